#include "render/drawing/triangulate.h"

#include <stdbool.h>

static double
turn (const QnVec2 *p, uint32_t a, uint32_t b, uint32_t c)
{
  return qn_vec2_cross (qn_vec2_sub (p[b], p[a]), qn_vec2_sub (p[c], p[a]));
}

/* Whether the corner i of the remaining polygon can be cut off. */
static bool
is_ear (const QnVec2 *p, const uint32_t *order, uint32_t n, uint32_t i)
{
  uint32_t a = order[(i + n - 1) % n], b = order[i], c = order[(i + 1) % n];
  if (turn (p, a, b, c) <= 0)
    return false;
  for (uint32_t k = 0; k < n; k++) {
    uint32_t q = order[k];
    if (q != a && q != b && q != c && turn (p, a, b, q) >= 0 && turn (p, b, c, q) >= 0
        && turn (p, c, a, q) >= 0)
      return false;
  }
  return true;
}

size_t
qn_triangulate (const QnVec2 *points, uint32_t count, uint32_t *indices, uint32_t *order)
{
  size_t written = 0;
  double area = 0;
  for (uint32_t i = 0; i < count; i++)
    area += qn_vec2_cross (points[i], points[(i + 1) % count]);
  for (uint32_t i = 0; i < count; i++)
    order[i] = area >= 0 ? i : count - 1 - i;

  uint32_t n = count;
  while (n >= 3) {
    uint32_t ear = 0;
    while (ear < n && !is_ear (points, order, n, ear))
      ear++;
    /* Nothing to cut: what remains has no area, or crosses itself by rounding. */
    bool found = ear < n;
    if (!found)
      ear = 0;
    if (found) {
      indices[written++] = order[(ear + n - 1) % n];
      indices[written++] = order[ear];
      indices[written++] = order[(ear + 1) % n];
    }
    for (uint32_t k = ear; k + 1 < n; k++)
      order[k] = order[k + 1];
    n--;
  }
  return written;
}
