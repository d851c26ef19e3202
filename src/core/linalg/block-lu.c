#include "core/linalg/block-lu.h"

#include "core/base/memory.h"
#include "core/linalg/dense-front.h"
#include "core/linalg/front-tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A front's matrices, in QnBlockLu.numbers: D, L and U one after the other. S stands in a place of
 * its own where it is kept, or where others have stood before it and will after it, which is
 * nearer to the processor. */
typedef struct {
  size_t diagonal, lower, upper, end;
  size_t schur, passing_schur;
  int32_t first_entry;      /* of A's, in QnBlockLu.sources */
  int32_t first_place;      /* of its pivots, in QnBlockLu.solution */
  int32_t pivots_of_parent; /* how much of its rest are pivots of the parent */
  double work;              /* of its elimination, any unit */
  bool odd;                 /* depth in the tree */
  bool changed;             /* by the factorisation in progress */
  QnPivotRange range;
} Matrices;

struct QnBlockLu {
  QnFrontTree tree;
  const QnFrontLoops *loops;
  Matrices *matrices; /* front_count + 1 */
  double *numbers;
  double work;
  bool whole;   /* every front is that of the values that were last seen */
  bool passing; /* no rest is kept in the factorisation in progress */

  /* The entries of A by the front that they come into: where they stand in ax, their values,
   * and where they go, counted from D. */
  int32_t *sources, *places;
  double *values;

  int32_t *exchanges; /* n */

  /* In order of elimination, with the padding of each front's pivots; where it holds each unknown
   * and those of the rests. */
  double *solution;
  size_t solution_size;
  int32_t *unknown_places, *rest_places;
  double *rest; /* of one front, with padding */
};

/* --- Setting up ------------------------------------------------------------------------- */

static size_t
matrix_size (int32_t rows, int32_t columns)
{
  return (size_t) qn_front_height (rows) * (size_t) columns;
}

/* Lays out D, L and U of all fronts; returns how many numbers they are. *longest: most unknowns in
 * the rest of a front. */
static size_t
lay_out_factors (QnBlockLu *lu, int32_t *longest)
{
  size_t sum = 0;

  *longest = 0;
  for (int32_t f = 0; f < lu->tree.front_count; f++) {
    const QnFront *front = &lu->tree.fronts[f];
    Matrices *m = &lu->matrices[f];
    double pivots = front->pivots, rest = front->rest;
    m->diagonal = sum;
    m->lower = m->diagonal + matrix_size (front->pivots, front->pivots);
    m->upper = m->lower + matrix_size (front->rest, front->pivots);
    m->end = m->upper + matrix_size (front->rest, front->pivots);
    sum = m->end;
    m->work = pivots * (pivots * (pivots / 3 + rest) + rest * rest);
    lu->work += m->work;
    *longest = front->rest > *longest ? front->rest : *longest;
    m->first_place = (int32_t) lu->solution_size;
    lu->solution_size += matrix_size (front->pivots, 1);
    while (m->pivots_of_parent < front->rest
           && lu->tree.places[front->first_row + m->pivots_of_parent]
                < lu->tree.fronts[front->parent].pivots)
      m->pivots_of_parent++;
  }
  return sum;
}

/* Lays out S of all fronts in so many numbers from `begin`, which are returned. Where it is not
 * kept, it waits for the parent on one of two stacks, of even and of odd depths, which grow
 * towards each other: fronts come right after their children's subtrees, so that the children's
 * are on top of theirs. */
static size_t
lay_out_rests (QnBlockLu *lu, size_t begin)
{
  const QnFrontTree *tree = &lu->tree;
  size_t sum = begin, low = begin, high;

  for (int32_t f = tree->front_count - 1; f >= 0; f--) {
    const QnFront *front = &tree->fronts[f];
    lu->matrices[f].odd = front->parent != QN_NONE && !lu->matrices[front->parent].odd;
  }
  for (int32_t f = 0; f < tree->front_count; f++) {
    lu->matrices[f].schur = sum;
    sum += matrix_size (tree->fronts[f].rest, tree->fronts[f].rest);
  }
  high = sum;
  for (int32_t f = 0; f < tree->front_count; f++) {
    Matrices *m = &lu->matrices[f];
    size_t size = matrix_size (tree->fronts[f].rest, tree->fronts[f].rest);
    m->passing_schur = m->odd ? high - size : low;
    *(m->odd ? &high : &low) = m->odd ? high - size : low + size;
    for (int32_t c = tree->fronts[f].child; c != QN_NONE; c = tree->fronts[c].sibling) {
      size = matrix_size (tree->fronts[c].rest, tree->fronts[c].rest);
      *(m->odd ? &low : &high) = m->odd ? low - size : high + size;
    }
  }
  return sum - begin;
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

/* mirror[p]: where the transpose of the entry at p stands. Columns are visited in order, and so
 * are the entries of their rows. */
static void
find_mirrors (int32_t n, const int32_t *ap, const int32_t *ai, int32_t *next,
              int32_t *mirror)
{
  memcpy (next, ap, (size_t) n * sizeof *next);
  for (int32_t j = 0; j < n; j++)
    for (int32_t p = ap[j]; p < ap[j + 1]; p++)
      mirror[p] = next[ai[p]]++;
}

static bool
list_all_entries (QnBlockLu *lu, const int32_t *ap, const int32_t *ai)
{
  const QnFrontTree *tree = &lu->tree;
  size_t n = (size_t) tree->n;
  int32_t fill = 0;
  int32_t *unknown = qn_alloc (n, sizeof *unknown), *where = qn_alloc (n, sizeof *where),
          *mirror = qn_alloc ((size_t) ap[n], sizeof *mirror);
  bool ok = unknown && where && mirror;

  if (ok) {
    find_mirrors (tree->n, ap, ai, where, mirror);
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
  free (unknown);
  free (where);
  free (mirror);
  return ok;
}

/* Finds the places of all unknowns in the solution; `place`: of every position. */
static bool
lay_out_solution (QnBlockLu *lu)
{
  const QnFrontTree *tree = &lu->tree;
  size_t n = (size_t) tree->n, rests = 0;
  for (int32_t f = 0; f < tree->front_count; f++)
    rests += (size_t) tree->fronts[f].rest;
  int32_t *place = qn_alloc (n, sizeof *place);

  lu->solution = qn_alloc_lines (lu->solution_size, sizeof *lu->solution);
  lu->unknown_places = qn_alloc (n, sizeof *lu->unknown_places);
  lu->rest_places = qn_alloc (rests, sizeof *lu->rest_places);
  bool ok = place && lu->solution && lu->unknown_places && lu->rest_places;
  if (ok) {
    for (int32_t f = 0; f < tree->front_count; f++)
      for (int32_t c = 0; c < tree->fronts[f].pivots; c++)
        place[tree->fronts[f].first + c] = lu->matrices[f].first_place + c;
    for (int32_t i = 0; i < tree->n; i++)
      lu->unknown_places[i] = place[tree->position[i]];
    for (size_t k = 0; k < rests; k++)
      lu->rest_places[k] = place[tree->rows[k]];
  }
  free (place);
  return ok;
}

static bool
set_up (QnBlockLu *lu, int32_t n, const int32_t *ap, const int32_t *ai,
        const QnVec2 *points)
{
  size_t entries = (size_t) ap[n];
  int32_t longest;

  if (!qn_front_tree_init (&lu->tree, n, ap, ai, points))
    return false;
  lu->matrices = qn_alloc ((size_t) lu->tree.front_count + 1, sizeof *lu->matrices);
  lu->sources = qn_alloc (entries, sizeof *lu->sources);
  lu->places = qn_alloc (entries, sizeof *lu->places);
  lu->values = qn_alloc (entries, sizeof *lu->values);
  lu->exchanges = qn_alloc ((size_t) n, sizeof *lu->exchanges);
  if (!lu->matrices || !lu->sources || !lu->places || !lu->values || !lu->exchanges)
    return false;
  size_t factors = lay_out_factors (lu, &longest);
  lu->numbers =
    qn_alloc_lines (factors + lay_out_rests (lu, factors), sizeof *lu->numbers);
  lu->rest = qn_alloc_lines ((size_t) qn_front_height (longest), sizeof *lu->rest);
  return lu->numbers && lu->rest && lay_out_solution (lu)
         && list_all_entries (lu, ap, ai);
}

QnBlockLu *
qn_block_lu_new (int32_t n, const int32_t *ap, const int32_t *ai, const QnVec2 *points)
{
  QnBlockLu *lu = qn_alloc (1, sizeof *lu);

  if (lu == NULL)
    return NULL;
  lu->loops = qn_front_loops (QN_FRONT_ROWS);
  if (!set_up (lu, n, ap, ai, points)) {
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
  qn_front_tree_clear (&lu->tree);
  free (lu->matrices);
  free (lu->numbers);
  free (lu->sources);
  free (lu->places);
  free (lu->values);
  free (lu->exchanges);
  free (lu->solution);
  free (lu->unknown_places);
  free (lu->rest_places);
  free (lu->rest);
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
                         .schur =
                           lu->numbers + (lu->passing ? m->passing_schur : m->schur),
                         .exchanges = lu->exchanges + front->first };
}

/* Whether any of the values of A that come into a front is new. */
static bool
has_new_values (const QnBlockLu *lu, int32_t f, const double *ax)
{
  int32_t e = lu->matrices[f].first_entry, end = lu->matrices[f + 1].first_entry;

  while (e < end && ax[lu->sources[e]] == lu->values[e])
    e++;
  return e < end;
}

/* Puts the values of A that come into a front there, and keeps them for comparison where its rest
 * is kept. */
static void
take_values (QnBlockLu *lu, int32_t f, const double *ax, double *diagonal)
{
  int32_t e = lu->matrices[f].first_entry, end = lu->matrices[f + 1].first_entry;

  if (lu->passing)
    for (; e < end; e++)
      diagonal[lu->places[e]] = ax[lu->sources[e]];
  for (; e < end; e++)
    diagonal[lu->places[e]] = lu->values[e] = ax[lu->sources[e]];
}

/* Adds what of a child's rest are pivots here, to D, L and U. */
static void
add_child_to_pivots (const QnBlockLu *lu, int32_t c, const QnDenseFront *front)
{
  const QnFront *child = &lu->tree.fronts[c];
  const int32_t *places = lu->tree.places + child->first_row;
  const int32_t *runs = lu->tree.runs + child->first_row;
  int32_t known = lu->matrices[c].pivots_of_parent, rest = child->rest - known;
  int32_t height = qn_front_height (child->rest),
          low_height = qn_front_height (front->rest);
  const double *schur = dense_front (lu, c).schur;

  lu->loops->add (&(QnFrontPart){ schur, height, known, known, front->diagonal,
                                  qn_front_height (front->pivots), places, runs,
                                  places });
  lu->loops->add (&(QnFrontPart){ schur + known, height, rest, known,
                                  front->lower - front->pivots, low_height,
                                  places + known, runs + known, places });
  lu->loops->add_by_rows (&(QnFrontPart){
    schur + (size_t) known * (size_t) height, height, known, rest,
    front->upper - front->pivots, low_height, places, runs, places + known });
}

/* Adds the other part of it to S. */
static void
add_child_to_rest (const QnBlockLu *lu, int32_t c, const QnDenseFront *front)
{
  const QnFront *child = &lu->tree.fronts[c];
  const int32_t *places = lu->tree.places + child->first_row;
  const int32_t *runs = lu->tree.runs + child->first_row;
  int32_t known = lu->matrices[c].pivots_of_parent, rest = child->rest - known;
  int32_t height = qn_front_height (child->rest),
          low_height = qn_front_height (front->rest);
  size_t pivots = (size_t) front->pivots;
  const double *schur = dense_front (lu, c).schur;

  lu->loops->add (
    &(QnFrontPart){ schur + (size_t) known * (size_t) height + known, height, rest, rest,
                    front->schur - pivots * (size_t) low_height - pivots, low_height,
                    places + known, runs + known, places + known });
}

static bool
factor_front (QnBlockLu *lu, int32_t f, const double *ax)
{
  Matrices *m = &lu->matrices[f];
  QnDenseFront front = dense_front (lu, f);

  memset (front.diagonal, 0, (m->end - m->diagonal) * sizeof (double));
  take_values (lu, f, ax, front.diagonal);
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    add_child_to_pivots (lu, c, &front);
  m->range = (QnPivotRange){ INFINITY, 0 };
  if (!lu->loops->eliminate (&front, &m->range))
    return false;
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    add_child_to_rest (lu, c, &front);
  return true;
}

/* Whether a front has to be eliminated anew: where a child was, or a value is new. */
static bool
is_touched (const QnBlockLu *lu, int32_t f, const double *ax)
{
  for (int32_t c = lu->tree.fronts[f].child; c != QN_NONE; c = lu->tree.fronts[c].sibling)
    if (lu->matrices[c].changed)
      return true;
  return has_new_values (lu, f, ax);
}

double
qn_block_lu_refactor (QnBlockLu *lu, const double *ax, double *work)
{
  QnPivotRange range = { INFINITY, 0 };
  double done = 0;
  bool regular = true;

  for (int32_t f = 0; f < lu->tree.front_count && regular; f++) {
    Matrices *m = &lu->matrices[f];
    m->changed = !lu->whole || is_touched (lu, f, ax);
    if (m->changed) {
      done += m->work;
      regular = factor_front (lu, f, ax);
    }
    range.smallest = fmin (m->range.smallest, range.smallest);
    range.largest = fmax (m->range.largest, range.largest);
  }
  lu->whole = regular;
  *work = lu->work > 0 ? done / lu->work : 0;
  if (!regular)
    return 0;
  return range.largest > 0 ? range.smallest / range.largest : 1;
}

double
qn_block_lu_factor (QnBlockLu *lu, const double *ax)
{
  double work;

  lu->whole = false;
  lu->passing = true;
  double ratio = qn_block_lu_refactor (lu, ax, &work);
  lu->whole = lu->passing = false;
  return ratio;
}

/* --- Solution --------------------------------------------------------------------------- */

void
qn_block_lu_solve (QnBlockLu *lu, double *b)
{
  const QnFrontTree *tree = &lu->tree;
  double *x = lu->solution, *rest = lu->rest;

  memset (x, 0, lu->solution_size * sizeof *x);
  for (int32_t i = 0; i < tree->n; i++)
    x[lu->unknown_places[i]] = b[i];
  for (int32_t f = 0; f < tree->front_count; f++) { /* x = L\x */
    QnDenseFront front = dense_front (lu, f);
    const int32_t *places = lu->rest_places + tree->fronts[f].first_row;
    lu->loops->forward (&front, x + lu->matrices[f].first_place, rest);
    for (int32_t r = 0; r < front.rest; r++)
      x[places[r]] -= rest[r];
  }
  for (int32_t f = tree->front_count - 1; f >= 0; f--) { /* x = U\x */
    QnDenseFront front = dense_front (lu, f);
    const int32_t *places = lu->rest_places + tree->fronts[f].first_row;
    for (int32_t r = 0; r < front.rest; r++)
      rest[r] = x[places[r]];
    for (int32_t r = front.rest; r < qn_front_height (front.rest); r++)
      rest[r] = 0;
    lu->loops->backward (&front, x + lu->matrices[f].first_place, rest);
  }
  for (int32_t i = 0; i < tree->n; i++)
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
