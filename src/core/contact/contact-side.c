#include "core/contact/contact-side.h"

#include <stdlib.h>

/* Directions that a run from its first vertex may take without leaving a vertex behind, as an
 * interval of angles about the direction of its first edge. */
typedef struct {
  QnVec2 origin, forward;
  double low, high;
} Sleeve;

/* Whether the run may be prolonged to `next`; narrows the sleeve if so. Every vertex passed
 * leaves the angles under which it is seen within the tolerance (Zhao & Saalfeld's sleeve). */
static bool
sleeve_admits (Sleeve *sleeve, QnVec2 last, QnVec2 next, double tolerance)
{
  QnVec2 to = qn_vec2_sub (next, sleeve->origin);
  double ahead = qn_vec2_dot (to, sleeve->forward);
  double distance = qn_vec2_length (to);
  if (qn_vec2_dot (qn_vec2_sub (next, last), sleeve->forward) <= 0 || ahead <= 0)
    return false;

  double angle = atan2 (qn_vec2_cross (sleeve->forward, to), ahead);
  if (angle < sleeve->low || angle > sleeve->high)
    return false;
  double spread = distance > tolerance ? asin (tolerance / distance) : 1;
  sleeve->low = fmax (sleeve->low, angle - spread);
  sleeve->high = fmin (sleeve->high, angle + spread);
  return true;
}

/* Number of edges in the straight run that begins at vertex `first`, at most `limit`. */
static size_t
run_length (const QnVec2 *v, size_t count, size_t first, size_t limit, double tolerance)
{
  QnVec2 edge = qn_vec2_sub (v[(first + 1) % count], v[first % count]);
  double length = qn_vec2_length (edge);
  Sleeve sleeve = { v[first % count], qn_vec2_scale (1 / length, edge), -1, 1 };

  size_t edges = 0;
  while (edges < limit
         && sleeve_admits (&sleeve, v[(first + edges) % count],
                           v[(first + edges + 1) % count], tolerance))
    edges++;
  return edges > 0 ? edges : 1;
}

/* Appends the sides of one block; items has room for one per vertex. */
static void
collect_sides (QnSides *sides, const QnModel *model, QnId block, double tolerance)
{
  size_t count = (size_t) model->blocks[block].vertex_count;
  const QnVec2 *v = qn_model_block_vertices (model, block);
  /* A vertex where the boundary certainly turns, to begin with: the one farthest from the
   * centroid, which is a corner of the convex hull. */
  size_t begin = 0;
  double most = -1;
  for (size_t i = 0; i < count; i++) {
    QnVec2 arm = qn_vec2_sub (v[i], model->blocks[block].centroid);
    double square = qn_vec2_dot (arm, arm);
    if (square > most) {
      most = square;
      begin = i;
    }
  }
  for (size_t done = 0; done < count;) {
    size_t edges = run_length (v, count, begin + done, count - done, tolerance);
    QnSide *side = &sides->items[sides->count++];
    side->block = block;
    side->vertex = (QnId) ((begin + done) % count);
    side->start = v[(begin + done) % count];
    side->end = v[(begin + done + edges) % count];
    QnVec2 along = qn_vec2_sub (side->end, side->start);
    side->length = qn_vec2_length (along);
    side->direction = qn_vec2_scale (1 / side->length, along);
    done += edges;
  }
}

static int
compare_sides (const void *a, const void *b)
{
  const QnSide *p = a, *q = b;

  return p->vertex - q->vertex;
}

void
qn_sides_init (QnSides *sides, const QnModel *model, double tolerance, QnPool *pool)
{
  *sides = (QnSides){ 0 };
  sides->items = qn_pool_alloc (pool, model->vertex_count, sizeof *sides->items);
  sides->first = qn_pool_alloc (pool, model->block_count + 1, sizeof *sides->first);
  if (pool->failed)
    return;
  for (size_t block = 0; block < model->block_count; block++) {
    size_t begin = sides->count;
    sides->first[block] = begin;
    collect_sides (sides, model, (QnId) block, tolerance);
    /* In their order around the block, from its lowest vertex on. */
    qsort (sides->items + begin, sides->count - begin, sizeof *sides->items,
           compare_sides);
  }
  sides->first[model->block_count] = sides->count;
}

const QnSide *
qn_sides_find (const QnSides *sides, QnId block, QnId vertex)
{
  size_t i = sides->first[block];

  while (i < sides->first[block + 1] && sides->items[i].vertex != vertex)
    i++;
  return i < sides->first[block + 1] ? &sides->items[i] : NULL;
}
