/* From a plan through the database to statistics: a function with known answers in place of an
 * analysis. */
#include "study/report/table.h"

#include "study/cases/folder.h"
#include "study/fixture.h"
#include "study/plan/sample.h"
#include "study/report/figures.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

typedef double (*Function) (const double *values);
typedef struct Bench {
  char *folder;
  QnStudy study;
  QnTable table;
} Bench;

/* Reads a study, stores what the function gives for every case, and reads the table. */
static void
fill (Bench *bench, const char *text, Function function)
{
  g_autoptr (GError) error = NULL;
  bench->folder = test_scratch_new ();
  fixture_read (bench->folder, text, &bench->study, &error);
  g_assert_no_error (error);
  g_autofree char *path = qn_folder_dup_database (bench->folder, (QnShard){ 0, 1 });
  QnStore *store = qn_store_open (path, &bench->study, TRUE, &error);
  g_assert_no_error (error);
  g_autofree double *sample = qn_sample_dup (&bench->study);
  for (gsize i = 0; i < qn_study_case_count (&bench->study); i++) {
    const double *values = sample + i * bench->study.parameters->len;
    g_auto (QnCaseResult) result;
    qn_case_result_fail (&result, NULL);
    result.failed = FALSE;
    result.outcome = g_strdup ("collapse");
    result.mechanism = g_strdup (i % 4 == 0 ? "sliding" : "rocking");
    result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER] = function (values);
    g_assert_true (qn_store_add (store, i, values, &result, &error));
  }
  g_assert_true (qn_store_commit (store, &error));
  qn_store_close (store);
  g_assert_true (qn_table_read (&bench->table, &bench->study, bench->folder, &error));
}

static void
clear (Bench *bench)
{
  qn_table_clear (&bench->table);
  qn_study_clear (&bench->study);
  test_scratch_free (bench->folder);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Bench, clear)

static double
ishigami (const double *x)
{
  return sin (x[0]) + 7 * pow (sin (x[1]), 2) + 0.1 * pow (x[2], 4) * sin (x[0]);
}

/* Ishigami and Homma 1990, with a = 7, b = 0.1: first order 0.3139, 0.4424, 0, total 0.5576,
 * 0.4424, 0.2437 (closed forms). */
static void
test_ishigami (void)
{
  static const double first[] = { 0.3139052, 0.4424111, 0 };
  static const double total[] = { 0.5575889, 0.4424111, 0.2436837 };
  static const char *const paths[] = { "loads.live[0].direction[0]",
                                       "loads.live[0].direction[1]",
                                       "loads.dead[0].direction[0]" };
  g_auto (Bench) bench;
  QnSobolIndex indices[3];
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text,
                   "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": "
                   "\"%s/01-sliding-block.quoin\", \"run\": \"solve\", \"parameters\": [",
                   g_getenv ("QUOIN_EXAMPLES"));
  for (int i = 0; i < 3; i++)
    g_string_append_printf (text,
                            "%s{ \"name\": \"x%d\", \"path\": \"%s\", \"distribution\": "
                            "{ \"kind\": \"uniform\", \"min\": -3.141592653589793, "
                            "\"max\": 3.141592653589793 } }",
                            i > 0 ? ", " : "", i, paths[i]);
  g_string_append (text, "], \"plan\": { \"kind\": \"sobol\", \"count\": 4096 }, "
                         "\"outputs\": [\"collapse_multiplier\"] }");
  fill (&bench, text->str, ishigami);
  g_assert_true (qn_table_sobol (&bench.table, 3, indices));
  for (int i = 0; i < 3; i++) {
    g_test_message ("x%d: first %.4f, total %.4f", i, indices[i].first, indices[i].total);
    g_assert_cmpfloat_with_epsilon (indices[i].first, first[i], 0.01);
    g_assert_cmpfloat_with_epsilon (indices[i].total, total[i], 0.01);
    g_assert_cmpfloat (indices[i].of_first.low, <=, first[i]);
    g_assert_cmpfloat (indices[i].of_first.high, >=, first[i]);
    g_assert_cmpfloat (indices[i].of_total.low, <=, total[i]);
    g_assert_cmpfloat (indices[i].of_total.high, >=, total[i]);
  }
  /* The independent points alone are a sample: two of each block of five. */
  gsize count;
  g_autofree double *sorted = qn_table_dup_sorted (&bench.table, 3, &count);
  g_assert_cmpuint (count, ==, 2 * 4096);
  QnMoments moments = qn_moments (sorted, count);
  g_assert_cmpfloat_with_epsilon (moments.mean, 3.5, 0.03);
  g_assert_cmpfloat_with_epsilon (moments.deviation * moments.deviation, 13.844588, 0.2);
}

static double
product (const double *x)
{
  return x[0] * x[1] / 10000;
}

static void
test_effects (void)
{
  g_auto (Bench) bench;
  double base;
  QnInterval effect;
  g_autofree char *text = fixture_study_text ("{ \"kind\": \"one-at-a-time\" }", "");
  fill (&bench, text, product);
  const double *own = bench.table.numbers; /* the project's own values */
  g_assert_true (qn_table_effect (&bench.table, 0, 2, &base, &effect));
  g_assert_cmpfloat_with_epsilon (base, own[0] * own[1] / 10000, 1e-12);
  g_assert_cmpfloat_with_epsilon (effect.low, fmin (0.3 * own[1] / 10000, base), 1e-12);
  g_assert_cmpfloat_with_epsilon (effect.high, fmax (0.7 * own[1] / 10000, base), 1e-12);
  g_assert_false (qn_table_is_sample (&bench.table));

  /* The line of the project as it is passes half a place beyond the first and the last of two bars. */
  const QnStudyFigure figure = { .kind = QN_STUDY_FIGURE_TORNADO, .column = 2 };
  g_autoptr (QnPlot) plot = qn_study_figure_plot (&figure, &bench.table, NULL);
  const QnMarks *line = &g_array_index (plot->marks, QnMarks, plot->marks->len - 1);
  g_assert_cmpint (line->kind, ==, QN_MARKS_LINE);
  g_assert_cmpuint (line->count, ==, 2);
  for (int i = 0; i < 2; i++) {
    g_assert_cmpfloat (line->x[i], ==, base);
    g_assert_cmpfloat (line->y[i], ==, i == 0 ? -0.5 : 1.5);
  }
}

static void
test_mechanisms_and_summary (void)
{
  g_auto (Bench) bench;
  gsize whole;
  g_autofree char *text =
    fixture_study_text ("{ \"kind\": \"monte-carlo\", \"count\": 40 }", "");
  fill (&bench, text, product);
  g_autoptr (GArray) shares = qn_table_dup_mechanisms (&bench.table, &whole);
  g_assert_cmpuint (whole, ==, 40);
  g_assert_cmpuint (shares->len, ==, 2);
  const QnMechanismShare *first = &g_array_index (shares, QnMechanismShare, 0);
  g_assert_cmpstr (first->kind, ==, "rocking");
  g_assert_cmpuint (first->count, ==, 30);
  g_assert_cmpfloat (first->range.low, <, first->range.high);
  double typical = qn_table_number (&bench.table, first->row, 2);
  g_assert_true (typical >= first->range.low && typical <= first->range.high);

  g_autofree char *summary = qn_summary_dup_text (&bench.table);
  static const char *const parts[] = {
    "Sliding\n40 of 40 cases are computed, 0 failed",
    "Collapse multiplier λ (collapse_multiplier): 40 values",
    "fragility",
    "rank correlation",
    "rocking",
    "75.00 %"
  };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++)
    if (strstr (summary, parts[i]) == NULL)
      g_test_fail_printf ("'%s' lacks '%s'", summary, parts[i]);
}

QN_TESTS
{
  g_test_add_func ("/study/column/ishigami", test_ishigami);
  g_test_add_func ("/study/column/effects", test_effects);
  g_test_add_func ("/study/column/mechanisms-and-summary", test_mechanisms_and_summary);
}
