#include "core/linalg/dense-front.h"

#include <math.h>
#include <string.h>

/* Doubles per SIMD vector; 2, which every processor has, unless the build says otherwise. */
#ifndef QN_VECTOR_LANES
#define QN_VECTOR_LANES 2
#endif
#define LANES QN_VECTOR_LANES

#if defined __x86_64__ && LANES == 4 && !defined __AVX2__
#error "These vectors would be split: the compiler is not asked for what they need."
#endif

typedef double Vector __attribute__ ((vector_size (8 * LANES), aligned (8), may_alias));
typedef int64_t Mask __attribute__ ((vector_size (8 * LANES), aligned (8), may_alias));

/* Always inlined: there the counts of vectors and columns are constants. */
#define PART static inline __attribute__ ((always_inline))

/* The name of this width's loops. */
#define WITH_NUMBER(name, lanes) name##_##lanes
#define WITH_LANES(name, lanes)  WITH_NUMBER (name, lanes)
#define WITH_WIDTH(name)         WITH_LANES (name, LANES)

/* Columns that are eliminated together before the others follow, and vectors of as many rows. */
#define STRIP         QN_FRONT_ROWS
#define STRIP_VECTORS (STRIP / LANES)

/* Columns of a tile of the product of matrices, which is one or two vectors high, and of the other
 * loops: what the registers hold. Blocks have three unknowns: what is left are three columns. */
#define TILE 6
#define TALL 4
#define SUMS (LANES < 4 ? 3 : 6)

/* Most columns that a vector is multiplied by together. */
#define GROUP 9

/* A pivot on the diagonal is kept unless another one is so much larger. */
#define EXCHANGE 4.0

/* --- Products --------------------------------------------------------------------------- */

/* sum (vectors x columns Vectors) -= left (height x depth) * right, the number of which in row k and
 * column c stands at right[k * right_row + c * right_column]. */
PART void
subtract_in_tile (Vector sum[TALL][TILE], const double *left, int32_t left_height,
                  const double *right, int32_t right_row, int32_t right_column,
                  int32_t depth, int vectors, int columns)
{
  for (int32_t k = 0; k < depth; k++, left += left_height, right += right_row) {
    Vector factor[TALL];
    QN_UNROLL
    for (int v = 0; v < vectors; v++)
      factor[v] = *(const Vector *) (left + LANES * v);
    QN_UNROLL
    for (int c = 0; c < columns; c++) {
      double value = right[c * right_column];
      QN_UNROLL
      for (int v = 0; v < vectors; v++)
        sum[v][c] -= factor[v] * value;
    }
  }
}

PART void
load_tile (Vector sum[TALL][TILE], const double *source, int32_t height, int vectors,
           int columns)
{
  QN_UNROLL
  for (int c = 0; c < columns; c++)
    QN_UNROLL
  for (int v = 0; v < vectors; v++)
    sum[v][c] = *(const Vector *) (source + c * height + LANES * v);
}

PART void
store_tile (double *target, int32_t height, Vector sum[TALL][TILE], int vectors,
            int columns)
{
  QN_UNROLL
  for (int c = 0; c < columns; c++)
    QN_UNROLL
  for (int v = 0; v < vectors; v++)
    *(Vector *) (target + c * height + LANES * v) = sum[v][c];
}

/* A matrix of the right side of a product, and how far its rows and columns are apart: one of
 * them is 1. */
typedef struct {
  const double *numbers;
  int32_t row, column;
} Factor;

/* A tile of target = (add ? target : 0) - left * right */
PART void
subtract_tile (double *target, int32_t target_height, const double *left,
               int32_t left_height, Factor right, int32_t depth, bool add, int vectors,
               int columns)
{
  Vector sum[TALL][TILE] = { { { 0 } } };

  if (add)
    load_tile (sum, target, target_height, vectors, columns);
  subtract_in_tile (sum, left, left_height, right.numbers, right.row, right.column, depth,
                    vectors, columns);
  store_tile (target, target_height, sum, vectors, columns);
}

/* The same for all columns of one or two vectors of rows. */
PART void
subtract_rows (double *target, int32_t target_height, const double *left,
               int32_t left_height, Factor right, int32_t depth, int32_t columns,
               bool add, int vectors)
{
  while (columns > 0) {
    int32_t width = columns >= TILE ? TILE : columns >= TILE / 2 ? TILE / 2 : 1;
    if (width == TILE)
      subtract_tile (target, target_height, left, left_height, right, depth, add, vectors,
                     TILE);
    else if (width == TILE / 2)
      subtract_tile (target, target_height, left, left_height, right, depth, add, vectors,
                     TILE / 2);
    else
      subtract_tile (target, target_height, left, left_height, right, depth, add, vectors,
                     1);
    target += (size_t) width * (size_t) target_height;
    right.numbers += (size_t) width * (size_t) right.column;
    columns -= width;
  }
}

/* target (height x columns) -= left (height x depth) * right (depth x columns), or target =
 * - left * right. */
PART void
subtract_product (double *target, int32_t target_height, const double *left,
                  int32_t left_height, Factor right, int32_t height, int32_t depth,
                  int32_t columns, bool add)
{
  int32_t row = 0;

  for (; row + 2 * LANES <= height; row += 2 * LANES)
    subtract_rows (target + row, target_height, left + row, left_height, right, depth,
                   columns, add, 2);
  if (row < height)
    subtract_rows (target + row, target_height, left + row, left_height, right, depth,
                   columns, add, 1);
}

/* target -= factor * column */
PART void
subtract_column (double *target, const double *column, int32_t height, double factor)
{
  for (int32_t row = 0; row < height; row += LANES)
    *(Vector *) (target + row) -= *(const Vector *) (column + row) * factor;
}

PART void
scale_column (double *column, int32_t height, double factor)
{
  for (int32_t row = 0; row < height; row += LANES)
    *(Vector *) (column + row) *= factor;
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
  Vector sizes = { 0 };

  for (int32_t row = first; row < height; row += LANES) {
    Mask size = (Mask) * (const Vector *) (column + row) & INT64_MAX;
    Mask larger = (Vector) size > sizes;
    sizes = (Vector) ((size & larger) | ((Mask) sizes & ~larger));
  }
  for (int i = 0; i < LANES; i++)
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
  if (size == 0)
    front->diagonal[(size_t) j * (size_t) height + (size_t) j] = size = QN_FRONT_VANISHED;
  if (!(size <= 1e300))
    return false;
  range->smallest = size < range->smallest ? size : range->smallest;
  range->largest = size > range->largest ? size : range->largest;
  if (pivot != j)
    exchange_rows (front->diagonal, height, front->pivots, j, pivot);
  return true;
}

/* Eliminates columns first to end of D within those columns, and leaves one over the pivot in its
 * place. Rows above the pivot in its vector keep what they have: they are set to zero factors while
 * it is subtracted. */
PART bool
eliminate_strip (const QnDenseFront *front, int32_t height, int32_t first, int32_t end,
                 QnPivotRange *range)
{
  for (int32_t j = first; j < end; j++) {
    double *column = front->diagonal + (size_t) j * (size_t) height;
    if (!choose_pivot (front, height, first, j, range))
      return false;

    double factor = 1 / column[j];
    double head[STRIP] = { 0 };
    column[j] = factor;
    for (int32_t row = j + 1; row < first + STRIP; row++)
      head[row - first] = column[row] *= factor;
    scale_column (column + first + STRIP, height - first - STRIP, factor);
    for (int32_t c = j + 1; c < end; c++) {
      double *target = front->diagonal + (size_t) c * (size_t) height;
      double value = target[j];
      subtract_column (target + first, head, STRIP, value);
      subtract_column (target + first + STRIP, column + first + STRIP,
                       height - first - STRIP, value);
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
  Vector sum[STRIP_VECTORS][SUMS];

  QN_UNROLL
  for (int v = 0; v < STRIP_VECTORS; v++)
    QN_UNROLL
  for (int c = 0; c < columns; c++)
    sum[v][c] = *(const Vector *) (inverse + LANES * v) * target[c * height];
  for (int32_t j = 1; j < count; j++)
    QN_UNROLL
  for (int v = 0; v < STRIP_VECTORS; v++) {
    Vector factor = *(const Vector *) (inverse + STRIP * j + LANES * v);
    QN_UNROLL
    for (int c = 0; c < columns; c++)
      sum[v][c] += factor * target[c * height + j];
  }
  QN_UNROLL
  for (int v = 0; v < STRIP_VECTORS; v++)
    QN_UNROLL
  for (int c = 0; c < columns; c++)
    *(Vector *) (target + c * height + LANES * v) = sum[v][c];
}

/* Rows of a strip in all columns of U_1. */
PART void
solve_strip (const double inverse[STRIP * STRIP], int32_t count, double *target,
             int32_t height, int32_t columns)
{
  int32_t c = 0;

  for (; c + SUMS <= columns; c += SUMS)
    multiply_strip (inverse, count, target + (size_t) c * (size_t) height, height, SUMS);
  for (; c < columns; c++)
    multiply_strip (inverse, count, target + (size_t) c * (size_t) height, height, 1);
}

/* D = P' L_1 U_1 */
PART bool
eliminate_diagonal (const QnDenseFront *front, QnPivotRange *range)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots);
  double *d = front->diagonal, inverse[STRIP * STRIP];

  for (int32_t first = 0; first < pivots; first += STRIP) {
    int32_t next = first + STRIP, end = next < pivots ? next : pivots;
    double *strip = d + (size_t) first * (size_t) height;
    double *right = d + (size_t) end * (size_t) height;
    if (!eliminate_strip (front, height, first, end, range))
      return false;
    if (end == pivots)
      break;
    invert_strip (strip, height, first, end - first, inverse);
    solve_strip (inverse, end - first, right + first, height, pivots - end);
    subtract_product (right + next, height, strip + next, height,
                      (Factor){ right + first, 1, height }, height - next, STRIP,
                      pivots - end, true);
  }
  return true;
}

/* Columns `first` and so many more of a matrix X of the rest, in one tile of its rows: X = X T^-1,
 * where the columns before are done and T is upper triangular. `inverse`: of its diagonal, or NULL
 * where that is all one. */
PART void
divide_tile (double *x, int32_t height, Factor triangle, int32_t first, int vectors,
             int columns, const double *inverse, int32_t inverse_step)
{
  Vector sum[TALL][TILE];
  double *target = x + (size_t) first * (size_t) height;
  const double *right = triangle.numbers + (size_t) first * (size_t) triangle.column;

  load_tile (sum, target, height, vectors, columns);
  subtract_in_tile (sum, x, height, right, triangle.row, triangle.column, first, vectors,
                    columns);
  right += (size_t) first * (size_t) triangle.row;
  QN_UNROLL
  for (int c = 0; c < columns; c++) {
    if (inverse != NULL)
      QN_UNROLL
    for (int v = 0; v < vectors; v++)
      sum[v][c] *= inverse[(size_t) (first + c) * (size_t) inverse_step];
    QN_UNROLL
    for (int next = c + 1; next < columns; next++) {
      double value = right[c * triangle.row + next * triangle.column];
      QN_UNROLL
      for (int v = 0; v < vectors; v++)
        sum[v][next] -= sum[v][c] * value;
    }
  }
  store_tile (target, height, sum, vectors, columns);
}

PART void
divide_rows (double *x, int32_t height, Factor triangle, int32_t pivots, int vectors,
             const double *inverse, int32_t inverse_step)
{
  int32_t first = 0;

  for (; first + TILE / 2 <= pivots; first += TILE / 2)
    divide_tile (x, height, triangle, first, vectors, TILE / 2, inverse, inverse_step);
  for (; first < pivots; first++)
    divide_tile (x, height, triangle, first, vectors, 1, inverse, inverse_step);
}

/* X = X T^-1, all rows. */
PART void
divide (double *x, int32_t height, Factor triangle, int32_t pivots, const double *inverse,
        int32_t inverse_step)
{
  int32_t row = 0;

  for (; row + 4 * LANES <= height; row += 4 * LANES)
    divide_rows (x + row, height, triangle, pivots, 4, inverse, inverse_step);
  if (row + 2 * LANES <= height) {
    divide_rows (x + row, height, triangle, pivots, 2, inverse, inverse_step);
    row += 2 * LANES;
  }
  if (row < height)
    divide_rows (x + row, height, triangle, pivots, 1, inverse, inverse_step);
}

PART void
exchange_columns (double *matrix, int32_t height, int32_t one, int32_t other)
{
  double *a = matrix + (size_t) one * (size_t) height,
         *b = matrix + (size_t) other * (size_t) height;

  for (int32_t row = 0; row < height; row++) {
    double value = a[row];
    a[row] = b[row];
    b[row] = value;
  }
}

static bool
eliminate (const QnDenseFront *front, QnPivotRange *range)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots),
          low_height = qn_front_height (front->rest);
  const double *d = front->diagonal;

  if (!eliminate_diagonal (front, range))
    return false;
  for (int32_t j = 0; j < pivots; j++)
    if (front->exchanges[j] != j)
      exchange_columns (front->upper, low_height, j, front->exchanges[j]);
  divide (front->lower, low_height, (Factor){ d, 1, height }, pivots, d, height + 1);
  divide (front->upper, low_height, (Factor){ d, height, 1 }, pivots, NULL, 0);
  subtract_product (front->schur, low_height, front->lower, low_height,
                    (Factor){ front->upper, low_height, 1 }, low_height, pivots,
                    front->rest, false);
  return true;
}

/* --- Solution --------------------------------------------------------------------------- */

/* target (rows) += sign * columns * factors, one column after the other; they are so far apart. */
PART void
add_group (double *target, int32_t rows, const double *matrix, ptrdiff_t step,
           const double *factors, int factor_step, int columns, double sign)
{
  Vector factor[GROUP];

  QN_UNROLL
  for (int c = 0; c < columns; c++)
    factor[c] = sign * factors[c * factor_step] - (Vector){ 0 };
  for (int32_t row = 0; row < rows; row += LANES) {
    Vector sum = *(const Vector *) (target + row);
    QN_UNROLL
    for (int c = 0; c < columns; c++)
      sum += *(const Vector *) (matrix + c * step + row) * factor[c];
    *(Vector *) (target + row) = sum;
  }
}

/* The same for any number of columns, from the first on (direction 1) or the last (-1). */
PART void
add_groups (double *target, int32_t rows, const double *matrix, int32_t height,
            const double *factors, int32_t columns, int direction, double sign)
{
  ptrdiff_t step = direction * (ptrdiff_t) height;

  if (direction < 0 && columns > 0) { /* of no column there is no last one */
    matrix += (size_t) (columns - 1) * (size_t) height;
    factors += columns - 1;
  }
  while (columns > 0) {
    int width = columns >= 9 ? 9 : columns >= 6 ? 6 : columns >= 3 ? 3 : 1;
    if (width == 9)
      add_group (target, rows, matrix, step, factors, direction, 9, sign);
    else if (width == 6)
      add_group (target, rows, matrix, step, factors, direction, 6, sign);
    else if (width == 3)
      add_group (target, rows, matrix, step, factors, direction, 3, sign);
    else
      add_group (target, rows, matrix, step, factors, direction, 1, sign);
    matrix += width * step;
    factors += width * direction;
    columns -= width;
  }
}

/* x = L_1 \ x within a strip of so many columns. */
PART void
forward_in_strip (double *x, const double *strip, int32_t height, int columns)
{
  QN_UNROLL
  for (int j = 0; j < columns; j++)
    QN_UNROLL
  for (int row = j + 1; row < columns; row++)
    x[row] -= strip[j * height + row] * x[j];
}

static void
forward (const QnDenseFront *front, double *x, double *below)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots),
          low_height = qn_front_height (front->rest), first = 0;
  const double *strip = front->diagonal;

  for (int32_t j = 0; j < pivots; j++) {
    int32_t other = front->exchanges[j];
    double value = x[other];
    x[other] = x[j];
    x[j] = value;
  }
  for (; first + STRIP <= pivots; first += STRIP) {
    int32_t next = first + STRIP;
    double own[STRIP];
    memcpy (own, x + first, sizeof own);
    forward_in_strip (own, strip + first, height, STRIP);
    memcpy (x + first, own, sizeof own);
    add_group (x + next, height - next, strip + next, height, own, 1, STRIP, -1);
    strip += STRIP * (size_t) height;
  }
  forward_in_strip (x + first, strip + first, height, pivots - first);
  memset (below, 0, (size_t) low_height * sizeof *below);
  add_groups (below, low_height, front->lower, low_height, x, pivots, 1, 1);
}

/* x[0 to columns] -= matrix' * factors */
PART void
subtract_sums (double *x, const double *matrix, int32_t height, const double *factors,
               int columns)
{
  Vector sum[LANES][STRIP_VECTORS] = { { { 0 } } };

  for (int32_t row = 0; row < height; row += STRIP)
    QN_UNROLL
  for (int v = 0; v < STRIP_VECTORS; v++) {
    Vector factor = *(const Vector *) (factors + row + LANES * v);
    QN_UNROLL
    for (int c = 0; c < columns; c++)
      sum[c][v] += *(const Vector *) (matrix + c * height + row + LANES * v) * factor;
  }
  QN_UNROLL
  for (int c = 0; c < columns; c++) {
    double s[STRIP]; /* of every eighth row */
    memcpy (s, sum[c], sizeof s);
    x[c] -= ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  }
}

/* x = U_1 \ x within a strip of so many columns. */
PART void
backward_in_strip (double *x, const double *strip, int32_t height, int columns)
{
  QN_UNROLL
  for (int j = columns - 1; j >= 0; j--) {
    x[j] *= strip[j * height + j];
    QN_UNROLL
    for (int row = 0; row < j; row++)
      x[row] -= strip[j * height + row] * x[j];
  }
}

static void
backward (const QnDenseFront *front, double *x, const double *above)
{
  int32_t pivots = front->pivots, height = qn_front_height (pivots),
          low_height = qn_front_height (front->rest), c = 0,
          first = pivots / STRIP * STRIP;
  const double *upper = front->upper,
               *strip = front->diagonal + (size_t) first * (size_t) height;

  for (; c + LANES <= pivots; c += LANES, upper += LANES * (size_t) low_height)
    subtract_sums (x + c, upper, low_height, above, LANES);
  for (; c + LANES / 2 <= pivots;
       c += LANES / 2, upper += LANES / 2 * (size_t) low_height)
    subtract_sums (x + c, upper, low_height, above, LANES / 2);
  for (; c < pivots; c++, upper += low_height)
    subtract_sums (x + c, upper, low_height, above, 1);

  backward_in_strip (x + first, strip + first, height, pivots - first);
  add_groups (x, first, strip, height, x + first, pivots - first, -1, -1);
  while (first > 0) {
    first -= STRIP;
    strip -= STRIP * (size_t) height;
    double own[STRIP];
    memcpy (own, x + first, sizeof own);
    backward_in_strip (own, strip + first, height, STRIP);
    memcpy (x + first, own, sizeof own);
    add_group (x, first, strip + (STRIP - 1) * (size_t) height, -(ptrdiff_t) height,
               own + STRIP - 1, -1, STRIP, -1);
  }
}

const QnFrontLoops WITH_WIDTH (qn_front_loops) = { eliminate, forward, backward };
