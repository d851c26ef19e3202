/* How an analysis ended and why, in plain sentences of the user's language. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

/* One or two words, translated: "Collapse"; "Overturns" in time. A static string. */
const char *qn_outcome_text (QnOutcome outcome, gboolean in_time);

/* One to three sentences: the outcome, its multiplier and stage, and why the procedure stopped
 * there. Free with g_free(). */
char *qn_outcome_dup_reason (const QnModel *model, const QnResult *result);

/* The same without the sentence with the multiplier of a collapse. */
char *qn_outcome_dup_cause (const QnModel *model, const QnResult *result);

/* One line: procedure that found the collapse multiplier, and why not the one of the settings; number of
 * solutions; upper bound. NULL where no collapse was found. Free with g_free(). */
char *qn_outcome_dup_interval (const QnModel *model, const QnResult *result);

/* Lines: last multiplier and work of each stage and of each cycle; NULL without stages. Free with
 * g_free(). */
char *qn_outcome_dup_stages (const QnModel *model, const QnResult *result);

/* Name of a stage (number from 1): its own, or its number; of a cyclic protocol with cycle and direction,
 * “push 2+”. Free with g_free(). */
char *qn_stage_dup_name (const QnModel *model, int32_t stage);

/* Whether only the dead load acts: there is no path to follow. */
gboolean qn_model_lacks_live_load (const QnModel *model);
