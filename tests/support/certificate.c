#include "support/certificate.h"

#include "support/pair-sums.h"

#include <glib.h>
#include <math.h>

/* What a pair carries: |t| <= cohesion - friction n and n <= cap, N. */
typedef struct Strength {
  double friction, cohesion, cap;
} Strength;

static Strength
pair_strength (const QnModel *model, const QnContacts *contacts, size_t pair)
{
  QnId id = qn_contacts_pair_law (model, contacts, (QnId) pair, 0);
  const QnLaw *law = &model->laws[id];
  const QnContactPair *p = &contacts->pairs[pair];
  double unit = law->basis == QN_BASIS_CONTACT
                  ? 1
                  : p->tributary * contacts->faces[p->face].thickness;
  double cap = law->tension * unit;

  g_assert_cmpint (qn_contacts_pair_law (model, contacts, (QnId) pair, 1), ==, id);
  if (law->kind != QN_LAW_COULOMB)
    return (Strength){ 0, INFINITY, law->kind == QN_LAW_NO_TENSION ? 0 : INFINITY };
  if (law->friction > 0)
    cap = fmin (cap, law->cohesion / law->friction * unit);
  return (Strength){ law->friction, law->cohesion * unit, cap };
}

/* Sum of forces and moments about the centroid of every free block, N and N m. */
static double
imbalance (const QnModel *model, const QnContacts *contacts, const double *forces,
           double multiplier)
{
  size_t count = model->block_count * QN_DOF_COUNT;
  double *sum = g_new0 (double, count), *live = g_new0 (double, count), worst = 0;

  qn_model_set_forces (model, NULL, sum);
  qn_model_live_forces (model, live);
  for (size_t i = 0; i < count; i++)
    sum[i] += multiplier * live[i];
  test_add_pair_forces (model, contacts, forces, sum);
  for (size_t i = 0; i < count; i++)
    if (!model->blocks[i / QN_DOF_COUNT].support[i % QN_DOF_COUNT])
      worst = fmax (worst, fabs (sum[i]));
  g_free (sum);
  g_free (live);
  return worst;
}

/* Largest excess of a pair's force over its strength, N. */
static double
excess (const QnModel *model, const QnContacts *contacts, const double *forces)
{
  double worst = 0;

  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength s = pair_strength (model, contacts, p);
    double n = forces[2 * p], t = forces[2 * p + 1];
    worst = fmax (worst, fmax (fabs (t) + s.friction * n - s.cohesion, n - s.cap));
  }
  return worst;
}

/* Dissipation of a pair, N m/s: the most that a force within its strength does along `rate`, and
 * that is at the end of the cut-off. *violation grows to what the flow rule forbids, and what
 * no strength would resist. */
static double
dissipate (const Strength *s, QnVec2 rate, double *violation)
{
  double slip = fabs (rate.y), across = isinf (s->cohesion) ? slip : 0;

  *violation = fmax (*violation, s->friction * slip - rate.x);
  *violation = fmax (*violation, isinf (s->cap) ? hypot (rate.x, slip) : across);
  return isinf (s->cohesion)
           ? 0
           : s->cap * rate.x + (s->cohesion - s->friction * s->cap) * slip;
}

void
test_assert_certified (const QnModel *model, const QnContacts *contacts,
                       const QnLimitSolution *solution)
{
  size_t count = model->block_count * QN_DOF_COUNT;
  double *dead = g_new0 (double, count), *live = g_new0 (double, count);
  double dissipation = 0, power = 0, violation = 0, fastest = 0, weight = 0;
  const double *v = solution->velocities;

  qn_model_set_forces (model, NULL, dead);
  qn_model_live_forces (model, live);
  for (size_t i = 0; i < count; i++) {
    bool fixed = model->blocks[i / QN_DOF_COUNT].support[i % QN_DOF_COUNT];
    if (fixed)
      g_assert_cmpfloat (v[i], ==, 0);
    else
      weight = fmax (weight, fmax (fabs (dead[i]), fabs (live[i])));
    dissipation -= dead[i] * v[i];
    power += live[i] * v[i];
    fastest = fmax (fastest, fabs (v[i]));
  }
  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength strength = pair_strength (model, contacts, p);
    dissipation +=
      dissipate (&strength, test_pair_rate (model, contacts, p, v), &violation);
  }
  g_free (dead);
  g_free (live);
  g_assert_cmpfloat (imbalance (model, contacts, solution->forces, solution->lower_bound),
                     <, 1e-8 * weight);
  g_assert_cmpfloat (excess (model, contacts, solution->forces), <=, 1e-9 * weight);
  g_assert_cmpfloat (violation, <, 1e-6 * fastest);
  g_assert_cmpfloat (power, >, 0);
  g_assert_cmpfloat_with_epsilon (dissipation / power, solution->upper_bound, 1e-6);
  g_assert_cmpfloat (solution->upper_bound - solution->lower_bound, <, 1e-6);
}
