#include "core/check/second-order-work.h"

#include "core/base/numbers.h"

#include <math.h>

/* Ways, in characteristic lengths, each longer by GROWTH: from far below the elastic displacement of a
 * joint to where a block has left its joints. */
#define FIRST_WAY 1e-9
#define LAST_WAY  0.1
#define GROWTH    1.5

bool
qn_moves_on (QnAssembly *as, const double *u, double multiplier, double driven,
             const double *velocity, double *moved, double *residual)
{
  size_t n = (size_t) as->unknown_count;
  double length = as->length / qn_assembly_largest (as, velocity, NULL);

  for (double way = FIRST_WAY; way <= LAST_WAY; way *= GROWTH) {
    for (size_t i = 0; i < n; i++)
      moved[i] = u[i] + way * length * velocity[i];
    if (!qn_assembly_evaluate (as, moved))
      return false;
    qn_assembly_residual (as, multiplier, residual);
    double power = qn_dot (residual, velocity, n); /* of what is out of balance */
    double load = driven * qn_dot (as->live, velocity, n);
    double gain = load > 0 ? power / load : -INFINITY;
    if (!(gain >= -QN_PUSH))
      return false;
    if (gain >= QN_PUSH)
      return true;
  }
  return false;
}
