/* The interior-point engine of limit analysis (core/limit/collapse.h) and of increments (central-path.h): the
 * problem, products with its matrices, and the step. Bodies are joined by plane joints.
 *
 *     B y + lambda f + d = 0      equilibrium, one row per free degree of freedom
 *     G y + s = h,  s >= 0        strength
 *     Q y + B'v + F z = 0         rates of the joints under the velocities v
 *     s z = 0,  z >= 0            flow only at the strength
 *     f'v = load_gain
 *
 * over the joint forces y and the (free) multiplier lambda. Forces come in cells of two
 * (normal, tangential); Q is diagonal and every row of G belongs to one cell. Cells come in
 * groups that act on the same rows (the cells of one face between two bodies), so that
 *
 *     M = B H^-1 B',   H = Q + F diag (z/s) G   (2 x 2 per cell, inverted in closed form)
 *
 * has the sparsity of the graph of bodies.
 *
 * Where flow is associative, F = G', these are the conditions of the optimum of
 *
 *     minimise 1/2 y'Qy - load_gain lambda  such that  B y + lambda f + d = 0,  G y <= h.
 *
 * Cells whose strength rows leave a direction free, redundant or empty equilibrium rows are
 * allowed. The caller scales: forces, lengths, f and d should be of the order of 1.
 *
 * Of an increment the engine knows cells and bounds alone; balance, large displacements and whatever has no
 * strength are the assembly's.
 *
 * Steps: Mehrotra's predictor and corrector (Mehrotra 1992), Gondzio's centrality correctors (Gondzio 1996).
 */
#pragma once

#include "core/base/memory.h"
#include "core/base/status.h"
#include "core/base/workers.h"

/* Rows on which one group of cells acts: three of each of the two bodies. */
#define QN_IP_GROUP_ROWS 6

/* One place where two bodies exchange a force (y_n, y_t). */
typedef struct QnIpCell {
  double quadratic[2]; /* diagonal of Q, >= 0 */
  int32_t first_bound; /* into QnIpProblem.bounds */
  int32_t bound_count; /* >= 0 */
  bool no_shear;       /* y_t is identically 0 */
  double map[QN_IP_GROUP_ROWS]
            [2]; /* its columns of B; entries for absent rows are unused */
} QnIpCell;

typedef struct QnIpGroup {
  int32_t rows[QN_IP_GROUP_ROWS]; /* of B, or -1 where the freedom is fixed */
  int32_t first_cell;             /* groups partition the cells in order */
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
  QnIpGroup *groups;
  QnIpCell *cells;
  QnIpBound *bounds; /* cell by cell */
  double *constant;  /* d, row_count */
  double *load;      /* f, row_count; NULL: no multiplier, lambda = 0, load_gain = 0 */
  double load_gain;  /* > 0 with a load */
  const QnWorkers *workers; /* borrowed; may be NULL */
} QnIpProblem;

/* A point or a direction. */
typedef struct QnIpVector {
  double *y; /* cell_count x 2: normal, shear */
  double *v; /* row_count */
  double *s; /* bound_count */
  double *z; /* bound_count */
  double lambda;
} QnIpVector;

/* What steers steps; parts. */
typedef struct QnIpTuning {
  double
    exponent; /* of what the predictor leaves of the mean product, for the one aimed at */
  double least_aim;   /* of the mean product, in one step */
  int32_t correctors; /* of centrality, for steps shorter than `full_step` */
  double full_step;
  double spread; /* of products about their mean: correctors bring them within */
  double gain;   /* of length, by a corrector that is worth another */
} QnIpTuning;

/* The inverse of H, cell by cell. */
typedef struct QnIpInverse {
  double *cells; /* cell_count x 4: by rows and … */
  double *axes;  /* cell_count x 2 and … */
  double
    *turns; /* bound_count: factors of the same inverse as a sum without cancellation,
                    diag (axes) + sum of turn g^ f^' */
  double *normals;       /* bound_count: G's columns of normal forces, as coupled */
  double regularization; /* r, on the diagonal of H */
  double coupling;       /* G in it is F' + coupling (G - F'); 1: exact */
} QnIpInverse;

/* An iterate with what the next step is found from. */
typedef struct QnIpStep QnIpStep;
struct QnIpStep {
  const QnIpProblem *problem; /* borrowed */
  const QnIpTuning *tuning;
  bool together;   /* residuals are lowered at the rate of the products */
  double proximal; /* term of flows in their strengths: G y + s - term dz = h */
  QnIpVector at, step, trial;
  double *ry, *rz;  /* residuals, minus the left-hand sides */
  double *products; /* right-hand side of s dz + z ds */
  double *right;    /* that of the rates: share x ry less the flows of unchanged forces */
  double power;     /* s'z */
  double *w;        /* bound_count: z / s, less with a proximal term */
  QnIpInverse inverse;
  /* Sets y, v, lambda of a step that takes `share` off the residuals, from `right`, and s = G y. */
  void (*solve) (QnIpStep *, double share, QnIpVector *out);
};

/* Allocates the vectors, for the counts that the problem has now. */
void qn_ip_step_init (QnIpStep *ip, const QnIpProblem *problem, const QnIpTuning *tuning,
                      QnPool *pool);

/* rz and the power of the iterate. */
void qn_ip_step_measure (QnIpStep *ip);

/* The weights of the iterate; and the inverse of one cell for these. */
void qn_ip_step_weights (QnIpStep *ip);
void qn_ip_step_invert (QnIpStep *ip, int32_t cell);

/* y += dy = (H+r)^-1 (normal, shear), s += G dy for one cell. A row's own part of dy is at right
 * angles to it and left out of its s. */
void qn_ip_step_answer (const QnIpStep *ip, int32_t cell, double normal, double shear,
                        QnIpVector *out);

/* ip->step: lowers the products as far as the predictor says. Returns how much of it may be gone until some s
 * or z vanishes; *part: what it leaves of the products. */
double qn_ip_step_find (QnIpStep *ip, double *part);

/* From a pool. */
void qn_ip_vector_init (QnIpVector *vector, const QnIpProblem *problem, QnPool *pool);

void qn_ip_vector_copy (QnIpVector *to, const QnIpVector *from,
                        const QnIpProblem *problem);

/* to += part * step */
void qn_ip_vector_add (QnIpVector *to, double part, const QnIpVector *step,
                       const QnIpProblem *problem);

/* out (row_count) += scale * B y */
void qn_ip_add_forces (const QnIpProblem *problem, const double *y, double scale,
                       double *out);

/* out (cell_count x 2) += scale * B'v */
void qn_ip_add_rates (const QnIpProblem *problem, const double *v, double scale,
                      double *out);

/* out (bound_count) = G y */
void qn_ip_apply_bounds (const QnIpProblem *problem, const double *y, double *out);

/* out (cell_count x 2) += scale F z, the flows of the bounds */
void qn_ip_add_flows (const QnIpProblem *problem, const double *z, double scale,
                      double *out);

/* values += factor * step */
void qn_ip_add_multiple (double *values, double factor, const double *step,
                         int32_t count);

double qn_ip_largest (const double *values, int32_t count); /* largest |value|, or NaN */
