/* Labels that are cut short where there is no room for them. */
#ifndef QN_APP_SHORTENED_H
#define QN_APP_SHORTENED_H

#include <gtk/gtk.h>

/* A label that may be cut short tells its whole text in a tooltip as long as it is; what is around it
 * may have another tooltip. */
void qn_shortened_tell (GtkLabel *label);

/* The same for all labels in a widget, such as the title that a header bar makes. */
void qn_shortened_tell_within (GtkWidget *widget);

/* Cuts it short there, and tells. */
void qn_shortened_set (GtkLabel *label, PangoEllipsizeMode mode);

#endif
