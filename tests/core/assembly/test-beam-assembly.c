#include "core/solver.h"

#include "core/path/analysis.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static QnId
add_riding_node (QnModel *model, const char *name, QnId block, QnSeat seat, double x,
                 double y)
{
  QnNode *node = qn_model_add_node (model, name);
  node->seat = seat;
  node->block = block;
  node->at = qn_vec2 (x, y);
  node->side = QN_BLOCK_SIDE_TOP;
  return (QnId) model->node_count - 1;
}

static QnBeam *
add_beam (QnModel *model, const char *name, QnId first, QnId second, int32_t elements)
{
  QnBeam *beam = qn_model_add_beam (model, name);
  beam->nodes[0] = first;
  beam->nodes[1] = second;
  beam->section = 0;
  beam->element_count = elements;
  return beam;
}

/* 0.2 x 0.3 m, E = 10 GPa, nu = 0.2, 20 kN/m3. */
static QnSection *
add_section (QnModel *model)
{
  QnSection *section = qn_model_add_section (model, "s");
  section->young = 10e9;
  section->poisson = 0.2;
  section->width = 0.2;
  section->height = 0.3;
  section->unit_weight = 20e3;
  return section;
}

static QnLoad *
add_line_load (QnModel *model, bool live, QnId beam, double x, double y)
{
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  load->kind = QN_LOAD_LINE;
  load->beam = beam;
  load->vector = qn_vec2 (x, y);
  return load;
}

static QnLoad *
add_node_load (QnModel *model, bool live, QnId node, double x, double y, double moment)
{
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  load->kind = QN_LOAD_NODE;
  load->node = node;
  load->vector = qn_vec2 (x, y);
  load->moment = moment;
  return load;
}

static QnTie *
add_tie (QnModel *model, const char *name, QnId first, QnVec2 from, QnId second,
         QnVec2 to)
{
  QnTie *tie = qn_model_add_tie (model, name);
  tie->ends[0] = (QnTieEnd){ first, from };
  tie->ends[1] = (QnTieEnd){ second, to };
  tie->area = 1e-3;
  tie->elasticity = 2e11;
  return tie;
}

/* A wall with beams between its blocks, at every kind of seat, with hinges and loads of every
 * kind; and ties that pull, hang slack, flow and are being tensioned. */
static void
init_mixture (QnModel *model, QnGeometry geometry)
{
  test_model_init_wall (model, 3, 0.3);
  model->analysis.geometry = geometry;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  add_section (model);
  QnId shared = add_riding_node (model, "n1", 4, QN_SEAT_CENTROID, 0, 0);
  QnId point = add_riding_node (model, "n2", 20, QN_SEAT_POINT, 1.1, 1.9);
  QnId side = add_riding_node (model, "n3", 40, QN_SEAT_SIDE, 0, 0);
  QnId free = test_model_add_node (model, "n4", 2.5, 2.2, "y");
  add_beam (model, "b1", shared, point, 3);
  add_beam (model, "b2", point, free, 2)->hinge[0] = true;
  add_beam (model, "b3", free, side, 1)->kind = QN_BEAM_EULER_BERNOULLI;
  QnVec2 low = qn_vec2 (0.5, 0.7), high = qn_vec2 (2.1, 1.8);
  add_tie (model, "t1", 4, low, 20, high)->prestress = 3e5;
  add_tie (model, "t2", 20, high, 10, low)->slack = 0.1;
  add_tie (model, "t3", QN_NONE, qn_vec2 (-3, 1), 40, high)->yield = 1e4;
  add_tie (model, "t4", 12, high, QN_NONE, qn_vec2 (4, 0));
  for (int live = 0; live < 2; live++) {
    add_line_load (model, live, 1, 2e6, -3e6);
    add_node_load (model, live, point, 1e6, 5e6, 2e5);
    add_node_load (model, live, free, 3e6, 1e6, -2e5);
  }
}

static double
entry (const QnAssembly *as, int32_t row, int32_t column)
{
  for (int32_t k = as->ap[column]; k < as->ap[column + 1]; k++)
    if (as->ai[k] == row)
      return as->ax[k];
  return 0;
}

/* K against central differences of R. Blocks and beams as one system, in a state far from rest
 * where geometry is nonlinear. */
static void
check_tangent (QnGeometry geometry)
{
  QnModel model;
  Solver solver;
  init_mixture (&model, geometry);
  solver_init (&solver, &model);
  QnAssembly *as = &solver.equilibrium.assembly;
  int32_t n = as->unknown_count, checked = 0;
  g_autofree double *u = g_new0 (double, n), *plus = g_new0 (double, n),
                    *minus = g_new0 (double, n);
  g_autofree QnPairResponse *at = g_new0 (QnPairResponse, as->pair_count);
  g_autoptr (GRand) random = g_rand_new_with_seed (5);
  double largest = 0;

  for (int32_t i = 0; i < n; i++)
    u[i] = g_rand_double_range (random, -1e-4, 1e-4);
  for (size_t b = 0;
       geometry == QN_GEOMETRY_NONLINEAR && b < qn_model_body_count (&solver.model);
       b++) { /* everything turned by 0.8 rad */
    QnVec2 c = b < solver.model.block_count
                 ? solver.model.blocks[b].centroid
                 : solver.model.nodes[b - solver.model.block_count].at;
    QnVec2 move = qn_vec2_sub (qn_vec2_rotate (c, cos (0.8), sin (0.8)), c);
    const double motion[3] = { move.x, move.y, 0.8 * as->length };
    for (int i = 0; i < 3; i++)
      if (as->unknown[3 * b + (size_t) i] != QN_NONE)
        u[as->unknown[3 * b + (size_t) i]] += motion[i];
  }
  g_assert_true (qn_assembly_evaluate (as, u));
  qn_assembly_tangent (as, 0.3, 0);
  for (int32_t k = 0; k < as->ap[n]; k++)
    largest = fmax (largest, fabs (as->ax[k]));
  for (size_t p = 0; p < as->pair_count; p++)
    at[p] = as->responses[p];

  for (int32_t j = 0; j < n; j++) {
    double h = 1e-9, kept = u[j];
    bool same = true;
    for (int side = 0; side < 2; side++) {
      u[j] = kept + (side ? -h : h);
      g_assert_true (qn_assembly_evaluate (as, u));
      qn_assembly_residual (as, 0.3, side ? minus : plus);
      for (size_t p = 0; p < as->pair_count; p++)
        same =
          same
          && memcmp (at[p].tangent, as->responses[p].tangent, sizeof at[p].tangent) == 0;
    }
    u[j] = kept;
    checked += same;
    for (int32_t i = 0; same && i < n; i++)
      g_assert_cmpfloat (fabs (entry (as, i, j) + (plus[i] - minus[i]) / (2 * h)), <,
                         1e-6 * largest);
  }
  g_assert_cmpint (checked, >, n * 9 / 10);
  solver_clear (&solver);
}

static void
test_tangent_linear (void)
{
  check_tangent (QN_GEOMETRY_LINEAR);
}

static void
test_tangent_nonlinear (void)
{
  check_tangent (QN_GEOMETRY_NONLINEAR);
}

static void
run (QnModel *model, QnContacts *contacts, QnResult *result)
{
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_model_prepare (model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, contacts, NULL, NULL, result, &diag), ==,
                   QN_OK);
}

/* A clamped beam between two ends: exact at the nodes under a uniform load, however few the
 * elements; moments q L^2 / 12 and q L^2 / 24, shear q L / 2. */
static void
test_line_load (void)
{
  for (int elements = 2; elements <= 6; elements += 2) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnResult) result;
    qn_model_init (&model);
    QnSection *section = add_section (&model);
    section->unit_weight = 0;
    test_model_add_node (&model, "a", 0, 0, "xyr");
    test_model_add_node (&model, "b", 4, 0, "xyr");
    add_beam (&model, "m", 0, 1, elements)->kind = QN_BEAM_EULER_BERNOULLI;
    add_line_load (&model, true, 0, 0, -12e3);
    model.analysis.increments = 1;
    model.analysis.max_multiplier = 1;
    run (&model, &contacts, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    const double EI = 10e9 * 0.2 * 0.027 / 12;
    const double *u = qn_result_step_displacements (&result, result.step_count - 1);
    const QnBeamForces *f = qn_result_step_beam_forces (&result, result.step_count - 1);
    g_assert_cmpfloat_with_epsilon (u[3 * (2 + elements / 2 - 1) + 1],
                                    -12e3 * 256 / (384 * EI), 1e-10);
    g_assert_cmpfloat_with_epsilon (f[0].moment[0], -12e3 * 16 / 12, 1e-3);
    g_assert_cmpfloat_with_epsilon (f[elements / 2].moment[0], 12e3 * 16 / 24, 1e-3);
    g_assert_cmpfloat_with_epsilon (f[0].shear[0], 24e3, 1e-3);
    g_assert_cmpfloat_with_epsilon (f[elements - 1].shear[1], -24e3, 1e-3);
  }
}

/* A portal with a strut, loaded sideways and downwards at large displacements: the work of the
 * loads is the energy of the elements. */
static void
test_energy (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  qn_model_init (&model);
  QnSection *section = add_section (&model);
  section->young = 1e7;
  section->unit_weight = 0;
  test_model_add_node (&model, "a", 0, 0, "xyr");
  test_model_add_node (&model, "b", 0, 3, "");
  test_model_add_node (&model, "c", 4, 3, "");
  test_model_add_node (&model, "d", 4, 0, "xy");
  add_beam (&model, "ab", 0, 1, 6);
  add_beam (&model, "bc", 1, 2, 6)->hinge[1] = true;
  add_beam (&model, "dc", 3, 2, 6);
  add_node_load (&model, true, 1, 400, -150, 0);
  add_line_load (&model, true, 1, 0, -30);
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.increments = 400;
  model.analysis.max_multiplier = 1;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);

  QnEquilibrium eq;
  double work = 0, energy = 0;
  g_assert_cmpint (qn_equilibrium_setup (&eq, &model, &contacts, NULL, NULL, NULL), ==,
                   QN_OK);
  const QnAssembly *as = &eq.assembly;
  g_autofree double *before = g_new0 (double, as->unknown_count);
  for (int i = 1; i <= 400; i++) {
    memcpy (before, eq.u, (gsize) as->unknown_count * sizeof *before);
    g_assert_cmpint (newton (&eq, i / 400.0), ==, QN_SOLVE_CONVERGED);
    qn_equilibrium_commit (&eq);
    for (int32_t k = 0; k < as->unknown_count; k++)
      work += (i - 0.5) / 400 * as->live[k] * (eq.u[k] - before[k]);
  }
  for (size_t b = 0; b < as->beams.count; b++)
    for (int i = 0; i < 3; i++)
      energy += 0.5 * as->beams.responses[b].force[i]
                * as->beams.beams[b].kinematics.deformation[i];
  QnId top = as->unknown[QN_DOF_COUNT];
  g_test_message ("sway %.3f m, work %.6f J, energy %.6f J", eq.u[top], work, energy);
  g_assert_cmpfloat (fabs (eq.u[top]), >, 0.3);
  g_assert_cmpfloat_with_epsilon (work / energy, 1, 2e-6);
  qn_equilibrium_clear (&eq);
}

/* Bars on hinges only: nodes without a rotation of their own; forces by statics. */
static void
test_truss (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  qn_model_init (&model);
  add_section (&model)->unit_weight = 0;
  test_model_add_node (&model, "a", 0, 0, "xy");
  test_model_add_node (&model, "b", 4, 0, "y");
  test_model_add_node (&model, "c", 2, 1.5, "");
  const QnId ends[3][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 } };
  for (int i = 0; i < 3; i++) {
    g_autofree char *name = g_strdup_printf ("bar%d", i);
    QnBeam *beam = add_beam (&model, name, ends[i][0], ends[i][1], 1);
    beam->hinge[0] = beam->hinge[1] = true;
  }
  add_node_load (&model, true, 2, 0, -6e3, 0);
  model.analysis.max_multiplier = 1;
  run (&model, &contacts, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  const QnBeamForces *f = qn_result_step_beam_forces (&result, result.step_count - 1);
  g_assert_cmpfloat_with_epsilon (f[0].normal[0], 4e3, 1e-2);
  g_assert_cmpfloat_with_epsilon (f[1].normal[0], -5e3, 1e-2);
  g_assert_cmpfloat_with_epsilon (f[2].normal[1], -5e3, 1e-2);
  g_assert_cmpfloat (fabs (f[1].moment[0]) + fabs (f[1].moment[1]), <, 1e-6);
}

/* A node on a block moves with it; a beam from it to a support holds the block. */
static void
test_rigid_link (void)
{
  for (int seat = QN_SEAT_CENTROID; seat < QN_SEAT_COUNT; seat++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnResult) result;
    test_model_init (&model);
    test_model_add_rectangle (&model, "block", 0, 0, 1, 0.5)->unit_weight = 0;
    add_section (&model)->unit_weight = 0;
    add_riding_node (&model, "n", 0, (QnSeat) seat, 0.8, 0.1);
    test_model_add_node (&model, "far", 3, 2, "xyr");
    add_beam (&model, "b", 0, 1, 1);
    QnLoad *load = qn_model_add_live_load (&model);
    load->kind = QN_LOAD_FORCE;
    load->block = 0;
    load->vector = qn_vec2 (1e3, -2e3);
    load->moment = 300;
    model.analysis.max_multiplier = 1;
    run (&model, &contacts, &result);
    const QnVec2 at = model.nodes[0].at, arm = qn_vec2_sub (at, qn_vec2 (0.5, 0.25));
    if (seat == QN_SEAT_SIDE)
      g_assert_cmpfloat_with_epsilon (at.y, 0.5, 1e-15);
    const double *u = qn_result_step_displacements (&result, result.step_count - 1);
    const QnBeamForces *f = qn_result_step_beam_forces (&result, result.step_count - 1);
    g_assert_cmpfloat_with_epsilon (u[3], u[0] - arm.y * u[2], 1e-15);
    g_assert_cmpfloat_with_epsilon (u[4], u[1] + arm.x * u[2], 1e-15);
    /* The end moment is that of the loads about the node. */
    double moment = 300 - qn_vec2_cross (arm, load->vector);
    g_assert_cmpfloat_with_epsilon (-f[0].moment[0], moment, 1e-6 * 2e3);
  }
}

/* Without an own support a beam that hangs on nothing is refused, and so is one among blocks. */
static void
test_floating (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag = { 0 };
  test_model_init_block_on_plane (&model, 1, 1);
  add_section (&model);
  test_model_add_node (&model, "a", 5, 0, "");
  test_model_add_node (&model, "b", 6, 0, "");
  add_beam (&model, "loose", 0, 1, 1);
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_BEAM_FLOATING);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_BEAM);
  g_assert_cmpint (diag.index, ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/beam-assembly/tangent/linear", test_tangent_linear);
  g_test_add_func ("/beam-assembly/tangent/nonlinear", test_tangent_nonlinear);
  g_test_add_func ("/beam-assembly/line-load", test_line_load);
  g_test_add_func ("/beam-assembly/energy", test_energy);
  g_test_add_func ("/beam-assembly/truss", test_truss);
  g_test_add_func ("/beam-assembly/rigid-link", test_rigid_link);
  g_test_add_func ("/beam-assembly/floating", test_floating);
}
