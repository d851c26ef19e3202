/* The list of what varies: each parameter with its distribution is a form. */
#include "app/pages/study-private.h"

#include "app/widgets/context-menu.h"
#include "core/base/integer.h"
#include "doc/text/explain.h"
#include "io/text/text-format.h"
#include <glib/gi18n.h>
#include <string.h>

typedef struct Row {
  QnForm base;
  QnStudyPage *page;
  guint index; /* of the parameter */
} Row;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (NAME, "name", NULL)                                                             \
  FIELD (PLACE, "place", NULL)                                                           \
  FIELD (REMOVE, "remove", NULL)                                                         \
  FIELD (VALUES, "values", NULL)                                                         \
  FIELD (FIRST_LABEL, "first_label", NULL)                                               \
  FIELD (SECOND_LABEL, "second_label", NULL)                                             \
  FIELD (LEVELS_LABEL, "levels_label", NULL)                                             \
  FIELD (KIND, "kind", NULL)                                                             \
  FIELD (FIRST, "first", NULL)                                                           \
  FIELD (SECOND, "second", NULL)                                                         \
  FIELD (LEVELS, "levels", NULL)                                                         \
  FIELD (OTHER, "other", NULL)
QN_FORM_FIELDS;

gboolean
qn_study_page_takes_value (QnStudyPage *self, const char *path, double value,
                           GError **error)
{
  const char *text = self->document->text->text;
  char number[QN_NUMBER_TEXT_SIZE];
  g_autofree char *override =
    g_strconcat (path, "=", qn_number_text (value, number), NULL);
  const char *const overrides[] = { override, NULL };
  QnProject probe;
  if (!qn_project_parse (text, strlen (text), "", overrides, &probe, error))
    return FALSE;
  qn_project_clear (&probe);
  return TRUE;
}

/* What a distribution means, and whether values that are likely cannot be computed. */
static char *
dup_meaning (QnStudyPage *self, const QnDraftParameter *parameter)
{
  if (parameter->kind == QN_DRAFT_OTHER)
    return g_strdup (_ ("as the study file says"));
  double low, high;
  gboolean spread =
    parameter->kind == QN_DRAFT_NORMAL || parameter->kind == QN_DRAFT_LOGNORMAL;
  g_autoptr (GString) text = g_string_new (NULL);
  qn_draft_get_fractiles (parameter, &low, &high);
  if (spread)
    g_string_printf (text, _ ("5 %% of the values lie below %.4g, 5 %% above %.4g."), low,
                     high);
  const double ends[] = { low, high };
  for (gsize i = 0; i < G_N_ELEMENTS (ends); i++) {
    g_autoptr (GError) error = NULL;
    if (qn_study_page_takes_value (self, parameter->path, ends[i], &error))
      continue;
    g_autofree char *reason = qn_path_dup_reason (error->message, parameter->path);
    if (text->len > 0)
      g_string_append_c (text, '\n');
    g_string_append_printf (text, _ ("%.3g is refused: %s."), ends[i], reason);
  }
  return g_string_free (g_steal_pointer (&text), FALSE);
}

static GMenuModel *
make_menu (GtkWidget *widget, QnMenuPlace *place, gpointer row)
{
  GMenu *menu = g_menu_new ();
  qn_menu_add_target (menu, _ ("_Leave It As It Is"), "study.remove",
                      g_variant_new_uint32 (((Row *) row)->index));
  return G_MENU_MODEL (menu);
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Row *row = (const Row *) data;
  QnStudyPage *page = row->page;
  const QnDraftParameter parameter = qn_draft_parameter (page->draft, row->index);
  const gboolean limits =
    parameter.kind == QN_DRAFT_UNIFORM || parameter.kind == QN_DRAFT_RANGE;
  int count;
  const QnPlanKind plan = qn_draft_get_plan (page->draft, &count);
  switch (field) {
  case NAME:
    value->text = g_strdup (parameter.name);
    return TRUE;
  case PLACE:
    value->text = qn_path_dup_text (&page->document->project.model, parameter.path);
    gtk_widget_set_tooltip_text (row->base.widgets[PLACE], value->text);
    return TRUE;
  case VALUES:
    return parameter.kind != QN_DRAFT_OTHER;
  case FIRST_LABEL:
    value->text = g_strdup (limits ? _ ("Least") : _ ("Mean"));
    return TRUE;
  case SECOND_LABEL:
    value->text = g_strdup (limits ? _ ("Greatest") : _ ("Deviation"));
    return TRUE;
  case KIND:
    value->number = MIN (parameter.kind, QN_DRAFT_RANGE);
    return TRUE;
  case FIRST:
    value->number = parameter.first;
    return TRUE;
  case SECOND:
    value->number = parameter.second;
    return TRUE;
  case LEVELS_LABEL:
  case LEVELS:
    value->number = parameter.levels;
    return parameter.kind == QN_DRAFT_RANGE || qn_plan_is_by_levels (plan);
  case OTHER:
    value->text = dup_meaning (page, &parameter);
    return *value->text != '\0';
  }
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Row *row = (Row *) data;
  QnStudyPage *page = row->page;
  QnDraft *draft = page->draft;
  if (field == NAME)
    qn_draft_set_name (draft, row->index, value->text);
  else if (field == KIND)
    qn_draft_set_kind (draft, row->index, (QnDraftKind) qn_value_int (value));
  else if (field == REMOVE)
    qn_draft_remove (draft, row->index);
  else
    qn_draft_set_values (
      draft, row->index, (QnDraftKind) (int) qn_form_get_number (row, KIND),
      qn_form_get_number (row, FIRST), qn_form_get_number (row, SECOND),
      (int) qn_to_integer (qn_form_get_number (row, LEVELS), 0, QN_STUDY_MAX_VALUES));
  qn_study_page_show (page); /* with the removed one this form may go */
  return TRUE;
}

void
qn_study_page_show_parameters (QnStudyPage *self, GtkListBox *list)
{
  static const QnFormKind kind = QN_FORM_KIND ("study-parameter", Row);
  const guint count = qn_draft_count (self->draft);
  while (self->rows->len > count) {
    Row *last = g_ptr_array_steal_index (self->rows, self->rows->len - 1);
    gtk_list_box_remove (list, last->base.root);
  }
  while (self->rows->len < count) {
    Row *row = qn_form_new (&kind, NULL);
    row->page = self;
    row->index = self->rows->len;
    qn_context_menu_attach (row->base.root, make_menu, row);
    gtk_list_box_append (list, row->base.root);
    g_ptr_array_add (self->rows, row);
  }
  for (guint i = 0; i < count; i++)
    qn_form_show (self->rows->pdata[i]);
}
