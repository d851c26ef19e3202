/* The minimum piece rule; see masonry.h. */
#include "core/base/memory.h"
#include "core/base/polygon.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

#include <stdlib.h>

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

/* Pieces of the same leaf that share a joint with `index`, best first; SIZE_MAX without memory. */
static size_t
find_neighbours (const QnPieces *pieces, size_t index, Neighbour **neighbours)
{
  const QnPiece *sliver = &pieces->items[index];
  double tolerance = JOINT_TOLERANCE * sliver->whole_width;
  size_t count = 0, capacity = 0;
  *neighbours = NULL;
  for (size_t i = 0; i < pieces->count; i++) {
    const QnPiece *other = &pieces->items[i];
    if (i == index || !other->fabric || other->leaf != sliver->leaf)
      continue;
    double joint = qn_joint_length (&sliver->ring, &other->ring, tolerance);
    if (joint == 0)
      continue;
    if (!QN_ARRAY_PUSH (*neighbours, count, capacity,
                        (Neighbour){ i, other->course == sliver->course, joint }))
      return SIZE_MAX;
  }
  if (count > 1)
    qsort (*neighbours, count, sizeof **neighbours, compare_neighbours);
  return count;
}

/* Merges the sliver with the first neighbour that gives a simple polygon; `merged` tells. */
static QnStatus
merge_sliver (QnPieces *pieces, size_t index, bool *merged, QnDiag *diag)
{
  *merged = false;
  Neighbour *neighbours;
  size_t count = find_neighbours (pieces, index, &neighbours);
  QnStatus status = count == SIZE_MAX ? qn_diag_no_memory (diag) : QN_OK;
  for (size_t i = 0; status == QN_OK && i < count && !*merged; i++) {
    QnPiece *neighbour = &pieces->items[neighbours[i].index];
    QnRing pair[] = { neighbour->ring, pieces->items[index].ring }, joined;
    QnDiag ignored;
    status =
      qn_polygons_union (&(QnRings){ .items = pair, .count = 2 }, &joined, &ignored);
    if (status == QN_OK) {
      qn_ring_clear (&neighbour->ring);
      neighbour->ring = joined;
      neighbour->cut = true;
      qn_pieces_remove (pieces, index);
      *merged = true;
    } else if (status == QN_ERROR_NO_MEMORY) {
      qn_diag_no_memory (diag);
    } else {
      status = QN_OK;
    }
  }
  free (neighbours);
  return status;
}

QnStatus
qn_slivers_merge (double minimum_piece, QnPieces *pieces, QnDiag *diag)
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
      return QN_OK;
    bool merged;
    QnStatus status = merge_sliver (pieces, smallest, &merged, diag);
    if (status != QN_OK)
      return status;
    if (!merged)
      pieces->items[smallest].lone = true;
  }
  return QN_OK;
}
