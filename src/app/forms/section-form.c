/* The section of the selected beams; a change concerns every beam that has it. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnBoundForm base;
  QnId section; /* that the form is about */
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (USERS, "users", NULL)                                                           \
  FIELD (NAME, "name", N_ ("Rename Section"))                                            \
  FIELD (SHAPE, "shape", N_ ("Change Section"))                                          \
  FIELD (ADD, "add", N_ ("Add Section"))                                                 \
  FIELD (UNUSED, "unused", N_ ("Remove Unused Sections"))
QN_FORM_FIELDS;

static const QnFieldInfo *
row_info (guint row)
{
  static const QnFieldInfo infos[QN_SECTION_FIELD_COUNT] = {
    [QN_SECTION_YOUNG] = { N_ ("Young's modulus"), QN_QUANTITY_STRESS, 1e-6, 1e15, FALSE,
                           NULL },
    [QN_SECTION_SHEAR_MODULUS] = { N_ ("Shear modulus"), QN_QUANTITY_STRESS, 1e-6, 1e15,
                                   FALSE, NULL },
    [QN_SECTION_POISSON] = { N_ ("Poisson's ratio"), QN_QUANTITY_NUMBER, -0.999, 0.5,
                             FALSE, NULL },
    [QN_SECTION_WIDTH] = { N_ ("Width"), QN_QUANTITY_LENGTH, 1e-6, 1e6, FALSE, NULL },
    [QN_SECTION_HEIGHT] = { N_ ("Height"), QN_QUANTITY_LENGTH, 1e-6, 1e6, FALSE, NULL },
    [QN_SECTION_AREA] = { N_ ("Area (m²)"), QN_QUANTITY_NUMBER, 1e-12, 1e12, FALSE,
                          NULL },
    [QN_SECTION_INERTIA] = { N_ ("Moment of inertia (m⁴)"), QN_QUANTITY_NUMBER, 1e-18,
                             1e12, FALSE, NULL },
    [QN_SECTION_SHEAR_FACTOR] = { N_ ("Shear factor"), QN_QUANTITY_NUMBER, 1e-6, 1e6,
                                  FALSE, NULL },
    [QN_SECTION_YIELD] = { N_ ("Yield (0: none)"), QN_QUANTITY_STRESS, 0.0, 1e15, FALSE,
                           NULL },
    [QN_SECTION_PLASTIC_MOMENT] = { N_ ("Plastic moment (0: none)"), QN_QUANTITY_MOMENT,
                                    0.0, 1e15, FALSE, NULL },
    [QN_SECTION_UNIT_WEIGHT] = { N_ ("Unit weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, 1e9,
                                 FALSE, NULL },
  };
  return &infos[row];
}

static const char *
row_step (guint row)
{
  return _ ("Change %s");
}

static QnBeamSet
selected (const Form *form)
{
  QnBeamSet set = { 0 };
  set.ids = qn_selection_get (qn_canvas_get_selection (form->base.canvas), QN_PART_BEAM,
                              &set.count);
  return set;
}

static gboolean
look (gpointer data)
{
  Form *form = data;
  QnBeamSet set = selected (form);
  form->section = set.count > 0
                    ? qn_canvas_get_model (form->base.canvas)->beams[set.ids[0]].section
                    : QN_NONE;
  return form->section != QN_NONE;
}

static gboolean
any_is_unused (const QnModel *model)
{
  g_autofree gboolean *used = g_new0 (gboolean, model->section_count + 1);
  for (gsize i = 0; i < model->beam_count; i++)
    used[model->beams[i].section] = TRUE;
  for (gsize i = 0; i < model->section_count; i++)
    if (!used[i])
      return TRUE;
  return FALSE;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  const QnSection *section = &model->sections[form->section];
  QnSectionField number = (QnSectionField) (field - FIELD_COUNT);
  guint users = 0;
  switch (field) {
  case TITLE:
    value->text = g_strdup_printf (_ ("Section %s"), section->name);
    return TRUE;
  case USERS:
    for (gsize i = 0; i < model->beam_count; i++)
      users += model->beams[i].section == form->section;
    value->text = g_strdup_printf (ngettext ("Of %u beam", "Of %u beams", users), users);
    return TRUE;
  case NAME:
    value->text = g_strdup (section->name);
    return TRUE;
  case SHAPE:
    value->number = section->height > 0.0 ? 0 : 1;
    return TRUE;
  case ADD:
    return TRUE;
  case UNUSED:
    return any_is_unused (model);
  default:
    if (!qn_section_has_field (section, number))
      return FALSE;
    value->number = qn_section_get_field (section, number);
    return TRUE;
  }
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  const Form *form = data;
  QnModel *model = &draft->model;
  switch (field) {
  case NAME:
    return qn_edit_rename_section (model, form->section, value->text, error);
  case SHAPE:
    return qn_edit_set_section_shape (model, form->section, value->number == 0.0, error);
  case ADD: /* like the one that the beams have */
    return qn_edit_add_section (model, form->section, error)
           && qn_edit_set_beam_section (model, selected (form),
                                        (QnId) model->section_count - 1, error);
  case UNUSED:
    qn_edit_remove_unused_sections (model);
    return TRUE;
  default:
    return qn_edit_set_section_field (
      model, form->section, (QnSectionField) (field - FIELD_COUNT), value->number, error);
  }
}

GtkWidget *
qn_section_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND (
    "section-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION,
    .row_info = row_info, .row_step = row_step, .row_count = QN_SECTION_FIELD_COUNT);
  return qn_bound_form_show (qn_bound_form_new (&kind, canvas));
}
