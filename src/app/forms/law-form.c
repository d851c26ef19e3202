/* The laws: kind, basis, the numbers that the kind has, and how the law answers. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/plot-view.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit.h"
#include "doc/text/law-text.h"
#include "doc/view/pair-text.h"
#include "io/project/typical-joint.h"
#include <glib/gi18n.h>
#include <string.h>

/* Numbers by the keys of project files; the first ones belong to every law. */
static const char *const keys[] = { "elasticity",
                                    "poisson",
                                    "kn",
                                    "ks",
                                    "shear_factor",
                                    "friction",
                                    "cohesion",
                                    "tension",
                                    "compression",
                                    "residual_friction",
                                    "fracture_energy_tension",
                                    "fracture_energy_shear",
                                    "dilatancy",
                                    "dilation_end",
                                    "yield",
                                    "hardening",
                                    "strength",
                                    "ultimate_strain",
                                    "fracture_energy",
                                    "crushing_energy" };

/* m: of the block's side in the plot, where a law speaks of strains. */
#define TYPICAL_LENGTH 0.1

typedef struct Form {
  QnForm base;
  QnId shown; /* law that the fields are about */
  QnId by; /* what stands in its place once it is removed; QN_NONE: that of all others */
  QnLawPreset
    traced; /* how the law answers a typical history of elongations; without its names */
  GArray *samples; /* of QnLawSample; empty where the law snaps back */
} Form;

#define CHANGE N_ ("Change Law")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (LAW, "law", NULL)                                                               \
  MEMBER (NAME, "name", N_ ("Rename Law"), QnLaw, name)                                  \
  MEMBER (SOURCE, "source", N_ ("Change Source"), QnLaw, source)                         \
  FIELD (JOINT, "joint", N_ ("Use Typical Joint"))                                       \
  FIELD (KIND, "kind", CHANGE)                                                           \
  MEMBER (BASIS, "basis", CHANGE, QnLaw, basis)                                          \
  FIELD (CELLS, "cells", CHANGE)                                                         \
  MEMBER (SOFTENING, "softening", CHANGE, QnLaw, exponential)                            \
  FIELD (POINTS, "points", CHANGE)                                                       \
  FIELD (VIEW, "view", NULL)                                                             \
  FIELD (ADD, "add", N_ ("Add Law"))                                                     \
  FIELD (DUPLICATE, "duplicate", N_ ("Duplicate Law"))                                   \
  FIELD (APPLY, "apply", N_ ("Apply Law"))                                               \
  FIELD (APPLY_TO_ALL, "apply_to_all", N_ ("Apply Law"))                                 \
  FIELD (SELECT, "select", NULL)                                                         \
  FIELD (BY, "by", NULL)                                                                 \
  FIELD (REMOVE, "remove", N_ ("Remove Law"))
QN_FORM_FIELDS;

static QnFieldInfo
row_info (guint row)
{
  static const char *const positive[] = { "elasticity", "kn", "ks", NULL };
  return (QnFieldInfo){ .label = qn_law_number_word (keys[row]),
                        .step = CHANGE,
                        .least = g_strv_contains (positive, keys[row]) ? 1e-12 : 0.0,
                        .most = g_str_equal (keys[row], "poisson") ? 0.4999 : 1e18 };
}

/* The number of a law, or NULL where its kind has none of this key. */
static double *
number_of (QnLaw *law, guint row)
{
  const gboolean derived = law->elasticity > 0.0;
  double *all[] = { derived ? &law->elasticity : NULL, derived ? &law->poisson : NULL,
                    derived ? NULL : &law->kn, derived ? NULL : &law->ks,
                    &law->shear_factor };
  if (row < G_N_ELEMENTS (all))
    return all[row];
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  for (size_t i = 0; i < count; i++)
    if (strcmp (parameters[i].key, keys[row]) == 0)
      return qn_law_at (law, &parameters[i]);
  return NULL;
}

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  if (form->shown < 0 || (gsize) form->shown >= model->law_count)
    form->shown = 0;
  if (form->by >= (QnId) model->law_count || form->by == form->shown)
    form->by = QN_NONE;
  return model->law_count > 0;
}

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return &model->laws[((const Form *) form)->shown];
}

/* The typical joints, after a row that asks for a choice. */
static void
add_joints (QnValue *value, const char *first)
{
  qn_value_add_row (value, first);
  for (int i = 0; i < QN_JOINT_COUNT; i++)
    qn_value_add_row (value, _ (qn_typical_joints[i].name));
}

/* Limit analysis takes strengths that last, and unless it is associative the dilatancy. */
static gboolean
is_ignored (const QnAnalysisSettings *analysis, const char *key)
{
  static const char *const taken[] = { "friction", "cohesion", "tension", "compression",
                                       "yield",    "strength", NULL };
  return analysis->procedure == QN_PROCEDURE_LIMIT && !g_strv_contains (taken, key)
         && (analysis->flow == QN_FLOW_ASSOCIATIVE || !g_str_equal (key, "dilatancy"));
}

static void
trace (Form *form, const QnLaw *law)
{
  form->traced = qn_law_preset_for (law);
  form->traced.law.name = form->traced.law.source = NULL;
  g_array_set_size (form->samples, 0);
  qn_law_trace (&form->traced, law->basis == QN_BASIS_MATERIAL ? TYPICAL_LENGTH : 1.0,
                form->samples);
  qn_plot_view_fit (form->base.widgets[VIEW]);
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const Form *form = data;
  return form->samples->len > 0 ? qn_law_plot (&form->traced, form->samples) : NULL;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnContacts *contacts = &form->base.canvas->document->contacts;
  QnSelection *selection = form->base.canvas->selection;
  QnLaw law = model->laws[form->shown];
  const double *number;
  guint uses = qn_edit_count_law_uses (model, form->shown);
  switch (field) {
  case BY:
    qn_value_set_laws (value, model, _ ("The law of the contacts"), form->by);
    return uses > 0 && model->law_count > 1;
  case LAW:
    for (gsize i = 0; i < model->law_count; i++)
      qn_value_take_row (
        value, qn_law_dup_text (model, contacts, (QnId) i, qn_settings_get_units ()));
    value->number = form->shown;
    return TRUE;
  case KIND:
    for (int i = 0; i < QN_LAW_KIND_COUNT; i++)
      qn_value_add_row (value, _ (qn_law_kind_words[i]));
    value->number = law.kind;
    return TRUE;
  case BASIS:
    for (int i = 0; i < QN_BASIS_COUNT; i++)
      qn_value_add_row (value, _ (qn_basis_words[i]));
    return TRUE;
  case CELLS:
    value->number = law.elasticity > 0.0 ? 1 + (int) law.arrangement : 0;
    return law.basis == QN_BASIS_MATERIAL;
  case SOFTENING:
    return qn_law_may_bond (law.kind)
           && (law.fracture_energy_tension > 0.0 || law.fracture_energy_shear > 0.0);
  case POINTS:
    value->text = qn_points_dup_text (law.points, law.point_count);
    return law.kind == QN_LAW_CURVE;
  case VIEW:
    trace ((Form *) data, &law);
    return TRUE;
  case JOINT:
    add_joints (value, _ ("Choose…"));
    return TRUE;
  case ADD:
    add_joints (value, _ ("Add…"));
    return TRUE;
  case APPLY:
    value->disabled =
      selection->ids[QN_PICK_BLOCK]->len + selection->ids[QN_PICK_FACE]->len == 0;
    return TRUE;
  case APPLY_TO_ALL:
    value->disabled = model->contact.law == form->shown;
    return TRUE;
  case SELECT:
    value->disabled = uses == 0;
    return TRUE;
  case NAME:
  case SOURCE:
  case DUPLICATE:
  case REMOVE:
    return TRUE;
  default:
    number = number_of (&law, field - FIELD_COUNT);
    if (number == NULL)
      return FALSE;
    value->number = *number;
    value->disabled = is_ignored (&model->analysis, keys[field - FIELD_COUNT]);
    g_object_set (form->base.widgets[field], "quantity",
                  qn_law_quantity (keys[field - FIELD_COUNT], law.basis), NULL);
    return TRUE;
  }
}

/* A law like the one that is shown, or a typical joint's. */
static gboolean
add (Form *form, QnModel *model, const QnValue *joint, GError **error)
{
  int kind = joint != NULL ? (int) joint->number - 1 : -1;
  if (!qn_edit_add_law (model, form->shown,
                        joint != NULL ? _ (qn_typical_joints[kind].name)
                                      : model->laws[form->shown].name,
                        error))
    return FALSE;
  form->shown = (QnId) model->law_count - 1;
  return joint == NULL
         || qn_law_make_joint (&model->laws[form->shown], (QnTypicalJointKind) kind)
         || qn_edit_no_memory (error);
}

/* To what is selected: blocks, whose joints have it then, or joints. */
static gboolean
apply (const Form *form, QnModel *model, GError **error)
{
  QnSelection *selection = form->base.canvas->selection;
  const QnContacts *contacts = &form->base.canvas->document->contacts;
  QnBlockSet blocks = { 0 };
  guint count;
  blocks.ids = qn_selection_get (selection, QN_PICK_BLOCK, &blocks.count);
  const QnId *ids = qn_selection_get (selection, QN_PICK_FACE, &count);
  if (blocks.count > 0)
    return qn_edit_set_blocks (model, blocks, QN_BLOCK_LAW, form->shown, error);
  return qn_edit_set_faces (model, (QnFaceSet){ contacts, ids, count }, &form->shown,
                            NULL, error);
}

/* The joints that have the law; where there are none, the blocks. */
static void
select_uses (const Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  const QnContacts *contacts = &form->base.canvas->document->contacts;
  g_autoptr (GArray) faces = g_array_new (FALSE, FALSE, sizeof (QnId));
  g_autoptr (GArray) blocks = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) contacts->face_count; i++)
    if (contacts->faces[i].law_a == form->shown
        || contacts->faces[i].law_b == form->shown)
      g_array_append_val (faces, i);
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (model->blocks[i].law == form->shown)
      g_array_append_val (blocks, i);
  if (faces->len > 0)
    qn_selection_set (form->base.canvas->selection, QN_PICK_FACE,
                      (const QnId *) (const void *) faces->data, faces->len);
  else
    qn_selection_set (form->base.canvas->selection, QN_PICK_BLOCK,
                      (const QnId *) (const void *) blocks->data, blocks->len);
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Form *form = (Form *) data;
  QnLaw *law = &model->laws[form->shown];
  QnVec2 points[QN_MAX_CURVE_POINTS];
  int32_t count;
  switch (field) {
  case LAW:
    form->shown = (QnId) value->number;
    return TRUE;
  case BY:
    form->by = qn_value_get_law (value);
    return TRUE;
  case NAME:
    return qn_edit_take_name (&law->name, value->text, error);
  case SOURCE:
    return qn_edit_take_text (&law->source, value->text, error);
  case JOINT:
    return value->number >= 1.0
           && (qn_law_make_joint (law, (QnTypicalJointKind) value->number - 1)
               || qn_edit_no_memory (error));
  case KIND:
    qn_law_change_kind (law, (QnLawKind) value->number);
    return TRUE;
  case BASIS:
    if (law->basis != QN_BASIS_MATERIAL)
      law->elasticity = 0.0;
    return TRUE;
  case CELLS:
    law->elasticity = value->number > 0.0 ? law->kn : 0.0;
    if (law->elasticity > 0.0)
      law->arrangement = (QnArrangement) (value->number - 1.0);
    qn_law_derive (law);
    return TRUE;
  case SOFTENING:
    return TRUE;
  case POINTS:
    if (!qn_points_parse (value->text, points, QN_MAX_CURVE_POINTS, &count))
      return qn_edit_refuse (
        error, _ ("Expected pairs of numbers with semicolons between them"));
    memcpy (law->points, points, (gsize) count * sizeof points[0]);
    law->point_count = count;
    return TRUE;
  case ADD:
    return value->number >= 1.0 && add (form, model, value, error);
  case DUPLICATE:
    return add (form, model, NULL, error);
  case APPLY:
    return apply (form, model, error);
  case APPLY_TO_ALL:
    model->contact.law = form->shown;
    return TRUE;
  case SELECT:
    select_uses (form);
    return TRUE;
  case REMOVE:
    return qn_edit_delete_law (model, form->shown,
                               form->by == form->shown ? QN_NONE : form->by, error);
  default:
    *number_of (law, field - FIELD_COUNT) = value->number;
    qn_law_derive (law);
    return TRUE;
  }
}

static void
clear (QnForm *form)
{
  g_array_unref (((Form *) form)->samples);
}

/* As it is before anything is shown. */
static void
init (QnForm *data)
{
  static const QnPlotHand hand = { .make = make_plot };
  Form *form = (Form *) data;
  form->by = QN_NONE;
  form->samples = g_array_new (FALSE, FALSE, sizeof (QnLawSample));
  qn_plot_view_init (form->base.widgets[VIEW], &hand, form);
}

const QnFormKind qn_law_form = QN_FORM_KIND (
  "law-form", Form, .subject = subject, .look = look, .follows = QN_FOLLOW_SELECTION,
  .row_info = row_info, .row_count = G_N_ELEMENTS (keys), .init = init, .clear = clear);
