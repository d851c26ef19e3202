#include "cli/analysis/cmd-solve.h"
#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/shown-text.h"
#include "core/limit/limit-sensitivity.h"

#include <glib/gi18n.h>

void
qn_cmd_limit_print (const char *title, const QnResult *result)
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

void
qn_cmd_limit_print_sensitivity (const QnProject *project, const QnContacts *contacts,
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
run_limit (const QnSubcommand *self, int argc, char **argv)
{
  qn_cmd_solve_run (self, "analysis.procedure=\"limit\"", argc, argv);
}

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
  .run = run_limit,
};
