/* Shapes as triangles with smooth edges, for gl-batch.c. */
#pragma once

#include "render/backend/gl-batch.h"

/* Data common to all vertices of a shape. Its points are places in the model, or, if `in_points`, offsets
 * in pt from `at`. */
typedef struct QnGlBrush {
  QnGlBatch *batch;
  GArray *scratch;        /* of uint32_t */
  GArray *scratch_points; /* of QnVec2 */
  QnColor color;
  bool thin, in_points;
  QnVec2 at;
} QnGlBrush;

/* A simple polygon of either orientation, or four points with sides that cross: the two sides
 * of a joint that has opened about a hinge within it. Points may coincide with the next. */
void qn_gl_add_fill (const QnGlBrush *brush, const QnVec2 *points, uint32_t count);

/* A line with mitred corners and square ends; `width` in pt. */
void qn_gl_add_line (const QnGlBrush *brush, const QnVec2 *points, uint32_t count,
                     bool closed, bool dashed, double width);
