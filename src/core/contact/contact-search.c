#include "core/contact/contact-search.h"

#include "core/base/memory.h"
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
static bool
plant_sides (QnContactSearch *search)
{
  QnId blocks = (QnId) search->model->block_count;
  size_t most = 0;
  for (QnId i = 0; i < blocks; i++)
    most = qn_side_count (search, i) > most ? qn_side_count (search, i) : most;
  if (most <= QN_FEW_SIDES)
    return true;

  QnBox *boxes = qn_alloc (most, sizeof *boxes);
  search->side_trees = qn_alloc ((size_t) blocks, sizeof *search->side_trees);
  bool done = boxes != NULL && search->side_trees != NULL;
  for (QnId i = 0; i < blocks && done; i++) {
    size_t count = qn_side_count (search, i);
    if (count <= QN_FEW_SIDES)
      continue;
    for (size_t k = 0; k < count; k++)
      boxes[k] = qn_side_box (&search->sides.items[search->sides.first[i] + k]);
    done = qn_box_tree_init (&search->side_trees[i], boxes, count);
  }
  free (boxes);
  return done;
}

QnStatus
qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                        QnContactLengths lengths, QnDiag *diag)
{
  *search = (QnContactSearch){ .model = model, .lengths = lengths };
  search->block_boxes = qn_alloc_unset (model->block_count, sizeof *search->block_boxes);
  search->convex = qn_alloc_unset (model->block_count, sizeof *search->convex);
  bool done = search->block_boxes != NULL && search->convex != NULL
              && qn_sides_init (&search->sides, model, search->lengths.tolerance);
  if (done) {
    describe_blocks (search);
    done = qn_box_tree_init (&search->block_tree, search->block_boxes, model->block_count)
           && plant_sides (search);
  }
  if (!done) {
    qn_contact_search_clear (search);
    return qn_diag_no_memory (diag);
  }
  return QN_OK;
}

void
qn_contact_search_clear (QnContactSearch *search)
{
  qn_sides_clear (&search->sides);
  free (search->block_boxes);
  free (search->convex);
  qn_box_tree_clear (&search->block_tree);
  for (size_t i = 0; search->side_trees != NULL && i < search->model->block_count; i++)
    qn_box_tree_clear (&search->side_trees[i]);
  free (search->side_trees);
  *search = (QnContactSearch){ 0 };
}
