#include "core/contact-search.h"

#include "core/memory.h"
#include "core/polygon.h"
#include "core/tolerance.h"

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
fill_boxes (QnContactSearch *search)
{
  const QnModel *model = search->model;
  for (size_t i = 0; i < search->sides.count; i++)
    search->side_boxes[i] =
      qn_box_of_segment (search->sides.items[i].start, search->sides.items[i].end);
  for (size_t i = 0; i < model->block_count; i++) {
    search->block_boxes[i] = qn_box_of_points (qn_model_block_vertices (model, (QnId) i),
                                               (size_t) model->blocks[i].vertex_count);
    search->convex[i] = is_convex (&search->sides, i);
  }
}

QnStatus
qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                        QnContactLengths lengths, QnDiag *diag)
{
  *search = (QnContactSearch){ .model = model, .lengths = lengths };
  if (!qn_sides_init (&search->sides, model, search->lengths.tolerance))
    return qn_diag_no_memory (diag);

  search->side_boxes = qn_alloc (search->sides.count, sizeof *search->side_boxes);
  search->block_boxes = qn_alloc (model->block_count, sizeof *search->block_boxes);
  search->convex = qn_alloc (model->block_count, sizeof *search->convex);
  bool done =
    search->side_boxes != NULL && search->block_boxes != NULL && search->convex != NULL;
  if (done) {
    fill_boxes (search);
    done =
      qn_box_tree_init (&search->side_tree, search->side_boxes, search->sides.count)
      && qn_box_tree_init (&search->block_tree, search->block_boxes, model->block_count);
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
  free (search->side_boxes);
  free (search->block_boxes);
  free (search->convex);
  qn_box_tree_clear (&search->side_tree);
  qn_box_tree_clear (&search->block_tree);
  *search = (QnContactSearch){ 0 };
}
