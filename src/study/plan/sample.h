/* The cases of a plan: a value of every parameter for every case.
 *
 * Numbers come from GSL (Mersenne twister, Sobol sequence, inverse distributions) and are rounded
 * to 12 significant digits, so that the last digits of a machine's mathematical functions do not
 * show: the same study gives the same table everywhere.
 */
#pragma once

#include "study/plan/study.h"

/* A row of values for every case (qn_study_case_count()), one for each parameter. Cases of a plan "sobol" come in
 * blocks of as many as parameters and two: the point a, the point b, and for every parameter the point a with
 * this one coordinate of b. Free with g_free(). */
double *qn_sample_dup (const QnStudy *study);
