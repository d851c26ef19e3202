/* The cases of a plan: a value of every parameter for every case.
 *
 * Numbers come from GSL (Mersenne twister, Sobol sequence, inverse distributions) and are rounded
 * to 12 significant digits, so that the last digits of a machine's mathematical functions do not
 * show: the same study gives the same table everywhere.
 */
#pragma once

#include "study/plan/study.h"

typedef struct QnSample {
  gsize count, width; /* cases, parameters */
  double *values;     /* count x width, owned */
} QnSample;

/* Cases of a plan "sobol" come in blocks of width + 2: the point a, the point b, and for every
 * parameter the point a with this one coordinate of b. */
void qn_sample_init (QnSample *sample, const QnStudy *study);

void qn_sample_clear (QnSample *sample);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnSample, qn_sample_clear)

static inline const double *
qn_sample_case (const QnSample *sample, gsize index)
{
  return sample->values + index * sample->width;
}
