/* One case: its outputs are those of the project with these values. */
#include "study/cases/case.h"

#include "core/limit/limit.h"
#include "io/text/text-format.h"
#include "study/fixture.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <math.h>

#define PLAN "{ \"kind\": \"monte-carlo\", \"count\": 10 }"

static void
test_outputs (void)
{
  g_auto (QnStudy) study;
  g_auto (QnCaseResult) result;
  const double values[] = { 0.37, 12000 };
  fixture_study (&study, PLAN, "");
  qn_case_solve (&study, values, NULL, NULL, &result);
  g_assert_false (result.failed);
  g_assert_cmpstr (result.outcome, ==, "collapse");
  g_assert_cmpstr (result.mechanism, ==, "sliding");
  g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER], 0.37,
                                  1e-6);
  g_assert_true (isnan (result.numbers[QN_STUDY_UPPER_BOUND])); /* not asked for */
}

/* A value that the project does not allow is a failed case that says which. */
static void
test_failed (void)
{
  g_auto (QnStudy) study;
  g_auto (QnCaseResult) result;
  const double values[] = { 0.4, -1 };
  fixture_study (&study, PLAN, "");
  qn_case_solve (&study, values, NULL, NULL, &result);
  g_assert_true (result.failed);
  g_assert_nonnull (strstr (result.reason, "blocks[1].unit_weight"));
}

/* Keys that move blocks: what the case finds equals what the project says afresh. */
static const struct {
  const char *name, *model, *path;
  double values[2];
} geometries[] = {
  { "opening-width", "12-facade.quoin", "masonry[0].openings[0].width", { 0.8, 1.0 } },
  { "thickness", "14-pointed-arch.quoin", "masonry[2].ring", { 0.42, 0.5 } },
  { "brick-size", "12-facade.quoin", "masonry[0].unit[0]", { 0.4, 0.55 } },
  { "random-bond", "15-rubble-pier.quoin", "masonry[0].seed", { 8, 9 } },
  { "perturbation", "12-facade.quoin", "masonry[0].perturbation", { 0.1, 0.3 } },
  { "perturbed-arch", "14-pointed-arch.quoin", "masonry[2].perturbation", { 0.1, 0.3 } },
};

static void
check_case (const QnStudy *study, const char *model, const char *path, double value,
            double *multiplier)
{
  char number[QN_NUMBER_TEXT_SIZE];
  g_autofree char *override =
    g_strconcat (path, "=", qn_number_text (value, number), NULL);
  const char *overrides[] = { override, NULL };
  g_auto (QnCaseResult) result;
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;
  qn_case_solve (study, &value, NULL, NULL, &result);
  if (result.failed)
    g_error ("%s", result.reason);
  g_assert_true (qn_project_load (model, overrides, &project, NULL));
  g_assert_true (qn_contacts_detect (&project.model, &contacts, NULL) == QN_OK);
  g_assert_true (
    qn_limit_associative (&project.model, &contacts, NULL, NULL, &solution, NULL)
    == QN_OK);
  /* It starts from another iterate: other bounds of the same multiplier, which lies between all of
   * them, to the gap that limit.h allows. */
  double least = fmax (result.numbers[QN_STUDY_LOWER_BOUND], solution.lower_bound);
  double most = fmin (result.numbers[QN_STUDY_UPPER_BOUND], solution.upper_bound);
  g_assert_cmpfloat (fabs (most - least), <, 1e-6 * (1 + solution.upper_bound));
  g_assert_cmpfloat (least, <, most + 1e-9 * (1 + most));
  *multiplier = solution.lower_bound;
}

static void
test_geometry (gconstpointer data)
{
  gsize i = GPOINTER_TO_SIZE (data);
  g_autoptr (GError) error = NULL;
  g_autofree char *model =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), geometries[i].model, NULL);
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s\", \"run\": "
    "\"limit\", \"parameters\": [ { \"name\": \"x\", \"path\": \"%s\", "
    "\"values\": [%g, %g] } ], "
    "\"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"lower_bound\"] }",
    model, geometries[i].path, geometries[i].values[0], geometries[i].values[1]);
  test_autoscratch char *folder = test_scratch_new ();
  double multipliers[2];
  g_auto (QnStudy) study;
  fixture_read (folder, text, &study, &error);
  g_assert_no_error (error);
  for (gsize k = 0; k < 2; k++)
    check_case (&study, model, geometries[i].path, geometries[i].values[k],
                &multipliers[k]);
  g_assert_cmpfloat (multipliers[0], !=, multipliers[1]);
}

/* A case in time: what it gives is what the result says. */
static void
test_dynamic (void)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s/%s\", \"run\": "
    "\"dynamic\", \"parameters\": [ { \"name\": \"scale\", \"path\": "
    "\"analysis.dynamic.ground[0].scale\", \"values\": [1] } ], "
    "\"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapsed\", "
    "\"time_of_collapse\", \"peak_displacement\", \"friction_energy\", "
    "\"energy_error\", \"largest_slip\", \"mechanism_shape\"] }",
    g_getenv ("QUOIN_EXAMPLES"), "42-arch-pulse.quoin");
  test_autoscratch char *folder = test_scratch_new ();
  g_auto (QnStudy) study;
  fixture_read (folder, text, &study, &error);
  g_assert_no_error (error);
  const double scales[] = { 0.1, 4 };
  for (gsize i = 0; i < 2; i++) {
    g_auto (QnCaseResult) result;
    QnCaseModel model;
    qn_case_solve (&study, &scales[i], NULL, &model, &result);
    if (result.failed)
      g_error ("%s", result.reason);
    const QnHistory *history = &model.result.history;
    double largest = 0;
    for (size_t b = 0; b < model.result.block_count; b++)
      largest = fmax (largest, history->peaks[b]);
    g_assert_cmpfloat (result.numbers[QN_STUDY_COLLAPSED], ==, i);
    g_assert_cmpfloat (result.numbers[QN_STUDY_PEAK_DISPLACEMENT], ==, largest);
    g_assert_cmpfloat (result.numbers[QN_STUDY_LARGEST_SLIP], ==, history->largest_slip);
    g_assert_cmpfloat (result.numbers[QN_STUDY_ENERGY_ERROR], ==, history->energy_error);
    g_assert_cmpfloat (result.numbers[QN_STUDY_FRICTION_ENERGY], >=, 0);
    g_assert_true (isnan (result.numbers[QN_STUDY_TIME_OF_COLLAPSE]) == (i == 0));
    g_assert_true ((result.shape != NULL) == (i == 1));
    if (i == 1)
      g_assert_cmpfloat (result.numbers[QN_STUDY_TIME_OF_COLLAPSE], ==,
                         history->collapse_time);
    qn_case_model_clear (&model);
  }
}

/* An analysis that may not take as much work as it needs has failed, and says so. */
static void
test_work (void)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s/%s\", \"run\": "
    "\"solve\", \"parameters\": [ { \"name\": \"f\", \"path\": "
    "\"laws[0].friction\", \"values\": [0.6] } ], \"limits\": { \"factorizations\": 3 },"
    "\"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapse_multiplier\"] }",
    g_getenv ("QUOIN_EXAMPLES"), "06-arch.quoin");
  test_autoscratch char *folder = test_scratch_new ();
  g_auto (QnStudy) study;
  g_auto (QnCaseResult) result;
  const double friction = 0.6;
  fixture_read (folder, text, &study, &error);
  g_assert_no_error (error);
  qn_case_solve (&study, &friction, NULL, NULL, &result);
  g_assert_true (result.failed);
  g_assert_nonnull (strstr (result.reason, "factorizations"));
}

/* A study of the combinations of an example, with more keys of the project file varied. */
static void
read_combinations (QnStudy *study, const char *folder, const char *parameters)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": "
    "\"%s/50-wall-in-combinations.quoin\", \"run\": \"solve\", \"parameters\": [%s], "
    "\"plan\": { \"kind\": \"combinations\" }, \"outputs\": "
    "[\"collapse_multiplier\"] }",
    g_getenv ("QUOIN_EXAMPLES"), parameters);
  fixture_read (folder, text, study, &error);
  g_assert_no_error (error);
}

/* The wall overturns about the corner that the live load pushes it to, or slides: moments and forces by
 * hand, of every combination. Without live load it stands. */
static double
by_hand (const QnCombination *combination, double friction)
{
  const double *f = combination->factors; /* self, floor, people, left, right, quake */
  double weight = f[0] * 18000 * 0.6 * 3 + f[1] * 10000 + f[2] * 8000;
  double push = f[3] * 2400 - f[4] * 2400 + f[5] * (3240 + 1240);
  double moment = f[3] * 3600 - f[4] * 3600 + f[5] * (3240 * 1.5 + 1240 * 3);
  double arm = push > 0 ? 0.15 : 0.45;
  double resisting = (weight - f[2] * 8000) * 0.3 + f[2] * 8000 * arm;
  double sliding = friction / combination->friction * weight / fabs (push);
  return fmin (resisting / fabs (moment), sliding);
}

static void
test_combinations (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_auto (QnStudy) study;
  guint standing = 0, sliding = 0;
  read_combinations (
    &study, folder,
    "{ \"name\": \"mu\", \"path\": \"laws[0].friction\", \"values\": [0.6, 0.2] }");
  g_assert_cmpuint (study.combinations->len, ==, 65);
  g_assert_cmpuint (qn_study_case_count (&study), ==, 130);
  for (gsize i = 0; i < 130; i++) {
    const double values[] = { i % 2 == 0 ? 0.6 : 0.2, 1 + (double) (i / 2) };
    const QnCombination *combination = study.combinations->pdata[i / 2];
    double hand = by_hand (combination, values[0]);
    g_auto (QnCaseResult) result;
    qn_case_solve (&study, values, NULL, NULL, &result);
    g_assert_cmpstr (result.reason, ==, NULL);
    standing += isinf (hand);
    sliding += hand < by_hand (combination, 0.6) - 1e-6;
    if (isinf (hand))
      g_assert_cmpstr (result.outcome, ==, "target-reached");
    else
      g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER] / hand,
                                      1, 1e-4);
  }
  g_assert_cmpuint (standing, ==, 32);
  g_assert_cmpuint (sliding, >, 10);
}

/* A foundation that moves out by s and tilts outwards by t opens the joints of the walls on it, at their tops, by
 * s + t (y + 0.15): y 1 and 2 m, from its centroid. The measured widths are any. */
static void
test_cracks (void)
{
  static const double outwards = 0.0042, tilt = 0.0031;
  test_autoscratch char *folder = test_scratch_new ();
  g_autoptr (GError) error = NULL;
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": "
    "\"%s/51-parting-walls.quoin\", \"run\": \"solve\", \"cracks\": [ "
    "{ \"blocks\": [\"r1\", \"l1\"], \"width\": 0.006 }, "
    "{ \"blocks\": [\"l2\", \"r2\"], \"width\": 0.013 } ], \"parameters\": [ "
    "{ \"name\": \"s\", \"path\": \"loads.live[0].value\", \"values\": [0.001] }, "
    "{ \"name\": \"t\", \"path\": \"loads.live[1].value\", \"values\": [-0.001] } ], "
    "\"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"crack_misfit\", "
    "\"widest_crack\"] }",
    g_getenv ("QUOIN_EXAMPLES"));
  g_auto (QnStudy) study;
  g_auto (QnCaseResult) result;
  fixture_read (folder, text, &study, &error);
  g_assert_no_error (error);
  qn_case_solve (&study, (const double[]){ outwards, -tilt }, NULL, NULL, &result);
  g_assert_cmpstr (result.outcome, ==, "target-reached");
  double low = outwards + 1.15 * tilt, high = outwards + 2.15 * tilt;
  g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_WIDEST_CRACK], high, 1e-9);
  g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_CRACK_MISFIT],
                                  hypot (low - 0.006, high - 0.013) / G_SQRT2, 1e-9);
}

QN_TESTS
{
  g_test_add_func ("/study/case/cracks", test_cracks);
  g_test_add_func ("/study/case/combinations", test_combinations);
  g_test_add_func ("/study/case/outputs", test_outputs);
  g_test_add_func ("/study/case/failed", test_failed);
  for (gsize i = 0; i < G_N_ELEMENTS (geometries); i++) {
    g_autofree char *path =
      g_strconcat ("/study/case/geometry/", geometries[i].name, NULL);
    g_test_add_data_func (path, GSIZE_TO_POINTER (i), test_geometry);
  }
  g_test_add_func ("/study/case/dynamic", test_dynamic);
  g_test_add_func ("/study/case/work", test_work);
}
