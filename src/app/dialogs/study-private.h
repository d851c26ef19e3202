/* The inside of the study window, shared by the files that make it up. */
#pragma once

#include "app/dialogs/study-window.h"
#include "study/cases/study-job.h"
#include "study/plan/draft.h"
#include "study/report/figures.h"

typedef struct QnStudyWindow {
  QnStudyParent parent;
  GtkWindow *window;
  GSimpleActionGroup *actions;
  GObject *chooser;     /* file chooser on the screen */
  const char *exported; /* what it asks for a file for */

  QnDraft *draft;
  gboolean showing; /* the draft is being shown: nobody has entered anything */
  QnStudyJob *job;  /* while it runs */
  guint timeout;

  char *running; /* folder of the results that are computed now, or last */
  char *folder;  /* of the results shown, or NULL */
  QnStudy study; /* that they belong to */
  QnTable table;
  gint64 chosen;   /* row, or -1 */
  gboolean points; /* were drawn, one for each row */

  /* from study-window.ui */
  GtkListBox *parameters;
  GtkDropDown *analysis, *plan, *figure, *of, *by, *by_second;
  GtkSpinButton *count;
  GtkWidget *cases, *outputs, *plot, *over, *and;
  GtkProgressBar *progress;
  GtkLabel *status, *failed;
} QnStudyWindow;

/* Figures that can be chosen, as in the list of study-window.ui. */
enum {
  QN_STUDY_ROW_CUMULATIVE,
  QN_STUDY_ROW_SCATTER,
  QN_STUDY_ROW_HISTOGRAM,
  QN_STUDY_ROW_TORNADO,
  QN_STUDY_ROW_ENVELOPE,
  QN_STUDY_ROW_SURFACE
};

/* study-window.c: the line under the figure; which actions can be used; the draft shown anew, soon:
 * rows are made anew outside of the signals of their own widgets. */
void qn_study_window_tell (QnStudyWindow *self, const char *text);
void qn_study_window_update_actions (QnStudyWindow *self);
void qn_study_window_show_draft (QnStudyWindow *self);

/* study-parameters.c: the list of what varies. */
void qn_study_window_show_parameters (QnStudyWindow *self);
/* Whether the project reads with this value there. */
gboolean qn_study_window_takes_value (QnStudyWindow *self, const char *path, double value,
                                      GError **error);

/* study-plan.c: analysis, plan, number of cases, outputs. */
void qn_study_window_connect_plan (QnStudyWindow *self);
void qn_study_window_show_plan (QnStudyWindow *self);

/* study-results.c: what has been computed.
 * Folder of the results of a study as it is now; the caller frees it. */
char *qn_study_window_dup_folder (const QnStudy *study, const char *path);
void qn_study_window_forget_results (QnStudyWindow *self);
/* Reads those of the study as its file is now; none is no error. */
void qn_study_window_read_results (QnStudyWindow *self);
/* What has come in since, of the study that runs. */
void qn_study_window_read_more (QnStudyWindow *self);

/* study-run.c: cases that are being computed. The job is looked at now and then. */
void qn_study_window_run (QnStudyWindow *self);

/* study-plot.c: the figure, and its points under the pointer. FALSE: nothing to draw. */
void qn_study_window_connect_plot (QnStudyWindow *self);
gboolean qn_study_window_chosen_figure (QnStudyWindow *self, QnStudyFigure *figure);

/* study-case.c: the chosen case, analysed again, in the drawing of the main window. */
void qn_study_window_open_case (QnStudyWindow *self);

/* study-export.c: "table", "figure" or "mechanisms", to a file that is asked for, or to `path`. */
void qn_study_window_export (QnStudyWindow *self, const char *what);
void qn_study_window_export_to (QnStudyWindow *self, const char *what, const char *path);
