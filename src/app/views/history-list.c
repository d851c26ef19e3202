#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

typedef struct List {
  QnDocument *document;
  GtkWidget *box;
} List;

static void
on_row_activated (GtkListBox *box, GtkListBoxRow *row, List *list)
{
  (void) box;
  qn_document_go_to (list->document, (guint) gtk_list_box_row_get_index (row));
}

static void
add_row (List *list, const char *text, gboolean undone)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  if (undone)
    gtk_widget_add_css_class (label, "dim-label");
  gtk_list_box_append (GTK_LIST_BOX (list->box), label);
}

static void
update (List *list)
{
  QnHistory *history = qn_document_get_history (list->document);
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (list->box)) != NULL)
    gtk_list_box_remove (GTK_LIST_BOX (list->box), child);
  guint position = qn_history_get_position (history);
  add_row (list, _ ("As opened"), FALSE);
  for (guint i = 0; i < qn_history_get_count (history); i++)
    add_row (list, qn_history_get_name (history, i), i >= position);
  gtk_list_box_select_row (
    GTK_LIST_BOX (list->box),
    gtk_list_box_get_row_at_index (GTK_LIST_BOX (list->box), (int) position));
}

GtkWidget *
qn_history_list_new (QnDocument *document)
{
  List *list = g_new0 (List, 1);
  list->document = document;
  list->box = gtk_list_box_new ();
  gtk_list_box_set_activate_on_single_click (GTK_LIST_BOX (list->box), TRUE);
  gtk_accessible_update_property (GTK_ACCESSIBLE (list->box),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  _ ("Steps of the history"), -1);
  g_signal_connect (list->box, "row-activated", G_CALLBACK (on_row_activated), list);
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_policy (GTK_SCROLLED_WINDOW (scroller), GTK_POLICY_NEVER,
                                  GTK_POLICY_AUTOMATIC);
  gtk_scrolled_window_set_max_content_height (GTK_SCROLLED_WINDOW (scroller), 400);
  gtk_scrolled_window_set_propagate_natural_height (GTK_SCROLLED_WINDOW (scroller), TRUE);
  gtk_widget_set_size_request (scroller, 220, -1);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), list->box);
  qn_own (scroller, list);
  qn_watch (scroller, document, "history-changed", G_CALLBACK (update), list);
  update (list);
  return scroller;
}
