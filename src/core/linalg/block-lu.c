#include "core/linalg/block-lu.h"

#include "core/base/memory.h"
#include "core/linalg/dense-front.h"
#include "core/linalg/front-tree.h"
#include "core/linalg/sparse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A front's matrices, in QnBlockLu.numbers: D, L, U and S one after the other. */
typedef struct {
  size_t diagonal, lower, upper, schur;
  int32_t first_entry;      /* of A's, in QnBlockLu.sources */
  int32_t first_place;      /* of its pivots, in QnBlockLu.solution */
  int32_t pivots_of_parent; /* how much of its rest are pivots of the parent */
  double work;              /* of its elimination: multiplications, about */
  int32_t inside;           /* how much of its rest is eliminated in its own part */
  bool changed;             /* by the factorisation in progress */
  QnPivotRange range;
} Matrices;

/* A subtree of fronts that is eliminated and solved with apart from all others. */
typedef struct {
  int32_t first, end; /* fronts */
  size_t scratch;     /* its place in QnBlockLu.scratch */
  bool regular;       /* every pivot of the factorisation in progress is a number */
} Part;

/* Trees that take more work than this (a millisecond) are taken to parts. */
#define WORK_TO_SHARE 3e7
/* A part is at most so much of the whole: few enough to be even, large enough for more than one. */
#define PART_OF_WORK 0.0625

struct QnBlockLu {
  QnPool pool; /* of all but the tree */
  QnFrontTree tree;
  const QnWorkers *workers;
  const QnFrontLoops *loops;
  Matrices *matrices; /* front_count + 1 */
  double *numbers;
  double work;
  bool whole; /* every front is that of the values that were last seen */

  /* Every front is in a part or above them all. */
  Part *parts;
  int32_t part_count;
  int32_t *top; /* the fronts above, in order */
  int32_t top_count;
  const double *ax; /* of the factorisation in progress */

  /* The entries of A by the front that they come into: where they stand in ax, their values,
   * and where they go, counted from D. */
  int32_t *sources, *places;
  double *values;

  int32_t *exchanges; /* n */

  /* In order of elimination, with the padding of each front's pivots; where it holds each unknown
   * and those of the rests. What a part takes off unknowns above it is summed up in `outside`: for
   * these, rest_places counts there, and outside_places says where the solution holds them. */
  double *solution, *outside;
  size_t solution_size, outside_count;
  int32_t *unknown_places, *rest_places, *outside_places;
  double
    *scratch; /* for the rest of one front, with padding: of each part, and above them */
  size_t scratch_above;
};

/* --- Setting up ------------------------------------------------------------------------- */

static size_t
matrix_size (int32_t rows, int32_t columns)
{
  return (size_t) qn_front_height (rows) * (size_t) columns;
}

/* Lays out the matrices of all fronts; returns how many numbers they are. */
static size_t
lay_out_matrices (QnBlockLu *lu)
{
  size_t sum = 0;

  for (int32_t f = 0; f < lu->tree.front_count; f++) {
    const QnFront *front = &lu->tree.fronts[f];
    Matrices *m = &lu->matrices[f];
    double pivots = front->pivots, rest = front->rest;
    m->diagonal = sum;
    m->lower = m->diagonal + matrix_size (front->pivots, front->pivots);
    m->upper = m->lower + matrix_size (front->rest, front->pivots);
    m->schur = m->upper + matrix_size (front->rest, front->pivots);
    sum = m->schur + matrix_size (front->rest, front->rest);
    m->work = pivots * (pivots * (pivots / 3 + rest) + rest * rest);
    lu->work += m->work;
    m->first_place = (int32_t) lu->solution_size;
    lu->solution_size += matrix_size (front->pivots, 1);
    while (m->pivots_of_parent < front->rest
           && lu->tree.places[front->first_row + m->pivots_of_parent]
                < lu->tree.fronts[front->parent].pivots)
      m->pivots_of_parent++;
  }
  return sum;
}

/* Takes the forest to parts, the largest subtrees of at most their share of the work. Where all of it
 * is little work, these are its trees. */
static void
lay_out_parts (QnBlockLu *lu, QnPool *room)
{
  const QnFrontTree *tree = &lu->tree;
  size_t count = (size_t) tree->front_count;
  double most = lu->work > WORK_TO_SHARE ? PART_OF_WORK * lu->work : INFINITY;
  double *work = qn_pool_alloc (room, count, sizeof *work); /* of each front's subtree, */
  int32_t *first = qn_pool_alloc (room, count, sizeof *first); /* and its first front */
  lu->parts = qn_pool_alloc (&lu->pool, count, sizeof *lu->parts);
  lu->top = qn_pool_alloc (&lu->pool, count, sizeof *lu->top);

  if (room->failed || lu->pool.failed)
    return;
  for (int32_t f = 0; f < tree->front_count; f++)
    first[f] = f;
  for (int32_t f = 0; f < tree->front_count; f++) {
    int32_t parent = tree->fronts[f].parent;
    work[f] += lu->matrices[f].work;
    if (parent != QN_NONE) {
      work[parent] += work[f];
      first[parent] = first[f] < first[parent] ? first[f] : first[parent];
    }
  }
  for (int32_t f = 0; f < tree->front_count; f++) {
    int32_t parent = tree->fronts[f].parent;
    if (work[f] > most)
      lu->top[lu->top_count++] = f;
    else if (parent == QN_NONE || work[parent] > most)
      lu->parts[lu->part_count++] = (Part){ .first = first[f], .end = f + 1 };
  }
}

/* Where in `front`, counted from D, the entry at these two places goes: pivots first, then the
 * rest. */
static int32_t
place_in_front (const QnFront *front, const Matrices *m, int32_t row, int32_t column)
{
  int32_t pivots = front->pivots, height = qn_front_height (front->rest);

  if (column >= pivots)
    return (int32_t) (m->upper - m->diagonal) + row * height + column - pivots;
  if (row < pivots)
    return column * qn_front_height (pivots) + row;
  return (int32_t) (m->lower - m->diagonal) + column * height + row - pivots;
}

/* Lists the entries that come into a front: all that share a pivot of it with one of its
 * unknowns. `unknown`: the reverse of tree.position; `mirror`: where the transpose of an entry
 * stands; `where`: of every position in this front, valid where >= 0. */
static int32_t
list_entries (QnBlockLu *lu, const int32_t *ap, const int32_t *ai, int32_t f,
              const int32_t *unknown, const int32_t *mirror, const int32_t *where,
              int32_t fill)
{
  const QnFront *front = &lu->tree.fronts[f];
  const Matrices *m = &lu->matrices[f];

  for (int32_t c = 0; c < front->pivots; c++) {
    int32_t j = unknown[front->first + c];
    for (int32_t p = ap[j]; p < ap[j + 1]; p++) {
      int32_t position = lu->tree.position[ai[p]];
      if (position < front->first)
        continue;
      int32_t row = where[position];
      lu->sources[fill] = p;
      lu->places[fill++] = place_in_front (front, m, row, c);
      if (row >= front->pivots) {
        lu->sources[fill] = mirror[p];
        lu->places[fill++] = place_in_front (front, m, c, row);
      }
    }
  }
  return fill;
}

static void
list_all_entries (QnBlockLu *lu, const int32_t *ap, const int32_t *ai, QnPool *room)
{
  const QnFrontTree *tree = &lu->tree;
  size_t n = (size_t) tree->n;
  int32_t fill = 0;
  int32_t *unknown = qn_pool_alloc (room, n, sizeof *unknown),
          *where = qn_pool_alloc (room, n, sizeof *where),
          *mirror = qn_pool_alloc (room, (size_t) ap[n], sizeof *mirror);

  if (room->failed)
    return;
  qn_sparse_mirror (tree->n, ap, ai, where, mirror);
  for (int32_t i = 0; i < tree->n; i++)
    unknown[tree->position[i]] = i;
  for (int32_t f = 0; f < tree->front_count; f++) {
    const QnFront *front = &tree->fronts[f];
    for (int32_t c = 0; c < front->pivots; c++)
      where[front->first + c] = c;
    for (int32_t r = 0; r < front->rest; r++)
      where[tree->rows[front->first_row + r]] = front->pivots + r;
    lu->matrices[f].first_entry = fill;
    fill = list_entries (lu, ap, ai, f, unknown, mirror, where, fill);
  }
  lu->matrices[tree->front_count].first_entry = fill;
}

/* Makes room for the rest of one of the fronts. */
static void
widen_scratch (const QnBlockLu *lu, int32_t f, size_t begin, size_t *end)
{
  size_t size = matrix_size (lu->tree.fronts[f].rest, 1);

  *end = size > *end - begin ? begin + size : *end;
}

static void
lay_out_scratch (QnBlockLu *lu)
{
  size_t end = 0;

  for (Part *part = lu->parts; part < lu->parts + lu->part_count; part++) {
    part->scratch = end;
    for (int32_t f = part->first; f < part->end; f++)
      widen_scratch (lu, f, part->scratch, &end);
  }
  lu->scratch_above = end;
  for (int32_t t = 0; t < lu->top_count; t++)
    widen_scratch (lu, lu->top[t], lu->scratch_above, &end);
  lu->scratch = qn_pool_lines (&lu->pool, end, sizeof *lu->scratch);
}

/* Finds the places of all unknowns in the solution. */
static void
lay_out_solution (QnBlockLu *lu, QnPool *room)
{
  const QnFrontTree *tree = &lu->tree;
  size_t n = (size_t) tree->n, rests = 0, outside = 0;
  for (int32_t f = 0; f < tree->front_count; f++)
    rests += (size_t) tree->fronts[f].rest;
  for (int32_t p = 0; p < lu->part_count; p++)
    outside += (size_t) tree->fronts[lu->parts[p].end - 1].rest;
  int32_t *place = qn_pool_alloc (room, n, sizeof *place),
          *where = qn_pool_alloc (room, n, sizeof *where);

  lu->solution = qn_pool_lines (&lu->pool, lu->solution_size, sizeof *lu->solution);
  lu->outside = qn_pool_alloc (&lu->pool, outside, sizeof *lu->outside);
  lu->unknown_places = qn_pool_alloc (&lu->pool, n, sizeof *lu->unknown_places);
  lu->rest_places = qn_pool_alloc (&lu->pool, rests, sizeof *lu->rest_places);
  lu->outside_places = qn_pool_alloc (&lu->pool, outside, sizeof *lu->outside_places);
  if (room->failed || lu->pool.failed)
    return;
  for (int32_t f = 0; f < tree->front_count; f++)
    for (int32_t c = 0; c < tree->fronts[f].pivots; c++)
      place[tree->fronts[f].first + c] = lu->matrices[f].first_place + c;
  for (int32_t i = 0; i < tree->n; i++)
    lu->unknown_places[i] = place[tree->position[i]];
  for (int32_t p = 0; p < lu->part_count; p++) {
    /* The rests of a part's fronts lie in the solution, or in what is summed up beside it. */
    const Part *part = &lu->parts[p];
    const QnFront *root = &tree->fronts[part->end - 1];
    for (int32_t r = 0; r < root->rest; r++) {
      int32_t row = tree->rows[root->first_row + r];
      where[row] = (int32_t) lu->outside_count;
      lu->outside_places[lu->outside_count++] = place[row];
    }
    for (int32_t f = part->first; f < part->end; f++) {
      const QnFront *front = &tree->fronts[f];
      const int32_t *rows = tree->rows + front->first_row;
      int32_t *inside = &lu->matrices[f].inside;
      while (*inside < front->rest && rows[*inside] < root->first + root->pivots)
        ++*inside;
      for (int32_t r = 0; r < front->rest; r++)
        lu->rest_places[front->first_row + r] = (r < *inside ? place : where)[rows[r]];
    }
  }
  for (int32_t t = 0; t < lu->top_count; t++) {
    const QnFront *front = &tree->fronts[lu->top[t]];
    lu->matrices[lu->top[t]].inside = front->rest;
    for (int32_t r = front->first_row; r < front->first_row + front->rest; r++)
      lu->rest_places[r] = place[tree->rows[r]];
  }
}

/* `room`: of what is needed here alone. */
static bool
set_up (QnBlockLu *lu, int32_t n, const int32_t *ap, const int32_t *ai, QnPool *room)
{
  size_t entries = (size_t) ap[n];

  if (!qn_front_tree_init (&lu->tree, n, ap, ai))
    return false;
  lu->matrices =
    qn_pool_alloc (&lu->pool, (size_t) lu->tree.front_count + 1, sizeof *lu->matrices);
  lu->sources = qn_pool_alloc (&lu->pool, entries, sizeof *lu->sources);
  lu->places = qn_pool_alloc (&lu->pool, entries, sizeof *lu->places);
  lu->values = qn_pool_alloc (&lu->pool, entries, sizeof *lu->values);
  lu->exchanges = qn_pool_alloc (&lu->pool, (size_t) n, sizeof *lu->exchanges);
  if (lu->pool.failed)
    return false;
  lu->numbers = qn_pool_lines (&lu->pool, lay_out_matrices (lu), sizeof *lu->numbers);
  lay_out_parts (lu, room);
  if (room->failed || lu->pool.failed)
    return false;
  lay_out_scratch (lu);
  lay_out_solution (lu, room);
  list_all_entries (lu, ap, ai, room);
  return !room->failed && !lu->pool.failed;
}

QnBlockLu *
qn_block_lu_new (int32_t n, const int32_t *ap, const int32_t *ai,
                 const QnWorkers *workers)
{
  QnBlockLu *lu = qn_alloc (1, sizeof *lu);
  QnPool room = { 0 };

  if (lu == NULL)
    return NULL;
  lu->loops = qn_front_loops (QN_FRONT_ROWS);
  lu->workers = workers;
  bool done = set_up (lu, n, ap, ai, &room);
  qn_pool_clear (&room);
  if (done)
    return lu;
  qn_block_lu_free (lu);
  return NULL;
}

void
qn_block_lu_free (QnBlockLu *lu)
{
  if (lu == NULL)
    return;
  qn_front_tree_clear (&lu->tree);
  qn_pool_clear (&lu->pool);
  free (lu);
}

/* --- Factorisation ---------------------------------------------------------------------- */

static QnDenseFront
dense_front (const QnBlockLu *lu, int32_t f)
{
  const QnFront *front = &lu->tree.fronts[f];
  const Matrices *m = &lu->matrices[f];

  return (QnDenseFront){ .pivots = front->pivots,
                         .rest = front->rest,
                         .diagonal = lu->numbers + m->diagonal,
                         .lower = lu->numbers + m->lower,
                         .upper = lu->numbers + m->upper,
                         .schur = lu->numbers + m->schur,
                         .exchanges = lu->exchanges + front->first };
}

/* Whether any of the values of A that come into a front is new. */
static bool
has_new_values (const QnBlockLu *lu, int32_t f)
{
  const double *ax = lu->ax;
  int32_t e = lu->matrices[f].first_entry, end = lu->matrices[f + 1].first_entry;

  while (e < end && ax[lu->sources[e]] == lu->values[e])
    e++;
  return e < end;
}

/* Adds the rest of a child to its parent: to D, L and U before their elimination, to S after it. */
static void
add_rest (const QnBlockLu *lu, int32_t c, const QnDenseFront *front, bool eliminated)
{
  const QnFront *child = &lu->tree.fronts[c];
  const int32_t *places = lu->tree.places + child->first_row, pivots = front->pivots;
  const int32_t known = lu->matrices[c].pivots_of_parent;
  const double *schur = dense_front (lu, c).schur;

  for (int32_t j = eliminated ? known : 0; j < child->rest; j++) {
    const double *column = schur + matrix_size (child->rest, j);
    if (j < known) {
      double *diagonal = front->diagonal + matrix_size (pivots, places[j]);
      double *lower = front->lower + matrix_size (front->rest, places[j]);
      for (int32_t r = 0; r < known; r++)
        diagonal[places[r]] += column[r];
      for (int32_t r = known; r < child->rest; r++)
        lower[places[r] - pivots] += column[r];
    } else if (!eliminated) {
      double *upper = front->upper + (places[j] - pivots);
      for (int32_t r = 0; r < known; r++)
        upper[matrix_size (front->rest, places[r])] += column[r];
    } else {
      double *target = front->schur + matrix_size (front->rest, places[j] - pivots);
      for (int32_t r = known; r < child->rest; r++)
        target[places[r] - pivots] += column[r];
    }
  }
}

static bool
factor_front (QnBlockLu *lu, int32_t f)
{
  Matrices *m = &lu->matrices[f];
  QnDenseFront front = dense_front (lu, f);

  memset (front.diagonal, 0, (m->schur - m->diagonal) * sizeof (double));
  /* The values of A that come into the front are kept for comparison. */
  for (int32_t e = m->first_entry; e < lu->matrices[f + 1].first_entry; e++)
    front.diagonal[lu->places[e]] = lu->values[e] = lu->ax[lu->sources[e]];
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    add_rest (lu, c, &front, false);
  m->range = (QnPivotRange){ INFINITY, 0 };
  if (!lu->loops->eliminate (&front, &m->range))
    return false;
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    add_rest (lu, c, &front, true);
  return true;
}

/* Eliminates a front anew where a child was, or a value is new. False where a pivot is no number. */
static bool
update_front (QnBlockLu *lu, int32_t f)
{
  Matrices *m = &lu->matrices[f];

  m->changed = !lu->whole;
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    m->changed |= lu->matrices[c].changed;
  m->changed = m->changed || has_new_values (lu, f);
  return !m->changed || factor_front (lu, f);
}

static void
factor_part (void *data, int32_t p)
{
  QnBlockLu *lu = data;
  Part *part = &lu->parts[p];

  part->regular = true;
  for (int32_t f = part->first; f < part->end && part->regular; f++)
    part->regular = update_front (lu, f);
}

double
qn_block_lu_refactor (QnBlockLu *lu, const double *ax, double *work)
{
  QnPivotRange range = { INFINITY, 0 };
  double done = 0;
  bool regular = true;

  lu->ax = ax;
  qn_workers_run (lu->workers, lu->part_count, factor_part, lu);
  for (int32_t p = 0; p < lu->part_count; p++)
    regular = regular && lu->parts[p].regular;
  for (int32_t t = 0; t < lu->top_count && regular; t++)
    regular = update_front (lu, lu->top[t]);
  for (int32_t f = 0; f < lu->tree.front_count && regular; f++) {
    const Matrices *m = &lu->matrices[f];
    done += m->changed ? m->work : 0;
    range.smallest = fmin (m->range.smallest, range.smallest);
    range.largest = fmax (m->range.largest, range.largest);
  }
  lu->whole = regular;
  *work = !regular ? 1 : lu->work > 0 ? done / lu->work : 0;
  if (!regular)
    return 0;
  return range.largest > 0 ? range.smallest / range.largest : 1;
}

double
qn_block_lu_factor (QnBlockLu *lu, const double *ax)
{
  double work;

  lu->whole = false;
  return qn_block_lu_refactor (lu, ax, &work);
}

/* --- Solution --------------------------------------------------------------------------- */

/* x = L\x for one front. */
static void
forward (QnBlockLu *lu, int32_t f, double *scratch)
{
  QnDenseFront front = dense_front (lu, f);
  const int32_t *places = lu->rest_places + lu->tree.fronts[f].first_row;
  int32_t inside = lu->matrices[f].inside;

  lu->loops->forward (&front, lu->solution + lu->matrices[f].first_place, scratch);
  for (int32_t r = 0; r < inside; r++)
    lu->solution[places[r]] -= scratch[r];
  for (int32_t r = inside; r < front.rest; r++)
    lu->outside[places[r]] -= scratch[r];
}

/* x = U\x for one front. */
static void
backward (QnBlockLu *lu, int32_t f, double *scratch)
{
  QnDenseFront front = dense_front (lu, f);
  const int32_t *places = lu->rest_places + lu->tree.fronts[f].first_row;
  int32_t inside = lu->matrices[f].inside;

  for (int32_t r = 0; r < inside; r++)
    scratch[r] = lu->solution[places[r]];
  for (int32_t r = inside; r < front.rest; r++)
    scratch[r] = lu->solution[lu->outside_places[places[r]]];
  for (int32_t r = front.rest; r < qn_front_height (front.rest); r++)
    scratch[r] = 0;
  lu->loops->backward (&front, lu->solution + lu->matrices[f].first_place, scratch);
}

static void
forward_part (void *data, int32_t p)
{
  QnBlockLu *lu = data;
  const Part *part = &lu->parts[p];

  for (int32_t f = part->first; f < part->end; f++)
    forward (lu, f, lu->scratch + part->scratch);
}

static void
backward_part (void *data, int32_t p)
{
  QnBlockLu *lu = data;
  const Part *part = &lu->parts[p];

  for (int32_t f = part->end - 1; f >= part->first; f--)
    backward (lu, f, lu->scratch + part->scratch);
}

void
qn_block_lu_solve (QnBlockLu *lu, double *b)
{
  double *x = lu->solution;

  memset (x, 0, lu->solution_size * sizeof *x);
  memset (lu->outside, 0, lu->outside_count * sizeof *lu->outside);
  for (int32_t i = 0; i < lu->tree.n; i++)
    x[lu->unknown_places[i]] = b[i];
  qn_workers_run (lu->workers, lu->part_count, forward_part, lu);
  for (size_t k = 0; k < lu->outside_count; k++)
    x[lu->outside_places[k]] += lu->outside[k];
  for (int32_t t = 0; t < lu->top_count; t++)
    forward (lu, lu->top[t], lu->scratch + lu->scratch_above);
  for (int32_t t = lu->top_count - 1; t >= 0; t--)
    backward (lu, lu->top[t], lu->scratch + lu->scratch_above);
  qn_workers_run (lu->workers, lu->part_count, backward_part, lu);
  for (int32_t i = 0; i < lu->tree.n; i++)
    b[i] = x[lu->unknown_places[i]];
}

/* det A = product of the determinants of D: unknowns are permuted alike as rows and columns. */
int
qn_block_lu_sign (const QnBlockLu *lu)
{
  int sign = 1;

  for (int32_t f = 0; f < lu->tree.front_count; f++) {
    QnDenseFront front = dense_front (lu, f);
    int32_t height = qn_front_height (front.pivots);
    for (int32_t j = 0; j < front.pivots; j++) {
      if (front.diagonal[(size_t) j * (size_t) height + (size_t) j] < 0)
        sign = -sign;
      if (front.exchanges[j] != j)
        sign = -sign;
    }
  }
  return sign;
}
