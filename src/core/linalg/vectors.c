#include "core/linalg/vectors.h"

int
qn_vectors (int width)
{
#ifdef QN_HAVE_X86_VECTORS
  if (width >= 4 && __builtin_cpu_supports ("avx2"))
    return 1;
#endif
  (void) width;
  return 0;
}
