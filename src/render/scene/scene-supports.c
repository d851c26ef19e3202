/* Supports: hatched blocks, as drawings of structures have them. */
#include "core/base/numbers.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>

/* Most hatch lines in one block; the spacing grows beyond. */
#define MAX_HATCH_LINES 400

/* Hatches a polygon, concave allowed, by lines along `direction` (unit), `spacing` apart:
 * each line is cut by the edges and every second piece lies inside. */
static void
hatch_polygon (QnSceneBuilder *b, const QnVec2 *v, QnId count, QnVec2 direction,
               double spacing, QnColor color)
{
  QnVec2 across = qn_vec2_perp (direction);
  double low = (double) INFINITY, high = -(double) INFINITY;
  for (QnId i = 0; i < count; i++) {
    double level = qn_vec2_dot (v[i], across);
    low = fmin (low, level);
    high = fmax (high, level);
  }
  spacing = fmax (spacing, (high - low) / MAX_HATCH_LINES);
  g_autofree double *cuts = g_new (double, (size_t) count);
  for (double level = low + 0.5 * spacing; level < high; level += spacing) {
    int n = 0;
    for (QnId i = 0; i < count; i++) {
      QnVec2 p = v[i], q = v[(i + 1) % count];
      double dp = qn_vec2_dot (p, across) - level, dq = qn_vec2_dot (q, across) - level;
      if ((dp < 0) != (dq < 0))
        cuts[n++] = qn_vec2_dot (qn_vec2_lerp (p, q, dp / (dp - dq)), direction);
    }
    qsort (cuts, (size_t) n, sizeof *cuts, qn_compare_doubles);
    for (int k = 0; k + 1 < n; k += 2) {
      QnVec2 base = qn_vec2_scale (level, across);
      QnVec2 line[2] = { qn_vec2_add_scaled (base, cuts[k], direction),
                         qn_vec2_add_scaled (base, cuts[k + 1], direction) };
      QnCommand *command =
        qn_scene_stroke (b->scene, QN_LAYER_HATCH, line, 2, false, 0.5, color);
      qn_command_set_extent (command, spacing, 1.5f);
    }
  }
}

void
qn_build_supports (QnSceneBuilder *b)
{
  QnColor color = qn_builder_ink (b, QN_INK_LINE);
  bool fixed = false, partial = false;
  g_autoptr (GArray) points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  for (size_t i = 0; i < b->model->block_count; i++) {
    const QnBlock *block = &b->model->blocks[i];
    int held = block->support[0] + block->support[1] + block->support[2];
    if (held == 0)
      continue;
    const QnVec2 *v = qn_builder_place_vertices (b, &b->motion, (QnId) i, points);
    bool all = held == QN_DOF_COUNT;
    QnVec2 direction = qn_vec2 (G_SQRT2 / 2, all ? G_SQRT2 / 2 : -G_SQRT2 / 2);
    /* The spacing suits the smaller side of the block and the size of its neighbours, but
     * not where those are so small that nothing of the hatch would be seen. */
    double side =
      qn_box_smaller_side (qn_box_of_points (v, (size_t) block->vertex_count));
    double spacing =
      fmin (0.30 * side, fmax (0.22 * b->block_size, 0.007 * qn_box_diagonal (b->box)));
    hatch_polygon (b, v, block->vertex_count, direction, all ? spacing : 2 * spacing,
                   color);
    fixed |= all;
    partial |= !all;
  }
  QnColor ground = qn_builder_ink (b, QN_INK_SUPPORT);
  if (fixed)
    qn_scene_legend (b->scene, QN_COMMAND_FILL, 0, ground, "%s", _ ("fixed"))->hatched =
      true;
  if (partial)
    qn_scene_legend (b->scene, QN_COMMAND_FILL, 0, ground, "%s", _ ("partly fixed"))
      ->hatched = true;
}
