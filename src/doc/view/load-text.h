/* Loads and stages in one line of text each. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "doc/text/units.h"

/* "Force on b6: 0; -10 kN". The caller frees it. */
char *qn_load_dup_text (const QnModel *model, const QnLoad *load, QnUnits units);

/* What a multiplier of the live loads means: "0.234 g" of horizontal weights, "132 kN" of forces in one
 * direction, of vehicles that of all axles; NULL where they are of several kinds or directions, or grow in stages. The caller frees it. */
char *qn_live_loads_dup_amount (const QnModel *model, double multiplier, QnUnits units);

/* "load on top: top to 2"; of a cyclic protocol at its first stage, and empty at the others. The caller
 * frees it. */
char *qn_stage_dup_text (const QnModel *model, gsize stage, QnUnits units);

/* "0.5 mm; 2 mm", the amplitudes of a protocol, empty of an ordinary stage, and how many cycles each has. The
 * caller frees it. The other way round `count` is 0 of an empty text; NULL: an error. */
char *qn_stage_dup_amplitudes (const QnModel *model, gsize stage, QnUnits units,
                               gsize *cycles);
double *qn_stage_parse_amplitudes (const QnStage *stage, const char *text, QnUnits units,
                                   gsize *count, GError **error);

/* First and last step of a stage in a result (stage from 1; 0: what lies before the first).
 * False where it has none. */
bool qn_result_stage_steps (const QnResult *result, int32_t stage, size_t *first,
                            size_t *last);
