#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "core/base/tolerance.h"
#include "core/model/model-check.h"
#include "core/model/outline.h"
#include "core/model/soil.h"
#include "core/model/vehicle.h"

double
qn_earth_at_rest (double friction_angle)
{
  return 1 - sin (friction_angle);
}

double
qn_earth_active (double friction_angle)
{
  double sine = sin (friction_angle);

  return (1 - sine) / (1 + sine);
}

double
qn_load_earth_coefficient (const QnLoad *load)
{
  switch (load->earth) {
  case QN_EARTH_AT_REST:
    return qn_earth_at_rest (load->friction_angle);
  case QN_EARTH_ACTIVE:
    return qn_earth_active (load->friction_angle);
  case QN_EARTH_GIVEN:
  case QN_EARTH_COUNT:
    break;
  }
  return load->coefficient;
}

double
qn_load_behind_front (const QnModel *model, const QnLoad *load, int32_t n, double behind)
{
  const QnVehicle *vehicle = &model->vehicles[load->vehicle];
  double back = n * (qn_vehicle_length (vehicle) + load->headway) + behind;

  return load->position + (load->reversed ? back : -back);
}

double
qn_load_surface_at (const QnLoad *load, double x)
{
  const QnVec2 *p = load->surface;

  for (int32_t i = 0; i + 1 < load->surface_count; i++)
    if (x >= p[i].x && x <= p[i + 1].x)
      return p[i].y + (p[i + 1].y - p[i].y) * ((x - p[i].x) / (p[i + 1].x - p[i].x));
  return NAN;
}

void
qn_model_renumber_loaded_edges (QnModel *model)
{
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    QnLoad *load = qn_model_load (model, i);
    if (load->kind != QN_LOAD_EDGE || load->has_side)
      continue;
    QnId edges = model->blocks[load->block].vertex_count;
    const QnVec2 *v = qn_model_block_vertices (model, load->block);
    if (qn_polygon_properties (v, (size_t) edges).area >= 0)
      continue;
    /* Vertex k becomes n - k, and 0 stays: edge k is n - 1 - k then, run through backwards. */
    load->edge = (2 * edges - load->edge - load->edge_count) % edges;
    const double part = load->part[0], intensity = load->intensity[0];
    load->part[0] = 1 - load->part[1];
    load->part[1] = 1 - part;
    load->intensity[0] = load->intensity[1];
    load->intensity[1] = intensity;
  }
}

/* --- Resolving ---------------------------------------------------------------------------- */

/* What is found while the loads of a model are resolved, one of which is at hand. */
typedef struct {
  QnModel *model;
  size_t source;
  const QnLoad *load;
  QnSeenEdges seen[QN_BLOCK_SIDE_COUNT];
  QnPool room; /* of what is seen, and of shares; whether memory ran out */
  QnDiag *diag;
} Resolver;

static QnStatus
refuse (const Resolver *r, QnProblem problem, const char *field)
{
  QnSubject of = qn_load_subject (r->model, r->source, r->diag);
  return qn_required (qn_require (of, false, problem, field, 0));
}

/* Intensities of one sign. */
static QnStatus
add_resultant (Resolver *r, QnId block, QnVec2 a, QnVec2 b, double q0, double q1,
               QnVec2 direction)
{
  QnModel *model = r->model;
  double length = qn_vec2_length (qn_vec2_sub (b, a));

  if (!(length > 0) || (q0 == 0 && q1 == 0))
    return QN_OK;
  if (model->edge_force_count >= QN_MAX_EDGE_FORCES)
    return refuse (r, QN_PROBLEM_TOO_MANY_EDGE_FORCES, NULL);
  const QnEdgeForce force = {
    .source = r->source,
    .block = block,
    .ends = { a, b },
    .intensity = { qn_vec2_scale (q0, direction), qn_vec2_scale (q1, direction) },
    .force = qn_vec2_scale (length * (0.5 * q0 + 0.5 * q1), direction),
    .at = qn_vec2_lerp (a, b, (q0 / (q0 + q1) + 2 * (q1 / (q0 + q1))) / 3),
  };
  if (!QN_ARRAY_PUSH (model->edge_forces, model->edge_force_count,
                      model->edge_force_capacity, force))
    return qn_diag_no_memory (r->diag);
  double size = qn_vec2_length (force.force) * qn_model_load_factor (model, r->load);
  return isfinite (size) && isfinite (q0 + q1)
           ? QN_OK
           : refuse (r, QN_PROBLEM_TOO_LARGE,
                     r->load->kind == QN_LOAD_EDGE ? "intensity" : "pressure");
}

/* A load from q0 at a to q1 at b, along an edge of a block; where its sign changes it is cut. */
static QnStatus
add_stretch (Resolver *r, QnId block, QnVec2 a, QnVec2 b, double q0, double q1,
             QnVec2 direction)
{
  if (!((q0 < 0 && q1 > 0) || (q0 > 0 && q1 < 0)))
    return add_resultant (r, block, a, b, q0, q1, direction);
  QnVec2 middle = qn_vec2_lerp (a, b, q0 / (q0 - q1));
  QnStatus status = add_resultant (r, block, a, middle, q0, 0, direction);
  return status == QN_OK ? add_resultant (r, block, middle, b, 0, q1, direction) : status;
}

/* Into the block, which is counter-clockwise. */
static QnVec2
inner_normal (QnVec2 a, QnVec2 b)
{
  QnVec2 edge = qn_vec2_sub (b, a);

  return qn_vec2_scale (1 / qn_vec2_length (edge), qn_vec2_perp (edge));
}

static bool
is_straight (QnVec2 a, QnVec2 b, QnVec2 c)
{
  QnVec2 from = inner_normal (a, b), to = inner_normal (b, c);

  return fabs (qn_vec2_cross (from, to)) <= QN_TOLERANCE_CONVEX
         && qn_vec2_dot (from, to) > 0;
}

void
qn_load_chain (const QnModel *model, const QnLoad *load, QnId *first, QnId *count)
{
  *first = load->edge;
  *count = load->edge_count;
  if (!load->has_side)
    return;
  const QnVec2 *v = qn_model_block_vertices (model, load->block);
  QnId n = model->blocks[load->block].vertex_count;
  QnId facing = qn_block_facing_edge (model, load->block, load->side), last = facing;
  for (*first = facing;
       is_straight (v[(*first + n - 1) % n], v[*first], v[(*first + 1) % n]);)
    *first = (*first + n - 1) % n;
  while (is_straight (v[last], v[(last + 1) % n], v[(last + 2) % n]))
    last = (last + 1) % n;
  *count = (last - *first + n) % n + 1;
}

static QnStatus
resolve_edge (Resolver *r)
{
  const QnLoad *load = r->load;
  const QnVec2 *v = qn_model_block_vertices (r->model, load->block);
  QnId n = r->model->blocks[load->block].vertex_count, first, count;
  double whole = 0, start = 0;
  QnStatus status = QN_OK;

  qn_load_chain (r->model, load, &first, &count);
  for (QnId i = first; i < first + count; i++)
    whole += qn_vec2_length (qn_vec2_sub (v[(i + 1) % n], v[i % n]));
  double from = load->part[0] * whole, to = load->part[1] * whole;
  for (QnId i = first; i < first + count && status == QN_OK; i++) {
    QnVec2 a = v[i % n], b = v[(i + 1) % n];
    double length = qn_vec2_length (qn_vec2_sub (b, a));
    double low = fmax (from, start), high = fmin (to, start + length);
    if (low < high) {
      double q[2], at[2] = { low, high };
      for (int end = 0; end < 2; end++) {
        double s = (at[end] - from) / (to - from);
        q[end] = (1 - s) * load->intensity[0] + s * load->intensity[1];
      }
      status = add_stretch (r, load->block, qn_vec2_lerp (a, b, (low - start) / length),
                            qn_vec2_lerp (a, b, (high - start) / length), q[0], q[1],
                            load->normal ? inner_normal (a, b) : load->vector);
    }
    start += length;
  }
  return status;
}

static const QnSeenEdges *
look_from (Resolver *r, QnBlockSide side)
{
  if (r->seen[side].items == NULL)
    qn_model_find_seen_edges (r->model, side, &r->seen[side], &r->room);
  return &r->seen[side];
}

/* The part of a seen edge between two coordinates: of the axis that it is seen across. */
static bool
clip (const QnSeenEdge *seen, bool by_y, const double span[2], QnVec2 ends[2])
{
  const QnVec2 a = seen->ends[0], b = seen->ends[1];
  double from = by_y ? a.y : a.x, to = by_y ? b.y : b.x, s[2] = { 0, 1 };

  for (int limit = 0; limit < 2; limit++) {
    double cut = (span[limit] - from) / (to - from);
    bool rising = to > from;
    if ((limit == 0) == rising)
      s[0] = fmax (s[0], cut);
    else
      s[1] = fmin (s[1], cut);
  }
  ends[0] = s[0] == 0 ? a : qn_vec2_lerp (a, b, s[0]);
  ends[1] = s[1] == 1 ? b : qn_vec2_lerp (a, b, s[1]);
  return s[0] < s[1];
}

/* The pressure acts on the horizontal projection; above the level there is no fill. */
static QnStatus
add_surcharge (Resolver *r, const QnSeenEdge *seen, const QnVec2 ends[2])
{
  const QnLoad *load = r->load;
  QnVec2 edge = qn_vec2_sub (ends[1], ends[0]);
  double per_length =
    r->model->blocks[seen->block].thickness * fabs (edge.x) / qn_vec2_length (edge);
  double depth[2], q[2];
  QnVec2 cut[3] = { ends[0], ends[1], ends[1] };

  for (int end = 0; end < 2; end++)
    depth[end] = load->unit_weight > 0 ? load->level - ends[end].y : 0;
  if (depth[0] * depth[1] < 0) /* comes out of the fill */
    cut[1] = qn_vec2_lerp (ends[0], ends[1], depth[0] / (depth[0] - depth[1]));
  for (int part = 0; part < 2; part++) {
    for (int end = 0; end < 2; end++) {
      double d = load->unit_weight > 0 ? load->level - cut[part + end].y : 0;
      q[end] = per_length * (load->pressure + load->unit_weight * fmax (d, 0));
    }
    QnStatus status =
      add_stretch (r, seen->block, cut[part], cut[part + 1], q[0], q[1], qn_vec2 (0, -1));
    if (status != QN_OK)
      return status;
  }
  return QN_OK;
}

static QnStatus
add_backfill (Resolver *r, const QnSeenEdge *seen, const QnVec2 ends[2])
{
  const QnLoad *load = r->load;
  double k = qn_load_earth_coefficient (load) * r->model->blocks[seen->block].thickness;
  double q[2];

  for (int end = 0; end < 2; end++)
    q[end] = k * (load->pressure + load->unit_weight * (load->span[1] - ends[end].y));
  return add_stretch (r, seen->block, ends[0], ends[1], q[0], q[1],
                      inner_normal (seen->ends[0], seen->ends[1]));
}

static QnStatus
resolve_seen (Resolver *r)
{
  bool fill = r->load->kind == QN_LOAD_BACKFILL;
  QnBlockSide side = fill ? r->load->side : QN_BLOCK_SIDE_TOP;
  QnStatus status = QN_OK;

  const QnSeenEdges *seen = look_from (r, side);
  for (size_t i = 0; i < seen->count && status == QN_OK; i++) {
    QnVec2 ends[2];
    if (clip (&seen->items[i], fill, r->load->span, ends))
      status = fill ? add_backfill (r, &seen->items[i], ends)
                    : add_surcharge (r, &seen->items[i], ends);
  }
  return status;
}

/* --- Fill and vehicles -------------------------------------------------------------------- */

/* Fill between two corners of its surface on an edge: weight on the level projection, active pressure on
 * the upright one, both in proportion to the depth. `beside`: the edge is upright, with the soil on this
 * side of it. */
static QnStatus
add_fill (Resolver *r, const QnSeenEdge *seen, const QnVec2 surface[2], double beside)
{
  const QnLoad *load = r->load;
  const double span[2] = { beside != 0 ? load->span[0] : surface[0].x,
                           beside != 0 ? INFINITY : surface[1].x };
  QnVec2 ends[2], edge = qn_vec2_sub (seen->ends[1], seen->ends[0]);
  double thickness = r->model->blocks[seen->block].thickness, depth[2];
  double active = qn_fill_active (load),
         slope = (surface[1].y - surface[0].y) / (surface[1].x - surface[0].x);

  if (!clip (seen, beside != 0, span, ends))
    return QN_OK;
  for (int end = 0; end < 2; end++)
    depth[end] = surface[0].y + slope * (ends[end].x - surface[0].x) - ends[end].y;
  for (int end = 0; end < 2; end++)
    if (depth[end] < 0 && depth[1 - end] > 0) { /* comes out of the fill */
      ends[end] = qn_vec2_lerp (ends[end], ends[1 - end],
                                depth[end] / (depth[end] - depth[1 - end]));
      depth[end] = 0;
    }
  double per_depth = load->unit_weight * thickness / qn_vec2_length (edge);
  return add_stretch (r, seen->block, ends[0], ends[1], per_depth * fmax (depth[0], 0),
                      per_depth * fmax (depth[1], 0), qn_vec2 (-active * edge.y, edge.x));
}

/* Treads and slopes from above; upright faces from their side, where the surface goes on beside them. */
static QnStatus
resolve_fill (Resolver *r)
{
  static const QnBlockSide sides[] = { QN_BLOCK_SIDE_TOP, QN_BLOCK_SIDE_LEFT,
                                       QN_BLOCK_SIDE_RIGHT };
  const QnLoad *load = r->load;
  const int count = load->friction_angle > 0 ? 3 : 1;
  QnStatus status = QN_OK;

  for (int s = 0; s < count && status == QN_OK; s++) {
    double beside = s == 0 ? 0 : s == 1 ? -1 : 1;
    const QnSeenEdges *all = look_from (r, sides[s]);
    for (size_t i = 0; i < all->count; i++) {
      const QnSeenEdge *seen = &all->items[i];
      QnVec2 edge = qn_vec2_sub (seen->ends[1], seen->ends[0]);
      double x = seen->ends[0].x;
      if (s > 0 && fabs (edge.x) > QN_TOLERANCE_CONVEX * fabs (edge.y))
        continue;
      for (int32_t k = 0; k + 1 < load->surface_count && status == QN_OK; k++) {
        const QnVec2 *surface = &load->surface[k];
        if (s == 0
            || (beside < 0 ? surface[0].x < x && surface[1].x >= x
                           : surface[0].x <= x && surface[1].x > x))
          status = add_fill (r, seen, surface, beside);
      }
    }
  }
  return status == QN_OK ? qn_model_add_soil (r->model, r->source, r->diag) : status;
}

/* A load on fill spreads along rays. With a rule of widths it comes in equal parts of all rays from an apex above
 * the surface, where the sides of the spreading load meet: at every depth it is uniform over its width.
 * With Boussinesq's half-space (Flamant's line load) the part between the vertical and the angle t is
 * (t + sin t cos t) / pi, the vertical component of the radial stresses. An edge receives the part of the
 * load whose rays meet it first, so all parts add up to the load, on slopes too. Rays that meet an upright
 * face, go through air, or pass beside the structure are lost.
 */
/* Load on one edge: the force, its first moment about the left end of the edge, and the loaded part. */
typedef struct QnShare {
  double force, moment; /* N, N m: along the edge */
  double from, to;      /* m along the edge from its left end */
} QnShare;

typedef struct QnSource {
  double x, surface; /* m: where it stands */
  double load;       /* N */
  QnSpread spread;
  bool boussinesq;
  double width;          /* m: no load is wider than this; 0: no limit */
  double effective;      /* m: width across at all depths; 0: that of `spread` */
  const QnVec2 *profile; /* of the surface, from the left; NULL: no fill */
  int32_t profile_count;
} QnSource;

/* Parts of an edge for which its share is summed up, and line loads that a patch is divided into. */
#define PARTS 24
#define LINES 8

QnSpread
qn_dispersal_spread (QnDispersal dispersal, const QnVehicle *vehicle)
{
  const double tan30 = 0.57735026918962576451, track = vehicle->track;
  const double along = vehicle->patch[0], across = track + vehicle->patch[1];

  switch (dispersal) {
  case QN_DISPERSAL_CS_454:
    return (QnSpread){ 0.3, 1, track + 1.5, 1 };
  case QN_DISPERSAL_NR_025:
    return (QnSpread){ 0.25, 1, track, 2 };
  case QN_DISPERSAL_EN_1991:
    return (QnSpread){ along, 2 * tan30, across, 2 * tan30 };
  case QN_DISPERSAL_HALF:
  case QN_DISPERSAL_BOUSSINESQ:
  case QN_DISPERSAL_COUNT:
    break;
  }
  return (QnSpread){ along, 1, across, 1 };
}

double
qn_vehicle_length (const QnVehicle *vehicle)
{
  double length = 0;

  for (int32_t i = 0; i < vehicle->axle_count; i++)
    length = fmax (length, vehicle->axles[i].at);
  for (int32_t i = 0; i < vehicle->line_count; i++)
    if (vehicle->lines[i].to < QN_ENDLESS)
      length = fmax (length, vehicle->lines[i].to);
  return length;
}

/* Rays from one apex to one side, u to that side from the apex. */
typedef struct {
  const QnSource *source;
  QnVec2 apex;
  double side; /* 1: to the right, -1 */
  double load;
  double most; /* tangent of the last ray's angle from the vertical */
} Fan;

/* The part of the load between the vertical and a ray, one side alone. */
static double
part_within (const Fan *fan, double tangent)
{
  if (isinf (tangent))
    return 0.5;
  return fan->source->boussinesq
           ? (atan (tangent) + tangent / (1 + tangent * tangent)) / QN_PI
           : fmin (tangent, fan->most) / fan->source->spread.along_slope;
}

static double
tangent_of (const Fan *fan, QnVec2 p)
{
  double u = fan->side * (p.x - fan->apex.x), depth = fan->apex.y - p.y;

  return depth > 0 ? u / depth : u > 0 ? INFINITY : 0;
}

/* Which part of a load the thickness of a block takes at a depth. */
static double
part_across (const QnSource *source, double thickness, double y)
{
  const QnSpread *s = &source->spread;
  double depth = fmax (source->surface - y, 0);
  double width =
    source->effective > 0 ? source->effective : s->across + s->across_slope * depth;

  if (source->width > 0)
    width = fmin (width, source->width);
  return fmin (thickness / width, 1);
}

/* Rays beyond this one have left the fill before they meet an edge between u and v: they pass above its
 * surface, or it ends there. */
static double
last_in_fill (const Fan *fan, double u, double v)
{
  const QnSource *source = fan->source;
  double last = INFINITY;

  if (source->profile_count > 0) {
    QnVec2 end = source->profile[fan->side > 0 ? source->profile_count - 1 : 0];
    if (u >= fan->side * (end.x - fan->apex.x))
      return 0;
  }
  for (int32_t i = 0; i < source->profile_count; i++) {
    QnVec2 p = source->profile[i];
    double at = fan->side * (p.x - fan->apex.x);
    if (at > 0 && at <= v && p.y < source->surface)
      last = fmin (last, tangent_of (fan, p));
  }
  return last;
}

/* The stretch of an edge, a to b outwards, between two rays. */
static void
add_share (const Fan *fan, double thickness, QnVec2 left, QnVec2 a, QnVec2 b, double from,
           double to, QnShare *share)
{
  QnVec2 along = qn_vec2_sub (b, a), ends[2];
  double u = fan->side * (a.x - fan->apex.x), depth = fan->apex.y - a.y;

  for (int end = 0; end < 2; end++) {
    double t = end == 0 ? from : to;
    double s = isfinite (t)  ? (t * depth - u) / (fan->side * along.x + t * along.y)
               : along.y > 0 ? depth / along.y
                             : 1;
    ends[end] = qn_vec2_lerp (a, b, fmin (fmax (s, 0), 1));
  }
  double before = part_within (fan, from);
  for (int i = 0; i < PARTS; i++) {
    QnVec2 next = qn_vec2_lerp (ends[0], ends[1], (i + 1.0) / PARTS);
    QnVec2 middle = qn_vec2_lerp (ends[0], ends[1], (i + 0.5) / PARTS);
    double within = part_within (fan, i + 1 < PARTS ? tangent_of (fan, next) : to);
    double force =
      fan->load * (within - before) * part_across (fan->source, thickness, middle.y);
    share->force += force;
    share->moment += force * qn_vec2_length (qn_vec2_sub (middle, left));
    before = within;
  }
  for (int end = 0; end < 2; end++) {
    double at = qn_vec2_length (qn_vec2_sub (ends[end], left));
    share->from = fmin (share->from, at);
    share->to = fmax (share->to, at);
  }
}

/* Edge by edge outwards; `horizon` is the outermost ray that has met something. */
static void
spread_fan (const QnModel *model, const QnSeenEdges *edges, const Fan *fan,
            QnShare *shares)
{
  double horizon = 0;

  for (size_t k = 0; k < edges->count && horizon < fan->most; k++) {
    size_t i = fan->side > 0 ? k : edges->count - 1 - k;
    const QnSeenEdge *edge = &edges->items[i];
    QnVec2 left = edge->ends[1], right = edge->ends[0];
    QnVec2 a = fan->side > 0 ? left : right, b = fan->side > 0 ? right : left;
    double ua = fan->side * (a.x - fan->apex.x), ub = fan->side * (b.x - fan->apex.x);
    if (ub <= 0)
      continue;
    if (ua < 0)
      a = qn_vec2_lerp (a, b, ua / (ua - ub));
    if (ua < QN_TOLERANCE_CONVEX * ub) /* the apex may stand on the edge */
      a.x = fan->apex.x;
    double from = fmax (tangent_of (fan, a), horizon), to = tangent_of (fan, b);
    double last = fmin (fan->most, last_in_fill (fan, fmax (ua, 0), ub));
    if (fmin (to, last) > from)
      add_share (fan, model->blocks[edge->block].thickness, left, a, b, from,
                 fmin (to, last), &shares[i]);
    horizon = fmax (from, to);
  }
}

/* Adds to `shares`, one for each edge. The edges are those seen from above, from left to right. */
static void
disperse (const QnModel *model, const QnSeenEdges *edges, const QnSource *source,
          QnShare *shares)
{
  const QnSpread *s = &source->spread;
  const int lines = source->boussinesq ? LINES : 1;

  for (int i = 0; i < 2 * lines; i++) {
    double x = source->x + s->along * ((i / 2 + 0.5) / lines - 0.5);
    double rise = source->boussinesq ? 0 : s->along / s->along_slope;
    Fan fan = { .source = source,
                .apex = qn_vec2 (x, source->surface + rise),
                .side = i % 2 == 0 ? 1 : -1,
                .load = source->load / lines,
                .most = source->boussinesq ? INFINITY : 0.5 * s->along_slope };
    spread_fan (model, edges, &fan, shares);
  }
}

/* A load between two x: the middle of what is spread; `along` is how long it is at the surface. */
static void
add_source (Resolver *r, double x, double force, double along, QnShare *shares)
{
  const QnLoad *load = r->load;
  double height;
  const QnLoad *fill =
    qn_model_find_road (r->model, &r->seen[QN_BLOCK_SIDE_TOP], x, &height);
  QnSource source = {
    .x = x,
    .surface = height,
    .load = force,
    .spread = qn_dispersal_spread (load->dispersal, &r->model->vehicles[load->vehicle]),
    .boussinesq = load->dispersal == QN_DISPERSAL_BOUSSINESQ,
    .width = load->width,
    .effective = load->effective,
    .profile = fill != NULL ? fill->surface : NULL,
    .profile_count = fill != NULL ? fill->surface_count : 0,
  };

  if (along > 0)
    source.spread.along = along;
  if (!isnan (height))
    disperse (r->model, &r->seen[QN_BLOCK_SIDE_TOP], &source, shares);
}

/* The shares of all edges as forces on them: linear loads with their resultants, and clears them. */
static QnStatus
add_shares (Resolver *r, QnShare *shares)
{
  const QnSeenEdges *top = &r->seen[QN_BLOCK_SIDE_TOP];
  QnStatus status = QN_OK;

  for (size_t i = 0; i < top->count; i++) {
    const QnShare share = shares[i];
    QnVec2 left = top->items[i].ends[1], right = top->items[i].ends[0];
    QnVec2 along = qn_vec2_sub (right, left);
    double whole = qn_vec2_length (along), length = share.to - share.from;
    shares[i] = (QnShare){ .from = INFINITY, .to = -INFINITY };
    if (!(share.force > 0) || !(length > 0) || status != QN_OK)
      continue;
    /* The centroid of a linear load lies in the middle third. */
    double centre = (share.moment / share.force - share.from) / length;
    centre = fmin (fmax (centre, 1.0 / 3), 2.0 / 3);
    double q = 2 * share.force / length, at = share.moment / share.force;
    status =
      add_stretch (r, top->items[i].block, qn_vec2_lerp (left, right, share.from / whole),
                   qn_vec2_lerp (left, right, share.to / whole), q * (2 - 3 * centre),
                   q * (3 * centre - 1), qn_vec2 (0, -1));
    if (status == QN_OK)
      r->model->edge_forces[r->model->edge_force_count - 1].at =
        qn_vec2_lerp (left, right, at / whole);
  }
  return status;
}

#define LINE_PART 0.5 /* m: uniform load is spread in parts of this length */

static QnStatus
resolve_vehicle (Resolver *r)
{
  const QnLoad *load = r->load;
  const QnVehicle *vehicle = &r->model->vehicles[load->vehicle];

  QnStatus status = QN_OK;
  size_t count = look_from (r, QN_BLOCK_SIDE_TOP)->count;
  QnShare *shares = qn_pool_alloc (&r->room, count, sizeof *shares);
  if (shares == NULL)
    return QN_OK;
  QnBox road = QN_BOX_EMPTY;
  for (size_t i = 0; i < count; i++) {
    shares[i] = (QnShare){ .from = INFINITY, .to = -INFINITY };
    for (int end = 0; end < 2; end++)
      qn_box_add_point (&road, r->seen[QN_BLOCK_SIDE_TOP].items[i].ends[end]);
  }
  for (size_t i = 0; i < r->model->dead_load_count; i++)
    for (int32_t k = 0; k < r->model->dead_loads[i].surface_count; k++)
      qn_box_add_point (&road, r->model->dead_loads[i].surface[k]);
  int32_t beside = 0;
  for (int32_t n = 0; n < load->convoy && status == QN_OK; n++) {
    for (int32_t i = 0; i < vehicle->axle_count && status == QN_OK; i++) {
      double x = qn_load_behind_front (r->model, load, n, vehicle->axles[i].at);
      double height;
      qn_model_find_road (r->model, &r->seen[QN_BLOCK_SIDE_TOP], x, &height);
      beside += isnan (height);
      add_source (r, x, vehicle->axles[i].load, 0, shares);
      status = add_shares (r, shares);
    }
    for (int32_t i = 0; i < vehicle->line_count && status == QN_OK; i++) {
      const QnLineLoad *line = &vehicle->lines[i];
      double a = qn_load_behind_front (r->model, load, n, line->from);
      double b = qn_load_behind_front (r->model, load, n, line->to);
      double from = fmax (fmin (a, b), road.min.x), to = fmin (fmax (a, b), road.max.x);
      int64_t parts = qn_to_integer (ceil ((to - from) / LINE_PART), 0, 1000000);
      double part = (to - from) / (double) parts;
      for (int64_t k = 0; k < parts; k++)
        add_source (r, from + ((double) k + 0.5) * part, line->intensity * part, part,
                    shares);
      status = add_shares (r, shares);
    }
  }
  qn_model_load (r->model, r->source)->beside = beside;
  return status;
}

QnStatus
qn_model_resolve_edge_loads (QnModel *model, QnDiag *diag)
{
  Resolver r = { .model = model, .diag = diag };
  QnStatus status = QN_OK;

  model->edge_force_count = 0;
  qn_model_drop_soil (model);
  for (; r.source < qn_model_load_count (model) && status == QN_OK; r.source++) {
    r.load = qn_model_load (model, r.source);
    if (r.load->kind == QN_LOAD_EDGE)
      status = resolve_edge (&r);
    else if (r.load->kind == QN_LOAD_SURCHARGE || r.load->kind == QN_LOAD_BACKFILL)
      status = resolve_seen (&r);
    else if (r.load->kind == QN_LOAD_FILL)
      status = resolve_fill (&r);
    else if (r.load->kind == QN_LOAD_VEHICLE)
      status = resolve_vehicle (&r);
  }
  if (r.room.failed)
    status = qn_diag_no_memory (diag);
  qn_pool_clear (&r.room);
  return status;
}
