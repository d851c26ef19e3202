/* Continuous members in linear geometry against closed forms of textbook mechanics. */
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* The member of all tests: 3 m long, 0.5 m deep, 0.2 m thick, E = 30 GPa, nu = 0. */
static const double L = 3, depth = 0.5, width = 0.2, young = 30e9, yield = 20e6;

/* A cantilever of equal blocks on a support of rigid stuff, so that the first face is the
 * clamped section; law 0 is the member's. */
static void
init_cantilever (QnModel *model, int blocks, QnLawKind kind, QnPairRule pairs)
{
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "member");
  *law = (QnLaw){ .name = law->name,
                  .kind = kind,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = young,
                  .ks = young / 2,
                  .shear_factor = 5. / 6,
                  .yield = yield };
  law = qn_model_add_law (model, "rigid");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = 1e6 * young,
                  .ks = 1e6 * young };
  model->contact.law = 0;
  model->contact.pairs = pairs;
  QnBlock *base = test_model_add_base (model, -0.1, -depth / 2, 0.1, depth);
  base->law = 1;
  base->thickness = width;
  for (int i = 0; i < blocks; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i + 1);
    double h = L / blocks;
    test_model_add_rectangle (model, name, i * h, -depth / 2, h, depth)->thickness =
      width;
  }
}

static void
add_tip_load (QnModel *model, double force)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = (QnId) model->block_count - 1;
  load->vector = qn_vec2 (0, -force);
  load->has_at = true;
  load->at = qn_vec2 (L, 0);
}

static void
solve (QnModel *model, QnContacts *contacts, QnResult *result)
{
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_model_prepare (model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, contacts, NULL, NULL, result, &diag), ==,
                   QN_OK);
}

/* Downward displacement of the tip, m, of equal blocks from the support's centroid to the load's:
 * every face stands for as much of the member as there is between two centroids. */
static double
tip_displacement (int blocks, QnPairRule pairs)
{
  const double h = L / (blocks - 1);
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  init_cantilever (&model, 0, QN_LAW_ELASTIC, pairs);
  model.blocks[0].law = QN_NONE;
  model.vertices[0].x = model.vertices[3].x = -h / 2;
  model.vertices[1].x = model.vertices[2].x = h / 2;
  for (int i = 1; i < blocks; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    test_model_add_rectangle (&model, name, (i - 0.5) * h, -depth / 2, h, depth)
      ->thickness = width;
  }
  add_tip_load (&model, 100e3);
  model.analysis.increments = 1;
  model.analysis.max_multiplier = 1;
  solve (&model, &contacts, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  const double *u = qn_result_step_displacements (&result, result.step_count - 1);
  double tip = -u[3 * (blocks - 1) + 1];
  return tip;
}

static QnPairRule
gauss (int count)
{
  return (QnPairRule){ .placement = QN_PLACEMENT_GAUSS, .count = count };
}

static QnPairRule
uniform (int count)
{
  return (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = count };
}

/* 14.400 mm of bending and 0.240 mm of shear: within 0.5 % at 20 blocks and 10 pairs. */
static void
test_cantilever (void)
{
  double tip = tip_displacement (20, gauss (10));
  g_test_message ("20 blocks, 10 pairs: %.6f mm", 1e3 * tip);
  g_assert_cmpfloat_with_epsilon (tip / 14.640e-3, 1, 0.002);
  g_assert_cmpfloat_with_epsilon (tip_displacement (20, gauss (2)), tip, 1e-12);
}

/* The error falls by four when the blocks are halved; it is the midpoint rule's. */
static void
test_second_order (void)
{
  double before = 0;
  for (int faces = 5; faces <= 40; faces *= 2) {
    double error = tip_displacement (faces + 1, gauss (2)) - 14.640e-3;
    g_test_message ("%d faces: error %.4f %%", faces, error / 14.640e-5);
    g_assert_cmpfloat_with_epsilon (error, -14.400e-3 / (4.0 * faces * faces), 1e-9);
    if (before != 0)
      g_assert_cmpfloat_with_epsilon (before / error, 4, 1e-4);
    before = error;
  }
}

/* Evenly spaced pairs, three or more, bend like the continuous section. */
static void
test_uniform_pairs (void)
{
  double exact = tip_displacement (20, gauss (2));
  g_assert_cmpfloat_with_epsilon (tip_displacement (20, uniform (10)) / 14.640e-3, 1,
                                  0.001);
  for (int n = 3; n <= 48; n *= 2)
    g_assert_cmpfloat_with_epsilon (tip_displacement (20, uniform (n)) / exact, 1, 1e-9);
  /* Two have no freedom for it: 1 - 1/4. */
  double two = (exact - 0.240e-3) / 0.75 + 0.240e-3;
  g_assert_cmpfloat_with_epsilon (tip_displacement (20, uniform (2)) / two, 1, 1e-5);
}

/* Gauss and Lobatto's, three or more, too; the ends alone are three times as stiff. */
static void
test_lobatto_pairs (void)
{
  double exact = tip_displacement (20, gauss (2));
  double ends = (exact - 0.240e-3) / 3 + 0.240e-3;
  for (int n = 3; n <= 9; n++)
    g_assert_cmpfloat_with_epsilon (
      tip_displacement (20, (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = n })
        / exact,
      1, 1e-9);
  g_assert_cmpfloat_with_epsilon (tip_displacement (20, (QnPairRule){ 0 }) / exact, 1,
                                  1e-9);
  g_assert_cmpfloat_with_epsilon (
    tip_displacement (20, (QnPairRule){ .placement = QN_PLACEMENT_ENDS }) / ends, 1,
    1e-5);
}

/* One face under a growing moment: M / M0 = 1.5 - 0.5 / k^2 beyond first yield. */
static void
test_moment_curvature (void)
{
  const double first = yield * width * depth * depth / 6; /* M0 */
  const double curvature = 2 * yield / (young * depth);
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  init_cantilever (&model, 1, QN_LAW_ELASTIC_PLASTIC, uniform (100));
  QnLoad *load = qn_model_add_live_load (&model);
  load->kind = QN_LOAD_FORCE;
  load->block = 1;
  load->moment = first;
  model.analysis.increments = 20;
  model.analysis.max_multiplier = 1.48;
  solve (&model, &contacts, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  double furthest = 0;
  for (size_t i = 1; i < result.step_count; i++) {
    double rotation = qn_result_step_displacements (&result, i)[3 + QN_DOF_RZ];
    double k = rotation / (curvature * L / 2); /* the face stands for half of the block */
    double expected = k <= 1 ? k : 1.5 - 0.5 / (k * k);
    g_assert_cmpfloat_with_epsilon (result.steps[i].multiplier / expected, 1, 0.002);
    furthest = fmax (furthest, k);
  }
  g_assert_cmpfloat (furthest, >, 4.5);
}

static double
collapse_load (QnModel *model)
{
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  solve (model, &contacts, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  double load = result.collapse_multiplier;
  qn_model_clear (model);
  return load;
}

/* Plastic load 83.333 kN: within 1 % at 10 pairs, 5/(8 n^2) too much. */
static void
test_plastic_load (void)
{
  static const int pairs[] = { 10, 20, 40 };
  for (size_t i = 0; i < G_N_ELEMENTS (pairs); i++) {
    QnModel model;
    init_cantilever (&model, 20, QN_LAW_ELASTIC_PLASTIC, uniform (pairs[i]));
    add_tip_load (&model, 1e3);
    model.analysis.increments = 1;
    double load = collapse_load (&model);
    g_test_message ("%d pairs: %.4f kN", pairs[i], load);
    double n = pairs[i];
    g_assert_cmpfloat_with_epsilon (load / 83.3333, 1 + 5 / (8 * n * n), 2e-4);
  }
}

/* Reinforced section, steel above and below: As fy (d - a/2) with a the depth of the compressed
 * block, between the bars' forces that plane sections allow. The lower bar lies inside the
 * compressed zone's elastic part, so that the exact moment is found by a search over the
 * neutral axis with stresses of the same laws. */
static double
section_moment (double curvature, double strength, double area, double cover, double fy)
{
  double low = -0.5 * depth, high = 0.5 * depth, moment = 0;
  for (int i = 0; i < 100; i++) {
    double axis = 0.5 * (low + high), force = 0;
    moment = 0;
    enum { FIBRES = 2000 };
    for (int k = 0; k < FIBRES; k++) {
      double y = depth * ((k + 0.5) / FIBRES - 0.5), e = curvature * (y - axis);
      double x = fmin (1, -e * young / (2 * strength));
      double stress = e < 0 ? -strength * x * (2 - x) : 0;
      force += stress * width * depth / FIBRES;
      moment += stress * y * width * depth / FIBRES;
    }
    for (int side = -1; side <= 1; side += 2) {
      double y = side * (0.5 * depth - cover);
      double stress = fmax (-fy, fmin (fy, 200e9 * curvature * (y - axis)));
      force += stress * area;
      moment += stress * area * y;
    }
    if (force > 0)
      low = axis; /* too much tension: the axis must rise */
    else
      high = axis;
  }
  return moment;
}

static void
test_reinforced (void)
{
  const double area = 4e-4, fy = 500e6, strength = 30e6, cover = 0.05;
  QnModel model;
  init_cantilever (&model, 10, QN_LAW_CONCRETE, uniform (100));
  model.laws[0].strength = strength;
  QnLaw *steel = qn_model_add_law (&model, "steel");
  *steel = (QnLaw){ .name = steel->name,
                    .kind = QN_LAW_ELASTIC_PLASTIC,
                    .basis = QN_BASIS_MATERIAL,
                    .kn = 200e9,
                    .ks = 77e9,
                    .yield = fy };
  for (int side = -1; side <= 1; side += 2) {
    QnBar *bar = qn_model_add_bar (&model);
    double y = side * (0.5 * depth - cover);
    *bar = (QnBar){ .law = 2, .area = area, .start = { -0.05, y }, .end = { 2.9, y } };
  }
  add_tip_load (&model, 1e3);
  model.analysis.increments = 1;
  double load = collapse_load (&model);
  double expected = section_moment (0.2, strength, area, cover, fy) / L / 1e3;
  g_test_message ("found %.4f kN, plane sections %.4f kN", load, expected);
  g_assert_cmpfloat_with_epsilon (load / expected, 1, 0.005);
}

/* Soft on stiff: a stone of 20 GPa on a bed of 1 GPa, in compression. */
static void
test_soft_on_stiff (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  init_cantilever (&model, 1, QN_LAW_ELASTIC, gauss (2));
  model.laws[0].kn = 20e9;
  model.laws[1].kn = 1e9;
  QnLoad *load = qn_model_add_live_load (&model);
  load->kind = QN_LOAD_FORCE;
  load->block = 1;
  load->vector = qn_vec2 (-1e5, 0);
  model.analysis.increments = 1;
  model.analysis.max_multiplier = 1;
  solve (&model, &contacts, &result);

  double area = depth * width, force = 1e5, soft = 0.05 / 1e9, stiff = 1.5 / 20e9;
  double expected = -force / area * (soft + stiff);
  const double *u = qn_result_step_displacements (&result, result.step_count - 1) + 3;
  g_assert_cmpfloat_with_epsilon (u[0] / expected, 1, 1e-9);
  for (size_t i = 0; i < 2; i++) {
    const QnPairResult *pair = &result.pairs[i];
    g_assert_true (pair->has_springs);
    g_assert_cmpfloat_with_epsilon (pair->elongation_a[0] / (-force / area * soft), 1,
                                    1e-9);
    g_assert_cmpfloat_with_epsilon (pair->elongation_b[0] / (-force / area * stiff), 1,
                                    1e-9);
    /* The base is fixed: C has moved by what the bed gives. */
    g_assert_cmpfloat_with_epsilon (pair->hinge.x, -force / area * soft, 1e-15);
    g_assert_cmpfloat_with_epsilon (pair->hinge.y, contacts.pairs[i].point.y, 1e-15);
  }
}

/* A block by contact on a column of cells by material: shortening under N, shear under V at the joint,
 * rotation under M. The joint's two pairs are at its ends, so that the half cell behind it has three times
 * its bending stiffness. */
static void
test_block_on_cells (void)
{
  enum { CELLS = 4 };
  const double cell = 0.3, height = CELLS * cell, area = depth * width;
  const double inertia = width * depth * depth * depth / 12, kn = 3e8, ks = 1e8;
  const double N = 5e5, V = 2e5, M = 3e4, shear = young / 2 * 5 / 6;
  QnModel model;
  QnContacts contacts;
  QnResult result;
  init_cantilever (&model, 0, QN_LAW_ELASTIC, (QnPairRule){ 0 });
  model.contact.pairs.placement = QN_PLACEMENT_DEFAULT;
  QnLaw *joint = qn_model_add_law (&model, "joint");
  *joint = (QnLaw){ .name = joint->name,
                    .kind = QN_LAW_COULOMB,
                    .basis = QN_BASIS_CONTACT,
                    .kn = kn,
                    .ks = ks,
                    .friction = 0.6 };
  model.blocks[0].law = 0;
  model.blocks[0].rigid = true;
  for (int i = 0; i <= CELLS; i++) {
    g_autofree char *name = g_strdup_printf ("c%d", i);
    QnBlock *block =
      test_model_add_rectangle (&model, name, i * cell, -depth / 2, cell, depth);
    block->thickness = width;
    block->unit_weight = 0;
  }
  const QnId top = (QnId) model.block_count - 1;
  model.blocks[top].law = 2;
  QnLoad *load = qn_model_add_dead_load (&model);
  *load = (QnLoad){ .kind = QN_LOAD_FORCE, .block = top, .vector = { -N, 0 } };
  load = qn_model_add_live_load (&model);
  *load = (QnLoad){ .kind = QN_LOAD_FORCE,
                    .block = top,
                    .vector = { 0, V },
                    .has_at = true,
                    .at = { height, 0 } };
  load = qn_model_add_live_load (&model);
  *load = (QnLoad){ .kind = QN_LOAD_FORCE, .block = top, .moment = M };
  model.analysis.increments = 1;
  model.analysis.max_multiplier = 1;
  solve (&model, &contacts, &result);

  const double *dead = qn_result_step_displacements (&result, 0) + 3 * top;
  const double *u = qn_result_step_displacements (&result, 1) + 3 * top;
  const double shortening = N * (height / (young * area) + 1 / (2 * kn));
  const double pair = 1 / (1 / kn + cell / (young * area));
  double turn = M * 2 / (pair * depth * depth);
  double sway = V * (height / (shear * area) + 1 / (2 * ks));
  for (int i = 0; i < CELLS; i++) {
    const double arm = height - i * cell, length = i == 0 ? cell / 2 : cell;
    const double curvature = (M + V * arm) / (young * inertia);
    turn += curvature * length;
    sway += curvature * length * arm;
  }
  g_assert_cmpfloat_with_epsilon (-dead[0] / shortening, 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (u[2] / turn, 1, 1e-9);
  g_assert_cmpfloat_with_epsilon ((u[1] - u[2] * cell / 2) / sway, 1, 1e-9);
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

/* A steel beam under its own weight on two narrow piers without friction: 31 cells over a span of 3 m.
 * Joints of the piers open at their outer edge and clamp it a little: by the moment of the reactions
 * and of the overhang. */
static void
test_beam_on_piers (void)
{
  enum { CELLS = 31 };
  const double cell = 0.1, height = 0.2, thick = 0.1, bearing = 0.02, weight = 78500;
  const double steel = 210e9, shear = steel / 2.6, q = weight * thick * height;
  const double bending = steel * thick * height * height * height / 12;
  QnModel model;
  QnContacts contacts;
  QnResult result;

  qn_model_init (&model);
  QnLaw *law = qn_model_add_law (&model, "bearing");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_COULOMB,
                  .basis = QN_BASIS_CONTACT,
                  .kn = 1e12,
                  .ks = 1e12,
                  .friction = 1e-6 };
  law = qn_model_add_law (&model, "steel");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = steel,
                  .ks = shear };
  model.contact.law = 0;
  for (int i = 0; i < 2; i++) {
    QnBlock *pier = test_model_add_rectangle (&model, i == 0 ? "left" : "right",
                                              i * L - bearing / 2, -1, bearing, 1);
    for (int k = 0; k < QN_DOF_COUNT; k++)
      pier->support[k] = true;
    pier->thickness = thick;
    pier->unit_weight = 0;
  }
  for (int i = 0; i < CELLS; i++) {
    g_autofree char *name = g_strdup_printf ("c%d", i);
    QnBlock *block =
      test_model_add_rectangle (&model, name, (i - 0.5) * cell, 0, cell, height);
    block->thickness = thick;
    block->unit_weight = weight;
    block->law = 1;
  }
  QnLoad *load = qn_model_add_dead_load (&model);
  *load = (QnLoad){ .kind = QN_LOAD_WEIGHT, .vector = { 0, -1 } };
  model.analysis.increments = 1;
  model.analysis.max_multiplier = 0;
  solve (&model, &contacts, &result);

  const double *u = qn_result_step_displacements (&result, 0);
  const double *reaction = qn_result_step_reactions (&result, 0);
  const double deflection = u[3 * 2 + 1] - u[3 * (2 + CELLS / 2) + 1];
  const double clamping = fabs (reaction[2]) + q * cell * cell / 8;
  g_assert_cmpfloat_with_epsilon (reaction[1] / (q * CELLS * cell / 2), 1, 1e-9);
  g_assert_cmpfloat (fabs (reaction[2]), <=, reaction[1] * bearing / 2);
  g_assert_cmpfloat_with_epsilon (deflection
                                    / (5 * q * L * L * L * L / (384 * bending)
                                       + q * L * L / (8 * shear * thick * height)
                                       - clamping * L * L / (8 * bending)),
                                  1, 1e-3);
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

QN_TESTS
{
  g_test_add_func ("/verify/members/beam-on-piers", test_beam_on_piers);
  g_test_add_func ("/verify/members/block-on-cells", test_block_on_cells);
  g_test_add_func ("/verify/members/cantilever", test_cantilever);
  g_test_add_func ("/verify/members/second-order", test_second_order);
  g_test_add_func ("/verify/members/uniform-pairs", test_uniform_pairs);
  g_test_add_func ("/verify/members/lobatto-pairs", test_lobatto_pairs);
  g_test_add_func ("/verify/members/moment-curvature", test_moment_curvature);
  g_test_add_func ("/verify/members/plastic-load", test_plastic_load);
  g_test_add_func ("/verify/members/reinforced", test_reinforced);
  g_test_add_func ("/verify/members/soft-on-stiff", test_soft_on_stiff);
}
