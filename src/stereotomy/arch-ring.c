#include "stereotomy/arch-ring.h"
#include "core/base/integer.h"
#include "core/base/memory.h"

/* Intervals of Simpson's rule for a quarter of an ellipse, and rounds of Newton's method. */
#define SIMPSON_INTERVALS 256
#define NEWTON_ROUNDS     12

/* d(arc length)/d(phi) of the ellipse x = a (1 - cos phi), y = b sin phi. */
static double
ellipse_speed (const QnArch *arch, double phi)
{
  return hypot (arch->span / 2 * sin (phi), arch->rise * cos (phi));
}

static double
ellipse_length (const QnArch *arch, double phi)
{
  double step = phi / SIMPSON_INTERVALS, sum = 0;
  for (int i = 0; i <= SIMPSON_INTERVALS; i++) {
    double weight = i == 0 || i == SIMPSON_INTERVALS ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * ellipse_speed (arch, i * step);
  }
  return sum * step / 3;
}

/* phi of the point at `share` of the quarter's length. */
static double
ellipse_angle (const QnArchRing *ring, double share)
{
  double phi = share * M_PI_2, target = share * ring->half_length;
  for (int i = 0; i < NEWTON_ROUNDS; i++) {
    double step =
      (ellipse_length (&ring->arch, phi) - target) / ellipse_speed (&ring->arch, phi);
    phi = fmin (fmax (phi - step, 0), M_PI_2);
    if (fabs (step) < 1e-14)
      break;
  }
  return phi;
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
  case QN_ARCH_ELLIPTIC:
  case QN_ARCH_SHAPE_COUNT:
    ring->half_length = ellipse_length (arch, M_PI_2);
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
  case QN_ARCH_ELLIPTIC:
  case QN_ARCH_SHAPE_COUNT:
    break;
  }
  double phi = ellipse_angle (ring, 2 * u);
  double c = u == 0.5 ? 0 : cos (phi), s = u == 0.5 ? 1 : sin (phi);
  /* Gradient of (x/a)^2 + (y/b)^2. */
  QnVec2 normal = { -c / half, s / arch->rise };
  normal = qn_vec2_scale (1 / qn_vec2_length (normal), normal);
  return qn_vec2_add_scaled (qn_vec2 (half * (1 - c), arch->rise * s), offset, normal);
}

static QnVec2
point_at (const QnArchRing *ring, double u, double offset)
{
  if (u <= 0.5)
    return left_half (ring, u, offset);
  QnVec2 mirrored = left_half (ring, 1 - u, offset);
  return qn_vec2 (ring->arch.span - mirrored.x, mirrored.y);
}

QnVec2
qn_arch_ring_intrados (const QnArchRing *ring, double u)
{
  return point_at (ring, u, 0);
}

QnVec2
qn_arch_ring_extrados (const QnArchRing *ring, double u)
{
  return point_at (ring, u, ring->arch.ring);
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

bool
qn_arch_ring_voussoir (const QnArchRing *ring, int32_t index, QnRing *voussoir)
{
  double u0 = joint_at (ring, index), u1 = joint_at (ring, index + 1);
  int32_t n = chords_between (ring, u0, u1);
  bool pointed = ring->arch.shape == QN_ARCH_POINTED;
  double v0 = pointed ? outer_position (ring, u0) : u0;
  double v1 = pointed ? outer_position (ring, u1) : u1;
  voussoir->points = qn_alloc (2 * (size_t) n + 2, sizeof *voussoir->points);
  voussoir->count = 0;
  if (voussoir->points == NULL)
    return false;

  for (int32_t k = n; k >= 0; k--)
    voussoir->points[voussoir->count++] =
      qn_arch_ring_intrados (ring, position_between (u0, u1, k, n));
  for (int32_t k = 0; k <= n; k++) {
    QnVec2 p;
    if (k == 0)
      p = qn_arch_ring_extrados (ring, u0);
    else if (k == n)
      p = qn_arch_ring_extrados (ring, u1);
    else if (pointed)
      p = pointed_extrados (ring, position_between (v0, v1, k, n));
    else
      p = qn_arch_ring_extrados (ring, position_between (u0, u1, k, n));
    voussoir->points[voussoir->count++] = p;
  }
  qn_ring_orient (voussoir);
  return true;
}

bool
qn_arch_ring_line (const QnArchRing *ring, QnRing *line)
{
  size_t most = (size_t) ring->arch.voussoirs * ((size_t) ring->chords + 1) + 1;
  line->points = qn_alloc (most, sizeof *line->points);
  line->count = 0;
  if (line->points == NULL)
    return false;
  line->points[line->count++] = qn_arch_ring_intrados (ring, 0);
  for (int32_t i = 0; i < ring->arch.voussoirs; i++) {
    double u0 = joint_at (ring, i), u1 = joint_at (ring, i + 1);
    int32_t n = chords_between (ring, u0, u1);
    for (int32_t k = 1; k <= n; k++)
      line->points[line->count++] =
        qn_arch_ring_intrados (ring, position_between (u0, u1, k, n));
  }
  return true;
}
