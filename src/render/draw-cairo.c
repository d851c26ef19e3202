#include "render/draw-cairo.h"

#include "render/text.h"

static void
set_color (cairo_t *cr, QnColor color)
{
  cairo_set_source_rgba (cr, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                         color.a / 255.0);
}

static void
trace_points (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
              bool closed, cairo_t *cr)
{
  const QnVec2 *points = qn_scene_points (scene, command);
  for (uint32_t i = 0; i < command->count; i++) {
    QnVec2 s = qn_camera_to_screen (camera, points[i]);
    cairo_line_to (cr, s.x, s.y);
  }
  if (closed)
    cairo_close_path (cr);
}

static void
draw_stroke (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
             double line_factor, cairo_t *cr)
{
  double dashes[2] = { 4 * camera->unit, 2.5 * camera->unit };
  trace_points (scene, command, camera, command->closed, cr);
  set_color (cr, command->color);
  cairo_set_line_width (cr, command->size * camera->unit * line_factor);
  cairo_set_dash (cr, dashes, command->dashed ? 2 : 0, 0);
  cairo_stroke (cr);
}

static void
draw_image (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
            cairo_t *cr)
{
  const QnVec2 *p = qn_scene_points (scene, command);
  QnVec2 low_left = qn_camera_to_screen (camera, p[0]);
  QnVec2 low_right = qn_camera_to_screen (camera, p[1]);
  QnVec2 top_left = qn_camera_to_screen (camera, p[3]);
  double columns = cairo_image_surface_get_width (scene->image);
  double rows = cairo_image_surface_get_height (scene->image);
  cairo_matrix_t to_page = {
    .xx = (low_right.x - low_left.x) / columns,
    .yx = (low_right.y - low_left.y) / columns,
    .xy = (low_left.x - top_left.x) / rows,
    .yy = (low_left.y - top_left.y) / rows,
    .x0 = top_left.x,
    .y0 = top_left.y,
  };
  cairo_save (cr);
  cairo_transform (cr, &to_page);
  cairo_set_source_surface (cr, scene->image, 0, 0);
  cairo_paint_with_alpha (cr, command->color.a / 255.0);
  cairo_restore (cr);
}

static void
draw_half_arrow (cairo_t *cr, double size)
{
  double rise = 0.16 * size;
  cairo_move_to (cr, -0.5 * size, -rise);
  cairo_line_to (cr, 0.5 * size, -rise);
  cairo_line_to (cr, 0.22 * size, -rise - 0.2 * size);
}

static void
trace_marker (cairo_t *cr, QnMarker marker, double size)
{
  double h = 0.5 * size;
  switch (marker) {
  case QN_MARKER_DOT:
  case QN_MARKER_RING:
    cairo_new_sub_path (cr);
    cairo_arc (cr, 0, 0, h, 0, 2 * G_PI);
    break;
  case QN_MARKER_SLIDE:
    draw_half_arrow (cr, size);
    cairo_rotate (cr, G_PI);
    draw_half_arrow (cr, size);
    cairo_rotate (cr, -G_PI);
    break;
  case QN_MARKER_CROSS:
    cairo_move_to (cr, -h, -h);
    cairo_line_to (cr, h, h);
    cairo_move_to (cr, -h, h);
    cairo_line_to (cr, h, -h);
    break;
  case QN_MARKER_ARROW_HEAD:
    cairo_move_to (cr, 0, 0);
    cairo_line_to (cr, -size, -0.36 * size);
    cairo_line_to (cr, -size, 0.36 * size);
    cairo_close_path (cr);
    break;
  case QN_MARKER_SQUARE:
    cairo_rectangle (cr, -h, -h, size, size);
    break;
  case QN_MARKER_DIAMOND:
    cairo_move_to (cr, -h, 0);
    cairo_line_to (cr, 0, -h);
    cairo_line_to (cr, h, 0);
    cairo_line_to (cr, 0, h);
    cairo_close_path (cr);
    break;
  case QN_MARKER_TICK:
    cairo_move_to (cr, -h * G_SQRT2 / 2, h * G_SQRT2 / 2);
    cairo_line_to (cr, h * G_SQRT2 / 2, -h * G_SQRT2 / 2);
    break;
  case QN_MARKER_COUNT:
    break;
  }
}

static void
draw_marker (cairo_t *cr, QnMarker marker, double x, double y, double size, double angle,
             bool mirrored, double unit, QnColor color)
{
  cairo_save (cr);
  cairo_translate (cr, x, y);
  cairo_rotate (cr, -angle);
  if (mirrored)
    cairo_scale (cr, 1, -1);
  trace_marker (cr, marker, size);
  cairo_restore (cr);

  cairo_set_dash (cr, NULL, 0, 0);
  switch (marker) {
  case QN_MARKER_DOT:
  case QN_MARKER_ARROW_HEAD:
  case QN_MARKER_SQUARE:
    set_color (cr, color);
    cairo_fill (cr);
    break;
  case QN_MARKER_RING:
  case QN_MARKER_DIAMOND:
    set_color (cr, qn_rgb (0xffffff));
    cairo_fill_preserve (cr);
    set_color (cr, color);
    cairo_set_line_width (cr, QN_RIM_WIDTH * unit);
    cairo_stroke (cr);
    break;
  case QN_MARKER_SLIDE:
  case QN_MARKER_CROSS:
  case QN_MARKER_TICK:
  case QN_MARKER_COUNT:
    set_color (cr, color);
    cairo_set_line_width (cr, QN_RIM_WIDTH * unit);
    cairo_stroke (cr);
    break;
  }
}

void
qn_draw_cairo_marker (cairo_t *cr, QnMarker marker, double x, double y, double size,
                      double angle, double unit, QnColor color)
{
  draw_marker (cr, marker, x, y, size, angle, false, unit, color);
}

static void
draw_command (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
              double line_factor, cairo_t *cr)
{
  QnVec2 s = { 0, 0 };
  if (command->count > 0)
    s = qn_camera_to_screen (camera, *qn_scene_points (scene, command));
  switch ((QnCommandKind) command->kind) {
  case QN_COMMAND_FILL:
    trace_points (scene, command, camera, true, cr);
    set_color (cr, command->color);
    cairo_fill (cr);
    break;
  case QN_COMMAND_STROKE:
    draw_stroke (scene, command, camera,
                 qn_command_is_thinned (command) ? line_factor : 1, cr);
    break;
  case QN_COMMAND_MARKER:
    draw_marker (cr, (QnMarker) command->marker, s.x, s.y, command->size * camera->unit,
                 command->angle, command->mirrored, camera->unit, command->color);
    break;
  case QN_COMMAND_TEXT:
    qn_text_draw (cr, &(QnTextStyle){ .size = command->size * camera->unit },
                  command->text, s.x, s.y, command->align_x, 1 - command->align_y,
                  command->angle, command->color);
    break;
  case QN_COMMAND_IMAGE:
    draw_image (scene, command, camera, cr);
    break;
  }
}

void
qn_draw_cairo (const QnScene *scene, const QnCamera *camera, unsigned layers,
               bool antialias, cairo_t *cr, QnDrawCounts *counts)
{
  QnBox visible = qn_camera_visible_box (camera);
  double line_factor = qn_scene_line_factor (scene, camera);
  QnDrawCounts tally = { 0, 0 };
  cairo_save (cr);
  cairo_rectangle (cr, camera->x, camera->y, camera->width, camera->height);
  cairo_clip (cr);
  cairo_set_antialias (cr, antialias ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_MITER);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (!(layers & 1u << command->layer))
      continue;
    if (!qn_command_is_visible (command, camera, visible)) {
      tally.skipped++;
      continue;
    }
    draw_command (scene, command, camera, line_factor, cr);
    tally.drawn++;
  }
  cairo_restore (cr);
  if (counts != NULL)
    *counts = tally;
}
