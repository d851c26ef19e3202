/* The list of what varies: each parameter with its distribution. */
#include "app/pages/study-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/quantity-entry.h"
#include "core/base/integer.h"
#include "doc/text/explain.h"
#include "io/text/number-text.h"
#include <glib/gi18n.h>
#include <string.h>

/* Fields of a row, kept with it. */
typedef struct Row {
  GtkDropDown *kind;
  QnQuantityEntry *first, *second, *levels;
  GtkEntry *name;
} Row;

static guint
index_of (GtkWidget *row_part)
{
  GtkWidget *row = gtk_widget_get_ancestor (row_part, GTK_TYPE_LIST_BOX_ROW);
  return (guint) gtk_list_box_row_get_index (GTK_LIST_BOX_ROW (row));
}

static void
on_values (GtkWidget *part, QnStudyPage *self)
{
  Row *row = g_object_get_data (
    G_OBJECT (gtk_widget_get_ancestor (part, GTK_TYPE_LIST_BOX_ROW)), "qn-row");
  if (self->showing)
    return;
  qn_draft_set_values (
    self->draft, index_of (part), (QnDraftKind) gtk_drop_down_get_selected (row->kind),
    qn_quantity_entry_get_value (row->first), qn_quantity_entry_get_value (row->second),
    (int) qn_to_integer (qn_quantity_entry_get_value (row->levels), 0,
                         QN_STUDY_MAX_VALUES));
  qn_study_page_show_draft (self);
}

static void
on_kind (GtkDropDown *choice, GParamSpec *pspec, QnStudyPage *self)
{
  guint kind = gtk_drop_down_get_selected (choice);
  if (self->showing || kind >= QN_DRAFT_OTHER)
    return;
  qn_draft_set_kind (self->draft, index_of (GTK_WIDGET (choice)), (QnDraftKind) kind);
  qn_study_page_show_draft (self);
}

static void
on_name (GtkEntry *entry, QnStudyPage *self)
{
  if (self->showing)
    return;
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  qn_draft_set_name (self->draft, index_of (GTK_WIDGET (entry)), name);
  qn_study_page_show_draft (self);
}

static void
on_remove (GtkButton *button, QnStudyPage *self)
{
  qn_draft_remove (self->draft, index_of (GTK_WIDGET (button)));
  qn_study_page_show_draft (self);
}

static void
show_number (GtkLabel *label, QnQuantityEntry *entry, const char *what, double value)
{
  gtk_label_set_text (label, what);
  gtk_accessible_update_property (GTK_ACCESSIBLE (entry), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  what, -1);
  qn_quantity_entry_set_value (entry, value);
}

gboolean
qn_study_page_takes_value (QnStudyPage *self, const char *path, double value,
                           GError **error)
{
  const char *text = qn_document_get_text (self->document);
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
make_menu (GtkWidget *row, QnMenuPlace *place, gpointer data)
{
  GMenu *menu = g_menu_new ();
  qn_menu_add_target (menu, _ ("_Leave It As It Is"), "study.remove",
                      g_variant_new_uint32 (index_of (row)));
  return G_MENU_MODEL (menu);
}

static void
add_row (QnStudyPage *self, guint index)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("study-parameter");
#define GET(type, name) type (gtk_builder_get_object (builder, name))
  QnDraftParameter parameter = qn_draft_parameter (self->draft, index);
  g_autofree char *path = parameter.path;
  GtkWidget *line = GET (GTK_WIDGET, "row"), *place = GET (GTK_WIDGET, "place");
  GtkWidget *other = GET (GTK_WIDGET, "other");
  Row *row = g_new (Row, 1);
  *row = (Row){ .kind = GET (GTK_DROP_DOWN, "kind"),
                .first = GET (QN_QUANTITY_ENTRY, "first"),
                .second = GET (QN_QUANTITY_ENTRY, "second"),
                .levels = GET (QN_QUANTITY_ENTRY, "levels"),
                .name = GET (GTK_ENTRY, "name") };
  g_object_set_data_full (G_OBJECT (line), "qn-row", row, g_free);
  gtk_editable_set_text (GTK_EDITABLE (row->name), parameter.name);
  g_autofree char *words =
    qn_path_dup_text (qn_document_get_model (self->document), path);
  gtk_label_set_text (GTK_LABEL (place), words);
  gtk_widget_set_tooltip_text (place, words);
  if (parameter.kind == QN_DRAFT_OTHER) {
    gtk_label_set_text (GTK_LABEL (other), _ ("as the study file says"));
    gtk_widget_set_visible (GET (GTK_WIDGET, "values"), FALSE);
  } else {
    gboolean limits =
      parameter.kind == QN_DRAFT_UNIFORM || parameter.kind == QN_DRAFT_RANGE;
    int count;
    QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
    gtk_drop_down_set_selected (row->kind, parameter.kind);
    show_number (GET (GTK_LABEL, "first_label"), row->first,
                 limits ? _ ("Least") : _ ("Mean"), parameter.first);
    show_number (GET (GTK_LABEL, "second_label"), row->second,
                 limits ? _ ("Greatest") : _ ("Deviation"), parameter.second);
    show_number (GET (GTK_LABEL, "levels_label"), row->levels, _ ("Values"),
                 parameter.levels);
    gboolean levels = parameter.kind == QN_DRAFT_RANGE || qn_plan_is_by_levels (plan);
    gtk_widget_set_visible (GTK_WIDGET (row->levels), levels);
    gtk_widget_set_visible (GET (GTK_WIDGET, "levels_label"), levels);
    g_autofree char *meaning = dup_meaning (self, &parameter);
    gtk_label_set_text (GTK_LABEL (other), meaning);
    gtk_widget_set_visible (other, *meaning != '\0');
  }
  g_signal_connect (row->name, "activate", G_CALLBACK (on_name), self);
  g_signal_connect (GET (GTK_WIDGET, "remove"), "clicked", G_CALLBACK (on_remove), self);
  g_signal_connect (row->kind, "notify::selected", G_CALLBACK (on_kind), self);
  QnQuantityEntry *const numbers[] = { row->first, row->second, row->levels };
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++)
    g_signal_connect (numbers[i], "committed", G_CALLBACK (on_values), self);
  qn_context_menu_attach (line, make_menu, self);
  gtk_list_box_append (self->parameters, line);
#undef GET
}

void
qn_study_page_show_parameters (QnStudyPage *self)
{
  GtkListBoxRow *row;
  guint count = qn_draft_count (self->draft);
  while ((row = gtk_list_box_get_row_at_index (self->parameters, 0)) != NULL)
    gtk_list_box_remove (self->parameters, GTK_WIDGET (row));
  for (guint i = 0; i < count; i++)
    add_row (self, i);
  gtk_widget_set_visible (GTK_WIDGET (self->parameters), count > 0);
}
