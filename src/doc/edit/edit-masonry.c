#include "doc/edit/edit-masonry.h"

#include "core/base/memory.h"
#include "doc/edit/edit-frame.h"
#include "io/project/project-masonry.h"
#include "io/project/project.h"
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

/* ---- the list of objects ---- */

/* Leaves out objects that have no blocks any more: they were taken apart. */
static void
drop_detached (const QnProject *draft, QnMasonries *list)
{
  gsize kept = 0;
  for (gsize i = 0; i < list->count; i++) {
    QnMasonry item = list->items[i];
    list->items[i] = (QnMasonry){ 0 };
    if (qn_project_has_masonry (draft, (QnId) i))
      list->items[kept++] = item;
    else
      qn_masonry_clear (&item);
  }
  list->count = kept;
}

static gboolean
open_list (const QnProject *draft, QnMasonries *list, GError **error)
{
  if (!qn_project_get_masonry (draft, list, error))
    return FALSE;
  drop_detached (draft, list);
  return TRUE;
}

/* Lays the objects of the list (cleared) and writes them into the draft. */
static gboolean
close_list (QnProject *draft, QnMasonries *list, GError **error)
{
  GString *json = g_string_new ("[");
  for (gsize i = 0; i < list->count; i++) {
    g_string_append (json, i > 0 ? ", " : "");
    qn_masonry_append_json (json, &list->items[i], &draft->model);
  }
  g_string_append_c (json, ']');
  gboolean done = qn_project_set_extra (draft, QN_MASONRY_MEMBER, json->str, error)
                  && qn_edit_rebuild (&draft->model, list, error);
  g_string_free (json, TRUE);
  qn_masonries_clear (list);
  return done;
}

static gboolean
refuse_object (GError **error)
{
  return qn_edit_refuse (error, _ ("This masonry object does not exist any more"));
}

gboolean
qn_edit_change_masonry (QnProject *draft, QnId object, QnMasonryEditFunc func,
                        gpointer user_data, GError **error)
{
  QnMasonries list;
  if (!open_list (draft, &list, error))
    return FALSE;
  gboolean there = object >= 0 && (gsize) object < list.count;
  if (there && func (&list.items[object], user_data, error))
    return close_list (draft, &list, error);
  qn_masonries_clear (&list);
  return there ? FALSE : refuse_object (error);
}

/* ---- adding ---- */

static gboolean
is_name_taken (const QnModel *model, const QnMasonries *list, const char *name)
{
  for (gsize i = 0; i < list->count; i++) {
    if (g_strcmp0 (list->items[i].name, name) == 0)
      return TRUE;
  }
  for (gsize i = 0; i < model->wall_count; i++) {
    if (g_strcmp0 (model->walls[i].name, name) == 0)
      return TRUE;
  }
  /* Blocks of an object that was detached keep its name in theirs. */
  g_autofree char *prefix = g_strdup_printf ("%s.", name);
  for (gsize i = 0; i < model->block_count; i++) {
    if (g_str_has_prefix (model->blocks[i].name, prefix))
      return TRUE;
  }
  return FALSE;
}

static char *
dup_free_object_name (const QnModel *model, const QnMasonries *list, QnMasonryKind kind)
{
  const char *word = kind == QN_MASONRY_WALL ? "w" : qn_masonry_kind_names[kind];
  for (gsize number = 1;; number++) {
    g_autofree char *name = g_strdup_printf ("%s%" G_GSIZE_FORMAT, word, number);
    if (!is_name_taken (model, list, name))
      return g_steal_pointer (&name);
  }
}

static void
take (const QnModel *model, QnMasonries *list, QnMasonry *masonry)
{
  if (masonry->name == NULL)
    masonry->name = dup_free_object_name (model, list, masonry->kind);
  qn_masonries_take (list, masonry);
}

gboolean
qn_edit_add_masonry (QnProject *draft, QnMasonry *masonry, GError **error)
{
  QnMasonries list;
  if (!open_list (draft, &list, error)) {
    qn_masonry_clear (masonry);
    return FALSE;
  }
  take (&draft->model, &list, masonry);
  return close_list (draft, &list, error);
}

/* ---- openings ---- */

static gboolean
remove_opening (QnMasonry *masonry, gpointer data, GError **error)
{
  gsize index = *(const gsize *) data;
  QnMasonryWall *wall = &masonry->wall;
  if (masonry->kind != QN_MASONRY_WALL || index >= wall->opening_count)
    return refuse_object (error);
  free (wall->openings[index].name);
  for (gsize i = index + 1; i < wall->opening_count; i++)
    wall->openings[i - 1] = wall->openings[i];
  wall->opening_count--;
  return TRUE;
}

gboolean
qn_edit_remove_opening (QnProject *draft, QnId object, gsize opening, GError **error)
{
  return qn_edit_change_masonry (draft, object, remove_opening, &opening, error);
}

/* ---- moving and copying whole objects ---- */

gboolean *
qn_edit_whole_objects (const QnModel *model, QnBlockSet set, gsize *count)
{
  QnId last = -1;
  for (gsize i = 0; i < model->block_count; i++)
    last = MAX (last, model->blocks[i].masonry);
  *count = (gsize) (last + 1);
  gboolean *whole = g_new0 (gboolean, *count + 1);
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      whole[model->blocks[i].masonry] = TRUE;
  g_autofree gboolean *flags = qn_block_set_to_flags (set, model);
  for (gsize i = 0; i < model->block_count; i++) {
    QnId object = model->blocks[i].masonry;
    if (object != QN_NONE && !flags[i])
      whole[object] = FALSE;
  }
  return whole;
}

/* Rounding of sines and cosines. */
#define RIGID_TOLERANCE 1e-12

static gboolean
is_rigid_motion (QnTransform t)
{
  return fabs (t.xx - t.yy) < RIGID_TOLERANCE && fabs (t.xy + t.yx) < RIGID_TOLERANCE
         && fabs (t.xx * t.xx + t.yx * t.yx - 1.0) < RIGID_TOLERANCE;
}

static void
move_object (QnMasonry *masonry, QnTransform transform)
{
  masonry->origin = qn_transform_apply (transform, masonry->origin);
  masonry->rotation =
    remainder (masonry->rotation + atan2 (transform.yx, transform.xx), 2.0 * G_PI);
}

/* Blocks of the set that do not belong to a whole object; free the ids. */
static QnBlockSet
dup_rest (const QnModel *model, QnBlockSet set, const gboolean *whole)
{
  QnId *ids = g_new (QnId, set.count + 1);
  guint count = 0;
  for (guint i = 0; i < set.count; i++) {
    QnId object = model->blocks[set.ids[i]].masonry;
    if (object == QN_NONE || !whole[object])
      ids[count++] = set.ids[i];
  }
  return (QnBlockSet){ ids, count };
}

/* Which objects a transform of the set carries along as a whole, one flag per object; NULL where
 * there are none. */
static gboolean *
dup_carried (const QnModel *model, QnBlockSet set, QnTransform transform, gsize *count)
{
  g_autofree gboolean *whole = qn_edit_whole_objects (model, set, count);
  gboolean any = FALSE;
  for (gsize i = 0; i < *count; i++)
    any = any || whole[i];
  return any && is_rigid_motion (transform) ? g_steal_pointer (&whole) : NULL;
}

gboolean
qn_edit_transform (QnProject *draft, QnBlockSet set, QnTransform transform,
                   GError **error)
{
  QnModel *model = &draft->model;
  gsize count = 0;
  g_autofree gboolean *whole = dup_carried (model, set, transform, &count);
  if (whole == NULL)
    return qn_edit_transform_blocks (model, set, transform, error);

  QnBlockSet rest = dup_rest (model, set, whole);
  /* What is fixed to the blocks of objects that move. */
  g_autofree gboolean *moved = g_new0 (gboolean, model->block_count + 1);
  for (gsize i = 0; i < model->block_count; i++)
    moved[i] = model->blocks[i].masonry != QN_NONE && whole[model->blocks[i].masonry];
  qn_edit_transform_attached (model, moved, transform);
  gboolean done =
    rest.count == 0 || qn_edit_transform_blocks (model, rest, transform, error);
  g_free ((gpointer) rest.ids);
  QnMasonries list;
  if (!done || !qn_project_get_masonry (draft, &list, error))
    return FALSE;
  for (gsize i = 0; i < MIN (count, list.count); i++) {
    if (whole[i])
      move_object (&list.items[i], transform);
  }
  drop_detached (draft, &list);
  return close_list (draft, &list, error);
}

/* Appends a copy of every whole object to the list. */
static gboolean
copy_objects (const QnProject *draft, const gboolean *whole, QnTransform step,
              QnMasonries *list, GError **error)
{
  QnMasonries originals;
  if (!open_list (draft, &originals, error))
    return FALSE;
  for (gsize i = 0; i < originals.count; i++) {
    if (!whole[i])
      continue;
    QnMasonry *copy = &originals.items[i];
    g_clear_pointer (&copy->name, free);
    move_object (copy, step);
    take (&draft->model, list, copy);
  }
  qn_masonries_clear (&originals);
  return TRUE;
}

gboolean
qn_edit_copy (QnProject *draft, QnBlockSet set, QnTransform transform, int copies,
              GError **error)
{
  QnModel *model = &draft->model;
  gsize count = 0;
  g_autofree gboolean *whole = dup_carried (model, set, transform, &count);
  if (whole == NULL)
    return qn_edit_copy_blocks (model, set, transform, copies, error);

  QnBlockSet rest = dup_rest (model, set, whole);
  gboolean done =
    rest.count == 0 || qn_edit_copy_blocks (model, rest, transform, copies, error);
  g_free ((gpointer) rest.ids);
  QnMasonries list;
  if (!done || !open_list (draft, &list, error))
    return FALSE;
  QnTransform step = qn_transform_translation (0.0, 0.0);
  for (int k = 0; k < copies && done; k++) {
    step = qn_transform_compose (step, transform);
    done = copy_objects (draft, whole, step, &list, error);
  }
  if (done)
    return close_list (draft, &list, error);
  qn_masonries_clear (&list);
  return FALSE;
}
