#include "render/drawing/marker-shape.h"

static void
set_points (QnMarkerPath *path, QnMarkerPaint paint, bool closed, int count,
            const QnVec2 *points)
{
  *path = (QnMarkerPath){ .paint = paint, .closed = closed, .count = count };
  for (int i = 0; i < count; i++)
    path->points[i] = points[i];
}

/* A polygon of so many sides is a circle at the sizes of markers. */
static void
set_circle (QnMarkerPath *path, QnMarkerPaint paint)
{
  *path = (QnMarkerPath){ .paint = paint, .closed = true, .count = QN_MARKER_POINTS };
  for (int i = 0; i < QN_MARKER_POINTS; i++) {
    double angle = 2 * G_PI * i / QN_MARKER_POINTS;
    path->points[i] = qn_vec2 (0.5 * cos (angle), 0.5 * sin (angle));
  }
}

/* A shaft with half a head; the second half arrow is the first turned about the middle. */
static void
set_half_arrow (QnMarkerPath *path, double turn)
{
  const QnVec2 points[3] = { { -0.5 * turn, 0.16 * turn },
                             { 0.5 * turn, 0.16 * turn },
                             { 0.22 * turn, 0.36 * turn } };
  set_points (path, QN_MARKER_LINES, false, 3, points);
}

bool
qn_marker_path (QnMarker marker, int part, QnMarkerPath *path)
{
  static const QnVec2 head[3] = { { 0, 0 }, { -1, 0.36 }, { -1, -0.36 } };
  static const QnVec2 square[4] = {
    { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 }
  };
  static const QnVec2 diamond[4] = { { -0.5, 0 }, { 0, -0.5 }, { 0.5, 0 }, { 0, 0.5 } };
  static const QnVec2 strokes[2][2] = { { { -0.5, -0.5 }, { 0.5, 0.5 } },
                                        { { -0.5, 0.5 }, { 0.5, -0.5 } } };
  static const QnVec2 tick[2] = { { -0.3536, -0.3536 }, { 0.3536, 0.3536 } };
  int parts = marker == QN_MARKER_SLIDE || marker == QN_MARKER_CROSS ? 2 : 1;
  if (part >= parts)
    return false;
  switch (marker) {
  case QN_MARKER_DOT:
    set_circle (path, QN_MARKER_INK);
    return true;
  case QN_MARKER_RING:
    set_circle (path, QN_MARKER_RIM);
    return true;
  case QN_MARKER_SLIDE:
    set_half_arrow (path, part == 0 ? 1 : -1);
    return true;
  case QN_MARKER_CROSS:
    set_points (path, QN_MARKER_LINES, false, 2, strokes[part]);
    return true;
  case QN_MARKER_ARROW_HEAD:
    set_points (path, QN_MARKER_INK, true, 3, head);
    return true;
  case QN_MARKER_SQUARE:
    set_points (path, QN_MARKER_INK, true, 4, square);
    return true;
  case QN_MARKER_DIAMOND:
    set_points (path, QN_MARKER_RIM, true, 4, diamond);
    return true;
  case QN_MARKER_TICK:
    set_points (path, QN_MARKER_LINES, false, 2, tick);
    return true;
  case QN_MARKER_COUNT:
    break;
  }
  return false;
}
