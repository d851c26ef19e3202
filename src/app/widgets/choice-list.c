#include "app/widgets/choice-list.h"

#include "app/widgets/shortened.h"

/* Characters of a longer choice that are shown in any case. */
#define CHOICE_CHARS 16

static void
on_setup_choice (GtkSignalListItemFactory *factory, GtkListItem *item, gpointer shortened)
{
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  if (shortened != NULL)
    qn_shortened_set (GTK_LABEL (label), PANGO_ELLIPSIZE_END);
  gtk_list_item_set_child (item, label);
}

static void
on_bind_choice (GtkSignalListItemFactory *factory, GtkListItem *item, gpointer data)
{
  GtkLabel *label = GTK_LABEL (gtk_list_item_get_child (item));
  const char *text = gtk_string_object_get_string (gtk_list_item_get_item (item));
  gtk_label_set_text (label, text);
  gtk_label_set_width_chars (label, (int) MIN (g_utf8_strlen (text, -1), CHOICE_CHARS));
}

static GtkListItemFactory *
make_choice_factory (gboolean shortened)
{
  GtkListItemFactory *factory = gtk_signal_list_item_factory_new ();
  g_signal_connect (factory, "setup", G_CALLBACK (on_setup_choice),
                    GINT_TO_POINTER (shortened));
  g_signal_connect (factory, "bind", G_CALLBACK (on_bind_choice), NULL);
  return factory;
}

void
qn_choice_list_prepare (GtkDropDown *choice)
{
  g_autoptr (GtkListItemFactory) button = make_choice_factory (TRUE);
  g_autoptr (GtkListItemFactory) list = make_choice_factory (FALSE);
  gtk_drop_down_set_factory (choice, button);
  gtk_drop_down_set_list_factory (choice, list);
  if (gtk_drop_down_get_model (choice) == NULL) {
    g_autoptr (GtkStringList) rows = gtk_string_list_new (NULL);
    gtk_drop_down_set_model (choice, G_LIST_MODEL (rows));
  }
}

void
qn_choice_list_fill (GtkDropDown *choice, const char *const *strings)
{
  GListModel *list = gtk_drop_down_get_model (choice);
  guint count = g_list_model_get_n_items (list), same = 0;
  while (same < count
         && g_strcmp0 (gtk_string_list_get_string (GTK_STRING_LIST (list), same),
                       strings[same])
              == 0)
    same++;
  if (same < count || strings[count] != NULL)
    gtk_string_list_splice (GTK_STRING_LIST (list), 0, count, strings);
}
