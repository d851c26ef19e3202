/* Paths whose joints part, bend or break: what stays of a branch, and what of it is told. */
#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

/* --- Branches on which nothing stays ----------------------------------------------------- */

#define EI 4e6 /* Nm2, of a section of 0.2 x 0.2 m */

static void
add_beam (QnModel *model, const char *name, QnId from, QnId to, int32_t elements)
{
  QnBeam *beam = qn_model_add_beam (model, name);
  beam->nodes[0] = from;
  beam->nodes[1] = to;
  beam->section = 0;
  beam->element_count = elements;
}

/* Straight, 4 m, clamped at its foot and pressed down at its head by 1 kN; or the frame of two such
 * columns under a beam of 4 m, pressed down at both corners. */
static void
init_columns (QnModel *model, int columns)
{
  QnId heads[2];

  test_model_init (model);
  QnSection *section = qn_model_add_section (model, "section");
  section->young = 3e10;
  section->width = section->height = 0.2;
  for (int i = 0; i < columns; i++) {
    QnNode *foot = qn_model_add_node (model, i == 0 ? "foot" : "foot 2");
    foot->at = qn_vec2 (4 * i, 0);
    foot->support[0] = foot->support[1] = foot->support[2] = true;
    QnNode *head = qn_model_add_node (model, i == 0 ? "head" : "head 2");
    head->at = qn_vec2 (4 * i, 4);
    heads[i] = (QnId) model->node_count - 1;
    add_beam (model, i == 0 ? "column" : "column 2", heads[i] - 1, heads[i], 24);
    QnLoad *load = qn_model_add_live_load (model);
    load->kind = QN_LOAD_NODE;
    load->node = heads[i];
    load->vector = qn_vec2 (0, -1000);
  }
  if (columns == 2)
    add_beam (model, "beam", heads[0], heads[1], 12);
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
}

/* Pressed down by a given way, straight columns stay straight for Newton's method, at many times the
 * load at which they buckle, where two eigenvalues are negative and the determinant is positive. Columns
 * bend as an elastica that shortens and shears (Runge-Kutta). The frame sways, at all increments at the
 * same load. */
static void
test_beyond_buckling (void)
{
  static const int increments[] = { 10, 20, 100, 200, 1000 };
  static const struct {
    int columns;
    bool pinned;
    double way, exact;
  } forms[] = { { 1, false, -2.5, 915.336 },
                { 1, true, -2.5, 3646.047 },
                { 2, false, -1, NAN } };
  double sways = NAN;

  for (size_t f = 0; f < G_N_ELEMENTS (forms); f++)
    for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
      g_auto (QnModel) model;
      g_auto (QnResult) result;
      init_columns (&model, forms[f].columns);
      if (forms[f].pinned) {
        model.nodes[0].support[QN_DOF_RZ] = false;
        model.nodes[1].support[QN_DOF_UX] = true;
        model.beams[0].element_count = 48; /* as many to a quarter of a wave */
      }
      test_control (&model, QN_PROCEDURE_DISPLACEMENT, NULL, QN_DOF_UY, forms[f].way);
      model.analysis.control.node = 1;
      model.analysis.increments = increments[i];
      test_analyse (&model, &result);
      double multiplier = result.steps[result.step_count - 1].multiplier;
      double exact = isnan (forms[f].exact) ? sways : forms[f].exact;
      g_test_message ("form %zu, %d increments: %.3f, %d factorisations", f,
                      increments[i], multiplier, result.statistics.factorizations);
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
      if (isnan (exact))
        sways = multiplier;
      else
        g_assert_cmpfloat_with_epsilon (multiplier, exact, 1e-3 * exact);
    }
  /* Clamped feet, heads that turn against the beam: between once and four times a column alone. */
  g_assert_cmpfloat (sways, >, G_PI * G_PI * EI / 64 / 1000);
  g_assert_cmpfloat (sways, <, 4 * G_PI * G_PI * EI / 64 / 1000 * 2);
}

/* The same under a prescribed load: what was called "without collapse" is bent. */
static void
test_loaded_beyond_buckling (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  init_columns (&model, 1);
  model.analysis.max_multiplier = 916.62;
  test_analyse (&model, &result);
  const double *head = qn_result_step_displacements (&result, result.step_count - 1) + 3;
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat_with_epsilon (head[1], -2.5, 0.01);
}

/* Whatever the procedure and its increments: where the straight branch ends is told, at the multiplier that
 * the search for the loss of stability finds, Euler's load of a column alone. A column that is pushed aside
 * as well bends from the start and loses nothing. */
static void
test_end_of_branch (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  static const int increments[] = { 1, 20, 200 };
  const double euler = G_PI * G_PI * EI / 64 / 1000;

  for (int columns = 1; columns <= 2; columns++)
    for (gsize p = 0; p < G_N_ELEMENTS (procedures); p++)
      for (gsize i = 0; i < 2 * G_N_ELEMENTS (increments); i++) {
        bool aside = i % 2 == 1;
        double end = columns == 1 ? 1.1 * euler : 4 * euler;
        g_auto (QnModel) model;
        g_auto (QnContacts) contacts;
        g_auto (QnResult) result, search;
        init_columns (&model, columns);
        if (aside)
          model.live_loads[0].vector.x = 1;
        test_control (&model, procedures[p], NULL, QN_DOF_UY, -0.3);
        model.analysis.control.node = 1;
        model.analysis.max_multiplier = end;
        model.analysis.increments = increments[i / 2];
        test_analyse (&model, &result);
        const QnPathEvent *buckling = qn_result_find_buckling (&result);
        g_assert_true ((buckling != NULL) == !aside);
        if (aside)
          continue;
        const double multiplier = buckling->multiplier;
        g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
        g_assert_cmpint (qn_stability_run (&model, &contacts, NULL, NULL, &search, NULL),
                         ==, QN_OK);
        g_test_message ("%d columns, procedure %d: %.4f, search %.4f, Euler %.4f",
                        columns, (int) procedures[p], multiplier,
                        search.first_limit_multiplier, euler);
        g_assert_cmpfloat_with_epsilon (multiplier / search.first_limit_multiplier, 1,
                                        model.analysis.multiplier_tolerance);
        if (columns == 1)
          g_assert_cmpfloat_with_epsilon (multiplier / euler, 1, 1e-3);
        else
          g_assert_cmpfloat (multiplier, >, 1.01 * euler);
        /* It is that of a step, and who asks to stop there stops there. */
        model.analysis.snap = QN_SNAP_THROUGH_STOP;
        qn_result_clear (&result);
        test_analyse (&model, &result);
        g_assert_cmpint (result.outcome, ==, QN_OUTCOME_SNAP);
        g_assert_cmpfloat (result.first_limit_multiplier, ==, multiplier);
        g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==,
                           multiplier);
      }
}

/* --- Joints without tension --------------------------------------------------------------- */

/* A block, and a stack, whose joints lose their shear forces at once when they open: they rock at
 * width / height, by every procedure. */
static void
test_no_tension (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH,
                                            QN_PROCEDURE_DISPLACEMENT };
  static const struct {
    int blocks;
    double width, height;
  } stacks[] = { { 1, 0.4, 1.2 }, { 4, 0.6, 0.3 }, { 12, 1, 0.3 } };

  for (size_t i = 0; i < 2 * G_N_ELEMENTS (procedures) * G_N_ELEMENTS (stacks); i++) {
    size_t s = i / 2 % G_N_ELEMENTS (stacks), p = i / 2 / G_N_ELEMENTS (stacks);
    double exact = stacks[s].width / (stacks[s].blocks * stacks[s].height), highest = 0;
    bool held = procedures[p] == QN_PROCEDURE_DISPLACEMENT;
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_stack (&model, stacks[s].blocks, stacks[s].width, stacks[s].height);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kind = QN_LAW_NO_TENSION;
    model.laws[0].kn = model.laws[0].ks = 1e9;
    model.analysis.increments = i % 2 ? 100 : 10;
    test_control (&model, procedures[p], NULL, QN_DOF_UX, 0.2);
    if (held)
      model.analysis.control.block = (QnId) model.block_count - 1;
    test_analyse (&model, &result);
    for (size_t step = 0; step < result.step_count; step++)
      highest = fmax (highest, result.steps[step].multiplier);
    g_assert_cmpint (result.outcome, ==,
                     held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (highest, exact, 1e-6);
  }
}

#define VOUSSOIRS 15

/* Semicircular, radii 0.9 and 1.1 m, joints without tension. */
static void
init_arch (QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1.2, -0.3, 2.4, 0.3);
  for (int i = 0; i < VOUSSOIRS; i++) {
    double from = G_PI * (1 - (double) i / VOUSSOIRS);
    double to = G_PI * (1 - (double) (i + 1) / VOUSSOIRS);
    const QnVec2 vertices[] = { qn_vec2 (0.9 * cos (from), 0.9 * sin (from)),
                                qn_vec2 (0.9 * cos (to), 0.9 * sin (to)),
                                qn_vec2 (1.1 * cos (to), 1.1 * sin (to)),
                                qn_vec2 (1.1 * cos (from), 1.1 * sin (from)) };
    g_autofree char *name = g_strdup_printf ("v%d", i);
    QnBlock *block = qn_model_add_block (model, name, vertices, 4);
    block->thickness = 1;
    block->unit_weight = 10000;
  }
  test_model_add_weight_loads (model, 1);
  model->laws[0].kind = QN_LAW_NO_TENSION;
  model->laws[0].kn = model->laws[0].ks = 1e9;
}

/* An arch of such joints comes to the load of limit analysis by every procedure; in large displacements to
 * one peak just below. */
static void
test_no_tension_arch (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH,
                                            QN_PROCEDURE_DISPLACEMENT };
  double exact, peak = NAN;
  g_auto (QnModel) rigid;
  g_auto (QnResult) limit;
  init_arch (&rigid);
  rigid.analysis.procedure = QN_PROCEDURE_LIMIT;
  test_analyse (&rigid, &limit);
  exact = limit.collapse_multiplier;
  g_assert_cmpfloat (exact, >, 0.05);

  for (size_t i = 0; i < 4 * G_N_ELEMENTS (procedures); i++) {
    QnProcedure procedure = procedures[i / 4];
    bool held = procedure == QN_PROCEDURE_DISPLACEMENT, moves = i % 2 == 1;
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    init_arch (&model);
    test_control (&model, procedure, held ? "v7" : NULL, QN_DOF_UX, 0.02);
    model.analysis.increments = i / 2 % 2 == 0 ? 10 : 100;
    model.analysis.geometry = moves ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    double highest = 0;
    test_analyse (&model, &result);
    for (size_t step = 0; step < result.step_count; step++)
      highest = fmax (highest, result.steps[step].multiplier);
    g_test_message (
      "procedure %d, %d increments, moves %d: %.6f of %.6f, %d factorisations", procedure,
      model.analysis.increments, moves, highest, exact, result.statistics.factorizations);
    g_assert_cmpint (result.outcome, ==,
                     held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
    if (!moves)
      g_assert_cmpfloat_with_epsilon (highest, exact, 1e-4 * exact);
    else if (isnan (peak))
      peak = highest;
    else
      g_assert_cmpfloat_with_epsilon (highest, peak, 2e-4 * peak);
  }
  g_assert_cmpfloat (peak, <, exact);
  g_assert_cmpfloat (peak, >, 0.98 * exact);
}

/* In large displacements stacks carry a little less than width / height, and lean on at once: long steps
 * would pass that peak. Every procedure finds it to the tolerance of the multiplier, whatever its steps. */
static void
test_peaks_between_steps (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH, QN_PROCEDURE_LOAD };
  static const int increments[] = { 5, 10, 100 };
  static const QnLawKind laws[] = { QN_LAW_NO_TENSION, QN_LAW_COULOMB };
  static const struct {
    int blocks;
    double width, height, peak; /* of joints of 1e9 N/m, found in 1,000 increments too */
  } stacks[] = { { 1, 0.4, 1.2, 0.33330 },
                 { 4, 0.6, 0.3, 0.49996 },
                 { 12, 1, 0.3, 0.27756 } };

  for (size_t s = 0; s < G_N_ELEMENTS (stacks); s++)
    for (size_t l = 0; l < G_N_ELEMENTS (laws); l++)
      for (size_t p = 0; p < G_N_ELEMENTS (procedures); p++)
        for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
          bool held = procedures[p] == QN_PROCEDURE_DISPLACEMENT;
          g_auto (QnModel) model;
          g_auto (QnResult) result;
          test_model_init_stack (&model, stacks[s].blocks, stacks[s].width,
                                 stacks[s].height);
          test_model_add_weight_loads (&model, 1);
          model.laws[0].kind = laws[l];
          model.laws[0].friction = 2;
          model.laws[0].kn = model.laws[0].ks = 1e9;
          model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
          model.analysis.increments = increments[i];
          test_control (&model, procedures[p], NULL, QN_DOF_UX, 0.15 * stacks[s].width);
          if (held)
            model.analysis.control.block = (QnId) model.block_count - 1;
          test_analyse (&model, &result);
          g_test_message ("%d blocks, law %d, procedure %d, %d increments: %.6f, %d "
                          "factorisations",
                          stacks[s].blocks, laws[l], procedures[p], increments[i],
                          result.collapse_multiplier, result.statistics.factorizations);
          g_assert_cmpint (result.outcome, ==,
                           held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
          g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, stacks[s].peak,
                                          2e-4 * stacks[s].peak);
        }
}

/* A wall that lies turned with its loads takes the same steps: no measure knows of the axes. A collapse
 * found directly is exact to a part of the tolerance of the multiplier. */
static void
test_turned (void)
{
  for (int wall = 1; wall <= 5; wall++) {
    QnResult results[2];
    for (int turned = 0; turned < 2; turned++) {
      g_auto (QnModel) model;
      test_model_init_wall (&model, wall, 0);
      g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
      if (turned)
        test_model_rotate (&model, 2.4);
      test_analyse (&model, &results[turned]);
    }
    g_assert_cmpuint (results[0].step_count, ==, results[1].step_count);
    for (size_t s = 0; s < results[0].step_count; s++)
      g_assert_cmpfloat_with_epsilon (results[0].steps[s].multiplier,
                                      results[1].steps[s].multiplier, 1e-6);
    qn_result_clear (&results[0]);
    qn_result_clear (&results[1]);
  }
}

/* --- Bonds ------------------------------------------------------------------------------- */

/* A block b x h stuck to its base at two pairs, each with the tension ft: its heel comes off at
 * lambda = b (ft + W/2) / (W h/2), and from then on it rocks at b/h, by every procedure. */
static void
test_bond_of_a_rocking_block (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  const double b = 1, h = 2, weight = 2e4, tension = 5e3;
  const double first = b * (tension + weight / 2) / (weight * h / 2);

  for (size_t i = 0; i < 2 * G_N_ELEMENTS (procedures); i++) {
    bool tough = i >= G_N_ELEMENTS (procedures);
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_block_on_plane (&model, b, h);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kn = model.laws[0].ks = 1e9;
    model.laws[0].friction = 1;
    model.laws[0].cohesion = 2e4;
    model.laws[0].tension = tension;
    model.laws[0].fracture_energy_tension =
      tough ? 0.05 : 0; /* ten times the elastic one */
    test_control (&model, procedures[i % G_N_ELEMENTS (procedures)],
                  i % G_N_ELEMENTS (procedures) > 0 ? "block" : NULL, QN_DOF_UX, 0.01);
    test_analyse (&model, &result);

    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, first, 2e-3 * first);
    g_assert_true (result.has_broken_bound);
    g_assert_cmpfloat_with_epsilon (result.broken_bound, b / h, 1e-6);
    if (i % G_N_ELEMENTS (procedures) == 0)
      continue;
    g_assert_true (result.outcome == QN_OUTCOME_TARGET_REACHED
                   || result.stop == QN_STOP_PLATEAU);
    const QnStep *last = &result.steps[result.step_count - 1];
    g_assert_cmpfloat_with_epsilon (last->multiplier, b / h, 1e-6);
    int broken = 0;
    for (size_t s = 0; s < result.step_count; s++)
      for (size_t p = 0; p < 2; p++) {
        QnPairResult pair = qn_result_pair_at (&result, s, p);
        if (pair.damage < 1 || pair.state != QN_PAIR_OPEN)
          continue;
        broken++;
        g_assert_cmpfloat (pair.normal_force, ==, 0);
        g_assert_cmpfloat (pair.shear_force, ==, 0);
      }
    g_assert_cmpint (broken, >, 5);
  }
}

static QnLaw *
set_bond (QnModel *model, double stiffness, double cohesion, double tension,
          double energy)
{
  QnLaw *law = &model->laws[0];
  law->basis = QN_BASIS_SURFACE;
  law->kn = law->ks = stiffness;
  law->cohesion = cohesion;
  law->tension = tension;
  law->fracture_energy_tension = energy;
  return law;
}

/* Work on block 1 of a lift that is its weight times the multiplier, J, without that on the weight. */
static double
lifting_work (const QnResult *result, double weight)
{
  double work = 0;
  for (size_t s = 1; s < result->step_count; s++) {
    double rise = qn_result_step_displacements (result, s)[4]
                  - qn_result_step_displacements (result, s - 1)[4];
    double mean = 0.5 * (result->steps[s].multiplier + result->steps[s - 1].multiplier);
    work += (mean - 1) * weight * rise;
  }
  return work;
}

/* What it takes to pull a block straight off its base is the fracture energy of both pairs,
 * besides its weight. */
static void
test_fracture_energy_of_a_joint (void)
{
  const double weight = 2e4, energy = 2;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  test_model_init_block_on_plane (&model, 1, 2);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, 1);
  model.blocks[1].support[QN_DOF_UX] = model.blocks[1].support[QN_DOF_RZ] = true;
  model.laws[0].kn = model.laws[0].ks = 1e8;
  model.laws[0].cohesion = 1e5;
  model.laws[0].tension = 5e3;
  model.laws[0].fracture_energy_tension = energy;
  model.analysis.increments = 400;
  test_control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UY, 1e-3);
  test_analyse (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  double stored = 0.5 * weight * weight / (2 * 5e7); /* by the weight, before */
  g_assert_cmpfloat_with_epsilon (lifting_work (&result, weight) + stored, 2 * energy,
                                  5e-3 * energy);
  for (size_t p = 0; p < 2; p++)
    g_assert_cmpfloat (result.pairs[p].damage, ==, 1);
}

/* Free to tilt it falls to a side soon after the peak: where, is found by shorter steps, which do not halve
 * the way there for ever. */
static void
test_way_to_a_fall (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  test_model_init_block_on_plane (&model, 1, 0.5);
  QnLaw *law = set_bond (&model, 1e10, 1e5, 5e4, 50);
  QnLoad *live = qn_model_add_live_load (&model);
  live->kind = QN_LOAD_FORCE;
  live->block = 1;
  live->vector = qn_vec2 (0, 1);
  model.analysis.increments = 400;
  test_control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UY, 4e-3);
  test_analyse (&model, &result);
  g_assert_cmpint (result.stop, ==, QN_STOP_FALL);
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, law->tension, 1);
  g_assert_cmpuint (result.step_count, <, 100);
}

/* Along an exponential curve the block could tilt long before the bond is broken: what is beyond that is
 * not found by shorter steps. */
static void
test_softening_beyond_a_bifurcation (void)
{
  const double weight = 1e4, energy = 50, target = 1e-3;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  test_model_init_block_on_plane (&model, 1, 1);
  QnLaw *law = set_bond (&model, 1e9, 3e5, 2e5, energy);
  law->fracture_energy_shear = 10 * energy;
  law->exponential = true;
  model.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 5 };
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, 1);
  test_control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UY, target);
  test_analyse (&model, &result);

  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 1 + law->tension / weight,
                                  1e-2);
  size_t last = result.step_count - 1;
  g_assert_cmpfloat_with_epsilon (qn_result_step_displacements (&result, last)[4], target,
                                  1e-9);
  g_assert_cmpfloat_with_epsilon (lifting_work (&result, weight), energy, 0.01 * energy);
  g_assert_cmpint (result.statistics.factorizations, <, 5000);
}

QN_TESTS
{
  g_test_add_func ("/path-control/softening-beyond-a-bifurcation",
                   test_softening_beyond_a_bifurcation);
  g_test_add_func ("/path-control/bond-of-a-rocking-block", test_bond_of_a_rocking_block);
  g_test_add_func ("/path-control/fracture-energy", test_fracture_energy_of_a_joint);
  g_test_add_func ("/path-control/way-to-a-fall", test_way_to_a_fall);
  g_test_add_func ("/path-control/beyond-buckling", test_beyond_buckling);
  g_test_add_func ("/path-control/loaded-beyond-buckling", test_loaded_beyond_buckling);
  g_test_add_func ("/path-control/end-of-branch", test_end_of_branch);
  g_test_add_func ("/path-control/no-tension", test_no_tension);
  g_test_add_func ("/path-control/no-tension-arch", test_no_tension_arch);
  g_test_add_func ("/path-control/peaks-between-steps", test_peaks_between_steps);
  g_test_add_func ("/path-control/turned", test_turned);
}
