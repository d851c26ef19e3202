#include "render/scene/thrust.h"

#include "core/base/box-tree.h"
#include "core/base/union-find.h"

#include <glib.h>

/* Faces follow each other along a line when the gap between them is below this part of the size
 * of a block (mortar between two head joints), and their lines differ by less than that. */
#define GAP_SHARE    0.1
#define OFFSET_SHARE 1e-3

/* Sine of the angle between faces of one line. */
#define STRAIGHT 1e-3

typedef struct Search {
  const QnModel *model;
  const QnContacts *contacts;
  const QnPairResult *pairs;
  double size;  /* m, of a block */
  QnId *cut_of; /* by face; the thrust's */
  /* Lists of sides of faces by block, 2 f of face f that of a and 2 f + 1 that of b; and of faces by cut. */
  QnId *of_block, *next_side, *of_cut, *next_face;
  QnThrust *thrust;
} Search;

/* ---- faces of one line: union by the ends that meet ---- */

/* Two faces with a common line, the one behind the other. */
static bool
follow_each_other (const Search *s, const QnContactFace *f, const QnContactFace *g)
{
  if (fabs (qn_vec2_cross (f->tangent, g->tangent)) > STRAIGHT)
    return false;
  QnVec2 way = qn_vec2_sub (qn_vec2_lerp (g->start, g->end, 0.5),
                            qn_vec2_lerp (f->start, f->end, 0.5));
  double along = fabs (qn_vec2_dot (way, f->tangent));
  return fabs (qn_vec2_cross (way, f->tangent)) < OFFSET_SHARE * s->size
         && fabs (along - 0.5 * (f->length + g->length)) < GAP_SHARE * s->size;
}

static void
join_faces (const Search *s, QnId *parent)
{
  size_t count = s->contacts->face_count;
  g_autofree QnBox *boxes = g_new (QnBox, count + 1);
  QnPool pool = { 0 };
  QnBoxTree tree;
  QnBoxPairs near = { 0 };
  for (size_t f = 0; f < count; f++)
    boxes[f] = qn_box_of_segment (s->contacts->faces[f].start, s->contacts->faces[f].end);
  qn_box_tree_init (&tree, boxes, count, &pool);
  if (qn_box_tree_pairs (&tree, 2 * GAP_SHARE * s->size, SIZE_MAX, &near))
    for (size_t i = 0; i < near.count; i++)
      if (follow_each_other (s, &s->contacts->faces[near.items[i][0]],
                             &s->contacts->faces[near.items[i][1]]))
        qn_sets_join (parent, near.items[i][0], near.items[i][1]);
  qn_box_pairs_clear (&near);
  qn_pool_clear (&pool);
}

/* ---- forces of cuts ---- */

/* Sums up the forces of the faces of all cuts; `first` are the moments of the normal forces about
 * the origin along the cut, `total` their sizes. */
static void
add_up (const Search *s, double *normal, double *first, double *total)
{
  for (size_t f = 0; f < s->contacts->face_count; f++) {
    const QnContactFace *face = &s->contacts->faces[f];
    QnCut *cut = &s->thrust->cuts[s->cut_of[f]];
    QnVec2 along = qn_vec2_perp (cut->normal);
    double sign = qn_vec2_dot (face->normal, cut->normal) > 0 ? 1 : -1;
    for (QnId k = face->first_pair; k < face->first_pair + face->pair_count; k++) {
      double n = s->pairs[k].normal_force, t = s->pairs[k].shear_force;
      QnVec2 force = qn_vec2_add (qn_vec2_scale (sign * n, face->normal),
                                  qn_vec2_scale (sign * t, face->tangent));
      cut->force = qn_vec2_add (cut->force, force);
      normal[s->cut_of[f]] += n;
      first[s->cut_of[f]] += n * qn_vec2_dot (s->contacts->pairs[k].point, along);
      total[s->cut_of[f]] += fabs (n);
    }
    QnVec2 ends[2] = { face->start, face->end };
    for (int i = 0; i < 2; i++) {
      double here = qn_vec2_dot (ends[i], along);
      if (here < qn_vec2_dot (cut->start, along))
        cut->start = ends[i];
      if (here > qn_vec2_dot (cut->end, along))
        cut->end = ends[i];
    }
  }
}

static void
place_force (QnCut *cut, double normal, double first, double total)
{
  QnVec2 along = qn_vec2_perp (cut->normal);
  double start = qn_vec2_dot (cut->start, along);
  cut->length = qn_vec2_dot (cut->end, along) - start;
  double half = 0.5 * cut->length;
  cut->moment = (start + half) * normal - first;
  if (normal < 0 && cut->length > 0) {
    cut->eccentricity = first / normal - start - half;
    cut->place = qn_pressure_place (cut->eccentricity, cut->length, normal, total);
  } else if (normal < 0)
    cut->place = QN_PLACE_EDGE;
  if (cut->place == QN_PLACE_NOWHERE)
    cut->eccentricity = 0;
  double s = fmin (fmax (half + cut->eccentricity, 0), cut->length);
  cut->at = qn_vec2_add_scaled (cut->start, s, along);
}

/* The face of every cut that its force passes through, or the nearest one. */
static void
find_faces (const Search *s)
{
  size_t count = s->thrust->count;
  g_autofree double *nearest = g_new (double, MAX (count, 1));
  for (size_t i = 0; i < count; i++)
    nearest[i] = INFINITY;
  for (size_t f = 0; f < s->contacts->face_count; f++) {
    const QnContactFace *face = &s->contacts->faces[f];
    QnCut *cut = &s->thrust->cuts[s->cut_of[f]];
    QnVec2 way = qn_vec2_sub (cut->at, qn_vec2_lerp (face->start, face->end, 0.5));
    double away = fabs (qn_vec2_dot (way, face->tangent)) - 0.5 * face->length;
    if (away < nearest[s->cut_of[f]]) {
      nearest[s->cut_of[f]] = away;
      cut->face = (QnId) f;
    }
  }
}

/* ---- neighbours ---- */

/* Puts an item before those of its list. */
static void
prepend (QnId *lists, QnId *next, QnId list, size_t item)
{
  next[item] = lists[list];
  lists[list] = (QnId) item;
}

static QnId *
new_lists (size_t count)
{
  QnId *lists = g_new (QnId, count + 1);
  for (size_t i = 0; i < count; i++)
    lists[i] = QN_NONE;
  return lists;
}

static bool
is_loaded (const Search *s, QnId cut)
{
  return qn_vec2_length (s->thrust->cuts[cut].force)
         >= QN_THRUST_LEAST_SHARE * s->thrust->largest;
}

/* Whether the force acts within the cut: bending alone, or tension, leaves no line of thrust. */
static bool
is_pressed (const QnCut *cut)
{
  return cut->place != QN_PLACE_NOWHERE && cut->place != QN_PLACE_OUTSIDE;
}

/* The block of a face on one side of its cut. */
static QnId
block_on_side (const Search *s, QnId face, int side)
{
  const QnContactFace *f = &s->contacts->faces[face];
  bool aligned = qn_vec2_dot (f->normal, s->thrust->cuts[s->cut_of[face]].normal) > 0;
  return aligned == (side == 0) ? f->a : f->b;
}

/* The only other loaded cut at the blocks on a side of this one, or QN_NONE. `layer` has the cut and side that
 * a block was last seen at. */
static QnId
find_next (const Search *s, QnId cut, int side, QnId *layer)
{
  QnId found = QN_NONE, mark = 2 * cut + side;
  for (QnId f = s->of_cut[cut]; f != QN_NONE; f = s->next_face[f]) {
    QnId block = block_on_side (s, f, side);
    if (qn_support_is_any (s->model->blocks[block].support))
      return QN_NONE;
    layer[block] = mark;
  }
  for (QnId f = s->of_cut[cut]; f != QN_NONE; f = s->next_face[f]) {
    QnId block = block_on_side (s, f, side);
    for (QnId k = s->of_block[block]; k != QN_NONE; k = s->next_side[k]) {
      const QnContactFace *face = &s->contacts->faces[k / 2];
      QnId other = s->cut_of[k / 2];
      if (other == cut || other == found || !is_loaded (s, other)
          || (layer[face->a] == mark && layer[face->b] == mark))
        continue;
      if (found != QN_NONE)
        return QN_NONE;
      found = other;
    }
  }
  return found;
}

static void
link_cuts (Search *s)
{
  size_t cuts = s->thrust->count, faces = s->contacts->face_count;
  g_autofree QnId *of_block = s->of_block = new_lists (s->model->block_count);
  g_autofree QnId *next_side = s->next_side = g_new (QnId, 2 * faces + 1);
  g_autofree QnId *of_cut = s->of_cut = new_lists (cuts);
  g_autofree QnId *next_face = s->next_face = g_new (QnId, faces + 1);
  g_autofree QnId *layer = new_lists (s->model->block_count);
  for (size_t f = faces; f-- > 0;) {
    prepend (of_block, next_side, s->contacts->faces[f].b, 2 * f + 1);
    prepend (of_block, next_side, s->contacts->faces[f].a, 2 * f);
    prepend (of_cut, next_face, s->cut_of[f], f);
  }
  for (size_t c = 0; c < cuts; c++)
    for (int side = 0; side < 2 && is_loaded (s, (QnId) c); side++)
      s->thrust->cuts[c].next[side] = find_next (s, (QnId) c, side, layer);
  /* The way leads from pressure to pressure, and both ways, or none. */
  for (size_t c = 0; c < cuts; c++)
    for (int side = 0; side < 2; side++) {
      QnId *next = &s->thrust->cuts[c].next[side];
      if (*next == QN_NONE)
        continue;
      const QnCut *other = &s->thrust->cuts[*next];
      if ((other->next[0] != (QnId) c && other->next[1] != (QnId) c)
          || !is_pressed (&s->thrust->cuts[c]) || !is_pressed (other))
        *next = QN_NONE;
    }
}

/* ---- all of it ---- */

static void
number_cuts (Search *s, QnId *parent)
{
  size_t faces = s->contacts->face_count;
  g_autofree QnId *number = g_new (QnId, faces + 1);
  for (size_t f = 0; f < faces; f++)
    number[f] = QN_NONE;
  for (size_t f = 0; f < faces; f++) {
    const QnContactFace *face = &s->contacts->faces[f];
    QnId root = qn_sets_root (parent, (QnId) f);
    if (number[root] == QN_NONE) {
      number[root] = (QnId) s->thrust->count++;
      s->thrust->cuts[number[root]] = (QnCut){ .start = face->start,
                                               .end = face->end,
                                               .normal = face->normal,
                                               .face = (QnId) f,
                                               .next = { QN_NONE, QN_NONE } };
    }
    s->cut_of[f] = number[root];
  }
}

void
qn_thrust_find (QnThrust *thrust, const QnModel *model, const QnContacts *contacts,
                const QnPairResult *pairs, const QnTouch *touches, size_t touch_count)
{
  size_t faces = contacts->face_count + touch_count;
  size_t pair_count = contacts->pair_count + touch_count;
  QnContacts all = *contacts;
  g_autofree QnContactFace *joints = all.faces = g_new (QnContactFace, faces + 1);
  g_autofree QnContactPair *places = all.pairs = g_new (QnContactPair, pair_count + 1);
  g_autofree QnPairResult *forces = g_new (QnPairResult, pair_count + 1);
  for (size_t f = 0; f < contacts->face_count; f++)
    joints[f] = contacts->faces[f];
  for (size_t p = 0; p < contacts->pair_count; p++) {
    places[p] = contacts->pairs[p];
    forces[p] = pairs[p];
  }
  /* Contacts found on the way as faces of one pair, behind those as drawn. */
  for (size_t i = 0; i < touch_count; i++) {
    const QnTouch *touch = &touches[i];
    all.faces[all.face_count++] =
      (QnContactFace){ .a = touch->block[0],
                       .b = touch->block[1],
                       .start = touch->at[0],
                       .end = touch->at[0],
                       .normal = touch->normal,
                       .tangent = qn_vec2_perp (touch->normal),
                       .first_pair = (QnId) all.pair_count,
                       .pair_count = 1 };
    forces[all.pair_count] =
      (QnPairResult){ .normal_force = touch->force, .shear_force = touch->shear };
    all.pairs[all.pair_count++] = (QnContactPair){ .point = touch->at[0] };
  }

  *thrust =
    (QnThrust){ .cuts = g_new0 (QnCut, faces + 1), .cut_of = g_new (QnId, faces + 1) };
  Search s = { .model = model,
               .contacts = &all,
               .pairs = forces,
               .size = model->characteristic_length,
               .cut_of = thrust->cut_of,
               .thrust = thrust };
  g_autofree QnId *parent = g_new (QnId, faces + 1);
  qn_sets_init (parent, faces);
  if (s.size > 0)
    join_faces (&s, parent);
  /* Two corners of one block on a side of another. */
  for (size_t i = 0; i < touch_count; i++)
    for (size_t k = i + 1; k < touch_count; k++)
      if (touches[i].block[0] == touches[k].block[0]
          && touches[i].block[1] == touches[k].block[1]
          && qn_vec2_dot (touches[i].normal, touches[k].normal) > 1 - STRAIGHT)
        qn_sets_join (parent, (QnId) (contacts->face_count + i),
                      (QnId) (contacts->face_count + k));
  number_cuts (&s, parent);

  g_autofree double *sums = g_new0 (double, 3 * thrust->count + 1);
  add_up (&s, sums, sums + thrust->count, sums + 2 * thrust->count);
  for (size_t c = 0; c < thrust->count; c++) {
    place_force (&thrust->cuts[c], sums[c], sums[thrust->count + c],
                 sums[2 * thrust->count + c]);
    thrust->largest = fmax (thrust->largest, qn_vec2_length (thrust->cuts[c].force));
  }
  find_faces (&s);
  if (thrust->largest > 0)
    link_cuts (&s);
}

void
qn_thrust_clear (QnThrust *thrust)
{
  g_free (thrust->cuts);
  g_free (thrust->cut_of);
  *thrust = (QnThrust){ 0 };
}
