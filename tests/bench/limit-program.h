/* The linear program of limit analysis for other solvers: the reference, and the peers to compare with.
 * All use one thread. */
#pragma once

#include "core/limit/limit-problem.h"

/* The largest cost x, with columns of sparse entries; rows: sum = right. Only the last column, the
 * multiplier, is free; all others are at least zero. */
typedef struct LimitProgram {
  int row_count, column_count;
  const int *starts, *rows; /* entries of column c: from starts[c] to starts[c + 1] */
  const double *values, *lower, *upper, *cost, *right;
} LimitProgram;

/* A solver with one of its methods: the largest cost, or NAN where it found no optimum within
 * `seconds`. */
typedef struct LimitPeer {
  const char *solver, *method;
  double (*solve) (const LimitProgram *program, int method, double seconds);
  int number; /* of the method */
} LimitPeer;

#ifdef HAVE_CLP
double clp_solve (const LimitProgram *program, int method, double seconds);
#endif
#ifdef HAVE_HIGHS
double highs_solve (const LimitProgram *program, int method, double seconds);
#endif

/* The peers that this build has, the fastest on most structures first; ends with a solver NULL. */
extern const LimitPeer limit_peers[];

/* Solves the scaled program (all pairs Coulomb without cohesion). Returns the multiplier or NAN; *spent
 * is the processor time. */
double limit_peer_solve (const LimitPeer *peer, const QnLimitProblem *limit,
                         double seconds, double *spent);
