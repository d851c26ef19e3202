#include "core/assembly/beam-element.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* A beam of 2.5 m, turned by 0.6 rad, with shear. */
static QnBeamProperties
sample (double first, double second)
{
  return (QnBeamProperties){ .chord = qn_vec2 (2.5 * cos (0.6), 2.5 * sin (0.6)),
                             .length = 2.5,
                             .axial = 4e8,
                             .bending = 1.6e6,
                             .phi = 0.3,
                             .moments = { first, second },
                             .mass = 250,
                             .rotary = 12 };
}

/* P = G' s at displacements v. */
static void
forces (const QnBeamProperties *p, const QnBeamMemory *memory, const double v[6],
        bool nonlinear, QnBeamKinematics *k, QnBeamResponse *response, double out[6])
{
  qn_beam_kinematics_init (k, p);
  qn_beam_kinematics_update (k, p, v, nonlinear);
  qn_beam_evaluate (p, memory, k->deformation, response);
  for (int j = 0; j < 6; j++) {
    out[j] = 0;
    for (int i = 0; i < 3; i++)
      out[j] += k->gradient[i][j] * response->force[i];
  }
}

/* K against central differences of P. */
static void
check_tangent (const QnBeamProperties *p, const double v[6], bool nonlinear)
{
  const QnBeamMemory memory = { .plastic = { 1e-3, -2e-3 } };
  QnBeamKinematics kinematics, near;
  QnBeamResponse response, moved;
  double at[6], k[6][6] = { { 0 } }, here[6], largest = 0;

  forces (p, &memory, v, nonlinear, &kinematics, &response, here);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++)
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
          k[i][j] += kinematics.gradient[a][i] * response.tangent[a][b]
                     * kinematics.gradient[b][j];
  if (nonlinear)
    qn_beam_kinematics_add_stiffness (&kinematics, response.force, k);
  for (int i = 0; i < 36; i++)
    largest = fmax (largest, fabs (k[i / 6][i % 6]));

  for (int j = 0; j < 6; j++) {
    const double h = 1e-6;
    double plus[6], minus[6];
    memcpy (at, v, sizeof at);
    at[j] = v[j] + h;
    forces (p, &memory, at, nonlinear, &near, &moved, plus);
    g_assert_cmpint (moved.phase, ==, response.phase);
    at[j] = v[j] - h;
    forces (p, &memory, at, nonlinear, &near, &moved, minus);
    g_assert_cmpint (moved.phase, ==, response.phase);
    for (int i = 0; i < 6; i++)
      g_assert_cmpfloat (fabs (k[i][j] - (plus[i] - minus[i]) / (2 * h)), <,
                         1e-6 * largest);
  }
}

static void
test_tangent (void)
{
  static const double moments[][2] = {
    { INFINITY, INFINITY }, { 0, INFINITY }, { INFINITY, 0 }, { 0, 0 },
    { 5e4, INFINITY },      { 5e4, 0 },      { 5e4, 6e4 }
  };
  const double small[6] = { 0.01, -0.02, 0.03, -0.004, 0.03, 0.09 };
  const double turned[6] = { 1.2, -0.7, 2.03, -2.4, 0.9, 2.2 };

  for (gsize i = 0; i < G_N_ELEMENTS (moments); i++) {
    QnBeamProperties p = sample (moments[i][0], moments[i][1]);
    check_tangent (&p, small, false);
    check_tangent (&p, small, true);
    check_tangent (&p, turned, true);
  }
}

/* A cantilever under a force and a moment at its tip: PL^3/3EI + PL/kGA, ML^2/2EI. */
static void
test_stiffness (void)
{
  QnBeamProperties p = sample (INFINITY, INFINITY);
  const double EI = p.bending * p.length, L = p.length, P = 1e3, M = 700;
  const double w =
    P * L * L * L / (3 * EI) + P * L * p.phi * L * L / (12 * EI) + M * L * L / (2 * EI);
  const double r = P * L * L / (2 * EI) + M * L / EI, N = 2e4;
  QnVec2 x = qn_vec2_scale (1 / L, p.chord), y = qn_vec2_perp (x);
  QnVec2 tip = qn_vec2_add_scaled (qn_vec2_scale (N / p.axial, x), w, y);
  const double v[6] = { 0, 0, 0, tip.x, tip.y, r };
  QnBeamKinematics k;
  QnBeamResponse response;
  double f[6];

  forces (&p, &(QnBeamMemory){ 0 }, v, false, &k, &response, f);
  QnVec2 end = qn_vec2 (f[3], f[4]);
  g_assert_cmpfloat_with_epsilon (qn_vec2_dot (end, x), N, 1e-9 * N);
  g_assert_cmpfloat_with_epsilon (qn_vec2_dot (end, y), P, 1e-9 * P);
  g_assert_cmpfloat_with_epsilon (f[5], M, 1e-9 * P);
  g_assert_cmpfloat_with_epsilon (f[2], -(M + P * L), 1e-9 * P);
  g_assert_cmpfloat_with_epsilon (f[2] + f[5] + qn_vec2_cross (p.chord, end), 0,
                                  1e-9 * P);
}

/* A rigid motion, however large, strains nothing. */
static void
test_rigid_motion (void)
{
  QnBeamProperties p = sample (INFINITY, INFINITY);
  for (double angle = -9; angle <= 9; angle += 0.37) {
    QnVec2 turned = qn_vec2_rotate (p.chord, cos (angle), sin (angle));
    const double v[6] = {
      3, -1, angle, 3 + turned.x - p.chord.x, -1 + turned.y - p.chord.y, angle
    };
    QnBeamKinematics k;
    qn_beam_kinematics_init (&k, &p);
    qn_beam_kinematics_update (&k, &p, v, true);
    for (int i = 0; i < 3; i++)
      g_assert_cmpfloat (fabs (k.deformation[i]), <, 1e-13);
  }
}

/* Whatever is asked for, moments keep their limits, and what they do on the hinges is work. */
static void
test_yielding (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  int seen[9] = { 0 };

  for (int trial = 0; trial < 20000; trial++) {
    QnBeamProperties p = sample (g_rand_double_range (random, 1e3, 1e5),
                                 g_rand_double_range (random, 1e3, 1e5));
    const QnBeamMemory memory = { .plastic = {
                                    g_rand_double_range (random, -0.01, 0.01),
                                    g_rand_double_range (random, -0.01, 0.01) } };
    const double deformation[3] = { 0, g_rand_double_range (random, -0.05, 0.05),
                                    g_rand_double_range (random, -0.05, 0.05) };
    QnBeamResponse response, again;
    qn_beam_evaluate (&p, &memory, deformation, &response);
    for (int i = 0; i < 2; i++) {
      double slip = response.memory.plastic[i] - memory.plastic[i];
      g_assert_cmpfloat (fabs (response.force[1 + i]), <=, p.moments[i] * (1 + 1e-9));
      g_assert_cmpfloat (slip * response.force[1 + i], >=, -1e-12);
      if (slip != 0)
        g_assert_cmpfloat_with_epsilon (fabs (response.force[1 + i]), p.moments[i],
                                        1e-9 * p.moments[i]);
    }
    /* What the hinges keep reproduces the forces without yielding on. */
    qn_beam_evaluate (&p, &response.memory, deformation, &again);
    for (int i = 1; i < 3; i++)
      g_assert_cmpfloat_with_epsilon (again.force[i], response.force[i], 1e-6);
    seen[4 + response.phase]++;
  }
  for (int i = 0; i < 9; i++)
    g_assert_cmpint (seen[i], >, 50);
}

static void
test_hinges (void)
{
  const double deformation[3] = { 0, 0.02, -0.01 };
  QnBeamResponse response;

  QnBeamProperties p = sample (0, INFINITY);
  p.phi = 0;
  qn_beam_evaluate (&p, &(QnBeamMemory){ 0 }, deformation, &response);
  g_assert_cmpfloat (response.force[1], ==, 0);
  g_assert_cmpfloat_with_epsilon (response.force[2], 3 * p.bending * -0.01, 1e-6);
  p = sample (0, 0);
  qn_beam_evaluate (&p, &(QnBeamMemory){ 0 }, deformation, &response);
  g_assert_cmpfloat (response.force[1], ==, 0);
  g_assert_cmpfloat (response.force[2], ==, 0);
}

/* q L^2 / 12 at both ends, q L^2 / 8 at the only one that holds. */
static void
test_fixed_end_moments (void)
{
  const double q = -1200;
  double m[2];

  QnBeamProperties p = sample (INFINITY, INFINITY);
  qn_beam_fixed_end_moments (&p, q, m);
  g_assert_cmpfloat_with_epsilon (m[0], 1200 * 2.5 * 2.5 / 12, 1e-9);
  g_assert_cmpfloat_with_epsilon (m[1], -1200 * 2.5 * 2.5 / 12, 1e-9);
  p = sample (INFINITY, 0);
  p.phi = 0;
  qn_beam_fixed_end_moments (&p, q, m);
  g_assert_cmpfloat_with_epsilon (m[0], 1200 * 2.5 * 2.5 / 8, 1e-9);
  g_assert_cmpfloat (m[1], ==, 0);
  p = sample (0, 0);
  qn_beam_fixed_end_moments (&p, q, m);
  g_assert_cmpfloat (m[0], ==, 0);
}

/* v' M v of rigid motions is the mass, the first moments and the moment of inertia, with or
 * without hinges; M is symmetric and positive. */
static void
test_mass (void)
{
  for (int hinges = 0; hinges < 4; hinges++) {
    QnBeamProperties p = sample (hinges & 1 ? 0 : INFINITY, hinges & 2 ? 0 : INFINITY);
    const QnVec2 end = p.chord;
    const double motions[3][6] = { { 1, 0, 0, 1, 0, 0 },
                                   { 0, 1, 0, 0, 1, 0 },
                                   { 0, 0, 1, -end.y, end.x, 1 } };
    const double expected[3] = { 250 * 2.5, 250 * 2.5,
                                 250 * 2.5 * 2.5 * 2.5 / 3 + 12 * 2.5 };
    double m[6][6];
    qn_beam_mass (&p, m);
    for (int motion = 0; motion < 3; motion++) {
      double sum = 0;
      for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
          sum += motions[motion][i] * m[i][j] * motions[motion][j];
          g_assert_cmpfloat_with_epsilon (m[i][j], m[j][i], 1e-9);
        }
      g_assert_cmpfloat_with_epsilon (sum, expected[motion], 1e-9 * expected[motion]);
    }
  }
}

/* 5 q L^4 / 384 EI + q L^2 / 8 kGA in the middle of a simple beam; M L^2 / 16 EI of a moment at
 * one end. */
static void
test_deflection (void)
{
  QnBeamProperties p = sample (INFINITY, INFINITY);
  const double L = p.length, EI = p.bending * L, q = -900;
  const double none[2] = { 0, 0 }, one[2] = { 400, 0 };
  double expected =
    5 * q * pow (L, 4) / (384 * EI) + q * L * L / 8 * p.phi * L * L / (12 * EI);

  g_assert_cmpfloat_with_epsilon (qn_beam_deflection (&p, none, q, 0.5), expected, 1e-12);
  g_assert_cmpfloat_with_epsilon (qn_beam_deflection (&p, one, 0, 0.5),
                                  -400 * L * L / (16 * EI), 1e-12);
  g_assert_cmpfloat_with_epsilon (qn_beam_deflection (&p, one, q, 1), 0, 1e-15);
}

QN_TESTS
{
  g_test_add_func ("/beam-element/tangent", test_tangent);
  g_test_add_func ("/beam-element/stiffness", test_stiffness);
  g_test_add_func ("/beam-element/rigid-motion", test_rigid_motion);
  g_test_add_func ("/beam-element/yielding", test_yielding);
  g_test_add_func ("/beam-element/hinges", test_hinges);
  g_test_add_func ("/beam-element/fixed-end-moments", test_fixed_end_moments);
  g_test_add_func ("/beam-element/mass", test_mass);
  g_test_add_func ("/beam-element/deflection", test_deflection);
}
