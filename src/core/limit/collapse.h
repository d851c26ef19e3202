/* Collapse of rigid blocks whose joints flow by a rule of their own, found directly.
 *
 * Unknowns are the motion v, the pair forces y, what strength they leave s, the flow z, and the
 * multiplier:
 *
 *     B y + lambda f + d = 0         balance
 *     e y + B'v + F z = 0            the motion is that of joints which flow, and of their compliance e
 *     G y + s = h
 *     s z = 0,  s >= 0,  z >= 0      flow only at the strength
 *     f'v = load_gain                work of the live load
 *
 * F is the flow of each strength row, G' where it is associative. A small compliance e decides which of
 * many force states that reach a strength is taken: the one that elastic joints of one stiffness reach.
 * Without it blocks wedge each other. The multiplier does not depend on e any more where e is small
 * enough; how far it does is told by its derivative.
 *
 * It is sought by interior-point steps (Mehrotra's predictor and corrector, Gondzio's centrality
 * correctors), which lower all products s z and residuals together. Friction without associativity
 * makes the curve on which all s z are equal turn back: its matrix has a determinant of the wrong sign
 * there, or a step is short because the strength of a few joints runs away with their normal force.
 * Then an iteration takes into account but a part of that, the coupling c: its matrix has
 * F' + c (G - F') in place of G. With c = 0 it is that of associative flow, symmetric and positive
 * definite. What is left out stays in the residual of G y + s = h and is taken off by later
 * iterations, so the solution is that of the equations above whatever c was; and the iterate has
 * passed to the other side of the turn. Pairs are eliminated, each iteration has one factorisation of
 * the size of the blocks.
 */
#ifndef QN_CORE_COLLAPSE_H
#define QN_CORE_COLLAPSE_H

#include "core/limit/interior-point-kkt.h"

typedef enum {
  QN_COLLAPSE_FOUND,
  QN_COLLAPSE_LOST, /* budget spent, or rounding ended the progress */
  QN_COLLAPSE_CANCELLED
} QnCollapseState;

typedef struct QnCollapse {
  const QnIpProblem *problem; /* borrowed */
  QnIpKkt kkt;
  QnIpVector at; /* the iterate, tau and kappa unused */
  double growth; /* of a collapse: d lambda / d log (1 / compliance) */
  double least_coupling;

  QnIpVector step, trial;
  double *w;            /* z / s */
  double *ry, *rv, *rz; /* residuals, minus the left-hand sides */
  double r_lambda;      /* that of the work */
  double *products;     /* right-hand side of s dz + z ds */
  QnIpKktRight right;
} QnCollapse;

/* Analyses the structure and allocates everything; `problem` is borrowed until _clear(). `collapse` is
 * overwritten without being cleared. */
QnStatus qn_collapse_init (QnCollapse *collapse, const QnIpProblem *problem,
                           QnDiag *diag);
void qn_collapse_clear (QnCollapse *collapse);

/* Sets the start: these forces (cell_count x 2) and this multiplier, no motion; NULL and 0: from
 * rest. `strength` > 0, in units of force, is what a joint without any has left there; its flow is
 * 1. `coupling` (0 to 1) is the least of an iteration whose matrix allows more. */
void qn_collapse_start (QnCollapse *collapse, const double *y, double lambda,
                        double strength, double coupling);

/* Goes from the start to a collapse, with the compliance that the problem's cells have and at most
 * `budget` factorisations. FOUND: the multiplier is known to `tolerance` of itself. go_on (data) is
 * asked once an iteration. */
QnStatus qn_collapse_follow (QnCollapse *collapse, double tolerance, int32_t budget,
                             bool (*go_on) (void *), void *data, QnCollapseState *state,
                             QnDiag *diag);

#endif
