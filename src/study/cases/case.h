/* One case of a study: the project with the values of its parameters, analysed. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "study/plan/study.h"

#include <glib.h>

/* Result of a case. An analysis without equilibrium, or that did not converge, has not failed: see
 * its outcome. */
typedef struct QnCaseResult {
  gboolean failed;
  char *outcome; /* as result files spell it; NULL where there is none. Owned */
  char *reason;  /* of a failure, in one line. Owned */
  double seconds;
  double numbers[QN_STUDY_OUTPUT_COUNT]; /* NaN: the case has none */
  char *mechanism;                       /* kind of mechanism, nullable. Owned */
  char *shape; /* of the mechanism, see below, nullable. Owned */
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

/* ---- shapes of mechanisms ----
 *
 * In a form that is comparable between cases with different blocks: the field of velocities is taken at the
 * points of a grid over the box around the structure, at each from the block that is nearest, and its components
 * are rounded to 63 levels of the largest speed. Two fields are alike as the cosine between them is close to 1.
 */

/* Points of the grid in each direction. */
#define QN_SHAPE_POINTS 12

/* Characters of a shape: two for every point. */
#define QN_SHAPE_LENGTH (2 * QN_SHAPE_POINTS * QN_SHAPE_POINTS)

/* Mechanisms whose shapes have this cosine with the first of their group or more fall into one
 * group: the angle of render/figure/compare-sheet.h. */
#define QN_SHAPE_ALIKE 0.95

/* The shape of a mechanism (velocities: block_count x 3): letters, digits, '-' and '_'. NULL where
 * nothing moves. Free with g_free(). */
char *qn_shape_dup (const QnModel *model, const double *velocities);

/* Cosine of two shapes, -1 to 1; 0 where one of them is no shape. */
double qn_shape_cosine (const char *a, const char *b);
