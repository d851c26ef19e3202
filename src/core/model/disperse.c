#include "core/model/disperse.h"

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
    double from = fmax (tangent_of (fan, a), horizon), to = tangent_of (fan, b);
    double last = fmin (fan->most, last_in_fill (fan, fmax (ua, 0), ub));
    if (fmin (to, last) > from)
      add_share (fan, model->blocks[edge->block].thickness, left, a, b, from,
                 fmin (to, last), &shares[i]);
    horizon = fmax (from, to);
  }
}

void
qn_disperse (const QnModel *model, const QnSeenEdges *edges, const QnSource *source,
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
