#include "core/contact/pair-kinematics.h"

#include <math.h>

void
qn_pair_kinematics_init (QnPairKinematics *pair, QnVec2 normal, QnVec2 arm_a,
                         QnVec2 arm_b, double length)
{
  *pair = (QnPairKinematics){ .normal = normal,
                              .arm_a = arm_a,
                              .arm_b = arm_b,
                              .length = length,
                              .share = 0.5,
                              .frame = normal,
                              .turned_a = arm_a,
                              .turned_b = arm_b };
}

void
qn_pair_kinematics_set_corner (QnPairKinematics *pair, QnVec2 apart)
{
  const double at_rest[6] = { 0 };

  pair->apart = apart;
  pair->share = 1;
  qn_pair_kinematics_update (pair, 1, at_rest);
}

/* dq for a frame and arms as they stand:
 *
 *   dq_n = n . dd + q_t drz_m      (the frame turns by rz_m = s rz_a + (1 - s) rz_b)
 *   dq_t = t . dd - q_n drz_m      dd = du_b + drz_b x r_b - du_a - drz_a x r_a
 */
QnPairGradient
qn_pair_kinematics_gradient (const QnPairKinematics *pair)
{
  const QnVec2 axes[2] = { pair->frame, qn_vec2_perp (pair->frame) };
  const double turning[2] = { pair->elongation[1], -pair->elongation[0] };
  const double s = pair->share, l = pair->length;
  QnPairGradient gradient;

  for (int i = 0; i < 2; i++) {
    double *g = gradient.factors[i];
    g[0] = (s * turning[i] - qn_vec2_cross (pair->turned_a, axes[i])) / l;
    g[1] = axes[i].x;
    g[2] = axes[i].y;
    g[3] = ((1 - s) * turning[i] + qn_vec2_cross (pair->turned_b, axes[i])) / l;
  }
  return gradient;
}

/* A rotation by its half. */
typedef struct {
  double sine, cosine; /* of half the angle */
} Turn;

static Turn
turn_by (double angle)
{
  return (Turn){ sin (0.5 * angle), cos (0.5 * angle) };
}

/* How far a turns away from itself, (R - 1) a, without the loss of digits of R a - a where the angle is
 * small: cos - 1 = -2 sin^2 (angle / 2). */
static QnVec2
turn_away (QnVec2 a, Turn turn)
{
  return qn_vec2_add_scaled (qn_vec2_scale (-2 * turn.sine * turn.sine, a),
                             2 * turn.sine * turn.cosine, qn_vec2_perp (a));
}

void
qn_pair_kinematics_update (QnPairKinematics *pairs, int32_t count, const double v[6])
{
  if (count == 0)
    return;
  Turn a = turn_by (v[2] / pairs->length), b = turn_by (v[5] / pairs->length);
  for (int32_t p = 0; p < count; p++) {
    QnPairKinematics *pair = &pairs[p];
    QnVec2 move_a = turn_away (pair->arm_a, a), move_b = turn_away (pair->arm_b, b);
    QnVec2 d = qn_vec2_add (qn_vec2_sub (qn_vec2 (v[3], v[4]), qn_vec2 (v[0], v[1])),
                            qn_vec2_sub (move_b, move_a));
    /* Two halves make the frame's rotation: of both blocks, or of a alone. */
    Turn other = pair->share == 0.5 ? b : a;
    if (pair->share != 0.5)
      d = qn_vec2_add (d, pair->apart);
    pair->frame =
      qn_vec2_rotate (pair->normal, a.cosine * other.cosine - a.sine * other.sine,
                      a.sine * other.cosine + a.cosine * other.sine);
    pair->turned_a = qn_vec2_add (pair->arm_a, move_a);
    pair->turned_b = qn_vec2_add (pair->arm_b, move_b);
    pair->elongation[0] = qn_vec2_dot (pair->frame, d);
    pair->elongation[1] = qn_vec2_dot (qn_vec2_perp (pair->frame), d);
  }
}

/* With the force F = f_n n + f_t t, which turns with the frame, the shares s of block a and r = 1 - s of
 * block b in the frame's rotation, and f . q = f_n q_n + f_t q_t:
 *
 *   d (u_b - u_a) drz_a, drz_b   s z x F, r z x F
 *   drz_a drz_a                  (1 - 2 s) F . r_a - s^2 f . q
 *   drz_b drz_b                  (2 r - 1) F . r_b - r^2 f . q
 *   drz_a drz_b                  s F . r_b - r F . r_a - s r f . q
 */
void
qn_pair_kinematics_add_stiffness (const QnPairKinematics *pair, const double force[2],
                                  double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS])
{
  const QnVec2 f = qn_vec2_add_scaled (qn_vec2_scale (force[0], pair->frame), force[1],
                                       qn_vec2_perp (pair->frame));
  const QnVec2 turned = qn_vec2_perp (f);
  const double s = pair->share, r = 1 - s, l = 1 / pair->length;
  double along_a = qn_vec2_dot (f, pair->turned_a),
         along_b = qn_vec2_dot (f, pair->turned_b),
         work = force[0] * pair->elongation[0] + force[1] * pair->elongation[1];
  const double both[2] = { turned.x * l, turned.y * l };
  double cross = (s * along_b - r * along_a - s * r * work) * l * l;

  for (int c = 0; c < 2; c++) {
    k[0][1 + c] += s * both[c];
    k[1 + c][0] += s * both[c];
    k[3][1 + c] += r * both[c];
    k[1 + c][3] += r * both[c];
  }
  k[0][0] += ((1 - 2 * s) * along_a - s * s * work) * l * l;
  k[3][3] += ((2 * r - 1) * along_b - r * r * work) * l * l;
  k[0][3] += cross;
  k[3][0] += cross;
}
