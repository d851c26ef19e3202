#include "core/model/model-list.h"

#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

void *
qn_model_list_add (void *items, size_t *count, size_t *capacity, size_t size)
{
  void *list;

  memcpy (&list, items, sizeof list);
  char *grown =
    *count < INT32_MAX ? qn_array_grow (list, capacity, *count + 1, size) : NULL;
  if (grown == NULL)
    return NULL;
  memcpy (items, &grown, sizeof grown);
  return memset (grown + (*count)++ * size, 0, size);
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
