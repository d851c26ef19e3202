/* A curve given by points joined by straight lines, with elastic unloading.
 *
 * In monotonic loading the force follows the points, beyond the last one it stays what it is
 * there; a side without points is elastic. Tension and compression harden and soften
 * independently, each with a plastic elongation of its own, pt and pc >= 0:
 *
 *   n = kn (q - pt + pc),   -C(q') <= n <= T(q''),   q' = pt - q,  q'' = q + pc
 *
 * T and C are the two sides of the curve; each is entered with the elongation less what the
 * other side has made plastic. No iteration is needed: the force is the elastic one or that of
 * the curve, whichever is smaller, and in the second case pt = q'' - T(q'') / kn. (Two-surface
 * plasticity with independent hardening; Simo & Hughes 1998, chapter 1.)
 *
 * Where the curve descends beyond its largest force and an energy G is given, the descent is
 * stretched: the plastic elongations from the peak on are multiplied by one factor so that the
 * area under them, above the last force, is G. Curves over strain must have one: the response
 * then does not depend on the size of the blocks.
 *
 * State: pt - pc as `opening` and pc as `extreme`. Shear is elastic.
 */
#include "core/law/law-ops.h"

#include <math.h>

/* Forces that differ by less than this part from the elastic one are elastic: what decimal
 * digits leave of a first point meant to lie on the line of kn. */
#define ELASTIC 1e-12

/* How much steeper than kn a branch may be for the same reason. */
#define STEEP 1e-9

/* One side of the curve as the spring sees it, points outwards from the origin. */
typedef struct {
  const QnSpring *spring;
  int first, step, count; /* into spring->points */
  int peak; /* number of the point with the largest force, the last of equals */
  double peak_plastic;
  double stretch;
} Side;

/* Force and plastic elongation of point i of a side, both >= 0. */
static double
point_force (const Side *side, int i)
{
  return fabs (side->spring->points[side->first + i * side->step].y)
         * side->spring->force_scale;
}

static double
point_plastic (const Side *side, int i)
{
  const QnSpring *s = side->spring;
  double e = fabs (s->points[side->first + i * side->step].x) * s->strain_scale;
  double plastic = e - point_force (side, i) / s->kn;

  if (i > side->peak)
    plastic = side->peak_plastic + side->stretch * (plastic - side->peak_plastic);
  return plastic;
}

static Side
side_of (const QnSpring *s, bool tension)
{
  int first_positive = 0, last_negative;

  while (first_positive < s->point_count && s->points[first_positive].x <= 0)
    first_positive++;
  last_negative = first_positive - 1;
  if (last_negative >= 0 && s->points[last_negative].x == 0)
    last_negative--;

  Side side = { .spring = s,
                .first = tension ? first_positive : last_negative,
                .step = tension ? 1 : -1,
                .count = tension ? s->point_count - first_positive : last_negative + 1,
                .peak = s->point_count,
                .stretch = s->stretch[tension ? 0 : 1] };
  int peak = 0;
  for (int i = 1; i < side.count; i++)
    if (point_force (&side, i) >= point_force (&side, peak))
      peak = i;
  if (side.count > 0)
    side.peak_plastic = point_plastic (&side, peak);
  side.peak = peak;
  return side;
}

/* Force of a side at the elongation e >= 0, and its slope. */
static double
side_force (const Side *side, double e, double *slope)
{
  double e0 = 0, f0 = 0;

  for (int i = 0; i < side->count; i++) {
    double f = point_force (side, i);
    double e1 = point_plastic (side, i) + f / side->spring->kn;
    if (e < e1) {
      *slope = (f - f0) / (e1 - e0);
      return f0 + *slope * (e - e0);
    }
    e0 = e1;
    f0 = f;
  }
  *slope = 0;
  return f0;
}

static void
evaluate_curve (const QnSpring *s, const QnSpringMemory *committed, const double q[2],
                QnSpringResponse *r)
{
  double trial = s->kn * (q[0] - committed->opening);
  double compressed = committed->extreme, stretched = committed->opening + compressed;
  bool tension = trial > 0;
  double sign = tension ? 1 : -1;
  Side side = side_of (s, tension);

  *r = (QnSpringResponse){ .force = { trial, s->ks * q[1] },
                           .tangent = { { s->kn, 0 }, { 0, s->ks } },
                           .memory = *committed,
                           .state = QN_PAIR_STICK };
  if (side.count == 0)
    return;

  double e = tension ? q[0] + compressed : stretched - q[0], slope;
  double force = side_force (&side, e, &slope);
  if (fabs (trial) - force <= ELASTIC * fabs (trial))
    return;
  r->force[0] = sign * force;
  r->tangent[0][0] = slope;
  if (tension) {
    stretched = e - force / s->kn;
  } else {
    compressed = e - force / s->kn;
    r->memory.extreme = compressed;
  }
  r->memory.opening = stretched - compressed;
  r->state = QN_PAIR_YIELD;
}

/* --- Parameters ------------------------------------------------------------------------- */

/* The descent of a side of the law itself: plastic elongation times force above the last one;
 * 0 where it does not descend. */
static double
descent_energy (const QnSpring *plain, bool tension)
{
  Side side = side_of (plain, tension);
  double energy = 0, last = side.count > 0 ? point_force (&side, side.count - 1) : 0;

  side.stretch = 1;
  for (int i = side.peak + 1; i < side.count; i++) {
    double length = point_plastic (&side, i) - point_plastic (&side, i - 1);
    double mean = 0.5 * (point_force (&side, i) + point_force (&side, i - 1));
    energy += (mean - last) * length;
  }
  return energy;
}

/* The law as a spring of unit area and unit length. */
static QnSpring
plain_spring (const QnLaw *law)
{
  return (QnSpring){ .kn = law->kn,
                     .points = law->points,
                     .point_count = law->point_count,
                     .force_scale = 1,
                     .strain_scale = 1,
                     .stretch = { 1, 1 } };
}

static QnProblem
check_point (const QnLaw *law, int32_t i)
{
  const QnVec2 *p = law->points, origin = { 0, 0 };
  bool inner_before = i > 0 && p[i - 1].x > 0;
  bool inner_after = i + 1 < law->point_count && p[i + 1].x < 0;

  if (!isfinite (p[i].x) || !isfinite (p[i].y))
    return QN_PROBLEM_NOT_FINITE;
  if (i > 0 && p[i].x <= p[i - 1].x)
    return QN_PROBLEM_CURVE_ORDER;
  /* What is wrong with point i, the one nearer to the origin being `inner`. */
  QnVec2 inner = p[i].x > 0 && inner_before  ? p[i - 1]
                 : p[i].x < 0 && inner_after ? p[i + 1]
                                             : origin;
  QnVec2 point = p[i];
  double de = fabs (point.x - inner.x), df = fabs (point.y) - fabs (inner.y);
  if (point.x * point.y < 0 || (point.x == 0 && point.y != 0))
    return QN_PROBLEM_CURVE_SIGN;
  if (df > law->kn * de * (1 + STEEP))
    return QN_PROBLEM_CURVE_TOO_STEEP;
  return QN_PROBLEM_NONE;
}

/* A law for all sizes of blocks must say what energy its descent dissipates. */
static bool
check_energy (const QnLaw *law, bool tension, double given, const char *field,
              QnSubject of)
{
  QnSpring plain = plain_spring (law);

  return qn_require (of,
                     law->basis != QN_BASIS_MATERIAL || given != 0
                       || !(descent_energy (&plain, tension) > 0),
                     QN_PROBLEM_FRACTURE_ENERGY_MISSING, field, 0);
}

static bool
check_curve (const QnLaw *law, QnSubject of)
{
  const int32_t count = law->point_count;
  const QnVec2 *p = law->points;

  if (!qn_require (of,
                   count >= 1 && count <= QN_MAX_CURVE_POINTS
                     && !(count == 1 && p[0].x == 0 && p[0].y == 0),
                   QN_PROBLEM_CURVE_COUNT, "points", count))
    return false;
  for (int32_t i = 0; i < count; i++) {
    QnProblem problem = check_point (law, i);
    if (qn_require (of, problem == QN_PROBLEM_NONE, problem, "points", p[i].x))
      continue;
    if (of.diag != NULL)
      of.diag->sub = i;
    return false;
  }
  return check_energy (law, false, law->crushing_energy, "crushing_energy", of)
         && check_energy (law, true, law->fracture_energy, "fracture_energy", of);
}

static void
resolve_curve (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  QnSpring plain = plain_spring (law);

  spring->points = law->points;
  spring->point_count = law->point_count;
  spring->force_scale = scale.force;
  spring->strain_scale = scale.strain;
  for (int side = 0; side < 2; side++) {
    double own = descent_energy (&plain, side == 0) * scale.strain;
    double given = side == 0 ? law->fracture_energy : law->crushing_energy;
    spring->stretch[side] = given > 0 && own > 0 ? given / own : 1;
  }
}

static double
softening_curve (const QnSpring *s)
{
  double steepest = 0;

  for (int tension = 0; tension < 2; tension++) {
    Side side = side_of (s, tension);
    for (int i = side.peak + 1; i < side.count; i++) {
      double fall = point_force (&side, i - 1) - point_force (&side, i);
      double length =
        point_plastic (&side, i) - point_plastic (&side, i - 1) - fall / s->kn;
      if (fall > 0)
        steepest = fmax (steepest, length > 0 ? fall / length : INFINITY);
    }
  }
  return steepest;
}

static const QnLawParameter curve_parameters[] = {
  QN_LAW_PARAMETER ("fracture_energy", fracture_energy, false, true),
  QN_LAW_PARAMETER ("crushing_energy", crushing_energy, false, true),
};

const QnLawOps qn_law_ops_curve = { QN_LAW_PARAMETERS (curve_parameters),
                                    .check = check_curve, .resolve = resolve_curve,
                                    .evaluate = evaluate_curve,
                                    .softening = softening_curve };
