/* The list of a drop-down. */
#pragma once

#include <gtk/gtk.h>

/* Long names are cut short in the button, not in the list; without a list it gets an empty one. */
void qn_choice_list_prepare (GtkDropDown *choice);

/* Fills a drop-down anew and selects a row, without telling those handlers that were connected with
 * `user_data`. The drop-down keeps its model: a handler of its own "notify::selected" may call
 * this, where another model would free what GTK is still working on. */
void qn_choice_list_fill (GtkDropDown *choice, const char *const *strings, guint selected,
                          gpointer user_data);

/* Selects a row, without telling those handlers either. */
void qn_choice_list_select (GtkDropDown *choice, guint selected, gpointer user_data);
