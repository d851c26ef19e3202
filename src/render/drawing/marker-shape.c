#include "render/drawing/marker-shape.h"

/* Paths of the markers; of a circle the points are computed. */
static const struct {
  QnMarkerPaint paint;
  bool closed;
  int count;
  QnVec2 points[4];
} shapes[QN_MARKER_COUNT][2] = {
  [QN_MARKER_DOT] = { { QN_MARKER_INK, true, QN_MARKER_POINTS, { { 0, 0 } } } },
  [QN_MARKER_RING] = { { QN_MARKER_RIM, true, QN_MARKER_POINTS, { { 0, 0 } } } },
  /* A shaft with half a head; the second half arrow is the first turned about the middle. */
  [QN_MARKER_SLIDE] = { { QN_MARKER_LINES,
                          false,
                          3,
                          { { -0.5, 0.16 }, { 0.5, 0.16 }, { 0.22, 0.36 } } },
                        { QN_MARKER_LINES,
                          false,
                          3,
                          { { 0.5, -0.16 }, { -0.5, -0.16 }, { -0.22, -0.36 } } } },
  [QN_MARKER_CROSS] = { { QN_MARKER_LINES, false, 2, { { -0.5, -0.5 }, { 0.5, 0.5 } } },
                        { QN_MARKER_LINES, false, 2, { { -0.5, 0.5 }, { 0.5, -0.5 } } } },
  [QN_MARKER_ARROW_HEAD] = { { QN_MARKER_INK,
                               true,
                               3,
                               { { 0, 0 }, { -1, 0.36 }, { -1, -0.36 } } } },
  [QN_MARKER_SQUARE] = { { QN_MARKER_INK,
                           true,
                           4,
                           { { -0.5, -0.5 },
                             { 0.5, -0.5 },
                             { 0.5, 0.5 },
                             { -0.5, 0.5 } } } },
  [QN_MARKER_DIAMOND] = { { QN_MARKER_RIM,
                            true,
                            4,
                            { { -0.5, 0 }, { 0, -0.5 }, { 0.5, 0 }, { 0, 0.5 } } } },
  [QN_MARKER_TICK] = { { QN_MARKER_LINES,
                         false,
                         2,
                         { { -0.3536, -0.3536 }, { 0.3536, 0.3536 } } } },
};

bool
qn_marker_path (QnMarker marker, int part, double angle, bool mirrored,
                QnMarkerPath *path)
{
  const int count = part < 2 ? shapes[marker][part].count : 0;
  const double c = cos (angle), s = sin (angle), flip = mirrored ? -1 : 1;
  if (count == 0)
    return false;
  path->paint = shapes[marker][part].paint;
  path->closed = shapes[marker][part].closed;
  path->count = count;
  for (int i = 0; i < count; i++) {
    /* A polygon of so many sides is a circle at the sizes of markers. */
    double turn = 2 * G_PI * i / QN_MARKER_POINTS;
    QnVec2 p = count == QN_MARKER_POINTS ? qn_vec2 (0.5 * cos (turn), 0.5 * sin (turn))
                                         : shapes[marker][part].points[i];
    path->points[i] = qn_vec2_rotate (qn_vec2 (p.x, flip * p.y), c, s);
  }
  return true;
}
