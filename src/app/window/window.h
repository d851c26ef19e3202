/* A window: one document with its drawing, panels and actions. */
#pragma once

#include "app/canvas/canvas.h"
#include <gtk/gtk.h>

#define QN_TYPE_WINDOW (qn_window_get_type ())
G_DECLARE_FINAL_TYPE (QnWindow, qn_window, QN, WINDOW, GtkApplicationWindow)

/* A window with the start page. */
QnWindow *qn_window_new (GtkApplication *application);

/* Borrowed. */
QnDocument *qn_window_get_document (QnWindow *window);

/* The page of the manual about what has the focus: a tool, the selection, a panel. */
const char *qn_window_get_help_page (QnWindow *window);

/* Whether it still shows the start page: a file may be opened into it. */
gboolean qn_window_is_blank (QnWindow *window);

/* The window that shows the project file, or NULL. */
QnWindow *qn_window_find_path (GtkApplication *application, const char *path);

/* Opens a file by one of the functions below, in this window while it is blank, in a new one otherwise. Where
 * the file cannot be opened this window says so, and no other is left. */
void qn_window_open_with (QnWindow *window, const char *path,
                          gboolean (*open) (QnWindow *, const char *));
/* The same for any file; a project that is open already is shown where it is. */
void qn_window_open (QnWindow *window, const char *path);

/* Closes all windows. What is not saved in them is asked for once. */
void qn_window_quit (GtkApplication *application);
/* When a window has gone: the next one that is to be saved by qn_window_quit() is. */
void qn_window_save_next (GtkApplication *application);

/* Opens a project, or imports what the kind of file allows, and presents the window. Says so in it
 * where the file cannot be read, and returns FALSE. */
gboolean qn_window_open_path (QnWindow *window, const char *path);

/* Opens an example: a drawing of its own, to be saved elsewhere. */
gboolean qn_window_open_copy (QnWindow *window, const char *path);

/* Takes over a recovered text. */
gboolean qn_window_open_recovered (QnWindow *window, const char *recovery_path);

/* A message in the bar above the drawing, with the place it is about (nullable). */
void qn_window_show_error (gpointer window, const char *message);
/* The same for what went well; it goes by itself. */
void qn_window_show_message (gpointer window, const char *message);
void qn_window_show_error_at (QnWindow *window, const char *message, QnVec2 at);
