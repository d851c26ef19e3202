#include "core/base/memory.h"
#include "support/generate-parts.h"

#include <stdlib.h>

#define PI 3.14159265358979323846

static QnStatus
check_arch (const QnArchRecipe *recipe, QnDiag *diag)
{
  QnStatus status = qn_generate_check_material (&recipe->material, diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->radius, false, "radius", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->ring, false, "ring", diag);
  if (status == QN_OK && recipe->ring >= 2 * recipe->radius)
    status = qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, QN_ENTITY_MODEL, QN_NONE,
                                "ring", recipe->ring);
  if (status == QN_OK)
    status = qn_generate_check (recipe->embrace, false, "embrace", diag);
  if (status == QN_OK && recipe->embrace > PI * (1 + 1e-12))
    status = qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, QN_ENTITY_MODEL, QN_NONE,
                                "embrace", recipe->embrace);
  if (status == QN_OK)
    status = qn_generate_check (recipe->count, false, "count", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->segments, false, "segments", diag);
  if (status == QN_OK)
    status = qn_generate_check_blocks (recipe->count + 2.0, "count", diag);
  if (status == QN_OK)
    status = qn_generate_check_blocks ((double) recipe->count * recipe->segments,
                                       "segments", diag);
  return status;
}

/* Point of the ring at a share of the embrace, 0 at the right springing and 1 at the left one.
 * Equal shares from both sides give mirrored points to the last bit. */
static QnVec2
ring_point (const QnArchRecipe *recipe, double radius, int64_t step, int64_t steps)
{
  int64_t from_middle = 2 * step - steps;
  double angle = recipe->embrace * (double) llabs (from_middle) / (2.0 * (double) steps);
  double x = radius * sin (angle);
  return qn_vec2 (from_middle < 0 ? x : -x, radius * cos (angle));
}

static QnStatus
add_voussoirs (QnModel *model, const QnArchRecipe *recipe, QnDiag *diag)
{
  int32_t segments = recipe->segments;
  double inner = recipe->radius - recipe->ring / 2,
         outer = recipe->radius + recipe->ring / 2;
  int64_t steps = (int64_t) recipe->count * segments;
  size_t vertex_count = 2 * ((size_t) segments + 1);
  QnVec2 *vertices = qn_alloc (vertex_count, sizeof *vertices);
  if (vertices == NULL)
    return qn_diag_no_memory (diag);

  QnStatus status = QN_OK;
  for (int32_t i = 0; i < recipe->count && status == QN_OK; i++) {
    for (int32_t s = 0; s <= segments; s++) {
      int64_t step = (int64_t) i * segments + s;
      vertices[s] = ring_point (recipe, outer, step, steps);
      vertices[vertex_count - 1 - (size_t) s] = ring_point (recipe, inner, step, steps);
    }
    status = qn_generate_add (model, &recipe->material, "v", i + 1, vertices,
                              vertex_count, diag);
  }
  free (vertices);
  return status;
}

/* A fixed block behind a springing: the radial joint and the same moved backwards. */
static QnStatus
add_springer (QnModel *model, const QnArchRecipe *recipe, bool right, QnDiag *diag)
{
  double inner = recipe->radius - recipe->ring / 2,
         outer = recipe->radius + recipe->ring / 2;
  QnVec2 p = ring_point (recipe, inner, right ? 0 : 1, 1);
  QnVec2 q = ring_point (recipe, outer, right ? 0 : 1, 1);
  QnVec2 out = qn_vec2_scale (1 / recipe->ring, qn_vec2_sub (q, p));
  QnVec2 back = right ? qn_vec2 (out.y, -out.x) : qn_vec2 (-out.y, out.x);
  QnVec2 shift = qn_vec2_scale (recipe->ring, back);
  const QnVec2 vertices[] = { p, q, qn_vec2_add (q, shift), qn_vec2_add (p, shift) };
  return qn_generate_add_fixed (model, &recipe->material,
                                right ? "right springer" : "left springer", vertices, 4,
                                diag);
}

QnStatus
qn_generate_arch (QnModel *model, const QnArchRecipe *recipe, QnDiag *diag)
{
  QnStatus status = check_arch (recipe, diag);
  if (status == QN_OK)
    status = qn_generate_begin (model, &recipe->material, diag);
  if (status == QN_OK)
    status = add_springer (model, recipe, true, diag);
  if (status == QN_OK)
    status = add_voussoirs (model, recipe, diag);
  if (status == QN_OK)
    status = add_springer (model, recipe, false, diag);
  return status;
}
