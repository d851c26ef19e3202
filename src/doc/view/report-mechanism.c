/* A page of a report on the kinematic check of a mechanism, where the project asks for it. */
#include "doc/text/explain.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/report-parts.h"

#include <glib/gi18n-lib.h>

/* The bodies, in picture and words. */
static bool
write_bodies (QnPages *pages, const QnReportRun *run, GError **error)
{
  const QnModel *model = &run->project->model;
  QnFigure figure;
  g_autofree char *words = qn_explain_mechanism (model, run->contacts, &run->file.result);
  qn_figure_init (&figure, model, run->contacts, &run->file.result, QN_VIEW_MECHANISM);
  figure.options.field = QN_FIELD_BODIES;
  figure.title = _ ("Bodies of the mechanism");
  if (words != NULL)
    qn_pages_paragraph (pages, words);
  qn_report_say (pages, _ ("%s: figure\u00a0%d."), figure.title,
                 qn_pages_next_figure (pages));
  return qn_pages_figures (pages, &figure, 1, 1, 0.3, error);
}

static void
write_checks (QnPages *pages, const QnCapacityAnswer *answer, QnUnits units)
{
  g_autoptr (GPtrArray) cells = qn_capacity_answer_make_table (answer, units);
  if (cells->len > QN_CAPACITY_COLUMNS)
    qn_report_table (pages, cells, QN_CAPACITY_COLUMNS);
  g_autoptr (QnPlot) plot = qn_capacity_answer_plot (answer);
  plot->title = _ ("Capacity curve of the mechanism");
  qn_report_say (pages, _ ("%s: figure\u00a0%d."), plot->title,
                 qn_pages_next_figure (pages));
  qn_pages_plot (pages, plot, 0.25);
}

bool
qn_report_write_mechanism (QnPages *pages, const QnReportRun *run, QnUnits units,
                           GError **error)
{
  const QnModel *model = &run->project->model;
  QnCapacityAnswer answer = { 0 };
  QnCapacitySettings settings;
  QnRecord points = { 0 };
  QnDiag diag = { 0 };
  g_autoptr (GError) wrong = NULL;
  g_autofree char *refused = NULL;
  bool done = true;
  gboolean read = qn_capacity_settings_read (run->project, &settings, &wrong);
  if (read && !settings.mechanism) {
    qn_capacity_settings_clear (&settings);
    return true;
  }
  g_autofree char *title = g_strdup_printf (_ ("Mechanism by code: %s"), run->name);
  qn_pages_break (pages);
  qn_pages_heading (pages, title);
  if (read
      && qn_capacity_settings_apply (&settings, run->project, FALSE, &answer, &points,
                                     &wrong)
      && qn_capacity_init_kinematic (&answer.capacity, model, run->contacts,
                                     &run->file.result, answer.control, answer.tie_strain,
                                     &diag)
           != QN_OK)
    refused = qn_explain_diag (model, &diag);
  if (wrong != NULL || refused != NULL) {
    qn_report_say (pages, _ ("Not checked: %s."),
                   wrong != NULL ? wrong->message : refused);
  } else {
    qn_capacity_answer_check (&answer);
    answer.block = g_strdup (model->blocks[answer.capacity.block].name);
    g_autofree char *facts = qn_capacity_answer_dup_facts (&answer, units);
    done = write_bodies (pages, run, error);
    qn_pages_paragraph (pages, facts);
    write_checks (pages, &answer, units);
    qn_pages_paragraph (
      pages,
      answer.tie_strain > 0
        ? _ ("The parts turn about hinges and do not break; alpha0 counts ties at their "
             "strength, the curve until they break. Compare the formulas with the code "
             "before you rely on them.")
        : _ ("The parts turn about hinges and do not break; alpha0 counts ties at their "
             "strength, the curve is that without ties. Compare the formulas with the "
             "code before you rely on them."));
  }
  qn_capacity_answer_clear (&answer);
  qn_record_clear (&points);
  qn_capacity_settings_clear (&settings);
  return done;
}
