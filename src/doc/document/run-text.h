/* Texts on runs: request and outcome. */
#pragma once

#include "doc/document/run.h"
#include "doc/text/units.h"

/* "Run 1, load control: 0.3558", "Run 2, modes: mode 1, 12.3 Hz". The caller frees it. */
char *qn_run_dup_title (const QnRun *run);

/* The outcome in one or two sentences. The caller frees it. */
char *qn_run_dup_explanation (const QnRun *run);

/* The mechanism in words, NULL where there is none, and of modes and buckling, in which nothing
 * slides or opens. The caller frees it. */
char *qn_run_dup_mechanism (const QnRun *run);

/* The mechanism in one sentence. */
char *qn_run_dup_mechanism_sentence (const QnRun *run);

/* Events of the path: a line (char *) for each reported event (qn_result_is_felt(); *told of them) with
 * multiplier, motion and number of moving blocks, and a line with the number of the others. Free with
 * g_ptr_array_unref(). */
GPtrArray *qn_run_dup_events (const QnRun *run, QnUnits units, guint *told);

/* Whether it followed a path that has a curve. */
gboolean qn_run_has_curve (const QnRun *run);
