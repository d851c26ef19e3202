/* Repairs: what can be done about a finding of contact detection.
 *
 * Gaps are closed by letting both blocks grow, by snapping corners or by moving a block, overlaps
 * by trimming, merging or moving apart, blocks that nothing holds are fixed or removed. Of the two
 * blocks of a finding the one that is free, not supported and smaller gives way. Where blocks
 * stand apart by joints of mortar these are what is to be closed: nothing is fixed to the ground
 * instead. */
#pragma once

#include "core/contact/contacts.h"
#include "doc/edit/edit.h"
#include "stereotomy/gaps.h"

typedef enum {
  QN_REPAIR_CLOSE, /* blocks grow to the middle of the gap; of all gaps of joints of mortar */
  QN_REPAIR_SNAP,    /* corners of one block go to the other */
  QN_REPAIR_MOVE,    /* the block as a whole */
  QN_REPAIR_TRIM,    /* takes the common part from one */
  QN_REPAIR_MERGE,   /* makes one of the two */
  QN_REPAIR_SUPPORT, /* fixes the block */
  QN_REPAIR_DELETE,
  QN_REPAIR_FORGET, /* removes an exception that concerns no face */
  QN_REPAIR_COUNT
} QnRepair;

/* What can be done, the best first; returns how many. `gaps`: the model has joints of mortar
 * (qn_model_find_gaps()). */
guint qn_repair_get_choices (const QnModel *model, const QnFinding *finding,
                             gboolean gaps, QnRepair choices[QN_REPAIR_COUNT]);

/* "Snap", "Move" …, for a button; the name of the step in the history; what it does. To be translated. */
typedef struct QnRepairWords {
  const char *label, *step, *sentence;
} QnRepairWords;
extern const QnRepairWords qn_repair_words[QN_REPAIR_COUNT];

/* Description of the repair with the block's name. The caller frees it. */
char *qn_repair_explain (const QnModel *model, const QnFinding *finding, QnRepair repair);

/* Does it to the draft of an edit whose model the finding is about. */
gboolean qn_edit_repair (QnModel *model, const QnFinding *finding, QnRepair repair,
                         GError **error);

/* Does the best for every finding that can be repaired without removing or fixing a block;
 * `count` is how many were. Refused where there is none. */
gboolean qn_edit_repair_all (QnModel *model, guint *count, GError **error);

/* The gaps between blocks of a prepared model, wider than what contacts bridge and up to `width`, m
 * (0: the usual width). `gaps` is overwritten; rings are blocks. */
void qn_model_find_gaps (const QnModel *model, double width, QnGaps *gaps);

/* The usual width of a model's blocks, m: qn_gaps_usual_width(). */
double qn_model_usual_gap (const QnModel *model);

/* "285 joints of mortar, 9 to 12 mm wide"; NULL where there are none. The caller frees it. */
char *qn_gaps_dup_text (const QnGaps *gaps);

/* Lets blocks grow to the middle of all gaps up to `width` (m, > 0) between them, freed from walls and
 * masonry where they were part of such. Refused where there are none. */
gboolean qn_edit_close_gaps (QnModel *model, double width, GError **error);
