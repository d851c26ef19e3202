#include "study/cases/moving-load.h"

#include "core/base/polygon.h"
#include "io/text/json-text.h"
#include "io/text/number-text.h"

#include <math.h>

/* Where the way of a moving load is `distance` from its start. */
static QnVec2
point_of_line (const QnParameter *parameter, double distance)
{
  guint i = 0;
  double length = qn_vec2_length (qn_vec2_sub (parameter->line[1], parameter->line[0]));
  while (distance > length && i + 2 < parameter->line_count) {
    distance -= length;
    i++;
    length = qn_vec2_length (qn_vec2_sub (parameter->line[i + 1], parameter->line[i]));
  }
  return length > 0 ? qn_vec2_lerp (parameter->line[i], parameter->line[i + 1],
                                    fmin (distance / length, 1))
                    : parameter->line[i];
}

/* The point of a block that is nearest to another. */
static QnVec2
nearest_point (const QnModel *model, QnId block, QnVec2 point)
{
  const QnVec2 *vertices = qn_model_block_vertices (model, block);
  int32_t count = model->blocks[block].vertex_count;
  QnVec2 best = vertices[0];
  if (qn_polygon_depth (vertices, (size_t) count, point) >= 0)
    return point;
  for (int32_t k = 0; k < count; k++) {
    QnVec2 p = vertices[k], q = vertices[(k + 1) % count];
    QnVec2 side = qn_vec2_sub (q, p);
    double s = qn_vec2_dot (qn_vec2_sub (point, p), side) / qn_vec2_dot (side, side);
    QnVec2 foot = qn_vec2_lerp (p, q, fmin (fmax (s, 0), 1));
    if (qn_vec2_length (qn_vec2_sub (foot, point))
        < qn_vec2_length (qn_vec2_sub (best, point)))
      best = foot;
  }
  return best;
}

/* A bound of the depth of a point outside of a polygon, from its box; INFINITY within the box. */
static double
depth_bound (const QnVec2 *vertices, int32_t count, QnVec2 point)
{
  QnVec2 low = vertices[0], high = vertices[0];
  for (int32_t k = 1; k < count; k++) {
    low = qn_vec2 (MIN (low.x, vertices[k].x), MIN (low.y, vertices[k].y));
    high = qn_vec2 (MAX (high.x, vertices[k].x), MAX (high.y, vertices[k].y));
  }
  double outside = MAX (MAX (low.x - point.x, point.x - high.x),
                        MAX (low.y - point.y, point.y - high.y));
  return outside > 0 ? -outside : INFINITY;
}

QnId
qn_nearest_block (const QnModel *model, QnVec2 point)
{
  double best = -INFINITY;
  QnId nearest = QN_NONE;
  for (size_t b = 0; b < model->block_count; b++) {
    const QnVec2 *vertices = qn_model_block_vertices (model, (QnId) b);
    int32_t count = model->blocks[b].vertex_count;
    if (depth_bound (vertices, count, point) <= best)
      continue;
    double depth = qn_polygon_depth (vertices, (size_t) count, point);
    if (depth > best) {
      best = depth;
      nearest = (QnId) b;
    }
  }
  return nearest;
}

void
qn_moving_load_add_overrides (GPtrArray *overrides, const QnParameter *parameter,
                              double distance_of_first, const QnModel *model)
{
  char x[QN_NUMBER_TEXT_SIZE], y[QN_NUMBER_TEXT_SIZE];
  for (guint i = 0; parameter->paths[i] != NULL; i++) {
    const char *path = parameter->paths[i];
    double distance = distance_of_first - parameter->offsets[i];
    if (distance < 0) {
      g_ptr_array_add (overrides, g_strconcat (path, ".value=[0, 0]", NULL));
      g_ptr_array_add (overrides, g_strconcat (path, ".moment=0", NULL));
      continue;
    }
    QnVec2 point = point_of_line (parameter, distance);
    QnId nearest = qn_nearest_block (model, point);
    if (nearest == QN_NONE)
      return;
    QnVec2 at = nearest_point (model, nearest, point);
    g_autoptr (GString) name = g_string_new (NULL);
    qn_json_append_string (name, model->blocks[nearest].name);
    g_ptr_array_add (overrides, g_strconcat (path, ".block=", name->str, NULL));
    g_ptr_array_add (overrides, g_strconcat (path, ".at=[", qn_number_text (at.x, x),
                                             ", ", qn_number_text (at.y, y), "]", NULL));
  }
}
