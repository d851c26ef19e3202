/* The list of a drop-down. */
#pragma once

#include <gtk/gtk.h>

/* Long names are cut short in the button, not in the list; without a list it gets an empty one. */
void qn_choice_list_prepare (GtkDropDown *choice);

/* Fills a drop-down anew. It keeps its model: a handler of its own "notify::selected" may call this, where
 * another model would free what GTK is still working on. */
void qn_choice_list_fill (GtkDropDown *choice, const char *const *strings);
