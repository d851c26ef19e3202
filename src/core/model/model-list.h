/* The lists of a model: arrays that grow by one zeroed item at a time. */
#pragma once

#include "core/model/model.h"

/* The new last item of a list, zeroed; NULL with nothing changed where memory runs out. `items` is
 * the address of the pointer to the list. */
void *qn_model_list_add (void *items, size_t *count, size_t *capacity, size_t size);

/* The same for items whose first member is a name (owned; NULL stays NULL), which is entered in
 * `index` unless that is NULL. */
void *qn_model_list_add_named (void *items, size_t *count, size_t *capacity, size_t size,
                               QnNameIndex *index, const char *name);

/* QN_MODEL_ADD (model, bars, bar) adds to model->bars, counted by model->bar_count. */
#define QN_MODEL_ADD(model, items, one)                                                  \
  qn_model_list_add (&(model)->items, &(model)->one##_count, &(model)->one##_capacity,   \
                     sizeof *(model)->items)
#define QN_MODEL_ADD_NAMED(model, items, one, index, name)                               \
  qn_model_list_add_named (&(model)->items, &(model)->one##_count,                       \
                           &(model)->one##_capacity, sizeof *(model)->items, index,      \
                           name)
