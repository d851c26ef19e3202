#include "core/analysis.h"

#include "core/clock.h"
#include "core/limit.h"
#include "core/path.h"

static QnStatus
follow_path (QnPath *path, QnDiag *diag)
{
  bool stands = false;
  QnStatus status = qn_path_apply_dead_load (path, &stands, diag);

  if (status != QN_OK || !stands)
    return status;
  if (path->settings->procedure == QN_PROCEDURE_LOAD)
    return qn_path_load_control (path, diag);
  return qn_path_motion_control (path, diag);
}

QnStatus
qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                 QnProgressFunc progress, void *user_data, QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds ();
  QnPath path;

  *result = (QnResult){ 0 };
  if (model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_limit_run (model, contacts, progress, user_data, result, diag);

  QnStatus status =
    qn_path_setup (&path, model, contacts, progress, user_data, result, diag);
  if (status == QN_OK)
    status = follow_path (&path, diag);
  if (status == QN_OK) {
    qn_assembly_pair_results (&path.equilibrium.assembly, path.equilibrium.u,
                              result->pairs);
    result->statistics = path.equilibrium.statistics;
    result->statistics.seconds = qn_clock_seconds () - start;
  } else {
    qn_result_clear (result);
  }
  qn_path_clear (&path);
  return status;
}
