/* One case of a study: the project with the values of its parameters, analysed. */
#pragma once

#include "core/result/result.h"
#include "study/plan/study.h"

/* Result of a case. An analysis without equilibrium, or that did not converge, has not failed: see
 * its outcome. */
typedef struct QnCaseResult {
  gboolean failed;
  char *outcome; /* as result files spell it; NULL where there is none. Owned */
  char *reason;  /* of a failure, in one line. Owned */
  double seconds;
  double numbers[QN_STUDY_OUTPUT_COUNT]; /* NaN: the case has none */
  char *mechanism;                       /* kind of mechanism, nullable. Owned */
  char *shape;                           /* of the mechanism (shape.h), nullable. Owned */
} QnCaseResult;

/* A case in full, for pictures. */
typedef struct QnCaseModel {
  QnProject project;
  QnContacts contacts;
  QnResult result;
} QnCaseModel;

/* Analyses the project with these values (one per parameter) and fills *result, which is
 * overwritten without being cleared. Where `keep` is a path, the full result is written there.
 * `model` (nullable) receives the case itself, empty where it failed. */
void qn_case_solve (const QnStudy *study, const double *values, const char *keep,
                    QnCaseModel *model, QnCaseResult *result);

void qn_case_model_clear (QnCaseModel *model);

/* A row with the reason why there is no result; borrows its arguments. */
void qn_case_result_fail (QnCaseResult *result, const char *reason);

void qn_case_result_clear (QnCaseResult *result);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnCaseResult, qn_case_result_clear)
