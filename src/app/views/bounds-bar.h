/* A line of multipliers from the least to the greatest value that was found for a model, each a mark
 * on it; the pointer over a mark, or a screen reader, is told how it was found. The part up to the
 * lower bound of limit analysis is drawn full, the part up to the upper bound faint. */
#pragma once

#include "doc/document/bounds.h"
#include <gtk/gtk.h>

#define QN_TYPE_BOUNDS_BAR (qn_bounds_bar_get_type ())
G_DECLARE_FINAL_TYPE (QnBoundsBar, qn_bounds_bar, QN, BOUNDS_BAR, GtkWidget)

/* Shows these (of QnBound; referenced); hides itself where there are fewer than two. */
void qn_bounds_bar_set (QnBoundsBar *bar, GArray *bounds);

/* What is told of the mark at a place of the widget, px; NULL where none is near. The caller frees
 * it. */
char *qn_bounds_bar_dup_told (QnBoundsBar *bar, double x);

/* Place of a mark on the widget, px. */
double qn_bounds_bar_place (QnBoundsBar *bar, double value);
