/* The minimum piece rule; see masonry.h. */
#include "core/base/polygon.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

/* Edges nearer than this part of a unit's width lie on one line. */
#define JOINT_TOLERANCE 1e-9

static bool
is_sliver (const QnPiece *piece, double minimum)
{
  if (!piece->fabric || !piece->cut || piece->lone)
    return false;
  return qn_ring_area (&piece->ring) < minimum * piece->whole_area * (1 - JOINT_TOLERANCE)
         || qn_polygon_width (piece->ring.points, piece->ring.count)
              < minimum * piece->whole_width * (1 - JOINT_TOLERANCE);
}

typedef struct Neighbour {
  size_t index;
  bool same_course;
  double joint;
} Neighbour;

static int
compare_neighbours (const void *left, const void *right)
{
  const Neighbour *a = left, *b = right;
  if (a->same_course != b->same_course)
    return a->same_course ? -1 : 1;
  if (a->joint != b->joint)
    return a->joint > b->joint ? -1 : 1;
  return a->index < b->index ? -1 : 1;
}

/* Pieces of the same leaf that share a joint with `index`, best first: of Neighbour. */
static GArray *
find_neighbours (const QnPieces *pieces, size_t index)
{
  const QnPiece *sliver = &pieces->items[index];
  double tolerance = JOINT_TOLERANCE * sliver->whole_width;
  GArray *neighbours = g_array_new (FALSE, FALSE, sizeof (Neighbour));
  for (size_t i = 0; i < pieces->count; i++) {
    const QnPiece *other = &pieces->items[i];
    if (i == index || !other->fabric || other->leaf != sliver->leaf)
      continue;
    const Neighbour neighbour = { i, other->course == sliver->course,
                                  qn_joint_length (&sliver->ring, &other->ring,
                                                   tolerance) };
    if (neighbour.joint != 0)
      g_array_append_val (neighbours, neighbour);
  }
  g_array_sort (neighbours, compare_neighbours);
  return neighbours;
}

/* Merges the sliver with the first neighbour that gives a simple polygon; false where none does. */
static bool
merge_sliver (QnPieces *pieces, size_t index)
{
  g_autoptr (GArray) neighbours = find_neighbours (pieces, index);
  for (guint i = 0; i < neighbours->len; i++) {
    QnPiece *neighbour = &pieces->items[g_array_index (neighbours, Neighbour, i).index];
    QnRing pair[] = { neighbour->ring, pieces->items[index].ring }, joined;
    if (qn_polygons_union (&(QnRings){ .items = pair, .count = 2 }, &joined, NULL)
        != QN_OK)
      continue;
    qn_ring_clear (&neighbour->ring);
    neighbour->ring = joined;
    neighbour->cut = true;
    qn_pieces_remove (pieces, index);
    return true;
  }
  return false;
}

void
qn_slivers_merge (double minimum_piece, QnPieces *pieces)
{
  /* The smallest first: what is merged away can no longer tempt its neighbours. */
  while (minimum_piece > 0) {
    size_t smallest = SIZE_MAX;
    double area = INFINITY;
    for (size_t i = 0; i < pieces->count; i++) {
      if (!is_sliver (&pieces->items[i], minimum_piece))
        continue;
      double own = qn_ring_area (&pieces->items[i].ring);
      if (own < area) {
        area = own;
        smallest = i;
      }
    }
    if (smallest == SIZE_MAX)
      return;
    if (!merge_sliver (pieces, smallest))
      pieces->items[smallest].lone = true;
  }
}
