#include "render/backend/draw-cairo.h"

#include "render/drawing/marker-shape.h"
#include "render/drawing/paint.h"
#include "render/drawing/text.h"

/* Paper around labels that stand on hatching, pt. */
#define LABEL_HALO 1.0

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
  trace_points (scene, command, camera, command->closed, cr);
  qn_set_color (cr, command->color, 1);
  cairo_set_line_width (cr, command->size * camera->unit * line_factor);
  qn_set_dashes (cr, command->dashed, camera->unit);
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

void
qn_draw_cairo_marker (cairo_t *cr, QnMarker marker, double x, double y, double size,
                      double angle, bool mirrored, double unit, QnColor color)
{
  QnMarkerPath path;
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_width (cr, QN_RIM_WIDTH * unit);
  for (int part = 0; qn_marker_path (marker, part, angle, mirrored, &path); part++) {
    cairo_new_path (cr); /* text leaves a current point behind */
    for (int i = 0; i < path.count; i++)
      cairo_line_to (cr, x + size * path.points[i].x, y - size * path.points[i].y);
    if (path.closed)
      cairo_close_path (cr);
    if (path.paint == QN_MARKER_RIM) {
      qn_set_color (cr, qn_rgb (0xffffff), 1);
      cairo_fill_preserve (cr);
    }
    qn_set_color (cr, color, 1);
    if (path.paint == QN_MARKER_INK)
      cairo_fill (cr);
    else
      cairo_stroke (cr);
  }
}

/* ---- labels ---- */

/* Boxes may overlap by this part of the smaller side: letters do not fill their lines. */
#define LABEL_BLUR 0.12

/* Lines by which a label may move away from its place. */
#define FARTHEST_LABEL 5

/* Strokes of this width, pt, and thinner ones may run through labels of forces: those of pairs. */
#define THIN_FORCE 0.55

/* Between a label and a line through its place, pt. */
#define LINE_GAP 1.0

/* Width of the line from a joint or load to its number, where this has moved away, pt. */
#define LEADER 0.35

/* What the labels of a drawing take of the page, in the order in which they were drawn, and the lines
 * of loads and forces, which they keep clear of. */
typedef struct Labels {
  const QnCamera *camera;
  GArray *taken; /* of cairo_rectangle_t */
  GArray *lines; /* of QnVec2, px, two for each */
  bool optional; /* the next one may be left out */
  bool beside;   /* and stands beside its place: */
  bool leads;    /* or is led to from there, where it stands farther away: */
  QnVec2 at;     /* px */
  QnColor color;
  cairo_t *cr;
} Labels;

static bool
is_crossed (const cairo_rectangle_t *box, QnVec2 a, QnVec2 b)
{
  double right = box->x + box->width, below = box->y + box->height;
  if (fmax (a.x, b.x) < box->x || fmin (a.x, b.x) > right || fmax (a.y, b.y) < box->y
      || fmin (a.y, b.y) > below)
    return false;
  QnVec2 along = qn_vec2_sub (b, a);
  double low = INFINITY, high = -INFINITY; /* of the corners beside the line */
  for (int i = 0; i < 4; i++) {
    QnVec2 corner = { i % 2 == 0 ? box->x : right, i < 2 ? box->y : below };
    double side = qn_vec2_cross (along, qn_vec2_sub (corner, a));
    low = fmin (low, side);
    high = fmax (high, side);
  }
  return low <= 0 && high >= 0;
}

/* Loads in weights are as many as blocks, and names of blocks are placed beside them: they do not
 * count. */
static void
note_lines (Labels *labels, const QnScene *scene, const QnCommand *command, QnBox visible)
{
  const QnVec2 *points = qn_scene_points (scene, command);
  bool load = command->layer == QN_LAYER_LOADS && !(command->extent > 0);
  bool force = command->layer == QN_LAYER_FORCES && command->size > THIN_FORCE;
  if (command->kind != QN_COMMAND_STROKE || !(load || force)
      || !qn_command_is_visible (command, labels->camera, visible))
    return;
  for (uint32_t i = 1; i < command->count; i++)
    for (uint32_t k = i - 1; k <= i; k++) {
      QnVec2 end = qn_camera_to_screen (labels->camera, points[k]);
      g_array_append_val (labels->lines, end);
    }
}

static bool
is_taken (const Labels *labels, const cairo_rectangle_t *box)
{
  for (guint i = 0; i < labels->lines->len; i += 2)
    if (is_crossed (box, g_array_index (labels->lines, QnVec2, i),
                    g_array_index (labels->lines, QnVec2, i + 1)))
      return true;
  double blur = LABEL_BLUR * fmin (box->width, box->height);
  for (guint i = 0; i < labels->taken->len; i++) {
    const cairo_rectangle_t *b = &g_array_index (labels->taken, cairo_rectangle_t, i);
    if (box->x + box->width - blur > b->x && b->x + b->width > box->x + blur
        && box->y + box->height - blur > b->y && b->y + b->height > box->y + blur)
      return true;
  }
  return false;
}

/* A label that the drawing was made to fit lies at its edge, to a rounding error or so. */
static bool
is_inside (const QnCamera *camera, const cairo_rectangle_t *box)
{
  double x = box->x - camera->x, y = box->y - camera->y, edge = 0.5 * camera->unit;
  return x >= -edge && x + box->width <= camera->width + edge && y >= -edge
         && y + box->height <= camera->height + edge;
}

/* Right or left of its place, in the middle, above or below: where the label stands free. */
static bool
place_beside (const Labels *labels, cairo_rectangle_t *box)
{
  const double xs[2] = { box->x, 2 * labels->at.x - box->x - box->width };
  const double gap = LINE_GAP * labels->camera->unit;
  const double ys[3] = { box->y, labels->at.y - gap - box->height, labels->at.y + gap };
  for (int i = 0; i < 6; i++) {
    cairo_rectangle_t place = { xs[i / 3], ys[i % 3], box->width, box->height };
    if (is_taken (labels, &place) || (i > 0 && !is_inside (labels->camera, &place)))
      continue;
    *box = place;
    g_array_append_val (labels->taken, place);
    return true;
  }
  return false;
}

/* A line from the place of a label to where it stands; others keep clear of it. */
static void
lead_to (Labels *labels, const cairo_rectangle_t *box)
{
  QnVec2 end = { fmin (fmax (labels->at.x, box->x), box->x + box->width),
                 fmin (fmax (labels->at.y, box->y), box->y + box->height) };
  cairo_move_to (labels->cr, labels->at.x, labels->at.y);
  cairo_line_to (labels->cr, end.x, end.y);
  cairo_set_line_width (labels->cr, LEADER * labels->camera->unit);
  qn_set_color (labels->cr, labels->color, 1);
  cairo_stroke (labels->cr);
  g_array_append_val (labels->lines, labels->at);
  g_array_append_val (labels->lines, end);
}

/* The nearest free place around; where there is none the label stays where it belongs. */
static bool
place_around (Labels *labels, cairo_rectangle_t *box)
{
  static const int ways[8][2] = { { 0, -1 }, { 0, 1 },   { 1, 0 }, { -1, 0 },
                                  { 1, -1 }, { -1, -1 }, { 1, 1 }, { -1, 1 } };
  const double gap = LINE_GAP * labels->camera->unit;
  for (int ring = 0; ring <= 2 * FARTHEST_LABEL; ring++)
    for (int i = 0; i < (ring == 0 ? 1 : 8); i++) {
      cairo_rectangle_t place = *box;
      place.x += 0.5 * ring * ways[i][0] * box->width;
      place.y += 0.5 * ring * ways[i][1] * box->height;
      cairo_rectangle_t apart = { place.x - gap, place.y, place.width + 2 * gap,
                                  place.height };
      if (is_taken (labels, &apart) || (ring > 0 && !is_inside (labels->camera, &place)))
        continue;
      *box = place;
      if (ring > 1)
        lead_to (labels, box);
      g_array_append_val (labels->taken, *box);
      return true;
    }
  g_array_append_val (labels->taken, *box);
  return true;
}

/* The nearest free place above or below, of upright text beside. What has room elsewhere after
 * zooming in is left out; what has none stays where it belongs. */
static bool
place_label (void *data, cairo_rectangle_t *box)
{
  Labels *labels = data;
  if (labels->optional && labels->beside)
    return place_beside (labels, box);
  if (labels->leads)
    return place_around (labels, box);
  const bool level = box->width >= box->height;
  const double step = (1 - LABEL_BLUR) * (level ? box->height : box->width);
  for (int i = 0; i <= 2 * FARTHEST_LABEL; i++) {
    double way = (i % 2 == 1 ? -1 : 1) * (i + 1) / 2 * step;
    cairo_rectangle_t place = *box;
    *(level ? &place.y : &place.x) += way;
    if (is_taken (labels, &place) || (i > 0 && !is_inside (labels->camera, &place))) {
      if (labels->optional)
        return false;
      continue;
    }
    *box = place;
    break;
  }
  g_array_append_val (labels->taken, *box);
  return true;
}

static void
draw_text (cairo_t *cr, const QnCommand *command, QnVec2 at, Labels *labels)
{
  const bool label = command->layer == QN_LAYER_LABELS;
  const double unit = labels->camera->unit;
  labels->optional = command->extent > 0;
  labels->beside = command->align_x < 0 || command->align_x > 1;
  labels->leads = command->pick != QN_PICK_NOTHING;
  labels->at = at;
  labels->color = command->color;
  qn_text_draw (cr,
                &(QnTextStyle){ .size = command->size * unit,
                                .halo = label ? LABEL_HALO * unit : 0,
                                .place = label ? place_label : NULL,
                                .place_data = labels },
                command->text, at.x, at.y, command->align_x, 1 - command->align_y,
                command->angle, command->color);
}

void
qn_draw_cairo (const QnScene *scene, const QnCamera *camera, unsigned layers, cairo_t *cr)
{
  QnBox visible = qn_camera_visible_box (camera);
  double line_factor = qn_scene_line_factor (scene, camera);
  Labels labels = { .camera = camera,
                    .cr = cr,
                    .taken = g_array_new (FALSE, FALSE, sizeof (cairo_rectangle_t)),
                    .lines = g_array_new (FALSE, FALSE, sizeof (QnVec2)) };
  cairo_save (cr);
  cairo_rectangle (cr, camera->x, camera->y, camera->width, camera->height);
  cairo_clip (cr);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_MITER);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (layers & 1u << QN_LAYER_LABELS)
      note_lines (&labels, scene, command, visible);
    if (!(layers & 1u << command->layer)
        || !qn_command_is_visible (command, camera, visible))
      continue;
    QnVec2 s = { 0, 0 };
    if (command->count > 0)
      s = qn_camera_to_screen (camera, *qn_scene_points (scene, command));
    switch ((QnCommandKind) command->kind) {
    case QN_COMMAND_FILL:
      trace_points (scene, command, camera, true, cr);
      qn_set_color (cr, command->color, 1);
      cairo_fill (cr);
      break;
    case QN_COMMAND_STROKE:
      draw_stroke (scene, command, camera,
                   qn_command_is_thinned (command) ? line_factor : 1, cr);
      break;
    case QN_COMMAND_MARKER:
      qn_draw_cairo_marker (cr, (QnMarker) command->marker, s.x, s.y,
                            command->size * camera->unit, command->angle,
                            command->mirrored, camera->unit, command->color);
      break;
    case QN_COMMAND_TEXT:
      draw_text (cr, command, s, &labels);
      break;
    case QN_COMMAND_IMAGE:
      draw_image (scene, command, camera, cr);
      break;
    }
  }
  cairo_restore (cr);
  g_array_unref (labels.taken);
  g_array_unref (labels.lines);
}
