#include "core/assembly/beam-element.h"

#include "core/base/tolerance.h"

#include <math.h>
#include <string.h>

/* What remains of the stiffness of an end or a tie that yields or is slack, in the tangent only: a node
 * between two ends that yield is held by no stiffness at all. Far below what Newton's method notices. */
#define YIELDED_STIFFNESS 1e-9

#define FULL_TURN 6.283185307179586

void
qn_beam_kinematics_init (QnBeamKinematics *k, const QnBeamProperties *properties)
{
  const double rest[6] = { 0 };

  qn_beam_kinematics_update (k, properties, rest, true);
}

static void
set_gradient (QnBeamKinematics *k)
{
  const double c = k->axis.x, s = k->axis.y, l = k->length;
  const double r[6] = { -c, -s, 0, c, s, 0 };                 /* de */
  const double z[6] = { s / l, -c / l, 0, -s / l, c / l, 0 }; /* turning of the chord */

  for (int j = 0; j < 6; j++) {
    k->gradient[0][j] = r[j];
    k->gradient[1][j] = -z[j];
    k->gradient[2][j] = -z[j];
  }
  k->gradient[1][2] += 1;
  k->gradient[2][5] += 1;
}

void
qn_beam_kinematics_update (QnBeamKinematics *k, const QnBeamProperties *properties,
                           const double v[6], bool nonlinear)
{
  if (!nonlinear) {
    for (int i = 0; i < 3; i++) {
      k->deformation[i] = 0;
      for (int j = 0; j < 6; j++)
        k->deformation[i] += k->gradient[i][j] * v[j];
    }
    return;
  }

  const QnVec2 chord = properties->chord, d = qn_vec2 (v[3] - v[0], v[4] - v[1]);
  const QnVec2 now = qn_vec2_add (chord, d);
  double l = qn_vec2_length (now);
  double turned = atan2 (qn_vec2_cross (chord, now), qn_vec2_dot (chord, now));

  k->length = l;
  k->axis = l > 0 ? qn_vec2_scale (1 / l, now) : qn_vec2 (1, 0);
  /* l - L without loss of digits: (l^2 - L^2) / (l + L) */
  k->deformation[0] =
    (2 * qn_vec2_dot (chord, d) + qn_vec2_dot (d, d)) / (l + properties->length);
  k->deformation[1] = remainder (v[2] - turned, FULL_TURN);
  k->deformation[2] = remainder (v[5] - turned, FULL_TURN);
  set_gradient (k);
}

/* d2e = z z' / l and d2theta = (r z' + z r') / l^2 with z, r of set_gradient() and z not yet
 * divided by l. */
void
qn_beam_kinematics_add_stiffness (const QnBeamKinematics *k, const double force[3],
                                  double stiffness[6][6])
{
  const double c = k->axis.x, s = k->axis.y, l = k->length;
  const double r[6] = { -c, -s, 0, c, s, 0 }, z[6] = { s, -c, 0, -s, c, 0 };
  double n = force[0] / l, m = (force[1] + force[2]) / (l * l);

  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++)
      stiffness[i][j] += n * z[i] * z[j] + m * (r[i] * z[j] + z[i] * r[j]);
}

/* The 2 x 2 bending stiffness. */
static void
bending_stiffness (const QnBeamProperties *p, double k[2][2])
{
  double unit = p->bending / (1 + p->phi);

  k[0][0] = k[1][1] = unit * (4 + p->phi);
  k[0][1] = k[1][0] = unit * (2 - p->phi);
}

/* --- Yielding --------------------------------------------------------------------------- */

/* Moments when the ends named by `sense` (+-1: at the limit, 0: elastic) yield; slip is how
 * far their hinges turn on. */
static void
return_to (double k[2][2], const double trial[2], const double limit[2],
           const int sense[2], double moment[2], double slip[2])
{
  double excess[2] = { 0, 0 };

  for (int i = 0; i < 2; i++)
    if (sense[i] != 0)
      excess[i] = trial[i] - sense[i] * limit[i];
  slip[0] = slip[1] = 0;
  if (sense[0] != 0 && sense[1] != 0) {
    double det = k[0][0] * k[1][1] - k[0][1] * k[1][0];
    slip[0] = (k[1][1] * excess[0] - k[0][1] * excess[1]) / det;
    slip[1] = (k[0][0] * excess[1] - k[1][0] * excess[0]) / det;
  } else {
    for (int i = 0; i < 2; i++)
      if (sense[i] != 0)
        slip[i] = excess[i] / k[i][i];
  }
  for (int i = 0; i < 2; i++)
    moment[i] = sense[i] != 0 ? sense[i] * limit[i]
                              : trial[i] - k[i][0] * slip[0] - k[i][1] * slip[1];
}

/* Whether ends that yield turn in the sense of their moments and the others keep their limits. */
static bool
is_admissible (const double limit[2], double stiffness, const int sense[2],
               const double moment[2], const double slip[2])
{
  for (int i = 0; i < 2; i++) {
    if (sense[i] == 0 && fabs (moment[i]) > limit[i] * (1 + QN_TOLERANCE_YIELD))
      return false;
    if (sense[i] != 0 && limit[i] > 0
        && sense[i] * slip[i] * stiffness < -QN_TOLERANCE_YIELD * limit[i])
      return false;
  }
  return true;
}

/* The one admissible combination: closest point of the rectangle of moments, by trying. */
static void
return_map (const QnBeamProperties *p, double k[2][2], const double trial[2],
            int sense[2], double moment[2], double slip[2])
{
  static const int senses[3] = { 0, 1, -1 };

  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      sense[0] = senses[i];
      sense[1] = senses[j];
      if ((p->moments[0] == 0 && i != 1) || (p->moments[1] == 0 && j != 1))
        continue; /* hinges always turn */
      if ((isinf (p->moments[0]) && i != 0) || (isinf (p->moments[1]) && j != 0))
        continue;
      return_to (k, trial, p->moments, sense, moment, slip);
      if (is_admissible (p->moments, k[0][0], sense, moment, slip))
        return;
    }
}

/* k with the yielding ends condensed: k - k_a k_aa^-1 k_a' */
static void
condense (double k[2][2], const int sense[2])
{
  double full[2][2];

  memcpy (full, k, sizeof full);
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++) {
      if (sense[0] != 0 && sense[1] != 0)
        k[i][j] = 0;
      else if (sense[0] != 0)
        k[i][j] -= full[i][0] * full[0][j] / full[0][0];
      else if (sense[1] != 0)
        k[i][j] -= full[i][1] * full[1][j] / full[1][1];
    }
}

void
qn_beam_evaluate (const QnBeamProperties *p, const QnBeamMemory *committed,
                  const double deformation[3], QnBeamResponse *response)
{
  double k[2][2], trial[2], moment[2] = { 0 }, slip[2] = { 0 };
  int sense[2] = { 0, 0 };

  bending_stiffness (p, k);
  for (int i = 0; i < 2; i++)
    trial[i] = k[i][0] * (deformation[1] - committed->plastic[0])
               + k[i][1] * (deformation[2] - committed->plastic[1]);
  return_map (p, k, trial, sense, moment, slip);

  *response =
    (QnBeamResponse){ .force = { p->axial * deformation[0], moment[0], moment[1] },
                      .phase = (int8_t) (3 * sense[0] + sense[1]) };
  const double full[2] = { k[0][0], k[1][1] };
  condense (k, sense);
  response->tangent[0][0] = p->axial;
  for (int i = 0; i < 2; i++) {
    response->memory.plastic[i] = committed->plastic[i] + slip[i];
    for (int j = 0; j < 2; j++)
      response->tangent[1 + i][1 + j] = k[i][j];
    if (sense[i] != 0 && p->moments[i] > 0)
      response->tangent[1 + i][1 + i] += YIELDED_STIFFNESS * full[i];
  }
}

/* --- Ties ------------------------------------------------------------------------------- */

void
qn_tie_evaluate (const QnBeamProperties *p, const QnBeamMemory *committed,
                 const double deformation[3], QnBeamResponse *response)
{
  enum { PULLS, SLACK, FLOWS, TENSIONED };
  const QnTie *tie = p->tie;
  const double strength = qn_tie_strength (tie);
  double trial = p->axial * (deformation[0] - p->rest - committed->stretch);
  double force = trial;
  int8_t phase = PULLS;

  *response = (QnBeamResponse){ .memory = *committed };
  if (trial > strength) {
    phase = FLOWS;
    force = strength;
    response->memory.stretch += (trial - strength) / p->axial;
  } else if (!committed->tensioned && trial < tie->prestress) {
    phase = TENSIONED;
    force = tie->prestress;
  } else if (trial < 0) {
    phase = SLACK;
    force = 0;
  }
  response->force[0] = force;
  response->phase = phase;
  response->tangent[0][0] = phase == PULLS ? p->axial : YIELDED_STIFFNESS * p->axial;
}

/* --- Loads, mass, shape ------------------------------------------------------------------ */

void
qn_beam_fixed_end_moments (const QnBeamProperties *p, double q, double moments[2])
{
  double k[2][2], fixed = -q * p->length * p->length / 12;
  bool first = p->moments[0] == 0, second = p->moments[1] == 0;

  bending_stiffness (p, k);
  moments[0] = first ? 0 : fixed;
  moments[1] = second ? 0 : -fixed;
  if (first && !second)
    moments[1] -= k[1][0] / k[0][0] * fixed;
  if (second && !first)
    moments[0] += k[0][1] / k[1][1] * fixed;
}

void
qn_beam_mass (const QnBeamProperties *p, double mass[6][6])
{
  /* Gauss and Legendre, four points: exact for products of cubics. */
  static const double places[2] = { 0.3399810435848563, 0.8611363115940526 };
  static const double weights[2] = { 0.6521451548625461, 0.3478548451374538 };
  const QnVec2 x = qn_vec2_scale (1 / p->length, p->chord), y = qn_vec2_perp (x);
  double t[4][4];

  /* How the rotations of the axis at the ends follow from w1, r1, w2, r2 of the nodes:
   * the same but for hinges, whose rotation makes the moment vanish. */
  const double turning[4] = { -1 / p->length, 0, 1 / p->length, 0 };
  double k[2][2];
  bending_stiffness (p, k);
  memset (t, 0, 16 * sizeof (double));
  for (int i = 0; i < 4; i++)
    t[i][i] = 1;
  bool hinge[2] = { p->moments[0] == 0, p->moments[1] == 0 };
  for (int end = 0; end < 2; end++) {
    if (!hinge[end])
      continue;
    int row = 1 + 2 * end, far = 3 - 2 * end;
    double carry = hinge[1 - end] ? 0 : -k[end][1 - end] / k[end][end];
    for (int j = 0; j < 4; j++) /* theta_end = carry theta_far, both against the chord */
      t[row][j] = turning[j] * (1 - carry);
    if (!hinge[1 - end])
      t[row][far] += carry;
  }
  memset (mass, 0, 36 * sizeof (double));
  for (int g = 0; g < 4; g++) {
    double s = 0.5 * (1 + (g % 2 ? 1 : -1) * places[g / 2]), w[4], r[4];
    double weight = 0.5 * weights[g / 2] * p->length;
    double field[3][6] = { { 0 } }; /* displacements along x and y, rotation */
    /* Deflection and rotation of the axis at x = s L for unit end values w1, r1, w2, r2
     * in the axes of the chord: Timoshenko's cubics, condensed where an end is hinged. */
    const double L = p->length, f = p->phi, d = 1 / (1 + f);
    w[0] = d * (1 - 3 * s * s + 2 * s * s * s + f * (1 - s));
    w[1] = d * L * (s - 2 * s * s + s * s * s + 0.5 * f * (s - s * s));
    w[2] = d * (3 * s * s - 2 * s * s * s + f * s);
    w[3] = d * L * (-s * s + s * s * s + 0.5 * f * (s * s - s));
    r[0] = d * 6 / L * (s * s - s);
    r[1] = d * (1 - 4 * s + 3 * s * s + f * (1 - s));
    r[2] = -r[0];
    r[3] = d * (-2 * s + 3 * s * s + f * s);
    for (int j = 0; j < 4; j++) {
      double wj = 0, rj = 0;
      for (int i = 0; i < 4; i++) {
        wj += w[i] * t[i][j];
        rj += r[i] * t[i][j];
      }
      const int end = 3 * (j / 2);
      if (j % 2) {
        field[1][end + 2] += wj;
        field[2][end + 2] += rj;
      } else {
        field[1][end] += wj * y.x;
        field[1][end + 1] += wj * y.y;
        field[2][end] += rj * y.x;
        field[2][end + 1] += rj * y.y;
      }
    }
    field[0][0] = (1 - s) * x.x;
    field[0][1] = (1 - s) * x.y;
    field[0][3] = s * x.x;
    field[0][4] = s * x.y;
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++)
        mass[i][j] += weight
                      * (p->mass * (field[0][i] * field[0][j] + field[1][i] * field[1][j])
                         + p->rotary * field[2][i] * field[2][j]);
  }
}

/* EI w'' = M = M1 (1 - s) + M2 s - q x (L - x) / 2, and -V / (kGA) of shear, both without
 * deflection at the ends. */
double
qn_beam_deflection (const QnBeamProperties *p, const double moments[2], double q,
                    double s)
{
  const double L = p->length, EI = p->bending * L, x = s * L;
  const double first = moments[0], second = moments[1];
  double bending =
    -(L * x / 6) * (first * (1 - s) * (2 - s) + second * (1 - s) * (1 + s)) / EI
    + q * x * (L * L * L - 2 * L * x * x + x * x * x) / (24 * EI);
  double shear = q * x * (L - x) / 2 * p->phi * L * L / (12 * EI);

  return bending + shear;
}
