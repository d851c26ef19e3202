#include "io/result/result-check.h"

#include "io/result-fixture.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

/* Index of the pair at the left corner of the block. */
static size_t
left_pair (const ResultFixture *fixture)
{
  return fixture->contacts.pairs[0].point.x < 1 ? 0 : 1;
}

static void
run_check (const ResultFixture *fixture, QnResultCheck *check)
{
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_auto (QnResultFile) file;
  GError *error = NULL;
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_no_error (error);
  g_assert_true (qn_result_check (&file, &fixture->project, check, &error));
  g_assert_no_error (error);
}

static void
test_sound (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.multiplier, ==, 0.2);
  g_assert_cmpfloat (check.out_of_balance, <, 1e-14);
  g_assert_cmpfloat (check.yield_violation, ==, 0);
  g_assert_cmpint (check.violating_pair, ==, QN_NONE);
  g_assert_cmpfloat (check.point_distance, ==, 0);
  g_assert_cmpfloat (check.force_scale, ==, 10000);
  g_assert_cmpfloat_with_epsilon (check.contact_scale, sqrt (6000. * 6000 + 1e6), 1e-9);
}

static void
test_out_of_balance (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  fixture->result.pairs[left_pair (fixture)].normal_force -= 100;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.01, 1e-12);
  g_assert_cmpint (check.unbalanced_block, ==, 1);

  /* The load that belongs to another multiplier. */
  fixture->result.pairs[left_pair (fixture)].normal_force += 100;
  fixture->result.collapse_multiplier = 0.3;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.1, 1e-12);
}

/* Forces in balance, moments not. */
static void
test_moment (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  size_t left = left_pair (fixture);
  fixture->result.pairs[left].normal_force -= 50;
  fixture->result.pairs[1 - left].normal_force += 50;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.005, 1e-12);
}

static void
test_yield (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  size_t left = left_pair (fixture);
  fixture->result.pairs[left].shear_force = 3000; /* 0.65 x 4000 = 2600 */
  run_check (fixture, &check);
  g_assert_cmpint (check.violating_pair, ==, (QnId) left);
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 400, 1e-9);

  fixture->result.pairs[left].shear_force = 0;
  fixture->result.pairs[left].normal_force = 10;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 10, 1e-9);
}

/* The weaker side decides, and an override of the face counts for both sides. */
static void
test_laws_of_sides (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  QnModel *model = &fixture->project.model;
  QnLaw *weak = qn_model_add_law (model, "weak");
  weak->kind = QN_LAW_COULOMB;
  weak->kn = weak->ks = 1;
  weak->friction = 0.1;
  model->blocks[1].law = 1;
  run_check (fixture, &check); /* 1000 against 0.1 x 4000 */
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 600, 1e-9);

  QnFaceOverride *override = qn_model_add_override (model);
  override->block_a = 1;
  override->block_b = 0;
  override->law = 0;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.yield_violation, ==, 0);

  /* Cohesion per area: 0.5 m2 x 2000 Pa = 1000 N. */
  weak->basis = QN_BASIS_SURFACE;
  weak->cohesion = 2000;
  weak->friction = 0;
  override->law = 1;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.yield_violation, ==, 0);
  weak->cohesion = 1999;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 0.5, 1e-9);

  /* Compression per area, of the pair that is pressed most. */
  double most = 0;
  for (size_t p = 0; p < fixture->result.pair_count; p++)
    most = fmax (most, -fixture->result.pairs[p].normal_force);
  weak->kind = QN_LAW_MOHR_COULOMB;
  weak->cohesion = 2000;
  weak->compression = most / 0.5;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.yield_violation, ==, 0);
  weak->compression -= 1;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 0.5, 1e-9);

  weak->kind = QN_LAW_NO_TENSION;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.yield_violation, ==, 0);
}

static void
test_distant_point (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  fixture->contacts.pairs[1].point.y += 0.25;
  run_check (fixture, &check);
  g_assert_cmpint (check.distant_pair, ==, 1);
  g_assert_cmpfloat (check.point_distance, ==, 0.25);
}

static void
test_weightless (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  QnModel *model = &fixture->project.model;
  model->blocks[1].weight = 0;
  QnLoad *load = qn_model_add_dead_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 1;
  load->vector = qn_vec2 (2000, -10000);
  run_check (fixture, &check);
  g_assert_cmpfloat (check.force_scale, ==, 10000);
  g_assert_cmpfloat (check.out_of_balance, <, 1e-14);
}

/* A pair of a bar follows the bar's law, whatever the joint's. */
static void
test_bar (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  QnModel *model = &fixture->project.model;
  QnLaw *steel = qn_model_add_law (model, "steel");
  steel->kind = QN_LAW_ELASTIC_PLASTIC;
  steel->basis = QN_BASIS_SURFACE;
  steel->kn = steel->ks = 1;
  steel->yield = 10000; /* over 0.5 m2: 5000 N, in tension and compression */
  QnBar *bar = qn_model_add_bar (model);
  bar->law = 1;
  fixture->contacts.pairs[left_pair (fixture)].bar = 0;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.yield_violation, ==, 0);
  steel->yield = 7000;
  run_check (fixture, &check); /* 4000 against 3500 */
  g_assert_cmpfloat_with_epsilon (check.yield_violation * check.contact_scale, 500, 1e-9);
}

/* The block has slid by 0.1 m: the forces act half-way between its corners and the places they
 * left, 0.55 m before and 0.45 m behind its centroid. */
static void
test_nonlinear (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  size_t left = left_pair (fixture);
  fixture->project.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  double *u = fixture->result.displacements + 6;
  u[3] = 0.1;
  u[4] = u[5] = 0;
  fixture->result.pairs[left].normal_force = -3500;
  fixture->result.pairs[1 - left].normal_force = -6500;
  run_check (fixture, &check);
  g_assert_cmpfloat (check.out_of_balance, <, 1e-14);
  g_assert_cmpfloat_with_epsilon (check.point_distance, 0.05,
                                  1e-12); /* half of the slip */

  u[3] = 0;
  run_check (fixture, &check); /* 500 N m too much for the block at rest */
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.05, 1e-12);
}

/* A weight hung 5 m beside the centroid has no arm once the block has made a quarter turn. */
static void
test_turned_load (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResultCheck check;
  QnModel *model = &fixture->project.model;
  model->dead_load_count = model->live_load_count = 0;
  QnLoad *load = qn_model_add_dead_load (model);
  *load = (QnLoad){ .kind = QN_LOAD_FORCE,
                    .block = 1,
                    .vector = { 0, -1000 },
                    .has_at = true,
                    .at = { 6, 0.5 } };
  for (size_t i = 0; i < 2; i++)
    fixture->result.pairs[i] = (QnPairResult){ .state = QN_PAIR_OPEN };
  fixture->result.displacements[6 + 5] = G_PI / 2;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.5, 1e-12); /* 5000 N m */
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  run_check (fixture, &check);
  g_assert_cmpfloat_with_epsilon (check.out_of_balance, 0.1, 1e-12); /* 1000 N */
}

static void
test_refused (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_auto (QnResultFile) file;
  QnResultCheck check;
  GError *error = NULL;
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  file.result.step_count = 0;
  g_assert_false (qn_result_check (&file, &fixture->project, &check, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_clear_error (&error);
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-check/sound", test_sound);
  RESULT_FIXTURE_ADD ("/result-check/out-of-balance", test_out_of_balance);
  RESULT_FIXTURE_ADD ("/result-check/moment", test_moment);
  RESULT_FIXTURE_ADD ("/result-check/yield", test_yield);
  RESULT_FIXTURE_ADD ("/result-check/laws-of-sides", test_laws_of_sides);
  RESULT_FIXTURE_ADD ("/result-check/distant-point", test_distant_point);
  RESULT_FIXTURE_ADD ("/result-check/weightless", test_weightless);
  RESULT_FIXTURE_ADD ("/result-check/bar", test_bar);
  RESULT_FIXTURE_ADD ("/result-check/nonlinear", test_nonlinear);
  RESULT_FIXTURE_ADD ("/result-check/turned-load", test_turned_load);
  RESULT_FIXTURE_ADD ("/result-check/refused", test_refused);
}
