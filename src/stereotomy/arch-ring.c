#include "stereotomy/arch-ring.h"
#include "core/base/integer.h"

/* Intervals of Simpson's rule for a quarter of an ellipse, and rounds of Newton's method. */
#define SIMPSON_INTERVALS 256
#define NEWTON_ROUNDS     12

/* d(arc length)/d(phi) of the ellipse x = a (1 - cos phi), y = b sin phi, or of the parabola
 * x = a t, y = b t (2 - t) with t = 2 phi / pi. */
static double
curve_speed (const QnArch *arch, double phi)
{
  return arch->shape == QN_ARCH_PARABOLIC
           ? M_2_PI * hypot (arch->span / 2, 2 * arch->rise * (1 - M_2_PI * phi))
           : hypot (arch->span / 2 * sin (phi), arch->rise * cos (phi));
}

static double
curve_length (const QnArch *arch, double phi)
{
  double step = phi / SIMPSON_INTERVALS, sum = 0;
  for (int i = 0; i <= SIMPSON_INTERVALS; i++) {
    double weight = i == 0 || i == SIMPSON_INTERVALS ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * curve_speed (arch, i * step);
  }
  return sum * step / 3;
}

/* phi of the point at `share` of the half's length. */
static double
curve_angle (const QnArchRing *ring, double share)
{
  double phi = share * M_PI_2, target = share * ring->half_length;
  for (int i = 0; i < NEWTON_ROUNDS; i++) {
    double step =
      (curve_length (&ring->arch, phi) - target) / curve_speed (&ring->arch, phi);
    phi = fmin (fmax (phi - step, 0), M_PI_2);
    if (fabs (step) < 1e-14)
      break;
  }
  return phi;
}

double
qn_arch_haunch (const QnArch *arch)
{
  double least = (sqrt (3) - 1) / 2 * (arch->span / 2 - arch->rise);
  return arch->haunch > 0 ? arch->haunch : arch->rise - least;
}

/* The circles touch where the line through their centres meets them: with a = half the span, r and R
 * the radii, d the depth of the middle centre, (R - r)^2 = (a - r)^2 + d^2 and R = rise + d. */
static void
init_three_centred (QnArchRing *ring)
{
  const QnArch *arch = &ring->arch;
  double r = qn_arch_haunch (arch), a = arch->span / 2 - r, b = arch->rise - r;
  ring->radius = r;
  ring->centre = -(a * a - b * b) / (2 * b);
  ring->crown_radius = arch->rise - ring->centre;
  ring->crown_opening = atan2 (a, -ring->centre);
  ring->half_length =
    r * (M_PI_2 - ring->crown_opening) + ring->crown_radius * ring->crown_opening;
}

void
qn_arch_ring_init (QnArchRing *ring, const QnArch *arch)
{
  *ring = (QnArchRing){ .arch = *arch };
  double half = arch->span / 2, turn = M_PI;
  switch (arch->shape) {
  case QN_ARCH_CIRCULAR:
    ring->radius = (half * half + arch->rise * arch->rise) / (2 * arch->rise);
    ring->centre = arch->rise - ring->radius;
    ring->opening = atan2 (half, -ring->centre);
    turn = 2 * ring->opening;
    break;
  case QN_ARCH_POINTED:
    ring->centre = (arch->rise * arch->rise - half * half) / arch->span;
    ring->radius = half + ring->centre;
    ring->opening = acos (ring->centre / ring->radius);
    ring->outer_opening = acos (ring->centre / (ring->radius + arch->ring));
    turn = 2 * ring->outer_opening;
    break;
  case QN_ARCH_THREE_CENTRED:
    init_three_centred (ring);
    break;
  case QN_ARCH_PARABOLIC:
    turn = 2 * atan (4 * arch->rise / arch->span); /* fall through */
  case QN_ARCH_ELLIPTIC:
  case QN_ARCH_SHAPE_COUNT:
    ring->half_length = curve_length (arch, M_PI_2);
    break;
  }
  double chord = 2 * acos (1 - QN_ARCH_SAGITTA);
  ring->chords =
    arch->sides == QN_SIDES_STRAIGHT
      ? 1
      : (int32_t) qn_to_integer (ceil (turn / arch->voussoirs / chord), 1, QN_MAX_BLOCKS);
}

/* Point at the distance `offset` outside the intrados, on the left half (u <= 1/2). */
static QnVec2
left_half (const QnArchRing *ring, double u, double offset)
{
  const QnArch *arch = &ring->arch;
  double half = arch->span / 2;
  switch (arch->shape) {
  case QN_ARCH_CIRCULAR: {
    /* Angle from the vertical, positive to the left; the springing's direction is taken from
     * lengths, so that it is exact. */
    double angle = ring->opening * (1 - 2 * u);
    double s = u == 0 ? half / ring->radius : sin (angle);
    double c = u == 0 ? -ring->centre / ring->radius : cos (angle);
    double y = u == 0 ? 0 : ring->centre + ring->radius * c;
    double x = u == 0 ? 0 : half - ring->radius * s;
    return qn_vec2 (x - offset * s, y + offset * c);
  }
  case QN_ARCH_POINTED: {
    double angle = 2 * u * ring->opening;
    double reach = ring->radius + offset;
    if (u == 0.5)
      return qn_vec2 (half, sqrt (reach * reach - ring->centre * ring->centre));
    return qn_vec2 (half + ring->centre - reach * cos (angle), reach * sin (angle));
  }
  case QN_ARCH_THREE_CENTRED: {
    double s = 2 * u * ring->half_length,
           haunch = ring->radius * (M_PI_2 - ring->crown_opening);
    double reach = ring->crown_radius + offset;
    double angle = (ring->half_length - s) / ring->crown_radius; /* from the vertical */
    if (s >= haunch)
      return u == 0.5
               ? qn_vec2 (half, arch->rise + offset)
               : qn_vec2 (half - reach * sin (angle), ring->centre + reach * cos (angle));
    angle = s / ring->radius; /* from the horizontal */
    reach = ring->radius + offset;
    return u == 0 ? qn_vec2 (-offset, 0)
                  : qn_vec2 (ring->radius - reach * cos (angle), reach * sin (angle));
  }
  case QN_ARCH_PARABOLIC: {
    double t = u == 0.5 ? 1 : M_2_PI * curve_angle (ring, 2 * u);
    QnVec2 normal = { -2 * arch->rise * (1 - t), half };
    normal = qn_vec2_scale (1 / qn_vec2_length (normal), normal);
    return qn_vec2_add_scaled (qn_vec2 (half * t, arch->rise * t * (2 - t)), offset,
                               normal);
  }
  case QN_ARCH_ELLIPTIC:
  case QN_ARCH_SHAPE_COUNT:
    break;
  }
  double phi = curve_angle (ring, 2 * u);
  double c = u == 0.5 ? 0 : cos (phi), s = u == 0.5 ? 1 : sin (phi);
  /* Gradient of (x/a)^2 + (y/b)^2. */
  QnVec2 normal = { -c / half, s / arch->rise };
  normal = qn_vec2_scale (1 / qn_vec2_length (normal), normal);
  return qn_vec2_add_scaled (qn_vec2 (half * (1 - c), arch->rise * s), offset, normal);
}

QnVec2
qn_arch_ring_point (const QnArchRing *ring, double u, double offset)
{
  if (u <= 0.5)
    return left_half (ring, u, offset);
  QnVec2 mirrored = left_half (ring, 1 - u, offset);
  return qn_vec2 (ring->arch.span - mirrored.x, mirrored.y);
}

/* The joint between voussoirs index - 1 and index; exactly mirrored. */
static double
joint_at (const QnArchRing *ring, int32_t index)
{
  int32_t n = ring->arch.voussoirs;
  return 2 * index <= n ? (double) index / n : 1 - (double) (n - index) / n;
}

/* Number of chords on one side of the voussoir between two joints; even where a pointed
 * keystone needs a corner at the crown. */
static int32_t
chords_between (const QnArchRing *ring, double u0, double u1)
{
  bool corner = ring->arch.shape == QN_ARCH_POINTED && u0 < 0.5 && u1 > 0.5;
  return corner ? ring->chords + ring->chords % 2 : ring->chords;
}

/* Position k of n between two joints, exactly 1/2 in the middle of a keystone. */
static double
position_between (double u0, double u1, int32_t k, int32_t n)
{
  if (k == 0)
    return u0;
  if (k == n)
    return u1;
  double u = u0 + (u1 - u0) * k / n;
  return fabs (u - 0.5) < 1e-12 ? 0.5 : u;
}

/* The extrados of a pointed arch runs on to the vertical beyond the last radial joint. Its
 * points at even angles from the springing to the crown, u in [0, 1]. */
static QnVec2
pointed_extrados (const QnArchRing *ring, double u)
{
  double w = u <= 0.5 ? u : 1 - u;
  double angle = 2 * w * ring->outer_opening, reach = ring->radius + ring->arch.ring;
  double half = ring->arch.span / 2;
  QnVec2 p = w == 0.5
               ? left_half (ring, 0.5, ring->arch.ring)
               : qn_vec2 (half + ring->centre - reach * cos (angle), reach * sin (angle));
  return u <= 0.5 ? p : qn_vec2 (ring->arch.span - p.x, p.y);
}

/* Where the joint at u meets the extrados, in the measure of pointed_extrados(). */
static double
outer_position (const QnArchRing *ring, double u)
{
  double scale = ring->opening / ring->outer_opening;
  return u == 0.5 ? 0.5 : u < 0.5 ? u * scale : 1 - (1 - u) * scale;
}

/* Point k of n of the upper side of a voussoir between two joints, at an offset. */
static QnVec2
upper_point (const QnArchRing *ring, double u0, double u1, int32_t k, int32_t n,
             double offset)
{
  return ring->arch.shape == QN_ARCH_POINTED && k > 0 && k < n
           ? pointed_extrados (ring, position_between (outer_position (ring, u0),
                                                       outer_position (ring, u1), k, n))
           : qn_arch_ring_point (ring, position_between (u0, u1, k, n), offset);
}

QnRing
qn_arch_ring_voussoir (const QnArchRing *ring, int32_t course, int32_t index)
{
  double u0 = joint_at (ring, index), u1 = joint_at (ring, index + 1);
  double thickness = ring->arch.ring / qn_arch_rings (&ring->arch);
  int32_t n = chords_between (ring, u0, u1);
  QnRing voussoir = { g_new (QnVec2, 2 * (size_t) n + 2), 0 };
  for (int32_t k = n; k >= 0; k--)
    voussoir.points[voussoir.count++] =
      qn_arch_ring_point (ring, position_between (u0, u1, k, n), course * thickness);
  for (int32_t k = 0; k <= n; k++)
    voussoir.points[voussoir.count++] =
      upper_point (ring, u0, u1, k, n, (course + 1) * thickness);
  qn_ring_orient (&voussoir);
  return voussoir;
}

QnRing
qn_arch_ring_line (const QnArchRing *ring, bool outside, double level)
{
  size_t most = (size_t) ring->arch.voussoirs * ((size_t) ring->chords + 1) + 1;
  QnRing line = { g_new (QnVec2, most), 0 };
  line.points[line.count++] = qn_arch_ring_point (ring, 0, outside ? ring->arch.ring : 0);
  for (int32_t i = 0; i < ring->arch.voussoirs; i++) {
    double u0 = joint_at (ring, i), u1 = joint_at (ring, i + 1);
    int32_t n = chords_between (ring, u0, u1);
    for (int32_t k = 1; k <= n; k++) {
      QnVec2 last = line.points[line.count - 1];
      QnVec2 p = outside ? upper_point (ring, u0, u1, k, n, ring->arch.ring)
                         : qn_arch_ring_point (ring, position_between (u0, u1, k, n), 0);
      bool above = p.y >= level;
      if (above && p.y > level)
        p = qn_vec2_lerp (last, p, (level - last.y) / (p.y - last.y));
      p.y = above ? level : p.y;
      line.points[line.count++] = p;
      if (above)
        return line;
    }
  }
  return line;
}
