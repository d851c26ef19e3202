/* Files that the user chooses, in one modal chooser at a time over a window or one of its dialogs, or
 * drops on a widget. */
#pragma once

#include <gtk/gtk.h>

/* Files of one kind that a window opens. Titles and names are marked for translation, not
 * translated yet. */
typedef struct QnFileKind {
  const char *title;           /* of the chooser */
  const char *accept;          /* what its button is called */
  const char *name;            /* of the kind */
  const char *const *suffixes; /* without their dots, NULL-terminated */
  const char *action;          /* of the window, with the chosen path as its parameter */
} QnFileKind;

/* Shows such files alone. */
void qn_chooser_add_kind (GtkFileChooserNative *chooser, const QnFileKind *kind);

/* The next chooser begins in the folder of this file: that of the project. */
void qn_chooser_begin_beside (const char *path);

/* A chooser over `parent`, in the folder that was chosen from last, that is still to be told what happens
 * on its response, and to be shown. *kept holds it from now on, in place of what it held; the response is
 * to clear *kept. */
GtkFileChooserNative *qn_chooser_begin (GtkWindow *parent, GObject **kept,
                                        GtkFileChooserAction action, const char *title,
                                        const char *accept);

/* What is asked of a chooser, with what happens then. */
typedef struct QnFileQuestion {
  const char *title, *accept; /* translated */
  const char *name; /* proposed for a file to be written, translated; NULL: one is read */
  const char *const *endings; /* of such a file: see qn_dialog_dup_chosen_path() */
  /* The file; NULL with the reason why it is none. Not called where none was chosen. */
  void (*chosen) (gpointer data, const char *path, const GError *error);
} QnFileQuestion;

/* Asks over `parent`; *kept holds the chooser while it is there, and `data` must live as long. */
void qn_chooser_ask (GtkWindow *parent, GObject **kept, const QnFileQuestion *question,
                     gpointer data);

/* Calls `take` for every file that is dropped on the widget; it says whether it takes the file. `data`
 * must live as long as the widget. */
typedef gboolean (*QnTakeFile) (GFile *file, gpointer data);
void qn_accept_files (GtkWidget *widget, QnTakeFile take, gpointer data);
