/* The linear program of limit analysis solved by Clp: the reference, and the solver to compare with. */
#pragma once

#include "core/limit/limit-problem.h"

typedef enum { CLP_DUAL, CLP_PRIMAL, CLP_BARRIER, CLP_METHOD_COUNT } ClpMethod;

/* Solves the scaled program (all pairs Coulomb without cohesion): x >= 0, lambda free. Returns
 * the multiplier, or NAN where Clp found no optimum within `seconds`; *spent is what it took. */
double clp_limit_solve (const QnLimitProblem *limit, ClpMethod method, double seconds,
                        double *spent);

/* Processor time of this process: other processes do not count. All solvers use one thread. */

const char *clp_method_name (ClpMethod method);
