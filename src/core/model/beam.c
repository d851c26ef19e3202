#include "core/model/beam.h"

#include <math.h>

const char *const qn_beam_kind_names[QN_BEAM_KIND_COUNT] = {
  [QN_BEAM_TIMOSHENKO] = "timoshenko",
  [QN_BEAM_EULER_BERNOULLI] = "euler-bernoulli",
};

const char *const qn_block_side_names[QN_BLOCK_SIDE_COUNT] = {
  [QN_BLOCK_SIDE_LEFT] = "left",
  [QN_BLOCK_SIDE_RIGHT] = "right",
  [QN_BLOCK_SIDE_BOTTOM] = "bottom",
  [QN_BLOCK_SIDE_TOP] = "top",
};

double
qn_section_shear_modulus (const QnSection *section)
{
  return section->shear_modulus > 0 ? section->shear_modulus
                                    : section->young / (2 * (1 + section->poisson));
}

double
qn_section_plastic_moment (const QnSection *section)
{
  if (section->plastic_moment > 0)
    return section->plastic_moment;
  return section->yield > 0
           ? section->yield * section->width * section->height * section->height / 4
           : INFINITY;
}

double
qn_section_weight (const QnSection *section)
{
  return section->unit_weight * section->area;
}

QnBeamPoint
qn_beam_forces_at (const QnBeamForces *f, double length, double s)
{
  double change = f->shear[1] - f->shear[0]; /* q L */
  return (QnBeamPoint){
    .normal = (1 - s) * f->normal[0] + s * f->normal[1],
    .shear = (1 - s) * f->shear[0] + s * f->shear[1],
    .moment =
      (1 - s) * f->moment[0] + s * f->moment[1] - 0.5 * change * length * s * (1 - s),
  };
}
