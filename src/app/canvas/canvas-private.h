/* The inside of the drawing widget, shared by the files that make it up. */
#pragma once

#include "app/canvas/canvas.h"
#include "render/scene/motion.h"

/* The scene of the present state, built when needed; NULL where there is nothing to show. */
const QnScene *qn_canvas_get_scene (QnCanvas *canvas);

/* What is under the scene, and over it. The photo and the labels of the scene belong to them
 * where OpenGL draws the rest. */
void qn_canvas_draw_below (QnCanvas *canvas, gboolean with_photo, cairo_t *cr);
void qn_canvas_draw_above (QnCanvas *canvas, gboolean with_labels, cairo_t *cr);

/* canvas-inspect.c: the card beside the pointer, and places of what is displaced. */
void qn_canvas_draw_inspected (QnCanvas *canvas, cairo_t *cr);
void qn_canvas_pointer_moved (QnCanvas *canvas);

/* How the blocks are displaced in the scene that is shown; its model NULL: there is none. */
QnMotion qn_canvas_get_motion (QnCanvas *canvas);
/* The outline of a block there. */
void qn_canvas_trace_placed (QnCanvas *canvas, cairo_t *cr, const QnMotion *motion,
                             const QnModel *model, QnId block);
/* A joint on the screen. */
void qn_canvas_joint_line (QnCanvas *canvas, const QnMotion *motion,
                           const QnContactFace *face, QnVec2 line[2]);

/* What the legend covers at the lower left, px. */
QnBox qn_canvas_legend_box (QnCanvas *canvas, const QnScene *scene);

/* Text in the widget's font, as large on the drawing as what the scene says in so many points. */
PangoLayout *qn_canvas_make_text (QnCanvas *canvas, const char *text, double points);

/* Draws everything by Cairo. */
void qn_canvas_draw (QnCanvas *canvas, cairo_t *cr);

/* canvas-pointer.c, canvas-camera.c, canvas-keys.c: what canvas.ui calls, as the user does things to the drawing. */
void qn_canvas_bind_pointer (GtkWidgetClass *klass);
void qn_canvas_bind_camera (GtkWidgetClass *klass);
void qn_canvas_bind_keys (GtkWidgetClass *klass);

/* Puts the pointer somewhere, and presses and releases there, as the mouse would; px. */
void qn_canvas_point (QnCanvas *canvas, QnVec2 screen, GdkModifierType modifiers);
void qn_canvas_click (QnCanvas *canvas, GdkModifierType modifiers);

/* Moves the camera so that everything is in view. */
void qn_canvas_fit_now (QnCanvas *canvas);

/* Emits the signal of canvas.h. */
void qn_canvas_emit_status (QnCanvas *canvas);

/* Distance of grid lines at the present zoom, m. */
double qn_canvas_grid_distance (QnCanvas *canvas);
