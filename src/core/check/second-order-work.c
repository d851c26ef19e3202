#include "core/check/second-order-work.h"

#include "core/base/numbers.h"

#include <math.h>

/* Ways, in characteristic lengths, each longer by GROWTH: from far below the elastic displacement of a
 * joint to where a block has left its joints. */
#define FIRST_WAY 1e-9
#define LAST_WAY  0.1
#define GROWTH    1.5

/* Power of the out-of-balance forces after the structure has moved by `way`. */
static double
find_power (QnAssembly *as, const double *u, double multiplier, double way,
            const double *velocity, double *moved, double *residual)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    moved[i] = u[i] + way * velocity[i];
  if (!qn_assembly_evaluate (as, moved))
    return NAN;
  qn_assembly_residual (as, multiplier, residual);
  return qn_dot (residual, velocity, (size_t) as->unknown_count);
}

bool
qn_moves_on (QnAssembly *as, const double *u, double multiplier, double driven,
             const double *velocity, double *moved, double *residual)
{
  double length = as->length / qn_assembly_largest (as, velocity, NULL);

  for (double way = FIRST_WAY; way <= LAST_WAY; way *= GROWTH) {
    double power =
      find_power (as, u, multiplier, way * length, velocity, moved, residual);
    double load = driven * qn_dot (as->live, velocity, (size_t) as->unknown_count);
    double gain = load > 0 ? power / load : -INFINITY;
    if (!(gain >= -QN_PUSH))
      return false;
    if (gain >= QN_PUSH)
      return true;
  }
  return false;
}
