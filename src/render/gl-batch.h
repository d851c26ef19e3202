/* A scene as triangles: one vertex and one index array for all of it, good for every camera.
 *
 * A vertex is a place in the model plus an offset in points on the screen, so that lines and
 * markers keep their size while the picture is zoomed without anything being uploaded again. */
#ifndef QN_RENDER_GL_BATCH_H
#define QN_RENDER_GL_BATCH_H

#include "render/scene.h"

typedef struct QnGlVertex {
  float place[2];  /* m from the batch's origin */
  float offset[2]; /* pt, y up */
  float along;     /* m, distance along a dashed line; -1: solid */
  uint8_t color[4];
  uint8_t thin[4]; /* first: 255 where the line factor of the scene applies */
} QnGlVertex;

typedef struct QnGlRange {
  uint32_t first, count; /* indices of one command */
} QnGlRange;

typedef struct QnGlBatch {
  QnVec2 origin;
  GArray *vertices;  /* of QnGlVertex */
  GArray *indices;   /* of uint32_t */
  QnGlRange *ranges; /* one per command of the scene; empty for text and images */
} QnGlBatch;

void qn_gl_batch_init (QnGlBatch *batch, const QnScene *scene);
void qn_gl_batch_clear (QnGlBatch *batch);

#endif
