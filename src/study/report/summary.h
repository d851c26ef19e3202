/* Summary of the cases of a study in words and numbers. */
#pragma once

#include "study/report/table.h"

/* Several lines, translated: how many cases there are and how they ended; of every output its
 * mean, deviation, quantiles with intervals, the share that has collapsed at a multiplier
 * (fragility), rank correlations, Sobol indices; of mechanisms how often each occurs. Plans by
 * levels are no sample: of them least and greatest values, and the effect of each parameter alone.
 * Free with g_free(). */
char *qn_summary_dup_text (const QnTable *table);
