/* Derivatives of the associative multiplier by the input, without solving again.
 *
 * At the optimum of the linear program of limit.h the mechanism v and the plastic rates of the
 * pairs are the dual solution. With v scaled so that the live load does unit power, the
 * derivative of the multiplier by any number p is that of the Lagrangian (envelope theorem):
 *
 *     d lambda / dp = sum over pairs of (rate x change of strength)
 *                     - v . (d dead / dp + lambda d live / dp)
 *
 * A pair that slides at the rate g under the normal force n contributes -n |g| to the derivative
 * by friction, |g| to that by cohesion (times the pair's area where the law is per area), and its
 * opening beyond the dilation of this sliding to that by tensile strength.
 *
 * Where several mechanisms share the optimum, the multiplier has a kink there: the numbers hold
 * for the mechanism that was found. A cohesion or tension of 0 can only grow.
 */
#pragma once

#include "core/base/memory.h"
#include "core/result/result.h"

/* Derivatives by the numbers of one law, and by factors 1 on weight and thickness of the blocks
 * that have it (that of the contacts where a block names none). */
typedef struct QnLawSensitivity {
  double friction; /* per 1 */
  double cohesion; /* per N or Pa, in the law's basis */
  double tension;  /* per N or Pa */
  double weight;   /* per factor: of 1 % more weight, a hundredth of it */
  double
    thickness; /* per factor: weight, and areas of joints between two such blocks; NAN with
                       vehicles and soil that resists, whose share of a block depends on it */
} QnLawSensitivity;

typedef struct QnLimitSensitivity {
  QnPool pool;            /* of the arrays */
  double multiplier;      /* the associative multiplier */
  QnLawSensitivity *laws; /* law_count */
  double *dead_loads;     /* dead_load_count: by a factor 1 on each */
  double *live_loads;     /* live_load_count; of other sets than the live loads 0 */
} QnLimitSensitivity;

/* From the result of an associative limit analysis of this model that found collapse. `out` is
 * overwritten without being cleared. */
QnStatus qn_limit_sensitivity (const QnModel *model, const QnContacts *contacts,
                               const QnResult *result, QnLimitSensitivity *out,
                               QnDiag *diag);

void qn_limit_sensitivity_clear (QnLimitSensitivity *sensitivity);
