/* The member `history` of a result file, of an analysis in time, and contacts that follow the blocks
 * (data/result-format.md). */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "io/json/json-tokens.h"
#include "io/text/file-writer.h"

/* Adds the member to a document that is being written. */
void qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                              const QnResult *result);

/* Adds contacts found and joints released, members `found` and `left` of an object. */
void qn_result_found_write (QnFileWriter *writer, const QnResult *result);

/* Reads these members, at their tokens (0: none), into a result with steps and blocks; `found` and `left` are
 * outside the history where the analysis is not one in time. */
gboolean qn_result_history_read (QnJson *json, gsize history, gsize found, gsize left,
                                 QnResult *result);
