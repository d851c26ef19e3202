/* A model with what is computed of it. */
#pragma once

#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "support/auto-clear.h"

typedef struct TestRun {
  QnModel model; /* filled by the test */
  QnContacts contacts;
  QnResult result;
} TestRun;

/* Prepares the model and detects its contacts; also analyses it by its own settings. Any error
 * fails the test. */
void test_run_prepare (TestRun *run);
void test_run_solve (TestRun *run);

/* The same of a model alone. */
void test_analyse (QnModel *model, QnResult *result);

/* What an analysis prescribes: of a block by its name, NULL: none. */
void test_control (QnModel *model, QnProcedure procedure, const char *block, QnDof dof,
                   double target);

/* How many statements of the result its check finds to be false. */
int test_run_count_faults (const TestRun *run);

/* Whether it finds a statement of this kind to be false. */
gboolean test_run_tells (const TestRun *run, QnClaim claim);

/* Prepares the model and finds the lowest modes about its equilibrium under dead load. */
void test_find_modes (QnModel *model, size_t wanted, QnModes *modes);

/* Clears the model too. */
void test_run_clear (TestRun *run);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (TestRun, test_run_clear)
