/* Coulomb's law with a limit of compression: the joint is crushed where its normal force reaches
 * fc, for instance at the toe of a pier that overturns.
 *
 * With the terms of law-coulomb.c and k >= 0 the shortening of the step:
 *
 *   yield      f = |t| + mu n - c <= 0,   n <= cap,   -n <= fc
 *   flow       slip += g sign(t),   opening += psi g - k
 *
 * Return mapping where the limit of compression is reached, with tc = c + mu fc the shear
 * strength that is left there:
 *
 *   crush      g = max (0, (|t*| - tc) / ks),  k = psi g - (n* + fc) / kn > 0:
 *                                          n = -fc,  |t| = min (|t*|, tc)
 *
 * and the mapping of law-coulomb.c elsewhere. The shortening stays: a crushed joint opens that
 * much earlier. There is no hardening, no softening and no limit to the shortening, as in limit
 * analysis with a rectangular block of stress at the toe (Orduña & Lourenço, J. Struct. Eng. 129
 * (2003) 1367-1375; the surfaces are those of Lourenço & Rots, J. Eng. Mech. 123 (1997) 660-668,
 * whose cap in compression is an ellipse). */
#include "core/law/law-ops.h"

#include <math.h>

static void
evaluate (const QnSpring *s, const QnSpringMemory *committed, const double q[2],
          QnSpringResponse *r)
{
  double n_trial = s->kn * (q[0] - committed->opening);
  double t_trial = s->ks * (q[1] - committed->slip);
  double sign = t_trial < 0 ? -1 : 1;
  double left = s->cohesion + s->friction * s->compression;
  double g = qn_larger ((fabs (t_trial) - left) / s->ks, 0);
  double shortening = s->dilatancy * g - (n_trial + s->compression) / s->kn;

  if (shortening <= 0) {
    qn_law_coulomb_evaluate (s, committed, q, r);
    return;
  }
  *r = (QnSpringResponse){ .force = { -s->compression, t_trial },
                           .tangent = { { 0, 0 }, { 0, s->ks } },
                           .memory = *committed,
                           .phase = QN_PHASE_CRUSH };
  r->memory.opening += s->dilatancy * g - shortening;
  if (g > 0) {
    r->force[1] = sign * left;
    r->tangent[1][1] = 0;
    r->memory.slip += sign * g;
    r->phase = sign > 0 ? QN_PHASE_CRUSH_SLIP_POSITIVE : QN_PHASE_CRUSH_SLIP_NEGATIVE;
  }
}

static void
resolve (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  qn_law_coulomb_resolve (law, scale, spring);
  spring->compression = law->compression * scale.force;
}

static int
strength (const QnSpring *s, QnStrengthRow rows[])
{
  int count = qn_law_coulomb_strength (s, rows);

  rows[count++] = (QnStrengthRow){ .normal = -1, .limit = s->compression, .opening = -1 };
  return count;
}

static const QnLawParameter parameters[] = {
  QN_LAW_PARAMETER ("friction", friction, true, false),
  QN_LAW_PARAMETER ("compression", compression, true, true),
  QN_LAW_PARAMETER ("cohesion", cohesion, false, false),
  QN_LAW_PARAMETER ("tension", tension, false, false),
  QN_LAW_PARAMETER ("dilatancy", dilatancy, false, false),
};

const QnLawOps qn_law_ops_mohr_coulomb = {
  QN_LAW_PARAMETERS (parameters), .check = qn_law_coulomb_check, .resolve = resolve,
  .evaluate = evaluate,           .strength = strength,          .plastic = true
};
