/* Contact pairs at given places, as the user types them: "0,1; 0,5; 0,9". */
#pragma once

#include "core/base/vec2.h"
#include "core/model/model.h"
#include "doc/text/units.h"

#include <glib.h>

/* Makes the rule one of given places, parts of the face's length from 0 to 1 in ascending order;
 * weights empty: all equal, otherwise one for each, scaled to the sum 1. Without any place one
 * at each end is meant. Whether places increase and weights are positive is for the model's check.
 * On failure nothing changes (domain QN_EDIT_ERROR). */
gboolean qn_pair_rule_parse (QnPairRule *rule, const char *positions, const char *weights,
                             GError **error);

/* How many pairs the rule puts on a face of this law; 1 where neither says. */
int qn_pair_rule_shown_count (const QnPairRule *rule, const QnModel *model, QnId law);

/* Where the rule puts the pairs of a face of this law: "5 per joint, at Gauss–Lobatto points". The caller frees
 * it. */
char *qn_pair_rule_dup_text (const QnPairRule *rule, const QnLaw *law, QnUnits units);

/* The lists of a rule of given places, "" for other rules. The caller frees them. */
char *qn_pair_rule_dup_positions (const QnPairRule *rule);
char *qn_pair_rule_dup_weights (const QnPairRule *rule);

/* Points apart by semicolons, their two numbers by spaces. FALSE where there is none, where there
 * are more than `most`, the room in `points`, or where one cannot be read. */
gboolean qn_points_parse (const char *text, QnVec2 *points, int32_t most, int32_t *count);

/* The text with nine significant digits; the caller frees it. */
char *qn_points_dup_text (const QnVec2 *points, int32_t count);
