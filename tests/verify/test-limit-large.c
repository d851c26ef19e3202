/* Limit analysis of a wall of ten thousand blocks, with both certificates summed up outside the
 * solver: the optimum is proved, whatever the way to it. */
#include "core/limit/limit.h"
#include "support/auto-clear.h"
#include "support/certificate.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>

static void
test_ten_thousand (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;

  test_bond_init (&model, TEST_UNIT, 66, 150, 0, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpuint (model.block_count, >, 9900);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (solution.effort.factorizations, <, 80);
  test_assert_certified (&model, &contacts, &solution);
}

QN_TESTS
{
  g_test_add_func ("/verify/limit-large/ten-thousand", test_ten_thousand);
}
