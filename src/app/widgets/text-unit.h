/* What is drawn by Cairo grows with the text that the user has set. */
#ifndef QN_APP_TEXT_UNIT_H
#define QN_APP_TEXT_UNIT_H

#include <gtk/gtk.h>

/* Pixels per typographic point of a drawing in which text of 9 or 10 points is as large as the text of
 * the widget: 4/3 where that has 10 points at 96 dpi, and never less. */
double qn_text_unit (GtkWidget *widget);

#endif
