#include "core/base/name-index.h"

#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

/* FNV-1a, 64 bit (Fowler, Noll, Vo). */
static uint64_t
hash_name (const char *name)
{
  uint64_t hash = UINT64_C (14695981039346656037);
  for (const char *c = name; *c != '\0'; c++) {
    hash ^= (unsigned char) *c;
    hash *= UINT64_C (1099511628211);
  }
  return hash ^ (hash >> 32);
}

static const char *
name_of (const void *items, size_t item_size, QnId id)
{
  const char *name;
  memcpy (&name, (const char *) items + (size_t) id * item_size, sizeof name);
  return name != NULL ? name : "";
}

static void
insert (QnId *slots, size_t slot_count, const char *name, QnId id)
{
  size_t slot = (size_t) hash_name (name) & (slot_count - 1);
  while (slots[slot] != QN_NONE)
    slot = (slot + 1) & (slot_count - 1);
  slots[slot] = id;
}

/* Ids are dense and enter the larger table in the order in which they were added, so that the
 * first of equal names stays first in its chain of slots. */
static bool
grow (QnNameIndex *index, const void *items, size_t item_size)
{
  size_t slot_count = index->slot_count == 0 ? 16 : 2 * index->slot_count;
  QnId *slots = qn_alloc (slot_count, sizeof *slots);
  if (slots == NULL)
    return false;

  for (size_t i = 0; i < slot_count; i++)
    slots[i] = QN_NONE;
  for (size_t i = 0; i < index->count; i++)
    insert (slots, slot_count, name_of (items, item_size, (QnId) i), (QnId) i);

  free (index->slots);
  index->slots = slots;
  index->slot_count = slot_count;
  return true;
}

bool
qn_name_index_add (QnNameIndex *index, const void *items, size_t item_size, QnId id)
{
  QN_ASSERT (id >= 0 && (size_t) id == index->count);
  if (2 * (index->count + 1) > index->slot_count && !grow (index, items, item_size))
    return false;

  insert (index->slots, index->slot_count, name_of (items, item_size, id), id);
  index->count++;
  return true;
}

QnId
qn_name_index_find (const QnNameIndex *index, const void *items, size_t item_size,
                    const char *name)
{
  if (index->count == 0 || name == NULL)
    return QN_NONE;

  size_t slot = (size_t) hash_name (name) & (index->slot_count - 1);
  while (index->slots[slot] != QN_NONE) {
    if (strcmp (name_of (items, item_size, index->slots[slot]), name) == 0)
      return index->slots[slot];
    slot = (slot + 1) & (index->slot_count - 1);
  }
  return QN_NONE;
}

void
qn_name_index_clear (QnNameIndex *index)
{
  free (index->slots);
  *index = (QnNameIndex){ 0 };
}
