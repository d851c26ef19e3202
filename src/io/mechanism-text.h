/* A mechanism in words, translated, and its facts in the result file. */
#ifndef QN_IO_MECHANISM_TEXT_H
#define QN_IO_MECHANISM_TEXT_H

#include "core/mechanism.h"
#include "io/file-writer.h"

/* A few words: "Overturning to the right", "Stepped crack, moving to the left", … */
char *qn_mechanism_dup_title (const QnMechanism *mechanism);

/* Whole sentences: what the mechanism is called, what the largest bodies do and about which
 * points, how many joints hinge, slide and open. Free with g_free(). */
char *qn_mechanism_dup_text (const QnModel *model, const QnMechanism *mechanism);

/* What a joint does: "hinge at the start corner, sliding", …; a static, translated string for
 * its kind. */
const char *qn_joint_kind_text (QnJointKind kind);

/* The facts as a JSON object: kind, bodies, joints that move. See data/result-format.md. */
void qn_mechanism_write (QnFileWriter *writer, const QnContacts *contacts,
                         const QnMechanism *mechanism);

#endif
