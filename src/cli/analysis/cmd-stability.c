#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/path/stability.h"
#include "io/result/result-file.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>

static char *stability_output;

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

static const GOptionEntry stability_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &stability_output,
    N_ ("Write a result here whose mechanism is the buckling mode"), N_ ("RESULT.json") },
  QN_INPUT_ENTRIES,
  QN_TIMINGS_ENTRY,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

static void
run_stability (char **arguments)
{
  const QnInput *input = qn_input_load (arguments[0]);
  /* On the undeformed structure the tangent of elastic joints never changes: every answer would be
   * "stable". */
  if (input->project.model.analysis.geometry != QN_GEOMETRY_NONLINEAR) {
    qn_project_set_key_error (&input->project, "analysis.geometry",
                              _ ("linear geometry has no buckling: set it to nonlinear"),
                              QN_TROUBLE);
    qn_cli_must (FALSE);
  }
  qn_input_require_sound (input);
  QnResult result;
  QnDiag diag = { 0 };
  const QnProject *project = &input->project;

  qn_terminal_progress_begin ();
  QnStatus status = qn_stability_run (&project->model, &input->contacts,
                                      qn_terminal_progress_update, NULL, &result, &diag);
  qn_terminal_progress_done ();
  if (status != QN_OK)
    qn_input_fail (input, QN_INPUT_PATH, &diag);
  if (qn_no_timings)
    qn_statistics_clear_timings (&result.statistics);
  if (qn_subcommand_prints ())
    print_stability (project, &result);
  qn_cli_must (stability_output == NULL
               || qn_result_file_write (stability_output, project, &input->contacts,
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

const QnSubcommand qn_cmd_stability = {
  .name = "stability",
  .arguments = "MODEL",
  .summary = N_ ("Find the load under which a structure buckles"),
  .help = N_ (
    "Follows the live load to the multiplier at which the tangent stiffness becomes "
    "singular, which the path of a perfect structure does not show: the Euler load of "
    "a straight column. Set \"geometry\" to \"nonlinear\": without the effect of "
    "displacements on equilibrium nothing buckles."),
  .options = stability_entries,
  .run = run_stability,
};
