/* The inside of the page of studies, shared by the files that make it up. */
#pragma once

#include "app/forms/form.h"
#include "app/pages/pages.h"
#include "study/cases/run.h"
#include "study/plan/draft.h"
#include "study/report/figures.h"

typedef struct QnStudyPage {
  QnForm base;
  QnDocument *document;
  QnViewState *state;
  const char *exported; /* what a file is asked for */

  QnDraft *draft;
  GPtrArray *rows; /* forms of what varies */
  QnStudyJob *job; /* while it runs */
  double share;    /* of its cases that are there */
  guint timeout;

  char *running; /* folder of the results that are computed now, or last */
  char *folder;  /* of the results shown, or NULL */
  QnStudy study; /* that they belong to */
  QnTable table;
  gint64 chosen;                 /* row, or -1 */
  gboolean points;               /* were drawn, one for each row */
  int figure, of, by, by_second; /* rows of the choices of the figure */
  GtkLabel *status;
} QnStudyPage;

/* study-page.c: the line under the figure; everything shown anew. */
void qn_study_page_tell (gpointer self, const char *text);
void qn_study_page_show (QnStudyPage *self);
/* FALSE: nothing to draw. */
gboolean qn_study_page_chosen_figure (QnStudyPage *self, QnStudyFigure *figure);

/* study-parameters.c: the list of what varies. */
void qn_study_page_show_parameters (QnStudyPage *self, GtkListBox *list);
/* Whether the project reads with this value there. */
gboolean qn_study_page_takes_value (QnStudyPage *self, const char *path, double value,
                                    GError **error);

/* study-results.c: what has been computed. */
void qn_study_page_forget_results (QnStudyPage *self);
/* Reads those of the study as its file is now; none is no error. */
void qn_study_page_read_results (QnStudyPage *self);
/* Of actions. Computes what is missing; the job is looked at now and then. */
void qn_study_page_run (GSimpleAction *action, GVariant *parameter, gpointer self);
/* The chosen case, analysed again, in the drawing. */
void qn_study_page_open_case (QnStudyPage *self);
/* Of actions: "table", "figure" or "mechanisms", to a file that is asked for; or (what, path). */
void qn_study_page_export (GSimpleAction *action, GVariant *what, gpointer self);
