/* Closing gaps: sides -> joints -> lines -> corners. See gaps.h. */
#include "stereotomy/gaps.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

#include <stdint.h>
#include <stdlib.h>

#define NONE SIZE_MAX

/* Sine of the angle (10 degrees) below which lines count as parallel. */
#define STRAIGHT_SINE 0.1736

/* Cosine of the angle (1.5 degrees) within which a bed goes on past a head joint. */
#define ONWARD_COSINE 0.99966

/* A corner moves at most so many times as far as the farther of its two sides. */
#define MOST_MITRE 6.0

/* Misses below this part of half a joint are rounding. */
#define ROUNDING 1e-6

/* Blocks keep at least this part of their area where corners are cut off. */
#define LEAST_LEFT 0.95

/* How often gaps that are left are tried again. */
#define MOST_PASSES 2

/* Steps of the golden section search for the slope of a line. */
#define SLOPE_STEPS 80

typedef struct Line {
  QnVec2 at, along; /* along: unit */
} Line;

/* A side of a ring, and the joint that it bounds. A joint is named by one of its sides, which begins
 * the lists of all its sides and gaps. */
typedef struct ClosingSide {
  QnVec2 from, to, along; /* along: unit */
  double length;
  size_t before, after;       /* the sides of the same ring at both ends */
  size_t joint;               /* towards the side that names the joint (union-find) */
  size_t next, last;          /* next side of the joint; of the naming one: the last */
  size_t first_gap, last_gap; /* of the naming one */
  bool faces;                 /* whether there is a gap beside it */
  bool parted;                /* no line serves all of its joint */
  bool has_line;
  Line line;
} ClosingSide;

/* What a line must keep to at one end of a gap, in the frame of a joint. */
typedef struct Sample {
  double x, low, high, weight;
} Sample;

typedef struct Closing {
  const QnRings *rings;
  QnGaps gaps;
  double slack;  /* m: by how much a line may cut into a block */
  double widest; /* m: mean width of the widest gap */
  ClosingSide *sides;
  size_t side_count;
  size_t *first_side; /* of each ring */
  size_t *next_gap;   /* of the same joint */
  Sample *samples;
} Closing;

static size_t
side_of (const Closing *closing, size_t gap, int i)
{
  const QnGap *g = &closing->gaps.items[gap];
  return closing->first_side[g->rings[i]] + g->edges[i];
}

static double
overlap_of (const QnGap *gap)
{
  return qn_vec2_length (qn_vec2_sub (gap->sides[0][1], gap->sides[0][0]));
}

/* ---- lines ---- */

static bool
lies_within (const Sample *samples, size_t count, double slope, double height,
             double slack)
{
  for (size_t i = 0; i < count; i++) {
    double y = height + slope * samples[i].x;
    if (y < samples[i].low - slack || y > samples[i].high + slack)
      return false;
  }
  return true;
}

/* How much room the line of a slope has at most; its height in the middle of that. */
static double
room (const Sample *samples, size_t count, double slope, double *height)
{
  double low = -INFINITY, high = INFINITY;
  for (size_t i = 0; i < count; i++) {
    low = fmax (low, samples[i].low - slope * samples[i].x);
    high = fmin (high, samples[i].high - slope * samples[i].x);
  }
  *height = 0.5 * (low + high);
  return high - low;
}

/* The line through the middle of the gaps: parallel to the sides where that lies within all of
 * them, else by least squares, else the one with the most room. */
static bool
fit_samples (const Sample *samples, size_t count, double slack, double *slope,
             double *height)
{
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
  for (size_t i = 0; i < count; i++) {
    double y = 0.5 * (samples[i].low + samples[i].high), x = samples[i].x;
    double weight = samples[i].weight;
    w += weight;
    wx += weight * x;
    wy += weight * y;
    wxx += weight * x * x;
    wxy += weight * x * y;
  }
  *slope = 0;
  *height = wy / w;
  if (lies_within (samples, count, 0, *height, slack)
      || room (samples, count, 0, height) >= -slack)
    return true;
  double spread = w * wxx - wx * wx;
  if (spread > 0) {
    *slope = (w * wxy - wx * wy) / spread;
    *height = (wy - *slope * wx) / w;
    if (lies_within (samples, count, *slope, *height, slack))
      return true;
  }
  /* The room is a concave function of the slope. */
  double from = *slope - 0.5, to = *slope + 0.5, golden = 0.5 * (sqrt (5.0) - 1), h;
  for (int i = 0; i < SLOPE_STEPS; i++) {
    double a = to - golden * (to - from), b = from + golden * (to - from);
    if (room (samples, count, a, &h) < room (samples, count, b, &h))
      from = a;
    else
      to = b;
  }
  *slope = 0.5 * (from + to);
  return room (samples, count, *slope, height) >= -slack;
}

/* Adds what a gap asks of a line in the direction `along` through `origin`. */
static size_t
add_samples (Closing *closing, size_t g, QnVec2 origin, QnVec2 along, size_t count)
{
  const QnGap *gap = &closing->gaps.items[g];
  QnVec2 up = qn_vec2_perp (along);
  /* A block lies to the left of its sides: above the line where they run along it. */
  int upper =
    qn_vec2_dot (closing->sides[side_of (closing, g, 0)].along, along) >= 0 ? 0 : 1;
  for (int end = 0; end < 2; end++) {
    QnVec2 high = qn_vec2_sub (gap->sides[upper][end], origin);
    QnVec2 low = qn_vec2_sub (gap->sides[1 - upper][end], origin);
    closing->samples[count++] =
      (Sample){ 0.5 * (qn_vec2_dot (low, along) + qn_vec2_dot (high, along)),
                qn_vec2_dot (low, up), qn_vec2_dot (high, up), overlap_of (gap) };
  }
  return count;
}

/* Whether no end of a side is farther from the line than the gaps of its joint are wide: a line that fits
 * in a short gap may leave a long side. */
static bool
stays_near (const Closing *closing, const size_t joints[2], size_t samples,
            const Line *line)
{
  double most = closing->slack;
  for (size_t i = 0; i < samples; i++)
    most = fmax (most, closing->samples[i].high - closing->samples[i].low);
  for (int i = 0; i < 2; i++)
    for (size_t s = joints[i]; s != NONE; s = closing->sides[s].next) {
      const ClosingSide *side = &closing->sides[s];
      double from = qn_vec2_cross (line->along, qn_vec2_sub (side->from, line->at));
      double to = qn_vec2_cross (line->along, qn_vec2_sub (side->to, line->at));
      if (fmax (fabs (from), fabs (to)) > most + closing->slack)
        return false;
    }
  return true;
}

/* The line of two joints (the second may be NONE) with a gap between them (g not NONE), near a direction;
 * false where none lies within all the gaps and near the sides. */
static bool
fit_along (Closing *closing, const size_t joints[2], size_t g, QnVec2 along, Line *line)
{
  const ClosingSide *sides = closing->sides;
  QnVec2 origin = sides[joints[0]].from;
  size_t count = g != NONE ? add_samples (closing, g, origin, along, 0) : 0;
  for (int i = 0; i < 2; i++)
    for (size_t k = joints[i] != NONE ? sides[joints[i]].first_gap : NONE; k != NONE;
         k = closing->next_gap[k])
      count = add_samples (closing, k, origin, along, count);
  double slope, height;
  if (count == 0
      || !fit_samples (closing->samples, count, closing->slack, &slope, &height))
    return false;
  QnVec2 up = qn_vec2_perp (along);
  line->at = qn_vec2_add_scaled (origin, height, up);
  line->along = along;
  if (slope != 0) {
    line->along = qn_vec2_add_scaled (along, slope, up);
    line->along = qn_vec2_scale (1 / qn_vec2_length (line->along), line->along);
  }
  return stays_near (closing, joints, count, line);
}

/* The line of a joint, or of two (b not NONE) with a gap between them (g not NONE), in the mean direction
 * of the sides or else that of the longest. */
static bool
fit (Closing *closing, size_t a, size_t b, size_t g, Line *line)
{
  const ClosingSide *sides = closing->sides;
  const size_t joints[2] = { a, b == a ? NONE : b };
  QnVec2 ahead = sides[a].along, sum = { 0, 0 };
  size_t longest = a;
  for (int i = 0; i < 2; i++)
    for (size_t s = joints[i]; s != NONE; s = sides[s].next) {
      bool same = qn_vec2_dot (sides[s].along, ahead) >= 0;
      sum = qn_vec2_add_scaled (sum, same ? sides[s].length : -sides[s].length,
                                sides[s].along);
      longest = sides[s].length > sides[longest].length ? s : longest;
    }
  double length = qn_vec2_length (sum);
  return length > 0
         && (fit_along (closing, joints, g, qn_vec2_scale (1 / length, sum), line)
             || fit_along (closing, joints, g, sides[longest].along, line));
}

/* ---- joints ---- */

static size_t
joint_of (Closing *closing, size_t side)
{
  ClosingSide *sides = closing->sides;
  while (sides[side].joint != side) {
    sides[side].joint = sides[sides[side].joint].joint;
    side = sides[side].joint;
  }
  return side;
}

static void
make_alone (ClosingSide *sides, size_t side)
{
  sides[side].joint = sides[side].last = side;
  sides[side].next = sides[side].first_gap = sides[side].last_gap = NONE;
}

/* Makes one joint of two, or of one and itself, with a gap (or NONE) between them. */
static void
join (Closing *closing, size_t a, size_t b, size_t g)
{
  ClosingSide *sides = closing->sides;
  if (a != b) {
    sides[sides[a].last].next = b;
    sides[a].last = sides[b].last;
    sides[b].joint = a;
    if (sides[a].first_gap == NONE)
      sides[a].first_gap = sides[b].first_gap;
    else
      closing->next_gap[sides[a].last_gap] = sides[b].first_gap;
    if (sides[b].last_gap != NONE)
      sides[a].last_gap = sides[b].last_gap;
  }
  if (g == NONE)
    return;
  if (sides[a].first_gap == NONE)
    sides[a].first_gap = g;
  else
    closing->next_gap[sides[a].last_gap] = g;
  sides[a].last_gap = g;
  closing->next_gap[g] = NONE;
}

/* Joins the joints of two sides; where `fits`, only if one line lies within all gaps. */
static void
try_join (Closing *closing, size_t one, size_t two, size_t g, bool fits)
{
  Line line;
  size_t a = joint_of (closing, one), b = joint_of (closing, two);
  if (!fits || fit (closing, a, b, g, &line))
    join (closing, a < b ? a : b, a < b ? b : a, g);
}

/* Sides of the neighbours across a gap that go on in one line past its end: a bed that a head joint
 * interrupts. Whether there are, at the first or second end. */
static bool
goes_on (const Closing *closing, size_t g, int end, size_t *a, size_t *b)
{
  const ClosingSide *sides = closing->sides;
  const ClosingSide *one = &sides[side_of (closing, g, 0)],
                    *two = &sides[side_of (closing, g, 1)];
  *a = end == 0 ? one->before : one->after;
  *b = end == 0 ? two->after : two->before;
  const ClosingSide *p = &sides[*a], *q = &sides[*b];
  QnVec2 between = end == 0 ? qn_vec2_sub (q->from, p->to) : qn_vec2_sub (q->to, p->from);
  QnVec2 along = qn_vec2_add (p->along, q->along);
  return p->faces && q->faces && qn_vec2_dot (p->along, q->along) > ONWARD_COSINE
         && fabs (qn_vec2_cross (along, between))
              <= 0.5 * closing->widest * qn_vec2_length (along);
}

typedef struct Rank {
  double overlap;
  size_t gap;
} Rank;

/* Longer gaps first: they are surer. */
static int
compare_ranks (const void *left, const void *right)
{
  const Rank *a = left, *b = right;
  if (a->overlap != b->overlap)
    return a->overlap > b->overlap ? -1 : 1;
  return a->gap < b->gap ? -1 : a->gap > b->gap;
}

/* Joins across gaps, of all sides or of `parted` ones as long as lines fit, and then along beds. */
static void
join_sides (Closing *closing, const Rank *ranks, bool parted)
{
  size_t count = closing->gaps.count, a, b;
  for (size_t i = 0; i < count; i++) {
    size_t g = ranks[i].gap, one = side_of (closing, g, 0);
    if (!parted || closing->sides[one].parted)
      try_join (closing, one, side_of (closing, g, 1), g, parted);
  }
  for (size_t i = 0; i < count; i++)
    for (int end = 0; end < 2; end++)
      if (goes_on (closing, ranks[i].gap, end, &a, &b)
          && joint_of (closing, a) != joint_of (closing, b)
          && (!parted || (closing->sides[a].parted && closing->sides[b].parted)))
        try_join (closing, a, b, NONE, true);
}

/* Whether a joint has a gap at all: what touches along all its length stays as it is. */
static bool
is_open (const Closing *closing, size_t joint)
{
  for (size_t g = closing->sides[joint].first_gap; g != NONE; g = closing->next_gap[g])
    if (closing->gaps.items[g].width > closing->slack)
      return true;
  return false;
}

/* One line for every joint as a whole where it can be, else for the largest parts of it. */
static void
find_lines (Closing *closing)
{
  ClosingSide *sides = closing->sides;
  g_autofree Rank *ranks = g_new (Rank, closing->gaps.count);
  for (size_t g = 0; g < closing->gaps.count; g++)
    ranks[g] = (Rank){ overlap_of (&closing->gaps.items[g]), g };
  if (ranks != NULL)
    qsort (ranks, closing->gaps.count, sizeof *ranks, compare_ranks);
  join_sides (closing, ranks, false);
  for (size_t i = 0; i < closing->side_count; i++) {
    Line line;
    if (sides[i].joint != i || sides[i].first_gap == NONE || !is_open (closing, i))
      continue;
    bool fits = fit (closing, i, NONE, NONE, &line);
    for (size_t s = i; s != NONE; s = sides[s].next) {
      sides[s].has_line = fits;
      sides[s].line = line;
      sides[s].parted = !fits;
    }
  }
  for (size_t i = 0; i < closing->side_count; i++)
    if (sides[i].parted)
      make_alone (sides, i);
  join_sides (closing, ranks, true);
  for (size_t i = 0; i < closing->side_count; i++)
    if (sides[i].parted && sides[i].joint == i && is_open (closing, i)) {
      bool fits = fit (closing, i, NONE, NONE, &sides[i].line);
      for (size_t s = i; s != NONE; s = sides[s].next) {
        sides[s].has_line = fits;
        sides[s].line = sides[i].line;
      }
    }
  /* What is left alone ends where its neighbour does. */
  for (size_t r = 0; r < closing->gaps.count; r++)
    for (int i = 0; i < 2; i++) {
      size_t one = side_of (closing, ranks[r].gap, i);
      size_t two = side_of (closing, ranks[r].gap, 1 - i);
      if (!sides[one].has_line && sides[two].has_line && sides[one].parted
          && sides[joint_of (closing, one)].first_gap == NONE) {
        sides[one].has_line = true;
        sides[one].line = sides[two].line;
        sides[one].joint = sides[two].joint;
      }
    }
  for (size_t i = 0; i < closing->side_count; i++)
    sides[i].joint = joint_of (closing, i);
}

/* ---- corners ---- */

static QnVec2
projection (QnVec2 p, const Line *line)
{
  double s = qn_vec2_dot (qn_vec2_sub (p, line->at), line->along);
  return qn_vec2_add_scaled (line->at, s, line->along);
}

/* Where a corner goes: to the lines of both sides. */
static QnVec2
corner (const ClosingSide *before, const ClosingSide *after)
{
  QnVec2 p = after->from;
  if (!before->has_line && !after->has_line)
    return p;
  Line one = before->has_line ? before->line : (Line){ before->from, before->along };
  Line two = after->has_line ? after->line : (Line){ after->from, after->along };
  QnVec2 on_one = projection (p, &one), on_two = projection (p, &two);
  double way = fmax (qn_vec2_length (qn_vec2_sub (on_one, p)),
                     qn_vec2_length (qn_vec2_sub (on_two, p)));
  double sine = qn_vec2_cross (one.along, two.along);
  if (fabs (sine) > STRAIGHT_SINE) {
    double s = qn_vec2_cross (qn_vec2_sub (two.at, one.at), two.along) / sine;
    QnVec2 meeting = qn_vec2_add_scaled (one.at, s, one.along);
    if (qn_vec2_length (qn_vec2_sub (meeting, p)) <= MOST_MITRE * way)
      return meeting;
  }
  return qn_vec2_lerp (on_one, on_two, 0.5);
}

typedef struct Corner {
  size_t ring;
  const ClosingSide *sides[2]; /* that end and begin there */
  QnVec2 *at;
  bool taken;
} Corner;

static bool
bounds (const Corner *corner, size_t joint)
{
  return corner->sides[0]->joint == joint || corner->sides[1]->joint == joint;
}

/* Where corners that miss each other meet: in their middle, and on the line that all have in common
 * where there is one. */
static QnVec2
common_place (const Corner *corners, const QnId *group, size_t size)
{
  QnVec2 sum = { 0, 0 };
  for (size_t i = 0; i < size; i++)
    sum = qn_vec2_add (sum, *corners[group[i]].at);
  QnVec2 middle = qn_vec2_scale (1 / (double) size, sum);
  for (int i = 0; i < 2; i++) {
    const ClosingSide *side = corners[group[0]].sides[i];
    size_t shared = 0;
    for (size_t k = 0; k < size; k++)
      shared += bounds (&corners[group[k]], side->joint);
    if (shared == size)
      return projection (middle, &side->line);
  }
  return middle;
}

/* Corners of several blocks where joints meet, within `reach` of each other, become one. */
static void
gather_corners (const Closing *closing, QnRings *moved, double reach)
{
  g_auto (QnPool) room = { 0 };
  g_autofree Corner *corners = g_new (Corner, closing->side_count);
  g_autofree QnBox *boxes = g_new (QnBox, closing->side_count);
  QnBoxTree tree;
  size_t count = 0;
  for (size_t i = 0; i < moved->count; i++)
    for (size_t k = 0; k < moved->items[i].count; k++) {
      const ClosingSide *after = &closing->sides[closing->first_side[i] + k];
      if (!after->has_line || !closing->sides[after->before].has_line)
        continue;
      QnVec2 *at = &moved->items[i].points[k];
      boxes[count] = (QnBox){ *at, *at };
      corners[count++] =
        (Corner){ i, { &closing->sides[after->before], after }, at, false };
    }
  qn_tree_of (&tree, boxes, count, &room);
  for (size_t i = 0; i < count; i++) {
    if (corners[i].taken)
      continue;
    QnId group[8];
    size_t size = 0;
    double apart = 0;
    QnBoxQuery query = qn_box_tree_query (&tree, qn_box_grow (boxes[i], reach));
    for (QnId k;
         (k = qn_box_query_next (&query)) != QN_NONE && size < QN_N_ELEMENTS (group);) {
      double way = qn_vec2_length (qn_vec2_sub (boxes[k].min, boxes[i].min));
      bool own = (size_t) k != i && corners[k].ring == corners[i].ring;
      if (corners[k].taken || own || way > reach)
        continue;
      group[size++] = k;
      apart = fmax (apart, way);
    }
    QnVec2 place = common_place (corners, group, size);
    for (size_t k = 0; k < size; k++) {
      corners[group[k]].taken = true;
      if (apart > ROUNDING * reach)
        *corners[group[k]].at = place;
    }
  }
}

static void
swap_rings (QnRing *one, QnRing *two)
{
  QnRing swap = *one;
  *one = *two;
  *two = swap;
}

/* Takes from a ring what lies in another one, as long as one piece of nearly all of it is left. A ring that cannot
 * be cut is reported as an overlap. */
static void
trim (QnRing *ring, QnRing *other)
{
  g_auto (QnRings) left = { 0 };
  if (qn_polygon_difference (ring, &(QnRings){ .items = other, .count = 1 }, &left, NULL)
        == QN_OK
      && left.count == 1
      && qn_ring_area (&left.items[0]) > LEAST_LEFT * qn_ring_area (ring))
    swap_rings (ring, &left.items[0]);
}

/* Puts a ring back where it was. */
static void
restore (QnRing *ring, const QnRing *before)
{
  g_auto (QnRing) copy = qn_ring_of (before->points, before->count);
  swap_rings (ring, &copy);
}

/* Area that two rings have in common, m2; 0 where it cannot be computed. */
static double
common_area (const QnRings *rings, const QnId pair[2])
{
  g_auto (QnRings) common = { 0 };
  qn_polygon_intersection (&rings->items[pair[0]], &rings->items[pair[1]], &common, NULL);
  return qn_rings_area (&common);
}

static double
depth_of (QnBox a, QnBox b)
{
  return fmin (fmin (a.max.x, b.max.x) - fmax (a.min.x, b.min.x),
               fmin (a.max.y, b.max.y) - fmax (a.min.y, b.min.y));
}

/* Blocks that came to overlap: where more than two joints meet, or a block
 * touches another at its corner alone, no lines part them. The smaller one is trimmed. */
static void
trim_overlaps (const Closing *closing, QnRings *moved)
{
  g_auto (QnPool) room = { 0 };
  g_auto (QnBoxPairs) pairs = { 0 };
  g_autofree QnBox *boxes = g_new0 (QnBox, moved->count);
  QnBoxTree tree;
  for (size_t i = 0; i < moved->count; i++)
    if (moved->items[i].count > 0)
      boxes[i] = qn_box_of_points (moved->items[i].points, moved->items[i].count);
  qn_tree_of (&tree, boxes, moved->count, &room);
  qn_require_memory (qn_box_tree_pairs (&tree, 0, QN_MOST_SIDE_PAIRS, &pairs));
  double least = ROUNDING * closing->widest;
  for (size_t i = 0; i < pairs.count; i++) {
    const QnId *ids = pairs.items[i];
    const bool second =
      qn_ring_area (&moved->items[ids[1]]) < qn_ring_area (&moved->items[ids[0]]);
    const QnId pair[2] = { ids[second], ids[!second] };
    /* What overlapped before is not ours to judge. */
    if (depth_of (boxes[pair[0]], boxes[pair[1]]) > least
        && common_area (moved, pair) > least * closing->widest
        && common_area (closing->rings, pair) <= least * closing->widest) {
      trim (&moved->items[pair[0]], &moved->items[pair[1]]);
      for (int k = 0; k < 2; k++)
        if (common_area (moved, pair) > least * closing->widest)
          restore (&moved->items[pair[k]], &closing->rings->items[pair[k]]);
    }
  }
}

/* ---- all of it ---- */

static void
closing_init (Closing *closing, const QnRings *rings)
{
  const size_t gaps = closing->gaps.count;
  for (size_t i = 0; i < rings->count; i++)
    closing->side_count += rings->items[i].count;
  closing->sides = g_new0 (ClosingSide, closing->side_count);
  closing->first_side = g_new (size_t, rings->count);
  closing->next_gap = g_new0 (size_t, gaps);
  closing->samples = g_new (Sample, 2 * gaps);
  for (size_t i = 0, n = 0; i < rings->count; i++) {
    const QnRing *ring = &rings->items[i];
    closing->first_side[i] = n;
    for (size_t k = 0; k < ring->count; k++, n++) {
      ClosingSide *side = &closing->sides[n];
      side->from = ring->points[k];
      side->to = ring->points[(k + 1) % ring->count];
      side->along = qn_vec2_sub (side->to, side->from);
      side->length = qn_vec2_length (side->along);
      if (side->length > 0)
        side->along = qn_vec2_scale (1 / side->length, side->along);
      side->before = k > 0 ? n - 1 : n + ring->count - 1;
      side->after = k + 1 < ring->count ? n + 1 : n + 1 - ring->count;
      make_alone (closing->sides, n);
    }
  }
  for (size_t g = 0; g < closing->gaps.count; g++) {
    closing->widest = fmax (closing->widest, closing->gaps.items[g].width);
    for (int i = 0; i < 2; i++)
      closing->sides[side_of (closing, g, i)].faces = true;
  }
}

static void
closing_clear (Closing *closing)
{
  qn_gaps_clear (&closing->gaps);
  g_free (closing->sides);
  g_free (closing->first_side);
  g_free (closing->next_gap);
  g_free (closing->samples);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Closing, closing_clear)

static QnGapClosing
close_once (QnRings *rings, double least, double most)
{
  g_auto (Closing) closing = { .rings = rings, .slack = least };
  g_auto (QnRings) moved = { 0 };
  g_auto (QnGaps) left = { 0 };
  qn_gaps_find (rings, -least, most, &closing.gaps);
  closing_init (&closing, rings);
  find_lines (&closing);
  for (size_t i = 0; i < rings->count; i++) {
    qn_rings_add (&moved, rings->items[i].points, rings->items[i].count);
    for (size_t k = 0; k < rings->items[i].count; k++) {
      const ClosingSide *after = &closing.sides[closing.first_side[i] + k];
      moved.items[i].points[k] = corner (&closing.sides[after->before], after);
    }
  }
  gather_corners (&closing, &moved, 0.5 * closing.widest);
  qn_snap_neighbours (&moved, least, NULL);
  trim_overlaps (&closing, &moved);
  /* Gaps that are left are looked for anew. */
  qn_gaps_find (&moved, least, most, &left);
  QnGapClosing told = { .left = left.count };
  if (left.count > 0)
    told.left_at =
      qn_vec2_lerp (left.items[0].sides[0][0], left.items[0].sides[1][1], 0.5);
  told.grown = qn_rings_area (&moved) - qn_rings_area (rings);
  QnRings swap = *rings;
  *rings = moved;
  moved = swap;
  return told;
}

QnGapClosing
qn_gaps_close (QnRings *rings, double least, double most)
{
  QnGapClosing all = close_once (rings, least, most);
  /* Short sides may face each other only when their neighbours have grown. */
  size_t before = SIZE_MAX;
  for (int i = 0; i < MOST_PASSES && all.left > 0 && all.left < before; i++) {
    before = all.left;
    QnGapClosing again = close_once (rings, least, most);
    again.grown += all.grown;
    all = again;
  }
  return all;
}
