/* Numbers that are probably slips: of the unit, by a factor of a thousand, degrees for a tangent.
 *
 * The ranges are wide: what lies outside can be computed, but is hardly a structure of masonry. They
 * stand in one table, each with its source (plausible.c; docs/method/contact-pairs.md).
 */
#pragma once

#include "core/contact/contacts.h"

typedef struct QnUsualRange {
  QnEntity entity; /* whose number it is */
  const char
    *key; /* in project files, below the entity; NULL: of the entity as a whole */
  const char *unit;       /* "" of a bare number */
  double least, greatest; /* of its size; 0 is never doubted */
  QnProblem doubt;        /* what is probably meant */
} QnUsualRange;

/* Appends a finding for every number of a prepared model that is outside of its range, once for equal
 * numbers; for live loads without dead loads on joints that carry nothing without; and for the block
 * that sinks furthest into its joints where that is more than a thousandth of its height under its own
 * weight, or a hundredth under the dead load on it, in linear geometry and in time, where softness
 * lowers no multiplier, a twentieth. */
QnStatus qn_contacts_report_doubts (const QnModel *model, QnContacts *contacts,
                                    QnDiag *diag);

/* The table. */
const QnUsualRange *qn_usual_ranges (size_t *count);
