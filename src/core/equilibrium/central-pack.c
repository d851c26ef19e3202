#include "core/equilibrium/central-pack-loops.h"

#include "core/linalg/vectors.h"

const QnCentralLoops *
qn_central_loops (int width)
{
  static const QnCentralLoops *const loops[] = QN_ALL_WIDTHS (qn_central_loops);

  return loops[qn_vectors (width)];
}
