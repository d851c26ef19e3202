#include "core/model/outline.h"

#include "core/base/tolerance.h"

/* Unit vector that points out of a block at one of its sides. */
static QnVec2
direction_of (QnBlockSide side)
{
  static const QnVec2 directions[QN_BLOCK_SIDE_COUNT] = {
    [QN_BLOCK_SIDE_LEFT] = { -1, 0 },
    [QN_BLOCK_SIDE_RIGHT] = { 1, 0 },
    [QN_BLOCK_SIDE_BOTTOM] = { 0, -1 },
    [QN_BLOCK_SIDE_TOP] = { 0, 1 },
  };

  return directions[side];
}

QnId
qn_block_facing_edge (const QnModel *model, QnId block, QnBlockSide side)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  const QnVec2 direction = direction_of (side);
  QnId count = model->blocks[block].vertex_count, best = 0;
  double best_facing = -INFINITY, best_length = 0;

  for (QnId i = 0; i < count; i++) {
    QnVec2 edge = qn_vec2_sub (v[(i + 1) % count], v[i]);
    double length = qn_vec2_length (edge);
    /* Counter-clockwise: the outer normal is the edge turned by -90 degrees. */
    double facing = qn_vec2_cross (direction, edge) / length;
    if (facing > best_facing + QN_TOLERANCE_CONVEX
        || (facing > best_facing - QN_TOLERANCE_CONVEX && length > best_length)) {
      best = i;
      best_facing = facing;
      best_length = length;
    }
  }
  return best;
}

/* --- What is seen from a side ------------------------------------------------------------- */

/* An edge in the axes of the viewer: u to the right, h towards him. */
typedef struct {
  QnId block, edge;
  QnVec2 low, high; /* ends by u */
} Segment;

/* Part of the envelope between two u. */
typedef struct {
  double from, to;
  const Segment *segment;
} Piece;

typedef struct {
  Piece *items;
  size_t count;
} Envelope;

static double
segment_height (const Segment *s, double u)
{
  return s->low.y + (s->high.y - s->low.y) * ((u - s->low.x) / (s->high.x - s->low.x));
}

static void
append (Envelope *out, double from, double to, const Segment *segment)
{
  Piece *last = out->count > 0 ? &out->items[out->count - 1] : NULL;

  if (last != NULL && last->segment == segment && last->to == from)
    last->to = to;
  else
    out->items[out->count++] = (Piece){ from, to, segment };
}

/* Room for 2 count pieces in both. */
static Envelope
find_envelope (const Segment *segments, size_t count, Piece *room, Piece *scratch)
{
  if (count == 1) {
    room[0] = (Piece){ segments->low.x, segments->high.x, segments };
    return (Envelope){ room, 1 };
  }
  size_t half = count / 2;
  Envelope a = find_envelope (segments, half, scratch, room);
  Envelope b =
    find_envelope (segments + half, count - half, scratch + 2 * half, room + 2 * half);
  /* Both envelopes begin and end pieces at ends of segments, and so does the merged one:
   * of n segments it has fewer than 2 n pieces. */
  Envelope out = { room, 0 };
  size_t i = 0, j = 0;
  double u = -INFINITY;

  while (i < a.count || j < b.count) {
    double from_a = i < a.count ? fmax (a.items[i].from, u) : INFINITY;
    double from_b = j < b.count ? fmax (b.items[j].from, u) : INFINITY;
    double to_a = i < a.count ? a.items[i].to : INFINITY;
    double to_b = j < b.count ? b.items[j].to : INFINITY;

    if (from_a < from_b) {
      u = fmin (to_a, from_b);
      append (&out, from_a, u, a.items[i].segment);
    } else if (from_b < from_a) {
      u = fmin (to_b, from_a);
      append (&out, from_b, u, b.items[j].segment);
    } else {
      u = fmin (to_a, to_b);
      double middle = 0.5 * (from_a + u);
      bool above = segment_height (a.items[i].segment, middle)
                   >= segment_height (b.items[j].segment, middle);
      append (&out, from_a, u, above ? a.items[i].segment : b.items[j].segment);
    }
    i += i < a.count && u >= to_a;
    j += j < b.count && u >= to_b;
  }
  return out;
}

static QnVec2
seen_from (QnVec2 direction, QnVec2 point)
{
  return qn_vec2 (qn_vec2_cross (point, direction), qn_vec2_dot (point, direction));
}

/* The edges that face the viewer; their outlines run against u there. */
static size_t
gather_segments (const QnModel *model, QnVec2 direction, Segment *segments)
{
  size_t count = 0;

  for (size_t b = 0; b < model->block_count; b++) {
    const QnVec2 *v = qn_model_block_vertices (model, (QnId) b);
    QnId edges = model->blocks[b].vertex_count;
    for (QnId e = 0; e < edges; e++) {
      QnVec2 start = seen_from (direction, v[e]);
      QnVec2 end = seen_from (direction, v[(e + 1) % edges]);
      if (end.x < start.x)
        segments[count++] = (Segment){ (QnId) b, e, end, start };
    }
  }
  return count;
}

static QnVec2
point_at (const QnModel *model, const Segment *s, double u)
{
  const QnVec2 *v = qn_model_block_vertices (model, s->block);
  QnVec2 start = v[s->edge];
  QnVec2 end = v[(s->edge + 1) % model->blocks[s->block].vertex_count];

  return u == s->high.x ? start
         : u == s->low.x
           ? end
           : qn_vec2_lerp (start, end, (s->high.x - u) / (s->high.x - s->low.x));
}

void
qn_model_find_seen_edges (const QnModel *model, QnBlockSide from, QnSeenEdges *seen,
                          QnPool *pool)
{
  size_t most = model->vertex_count;
  Segment *segments = qn_pool_alloc (pool, most, sizeof *segments);
  Piece *room = qn_pool_alloc (pool, most, 4 * sizeof *room);

  *seen = (QnSeenEdges){ qn_pool_alloc (pool, most, 2 * sizeof *seen->items), 0 };
  size_t count =
    pool->failed ? 0 : gather_segments (model, direction_of (from), segments);
  if (count == 0)
    return;
  Envelope envelope = find_envelope (segments, count, room, room + 2 * count);
  for (size_t i = 0; i < envelope.count; i++) {
    const Piece *piece = &envelope.items[i];
    seen->items[seen->count++] = (QnSeenEdge){
      piece->segment->block,
      piece->segment->edge,
      { point_at (model, piece->segment, piece->to),
        point_at (model, piece->segment, piece->from) },
    };
  }
}

const QnLoad *
qn_model_find_road (const QnModel *model, const QnSeenEdges *top, double x,
                    double *height)
{
  *height = NAN;
  for (size_t i = 0; i < model->dead_load_count; i++) {
    const QnLoad *load = &model->dead_loads[i];
    *height = load->kind == QN_LOAD_FILL ? qn_load_surface_at (load, x) : NAN;
    if (!isnan (*height))
      return load;
  }
  for (size_t i = 0; i < top->count; i++) {
    QnVec2 left = top->items[i].ends[1], right = top->items[i].ends[0];
    if (x >= left.x && x <= right.x)
      *height = left.y + (right.y - left.y) * ((x - left.x) / (right.x - left.x));
  }
  return NULL;
}
