#include "core/memory.h"

#include <stdlib.h>
#include <string.h>

void *
qn_alloc (size_t count, size_t size)
{
  return calloc (count > 0 ? count : 1, size > 0 ? size : 1);
}

char *
qn_strdup (const char *text)
{
  if (text == NULL)
    return NULL;

  size_t bytes = strlen (text) + 1;
  char *copy = malloc (bytes);
  if (copy != NULL)
    memcpy (copy, text, bytes);
  return copy;
}

void *
qn_array_grow (void *array, size_t *capacity, size_t need, size_t size)
{
  if (array != NULL && need <= *capacity)
    return array;

  size_t grown = *capacity < 8 ? 8 : *capacity;
  while (grown < need) {
    if (grown > SIZE_MAX / 2)
      return NULL;
    grown *= 2;
  }
  if (grown > SIZE_MAX / size)
    return NULL;

  char *moved = realloc (array, grown * size);
  if (moved == NULL)
    return NULL;
  memset (moved + *capacity * size, 0, (grown - *capacity) * size);
  *capacity = grown;
  return moved;
}
