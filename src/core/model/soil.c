#include "core/model/soil.h"

#include "core/base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Length of the ties, in sizes of the structure. */
#define REACH 100.0

double
qn_fill_active (const QnLoad *fill)
{
  return fill->friction_angle > 0 ? qn_earth_active (fill->friction_angle) : 0;
}

/* Over the vertical stress of a fill: largest pressure less Ka. */
static double
fill_mobilised (const QnLoad *fill)
{
  double active = qn_fill_active (fill);

  return active > 0 ? fmax (fill->mobilisation / active - active, 0) : 0;
}

void
qn_model_drop_soil (QnModel *model)
{
  for (size_t i = 0; i < model->soil_tie_count; i++)
    free (model->soil_ties[i].name);
  model->soil_tie_count = 0;
}

/* Soil on one side of a block: integral of the vertical stress, N; its first moment; projection, m2. */
typedef struct {
  double stress, area;
  QnVec2 moment;
} Push;

/* A tie of a block, to the side to which the fill pushes it: 1 is right, -1 left. */
static QnStatus
add_tie (QnModel *model, const QnLoad *fill, QnId block, const Push *push, double side,
         double reach, QnDiag *diag)
{
  static const char prefix[] = "soil.";
  const QnVec2 at = qn_vec2_scale (1 / push->stress, push->moment);
  size_t size = sizeof prefix + strlen (model->blocks[block].name);
  char *name = qn_alloc (size, 1);
  QnTie *tie = NULL;

  if (name != NULL) {
    snprintf (name, size, "%s%s", prefix, model->blocks[block].name);
    tie = QN_ADD (model, QnTie, soil_ties, name);
  }
  free (name);
  if (tie == NULL)
    return qn_diag_no_memory (diag);
  tie->ends[0] = (QnTieEnd){ block, at };
  tie->ends[1] = (QnTieEnd){ QN_NONE, qn_vec2 (at.x + side * reach, at.y) };
  tie->area = push->area;
  tie->elasticity = fill->stiffness * reach;
  tie->yield = fill_mobilised (fill) * push->stress / push->area;
  /* Pressure at rest less Ka. */
  double above = qn_earth_at_rest (fill->friction_angle) - qn_fill_active (fill);
  tie->prestress = fmin (fmin (fmax (above, 0), fill_mobilised (fill)) * push->stress,
                         tie->yield * tie->area);
  return QN_OK;
}

QnStatus
qn_model_add_soil (QnModel *model, size_t source, QnDiag *diag)
{
  const QnLoad *fill = qn_model_load (model, source);
  const double factor = qn_model_load_factor (model, fill);
  size_t count;
  const QnEdgeForce *forces = qn_model_edge_forces_of (model, source, &count);
  const QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  QnStatus status = QN_OK;

  if (!(fill_mobilised (fill) > 0 && factor > 0))
    return QN_OK;
  Push *pushes = qn_alloc (2 * model->block_count, sizeof *pushes);
  if (pushes == NULL)
    return qn_diag_no_memory (diag);
  for (size_t i = 0; i < count; i++) {
    double x = forces[i].force.x, stress = fabs (x) / qn_fill_active (fill) * factor;
    Push *push = &pushes[2 * forces[i].block + (x > 0)];
    push->stress += stress;
    push->moment = qn_vec2_add_scaled (push->moment, stress, forces[i].at);
    push->area += model->blocks[forces[i].block].thickness
                  * fabs (forces[i].ends[1].y - forces[i].ends[0].y);
  }
  for (size_t i = 0; i < 2 * model->block_count && status == QN_OK; i++)
    if (pushes[i].stress > 0 && pushes[i].area > 0
        && !qn_support_is_full (model->blocks[i / 2].support))
      status = add_tie (model, fill, (QnId) (i / 2), &pushes[i], i % 2 == 0 ? -1 : 1,
                        REACH * qn_box_diagonal (box), diag);
  free (pushes);
  return status;
}
