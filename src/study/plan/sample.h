/* The cases of a plan: a value of every parameter for every case.
 *
 * Numbers come from GSL (Mersenne twister, Sobol sequence, inverse distributions) and are rounded
 * to 12 significant digits, so that the last digits of a machine's mathematical functions do not
 * show: the same study gives the same table everywhere.
 */
#pragma once

#include "study/plan/study.h"

#include <glib.h>
#include <gsl/gsl_rng.h>

/* A row of values for every case (qn_study_case_count()), one for each parameter. Cases of a plan "sobol" come in
 * blocks of as many as parameters and two: the point a, the point b, and for every parameter the point a with
 * this one coordinate of b. Free with g_free(). */
double *qn_sample_dup (const QnStudy *study);

/* ---- points of the unit cube whose coordinates are correlated by rank ----
 *
 * Correlations are Spearman's, of ranks. Both functions use a normal variable for each coordinate;
 * two of them with correlation r have the rank correlation 6/pi asin (r/2). */

/* Whether any variables have these rank correlations (width x width, diagonal 1). */
gboolean qn_correlation_is_possible (const double *correlation, gsize width);

/* Independent points (count x width, in and out) moved so that each two coordinates follow the
 * normal copula: every point by itself. */
void qn_correlation_copula (const double *correlation, gsize width, double *points,
                            gsize count);

/* Exchanges values within each coordinate only, so that layers stay occupied. Iman and Conover,
 * Communications in Statistics B11 (1982) 311-334. `count` must be larger than 2 x width. */
void qn_correlation_reorder (const double *correlation, gsize width, double *points,
                             gsize count, gsl_rng *random);
