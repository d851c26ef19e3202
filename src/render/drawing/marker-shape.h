/* The shapes of markers, once for every back end: paths in units of the marker's size. */
#pragma once

#include "render/drawing/scene.h"

#define QN_MARKER_POINTS 32

/* Width of the lines and rims of markers, pt. */
#define QN_RIM_WIDTH 0.9

typedef enum {
  QN_MARKER_INK,  /* filled with the marker's colour */
  QN_MARKER_RIM,  /* filled with paper white, then stroked */
  QN_MARKER_LINES /* stroked */
} QnMarkerPaint;

typedef struct QnMarkerPath {
  QnMarkerPaint paint;
  bool closed;
  int count;
  QnVec2 points[QN_MARKER_POINTS];
} QnMarkerPath;

/* The `part`-th path of a marker, from 0, turned counter-clockwise by an angle; mirrored about its axis before.
 * False when there are no more. */
bool qn_marker_path (QnMarker marker, int part, double angle, bool mirrored,
                     QnMarkerPath *path);
