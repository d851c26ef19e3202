/* What is drawn by Cairo grows with the text that the user has set. */
#pragma once

#include <gtk/gtk.h>

/* Pixels per typographic point of a drawing in which text of 9 or 10 points is as large as the text of
 * the widget: QN_TEXT_UNIT where that has 10 points at 96 dpi, and never less. */
#define QN_TEXT_UNIT (96.0 / 72.0)
double qn_text_unit (GtkWidget *widget);
