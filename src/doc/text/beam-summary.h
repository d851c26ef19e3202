/* Section forces of a beam in three lines of text: at its ends, and the largest of each and where that is. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "doc/text/units.h"

/* NULL where the result does not know the section forces of this step. The caller frees it. */
char *qn_beam_dup_summary (const QnModel *model, const QnResult *result, size_t step,
                           QnId beam, QnUnits units);
