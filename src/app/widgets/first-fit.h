/* Shows the first of its children that has room for what it asks for at least, else the last. */
#ifndef QN_APP_FIRST_FIT_H
#define QN_APP_FIRST_FIT_H

#include <gtk/gtk.h>

#define QN_TYPE_FIRST_FIT (qn_first_fit_get_type ())
G_DECLARE_FINAL_TYPE (QnFirstFit, qn_first_fit, QN, FIRST_FIT, GtkWidget)

#endif
