#include "cli/analysis/sensitivity.h"
#include "cli/base/shown-text.h"

#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/shown-text.h"
#include "core/limit/limit-sensitivity.h"

#include <glib/gi18n.h>

QnExit
qn_sensitivity_print (const QnProject *project, const QnContacts *contacts,
                      const QnResult *result)
{
  QnLimitSensitivity sensitivity;
  QnDiag diag = { 0 };
  if (result->limit.flow != QN_FLOW_ASSOCIATIVE)
    return qn_cli_usage_error ("limit",
                               _ ("--sensitivity is that of associative flow alone"));
  if (result->outcome != QN_OUTCOME_COLLAPSE)
    return QN_EXIT_DONE;
  if (qn_limit_sensitivity (&project->model, contacts, result, &sensitivity, &diag)
      != QN_OK)
    return qn_input_refuse (project, &diag);
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
  return QN_EXIT_DONE;
}
