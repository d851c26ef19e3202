#include "core/linalg/dissection.h"

#include "core/base/integer.h"
#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

/* Parts of so many nodes are not cut any more. */
#define SMALLEST_CUT 50

/* The smaller part that a cut leaves, as a part of the whole, is at least this. */
#define LEAST_PART 0.4

typedef struct {
  double along;
  int32_t node;
} Item;

typedef struct {
  const QnPlaneGraph *graph;
  int32_t *set;
  int32_t set_count;
  Item *items;    /* all nodes, those of a part side by side */
  Item *scratch;  /* as many */
  int32_t *place; /* of each node in `items` */
  int32_t *begun; /* of each cut: its touching nodes, less those of the last */
} Dissection;

/* Where a part is cut. */
typedef struct {
  int32_t middle;   /* nodes before it */
  int32_t touching; /* of them, that touch what is behind */
} Cut;

static int
compare_items (const void *a, const void *b)
{
  const Item *left = a, *right = b;

  if (left->along != right->along)
    return left->along < right->along ? -1 : 1;
  return (left->node > right->node) - (left->node < right->node);
}

static void
close_set (Dissection *d, int32_t first, int32_t end)
{
  for (int32_t i = first; i < end; i++)
    d->set[d->items[i].node] = d->set_count;
  d->set_count += end > first;
}

static void
sort_part (Dissection *d, int32_t first, int32_t count, bool upwards)
{
  Item *items = d->items + first;

  for (int32_t i = 0; i < count; i++) {
    QnVec2 point = d->graph->points[items[i].node];
    items[i].along = upwards ? point.y : point.x;
  }
  qsort (items, (size_t) count, sizeof *items, compare_items);
  for (int32_t i = 0; i < count; i++)
    d->place[items[i].node] = first + i;
}

/* The last place within a part where a neighbour of a node stands, itself included. */
static int32_t
last_neighbour (const Dissection *d, int32_t node, int32_t end)
{
  int32_t last = d->place[node];

  for (int32_t p = d->graph->start[node]; p < d->graph->start[node + 1]; p++) {
    int32_t place = d->place[d->graph->next[p]];
    if (place > last && place < end)
      last = place;
  }
  return last;
}

/* Sorts a part along x or y and finds where, near its middle, least touches a cut. */
static Cut
find_cut (Dissection *d, int32_t first, int32_t count, bool upwards)
{
  int32_t low = (int32_t) qn_to_integer (LEAST_PART * count, 0, count), touching = 0;
  Cut cut = { .touching = count };

  sort_part (d, first, count, upwards);
  memset (d->begun, 0, (size_t) (count + 1) * sizeof *d->begun);
  for (int32_t i = 0; i < count; i++) {
    d->begun[i + 1]++;
    d->begun[last_neighbour (d, d->items[first + i].node, first + count) - first + 1]--;
  }
  for (int32_t i = 0; i <= count - low; i++) {
    touching += d->begun[i];
    if (i >= low && touching < cut.touching) {
      cut.touching = touching;
      cut.middle = i;
    }
  }
  return cut;
}

/* Numbers the sets of a part. */
static void
dissect (Dissection *d, int32_t first, int32_t count)
{
  if (count < SMALLEST_CUT) {
    close_set (d, first, first + count);
    return;
  }
  Cut cut = find_cut (d, first, count, false);
  Cut other = find_cut (d, first, count, true);
  if (cut.touching < other.touching)
    sort_part (d, first, count, false);
  else
    cut = other;

  /* What is before the cut, what is behind, and last what parts them. */
  Item *items = d->items + first;
  int32_t before = 0, parting = 0, behind = count - cut.middle;
  for (int32_t i = 0; i < cut.middle; i++)
    if (last_neighbour (d, items[i].node, first + count) >= first + cut.middle)
      d->scratch[parting++] = items[i];
    else
      items[before++] = items[i];
  memmove (items + before, items + cut.middle, (size_t) behind * sizeof *items);
  memcpy (items + before + behind, d->scratch, (size_t) parting * sizeof *items);
  dissect (d, first, before);
  dissect (d, first + before, behind);
  close_set (d, first + before + behind, first + count);
}

bool
qn_dissect (const QnPlaneGraph *graph, int32_t *set)
{
  size_t count = (size_t) graph->count;
  Dissection d = { .graph = graph,
                   .set = set,
                   .items = qn_alloc (count, sizeof *d.items),
                   .scratch = qn_alloc (count, sizeof *d.scratch),
                   .place = qn_alloc (count, sizeof *d.place),
                   .begun = qn_alloc (count + 1, sizeof *d.begun) };
  bool ok = d.items && d.scratch && d.place && d.begun;

  if (ok) {
    for (int32_t k = 0; k < graph->count; k++)
      d.items[k].node = k;
    dissect (&d, 0, graph->count);
  }
  free (d.items);
  free (d.scratch);
  free (d.place);
  free (d.begun);
  return ok;
}
