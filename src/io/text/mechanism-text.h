/* A mechanism, ties and plastic hinges in words, translated, and the facts of a mechanism in the result file. */
#pragma once

#include "core/model/model.h"
#include "core/result/mechanism.h"
#include "core/result/result.h"
#include "io/text/file-writer.h"

#include <glib.h>

/* A few words, translated: "Overturning to the right", "Stepped crack, moving to the left", … Free
 * with g_free(). */
char *qn_mechanism_dup_title (const QnMechanism *mechanism);

/* One sentence: name, numbers of hinges, sliding and opening joints. The caller frees. */
char *qn_mechanism_dup_sentence (const QnMechanism *mechanism);

/* Whole sentences: name of the mechanism, motion of the largest bodies with their centres, number of
 * joints that hinge, slide and open. Free with g_free(). */
char *qn_mechanism_dup_text (const QnModel *model, const QnMechanism *mechanism);

/* What one of the first two says of a result; NULL where it has no mechanism, or no memory is left. */
char *qn_collapse_dup_words (const QnModel *model, const QnContacts *contacts,
                             const QnResult *result,
                             char *(*dup_words) (const QnMechanism *mechanism));

/* Whole sentences of a result, with the plastic hinges of its beams; without the joints if only the hinges move
 * the structure. NULL where it has no mechanism, or no memory is left. */
char *qn_collapse_dup_text (const QnModel *model, const QnContacts *contacts,
                            const QnResult *result);

/* The facts as a JSON object: kind, bodies, joints that move. See data/result-format.md. */
void qn_mechanism_write (QnFileWriter *writer, const QnContacts *contacts,
                         const QnMechanism *mechanism);

/* ---- ties and plastic hinges ---- */

/* "slack", "elastic", "yields", "anchor gives". */
const char *qn_tie_state_text (QnTieState state);

/* The step with the largest force of a tie, the first of equal ones; -1: forces not known. */
gssize qn_tie_worst_step (const QnResult *result, gsize tie);

/* Force of a tie over its strength; 0 if the strength is unlimited. */
double qn_tie_utilisation (const QnTie *tie, double force);

/* "Ties at most: “T” 3 kN, 100 % of its strength (anchor gives), “S” 1.2 kN, 40 %.", those that use most
 * first; NULL where there are none or their forces are not known. Free with g_free(). */
char *qn_ties_dup_text (const QnModel *model, const QnResult *result);

/* "2 plastic hinges: “beam” at “left corner”, “right” at “right corner”.", as they are at the last
 * step; NULL where no beam yields or its section forces are not known. Free with g_free(). */
char *qn_hinges_dup_text (const QnModel *model, const QnResult *result);
