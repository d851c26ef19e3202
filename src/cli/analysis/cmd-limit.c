#include "cli/analysis/cmd-solve.h"
#include "cli/base/shown-text.h"

#include <glib/gi18n.h>

void
qn_cmd_limit_print (const char *title, const QnResult *result)
{
  const QnLimitFigures *figures = &result->limit;
  if (figures->flow == QN_FLOW_ASSOCIATIVE)
    qn_print (_ ("%s: limit multiplier between %.8f (forces) and %.8f (mechanism)\n"),
              title, figures->lower_bound, figures->upper_bound);
  else
    qn_print (_ ("%s: non-associative fixed points between %.5f and %.5f (%d found)\n"),
              title, figures->lower_bound, figures->upper_bound, result->solution_count);
}

static QnExit
run_limit (const QnSubcommand *self, int argc, char **argv)
{
  return qn_cmd_solve_run (self, "analysis.procedure=\"limit\"", argc, argv);
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
