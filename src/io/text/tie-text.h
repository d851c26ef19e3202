/* Ties in words, translated. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

/* "slack", "elastic", "yields", "anchor gives". */
const char *qn_tie_state_text (QnTieState state);

/* The step with the largest force of a tie, the first of equal ones; -1: forces not known. */
gssize qn_tie_worst_step (const QnResult *result, gsize tie);

/* Force of a tie over its strength; 0 if the strength is unlimited. */
double qn_tie_utilisation (const QnTie *tie, double force);

/* "Ties at most: “T” 3 kN, 100 % of its strength (anchor gives), “S” 1.2 kN, 40 %.", those that use most
 * first; NULL where there are none or their forces are not known. Free with g_free(). */
char *qn_ties_dup_text (const QnModel *model, const QnResult *result);

/* "2 plastic hinges: “beam” at “left corner”, “right” at “right corner”.", as they are at the last
 * step; NULL where no beam yields or its section forces are not known. Free with g_free(). */
char *qn_hinges_dup_text (const QnModel *model, const QnResult *result);
