#include "study/plan/sample.h"

#include "study/plan/correlation.h"

#include <gsl/gsl_qrng.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

static double
round_digits (double value)
{
  char text[G_ASCII_DTOSTR_BUF_SIZE];
  return g_ascii_strtod (g_ascii_formatd (text, sizeof text, "%.11e", value), NULL);
}

static double
final_value (const QnParameter *parameter, double value)
{
  return parameter->whole ? rint (value) : round_digits (value);
}

/* The last parameter changes first. */
static void
fill_grid (double *values, gsize count, const QnStudy *study)
{
  const gsize width = study->parameters->len;
  for (gsize i = 0; i < count; i++) {
    gsize rest = i;
    for (gsize j = width; j-- > 0;) {
      const QnParameter *parameter = qn_study_parameter (study, j);
      gsize levels = qn_parameter_level_count (parameter);
      values[i * width + j] =
        final_value (parameter, qn_parameter_level (parameter, rest % levels));
      rest /= levels;
    }
  }
}

static void
fill_one_at_a_time (double *values, gsize count, const QnStudy *study)
{
  const gsize width = study->parameters->len;
  for (gsize i = 0; i < count * width; i++)
    values[i] = qn_study_parameter (study, i % width)->base;
  gsize row = 1;
  for (gsize j = 0; j < width; j++) {
    const QnParameter *parameter = qn_study_parameter (study, j);
    for (gsize k = 0; k < qn_parameter_level_count (parameter); k++)
      values[row++ * width + j] =
        final_value (parameter, qn_parameter_level (parameter, k));
  }
}

static void
draw_points (double *points, gsize count, gsize width, gsl_rng *random)
{
  for (gsize i = 0; i < count * width; i++)
    points[i] = gsl_rng_uniform_pos (random);
}

/* One point in each of `count` layers, at random within it. */
static void
draw_layers (double *points, gsize count, gsize width, gsl_rng *random)
{
  g_autofree gsize *layer = g_new (gsize, count);
  for (gsize j = 0; j < width; j++) {
    for (gsize i = 0; i < count; i++)
      layer[i] = i;
    gsl_ran_shuffle (random, layer, count, sizeof *layer);
    for (gsize i = 0; i < count; i++)
      points[i * width + j] =
        ((double) layer[i] + gsl_rng_uniform_pos (random)) / (double) count;
  }
}

/* Saltelli et al., Computer Physics Communications 181 (2010) 259-270, on the Sobol sequence in
 * twice as many dimensions, shifted by a random vector modulo 1 (Cranley and Patterson 1976). */
static void
draw_sobol (double *points, gsize count, gsize width, gsl_rng *random)
{
  gsize rows = width + 2, dimensions = 2 * width;
  g_autofree double *shift = g_new (double, dimensions);
  g_autofree double *q = g_new (double, dimensions);
  gsl_qrng *sequence = gsl_qrng_alloc (gsl_qrng_sobol, (guint) dimensions);
  draw_points (shift, 1, dimensions, random);
  for (gsize i = 0; i < count; i++) {
    double *block = points + i * rows * width;
    gsl_qrng_get (sequence, q);
    for (gsize j = 0; j < dimensions; j++) {
      q[j] = fmod (q[j] + shift[j], 1);
      q[j] = fmax (q[j], 1e-12);
    }
    memcpy (block, q, dimensions * sizeof *q);
    for (gsize k = 0; k < width; k++) {
      double *mixed = block + (k + 2) * width;
      memcpy (mixed, q, width * sizeof *q);
      mixed[k] = q[width + k];
    }
  }
  gsl_qrng_free (sequence);
}

static void
fill_random (double *points, gsize count, const QnStudy *study)
{
  const gsize width = study->parameters->len;
  gsl_rng *random = gsl_rng_alloc (gsl_rng_mt19937);
  gsl_rng_set (random, study->seed);
  if (study->plan == QN_PLAN_SOBOL)
    draw_sobol (points, study->count, width, random);
  else if (study->plan == QN_PLAN_LATIN_HYPERCUBE)
    draw_layers (points, count, width, random);
  else
    draw_points (points, count, width, random);
  if (study->correlation != NULL && study->plan == QN_PLAN_LATIN_HYPERCUBE)
    qn_correlation_reorder (study->correlation, width, points, count, random);
  else if (study->correlation != NULL)
    qn_correlation_copula (study->correlation, width, points, count);
  gsl_rng_free (random);

  for (gsize i = 0; i < count * width; i++) {
    const QnParameter *parameter = qn_study_parameter (study, i % width);
    points[i] = final_value (
      parameter, qn_distribution_quantile (&parameter->distribution, points[i]));
  }
}

double *
qn_sample_dup (const QnStudy *study)
{
  const gsize count = qn_study_case_count (study);
  double *values = g_new (double, count * study->parameters->len);
  if (study->plan == QN_PLAN_ONE_AT_A_TIME)
    fill_one_at_a_time (values, count, study);
  else
    (qn_plan_is_by_levels (study->plan) ? fill_grid : fill_random) (values, count, study);
  return values;
}
