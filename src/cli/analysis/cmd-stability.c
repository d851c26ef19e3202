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

static void
solve_stability (const StabilityOptions *options, const QnInput *input)
{
  QnTerminalProgress progress;
  QnResult result;
  QnDiag diag = { 0 };
  const QnProject *project = &input->project;

  qn_terminal_progress_begin (&progress, options->quiet);
  QnStatus status =
    qn_stability_run (&project->model, &input->contacts, qn_terminal_progress_update,
                      &progress, &result, &diag);
  qn_terminal_progress_done (&progress);
  if (status != QN_OK)
    qn_input_fail (input, QN_INPUT_PATH, &diag);
  if (options->no_timings)
    qn_statistics_clear_timings (&result.statistics);
  if (!options->quiet && g_strcmp0 (options->output, "-") != 0)
    print_stability (project, &result);
  qn_cli_must (options->output == NULL
               || qn_result_file_write (options->output, project, &input->contacts,
                                        &result, QN_DETAIL_FORCES, QN_TROUBLE));
  if (result.outcome == QN_OUTCOME_CANCELLED)
    qn_cli_cancelled (project->name);
  if (result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE
      || result.outcome == QN_OUTCOME_NOT_CONVERGED) {
    g_autofree char *reason = qn_outcome_dup_reason (&project->model, &result);
    qn_cli_fail (QN_EXIT_NO_ANSWER, "%s: %s", project->name, reason);
  }
  qn_result_clear (&result);
}

static void
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
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  const QnInput *input = qn_input_load (argv[1], &options.input);
  /* On the undeformed structure the tangent of elastic joints never changes: every answer would be
   * "stable". */
  if (input->project.model.analysis.geometry != QN_GEOMETRY_NONLINEAR) {
    qn_project_set_key_error (&input->project, "analysis.geometry",
                              _ ("linear geometry has no buckling: set it to nonlinear"),
                              QN_TROUBLE);
    qn_cli_must (FALSE);
  }
  qn_input_require_sound (input);
  solve_stability (&options, input);
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
