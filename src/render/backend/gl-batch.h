/* A scene as triangles: one vertex and one index array for all of it, good for every camera.
 *
 * A vertex is a place in the model plus an offset in points on the screen, so that lines and
 * markers keep their size while the picture is zoomed without anything being uploaded again.
 *
 * Edges are smooth without several samples a pixel: every vertex says how far it lies inside
 * up to four straight edges, and shapes are grown by half a pixel so that a fragment learns
 * from these distances how much of its pixel is covered. Edges 0 and 2, and 1 and 3, face each
 * other: the part of a pixel between two parallel edges is exact however thin the shape. */
#pragma once

#include "render/drawing/scene.h"

/* Steps of a pixel in which growth is stored. */
#define QN_GL_GROWTH_STEPS 60

typedef struct QnGlVertex {
  float place[2];  /* m from the batch's origin */
  float offset[2]; /* pt, y up */
  float reach[4];  /* distance from the edges, inwards, m or pt; in the ungrown shape */
  uint8_t color[4];
  uint8_t
    flags[4];     /* 255 where so: the line factor of the scene applies; edges 0 and 2 in
                        pt; edges 1 and 3 in pt; dashed along the distance from edge 1 */
  int8_t grow[2]; /* px / QN_GL_GROWTH_STEPS, y up: outwards */
  int8_t rim[4];  /* px / QN_GL_GROWTH_STEPS: what growing adds to the distances */
  uint8_t unused[2]; /* to whole words */
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
