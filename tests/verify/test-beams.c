/* Beam elements against closed forms: stiffness, collapse, large displacements, vibration. */
#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const double young = 30e9, yield = 20e6;

static QnId
add_section (QnModel *model, const char *name, double height, bool yields)
{
  QnSection *section = qn_model_add_section (model, name);
  section->young = young;
  section->width = 0.2;
  section->height = height;
  section->yield = yields ? yield : 0;
  return (QnId) model->section_count - 1;
}

static QnBeam *
add_beam (QnModel *model, const char *name, QnId first, QnId second, QnId section,
          int32_t elements)
{
  QnBeam *beam = qn_model_add_beam (model, name);
  beam->nodes[0] = first;
  beam->nodes[1] = second;
  beam->section = section;
  beam->element_count = elements;
  return beam;
}

static QnLoad *
add_live_load (QnModel *model, QnLoadKind kind, QnId on, double x, double y)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = kind;
  load->node = load->beam = on;
  load->vector = qn_vec2 (x, y);
  return load;
}

static void
run (QnModel *model, QnResult *result)
{
  g_auto (QnContacts) contacts;
  QnDiag diag = { 0 };
  QnStatus status = qn_model_prepare (model, &diag);
  if (status == QN_OK)
    status = qn_contacts_detect (model, &contacts, &diag);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, "no problem");
  g_assert_cmpint (status, ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, result, &diag), ==,
                   QN_OK);
}

/* A frame L x h, pinned or clamped, pushed at its left corner. Sway: H h = 2 Mp of the weaker of
 * beam and columns where it is pinned, 4 Mp where it is clamped and all yield alike. Equal
 * sections put two plastic hinges on one node, which no stiffness holds then. */
static void
test_frame_collapse (void)
{
  const double strong = 0.2 * cbrt (2), Mp = yield * 0.2 * 0.2 * 0.2 / 4;
  const struct {
    double column;
    const char *feet;
    double expected;
  } frames[] = {
    { strong, "xy", 2 * Mp / 3 },
    { 0.2, "xy", 2 * Mp / 3 },
    { 0.2, "xyr", 4 * Mp / 3 },
    { 0.15, "xy", 2 * Mp * 0.5625 / 3 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (frames); i++)
    for (int32_t elements = 1; elements <= 4; elements += 3) {
      g_auto (QnModel) model;
      g_auto (QnResult) result;
      qn_model_init (&model);
      QnId column = add_section (&model, "column", frames[i].column, true);
      QnId beam = add_section (&model, "beam", 0.2, true);
      QnId a = test_model_add_node (&model, "a", 0, 0, frames[i].feet);
      QnId b = test_model_add_node (&model, "b", 0, 3, ""),
           c = test_model_add_node (&model, "c", 3, 3, "");
      QnId d = test_model_add_node (&model, "d", 3, 0, frames[i].feet);
      add_beam (&model, "left", a, b, column, elements);
      add_beam (&model, "top", b, c, beam, elements);
      add_beam (&model, "right", d, c, column, elements);
      add_live_load (&model, QN_LOAD_NODE, b, 1000, 0);
      model.analysis.increments = 1;
      run (&model, &result);
      g_test_message ("frame %u, %d elements: %.6f kN", (guint) i, elements,
                      result.collapse_multiplier);
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_cmpfloat_with_epsilon (result.collapse_multiplier / frames[i].expected,
                                      1e-3, 2e-7);
    }
}

/* q = (6 + 4 sqrt 2) Mp / L^2 of a propped cantilever: the hinge in the span is found among the
 * elements' ends. */
static void
test_propped_cantilever (void)
{
  const double Mp = yield * 0.2 * 0.04 / 4, L = 4;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  qn_model_init (&model);
  QnId section = add_section (&model, "s", 0.2, true);
  test_model_add_node (&model, "a", 0, 0, "xyr");
  test_model_add_node (&model, "b", L, 0, "y");
  add_beam (&model, "ab", 0, 1, section, 40);
  add_live_load (&model, QN_LOAD_LINE, 0, 0, -1000);
  model.analysis.increments = 1;
  run (&model, &result);
  double expected = (6 + 4 * G_SQRT2) * Mp / (L * L) / 1000;
  g_test_message ("propped: %.5f, exact %.5f", result.collapse_multiplier, expected);
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier / expected, 1, 1e-3);
}

/* Tip of the elastica at P L^2/EI = 10; what halving the elements changes falls by four. */
static void
test_elastica (void)
{
  double before = 0, change = 0;
  for (int32_t elements = 10; elements <= 40; elements *= 2) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    qn_model_init (&model);
    QnSection *section = qn_model_add_section (&model, "s");
    section->young = 1e9;
    section->area = 1;
    section->inertia = 1e-6;
    test_model_add_node (&model, "a", 0, 0, "xyr");
    test_model_add_node (&model, "b", 1, 0, "");
    add_beam (&model, "ab", 0, 1, 0, elements)->kind = QN_BEAM_EULER_BERNOULLI;
    add_live_load (&model, QN_LOAD_NODE, 1, 0, -1e4);
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    model.analysis.increments = 10;
    model.analysis.max_multiplier = 1;
    run (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    const double *u = qn_result_step_displacements (&result, result.step_count - 1) + 3;
    g_test_message ("%d elements: down %.5f in %.5f turned %.5f", elements, -u[1], -u[0],
                    -u[2]);
    if (change != 0)
      g_assert_cmpfloat_with_epsilon (change / (before + u[1]), 4, 0.1);
    change = before != 0 ? before + u[1] : 0;
    before = -u[1];
    if (elements == 40) {
      g_assert_cmpfloat_with_epsilon (-u[1] / 0.81061, 1, 0.005);
      g_assert_cmpfloat_with_epsilon (-u[0] / 0.55500, 1, 0.005);
      g_assert_cmpfloat_with_epsilon (-u[2] / 1.43029, 1, 0.005);
    }
  }
}

/* A cantilever under an end moment of 4 pi EI/L winds up into two full circles: rotations of any
 * size. */
static void
test_roll_up (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  qn_model_init (&model);
  QnSection *section = qn_model_add_section (&model, "s");
  section->young = 1e9;
  section->area = 1;
  section->inertia = 1e-6;
  test_model_add_node (&model, "a", 0, 0, "xyr");
  test_model_add_node (&model, "b", 1, 0, "");
  add_beam (&model, "ab", 0, 1, 0, 40);
  add_live_load (&model, QN_LOAD_NODE, 1, 0, 0)->moment = 4 * G_PI * 1e3;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.increments = 20;
  model.analysis.max_multiplier = 1;
  run (&model, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  const double *u = qn_result_step_displacements (&result, result.step_count - 1) + 3;
  g_test_message ("tip at (%.5f, %.5f), turned %.6f", 1 + u[0], u[1], u[2]);
  g_assert_cmpfloat_with_epsilon (u[2], 4 * G_PI, 1e-6);
  g_assert_cmpfloat_with_epsilon (1 + u[0], 0, 1e-3);
  g_assert_cmpfloat_with_epsilon (u[1], 0, 1e-3);
}

/* Frequencies of a Timoshenko beam, simply supported: closed form; the consistent mass converges
 * from above with the fourth power. Free, its rigid motions have none. */
static void
test_vibration (void)
{
  static const double expected[] = { 315.819, 1151.685, 2304.893, 3627.124 };
  static const size_t number[] = { 0, 1, 3, 4 }; /* motions along the axis between */
  for (int free = 0; free < 2; free++) {
    g_auto (QnModel) model;
    g_auto (QnModes) modes;
    qn_model_init (&model);
    QnId section = add_section (&model, "s", 0.5, false);
    model.sections[section].density = 7000;
    test_model_add_node (&model, "a", 0, 0, free ? "" : "xy");
    test_model_add_node (&model, "b", 3, 0, free ? "" : "xy");
    add_beam (&model, "ab", 0, 1, section, 60);
    test_find_modes (&model, 6, &modes);
    for (size_t i = 0; i < 3 && free; i++)
      g_assert_cmpfloat (modes.omega[i], <, 0.1);
    if (free) /* stiffer than between supports */
      g_assert_cmpfloat (modes.omega[3], >, 315);
    for (size_t i = 0; i < 4 && !free; i++) {
      g_test_message ("omega %.3f, exact %.3f", modes.omega[number[i]], expected[i]);
      g_assert_cmpfloat_with_epsilon (modes.omega[number[i]] / expected[i], 1, 1e-3);
    }
  }
}

/* A block of mass m on a beam without mass to speak of: 3 EI / (m L^3), the rigid link making the
 * cantilever longer than its beam. */
static void
test_block_on_beam (void)
{
  const double EI = young * 0.2 * 0.008 / 12, arm = 0.5, L = 3 + arm;
  g_auto (QnModel) model;
  g_auto (QnModes) modes;
  test_model_init (&model);
  QnBlock *block = test_model_add_rectangle (&model, "mass", 3, -0.05, 2 * arm, 0.1);
  block->unit_weight = 1e6;
  QnId section = add_section (&model, "s", 0.2, false);
  model.sections[section].unit_weight = 1e-3;
  test_model_add_node (&model, "a", 0, 0, "xyr");
  QnNode *end = qn_model_add_node (&model, "b");
  end->seat = QN_SEAT_SIDE;
  end->block = 0;
  end->side = QN_BLOCK_SIDE_LEFT;
  add_beam (&model, "ab", 0, 1, section, 1)->kind = QN_BEAM_EULER_BERNOULLI;
  test_find_modes (&model, 1, &modes);
  /* Flexibility of the block's centroid: beam of 3 m under a force with an arm of 0.5 m. */
  const double w = (9 + 2 * 4.5 * arm + 3 * arm * arm) / EI, r = (4.5 + 3 * arm) / EI;
  const double m = 1e6 * 0.1 / 9.81, J = m * (1 + 0.01) / 12, c = 3 / EI;
  /* (w - 1/(m o^2)) (c - 1/(J o^2)) = r^2 */
  double a = m * J * (w * c - r * r), sum = m * w + J * c;
  double omega = sqrt ((sum - sqrt (sum * sum - 4 * a)) / (2 * a));
  g_test_message ("omega %.6f, exact %.6f (L %.1f)", modes.omega[0], omega, L);
  g_assert_cmpfloat_with_epsilon (modes.omega[0] / omega, 1, 1e-6);
}

/* A mast on a block, driven by its head's displacement past the peak: the block overturns at
 * W b/2 over its height, whatever the mast's stiffness; in large displacements the load falls. */
static void
test_mast (void)
{
  for (int nonlinear = 0; nonlinear < 2; nonlinear++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init (&model);
    test_model_add_base (&model, -1, -1, 3, 1);
    test_model_add_rectangle (&model, "footing", 0, 0, 1, 1)->unit_weight = 20e3;
    QnId section = add_section (&model, "s", 0.2, false);
    model.sections[section].unit_weight = 0;
    QnNode *foot = qn_model_add_node (&model, "foot");
    foot->seat = QN_SEAT_SIDE;
    foot->block = 1;
    foot->side = QN_BLOCK_SIDE_TOP;
    test_model_add_node (&model, "head", 0.5, 3, "");
    add_beam (&model, "mast", 0, 1, section, 4);
    QnLoad *weight = qn_model_add_dead_load (&model);
    weight->kind = QN_LOAD_WEIGHT;
    weight->vector = qn_vec2 (0, -1);
    add_live_load (&model, QN_LOAD_NODE, 1, 1000, 0);
    model.analysis.geometry = nonlinear ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    model.analysis.procedure = QN_PROCEDURE_DISPLACEMENT;
    model.analysis.control.node = 1;
    model.analysis.control.target = 0.3;
    model.analysis.increments = 100;
    run (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    double peak = 0, last = result.steps[result.step_count - 1].multiplier;
    for (size_t i = 0; i < result.step_count; i++)
      peak = fmax (peak, result.steps[i].multiplier);
    g_test_message ("peak %.5f, at 0.3 m %.5f", peak, last);
    /* Turned by t about its corner (1, 0), the head, with what the mast gives, has gone 0.3 m:
     * 3 sin t - 0.5 cos t + 0.5 + P L^3/3EI. The joint's give is left out. */
    double t = 0, expected = 10. / 3;
    for (int i = 0; i < 50 && nonlinear; i++) {
      double give = 1000 * expected * 8 / (3 * young * 0.2 * 0.008 / 12);
      t = asin ((0.3 - give - 0.5 + 0.5 * cos (t)) / 3);
      expected = 20 * (0.5 * cos (t) - 0.5 * sin (t)) / (3 * cos (t) + 0.5 * sin (t));
    }
    if (!nonlinear)
      g_assert_cmpfloat_with_epsilon (peak, 10. / 3, 1e-6);
    g_assert_cmpfloat_with_epsilon (last / expected, 1, nonlinear ? 1e-3 : 1e-6);
  }
}

QN_TESTS
{
  g_test_add_func ("/verify/beams/frame-collapse", test_frame_collapse);
  g_test_add_func ("/verify/beams/propped-cantilever", test_propped_cantilever);
  g_test_add_func ("/verify/beams/elastica", test_elastica);
  g_test_add_func ("/verify/beams/roll-up", test_roll_up);
  g_test_add_func ("/verify/beams/vibration", test_vibration);
  g_test_add_func ("/verify/beams/block-on-beam", test_block_on_beam);
  g_test_add_func ("/verify/beams/mast", test_mast);
}
