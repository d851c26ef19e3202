/* Points as the user types them, "-0.002 -2e6; 0.001 1e5": of a law's curve, elongation and force or strain
 * and stress, or places, all in SI. The decimal sign is that of the locale, or the other. */
#pragma once

#include "core/base/vec2.h"

#include <glib.h>

/* Points apart by semicolons, their two numbers by spaces. FALSE where there is none, where there
 * are more than `most`, the room in `points`, or where one cannot be read. */
gboolean qn_points_parse (const char *text, QnVec2 *points, int32_t most, int32_t *count);

/* The text with nine significant digits; the caller frees it. */
char *qn_points_dup_text (const QnVec2 *points, int32_t count);
