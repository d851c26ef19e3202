/* Labels that are cut short where there is no room for them. */
#pragma once

#include <gtk/gtk.h>

/* Every label in a widget that may be cut short, such as the title that a header bar makes, tells its
 * whole text in a tooltip as long as it is; what is around it may have another tooltip. */
void qn_shortened_tell (GtkWidget *widget);

/* Cuts a label short there, and tells. */
void qn_shortened_set (GtkLabel *label, PangoEllipsizeMode mode);

/* The folder of a file, with "~" for the user's own. The caller frees it. */
char *qn_shortened_dup_folder (const char *path);
