/* Windows that ask something: over their parent, closed by Escape. */
#pragma once

#include <gtk/gtk.h>

/* Popovers that are open when the window goes close with it. GTK 4.8 takes them from the screen only:
 * they would keep the pointer and the keys, and stay in memory. A popover that closes alone gives the keys
 * back. */
void qn_popovers_attend (GtkWidget *window);

/* Escape closes the window, and popovers that close give their keys back. For windows that do not come
 * from qn_builder_new(), which does it. */
void qn_dialog_attend (GtkWidget *window);

/* Modal, gone with its parent. A height of -1 takes what the content needs. */
GtkWidget *qn_dialog_new (GtkWindow *parent, const char *title, int width, int height);

/* Shows it with the focus on the button that takes what it offers, for Return. */
void qn_dialog_present (GtkWidget *dialog, GtkWidget *accept);

/* The path chosen for a file to be written. One that ends in none of `endings` (NULL-terminated,
 * with their dots) gets the first of them; such a file must not be there yet, as nobody was asked
 * whether it may be replaced. NULL with an error; the caller frees it. */
char *qn_dialog_dup_chosen_path (GtkNativeDialog *chooser, const char *const *endings,
                                 GError **error);

/* The same for a path. */
char *qn_dialog_complete_path (const char *path, const char *const *endings,
                               GError **error);
