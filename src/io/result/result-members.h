/* Private to result files: how values of tokens are read, and the tables of members by which objects
 * are read and written (io/project/project-members.h).
 *
 * Readers take the token of the value and return FALSE with the error of `json` set. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "io/json/json-tokens.h"
#include "io/project/project-members.h"
#include "io/result/result-file.h"
#include "io/text/file-writer.h"

#define QN_MAYBE(key, use, type, member)                                                 \
  QN_MEMBER (key, MAYBE, use, type, member, 0, NULL)
#define QN_WHOLE(key, use, least, type, member)                                          \
  QN_MEMBER (key, WHOLE, use, type, member, least, NULL)
#define QN_PAIR(key, use, type, member) QN_MEMBER (key, PAIR, use, type, member, 0, NULL)
#define QN_STAGE(key, type, member)                                                      \
  QN_MEMBER (key, STAGE, OPTIONAL, type, member, 0, NULL)
#define QN_PLACE(key, use, type, member)                                                 \
  QN_MEMBER (key, PLACE, use, type, member, 0, NULL)

/* A step, and where its lists are. */
typedef struct QnStepMembers {
  QnStep step;
  gsize displacements, node_displacements, velocities, reactions, beam_forces, ties,
    forces, states, damage;
} QnStepMembers;

typedef struct QnContactMembers {
  QnResultContact contact;
  QnPairResult pair;
  QnVec2 point;  /* m, where the force acts; see result-contact.h */
  QnVec2 normal; /* unit, from the first block to the second */
  double area;   /* tributary area, m2 */
  double stress; /* Pa, along a bar */
} QnContactMembers;

typedef struct QnEventMembers {
  QnPathEvent event;
  gsize blocks;
} QnEventMembers;

/* Places of a fault, one for each kind of entity; all but one are QN_NONE. */
#define QN_FAULT_PLACES 6
extern const QnEntity qn_fault_entities[QN_FAULT_PLACES];

typedef struct QnRefusedMembers {
  QnFault fault;
  char *claim;
  QnId places[QN_FAULT_PLACES];
} QnRefusedMembers;

/* Of QnResult: the answer. Of QnSolution, QnVibration, QnStatistics, QnTieResult and the structs above. A step's come in three parts: what is
 * before the displacements, behind them, and in time. */
extern const QnMember qn_answer_members[], qn_solution_members[], qn_vibration_members[],
  qn_statistics_members[], qn_tie_members[], qn_event_members[], qn_refused_members[],
  qn_contact_members[], qn_step_members[], qn_step_rest[], qn_step_time[],
  qn_step_lists[];

/* Reads an object by tables, up to a NULL, of together at most 64 members: those given twice and
 * required ones that are missing are errors, unknown ones are skipped. Missing optional members leave
 * their field unchanged. */
gboolean qn_result_members_read (QnJson *json, gsize at, const QnMember *const *tables,
                                 gpointer target);

/* Writes a text, which ends with a space, the members of a struct, and another text. */
void qn_result_members_write (QnFileWriter *writer, const char *before,
                              const QnMember *members, gconstpointer source,
                              gconstpointer usual, const char *after);

gboolean qn_result_read_array (QnJson *json, gsize at);

/* `count` numbers, `stride` doubles apart. `refusal` says that there are more or less of them; NULL:
 * the message counts them itself. */
gboolean qn_result_read_numbers (QnJson *json, gsize at, double *numbers, size_t stride,
                                 size_t count, const char *refusal);

/* `count` rows of QN_DOF_COUNT numbers, one behind the other. */
gboolean qn_result_read_rows (QnJson *json, gsize at, double *rows, size_t count,
                              const char *refusal);

/* A whole number that is not negative; numbers of blocks, into a list to be freed with free(). */
gboolean qn_result_read_id (QnJson *json, gsize at, int32_t *id);
gboolean qn_result_read_ids (QnJson *json, gsize at, size_t block_count, QnId **ids,
                             size_t *count);

/* Room for `count` items, each of which needs a token, of a list at `at`; NULL with an error where the
 * text is too short for them, which `refusal` says, or memory runs out. */
void *qn_result_room (QnJson *json, gsize at, size_t count, size_t size,
                      const char *refusal);

/* ---- result-history.c: the history of an analysis in time, and contacts that follow the blocks ---- */

/* Adds the member to a document that is being written. */
void qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                              const QnResult *result);

/* Adds contacts found and joints released, members `found` and `left` of an object. */
void qn_result_found_write (QnFileWriter *writer, const QnResult *result);

/* Reads these members, at their tokens (0: none), into a result with steps and blocks; `found` and `left` are
 * outside the history where the analysis is not one in time. */
gboolean qn_result_history_read (QnJson *json, gsize history, gsize found, gsize left,
                                 QnResult *result);

/* Adds forces, states and damage to a step that is being written, where the result has them. */
void qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step);

/* Reads them of a step, at these tokens (0: none), into a result with steps and pairs: all steps have
 * forces and states or none, and some have damage. */
gboolean qn_result_forces_read (QnJson *json, gsize at, gsize forces, gsize states,
                                gsize damage, QnResult *result, size_t step);
