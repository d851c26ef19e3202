#include "app/widgets/choice-list.h"

static gboolean
holds (GListModel *list, const char *const *strings)
{
  guint count = g_list_model_get_n_items (list);
  for (guint i = 0; i < count; i++)
    if (g_strcmp0 (gtk_string_list_get_string (GTK_STRING_LIST (list), i), strings[i])
        != 0)
      return FALSE;
  return strings[count] == NULL;
}

void
qn_choice_list_fill (GtkDropDown *choice, const char *const *strings, guint selected,
                     gpointer user_data)
{
  GListModel *list = gtk_drop_down_get_model (choice);
  g_signal_handlers_block_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                   user_data);
  if (!holds (list, strings))
    gtk_string_list_splice (GTK_STRING_LIST (list), 0, g_list_model_get_n_items (list),
                            strings);
  gtk_drop_down_set_selected (choice, selected);
  g_signal_handlers_unblock_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                     user_data);
}
