/* Reinforced concrete: a tension chord against the theory of its cracks, a panel in pure shear. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <math.h>

#define ES 200e9
#define EC 33e9

/* --- A tension chord --------------------------------------------------------------------------
 *
 * A bar along a row of cells, pulled at one end. Blocks of steel stand for it, which the concrete holds by
 * bond: a shear stress tau = 2 ft around the bar, whatever the slip (Marti, Alvarez, Kaufmann & Sigrist,
 * Struct. Eng. Int. 8 (1998) 287-298). A crack takes the stress off the concrete over the length
 *
 *   l0 = ft phi / (4 rho tau)
 *
 * on both sides, so that cracks lie l0 to 2 l0 apart. Where they lie s apart, the bar strains less than a
 * bare one by tau s / (phi Es) in the mean. Strengths scatter by 2 % from joint to joint, without which all
 * would crack at once. */

#define CELLS  40
#define LENGTH 1.0
#define SIDE   0.1
#define PHI    0.016
#define FT     3e6
#define TAU    (2 * FT)
#define AREA   (G_PI / 4 * PHI * PHI)
#define RHO    (AREA / (SIDE * SIDE))

static QnId
add_concrete (QnModel *model, int index)
{
  g_autofree char *name = g_strdup_printf ("concrete %d", index);
  QnLaw *law = qn_model_add_law (model, name);

  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_CONCRETE,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = EC,
                  .ks = EC / 2,
                  .strength = 30e6,
                  .tension =
                    FT * (0.98 + 0.04 * (index * 0.618034 - floor (index * 0.618034))),
                  .fracture_energy = 100 };
  return (QnId) model->law_count - 1;
}

static void
add_piece (QnModel *model, char kind, int i, double y, double height, double thickness,
           QnId law)
{
  const double dx = LENGTH / CELLS;
  g_autofree char *name = g_strdup_printf ("%c%d", kind, i);
  QnBlock *block = test_model_add_rectangle (model, name, i * dx, y, dx, height);

  block->thickness = thickness;
  block->unit_weight = 0;
  block->law = law;
  block->support[1] = block->support[2] = true;
}

static void
join (QnModel *model, QnId a, QnId b, QnId law)
{
  QnFaceOverride *joint = qn_model_add_override (model);
  *joint = (QnFaceOverride){ .block_a = a, .block_b = b, .law = law };
}

/* With blocks of steel that bond holds, and strengths by joint or by cell; or with a bar bonded for good. The
 * first CELLS blocks are of concrete. */
typedef enum { BY_JOINT, BY_CELL, BONDED } Chord;

static void
init_chord (TestRun *run, Chord kind)
{
  const bool slips = kind != BONDED;
  *run = (TestRun){ 0 };
  QnModel *model = &run->model;
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "steel");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = ES,
                  .ks = ES / 2 };
  law = qn_model_add_law (model, "bond"); /* four times, on a width of phi pi / 4 */
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_COULOMB,
                  .basis = QN_BASIS_SURFACE,
                  .kn = 1e12,
                  .ks = 1e12,
                  .cohesion = 4 * TAU,
                  .tension = 4 * TAU,
                  .fracture_energy_tension = 1e4,
                  .fracture_energy_shear = 4 * TAU * 0.02 };
  for (int i = 0; i < CELLS; i++)
    add_piece (model, 'c', i, 0, SIDE, SIDE, 0);
  for (int i = 0; slips && i < CELLS; i++) {
    add_piece (model, 's', i, -PHI, PHI, AREA / PHI, 0);
    join (model, i, CELLS + i, 1);
  }
  for (int i = 0; i + 1 < CELLS; i++)
    if (kind == BY_CELL)
      model->blocks[i].law = add_concrete (model, i);
    else
      join (model, i, i + 1, add_concrete (model, i));
  model->contact.law = 0;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 3 };
  model->blocks[slips ? CELLS : 0].support[0] = true;
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = slips ? 2 * CELLS - 1 : CELLS - 1;
  load->vector = qn_vec2 (1e3, 0);
  if (!slips) {
    QnBar *bar = qn_model_add_bar (model);
    *bar = (QnBar){ .law = 0,
                    .area = AREA,
                    .start = { LENGTH / CELLS / 2, SIDE / 2 },
                    .end = { LENGTH * (1 - 0.5 / CELLS), SIDE / 2 } };
  }
}

/* Where the concrete has parted by more than it stretches, and by how much; their number. */
static int
find_cracks (const TestRun *run, size_t step, double at[CELLS], double width[CELLS])
{
  const double *u = qn_result_step_displacements (&run->result, step);
  int count = 0;

  for (int i = 0; i + 1 < CELLS; i++) {
    double opening = u[3 * (i + 1)] - u[3 * i];
    if (opening > 3 * FT / EC * LENGTH / CELLS) {
      at[count] = (i + 1) * LENGTH / CELLS;
      width[count++] = opening;
    }
  }
  return count;
}

static void
test_chord (void)
{
  const double l0 = FT * PHI / (4 * RHO * TAU), cell = LENGTH / CELLS;
  const double first = FT * (SIDE * SIDE + ES / EC * AREA);
  double at[CELLS], width[CELLS], cracked = 0;
  g_auto (TestRun) run;
  init_chord (&run, BY_JOINT);
  test_control (&run.model, QN_PROCEDURE_DISPLACEMENT, "s39", QN_DOF_UX, 2e-3);
  run.model.analysis.increments = 30;
  test_run_solve (&run);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);

  const QnResult *result = &run.result;
  for (size_t i = 0; i < result->step_count && find_cracks (&run, i, at, width) == 0; i++)
    cracked = fmax (cracked, result->steps[i].multiplier * 1e3);
  const size_t last = result->step_count - 1;
  const int count = find_cracks (&run, last, at, width);
  g_test_message ("first crack at %.2f kN, hand %.2f; %d cracks", cracked / 1e3,
                  first / 1e3, count);
  g_assert_cmpfloat (cracked, >, 0.975 * first);
  g_assert_cmpfloat (cracked, <, 1.0 * first);

  double mean = 0, widest = 0;
  for (int i = 0; i < count; i++) {
    const double gap = at[i] - (i == 0 ? 0 : at[i - 1]);
    g_test_message ("crack at %.3f m, %.3f from the last, %.3f mm", at[i], gap,
                    1e3 * width[i]);
    g_assert_cmpfloat (gap, >, l0 - cell);
    g_assert_cmpfloat (gap, <, 2 * l0 + cell);
    mean += width[i] / count;
    widest = fmax (widest, width[i]);
  }
  const double stress = result->steps[last].multiplier * 1e3 / AREA;
  const double spacing = LENGTH / (count + 1);
  const double strain = 2e-3 / (LENGTH - cell);
  const double stiffened = stress / ES - TAU * spacing / (PHI * ES);
  /* fib Model Code 2010, 7.6.4.4: 2 ls (eps_sm - eps_cm) with tau 1.8 ft and beta 0.6, without cover;
   * EN 1992-1-1, 7.3.4: k1 0.8, k2 1, kt 0.6. */
  const double less = 0.6 * FT / RHO * (1 + ES / EC * RHO);
  const double mc = 2 * FT * PHI / (4 * 1.8 * FT * RHO) * (stress - less) / ES;
  const double ec =
    (3.4 * (SIDE - PHI) / 2 + 0.8 * 0.425 * PHI / RHO) * (stress - less) / ES;
  g_test_message (
    "%.0f MPa: spacing %.3f (%.3f to %.3f), width %.3f, widest %.3f (MC %.3f, "
    "EC %.3f) mm, strain %.4f of bare, theory %.4f",
    stress / 1e6, spacing, l0, 2 * l0, 1e3 * mean, 1e3 * widest, 1e3 * mc, 1e3 * ec,
    strain * ES / stress, stiffened * ES / stress);
  g_assert_cmpfloat_with_epsilon (strain / stiffened, 1, 0.03);
  g_assert_cmpfloat (widest, <, 1.1 * mc);
  g_assert_cmpfloat (widest, >, 0.7 * mc);
  g_assert_cmpfloat (widest, <, ec);
}

/* Force at the end of the path, and the work done on it. */
static double
pull_chord (Chord kind, QnProcedure procedure, double target, double *work)
{
  double way = 0, force = 0;
  g_auto (TestRun) run;
  init_chord (&run, kind);
  test_control (&run.model, procedure, "s39", QN_DOF_UX, target);
  run.model.analysis.increments = 30;
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  *work = 0;
  for (size_t i = 0; i < run.result.step_count; i++) {
    const double u = qn_result_step_displacements (&run.result, i)[3 * (2 * CELLS - 1)];
    const double now = run.result.steps[i].multiplier * 1e3;
    *work += 0.5 * (now + force) * (u - way);
    way = u;
    force = now;
  }
  g_test_message ("%d, %d: %.3f kN, %.3f J", (int) kind, (int) procedure, force / 1e3,
                  *work);
  return force;
}

/* The same cracks whatever is controlled, though force falls with each. Cells of two strengths share a joint,
 * whose springs then crack one after the other. */
static void
test_chord_paths (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  double force[3], work[3], other;
  for (int i = 0; i < 3; i++) {
    force[i] = pull_chord (BY_JOINT, procedures[i], 1e-3, &work[i]);
    g_assert_cmpfloat_with_epsilon (force[i] / force[0], 1, 0.01);
    g_assert_cmpfloat_with_epsilon (work[i] / work[0], 1, 0.01);
  }
  pull_chord (BY_CELL, QN_PROCEDURE_DISPLACEMENT, 0.4e-3, &other);
}

/* A bar that is bonded for good opens every joint: spacing and stiffening are then those of the cells. */
static void
test_bonded_chord (void)
{
  double at[CELLS], width[CELLS];
  g_auto (TestRun) run;
  init_chord (&run, BONDED);
  test_control (&run.model, QN_PROCEDURE_DISPLACEMENT, "c39", QN_DOF_UX, 2e-3);
  run.model.analysis.increments = 30;
  test_run_solve (&run);
  const size_t last = run.result.step_count - 1;
  g_assert_cmpint (find_cracks (&run, last, at, width), ==, CELLS - 1);
  /* What the concrete still carries at such small openings is its softening. */
  const double strain = 2e-3 / (LENGTH - LENGTH / CELLS),
               opening = strain * LENGTH / CELLS;
  const double force = strain * ES * AREA + FT * SIDE * SIDE * (1 - opening * FT / 200);
  g_assert_cmpfloat_with_epsilon (run.result.steps[last].multiplier * 1e3 / force, 1,
                                  0.01);
}

/* --- A panel in pure shear --------------------------------------------------------------------
 *
 * Panel PV4 of Vecchio & Collins (University of Toronto, 1982): 0.89 x 0.89 x 0.07 m, 1.06 % of 242 MPa both
 * ways, fc 26.6 MPa, as transcribed in the examples of Reinforced-Concrete-Membrane (A. F. Mello). Where the
 * bars yield before the concrete is crushed, plasticity has the strength sqrt (rho_x fx rho_y fy) (Nielsen). */

#define PANEL 0.89
#define DEPTH 0.07
#define RATIO 0.0106
#define YIELD 242e6
#define SIDES 5

/* Bars in lines at 45 degrees, or along the sides; enough of them to spread. */
static void
add_panel_bars (QnModel *model, bool diagonal)
{
  const double s = PANEL / (2 * SIDES), cell = PANEL / SIDES, inside = 1e-3;

  for (int k = diagonal ? -2 * SIDES : 0; k < 2 * SIDES; k++)
    for (int other = 0; other < 2; other++) {
      const double p = (k + 0.5) * s;
      const double from = diagonal ? fmax (0, -p) + inside : inside;
      const double to = diagonal ? fmin (PANEL, PANEL - p) - inside : PANEL - inside;
      if (to - from < cell)
        continue;
      QnVec2 a = diagonal ? qn_vec2 (from, from + p) : qn_vec2 (from, p);
      QnVec2 b = diagonal ? qn_vec2 (to, to + p) : qn_vec2 (to, p);
      if (other && diagonal) {
        a.x = PANEL - a.x;
        b.x = PANEL - b.x;
      } else if (other) {
        a = qn_vec2 (a.y, a.x);
        b = qn_vec2 (b.y, b.x);
      }
      QnBar *bar = qn_model_add_bar (model);
      *bar = (QnBar){ .law = 1,
                      .area = RATIO * DEPTH * s / (diagonal ? G_SQRT2 : 1),
                      .start = a,
                      .end = b };
    }
}

static void
push_side (QnModel *model, int i, int j, QnVec2 at, QnVec2 force)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = j * SIDES + i;
  load->has_at = true;
  load->at = at;
  load->vector = force;
}

/* The largest shear stress, Pa. Seen along its diagonals pure shear is as much tension as compression. */
static double
shear_panel (bool diagonal, double fc, double ft, double target)
{
  const double d = PANEL / SIDES, f = 1e6 * d * DEPTH;
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "concrete");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_MOHR_COULOMB,
                  .basis = QN_BASIS_MATERIAL,
                  .elasticity = 24e9,
                  .arrangement = QN_ARRANGEMENT_GRID,
                  .tension = ft,
                  .cohesion = sqrt (fc * ft) / 2,
                  .friction = (fc - ft) / (2 * sqrt (fc * ft)),
                  .residual_friction = 0.8,
                  .compression = fc,
                  .fracture_energy_tension = 75,
                  .fracture_energy_shear = 750,
                  .exponential = true };
  qn_law_derive (law);
  law = qn_model_add_law (model, "steel");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC_PLASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = ES,
                  .ks = ES / 2.5,
                  .yield = YIELD };
  for (int i = 0; i < SIDES * SIDES; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block =
      test_model_add_rectangle (model, name, i % SIDES * d, i / SIDES * d, d, d);
    block->thickness = DEPTH;
    block->unit_weight = 0;
    for (int dof = 0; dof < 3; dof++)
      block->support[dof] = i == SIDES * SIDES / 2;
  }
  for (int k = 0; k < SIDES; k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      const int far = sign < 0 ? 0 : SIDES - 1;
      const double m = (k + 0.5) * d, e = sign < 0 ? 0 : PANEL, g = sign * f;
      push_side (model, far, k, qn_vec2 (e, m),
                 diagonal ? qn_vec2 (g, 0) : qn_vec2 (0, g));
      push_side (model, k, far, qn_vec2 (m, e),
                 diagonal ? qn_vec2 (0, -g) : qn_vec2 (g, 0));
    }
  add_panel_bars (model, diagonal);
  model->contact.law = 0;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 3 };
  test_control (model, QN_PROCEDURE_DISPLACEMENT, diagonal ? "b14" : "b22", QN_DOF_UX,
                target);
  model->analysis.increments = 10;
  test_run_solve (&run);
  double peak = 0;
  for (size_t i = 0; i < run.result.step_count; i++)
    peak = fmax (peak, run.result.steps[i].multiplier * 1e6);
  return peak;
}

/* Cells that lie across the cracks have the plastic strength of the bars. Cells along the shear crack where
 * their cohesion is reached, however little the bars could carry then. */
static void
test_panel (void)
{
  const double fc = 26.6e6, ft = 1.7e6, plastic = RATIO * YIELD;
  const double turned = shear_panel (true, fc, ft, 4e-3);
  const double along = shear_panel (false, fc, ft, 6e-5);
  g_test_message ("plastic %.3f MPa, turned %.3f, along the cells %.3f, cohesion %.3f",
                  plastic / 1e6, turned / 1e6, along / 1e6, sqrt (fc * ft) / 2e6);
  g_assert_cmpfloat_with_epsilon (turned / plastic, 1, 0.01);
  g_assert_cmpfloat_with_epsilon (along / (sqrt (fc * ft) / 2), 1, 0.02);
}

QN_TESTS
{
  g_test_add_func ("/verify/reinforced/chord", test_chord);
  g_test_add_func ("/verify/reinforced/chord-paths", test_chord_paths);
  g_test_add_func ("/verify/reinforced/bonded-chord", test_bonded_chord);
  g_test_add_func ("/verify/reinforced/panel", test_panel);
}
