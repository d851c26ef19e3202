/* The section of the selected beams; a change concerns every beam that has it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnForm base;
  QnId section; /* that the form is about */
} Form;

#define CHANGE N_ ("Change %s")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (USERS, "users", NULL)                                                           \
  MEMBER (NAME, "name", N_ ("Rename Section"), QnSection, name)                          \
  FIELD (SHAPE, "shape", N_ ("Change Section"))                                          \
  MEMBER (YOUNG, "young", CHANGE, QnSection, young)                                      \
  MEMBER (SHEAR_MODULUS, "shear_modulus", CHANGE, QnSection, shear_modulus)              \
  MEMBER (POISSON, "poisson", CHANGE, QnSection, poisson)                                \
  MEMBER (WIDTH, "width", CHANGE, QnSection, width)                                      \
  MEMBER (HEIGHT, "height", CHANGE, QnSection, height)                                   \
  MEMBER (AREA, "area", CHANGE, QnSection, area)                                         \
  MEMBER (INERTIA, "inertia", CHANGE, QnSection, inertia)                                \
  MEMBER (SHEAR_FACTOR, "shear_factor", CHANGE, QnSection, shear_factor)                 \
  MEMBER (YIELD, "yield", CHANGE, QnSection, yield)                                      \
  MEMBER (PLASTIC_MOMENT, "plastic_moment", CHANGE, QnSection, plastic_moment)           \
  MEMBER (UNIT_WEIGHT, "unit_weight", CHANGE, QnSection, unit_weight)                    \
  FIELD (ADD, "add", N_ ("Add Section"))                                                 \
  FIELD (UNUSED, "unused", N_ ("Remove Unused Sections"))
QN_FORM_FIELDS;

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  QnBeamSet set = form->base.parts.beams;
  form->section = set.count > 0 ? model->beams[set.ids[0]].section : QN_NONE;
  return form->section != QN_NONE;
}

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return &model->sections[((const Form *) form)->section];
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
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnSection *section = &model->sections[form->section];
  gboolean rectangle = section->height > 0.0;
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
  case SHAPE:
    value->number = rectangle ? 0 : 1;
    return TRUE;
  case WIDTH:
  case HEIGHT:
  case YIELD:
    return rectangle;
  case AREA:
  case INERTIA:
  case PLASTIC_MOMENT:
    return !rectangle;
  case SHEAR_MODULUS:
    return section->shear_modulus > 0.0;
  case POISSON:
    return !(section->shear_modulus > 0.0);
  case UNUSED:
    return any_is_unused (model);
  }
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  switch (field) {
  case NAME:
    return qn_edit_take_name (&model->sections[form->section].name, value->text, error);
  case SHAPE:
    return qn_edit_set_section_shape (model, form->section, value->number == 0.0, error);
  case ADD: /* like the one that the beams have */
    return qn_edit_add_section (model, form->section, error)
           && qn_edit_set_beams (model, form->base.parts.beams, QN_BEAM_SECTION,
                                 (double) model->section_count - 1, error);
  case UNUSED:
    qn_edit_remove_unused_sections (model);
    return TRUE;
  case UNIT_WEIGHT:
    model->sections[form->section].density = -1.0; /* no longer what counts */
    break;
  }
  return TRUE;
}

const QnFormKind qn_section_form = QN_FORM_KIND (
  "section-form", Form, .subject = subject, .look = look, .follows = QN_FOLLOW_SELECTION);
