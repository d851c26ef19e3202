/* The stress tests' own checks: each is shown something to complain about. */
#include "stress/cases.h"
#include "stress/checks.h"
#include "stress/process.h"
#include "stress/report.h"

#include "core/path/analysis.h"
#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <math.h>
#include <signal.h>
#include <string.h>

typedef struct Fixture {
  QnModel model;
  QnContacts contacts;
  QnResult result;
} Fixture;

/* Wall 1 without dilatancy, solved. */
static void
set_up (Fixture *f, gconstpointer data)
{
  (void) data;
  test_model_init_wall (&f->model, 1, 0);
  f->model.analysis.increments = 10;
  test_detect (&f->model, &f->contacts);
  g_assert_cmpint (
    qn_analysis_run (&f->model, &f->contacts, NULL, NULL, &f->result, NULL), ==, QN_OK);
}

static void
tear_down (Fixture *f, gconstpointer data)
{
  (void) data;
  qn_result_clear (&f->result);
  qn_contacts_clear (&f->contacts);
  qn_model_clear (&f->model);
}

static guint
faults_of (Fixture *f)
{
  StressCheck check = stress_check_result (&f->model, &f->contacts, &f->result);
  return stress_check_faults (&check);
}

static void
test_sound (Fixture *f, gconstpointer data)
{
  (void) data;
  g_assert_cmpuint (faults_of (f), ==, 0);
  g_assert_true (stress_path_is_consistent (&f->result));
}

/* A thousandth of a block's weight too much in one joint, at some step on the way. */
static void
test_balance (Fixture *f, gconstpointer data)
{
  (void) data;
  f->result.step_forces[f->result.pair_count + 1] += 1e-3 * f->model.blocks[1].weight;
  g_assert_cmpuint (faults_of (f) & STRESS_BALANCE, !=, 0);
}

/* The joint is weaker than what it was solved with. */
static void
test_strength (Fixture *f, gconstpointer data)
{
  (void) data;
  f->model.laws[0].friction *= 1 - 1e-3;
  g_assert_cmpuint (faults_of (f), ==, STRESS_STRENGTH);
}

/* A block of the mechanism moves into those below that carry it; joints that stand open already may close. */
static void
test_mechanism (Fixture *f, gconstpointer data)
{
  (void) data;
  f->result.mechanism[QN_DOF_COUNT + QN_DOF_UY] -= 1;
  g_assert_cmpuint (faults_of (f), ==, STRESS_MECHANISM);
  f->result.mechanism_uncertain = true;
  g_assert_cmpuint (faults_of (f), ==, 0);
}

static void
test_path (Fixture *f, gconstpointer data)
{
  (void) data;
  double collapse = f->result.collapse_multiplier;
  f->result.collapse_multiplier *= 1 + 1e-6;
  g_assert_false (stress_path_is_consistent (&f->result));
  f->result.collapse_multiplier = collapse;
  f->result.steps[1].multiplier = 2 * collapse;
  g_assert_false (stress_path_is_consistent (&f->result));
  f->result.steps[1].multiplier = NAN;
  g_assert_false (stress_path_is_consistent (&f->result));
}

static void
test_limit (Fixture *f, gconstpointer data)
{
  (void) data;
  g_auto (QnLimitSolution) solution;
  f->model.laws[0].dilatancy = f->model.laws[0].friction;
  g_assert_cmpint (
    qn_limit_associative (&f->model, &f->contacts, NULL, NULL, &solution, NULL), ==,
    QN_OK);
  g_assert_true (stress_limit_is_proved (&f->model, &f->contacts, &solution));
  solution.upper_bound += 1e-3;
  g_assert_false (stress_limit_is_proved (&f->model, &f->contacts, &solution));
  solution.lower_bound = solution.upper_bound;
  g_assert_false (stress_limit_is_proved (&f->model, &f->contacts, &solution));
  solution.outcome = QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  g_assert_false (stress_limit_is_proved (&f->model, &f->contacts, &solution));
  solution.outcome = QN_OUTCOME_UNBOUNDED;
  g_assert_false (stress_limit_is_proved (&f->model, &f->contacts, &solution));
}

static void
build_crash (const StressCase *c, QnModel *model)
{
  (void) c;
  (void) model;
  raise (SIGSEGV);
}

static void
build_for_ever (const StressCase *c, QnModel *model)
{
  volatile const StressCase *kept = c;
  (void) model;
  while (kept == c)
    continue;
}

static void
build_block (const StressCase *c, QnModel *model)
{
  test_model_init_block_on_plane (model, 1, c->value);
  test_model_add_weight_loads (model, 1);
}

static void
test_process (void)
{
  StressCase c = { .name = "case", .value = 2, .exact = { 0.5, 0.5 } };
  StressRow row;

  c.build = build_block;
  stress_process_run (&c, 60, &row);
  g_assert_cmpuint (stress_row_faults (&row), ==, 0);
  g_assert_cmpuint (row.blocks, ==, 2);
  c.exact[STRESS_SLIDING] = 0.501;
  stress_process_run (&c, 60, &row);
  g_assert_cmpuint (stress_row_faults (&row), ==, STRESS_STATICS);
  c.expectation = STRESS_EXPECT_REFUSED;
  c.problem = QN_PROBLEM_BLOCK_FLOATING;
  stress_process_run (&c, 60, &row);
  g_assert_cmpuint (row.faults, ==, STRESS_NOT_REFUSED);
  c.build = build_crash;
  stress_process_run (&c, 60, &row);
  g_assert_cmpuint (row.faults, ==, STRESS_CRASH);
  c.build = build_for_ever;
  stress_process_run (&c, 1, &row);
  g_assert_cmpuint (row.faults, ==, STRESS_HANG);
}

/* The same seed, the same wall; other seeds, other walls. */
static void
test_random (void)
{
  for (guint32 seed = 1; seed <= 20; seed++) {
    QnModel models[3];
    char text[3][160];
    for (int i = 0; i < 3; i++)
      test_wall_draw_any (&models[i], seed + (i == 2), text[i], sizeof text[i]);
    g_assert_cmpstr (text[0], ==, text[1]);
    g_assert_cmpuint (models[0].block_count, ==, models[1].block_count);
    g_assert_cmpmem (models[0].vertices, models[0].vertex_count * sizeof (QnVec2),
                     models[1].vertices, models[1].vertex_count * sizeof (QnVec2));
    g_assert_cmpfloat (models[0].laws[0].friction, ==, models[1].laws[0].friction);
    g_assert_cmpfloat (models[0].laws[0].friction, !=, models[2].laws[0].friction);
    for (int i = 0; i < 3; i++)
      qn_model_clear (&models[i]);
  }
}

/* How far the wall has moved in the last quarter of a time in which it is shaken no more, over how far in all: the
 * acceleration of the ground has grown slowly until it acts as the live load does at this multiplier. */
static double
motion_left (QnModel *model, const QnContacts *contacts, double multiplier)
{
  const double grow = 20, end = 36;
  g_auto (QnResult) result;

  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.dynamic.duration = end;
  model->analysis.dynamic.time_step = 0.5;
  model->analysis.dynamic.rho = 0.5;
  model->analysis.dynamic.mass_damping = 5;
  model->analysis.dynamic.output_interval = 1;
  QnGroundMotion *ground =
    model->ground_count > 0 ? model->ground : qn_model_add_ground_motion (model);
  ground->point_count = 0;
  ground->direction = qn_vec2_scale (-1, model->live_loads[0].vector);
  double acceleration = multiplier * model->gravity;
  qn_ground_motion_add_point (ground, 0, 0);
  qn_ground_motion_add_point (ground, grow, acceleration);
  qn_ground_motion_add_point (ground, end, acceleration);
  g_assert_cmpint (qn_analysis_run (model, contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  if (result.outcome == QN_OUTCOME_COLLAPSE)
    return 1;
  size_t last = result.step_count - 1, before = last;
  while (result.steps[before].time > end - 0.25 * (end - grow))
    before--;
  return qn_result_motion (&result, before, last) / qn_result_motion (&result, 0, last);
}

/* Equilibria exist up to 1.28 and 1.56 times the multiplier: these walls fall before, as they do in time. */
static void
test_slow_load (void)
{
  static const guint32 seeds[] = { 7012, 7381 };

  for (gsize i = 0; i < G_N_ELEMENTS (seeds); i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnResult) result;
    char text[160];

    test_wall_draw_any (&model, seeds[i], text, sizeof text);
    model.laws[0].dilatancy = 0;
    test_detect (&model, &contacts);
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpint (result.stop, ==, QN_STOP_FALL);
    g_assert_false (result.mechanism_uncertain);
    double multiplier = result.collapse_multiplier;
    g_assert_cmpfloat (motion_left (&model, &contacts, 0.97 * multiplier), <, 1e-3);
    g_assert_cmpfloat (motion_left (&model, &contacts, 1.03 * multiplier), >, 1e-1);
  }
}

/* What --only takes must name one case. */
static void
test_names (void)
{
  g_autoptr (GArray) cases = stress_cases_new ();
  g_autoptr (GHashTable) names = g_hash_table_new (g_str_hash, g_str_equal);

  stress_cases_add_random (cases, 1, 1000);
  for (guint i = 0; i < cases->len; i++)
    g_assert_true (g_hash_table_add (names, g_array_index (cases, StressCase, i).name));
}

/* The tables of a case that went well, of one that did not, and of what is no structure. */
static void
test_report (void)
{
  StressCase cases[] = {
    { .subject = "blocks", .name = "good-wall1", .build = build_block, .value = 2 },
    { .subject = "blocks", .name = "good-wall2", .build = build_block, .value = 4 },
    { .subject = "blocks", .name = "crash", .build = build_crash },
    { .subject = "none", .name = "flat", .build = build_block, .value = 0 },
  };
  g_autoptr (GArray) entries = g_array_new (FALSE, TRUE, sizeof (StressEntry));
  g_autoptr (GString) text = g_string_new (NULL);

  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    StressEntry entry = { .c = &cases[i] };
    cases[i].exact[0] = cases[i].exact[1] = NAN;
    cases[i].repeat = 7;
    stress_process_run (&cases[i], 60, &entry.row);
    g_array_append_val (entries, entry);
  }
  stress_report_markdown (text, entries, "stress");
  g_test_message ("%s", text->str);
  g_assert_nonnull (strstr (text->str, "stress`: 4 cases, 4 paths, "));
  g_assert_nonnull (strstr (text->str, "; 2 cases with faults.\n"));
  g_assert_nonnull (strstr (text->str, "| Blocks | 3 | 4 collapse | "));
  g_assert_nonnull (strstr (text->str, " | 100 % |  | 0 % | 1 |\n"));
  g_assert_nonnull (strstr (text->str, "| None | 1 | 1 refused | "));
  g_assert_nonnull (strstr (text->str, "| crash | 0 |  |  |  | crashed. "));
}

QN_TESTS
{
  static const struct {
    const char *name;
    void (*test) (Fixture *f, gconstpointer data);
  } tests[] = { { "sound", test_sound },       { "balance", test_balance },
                { "strength", test_strength }, { "mechanism", test_mechanism },
                { "path", test_path },         { "limit", test_limit } };

  for (size_t i = 0; i < G_N_ELEMENTS (tests); i++) {
    g_autofree char *path = g_strconcat ("/stress/checks/", tests[i].name, NULL);
    g_test_add (path, Fixture, NULL, set_up, tests[i].test, tear_down);
  }
  g_test_add_func ("/stress/process", test_process);
  g_test_add_func ("/stress/random", test_random);
  g_test_add_func ("/stress/slow-load", test_slow_load);
  g_test_add_func ("/stress/names", test_names);
  g_test_add_func ("/stress/report", test_report);
}
