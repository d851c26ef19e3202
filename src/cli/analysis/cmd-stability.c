#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "core/path/stability.h"
#include "io/result/result-file.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>

typedef struct StabilityOptions {
  char *output;
  QnInputOptions input;
  gboolean quiet, no_timings;
} StabilityOptions;

static void
print_stability (const QnProject *project, const QnResult *result)
{
  const char *title = project->model.title != NULL ? project->model.title : project->name;
  if (result->outcome == QN_OUTCOME_SNAP) {
    qn_print (_ ("%s: stability is lost at load multiplier %.6g\n"), title,
              result->first_limit_multiplier);
    return;
  }
  g_autofree char *reason = qn_outcome_dup_reason (&project->model, result);
  if (result->outcome == QN_OUTCOME_TARGET_REACHED)
    qn_print (_ ("%s: stable along the whole path\n"), title);
  qn_print ("%s\n", reason);
}

static QnExit
exit_code (const QnProject *project, const QnResult *result)
{
  g_autofree char *reason = qn_outcome_dup_reason (&project->model, result);
  if (result->outcome == QN_OUTCOME_CANCELLED)
    return qn_cli_cancelled (project->name);
  if (result->outcome != QN_OUTCOME_DEAD_LOAD_UNSTABLE
      && result->outcome != QN_OUTCOME_NOT_CONVERGED)
    return QN_EXIT_DONE;
  qn_cli_error ("%s: %s", project->name, reason);
  return QN_EXIT_NO_ANSWER;
}

static QnExit
solve_stability (const StabilityOptions *options, const QnInput *input)
{
  QnTerminalProgress progress;
  QnResult result;
  QnDiag diag = { 0 };
  GError *error = NULL;

  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, options->quiet);
  QnStatus status =
    qn_stability_run (&input->project.model, &input->contacts,
                      qn_terminal_progress_update, &progress, &result, &diag);
  qn_terminal_progress_done (&progress);
  if (status != QN_OK)
    return qn_input_fail (input, QN_INPUT_PATH, &diag);
  if (options->no_timings)
    qn_statistics_clear_timings (&result.statistics);
  if (!options->quiet && g_strcmp0 (options->output, "-") != 0)
    print_stability (&input->project, &result);
  QnExit code = exit_code (&input->project, &result);
  if (options->output != NULL
      && !qn_result_file_write (options->output, &input->project, &input->contacts,
                                &result, &error))
    code = qn_cli_fail (error);
  qn_result_clear (&result);
  return code;
}

/* On the undeformed structure the tangent of elastic joints never changes: every answer would be
 * "stable". */
static QnExit
require_nonlinear (const QnInput *input)
{
  GError *error = NULL;
  if (input->project.model.analysis.geometry == QN_GEOMETRY_NONLINEAR)
    return QN_EXIT_DONE;
  qn_project_set_key_error (&input->project, "analysis.geometry",
                            _ ("linear geometry has no buckling: set it to nonlinear"),
                            &error);
  return qn_cli_fail (error);
}

static QnExit
run_stability (const QnSubcommand *self, int argc, char **argv)
{
  StabilityOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
      N_ ("Write a result here whose mechanism is the buckling mode"),
      N_ ("RESULT.json") },
    QN_INPUT_ENTRIES (options.input),
    QN_INPUT_TIMINGS_ENTRY (&options.no_timings),
    QN_INPUT_QUIET_ENTRY (&options.quiet),
    G_OPTION_ENTRY_NULL,
  };
  QnInput input = { 0 };
  QnExit code = QN_EXIT_USAGE;

  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = qn_input_load (&input, argv[1], &options.input);
  if (code == QN_EXIT_DONE)
    code = require_nonlinear (&input);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  if (code == QN_EXIT_DONE)
    code = solve_stability (&options, &input);
  qn_input_clear (&input);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_stability = {
  .name = "stability",
  .arguments = "MODEL",
  .summary = N_ ("Find the load under which a structure buckles"),
  .help = N_ (
    "Follows the live load to the multiplier at which the tangent stiffness becomes "
    "singular, which the path of a perfect structure does not show: the Euler load of "
    "a straight column. Set \"geometry\" to \"nonlinear\": without the effect of "
    "displacements on equilibrium nothing buckles."),
  .run = run_stability,
};
