/* Contact faces: where a side of one block faces a side of another on a common line. */
#include "core/contact/contact-search.h"

#include "core/base/polygon.h"

#include <stdlib.h>

typedef enum { MATCH_FACE, MATCH_TOUCH, MATCH_GAP } MatchKind;

/* Relation of one side of block a to one side of block b. */
typedef struct QnContactMatch {
  MatchKind kind;
  QnId side_a, side_b;
  double from;       /* where it begins along side a, m */
  QnVec2 start, end; /* FACE, GAP: ends of the common stretch; TOUCH: start alone */
  double width;      /* GAP: its largest width, m */
} Match;

typedef QnContactMatches Matches;

static void
add_match (const QnContactSearch *search, Matches *matches, Match match)
{
  search->room->failed |=
    !QN_ARRAY_PUSH (matches->items, matches->count, matches->capacity, match);
}

/* One end of the stretch that two opposite sides have in common. */
typedef struct {
  double along; /* from the start of side a along the common direction, m */
  QnVec2 place; /* the vertex, of a or of b, that ends the stretch */
  double gap;   /* distance of side b in front of side a there, m */
} StretchEnd;

/* Height of the line through a side above the line of reference, at `along`. */
static double
height_at (double along, double along_p, double height_p, double along_q, double height_q)
{
  double span = along_q - along_p;
  return span != 0 ? height_p + (height_q - height_p) * (along - along_p) / span
                   : height_p;
}

/* The stretch in which `b` runs opposite to `a`; false if it is no longer than `least`. */
static bool
common_stretch (const QnSide *a, const QnSide *b, double least, StretchEnd ends[2])
{
  if (qn_vec2_dot (a->direction, b->direction) >= 0)
    return false;

  /* The longer side knows the direction of the joint better. */
  QnVec2 u = a->length >= b->length ? a->direction : qn_vec2_scale (-1, b->direction);
  QnVec2 normal = { u.y, -u.x };
  QnVec2 to_a1 = qn_vec2_sub (a->end, a->start);
  QnVec2 to_b0 = qn_vec2_sub (b->end, a->start), to_b1 = qn_vec2_sub (b->start, a->start);
  double a1 = qn_vec2_dot (u, to_a1);
  double b0 = qn_vec2_dot (u, to_b0), b1 = qn_vec2_dot (u, to_b1);
  ends[0] = b0 > 0 ? (StretchEnd){ b0, b->end, 0 } : (StretchEnd){ 0, a->start, 0 };
  ends[1] = b1 < a1 ? (StretchEnd){ b1, b->start, 0 } : (StretchEnd){ a1, a->end, 0 };
  if (ends[1].along - ends[0].along <= least)
    return false;

  for (int i = 0; i < 2; i++) {
    double s = ends[i].along;
    double of_a = height_at (s, 0, 0, a1, qn_vec2_dot (normal, to_a1));
    double of_b =
      height_at (s, b0, qn_vec2_dot (normal, to_b0), b1, qn_vec2_dot (normal, to_b1));
    ends[i].gap = of_b - of_a;
  }
  return true;
}

/* A face if the gap is within the tolerance all along; a near miss if it is not much wider. */
static void
match_stretch (const QnContactSearch *search, const QnSide *a, const QnSide *b,
               Match match, Matches *matches)
{
  StretchEnd ends[2];
  if (!common_stretch (a, b, 2 * search->lengths.tolerance, ends))
    return;

  double widest = qn_max (ends[0].gap, ends[1].gap);
  double narrowest = qn_min (ends[0].gap, ends[1].gap);
  if (narrowest < -search->lengths.tolerance || widest > search->lengths.gap_limit)
    return;
  match.kind = widest <= search->lengths.tolerance ? MATCH_FACE : MATCH_GAP;
  if (match.kind == MATCH_GAP && ends[1].along - ends[0].along <= widest)
    return; /* corners that pass each other, no joint */
  match.from = ends[0].along;
  match.start = ends[0].place;
  match.end = ends[1].place;
  match.width = widest;
  add_match (search, matches, match);
}

/* Whether `corner` lies on `side`, its end excluded, and its start too unless `with_start`. */
static bool
lies_on (QnVec2 corner, const QnSide *side, bool with_start, double tolerance)
{
  QnVec2 to = qn_vec2_sub (corner, side->start);
  double along = qn_vec2_dot (side->direction, to);
  return fabs (qn_vec2_cross (side->direction, to)) <= tolerance
         && along >= (with_start ? -tolerance : tolerance)
         && along < side->length - tolerance;
}

static int
compare_matches (const void *left, const void *right)
{
  const Match *l = left, *r = right;
  if (l->kind != r->kind)
    return l->kind < r->kind ? -1 : 1;
  if (l->side_a != r->side_a)
    return l->side_a < r->side_a ? -1 : 1;
  if (l->from != r->from)
    return l->from < r->from ? -1 : 1;
  return (l->side_b > r->side_b) - (l->side_b < r->side_b);
}

/* Everything that two blocks have to do with each other, sorted. */
static void
find_matches (const QnContactSearch *search, QnId a, QnId b, Matches *matches)
{
  const QnSide *sides = search->sides.items, *side_a, *side_b;
  double reach = search->lengths.gap_limit;
  QnSideWalk walk_a, walk_b;

  matches->count = 0;
  /* What is near enough for certain, then what is, by one and the same rounding. */
  qn_side_walk_start (&walk_a, search, a,
                      qn_box_grow (search->block_boxes[b], 2 * reach));
  while ((side_a = qn_side_walk_next (&walk_a)) != NULL) {
    qn_side_walk_start (&walk_b, search, b, qn_box_grow (qn_side_box (side_a), reach));
    while ((side_b = qn_side_walk_next (&walk_b)) != NULL) {
      Match match = { .side_a = (QnId) (side_a - sides),
                      .side_b = (QnId) (side_b - sides) };
      match_stretch (search, side_a, side_b, match, matches);
      /* Every corner is the start of one side; where two corners meet, only the first
       * test sees it. */
      match.kind = MATCH_TOUCH;
      if (lies_on (side_a->start, side_b, true, search->lengths.tolerance)) {
        match.start = match.end = side_a->start;
        add_match (search, matches, match);
      }
      if (lies_on (side_b->start, side_a, false, search->lengths.tolerance)) {
        match.start = match.end = side_b->start;
        add_match (search, matches, match);
      }
    }
  }
  if (matches->count > 1)
    qsort (matches->items, matches->count, sizeof *matches->items, compare_matches);
}

static void
add_face (const QnContactSearch *search, QnContacts *contacts, const Match *match)
{
  const QnSide *a = &search->sides.items[match->side_a];
  const QnSide *b = &search->sides.items[match->side_b];
  const QnBlock *blocks = search->model->blocks;
  QnVec2 along = qn_vec2_sub (match->end, match->start);
  QnVec2 tangent =
    a->length >= b->length ? a->direction : qn_vec2_scale (-1, b->direction);
  QnContactFace face = {
    .a = a->block,
    .b = b->block,
    .edge_a = a->vertex,
    .edge_b = b->vertex,
    .start = match->start,
    .end = match->end,
    .normal = { tangent.y, -tangent.x },
    .tangent = tangent,
    .length = qn_vec2_length (along),
    .thickness = qn_min (blocks[a->block].thickness, blocks[b->block].thickness),
    .law_a = QN_NONE,
    .law_b = QN_NONE,
  };
  search->room->failed |=
    !QN_ARRAY_PUSH (contacts->faces, contacts->face_count, contacts->face_capacity, face);
}

/* Whether a third block fills the gap there. */
static bool
is_filled (const QnContactSearch *search, QnVec2 at, QnId a, QnId b)
{
  const QnModel *model = search->model;
  QnBoxQuery query = qn_box_tree_query (&search->block_tree, (QnBox){ at, at });
  QnId block;
  while ((block = qn_box_query_next (&query)) != QN_NONE) {
    if (block != a && block != b
        && qn_polygon_depth (qn_model_block_vertices (model, block),
                             (size_t) model->blocks[block].vertex_count, at)
             > 0)
      return true;
  }
  return false;
}

static void
add_gap (const QnContactSearch *search, QnContacts *contacts, const Match *match)
{
  QnId a = search->sides.items[match->side_a].block;
  QnId b = search->sides.items[match->side_b].block;
  QnVec2 at = qn_vec2_lerp (match->start, match->end, 0.5);
  QnVec2 across = qn_vec2_perp (search->sides.items[match->side_a].direction);
  QnVec2 between = qn_vec2_add_scaled (at, -match->width / 2, across);
  if (!is_filled (search, between, a, b))
    qn_contacts_tell (contacts, QN_PROBLEM_NEAR_MISS_GAP, a, b, QN_NONE, at,
                      match->width);
}

static void
add_touch (const QnContactSearch *search, QnTouches *touches, QnId a, QnId b, QnVec2 at)
{
  /* A corner on a corner of sides in several directions may be seen more than once. */
  for (size_t i = touches->count; i > 0; i--) {
    const QnTouch *earlier = &touches->items[i - 1];
    if (earlier->a != a || earlier->b != b)
      break;
    if (qn_vec2_length (qn_vec2_sub (earlier->at, at)) <= 4 * search->lengths.tolerance)
      return;
  }
  search->room->failed |= !QN_ARRAY_PUSH (touches->items, touches->count,
                                          touches->capacity, (QnTouch){ a, b, at });
}

/* Whether the place lies on one of the faces from `first` on. */
static bool
on_common_face (const QnContactSearch *search, const QnContacts *contacts, size_t first,
                QnVec2 place)
{
  for (size_t i = contacts->face_count; i > first; i--) {
    const QnContactFace *face = &contacts->faces[i - 1];
    if (qn_segment_distance (face->start, face->end, place)
        <= 4 * search->lengths.tolerance)
      return true;
  }
  return false;
}

void
qn_contact_match_pair (const QnContactSearch *search, QnId a, QnId b, Matches *matches,
                       QnContacts *contacts, QnTouches *touches)
{
  size_t first = contacts->face_count;

  find_matches (search, a, b, matches);
  /* Faces come before touches. */
  for (size_t i = 0; i < matches->count; i++) {
    const Match *match = &matches->items[i];
    switch (match->kind) {
    case MATCH_FACE:
      add_face (search, contacts, match);
      break;
    case MATCH_TOUCH:
      if (!on_common_face (search, contacts, first, match->start))
        add_touch (search, touches, a, b, match->start);
      break;
    case MATCH_GAP:
      add_gap (search, contacts, match);
      break;
    }
  }
}
