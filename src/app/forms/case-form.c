/* Load cases and their factors. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-stage.h"
#include "doc/text/units.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnBoundForm base;
  int selected; /* row, or -1 */
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (CASES, "cases", NULL)                                                           \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (NAME, "name", N_ ("Rename Load Case"))                                          \
  MEMBER (FACTOR, "factor", N_ ("Change Factor"), QnLoadCase, factor)                    \
  FIELD (ADD, "add", N_ ("Add Load Case"))                                               \
  FIELD (REMOVE, "remove", N_ ("Remove Load Case"))
QN_FORM_FIELDS;

static gboolean
look (gpointer data)
{
  Form *form = data;
  if (form->selected >= (int) qn_canvas_get_model (form->base.canvas)->load_case_count)
    form->selected = -1;
  return TRUE;
}

static gpointer
subject (gpointer form, QnModel *model, guint field)
{
  const int selected = ((const Form *) form)->selected;
  return selected >= 0 ? &model->load_cases[selected] : NULL;
}

static guint
count_loads (const QnModel *model, int32_t load_case)
{
  guint count = 0;
  for (gsize i = 0; i < qn_model_load_count (model); i++)
    count += qn_model_load (model, i)->load_case == load_case;
  return count;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  const QnLoadCase *shown =
    form->selected >= 0 ? &model->load_cases[form->selected] : NULL;
  switch (field) {
  case CASES:
    for (gsize i = 0; i < model->load_case_count; i++) {
      g_autofree char *factor =
        qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, model->load_cases[i].factor, 6);
      guint loads = count_loads (model, (int32_t) i + 1);
      qn_value_take_row (value,
                         g_strdup_printf (ngettext ("%s × %s, for %u load",
                                                    "%s × %s, for %u loads", loads),
                                          model->load_cases[i].name, factor, loads));
    }
    value->number = form->selected;
    return TRUE;
  case EMPTY:
    value->text = g_strdup (_ ("No load cases: every load counts as it is."));
    return model->load_case_count == 0;
  case NAME:
    value->text = shown != NULL ? g_strdup (shown->name) : NULL;
    return shown != NULL;
  case FACTOR:
    return shown != NULL;
  case REMOVE:
    value->disabled = shown == NULL;
    return TRUE;
  default:
    return TRUE;
  }
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnModel *model = draft != NULL ? &draft->model : NULL;
  switch (field) {
  case CASES:
    form->selected = (int) value->number;
    return TRUE;
  case NAME:
    return qn_edit_rename_load_case (model, form->selected + 1, value->text, error);
  case FACTOR:
    return TRUE;
  case ADD:
    if (!qn_edit_add_load_case (model, error))
      return FALSE;
    form->selected = (int) model->load_case_count - 1;
    return TRUE;
  default:
    return qn_edit_delete_load_case (model, form->selected + 1, error);
  }
}

GtkWidget *
qn_case_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("case-form", Form, .look = look, .subject = subject);
  Form *form = qn_bound_form_new (&kind, canvas);
  form->selected = -1;
  return qn_bound_form_show (form);
}
