/* Associative limit analyses of models that differ in numbers alone: friction, cohesion, weights,
 * loads, small changes of shape. They share the structure of the program and the order of
 * elimination; every answer is that of qn_limit_associative() for its model alone.
 */
#ifndef QN_CORE_LIMIT_SERIES_H
#define QN_CORE_LIMIT_SERIES_H

#include "core/limit/limit.h"

typedef struct QnLimitSeries {
  QnLimitProblem limit; /* numbers of the last model, structure of the first */
  QnCollapse engine;
} QnLimitSeries;

/* Analyses the structure of the model that the others are like. `series` is overwritten without being
 * cleared, and must stay where it is until _clear(). */
QnStatus qn_limit_series_init (QnLimitSeries *series, const QnModel *model,
                               const QnContacts *contacts, QnDiag *diag);
void qn_limit_series_clear (QnLimitSeries *series);

/* As qn_limit_associative(); models of another structure are solved by themselves. */
QnStatus qn_limit_series_solve (QnLimitSeries *series, const QnModel *model,
                                const QnContacts *contacts, QnProgressFunc progress,
                                void *user_data, QnLimitSolution *solution, QnDiag *diag);

#endif
