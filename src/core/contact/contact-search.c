#include "core/contact/contact-search.h"

#include "core/base/tolerance.h"

#include <stdlib.h>

QnContactLengths
qn_contact_lengths (const QnModel *model)
{
  QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  double far = fmax (fmax (fabs (box.min.x), fabs (box.max.x)),
                     fmax (fabs (box.min.y), fabs (box.max.y)));
  double size = model->characteristic_length;
  double tolerance =
    fmax (model->contact.tolerance * size, QN_TOLERANCE_COORDINATE * far);
  return (QnContactLengths){ .tolerance = tolerance,
                             .gap_limit = fmax (QN_NEAR_MISS_GAP * size, 2 * tolerance),
                             .overlap_limit = QN_NEAR_MISS_OVERLAP * tolerance };
}

/* Corners that merged sides leave, not vertices, say whether a block is convex. */
static bool
is_convex (const QnSides *sides, size_t block)
{
  size_t begin = sides->first[block], count = sides->first[block + 1] - begin;
  for (size_t i = 0; i < count; i++) {
    QnVec2 in = sides->items[begin + i].direction;
    QnVec2 out = sides->items[begin + (i + 1) % count].direction;
    if (qn_vec2_cross (in, out) < -QN_TOLERANCE_CONVEX)
      return false;
  }
  return true;
}

void
qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                        QnContactLengths lengths, QnPool *room)
{
  *search = (QnContactSearch){ .model = model, .lengths = lengths, .room = room };
  search->block_boxes =
    qn_pool_alloc (room, model->block_count, sizeof *search->block_boxes);
  search->convex = qn_pool_alloc (room, model->block_count, sizeof *search->convex);
  qn_sides_init (&search->sides, model, search->lengths.tolerance, room);
  if (room->failed)
    return;
  for (size_t i = 0; i < model->block_count; i++) {
    search->block_boxes[i] = qn_model_block_box (model, (QnId) i);
    search->convex[i] = is_convex (&search->sides, i);
  }
  qn_box_tree_init (&search->block_tree, search->block_boxes, model->block_count, room);
  /* The trees of the sides of blocks that have many. */
  QnId blocks = (QnId) model->block_count;
  size_t most = 0;
  for (QnId i = 0; i < blocks; i++)
    most = qn_side_count (search, i) > most ? qn_side_count (search, i) : most;
  if (most <= QN_FEW_SIDES)
    return;
  QnBox *boxes = qn_pool_alloc (search->room, most, sizeof *boxes);
  search->side_trees =
    qn_pool_alloc (search->room, (size_t) blocks, sizeof *search->side_trees);
  for (QnId i = 0; i < blocks && !search->room->failed; i++) {
    size_t count = qn_side_count (search, i);
    if (count <= QN_FEW_SIDES)
      continue;
    for (size_t k = 0; k < count; k++)
      boxes[k] = qn_side_box (&search->sides.items[search->sides.first[i] + k]);
    qn_box_tree_init (&search->side_trees[i], boxes, count, search->room);
  }
}

/* --- All pairs of blocks that lie near each other, one after the other ------------------- */

static QnStatus
find_neighbours (const QnContactSearch *search, QnBoxPairs *pairs, QnDiag *diag)
{
  size_t most = QN_MOST_NEIGHBOURS (search->model->block_count);

  search->room->failed |=
    !qn_box_tree_pairs (&search->block_tree, 2 * search->lengths.gap_limit, most, pairs);
  if (pairs->count == most)
    return qn_refuse (diag, QN_PROBLEM_TOO_MANY_NEIGHBOURS, QN_ENTITY_MODEL, QN_NONE);
  return QN_OK;
}

QnStatus
qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts, QnDiag *diag)
{
  size_t blocks = search->model->block_count;
  size_t deep_overlaps = 0;
  QnBoxPairs neighbours = { 0 };
  QnTouches touches = { 0 };
  QnFindings overlaps = { 0 };
  QnContactMatches matches = { 0 }; /* scratch of one pair of blocks, as the next */
  QnContactCuts cuts = { 0 };
  QnStatus status = find_neighbours (search, &neighbours, diag);

  for (size_t i = 0; status == QN_OK && !search->room->failed && i < neighbours.count
                     && deep_overlaps <= QN_MOST_OVERLAPS (blocks);
       i++) {
    QnId a = neighbours.items[i][0], b = neighbours.items[i][1];
    size_t earlier = overlaps.count;
    qn_contact_match_pair (search, a, b, &matches, contacts, &touches);
    qn_contact_check_overlap (search, a, b, &cuts, &overlaps);
    deep_overlaps += overlaps.count > earlier
                     && overlaps.items[earlier].problem == QN_PROBLEM_BLOCKS_OVERLAP;
  }
  qn_box_pairs_clear (&neighbours);
  free (matches.items);
  free (cuts.items);

  if (deep_overlaps > QN_MOST_OVERLAPS (blocks)) { /* the first is named */
    status = qn_refuse (diag, QN_PROBLEM_TOO_MANY_OVERLAPS, QN_ENTITY_BLOCK,
                        overlaps.items[0].block_a);
    if (diag != NULL)
      diag->other = overlaps.items[0].block_b;
  } else if (status == QN_OK) {
    for (size_t i = 0; i < overlaps.count; i++)
      qn_contacts_report (contacts, overlaps.items[i]);
    qn_contact_search_points (search, contacts, &touches);
  }
  free (touches.items);
  free (overlaps.items);
  return status;
}
