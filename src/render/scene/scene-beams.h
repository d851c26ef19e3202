/* Shared by the drawings of beams; private to the scene-*.c files. */
#pragma once

#include "core/assembly/assembly.h"
#include "render/scene/scene-builder.h"

typedef struct QnBeamDrawing {
  const QnSceneBuilder *builder;
  const QnBeamForces
    *forces;     /* of the step, by element; NULL: not known, or not wanted */
  QnVec2 *loads; /* on elements at the step, N/m; with forces */
  bool bent;     /* drawn with the deflection by these forces; a mechanism is not */
} QnBeamDrawing;

void qn_beam_drawing_init (QnBeamDrawing *drawing, const QnSceneBuilder *builder);
void qn_beam_drawing_clear (QnBeamDrawing *drawing);

/* The point at x = s L of an element as drawn, bent by its forces; and the direction of y. */
QnVec2 qn_beam_drawing_place (const QnBeamDrawing *drawing, QnId element, double s,
                              QnVec2 *across);

/* A node as drawn. */
QnVec2 qn_builder_place_node (const QnSceneBuilder *builder, QnId node);
