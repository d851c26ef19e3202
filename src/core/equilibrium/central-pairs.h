/* All contact pairs of a central path as cells of the interior-point engine: see central-path.h. Pairs of
 * other laws have no bounds, and a tangent in the place of their inverse. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/equilibrium/interior-point.h"

typedef struct QnCentralPairs {
  QnIpStep ip;          /* without residuals of balance, which are the caller's */
  QnPool pool;          /* of all arrays, and of the caller's */
  QnAssembly *assembly; /* borrowed */
  double force, length; /* units, N and m */
  bool others;          /* some pairs have other laws */
  bool turned;          /* some slip has passed a corner of the law's dilation */
  double *slips;        /* by pair: slip about which dilation is linearised, m */
  QnIpProblem
    problem; /* bounds of a pair by rows: tension, friction both ways, compression */
  double *plastic; /* pairs x 2: plastic elongations q_p */
  double *rates;   /* pairs x 2: elongations by a step, m */
  double *forces;  /* pairs x 2, N; tangents: x 4, N/m */
  double *tangents;

  /* Maxima over all pairs in units of the path. */
  double strain, strength; /* residuals: q - q_p - flow z - y / k; h - G y - s */
  double elongation;       /* q - q_p */
  double largest_force;
} QnCentralPairs;

/* The pool has failed when memory runs out. */
void qn_central_pairs_init (QnCentralPairs *pairs, QnAssembly *assembly,
                            const QnIpTuning *tuning);

/* Starts all pairs from the last evaluation inside their strength: s z = size, s - z the remaining strength
 * or minus the opening. Dilation is linear about the committed slip; `again`: about the slip at which the
 * path before left those that turned. */
void qn_central_pairs_start (QnCentralPairs *pairs, double size, bool again);

/* Residuals and tangents at the last elongations; evaluates pairs of other laws, false if that failed. */
bool qn_central_pairs_prepare (QnCentralPairs *pairs);

/* Sets `forces` to the present ones; or to those that a step leads to if no block moves. */
void qn_central_pairs_get_forces (QnCentralPairs *pairs);
void qn_central_pairs_aim (QnCentralPairs *pairs);

/* Sets y and s = G y of a step from `rates`. */
void qn_central_pairs_complete (const QnCentralPairs *pairs, QnIpVector *step);

/* Writes present forces and their plastic elongations into the assembly's responses. False if a law has no
 * response there or some pair has turned. */
bool qn_central_pairs_take_flow (QnCentralPairs *pairs);
