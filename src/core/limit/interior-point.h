/* Interior-point engine for structures of rigid bodies joined by plane joints.
 *
 * Solves, with the structure of such problems built in, the convex quadratic program
 *
 *     minimise    1/2 y'Qy - load_gain lambda
 *     such that   B y + lambda f + d = 0      equilibrium, one row per free degree of freedom
 *                 G y + s = h,  s >= 0        strength
 *
 * over the joint forces y and the (free) multiplier lambda. Forces come in cells of two
 * (normal, tangential); Q is diagonal and every row of G belongs to one cell. Cells come in
 * groups that act on the same rows (the cells of one face between two bodies), so that
 *
 *     M = B H^-1 B',   H = Q + G' diag (z/s) G   (2 x 2 per cell, inverted in closed form)
 *
 * has the sparsity of the graph of bodies. It is the only matrix ever factorised: symbolic
 * analysis once per structure, one factorisation per iteration.
 *
 * The dual variables are v (one per row; with load_gain = 1 a velocity field with f'v = 1)
 * and z >= 0 (one per strength row): Qy + B'v + G'z = 0 and f'v = load_gain.
 *
 * Method: homogeneous embedding (Ye, Todd & Mizuno 1994 for linear, Goulart & Chen 2024 for
 * quadratic programs), Mehrotra's predictor and corrector, Gondzio's centrality correctors. It ends
 * with an optimum or with a certificate that there is none, and never diverges:
 *
 *   no forces at all keep equilibrium: v, z >= 0 with B'v + G'z = 0, f'v = 0, d'v - h'z > 0
 *   the multiplier has no bound:       y, lambda with By + lambda f = 0, Gy <= 0, Qy = 0 and
 *                                      load_gain lambda > 0
 *
 * Cells whose strength rows leave a direction free, redundant or empty equilibrium rows are
 * allowed. The caller scales: forces, lengths, f and d should be of the order of 1.
 */
#ifndef QN_CORE_INTERIOR_POINT_H
#define QN_CORE_INTERIOR_POINT_H

#include "core/base/status.h"
#include "core/base/workers.h"

/* Rows on which one group of cells acts: three of each of the two bodies. */
#define QN_IP_GROUP_ROWS 6

/* One place where two bodies exchange a force (y_n, y_t). */
typedef struct QnIpCell {
  double map[QN_IP_GROUP_ROWS]
            [2];       /* its columns of B; entries for absent rows are unused */
  double quadratic[2]; /* diagonal of Q, >= 0 */
  int32_t first_bound; /* into QnIpProblem.bounds */
  int32_t bound_count; /* >= 0 */
  bool no_shear;       /* y_t is identically 0 */
} QnIpCell;

typedef struct QnIpGroup {
  int32_t
    rows[QN_IP_GROUP_ROWS]; /* row of B, or -1 where the degree of freedom is fixed */
  int32_t first_cell;       /* groups partition the cells in order */
  int32_t cell_count;
} QnIpGroup;

/* One row of G and h: normal y_n + shear y_t <= limit. */
typedef struct QnIpBound {
  double normal;
  double shear;
  double limit;
  double opening; /* its flow is (opening, shear): associative where opening = normal */
} QnIpBound;

/* The numbers may change between solves; counts, rows and first_ indices may not. */
typedef struct QnIpProblem {
  int32_t row_count, group_count, cell_count, bound_count;
  const QnIpGroup *groups;
  const QnIpCell *cells;
  const QnIpBound *bounds;  /* cell by cell */
  const double *constant;   /* d, row_count */
  const double *load;       /* f, row_count; NULL: no multiplier, lambda = 0 */
  double load_gain;         /* 1: maximise lambda; 0: any feasible lambda */
  const QnWorkers *workers; /* borrowed; may be NULL */
} QnIpProblem;

typedef enum {
  QN_IP_RUNNING,
  QN_IP_OPTIMAL,
  QN_IP_INFEASIBLE, /* no equilibrium: v and z hold the certificate */
  QN_IP_UNBOUNDED,  /* the multiplier has no bound: y and lambda hold the certificate */
  QN_IP_STALLED, /* no further progress; the iterate and its measures are the best known */
  QN_IP_STATE_COUNT
} QnIpState;

typedef struct QnIpSettings {
  double tolerance; /* relative residuals and gap of an optimum */
  int32_t max_iterations;
  int32_t correctors; /* most centrality correctors per iteration, 0 … 10 */
  bool
    hasten; /* the last iterations step almost to the boundary: about three fewer, less central */
} QnIpSettings;

/* Measures of the last iterate, after division by tau. */
typedef struct QnIpMeasures {
  double
    primal_residual; /* largest |By + lambda f + d|, relative to 1 + largest |d|, |f| */
  double dual_residual; /* largest |Qy + B'v + G'z|, relative to 1 + largest |v| */
  double gap;           /* of the objectives, relative to 1 + their size */
} QnIpMeasures;

/* A point or a direction of the homogeneous space: divide by tau to read a solution. */
typedef struct QnIpVector {
  double *y; /* cell_count x 2: normal, shear */
  double *v; /* row_count */
  double *s; /* bound_count */
  double *z; /* bound_count */
  double lambda, tau, kappa;
} QnIpVector;

typedef struct QnInteriorPointWork QnInteriorPointWork;

typedef struct QnInteriorPoint {
  QnIpState state;
  int32_t iterations;
  int32_t factorizations;
  double factor_seconds; /* spent in factorising and solving, s */
  QnIpMeasures measures;
  QnIpVector at;             /* the iterate (or certificate) */
  QnInteriorPointWork *work; /* owned */
} QnInteriorPoint;

/* tolerance 1e-9, 200 iterations, 6 correctors, not hastened. */
QnIpSettings qn_interior_point_defaults (void);

/* Analyses the structure and allocates everything. `problem` is borrowed until _clear().
 * `ip` is overwritten without being cleared. */
QnStatus qn_interior_point_init (QnInteriorPoint *ip, const QnIpProblem *problem,
                                 const QnIpSettings *settings, QnDiag *diag);

/* Starting point for the problem's present numbers; resets the counters. */
QnStatus qn_interior_point_start (QnInteriorPoint *ip, QnDiag *diag);

/* Starts from an iterate of a problem of the same structure with other numbers instead, in place of
 * about half of the iterations. It must lie well inside: of a solution that has converged the
 * multipliers of bounds that are not reached are too small to grow again. */
void qn_interior_point_start_from (QnInteriorPoint *ip, const QnIpVector *iterate);

/* From an optimum on to a finer tolerance, until the next start. */
void qn_interior_point_refine (QnInteriorPoint *ip, double tolerance);

/* Copies the iterate; `copy` is zeroed before the first time, and freed by _clear(). */
QnStatus qn_interior_point_keep (const QnInteriorPoint *ip, QnIpVector *copy,
                                 QnDiag *diag);
bool qn_ip_vector_init (QnIpVector *vector, const QnIpProblem *problem);
void qn_ip_vector_clear (QnIpVector *vector);

/* One iteration; ip->state then says whether to continue. */
QnStatus qn_interior_point_iterate (QnInteriorPoint *ip, QnDiag *diag);

/* Forces in equilibrium nearest to y (cell_count x 2, in and out, not homogeneous) in the metric
 * of the present iterate's barrier: a by-product of the last factorisation, at the price of a
 * few solves.
 *
 * *lambda in: the required multiplier; out: unchanged where `fixed`, else the nearest one in the
 * metric. *residual is the largest remaining |By + lambda f + d|, *slack the smallest h - Gy
 * (INFINITY without bounds); slack >= 0 proves that this multiplier can be carried. Towards the
 * optimum the metric becomes flat: request a fixed multiplier early. */
QnStatus qn_interior_point_restore (QnInteriorPoint *ip, bool fixed, double *lambda,
                                    double *y, double *residual, double *slack,
                                    QnDiag *diag);

/* The same, nearest to the present iterate; y is out alone. */
QnStatus qn_interior_point_project (QnInteriorPoint *ip, bool fixed, double *lambda,
                                    double *y, double *residual, double *slack,
                                    QnDiag *diag);

/* out = B y + lambda f + tau d */
void qn_interior_point_balance (const QnIpProblem *problem, const double *y,
                                double lambda, double tau, double *out);

/* rates (cell_count x 2) = -B'v: elongation rates of the cells under velocities v. */
void qn_interior_point_rates (const QnIpProblem *problem, const double *v, double *rates);

void qn_interior_point_clear (QnInteriorPoint *ip);

#endif
