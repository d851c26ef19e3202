/* What a result states of single joints, where the steps alone do not tell how they came to it. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Removes steps, as if a motion had led from the one before to the one after: which came to rest there. */
static void
drop_steps (QnResult *r, size_t from, size_t to)
{
  const struct {
    void *items;
    size_t size; /* of a step */
  } arrays[] = {
    { r->steps, sizeof *r->steps },
    { r->displacements, qn_result_body_count (r) * QN_DOF_COUNT * sizeof (double) },
    { r->reactions, r->support_count * QN_DOF_COUNT * sizeof (double) },
    { r->step_forces, 2 * r->pair_count * sizeof (double) },
    { r->step_states, r->pair_count },
    { r->step_damage, r->pair_count * sizeof (double) },
    { r->ties, r->tie_count * sizeof *r->ties },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (arrays); i++) {
    char *items = arrays[i].items;
    if (items == NULL)
      continue;
    memmove (items + from * arrays[i].size, items + to * arrays[i].size,
             (r->step_count - to) * arrays[i].size);
  }
  r->step_count -= to - from;
  r->steps[from].relaxed = true;
}

static size_t
end_of (const QnResult *r, int stage)
{
  size_t end = 0;
  for (size_t i = 0; i < r->step_count; i++)
    if (r->steps[i].stage == stage)
      end = i;
  g_assert_cmpuint (end, >, 0);
  return end;
}

static void
add_stage (QnModel *model, uint32_t sets, double target)
{
  QnStage *stage = qn_model_add_stage (model, "stage");
  stage->sets = sets;
  stage->has_target = true;
  stage->target = target;
}

/* Prescribes a displacement of block 1. */
static void
add_move (QnModel *model, uint32_t sets, QnDof dof, double target, int32_t increments)
{
  QnStage *stage = qn_model_add_stage (model, "stage");
  stage->sets = sets;
  stage->procedure = QN_PROCEDURE_DISPLACEMENT;
  stage->control.block = 1;
  stage->control.dof = dof;
  stage->control.target = target;
  stage->increments = increments;
}

static void
press (QnModel *model, double force)
{
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->block = 1;
  dead->kind = QN_LOAD_FORCE;
  dead->vector = qn_vec2 (0, -force);
}

static void
add_force (QnModel *model, const char *set, double fx, double fy)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->set = qn_model_add_load_set (model, set);
  load->block = 1;
  load->vector = qn_vec2 (fx, fy);
}

/* A fibre of a member that was pulled beyond yield while it came to rest carries less than its
 * elongation alone tells; one that was not has no reason for it, and any force has to balance the
 * loads. */
static void
test_fibre_strained_on_the_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init (model);
  model->laws[0].kind = QN_LAW_BILINEAR;
  model->laws[0].yield = 1e3;
  model->laws[0].hardening = 0.2;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 1 };
  test_model_add_base (model, -0.5, -1, 1, 1);
  test_model_add_rectangle (model, "block", -0.5, 0, 1, 1);
  model->blocks[1].support[QN_DOF_RZ] = true;
  add_force (model, "live", 0, 1e3);
  add_stage (model, 1, 1.3);
  add_stage (model, 1, 0.4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);

  drop_steps (r, 1, end_of (r, 2));
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
  r->steps[1].relaxed = true;
  r->pairs[0].normal_force = r->step_forces[2 * r->pair_count] = 3e3;
  g_assert_true (test_run_tells (&run, QN_CLAIM_BALANCE));
}

/* A bar across a joint at a slant that was pulled beyond yield while the structure came to rest: any force along
 * it has a reason, none across it. */
static void
test_bar_strained_on_the_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init (model);
  QnLaw *steel = qn_model_add_law (model, "steel");
  *steel = (QnLaw){ .name = steel->name,
                    .kind = QN_LAW_BILINEAR,
                    .basis = QN_BASIS_MATERIAL,
                    .kn = 2e11,
                    .ks = 8e10,
                    .yield = 5e8,
                    .hardening = 0.2 };
  test_model_add_base (model, -0.5, -1, 1, 1);
  test_model_add_rectangle (model, "block", -0.5, 0, 1, 1);
  model->blocks[1].support[QN_DOF_UX] = model->blocks[1].support[QN_DOF_RZ] = true;
  *qn_model_add_bar (model) =
    (QnBar){ .law = 1, .area = 3e-4, .start = { -0.3, -0.5 }, .end = { 0.3, 0.5 } };
  add_force (model, "live", 0, 1.5e5);
  add_stage (model, 1, 1.3);
  add_stage (model, 1, 0.4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);

  drop_steps (r, 1, end_of (r, 2));
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  size_t bar = 0;
  while (run.contacts.pairs[bar].bar == QN_NONE)
    bar++;
  double s = run.contacts.pairs[bar].slant, c = sqrt (1 - s * s);
  double *force = r->step_forces + 2 * (r->pair_count + bar);
  const double along[2] = { c, s }, across[2] = { -s, c };
  g_assert_cmpfloat (fabs (s), >, 0.5);
  for (int i = 0; i < 2; i++) {
    const double *way = i == 0 ? along : across, before[2] = { force[0], force[1] };
    r->pairs[bar].normal_force = force[0] += 1e4 * way[0];
    r->pairs[bar].shear_force = force[1] += 1e4 * way[1];
    g_assert_true (test_run_tells (&run, QN_CLAIM_BALANCE));
    g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES) == (i == 1));
    force[0] = before[0];
    force[1] = before[1];
  }
}

/* How far a joint that dilates has risen by sliding is not told while it stands open. It shows once it carries
 * again, in whatever step. */
static void
test_joint_that_has_risen (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 0.5);
  model->laws[0].friction = 0.5;
  model->laws[0].dilatancy = 0.2;
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  add_force (model, "live", 1e4, 0);
  add_force (model, "tilt", 0, 0);
  model->live_loads[1].moment = -1e4;
  for (int i = 0; i < 3; i++) {
    static const double targets[] = { 0.01, -0.002, -0.01 };
    add_move (model, i < 2 ? 1 : 2, i < 2 ? QN_DOF_UX : QN_DOF_RZ, targets[i], 4);
    if (i == 1)
      add_stage (model, 1, 0);
  }
  add_stage (model, 2, 0);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  size_t tilted = end_of (r, 4), pairs = r->pair_count;
  const uint8_t *states = r->step_states + tilted * pairs;
  g_assert_true (states[0] == QN_PAIR_OPEN || states[1] == QN_PAIR_OPEN);

  for (size_t i = tilted; i < r->step_count; i++)
    r->steps[i].relaxed = false; /* it closes straight */
  drop_steps (r, 1, tilted);
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
}

/* What lies between two supports carries no load: neither its state nor its force counts. */
static void
test_between_supports (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init (model);
  test_model_add_base (model, 0, -0.3, 1, 0.3);
  QnBlock *sinks = test_model_add_base (model, 1, -0.3, 1, 0.3);
  g_free (sinks->name);
  sinks->name = g_strdup ("sinks");
  test_model_add_rectangle (model, "block", 0.2, 0, 0.6, 0.5);
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  QnLoad *settles = qn_model_add_live_load (model);
  settles->kind = QN_LOAD_SETTLEMENT;
  settles->set = 0;
  settles->block = 1;
  settles->dof = QN_DOF_UY;
  settles->value = -0.05;
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  int held = 0;
  for (size_t p = 0; p < r->pair_count; p++) {
    const QnContactFace *face = &run.contacts.faces[run.contacts.pairs[p].face];
    gboolean between = face->a + face->b == 1;
    uint8_t *state = &r->step_states[r->pair_count + p], before = *state;
    held += between;
    *state = before == QN_PAIR_SLIP ? QN_PAIR_STICK : QN_PAIR_SLIP;
    g_assert_true (test_run_tells (&run, QN_CLAIM_STATES) == !between);
    *state = before;
  }
  g_assert_cmpint (held, >, 0);
}

/* A joint slides on the side whose bond is broken, with more friction than that of the other side, whose
 * bond is whole. */
static void
test_one_bond_broken (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 0.5);
  QnLaw *whole = qn_model_add_law (model, "whole"), *breaks = &model->laws[0];
  *whole = (QnLaw){ .name = whole->name,
                    .kind = QN_LAW_COULOMB,
                    .kn = breaks->kn,
                    .ks = 2 * breaks->ks,
                    .friction = 0.3,
                    .cohesion = 3000,
                    .tension = 300 };
  breaks->friction = 0.7;
  breaks->cohesion = 500;
  model->blocks[1].law = 1;
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  add_force (model, "push", 1, 0);
  add_move (model, 2, QN_DOF_UX, 0.01, 10);
  test_run_solve (&run);
  const QnStep *last = &run.result.steps[run.result.step_count - 1];
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat_with_epsilon (last->multiplier, 0.7 * 5000, 1);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

/* Blocks pressed aslant. On the way to rest the stronger bond of a joint breaks, where the weaker one would break
 * at the forces of rest, and its friction counts from then on. */
static void
test_other_bond_broken (void)
{
  for (int i = 0; i < 24; i++) {
    g_auto (TestRun) run = { 0 };
    QnModel *model = &run.model;
    test_model_init_stack (model, 2, 1.2, 0.5);
    for (int strong = 0; strong < 2; strong++) {
      QnLaw *law = strong ? &model->laws[0] : qn_model_add_law (model, "weak");
      *law = (QnLaw){ .name = law->name,
                      .kind = QN_LAW_COULOMB,
                      .basis = QN_BASIS_SURFACE,
                      .kn = 2e10,
                      .ks = 1e10,
                      .friction = strong ? 0.88 : 0.98,
                      .cohesion = strong ? 1e4 : 1e3,
                      .tension = strong ? 5e3 : 100 };
    }
    model->blocks[1].law = 1;
    press (model, 160e3);
    model->dead_loads[0].block = 2;
    model->dead_loads[0].vector.x = 30e3 + 3e3 * i;
    model->analysis.max_multiplier = 0;
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
}

/* A bond that was damaged a very little more on the way of a motion carries less by more than forces may
 * differ. */
static void
test_bond_damaged_on_the_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 0.5);
  QnLaw *law = &model->laws[0];
  law->cohesion = law->tension = 2e4;
  double elastic = law->tension / (0.5 * law->kn);
  law->fracture_energy_tension = 20 * law->tension * elastic;
  add_force (model, "lift", 0, 1e4);
  for (int i = 0; i < 3; i++)
    add_move (model, 2, QN_DOF_UY, 10 * elastic * (i == 1 ? 1 + 3e-4 : 1), 4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  size_t first = end_of (r, 1), last = r->step_count - 1;
  g_assert_cmpfloat (fabs (r->step_forces[2 * last * r->pair_count]
                             / r->step_forces[2 * first * r->pair_count]
                           - 1),
                     >, 1e-5);
  drop_steps (r, first + 1, last);
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  g_assert_false (test_run_tells (&run, QN_CLAIM_STATES));
  r->steps[first + 1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
}

/* What is left of a bond carries besides the friction of a joint that slips, which is not at its strength
 * then: in time as on a path. */
static void
test_slip_of_a_damaged_bond (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 0.5, 0.82);
  model->blocks[1].unit_weight = 20000;
  QnLaw *law = &model->laws[0];
  law->basis = QN_BASIS_SURFACE;
  law->kn = law->ks = 1e10;
  law->friction = 0.6;
  law->cohesion = 15e3;
  law->tension = 4e3;
  law->fracture_energy_tension = 5;
  law->fracture_energy_shear = 20;
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  QnDynamicSettings *dynamic = &model->analysis.dynamic;
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  dynamic->duration = 0.4;
  dynamic->time_step = dynamic->output_interval = 0.005;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ QN_PULSE_SINE, 5.5, 0.3, 0 };
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  size_t slips = 0;
  for (size_t i = 0; i < r->step_count * r->pair_count; i++)
    if (r->step_states[i] == QN_PAIR_SLIP) {
      slips++;
      g_assert_cmpfloat (r->step_damage[i], >, 0);
      g_assert_cmpfloat (r->step_damage[i], <, 1);
    }
  g_assert_cmpuint (slips, >, 0);
  /* Friction that is not at its strength does not slip. */
  for (size_t i = 0; i < r->step_count * r->pair_count; i++)
    if (r->step_states[i] == QN_PAIR_STICK && r->step_damage[i] > 0)
      r->step_states[i] = QN_PAIR_SLIP;
  g_assert_true (test_run_tells (&run, QN_CLAIM_STATES));
}

/* A bond that was damaged by little, and its friction slid, on the way of a motion that no step tells; it sticks
 * now. Its force, which is mostly the bond's, hardly tells that it slid. */
static void
test_slip_before_an_unknown_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 0.0001);
  QnLaw *law = &model->laws[0];
  law->cohesion = law->tension = 2e4;
  law->friction = 0.6;
  double elastic = law->cohesion / (0.5 * law->ks);
  law->fracture_energy_tension = 500 * law->tension * elastic;
  press (model, 4e4);
  add_force (model, "push", 1e4, 0);
  add_move (model, 2, QN_DOF_UX, 1.601 * elastic, 4);
  add_move (model, 2, QN_DOF_UX, 1.597 * elastic, 4);
  add_move (model, 2, QN_DOF_UX, 1.598 * elastic, 4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  drop_steps (r, 1, end_of (r, 2));
  drop_steps (r, 2, r->step_count - 1);
  r->steps[2].relaxed = false;
  g_clear_pointer (&r->step_forces, free);
  g_assert_cmpint (r->pairs[0].state, ==, QN_PAIR_STICK);
  g_assert_cmpfloat (r->pairs[0].damage, >, 5e-4);
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  g_assert_false (test_run_tells (&run, QN_CLAIM_STATES));
  r->pairs[0].state = QN_PAIR_YIELD;
  g_assert_true (test_run_tells (&run, QN_CLAIM_STATES));
  r->pairs[0].state = QN_PAIR_OPEN;
  g_assert_true (test_run_tells (&run, QN_CLAIM_STATES));
  r->pairs[0].state = QN_PAIR_STICK;
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_STATES));
}

/* Mortar on concrete: its bond was damaged, and its friction slid to and fro, on the way of a motion that no
 * step tells, while the concrete stayed elastic; below or above it. */
static void
check_weaker_bond (QnId of_concrete)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 0.0001);
  QnLaw *concrete = qn_model_add_law (model, "concrete"), *mortar = &model->laws[0];
  mortar->cohesion = mortar->tension = 2e4;
  mortar->friction = 0.6;
  *concrete = (QnLaw){ .name = concrete->name,
                       .kind = QN_LAW_COULOMB,
                       .kn = 3 * mortar->kn,
                       .ks = 2 * mortar->ks,
                       .friction = 0.8,
                       .cohesion = 9e4,
                       .tension = 5e4 };
  model->blocks[of_concrete].law = 1;
  double elastic = 3.2e4 * (1 / mortar->ks + 1 / concrete->ks);
  mortar->fracture_energy_tension = concrete->fracture_energy_tension = 2e5 * elastic;
  press (model, 4e4);
  add_force (model, "push", 1e4, 0);
  add_move (model, 2, QN_DOF_UX, 3 * elastic, 4);
  add_move (model, 2, QN_DOF_UX, 0.4 * elastic, 4);
  add_move (model, 2, QN_DOF_UX, 1.4 * elastic, 4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  drop_steps (r, 1, end_of (r, 2));
  drop_steps (r, 2, r->step_count - 1);
  r->steps[2].relaxed = false;
  r->steps[1].relaxed = true;
  g_assert_cmpfloat (r->pairs[0].damage, >, 0.2);
  g_assert_cmpfloat (r->pairs[0].damage, <, 0.9);
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  g_assert_false (test_run_tells (&run, QN_CLAIM_STATES));
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
}

static void
test_weaker_bond_on_an_unknown_way (void)
{
  check_weaker_bond (0);
  check_weaker_bond (1);
}

/* A block on a joint that may be crushed, pressed by a share of its strength. Returns the slip at which its
 * bond begins to be damaged. */
static double
init_crushable (QnModel *model, double share)
{
  test_model_init_block_on_plane (model, 1, 0.0001);
  QnLaw *law = &model->laws[0];
  law->kind = QN_LAW_MOHR_COULOMB;
  law->friction = 0.6;
  law->compression = 1e5;
  law->cohesion = law->tension = law->compression / 300;
  const double pressed = share * law->compression;
  const double elastic = (law->cohesion + law->friction * pressed) / (0.5 * law->ks);
  law->fracture_energy_tension = 20 * law->cohesion * elastic;
  press (model, 2 * pressed);
  return elastic;
}

/* A joint that was crushed a little on the way of a motion that no step tells: its force agrees without that,
 * but hardly the damage that its bond takes later. */
static void
test_crushed_a_little_on_an_unknown_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  const double elastic = init_crushable (model, 0.99), most = model->laws[0].compression;
  const double crushed = -most / (0.5 * model->laws[0].kn);
  add_force (model, "press", 0, -1e3);
  add_force (model, "push", 1e3, 0);
  add_move (model, 2, QN_DOF_UY, crushed * (1 + 5e-6), 4);
  add_stage (model, 2, 0);
  add_move (model, 4, QN_DOF_UX, 1.02 * elastic, 4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  g_assert_cmpfloat (r->pairs[0].damage, >, 0.01);
  drop_steps (r, 1, end_of (r, 2));
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  g_assert_false (test_run_tells (&run, QN_CLAIM_STATES));
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_STATES));
}

/* A joint whose bond is damaged in part is crushed, and pressed less again, on the way of a motion that no step
 * tells: its force is below the strength, at an elongation where it would have been crushed. */
static void
test_crushed_and_relieved_on_an_unknown_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  const double elastic = init_crushable (model, 0.5), most = model->laws[0].compression;
  const double crushed = -most / (0.5 * model->laws[0].kn);
  add_force (model, "push", 1e3, 0);
  add_force (model, "press", 0, -1e3);
  add_move (model, 2, QN_DOF_UX, 1.02 * elastic, 4);
  add_move (model, 4, QN_DOF_UY, 1.5 * crushed, 4);
  add_move (model, 4, QN_DOF_UY, 1.3 * crushed, 4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  g_assert_cmpfloat (r->pairs[0].damage, >, 0.01);
  g_assert_cmpfloat (r->pairs[0].damage, <, 1);
  g_assert_cmpfloat (fabs (r->pairs[0].normal_force), <, 0.9 * most);
  size_t first = end_of (r, 1) + 1;
  drop_steps (r, first, r->step_count - 1);
  g_assert_false (test_run_tells (&run, QN_CLAIM_FORCES));
  r->steps[first].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
}

/* Joints of two laws, on a way that no result tells: a joint that dilates, and one whose bond softens, beside
 * concrete, in time; and two bonds that soften, of which the one with more cohesion is damaged, on a path that has
 * jumped. */
static void
test_unequal_sides (void)
{
  for (int bonds = 0; bonds < 3; bonds++) {
    g_auto (TestRun) run = { 0 };
    QnModel *model = &run.model;
    test_model_init (model);
    qn_model_add_law (model, "other");
    QnLaw *a = &model->laws[0], *b = &model->laws[1];
    test_model_add_base (model, -5, -1, 10, 1);
    test_model_add_weight_loads (model, 1);
    model->live_load_count = bonds == 1;
    model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 5 };
    if (bonds != 1) {
      *a = (QnLaw){ .name = a->name,
                    .kind = QN_LAW_COULOMB,
                    .basis = QN_BASIS_SURFACE,
                    .kn = 2.66e9,
                    .ks = 2.66e9,
                    .friction = 0.7,
                    .dilatancy = 0.1 };
      *b = (QnLaw){ .name = b->name,
                    .kind = QN_LAW_CONCRETE,
                    .basis = QN_BASIS_SURFACE,
                    .kn = 1e11,
                    .ks = 1e11,
                    .strength = 2e7,
                    .fracture_energy = 100 };
      test_model_add_rectangle (model, "b0", -0.033, 0, 0.546, 0.4805);
      model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
      model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
      model->analysis.dynamic.duration = 1;
      model->analysis.dynamic.time_step = 0.005;
      model->analysis.dynamic.joint_damping = 1e-4;
      model->analysis.dynamic.of = QN_DAMPING_CURRENT;
      QnGroundMotion *motion = qn_model_add_ground_motion (model);
      motion->kind = QN_SIGNAL_PULSE;
      motion->direction = qn_vec2 (1, 0);
      motion->pulse = (QnPulse){ QN_PULSE_HALF_SINE, bonds == 0 ? 7.1 : 60, 0.418, 0 };
      if (bonds == 2) {
        a->kn = a->ks = 4e10;
        a->dilatancy = 0;
        a->tension = 1e5;
        a->cohesion = 2e5;
        a->fracture_energy_tension = 10;
        a->fracture_energy_shear = 50;
        b->kn = b->ks = 5e11;
        b->kind = QN_LAW_MOHR_COULOMB;
        b->friction = 1.7;
        b->cohesion = 4e6;
        b->tension = 2e6;
        b->compression = 2e7;
        model->analysis.geometry = QN_GEOMETRY_LINEAR;
        model->analysis.dynamic.output_interval = 0.05;
      }
    } else {
      *a = (QnLaw){ .name = a->name,
                    .kind = QN_LAW_COULOMB,
                    .basis = QN_BASIS_SURFACE,
                    .kn = 7.934e9,
                    .ks = 3.1735e9,
                    .friction = 0.64,
                    .cohesion = 361847,
                    .tension = 96948,
                    .fracture_energy_tension = 4.418,
                    .fracture_energy_shear = 4.418,
                    .exponential = true };
      *b = (QnLaw){ .name = b->name,
                    .kind = QN_LAW_COULOMB,
                    .basis = QN_BASIS_SURFACE,
                    .kn = 6.352e10,
                    .ks = 6.352e10,
                    .friction = 0.6074,
                    .cohesion = 178121,
                    .tension = 166728,
                    .fracture_energy_tension = 8.8416,
                    .fracture_energy_shear = 88.416 };
      test_model_add_rectangle (model, "b0", 0.0027, 0, 0.808, 0.6776);
      test_model_add_rectangle (model, "b1", -0.0209, 0.6776, 0.6235, 0.6676);
      model->blocks[2].law = 1;
      test_control (model, QN_PROCEDURE_DISPLACEMENT, "b1", QN_DOF_UX, 0.0095);
    }
    for (size_t i = 0; i < model->block_count; i++)
      model->blocks[i].unit_weight = 2e4;
    model->blocks[0].law = 1;
    model->blocks[1].law = 0;
    test_run_solve (&run);
    g_test_message ("bonds %d: stop %d", bonds, (int) run.result.stop);
    g_assert_cmpint (run.result.outcome, !=, QN_OUTCOME_NOT_CONVERGED);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
}

/* In time a member may have any normal force, for its way is not told, but no other shear force than its law's;
 * one that is elastic has no other force at all. */
static void
test_member_in_time (void)
{
  for (int elastic = 0; elastic < 2; elastic++) {
    g_auto (TestRun) run = { 0 };
    QnModel *model = &run.model;
    test_model_init_block_on_plane (model, 0.5, 0.5);
    QnLaw *law = &model->laws[0];
    law->kind = elastic ? QN_LAW_ELASTIC : QN_LAW_CONCRETE;
    law->basis = QN_BASIS_SURFACE;
    law->kn = law->ks = 1e9;
    law->strength = 2e7;
    test_model_add_weight_loads (model, 1);
    model->live_load_count = 0;
    model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
    model->analysis.dynamic.duration = 0.02;
    model->analysis.dynamic.time_step = 0.001;
    QnGroundMotion *motion = qn_model_add_ground_motion (model);
    motion->kind = QN_SIGNAL_PULSE;
    motion->direction = qn_vec2 (1, 0);
    motion->pulse = (QnPulse){ QN_PULSE_HALF_SINE, 1, 0.02, 0 };
    test_run_solve (&run);
    QnPairResult *pair = &run.result.pairs[0];
    double *again =
      run.result.step_forces + 2 * (run.result.step_count - 1) * run.result.pair_count;
    const double force[2] = { pair->normal_force, pair->shear_force };
    g_assert_cmpint (run.result.outcome, !=, QN_OUTCOME_NOT_CONVERGED);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
    pair->shear_force = again[1] = force[1] + 0.1 * fabs (force[0]);
    g_assert_true (test_run_tells (&run, QN_CLAIM_FORCES));
    pair->shear_force = again[1] = force[1];
    pair->normal_force = again[0] = 1.1 * force[0];
    g_assert_cmpint (test_run_tells (&run, QN_CLAIM_FORCES), ==, elastic);
  }
}

/* A joint with a dilatancy of 0.2 that slides rises by a fifth of the slip; beyond the end of dilation it rises no
 * more. The check holds the motion at collapse to that. */
static void
test_ends_of_dilation (void)
{
  for (int ends = 0; ends < 2; ends++) {
    g_auto (TestRun) run = { 0 };
    QnModel *model = &run.model;
    test_model_init_block_on_plane (model, 1, 0.5);
    model->laws[0].friction = 0.4;
    model->laws[0].dilatancy = 0.2;
    model->laws[0].dilation_end = ends ? 1e-4 : 0;
    test_model_add_weight_loads (model, 1);
    add_move (model, 1, QN_DOF_UX, 1e-3, 4);
    qn_model_add_stage (model, "to collapse")->sets = 1;
    test_run_solve (&run);
    QnResult *r = &run.result;
    double *motion = r->mechanism + QN_DOF_COUNT;
    g_assert_cmpint (r->outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (r->collapse_multiplier, 0.4, 1e-6);
    g_assert_false (r->mechanism_uncertain);
    g_assert_cmpfloat_with_epsilon (motion[QN_DOF_UY] / motion[QN_DOF_UX], ends ? 0 : 0.2,
                                    1e-3);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
    motion[QN_DOF_UY] = (ends ? 0.2 : 0) * motion[QN_DOF_UX];
    g_assert_true (test_run_tells (&run, QN_CLAIM_OVERLAP)
                   || test_run_tells (&run, QN_CLAIM_FLOW));
  }
}

/* A tie that has yielded between two steps holds less than its length alone tells, if a motion led from the one to
 * the other; never more than its strength, and it never pushes. */
static void
test_tie_stretched_on_the_way (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 1, 1);
  model->laws[0].kind = QN_LAW_ELASTIC;
  QnTie *tie = qn_model_add_tie (model, "tie");
  tie->ends[0] = (QnTieEnd){ 1, { -0.5, 0.5 } };
  tie->ends[1] = (QnTieEnd){ QN_NONE, { -2.5, 0.5 } };
  tie->area = 1e-4;
  tie->elasticity = 2e11;
  tie->yield = 2e7;
  test_model_add_weight_loads (model, 1);
  model->live_load_count = 0;
  add_force (model, "live", 1e4, 0);
  add_stage (model, 1, 3);
  add_stage (model, 1, 0.4);
  test_run_solve (&run);
  QnResult *r = &run.result;
  const size_t pulled = end_of (r, 1);
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat_with_epsilon (qn_result_step_ties (r, pulled)->force, 2e3, 1e-3);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);

  drop_steps (r, 1, end_of (r, 2));
  g_assert_false (test_run_tells (&run, QN_CLAIM_TIES));
  r->steps[1].relaxed = false;
  g_assert_true (test_run_tells (&run, QN_CLAIM_TIES));
  r->steps[1].relaxed = true;
  QnTieResult *stated = &r->ties[1];
  const double force = stated->force, wrong[] = { 2.1e3, -10 };
  for (guint i = 0; i < G_N_ELEMENTS (wrong); i++) {
    stated->force = wrong[i];
    g_assert_true (test_run_tells (&run, QN_CLAIM_TIES));
  }
  stated->force = force;
  g_assert_false (test_run_tells (&run, QN_CLAIM_TIES));
}

QN_TESTS
{
  g_test_add_func ("/core/result-check/ends-of-dilation", test_ends_of_dilation);
  g_test_add_func ("/core/result-check/tie-stretched-on-the-way",
                   test_tie_stretched_on_the_way);
  g_test_add_func ("/core/result-check/member-in-time", test_member_in_time);
  g_test_add_func ("/core/result-check/unequal-sides", test_unequal_sides);
  g_test_add_func ("/core/result-check/crushed-and-relieved-on-an-unknown-way",
                   test_crushed_and_relieved_on_an_unknown_way);
  g_test_add_func ("/core/result-check/crushed-a-little-on-an-unknown-way",
                   test_crushed_a_little_on_an_unknown_way);
  g_test_add_func ("/core/result-check/weaker-bond-on-an-unknown-way",
                   test_weaker_bond_on_an_unknown_way);
  g_test_add_func ("/core/result-check/slip-before-an-unknown-way",
                   test_slip_before_an_unknown_way);
  g_test_add_func ("/core/result-check/slip-of-a-damaged-bond",
                   test_slip_of_a_damaged_bond);
  g_test_add_func ("/core/result-check/one-bond-broken", test_one_bond_broken);
  g_test_add_func ("/core/result-check/other-bond-broken", test_other_bond_broken);
  g_test_add_func ("/core/result-check/bond-damaged-on-the-way",
                   test_bond_damaged_on_the_way);
  g_test_add_func ("/core/result-check/fibre-strained-on-the-way",
                   test_fibre_strained_on_the_way);
  g_test_add_func ("/core/result-check/bar-strained-on-the-way",
                   test_bar_strained_on_the_way);
  g_test_add_func ("/core/result-check/joint-that-has-risen", test_joint_that_has_risen);
  g_test_add_func ("/core/result-check/between-supports", test_between_supports);
}
