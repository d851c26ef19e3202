/* Points of the unit cube whose coordinates are correlated by rank.
 *
 * Correlations are Spearman's, of ranks. Both functions use a normal variable for each coordinate;
 * two of them with correlation r have the rank correlation 6/pi asin (r/2).
 */
#pragma once

#include <glib.h>
#include <gsl/gsl_rng.h>

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
