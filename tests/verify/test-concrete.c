/* Plain concrete that cracks: what breaks it is its fracture energy, whatever the cells, the increments and
 * what is controlled. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <math.h>

#define GF        100.0
#define THICKNESS 0.1

/* As the law of fibres, and as that of joints with a bond. */
static void
init (TestRun *run, QnLawKind kind)
{
  *run = (TestRun){ 0 };
  qn_model_init (&run->model);
  QnLaw *law = qn_model_add_law (&run->model, "concrete");
  *law = (QnLaw){ .name = law->name,
                  .kind = kind,
                  .basis = QN_BASIS_MATERIAL,
                  .elasticity = 30e9,
                  .arrangement = QN_ARRANGEMENT_GRID,
                  .tension = 2.5e6,
                  .strength = 30e6,
                  .fracture_energy = GF,
                  .friction = 1.4,
                  .cohesion = 4.3e6,
                  .fracture_energy_tension = GF,
                  .fracture_energy_shear = 10 * GF,
                  .exponential = true,
                  .compression = 30e6 };
  qn_law_derive (law);
  run->model.contact.law = 0;
}

static QnBlock *
add_cell (QnModel *model, const char *name, QnVec2 at, QnVec2 size)
{
  QnBlock *block = test_model_add_rectangle (model, name, at.x, at.y, size.x, size.y);

  block->thickness = THICKNESS;
  block->unit_weight = 0;
  return block;
}

/* A stiff end of a specimen, held in the degrees of freedom of `support`, bit by bit. */
static void
add_plate (QnModel *model, const char *name, QnVec2 at, QnVec2 size, int support)
{
  QnBlock *block = add_cell (model, name, at, size);

  block->rigid = true;
  for (int dof = 0; dof < 3; dof++)
    block->support[dof] = support >> dof & 1;
}

static void
push (QnModel *model, const char *name, QnVec2 force, QnVec2 arm)
{
  QnId block = qn_model_find_block (model, name);
  QnLoad *load = qn_model_add_live_load (model);

  load->kind = QN_LOAD_FORCE;
  load->block = block;
  load->vector = force;
  load->moment = qn_vec2_cross (arm, force);
}

/* The work done by the force of `push`, up to the last step; its peak. */
static double
work_of (const TestRun *run, const char *name, QnVec2 force, QnVec2 arm, double *peak)
{
  const QnId block = qn_model_find_block (&run->model, name);
  double work = 0, way = 0, multiplier = 0;

  *peak = 0;
  for (size_t i = 0; i < run->result.step_count; i++) {
    const double *u = qn_result_step_displacements (&run->result, i) + 3 * block;
    double now = run->result.steps[i].multiplier;
    double along = u[0] * force.x + u[1] * force.y + u[2] * qn_vec2_cross (arm, force);
    work += 0.5 * (now + multiplier) * (along - way);
    way = along;
    multiplier = now;
    *peak = fmax (*peak, now);
  }
  return work;
}

/* A bar held by half of its height and pulled apart at an eccentricity: the crack runs through this section,
 * and takes the fracture energy times its area, of however many cells the bar is. */
static void
test_energy (void)
{
  static const double length = 0.2, height = 0.1, held = 0.05;
  static const int cells[] = { 1, 2, 5 };

  for (int kind = 0; kind < 2; kind++)
    for (size_t c = 0; c < G_N_ELEMENTS (cells); c++) {
      g_auto (TestRun) run;
      init (&run, kind == 0 ? QN_LAW_CONCRETE : QN_LAW_MOHR_COULOMB);
      QnModel *model = &run.model;
      const QnVec2 size = { length / cells[c], height }, force = { 1e3, 0 },
                   arm = { 0, 0.004 };
      add_plate (model, "held", qn_vec2 (-0.1, (height - held) / 2), qn_vec2 (0.1, held),
                 7);
      for (int i = 0; i < cells[c]; i++) {
        g_autofree char *name = g_strdup_printf ("c%d", i);
        add_cell (model, name, qn_vec2 (i * size.x, 0), size);
      }
      add_plate (model, "pulled", qn_vec2 (length, 0), qn_vec2 (0.1, height), 0);
      push (model, "pulled", force, arm);
      test_control (model, QN_PROCEDURE_DISPLACEMENT, "pulled", QN_DOF_UX, 1e-3);
      model->analysis.increments = 400;
      test_run_solve (&run);
      double peak, work = work_of (&run, "pulled", force, arm, &peak);
      g_test_message ("%d, %d cells: %.5g J, %.5g kN", kind, cells[c], work, peak);
      g_assert_cmpfloat_with_epsilon (work / (GF * THICKNESS * held), 1, 0.025);
    }
}

/* A beam of 1.8 x 0.5 m on plates, pushed in the middle; its peak, kN. */
static double
bend (QnLawKind kind, int nx, int ny, QnProcedure procedure, int increments,
      double target)
{
  g_auto (TestRun) run;
  init (&run, kind);
  QnModel *model = &run.model;
  const QnVec2 size = { 2.0 / nx, 0.5 / ny }, plate = { 0.1, 0.05 };
  for (int i = 0; i < nx * ny; i++) {
    g_autofree char *name = g_strdup_printf ("c%d", i);
    add_cell (model, name, qn_vec2 (i % nx * size.x - 1, i / nx * size.y), size);
  }
  add_plate (model, "left", qn_vec2 (-0.95, -0.05), plate, 3);
  add_plate (model, "right", qn_vec2 (0.85, -0.05), plate, 2);
  add_plate (model, "load", qn_vec2 (-0.05, 0.5), plate, 0);
  push (model, "load", qn_vec2 (0, -1e3), qn_vec2 (0, 0));
  test_control (model, procedure, "load", QN_DOF_UY, -target);
  model->analysis.increments = increments;
  test_run_solve (&run);
  double peak;
  work_of (&run, "load", qn_vec2 (0, -1e3), qn_vec2 (0, 0), &peak);
  g_test_message ("%d x %d, %d: %.4f kN", nx, ny, (int) procedure, peak);
  return peak;
}

/* The strength does not hang on the cells, and beyond the first crack the beam carries more, as concrete of
 * this depth does: a brittle one, or one that is elastic to its strength, carries 4 ft I / (h/2) / L. */
static void
test_cells (void)
{
  static const int cells[][2] = { { 12, 5 }, { 16, 7 }, { 20, 8 } };
  const double brittle = 4 * 2.5e6 * THICKNESS * 0.25 / 6 / 1.8 / 1e3;

  for (int kind = 0; kind < 2; kind++) {
    double least = INFINITY, most = 0;
    for (size_t c = 0; c < G_N_ELEMENTS (cells); c++) {
      double peak = bend (kind == 0 ? QN_LAW_CONCRETE : QN_LAW_MOHR_COULOMB, cells[c][0],
                          cells[c][1], QN_PROCEDURE_DISPLACEMENT, 20, 0.16e-3);
      least = fmin (least, peak);
      most = fmax (most, peak);
    }
    g_assert_cmpfloat (most / least, <, 1.05);
    g_assert_cmpfloat (least, >, 1.2 * brittle);
    g_assert_cmpfloat (most, <, 1.6 * brittle);
  }
}

/* Nor on how long the steps may be, nor on what is controlled: cracks open one after the other, not all
 * that a long step would open at once. */
static void
test_steps (void)
{
  static const struct {
    QnProcedure procedure;
    int increments;
    double target;
  } runs[] = {
    { QN_PROCEDURE_DISPLACEMENT, 100, 0.2e-3 },
    { QN_PROCEDURE_DISPLACEMENT, 3, 2e-3 },
    { QN_PROCEDURE_WORK, 10, 5e-4 },
    { QN_PROCEDURE_ARC_LENGTH, 10, 5e-4 },
  };
  for (int kind = 0; kind < 2; kind++) {
    double first = 0;
    for (size_t i = 0; i < G_N_ELEMENTS (runs); i++) {
      double peak = bend (kind == 0 ? QN_LAW_CONCRETE : QN_LAW_MOHR_COULOMB, 8, 3,
                          runs[i].procedure, runs[i].increments, runs[i].target);
      first = i == 0 ? peak : first;
      g_assert_cmpfloat_with_epsilon (peak / first, 1, 0.01);
    }
  }
}

/* --- A reinforced section -------------------------------------------------------------------- */

#define WIDTH   0.3
#define HEIGHT  0.5
#define COVER   0.05
#define STEEL   1.5e-3 /* m2 on either side */
#define FC      30e6
#define FY      500e6
#define CRUSHED 0.0035

/* Normal force (tension positive) and moment of plane strains: compression `top` at one edge, none at the
 * depth x below it. Parabola and rectangle, elastic-plastic steel. */
static void
section (double top, double x, double *normal, double *moment)
{
  const int fibres = 4000;

  *normal = *moment = 0;
  for (int i = 0; i < fibres + 2; i++) {
    bool steel = i >= fibres;
    double depth = i == fibres       ? COVER
                   : i == fibres + 1 ? HEIGHT - COVER
                                     : (i + 0.5) / fibres * HEIGHT;
    double e = top * (1 - depth / x), r = fmin (e / 0.002, 1);
    double force = steel   ? STEEL * fmin (fmax (200e9 * e, -FY), FY)
                   : e > 0 ? FC * r * (2 - r) * WIDTH * HEIGHT / fibres
                           : 0;
    *normal -= force;
    *moment += force * (HEIGHT / 2 - depth);
  }
}

/* The moment at which the edge reaches its ultimate strain, under a normal force. */
static double
hand_moment (double normal)
{
  double low = 0.02, high = 20 * HEIGHT, n, m;

  for (int i = 0; i < 100; i++) {
    double x = 0.5 * (low + high);
    section (CRUSHED, x, &n, &m);
    if (n > normal)
      low = x;
    else
      high = x;
  }
  return m;
}

/* Under twelve normal forces, from tension to far beyond the balanced one. */
static void
test_interaction (void)
{
  for (int i = 0; i < 12; i++) {
    const double normal = 0.4e6 - 0.4e6 * i, hand = hand_moment (normal);
    g_auto (TestRun) run;
    init (&run, QN_LAW_CONCRETE);
    QnModel *model = &run.model;
    QnLaw *law = &model->laws[0];
    law->arrangement = QN_ARRANGEMENT_CHAIN;
    law->tension = law->fracture_energy = 0;
    law->strength = FC;
    law->ultimate_strain = CRUSHED;
    law->crushing_energy = 3000;
    law = qn_model_add_law (model, "steel");
    law->kind = QN_LAW_ELASTIC_PLASTIC;
    law->basis = QN_BASIS_MATERIAL;
    law->kn = law->ks = 200e9;
    law->yield = FY;
    add_plate (model, "base", qn_vec2 (0, -0.1), qn_vec2 (HEIGHT, 0.1), 7);
    add_cell (model, "block", qn_vec2 (0, 0), qn_vec2 (HEIGHT, 0.2));
    for (size_t b = 0; b < model->block_count; b++)
      model->blocks[b].thickness = WIDTH;
    for (int side = 0; side < 2; side++) {
      const double x = side == 0 ? COVER : HEIGHT - COVER;
      QnBar *bar = qn_model_add_bar (model);
      *bar = (QnBar){ .law = 1, .area = STEEL, .start = { x, -0.05 }, .end = { x, 0.1 } };
    }
    model->contact.pairs =
      (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 100 };
    QnLoad *load = qn_model_add_dead_load (model);
    load->kind = QN_LOAD_FORCE;
    load->block = 1;
    load->vector = qn_vec2 (0, normal);
    load = qn_model_add_live_load (model);
    load->kind = QN_LOAD_FORCE;
    load->block = 1;
    load->moment = 1e3;
    test_control (model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_RZ, 3e-3);
    model->analysis.increments = 40;
    test_run_solve (&run);
    double peak = 0;
    for (size_t s = 0; s < run.result.step_count; s++)
      peak = fmax (peak, run.result.steps[s].multiplier * 1e3);
    g_test_message ("N %.1f MN: %.2f kN m, by hand %.2f, %.2f %%", normal / 1e6,
                    peak / 1e3, hand / 1e3, 100 * (peak / hand - 1));
    g_assert_cmpfloat_with_epsilon (peak / hand, 1, 0.01);
  }
}

/* A prism whose first block is a little lower is crushed there, and nowhere else, whatever the number of blocks
 * (the example of localisation of the method's authors): shortening at a force by hand, with the peak of the
 * crushed section at `ec`, its descent by the energy, the rest of the prism unloading elastically. */
static void
test_crushing (void)
{
  static const int counts[] = { 2, 3, 5, 9 };
  const double fc = 30e6, e = 30e9, ec = 2 * fc / e, gc = 1e5, thin = 0.038, thick = 0.04;

  for (size_t c = 0; c < G_N_ELEMENTS (counts); c++) {
    g_auto (TestRun) run;
    init (&run, QN_LAW_CONCRETE);
    QnModel *model = &run.model;
    const int last = counts[c] - 1;
    const double l = 1.0 / last;
    model->laws[0].tension = model->laws[0].fracture_energy = 0;
    model->laws[0].ultimate_strain = ec;
    model->laws[0].crushing_energy = gc;
    for (int i = 0; i <= last; i++) {
      g_autofree char *name = i == last ? g_strdup ("top") : g_strdup_printf ("b%d", i);
      double height = i == 0 ? 0.19 : 0.2;
      QnBlock *block =
        add_cell (model, name, qn_vec2 ((i - 0.5) * l, -height / 2), qn_vec2 (l, height));
      block->thickness = 0.2;
      block->support[QN_DOF_UX] = i == 0;
      block->support[QN_DOF_UY] = block->support[QN_DOF_RZ] = true;
    }
    push (model, "top", qn_vec2 (-1e3, 0), qn_vec2 (0, 0));
    test_control (model, QN_PROCEDURE_DISPLACEMENT, "top", QN_DOF_UX, -4e-3);
    model->analysis.increments = 200;
    test_run_solve (&run);
    double peak = 0, force = 1e3 * run.result.steps[run.result.step_count - 1].multiplier;
    for (size_t i = 0; i < run.result.step_count; i++)
      peak = fmax (peak, 1e3 * run.result.steps[i].multiplier);
    double most = thin * fc / thick; /* stress beside the crushed section, at the peak */
    double descent = (fc - force / thin) / fc * (2 * gc / fc - fc / e * l);
    double rest = ec * (1 - sqrt (1 - most / fc)) - (most - force / thick) / e;
    double shortening = ec * l + descent + rest * (1 - l);
    g_test_message ("%d blocks: peak %.5g, %.5g kN at %.5g mm", counts[c], peak / 1e3,
                    force / 1e3, 1e3 * shortening);
    g_assert_cmpfloat_with_epsilon (peak / (thin * fc), 1, 1e-4);
    g_assert_cmpfloat_with_epsilon (shortening, 4e-3, 2e-6);
  }
}

QN_TESTS
{
  g_test_add_func ("/verify/concrete/crushing", test_crushing);
  g_test_add_func ("/verify/concrete/energy", test_energy);
  g_test_add_func ("/verify/concrete/cells", test_cells);
  g_test_add_func ("/verify/concrete/steps", test_steps);
  g_test_add_func ("/verify/concrete/interaction", test_interaction);
}
