/* A mechanism in words, translated, and its facts in the result file. */
#pragma once

#include "core/result/mechanism.h"
#include "core/result/result.h"
#include "io/text/file-writer.h"

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
