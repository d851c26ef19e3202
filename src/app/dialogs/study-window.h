/* The study of a project: what varies in it, its plan, and its cases as they come in.
 *
 * The study file lies beside the project and is written whenever the study is run; every state of
 * it has a folder of results of its own, so that the same study goes on where it stopped. */
#pragma once

#include "app/dialogs/dialogs.h"

/* What the window belongs to. */
typedef struct QnStudyParent {
  GtkWindow *window;
  QnDocument *document;
  QnViewState *state;
} QnStudyParent;

/* Shows the study window of a main window, which has one at most, and returns it; NULL with an error
 * where the project has no file yet or its study cannot be read. `path` (nullable): a study file
 * other than the project's own. */
GtkWindow *qn_study_window_show (const QnStudyParent *parent, const char *path,
                                 GError **error);

/* Makes a number of the project vary. */
void qn_study_window_vary (GtkWindow *window, const char *path, double base);

/* The force moves along a line that has been drawn. */
void qn_study_window_move_load (GtkWindow *window, const char *path, const GArray *line);
