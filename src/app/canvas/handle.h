/* Handles: the small squares by which what is selected is dragged. Openings, walls, arches and
 * columns by their measures, blocks by their corners, any selection around its middle. */
#pragma once

#include "app/canvas/canvas.h"
#include "doc/masonry/masonry-shape.h"

/* The handle at a place of the screen; FALSE where there is none. */
gboolean qn_handle_find (QnCanvas *canvas, QnVec2 screen, QnGrip *grip);

/* Begins to drag it. */
void qn_handle_begin (QnCanvas *canvas, QnGrip grip);

/* Handles of what is selected. */
void qn_handle_draw_all (QnCanvas *canvas, cairo_t *cr);

/* What dragging the grip to the gesture's end would give. */
void qn_handle_draw_drag (QnCanvas *canvas, cairo_t *cr);

/* Turns the selection by an angle (rad) about the middle that the grip has, and ends the gesture. */
void qn_handle_turn (QnCanvas *canvas, double angle);

/* Does it, and ends the gesture. */
void qn_handle_finish (QnCanvas *canvas);
