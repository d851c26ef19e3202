#include "core/linalg/lanczos.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Vectors of the basis beyond twice the wanted ones: more of them restart less often. */
#define SPARE 20

#define MOST_RESTARTS 1000

/* What is left of a vector, as a part of it, once all that the basis holds is taken away, where
 * it holds all: rounding of an orthogonalisation and of a solution. */
#define NOTHING 1e-9

/* An eigenvector has settled when the operator leads out of it by no more than this part of its
 * eigenvalue, or than rounding of the largest one; its eigenvalue has twice the digits then. */
#define SETTLED 1e-12

/* A second start that moves no wanted eigenvalue by more than this part has found none. */
#define SAME_EIGENVALUE 1e-6

/* LAPACK: eigenvalues, ascending, and eigenvectors, in a, of a symmetric matrix. The lengths of
 * strings come last, as Fortran has them. */
void dsyev_ (const char *job, const char *part, const int *n, double *a, const int *lda,
             double *w, double *work, const int *lwork, int *info, size_t job_length,
             size_t part_length);

typedef struct {
  QnPool pool; /* of all that follows */
  const QnLanczosProblem *problem;
  size_t n, wanted;
  size_t most;  /* vectors that the basis has room for, the next one not counted */
  size_t count; /* vectors in the basis */
  double
    *basis; /* most + 1 columns of n: the last one in use is the next to be multiplied */
  double *mass;   /* n: M times a vector */
  double *other;  /* n or most: scratch */
  double *matrix; /* most x most: the operator in the basis */
  double *ritz;   /* most x most: its eigenvectors, those of the largest values first */
  double *theta;  /* most: its eigenvalues, largest absolute values first */
  double *work;   /* of LAPACK */
  int work_length;
  double beta; /* length of what is beyond the basis */
  bool full;   /* the basis holds all that the operator reaches */
  uint64_t seed;
} Lanczos;

static double *
column (const Lanczos *l, size_t j)
{
  return l->basis + j * l->n;
}

static bool
lanczos_init (Lanczos *l, const QnLanczosProblem *problem, size_t wanted)
{
  size_t n = (size_t) problem->n, most = 2 * wanted + SPARE;

  *l = (Lanczos){ .problem = problem, .n = n, .seed = 1 };
  l->most = most < n ? most : n;
  l->wanted = wanted < l->most ? wanted : l->most;
  l->work_length = (int) (34 * l->most);
  l->basis = qn_pool_alloc (&l->pool, n, (l->most + 1) * sizeof (double));
  l->mass = qn_pool_alloc (&l->pool, n, sizeof (double));
  l->other = qn_pool_alloc (&l->pool, n, sizeof (double));
  l->matrix = qn_pool_alloc (&l->pool, l->most, l->most * sizeof (double));
  l->ritz = qn_pool_alloc (&l->pool, l->most, l->most * sizeof (double));
  l->theta = qn_pool_alloc (&l->pool, l->most, sizeof (double));
  l->work = qn_pool_alloc (&l->pool, (size_t) l->work_length, sizeof (double));
  return !l->pool.failed;
}

/* Takes out of w what lies in the first `count` vectors, twice, as once leaves digits behind, and
 * adds the parts to `parts` (nullable). Returns the length of what is left. */
static double
orthogonalize (Lanczos *l, size_t count, double *w, double *parts)
{
  for (int pass = 0; pass < 2; pass++) {
    l->problem->multiply (l->problem->data, w, l->mass);
    for (size_t j = 0; j < count; j++) {
      double part = qn_dot (column (l, j), l->mass, l->n);
      for (size_t i = 0; i < l->n; i++)
        w[i] -= part * column (l, j)[i];
      if (parts != NULL)
        parts[j] += part;
    }
  }
  l->problem->multiply (l->problem->data, w, l->mass);
  return sqrt (fmax (0, qn_dot (w, l->mass, l->n)));
}

/* w := (K - sigma M)^-1 M v */
static void
apply (Lanczos *l, const double *v, double *w)
{
  l->problem->multiply (l->problem->data, v, w);
  l->problem->solve (l->problem->data, w);
}

/* Another start, orthogonal to the first `count` vectors, as the vector behind them: out of the
 * operator's range, which the null space of M has no part in. False where there is none. */
static bool
start_anew (Lanczos *l, size_t count)
{
  double *w = column (l, count);

  for (size_t i = 0; i < l->n; i++) {
    l->seed = l->seed * 6364136223846793005u + 1442695040888963407u;
    l->other[i] = 0.5 + (double) (l->seed >> 11) * 0x1p-53;
  }
  apply (l, l->other, w);
  l->problem->multiply (l->problem->data, w, l->mass);
  double before = sqrt (fmax (0, qn_dot (w, l->mass, l->n)));
  double left = orthogonalize (l, count, w, NULL);
  if (!(left > NOTHING * before))
    return false;
  for (size_t i = 0; i < l->n; i++)
    w[i] /= left;
  /* What was nearly lost has to be cleaned once more. */
  left = orthogonalize (l, count, w, NULL);
  for (size_t i = 0; i < l->n; i++)
    w[i] /= left;
  return left > 0;
}

/* Multiplies the last vector and makes what is new of it the next one; false to cancel. */
static bool
grow (Lanczos *l)
{
  size_t j = l->count;
  double *w = column (l, j + 1), *parts = l->other;

  if (l->problem->go_on != NULL && !l->problem->go_on (l->problem->data))
    return false;
  apply (l, column (l, j), w);
  memset (parts, 0, (j + 1) * sizeof *parts);
  l->beta = orthogonalize (l, j + 1, w, parts);
  for (size_t i = 0; i <= j; i++)
    l->matrix[i * l->most + j] = l->matrix[j * l->most + i] = parts[i];
  double size = sqrt (qn_dot (parts, parts, j + 1));
  l->count++;
  if (l->beta > NOTHING * size) {
    for (size_t i = 0; i < l->n; i++)
      w[i] /= l->beta;
  } else {
    l->beta = 0;
    l->full = l->count == l->n || !start_anew (l, l->count);
  }
  return true;
}

/* theta and ritz of the basis as it is, largest absolute values first. */
static bool
project (Lanczos *l)
{
  const int m = (int) l->count;
  int info = 0;
  double *sorted = l->other;

  for (int j = 0; j < m; j++)
    memcpy (l->ritz + (size_t) j * l->count, l->matrix + (size_t) j * l->most,
            l->count * sizeof *l->ritz);
  dsyev_ ("V", "U", &m, l->ritz, &m, l->theta, l->work, &l->work_length, &info, 1, 1);
  if (info != 0)
    return false;

  /* Ascending values have their largest absolute values at both ends. */
  memcpy (sorted, l->theta, l->count * sizeof *sorted);
  double *vectors = l->matrix;
  memcpy (vectors, l->ritz, l->count * l->count * sizeof *vectors);
  size_t low = 0, high = l->count;
  for (size_t i = 0; i < l->count; i++) {
    size_t from = fabs (sorted[low]) > fabs (sorted[high - 1]) ? low++ : --high;
    l->theta[i] = sorted[from];
    memcpy (l->ritz + i * l->count, vectors + from * l->count,
            l->count * sizeof *vectors);
  }
  return true;
}

static bool
has_settled (const Lanczos *l)
{
  for (size_t i = 0; i < l->wanted && i < l->count; i++) {
    double last = l->ritz[i * l->count + l->count - 1];
    if (fabs (l->beta * last)
        > fmax (SETTLED * fabs (l->theta[i]), 4 * DBL_EPSILON * fabs (l->theta[0])))
      return false;
  }
  return true;
}

/* Makes the first `kept` Ritz vectors the basis, with the vector behind the basis behind them. */
static void
shrink (Lanczos *l, size_t kept)
{
  for (size_t i = 0; i < l->n; i++) {
    for (size_t k = 0; k < kept; k++) {
      double sum = 0;
      for (size_t j = 0; j < l->count; j++)
        sum += l->basis[j * l->n + i] * l->ritz[k * l->count + j];
      l->other[k] = sum;
    }
    for (size_t k = 0; k < kept; k++)
      l->basis[k * l->n + i] = l->other[k];
  }
  memmove (column (l, kept), column (l, l->count), l->n * sizeof (double));
  memset (l->matrix, 0, l->most * l->most * sizeof *l->matrix);
  for (size_t k = 0; k < kept; k++)
    l->matrix[k * l->most + k] = l->theta[k];
  l->count = kept;
}

/* Grows the basis until the wanted values have settled. */
static QnSolveStatus
settle (Lanczos *l)
{
  for (int restart = 0; restart < MOST_RESTARTS; restart++) {
    while (l->count < l->most && !l->full)
      if (!grow (l))
        return QN_SOLVE_CANCELLED;
    if (!project (l))
      return QN_SOLVE_FAILED;
    if (l->full || has_settled (l))
      return QN_SOLVE_CONVERGED;
    shrink (l, l->wanted + (l->most - l->wanted) / 2);
  }
  return QN_SOLVE_FAILED;
}

/* Settles, and again from other starts, until that changes nothing. */
static QnSolveStatus
find_all (Lanczos *l, double *before)
{
  QnSolveStatus status = settle (l);
  bool changed = true;

  for (size_t i = 0; i < l->wanted && status == QN_SOLVE_CONVERGED && !l->full && changed;
       i++) {
    memcpy (before, l->theta, l->wanted * sizeof *before);
    shrink (l, l->wanted + (l->most - l->wanted) / 2);
    l->full = !start_anew (l, l->count);
    status = settle (l);
    changed = false;
    for (size_t k = 0; k < l->wanted && k < l->count; k++)
      changed |= fabs (l->theta[k] - before[k]) > SAME_EIGENVALUE * fabs (before[k]);
  }
  return status;
}

/* lambda = sigma + 1 / theta, ascending, with their vectors. */
static size_t
take (Lanczos *l, double *values, double *vectors)
{
  size_t found = l->wanted < l->count ? l->wanted : l->count;

  shrink (l, found);
  for (size_t k = 0; k < found; k++) {
    double value = l->problem->shift + 1 / l->theta[k];
    size_t at = k;
    for (; at > 0 && values[at - 1] > value; at--) {
      values[at] = values[at - 1];
      memcpy (vectors + at * l->n, vectors + (at - 1) * l->n, l->n * sizeof *vectors);
    }
    values[at] = value;
    memcpy (vectors + at * l->n, column (l, k), l->n * sizeof *vectors);
  }
  return found;
}

QnSolveStatus
qn_lanczos_run (const QnLanczosProblem *problem, size_t wanted, size_t *found,
                double *values, double *vectors)
{
  Lanczos l;
  QnSolveStatus status = QN_SOLVE_NO_MEMORY;
  double *before = NULL;

  *found = 0;
  if (lanczos_init (&l, problem, wanted)) {
    before = qn_alloc (l.wanted, sizeof *before);
    l.full = before != NULL && !start_anew (&l, 0);
    if (before != NULL && !l.full)
      status = find_all (&l, before);
    else if (l.full)
      status = QN_SOLVE_CONVERGED; /* nothing has mass */
  }
  if (status == QN_SOLVE_CONVERGED && l.count > 0)
    *found = take (&l, values, vectors);
  free (before);
  qn_pool_clear (&l.pool);
  return status;
}
