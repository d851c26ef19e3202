#include "stereotomy/arch-ring.h"
#include "support/room.h"

#include <glib.h>

static double
ring_area (const QnArch *arch)
{
  QnArchRing ring;
  qn_arch_ring_init (&ring, arch);
  double area = 0;
  for (int i = 0; i < arch->voussoirs; i++) {
    g_auto (QnRing) voussoir = qn_arch_ring_voussoir (&ring, 0, i);
    g_assert_cmpfloat (qn_ring_area (&voussoir), >, 0);
    area += qn_ring_area (&voussoir);
  }
  return area;
}

static void
test_semicircle (void)
{
  QnArch arch = { .span = 2, .rise = 1, .ring = 0.2, .voussoirs = 9 };
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  g_assert_cmpfloat (qn_arch_ring_extrados (&ring, 0).x, ==, -0.2);
  g_assert_cmpfloat (qn_arch_ring_extrados (&ring, 0).y, ==, 0);
  g_assert_cmpfloat (qn_arch_ring_point (&ring, 1, 0).x, ==, 2);
  g_assert_cmpfloat_with_epsilon (qn_arch_ring_point (&ring, 0.5, 0).y, 1, 1e-15);
  double exact = M_PI / 2 * (1.2 * 1.2 - 1);
  g_assert_cmpfloat_with_epsilon (ring_area (&arch), exact, 0.01 * exact);
  /* Straight sides: sectors of a regular polygon. */
  arch.sides = QN_SIDES_STRAIGHT;
  arch.voussoirs = 27;
  exact = 27. / 2 * sin (M_PI / 27) * (1.2 * 1.2 - 1);
  g_assert_cmpfloat_with_epsilon (ring_area (&arch), exact, 1e-12);
}

static void
test_shared_joints (void)
{
  const QnArch arches[] = {
    { .span = 3, .rise = 0.7, .ring = 0.3, .voussoirs = 8 },
    { .span = 3, .rise = 2.5, .ring = 0.3, .voussoirs = 7, .shape = QN_ARCH_POINTED },
    { .span = 3, .rise = 2.5, .ring = 0.3, .voussoirs = 8, .shape = QN_ARCH_POINTED },
    { .span = 3, .rise = 0.7, .ring = 0.3, .voussoirs = 8, .shape = QN_ARCH_ELLIPTIC },
    { .span = 3, .rise = 0.7, .ring = 0.3, .voussoirs = 7, .shape = QN_ARCH_PARABOLIC },
    { .span = 3,
      .rise = 0.9,
      .ring = 0.3,
      .voussoirs = 8,
      .shape = QN_ARCH_THREE_CENTRED }
  };
  for (size_t k = 0; k < G_N_ELEMENTS (arches); k++) {
    QnArchRing ring;
    qn_arch_ring_init (&ring, &arches[k]);
    QnRing line = qn_arch_ring_line (&ring, false, INFINITY);
    double crown = 0;
    for (size_t i = 0; i < line.count; i++) {
      crown = fmax (crown, line.points[i].y);
      /* Symmetric. */
      QnVec2 p = line.points[i], q = line.points[line.count - 1 - i];
      g_assert_cmpfloat_with_epsilon (p.x + q.x, 3, 1e-15);
      g_assert_cmpfloat_with_epsilon (p.y, q.y, 1e-15);
    }
    qn_ring_clear (&line);
    if (arches[k].shape == QN_ARCH_POINTED || arches[k].voussoirs % 2 == 0)
      g_assert_cmpfloat_with_epsilon (crown, arches[k].rise, 1e-12);
    /* Neighbours share both ends of their joint exactly. */
    for (int i = 0; i + 1 < arches[k].voussoirs; i++) {
      g_auto (QnRing) a = qn_arch_ring_voussoir (&ring, 0, i),
                      b = qn_arch_ring_voussoir (&ring, 0, i + 1);
      int shared = 0;
      for (size_t m = 0; m < a.count; m++)
        for (size_t n = 0; n < b.count; n++)
          shared += a.points[m].x == b.points[n].x && a.points[m].y == b.points[n].y;
      g_assert_cmpint (shared, ==, 2);
    }
  }
}

static void
test_pointed_crown (void)
{
  QnArch arch = {
    .span = 4, .rise = 3, .ring = 0.5, .voussoirs = 12, .shape = QN_ARCH_POINTED
  };
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  /* Centres (9 - 4) / 4 beyond the middle: radius 3.25. */
  g_assert_cmpfloat_with_epsilon (ring.radius, 3.25, 1e-15);
  QnVec2 crown = qn_arch_ring_extrados (&ring, 0.5);
  g_assert_cmpfloat (crown.x, ==, 2);
  g_assert_cmpfloat_with_epsilon (crown.y, sqrt (3.75 * 3.75 - 1.25 * 1.25), 1e-12);
  /* Two sectors between the radii, less what crosses the middle. */
  double outer = acos (1.25 / 3.75), inner = acos (1.25 / 3.25);
  double exact = 3.75 * 3.75 * outer - 1.25 * crown.y - (3.25 * 3.25 * inner - 1.25 * 3);
  g_assert_cmpfloat_with_epsilon (ring_area (&arch), exact, 0.01 * exact);
}

static void
test_ellipse_even (void)
{
  QnArch arch = { .span = 6,
                  .rise = 1,
                  .ring = 0.3,
                  .voussoirs = 10,
                  .shape = QN_ARCH_ELLIPTIC,
                  .sides = QN_SIDES_STRAIGHT };
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  /* Equal lengths of the intrados between joints, measured in small steps. */
  double lengths[10], mean = 0;
  for (int i = 0; i < 10; i++) {
    lengths[i] = 0;
    QnVec2 p = qn_arch_ring_point (&ring, i / 10., 0);
    for (int k = 1; k <= 200; k++) {
      QnVec2 q = qn_arch_ring_point (&ring, (i + k / 200.) / 10, 0);
      lengths[i] += qn_vec2_length (qn_vec2_sub (q, p));
      p = q;
    }
    mean += lengths[i] / 10;
    QnVec2 at = qn_arch_ring_point (&ring, i / 10., 0);
    double ellipse = (at.x - 3) * (at.x - 3) / 9 + at.y * at.y;
    g_assert_cmpfloat_with_epsilon (ellipse, 1, 1e-12);
    QnVec2 out = qn_vec2_sub (qn_arch_ring_extrados (&ring, i / 10.), at);
    g_assert_cmpfloat_with_epsilon (qn_vec2_length (out), 0.3, 1e-12);
  }
  for (int i = 0; i < 10; i++)
    g_assert_cmpfloat_with_epsilon (lengths[i], mean, 2e-5 * mean);
}

/* The usual three-centred arch of 10 by 3 m: three arcs of 60 degrees, by hand. */
static void
test_three_centred (void)
{
  QnArch arch = {
    .span = 10, .rise = 3, .ring = 0.6, .voussoirs = 24, .shape = QN_ARCH_THREE_CENTRED
  };
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  double r = 3 - (sqrt (3) - 1), depth = sqrt (3) * (5 - r);
  g_assert_cmpfloat_with_epsilon (ring.radius, r, 1e-12);
  g_assert_cmpfloat_with_epsilon (ring.crown_radius, 3 + depth, 1e-12);
  g_assert_cmpfloat_with_epsilon (ring.crown_opening, G_PI / 6, 1e-12);
  for (int i = 0; i <= 100; i++) {
    QnVec2 p = qn_arch_ring_point (&ring, i / 100., 0), q;
    q = qn_vec2_sub (qn_arch_ring_extrados (&ring, i / 100.), p);
    g_assert_cmpfloat_with_epsilon (qn_vec2_length (q), 0.6, 1e-12);
    double crown = hypot (p.x - 5, p.y + depth);
    double end = hypot (fmin (p.x, 10 - p.x) - r, p.y);
    g_assert_true (fabs (crown - 3 - depth) < 1e-12 || fabs (end - r) < 1e-12);
  }
  /* Another radius: the circles still touch. */
  arch.haunch = 1;
  qn_arch_ring_init (&ring, &arch);
  g_assert_cmpfloat_with_epsilon (hypot (4, ring.centre), ring.crown_radius - 1, 1e-12);
}

static void
test_parabola (void)
{
  QnArch arch = {
    .span = 6, .rise = 2, .ring = 0.3, .voussoirs = 10, .shape = QN_ARCH_PARABOLIC
  };
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  /* Half its length, with k = 4 rise / span: span / 4 (sqrt (1 + k^2) + asinh (k) / k). */
  double k = 4. * 2 / 6, half = 6. / 4 * (sqrt (1 + k * k) + asinh (k) / k);
  g_assert_cmpfloat_with_epsilon (ring.half_length, half, 1e-9);
  for (int i = 0; i <= 20; i++) {
    QnVec2 p = qn_arch_ring_point (&ring, i / 20., 0);
    g_assert_cmpfloat_with_epsilon (p.y, 2. / 9 * p.x * (6 - p.x), 1e-12);
    /* The joint is normal to the curve, whose slope is 2/9 (6 - 2 x). */
    QnVec2 joint = qn_vec2_sub (qn_arch_ring_extrados (&ring, i / 20.), p);
    g_assert_cmpfloat_with_epsilon (joint.x + joint.y * 2. / 9 * (6 - 2 * p.x), 0, 1e-12);
    g_assert_cmpfloat_with_epsilon (qn_vec2_length (joint), 0.3, 1e-12);
  }
}

QN_TESTS
{
  g_test_add_func ("/arch-ring/semicircle", test_semicircle);
  g_test_add_func ("/arch-ring/shared-joints", test_shared_joints);
  g_test_add_func ("/arch-ring/pointed-crown", test_pointed_crown);
  g_test_add_func ("/arch-ring/ellipse-even", test_ellipse_even);
  g_test_add_func ("/arch-ring/three-centred", test_three_centred);
  g_test_add_func ("/arch-ring/parabola", test_parabola);
}
