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

/* Adds what contacts that follow the blocks have become, members `found` and `left` of an object. */
void qn_result_found_write (QnFileWriter *writer, const QnResult *result);

/* Reads the member, at this token (0: none), or what stands outside it of an analysis without time, into a
 * result with steps and blocks. */
gboolean qn_result_history_read (QnJson *json, gsize history, gsize found, gsize left,
                                 QnResult *result);
