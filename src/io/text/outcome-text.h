/* How an analysis ended and why, in plain sentences of the user's language. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

/* One or two words, translated: "Collapse"; "Overturns" in time. A static string. */
const char *qn_outcome_text (QnOutcome outcome, gboolean in_time);

/* One to three sentences: what the outcome is, at which multiplier, in which stage, and what
 * made the procedure stop there. Free with g_free(). */
char *qn_outcome_dup_reason (const QnModel *model, const QnResult *result);

/* The same without the sentence with the multiplier of a collapse. */
char *qn_outcome_dup_cause (const QnModel *model, const QnResult *result);

/* One line: how the collapse multiplier was found, and why not as asked for, how many solutions there are, and the bound that
 * nothing exceeds. NULL where no collapse was found. Free with g_free(). */
char *qn_outcome_dup_interval (const QnModel *model, const QnResult *result);

/* Lines: where each stage led and the work of its loads, and the same of every cycle; NULL without stages. Free
 * with g_free(). */
char *qn_outcome_dup_stages (const QnModel *model, const QnResult *result);

/* Name of a stage (number from 1): its own, or its number; of a cyclic protocol with cycle and direction,
 * “push 2+”. Free with g_free(). */
char *qn_stage_dup_name (const QnModel *model, int32_t stage);

/* Whether nothing but the dead load acts, so that there is no path to follow. */
gboolean qn_model_lacks_live_load (const QnModel *model);
