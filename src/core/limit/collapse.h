/* The engine of limit analysis: collapse of rigid blocks, the problem of interior-point.h, by its steps, which
 * lower all products s z and residuals together. v is the motion, Q the compliance of joints, z their flow.
 * Pairs are eliminated, each iteration has one factorisation of the size of the blocks.
 *
 * Associative flow, without compliance a linear program: a step goes as near to the boundary as the predictor
 * leaves of the mean product. Where there is no solution the iterate grows without end, in the direction that
 * proves it: v and z where no forces keep equilibrium under any multiplier, y and lambda where the multiplier
 * has no bound.
 *
 * With a flow of its own a small compliance decides which of many force states that reach a strength
 * is taken: the one that elastic joints of one stiffness reach. Without it blocks wedge each other. The
 * multiplier does not depend on it any more where it is small enough; how far it does is told by its
 * derivative. The curve on which all s z are equal turns back: its matrix has a determinant of the
 * wrong sign there, or a step is short because the strength of a few joints runs away with their normal
 * force. Then an iteration takes into account but a part of that, the coupling c: its matrix has
 * F' + c (G - F') in place of G. With c = 0 it is that of associative flow, symmetric and positive
 * definite. What is left out stays in the residual of G y + s = h and is taken off by later
 * iterations, so the solution is that of the equations above whatever c was; and the iterate has
 * passed to the other side of the turn.
 */
#pragma once

#include "core/base/progress.h"
#include "core/limit/interior-point-kkt.h"

typedef struct QnCollapse {
  QnIpStep ip; /* its iterate: collapse, or certificate */
  QnPool pool; /* of vectors */
  QnIpKkt kkt;
  double growth; /* of a collapse: d lambda / d log (1 / compliance), */
  double gap;    /* and what is left between forces and motion that were found in turn */
  double least_coupling;
  double least_multiplier; /* relative tolerances refer to at least this multiplier */
  bool own_flow;           /* some strength row is not associative */
  bool holds_flows;    /* set by who starts: whether such flows have a proximal term */
  QnStatistics effort; /* iterations, factorisations and factor_seconds alone */
  QnProgressFunc
    progress; /* set by who starts, nullable, with its data: told of iterations */
  void *user_data;
  bool cancelled; /* by it */

  double *given; /* rates of the cells besides those of the unknowns, cell_count x 2 */
  QnIpBound *bounds; /* of one of two programs, */
  QnIpVector kept;   /* and what the other one found */
  double *rv;        /* residual of balance, minus the left-hand side */
  double r_lambda;   /* that of the work */
  double *right_v;   /* right-hand side of balance */
} QnCollapse;

/* least_multiplier after a start. */
#define QN_COLLAPSE_LEAST 1e-4

/* Factorisations by which a program of associative flow comes to its end, if it does. */
#define QN_COLLAPSE_BUDGET 200

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

/* Starts from the iterate: from its forces, motion and multiplier. What strength these forces leave becomes
 * that of the joints; `strength` is that of a joint without any. */
void qn_collapse_centre (QnCollapse *collapse, double strength);

/* From rest as well, with a strength of the size of the forces by which joints of one stiffness would carry
 * the constant loads: one factorisation. Of associative problems. */
void qn_collapse_start_elastic (QnCollapse *collapse);

/* Iterates to a collapse with the compliance of the problem's cells and at most `budget` factorisations.
 * COLLAPSE: relative error of the multiplier <= `tolerance`. Associative: DEAD_LOAD_UNSTABLE where v and z prove
 * that no forces keep equilibrium, UNBOUNDED where y over lambda balances the live load alone. NOT_CONVERGED:
 * the budget is spent, or rounding ended the progress. is_enough (data), nullable, is called once per iteration;
 * true cancels, as `progress` does. */
QnOutcome qn_collapse_follow (QnCollapse *collapse, double tolerance, int32_t budget,
                              bool (*is_enough) (void *), void *data);

/* From an iterate that was lost, by two convex programs in turn:
 *
 *     motion and flow of least dissipation where the normal forces give the strength of shear,
 *     forces and multiplier of least excess dissipation under this motion and flow.
 *
 * Both lower the same gap, z'(h - Gy) + 1/2 |Qy - q|^2 in the metric of Q, q the rates that motion and flow leave to
 * the compliance: 0 at a collapse. Forces end in equilibrium and within their strength, motion and flow obey the
 * rates, and COLLAPSE is told where the gap is at most `tolerance` of the work of the live load; or, while joints
 * still give so much that the multiplier is not known as well, the geometric mean of that and of the work that they
 * store. */
QnOutcome qn_collapse_alternate (QnCollapse *collapse, double tolerance, int32_t budget);

/* Whether v and z of the iterate prove that no forces keep equilibrium under any multiplier: the dead
 * load does more power along v than the joints can dissipate, and the live load none. `problem`: that of
 * the engine, or its first groups, cells and bounds alone. */
bool qn_collapse_proves_infeasible (const QnCollapse *collapse,
                                    const QnIpProblem *problem);

/* Forces in equilibrium. */
typedef struct QnCollapseForces {
  double *y; /* cell_count x 2 */
  double lambda;
  double residual; /* the largest |By + lambda f + d| */
  double slack;    /* the smallest h - Gy, INFINITY without bounds */
} QnCollapseForces;

/* Those nearest to the forces of the iterate, in the metric of its barrier: a by-product of the last
 * factorisation, at the price of a few solves. forces->lambda in: the required multiplier; out: unchanged where
 * `fixed`, else the nearest one in the metric. Where nothing is left out of balance, slack >= 0 proves that this
 * multiplier can be carried. Towards the optimum the metric becomes flat: request a fixed multiplier early. */
void qn_collapse_project (QnCollapse *collapse, bool fixed, QnCollapseForces *forces);
