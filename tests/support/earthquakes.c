#include "support/earthquakes.h"

#include "core/path/analysis.h"
#include "support/models.h"

#include <math.h>

#define G TEST_G

void
test_earthquake_solve (QnModel *model, gboolean follow, QnResult *result)
{
  g_auto (QnContacts) contacts;
  model->analysis.dynamic.follow = follow;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
}

gboolean
test_earthquake_overturns (QnModel *model, gboolean follow, double *energy_error)
{
  g_auto (QnResult) result;
  test_earthquake_solve (model, follow, &result);
  QnOutcome outcome = result.outcome;
  g_assert_true (outcome == QN_OUTCOME_COLLAPSE || outcome == QN_OUTCOME_TARGET_REACHED
                 || outcome == QN_OUTCOME_REST);
  *energy_error = MAX (*energy_error, result.history.energy_error);
  qn_model_clear (model);
  return outcome == QN_OUTCOME_COLLAPSE;
}

static void
set_up (QnModel *model, double stiffness, double friction, double duration, double rho,
        double damping, QnPulse pulse)
{
  QnDynamicSettings *dynamic = &model->analysis.dynamic;
  QnLoad *load = qn_model_add_dead_load (model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (0, -1);
  model->laws[0].kn = model->laws[0].ks = stiffness;
  model->laws[0].friction = friction;
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  dynamic->duration = duration;
  dynamic->time_step = 0.005;
  dynamic->rho = rho;
  dynamic->joint_damping = damping;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = pulse;
}

/* --- The rocking block under a half-sine pulse --------------------------------------------- */

#define WIDTH  0.2
#define HEIGHT 1.0

/* A rigid block under the pulse, by Runge and Kutta's method: 4/3 R theta'' = -g sin(s alpha - theta)
 * - a cos(s alpha - theta), s the side it rocks to, with Housner's loss of speed at impacts.
 * Whether it overturns, and after how many impacts. */
static gboolean
exact_overturns (double amplitude, int halves, double pulse, int *impacts)
{
  const double h = 1e-4, alpha = atan (WIDTH / HEIGHT),
               radius = 0.5 * hypot (WIDTH, HEIGHT);
  const double kept = 1 - 1.5 * sin (alpha) * sin (alpha);
  double theta = 0, speed = 0, side = 0;
  *impacts = 0;
  for (double t = 0; t < 12; t += h) {
    double k[4][2], x = theta, v = speed;
    double now = t < pulse ? amplitude * sin (halves * G_PI * t / pulse) : 0;
    if (side == 0) {
      if (fabs (now) <= G * WIDTH / HEIGHT)
        continue;
      side = now > 0 ? -1 : 1; /* it turns against the ground's acceleration */
    }
    for (int i = 0; i < 4; i++) {
      double part = i == 0 ? 0 : i == 3 ? h : 0.5 * h, s = t + part;
      double a = s < pulse ? amplitude * sin (halves * G_PI * s / pulse) : 0;
      if (i > 0) {
        x = theta + part * k[i - 1][0];
        v = speed + part * k[i - 1][1];
      }
      k[i][0] = v;
      k[i][1] =
        -0.75 / radius * (G * sin (side * alpha - x) + a * cos (side * alpha - x));
    }
    double before = theta;
    theta += h / 6 * (k[0][0] + 2 * k[1][0] + 2 * k[2][0] + k[3][0]);
    speed += h / 6 * (k[0][1] + 2 * k[1][1] + 2 * k[2][1] + k[3][1]);
    if (fabs (theta) > G_PI / 2)
      return TRUE;
    if (side * theta < 0 || (side * before > 0 && theta == 0)) {
      ++*impacts;
      theta = 0;
      speed *= kept;
      side = -side;
      if (fabs (speed) < 1e-3)
        return FALSE;
    }
  }
  return FALSE;
}

void
test_earthquake_init_block (QnModel *model, double amplitude, double pulse)
{
  test_model_init_block_on_plane (model, WIDTH, HEIGHT);
  set_up (model, 1e9, 20, 8, 0.8, 1e-4,
          (QnPulse){ QN_PULSE_HALF_SINE, amplitude, pulse, 0 });
}

void
test_earthquake_init_block_sine (QnModel *model, double amplitude, double pulse)
{
  test_model_init_block_on_plane (model, WIDTH, HEIGHT);
  set_up (model, 1e9, 20, 4, 0.8, 0, (QnPulse){ QN_PULSE_SINE, amplitude, pulse, 0 });
  model->analysis.dynamic.of = QN_DAMPING_IMPACT;
}

double
test_earthquake_block_frequency (void)
{
  return sqrt (0.75 * G / (0.5 * hypot (WIDTH, HEIGHT)));
}

double
test_earthquake_exact_boundary (int halves, double pulse, int *impacts)
{
  double low = G * WIDTH / HEIGHT, high = low;
  int ignored;
  do
    high *= 1.1;
  while (!exact_overturns (high, halves, pulse, &ignored));
  low = high / 1.1;
  while (high - low > 1e-4 * high) {
    double middle = 0.5 * (low + high);
    if (exact_overturns (middle, halves, pulse, &ignored))
      high = middle;
    else
      low = middle;
  }
  exact_overturns (high, halves, pulse, impacts);
  return high;
}

/* --- The multi-drum column ------------------------------------------------------------------ */

const TestColumn test_columns[TEST_COLUMNS] = {
  { 0.1, 3.6, 4.3 },   { 0.15, 2.05, 2.2 },  { 0.2, 1.45, 1.48 },  { 0.25, 1.08, 1.09 },
  { 0.3, 0.87, 0.88 }, { 0.32, 0.80, 0.82 }, { 0.33, 0.78, 0.79 }, { 0.35, 0.37, 0.43 },
  { 0.4, 0.29, 0.31 }, { 0.5, 0.25, 0.27 },  { 0.6, 0.23, 0.25 },  { 0.8, 0.21, 0.22 },
  { 1.0, 0.20, 0.21 },
};

void
test_earthquake_init_column (QnModel *model, double amplitude, double duration)
{
  test_model_init (model);
  test_model_add_base (model, -2, -0.5, 4, 0.5);
  for (int i = 0; i < 8; i++) {
    double bottom = 0.82 * i, top = i < 7 ? bottom + 0.82 : 5.95;
    double b = 0.5 * (1.11 - 0.21 * bottom / 5.95), t = 0.5 * (1.11 - 0.21 * top / 5.95);
    const QnVec2 corners[] = { { -b, bottom }, { b, bottom }, { t, top }, { -t, top } };
    g_autofree char *name = g_strdup_printf ("drum %d", i + 1);
    QnBlock *drum = qn_model_add_block (model, name, corners, 4);
    drum->thickness = 1;
    drum->unit_weight = 2620 * G;
  }
  set_up (model, 2e9, 0.7, 12, 0.7, 2e-4,
          (QnPulse){ QN_PULSE_STEP_IMPULSE, amplitude * G, duration, 0 });
}

/* --- The arch of Lemos ---------------------------------------------------------------------- */

#define VOUSSOIRS 17
#define CROWN     (VOUSSOIRS / 2 + 1) /* block 0 is the base */
#define SPAN_IN   3.75
#define SPAN_OUT  4.25

/* Frequency of the arch with closed joints, Hz (quoin-cli modal with elastic joints). */
#define ARCH_FREQUENCY 10.912

static QnVec2
on_arch (double radius, int joint)
{
  double angle = G_PI * (1 - joint / (double) VOUSSOIRS);
  return qn_vec2 (radius * cos (angle), radius * sin (angle));
}

/* Three pairs a joint, at its ends and in its middle, with the lengths they stand for: those of the
 * method's authors for this arch. Joints of 1e10 Pa/m are two springs of 2e10 Pa/m in series. */
void
test_earthquake_init_arch (QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -5, -0.5, 10, 0.5);
  for (int i = 0; i < VOUSSOIRS; i++) {
    const QnVec2 corners[] = { on_arch (SPAN_IN, i), on_arch (SPAN_IN, i + 1),
                               on_arch (SPAN_OUT, i + 1), on_arch (SPAN_OUT, i) };
    g_autofree char *name = g_strdup_printf ("voussoir %d", i + 1);
    QnBlock *block = qn_model_add_block (model, name, corners, 4);
    block->thickness = 1;
    block->unit_weight = 2700 * 10;
  }
  model->gravity = 10;
  model->laws[0].basis = QN_BASIS_SURFACE;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_EXPLICIT,
                                       .count = 3,
                                       .positions = { 0, 0.5, 1 },
                                       .weights = { 0.25, 0.5, 0.25 } };
  set_up (model, 2e10, tan (35 * G_PI / 180), 2, 0.8,
          2 * 0.05 / (2 * G_PI * ARCH_FREQUENCY),
          (QnPulse){ QN_PULSE_HALF_SINE, 1.5, 0.25, 0 });
  model->analysis.dynamic.time_step = 0.002;
  for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
    QnTrack *track = qn_model_add_track (model);
    track->block = CROWN;
    track->dof = (QnDof) dof;
  }
}

/* Sideways motion of the middle of the extrados of the crown since the start, m, positive where the
 * body force of the pulse drives it. */
static double
crown_motion (const QnHistory *history, size_t row, double arm)
{
  const double *first = history->rows + QN_HISTORY_TRACK;
  const double *now = first + history->width * row;
  return -(now[0] - first[0] - arm * sin (now[2] - first[2]));
}

void
test_earthquake_arch_peaks (const QnModel *model, const QnHistory *history,
                            double peaks[2], double times[2])
{
  double arm = on_arch (SPAN_OUT, VOUSSOIRS / 2).y - model->blocks[CROWN].centroid.y;
  size_t first = 0, second;
  for (size_t i = 0; i < history->row_count; i++)
    if (crown_motion (history, i, arm) > crown_motion (history, first, arm))
      first = i;
  second = first;
  for (size_t i = first; i < history->row_count; i++)
    if (crown_motion (history, i, arm) < crown_motion (history, second, arm))
      second = i;
  peaks[0] = crown_motion (history, first, arm);
  peaks[1] = crown_motion (history, second, arm);
  times[0] = history->rows[history->width * first];
  times[1] = history->rows[history->width * second];
}
