#include "core/block-lu.h"

#include "core/memory.h"

#include <amd.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Unknowns of a body, and the height of a column of a block: one number of padding makes
 * columns as long as the widest registers. */
#define SIDE   3
#define STRIDE 4

typedef double Block[SIDE * STRIDE];

/* blocks[rows[p]] -= factors[p] * right, for all p < count */
typedef void (*SubtractProducts) (Block *blocks, const int32_t *rows,
                                  const Block *factors, int32_t count,
                                  const double *right);

struct QnBlockLu {
  int32_t n, node_count;
  const int32_t *ap, *ai;
  int32_t
    *slot; /* n: where an unknown stands: STRIDE x its node, in the order of P, + row */
  int32_t *unknown; /* node_count x SIDE: the reverse, -1 for padding */

  /* Pattern of L by columns. That of U is its transpose: column j of U has the rows k
   * listed from row_start[j], in ascending order. */
  int32_t *column_start, *rows;
  int32_t *row_start, *columns;

  Block *lower;     /* by columns of L */
  Block *upper;     /* by columns of U */
  Block *inverse;   /* of the diagonal blocks of U */
  Block *work;      /* node_count: one column of blocks, scattered; zero between calls */
  double *solution; /* node_count x STRIDE */
  SubtractProducts subtract_products;
};

/* --- The inner loop --------------------------------------------------------------------- */

typedef double Pair __attribute__ ((vector_size (16), aligned (8)));

static void
subtract_products_by_two (Block *blocks, const int32_t *rows, const Block *factors,
                          int32_t count, const double *right)
{
  for (int32_t p = 0; p < count; p++) {
    const double *factor = factors[p];
    double *target = blocks[rows[p]];
    for (int half = 0; half < STRIDE; half += 2) {
      Pair a = *(const Pair *) (factor + half);
      Pair b = *(const Pair *) (factor + STRIDE + half);
      Pair c = *(const Pair *) (factor + 2 * STRIDE + half);
      for (int column = 0; column < SIDE; column++) {
        const double *r = right + column * STRIDE;
        Pair *t = (Pair *) (target + column * STRIDE + half);
        *t -=
          a * (Pair){ r[0], r[0] } + b * (Pair){ r[1], r[1] } + c * (Pair){ r[2], r[2] };
      }
    }
  }
}

#if defined __x86_64__ && defined __GNUC__

typedef double Four __attribute__ ((vector_size (32), aligned (8)));

/* The same operations in the same order, four numbers at a time: results are equal to the
 * bit. */
__attribute__ ((target ("avx2"))) static void
subtract_products_by_four (Block *blocks, const int32_t *rows, const Block *factors,
                           int32_t count, const double *right)
{
  Four r[SIDE * SIDE];

  for (int column = 0; column < SIDE; column++)
    for (int row = 0; row < SIDE; row++) {
      double value = right[column * STRIDE + row];
      r[column * SIDE + row] = (Four){ value, value, value, value };
    }
  for (int32_t p = 0; p < count; p++) {
    const double *factor = factors[p];
    double *target = blocks[rows[p]];
    Four a = *(const Four *) factor;
    Four b = *(const Four *) (factor + STRIDE);
    Four c = *(const Four *) (factor + 2 * STRIDE);
    for (int column = 0; column < SIDE; column++) {
      Four *t = (Four *) (target + column * STRIDE);
      *t -= a * r[SIDE * column] + b * r[SIDE * column + 1] + c * r[SIDE * column + 2];
    }
  }
}

static SubtractProducts
fastest_inner_loop (void)
{
  return __builtin_cpu_supports ("avx2") ? subtract_products_by_four
                                         : subtract_products_by_two;
}

#else

static SubtractProducts
fastest_inner_loop (void)
{
  return subtract_products_by_two;
}

#endif

/* --- Analysis --------------------------------------------------------------------------- */

/* Pattern of a symmetric matrix of nodes in compressed columns. */
typedef struct {
  int32_t count;
  int32_t *start, *rows;
} Graph;

static bool
same_column (const QnBlockLu *lu, int32_t a, int32_t b)
{
  int32_t length = lu->ap[a + 1] - lu->ap[a];

  return length == lu->ap[b + 1] - lu->ap[b]
         && memcmp (lu->ai + lu->ap[a], lu->ai + lu->ap[b],
                    (size_t) length * sizeof *lu->ai)
              == 0;
}

/* Gathers neighbouring unknowns with equal columns in nodes: node[unknown]. Returns how many
 * nodes there are. */
static int32_t
gather_nodes (const QnBlockLu *lu, int32_t *node)
{
  int32_t count = 0;

  for (int32_t i = 0, first = 0; i < lu->n; i++) {
    if (i == 0 || i - first == SIDE || !same_column (lu, first, i)) {
      first = i;
      count++;
    }
    node[i] = count - 1;
  }
  return count;
}

/* The graph of the nodes, without loops. `marks` is scratch of one number a node. */
static void
fill_graph (const QnBlockLu *lu, const int32_t *node, int32_t *marks, Graph *graph)
{
  int32_t fill = 0;

  memset (marks, -1, (size_t) graph->count * sizeof *marks);
  for (int32_t i = 0; i < lu->n; i++) {
    int32_t k = node[i];
    if (i == 0 || node[i - 1] != k) {
      graph->start[k] = fill;
      marks[k] = k;
    }
    for (int32_t p = lu->ap[i]; p < lu->ap[i + 1]; p++) {
      int32_t neighbour = node[lu->ai[p]];
      if (marks[neighbour] != k) {
        marks[neighbour] = k;
        graph->rows[fill++] = neighbour;
      }
    }
  }
  graph->start[graph->count] = fill;
}

static int
compare_index (const void *a, const void *b)
{
  return *(const int32_t *) a - *(const int32_t *) b;
}

/* The rows of column j of L: the later neighbours of node j, and the rows of the columns that
 * it is the parent of in the elimination tree. `child` and `sibling` hold that tree. */
static int32_t
find_column (const QnBlockLu *lu, const Graph *graph, const int32_t *order,
             const int32_t *place, int32_t j, int32_t *marks, const int32_t *child,
             const int32_t *sibling, int32_t *out)
{
  int32_t length = 0;

  marks[j] = j;
  for (int32_t p = graph->start[order[j]]; p < graph->start[order[j] + 1]; p++) {
    int32_t i = place[graph->rows[p]];
    if (i > j && marks[i] != j) {
      marks[i] = j;
      out[length++] = i;
    }
  }
  for (int32_t c = child[j]; c != -1; c = sibling[c])
    for (int32_t p = lu->column_start[c]; p < lu->column_start[c + 1]; p++) {
      int32_t i = lu->rows[p];
      if (marks[i] != j) {
        marks[i] = j;
        out[length++] = i;
      }
    }
  qsort (out, (size_t) length, sizeof *out, compare_index);
  return length;
}

/* Fills column_start and rows. False when memory runs out. */
static bool
analyse_columns (QnBlockLu *lu, const Graph *graph, const int32_t *order,
                 const int32_t *place)
{
  size_t nodes = (size_t) lu->node_count, capacity = 0;
  int32_t *scratch = qn_alloc (4 * nodes + 1, sizeof *scratch);
  int32_t *marks = scratch, *child = scratch + nodes, *sibling = scratch + 2 * nodes,
          *column = scratch + 3 * nodes;

  if (scratch == NULL)
    return false;
  memset (scratch, -1, 3 * nodes * sizeof *scratch);
  for (int32_t j = 0; j < lu->node_count; j++) {
    int32_t start = lu->column_start[j];
    int32_t length =
      find_column (lu, graph, order, place, j, marks, child, sibling, column);
    int32_t *grown = qn_array_grow (lu->rows, &capacity, (size_t) start + (size_t) length,
                                    sizeof *grown);
    if (grown == NULL) {
      free (scratch);
      return false;
    }
    lu->rows = grown;
    memcpy (lu->rows + start, column, (size_t) length * sizeof *column);
    lu->column_start[j + 1] = start + length;
    if (length > 0) {
      sibling[j] = child[column[0]];
      child[column[0]] = j;
    }
  }
  free (scratch);
  return true;
}

/* The pattern of L by rows. False when memory runs out. */
static bool
transpose_columns (QnBlockLu *lu)
{
  int32_t count = lu->column_start[lu->node_count];

  lu->columns = qn_alloc ((size_t) count + 1, sizeof *lu->columns);
  if (lu->columns == NULL)
    return false;
  for (int32_t p = 0; p < count; p++)
    lu->row_start[lu->rows[p] + 1]++;
  for (int32_t j = 0; j < lu->node_count; j++)
    lu->row_start[j + 1] += lu->row_start[j];
  /* row_start[i] runs to the end of its row, and is then shifted back. */
  for (int32_t j = 0; j < lu->node_count; j++)
    for (int32_t p = lu->column_start[j]; p < lu->column_start[j + 1]; p++)
      lu->columns[lu->row_start[lu->rows[p]]++] = j;
  for (int32_t j = lu->node_count; j > 0; j--)
    lu->row_start[j] = lu->row_start[j - 1];
  lu->row_start[0] = 0;
  return true;
}

static void
place_unknowns (QnBlockLu *lu, const int32_t *node, const int32_t *place)
{
  for (int32_t k = 0; k < SIDE * lu->node_count; k++)
    lu->unknown[k] = -1;
  for (int32_t i = 0, first = 0; i < lu->n; i++) {
    if (i > 0 && node[i] != node[i - 1])
      first = i;
    lu->slot[i] = STRIDE * place[node[i]] + (i - first);
    lu->unknown[SIDE * place[node[i]] + (i - first)] = i;
  }
}

/* Ordering and symbolic factorisation. False when memory runs out. */
static bool
analyse (QnBlockLu *lu)
{
  size_t n = (size_t) lu->n;
  int32_t *node = qn_alloc (n, sizeof *node), *order = qn_alloc (n, sizeof *order),
          *place = qn_alloc (n, sizeof *place);
  Graph graph = { .start = qn_alloc (n + 1, sizeof *graph.start),
                  .rows = qn_alloc ((size_t) lu->ap[n], sizeof *graph.rows) };
  bool ok = node && order && place && graph.start && graph.rows;

  if (ok) {
    graph.count = lu->node_count = gather_nodes (lu, node);
    fill_graph (lu, node, place, &graph);
    ok = amd_order (graph.count, graph.start, graph.rows, order, NULL, NULL) >= AMD_OK;
  }
  if (ok) {
    size_t nodes = (size_t) lu->node_count;
    for (int32_t j = 0; j < lu->node_count; j++)
      place[order[j]] = j;
    lu->slot = qn_alloc (n, sizeof *lu->slot);
    lu->unknown = qn_alloc (SIDE * nodes, sizeof *lu->unknown);
    lu->column_start = qn_alloc (nodes + 1, sizeof *lu->column_start);
    lu->row_start = qn_alloc (nodes + 1, sizeof *lu->row_start);
    ok = lu->slot && lu->unknown && lu->column_start && lu->row_start
         && analyse_columns (lu, &graph, order, place) && transpose_columns (lu);
  }
  if (ok)
    place_unknowns (lu, node, place);
  free (node);
  free (order);
  free (place);
  free (graph.start);
  free (graph.rows);
  return ok;
}

QnBlockLu *
qn_block_lu_new (int32_t n, const int32_t *ap, const int32_t *ai)
{
  QnBlockLu *lu = qn_alloc (1, sizeof *lu);

  if (lu == NULL)
    return NULL;
  *lu =
    (QnBlockLu){ .n = n, .ap = ap, .ai = ai, .subtract_products = fastest_inner_loop () };
  bool ok = analyse (lu);
  if (ok) {
    size_t nodes = (size_t) lu->node_count,
           blocks = (size_t) lu->column_start[lu->node_count];
    lu->lower = qn_alloc (blocks + 1, sizeof *lu->lower);
    lu->upper = qn_alloc (blocks + 1, sizeof *lu->upper);
    lu->inverse = qn_alloc (nodes, sizeof *lu->inverse);
    lu->work = qn_alloc (nodes, sizeof *lu->work);
    lu->solution = qn_alloc (STRIDE * nodes, sizeof *lu->solution);
    ok = lu->lower && lu->upper && lu->inverse && lu->work && lu->solution;
  }
  if (!ok) {
    qn_block_lu_free (lu);
    return NULL;
  }
  return lu;
}

void
qn_block_lu_free (QnBlockLu *lu)
{
  if (lu == NULL)
    return;
  free (lu->slot);
  free (lu->unknown);
  free (lu->column_start);
  free (lu->rows);
  free (lu->row_start);
  free (lu->columns);
  free (lu->lower);
  free (lu->upper);
  free (lu->inverse);
  free (lu->work);
  free (lu->solution);
  free (lu);
}

/* --- Factorisation ---------------------------------------------------------------------- */

/* Inverts a block by Gauss-Jordan elimination with row exchanges; notes the sizes of its
 * pivots. False where a pivot is zero. */
static bool
invert (const double *block, double *inverse, double *smallest, double *largest)
{
  double a[SIDE][2 * SIDE];

  for (int r = 0; r < SIDE; r++)
    for (int c = 0; c < SIDE; c++) {
      a[r][c] = block[STRIDE * c + r];
      a[r][SIDE + c] = r == c;
    }
  for (int c = 0; c < SIDE; c++) {
    int pivot = c;
    for (int r = c + 1; r < SIDE; r++)
      if (fabs (a[r][c]) > fabs (a[pivot][c]))
        pivot = r;
    double size = fabs (a[pivot][c]);
    if (!(size > 0 && isfinite (size)))
      return false;
    *smallest = fmin (*smallest, size);
    *largest = fmax (*largest, size);
    for (int k = 0; k < 2 * SIDE; k++) {
      double value = a[pivot][k];
      a[pivot][k] = a[c][k];
      a[c][k] = value;
    }
    for (int r = 0; r < SIDE; r++) {
      double factor = r == c ? 0 : a[r][c] / a[c][c];
      for (int k = c; k < 2 * SIDE; k++)
        a[r][k] -= factor * a[c][k];
    }
  }
  for (int r = 0; r < SIDE; r++)
    for (int c = 0; c < SIDE; c++)
      inverse[STRIDE * c + r] = a[r][SIDE + c] / a[r][r];
  return true;
}

/* Puts column j of P A P' into the work column. */
static void
scatter_column (QnBlockLu *lu, const double *ax, int32_t j)
{
  double *work = &lu->work[0][0];

  for (int c = 0; c < SIDE; c++) {
    int32_t unknown = lu->unknown[SIDE * j + c];
    if (unknown == -1)
      continue;
    for (int32_t p = lu->ap[unknown]; p < lu->ap[unknown + 1]; p++) {
      int32_t slot = lu->slot[lu->ai[p]];
      work[SIDE * STRIDE * (slot / STRIDE) + STRIDE * c + slot % STRIDE] = ax[p];
    }
  }
}

/* Padding has no entries: it takes the size of the node's first column. */
static void
pad_diagonal (const QnBlockLu *lu, int32_t j, double *block)
{
  double size = fmax (fabs (block[0]), fmax (fabs (block[1]), fabs (block[2])));

  for (int c = 1; c < SIDE; c++)
    if (lu->unknown[SIDE * j + c] == -1)
      block[STRIDE * c + c] = size;
}

/* out = left * right */
static void
multiply (const double *left, const double *right, double *out)
{
  for (int c = 0; c < SIDE; c++)
    for (int r = 0; r < STRIDE; r++)
      out[STRIDE * c + r] = left[r] * right[STRIDE * c]
                            + left[STRIDE + r] * right[STRIDE * c + 1]
                            + left[2 * STRIDE + r] * right[STRIDE * c + 2];
}

double
qn_block_lu_factor (QnBlockLu *lu, const double *ax)
{
  double smallest = INFINITY, largest = 0;

  for (int32_t j = 0; j < lu->node_count; j++) {
    scatter_column (lu, ax, j);
    for (int32_t q = lu->row_start[j]; q < lu->row_start[j + 1]; q++) {
      int32_t k = lu->columns[q], first = lu->column_start[k];
      memcpy (lu->upper[q], lu->work[k], sizeof (Block));
      memset (lu->work[k], 0, sizeof (Block));
      lu->subtract_products (lu->work, lu->rows + first,
                             (const Block *) lu->lower + first,
                             lu->column_start[k + 1] - first, lu->upper[q]);
    }

    pad_diagonal (lu, j, lu->work[j]);
    bool regular = invert (lu->work[j], lu->inverse[j], &smallest, &largest);
    memset (lu->work[j], 0, sizeof (Block));
    for (int32_t p = lu->column_start[j]; p < lu->column_start[j + 1]; p++) {
      double *block = lu->work[lu->rows[p]];
      if (regular)
        multiply (block, lu->inverse[j], lu->lower[p]);
      memset (block, 0, sizeof (Block));
    }
    if (!regular)
      return 0;
  }
  return largest > 0 ? smallest / largest : 1;
}

/* --- Solution --------------------------------------------------------------------------- */

/* y -= block * x */
static inline void
subtract_product (const double *block, const double *x, double *y)
{
  for (int r = 0; r < SIDE; r++)
    y[r] -= block[r] * x[0] + block[STRIDE + r] * x[1] + block[2 * STRIDE + r] * x[2];
}

void
qn_block_lu_solve (QnBlockLu *lu, double *b)
{
  double *x = lu->solution;

  memset (x, 0, STRIDE * (size_t) lu->node_count * sizeof *x);
  for (int32_t i = 0; i < lu->n; i++)
    x[lu->slot[i]] = b[i];
  for (int32_t j = 0; j < lu->node_count; j++) /* x = L\x */
    for (int32_t p = lu->column_start[j]; p < lu->column_start[j + 1]; p++)
      subtract_product (lu->lower[p], x + STRIDE * j, x + STRIDE * lu->rows[p]);
  for (int32_t j = lu->node_count - 1; j >= 0; j--) { /* x = U\x */
    double y[SIDE] = { 0 };
    subtract_product (lu->inverse[j], x + STRIDE * j, y);
    for (int r = 0; r < SIDE; r++)
      x[STRIDE * j + r] = -y[r];
    for (int32_t q = lu->row_start[j]; q < lu->row_start[j + 1]; q++)
      subtract_product (lu->upper[q], x + STRIDE * j, x + STRIDE * lu->columns[q]);
  }
  for (int32_t i = 0; i < lu->n; i++)
    b[i] = x[lu->slot[i]];
}

/* det A = product of the determinants of U's diagonal blocks: rows and columns are permuted
 * alike, and padding is positive. */
int
qn_block_lu_sign (const QnBlockLu *lu)
{
  int sign = 1;

  for (int32_t j = 0; j < lu->node_count; j++) {
    const double *a = lu->inverse[j], *b = a + STRIDE, *c = b + STRIDE;
    double determinant = a[0] * (b[1] * c[2] - b[2] * c[1])
                         - a[1] * (b[0] * c[2] - b[2] * c[0])
                         + a[2] * (b[0] * c[1] - b[1] * c[0]);
    sign = determinant < 0 ? -sign : sign;
  }
  return sign;
}
