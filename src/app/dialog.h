/* Windows that ask something: over their parent, closed by Escape. */
#ifndef QN_APP_DIALOG_H
#define QN_APP_DIALOG_H

#include <gtk/gtk.h>

/* Modal, gone with its parent. A height of -1 takes what the content needs. */
GtkWidget *qn_dialog_new (GtkWindow *parent, const char *title, int width, int height);

#endif
