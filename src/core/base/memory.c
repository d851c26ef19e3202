#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

/* From this size on memory is requested in large pages; their alignment. */
#define LARGE_MEMORY ((size_t) 4 << 20)
#define LARGE_PAGE   ((uintptr_t) 2 << 20)

/* Bytes that processors move together. */
#define LINE 64

/* Tells the system that large pages suit a block, where it has them and leaves the choice to
 * programs: a page for every 4 kB is met by a fault each, which may take longer than what is done
 * with its contents. Nothing depends on it. */
static void *
with_large_pages (void *block, size_t count, size_t size)
{
#ifdef MADV_HUGEPAGE
  if (block != NULL && size > 0 && count >= LARGE_MEMORY / size) {
    uintptr_t start = (uintptr_t) block, end = start + count * size;
    start = (start + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    end = end / LARGE_PAGE * LARGE_PAGE;
    if (end > start)
      madvise ((void *) start, end - start, MADV_HUGEPAGE);
  }
#else
  (void) count;
  (void) size;
#endif
  return block;
}

void *
qn_alloc (size_t count, size_t size)
{
  return with_large_pages (calloc (count > 0 ? count : 1, size > 0 ? size : 1), count,
                           size);
}

void *
qn_alloc_lines (size_t count, size_t size)
{
  if (size > 0 && count > (SIZE_MAX - LINE) / size)
    return NULL;
  return with_large_pages (aligned_alloc (LINE, (count * size + LINE) / LINE * LINE),
                           count, size);
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

bool
qn_array_reserve (void *array, size_t *capacity, size_t need, size_t size)
{
  void *items;

  memcpy (&items, array, sizeof items);
  if (items != NULL && need <= *capacity)
    return true;
  size_t grown = *capacity < 8 ? 8 : *capacity;
  while (grown < need) {
    if (grown > SIZE_MAX / 2)
      return false;
    grown *= 2;
  }
  if (grown > SIZE_MAX / size)
    return false;
  char *moved = with_large_pages (realloc (items, grown * size), grown, size);
  if (moved == NULL)
    return false;
  memset (moved + *capacity * size, 0, (grown - *capacity) * size);
  *capacity = grown;
  memcpy (array, &moved, sizeof moved);
  return true;
}

void *
qn_pool_add (QnPool *pool, void *block)
{
  bool kept =
    block != NULL && QN_ARRAY_PUSH (pool->blocks, pool->count, pool->capacity, block);

  if (!kept)
    free (block);
  pool->failed = pool->failed || !kept;
  return kept ? block : NULL;
}

void *
qn_pool_alloc (QnPool *pool, size_t count, size_t size)
{
  return qn_pool_add (pool, qn_alloc (count, size));
}

void *
qn_pool_lines (QnPool *pool, size_t count, size_t size)
{
  return qn_pool_add (pool, qn_alloc_lines (count, size));
}

void
qn_pool_clear (QnPool *pool)
{
  for (size_t i = 0; i < pool->count; i++)
    free (pool->blocks[i]);
  free (pool->blocks);
  *pool = (QnPool){ 0 };
}
