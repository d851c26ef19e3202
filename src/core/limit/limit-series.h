/* Associative limit analyses of models that differ in numbers alone: friction, cohesion, weights,
 * loads, small changes of shape. They share the structure of the program, the order of elimination
 * and an iterate half way to the optimum, from which every analysis starts: so the answer to a model
 * does not depend on those before it, but for rounding it is that of qn_limit_associative().
 */
#ifndef QN_CORE_LIMIT_SERIES_H
#define QN_CORE_LIMIT_SERIES_H

#include "core/limit/limit.h"

typedef struct QnLimitSeries {
  QnLimitProblem limit; /* numbers of the last model, structure of the first */
  QnInteriorPoint ip;
  QnLimitStart start;
  bool ready; /* the first model has an optimum to start from */
} QnLimitSeries;

/* Solves the model that the others are like. Where it has no optimum, the others are solved one by
 * one. `series` is overwritten without being cleared, and must stay where it is until _clear(). */
QnStatus qn_limit_series_init (QnLimitSeries *series, const QnModel *model,
                               const QnContacts *contacts, QnDiag *diag);
void qn_limit_series_clear (QnLimitSeries *series);

/* As qn_limit_associative(); models of another structure are solved by themselves. */
QnStatus qn_limit_series_solve (QnLimitSeries *series, const QnModel *model,
                                const QnContacts *contacts, QnProgressFunc progress,
                                void *user_data, QnLimitSolution *solution, QnDiag *diag);

#endif
