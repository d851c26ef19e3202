/* Plans: which points they have, and that they are the same everywhere. */
#include "core/base/integer.h"
#include "study/fixture.h"
#include "study/plan/sample.h"
#include "support/room.h"

#include <gsl/gsl_statistics.h>
#include <math.h>
#include <string.h>

typedef struct Sample {
  gsize count, width;
  double *values;
} Sample;

static void
sample_clear (Sample *sample)
{
  g_free (sample->values);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Sample, sample_clear)

static void
sample_of (Sample *sample, const char *plan, const char *more)
{
  g_auto (QnStudy) study;
  fixture_study (&study, plan, more);
  *sample = (Sample){ qn_study_case_count (&study), study.parameters->len,
                      qn_sample_dup (&study) };
}

static const double *
case_of (const Sample *sample, gsize index)
{
  return sample->values + index * sample->width;
}

static void
assert_case (const Sample *sample, gsize index, double friction, double weight)
{
  const double *values = case_of (sample, index);
  g_assert_cmpfloat_with_epsilon (values[0], friction, 1e-11);
  g_assert_cmpfloat_with_epsilon (values[1], weight, 1e-6);
}

static void
test_grid (void)
{
  g_auto (Sample) sample;
  sample_of (&sample, "{ \"kind\": \"grid\" }", "");
  g_assert_cmpuint (sample.count, ==, 9);
  assert_case (&sample, 0, 0.3, 10000);
  assert_case (&sample, 1, 0.3, 15000);
  assert_case (&sample, 3, 0.5, 10000);
  assert_case (&sample, 8, 0.7, 20000);
}

static void
test_one_at_a_time (void)
{
  g_auto (Sample) sample;
  sample_of (&sample, "{ \"kind\": \"one-at-a-time\" }", "");
  g_assert_cmpuint (sample.count, ==, 7);
  const double friction = case_of (&sample, 0)[0];
  const double weight = case_of (&sample, 0)[1];
  assert_case (&sample, 1, 0.3, weight);
  assert_case (&sample, 3, 0.7, weight);
  assert_case (&sample, 4, friction, 10000);
  assert_case (&sample, 6, friction, 20000);
}

/* Every layer of the interval 0.2 … 0.8 holds one point. */
static void
assert_layers (const Sample *sample)
{
  g_autofree guint8 *taken = g_new0 (guint8, sample->count);
  for (gsize i = 0; i < sample->count; i++) {
    double u = (case_of (sample, i)[0] - 0.2) / 0.6;
    gsize layer = (gsize) qn_to_integer (u * (double) sample->count, 0, G_MAXINT32);
    g_assert_cmpuint (layer, <, sample->count);
    g_assert_cmpuint (taken[layer]++, ==, 0);
  }
}

static double
rank_correlation (const Sample *sample)
{
  g_autofree double *work = g_new (double, 2 * sample->count);
  return gsl_stats_spearman (sample->values, 2, sample->values + 1, 2, sample->count,
                             work);
}

static void
test_layers (void)
{
  g_auto (Sample) sample;
  sample_of (&sample, "{ \"kind\": \"latin-hypercube\", \"count\": 500, \"seed\": 3 }",
             "");
  assert_layers (&sample);
  g_assert_cmpfloat (fabs (rank_correlation (&sample)), <, 0.15);
}

/* Of uniform marginals: the friction's, and the weight's three steps. */
static void
test_correlated (void)
{
  static const char *const plans[] = { "monte-carlo", "latin-hypercube" };
  for (gsize i = 0; i < G_N_ELEMENTS (plans); i++) {
    g_autofree char *plan =
      g_strdup_printf ("{ \"kind\": \"%s\", \"count\": 4000, \"seed\": 5 }", plans[i]);
    const double wanted[] = { 1, 0.6, 0.6, 1 };
    g_autofree double *points = g_new (double, 8000);
    gsl_rng *random = gsl_rng_alloc (gsl_rng_mt19937);
    g_autofree double *work = g_new (double, 8000);
    for (gsize k = 0; k < 8000; k++)
      points[k] = gsl_rng_uniform_pos (random);
    if (i == 0)
      qn_correlation_copula (wanted, 2, points, 4000);
    else
      qn_correlation_reorder (wanted, 2, points, 4000, random);
    g_assert_cmpfloat_with_epsilon (
      gsl_stats_spearman (points, 2, points + 1, 2, 4000, work), 0.6,
      i == 0 ? 0.03 : 0.005);
    gsl_rng_free (random);

    g_auto (Sample) sample;
    sample_of (&sample, plan, ", \"correlation\": [[\"friction\", \"weight\", 0.6]]");
    g_assert_cmpfloat_with_epsilon (rank_correlation (&sample), 0.57, 0.04);
    if (i == 1)
      assert_layers (&sample);
  }
}

static void
test_saltelli (void)
{
  g_auto (Sample) sample;
  sample_of (&sample, "{ \"kind\": \"sobol\", \"count\": 64, \"seed\": 1 }", "");
  g_assert_cmpuint (sample.count, ==, 64 * 4);
  for (gsize i = 0; i < 64; i++) {
    const double *a = case_of (&sample, 4 * i), *b = a + 2;
    g_assert_true (a[4] == b[0] && a[5] == a[1]); /* a with the friction of b */
    g_assert_true (a[6] == a[0] && a[7] == b[1]);
  }
}

/* The same seed gives these numbers on every machine; another seed gives others. */
static void
test_known_numbers (void)
{
  static const struct {
    const char *plan;
    double friction[3];
  } known[] = {
    { "monte-carlo", { 0.450213199062, 0.632194693573, 0.200068628648 } },
    { "latin-hypercube", { 0.349928038655, 0.361006691941, 0.74270667322 } },
    { "sobol", { 0.750213199062, 0.332194693573, 0.332194693573 } },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (known); i++) {
    g_auto (Sample) sample, other;
    g_autofree char *plan =
      g_strdup_printf ("{ \"kind\": \"%s\", \"count\": 8, \"seed\": 1 }", known[i].plan);
    g_autofree char *next =
      g_strdup_printf ("{ \"kind\": \"%s\", \"count\": 8, \"seed\": 2 }", known[i].plan);
    sample_of (&sample, plan, "");
    sample_of (&other, next, "");
    for (gsize k = 0; k < 3; k++) {
      g_assert_cmpfloat (case_of (&sample, k)[0], ==, known[i].friction[k]);
    }
    g_assert_true (
      memcmp (sample.values, other.values, sample.count * sample.width * sizeof (double))
      != 0);
  }
}

static void
test_whole (void)
{
  g_auto (QnStudy) study;
  fixture_study (&study, "{ \"kind\": \"monte-carlo\", \"count\": 50 }", "");
  QnParameter *parameter = &g_array_index (study.parameters, QnParameter, 0);
  parameter->whole = TRUE;
  parameter->distribution.max = 20.4;
  g_autofree double *values = qn_sample_dup (&study);
  for (gsize i = 0; i < qn_study_case_count (&study); i++)
    g_assert_cmpfloat (values[2 * i], ==, rint (values[2 * i]));
}

QN_TESTS
{
  g_test_add_func ("/study/sample/grid", test_grid);
  g_test_add_func ("/study/sample/one-at-a-time", test_one_at_a_time);
  g_test_add_func ("/study/sample/layers", test_layers);
  g_test_add_func ("/study/sample/correlated", test_correlated);
  g_test_add_func ("/study/sample/saltelli", test_saltelli);
  g_test_add_func ("/study/sample/known-numbers", test_known_numbers);
  g_test_add_func ("/study/sample/whole", test_whole);
}
