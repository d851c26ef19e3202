#include "doc/text/explain.h"

#include "doc/fixture.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static void
test_diag (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  const QnModel *model = &document->project.model;
  const struct {
    QnDiag diag;
    const char *expected;
  } cases[] = {
    { { .problem = QN_PROBLEM_NO_BLOCKS,
        .entity = QN_ENTITY_MODEL,
        .index = QN_NONE,
        .other = QN_NONE },
      "Model: " },
    { { .problem = QN_PROBLEM_NO_BLOCKS,
        .entity = QN_ENTITY_BLOCK,
        .index = 0,
        .other = QN_NONE },
      model->blocks[0].name },
    { { .problem = QN_PROBLEM_NO_BLOCKS,
        .entity = QN_ENTITY_BLOCK,
        .index = 0,
        .other = 1 },
      model->blocks[1].name },
    { { .problem = QN_PROBLEM_NO_BLOCKS,
        .entity = QN_ENTITY_LIVE_LOAD,
        .index = 2,
        .other = QN_NONE },
      "Live load 3: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = qn_explain_diag (model, &cases[i].diag);
    g_assert_nonnull (strstr (text, cases[i].expected));
    g_assert_nonnull (strstr (text, qn_problem_text (QN_PROBLEM_NO_BLOCKS)));
  }
  g_autofree char *half_built = qn_explain_diag (NULL, &cases[1].diag);
  g_assert_nonnull (half_built);
}

static void
test_finding (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  const QnModel *model = &document->project.model;
  QnFinding finding = {
    .problem = QN_PROBLEM_NO_BLOCKS, .block_a = 0, .block_b = 1, .value = 2e-5
  };
  g_autofree char *text = qn_explain_finding (model, &finding);
  g_assert_nonnull (strstr (text, model->blocks[0].name));
  g_assert_nonnull (strstr (text, model->blocks[1].name));
  g_assert_nonnull (strstr (text, "(0.02 mm)"));
  finding.block_b = QN_NONE;
  finding.value = 0.0;
  g_autofree char *single = qn_explain_finding (model, &finding);
  g_assert_null (strstr (single, "mm"));
}

/* The words name the multiplier, the mechanism and its motion. */
static void
test_outcome (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  const QnRun *run = solve_example (document);
  g_autofree char *outcome = qn_explain_outcome (&run->model, &run->result);
  g_assert_nonnull (strstr (outcome, "0.5"));
  g_autofree char *words =
    qn_explain_mechanism (&run->model, &run->contacts, &run->result);
  g_autofree char *brief =
    qn_explain_mechanism_briefly (&run->model, &run->contacts, &run->result);
  g_assert_nonnull (strstr (words, "verturning"));
  g_assert_nonnull (strstr (words, "block"));
  g_assert_cmpstr (brief, ==, "Overturning to the right");
  g_assert_true (g_str_has_prefix (words, brief));
  QnResult result = { .outcome = QN_OUTCOME_COLLAPSE };
  g_assert_cmpstr (qn_explain_outcome_label (&result), ==, "Collapse");
  for (int i = 0; i < QN_OUTCOME_COUNT; i++) {
    result.outcome = (QnOutcome) i;
    g_assert_cmpstr (qn_explain_outcome_label (&result), !=, "");
  }
  result.outcome = QN_OUTCOME_TARGET_REACHED;
  g_assert_cmpstr (qn_explain_outcome_label (&result), ==, "Target reached");
  result.history.width = 1;
  g_assert_cmpstr (qn_explain_outcome_label (&result), ==, "Stands");
  for (int i = 0; i < QN_PAIR_STATE_COUNT; i++)
    g_assert_cmpstr (qn_explain_pair_state ((QnPairState) i), !=, "");

  QnResult uncertain = run->result;
  uncertain.mechanism_uncertain = true;
  g_autofree char *last =
    qn_explain_mechanism_briefly (&run->model, &run->contacts, &uncertain);
  g_assert_cmpstr (last, ==, "Overturning to the right (last motion)");

  QnResult none = { 0 };
  g_assert_null (qn_explain_mechanism (&run->model, &run->contacts, &none));
}

/* Where no block moves, plastic hinges are the mechanism. */
static void
test_frame (void)
{
  g_autoptr (QnDocument) document = open_example ("32-frame-beams.quoin");
  const QnRun *run = solve_example (document);
  g_autofree char *words =
    qn_explain_mechanism (&run->model, &run->contacts, &run->result);
  g_autofree char *brief =
    qn_explain_mechanism_briefly (&run->model, &run->contacts, &run->result);
  g_assert_cmpstr (
    words, ==, "2 plastic hinges: “beam” at “left corner”, “beam” at “right corner”.");
  g_assert_cmpstr (brief, ==, "Beams fail");
}

/* A motion is told by how far a block went and when; files of earlier versions do not say when. */
static void
test_peak (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  const QnModel *model = &document->project.model;
  double peaks[] = { 0, 0.0125 };
  QnResult result = { .outcome = QN_OUTCOME_REST,
                      .block_count = model->block_count,
                      .history = {
                        .width = QN_HISTORY_TRACK, .peaks = peaks, .end = 2 } };
  g_assert_cmpuint (model->block_count, ==, 2);
  result.history.peak_time = 0.75;
  g_autofree char *text = qn_explain_outcome (model, &result);
  g_assert_nonnull (strstr (text, "Largest displacement: 12.5 mm at 0.75 s"));
  g_assert_nonnull (strstr (text, model->blocks[1].name));
  result.history.peak_time = NAN;
  g_autofree char *old = qn_explain_outcome (model, &result);
  g_assert_nonnull (strstr (old, "Largest displacement: 12.5 mm, of block"));
  peaks[1] = 0;
  g_autofree char *still = qn_explain_outcome (model, &result);
  g_assert_null (strstr (still, "displacement"));
}

/* What did not converge is what was asked for: limit analysis has no dead load to rest under. */
static void
test_not_converged (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnResult result = { .outcome = QN_OUTCOME_NOT_CONVERGED };
  QnModel model = document->project.model;

  model.analysis.procedure = QN_PROCEDURE_LIMIT;
  g_autofree char *limit = qn_explain_outcome (&model, &result);
  g_assert_nonnull (strstr (limit, "limit analysis"));
  model.analysis.procedure = QN_PROCEDURE_LOAD;
  g_autofree char *path = qn_explain_outcome (&model, &result);
  g_assert_nonnull (strstr (path, "dead load"));
}

/* A mode of vibration or of buckling is no mechanism, and is not called one. */
static void
test_modes (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  const QnModel *model = &document->project.model;
  const QnContacts *contacts = &document->contacts;
  g_autofree double *shape = g_new0 (double, QN_DOF_COUNT * model->block_count);
  shape[QN_DOF_COUNT * (model->block_count - 1)] = 1;
  QnResult result = { .mechanism = shape, .block_count = model->block_count };
  g_autofree char *mechanism = qn_explain_mechanism_briefly (model, contacts, &result);
  g_assert_cmpstr (mechanism, ==, "Sliding to the right");
  result.vibration = (QnVibration){ .dead_load = true, .mode = 2, .omega = 4 * G_PI };
  g_autofree char *loaded = qn_explain_mechanism (model, contacts, &result);
  g_assert_cmpstr (loaded, ==, "Mode 2 of vibration under dead load, 2 Hz.");
  g_autofree char *outcome = qn_explain_outcome (model, &result);
  g_assert_cmpstr (outcome, ==, "Small vibrations about an equilibrium.");
  result.vibration = (QnVibration){ 0 };
  result.stability = QN_STABILITY_LOST;
  g_autofree char *buckling = qn_explain_mechanism_briefly (model, contacts, &result);
  g_assert_cmpstr (buckling, ==, "Buckling mode, of no given size.");
}

/* Singular and plural agree, of pairs and of blocks. */
static void
test_numbers (void)
{
  const int32_t counts[QN_PAIR_STATE_COUNT] = {
    [QN_PAIR_STICK] = 1, [QN_PAIR_OPEN] = 2, [QN_PAIR_YIELD] = 1
  };
  g_autofree char *pairs = qn_explain_pairs (counts);
  g_assert_cmpstr (pairs, ==, "1 pair sticks, 2 pairs are open, 1 pair yields");
  QnBlock blocks[] = { { .name = (char *) "b12" }, { .name = (char *) "b52" } };
  const QnModel model = { .blocks = blocks, .block_count = 2 };
  const QnDiag diag = { .problem = QN_PROBLEM_BLOCKS_OVERLAP,
                        .entity = QN_ENTITY_BLOCK,
                        .index = 0,
                        .other = 1 };
  g_autofree char *words = qn_explain_diag (&model, &diag);
  g_assert_true (g_str_has_prefix (words, "Blocks “b12” and “b52”: "));
}

QN_TESTS
{
  g_test_add_func ("/doc/explain/diag", test_diag);
  g_test_add_func ("/doc/explain/peak", test_peak);
  g_test_add_func ("/doc/explain/finding", test_finding);
  g_test_add_func ("/doc/explain/outcome", test_outcome);
  g_test_add_func ("/doc/explain/frame", test_frame);
  g_test_add_func ("/doc/explain/not-converged", test_not_converged);
  g_test_add_func ("/explain/modes", test_modes);
  g_test_add_func ("/doc/explain/numbers", test_numbers);
}
