/* Numbers that are probably mistakes: wrong unit, factor 1000, degrees instead of a tangent.
 *
 * A number outside its range can be computed, but is unusual for masonry. The table in plausible.c names
 * the source of each range (docs/method/contact-pairs.md).
 */
#pragma once

#include "core/contact/contacts.h"

typedef struct QnUsualRange {
  QnEntity entity;
  const char *key;  /* in project files, below the entity; NULL: the entity as a whole */
  const char *unit; /* "": none */
  double least, greatest; /* of the absolute value; 0 is never reported */
  QnProblem doubt;        /* the probable mistake */
  size_t offset;          /* of the member in the entity; 0: another number */
} QnUsualRange;

/* Appends findings for numbers of a prepared model outside of their range, one for equal numbers; for live
 * loads without dead loads on joints that need compression; and for the block that sinks furthest into
 * its joints if it sinks by more than 1/1000 of its height under its own weight, or 1/100 under the dead
 * load on it; 1/20 in linear geometry and in time, where soft joints lower no multiplier. */
void qn_contacts_report_doubts (const QnModel *model, QnContacts *contacts);

/* Slivers side by side. `rows`: for each of the block_count blocks the first of its row, QN_NONE where it is
 * no sliver; `neighbours`: which block each touches most, of those that are no lintel above or below it if it
 * has one. Both in the room of `contacts`. False where there are none, or without memory. */
bool qn_contacts_find_slivers (const QnModel *model, QnContacts *contacts, QnId **rows,
                               QnId **neighbours);

const QnUsualRange *qn_usual_ranges (size_t *count);
