/* What a window without a drawing shows: new, open, examples with thumbnails, recent files. */
#ifndef QN_APP_START_PAGE_H
#define QN_APP_START_PAGE_H

#include <gtk/gtk.h>

/* Emits nothing: its buttons are actions of the window ("win.open-path" with a path). */
GtkWidget *qn_start_page_new (void);

#endif
