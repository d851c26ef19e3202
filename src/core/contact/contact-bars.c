#include "core/contact/contact-bars.h"

#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "core/base/tolerance.h"
#include "core/contact/contact-search.h"
#include "core/model/bar.h"

#include <math.h>
#include <stdlib.h>

/* Parts of a face's or a bar's length that are rounding. */
#define SNAP 1e-9

void
qn_bar_search_init (QnBarSearch *search, const QnModel *model, QnPool *room)
{
  size_t count = 0, n = 0;

  for (size_t i = 0; i < model->bar_count; i++)
    count += qn_bar_line_count (&model->bars[i]);
  *search = (QnBarSearch){ 0 };
  QnBox *boxes = qn_pool_alloc (room, count, sizeof *boxes);
  search->near = qn_pool_alloc (room, count, sizeof *search->near);
  search->bars = qn_pool_alloc (room, count, sizeof *search->bars);
  search->lines = qn_pool_alloc (room, count, sizeof *search->lines);
  search->used = qn_pool_alloc (room, model->bar_count, sizeof *search->used);
  if (room->failed)
    return;
  for (size_t i = 0; i < model->bar_count; i++)
    for (size_t k = 0; k < qn_bar_line_count (&model->bars[i]); k++, n++) {
      QnVec2 ends[2];
      qn_bar_line (&model->bars[i], k, ends);
      boxes[n] = qn_box_of_segment (ends[0], ends[1]);
      search->bars[n] = (QnId) i;
      search->lines[n] = (int32_t) k;
    }
  qn_box_tree_init (&search->tree, boxes, count, room);
}

static QnVec2
direction (const QnVec2 ends[2])
{
  QnVec2 along = qn_vec2_sub (ends[1], ends[0]);

  return qn_vec2_scale (1 / qn_vec2_length (along), along);
}

static double
snap (double part)
{
  return fabs (part) < SNAP ? 0 : fabs (part - 1) < SNAP ? 1 : part;
}

/* Where a line crosses that of the face, as a part of the face; a corner counts for the line that ends
 * there. */
static bool
crossing (const QnVec2 ends[2], bool goes_on, const QnContactFace *face, double *on_face)
{
  QnVec2 along = qn_vec2_sub (ends[1], ends[0]);
  QnVec2 to = qn_vec2_sub (face->start, ends[0]);
  double climb = qn_vec2_dot (along, face->normal);

  if (fabs (climb) <= SNAP * qn_vec2_length (along))
    return false;
  double on_line = snap (qn_vec2_dot (to, face->normal) / climb);
  QnVec2 met = qn_vec2_add_scaled (ends[0], on_line, along);
  *on_face =
    snap (qn_vec2_dot (qn_vec2_sub (met, face->start), face->tangent) / face->length);
  return on_line > 0 && (goes_on ? on_line <= 1 : on_line < 1) && *on_face >= 0
         && *on_face <= 1;
}

void
qn_bar_search_cross (QnBarSearch *search, const QnModel *model, QnContacts *contacts,
                     QnId index)
{
  QnContactFace *face = &contacts->faces[index];
  /* The lines near the face. The margin is rounding where one crosses an end of it. */
  QnBox box = qn_box_grow (qn_box_of_segment (face->start, face->end),
                           QN_TOLERANCE_CONVEX * face->length);
  QnBoxQuery query = qn_box_tree_query (&search->tree, box);
  size_t count = 0;
  for (QnId line = qn_box_query_next (&query); line != QN_NONE;
       line = qn_box_query_next (&query))
    search->near[count++] = line;
  if (count > 1)
    qsort (search->near, count, sizeof *search->near, qn_compare_ids);

  if (!qn_contacts_reserve_pairs (contacts, count))
    return;
  for (size_t k = 0; k < count; k++) {
    const QnId i = search->bars[search->near[k]];
    const int32_t line = search->lines[search->near[k]];
    const QnBar *bar = &model->bars[i];
    QnVec2 ends[2];
    double on_face;
    qn_bar_line (bar, (size_t) line, ends);
    if (!crossing (ends, line < bar->via_count, face, &on_face))
      continue;
    QnVec2 along = direction (ends);
    double forth = qn_vec2_dot (along, face->normal) > 0 ? 1 : -1;
    contacts->pairs[contacts->pair_count++] = (QnContactPair){
      .face = index,
      .point = qn_vec2_lerp (face->start, face->end, on_face),
      .abscissa = on_face * face->length,
      .tributary = bar->area / face->thickness,
      .bar = i,
      .line = line,
      .slant = forth * qn_vec2_dot (along, face->tangent),
    };
    face->pair_count++;
    search->used[i] = true;
  }
}

/* --- Along the bars ------------------------------------------------------------------------ */

static int
compare_crossings (const void *first, const void *second)
{
  const QnBarCrossing *a = first, *b = second;

  if (a->bar != b->bar)
    return a->bar < b->bar ? -1 : 1;
  if (a->line != b->line)
    return a->line < b->line ? -1 : 1;
  return (a->along > b->along) - (a->along < b->along);
}

QnBarCrossing *
qn_bar_crossings (const QnModel *model, const QnContacts *contacts, size_t *count)
{
  QnBarCrossing *all = qn_alloc (contacts->pair_count, sizeof *all);

  *count = 0;
  for (size_t p = 0; all != NULL && p < contacts->pair_count; p++) {
    const QnContactPair *pair = &contacts->pairs[p];
    QnVec2 ends[2];
    if (pair->bar == QN_NONE)
      continue;
    qn_bar_line (&model->bars[pair->bar], (size_t) pair->line, ends);
    all[(*count)++] = (QnBarCrossing){
      .pair = (QnId) p,
      .bar = pair->bar,
      .line = pair->line,
      .along = qn_vec2_dot (direction (ends), qn_vec2_sub (pair->point, ends[0])),
      .reach = 2 * SNAP * contacts->faces[pair->face].length,
    };
  }
  if (all != NULL)
    qsort (all, *count, sizeof *all, compare_crossings);
  return all;
}

/* --- Ends of faces ------------------------------------------------------------------------ */

/* On which side of a line a face lies that it meets at one of its ends: left 1, right -1; else 0. */
static int
side_of_face (const QnModel *model, const QnContacts *contacts, QnId p)
{
  const QnContactPair *pair = &contacts->pairs[p];
  const QnContactFace *face = &contacts->faces[pair->face];
  QnVec2 ends[2];

  if (pair->abscissa > 0 && pair->abscissa < face->length)
    return 0;
  qn_bar_line (&model->bars[pair->bar], (size_t) pair->line, ends);
  QnVec2 middle = qn_vec2_lerp (face->start, face->end, 0.5);
  return qn_vec2_cross (direction (ends), qn_vec2_sub (middle, pair->point)) > 0 ? 1 : -1;
}

/* Whether a point lies in a block, or on its outline. */
static bool
is_in_block (const QnBoxTree *blocks, const QnModel *model, QnVec2 at)
{
  QnBoxQuery query = qn_box_tree_query (blocks, qn_box_of_segment (at, at));

  for (QnId i = qn_box_query_next (&query); i != QN_NONE;
       i = qn_box_query_next (&query)) {
    const QnBlock *block = &model->blocks[i];
    if (qn_polygon_depth (qn_model_block_vertices (model, i),
                          (size_t) block->vertex_count, at)
        >= -QN_TOLERANCE_CONVEX * sqrt (block->area))
      return true;
  }
  return false;
}

/* Both ends of every bar; a mesh may reach beyond the blocks. */
static QnStatus
check_ends (const QnModel *model, QnPool *room, QnDiag *diag)
{
  QnBox *boxes = qn_pool_alloc (room, model->block_count, sizeof *boxes);
  QnBoxTree blocks;
  QnStatus status = QN_OK;

  if (boxes == NULL)
    return QN_OK;
  for (size_t i = 0; i < model->block_count; i++)
    boxes[i] = qn_box_grow (qn_model_block_box (model, (QnId) i),
                            QN_TOLERANCE_CONVEX * sqrt (model->blocks[i].area));
  qn_box_tree_init (&blocks, boxes, model->block_count, room);
  for (size_t i = 0; i < model->bar_count && status == QN_OK; i++) {
    const QnBar *bar = &model->bars[i];
    for (int end = 0; end < 2 && !qn_bar_is_mesh (bar) && status == QN_OK; end++) {
      QnVec2 at = end == 0 ? bar->start : bar->end;
      if (is_in_block (&blocks, model, at))
        continue;
      status = qn_diag_set_field (diag, QN_PROBLEM_BAR_END, QN_ENTITY_BAR, (QnId) i,
                                  end == 0 ? "start" : "end", 0);
      if (diag != NULL)
        diag->at = at;
    }
  }
  return status;
}

QnStatus
qn_bar_search_finish (const QnBarSearch *search, const QnModel *model,
                      QnContacts *contacts, QnDiag *diag)
{
  if (model->bar_count == 0)
    return QN_OK;
  QnStatus status = check_ends (model, &contacts->room, diag);

  for (size_t i = 0; status == QN_OK && i < model->bar_count; i++)
    if (!search->used[i])
      status = qn_refuse (diag, QN_PROBLEM_BAR_UNUSED, QN_ENTITY_BAR, (QnId) i);
  if (status == QN_OK) {
    /* Halves the bars at every place where there are faces on either side. */
    size_t count;
    QnBarCrossing *all =
      qn_pool_add (&contacts->room, qn_bar_crossings (model, contacts, &count));
    for (size_t first = 0, next; first < count; first = next) {
      bool left = false, right = false;
      for (next = first; next < count && qn_bar_crossings_meet (&all[first], &all[next]);
           next++) {
        int side = side_of_face (model, contacts, all[next].pair);
        left |= side > 0;
        right |= side < 0;
      }
      for (size_t i = first; i < next && left && right; i++)
        if (side_of_face (model, contacts, all[i].pair) != 0)
          contacts->pairs[all[i].pair].tributary *= 0.5;
    }
  }
  return status;
}

double
qn_bar_axial (const QnContactPair *pair, double normal, double shear)
{
  return sqrt (1 - pair->slant * pair->slant) * normal + pair->slant * shear;
}
