/* The manual: in Yelp where it is installed and the desktop shows help, else in a window of the
 * program, which holds the same pages. */
#pragma once

#include <gtk/gtk.h>

/* Names the page of the manual (docs/manual, without .md) that is about a widget and all that it
 * contains; in a dialog F1 shows it. `page` is not copied. */
void qn_help_set_page (GtkWidget *widget, const char *page);

/* The page of the widget or of the nearest one around it, or NULL. */
const char *qn_help_find_page (GtkWidget *widget);

/* Shows a page; NULL is the first one. */
void qn_help_show (GtkWindow *parent, const char *page);
