/* Popovers that close, and those of windows that close. */
#ifndef QN_APP_POPOVERS_H
#define QN_APP_POPOVERS_H

#include <gtk/gtk.h>

/* Popovers that are open when the window goes close with it. GTK 4.8 takes them from the screen only:
 * they would keep the pointer and the keys, and stay in memory. A popover that closes alone gives the keys
 * back. */
void qn_popovers_attend (GtkWidget *window);

#endif
