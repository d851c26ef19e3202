/* Runs in words: what was asked, and what came of it. */
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

/* The same in one sentence. */
char *qn_run_dup_mechanism_sentence (const QnRun *run);

/* What happened along the path, a line (char *) for each of the result's events that is felt, *told of them: its
 * multiplier, how far a jump goes, how many blocks move; and one that counts the others, where joints
 * settle. Free with g_ptr_array_unref(). */
GPtrArray *qn_run_dup_events (const QnRun *run, QnUnits units, guint *told);

/* Whether it followed a path that has a curve. */
gboolean qn_run_has_curve (const QnRun *run);
