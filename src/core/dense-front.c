#include "core/dense-front.h"

#include <math.h>
#include <string.h>

/* Columns that are eliminated together before the others follow. */
#define STRIP QN_FRONT_ROWS

/* Columns of a tile of the product of matrices; a tile is one or two vectors high. */
#define TILE 6

/* A pivot on the diagonal is kept unless another one is so much larger. */
#define EXCHANGE 4.0

/* Every function is made part of its caller, and so compiled for each kind of processor. */
#define PART static inline __attribute__ ((always_inline))

typedef double Eight __attribute__ ((vector_size (64), aligned (8), may_alias));
typedef int64_t Mask __attribute__ ((vector_size (64)));

/* --- Products --------------------------------------------------------------------------- */

/* target (height x columns) = (add ? target : 0) - left (height x depth) * right, where the
 * height is that of `vectors` Eights. */
PART void
subtract_tile (double *target, int32_t target_height, const double *left,
               int32_t left_height, const double *right, int32_t right_height,
               int32_t depth, int vectors, int columns, bool add)
{
  Eight sum[2][TILE];

  QN_UNROLL
  for (int c = 0; c < columns; c++)
    QN_UNROLL
  for (int v = 0; v < vectors; v++)
    sum[v][c] =
      add ? *(const Eight *) (target + c * target_height + 8 * v) : (Eight){ 0 };
  for (int32_t k = 0; k < depth; k++) {
    Eight factor[2];
    QN_UNROLL
    for (int v = 0; v < vectors; v++)
      factor[v] = *(const Eight *) (left + (size_t) k * (size_t) left_height + 8 * v);
    QN_UNROLL
    for (int c = 0; c < columns; c++) {
      double value = right[c * right_height + k];
      QN_UNROLL
      for (int v = 0; v < vectors; v++)
        sum[v][c] -= factor[v] * value;
    }
  }
  QN_UNROLL
  for (int c = 0; c < columns; c++)
    QN_UNROLL
  for (int v = 0; v < vectors; v++)
    *(Eight *) (target + c * target_height + 8 * v) = sum[v][c];
}

/* The same for `height` rows, a multiple of eight. */
PART void
subtract_column_tiles (double *target, int32_t target_height, const double *left,
                       int32_t left_height, const double *right, int32_t right_height,
                       int32_t height, int32_t depth, int columns, bool add)
{
  int32_t row = 0;

  for (; row + 16 <= height; row += 16)
    subtract_tile (target + row, target_height, left + row, left_height, right,
                   right_height, depth, 2, columns, add);
  if (row < height)
    subtract_tile (target + row, target_height, left + row, left_height, right,
                   right_height, depth, 1, columns, add);
}

/* target (height x columns) -= left (height x depth) * right (depth x columns), or target =
 * - left * right. */
PART void
subtract_product (double *target, int32_t target_height, const double *left,
                  int32_t left_height, const double *right, int32_t right_height,
                  int32_t height, int32_t depth, int32_t columns, bool add)
{
  int32_t column = 0;

  for (; column + TILE <= columns; column += TILE)
    subtract_column_tiles (target + (size_t) column * (size_t) target_height,
                           target_height, left, left_height,
                           right + (size_t) column * (size_t) right_height, right_height,
                           height, depth, TILE, add);
  if (column + TILE / 2 <= columns) {
    subtract_column_tiles (target + (size_t) column * (size_t) target_height,
                           target_height, left, left_height,
                           right + (size_t) column * (size_t) right_height, right_height,
                           height, depth, TILE / 2, add);
    column += TILE / 2;
  }
  for (; column < columns; column++)
    subtract_column_tiles (target + (size_t) column * (size_t) target_height,
                           target_height, left, left_height,
                           right + (size_t) column * (size_t) right_height, right_height,
                           height, depth, 1, add);
}

/* target -= factor * column */
PART void
subtract_column (double *target, const double *column, int32_t height, double factor)
{
  for (int32_t row = 0; row < height; row += 8)
    *(Eight *) (target + row) -= *(const Eight *) (column + row) * factor;
}

PART void
scale_column (double *column, int32_t height, double factor)
{
  for (int32_t row = 0; row < height; row += 8)
    *(Eight *) (column + row) *= factor;
}

/* --- Elimination ------------------------------------------------------------------------ */

PART void
exchange_rows (double *matrix, int32_t height, int32_t columns, int32_t one,
               int32_t other)
{
  for (int32_t c = 0; c < columns; c++) {
    double *column = matrix + (size_t) c * (size_t) height;
    double value = column[one];
    column[one] = column[other];
    column[other] = value;
  }
}

/* The largest size in a column from `first`, a multiple of eight, to `height`. */
PART double
largest_size (const double *column, int32_t first, int32_t height)
{
  double largest = 0;
  Eight sizes = { 0 };

  for (int32_t row = first; row < height; row += 8) {
    Mask size = (Mask) * (const Eight *) (column + row) & INT64_MAX;
    Mask larger = (Eight) size > sizes;
    sizes = (Eight) ((size & larger) | ((Mask) sizes & ~larger));
  }
  for (int i = 0; i < 8; i++)
    largest = sizes[i] > largest ? sizes[i] : largest;
  return largest;
}

/* Brings a pivot to row j of column j, in the strip from `first`. */
PART bool
choose_pivot (const QnDenseFront *front, int32_t height, int32_t first, int32_t j,
              QnPivotRange *range)
{
  const double *column = front->diagonal + (size_t) j * (size_t) height;
  double size = fabs (column[j]), largest = size;
  int32_t pivot = j;

  for (int32_t row = j + 1; row < first + STRIP; row++)
    largest = fabs (column[row]) > largest ? fabs (column[row]) : largest;
  if (first + STRIP < height)
    largest = fmax (largest, largest_size (column, first + STRIP, height));
  if (largest > EXCHANGE * size)
    for (pivot = j + 1; fabs (column[pivot]) < largest;)
      pivot++;
  front->exchanges[j] = pivot;
  size = fabs (column[pivot]);
  if (!(size > 0 && size <= 1e300))
    return false;
  range->smallest = size < range->smallest ? size : range->smallest;
  range->largest = size > range->largest ? size : range->largest;
  if (pivot != j) {
    exchange_rows (front->diagonal, height, front->pivots, j, pivot);
    exchange_rows (front->upper, height, front->rest, j, pivot);
  }
  return true;
}

/* Eliminates columns first to end of D and L, within those columns. Rows above the pivot in
 * its vector keep what they have: they are set to zero factors while it is subtracted. */
PART bool
eliminate_strip (const QnDenseFront *front, int32_t height, int32_t low_height,
                 int32_t first, int32_t end, QnPivotRange *range)
{
  for (int32_t j = first; j < end; j++) {
    double *column = front->diagonal + (size_t) j * (size_t) height;
    double *below = front->lower + (size_t) j * (size_t) low_height;
    if (!choose_pivot (front, height, first, j, range))
      return false;

    double factor = 1 / column[j];
    Eight head = { 0 };
    for (int32_t row = j + 1; row < first + STRIP; row++)
      head[row - first] = column[row] *= factor;
    scale_column (column + first + STRIP, height - first - STRIP, factor);
    scale_column (below, low_height, factor);
    for (int32_t c = j + 1; c < end; c++) {
      double *target = front->diagonal + (size_t) c * (size_t) height;
      double value = target[j];
      *(Eight *) (target + first) -= head * value;
      subtract_column (target + first + STRIP, column + first + STRIP,
                       height - first - STRIP, value);
      subtract_column (front->lower + (size_t) c * (size_t) low_height, below, low_height,
                       value);
    }
  }
  return true;
}

/* inverse (by columns) of the unit lower triangle of a strip of L_1. */
PART void
invert_strip (const double *strip, int32_t height, int32_t first, int32_t count,
              double inverse[STRIP * STRIP])
{
  memset (inverse, 0, STRIP * STRIP * sizeof *inverse);
  for (int32_t c = 0; c < count; c++) {
    inverse[STRIP * c + c] = 1;
    for (int32_t j = c; j < count; j++)
      for (int32_t row = j + 1; row < count; row++)
        inverse[STRIP * c + row] -=
          strip[(size_t) j * (size_t) height + (size_t) (first + row)]
          * inverse[STRIP * c + j];
  }
}

/* The rows of a strip in `columns` columns, side by side: target = inverse * target. */
PART void
multiply_strip (const double inverse[STRIP * STRIP], int32_t count, double *target,
                int32_t height, int columns)
{
  Eight sum[4];

  QN_UNROLL
  for (int c = 0; c < columns; c++)
    sum[c] = *(const Eight *) inverse * target[c * height];
  for (int32_t j = 1; j < count; j++) {
    Eight factor = *(const Eight *) (inverse + STRIP * j);
    QN_UNROLL
    for (int c = 0; c < columns; c++)
      sum[c] += factor * target[c * height + j];
  }
  QN_UNROLL
  for (int c = 0; c < columns; c++)
    *(Eight *) (target + c * height) = sum[c];
}

/* Rows of a strip in all columns of U, or of U_1. */
PART void
solve_strip (const double inverse[STRIP * STRIP], int32_t count, double *target,
             int32_t height, int32_t columns)
{
  int32_t c = 0;

  for (; c + 4 <= columns; c += 4)
    multiply_strip (inverse, count, target + (size_t) c * (size_t) height, height, 4);
  for (; c < columns; c++)
    multiply_strip (inverse, count, target + (size_t) c * (size_t) height, height, 1);
}

PART bool
eliminate (const QnDenseFront *front, QnPivotRange *range)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots),
          low_height = qn_front_height (front->rest);
  double *d = front->diagonal, inverse[STRIP * STRIP];

  for (int32_t first = 0; first < pivots; first += STRIP) {
    int32_t end = first + STRIP < pivots ? first + STRIP : pivots;
    int32_t next = first + STRIP;
    double *strip = d + (size_t) first * (size_t) height;
    double *right = d + (size_t) end * (size_t) height;
    if (!eliminate_strip (front, height, low_height, first, end, range))
      return false;
    invert_strip (strip, height, first, end - first, inverse);
    solve_strip (inverse, end - first, right + first, height, pivots - end);
    solve_strip (inverse, end - first, front->upper + first, height, front->rest);
    if (next < pivots) {
      subtract_product (right + next, height, strip + next, height, right + first, height,
                        height - next, STRIP, pivots - next, true);
      subtract_product (front->lower + (size_t) next * (size_t) low_height, low_height,
                        front->lower + (size_t) first * (size_t) low_height, low_height,
                        right + first, height, low_height, STRIP, pivots - next, true);
      subtract_product (front->upper + next, height, strip + next, height,
                        front->upper + first, height, height - next, STRIP, front->rest,
                        true);
    }
  }
  subtract_product (front->schur, low_height, front->lower, low_height, front->upper,
                    height, low_height, pivots, front->rest, false);
  return true;
}

/* --- Solution --------------------------------------------------------------------------- */

/* target += matrix (height x columns) * factors, four columns at a time. */
PART void
add_columns (double *target, const double *matrix, int32_t height, int32_t columns,
             const double *factors)
{
  int32_t c = 0;

  for (; c + 4 <= columns; c += 4, matrix += 4 * (size_t) height)
    for (int32_t row = 0; row < height; row += 8) {
      Eight sum = *(const Eight *) (target + row);
      QN_UNROLL
      for (int i = 0; i < 4; i++)
        sum += *(const Eight *) (matrix + i * height + row) * factors[c + i];
      *(Eight *) (target + row) = sum;
    }
  for (; c < columns; c++, matrix += height)
    subtract_column (target, matrix, height, -factors[c]);
}

PART void
forward (const QnDenseFront *front, double *x, double *below)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots),
          low_height = qn_front_height (front->rest);

  for (int32_t j = 0; j < pivots; j++) {
    int32_t other = front->exchanges[j];
    double value = x[other];
    x[other] = x[j];
    x[j] = value;
  }
  for (int32_t j = 0; j < pivots; j++) {
    const double *column = front->diagonal + (size_t) j * (size_t) height;
    int32_t next = (j / STRIP + 1) * STRIP;
    for (int32_t row = j + 1; row < next; row++)
      x[row] -= column[row] * x[j];
    subtract_column (x + next, column + next, height - next, x[j]);
  }
  memset (below, 0, (size_t) low_height * sizeof *below);
  add_columns (below, front->lower, low_height, pivots, x);
}

PART void
backward (const QnDenseFront *front, double *x, double *above)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots);

  for (int32_t c = 0; c < front->rest; c++)
    above[c] = -above[c];
  add_columns (x, front->upper, height, front->rest, above);
  for (int32_t j = pivots - 1; j >= 0; j--) {
    const double *column = front->diagonal + (size_t) j * (size_t) height;
    int32_t first = j / STRIP * STRIP;
    x[j] /= column[j];
    for (int32_t row = first; row < j; row++)
      x[row] -= column[row] * x[j];
    subtract_column (x, column, first, x[j]);
  }
}

/* --- One set of loops for each kind of processor ---------------------------------------- */

#define LOOPS(name, attribute)                                                           \
  attribute static bool eliminate_##name (const QnDenseFront *front,                     \
                                          QnPivotRange *range)                           \
  {                                                                                      \
    return eliminate (front, range);                                                     \
  }                                                                                      \
  attribute static void forward_##name (const QnDenseFront *front, double *x,            \
                                        double *below)                                   \
  {                                                                                      \
    forward (front, x, below);                                                           \
  }                                                                                      \
  attribute static void backward_##name (const QnDenseFront *front, double *x,           \
                                         double *above)                                  \
  {                                                                                      \
    backward (front, x, above);                                                          \
  }                                                                                      \
  static const QnFrontLoops loops_##name = { eliminate_##name, forward_##name,           \
                                             backward_##name };

LOOPS (everywhere, )

#if defined __x86_64__ && defined __GNUC__

LOOPS (avx2, __attribute__ ((target ("avx2"))))
LOOPS (avx512, __attribute__ ((target ("avx512f"))))

const QnFrontLoops *
qn_front_loops (int width)
{
  if (width >= 8 && __builtin_cpu_supports ("avx512f"))
    return &loops_avx512;
  return width >= 4 && __builtin_cpu_supports ("avx2") ? &loops_avx2 : &loops_everywhere;
}

#else

const QnFrontLoops *
qn_front_loops (int width)
{
  (void) width;
  return &loops_everywhere;
}

#endif
