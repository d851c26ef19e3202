#include "core/contact/contact-search.h"

#include "core/base/tolerance.h"

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

static void
describe_blocks (QnContactSearch *search)
{
  const QnModel *model = search->model;
  for (size_t i = 0; i < model->block_count; i++) {
    search->block_boxes[i] = qn_model_block_box (model, (QnId) i);
    search->convex[i] = is_convex (&search->sides, i);
  }
}

/* The trees of the sides of blocks that have many. */
static void
plant_sides (QnContactSearch *search)
{
  QnId blocks = (QnId) search->model->block_count;
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
  describe_blocks (search);
  qn_box_tree_init (&search->block_tree, search->block_boxes, model->block_count, room);
  plant_sides (search);
}
