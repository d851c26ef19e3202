#include "core/path/analysis.h"

#include "core/base/clock.h"
#include "core/limit/limit.h"
#include "core/path/path.h"

QnStatus
qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                 QnProgressFunc progress, void *user_data, QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds ();
  QnPath path;
  bool stands;

  *result = (QnResult){ 0 };
  if (model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_limit_run (model, contacts, progress, user_data, result, diag);

  QnStatus status =
    qn_path_setup (&path, model, contacts, progress, user_data, result, diag);
  if (status == QN_OK)
    status = qn_path_run (&path, &stands, diag);
  return qn_path_finish (&path, status, start);
}
