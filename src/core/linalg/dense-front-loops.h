/* The loops over dense fronts for each width of vectors: see dense-front.c. */
#pragma once

#include "core/linalg/dense-front.h"

extern const QnFrontLoops qn_front_loops_2, qn_front_loops_4;
