/* Joints of mortar that a drawing leaves open: found in a model, and closed in one step. */
#pragma once

#include "doc/edit/edit.h"
#include "stereotomy/gaps.h"

/* The gaps between blocks of a prepared model, wider than what contacts bridge and up to `width`, m
 * (0: the usual width). `gaps` is overwritten; rings are blocks. FALSE without memory. */
gboolean qn_model_find_gaps (const QnModel *model, double width, QnGaps *gaps);

/* The usual width of a model's blocks, m: qn_gaps_usual_width(); 0 without memory. */
double qn_model_usual_gap (const QnModel *model);

/* "285 joints of mortar, 9 to 12 mm wide"; NULL where there are none. The caller frees it. */
char *qn_gaps_dup_text (const QnGaps *gaps);

/* Lets blocks grow to the middle of all gaps up to `width` (m, > 0) between them, freed from walls and
 * masonry where they were part of such. `closing` (nullable) is overwritten. Refused where there
 * are none. */
gboolean qn_edit_close_gaps (QnModel *model, double width, QnGapClosing *closing,
                             GError **error);
