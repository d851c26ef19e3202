/* Section of a report on what its answers take for granted, and what nobody has looked at: sentences that the
 * project and its results decide, none that is always the same where they do not. */
#include "doc/view/report-parts.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static void
add (GString *list, bool holds, const char *sentence)
{
  if (holds)
    g_string_append_printf (list, "%s• %s", list->len > 0 ? "\n" : "", sentence);
}

/* Whether joints have a law of which a number of these keys is given. */
static bool
is_given (const QnModel *model, size_t law, const char *const *keys)
{
  size_t count;
  const QnLaw *its = &model->laws[law];
  const QnLawParameter *parameters = qn_law_parameters (its->kind, &count);
  for (size_t i = 0; i < count; i++) {
    double value = qn_law_get (its, &parameters[i]);
    if (g_strv_contains (keys, parameters[i].key) && isfinite (value) && value > 0)
      return true;
  }
  return false;
}

/* Properties of the laws of joints. */
typedef struct Joints {
  bool tension, slides, dilates;
  GString *uncrushed; /* names of those that carry any compression, or empty */
} Joints;

static void
look_at_joints (Joints *joints, const QnReport *report)
{
  static const char *const tension[] = { "tension", "cohesion", NULL };
  static const char *const dilation[] = { "dilatancy", NULL };
  static const char *const crushing[] = { "compression", "yield", "strength", NULL };
  const QnModel *model = &report->project->model;
  const QnContacts *contacts = report->contacts;
  for (size_t law = 0; law < model->law_count; law++) {
    const QnLaw *its = &model->laws[law];
    bool used = false;
    for (size_t f = 0; f < contacts->face_count && !used; f++)
      used =
        contacts->faces[f].law_a == (QnId) law || contacts->faces[f].law_b == (QnId) law;
    if (!used)
      continue;
    joints->tension |= (its->kind != QN_LAW_NO_TENSION && !qn_law_may_bond (its->kind))
                       || is_given (model, law, tension);
    joints->slides |= qn_law_may_bond (its->kind);
    joints->dilates |= is_given (model, law, dilation);
    if (its->kind != QN_LAW_CURVE && !is_given (model, law, crushing)) {
      g_string_append (joints->uncrushed, joints->uncrushed->len > 0 ? ", " : "");
      g_string_append_printf (joints->uncrushed, _ ("“%s”"), its->name);
    }
  }
}

static bool
has_load (const QnModel *model, QnLoadKind from, QnLoadKind to)
{
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    QnLoadKind kind = qn_model_load (model, i)->kind;
    if (kind >= from && kind <= to)
      return true;
  }
  return false;
}

static bool
has_open_anchor (const QnModel *model)
{
  for (size_t i = 0; i < model->tie_count; i++)
    if (!(model->ties[i].anchor > 0))
      return true;
  return false;
}

/* As a section, or as a paragraph of `brief`; the list is empty then. */
static void
write_list (QnPages *pages, const char *heading, GString *list, GString *brief)
{
  if (brief != NULL) {
    g_string_replace (list, "\n• ", " ", 0);
    g_string_append_printf (brief, "%s: %s\n", heading, list->str + strlen ("• "));
  } else {
    qn_pages_heading (pages, heading);
    qn_pages_paragraph (pages, list->str);
  }
  g_string_truncate (list, 0);
}

void
qn_report_write_assumptions (QnPages *pages, const QnReport *report, GString *brief)
{
  const QnModel *model = &report->project->model;
  const bool blocks = model->block_count > 0;
  const bool linear = model->analysis.geometry == QN_GEOMETRY_LINEAR
                      || model->analysis.procedure == QN_PROCEDURE_LIMIT;
  const bool in_time = model->analysis.procedure == QN_PROCEDURE_DYNAMIC;
  const bool settles = has_load (model, QN_LOAD_SETTLEMENT, QN_LOAD_SETTLEMENT);
  g_autoptr (GString) uncrushed = g_string_new (NULL);
  g_autoptr (GString) list = g_string_new (NULL);
  Joints joints = { .uncrushed = uncrushed };
  look_at_joints (&joints, report);

  add (list, true, _ ("The structure, its loads and its motion lie in one plane."));
  add (list, blocks,
       _ ("Blocks are rigid and do not break: what deforms, opens, slides or is "
          "crushed are their joints."));
  add (list, blocks && joints.tension,
       _ ("Joints carry tension and cohesion as given under Materials."));
  add (list, blocks && !joints.tension, _ ("Joints carry no tension."));
  add (list, joints.slides && !joints.dilates, _ ("Joints slide without dilation."));
  add (list, joints.slides && joints.dilates,
       _ ("Joints that slide open as well, by the dilatancy that is given."));
  add (list, linear,
       _ ("Displacements are small: equilibrium is that of the undeformed structure."));
  add (list, !linear, _ ("Equilibrium is that of the deformed structure."));
  add (
    list, !in_time && qn_model_sets_have_force (model, 1),
    _ ("The dead load acts first and stays; the live load grows slowly, in proportion."));
  add (list, model->ground_count > 0, _ ("All of the ground moves as one."));
  add (list, true,
       settles ? _ ("Supports are rigid, but for the settlements that are given.")
               : _ ("Supports are rigid and do not settle."));
  add (list, model->tie_count > 0,
       _ ("Ties carry tension alone and are not bonded to the masonry."));
  add (list, has_load (model, QN_LOAD_SURCHARGE, QN_LOAD_VEHICLE),
       _ ("Soil loads and presses as given; it is no part of the structure."));

  write_list (pages, _ ("Assumptions"), list, brief);
  add (list, true, _ ("Forces and motion out of the plane."));
  add (list, blocks, _ ("Cracking and splitting of blocks."));
  if (uncrushed->len > 0)
    g_string_append_printf (list, _ ("\n• Crushing: joints of %s carry any compression."),
                            uncrushed->str);
  add (list, blocks && linear,
       _ ("The effect of displacements on equilibrium, as of slender or leaning parts."));
  add (list, true, _ ("The ground below the supports."));
  add (list, has_open_anchor (model),
       _ ("Anchors of ties, where no strength of them is given."));
  add (list, *model->combinations.code == '\0',
       _ ("Combinations and partial factors of a code: loads and strengths are taken as "
          "given."));
  add (list, true,
       _ ("Creep, moisture, temperature and decay, and how the answer scatters with the "
          "numbers given."));
  for (size_t i = 0; i < report->run_count; i++)
    if (report->runs[i].unchecked != NULL)
      g_string_append_printf (list, _ ("\n• %s, by the independent check: %s"),
                              report->runs[i].name, report->runs[i].unchecked);
  write_list (pages, _ ("What Was Not Checked"), list, brief);
}
