#include "core/linalg/dense-front-loops.h"

#include "core/linalg/vectors.h"

const QnFrontLoops *
qn_front_loops (int width)
{
  static const QnFrontLoops *const loops[] = QN_ALL_WIDTHS (qn_front_loops);

  return loops[qn_vectors (width)];
}
