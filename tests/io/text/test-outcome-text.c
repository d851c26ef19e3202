#include "io/text/outcome-text.h"

#include "support/models.h"
#include "support/room.h"

#include <string.h>

/* With broken bonds the associative bound is safe where joints are associative, and is not called so where they
 * slide with less dilatancy than friction. */
static void
test_broken_bond (void)
{
  QnModel model;
  QnResult result = { .outcome = QN_OUTCOME_COLLAPSE,
                      .has_associative_bound = true,
                      .associative_bound = 1.4,
                      .has_broken_bound = true,
                      .broken_bound = 1.1 };
  test_model_init (&model);
  model.laws[0].cohesion = 1e4;
  qn_result_add_solution (&result, (QnSolution){ .multiplier = 0.6 });
  for (int associative = 0; associative < 2; associative++) {
    model.laws[0].dilatancy = associative ? model.laws[0].friction : 0;
    g_autofree char *text = qn_outcome_dup_interval (&model, &result);
    g_assert_nonnull (strstr (text, "1.1000"));
    g_assert_cmpint (strstr (text, "only that is safe") != NULL, ==, associative);
    g_assert_cmpint (strstr (text, "may carry less") != NULL, ==, !associative);
  }
  qn_model_clear (&model);
}

/* Few pairs at joints by area that open in large displacements are told; none that stay closed, many pairs,
 * joints per pair or linear geometry. */
static void
test_coarse_pairs (void)
{
  QnModel model;
  QnPairResult pairs[] = { { .state = QN_PAIR_STICK }, { .state = QN_PAIR_OPEN } };
  QnResult result = { .outcome = QN_OUTCOME_COLLAPSE,
                      .has_associative_bound = true,
                      .associative_bound = 0.8,
                      .pairs = pairs,
                      .pair_count = G_N_ELEMENTS (pairs) };
  test_model_init (&model);
  qn_result_add_solution (&result, (QnSolution){ .multiplier = 0.6 });
  for (int other = 0; other < 5; other++) {
    model.analysis.geometry = other == 1 ? QN_GEOMETRY_LINEAR : QN_GEOMETRY_NONLINEAR;
    model.laws[0].basis = other == 2 ? QN_BASIS_CONTACT : QN_BASIS_SURFACE;
    model.contact.pairs =
      (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = other == 3 ? 9 : 5 };
    pairs[1].state = other == 4 ? QN_PAIR_SLIP : QN_PAIR_OPEN;
    g_autofree char *text = qn_outcome_dup_interval (&model, &result);
    g_assert_cmpint (strstr (text, "5 pairs") != NULL, ==, other == 0);
  }
  qn_model_clear (&model);
}

QN_TESTS
{
  g_test_add_func ("/outcome-text/coarse-pairs", test_coarse_pairs);
  g_test_add_func ("/outcome-text/broken-bond", test_broken_bond);
}
