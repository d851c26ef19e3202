/* Balance and strength at the last step, of an equilibrium found by hand. */
#include "io/result/result-file.h"

#include "io/result-fixture.h"
#include "support/room.h"

/* Index of the pair at the left corner of the block. */
static size_t
left_pair (const ResultFixture *fixture)
{
  return fixture->contacts.pairs[0].point.x < 1 ? 0 : 1;
}

static QnLastForces
run_check (const ResultFixture *fixture)
{
  QnResultFaults faults;
  g_assert_cmpint (qn_result_find_faults (&fixture->project.model, &fixture->contacts,
                                          &fixture->result, QN_CHECK_STATED, &faults,
                                          NULL),
                   ==, QN_OK);
  return faults.last;
}

static void
assert_out (QnLastForces last, double newtons)
{
  g_assert_cmpfloat_with_epsilon (last.out_of_balance * last.scale, newtons, 1e-8);
}

static void
assert_excess (QnLastForces last, double newtons)
{
  g_assert_cmpfloat_with_epsilon (last.yield_violation * last.contact_scale, newtons,
                                  1e-9);
}

static void
test_sound (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnLastForces last = run_check (fixture);
  g_assert_cmpfloat (last.multiplier, ==, 0.2);
  g_assert_cmpfloat (last.out_of_balance, <, 1e-14);
  g_assert_cmpfloat (last.yield_violation, ==, 0);
  g_assert_cmpint (last.pair, ==, QN_NONE);
  g_assert_cmpfloat_with_epsilon (last.contact_scale, sqrt (6000. * 6000 + 1e6), 1e-9);
}

static void
test_out_of_balance (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->result.pairs[left_pair (fixture)].normal_force -= 100;
  QnLastForces last = run_check (fixture);
  assert_out (last, 100);
  g_assert_cmpint (last.entity, ==, QN_ENTITY_BLOCK);
  g_assert_cmpint (last.index, ==, 1);

  /* The load that belongs to another multiplier. */
  fixture->result.pairs[left_pair (fixture)].normal_force += 100;
  fixture->result.steps[1].multiplier = 0.3;
  assert_out (run_check (fixture), 1000);
}

/* Forces in balance, moments not. */
static void
test_moment (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  size_t left = left_pair (fixture);
  fixture->result.pairs[left].normal_force -= 50;
  fixture->result.pairs[1 - left].normal_force += 50;
  assert_out (run_check (fixture), 50 / fixture->project.model.characteristic_length);
}

static void
test_yield (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  size_t left = left_pair (fixture);
  fixture->result.pairs[left].shear_force = 3000; /* 0.65 x 4000 = 2600 */
  g_assert_cmpint (run_check (fixture).pair, ==, (QnId) left);
  assert_excess (run_check (fixture), 400);

  fixture->result.pairs[left].shear_force = 0;
  fixture->result.pairs[left].normal_force = 10;
  assert_excess (run_check (fixture), 10);
}

/* The weaker side decides. */
static void
test_laws_of_sides (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnContactFace *face = fixture->contacts.faces;
  QnLaw *weak = qn_model_add_law (&fixture->project.model, "weak");
  weak->kind = QN_LAW_COULOMB;
  weak->kn = weak->ks = 1;
  weak->friction = 0.1;
  face->law_b = 1;
  assert_excess (run_check (fixture), 600); /* 1000 against 0.1 x 4000 */
  face->law_a = 1;
  face->law_b = 0;
  assert_excess (run_check (fixture), 600);

  /* Cohesion per area: 0.5 m2 x 2000 Pa = 1000 N. */
  weak->basis = QN_BASIS_SURFACE;
  weak->cohesion = 2000;
  weak->friction = 0;
  assert_excess (run_check (fixture), 0);
  weak->cohesion = 1999;
  assert_excess (run_check (fixture), 0.5);

  /* Compression per area, of the pair that is pressed most. */
  double most = 0;
  for (size_t p = 0; p < fixture->result.pair_count; p++)
    most = fmax (most, -fixture->result.pairs[p].normal_force);
  weak->kind = QN_LAW_MOHR_COULOMB;
  weak->cohesion = 2000;
  weak->compression = most / 0.5;
  assert_excess (run_check (fixture), 0);
  weak->compression -= 1;
  assert_excess (run_check (fixture), 0.5);

  weak->kind = QN_LAW_NO_TENSION;
  assert_excess (run_check (fixture), 0);
}

static void
test_weightless (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnModel *model = &fixture->project.model;
  model->blocks[1].weight = 0;
  QnLoad *load = qn_model_add_dead_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 1;
  load->vector = qn_vec2 (2000, -10000);
  assert_out (run_check (fixture), 0);
}

/* A pair of a bar follows the bar's law, whatever the joint's. */
static void
test_bar (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnModel *model = &fixture->project.model;
  QnLaw *steel = qn_model_add_law (model, "steel");
  steel->kind = QN_LAW_ELASTIC_PLASTIC;
  steel->basis = QN_BASIS_SURFACE;
  steel->kn = steel->ks = 1;
  steel->yield = 10000; /* over 0.5 m2: 5000 N, in tension and compression */
  QnBar *bar = qn_model_add_bar (model);
  bar->law = 1;
  fixture->contacts.pairs[left_pair (fixture)].bar = 0;
  assert_excess (run_check (fixture), 0);
  steel->yield = 7000;
  assert_excess (run_check (fixture), 500); /* 4000 against 3500 */
}

/* The block has slid by 0.1 m: the forces act half-way between its corners and the places they
 * left, 0.55 m before and 0.45 m behind its centroid. */
static void
test_nonlinear (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  size_t left = left_pair (fixture);
  fixture->project.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  double *u = fixture->result.displacements + 6;
  u[3] = 0.1;
  u[4] = u[5] = 0;
  fixture->result.pairs[left].normal_force = -3500;
  fixture->result.pairs[1 - left].normal_force = -6500;
  assert_out (run_check (fixture), 0);

  u[3] = 0; /* 500 N m too much for the block at rest */
  assert_out (run_check (fixture), 500 / fixture->project.model.characteristic_length);
}

/* A weight hung 5 m beside the centroid has no arm once the block has made a quarter turn. */
static void
test_turned_load (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
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
  assert_out (run_check (fixture), 5000 / model->characteristic_length); /* N m */
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  assert_out (run_check (fixture), 1000);
}

static void
test_nothing (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->result.step_count = 0;
  g_assert_true (isnan (run_check (fixture).multiplier));
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-claims/sound", test_sound);
  RESULT_FIXTURE_ADD ("/result-claims/out-of-balance", test_out_of_balance);
  RESULT_FIXTURE_ADD ("/result-claims/moment", test_moment);
  RESULT_FIXTURE_ADD ("/result-claims/yield", test_yield);
  RESULT_FIXTURE_ADD ("/result-claims/laws-of-sides", test_laws_of_sides);
  RESULT_FIXTURE_ADD ("/result-claims/weightless", test_weightless);
  RESULT_FIXTURE_ADD ("/result-claims/bar", test_bar);
  RESULT_FIXTURE_ADD ("/result-claims/nonlinear", test_nonlinear);
  RESULT_FIXTURE_ADD ("/result-claims/turned-load", test_turned_load);
  RESULT_FIXTURE_ADD ("/result-claims/nothing", test_nothing);
}
