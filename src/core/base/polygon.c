#include "core/base/polygon.h"

QnPolygonProperties
qn_polygon_properties (const QnVec2 *vertices, size_t count)
{
  double twice_area = 0, sx = 0, sy = 0, polar = 0;
  QnVec2 origin = vertices[0];
  for (size_t i = 1; i + 1 < count; i++) {
    QnVec2 p = qn_vec2_sub (vertices[i], origin);
    QnVec2 q = qn_vec2_sub (vertices[i + 1], origin);
    double cross = qn_vec2_cross (p, q);
    twice_area += cross;
    sx += cross * (p.x + q.x);
    sy += cross * (p.y + q.y);
    polar += cross * (qn_vec2_dot (p, p) + qn_vec2_dot (p, q) + qn_vec2_dot (q, q));
  }

  QnPolygonProperties properties = { .area = twice_area / 2, .centroid = origin };
  if (twice_area == 0)
    return properties;
  QnVec2 arm = { sx / (3 * twice_area), sy / (3 * twice_area) };
  properties.centroid = qn_vec2_add (origin, arm);
  /* Jc = Jo - A |c|^2, Jo = sum of (p x q)(p.p + p.q + q.q) / 12 */
  properties.polar_moment = polar / 12 - properties.area * qn_vec2_dot (arm, arm);
  return properties;
}

void
qn_polygon_reverse (QnVec2 *vertices, size_t count)
{
  for (size_t i = 1, j = count - 1; i < j; i++, j--) {
    QnVec2 swap = vertices[i];
    vertices[i] = vertices[j];
    vertices[j] = swap;
  }
}

/* Of the segment pq, how much of it lies before what is nearest to the point. */
static double
share_before (QnVec2 p, QnVec2 q, QnVec2 point)
{
  QnVec2 along = qn_vec2_sub (q, p);
  double square = qn_vec2_dot (along, along);
  double share = square > 0 ? qn_vec2_dot (qn_vec2_sub (point, p), along) / square : 0;
  return share < 0 ? 0 : share > 1 ? 1 : share;
}

double
qn_segment_distance (QnVec2 p, QnVec2 q, QnVec2 point)
{
  return qn_vec2_length (qn_vec2_add_scaled (
    qn_vec2_sub (point, p), -share_before (p, q, point), qn_vec2_sub (q, p)));
}

QnVec2
qn_segment_nearest (QnVec2 p, QnVec2 q, QnVec2 point)
{
  double share = share_before (p, q, point);
  return share < 1 ? qn_vec2_lerp (p, q, share) : q;
}

double
qn_polygon_width (const QnVec2 *vertices, size_t count)
{
  double width = INFINITY;
  for (size_t i = 0; i < count; i++) {
    QnVec2 side = qn_vec2_sub (vertices[(i + 1) % count], vertices[i]);
    double length = qn_vec2_length (side), low = 0, high = 0;
    for (size_t k = 0; k < count && length > 0; k++) {
      double height =
        qn_vec2_cross (side, qn_vec2_sub (vertices[k], vertices[i])) / length;
      low = fmin (low, height);
      high = fmax (high, height);
    }
    if (length > 0)
      width = fmin (width, high - low);
  }
  return width;
}

double
qn_polygon_depth (const QnVec2 *vertices, size_t count, QnVec2 point)
{
  bool inside = false;
  double nearest = INFINITY;
  for (size_t i = 0, j = count - 1; i < count; j = i++) {
    QnVec2 p = qn_vec2_sub (vertices[j], point);
    QnVec2 q = qn_vec2_sub (vertices[i], point);
    /* A ray to the right crosses the edges that pass from one side of it to the other. */
    if ((p.y > 0) != (q.y > 0) && (qn_vec2_cross (p, q) > 0) == (q.y > p.y))
      inside = !inside;
    nearest = fmin (nearest, qn_segment_distance (p, q, qn_vec2 (0, 0)));
  }
  return inside ? nearest : -nearest;
}

/* Cuts off the triangle at a convex corner. If it is empty of other vertices its centroid is
 * inside; otherwise the vertex in it that lies deepest sees the corner, and half-way is inside. */
QnVec2
qn_polygon_inner_point (const QnVec2 *vertices, size_t count)
{
  /* Lowest vertex, the leftmost of several: certainly a convex corner. */
  size_t corner = 0;
  for (size_t i = 1; i < count; i++)
    if (vertices[i].y < vertices[corner].y
        || (vertices[i].y == vertices[corner].y && vertices[i].x < vertices[corner].x))
      corner = i;
  size_t before = (corner + count - 1) % count;
  size_t after = (corner + 1) % count;
  QnVec2 p = qn_vec2_sub (vertices[before], vertices[corner]);
  QnVec2 q = qn_vec2_sub (vertices[after], vertices[corner]);
  QnVec2 base = qn_vec2_sub (p, q);

  double deepest = 0;
  size_t found = corner;
  for (size_t i = 0; i < count; i++) {
    if (i == corner || i == before || i == after)
      continue;
    QnVec2 v = qn_vec2_sub (vertices[i], vertices[corner]);
    double from_base = qn_vec2_cross (base, qn_vec2_sub (v, q));
    if (qn_vec2_cross (q, v) >= 0 && qn_vec2_cross (v, p) >= 0 && from_base > deepest) {
      deepest = from_base;
      found = i;
    }
  }
  if (found != corner)
    return qn_vec2_lerp (vertices[corner], vertices[found], 0.5);
  return qn_vec2_add_scaled (vertices[corner], 1.0 / 3.0, qn_vec2_add (p, q));
}
