/* Names and lists of a model, whatever is in them. */
#include "doc/edit/edit.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

char *
qn_edit_dup_new_name (const QnModel *model, gsize items, const char *word,
                      const char *between, gsize number)
{
  for (;; number++) {
    g_autofree char *name = g_strdup_printf ("%s%s%zu", word, between, number);
    if (qn_model_find_item (model, items, name) == QN_NONE)
      return g_steal_pointer (&name);
  }
}

char *
qn_edit_dup_free_name (const QnModel *model, gsize items, const char *word)
{
  return qn_model_find_item (model, items, word) == QN_NONE
           ? g_strdup (word)
           : qn_edit_dup_new_name (model, items, word, " ", 2);
}

gboolean
qn_edit_take_name (char **place, const char *name, GError **error)
{
  char *copy = strdup (name);
  if (copy == NULL)
    return qn_edit_no_memory (error);
  free (*place);
  *place = copy;
  return TRUE;
}

gboolean
qn_edit_take_text (char **place, const char *text, GError **error)
{
  if (*text != '\0')
    return qn_edit_take_name (place, text, error);
  g_clear_pointer (place, free);
  return TRUE;
}

void
qn_edit_drop (gpointer items, size_t *count, gsize size, gsize index)
{
  char *dropped = (char *) items + index * size;
  memmove (dropped, dropped + size, (--*count - index) * size);
}

/* ---- parts, loads, bars, ties ---- */

#define LIST(array, number)                                                              \
  offsetof (QnModel, array), offsetof (QnModel, number), sizeof *((QnModel *) NULL)->array

static const struct {
  gsize items, count, size;
  const char *missing;
} lists[] = {
  [QN_PICK_BLOCK] = { LIST (blocks, block_count), NULL },
  [QN_PICK_BEAM] = { LIST (beams, beam_count), NULL },
  [QN_PICK_DEAD_LOAD] = { LIST (dead_loads, dead_load_count),
                          N_ ("There is no such load") },
  [QN_PICK_LIVE_LOAD] = { LIST (live_loads, live_load_count),
                          N_ ("There is no such load") },
  [QN_PICK_BAR] = { LIST (bars, bar_count), N_ ("There is no such bar") },
  [QN_PICK_TIE] = { LIST (ties, tie_count), N_ ("There is no such tie") },
};

gsize
qn_model_count_items (const QnModel *model, QnPickKind kind)
{
  return G_STRUCT_MEMBER (size_t, model, lists[kind].count);
}

gboolean
qn_edit_has_item (const QnModel *model, QnPickKind kind, QnId item, GError **error)
{
  return (item >= 0 && (gsize) item < qn_model_count_items (model, kind))
         || qn_edit_refuse (error, "%s", _ (lists[kind].missing));
}

gboolean
qn_edit_remove_item (QnModel *model, QnPickKind kind, QnId item, GError **error)
{
  if (!qn_edit_has_item (model, kind, item, error))
    return FALSE;
  if (kind == QN_PICK_TIE)
    free (model->ties[item].name);
  qn_edit_drop (G_STRUCT_MEMBER (gpointer, model, lists[kind].items),
                &G_STRUCT_MEMBER (size_t, model, lists[kind].count), lists[kind].size,
                (gsize) item);
  return TRUE;
}
