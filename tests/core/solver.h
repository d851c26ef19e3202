/* Setting up the solver on test models. */
#pragma once

#include "core/equilibrium/equilibrium.h"
#include "support/models.h"

#include <glib.h>

typedef struct Solver {
  QnModel model;
  QnContacts contacts;
  QnEquilibrium equilibrium;
} Solver;

/* Takes over the model. */
static inline void
solver_init (Solver *solver, QnModel *model)
{
  QnDiag diag;
  solver->model = *model;
  g_assert_cmpint (qn_model_prepare (&solver->model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&solver->model, &solver->contacts, &diag), ==,
                   QN_OK);
  g_assert_cmpint (qn_equilibrium_setup (&solver->equilibrium, &solver->model,
                                         &solver->contacts, NULL, NULL, &diag),
                   ==, QN_OK);
}

static inline void
solver_clear (Solver *solver)
{
  qn_equilibrium_clear (&solver->equilibrium);
  qn_contacts_clear (&solver->contacts);
  qn_model_clear (&solver->model);
}

/* Newton, or relaxation, at a multiplier. */
static inline QnSolveStatus
newton (QnEquilibrium *eq, double multiplier)
{
  const QnTarget target = qn_target_multiplier (multiplier);
  return qn_equilibrium_newton (eq, &target, 0, 20);
}

static inline QnSolveStatus
relax (QnEquilibrium *eq, double multiplier)
{
  const QnTarget target = qn_target_multiplier (multiplier);
  return qn_equilibrium_relax (eq, NULL, &target, INFINITY, NULL, 300);
}
