/* The arithmetic of contact pairs for each width of vectors: see vectors.h. */
#pragma once

#include "core/equilibrium/central-pack.h"

extern const QnCentralLoops qn_central_loops_2, qn_central_loops_4;
