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

QN_TESTS
{
  g_test_add_func ("/verify/concrete/energy", test_energy);
  g_test_add_func ("/verify/concrete/cells", test_cells);
  g_test_add_func ("/verify/concrete/steps", test_steps);
}
