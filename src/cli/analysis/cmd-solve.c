#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "core/limit/limit-sensitivity.h"
#include "core/path/analysis.h"
#include "io/exchange/table-csv.h"
#include "io/text/file-writer.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>
#include <string.h>

/* Part of its length that a joint may slide by without a word. */
#define FAR_SLIP 0.1

static char *solve_output, *solve_csv, *solve_detail;
static QnResultDetail solve_level; /* of `detail` */
static gboolean solve_sensitivity;

static const GOptionEntry solve_entries[] = {
  /* Of limit analysis alone. */
  { "sensitivity", 0, 0, G_OPTION_ARG_NONE, &solve_sensitivity,
    N_ ("Print how the associative multiplier changes with laws, weights and loads"),
    NULL },
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &solve_output,
    N_ ("Write the result file here; - is standard output"), N_ ("RESULT.json") },
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &solve_csv,
    N_ ("Write the load–displacement curve here"), N_ ("CURVE.csv") },
  { "detail", 0, 0, G_OPTION_ARG_STRING, &solve_detail,
    N_ ("What the result contains of contact pairs: forces (default), pairs: their "
        "hinges "
        "and springs too, or steps: forces of all steps, however many"),
    N_ ("forces|pairs|steps") },
  QN_INPUT_ENTRIES,
  QN_TIMINGS_ENTRY,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

/* Names the blocks that the dead load moves, the first few of them. */
static void
tell_unstable (const QnInput *input, const QnResult *result)
{
  enum { SHOWN = 5 };
  const QnModel *model = &input->project.model;
  g_autoptr (GString) names = g_string_new (NULL);
  for (size_t i = 0; i < result->unstable_count && i < SHOWN; i++)
    g_string_append_printf (names, "%s%s", i > 0 ? ", " : "",
                            model->blocks[result->unstable_blocks[i]].name);
  if (result->unstable_count > SHOWN)
    g_string_append_printf (names, _ (" and %zu more"), result->unstable_count - SHOWN);
  qn_cli_fail (QN_EXIT_NO_ANSWER, _ ("%s: no stable equilibrium under the dead load: %s"),
               input->project.name, names->str);
}

/* How far an analysis in time went, and what its numbers are worth. */
static void
print_history (const char *title, const QnProject *project, const QnResult *result)
{
  const QnHistory *history = &result->history;
  qn_print (_ ("%s: followed to %.4g s, largest displacement %.4g m at %.4g s\n"), title,
            history->end, qn_result_peak (result, NULL), history->peak_time);
  qn_print (
    _ ("%d time steps, %d more given up for shorter ones; error of the energy balance "
       "%.1e of the input\n"),
    history->steps, history->rejected, history->energy_error);
  if (history->largest_slip > FAR_SLIP && !project->model.analysis.follow)
    qn_print (
      _ ("a joint has slid by %.0f %% of its length: contacts stay where they were on "
         "their blocks, so that forces are less certain from then on\n"),
      100 * history->largest_slip);
}

static void
print_limit (const char *title, const QnResult *result)
{
  const QnLimitFigures *figures = &result->limit;
  if (figures->flow == QN_FLOW_ASSOCIATIVE)
    qn_print (_ ("%s: limit multiplier between %.8f (forces) and %.8f (mechanism)\n"),
              title, figures->lower_bound, figures->upper_bound);
  else
    qn_print (_ ("%s: non-associative fixed points between %.5f and %.5f (%d found), the "
                 "least known to %.1g\n"),
              title, figures->lower_bound, figures->upper_bound, result->solution_count,
              figures->uncertainty);
}

/* The derivatives of the associative multiplier as a table. Where it has none: with non-associative flow that
 * ends the program, without collapse nothing is said. */
static void
print_sensitivity (const QnProject *project, const QnContacts *contacts,
                   const QnResult *result)
{
  QnLimitSensitivity sensitivity;
  QnDiag diag = { 0 };
  if (result->limit.flow != QN_FLOW_ASSOCIATIVE)
    qn_cli_usage_error (_ ("--sensitivity is that of associative flow alone"));
  if (result->outcome != QN_OUTCOME_COLLAPSE)
    return;
  if (qn_limit_sensitivity (&project->model, contacts, result, &sensitivity, &diag)
      != QN_OK)
    qn_input_refuse (project, &diag);
  qn_print (_ ("Change of the associative multiplier %.6f, of this mechanism:\n"),
            sensitivity.multiplier);
  qn_print ("%-24s %12s %12s %12s %12s %12s\n", _ ("law"), _ ("friction"), _ ("cohesion"),
            _ ("tension"), _ ("weight"), _ ("thickness"));
  for (size_t i = 0; i < project->model.law_count; i++)
    qn_print ("%-24s %12.6g %12.6g %12.6g %12.6g %12.6g\n", project->model.laws[i].name,
              sensitivity.laws[i].friction, sensitivity.laws[i].cohesion,
              sensitivity.laws[i].tension, sensitivity.laws[i].weight,
              sensitivity.laws[i].thickness);
  for (size_t i = 0; i < project->model.dead_load_count; i++)
    qn_print (_ ("dead load %zu: %.6g\n"), i + 1, sensitivity.dead_loads[i]);
  for (size_t i = 0; i < project->model.live_load_count; i++)
    if (project->model.live_loads[i].set == 0)
      qn_print (_ ("live load %zu: %.6g\n"), i + 1, sensitivity.live_loads[i]);
  qn_print (_ (
    "Change of the multiplier per unit of friction, per N or Pa of cohesion and tension "
    "(as the law has them), and per relative change of weight, thickness and loads.\n"));
  qn_limit_sensitivity_clear (&sensitivity);
}

static void
print_summary (const QnProject *project, const QnResult *result)
{
  const QnStatistics *spent = &result->statistics;
  const char *title = project->model.title != NULL ? project->model.title : project->name;
  const QnPathEvent *buckled = qn_result_find_buckling (result);

  if (result->history.width > 0)
    print_history (title, project, result);
  else if (result->outcome == QN_OUTCOME_UNBOUNDED)
    qn_print (_ ("%s: no collapse found\n"), title);
  else if (result->limit.given)
    print_limit (title, result);
  else if (result->outcome == QN_OUTCOME_COLLAPSE)
    qn_print (_ ("%s: collapse at load multiplier %.5f\n"), title,
              result->collapse_multiplier);
  else if (result->outcome == QN_OUTCOME_SNAP)
    qn_print (_ ("%s: stopped at the first limit point, load multiplier %.5f\n"), title,
              result->first_limit_multiplier);
  else if (buckled != NULL)
    qn_print (_ ("%s: stability is lost at load multiplier %.6g\n"), title,
              buckled->multiplier);
  else if (result->has_collapse_multiplier && result->stage == 0)
    qn_print (_ ("%s: collapse at load multiplier %.5f, last equilibrium at %.5f\n"),
              title, result->collapse_multiplier,
              result->steps[result->step_count - 1].multiplier);
  else if (result->step_count > 0)
    qn_print (_ ("%s: last equilibrium at load multiplier %.5f\n"), title,
              result->steps[result->step_count - 1].multiplier);
  if (result->outcome == QN_OUTCOME_COLLAPSE && qn_result_has_felt_limit (result)
      && result->first_limit_multiplier < result->collapse_multiplier)
    qn_print (_ ("first limit point at %.5f: the path jumps to another equilibrium\n"),
              result->first_limit_multiplier);
  g_autofree char *stages = qn_outcome_dup_stages (&project->model, result);
  g_auto (GStrv) lines = g_strsplit (stages != NULL ? stages : "", "\n", -1);
  for (char **line = lines; *line != NULL; line++)
    qn_print ("%s\n", *line);
  g_autofree char *interval = qn_outcome_dup_interval (&project->model, result);
  if (interval != NULL)
    qn_print ("%s\n", interval);
  g_autofree char *cause = qn_outcome_dup_cause (&project->model, result);
  qn_print ("%s\n", cause);
  g_autofree char *ties = qn_ties_dup_text (&project->model, result);
  if (ties != NULL)
    qn_print ("%s\n", ties);
  qn_print (
    _ ("%zu steps, %d iterations, %d factorisations, %.3f s (factorising %.0f %%, "
       "assembly %.0f %%, laws %.0f %%)\n"),
    result->step_count, spent->iterations, spent->factorizations, spent->seconds,
    100 * spent->factor_seconds / MAX (spent->seconds, 1e-9),
    100 * spent->assembly_seconds / MAX (spent->seconds, 1e-9),
    100 * spent->law_seconds / MAX (spent->seconds, 1e-9));
}

/* Finds out before a long analysis whether a file can be written where it shall be. Devices
 * and pipes are not touched. */
static void
probe_output (const char *path)
{
  if (path == NULL || strcmp (path, "-") == 0
      || (g_file_test (path, G_FILE_TEST_EXISTS)
          && !g_file_test (path, G_FILE_TEST_IS_REGULAR | G_FILE_TEST_IS_DIR)))
    return;
  qn_cli_must (qn_file_can_be_written (path, QN_TROUBLE));
}

static void
report (const QnInput *input, const QnResult *result)
{
  const QnProject *project = &input->project;
  qn_cli_must (solve_output == NULL
               || qn_result_file_write (solve_output, project, &input->contacts, result,
                                        solve_level, QN_TROUBLE));
  qn_cli_must (solve_csv == NULL
               || qn_result_table_write (solve_csv, QN_TABLE_CURVE, project,
                                         &input->contacts, result, QN_TROUBLE));
  if (qn_subcommand_prints ()) {
    print_summary (project, result);
    g_autofree char *text =
      qn_collapse_dup_text (&project->model, &input->contacts, result);
    if (text != NULL)
      qn_print ("%s\n", text);
  }
  if (solve_sensitivity)
    print_sensitivity (project, &input->contacts, result);
  /* An end that is no success. */
  if (result->outcome == QN_OUTCOME_CANCELLED)
    qn_cli_cancelled (project->name);
  if (result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    tell_unstable (input, result);
  if (result->outcome == QN_OUTCOME_NOT_CONVERGED) {
    g_autofree char *reason = qn_outcome_dup_reason (&project->model, result);
    qn_cli_fail (QN_EXIT_NO_ANSWER, _ ("%s: the analysis did not converge: %s"),
                 project->name, reason);
  }
}

/* A limit multiplier is about a structure that stands. By the associative theorem friction may wedge
 * blocks between others, without a reason to be pressed together: whether the dead load stands is asked
 * of a path. */
static void
require_dead_load (const QnInput *input)
{
  QnModel model = input->project.model; /* shares all arrays */
  QnResult result = { 0 };
  model.analysis.procedure = QN_PROCEDURE_LOAD;
  model.analysis.geometry = QN_GEOMETRY_LINEAR;
  model.analysis.max_multiplier = 0;
  if (qn_analysis_run (&model, &input->contacts, NULL, NULL, &result, NULL) == QN_OK
      && result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    tell_unstable (input, &result);
  qn_result_clear (&result);
}

static void
solve_project (QnInput *input)
{
  QnDiag diag = { 0 };
  QnResult result = { 0 };

  input->project.model.analysis.all_forces = solve_level == QN_DETAIL_STEPS;
  qn_terminal_progress_begin ();
  QnStatus status = qn_analysis_run (&input->project.model, &input->contacts,
                                     qn_terminal_progress_update, NULL, &result, &diag);
  gsize memory = qn_terminal_progress_done ();
  if (status == QN_ERROR_CANCELLED)
    qn_cli_cancelled (input->project.name);
  if (status != QN_OK)
    qn_input_refuse (&input->project, &diag);
  result.statistics.peak_memory_bytes = (int64_t) memory;
  if (qn_no_timings)
    qn_statistics_clear_timings (&result.statistics);
  report (input, &result);
  if (input->project.model.analysis.procedure == QN_PROCEDURE_LIMIT)
    require_dead_load (input);
  qn_result_clear (&result);
}

static void
run_solve (char **arguments)
{
  static const char *const details[QN_DETAIL_COUNT] = { "forces", "pairs", "steps" };
  if (solve_detail != NULL
      && !qn_find_word (solve_detail, details, QN_DETAIL_COUNT, &solve_level))
    qn_cli_usage_error (_ ("--detail is forces, pairs or steps"));
  QnInput *input = qn_input_load (arguments[0]);
  qn_input_prepare (input);
  probe_output (solve_output);
  probe_output (solve_csv);
  solve_project (input);
}

static void
run_limit (char **arguments)
{
  const char *procedure = "analysis.procedure=\"limit\"";
  qn_input_override (procedure, TRUE);
  qn_cli_set_own_override (procedure);
  run_solve (arguments);
}

const QnSubcommand qn_cmd_solve = {
  .name = "solve",
  .arguments = "MODEL",
  .summary = N_ ("Follow the load path of a project until it collapses"),
  .help =
    N_ ("The dead load is applied first; the multiplier of the live load then grows "
        "until no equilibrium is left, or as the project's \"analysis\" says. Ctrl+C "
        "ends the analysis and keeps what has converged."),
  .options = solve_entries + 1,
  .run = run_solve,
};

const QnSubcommand qn_cmd_limit = {
  .name = "limit",
  .arguments = "MODEL",
  .summary = N_ ("Find the limit multiplier of rigid blocks directly"),
  .help = N_ (
    "With associative flow (dilatancy = friction) the multiplier is exact for rigid "
    "blocks: "
    "equilibrium exists up to the lower bound and none above the upper one. With --set "
    "analysis.flow=non-associative the joints dilate as their laws say; several "
    "multipliers "
    "can then have a mechanism, and the interval of those found is given. The interval "
    "is "
    "no bound; the associative value bounds every other from above. Where the dead load "
    "alone does not stand on its path, that is told, with exit code 4."),
  .options = solve_entries,
  .run = run_limit,
};
