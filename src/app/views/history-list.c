#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include <glib/gi18n.h>

typedef struct List {
  QnDocument *document;
  GtkWidget *box;
} List;

static void
on_row_activated (GtkListBox *box, GtkListBoxRow *row, List *list)
{
  qn_document_go_to (list->document, (guint) gtk_list_box_row_get_index (row));
}

/* The step that was clicked, or that has the focus. */
static GMenuModel *
make_menu (GtkWidget *box, QnMenuPlace *place, gpointer data)
{
  GtkListBoxRow *row = gtk_list_box_get_row_at_y (GTK_LIST_BOX (box), (int) place->y);
  GtkWidget *focus = gtk_window_get_focus (GTK_WINDOW (gtk_widget_get_root (box)));
  if (place->by_key && focus != NULL)
    row = GTK_LIST_BOX_ROW (gtk_widget_get_ancestor (focus, GTK_TYPE_LIST_BOX_ROW));
  if (row == NULL)
    return NULL;
  graphene_point_t at;
  if (place->by_key
      && gtk_widget_compute_point (GTK_WIDGET (row), box, graphene_point_zero (), &at))
    place->y = at.y + 0.5 * gtk_widget_get_height (GTK_WIDGET (row));
  GMenu *menu = g_menu_new ();
  const char *name = gtk_label_get_text (GTK_LABEL (gtk_list_box_row_get_child (row)));
  qn_menu_add_target (menu, _ ("_Go to This Step"), "win.go-to-step",
                      g_variant_new_int32 (gtk_list_box_row_get_index (row)));
  qn_menu_add_target (menu, _ ("_Copy Text"), "win.copy-text",
                      g_variant_new_string (name));
  return G_MENU_MODEL (menu);
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
  QnEditHistory *history = list->document->history;
  GtkListBoxRow *row; /* the context menu is a child, too */
  while ((row = gtk_list_box_get_row_at_index (GTK_LIST_BOX (list->box), 0)) != NULL)
    gtk_list_box_remove (GTK_LIST_BOX (list->box), GTK_WIDGET (row));
  guint position = history->position;
  add_row (list, _ ("As opened"), FALSE);
  for (guint i = 0; i < history->steps->len; i++)
    add_row (list, qn_history_get_name (history, i), i >= position);
  gtk_list_box_select_row (
    GTK_LIST_BOX (list->box),
    gtk_list_box_get_row_at_index (GTK_LIST_BOX (list->box), (int) position));
}

GtkWidget *
qn_history_list_new (QnDocument *document)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("history-list");
  GtkWidget *scroller = qn_builder_take_widget (builder, "history");
  List *list = g_new (List, 1);
  *list = (List){ document, qn_builder_get_widget (builder, "steps") };
  g_signal_connect (list->box, "row-activated", G_CALLBACK (on_row_activated), list);
  qn_context_menu_attach (list->box, make_menu, NULL);
  qn_own (scroller, list);
  qn_watch (scroller, document, "history-changed", G_CALLBACK (update), list);
  update (list);
  return scroller;
}
