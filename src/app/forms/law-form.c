/* The laws: kind, basis, the numbers that the kind has, and how the law answers. */
#include "app/forms/bound-form.h"
#include "app/forms/law-view.h"
#include "app/forms/panel.h"
#include "doc/text/law-points.h"
#include "doc/text/law-preset.h"
#include <glib/gi18n.h>
#include <stdlib.h>
#include <string.h>

/* What the number of a parameter is: it depends on the basis. */
typedef enum { IS_STIFFNESS, IS_NUMBER, IS_STRENGTH, IS_STRAIN } Meaning;

static const QnQuantity quantities[][QN_BASIS_COUNT] = {
  [IS_STIFFNESS] = { QN_QUANTITY_STIFFNESS, QN_QUANTITY_SURFACE_STIFFNESS,
                     QN_QUANTITY_STRESS },
  [IS_NUMBER] = { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER },
  [IS_STRENGTH] = { QN_QUANTITY_FORCE, QN_QUANTITY_STRESS, QN_QUANTITY_STRESS },
  [IS_STRAIN] = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_NUMBER },
};

/* Numbers by the keys of project files; the first three belong to every law. */
static const struct {
  const char *key;
  Meaning meaning;
  QnFieldInfo info;
} numbers[] = {
  { "kn", IS_STIFFNESS, { N_ ("Normal stiffness"), .least = 1e-12, .most = 1e18 } },
  { "ks", IS_STIFFNESS, { N_ ("Shear stiffness"), .least = 1e-12, .most = 1e18 } },
  { "shear_factor", IS_NUMBER, { N_ ("Shear factor (0: 1)"), .most = 1e18 } },
  { "friction", IS_NUMBER, { N_ ("Friction, tangent"), .most = 1e18 } },
  { "cohesion", IS_STRENGTH, { N_ ("Cohesion"), .most = 1e18 } },
  { "tension", IS_STRENGTH, { N_ ("Tensile strength"), .most = 1e18 } },
  { "compression", IS_STRENGTH, { N_ ("Compressive strength"), .most = 1e18 } },
  { "dilatancy", IS_NUMBER, { N_ ("Dilatancy, tangent"), .most = 1e18 } },
  { "yield", IS_STRENGTH, { N_ ("Yield"), .most = 1e18 } },
  { "hardening", IS_NUMBER, { N_ ("Hardening, part of stiffness"), .most = 1e18 } },
  { "strength", IS_STRENGTH, { N_ ("Strength"), .most = 1e18 } },
  { "ultimate_strain", IS_STRAIN, { N_ ("Ultimate strain"), .most = 1e18 } },
  { "fracture_energy",
    IS_NUMBER,
    { N_ ("Fracture energy, J/m² (pair: J)"), .most = 1e18 } },
  { "crushing_energy",
    IS_NUMBER,
    { N_ ("Crushing energy, J/m² (pair: J)"), .most = 1e18 } },
};

typedef struct Form {
  QnBoundForm base;
  QnId shown; /* law that the fields are about */
  QnId
    by; /* what stands in its place once it is removed; QN_NONE: the law of the contacts */
} Form;

enum { LAW, NAME, JOINT, KIND, BASIS, POINTS, VIEW, ADD, USES, BY, REMOVE, FIRST_NUMBER };

static const QnFormField fields[] = {
  [LAW] = { .id = "law" },
  [NAME] = { .id = "name", .step = N_ ("Rename Law") },
  [JOINT] = { .id = "joint", .step = N_ ("Take Joint") },
  [KIND] = { .id = "kind", .step = N_ ("Change Law") },
  [BASIS] = { .id = "basis", .step = N_ ("Change Law") },
  [POINTS] = { .id = "points", .step = N_ ("Change Law") },
  [VIEW] = { .id = "view" },
  [ADD] = { .id = "add", .step = N_ ("Add Law") },
  [USES] = { .id = "uses" },
  [BY] = { .id = "by" },
  [REMOVE] = { .id = "remove", .step = N_ ("Remove Law") },
};

static const QnFieldInfo *
row_info (guint row)
{
  return &numbers[row].info;
}

static const char *
row_step (guint row)
{
  (void) row;
  return _ ("Change Law");
}

/* The number of a law, or NULL where its kind has none of this key. */
static double *
number_of (QnLaw *law, guint row)
{
  double *all[] = { &law->kn, &law->ks, &law->shear_factor };
  if (row < G_N_ELEMENTS (all))
    return all[row];
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  for (size_t i = 0; i < count; i++)
    if (strcmp (parameters[i].key, numbers[row].key) == 0)
      return qn_law_at (law, &parameters[i]);
  return NULL;
}

static gboolean
look (gpointer data)
{
  Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  if (form->shown < 0 || (gsize) form->shown >= model->law_count)
    form->shown = 0;
  if (form->by >= (QnId) model->law_count || form->by == form->shown)
    form->by = QN_NONE;
  return model->law_count > 0;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  QnLaw law = model->laws[form->shown];
  const double *number;
  guint uses = qn_edit_count_law_uses (model, form->shown);
  switch (field) {
  case USES:
    value->text =
      g_strdup_printf (_ ("Blocks, walls, joints and bars that use it: %u"), uses);
    return uses > 0;
  case BY:
    qn_value_set_laws (value, model, _ ("The law of the contacts"), form->by);
    return uses > 0 && model->law_count > 1;
  case LAW:
    qn_value_set_laws (value, model, NULL, form->shown);
    return TRUE;
  case NAME:
    value->text = g_strdup (law.name);
    return TRUE;
  case KIND:
    value->number = law.kind;
    return TRUE;
  case BASIS:
    value->number = law.basis;
    return TRUE;
  case POINTS:
    value->text = qn_law_points_dup_text (law.points, law.point_count);
    return law.kind == QN_LAW_CURVE;
  case VIEW:
    qn_law_view_set_law (form->base.widgets[VIEW], &law);
    return TRUE;
  case JOINT: /* the first row asks for a choice */
  case ADD:
  case REMOVE:
    return TRUE;
  default:
    number = number_of (&law, field - FIRST_NUMBER);
    if (number == NULL)
      return FALSE;
    value->number = *number;
    g_object_set (form->base.widgets[field], "quantity",
                  quantities[numbers[field - FIRST_NUMBER].meaning][law.basis], NULL);
    return TRUE;
  }
}

static gboolean
rename_law (QnLaw *law, const char *text, GError **error)
{
  char *name = strdup (text);
  if (name == NULL)
    return qn_edit_no_memory (error);
  free (law->name);
  law->name = name;
  return TRUE;
}

static gboolean
add (Form *form, QnModel *model, GError **error)
{
  g_autofree char *name = NULL;
  guint number = (guint) model->law_count;
  do {
    g_free (name);
    name = g_strdup_printf (_ ("law %u"), ++number);
  } while (qn_model_find_law (model, name) != QN_NONE);
  if (!qn_edit_add_law (model, form->shown, name, error))
    return FALSE;
  form->shown = (QnId) model->law_count - 1;
  return TRUE;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnModel *model = draft != NULL ? &draft->model : NULL;
  QnLaw *law = model != NULL ? &model->laws[form->shown] : NULL;
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
    return rename_law (law, value->text, error);
  case JOINT:
    if (value->number < 1.0)
      return FALSE;
    if (qn_law_make_joint (law, (QnJointPreset) value->number - 1))
      return TRUE;
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                         _ ("The cohesion of this joint is a stress: choose the basis "
                            "“Surface” or “Material” first"));
    return FALSE;
  case KIND:
    qn_law_change_kind (law, (QnLawKind) value->number);
    return TRUE;
  case BASIS:
    law->basis = (QnBasis) value->number;
    return TRUE;
  case POINTS:
    if (!qn_law_points_parse (value->text, points, &count)) {
      g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                           _ ("Expected pairs of numbers with semicolons between them"));
      return FALSE;
    }
    memcpy (law->points, points, (gsize) count * sizeof points[0]);
    law->point_count = count;
    return TRUE;
  case ADD:
    return add (form, model, error);
  case REMOVE:
    return qn_edit_delete_law (model, form->shown,
                               form->by == form->shown ? QN_NONE : form->by, error);
  default:
    *number_of (law, field - FIRST_NUMBER) = value->number;
    return TRUE;
  }
}

GtkWidget *
qn_law_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND_WITH_ROWS ("law-form", Form, 0, G_N_ELEMENTS (numbers));
  QnBoundForm *form = qn_bound_form_new (&kind, canvas);
  ((Form *) form)->by = QN_NONE;
  qn_law_view_init (form->widgets[VIEW]);
  return qn_bound_form_show (form);
}
