/* Names and lists of a model, whatever is in them. */
#include "doc/edit/edit.h"

#include <stdlib.h>
#include <string.h>

char *
qn_edit_dup_new_name (const QnModel *model, QnFindFunc find, const char *word,
                      const char *between, gsize number)
{
  for (;; number++) {
    g_autofree char *name = g_strdup_printf ("%s%s%zu", word, between, number);
    if (find (model, name) == QN_NONE)
      return g_steal_pointer (&name);
  }
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
