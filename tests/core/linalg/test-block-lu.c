#include "core/linalg/block-lu.h"

#include "core/linalg/sparse.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Bodies in a square grid, each coupled with its neighbours; some lack degrees of freedom. The large one
 * is worth taking to parts. */
enum { SIDE = 12, LARGE_SIDE = 64 };

typedef struct {
  int32_t n;
  int32_t (*unknown)[3];
  QnPool pool; /* of the pattern */
  int32_t *ap, *ai;
  double *ax, *x, *b;
} Grid;

static void
couple (Grid *grid, QnSparsePattern *pattern, int one, int other)
{
  int32_t unknowns[6];

  for (int d = 0; d < 3; d++) {
    unknowns[d] = grid->unknown[one][d];
    unknowns[3 + d] = grid->unknown[other][d];
  }
  qn_sparse_pattern_add_clique (pattern, unknowns, 6);
}

static void
grid_init (Grid *grid, int side, GRand *random)
{
  QnSparsePattern pattern;
  int bodies = side * side;

  grid->n = 0;
  grid->pool = (QnPool){ 0 };
  grid->unknown = g_malloc_n ((gsize) bodies, sizeof *grid->unknown);
  for (int body = 0; body < bodies; body++)
    for (int d = 0; d < 3; d++)
      grid->unknown[body][d] =
        body > 0 && g_rand_int_range (random, 0, 8) == 0 ? QN_NONE : grid->n++;
  qn_sparse_pattern_init (&pattern, grid->n, (size_t) bodies * 72, &grid->pool);
  for (int body = 0; body < bodies; body++) {
    if (body % side > 0)
      couple (grid, &pattern, body, body - 1);
    if (body >= side)
      couple (grid, &pattern, body, body - side);
  }
  qn_sparse_pattern_compress (&pattern, &grid->ap, &grid->ai);
  g_assert_false (grid->pool.failed);
  grid->ax = g_new (double, grid->ap[grid->n]);
  grid->x = g_new (double, grid->n);
  grid->b = g_new (double, grid->n);
}

/* Random values, not symmetric, with a diagonal that elimination can rest upon; b = A x. */
static void
grid_randomise (Grid *grid, GRand *random)
{
  for (int32_t i = 0; i < grid->n; i++) {
    grid->x[i] = g_rand_double_range (random, -1, 1);
    grid->b[i] = 0;
  }
  for (int32_t j = 0; j < grid->n; j++)
    for (int32_t p = grid->ap[j]; p < grid->ap[j + 1]; p++) {
      grid->ax[p] = g_rand_double_range (random, -1, 1) + (grid->ai[p] == j ? 12 : 0);
      grid->b[grid->ai[p]] += grid->ax[p] * grid->x[j];
    }
}

static void
grid_clear (Grid *grid)
{
  g_free (grid->unknown);
  g_free (grid->ax);
  g_free (grid->x);
  g_free (grid->b);
  qn_pool_clear (&grid->pool);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Grid, grid_clear)

static void
test_solution (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (11);

  for (int structure = 0; structure < 5; structure++) {
    g_auto (Grid) grid;
    grid_init (&grid, SIDE, random);
    QnBlockLu *lu = qn_block_lu_new (grid.n, grid.ap, grid.ai, NULL);
    g_assert_nonnull (lu);
    for (int k = 0; k < 3; k++) {
      grid_randomise (&grid, random);
      double ratio = qn_block_lu_factor (lu, grid.ax);
      g_assert_cmpfloat (ratio, >, 1e-3);
      g_assert_cmpfloat (ratio, <=, 1);
      qn_block_lu_solve (lu, grid.b);
      for (int32_t i = 0; i < grid.n; i++)
        g_assert_cmpfloat (fabs (grid.b[i] - grid.x[i]), <, 1e-12);
    }
    qn_block_lu_free (lu);
  }
}

/* A body without any stiffness is found out: it moves without end. It leaves nothing behind. */
static void
test_vanishing_pivot (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (13);
  g_auto (Grid) grid;
  grid_init (&grid, SIDE, random);
  QnBlockLu *lu = qn_block_lu_new (grid.n, grid.ap, grid.ai, NULL);

  grid_randomise (&grid, random);
  for (int32_t j = 0; j < grid.n; j++)
    for (int32_t p = grid.ap[j]; p < grid.ap[j + 1]; p++)
      for (int d = 0; d < 3; d++)
        if (grid.ai[p] == grid.unknown[40][d] || j == grid.unknown[40][d])
          grid.ax[p] = 0;
  g_assert_cmpfloat (qn_block_lu_factor (lu, grid.ax), <, 1e-50);
  qn_block_lu_solve (lu, grid.b);
  for (int32_t i = 0; i < grid.n; i++) {
    bool free =
      i == grid.unknown[40][0] || i == grid.unknown[40][1] || i == grid.unknown[40][2];
    g_assert_true (free == (fabs (grid.b[i]) > 1e50));
  }

  grid_randomise (&grid, random);
  double share;
  g_assert_cmpfloat (qn_block_lu_refactor (lu, grid.ax, &share), >, 0);
  g_assert_cmpfloat (share, ==, 1);
  qn_block_lu_solve (lu, grid.b);
  for (int32_t i = 0; i < grid.n; i++)
    g_assert_cmpfloat (fabs (grid.b[i] - grid.x[i]), <, 1e-12);
  qn_block_lu_free (lu);
}

/* Rows are exchanged within a block: the first pivot may be zero. */
static void
test_single_body (void)
{
  const int32_t ap[] = { 0, 2, 4 }, ai[] = { 0, 1, 0, 1 };
  const double ax[] = { 0, 2, 4, 1 };
  double b[] = { 4, 3 };
  QnBlockLu *lu = qn_block_lu_new (2, ap, ai, NULL);

  g_assert_cmpfloat (qn_block_lu_factor (lu, ax), ==, 0.5);
  qn_block_lu_solve (lu, b);
  g_assert_cmpfloat (b[0], ==, 1);
  g_assert_cmpfloat (b[1], ==, 1);
  qn_block_lu_free (lu);
}

static void
test_empty (void)
{
  const int32_t ap[] = { 0 }, ai[] = { 0 };
  QnBlockLu *lu = qn_block_lu_new (0, ap, ai, NULL);

  g_assert_nonnull (lu);
  g_assert_cmpfloat (qn_block_lu_factor (lu, NULL), ==, 1);
  qn_block_lu_free (lu);
}

/* What is eliminated anew is what new values reach, and the factors are those of a factorisation
 * from the start, to the bit. */
static void
test_refactorisation (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (17);
  g_auto (Grid) grid;
  grid_init (&grid, SIDE, random);
  QnBlockLu *lu = qn_block_lu_new (grid.n, grid.ap, grid.ai, NULL);
  QnBlockLu *fresh = qn_block_lu_new (grid.n, grid.ap, grid.ai, NULL);
  double share, least = 1;

  grid_randomise (&grid, random);
  g_assert_cmpfloat (qn_block_lu_refactor (lu, grid.ax, &share), >, 0);
  g_assert_cmpfloat (share, ==, 1);
  g_assert_cmpfloat (qn_block_lu_refactor (lu, grid.ax, &share), >, 0);
  g_assert_cmpfloat (share, ==, 0);
  for (int k = 0; k < 100; k++) {
    int32_t p = g_rand_int_range (random, 0, grid.ap[grid.n]);
    grid.ax[p] += 0.125;
    double ratio = qn_block_lu_refactor (lu, grid.ax, &share);
    g_assert_cmpfloat (share, >, 0);
    g_assert_cmpfloat (share, <, 1);
    least = MIN (least, share);
    g_assert_cmpfloat (qn_block_lu_factor (fresh, grid.ax), ==, ratio);
    g_autofree double *x = g_memdup2 (grid.b, (gsize) grid.n * sizeof *x);
    qn_block_lu_solve (lu, x);
    qn_block_lu_solve (fresh, grid.b);
    g_assert_cmpmem (x, (size_t) grid.n * sizeof *x, grid.b, (size_t) grid.n * sizeof *x);
    g_assert_cmpint (qn_block_lu_sign (lu), ==, qn_block_lu_sign (fresh));
  }
  g_assert_cmpfloat (least, <, 0.7);
  qn_block_lu_free (lu);
  qn_block_lu_free (fresh);
}

static void
run_backwards (void *pool, int32_t count, void (*part) (void *data, int32_t i),
               void *data)
{
  int32_t *most = pool;

  *most = MAX (*most, count);
  for (int32_t i = count - 1; i >= 0; i--)
    part (data, i);
}

/* The parts of a large matrix do not touch each other: in any order they give the same, to the bit. */
static void
test_parts (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (19);
  g_auto (Grid) grid;
  int32_t most = 0;
  double share;
  grid_init (&grid, LARGE_SIDE, random);
  QnWorkers backwards = { .run = run_backwards, .pool = &most };
  QnBlockLu *one = qn_block_lu_new (grid.n, grid.ap, grid.ai, NULL);
  QnBlockLu *other = qn_block_lu_new (grid.n, grid.ap, grid.ai, &backwards);

  for (int k = 0; k < 6; k++) {
    if (k % 3 == 0)
      grid_randomise (&grid, random);
    else
      grid.ax[g_rand_int_range (random, 0, grid.ap[grid.n])] += 0.125;
    bool anew = k % 2 == 0;
    double ratio = anew ? qn_block_lu_factor (one, grid.ax)
                        : qn_block_lu_refactor (one, grid.ax, &share);
    g_assert_cmpfloat (ratio, >, 1e-3);
    g_assert_cmpfloat (qn_block_lu_refactor (other, grid.ax, &share), ==, ratio);
    g_assert_true (k % 3 == 0 ? share == 1 : share < 0.7);
    g_assert_cmpint (qn_block_lu_sign (one), ==, qn_block_lu_sign (other));
    g_autofree double *x = g_memdup2 (grid.b, (gsize) grid.n * sizeof *x);
    g_autofree double *y = g_memdup2 (grid.b, (gsize) grid.n * sizeof *y);
    qn_block_lu_solve (one, x);
    qn_block_lu_solve (other, y);
    g_assert_cmpmem (x, (gsize) grid.n * sizeof *x, y, (gsize) grid.n * sizeof *y);
    for (int32_t i = 0; k % 3 == 0 && i < grid.n; i++)
      g_assert_cmpfloat (fabs (x[i] - grid.x[i]), <, 1e-11);
  }
  g_assert_cmpint (most, >, 16);

  /* What is no number is found in whichever part it stands. */
  grid.ax[grid.ap[grid.n / 3]] = NAN;
  g_assert_cmpfloat (qn_block_lu_factor (one, grid.ax), ==, 0);
  g_assert_cmpfloat (qn_block_lu_refactor (other, grid.ax, &share), ==, 0);
  grid_randomise (&grid, random);
  g_assert_cmpfloat (qn_block_lu_refactor (other, grid.ax, &share), >, 1e-3);
  g_assert_cmpfloat (share, ==, 1);
  qn_block_lu_free (one);
  qn_block_lu_free (other);
}

QN_TESTS
{
  g_test_add_func ("/block-lu/solution", test_solution);
  g_test_add_func ("/block-lu/refactorisation", test_refactorisation);
  g_test_add_func ("/block-lu/vanishing-pivot", test_vanishing_pivot);
  g_test_add_func ("/block-lu/single-body", test_single_body);
  g_test_add_func ("/block-lu/empty", test_empty);
  g_test_add_func ("/block-lu/parts", test_parts);
}
