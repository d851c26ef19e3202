#include "core/linalg/dense-front.h"

/* Compiled once for vectors of two and of four numbers: the compiler would split vectors wider than the
 * processor's. Every width does the same operations on every number, in the same order. */
const QnFrontLoops *
qn_front_loops (int width)
{
#ifdef QN_HAVE_X86_VECTORS
  if (width >= 4 && __builtin_cpu_supports ("avx2"))
    return &qn_front_loops_4;
#endif
  (void) width;
  return &qn_front_loops_2;
}
