/* Dialogs over a window. Each gets what it works on, and functions by which it tells its window
 * what has come of it; what is passed must live as long as the window. */
#pragma once

#include "doc/view/recipe.h"
#include "doc/view/view-state.h"
#include <gtk/gtk.h>

/* Shows in the window what went well. */
typedef void (*QnTellFunc) (gpointer window, const char *message);

/* Of the program. */
void qn_preferences_show (GtkWindow *parent);
void qn_about_show (GtkWindow *parent);

/* A figure of what the view state shows. Hands over the path that was chosen and what the figure
 * is to show, for the window to write it; the recipe is taken over. */
typedef void (*QnFigureFunc) (GtkWindow *window, const char *path, QnRecipe *recipe);
void qn_export_dialog_show (GtkWindow *parent, QnViewState *state, QnFigureFunc write,
                            QnTellFunc tell);

/* What the report of the project holds, kept in it; then has the window ask for the file. */
typedef void (*QnReportFunc) (GtkWindow *window);
void qn_report_dialog_show (GtkWindow *parent, QnDocument *document, QnReportFunc choose);

/* An animation of the current run. With a path it is written there at once, as the dialog would by
 * itself, and the dialog shows how far it is. */
void qn_animation_dialog_show (GtkWindow *parent, QnViewState *state, QnTellFunc tell,
                               const char *path);

/* What the drawing of another program becomes. Hands over the project for the window to take in;
 * it remains the dialog's. */
typedef void (*QnImportFunc) (GtkWindow *window, const QnProject *project);
void qn_import_dialog_show (GtkWindow *parent, const char *path, gboolean adds,
                            QnImportFunc import);

/* The strip of a façade, likewise. */
void qn_facade_dialog_show (GtkWindow *parent, QnImportFunc import);
