/* Two children: beside each other where both have the room that they take by themselves, the first taking
 * the rest; else the second below the first. */
#ifndef QN_APP_WRAP_PAIR_H
#define QN_APP_WRAP_PAIR_H

#include <gtk/gtk.h>

#define QN_TYPE_WRAP_PAIR (qn_wrap_pair_get_type ())
G_DECLARE_FINAL_TYPE (QnWrapPair, qn_wrap_pair, QN, WRAP_PAIR, GtkWidget)

GtkWidget *qn_wrap_pair_new (GtkWidget *first, GtkWidget *second);

#endif
