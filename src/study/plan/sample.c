#include "study/plan/sample.h"

#include <float.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <string.h>

/* ---- correlated points ---- */

/* Lower Cholesky factor of the correlation of the normal variables; NULL where there is none. */
static gsl_matrix *
factor_of (const double *correlation, gsize width)
{
  gsl_matrix *factor = gsl_matrix_alloc (width, width);
  for (gsize i = 0; i < width; i++)
    for (gsize j = 0; j < width; j++)
      gsl_matrix_set (factor, i, j,
                      i == j ? 1 : 2 * sin (G_PI / 6 * correlation[i * width + j]));
  if (gsl_linalg_cholesky_decomp1 (factor) != GSL_SUCCESS)
    g_clear_pointer (&factor, gsl_matrix_free);
  return factor;
}

gboolean
qn_correlation_is_possible (const double *correlation, gsize width)
{
  gsl_matrix *factor = factor_of (correlation, width);
  if (factor == NULL)
    return FALSE;
  gsl_matrix_free (factor);
  return TRUE;
}

void
qn_correlation_copula (const double *correlation, gsize width, double *points,
                       gsize count)
{
  gsl_matrix *factor = factor_of (correlation, width);
  gsl_vector *z = gsl_vector_alloc (width);
  for (gsize i = 0; i < count; i++) {
    double *point = points + i * width;
    for (gsize j = 0; j < width; j++)
      gsl_vector_set (z, j, gsl_cdf_ugaussian_Pinv (point[j]));
    gsl_blas_dtrmv (CblasLower, CblasNoTrans, CblasNonUnit, factor, z); /* z = L z */
    for (gsize j = 0; j < width; j++)
      point[j] =
        CLAMP (gsl_cdf_ugaussian_P (gsl_vector_get (z, j)), DBL_EPSILON, 1 - DBL_EPSILON);
  }
  gsl_vector_free (z);
  gsl_matrix_free (factor);
}

/* Puts the values of a column into the order of another. */
static void
order_like (double *values, gsize stride, const double *model, gsize model_stride,
            gsize count)
{
  g_autofree gsize *rank = g_new (gsize, count);
  g_autofree double *sorted = g_new (double, count);
  for (gsize i = 0; i < count; i++)
    sorted[i] = values[i * stride];
  gsl_sort (sorted, 1, count);
  gsl_sort_index (rank, model, model_stride, count);
  for (gsize i = 0; i < count; i++)
    values[rank[i] * stride] = sorted[i];
}

void
qn_correlation_reorder (const double *correlation, gsize width, double *points,
                        gsize count, gsl_rng *random)
{
  gsl_matrix *wanted = factor_of (correlation, width);
  /* Normal scores in random order, and the correlation that they have by chance. */
  gsl_matrix *scores = gsl_matrix_alloc (count, width);
  g_autofree double *column = g_new (double, count);
  for (gsize j = 0; j < width; j++) {
    for (gsize i = 0; i < count; i++)
      column[i] = gsl_cdf_ugaussian_Pinv ((double) (i + 1) / (double) (count + 1));
    gsl_ran_shuffle (random, column, count, sizeof *column);
    for (gsize i = 0; i < count; i++)
      gsl_matrix_set (scores, i, j, column[i]);
  }
  gsl_matrix *chance = gsl_matrix_alloc (width, width);
  for (gsize i = 0; i < width; i++)
    for (gsize j = 0; j < width; j++)
      gsl_matrix_set (chance, i, j,
                      gsl_stats_correlation (scores->data + i, scores->tda,
                                             scores->data + j, scores->tda,
                                             scores->size1));
  gsl_linalg_cholesky_decomp1 (chance);
  /* Scores R with R'R = QQ' become R Q'^-1 P' with the correlation PP'. */
  gsl_blas_dtrsm (CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, chance, scores);
  gsl_blas_dtrmm (CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, wanted, scores);
  for (gsize j = 0; j < width; j++)
    order_like (points + j, width, scores->data + j, scores->tda, count);
  gsl_matrix_free (wanted);
  gsl_matrix_free (scores);
  gsl_matrix_free (chance);
}

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
