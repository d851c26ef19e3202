#include "render/scene/thrust.h"

#include "core/base/integer.h"
#include "core/base/union-find.h"
#include "core/model/support.h"

#include <glib.h>

/* Faces follow each other along a line when the gap between them is below this part of the size
 * of a block (mortar between two head joints), and their lines differ by less than that. */
#define GAP_SHARE    0.1
#define OFFSET_SHARE 1e-3

/* Farther from the origin faces share a cell. */
#define MOST_CELLS 1000000000

/* Sine of the angle between faces of one line. */
#define STRAIGHT 1e-3

typedef struct Search {
  const QnModel *model;
  const QnContacts *contacts;
  const QnPairResult *pairs;
  double size;  /* m, of a block */
  QnId *cut_of; /* by face; the thrust's */
  QnId *first;  /* block_count + 1: where its faces begin in `faces` */
  QnId *faces;  /* of every block */
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

/* Ends that meet are in the same cell of a grid, or in cells beside each other. */
static guint
cell_hash (gint64 x, gint64 y)
{
  gint64 key = x * 73856093 ^ y * 19349663;
  return g_int64_hash (&key);
}

static void
join_faces (const Search *s, QnId *parent)
{
  size_t count = s->contacts->face_count, buckets = 4 * count + 1;
  double cell = 2 * GAP_SHARE * s->size;
  g_autofree QnId *head = g_new (QnId, buckets);
  g_autofree QnId *next = g_new (QnId, 2 * count + 1);
  for (size_t i = 0; i < buckets; i++)
    head[i] = QN_NONE;
  for (size_t i = 0; i < 2 * count; i++) {
    const QnContactFace *face = &s->contacts->faces[i / 2];
    QnVec2 p = i % 2 == 0 ? face->start : face->end;
    gint64 x = qn_to_integer (floor (p.x / cell), -MOST_CELLS, MOST_CELLS);
    gint64 y = qn_to_integer (floor (p.y / cell), -MOST_CELLS, MOST_CELLS);
    for (gint64 dx = -1; dx <= 1; dx++)
      for (gint64 dy = -1; dy <= 1; dy++)
        for (QnId k = head[cell_hash (x + dx, y + dy) % buckets]; k != QN_NONE;
             k = next[k])
          if (follow_each_other (s, face, &s->contacts->faces[k / 2]))
            qn_sets_join (parent, k / 2, (QnId) i / 2);
    size_t bucket = cell_hash (x, y) % buckets;
    next[i] = head[bucket];
    head[bucket] = (QnId) i;
  }
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

static void
list_faces (Search *s)
{
  size_t blocks = s->model->block_count;
  s->first = g_new0 (QnId, blocks + 2);
  s->faces = g_new (QnId, 2 * s->contacts->face_count + 1);
  for (size_t f = 0; f < s->contacts->face_count; f++) {
    s->first[s->contacts->faces[f].a + 2]++;
    s->first[s->contacts->faces[f].b + 2]++;
  }
  for (size_t i = 2; i < blocks + 2; i++)
    s->first[i] += s->first[i - 1];
  for (size_t f = 0; f < s->contacts->face_count; f++) {
    s->faces[s->first[s->contacts->faces[f].a + 1]++] = (QnId) f;
    s->faces[s->first[s->contacts->faces[f].b + 1]++] = (QnId) f;
  }
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

/* The only other loaded cut at the blocks on a side of this one, whose faces are given; or
 * QN_NONE. `layer` has the cut and side that a block was last seen at. */
static QnId
find_next (const Search *s, const QnId *faces, gsize count, int side, QnId *layer,
           QnId mark)
{
  QnId cut = s->cut_of[faces[0]], found = QN_NONE;
  for (gsize i = 0; i < count; i++) {
    QnId block = block_on_side (s, faces[i], side);
    if (qn_support_is_any (s->model->blocks[block].support))
      return QN_NONE;
    layer[block] = mark;
  }
  for (gsize i = 0; i < count; i++) {
    QnId block = block_on_side (s, faces[i], side);
    for (QnId k = s->first[block]; k < s->first[block + 1]; k++) {
      const QnContactFace *face = &s->contacts->faces[s->faces[k]];
      QnId other = s->cut_of[s->faces[k]];
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
  g_autofree QnId *begin = g_new0 (QnId, cuts + 2);
  g_autofree QnId *of_cut = g_new (QnId, faces + 1);
  g_autofree QnId *layer = g_new (QnId, s->model->block_count + 1);
  for (size_t i = 0; i < s->model->block_count; i++)
    layer[i] = QN_NONE;
  for (size_t f = 0; f < faces; f++)
    begin[s->cut_of[f] + 2]++;
  for (size_t i = 2; i < cuts + 2; i++)
    begin[i] += begin[i - 1];
  for (size_t f = 0; f < faces; f++)
    of_cut[begin[s->cut_of[f] + 1]++] = (QnId) f;
  for (size_t c = 0; c < cuts; c++)
    for (int side = 0; side < 2 && is_loaded (s, (QnId) c); side++)
      s->thrust->cuts[c].next[side] =
        find_next (s, of_cut + begin[c], (gsize) (begin[c + 1] - begin[c]), side, layer,
                   (QnId) (2 * c) + side);
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

/* Contacts found on the way as faces of one pair, behind those as drawn. */
static void
append_touches (QnContacts *all, QnPairResult *forces, const QnTouch *touches,
                size_t touch_count)
{
  for (size_t i = 0; i < touch_count; i++) {
    const QnTouch *touch = &touches[i];
    all->faces[all->face_count++] =
      (QnContactFace){ .a = touch->block[0],
                       .b = touch->block[1],
                       .start = touch->at[0],
                       .end = touch->at[0],
                       .normal = touch->normal,
                       .tangent = qn_vec2_perp (touch->normal),
                       .first_pair = (QnId) all->pair_count,
                       .pair_count = 1 };
    forces[all->pair_count] =
      (QnPairResult){ .normal_force = touch->force, .shear_force = touch->shear };
    all->pairs[all->pair_count++] = (QnContactPair){ .point = touch->at[0] };
  }
}

/* Two corners of one block on a side of another. */
static void
join_touches (QnId *parent, size_t faces, const QnTouch *touches, size_t touch_count)
{
  for (size_t i = 0; i < touch_count; i++)
    for (size_t k = i + 1; k < touch_count; k++)
      if (touches[i].block[0] == touches[k].block[0]
          && touches[i].block[1] == touches[k].block[1]
          && qn_vec2_dot (touches[i].normal, touches[k].normal) > 1 - STRAIGHT)
        qn_sets_join (parent, (QnId) (faces + i), (QnId) (faces + k));
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
  append_touches (&all, forces, touches, touch_count);

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
  join_touches (parent, contacts->face_count, touches, touch_count);
  number_cuts (&s, parent);

  g_autofree double *sums = g_new0 (double, 3 * thrust->count + 1);
  add_up (&s, sums, sums + thrust->count, sums + 2 * thrust->count);
  for (size_t c = 0; c < thrust->count; c++) {
    place_force (&thrust->cuts[c], sums[c], sums[thrust->count + c],
                 sums[2 * thrust->count + c]);
    thrust->largest = fmax (thrust->largest, qn_vec2_length (thrust->cuts[c].force));
  }
  find_faces (&s);
  list_faces (&s);
  if (thrust->largest > 0)
    link_cuts (&s);
  g_free (s.first);
  g_free (s.faces);
}

void
qn_thrust_clear (QnThrust *thrust)
{
  g_free (thrust->cuts);
  g_free (thrust->cut_of);
  *thrust = (QnThrust){ 0 };
}
