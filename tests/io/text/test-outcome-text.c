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

/* Few pairs at joints by area that open in large displacements, or have a bond, are told; none that stay
 * closed, many pairs, joints per pair or linear geometry without a bond. */
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
  for (int other = 0; other < 6; other++) {
    model.analysis.geometry =
      other == 1 || other == 5 ? QN_GEOMETRY_LINEAR : QN_GEOMETRY_NONLINEAR;
    model.laws[0].tension = other == 5 ? 1e4 : 0;
    model.laws[0].basis = other == 2 ? QN_BASIS_CONTACT : QN_BASIS_SURFACE;
    model.contact.pairs =
      (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = other == 3 ? 9 : 5 };
    pairs[1].state = other == 4 ? QN_PAIR_SLIP : QN_PAIR_OPEN;
    g_autofree char *text = qn_outcome_dup_interval (&model, &result);
    g_assert_cmpint (strstr (text, "5 pairs") != NULL, ==, other == 0 || other == 5);
  }
  qn_model_clear (&model);
}

/* How every analysis may end, and words of the sentence that says so. */
static void
test_reasons (void)
{
  enum {
    NOTHING,
    NONLINEAR,
    ASSOCIATIVE,
    BOUND,
    UNCERTAIN,
    NO_STEPS,
    FALLEN,
    ENDS,
    IDLE
  };
  static const struct {
    const char *words;
    QnOutcome outcome;
    QnProcedure procedure;
    QnStop stop;
    int with;
  } cases[] = {
    { "was not determined", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_LOAD, 0, UNCERTAIN },
    { "held a little above", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_LOAD, QN_STOP_FALL, 0 },
    { "along its mechanism", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_LOAD, 0, 0 },
    { "No forces that", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_LIMIT, 0, ASSOCIATIVE },
    { "lowest multiplier found", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_LIMIT, 0, 0 },
    { "fall out of", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_DISPLACEMENT, QN_STOP_FALL, 0 },
    { "nothing of the load", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_WORK, 0, FALLEN },
    { "under a constant load", QN_OUTCOME_COLLAPSE, QN_PROCEDURE_ARC_LENGTH, 0, 0 },
    { "its end value of 0.5", QN_OUTCOME_TARGET_REACHED, QN_PROCEDURE_LOAD, 0, ENDS },
    { "target was reached", QN_OUTCOME_TARGET_REACHED, QN_PROCEDURE_LOAD, 0, 0 },
    { "No live load acts", QN_OUTCOME_TARGET_REACHED, QN_PROCEDURE_LOAD, 0, IDLE },
    { "first limit point", QN_OUTCOME_SNAP, QN_PROCEDURE_LOAD, 0, 0 },
    { "associative theorem", QN_OUTCOME_UNBOUNDED, QN_PROCEDURE_LIMIT, 0, 0 },
    { "by its own size", QN_OUTCOME_UNBOUNDED, QN_PROCEDURE_LOAD, 0, NONLINEAR },
    { "No collapse up to", QN_OUTCOME_UNBOUNDED, QN_PROCEDURE_LOAD, 0, 0 },
    { "Cancelled at a load", QN_OUTCOME_CANCELLED, QN_PROCEDURE_LOAD, 0, 0 },
    { "refused a part", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LOAD, QN_STOP_CHECK, 0 },
    { "with the dilatancy", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LIMIT, 0, BOUND },
    { "max_factorizations", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_WORK,
      QN_STOP_FACTORIZATIONS, 0 },
    { "max_seconds", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LOAD, QN_STOP_TIME, 0 },
    { "optimisation", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LIMIT, 0, 0 },
    { "nor clearly falls", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LOAD, 0, NO_STEPS },
    { "neither an", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_LOAD, 0, 0 },
    { "largest number", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_WORK, QN_STOP_STEPS, 0 },
    { "shortest step", QN_OUTCOME_NOT_CONVERGED, QN_PROCEDURE_WORK, 0, 0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const int with = cases[i].with;
    QnModel model;
    QnStep step = { .multiplier = with == FALLEN ? 0 : 0.5 };
    QnResult result = { .outcome = cases[i].outcome,
                        .stop = cases[i].stop,
                        .steps = &step,
                        .step_count = with == NO_STEPS ? 0 : 1,
                        .mechanism_uncertain = with == UNCERTAIN,
                        .has_associative_bound = with == BOUND };
    test_model_init_wall (&model, 1, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    model.analysis.procedure = cases[i].procedure;
    model.analysis.flow =
      with == ASSOCIATIVE ? QN_FLOW_ASSOCIATIVE : QN_FLOW_NON_ASSOCIATIVE;
    model.analysis.geometry =
      with == NONLINEAR ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    model.analysis.max_multiplier = with == ENDS ? 0.5 : INFINITY;
    model.live_load_count = with == IDLE ? 0 : model.live_load_count;
    g_autofree char *text = qn_outcome_dup_reason (&model, &result);
    if (strstr (text, cases[i].words) == NULL)
      g_error ("%s: %s", cases[i].words, text);
    qn_model_clear (&model);
  }
}

/* The same for analyses in time. */
static void
test_reasons_in_time (void)
{
  static const struct {
    const char *words;
    QnOutcome outcome;
    QnStop stop;
  } cases[] = {
    { "Overturned at 2 s", QN_OUTCOME_COLLAPSE, 0 },
    { "end of the duration, 3 s", QN_OUTCOME_TARGET_REACHED, 0 },
    { "At rest at 3 s", QN_OUTCOME_REST, 0 },
    { "Cancelled at 3 s", QN_OUTCOME_CANCELLED, 0 },
    { "refused a part", QN_OUTCOME_NOT_CONVERGED, QN_STOP_CHECK },
    { "max_factorizations", QN_OUTCOME_NOT_CONVERGED, QN_STOP_FACTORIZATIONS },
    { "max_seconds", QN_OUTCOME_NOT_CONVERGED, QN_STOP_TIME },
    { "no step converged", QN_OUTCOME_NOT_CONVERGED, 0 },
  };
  QnModel model;
  test_model_init_wall (&model, 1, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnResult result = { .outcome = cases[i].outcome,
                        .stop = cases[i].stop,
                        .linearity = QN_LINEARITY_BEYOND,
                        .history = { .width = 1, .collapse_time = 2, .end = 3 } };
    g_autofree char *text = qn_outcome_dup_reason (&model, &result);
    if (strstr (text, cases[i].words) == NULL)
      g_error ("%s: %s", cases[i].words, text);
    g_assert_nonnull (strstr (text, "a tenth of their least width"));
  }
  qn_model_clear (&model);
}

QN_TESTS
{
  g_test_add_func ("/outcome-text/reasons", test_reasons);
  g_test_add_func ("/outcome-text/reasons-in-time", test_reasons_in_time);
  g_test_add_func ("/outcome-text/coarse-pairs", test_coarse_pairs);
  g_test_add_func ("/outcome-text/broken-bond", test_broken_bond);
}
