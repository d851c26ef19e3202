#include "core/contact/contact-follow.h"

#include "core/base/polygon.h"
#include "core/contact/contact-search.h"

#include <stdlib.h>
#include <string.h>

/* Most pairs of blocks near each other that a search looks at, per block. */
#define MOST_NEAR 1000

QnStatus
qn_contact_follow_init (QnContactFollow *follow, const QnModel *model,
                        const QnContacts *drawn, QnDiag *diag)
{
  size_t blocks = model->block_count;

  *follow = (QnContactFollow){ .model = model, .drawn = drawn, .smallest = INFINITY };
  follow->sizes = qn_pool_alloc (&follow->pool, blocks, sizeof *follow->sizes);
  follow->reach = qn_pool_alloc (&follow->pool, blocks, sizeof *follow->reach);
  follow->left = qn_pool_alloc (&follow->pool, drawn->face_count, sizeof *follow->left);
  follow->at_search =
    qn_pool_alloc (&follow->pool, blocks * QN_DOF_COUNT, sizeof (double));
  qn_sides_init (&follow->sides, model, qn_contact_lengths (model).tolerance,
                 &follow->pool);
  if (follow->pool.failed)
    return qn_diag_no_memory (diag);
  for (size_t b = 0; b < blocks; b++) {
    const QnVec2 *v = qn_model_block_vertices (model, (QnId) b);
    follow->sizes[b] = sqrt (model->blocks[b].area);
    follow->smallest = fmin (follow->smallest, follow->sizes[b]);
    for (QnId i = 0; i < model->blocks[b].vertex_count; i++)
      follow->reach[b] = fmax (
        follow->reach[b], qn_vec2_length (qn_vec2_sub (v[i], model->blocks[b].centroid)));
  }
  return QN_OK;
}

void
qn_contact_follow_clear (QnContactFollow *follow)
{
  free (follow->found);
  free (follow->active);
  free (follow->origins);
  qn_pool_clear (&follow->pool);
  *follow = (QnContactFollow){ 0 };
}

void
qn_contact_follow_set_overlap (QnContactFollow *follow, const double *elongations)
{
  follow->overlap = 0;
  for (size_t p = 0; p < follow->drawn->pair_count; p++)
    follow->overlap = fmax (follow->overlap, -elongations[2 * p]);
}

double
qn_contact_follow_band (const QnContactFollow *follow, QnId a, QnId b)
{
  return fmax (QN_FOLLOW_SLIP * fmin (follow->sizes[a], follow->sizes[b]),
               QN_FOLLOW_OVERLAP * follow->overlap);
}

/* --- Where corners are ------------------------------------------------------------------- */

static QnCornerPlace
place_beside (const QnSide *side, QnVec2 corner)
{
  QnVec2 from = qn_vec2_sub (corner, side->start);

  return (QnCornerPlace){ .along = qn_vec2_dot (from, side->direction),
                          .length = side->length,
                          .apart = -qn_vec2_cross (side->direction, from) };
}

static QnVec2
corner_of (const QnContactFollow *follow, const QnFoundContact *contact,
           const double *displacements)
{
  const QnModel *model = follow->model;
  QnVec2 corner = qn_model_block_vertices (model, contact->other)[contact->corner];

  return qn_block_unplace (model, contact->block, displacements,
                           qn_block_place (model, contact->other, displacements, corner));
}

QnCornerPlace
qn_contact_follow_place (const QnContactFollow *follow, const QnFoundContact *contact,
                         const double *displacements)
{
  return place_beside (qn_sides_find (&follow->sides, contact->block, contact->side),
                       corner_of (follow, contact, displacements));
}

/* --- Leaving joints ---------------------------------------------------------------------- */

static bool
is_crossed_by_bar (const QnContacts *contacts, const QnContactFace *face)
{
  for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
    if (contacts->pairs[p].bar != QN_NONE)
      return true;
  return false;
}

bool
qn_contact_follow_leave (QnContactFollow *follow, const double *displacements,
                         const QnPairResponse *responses)
{
  bool any = false;

  for (size_t f = 0; f < follow->drawn->face_count; f++) {
    const QnContactFace *face = &follow->drawn->faces[f];
    if (follow->left[f])
      continue;
    double turn = displacements[QN_DOF_COUNT * face->a + QN_DOF_RZ]
                  - displacements[QN_DOF_COUNT * face->b + QN_DOF_RZ];
    bool leaves = fabs (turn) > QN_FOLLOW_TURN;
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      leaves = leaves
               || fabs (responses[p].memory.a.slip + responses[p].memory.b.slip)
                    > qn_contact_follow_band (follow, face->a, face->b);
    if (!leaves || is_crossed_by_bar (follow->drawn, face))
      continue;
    follow->left[f] = any = true;
  }
  return any;
}

/* --- Search ------------------------------------------------------------------------------ */

bool
qn_contact_follow_is_due (const QnContactFollow *follow, const double *displacements,
                          double margin)
{
  double moved = 0;

  if (follow->margin < margin)
    return true;
  for (size_t b = 0; b < follow->model->block_count; b++) {
    const double *d = displacements + QN_DOF_COUNT * b,
                 *d0 = follow->at_search + QN_DOF_COUNT * b;
    moved = fmax (moved, hypot (d[0] - d0[0], d[1] - d0[1])
                           + follow->reach[b] * fabs (d[2] - d0[2]));
  }
  return moved > 0.25 * follow->margin;
}

void
qn_contacts_between (const QnContacts *drawn, QnId a, QnId b, size_t *first, size_t *end)
{
  const QnContactFace *faces = drawn->faces;
  QnId low = a < b ? a : b, high = a < b ? b : a;
  size_t after = drawn->face_count;

  *first = 0;
  while (*first < after) { /* faces are sorted by a, b */
    size_t middle = *first + (after - *first) / 2;
    if (faces[middle].a < low || (faces[middle].a == low && faces[middle].b < high))
      *first = middle + 1;
    else
      after = middle;
  }
  *end = *first;
  while (*end < drawn->face_count && faces[*end].a == low && faces[*end].b == high)
    ++*end;
}

/* The joint as drawn between two blocks that still holds; where `side` is not NULL, on that side of
 * block a; where `other` is not NULL, on either of these two sides of block b. */
static bool
is_joined (const QnContactFollow *follow, QnId a, QnId b, const QnSide *side,
           const QnSide *const other[2])
{
  size_t first, end;

  qn_contacts_between (follow->drawn, a, b, &first, &end);
  for (; first < end; first++) {
    const QnContactFace *face = &follow->drawn->faces[first];
    QnId own = face->a == a ? face->edge_a : face->edge_b,
         theirs = face->a == a ? face->edge_b : face->edge_a;
    if (!follow->left[first] && (side == NULL || side->vertex == own)
        && (other == NULL || other[0]->vertex == theirs || other[1]->vertex == theirs))
      return true;
  }
  return false;
}

/* Corners of block b near sides of block a. */
static void
list_corners (QnContactFollow *follow, QnId a, QnId b, const double *displacements,
              double margin)
{
  const QnSides *sides = &follow->sides;
  const QnSide *own = sides->items + sides->first[b];
  size_t corners = sides->first[b + 1] - sides->first[b];
  bool joined = is_joined (follow, a, b, NULL, NULL);

  for (size_t i = 0; i < corners; i++) {
    const QnSide *next = &own[(i + 1) % corners];
    const QnSide *const both[2] = { &own[i], next };
    if (!(qn_vec2_cross (own[i].direction, next->direction) > 0))
      continue; /* the boundary of the block does not bulge there */
    if (joined && is_joined (follow, a, b, NULL, both))
      continue; /* it is held where it is */
    QnVec2 corner =
      qn_block_unplace (follow->model, a, displacements,
                        qn_block_place (follow->model, b, displacements, next->start));
    for (size_t s = sides->first[a]; s < sides->first[a + 1]; s++) {
      const QnSide *side = &sides->items[s];
      QnCornerPlace at = place_beside (side, corner);
      double over = joined ? -qn_contact_follow_band (follow, a, b) : margin;
      if (fabs (at.apart) > margin || at.along < -over || at.along > at.length + over
          || (joined && is_joined (follow, a, b, side, NULL)))
        continue;
      follow->pool.failed |=
        !QN_ARRAY_PUSH (follow->found, follow->count, follow->capacity,
                        (QnFoundContact){ .block = a,
                                          .side = side->vertex,
                                          .other = b,
                                          .corner = next->vertex,
                                          .foot = at.along });
    }
  }
}

static bool
is_same (const QnFoundContact *a, const QnFoundContact *b)
{
  return a->block == b->block && a->side == b->side && a->other == b->other
         && a->corner == b->corner;
}

static bool
is_between (const QnFoundContact *c, QnId a, QnId b)
{
  return (c->block == a && c->other == b) || (c->block == b && c->other == a);
}

/* The first listed contact between these blocks, or where it would stand. */
static size_t
first_between (const QnContactFollow *follow, QnId a, QnId b)
{
  size_t first = 0, end = follow->count;
  QnId low = a < b ? a : b, high = a < b ? b : a;

  while (first < end) {
    size_t middle = first + (end - first) / 2;
    const QnFoundContact *c = &follow->found[middle];
    QnId c_low = c->block < c->other ? c->block : c->other,
         c_high = c->block < c->other ? c->other : c->block;
    if (c_low < low || (c_low == low && c_high < high))
      first = middle + 1;
    else
      end = middle;
  }
  return first;
}

size_t
qn_contact_follow_end (const QnContactFollow *follow, size_t first)
{
  const QnFoundContact *c = &follow->found[first];
  size_t end = first + 1;

  while (end < follow->count && is_between (&follow->found[end], c->block, c->other))
    end++;
  return end;
}

size_t
qn_contact_follow_find (const QnContactFollow *follow, const QnFoundContact *contact)
{
  QnId a = contact->block, b = contact->other;

  for (size_t i = first_between (follow, a, b);
       i < follow->count && is_between (&follow->found[i], a, b); i++)
    if (is_same (&follow->found[i], contact))
      return i;
  return follow->count;
}

/* States of the contacts of the previous list. Whether the list is the same. */
static bool
take_over (QnContactFollow *follow, const QnFoundContact *before, const bool *active,
           size_t count)
{
  bool same = count == follow->count;

  for (size_t i = 0; i < follow->count; i++)
    follow->origins[i] = QN_NONE;
  for (size_t i = 0; i < count; i++) {
    size_t at = qn_contact_follow_find (follow, &before[i]);
    if (at < follow->count) {
      follow->found[at] = before[i];
      follow->active[at] = active[i];
      follow->origins[at] = (QnId) i;
    }
    same = same && at == i;
  }
  return same;
}

QnStatus
qn_contact_follow_search (QnContactFollow *follow, const double *displacements,
                          double margin, bool *changed, QnDiag *diag)
{
  QnFoundContact *before = follow->found;
  bool *active = follow->active;
  size_t count = follow->count;

  follow->found = NULL;
  follow->count = follow->capacity = 0;
  const QnModel *model = follow->model;
  size_t blocks = model->block_count;
  QnPool room = { 0 };
  QnBox *boxes = qn_pool_alloc (&room, blocks, sizeof *boxes);
  QnBoxTree tree;
  QnBoxPairs pairs = { 0 };
  for (size_t b = 0; boxes != NULL && b < blocks; b++) {
    const QnVec2 *v = qn_model_block_vertices (model, (QnId) b);
    boxes[b] = QN_BOX_EMPTY;
    for (QnId i = 0; i < model->blocks[b].vertex_count; i++)
      qn_box_add_point (&boxes[b], qn_block_place (model, (QnId) b, displacements, v[i]));
  }
  qn_box_tree_init (&tree, boxes, blocks, &room);
  follow->pool.failed |=
    room.failed || !qn_box_tree_pairs (&tree, margin, MOST_NEAR * blocks, &pairs);
  for (size_t i = 0; i < pairs.count; i++) {
    QnId a = pairs.items[i][0], b = pairs.items[i][1];
    if (qn_support_is_full (model->blocks[a].support)
        && qn_support_is_full (model->blocks[b].support))
      continue;
    list_corners (follow, a, b, displacements, margin);
    list_corners (follow, b, a, displacements, margin);
  }
  qn_box_pairs_clear (&pairs);
  qn_pool_clear (&room);
  free (follow->origins);
  follow->active = qn_alloc (follow->count, sizeof *follow->active);
  follow->origins = qn_alloc (follow->count, sizeof *follow->origins);
  follow->pool.failed |= follow->active == NULL || follow->origins == NULL;
  if (!follow->pool.failed)
    *changed = !take_over (follow, before, active, count);
  follow->margin = margin;
  memcpy (follow->at_search, displacements,
          follow->model->block_count * QN_DOF_COUNT * sizeof *displacements);
  free (before);
  free (active);
  return follow->pool.failed ? qn_diag_no_memory (diag) : QN_OK;
}

/* --- Activation --------------------------------------------------------------------------- */

/* Whether no other side of the block is nearer to a corner that lies within it. */
static bool
is_least_deep (const QnContactFollow *follow, const QnFoundContact *contact,
               QnCornerPlace at, const double *displacements)
{
  const QnSides *sides = &follow->sides;
  QnVec2 corner = corner_of (follow, contact, displacements);

  for (size_t s = sides->first[contact->block]; s < sides->first[contact->block + 1]; s++)
    if (sides->items[s].vertex != contact->side
        && qn_segment_distance (sides->items[s].start, sides->items[s].end, corner)
             < -at.apart)
      return false;
  return true;
}

/* Whether the corner at the end of this side nearer to the contact's own corner touches one of that
 * corner's sides already. */
static bool
is_met (const QnContactFollow *follow, size_t index, QnCornerPlace at)
{
  const QnFoundContact *contact = &follow->found[index];
  const QnSides *sides = &follow->sides;
  const QnSide *side = qn_sides_find (sides, contact->block, contact->side);
  QnVec2 end = at.along < 0.5 * at.length ? side->start : side->end;
  QnId a = contact->block, b = contact->other;
  double near = qn_contact_follow_band (follow, a, b);

  if (fmin (at.along, at.length - at.along) > near)
    return false;
  for (size_t k = first_between (follow, a, b);
       k < follow->count && is_between (&follow->found[k], a, b); k++) {
    const QnFoundContact *c = &follow->found[k];
    if (!follow->active[k] || c->block != contact->other)
      continue;
    QnVec2 corner = qn_model_block_vertices (follow->model, c->other)[c->corner];
    if (corner.x == end.x && corner.y == end.y)
      return true;
  }
  return false;
}

bool
qn_contact_follow_activate (QnContactFollow *follow, const double *displacements)
{
  bool any = false;

  for (size_t i = 0; i < follow->count; i++) {
    QnFoundContact *c = &follow->found[i];
    QnCornerPlace at = qn_contact_follow_place (follow, c, displacements);
    double over = qn_contact_follow_band (follow, c->block, c->other);
    if (!follow->active[i])
      continue;
    bool slid_off = at.along < -over || at.along > at.length + over;
    bool came_out = c->inset > 0 && at.apart >= 0;
    if (slid_off || came_out)
      c->inset = 0;
    follow->active[i] = !slid_off;
    any = any || slid_off || came_out;
  }
  for (size_t i = 0; i < follow->count; i++) {
    const QnFoundContact *c = &follow->found[i];
    if (follow->active[i])
      continue;
    QnCornerPlace at = qn_contact_follow_place (follow, c, displacements);
    if (at.along < 0 || at.along > at.length || at.apart < -follow->margin
        || (at.apart < 0 && !is_least_deep (follow, c, at, displacements))
        || is_met (follow, i, at))
      continue;
    follow->active[i] = any = true;
  }
  return any;
}

/* --- As faces and pairs ------------------------------------------------------------------ */

/* Length of the longer side at a corner. */
static double
longer_side (const QnSides *sides, QnId block, QnId corner)
{
  const QnSide *own = sides->items + sides->first[block];
  size_t count = sides->first[block + 1] - sides->first[block];
  double longest = 0;

  for (size_t i = 0; i < count; i++)
    if (own[i].vertex == corner || own[(i + 1) % count].vertex == corner)
      longest = fmax (longest, own[i].length);
  return longest;
}

bool
qn_contacts_set_inset (QnContacts *contacts, size_t pair, double inset)
{
  QnContactPair *p = &contacts->pairs[pair];
  const QnContactFace *face = &contacts->faces[p->face];
  QnVec2 foot = qn_vec2_add_scaled (face->start, p->abscissa, face->tangent);
  QnVec2 before = p->foot;

  p->foot = qn_vec2_add_scaled (foot, -inset, face->normal);
  return p->foot.x != before.x || p->foot.y != before.y;
}

QnStatus
qn_contacts_with_found (const QnModel *model, const QnContacts *drawn,
                        const QnSides *sides, const QnFoundContact *found, size_t count,
                        QnContacts *contacts, QnDiag *diag)
{
  size_t faces = drawn->face_count + count, pairs = drawn->pair_count + count;

  *contacts = (QnContacts){ .face_count = drawn->face_count,
                            .face_capacity = faces,
                            .pair_count = drawn->pair_count,
                            .pair_capacity = pairs };
  contacts->faces = qn_alloc (faces, sizeof *contacts->faces);
  contacts->pairs = qn_alloc (pairs, sizeof *contacts->pairs);
  if (contacts->faces == NULL || contacts->pairs == NULL) {
    qn_contacts_clear (contacts);
    return qn_diag_no_memory (diag);
  }
  if (drawn->face_count > 0)
    memcpy (contacts->faces, drawn->faces, drawn->face_count * sizeof *contacts->faces);
  if (drawn->pair_count > 0)
    memcpy (contacts->pairs, drawn->pairs, drawn->pair_count * sizeof *contacts->pairs);
  for (size_t i = 0; i < count; i++) {
    const QnFoundContact *c = &found[i];
    const QnSide *side = qn_sides_find (sides, c->block, c->side);
    const QnBlock *blocks = model->blocks;
    QnContactFace *face = &contacts->faces[contacts->face_count];

    *face = (QnContactFace){
      .a = c->block,
      .b = c->other,
      .edge_a = c->side,
      .edge_b = c->corner,
      .start = side->start,
      .end = side->end,
      .normal = qn_vec2 (side->direction.y, -side->direction.x),
      .tangent = side->direction,
      .length = side->length,
      .thickness = fmin (blocks[c->block].thickness, blocks[c->other].thickness),
      .law_a = qn_model_side_law (model, c->block, c->other),
      .law_b = qn_model_side_law (model, c->other, c->block),
      .first_pair = (QnId) contacts->pair_count,
      .pair_count = 1,
    };
    contacts->pairs[contacts->pair_count++] = (QnContactPair){
      .face = (QnId) contacts->face_count++,
      .bar = QN_NONE,
      .point = qn_model_block_vertices (model, c->other)[c->corner],
      .abscissa = c->foot,
      .tributary = 0.5 * fmin (side->length, longer_side (sides, c->other, c->corner)),
      .found = true,
    };
    qn_contacts_set_inset (contacts, contacts->pair_count - 1, c->inset);
  }
  return QN_OK;
}
