#include "render/backend/gl-batch.h"

#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "render/drawing/marker-shape.h"

#include <string.h>

/* Distance from an edge that is not there, m or pt. */
#define FAR_AWAY 1e9f

/* Corners sharper than this many half widths are cut: 29 degrees. */
#define MITRE_LIMIT 4.0

/* How far shapes are grown, px: half a pixel, the reach of a pixel's own area. */
#define GROWTH 0.5

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

static int8_t
growth_steps (double px)
{
  return (int8_t) qn_to_integer (round (px * QN_GL_GROWTH_STEPS), -127, 127);
}

/* A vertex inside all edges, of the brush's colour. */
static QnGlVertex
make_vertex (const QnGlBrush *brush, QnVec2 point, QnVec2 grow)
{
  QnVec2 place = brush->in_points ? brush->at : point;
  QnVec2 offset = brush->in_points ? point : qn_vec2 (0, 0);
  QnColor c = brush->color;
  return (QnGlVertex){
    .place = { (float) (place.x - brush->batch->origin.x),
               (float) (place.y - brush->batch->origin.y) },
    .offset = { (float) offset.x, (float) offset.y },
    .reach = { FAR_AWAY, FAR_AWAY, FAR_AWAY, FAR_AWAY },
    .color = { c.r, c.g, c.b, c.a },
    .flags = { brush->thin ? 255 : 0, brush->in_points ? 255 : 0,
               brush->in_points ? 255 : 0, 0 },
    .grow = { growth_steps (grow.x), growth_steps (grow.y) },
  };
}

static uint32_t
add_vertex (const QnGlBrush *brush, QnGlVertex vertex)
{
  g_array_append_val (brush->batch->vertices, vertex);
  return brush->batch->vertices->len - 1;
}

static void
add_triangle (const QnGlBrush *brush, uint32_t a, uint32_t b, uint32_t c)
{
  uint32_t indices[3] = { a, b, c };
  g_array_append_vals (brush->batch->indices, indices, 3);
}

/* Where two sides with these unit normals meet, both moved by 1: (n + m) / (1 + n . m). False
 * where that is farther away than the limit. */
static bool
mitre (QnVec2 n, QnVec2 m, QnVec2 *corner)
{
  double denominator = 1 + qn_vec2_dot (n, m);
  bool blunt = denominator > 2 / (MITRE_LIMIT * MITRE_LIMIT);
  *corner = qn_vec2_scale (1 / fmax (denominator, 2 / (MITRE_LIMIT * MITRE_LIMIT)),
                           qn_vec2_add (n, m));
  return blunt;
}

/* Gathers the points that differ from their neighbours in the brush's scratch. */
static GArray *
distinct_points (const QnGlBrush *brush, const QnVec2 *points, uint32_t count,
                 bool closed)
{
  GArray *kept = brush->scratch_points;
  g_array_set_size (kept, 0);
  for (uint32_t i = 0; i < count; i++) {
    const QnVec2 *last = &g_array_index (kept, QnVec2, kept->len - 1);
    if (kept->len == 0 || points[i].x != last->x || points[i].y != last->y)
      g_array_append_val (kept, points[i]);
  }
  const QnVec2 *last = &g_array_index (kept, QnVec2, kept->len - 1);
  if (closed && kept->len > 1 && points[0].x == last->x && points[0].y == last->y)
    g_array_set_size (kept, kept->len - 1);
  return kept;
}

/* ---- polygons -------------------------------------------------------------------------- */

/* Outer unit normal of the side that starts at point i; `turn` is 1 for counter-clockwise
 * polygons and -1 for clockwise ones. */
static QnVec2
side_normal (const QnVec2 *points, uint32_t count, uint32_t i, double turn)
{
  QnVec2 d = qn_vec2_sub (points[(i + 1) % count], points[i]);
  double length = qn_vec2_length (d);
  return length > 0 ? qn_vec2_scale (-turn / length, qn_vec2_perp (d)) : qn_vec2 (0, 0);
}

static bool
is_small_and_convex (const QnVec2 *points, uint32_t count, double turn)
{
  if (count > 4)
    return false;
  for (uint32_t i = 0; i < count; i++) {
    QnVec2 d = qn_vec2_sub (points[(i + 1) % count], points[i]);
    QnVec2 e = qn_vec2_sub (points[(i + 2) % count], points[(i + 1) % count]);
    if (!(turn * qn_vec2_cross (d, e) > 0))
      return false;
  }
  return true;
}

/* Three or four edges, whose distances all vertices know. */
typedef struct Convex {
  const QnGlBrush *brush;
  const QnVec2 *points;
  QnVec2 normals[4];
  uint32_t count;
} Convex;

static void
add_convex_vertex (const Convex *shape, uint32_t i, QnVec2 grow)
{
  QnGlVertex v = make_vertex (shape->brush, shape->points[i], grow);
  for (uint32_t k = 0; k < shape->count; k++) {
    QnVec2 from_side = qn_vec2_sub (shape->points[i], shape->points[k]);
    v.reach[k] = (float) -qn_vec2_dot (shape->normals[k], from_side);
    v.rim[k] = growth_steps (-qn_vec2_dot (shape->normals[k], grow));
  }
  add_vertex (shape->brush, v);
}

static double
turn_at (const QnVec2 *p, uint32_t a, uint32_t b, uint32_t c)
{
  return qn_vec2_cross (qn_vec2_sub (p[b], p[a]), qn_vec2_sub (p[c], p[a]));
}

/* Whether the corner i of the remaining polygon can be cut off. */
static bool
is_ear (const QnVec2 *p, const uint32_t *order, uint32_t n, uint32_t i)
{
  uint32_t a = order[(i + n - 1) % n], b = order[i], c = order[(i + 1) % n];
  if (turn_at (p, a, b, c) <= 0)
    return false;
  for (uint32_t k = 0; k < n; k++) {
    uint32_t q = order[k];
    if (q != a && q != b && q != c && turn_at (p, a, b, q) >= 0
        && turn_at (p, b, c, q) >= 0 && turn_at (p, c, a, q) >= 0)
      return false;
  }
  return true;
}

/* Triangles that cover a polygon, whose point i is the vertex base + 2 i. Ears are cut one by one, O(count^2):
 * masonry blocks have few vertices. */
static void
cut_ears (const QnGlBrush *brush, const QnVec2 *points, uint32_t count, double turn,
          uint32_t base)
{
  g_array_set_size (brush->scratch, count);
  uint32_t *order = &g_array_index (brush->scratch, uint32_t, 0);
  for (uint32_t i = 0; i < count; i++)
    order[i] = turn > 0 ? i : count - 1 - i;
  for (uint32_t n = count; n >= 3; n--) {
    uint32_t ear = 0;
    while (ear < n && !is_ear (points, order, n, ear))
      ear++;
    /* Nothing to cut: what remains has no area, or crosses itself by rounding. */
    if (ear == n)
      ear = 0;
    else
      add_triangle (brush, base + 2 * order[(ear + n - 1) % n], base + 2 * order[ear],
                    base + 2 * order[(ear + 1) % n]);
    memmove (order + ear, order + ear + 1, (n - ear - 1) * sizeof *order);
  }
}

/* Any polygon: its triangles, shrunk by half a pixel, and a band a pixel wide around them. */
static void
add_banded (const QnGlBrush *brush, const QnVec2 *points, uint32_t count, double turn)
{
  uint32_t base = brush->batch->vertices->len;
  for (uint32_t i = 0; i < count; i++) {
    QnVec2 corner;
    mitre (side_normal (points, count, (i + count - 1) % count, turn),
           side_normal (points, count, i, turn), &corner);
    for (int outer = 0; outer < 2; outer++) {
      double growth = outer ? GROWTH : -GROWTH;
      QnGlVertex v = make_vertex (brush, points[i], qn_vec2_scale (growth, corner));
      v.reach[0] = 0;
      v.rim[0] = growth_steps (-growth);
      add_vertex (brush, v);
    }
  }
  for (uint32_t i = 0; i < count; i++) {
    uint32_t a = base + 2 * i, b = base + 2 * ((i + 1) % count);
    add_triangle (brush, a, a + 1, b);
    add_triangle (brush, b, a + 1, b + 1);
  }
  cut_ears (brush, points, count, turn, base);
}

static void
add_simple (const QnGlBrush *brush, const QnVec2 *points, uint32_t count)
{
  double turn = qn_polygon_properties (points, count).area < 0 ? -1 : 1;
  if (is_small_and_convex (points, count, turn)) {
    Convex shape = { .brush = brush, .points = points, .count = count };
    uint32_t base = brush->batch->vertices->len;
    for (uint32_t i = 0; i < count; i++)
      shape.normals[i] = side_normal (points, count, i, turn);
    for (uint32_t i = 0; i < count; i++) {
      QnVec2 before = shape.normals[(i + count - 1) % count], after = shape.normals[i];
      QnVec2 corner;
      if (mitre (before, after, &corner)) {
        add_convex_vertex (&shape, i, qn_vec2_scale (GROWTH, corner));
        continue;
      }
      /* A sharp tip is cut off square: both sides go on as far as they are grown. */
      QnVec2 ahead = qn_vec2_scale (turn, qn_vec2_perp (before));
      QnVec2 back = qn_vec2_scale (-turn, qn_vec2_perp (after));
      add_convex_vertex (&shape, i, qn_vec2_scale (GROWTH, qn_vec2_add (before, ahead)));
      add_convex_vertex (&shape, i, qn_vec2_scale (GROWTH, qn_vec2_add (after, back)));
    }
    for (uint32_t i = base + 1; i + 1 < brush->batch->vertices->len; i++)
      add_triangle (brush, base, i, i + 1);
  } else
    add_banded (brush, points, count, turn);
}

/* Where the segments ab and cd cross inside both. */
static bool
crossing (QnVec2 a, QnVec2 b, QnVec2 c, QnVec2 d, QnVec2 *at)
{
  QnVec2 ab = qn_vec2_sub (b, a), cd = qn_vec2_sub (d, c), ac = qn_vec2_sub (c, a);
  double denominator = qn_vec2_cross (ab, cd);
  double s = qn_vec2_cross (ac, cd) / denominator;
  double t = qn_vec2_cross (ac, ab) / denominator;
  *at = qn_vec2_add_scaled (a, s, ab);
  return s > 0 && s < 1 && t > 0 && t < 1;
}

/* A simple polygon of either orientation, or four points with sides that cross: the two sides of a joint
 * that has opened about a hinge within it. Points may coincide with the next. */
static void
add_fill (const QnGlBrush *brush, const QnVec2 *points, uint32_t count)
{
  const GArray *kept = distinct_points (brush, points, count, true);
  const QnVec2 *p = (const QnVec2 *) (const void *) kept->data;
  QnVec2 x;
  if (kept->len < 3)
    return;
  if (kept->len == 4 && crossing (p[0], p[1], p[2], p[3], &x)) {
    add_simple (brush, (QnVec2[]){ x, p[1], p[2] }, 3);
    add_simple (brush, (QnVec2[]){ x, p[3], p[0] }, 3);
  } else if (kept->len == 4 && crossing (p[1], p[2], p[3], p[0], &x)) {
    add_simple (brush, (QnVec2[]){ x, p[2], p[3] }, 3);
    add_simple (brush, (QnVec2[]){ x, p[0], p[1] }, 3);
  } else {
    add_simple (brush, p, kept->len);
  }
}

/* ---- lines ----------------------------------------------------------------------------- */

typedef struct Line {
  const QnGlBrush *brush;
  double half_width; /* pt */
  double length;     /* m or pt */
  bool ended;        /* it has ends */
  bool dashed;
  int64_t
    last; /* index of the left one of the last two vertices; -1: none to go on from */
} Line;

/* A place on a line: the direction from it to its left side, as long as the mitre has it, and
 * the way out of the line where that is an end. */
typedef struct Node {
  QnVec2 point, left;
  QnVec2 beyond; /* pt: where a cut corner goes on */
  QnVec2 out;    /* unit, at ends */
  double along;  /* m or pt */
  int end;       /* -1 the first, 1 the last, 0 neither */
} Node;

static uint32_t
add_side (const Line *line, const Node *node, int side)
{
  QnVec2 across = qn_vec2_scale (side, node->left);
  QnVec2 grow = qn_vec2_scale (GROWTH, qn_vec2_add (across, node->out));
  QnGlVertex v = make_vertex (line->brush, node->point, grow);
  v.offset[0] += (float) (line->half_width * across.x + node->beyond.x);
  v.offset[1] += (float) (line->half_width * across.y + node->beyond.y);
  v.flags[1] = 255;
  v.reach[0] = side > 0 ? 0 : (float) (2 * line->half_width);
  v.reach[2] = side > 0 ? (float) (2 * line->half_width) : 0;
  v.rim[0] = growth_steps (-side * GROWTH);
  v.rim[2] = growth_steps (side * GROWTH);
  if (line->ended) {
    v.reach[1] = (float) node->along;
    v.reach[3] = (float) (line->length - node->along);
    v.rim[1] = growth_steps (node->end * GROWTH);
    v.rim[3] = growth_steps (-node->end * GROWTH);
  }
  v.flags[3] = line->dashed ? 255 : 0;
  return add_vertex (line->brush, v);
}

static void
add_node (Line *line, const Node *node)
{
  uint32_t left = add_side (line, node, 1), right = add_side (line, node, -1);
  if (line->last >= 0) {
    uint32_t from = (uint32_t) line->last;
    add_triangle (line->brush, from, from + 1, left);
    add_triangle (line->brush, left, from + 1, right);
  }
  line->last = left;
}

/* The corner between two segments of these unit directions. */
static void
add_corner (Line *line, QnVec2 point, QnVec2 d, QnVec2 e, double along)
{
  Node node = { .point = point, .along = along };
  if (mitre (qn_vec2_perp (d), qn_vec2_perp (e), &node.left)) {
    add_node (line, &node);
    return;
  }
  node.left = qn_vec2_perp (d);
  node.beyond = qn_vec2_scale (line->half_width, d);
  add_node (line, &node);
  line->last = -1;
  node.left = qn_vec2_perp (e);
  node.beyond = qn_vec2_scale (-line->half_width, e);
  add_node (line, &node);
}

static void
add_end (Line *line, QnVec2 point, QnVec2 d, double along, int end)
{
  add_node (line, &(Node){ .point = point,
                           .left = qn_vec2_perp (d),
                           .out = qn_vec2_scale (end, d),
                           .along = along,
                           .end = end });
}

static QnVec2
direction (QnVec2 from, QnVec2 to)
{
  QnVec2 d = qn_vec2_sub (to, from);
  return qn_vec2_scale (1 / qn_vec2_length (d), d);
}

/* From the first point to the last, which for a ring is the first again. */
static void
add_run (Line *line, const QnVec2 *p, uint32_t count, bool ring)
{
  double along = 0;
  QnVec2 before = direction (p[count - 2], p[count - 1]);
  QnVec2 first = direction (p[0], p[1]), d = first;
  if (ring)
    add_corner (line, p[0], before, first, 0);
  else
    add_end (line, p[0], first, 0, -1);
  for (uint32_t i = 1; i + 1 < count; i++) {
    QnVec2 e = direction (p[i], p[i + 1]);
    along += qn_vec2_length (qn_vec2_sub (p[i], p[i - 1]));
    add_corner (line, p[i], d, e, along);
    d = e;
  }
  if (ring)
    add_corner (line, p[count - 1], before, first, line->length);
  else
    add_end (line, p[count - 1], d, line->length, 1);
}

/* A line with mitred corners and square ends; `width` in pt. */
static void
add_line (const QnGlBrush *brush, const QnVec2 *points, uint32_t count, bool closed,
          bool dashed, double width)
{
  GArray *kept = distinct_points (brush, points, count, closed);
  if (kept->len < 2)
    return;
  bool ring = closed && kept->len > 2;
  if (ring)
    g_array_append_val (kept, points[0]);
  Line line = { .brush = brush,
                .half_width = 0.5 * width,
                .ended = !ring || dashed,
                .dashed = dashed,
                .last = -1 };
  const QnVec2 *p = &g_array_index (kept, QnVec2, 0);
  for (guint i = 1; i < kept->len; i++)
    line.length += qn_vec2_length (qn_vec2_sub (p[i], p[i - 1]));
  add_run (&line, p, kept->len, ring);
}

/* ---- scenes ---------------------------------------------------------------------------- */

static void
add_marker (QnGlBrush brush, const QnScene *scene, const QnCommand *command)
{
  QnMarkerPath path;
  brush.at = *qn_scene_points (scene, command);
  brush.in_points = true;
  for (int part = 0; qn_marker_path ((QnMarker) command->marker, part, command->angle,
                                     command->mirrored, &path);
       part++) {
    uint32_t count = (uint32_t) path.count;
    for (uint32_t i = 0; i < count; i++)
      path.points[i] = qn_vec2_scale (command->size, path.points[i]);
    if (path.paint == QN_MARKER_RIM) {
      QnGlBrush paper = brush;
      paper.color = qn_rgb (0xffffff);
      add_fill (&paper, path.points, count);
    }
    if (path.paint == QN_MARKER_INK)
      add_fill (&brush, path.points, count);
    else
      add_line (&brush, path.points, count, path.closed, false, QN_RIM_WIDTH);
  }
}

void
qn_gl_batch_init (QnGlBatch *batch, const QnScene *scene)
{
  guint count = scene->commands->len;
  g_autoptr (GArray) scratch = g_array_new (FALSE, FALSE, sizeof (uint32_t));
  g_autoptr (GArray) scratch_points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  *batch = (QnGlBatch){
    .vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnGlVertex), 8 * count),
    .indices = g_array_sized_new (FALSE, FALSE, sizeof (uint32_t), 16 * count),
    .ranges = g_new0 (QnGlRange, MAX (count, 1)),
  };
  if (!qn_box_is_empty (scene->box))
    batch->origin = qn_vec2_lerp (scene->box.min, scene->box.max, 0.5);
  for (guint i = 0; i < count; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    QnGlBrush brush = { .batch = batch,
                        .scratch = scratch,
                        .scratch_points = scratch_points,
                        .color = command->color,
                        .thin = qn_command_is_thinned (command) };
    const QnVec2 *points = qn_scene_points (scene, command);
    batch->ranges[i].first = batch->indices->len;
    switch ((QnCommandKind) command->kind) {
    case QN_COMMAND_FILL:
      add_fill (&brush, points, command->count);
      break;
    case QN_COMMAND_STROKE:
      add_line (&brush, points, command->count, command->closed, command->dashed,
                command->size);
      break;
    case QN_COMMAND_MARKER:
      add_marker (brush, scene, command);
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
