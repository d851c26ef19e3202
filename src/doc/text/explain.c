#include "doc/text/explain.h"

#include "core/contact/plausible.h"
#include "io/project/project.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"
#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Entities by their word and, of lists of a project file, how paths of them begin and are told; `items`:
 * place in QnModel of those that have names, else 0. */
static const struct {
  const char *word;
  gsize items;
  const char *path, *told;
} entities[] = {
  [QN_ENTITY_LAW] = { N_ ("Law"), offsetof (QnModel, laws), "laws[", N_ ("Law %s") },
  [QN_ENTITY_BLOCK] = { N_ ("Block"), offsetof (QnModel, blocks), "blocks[",
                        N_ ("Block %s") },
  [QN_ENTITY_WALL] = { N_ ("Wall"), offsetof (QnModel, walls), "walls[", N_ ("Wall %s") },
  [QN_ENTITY_CONTACT] = { .word = N_ ("Contacts") },
  [QN_ENTITY_FACE_OVERRIDE] = { .word = N_ ("Contact face") },
  [QN_ENTITY_BAR] = { N_ ("Reinforcing bar"), 0, "bars[", N_ ("Bar %s") },
  [QN_ENTITY_TIE] = { N_ ("Tie"), offsetof (QnModel, ties), "ties[", N_ ("Tie %s") },
  [QN_ENTITY_VEHICLE] = { .word = N_ ("Vehicle"), .items = offsetof (QnModel, vehicles) },
  [QN_ENTITY_NODE] = { .word = N_ ("Node"), .items = offsetof (QnModel, nodes) },
  [QN_ENTITY_SECTION] = { N_ ("Section"), offsetof (QnModel, sections), "sections[",
                          N_ ("Section %s") },
  [QN_ENTITY_BEAM] = { N_ ("Beam"), offsetof (QnModel, beams), "beams[", N_ ("Beam %s") },
  [QN_ENTITY_DEAD_LOAD] = { N_ ("Dead load"), 0, "loads.dead[", N_ ("Constant load %s") },
  [QN_ENTITY_LIVE_LOAD] = { N_ ("Live load"), 0, "loads.live[", N_ ("Growing load %s") },
  [QN_ENTITY_LOAD_CASE] = { .word = N_ ("Load case") },
  [QN_ENTITY_ANALYSIS] = { .word = N_ ("Analysis") },
  [QN_ENTITY_STAGE] = { N_ ("Load stage"), 0, "analysis.stages[", N_ ("Stage %s") },
  [QN_ENTITY_GROUND_MOTION] = { .word = N_ ("Ground motion") },
  [QN_ENTITY_INITIAL_MOTION] = { .word = N_ ("Initial motion") },
  [QN_ENTITY_TRACK] = { .word = N_ ("Tracked displacement") },
  [QN_ENTITY_MASONRY] = { N_ ("Masonry"), 0, "masonry[", N_ ("Masonry %s") },
  [QN_ENTITY_MODEL] = { .word = N_ ("Model") },
};

static const char *
entity_name (const QnModel *model, QnEntity entity, QnId index)
{
  if (model == NULL || index < 0 || entities[entity].items == 0)
    return NULL;
  if (entity == QN_ENTITY_TIE && (gsize) index >= model->tie_count) {
    index -= (QnId) model->tie_count;
    return qn_model_item_name (model, offsetof (QnModel, soil_ties), index);
  }
  return qn_model_item_name (model, entities[entity].items, index);
}

char *
qn_explain_diag (const QnModel *model, const QnDiag *diag)
{
  const char *text = _ (qn_problem_text (diag->problem));
  const char *word = _ (entities[diag->entity].word);
  const char *name = entity_name (model, diag->entity, diag->index);
  const char *other = entity_name (model, diag->entity, diag->other);
  if (name != NULL && other != NULL && diag->entity == QN_ENTITY_BLOCK)
    return g_strdup_printf (_ ("Blocks “%s” and “%s”: %s"), name, other, text);
  if (name != NULL && other != NULL)
    return g_strdup_printf (_ ("%s “%s” and “%s”: %s"), word, name, other, text);
  if (name != NULL)
    return g_strdup_printf (_ ("%s “%s”: %s"), word, name, text);
  if (diag->index >= 0 && diag->entity != QN_ENTITY_MODEL)
    return g_strdup_printf (_ ("%s %d: %s"), word, diag->index + 1, text);
  return g_strdup_printf (_ ("%s: %s"), word, text);
}

char *
qn_explain_finding (const QnModel *model, const QnFinding *finding)
{
  const char *a = entity_name (model, QN_ENTITY_BLOCK, finding->block_a);
  const char *b = entity_name (model, QN_ENTITY_BLOCK, finding->block_b);
  const char *text = _ (qn_problem_text (finding->problem));
  if (finding->range != NULL) {
    const char *name = entity_name (model, finding->range->entity, finding->subject);
    g_autofree char *doubt = qn_range_dup_text (finding);
    return g_strdup_printf ("%s: %s %s", name != NULL ? name : _ ("Model"),
                            finding->range->key, doubt);
  }
  g_autofree char *value = qn_project_dup_finding_value (finding, "mm", 1e3);
  g_autofree char *width =
    value != NULL ? g_strdup_printf (" (%s)", value) : g_strdup ("");
  if (a != NULL && b != NULL)
    return g_strdup_printf (_ ("%s – %s: %s%s"), a, b, text, width);
  return g_strdup_printf (_ ("%s: %s%s"), a != NULL ? a : _ ("Model"), text, width);
}

const char *
qn_explain_outcome_label (const QnResult *result)
{
  return result->outcome == QN_OUTCOME_TARGET_REACHED && result->history.width == 0
             && qn_result_find_buckling (result) != NULL
           ? _ ("Buckled")
           : qn_outcome_text (result->outcome, result->history.width > 0);
}

const char *
qn_explain_pair_state (QnPairState state)
{
  static const char *const texts[QN_PAIR_STATE_COUNT] = {
    [QN_PAIR_STICK] = N_ ("sticks"),
    [QN_PAIR_SLIP] = N_ ("slides"),
    [QN_PAIR_OPEN] = N_ ("open"),
    [QN_PAIR_YIELD] = N_ ("yields"),
  };
  return _ (texts[state]);
}

static char *
dup_pairs (QnPairState state, guint count)
{
  switch (state) {
  case QN_PAIR_SLIP:
    return g_strdup_printf (ngettext ("%u pair slides", "%u pairs slide", count), count);
  case QN_PAIR_OPEN:
    return g_strdup_printf (ngettext ("%u pair is open", "%u pairs are open", count),
                            count);
  case QN_PAIR_YIELD:
    return g_strdup_printf (ngettext ("%u pair yields", "%u pairs yield", count), count);
  case QN_PAIR_STICK:
  case QN_PAIR_STATE_COUNT:
    break;
  }
  return g_strdup_printf (ngettext ("%u pair sticks", "%u pairs stick", count), count);
}

char *
qn_explain_pairs (const int32_t counts[QN_PAIR_STATE_COUNT])
{
  GString *text = g_string_new (NULL);
  for (int state = 0; state < QN_PAIR_STATE_COUNT; state++) {
    if (counts[state] == 0)
      continue;
    g_autofree char *pairs = dup_pairs ((QnPairState) state, (guint) counts[state]);
    g_string_append_printf (text, "%s%s", text->len > 0 ? ", " : "", pairs);
  }
  return g_string_free (text, FALSE);
}

/* How far blocks went in an analysis in time, and when; NULL where none did. */
static char *
dup_peak (const QnModel *model, const QnResult *result)
{
  QnId block;
  double peak = qn_result_peak (result, &block);
  if (!(peak > 0))
    return NULL;
  if (isnan (result->history.peak_time))
    return g_strdup_printf (_ ("Largest displacement: %.4g mm, of block “%s”."),
                            1e3 * peak, model->blocks[block].name);
  return g_strdup_printf (_ ("Largest displacement: %.4g mm at %.4g s, of block “%s”."),
                          1e3 * peak, result->history.peak_time,
                          model->blocks[block].name);
}

char *
qn_explain_outcome (const QnModel *model, const QnResult *result)
{
  if (result->vibration.mode > 0)
    return g_strdup (_ ("Small vibrations about an equilibrium."));
  g_autofree char *reason = qn_outcome_dup_reason (model, result);
  g_autofree char *peak = dup_peak (model, result);
  g_autofree char *ties = qn_ties_dup_text (model, result);
  GString *text = g_string_new (reason);
  if (peak != NULL)
    g_string_append_printf (text, " %s", peak);
  if (ties != NULL)
    g_string_append_printf (text, " %s", ties);
  return g_string_free (text, FALSE);
}

/* What the motion is that a result has in place of a mechanism, or NULL where it is one. */
static char *
dup_mode (const QnResult *result)
{
  if (result->mechanism != NULL && result->stability == QN_STABILITY_LOST)
    return g_strdup (_ ("Buckling mode, of no given size."));
  if (result->mechanism == NULL || result->vibration.mode == 0)
    return NULL;
  double hertz = result->vibration.omega / (2 * G_PI);
  g_autofree char *frequency = qn_label_number ("%.4g", hertz);
  return result->vibration.dead_load
           ? g_strdup_printf (_ ("Mode %d of vibration under dead load, %s Hz."),
                              result->vibration.mode, frequency)
           : g_strdup_printf (_ ("Mode %d of vibration about the last step, %s Hz."),
                              result->vibration.mode, frequency);
}

char *
qn_explain_mechanism (const QnModel *model, const QnContacts *contacts,
                      const QnResult *result)
{
  char *mode = dup_mode (result);
  return mode != NULL ? mode : qn_collapse_dup_text (model, contacts, result);
}

char *
qn_explain_mechanism_briefly (const QnModel *model, const QnContacts *contacts,
                              const QnResult *result)
{
  char *mode = dup_mode (result);
  if (mode != NULL)
    return mode;
  g_autofree char *title =
    qn_collapse_dup_words (model, contacts, result, qn_mechanism_dup_title);
  return title != NULL && result->mechanism_uncertain
           ? g_strdup_printf (_ ("%s (last motion)"), title)
           : g_steal_pointer (&title);
}

const char *
qn_explain_procedure (const QnAnalysisSettings *analysis)
{
  switch (analysis->procedure) {
  case QN_PROCEDURE_LOAD:
    return _ ("load control");
  case QN_PROCEDURE_DISPLACEMENT:
    return _ ("displacement control");
  case QN_PROCEDURE_WORK:
    return _ ("work control");
  case QN_PROCEDURE_ARC_LENGTH:
    return _ ("arc length");
  case QN_PROCEDURE_LIMIT:
    return analysis->flow == QN_FLOW_ASSOCIATIVE ? _ ("associative limit analysis")
                                                 : _ ("non-associative limit analysis");
  case QN_PROCEDURE_DYNAMIC:
    return _ ("analysis in time");
  case QN_PROCEDURE_COUNT:
    break;
  }
  return "";
}

char *
qn_path_dup_text (const QnModel *model, const char *path)
{
  for (gsize i = 0; i < G_N_ELEMENTS (entities); i++) {
    if (entities[i].path == NULL || !g_str_has_prefix (path, entities[i].path))
      continue;
    char *end;
    guint64 index = g_ascii_strtoull (path + strlen (entities[i].path), &end, 10);
    const char *known =
      index < G_MAXINT32 ? entity_name (model, (QnEntity) i, (QnId) index) : NULL;
    g_autofree char *name = known != NULL
                              ? g_strdup_printf (_ ("“%s”"), known)
                              : g_strdup_printf ("%" G_GUINT64_FORMAT, index + 1);
    /* Words of the table, each with one "%s". */
    g_auto (GStrv) around = g_strsplit (_ (entities[i].told), "%s", 2);
    g_autofree char *whose = g_strjoinv (name, around);
    g_autofree char *rest =
      g_strdelimit (g_strdup (end[0] == ']' && end[1] == '.' ? end + 2 : ""), "_", ' ');
    return g_strconcat (whose, *rest != '\0' ? ": " : "", rest, NULL);
  }
  return g_strdelimit (g_strdup (path), "_", ' ');
}

char *
qn_path_dup_reason (const char *message, const char *path)
{
  g_autofree char *place = g_strconcat (path, ": ", NULL);
  g_autofree char *override = g_strconcat ("\"", path, "=", NULL);
  const char *begin = strstr (message, place);
  begin = begin != NULL ? begin + strlen (place) : message;
  const char *end = strstr (begin, override);
  while (end != NULL && end > begin && *end != '(')
    end--;
  char *reason =
    end != NULL ? g_strndup (begin, (gsize) (end - begin)) : g_strdup (begin);
  return g_strchomp (reason);
}

static char *
dup_phrase (QnCount count)
{
  gsize n = count.number;
  switch (count.what) {
  case QN_COUNTED_BLOCKS:
    return g_strdup_printf (ngettext ("%zu block", "%zu blocks", n), n);
  case QN_COUNTED_BEAMS:
    return g_strdup_printf (ngettext ("%zu beam", "%zu beams", n), n);
  case QN_COUNTED_FACES:
    return g_strdup_printf (ngettext ("%zu contact face", "%zu contact faces", n), n);
  case QN_COUNTED_PAIRS:
    return g_strdup_printf (ngettext ("%zu contact pair", "%zu contact pairs", n), n);
  case QN_COUNTED_FINDINGS:
    return g_strdup_printf (ngettext ("%zu finding", "%zu findings", n), n);
  case QN_COUNTED_STEPS:
    return g_strdup_printf (ngettext ("%zu step", "%zu steps", n), n);
  case QN_COUNTED_ITERATIONS:
    return g_strdup_printf (ngettext ("%zu iteration", "%zu iterations", n), n);
  case QN_COUNTED_FACTORISATIONS:
    return g_strdup_printf (ngettext ("%zu factorisation", "%zu factorisations", n), n);
  }
  return g_strdup ("");
}

char *
qn_counts_dup_text (const QnCount *counts, gsize n_counts, const char *separator)
{
  g_autoptr (GStrvBuilder) phrases = g_strv_builder_new ();
  for (gsize i = 0; i < n_counts; i++) {
    g_autofree char *phrase = dup_phrase (counts[i]);
    g_strv_builder_add (phrases, phrase);
  }
  g_auto (GStrv) strings = g_strv_builder_end (phrases);
  return g_strjoinv (separator, strings);
}
