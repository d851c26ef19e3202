#include "core/model/model-list.h"

#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

void *
qn_model_list_add (void *items, size_t *count, size_t *capacity, size_t size)
{
  char *list;

  if (*count >= INT32_MAX || !qn_array_reserve (items, capacity, *count + 1, size))
    return NULL;
  memcpy (&list, items, sizeof list);
  return memset (list + (*count)++ * size, 0, size);
}

void *
qn_model_list_add_named (void *items, size_t *count, size_t *capacity, size_t size,
                         QnNameIndex *index, const char *name)
{
  char *copy = qn_strdup (name);
  char *item = copy != NULL || name == NULL
                 ? qn_model_list_add (items, count, capacity, size)
                 : NULL;

  if (item != NULL) {
    memcpy (item, &copy, sizeof copy);
    size_t place = *count - 1;
    if (index == NULL
        || qn_name_index_add (index, item - place * size, size, (QnId) place))
      return item;
    (*count)--;
  }
  free (copy);
  return NULL;
}
