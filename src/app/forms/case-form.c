/* Load cases and their factors. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-stage.h"
#include "doc/text/units.h"
#include <glib/gi18n.h>

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (CASES, "cases", NULL)                                                           \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (NAME, "name", N_ ("Rename Load Case"))                                          \
  MEMBER (FACTOR, "factor", N_ ("Change Factor"), QnLoadCase, factor)                    \
  FIELD (ADD, "add", N_ ("Add Load Case"))                                               \
  FIELD (REMOVE, "remove", N_ ("Remove Load Case"))
QN_FORM_FIELDS;

static guint
count_loads (const QnModel *model, int32_t load_case)
{
  guint count = 0;
  for (gsize i = 0; i < qn_model_load_count (model); i++)
    count += qn_model_load (model, i)->load_case == load_case;
  return count;
}

static char *
dup_row (const QnModel *model, gsize index)
{
  g_autofree char *factor =
    qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, model->load_cases[index].factor, 6);
  guint loads = count_loads (model, (int32_t) index + 1);
  return g_strdup_printf (
    ngettext ("%s × %s, for %u load", "%s × %s, for %u loads", loads),
    model->load_cases[index].name, factor, loads);
}

static gboolean
show (gpointer form, guint field, QnValue *value)
{
  const QnLoadCase *shown =
    qn_bound_form_item (form, qn_canvas_get_model (((QnBoundForm *) form)->canvas));
  if (field == NAME && shown != NULL)
    value->text = g_strdup (shown->name);
  value->disabled = field == REMOVE && shown == NULL;
  return shown != NULL || field >= ADD;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  QnBoundForm *form = data;
  QnModel *model = &draft->model;
  switch (field) {
  case NAME:
    return qn_edit_rename_load_case (model, form->selected + 1, value->text, error);
  case FACTOR:
    return TRUE;
  case ADD:
    form->wanted = (int) model->load_case_count;
    return qn_edit_add_load_case (model, error);
  default:
    return qn_edit_delete_load_case (model, form->selected + 1, error);
  }
}

static const QnFormList list =
  QN_FORM_LIST (CASES, EMPTY, load_cases, load_case_count, dup_row, FALSE, 0);

const QnFormKind qn_case_form = QN_FORM_KIND ("case-form", QnBoundForm, .list = &list);
