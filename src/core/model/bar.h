/* Reinforcing bars have an area; users give the diameter of a round bar of this area. Each bar consists of
 * straight lines: the pieces between its corners, or the bars of a mesh. */
#pragma once

#include "core/model/model.h"

/* Area, m2, of a round bar of this diameter, m; diameter of a round bar of this area. */
double qn_bar_get_area (double diameter);
double qn_bar_get_diameter (double area);

/* Whether a bar is a mesh: bars of one or two directions in the rectangle between `start` and `end`, as many
 * as fit at their spacing, centred. */
static inline bool
qn_bar_is_mesh (const QnBar *bar)
{
  return bar->spacing.x > 0 || bar->spacing.y > 0;
}

/* Number of straight lines; ends of one of them, m. Upright bars of a mesh come first. */
size_t qn_bar_line_count (const QnBar *bar);
void qn_bar_line (const QnBar *bar, size_t line, QnVec2 ends[2]);

/* Total length of its lines, m. */
double qn_bar_length (const QnBar *bar);
