/* The limit-analysis program of a model, in the scaled terms of the interior-point engine.
 *
 * One cell per contact pair that touches a free block, holding the pair's normal and shear
 * force (tension positive, tangent as in contacts.h); its bounds are the strengths of the two
 * springs in series, that is the intersection of what their laws allow
 * (qn_spring_rigid_strength()). Ties are further cells, of a normal force between 0 and their strength.
 *
 * Without friction and cohesion there is no shear, and the cell is marked. Stiffness plays no part.
 * Forces are divided by `force_unit`, lengths by `length_unit`, the live load by its own
 * `load_unit`; equilibrium rows of supported degrees of freedom do not exist.
 */
#pragma once

#include "core/contact/contacts.h"
#include "core/limit/collapse.h"

typedef struct QnLimitProblem {
  QnIpProblem ip;
  QnCollapse engine; /* of it */
  QnPool pool;       /* of all arrays */
  QnId *cell_pairs;  /* contact pair of every cell; ties count on behind the pairs */
  int32_t *rows;     /* block_count x 3: equilibrium row, or -1 where supported */
  double *mass; /* block_count x 3: inertia of every degree of freedom, scaled; > 0 */
  size_t block_count, pair_count; /* the ties with the pairs */
  bool own_flow;                  /* joints flow as their laws say; else associatively */
  double force_unit;              /* N */
  double length_unit;             /* m */
  double load_unit;               /* N; multiplier = lambda x force_unit / load_unit */
} QnLimitProblem;

/* `limit` is overwritten without being cleared, and not to be moved. A model none of whose free blocks carries
 * a live load is refused (NO_LIVE_LOAD). */
QnStatus qn_limit_problem_init (QnLimitProblem *limit, const QnModel *model,
                                const QnContacts *contacts, bool own_flow, QnDiag *diag);

void qn_limit_problem_clear (QnLimitProblem *limit);

/* The multiplier that a scaled lambda stands for, and back. */
double qn_limit_problem_multiplier (const QnLimitProblem *limit, double lambda);

/* Scaled unknowns to model quantities; unset pairs and supported degrees become 0.
 * forces: pair_count x 2, N, per so many of the scaled ones; velocities: block_count x 3. */
void qn_limit_problem_forces (const QnLimitProblem *limit, const double *y, double per,
                              double *forces);
void qn_limit_problem_velocities (const QnLimitProblem *limit, const double *v,
                                  double *velocities);
