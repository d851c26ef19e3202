/* The member `history` of a result file, of an analysis in time (data/result-format.md). */
#ifndef QN_IO_RESULT_HISTORY_H
#define QN_IO_RESULT_HISTORY_H

#include "core/model/model.h"
#include "core/result/result.h"
#include "io/json/json-stream.h"
#include "io/text/file-writer.h"

/* Adds the member to a document that is being written. */
void qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                              const QnResult *result);

/* Adds what contacts that follow the blocks have become, members `found` and `left` of an object. */
void qn_result_found_write (QnFileWriter *writer, const QnResult *result);

/* What has been read of it. */
typedef struct QnHistoryDraft {
  QnHistory history;  /* but for its rows */
  GPtrArray *columns; /* of GArray of double, as in the rows of a history */
  GArray *peaks;
  GArray *found, *found_forces, *left; /* as a result has them; NULL: none */
  gboolean by_step; /* these stood outside the history, of an analysis without time */
} QnHistoryDraft;

/* Reads the member; target is a QnHistoryDraft. */
gboolean qn_result_history_read (QnJsonStream *stream, gpointer target);

/* The same for one item of `found` and of `left` outside it. */
gboolean qn_result_found_read (QnJsonStream *stream, gpointer target);
gboolean qn_result_left_read (QnJsonStream *stream, gpointer target);

/* Hands it over to the result, whose number of blocks is known. FALSE with the stream's error where
 * its lists are not of one length. */
gboolean qn_result_history_take (QnHistoryDraft *draft, QnJsonStream *stream,
                                 QnResult *result);

void qn_history_draft_clear (QnHistoryDraft *draft);

#endif
