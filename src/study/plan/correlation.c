#include "study/plan/correlation.h"

#include <float.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>

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

/* Normal scores in random order, one permutation per coordinate. */
static gsl_matrix *
create_scores (gsize count, gsize width, gsl_rng *random)
{
  gsl_matrix *scores = gsl_matrix_alloc (count, width);
  g_autofree double *column = g_new (double, count);
  for (gsize j = 0; j < width; j++) {
    for (gsize i = 0; i < count; i++)
      column[i] = gsl_cdf_ugaussian_Pinv ((double) (i + 1) / (double) (count + 1));
    gsl_ran_shuffle (random, column, count, sizeof *column);
    for (gsize i = 0; i < count; i++)
      gsl_matrix_set (scores, i, j, column[i]);
  }
  return scores;
}

/* The correlation that the shuffled scores have by chance, as its Cholesky factor. */
static gsl_matrix *
chance_factor (const gsl_matrix *scores)
{
  gsize width = scores->size2;
  gsl_matrix *factor = gsl_matrix_alloc (width, width);
  for (gsize i = 0; i < width; i++)
    for (gsize j = 0; j < width; j++)
      gsl_matrix_set (factor, i, j,
                      gsl_stats_correlation (scores->data + i, scores->tda,
                                             scores->data + j, scores->tda,
                                             scores->size1));
  gsl_linalg_cholesky_decomp1 (factor);
  return factor;
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
  gsl_matrix *scores = create_scores (count, width, random);
  gsl_matrix *chance = chance_factor (scores);
  /* Scores R with R'R = QQ' become R Q'^-1 P' with the correlation PP'. */
  gsl_blas_dtrsm (CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, chance, scores);
  gsl_blas_dtrmm (CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, wanted, scores);
  for (gsize j = 0; j < width; j++)
    order_like (points + j, width, scores->data + j, scores->tda, count);
  gsl_matrix_free (wanted);
  gsl_matrix_free (scores);
  gsl_matrix_free (chance);
}
