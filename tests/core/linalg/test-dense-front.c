#include "core/linalg/dense-front.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Fronts of all sizes up to these. */
enum { PIVOTS = 40, REST = 35, MOST = 40 };

typedef struct {
  QnDenseFront dense;
  double diagonal[MOST * PIVOTS], lower[MOST * PIVOTS], upper[MOST * PIVOTS],
    schur[MOST * REST];
  int32_t exchanges[PIVOTS];
  double x[MOST], below[MOST]; /* a solution, and what forward passed on */
} Front;

static void
fill (double *matrix, int32_t rows, int32_t columns, GRand *random)
{
  int32_t height = qn_front_height (rows);
  g_assert_cmpint (height, <=, MOST);
  memset (matrix, 0, sizeof (double) * (size_t) height * (size_t) columns);
  for (int32_t c = 0; c < columns; c++)
    for (int32_t r = 0; r < rows; r++)
      matrix[height * c + r] = g_rand_double_range (random, -1, 1);
}

static void
front_init (Front *front, int32_t pivots, int32_t rest, guint32 seed)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (seed);
  front->dense = (QnDenseFront){ .pivots = pivots,
                                 .rest = rest,
                                 .diagonal = front->diagonal,
                                 .lower = front->lower,
                                 .upper = front->upper,
                                 .schur = front->schur,
                                 .exchanges = front->exchanges };
  fill (front->diagonal, pivots, pivots, random);
  fill (front->lower, rest, pivots, random);
  fill (front->upper, rest, pivots, random);
}

/* D x = b - U y and z = L x: forward and backward together solve for x, and forward tells what
 * of it reaches the rest. */
static void
check_solution (const Front *original, Front *front, const QnFrontLoops *loops)
{
  int32_t pivots = front->dense.pivots, rest = front->dense.rest;
  int32_t height = qn_front_height (pivots), low_height = qn_front_height (rest);
  double y[MOST] = { 0 }, z[MOST], right[MOST], *x = front->x, *below = front->below;

  memset (x, 0, sizeof front->x);
  for (int32_t r = 0; r < pivots; r++)
    x[r] = right[r] = sin (r + 1);
  for (int32_t r = 0; r < rest; r++)
    y[r] = z[r] = cos (r);
  loops->forward (&front->dense, x, below);
  loops->backward (&front->dense, x, y);

  for (int32_t c = 0; c < pivots; c++)
    for (int32_t r = 0; r < pivots; r++)
      right[r] -= original->diagonal[height * c + r] * x[c];
  for (int32_t c = 0; c < rest; c++)
    for (int32_t r = 0; r < pivots; r++)
      right[r] -= original->upper[low_height * r + c] * z[c];
  for (int32_t r = 0; r < pivots; r++)
    g_assert_cmpfloat (fabs (right[r]), <, 1e-9);

  /* S = - L D^-1 U, and what forward passes on is L D^-1 b. */
  for (int32_t r = 0; r < rest; r++) {
    double sum = below[r];
    for (int32_t c = 0; c < pivots; c++)
      sum -= original->lower[low_height * c + r] * x[c];
    for (int32_t c = 0; c < rest; c++)
      sum += front->schur[low_height * c + r] * z[c];
    g_assert_cmpfloat (fabs (sum), <, 1e-9);
  }
}

/* The loops for every kind of processor agree to the bit. */
static void
test_elimination (void)
{
  static Front original, front, wide;
  const int widths[] = { 2, 4 };

  for (int32_t pivots = 1; pivots <= PIVOTS; pivots += 1 + pivots / 8)
    for (int32_t rest = 0; rest <= REST; rest += 1 + rest / 5) {
      front_init (&original, pivots, rest, (guint32) (100 * pivots + rest));
      for (size_t w = 0; w < G_N_ELEMENTS (widths); w++) {
        QnPivotRange range = { INFINITY, 0 };
        const QnFrontLoops *loops = qn_front_loops (widths[w]);
        front_init (&front, pivots, rest, (guint32) (100 * pivots + rest));
        g_assert_true (loops->eliminate (&front.dense, &range));
        g_assert_cmpfloat (range.smallest, >, 0);
        g_assert_cmpfloat (range.largest, <, 100);
        check_solution (&original, &front, loops);
        if (w == 0)
          wide = front;
        size_t bytes = sizeof (double) * (size_t) (qn_front_height (rest) * rest);
        g_assert_cmpmem (wide.schur, bytes, front.schur, bytes);
        bytes = sizeof (double) * (size_t) (qn_front_height (pivots) * pivots);
        g_assert_cmpmem (wide.diagonal, bytes, front.diagonal, bytes);
        bytes = sizeof (double) * (size_t) (qn_front_height (rest) * pivots);
        g_assert_cmpmem (wide.lower, bytes, front.lower, bytes);
        g_assert_cmpmem (wide.upper, bytes, front.upper, bytes);
        g_assert_cmpmem (wide.x, sizeof wide.x, front.x, sizeof front.x);
        bytes = sizeof (double) * (size_t) qn_front_height (rest);
        g_assert_cmpmem (wide.below, bytes, front.below, bytes);
      }
    }
}

/* Every processor takes the widest loops that it can, and no wider ones than it is asked to. */
static void
test_processor (void)
{
  bool avx2 = false;

#ifdef __x86_64__
  avx2 = __builtin_cpu_supports ("avx2");
#endif
  g_assert_true ((qn_front_loops (4) != qn_front_loops (2)) == avx2);
  g_assert_true (qn_front_loops (8) == qn_front_loops (4));
}

/* A row of zeros, and what is no number. */
static void
test_singular (void)
{
  static Front front;
  const QnFrontLoops *loops = qn_front_loops (QN_FRONT_ROWS);
  QnPivotRange range = { INFINITY, 0 };

  front_init (&front, 11, 7, 1);
  for (int32_t c = 0; c < 11; c++)
    front.diagonal[16 * c + 6] = 0;
  g_assert_true (loops->eliminate (&front.dense, &range));
  g_assert_cmpfloat (range.smallest, ==, QN_FRONT_VANISHED);
  front_init (&front, 11, 7, 1);
  front.diagonal[16 * 4 + 9] = NAN;
  g_assert_false (loops->eliminate (&front.dense, &range));
}

QN_TESTS
{
  g_test_add_func ("/dense-front/elimination", test_elimination);
  g_test_add_func ("/dense-front/processor", test_processor);
  g_test_add_func ("/dense-front/singular", test_singular);
}
