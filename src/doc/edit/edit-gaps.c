#include "doc/edit/edit-gaps.h"

#include "doc/edit/edit-shape.h"
#include "io/text/text-format.h"
#include <glib/gi18n-lib.h>
#include <string.h>

/* Gaps below so many tolerances of contacts are none. */
#define LEAST_GAP 2.0

static double
least_gap (const QnModel *model)
{
  return LEAST_GAP * model->contact.tolerance * model->characteristic_length;
}

static gboolean
to_rings (const QnModel *model, QnRings *rings)
{
  *rings = (QnRings){ 0 };
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (!qn_rings_add (rings, qn_model_block_vertices (model, i),
                       (gsize) model->blocks[i].vertex_count)) {
      qn_rings_clear (rings);
      return FALSE;
    }
  return TRUE;
}

gboolean
qn_model_find_gaps (const QnModel *model, double width, QnGaps *gaps)
{
  QnRings rings;
  *gaps = (QnGaps){ 0 };
  if (!to_rings (model, &rings))
    return FALSE;
  QnStatus status =
    qn_gaps_find (&rings, least_gap (model),
                  width > 0.0 ? width : qn_gaps_usual_width (&rings), gaps, NULL);
  qn_rings_clear (&rings);
  return status == QN_OK;
}

double
qn_model_usual_gap (const QnModel *model)
{
  QnRings rings;
  if (!to_rings (model, &rings))
    return 0.0;
  double width = qn_gaps_usual_width (&rings);
  qn_rings_clear (&rings);
  return width;
}

char *
qn_gaps_dup_text (const QnGaps *gaps)
{
  double least, mean, most;
  if (gaps->count == 0)
    return NULL;
  qn_gaps_widths (gaps, &least, &mean, &most);
  g_autofree char *widths = qn_widths_dup_text (least, mean, most);
  return g_strdup_printf (ngettext ("%zu joint of mortar, %s wide",
                                    "%zu joints of mortar, %s wide",
                                    (gulong) gaps->count),
                          gaps->count, widths);
}

static gboolean
same_ring (const QnModel *model, QnId block, const QnRing *ring)
{
  return (gsize) model->blocks[block].vertex_count == ring->count
         && memcmp (qn_model_block_vertices (model, block), ring->points,
                    ring->count * sizeof *ring->points)
              == 0;
}

/* Gives blocks, all of them free, new shapes. Those with other numbers of corners go last: they
 * change the numbers of blocks. */
static gboolean
set_shapes (QnModel *model, const QnId *ids, guint count, const QnRing *shapes,
            GError **error)
{
  g_autoptr (GPtrArray) names = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GArray) others = g_array_new (FALSE, FALSE, sizeof (guint));
  for (guint i = 0; i < count; i++) {
    QnBlock *block = &model->blocks[ids[i]];
    if ((gsize) block->vertex_count == shapes[i].count) {
      memcpy (model->vertices + block->first_vertex, shapes[i].points,
              shapes[i].count * sizeof *shapes[i].points);
    } else {
      g_ptr_array_add (names, g_strdup (block->name));
      g_array_append_val (others, i);
    }
  }
  for (guint i = 0; i < others->len; i++) {
    QnId id = qn_model_find_block (model, names->pdata[i]);
    QnRing ring = shapes[g_array_index (others, guint, i)];
    QnRings one = { &ring, 1, 1 };
    if (!qn_edit_replace_blocks (model, &id, 1, &one, error))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_edit_close_gaps (QnModel *model, double width, QnGapClosing *closing, GError **error)
{
  QnRings rings;
  QnGapClosing own;
  if (closing == NULL)
    closing = &own;
  if (!to_rings (model, &rings))
    return qn_edit_no_memory (error);
  if (qn_gaps_close (&rings, least_gap (model), width, closing, NULL) != QN_OK) {
    qn_rings_clear (&rings);
    return qn_edit_no_memory (error);
  }
  g_autoptr (GArray) changed = g_array_new (FALSE, FALSE, sizeof (QnId));
  g_autoptr (GArray) shapes = g_array_new (FALSE, FALSE, sizeof (QnRing));
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (!same_ring (model, i, &rings.items[i])) {
      g_array_append_val (changed, i);
      g_array_append_val (shapes, rings.items[i]);
    }
  QnId *ids = (QnId *) changed->data;
  gboolean done = changed->len > 0;
  if (!done)
    g_set_error (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                 _ ("There are no gaps up to %.3g mm between blocks"), 1e3 * width);
  done = done && qn_edit_take_apart (model, ids, changed->len, error)
         && set_shapes (model, ids, changed->len, (const QnRing *) shapes->data, error);
  qn_rings_clear (&rings);
  return done;
}
