/* Files that the user chooses, in one modal chooser at a time over a window or one of its dialogs, or
 * drops on a widget. */
#pragma once

#include <gtk/gtk.h>

/* Files of one kind that a window opens. Titles and names are marked for translation, not
 * translated yet. */
typedef struct QnFileKind {
  const char *asked;       /* by this action of the window */
  const char *title;       /* of the chooser */
  const char *accept;      /* what its button is called */
  const char *name;        /* of the kind */
  const char *suffixes[8]; /* without their dots, NULL-terminated */
  const char *action;      /* of the window, with the chosen path as its parameter */
} QnFileKind;

/* The next chooser begins in the folder of this file: that of the project. */
void qn_chooser_begin_beside (const char *path);

/* What is asked of a chooser, with what happens then. */
typedef struct QnFileQuestion {
  const char *title, *accept; /* translated */
  const char *name; /* proposed for a file to be written, translated; NULL: one is read */
  /* Of such a file, NULL-terminated, with their dots. A name that ends in none of them gets the first; such a
   * file must not be there yet, as nobody was asked whether it may be replaced. */
  const char *const *endings;
  /* Reads or writes the file, each of many; FALSE with an error. */
  gboolean (*use) (gpointer data, const char *path, GError **error);
  void (*told) (gpointer data, const char *message); /* where a written one is; or NULL */
  void (*failed) (gpointer data, const char *message); /* why not; NULL: `told` */
  void (*left) (gpointer data);                        /* no file was taken; or NULL */
  const QnFileKind *kind; /* that alone is shown; NULL: all files */
  const char *path;       /* of the file that is proposed, instead of a name; or NULL */
  const char *given;      /* that is the file, and nothing is asked; or NULL */
  gboolean folder, many;  /* folders, in place of files to be read; several at once */
} QnFileQuestion;

/* Asks over the window of a widget, in the folder that was chosen from last. The widget keeps the chooser, its
 * only one, as QN_CHOOSER, and it goes with it; `data` must live as long. */
#define QN_CHOOSER "qn-chooser"
void qn_chooser_ask (GtkWidget *widget, const QnFileQuestion *question, gpointer data);

/* The path of a file to be written with its ending, as above; NULL with an error. The caller frees it. */
char *qn_chooser_complete_path (const char *path, const char *const *endings,
                                GError **error);

/* Files that are dropped on the widget answer the question, too. `data` must live as long as the widget. */
void qn_accept_files (GtkWidget *widget, const QnFileQuestion *question, gpointer data);
