/* The core's problems in the user's language, with the names of what they are about. */
#pragma once

#include "core/contact/finding.h"
#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

/* "Block “w.3.1”: polygon crosses itself". `model` may be half built. The caller frees it. */
char *qn_explain_diag (const QnModel *model, const QnDiag *diag);

/* "w.3.1 – w.4.1: gap just wider than the contact tolerance (0.02 mm)". The caller frees. */
char *qn_explain_finding (const QnModel *model, const QnFinding *finding);

/* One or two sentences on how an analysis ended: what the multiplier means, which blocks
 * move where there is no equilibrium. The caller frees it. */
char *qn_explain_outcome (const QnModel *model, const QnResult *result);

/* What kind of mechanism it is and what takes part, in whole sentences, or in a few words;
 * NULL where there is none. The caller frees it. */
char *qn_explain_mechanism (const QnModel *model, const QnContacts *contacts,
                            const QnResult *result);
char *qn_explain_mechanism_briefly (const QnModel *model, const QnContacts *contacts,
                                    const QnResult *result);

/* "load control", "associative limit analysis". */
const char *qn_explain_procedure (const QnAnalysisSettings *analysis);

/* Short label of how an analysis ended and of a pair's state, translated; static strings. */
const char *qn_explain_outcome_label (const QnResult *result);
const char *qn_explain_pair_state (QnPairState state);
/* How many pairs are in each state: "1 pair sticks, 2 pairs are open". The caller frees it. */
char *qn_explain_pairs (const int32_t counts[QN_PAIR_STATE_COUNT]);

/* Names from the model; numbers count from one where there is none. The caller frees it. */
char *qn_path_dup_text (const QnModel *model, const char *path);

/* The message of an error about an override of that place without file, place and override, which the
 * window says otherwise. The caller frees it. */
char *qn_path_dup_reason (const char *message, const char *path);

typedef enum {
  QN_COUNTED_BLOCKS,
  QN_COUNTED_BEAMS,
  QN_COUNTED_FACES,
  QN_COUNTED_PAIRS,
  QN_COUNTED_FINDINGS,
  QN_COUNTED_STEPS,
  QN_COUNTED_ITERATIONS,
  QN_COUNTED_FACTORISATIONS,
} QnCounted;

typedef struct QnCount {
  QnCounted what;
  gsize number;
} QnCount;

/* The counts in their order with `separator` between them. Free with g_free(). */
char *qn_counts_dup_text (const QnCount *counts, gsize n_counts, const char *separator);
