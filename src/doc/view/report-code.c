/* Pages of a report by codes: on the kinematic check of a mechanism, where the project asks for it, and on the
 * combinations of load cases, where it has a code for them. */
#include "core/path/analysis.h"
#include "doc/text/explain.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/report-parts.h"
#include "io/project/combinations.h"
#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* ---- the mechanism ---- */

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
    /* The bodies, in picture and words. */
    QnFigure figure;
    g_autofree char *words =
      qn_explain_mechanism (model, run->contacts, &run->file.result);
    qn_figure_init (&figure, model, run->contacts, &run->file.result, QN_VIEW_MECHANISM);
    figure.options.field = QN_FIELD_BODIES;
    figure.title = _ ("Bodies of the mechanism");
    if (words != NULL)
      qn_pages_paragraph (pages, words);
    qn_report_say (pages, _ ("%s: figure\u00a0%d."), figure.title,
                   qn_pages_next_figure (pages));
    done = qn_pages_figures (pages, &figure, 1, 1, 0.3, error);
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

/* ---- combinations ---- */

/* The project as one combination, analysed as it says. The multiplier of its live loads, INFINITY where
 * the combination has none, -INFINITY where there is no equilibrium or no answer: then *why is set. NAN
 * where it is cancelled. */
static double
solve (const QnReport *report, const QnCombination *combination, char **why)
{
  const QnProject *project = report->project;
  g_autoptr (GPtrArray) overrides = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GError) error = NULL;
  QnProject combined;
  QnContacts contacts = { 0 };
  QnResult result = { 0 };
  QnDiag diag = { 0 };
  double multiplier = -INFINITY;
  for (char **given = project->overrides; given != NULL && *given != NULL; given++)
    g_ptr_array_add (overrides, g_strdup (*given));
  qn_combination_add_overrides (combination, &project->model, overrides);
  g_ptr_array_add (overrides, NULL);
  if (!qn_project_parse (project->text, project->text_length, project->name,
                         (const char *const *) overrides->pdata, &combined, &error)) {
    *why = g_strdup (error->message);
    return multiplier;
  }
  QnModel *model = &combined.model;
  model->analysis.bound = QN_BOUND_NEVER;
  if (qn_contacts_detect (model, &contacts, &diag) != QN_OK
      || qn_contacts_require_sound (model, &contacts, &diag) != QN_OK
      || qn_analysis_run (model, &contacts, report->progress, report->progress_data,
                          &result, &diag)
           != QN_OK)
    *why = qn_explain_diag (model, &diag);
  else if (result.outcome == QN_OUTCOME_CANCELLED)
    multiplier = NAN;
  else if (result.has_collapse_multiplier)
    multiplier = result.collapse_multiplier;
  else if (result.outcome == QN_OUTCOME_TARGET_REACHED
           && model->analysis.max_multiplier == 0)
    multiplier = INFINITY;
  else
    *why = g_strdup (qn_explain_outcome_label (&result));
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_project_clear (&combined);
  return multiplier;
}

/* "en1990 6.10a and b" as "EN 1990 6.10a and b"; the caller frees it. */
static char *
dup_code_title (const char *code)
{
  const gsize letters = strcspn (code, "0123456789");
  g_autofree char *body = g_ascii_strup (code, (gssize) letters);
  return g_strdup_printf (code[letters] != '\0' ? "%s %s" : "%s%s", body, code + letters);
}

bool
qn_report_write_combinations (QnPages *pages, const QnReport *report, GError **error)
{
  enum { COLUMNS = 4 };
  const QnProject *project = report->project;
  g_autoptr (GError) wrong = NULL;
  if (*project->model.combinations.code == '\0')
    return true;
  g_autoptr (GPtrArray) list = qn_combinations_make (project, &wrong);
  qn_pages_heading (pages, _ ("Combinations"));
  if (list == NULL) {
    qn_report_say (pages, _ ("Not checked: %s."), wrong->message);
    return true;
  }
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  g_autofree double *multipliers = g_new (double, list->len);
  guint worst = 0;
  qn_report_row (cells, report->units, "wwww", _ ("No."), _ ("Combination"), _ ("λ"),
                 _ ("met"));
  for (guint i = 0; i < list->len; i++) {
    const QnCombination *combination = list->pdata[i];
    g_autofree char *why = NULL;
    const QnProgress begun = { .steps = 0 };
    bool goes_on =
      report->progress == NULL || report->progress (&begun, report->progress_data);
    multipliers[i] = goes_on ? solve (report, combination, &why) : NAN;
    if (isnan (multipliers[i])) {
      g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_CANCELLED, _ ("Cancelled"));
      return false;
    }
    worst = multipliers[i] < multipliers[worst] ? i : worst;
    qn_report_row (cells, report->units, "zwow", (gsize) i + 1, combination->label,
                   why != NULL                 ? g_steal_pointer (&why)
                   : isfinite (multipliers[i]) ? qn_label_number ("%.4g", multipliers[i])
                                               : g_strdup (_ ("stands")),
                   multipliers[i] >= 1 ? _ ("yes") : _ ("no"));
  }
  g_autofree char *least = isfinite (multipliers[worst])
                             ? qn_label_number ("%.4g", multipliers[worst])
                             : g_strdup ("–");
  g_autofree char *code = dup_code_title (project->model.combinations.code);
  qn_report_say (
    pages,
    _ ("%u combinations by %s. The multiplier is that of the live loads with "
       "their factors; a combination is met from 1 on. The worst: %s, λ = %s; all: "
       "figure\u00a0%d."),
    list->len, code, ((const QnCombination *) list->pdata[worst])->label, least,
    qn_pages_next_figure (pages));
  /* The multiplier over the number of the combination. */
  g_autoptr (QnPlot) plot = qn_plot_new (_ ("Combination"), _ ("Collapse multiplier λ"));
  double *x = qn_plot_keep (plot, g_new (double, 2 * list->len)), *y = x + list->len;
  gsize shown = 0;
  for (gsize i = 0; i < list->len; i++) {
    x[shown] = (double) i + 1;
    y[shown] = multipliers[i];
    shown += isfinite (multipliers[i]);
  }
  plot->title = _ ("Multipliers of the combinations");
  plot->y.from_zero = true;
  qn_plot_mark (plot, QN_MARKS_POINTS, NULL, 1, x, y, shown);
  if (shown > 0)
    qn_pages_plot (pages, plot, 0.25);
  qn_report_table (pages, cells, COLUMNS);
  return true;
}
