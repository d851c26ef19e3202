/* A block on a plane in an equilibrium found by hand, as a result.
 *
 * The project is test_project_text: a block of 1 m x 1 m and 10 kN on a fixed base. At
 * multiplier 0.2 the live load is 2 kN at half height; it overturns with 1 kN m, so that the
 * left pair carries 4 kN and the right pair 6 kN, each with half of the shear. */
#pragma once

#include "core/result/result.h"
#include "io/project/project.h"

typedef struct ResultFixture {
  QnProject project;
  QnContacts contacts;
  QnResult result; /* two steps, a mechanism, statistics */
} ResultFixture;

void result_fixture_set_up (ResultFixture *fixture, gconstpointer data);
void result_fixture_tear_down (ResultFixture *fixture, gconstpointer data);

/* Adds a test, void test (ResultFixture *, gconstpointer), that gets one. */
#define RESULT_FIXTURE_ADD(path, test)                                                   \
  g_test_add (path, ResultFixture, NULL, result_fixture_set_up, test,                    \
              result_fixture_tear_down)

/* The result file of the fixture as text; free with g_free(). */
char *result_fixture_dup_text (const ResultFixture *fixture);
