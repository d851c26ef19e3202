#include "doc/document/selection.h"

#include "core/base/integer.h"
#include "doc/edit/edit-masonry.h"
#include "render/scene/reading.h"

#include <math.h>
#include <string.h>

/* Faces whose directions differ by less belong together. */
#define SAME_DIRECTION 1e-6

enum { LIST_COUNT = QN_PICK_TIE + 1 };

G_DEFINE_FINAL_TYPE (QnSelection, qn_selection, G_TYPE_OBJECT)

static void
qn_selection_finalize (GObject *object)
{
  for (int i = 0; i < LIST_COUNT; i++)
    g_array_unref (QN_SELECTION (object)->ids[i]);
  G_OBJECT_CLASS (qn_selection_parent_class)->finalize (object);
}

static void
qn_selection_class_init (QnSelectionClass *klass)
{
  G_OBJECT_CLASS (klass)->finalize = qn_selection_finalize;
  g_signal_new ("changed", QN_TYPE_SELECTION, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                G_TYPE_NONE, 0);
}

static GArray *
new_ids (void)
{
  return g_array_new (FALSE, FALSE, sizeof (QnId));
}

static void
qn_selection_init (QnSelection *self)
{
  for (int i = 0; i < LIST_COUNT; i++)
    self->ids[i] = new_ids ();
  self->object = QN_NONE;
}

gboolean
qn_selection_has (QnSelection *self, QnPickKind kind, QnId id)
{
  return g_array_binary_search (self->ids[kind], &id, qn_compare_ids, NULL);
}

const QnId *
qn_selection_get (QnSelection *self, QnPickKind kind, guint *count)
{
  *count = self->ids[kind]->len;
  return (const QnId *) self->ids[kind]->data;
}

gboolean
qn_selection_is_empty (QnSelection *self)
{
  guint count = 0;
  for (int i = 0; i < LIST_COUNT; i++)
    count += self->ids[i]->len;
  return count == 0 && self->object == QN_NONE;
}

void
qn_selection_clear (QnSelection *self)
{
  qn_selection_set (self, QN_PICK_BLOCK, NULL, 0);
}

/* Takes over the lists. */
static void
replace_all (QnSelection *self, GArray *const lists[LIST_COUNT], QnId object, int opening)
{
  gboolean same = object == self->object && opening == self->opening;
  for (int i = 0; i < LIST_COUNT; i++) {
    /* Ascending, each once. */
    GArray *ids = lists[i];
    g_array_sort (ids, qn_compare_ids);
    guint kept = 0;
    for (guint k = 0; k < ids->len; k++) {
      QnId id = g_array_index (ids, QnId, k);
      if (kept == 0 || g_array_index (ids, QnId, kept - 1) != id)
        g_array_index (ids, QnId, kept++) = id;
    }
    g_array_set_size (ids, kept);
    GArray *old = self->ids[i];
    same = same && kept == old->len
           && (kept == 0 || memcmp (ids->data, old->data, kept * sizeof (QnId)) == 0);
    g_array_unref (old);
    self->ids[i] = ids;
  }
  self->object = object;
  self->opening = opening;
  if (!same)
    g_signal_emit_by_name (self, "changed");
}

static void
begin_lists (GArray *lists[LIST_COUNT])
{
  for (int i = 0; i < LIST_COUNT; i++)
    lists[i] = new_ids ();
}

static GArray *
ids_with (GArray *ids, const QnId *more, guint count)
{
  if (count > 0)
    g_array_append_vals (ids, more, count);
  return ids;
}

/* In the list or out of it. */
static GArray *
ids_toggled (GArray *ids, QnId id)
{
  GArray *copy = g_array_copy (ids);
  guint at = 0;
  if (g_array_binary_search (copy, &id, qn_compare_ids, &at))
    g_array_remove_index (copy, at);
  else
    g_array_append_val (copy, id);
  return copy;
}

/* Takes over one of the lists. Blocks and beams may be selected together. */
static void
replace_one (QnSelection *self, int list, GArray *ids, gboolean keep)
{
  GArray *lists[LIST_COUNT];
  for (int i = 0; i < LIST_COUNT; i++)
    lists[i] = i == list ? ids
               : keep && list < QN_PICK_FACE && i < QN_PICK_FACE
                 ? g_array_copy (self->ids[i])
                 : new_ids ();
  replace_all (self, lists, QN_NONE, 0);
}

void
qn_selection_set (QnSelection *self, QnPickKind kind, const QnId *ids, guint count)
{
  replace_one (self, kind, ids_with (new_ids (), ids, count), FALSE);
}

void
qn_selection_add (QnSelection *self, QnPickKind kind, const QnId *ids, guint count)
{
  replace_one (self, kind, ids_with (g_array_copy (self->ids[kind]), ids, count), TRUE);
}

void
qn_selection_toggle (QnSelection *self, QnPickKind kind, QnId id)
{
  replace_one (self, kind, ids_toggled (self->ids[kind], id), TRUE);
}

void
qn_selection_set_one (QnSelection *self, QnPickKind kind, QnId id)
{
  qn_selection_set (self, kind, &id, id != QN_NONE);
}

QnId
qn_selection_get_one (QnSelection *self, QnPickKind kind)
{
  const GArray *ids = self->ids[kind];
  return ids->len > 0 ? g_array_index (ids, QnId, 0) : QN_NONE;
}

QnPick
qn_selection_get_item (QnSelection *self)
{
  QnPickKind kind = QN_PICK_DEAD_LOAD;
  while (kind < QN_PICK_TIE && self->ids[kind]->len == 0)
    kind++;
  return (QnPick){ kind, qn_selection_get_one (self, kind) };
}

void
qn_selection_set_opening (QnSelection *self, QnId object, int opening)
{
  GArray *none[LIST_COUNT];
  begin_lists (none);
  replace_all (self, none, object, object != QN_NONE ? opening : 0);
}

/* ---- what belongs together ---- */

void
qn_selection_select_all (QnSelection *self, const QnModel *model)
{
  GArray *lists[LIST_COUNT];
  begin_lists (lists);
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    g_array_append_val (lists[QN_PICK_BLOCK], i);
  for (QnId i = 0; i < (QnId) model->beam_count; i++)
    g_array_append_val (lists[QN_PICK_BEAM], i);
  replace_all (self, lists, QN_NONE, 0);
}

/* Wall blocks are named <wall>.<course>.<position>: those of a course share what precedes the
 * last dot. */
static gboolean
are_like_blocks (const QnBlock *a, const QnBlock *b, QnLikeness likeness)
{
  const char *dot_a = strrchr (a->name, '.'), *dot_b = strrchr (b->name, '.');
  if (likeness == QN_LIKE_LAW)
    return a->law == b->law;
  if (a->wall != b->wall || a->masonry != b->masonry
      || (a->wall == QN_NONE && a->masonry == QN_NONE))
    return FALSE;
  return likeness == QN_LIKE_WALL
         || (dot_a != NULL && dot_b != NULL && dot_a - a->name == dot_b - b->name
             && memcmp (a->name, b->name, (gsize) (dot_b - b->name)) == 0);
}

void
qn_selection_select_blocks_like (QnSelection *self, const QnModel *model, QnId block,
                                 QnLikeness likeness)
{
  GArray *blocks = new_ids ();
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (i == block
        || are_like_blocks (&model->blocks[i], &model->blocks[block], likeness))
      g_array_append_val (blocks, i);
  replace_one (self, QN_PICK_BLOCK, blocks, FALSE);
}

static gboolean
are_alike (const QnContactFace *a, const QnContactFace *b, QnLikeness likeness)
{
  if (likeness == QN_LIKE_LAW)
    return (a->law_a == b->law_a && a->law_b == b->law_b)
           || (a->law_a == b->law_b && a->law_b == b->law_a);
  return likeness == QN_LIKE_DIRECTION
           ? fabs (qn_vec2_cross (a->tangent, b->tangent)) <= SAME_DIRECTION
           : qn_faces_in_line (a, b);
}

void
qn_selection_select_faces_like (QnSelection *self, const QnContacts *contacts, QnId face,
                                QnLikeness likeness)
{
  GArray *faces = new_ids ();
  for (QnId i = 0; i < (QnId) contacts->face_count; i++) {
    if (i == face || are_alike (&contacts->faces[face], &contacts->faces[i], likeness))
      g_array_append_val (faces, i);
  }
  replace_one (self, QN_PICK_FACE, faces, FALSE);
}

/* ---- across edits ---- */

static QnVec2
middle (const QnContactFace *face)
{
  return qn_vec2_lerp (face->start, face->end, 0.5);
}

/* The face between blocks of the same names that is nearest to where it was. */
static QnId
follow_face (const QnModel *before, const QnContactFace *face, const QnModel *after,
             const QnContacts *contacts)
{
  QnId a = qn_model_find_block (after, before->blocks[face->a].name);
  QnId b = qn_model_find_block (after, before->blocks[face->b].name);
  QnId best = QN_NONE;
  double nearest = INFINITY;
  for (QnId i = 0; i < (QnId) contacts->face_count; i++) {
    const QnContactFace *other = &contacts->faces[i];
    if (!(other->a == a && other->b == b) && !(other->a == b && other->b == a))
      continue;
    double distance = qn_vec2_length (qn_vec2_sub (middle (other), middle (face)));
    if (distance < nearest) {
      nearest = distance;
      best = i;
    }
  }
  return best;
}

/* By name; a block that was renamed, and nothing else, keeps its number. */
static QnId
follow_block (const QnModel *before, QnId old, const QnModel *after)
{
  QnId id = qn_model_find_block (after, before->blocks[old].name);
  if (id != QN_NONE || after->block_count != before->block_count)
    return id;
  const QnBlock *then = &before->blocks[old], *now = &after->blocks[old];
  gboolean renamed = qn_model_find_block (before, now->name) == QN_NONE
                     && then->vertex_count == now->vertex_count
                     && then->centroid.x == now->centroid.x
                     && then->centroid.y == now->centroid.y;
  return renamed ? old : QN_NONE;
}

/* Whether an object is the same as before: its blocks are called after it. */
static gboolean
is_same_object (const QnBlock *a, const QnBlock *b)
{
  gsize length = strcspn (a->name, ".");
  return a->masonry == b->masonry && length == strcspn (b->name, ".")
         && strncmp (a->name, b->name, length) == 0;
}

/* Which objects of parametric masonry are selected as a whole, one flag for each of `count`. Bricks that
 * change are other blocks of the same object. */
static gboolean *
find_whole (QnSelection *self, const QnModel *before, const QnModel *after, gsize *count)
{
  gboolean *whole =
    qn_edit_whole_objects (before, qn_selection_get_parts (self).blocks, count);
  g_autofree const QnBlock **lasts = g_new0 (const QnBlock *, *count + 1);
  for (gsize i = 0; i < before->block_count; i++)
    if (before->blocks[i].masonry != QN_NONE)
      lasts[before->blocks[i].masonry] = &before->blocks[i];
  for (gsize i = 0; i < after->block_count; i++) {
    const QnBlock *block = &after->blocks[i];
    if (block->masonry != QN_NONE && (gsize) block->masonry < *count
        && whole[block->masonry] && !is_same_object (lasts[block->masonry], block))
      whole[block->masonry] = FALSE;
  }
  return whole;
}

static const char *
name_of_block (const QnModel *model, QnId block)
{
  return block != QN_NONE ? model->blocks[block].name : NULL;
}

static gboolean
same_load (const QnModel *a, const QnLoad *one, const QnModel *b, const QnLoad *other)
{
  return one->kind == other->kind && one->set == other->set
         && one->load_case == other->load_case && one->vector.x == other->vector.x
         && one->vector.y == other->vector.y && one->moment == other->moment
         && one->node == other->node && one->beam == other->beam
         && one->value == other->value && one->dof == other->dof
         && one->edge == other->edge && one->edge_count == other->edge_count
         && one->side == other->side && one->pressure == other->pressure
         && one->level == other->level
         && memcmp (one->intensity, other->intensity, sizeof one->intensity) == 0
         && memcmp (one->part, other->part, sizeof one->part) == 0
         && memcmp (one->span, other->span, sizeof one->span) == 0
         && g_strcmp0 (name_of_block (a, one->block), name_of_block (b, other->block))
              == 0;
}

static gboolean
same_item (QnPickKind kind, const QnModel *a, QnId one, const QnModel *b, QnId other)
{
  if (kind == QN_PICK_TIE)
    return strcmp (a->ties[one].name, b->ties[other].name) == 0;
  if (kind != QN_PICK_BAR) {
    gboolean live = kind == QN_PICK_LIVE_LOAD;
    return same_load (a, &qn_model_loads (a, live, NULL)[one], b,
                      &qn_model_loads (b, live, NULL)[other]);
  }
  const QnBar *x = &a->bars[one], *y = &b->bars[other];
  return x->area == y->area && x->start.x == y->start.x && x->start.y == y->start.y
         && x->end.x == y->end.x && x->end.y == y->end.y;
}

/* The same one at its place or elsewhere; where none is the same, the one at its place was changed,
 * unless there are fewer or more than before. */
static QnId
follow_item (QnPickKind kind, QnId old, const QnModel *before, const QnModel *after)
{
  const gsize now = qn_model_count_items (after, kind);
  if ((gsize) old < now && same_item (kind, before, old, after, old))
    return old;
  for (QnId i = 0; i < (QnId) now; i++)
    if (same_item (kind, before, old, after, i))
      return i;
  return now == qn_model_count_items (before, kind) ? old : QN_NONE;
}

void
qn_selection_follow (QnSelection *self, const QnModel *before,
                     const QnContacts *contacts_before, const QnModel *after,
                     const QnContacts *contacts_after)
{
  GArray *lists[LIST_COUNT];
  gsize objects;
  g_autofree gboolean *whole = find_whole (self, before, after, &objects);
  begin_lists (lists);
  for (QnId i = 0; i < (QnId) after->block_count; i++)
    if (after->blocks[i].masonry != QN_NONE && (gsize) after->blocks[i].masonry < objects
        && whole[after->blocks[i].masonry])
      g_array_append_val (lists[QN_PICK_BLOCK], i);
  for (QnPickKind kind = QN_PICK_BLOCK; kind <= QN_PICK_TIE; kind++) {
    const gsize count = kind == QN_PICK_FACE ? contacts_before->face_count
                                             : qn_model_count_items (before, kind);
    for (guint i = 0; i < self->ids[kind]->len; i++) {
      const QnId old = g_array_index (self->ids[kind], QnId, i);
      if ((gsize) old >= count
          || (kind == QN_PICK_BLOCK && before->blocks[old].masonry != QN_NONE
              && whole[before->blocks[old].masonry]))
        continue;
      const QnId id =
        kind == QN_PICK_BLOCK  ? follow_block (before, old, after)
        : kind == QN_PICK_BEAM ? qn_model_find_beam (after, before->beams[old].name)
        : kind == QN_PICK_FACE
          ? follow_face (before, &contacts_before->faces[old], after, contacts_after)
          : follow_item (kind, old, before, after);
      if (id != QN_NONE)
        g_array_append_val (lists[kind], id);
    }
  }
  replace_all (self, lists, self->object, self->opening);
}

QnPartSet
qn_selection_get_parts (QnSelection *selection)
{
  QnPartSet set;
  set.blocks.ids = qn_selection_get (selection, QN_PICK_BLOCK, &set.blocks.count);
  set.beams.ids = qn_selection_get (selection, QN_PICK_BEAM, &set.beams.count);
  return set;
}
