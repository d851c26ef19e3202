#include "stereotomy/masonry-parts.h"

static QnStatus
check_leaf (const QnMasonryWall *wall, const QnLeaf *leaf, QnDiag *diag)
{
  bool listed = leaf->bond == QN_BOND_CUSTOM;
  const QnSubject of = qn_masonry_subject (diag);
  const char *unit = wall->grid ? "size" : "unit";
  bool holds =
    qn_require_length (of, unit, leaf->unit.x, QN_RANGE_POSITIVE)
    && qn_require_length (of, unit, leaf->unit.y, QN_RANGE_POSITIVE)
    && qn_require_length (of, "header", leaf->header, QN_RANGE_NOT_NEGATIVE)
    && (listed || qn_require_length (of, "length", leaf->length, QN_RANGE_POSITIVE))
    && qn_require (of, leaf->lap >= 0 && leaf->lap < 1, QN_PROBLEM_FRACTION, "lap",
                   leaf->lap)
    && qn_require (of, leaf->bond != QN_BOND_FLEMISH || leaf->header < leaf->unit.x,
                   QN_PROBLEM_HEADER_TOO_LONG, "header", leaf->header)
    && qn_require (of, !listed || wall->leaf_count == 1, QN_PROBLEM_LEAVES_LISTED,
                   "leaves", 0)
    && qn_require (of, !listed || wall->courses.course_count > 0, QN_PROBLEM_COURSE_EMPTY,
                   "courses", 0);
  if (!holds || listed)
    return qn_required (holds);
  double shortest =
    leaf->header > 0 ? fmin (leaf->header, leaf->unit.x) : leaf->unit.x / 2;
  double lowest = leaf->unit.y;
  for (size_t i = 0; i < wall->course_height_count; i++)
    lowest = i == 0 ? wall->course_heights[0] : fmin (lowest, wall->course_heights[i]);
  return qn_required (
    qn_require (of, leaf->length / shortest * (wall->height / lowest) <= QN_MAX_PIECES,
                QN_PROBLEM_TOO_MANY_BLOCKS, "unit", leaf->unit.x));
}

static QnStatus
check_wall (const QnMasonry *masonry, QnDiag *diag)
{
  const QnMasonryWall *wall = &masonry->wall;
  QN_ASSERT (wall->leaf_count > 0);
  const QnSubject of = qn_masonry_subject (diag);
  bool holds = wall->leaves[0].bond == QN_BOND_CUSTOM
               || qn_require_length (of, wall->grid ? "size" : "height", wall->height,
                                     QN_RANGE_POSITIVE);
  for (size_t i = 0; holds && i < wall->course_height_count; i++)
    holds = qn_require_length (of, "course_heights", wall->course_heights[i],
                               QN_RANGE_POSITIVE);
  holds = holds
          && qn_require (of, wall->minimum_piece >= 0 && wall->minimum_piece < 1,
                         QN_PROBLEM_FRACTION, "minimum_piece", wall->minimum_piece);
  QnStatus status = qn_required (holds);
  for (size_t i = 0; i < wall->leaf_count && status == QN_OK; i++) {
    status = check_leaf (wall, &wall->leaves[i], diag);
    if (status != QN_OK && diag != NULL && wall->leaf_count > 1)
      diag->other = (QnId) i;
  }
  return status;
}

/* Extent of the rectangle that the wall fills, teeth left out. */
static QnBox
wall_bounds (const QnMasonryWall *wall, const QnPieces *pieces)
{
  QnBox bounds = { { 0, 0 }, { 0, wall->height } };
  for (size_t i = 0; i < wall->leaf_count; i++)
    bounds.max.x += wall->leaves[i].length;
  if (wall->leaves[0].bond != QN_BOND_CUSTOM)
    return bounds;
  bounds.max = (QnVec2){ 0, 0 };
  for (size_t i = 0; i < pieces->count; i++) {
    QnBox piece = qn_ring_bounds (&pieces->items[i].ring);
    bounds.max.x = fmax (bounds.max.x, piece.max.x);
    bounds.max.y = fmax (bounds.max.y, piece.max.y);
  }
  return bounds;
}

/* One fixed block below the whole lowest course, teeth included. */
static void
lay_foundation (const QnMasonry *masonry, QnPieces *pieces)
{
  double left = INFINITY, right = -INFINITY;
  for (size_t i = 0; i < pieces->count; i++) {
    if (!pieces->items[i].fabric || pieces->items[i].course != 0)
      continue;
    QnBox bounds = qn_ring_bounds (&pieces->items[i].ring);
    left = fmin (left, bounds.min.x);
    right = fmax (right, bounds.max.x);
  }
  if (masonry->foundation == 0 || left >= right)
    return;
  qn_pieces_add (pieces, qn_rectangle (left, -masonry->foundation, right, 0), "%s.base",
                 masonry->name)
    ->fixed = true;
}

QnStatus
qn_masonry_lay_wall (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnMasonryWall *wall = &masonry->wall;
  QnStatus status = check_wall (masonry, diag);
  double left = 0;
  for (size_t i = 0; i < wall->leaf_count && status == QN_OK; i++) {
    status = qn_bond_lay_leaf (masonry, i, left, pieces, diag);
    left += wall->leaves[i].length;
  }
  lay_foundation (masonry, pieces);
  if (status == QN_OK)
    status = qn_openings_cut (masonry, wall_bounds (wall, pieces), pieces, diag);
  if (status == QN_OK)
    qn_slivers_merge (wall->minimum_piece, pieces);
  return status;
}
