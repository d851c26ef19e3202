/* Load cases, their factors, and by which code they are combined. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-stage.h"
#include "doc/text/units.h"
#include "io/project/combinations.h"
#include <glib/gi18n.h>
#include <string.h>

#define PARTIAL(number, id, MEMBER, member)                                              \
  MEMBER (number, id, N_ ("Change Partial Factor"), QnCombinationRules, member)
#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (CASES, "cases", NULL)                                                           \
  FIELD (EMPTY, "empty", NULL)                                                           \
  MEMBER (NAME, "name", N_ ("Rename Load Case"), QnLoadCase, name)                       \
  MEMBER (FACTOR, "factor", N_ ("Change Factor"), QnLoadCase, factor)                    \
  FIELD (ACTION, "action", N_ ("Change Action"))                                         \
  FIELD (ADD, "add", N_ ("Add Load Case"))                                               \
  FIELD (REMOVE, "remove", N_ ("Remove Load Case"))                                      \
  FIELD (CODE, "code", N_ ("Change Code of Combinations"))                               \
  PARTIAL (FRICTION, "friction", MEMBER, friction)                                       \
  PARTIAL (STRENGTH, "strength", MEMBER, strength)                                       \
  PARTIAL (SEISMIC_FRICTION, "seismic_friction", MEMBER, seismic_friction)               \
  PARTIAL (SEISMIC_STRENGTH, "seismic_strength", MEMBER, seismic_strength)
QN_FORM_FIELDS;

static char *
dup_row (const QnModel *model, gsize index)
{
  g_autofree char *factor =
    qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, model->load_cases[index].factor, 6);
  guint loads = 0;
  for (gsize i = 0; i < qn_model_load_count (model); i++)
    loads += qn_model_load (model, i)->load_case == (int32_t) index + 1;
  return g_strdup_printf (
    ngettext ("%s × %s, for %u load", "%s × %s, for %u loads", loads),
    model->load_cases[index].name, factor, loads);
}

/* Rows of names with one for none before them; the row of `chosen`. */
static void
set_names (QnValue *value, const char *none, char **names, const char *chosen)
{
  g_auto (GStrv) owned = names;
  qn_value_add_row (value, none);
  for (guint i = 0; owned[i] != NULL; i++) {
    qn_value_add_row (value, owned[i]);
    value->number = strcmp (owned[i], chosen) == 0 ? i + 1 : value->number;
  }
}

static void
take_name (const QnValue *value, char **names, char *target)
{
  g_auto (GStrv) owned = names;
  const int row = qn_value_int (value);
  g_strlcpy (target, row > 0 ? owned[row - 1] : "", QN_ACTION_SIZE);
}

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return field >= CODE ? (gpointer) &model->combinations
                       : (gpointer) qn_form_item (form, model);
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnLoadCase *shown = qn_form_item (form, model);
  if (field == ACTION && shown != NULL)
    set_names (value, _ ("the same in all"), qn_combinations_dup_actions (),
               shown->action);
  if (field == CODE)
    set_names (value, _ ("none"), qn_combinations_dup_codes (), model->combinations.code);
  value->disabled = field == REMOVE && shown == NULL;
  if (field == CODE)
    return model->load_case_count > 0;
  return field > CODE ? *model->combinations.code != '\0'
                      : shown != NULL || field == ADD || field == REMOVE;
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  switch (field) {
  case NAME:
    return qn_edit_rename_load_list (model, TRUE, form->selected + 1, value->text, error);
  case ACTION:
    take_name (value, qn_combinations_dup_actions (),
               model->load_cases[form->selected].action);
    return TRUE;
  case CODE:
    take_name (value, qn_combinations_dup_codes (), model->combinations.code);
    return TRUE;
  case ADD:
    form->wanted = (int) model->load_case_count;
    return qn_edit_add_load_list (model, TRUE, error);
  case REMOVE:
    return qn_edit_delete_load_case (model, form->selected + 1, error);
  }
  return TRUE;
}

static const QnFormList list =
  QN_FORM_LIST (CASES, EMPTY, load_cases, load_case_count, dup_row, QN_PICK_NOTHING);

const QnFormKind qn_case_form =
  QN_FORM_KIND ("case-form", QnForm, .list = &list, .subject = subject);
