#include "doc/view/magnet.h"

#include "core/base/polygon.h"

#define KINDS (QN_MAGNET_GRID + 1)

/* The nearest hit of every kind so far, in their order, and how far it is. */
typedef struct Best {
  double distance[KINDS];
  QnMagnetHit hit[KINDS];
} Best;

static void
offer (Best *best, QnMagnetKind kind, QnVec2 from, QnVec2 point, QnVec2 a, QnVec2 b)
{
  double distance = qn_vec2_length (qn_vec2_sub (from, point));
  if (distance <= best->distance[kind]) {
    best->distance[kind] = distance;
    best->hit[kind] = (QnMagnetHit){ kind, point, a, b };
  }
}

static void
offer_block (const QnModel *model, QnId block, QnVec2 p, Best *best)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  QnId count = model->blocks[block].vertex_count;
  for (QnId i = 0; i < count; i++) {
    QnVec2 a = v[i], b = v[(i + 1) % count];
    offer (best, QN_MAGNET_CORNER, p, a, a, a);
    offer (best, QN_MAGNET_MIDDLE, p, qn_vec2_lerp (a, b, 0.5), a, b);
    offer (best, QN_MAGNET_EDGE, p, qn_segment_nearest (a, b, p), a, b);
  }
}

QnMagnetHit
qn_magnet_find (const QnMagnet *magnet, const QnModel *model, QnVec2 p, const int *skip)
{
  QnMagnetHit nothing = { QN_MAGNET_NOTHING, p, p, p };
  if (!magnet->enabled)
    return nothing;

  Best best = { 0 };
  for (int kind = 0; kind < KINDS; kind++)
    best.distance[kind] = magnet->reach;
  for (size_t i = 0; i < model->node_count; i++) {
    QnVec2 at = model->nodes[i].at;
    QnId block = model->nodes[i].block;
    bool goes = skip != NULL && block != QN_NONE && skip[block];
    if (model->nodes[i].beam == QN_NONE && !goes)
      offer (&best, QN_MAGNET_NODE, p, at, at, at);
  }
  for (size_t i = 0; i < model->block_count; i++) {
    if (skip == NULL || !skip[i])
      offer_block (model, (QnId) i, p, &best);
  }
  for (size_t i = 0; i < model->wall_count; i++) {
    const QnWall *wall = &model->walls[i];
    double row = round ((p.y - wall->origin.y) / wall->unit.y);
    if (row < 0.0 || row > wall->course_count)
      continue;
    double y = wall->origin.y + row * wall->unit.y;
    offer (&best, QN_MAGNET_COURSE, p, qn_vec2 (p.x, y), qn_vec2 (wall->origin.x, y),
           qn_vec2 (p.x, y));
  }
  if (magnet->grid > 0.0) {
    QnVec2 crossing = qn_vec2 (round (p.x / magnet->grid) * magnet->grid,
                               round (p.y / magnet->grid) * magnet->grid);
    offer (&best, QN_MAGNET_GRID, p, crossing, crossing, crossing);
  }

  for (int kind = 0; kind < KINDS; kind++)
    if (best.hit[kind].kind != QN_MAGNET_NOTHING)
      return best.hit[kind];
  return nothing;
}

double
qn_magnet_round_distance (double least)
{
  if (!(least > 0.0) || isinf (least))
    return 1.0;
  double power = pow (10.0, floor (log10 (least)));
  static const double steps[] = { 1.0, 2.0, 5.0, 10.0 };
  for (size_t i = 0; i < QN_N_ELEMENTS (steps); i++) {
    if (steps[i] * power >= least * (1.0 - 1e-9))
      return steps[i] * power;
  }
  return 10.0 * power;
}
