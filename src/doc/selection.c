#include "doc/selection.h"

#include <string.h>

struct _QnSelection {
  GObject parent_instance;
  GArray *blocks; /* of QnId, ascending */
  QnId face;
};

G_DEFINE_FINAL_TYPE (QnSelection, qn_selection, G_TYPE_OBJECT)

enum { SIGNAL_CHANGED, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

static void
qn_selection_finalize (GObject *object)
{
  g_array_unref (QN_SELECTION (object)->blocks);
  G_OBJECT_CLASS (qn_selection_parent_class)->finalize (object);
}

static void
qn_selection_class_init (QnSelectionClass *klass)
{
  G_OBJECT_CLASS (klass)->finalize = qn_selection_finalize;
  signals[SIGNAL_CHANGED] = g_signal_new ("changed", QN_TYPE_SELECTION, G_SIGNAL_RUN_LAST,
                                          0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void
qn_selection_init (QnSelection *self)
{
  self->blocks = g_array_new (FALSE, FALSE, sizeof (QnId));
  self->face = QN_NONE;
}

QnSelection *
qn_selection_new (void)
{
  return g_object_new (QN_TYPE_SELECTION, NULL);
}

static void
emit_changed (QnSelection *self)
{
  g_signal_emit (self, signals[SIGNAL_CHANGED], 0);
}

static int
compare_ids (gconstpointer a, gconstpointer b)
{
  QnId x = *(const QnId *) a, y = *(const QnId *) b;
  return (x > y) - (x < y);
}

gboolean
qn_selection_has_block (QnSelection *self, QnId block)
{
  return g_array_binary_search (self->blocks, &block, compare_ids, NULL);
}

const QnId *
qn_selection_get_blocks (QnSelection *self, guint *count)
{
  *count = self->blocks->len;
  return (const QnId *) self->blocks->data;
}

void
qn_selection_clear (QnSelection *self)
{
  qn_selection_set_blocks (self, NULL, 0);
}

static void
replace_blocks (QnSelection *self, GArray *blocks)
{
  g_array_sort (blocks, compare_ids);
  guint kept = 0;
  for (guint i = 0; i < blocks->len; i++) {
    QnId id = g_array_index (blocks, QnId, i);
    if (kept == 0 || g_array_index (blocks, QnId, kept - 1) != id)
      g_array_index (blocks, QnId, kept++) = id;
  }
  g_array_set_size (blocks, kept);

  gboolean same =
    self->face == QN_NONE && blocks->len == self->blocks->len
    && (kept == 0
        || memcmp (blocks->data, self->blocks->data, kept * sizeof (QnId)) == 0);
  g_array_unref (self->blocks);
  self->blocks = blocks;
  self->face = QN_NONE;
  if (!same)
    emit_changed (self);
}

void
qn_selection_set_blocks (QnSelection *self, const QnId *blocks, guint count)
{
  GArray *copy = g_array_new (FALSE, FALSE, sizeof (QnId));
  if (count > 0)
    g_array_append_vals (copy, blocks, count);
  replace_blocks (self, copy);
}

void
qn_selection_add_blocks (QnSelection *self, const QnId *blocks, guint count)
{
  GArray *copy = g_array_copy (self->blocks);
  if (count > 0)
    g_array_append_vals (copy, blocks, count);
  replace_blocks (self, copy);
}

void
qn_selection_toggle_block (QnSelection *self, QnId block)
{
  GArray *copy = g_array_copy (self->blocks);
  guint at = 0;
  if (g_array_binary_search (copy, &block, compare_ids, &at))
    g_array_remove_index (copy, at);
  else
    g_array_append_val (copy, block);
  replace_blocks (self, copy);
}

void
qn_selection_set_face (QnSelection *self, QnId face)
{
  if (self->face == face && self->blocks->len == 0)
    return;
  g_array_set_size (self->blocks, 0);
  self->face = face;
  emit_changed (self);
}

QnId
qn_selection_get_face (QnSelection *self)
{
  return self->face;
}

typedef gboolean (*BlockTest) (const QnModel *model, QnId candidate, QnId block);

static void
select_matching (QnSelection *self, const QnModel *model, QnId block, BlockTest test)
{
  GArray *blocks = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    if (test == NULL || test (model, i, block))
      g_array_append_val (blocks, i);
  }
  replace_blocks (self, blocks);
}

void
qn_selection_select_all (QnSelection *self, const QnModel *model)
{
  select_matching (self, model, QN_NONE, NULL);
}

/* Wall blocks are named <wall>.<course>.<position>: those of a course share what precedes the
 * last dot. */
static gboolean
same_course (const QnModel *model, QnId candidate, QnId block)
{
  const QnBlock *a = &model->blocks[candidate], *b = &model->blocks[block];
  if (candidate == block)
    return TRUE;
  if (a->wall != b->wall || b->wall == QN_NONE)
    return FALSE;
  const char *dot_a = strrchr (a->name, '.'), *dot_b = strrchr (b->name, '.');
  if (dot_a == NULL || dot_b == NULL)
    return FALSE;
  gsize length = (gsize) (dot_b - b->name);
  return (gsize) (dot_a - a->name) == length && memcmp (a->name, b->name, length) == 0;
}

static gboolean
same_wall (const QnModel *model, QnId candidate, QnId block)
{
  QnId wall = model->blocks[block].wall;
  return candidate == block || (wall != QN_NONE && model->blocks[candidate].wall == wall);
}

static gboolean
same_law (const QnModel *model, QnId candidate, QnId block)
{
  return model->blocks[candidate].law == model->blocks[block].law;
}

void
qn_selection_select_course (QnSelection *self, const QnModel *model, QnId block)
{
  select_matching (self, model, block, same_course);
}

void
qn_selection_select_wall (QnSelection *self, const QnModel *model, QnId block)
{
  select_matching (self, model, block, same_wall);
}

void
qn_selection_select_same_law (QnSelection *self, const QnModel *model, QnId block)
{
  select_matching (self, model, block, same_law);
}

void
qn_selection_follow (QnSelection *self, const QnModel *before, const QnModel *after)
{
  GArray *blocks = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (guint i = 0; i < self->blocks->len; i++) {
    QnId old = g_array_index (self->blocks, QnId, i);
    if ((gsize) old >= before->block_count)
      continue;
    QnId id = qn_model_find_block (after, before->blocks[old].name);
    if (id != QN_NONE)
      g_array_append_val (blocks, id);
  }
  replace_blocks (self, blocks);
}
