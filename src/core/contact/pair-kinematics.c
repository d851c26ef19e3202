#include "core/contact/pair-kinematics.h"

#include <string.h>

/* dq for a frame and arms as they stand:
 *
 *   dq_n = n . dd + q_t drz_m      (the frame turns by rz_m = s rz_a + (1 - s) rz_b)
 *   dq_t = t . dd - q_n drz_m      dd = du_b + drz_b x r_b - du_a - drz_a x r_a
 */
static void
set_gradient (QnPairKinematics *pair, const double turning[2])
{
  const QnVec2 axes[2] = { pair->frame, qn_vec2_perp (pair->frame) };

  for (int i = 0; i < 2; i++) {
    double *g = pair->gradient[i];
    g[0] = -axes[i].x;
    g[1] = -axes[i].y;
    g[2] = (-qn_vec2_cross (pair->turned_a, axes[i]) + pair->share * turning[i])
           / pair->length;
    g[3] = axes[i].x;
    g[4] = axes[i].y;
    g[5] = (qn_vec2_cross (pair->turned_b, axes[i]) + (1 - pair->share) * turning[i])
           / pair->length;
  }
}

void
qn_pair_kinematics_init (QnPairKinematics *pair, QnVec2 normal, QnVec2 arm_a,
                         QnVec2 arm_b, double length)
{
  const double at_rest[2] = { 0, 0 };

  *pair = (QnPairKinematics){ .normal = normal,
                              .arm_a = arm_a,
                              .arm_b = arm_b,
                              .length = length,
                              .share = 0.5,
                              .frame = normal,
                              .turned_a = arm_a,
                              .turned_b = arm_b };
  set_gradient (pair, at_rest);
}

void
qn_pair_kinematics_set_corner (QnPairKinematics *pair, QnVec2 apart)
{
  const double at_rest[6] = { 0 };

  pair->apart = apart;
  pair->share = 1;
  qn_pair_kinematics_update (pair, at_rest);
}

QnPairGradient
qn_pair_kinematics_gradient (const QnPairKinematics *pair)
{
  QnPairGradient gradient;

  for (int i = 0; i < 2; i++)
    memcpy (gradient.factors[i], pair->gradient[i] + 2, sizeof gradient.factors[i]);
  return gradient;
}

void
qn_pair_kinematics_update (QnPairKinematics *pair, const double v[6])
{
  double rz_a = v[2] / pair->length, rz_b = v[5] / pair->length;
  double rz_m = pair->share * rz_a + (1 - pair->share) * rz_b;
  QnVec2 move_a = qn_vec2_turn_away (pair->arm_a, rz_a),
         move_b = qn_vec2_turn_away (pair->arm_b, rz_b);
  QnVec2 d = qn_vec2_add (qn_vec2_sub (qn_vec2 (v[3], v[4]), qn_vec2 (v[0], v[1])),
                          qn_vec2_sub (move_b, move_a));

  if (pair->share != 0.5)
    d = qn_vec2_add (d, pair->apart);

  pair->frame = qn_vec2_rotate (pair->normal, cos (rz_m), sin (rz_m));
  pair->turned_a = qn_vec2_add (pair->arm_a, move_a);
  pair->turned_b = qn_vec2_add (pair->arm_b, move_b);
  pair->elongation[0] = qn_vec2_dot (pair->frame, d);
  pair->elongation[1] = qn_vec2_dot (qn_vec2_perp (pair->frame), d);

  const double turning[2] = { pair->elongation[1], -pair->elongation[0] };
  set_gradient (pair, turning);
}

/* Second derivatives of q along the axis e of the frame (n or t), with e' = de/drz_m (t or -n),
 * q = e . d, and the shares s of block a and r = 1 - s of block b in the frame's rotation:
 *
 *   du drz_a, drz_b   +- s e', +- r e'
 *   drz_a drz_a   e . r_a - 2 s e' . (z x r_a) - s^2 q
 *   drz_b drz_b  -e . r_b + 2 r e' . (z x r_b) - r^2 q
 *   drz_a drz_b   e' . (s z x r_b - r z x r_a) - s r q
 */
void
qn_pair_kinematics_add_stiffness (const QnPairKinematics *pair, const double force[2],
                                  double k[6][6])
{
  const QnVec2 n = pair->frame, t = qn_vec2_perp (n);
  const QnVec2 axes[2] = { n, t }, slopes[2] = { t, qn_vec2_scale (-1, n) };
  const double s = pair->share, r = 1 - s, l = pair->length;

  for (int i = 0; i < 2; i++) {
    double f = force[i], q = pair->elongation[i];
    double along_a = qn_vec2_cross (pair->turned_a, slopes[i]); /* e' . (z x r_a) */
    double along_b = qn_vec2_cross (pair->turned_b, slopes[i]);
    double slope[2] = { f * slopes[i].x / l, f * slopes[i].y / l };

    for (int c = 0; c < 2; c++) {
      for (int rotation = 2; rotation <= 5; rotation += 3) {
        double part = (rotation == 2 ? s : r) * slope[c];
        k[c][rotation] -= part;
        k[rotation][c] -= part;
        k[3 + c][rotation] += part;
        k[rotation][3 + c] += part;
      }
    }
    double cross = f * (s * along_b - r * along_a - s * r * q) / (l * l);
    k[2][2] +=
      f * (qn_vec2_dot (axes[i], pair->turned_a) - 2 * s * along_a - s * s * q) / (l * l);
    k[5][5] += f * (-qn_vec2_dot (axes[i], pair->turned_b) + 2 * r * along_b - r * r * q)
               / (l * l);
    k[2][5] += cross;
    k[5][2] += cross;
  }
}
