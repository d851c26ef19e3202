/* The arithmetic of contact pairs for each width of vectors: see vectors.h. */
#ifndef QN_CORE_CENTRAL_PACK_LOOPS_H
#define QN_CORE_CENTRAL_PACK_LOOPS_H

#include "core/equilibrium/central-pack.h"

extern const QnCentralLoops qn_central_loops_2, qn_central_loops_4, qn_central_loops_8;

#endif
