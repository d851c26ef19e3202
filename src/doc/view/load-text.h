/* Loads and stages in one line of text each. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "doc/text/units.h"

/* "Force on b6: 0; -10 kN". The caller frees it. */
char *qn_load_dup_text (const QnModel *model, const QnLoad *load, QnUnits units);

/* What a multiplier of the live loads means: "0.234 g" of horizontal weights, "132 kN" of forces in one
 * direction; NULL where they are of several kinds or directions, or grow in stages. The caller frees it. */
char *qn_live_loads_dup_amount (const QnModel *model, double multiplier, QnUnits units);

/* "load on top: top to 2". The caller frees it. */
char *qn_stage_dup_text (const QnModel *model, gsize stage, QnUnits units);

/* First and last step of a stage in a result (stage from 1; 0: what lies before the first).
 * False where it has none. */
bool qn_result_stage_steps (const QnResult *result, int32_t stage, size_t *first,
                            size_t *last);
