/* A drawing area on which all is drawn as on white paper: in a dark window it becomes dark. */
#pragma once

#include <gtk/gtk.h>

#define QN_TYPE_PAPER_AREA (qn_paper_area_get_type ())
G_DECLARE_FINAL_TYPE (QnPaperArea, qn_paper_area, QN, PAPER_AREA, GtkDrawingArea)

/* In a dark window, true: until it is popped, light becomes dark and hues stay. */
gboolean qn_paper_area_push_dark (GtkWidget *widget, GtkSnapshot *snapshot);
