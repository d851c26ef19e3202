/* The problem that the interior-point engine (collapse.h) solves, and products with its matrices:
 * structures of rigid bodies joined by plane joints.
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
 */
#pragma once

#include "core/base/memory.h"
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
  const QnIpGroup *groups;
  const QnIpCell *cells;
  const QnIpBound *bounds; /* cell by cell */
  const double *constant;  /* d, row_count */
  const double *load; /* f, row_count; NULL: no multiplier, lambda = 0, load_gain = 0 */
  double load_gain;   /* > 0 with a load */
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

/* From a pool. */
void qn_ip_vector_init (QnIpVector *vector, const QnIpProblem *problem, QnPool *pool);

/* to += part * step */
void qn_ip_vector_add (QnIpVector *to, double part, const QnIpVector *step,
                       const QnIpProblem *problem);

/* out (row_count) = B y + lambda f + d */
void qn_ip_balance (const QnIpProblem *problem, const double *y, double lambda,
                    double *out);

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

double qn_ip_quadratic_term (const QnIpProblem *problem, const double *y); /* y'Qy */
double qn_ip_limit_term (const QnIpProblem *problem, const double *z);     /* h'z */
double qn_ip_largest (const double *values, int32_t count); /* largest |value|, or NaN */
