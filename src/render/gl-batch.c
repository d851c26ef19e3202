#include "render/gl-batch.h"

#include "render/marker-shape.h"
#include "render/triangulate.h"

/* What is the same for all vertices of a command. */
typedef struct Brush {
  QnGlBatch *batch;
  QnColor color;
  bool thin;
} Brush;

static uint32_t
add_vertex (const Brush *brush, QnVec2 place, QnVec2 offset, double along)
{
  QnColor c = brush->color;
  QnGlVertex v = {
    .place = { (float) (place.x - brush->batch->origin.x),
               (float) (place.y - brush->batch->origin.y) },
    .offset = { (float) offset.x, (float) offset.y },
    .along = (float) along,
    .color = { c.r, c.g, c.b, c.a },
    .thin = { brush->thin ? 255 : 0, 0, 0, 0 },
  };
  g_array_append_val (brush->batch->vertices, v);
  return brush->batch->vertices->len - 1;
}

static void
add_triangle (const Brush *brush, uint32_t a, uint32_t b, uint32_t c)
{
  uint32_t indices[3] = { a, b, c };
  g_array_append_vals (brush->batch->indices, indices, 3);
}

/* The sides of a line drawn from place to place, or, for markers, from offset to offset. A
 * joined end is longer by half the width, which makes square corners. */
typedef struct Segment {
  QnVec2 place[2], offset[2]; /* m, pt */
  QnVec2 direction;           /* unit */
  double half_width;          /* pt */
  bool joined[2];
  double along[2];
} Segment;

static void
add_segment (const Brush *brush, const Segment *s)
{
  uint32_t corners[4];
  QnVec2 side = qn_vec2_scale (s->half_width, qn_vec2_perp (s->direction));
  for (int end = 0; end < 2; end++) {
    double beyond = s->joined[end] ? s->half_width : 0;
    QnVec2 tip =
      qn_vec2_add_scaled (s->offset[end], end == 0 ? -beyond : beyond, s->direction);
    corners[2 * end] =
      add_vertex (brush, s->place[end], qn_vec2_add (tip, side), s->along[end]);
    corners[2 * end + 1] =
      add_vertex (brush, s->place[end], qn_vec2_sub (tip, side), s->along[end]);
  }
  add_triangle (brush, corners[0], corners[1], corners[2]);
  add_triangle (brush, corners[2], corners[1], corners[3]);
}

static void
add_stroke (const Brush *brush, const QnScene *scene, const QnCommand *command)
{
  const QnVec2 *p = qn_scene_points (scene, command);
  uint32_t n = command->count, segments = command->closed ? n : n - 1;
  double along = 0;
  for (uint32_t i = 0; n >= 2 && i < segments; i++) {
    QnVec2 a = p[i], b = p[(i + 1) % n], d = qn_vec2_sub (b, a);
    double length = qn_vec2_length (d);
    if (!(length > 0))
      continue;
    Segment s = { .place = { a, b },
                  .direction = qn_vec2_scale (1 / length, d),
                  .half_width = 0.5 * command->size,
                  .joined = { command->closed || i > 0,
                              command->closed || i + 1 < segments },
                  .along = { -1, -1 } };
    if (command->dashed) {
      s.along[0] = along;
      s.along[1] = along + length;
    }
    along += length;
    add_segment (brush, &s);
  }
}

static void
add_fill (const Brush *brush, const QnVec2 *points, uint32_t count, GArray *scratch)
{
  if (count < 3)
    return;
  g_array_set_size (scratch, 4 * count);
  uint32_t *indices = &g_array_index (scratch, uint32_t, 0), *order = indices + 3 * count;
  uint32_t base = brush->batch->vertices->len;
  for (uint32_t i = 0; i < count; i++)
    add_vertex (brush, points[i], qn_vec2 (0, 0), -1);
  size_t n = qn_triangulate (points, count, indices, order);
  for (size_t i = 0; i + 2 < n; i += 3)
    add_triangle (brush, base + indices[i], base + indices[i + 1], base + indices[i + 2]);
}

static void
add_marker_fill (const Brush *brush, QnVec2 at, const QnMarkerPath *path)
{
  uint32_t base = brush->batch->vertices->len;
  for (int i = 0; i < path->count; i++)
    add_vertex (brush, at, path->points[i], -1);
  for (int i = 1; i + 1 < path->count; i++)
    add_triangle (brush, base, base + (uint32_t) i, base + (uint32_t) i + 1);
}

static void
add_marker_lines (const Brush *brush, QnVec2 at, const QnMarkerPath *path)
{
  int segments = path->closed ? path->count : path->count - 1;
  for (int i = 0; i < segments; i++) {
    QnVec2 a = path->points[i], b = path->points[(i + 1) % path->count];
    QnVec2 d = qn_vec2_sub (b, a);
    Segment s = { .place = { at, at },
                  .offset = { a, b },
                  .direction = qn_vec2_scale (1 / qn_vec2_length (d), d),
                  .half_width = 0.5 * QN_RIM_WIDTH,
                  .joined = { path->closed, path->closed },
                  .along = { -1, -1 } };
    /* The sides of a circle meet so flatly that they need no corner. */
    if (path->count == QN_MARKER_POINTS)
      s.joined[0] = s.joined[1] = false;
    add_segment (brush, &s);
  }
}

static void
add_marker (const Brush *brush, const QnScene *scene, const QnCommand *command)
{
  QnVec2 at = *qn_scene_points (scene, command);
  double c = cos (command->angle), s = sin (command->angle);
  double flip = command->mirrored ? -1 : 1;
  QnMarkerPath path;
  for (int part = 0; qn_marker_path ((QnMarker) command->marker, part, &path); part++) {
    for (int i = 0; i < path.count; i++) {
      QnVec2 p = qn_vec2 (path.points[i].x, flip * path.points[i].y);
      path.points[i] = qn_vec2_scale (command->size, qn_vec2_rotate (p, c, s));
    }
    if (path.paint == QN_MARKER_RIM) {
      Brush paper = *brush;
      paper.color = qn_rgb (0xffffff);
      add_marker_fill (&paper, at, &path);
    }
    if (path.paint == QN_MARKER_INK)
      add_marker_fill (brush, at, &path);
    else
      add_marker_lines (brush, at, &path);
  }
}

void
qn_gl_batch_init (QnGlBatch *batch, const QnScene *scene)
{
  guint count = scene->commands->len;
  g_autoptr (GArray) scratch = g_array_new (FALSE, FALSE, sizeof (uint32_t));
  *batch = (QnGlBatch){
    .vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnGlVertex), 10 * count),
    .indices = g_array_sized_new (FALSE, FALSE, sizeof (uint32_t), 16 * count),
    .ranges = g_new0 (QnGlRange, MAX (count, 1)),
  };
  if (!qn_box_is_empty (scene->box))
    batch->origin = qn_vec2_lerp (scene->box.min, scene->box.max, 0.5);
  for (guint i = 0; i < count; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    Brush brush = { batch, command->color, qn_command_is_thinned (command) };
    batch->ranges[i].first = batch->indices->len;
    switch ((QnCommandKind) command->kind) {
    case QN_COMMAND_FILL:
      add_fill (&brush, qn_scene_points (scene, command), command->count, scratch);
      break;
    case QN_COMMAND_STROKE:
      add_stroke (&brush, scene, command);
      break;
    case QN_COMMAND_MARKER:
      add_marker (&brush, scene, command);
      break;
    case QN_COMMAND_TEXT:
    case QN_COMMAND_IMAGE:
      break;
    }
    batch->ranges[i].count = batch->indices->len - batch->ranges[i].first;
  }
}

void
qn_gl_batch_clear (QnGlBatch *batch)
{
  g_clear_pointer (&batch->vertices, g_array_unref);
  g_clear_pointer (&batch->indices, g_array_unref);
  g_clear_pointer (&batch->ranges, g_free);
}
