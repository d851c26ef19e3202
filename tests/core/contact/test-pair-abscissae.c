#include "core/contact/pair-abscissae.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Sum over the pairs of y^power, y from -1/2 to 1/2 across a face of unit length. */
static double
moment (const QnPairRule *rule, int power)
{
  double sum = 0;
  for (size_t i = 0; i < qn_pair_rule_count (rule); i++) {
    double position, weight;
    qn_pair_rule_place (rule, 1, i, &position, &weight);
    sum += weight * pow (position - 0.5, power);
  }
  return sum;
}

static void
test_ends (void)
{
  QnPairRule rule = { .placement = QN_PLACEMENT_ENDS, .offset = 0.1 };
  g_assert_cmpuint (qn_pair_rule_count (&rule), ==, 2);
  g_assert_cmpfloat_with_epsilon (moment (&rule, 0), 1, 1e-15);
  g_assert_cmpfloat_with_epsilon (moment (&rule, 2) * 12, 3 * 0.8 * 0.8, 1e-14);
}

/* Force and bending are exact from three pairs on; evenly spaced, symmetric, nearly equal; full
 * plastic bending 5/(8 n^2) too much for even n. */
static void
test_uniform (void)
{
  for (int n = 1; n <= 40; n++) {
    QnPairRule rule = { .placement = QN_PLACEMENT_UNIFORM, .count = n };
    double bending = n > 2 ? 1 : 1 - 1.0 / (n * n), plastic = 0;
    g_assert_cmpfloat_with_epsilon (moment (&rule, 0), 1, 1e-14);
    g_assert_cmpfloat_with_epsilon (moment (&rule, 1), 0, 1e-14);
    g_assert_cmpfloat_with_epsilon (moment (&rule, 2) * 12, bending, 1e-13);
    g_assert_cmpfloat_with_epsilon (moment (&rule, 3), 0, 1e-14);
    for (size_t i = 0; i < (size_t) n; i++) {
      double position, weight;
      qn_pair_rule_place (&rule, 1, i, &position, &weight);
      g_assert_cmpfloat_with_epsilon (position, ((double) i + 0.5) / n, 1e-15);
      g_assert_cmpfloat_with_epsilon (weight * n, 1, 4.0 / (n * n));
      plastic += weight * fabs (position - 0.5);
    }
    if (n % 2 == 0 && n > 2)
      g_assert_cmpfloat_with_epsilon ((4 * plastic - 1) * n * n, 5. / 8, 0.7 / (n * n));
  }
}

static void
test_maclaurin (void)
{
  static const double three[] = { 3. / 8, 2. / 8, 3. / 8 };
  static const double four[] = { 13. / 48, 11. / 48, 11. / 48, 13. / 48 };
  for (int n = 3; n <= 4; n++) {
    QnPairRule rule = { .placement = QN_PLACEMENT_UNIFORM, .count = n };
    for (size_t i = 0; i < (size_t) n; i++) {
      double position, weight;
      qn_pair_rule_place (&rule, 1, i, &position, &weight);
      g_assert_cmpfloat_with_epsilon (weight, n == 3 ? three[i] : four[i], 1e-15);
    }
  }
}

/* Exact up to degree 2n - 1, and not beyond. */
static void
test_gauss (void)
{
  for (int n = 1; n <= 12; n++) {
    QnPairRule rule = { .placement = QN_PLACEMENT_GAUSS, .count = n };
    for (int power = 0; power <= 2 * n; power++) {
      double exact = power % 2 == 1 ? 0 : 2 * pow (0.5, power + 1) / (power + 1);
      double error = fabs (moment (&rule, power) - exact);
      if (power < 2 * n)
        g_assert_cmpfloat (error, <=, 1e-15);
      else if (n <= 6)
        g_assert_cmpfloat (error, >=, 1e-9);
    }
  }
}

/* Both ends, ascending, symmetric; exact up to degree 2n - 3, and not beyond. Two points are the ends
 * of the other rule, to the bit. */
static void
test_lobatto (void)
{
  for (int n = 2; n <= 9; n++) {
    QnPairRule rule = { .placement = QN_PLACEMENT_LOBATTO, .count = n };
    double before = -1, position, mirrored, weight, same;
    for (size_t i = 0; i < (size_t) n; i++) {
      qn_pair_rule_place (&rule, 3, i, &position, &weight);
      qn_pair_rule_place (&rule, 3, (size_t) n - 1 - i, &mirrored, &same);
      g_assert_cmpfloat (position, >, before);
      g_assert_cmpfloat_with_epsilon (position, 1 - mirrored, 1e-15);
      g_assert_cmpfloat (weight, ==, same);
      before = position;
    }
    g_assert_cmpfloat (before, ==, 1);
    for (int power = 0; power <= 2 * n - 2; power++) {
      double exact = power % 2 == 1 ? 0 : 2 * pow (0.5, power + 1) / (power + 1);
      double error = fabs (moment (&rule, power) - exact);
      if (power < 2 * n - 2)
        g_assert_cmpfloat (error, <=, 1e-15);
      else if (n <= 6)
        g_assert_cmpfloat (error, >=, 1e-9);
    }
    g_assert_cmpfloat_with_epsilon (qn_pair_rule_bending (&rule, 3), n > 2 ? 1 : 3,
                                    1e-13);
    rule.offset = 0.3;
    g_assert_cmpfloat_with_epsilon (qn_pair_rule_bending (&rule, 3), n > 2 ? 0.64 : 1.92,
                                    1e-13);
    qn_pair_rule_place (&rule, 3, 0, &position, &weight);
    g_assert_cmpfloat (position, ==, 0.3 / 3);
  }
}

/* The largest ratio of the moment that pairs and a stress block carry, by all normal forces. */
static double
crushing_scanned (const QnPairRule *rule)
{
  double most = 0;
  for (int k = 1; k < 100000; k++) {
    double force = k / 100000., left = force, carried = 0;
    for (size_t i = 0; left > 0; i++) {
      double position, weight;
      qn_pair_rule_place (rule, 1, i, &position, &weight);
      double taken = MIN (left, weight);
      carried += taken * (1 - 2 * position);
      left -= taken;
    }
    most = MAX (most, carried / (force * (1 - force)));
  }
  return most;
}

/* Two end pairs carry twice the moment of half the section; the more of Lobatto's points, the less
 * too much. By law: five of them, nine where it can be crushed, the ends in N/m. */
static void
test_crushing (void)
{
  static const double lobatto[] = { 1.2, 1.091, 1.053, 1.035, 1.025, 1.018, 1.015 };
  QnPairRule rule = { .placement = QN_PLACEMENT_ENDS };
  g_assert_cmpfloat_with_epsilon (qn_pair_rule_crushing (&rule, 1, false), 2, 1e-14);
  for (int n = 3; n <= 9; n++) {
    rule = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = n };
    double most = qn_pair_rule_crushing (&rule, 1, false);
    g_test_message ("%d pairs: %.5f", n, most);
    g_assert_cmpfloat_with_epsilon (most, crushing_scanned (&rule), 1e-4);
    g_assert_cmpfloat_with_epsilon (most, lobatto[n - 3], 1e-3);
  }
  /* Equal strengths, whatever the weights: a third at the end. */
  rule.count = 3;
  g_assert_cmpfloat_with_epsilon (qn_pair_rule_crushing (&rule, 1, true), 1.5, 1e-14);
}

static void
test_by_law (void)
{
  static const struct {
    QnLawKind kind;
    QnBasis basis;
    int count;
  } laws[] = {
    { QN_LAW_COULOMB, QN_BASIS_CONTACT, 2 },
    { QN_LAW_COULOMB, QN_BASIS_SURFACE, 5 },
    { QN_LAW_ELASTIC, QN_BASIS_MATERIAL, 5 },
    { QN_LAW_NO_TENSION, QN_BASIS_SURFACE, 5 },
    { QN_LAW_MOHR_COULOMB, QN_BASIS_CONTACT, 2 },
    { QN_LAW_MOHR_COULOMB, QN_BASIS_SURFACE, 9 },
    { QN_LAW_CONCRETE, QN_BASIS_MATERIAL, 9 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (laws); i++) {
    const QnLaw law = { .kind = laws[i].kind, .basis = laws[i].basis };
    QnPairRule rule = qn_pair_rule_by_law (&(QnPairRule){ .offset = 0.1 }, &law);
    double position, weight;
    g_assert_cmpuint (qn_pair_rule_count (&rule), ==, laws[i].count);
    qn_pair_rule_place (&rule, 1, 0, &position, &weight);
    g_assert_cmpfloat (position, ==, 0.1);
    rule = qn_pair_rule_by_law (
      &(QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 7 }, &law);
    g_assert_cmpuint (qn_pair_rule_count (&rule), ==, 7);
    rule = qn_pair_rule_by_law (&(QnPairRule){ .placement = QN_PLACEMENT_ENDS }, &law);
    g_assert_cmpuint (qn_pair_rule_count (&rule), ==, 2);
  }
}

/* Known abscissae, ascending and symmetric. */
static void
test_legendre (void)
{
  double x, w;
  qn_gauss_legendre (2, 1, &x, &w);
  g_assert_cmpfloat_with_epsilon (x, 1 / sqrt (3), 1e-15);
  g_assert_cmpfloat_with_epsilon (w, 1, 1e-14);
  qn_gauss_legendre (3, 1, &x, &w);
  g_assert_cmpfloat (x, ==, 0);
  g_assert_cmpfloat_with_epsilon (w, 8. / 9, 1e-14);
  qn_gauss_legendre (3, 0, &x, &w);
  g_assert_cmpfloat_with_epsilon (x, -sqrt (0.6), 1e-15);

  for (size_t n = 1; n <= 1000; n += 111) {
    double before = -1, sum = 0;
    for (size_t i = 0; i < n; i++) {
      double mirrored, same;
      qn_gauss_legendre (n, i, &x, &w);
      qn_gauss_legendre (n, n - 1 - i, &mirrored, &same);
      g_assert_cmpfloat (x, >, before);
      g_assert_cmpfloat_with_epsilon (x, -mirrored, 1e-15);
      before = x;
      sum += w;
    }
    g_assert_cmpfloat (before, <, 1);
    g_assert_cmpfloat_with_epsilon (sum, 2, 1e-11);
  }
}

static void
test_explicit (void)
{
  QnPairRule rule = { .placement = QN_PLACEMENT_EXPLICIT,
                      .count = 3,
                      .positions = { 0, 0.5, 1 },
                      .weights = { 1. / 6, 4. / 6, 1. / 6 } };
  g_assert_cmpuint (qn_pair_rule_count (&rule), ==, 3);
  g_assert_cmpfloat_with_epsilon (moment (&rule, 2) * 12, 1, 1e-15); /* Simpson */
}

QN_TESTS
{
  g_test_add_func ("/pair-abscissae/ends", test_ends);
  g_test_add_func ("/pair-abscissae/uniform", test_uniform);
  g_test_add_func ("/pair-abscissae/maclaurin", test_maclaurin);
  g_test_add_func ("/pair-abscissae/gauss", test_gauss);
  g_test_add_func ("/pair-abscissae/lobatto", test_lobatto);
  g_test_add_func ("/pair-abscissae/crushing", test_crushing);
  g_test_add_func ("/pair-abscissae/by-law", test_by_law);
  g_test_add_func ("/pair-abscissae/legendre", test_legendre);
  g_test_add_func ("/pair-abscissae/explicit", test_explicit);
}
