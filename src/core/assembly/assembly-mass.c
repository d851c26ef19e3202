/* Mass matrix and inertia forces. */
#include "core/assembly/assembly-parts.h"

#include <string.h>

/* Mass of a block and the square of its radius of gyration over that of the scaled rotation. */
static double
block_mass (const QnAssembly *as, size_t block, int dof)
{
  const QnBlock *b = &as->model->blocks[block];
  double mass = b->weight / as->model->gravity;

  return dof == QN_DOF_RZ ? mass * (b->polar_moment / b->area) / (as->length * as->length)
                          : mass;
}

QnStatus
qn_assembly_mass (const QnAssembly *as, double *mass, QnDiag *diag)
{
  const QnModel *model = as->model;

  memset (mass, 0, (size_t) as->ap[as->unknown_count] * sizeof *mass);
  for (size_t b = 0; b < model->block_count; b++)
    for (int i = 0; i < QN_DOF_COUNT; i++) {
      int32_t unknown = as->unknown[QN_DOF_COUNT * b + i];
      if (unknown == QN_NONE || as->settles[unknown])
        continue;
      double own = block_mass (as, b, i);
      if (!(own > 0 && isfinite (own)))
        return qn_diag_set_field (diag, QN_PROBLEM_BLOCK_WITHOUT_MASS, QN_ENTITY_BLOCK,
                                  (QnId) b, NULL, own);
      mass[as->diagonal[unknown]] = own;
    }
  for (size_t b = 0; b < model->beam_count; b++) {
    double own =
      qn_section_weight (&model->sections[model->beams[b].section]) / model->gravity;
    if (!(own > 0 && isfinite (own)))
      return qn_diag_set_field (diag, QN_PROBLEM_BEAM_WITHOUT_MASS, QN_ENTITY_BEAM,
                                (QnId) b, NULL, own);
  }
  qn_beam_assembly_add_mass (as, mass);
  for (int32_t j = 0; j < as->unknown_count; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++)
      if (as->settles[j] || as->settles[as->ai[k]])
        mass[k] = 0; /* supports that may settle do not move */
  return QN_OK;
}

void
qn_assembly_add_inertia (const QnAssembly *as, QnVec2 acceleration, double *forces)
{
  const double components[2] = { acceleration.x, acceleration.y };

  for (size_t b = 0; b < as->model->block_count; b++)
    for (int i = 0; i < 2; i++) {
      int32_t unknown = as->unknown[QN_DOF_COUNT * b + i];
      if (unknown != QN_NONE)
        forces[unknown] += block_mass (as, b, i) * components[i];
    }
  qn_beam_assembly_add_inertia (as, acceleration, forces);
  for (size_t s = 0; s < as->settling_count; s++)
    forces[as->settling[s].unknown] = 0;
}

void
qn_assembly_multiply (const QnAssembly *as, const double *ax, const double *x, double *y)
{
  memset (y, 0, (size_t) as->unknown_count * sizeof *y);
  for (int32_t j = 0; j < as->unknown_count; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++)
      y[as->ai[k]] += ax[k] * x[j];
}
