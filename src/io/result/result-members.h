/* Private to result files: how lists are read, and the tables of members by which objects are read and
 * written (io/project/project-members.h).
 *
 * Readers return FALSE with the error of the value's reader set. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "io/project/project-members.h"
#include "io/result/result-file.h"
#include "io/text/file-writer.h"

#define QN_MAYBE(key, use, type, member)                                                 \
  QN_MEMBER (key, MAYBE, use, type, member, 0, NULL)
#define QN_WHOLE(key, use, least, type, member)                                          \
  QN_MEMBER (key, WHOLE, use, type, member, least, NULL)
#define QN_PAIR(key, use, type, member) QN_MEMBER (key, IDS, use, type, member, 2, NULL)
#define QN_STAGE(key, type, member)                                                      \
  QN_MEMBER (key, STAGE, OPTIONAL, type, member, 0, NULL)

typedef struct QnContactMembers {
  QnResultContact contact;
  QnPairResult pair;
  QnVec2 point;  /* m, where the force acts; see result-contact.h */
  QnVec2 normal; /* unit, from the first block to the second */
  double area;   /* tributary area, m2 */
  double stress; /* Pa, along a bar */
} QnContactMembers;

/* Places of a fault, one for each kind of entity; all but one are QN_NONE. */
#define QN_FAULT_PLACES 6
extern const QnEntity qn_fault_entities[QN_FAULT_PLACES];

typedef struct QnRefusedMembers {
  QnFault fault;
  char *claim;
  QnId places[QN_FAULT_PLACES];
} QnRefusedMembers;

/* Of QnResult: the answer. Of QnSolution, QnVibration, QnStatistics, QnTieResult, QnPathEvent, QnStep and the
 * structs above. A step's come in three parts: what is before the displacements, behind them, and in time. */
extern const QnMember qn_answer_members[], qn_solution_members[], qn_vibration_members[],
  qn_statistics_members[], qn_tie_members[], qn_event_members[], qn_refused_members[],
  qn_contact_members[], qn_step_members[], qn_step_rest[], qn_step_time[];

/* Writes a text, which ends with a space, the members of a struct, and another text. */
void qn_result_members_write (QnFileWriter *writer, const char *before,
                              const QnMember *members, gconstpointer source,
                              gconstpointer usual, const char *after);

/* The members of an object; others are passed over: later versions of the program add some. */
static inline gboolean
qn_result_object (const QnJsonValue *place, const QnMember *members, gpointer target)
{
  return qn_json_value_object (place) && qn_members_take (place, members, NULL, target);
}

/* `count` numbers, `stride` doubles apart. `refusal` says that there are more or less of them; NULL:
 * the message counts them itself. */
gboolean qn_result_read_numbers (const QnJsonValue *list, double *numbers, size_t stride,
                                 size_t count, const char *refusal);

/* `count` rows of QN_DOF_COUNT numbers, one behind the other. */
gboolean qn_result_read_rows (const QnJsonValue *list, double *rows, size_t count,
                              const char *refusal);

/* Numbers of blocks, of an array, into a list to be freed with free(). */
gboolean qn_result_read_ids (const QnJsonValue *list, size_t block_count, QnId **ids,
                             size_t *count);

/* Room for `count` items, each of which has a byte of the text at least; NULL with an error where the text
 * is too short for them, which `refusal` says, or memory runs out. */
void *qn_result_room (const QnJsonValue *place, size_t count, size_t size,
                      const char *refusal);

/* ---- result-history.c: the history of an analysis in time, and contacts that follow the blocks ---- */

/* Adds the member to a document that is being written. */
void qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                              const QnResult *result);

/* Adds contacts found and joints released, members `found` and `left` of an object. */
void qn_result_found_write (QnFileWriter *writer, const QnResult *result);

/* Reads these members of the document into a result with steps and blocks; `found` and `left` are outside the
 * history where the analysis is not one in time. */
gboolean qn_result_history_read (const QnJsonValue *root, QnResult *result);

/* Adds forces, states and damage to a step that is being written, where the result has them. */
void qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step);

/* Reads them of a step, an element of the list, into a result with steps and pairs: all steps have forces and
 * states or none, and some have damage. */
gboolean qn_result_forces_read (const QnJsonValue *step, QnResult *result);
