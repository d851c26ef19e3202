#include "core/model/bar.h"
#include "core/base/base.h"
#include "core/base/integer.h"

#include <math.h>

double
qn_bar_get_area (double diameter)
{
  return 0.25 * QN_PI * diameter * diameter;
}

double
qn_bar_get_diameter (double area)
{
  return sqrt (4.0 * area / QN_PI);
}

/* Part of a spacing by which the last bar may miss the rectangle. */
#define ROUNDING 1e-6

/* How many bars of a mesh find room across an extent. */
static size_t
count_across (double extent, double spacing)
{
  return spacing > 0
           ? (size_t) qn_to_integer (extent / spacing + ROUNDING, 0, INT32_MAX) + 1
           : 0;
}

size_t
qn_bar_line_count (const QnBar *bar)
{
  if (!qn_bar_is_mesh (bar))
    return (size_t) bar->via_count + 1;
  return count_across (fabs (bar->end.x - bar->start.x), bar->spacing.x)
         + count_across (fabs (bar->end.y - bar->start.y), bar->spacing.y);
}

/* Where the bars of one direction lie. */
static double
place_across (double start, double end, double spacing, size_t i)
{
  double rest = fabs (end - start)
                - spacing * (double) (count_across (fabs (end - start), spacing) - 1);

  return fmin (start, end) + 0.5 * rest + spacing * (double) i;
}

void
qn_bar_line (const QnBar *bar, size_t line, QnVec2 ends[2])
{
  QnVec2 start = bar->start, end = bar->end;

  ends[0] = start;
  ends[1] = end;
  if (!qn_bar_is_mesh (bar)) {
    if (line > 0)
      ends[0] = bar->via[line - 1];
    if (line < (size_t) bar->via_count)
      ends[1] = bar->via[line];
    return;
  }
  size_t upright = count_across (fabs (end.x - start.x), bar->spacing.x);
  if (line < upright)
    ends[0].x = ends[1].x = place_across (start.x, end.x, bar->spacing.x, line);
  else
    ends[0].y = ends[1].y = place_across (start.y, end.y, bar->spacing.y, line - upright);
}

double
qn_bar_length (const QnBar *bar)
{
  double length = 0;

  for (size_t i = 0; i < qn_bar_line_count (bar); i++) {
    QnVec2 ends[2];
    qn_bar_line (bar, i, ends);
    length += qn_vec2_length (qn_vec2_sub (ends[1], ends[0]));
  }
  return length;
}
