/* Reinforcing bars are given by their area; people speak of the diameter of one round bar of it. Each
 * consists of straight lines: the pieces between its corners, or the bars of a mesh. */
#pragma once

#include "core/model/model.h"

/* Area of a round bar of that diameter, m2, m; and the other way round. */
double qn_bar_get_area (double diameter);
double qn_bar_get_diameter (double area);

/* Whether it is a mesh: bars of two directions, or one, in the rectangle between `start` and `end`, as many
 * as find room at their spacing, in its middle. */
static inline bool
qn_bar_is_mesh (const QnBar *bar)
{
  return bar->spacing.x > 0 || bar->spacing.y > 0;
}

/* Its straight lines and their ends; of a mesh the upright ones first. */
size_t qn_bar_line_count (const QnBar *bar);
void qn_bar_line (const QnBar *bar, size_t line, QnVec2 ends[2]);

/* All of its lines together, m. */
double qn_bar_length (const QnBar *bar);
