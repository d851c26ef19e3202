/* Hash index from names to entity indices, so that a name among 100,000 is found at once.
 *
 * The index keeps no strings. It serves arrays of structs whose first member is their
 * `char *name`; array and struct size are passed along with every call, since the array may
 * have moved in between. A zeroed index is empty.
 */
#pragma once

#include "core/base/base.h"

typedef struct QnNameIndex {
  QnId *slots;       /* owned; open addressing, QN_NONE = free */
  size_t slot_count; /* a power of two, at least twice `count` */
  size_t count;
} QnNameIndex;

/* Adds items[id], the next in the array, under its name (NULL counts as ""). An equal name added
 * earlier stays the one that is found. False when memory runs out, with the index unchanged. */
bool qn_name_index_add (QnNameIndex *index, const void *items, size_t item_size, QnId id);

/* The item added first under this name, or QN_NONE. */
QnId qn_name_index_find (const QnNameIndex *index, const void *items, size_t item_size,
                         const char *name);

void qn_name_index_clear (QnNameIndex *index);
