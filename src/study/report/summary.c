#include "io/text/outcome-text.h"
#include "io/text/text-format.h"
#include "study/report/table.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static void
append_interval (GString *text, QnInterval interval)
{
  qn_text_append (text, " (%.6g … %.6g)\n", interval.low, interval.high);
}

static void
append_sample (GString *text, const double *sorted, gsize count)
{
  static const double shares[] = { 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99 };
  QnMoments moments = qn_moments (sorted, count);
  qn_text_append (text, "  %-12s %10.6g", _ ("mean"), moments.mean);
  append_interval (text, moments.of_mean);
  qn_text_append (text, "  %-12s %10.6g\n", _ ("deviation"), moments.deviation);
  qn_text_append (text, "  %-12s %10.6g … %.6g\n", _ ("range"), sorted[0],
                  sorted[count - 1]);
  for (gsize i = 0; i < G_N_ELEMENTS (shares); i++) {
    g_autofree char *name = g_strdup_printf (_ ("%.0f %% quantile"), 100 * shares[i]);
    qn_text_append (text, "  %-12s %10.6g", name, qn_quantile (sorted, count, shares[i]));
    append_interval (text, qn_quantile_interval (sorted, count, shares[i]));
  }
}

/* Share of the cases that do not reach a multiplier, at ten round ones. */
/* Where nearly all values are one, lines that the printed digits distinguish. */
static void
append_fragility (GString *text, const char *share, const double *sorted, gsize count)
{
  double low = sorted[0], high = sorted[count - 1];
  double least = fmax (5e-5 * fmax (fabs (low), fabs (high)), 1e-300);
  double step = pow (10, floor (log10 (fmax (high - low, least) / 5)));
  while ((high - low) / step > 12)
    step *= 2;
  if (!(high > low))
    return;
  qn_text_append (text, _ ("  %s at a multiplier (fragility)\n"), share);
  for (double x = ceil (low / step) * step; x < high + step; x += step) {
    gsize part = qn_count_up_to (sorted, count, x);
    QnInterval interval = qn_share_interval (part, count);
    qn_text_append (text, "    %10.6g %8.2f %% (%.2f … %.2f)\n", x,
                    100.0 * (double) part / (double) count, 100 * interval.low,
                    100 * interval.high);
  }
}

/* The least of all at every combination, and of these the worst. One whose dead load does not stand is
 * worse than any with a value. */
static void
append_combinations (GString *text, const QnTable *table, gsize column)
{
  const gsize parameter = table->parameters - 1;
  const guint count = table->study->combinations->len;
  g_autofree double *least = g_new (double, count);
  g_autofree const QnRow **rows = g_new0 (const QnRow *, count);
  gsize worst = 0;
  for (guint i = 0; i < count; i++)
    least[i] = INFINITY;
  for (gsize i = 0; i < table->rows->len; i++) {
    const QnRow *row = &g_array_index (table->rows, QnRow, i);
    gsize at = (gsize) qn_table_number (table, i, parameter) - 1;
    double value = qn_table_number (table, i, column);
    value = row->failed || g_strcmp0 (row->outcome, "dead-load-unstable") == 0 ? -INFINITY
            : isnan (value)                                                    ? INFINITY
                                                                               : value;
    if (rows[at] == NULL || value < least[at]) {
      least[at] = value;
      rows[at] = row;
    }
    worst = least[at] < least[worst] ? at : worst;
  }
  for (guint i = 0; i < count; i++) {
    const char *name = qn_study_combination (table->study, parameter, i + 1)->label;
    char number[32] = "–";
    if (isfinite (least[i]))
      g_snprintf (number, sizeof number, "%.6g", least[i]);
    qn_text_append (text, "  %4u  %10s  %s%s%s\n", i + 1,
                    rows[i] == NULL || isfinite (least[i]) ? number
                    : rows[i]->failed                      ? _ ("No answer")
                                      : qn_study_word (rows[i]->outcome),
                    name, i == worst && least[i] < INFINITY ? "  " : "",
                    i == worst && least[i] < INFINITY ? _ ("← least") : "");
  }
}

/* The parameters of the case with the least misfit: what fits best among those computed. */
static void
append_fit (GString *text, const QnTable *table, gsize column)
{
  const gsize count = table->rows->len;
  gsize best = count;
  for (gsize i = 0; i < count; i++) {
    double misfit = qn_table_number (table, i, column);
    if (!isnan (misfit)
        && (best == count || misfit < qn_table_number (table, best, column)))
      best = i;
  }
  if (best == count)
    return;
  qn_text_append (text, _ ("  least in case %zu\n"),
                  g_array_index (table->rows, QnRow, best).index + 1);
  for (gsize p = 0; p < table->parameters; p++)
    qn_text_append (text, "    %-24s %10.6g\n", qn_table_column_name (table, p),
                    qn_table_number (table, best, p));
}

static void
append_output (GString *text, const QnTable *table, gsize column)
{
  gsize count;
  g_autofree double *sorted = qn_table_dup_sorted (table, column, &count);
  g_autofree char *name =
    g_strdup_printf ("%s (%s)", qn_table_column_text (table, column),
                     qn_table_column_name (table, column));
  qn_text_append (
    text, g_dngettext (GETTEXT_PACKAGE, "%s: %zu value\n", "%s: %zu values\n", count),
    name, count);
  if (table->study->combinations != NULL
      && qn_table_fragility_text (table, column) != NULL)
    append_combinations (text, table, column);
  if (count == 0)
    return;
  if (strcmp (qn_table_column_name (table, column),
              qn_study_output_names[QN_STUDY_CRACK_MISFIT])
      == 0)
    append_fit (text, table, column);
  if (!qn_table_is_sample (table)) {
    qn_text_append (text, "  %-12s %10.6g … %.6g\n", _ ("range"), sorted[0],
                    sorted[count - 1]);
    double base = NAN;
    QnInterval effect;
    for (gsize k = 0; k < table->parameters; k++) {
      if (!qn_table_effect (table, k, column, &base, &effect))
        continue;
      if (k == 0)
        qn_text_append (text, _ ("  %.6g as the project is; range by parameter\n"), base);
      qn_text_append (text, "    %-24s %10.6g … %.6g\n", qn_table_column_name (table, k),
                      effect.low, effect.high);
    }
    return;
  }
  append_sample (text, sorted, count);
  const char *share = qn_table_fragility_text (table, column);
  if (share != NULL)
    append_fragility (text, share, sorted, count);
  g_string_append (text, _ ("  rank correlation with\n"));
  for (gsize k = 0; k < table->parameters; k++) {
    g_autofree double *x = NULL, *y = NULL;
    gsize pairs = qn_table_dup_pairs (table, k, column, &x, &y);
    double r = qn_rank_correlation (x, y, pairs);
    if (!isnan (r))
      qn_text_append (text, "    %-24s %8.3f\n", qn_table_column_name (table, k), r);
  }
  g_autofree QnSobolIndex *indices = g_new (QnSobolIndex, table->parameters);
  if (!qn_table_sobol (table, column, indices))
    return;
  g_string_append (text, _ ("  Sobol indices: first order, total\n"));
  for (gsize k = 0; k < table->parameters; k++)
    qn_text_append (text, "    %-24s %8.3f (%.3f … %.3f) %8.3f (%.3f … %.3f)\n",
                    qn_table_column_name (table, k), indices[k].first,
                    indices[k].of_first.low, indices[k].of_first.high, indices[k].total,
                    indices[k].of_total.low, indices[k].of_total.high);
}

static void
append_mechanisms (GString *text, const QnTable *table)
{
  gsize whole;
  g_autoptr (GArray) shares = qn_table_dup_mechanisms (table, &whole);
  qn_text_append (text, "%s\n", _ ("Mechanisms"));
  for (guint i = 0; i < shares->len; i++) {
    const QnMechanismShare *share = &g_array_index (shares, QnMechanismShare, i);
    g_autofree char *name = qn_mechanism_share_dup_name (share);
    qn_text_append (text, "  %-22s %6zu  %6.2f %%", name, share->count,
                    100.0 * (double) share->count / (double) whole);
    if (!isnan (share->range.low))
      qn_text_append (text, "  %s %.6g … %.6g",
                      qn_table_column_text (table, (gsize) share->column),
                      share->range.low, share->range.high);
    g_string_append_c (text, '\n');
  }
}

char *
qn_summary_dup_text (const QnTable *table)
{
  GString *text = g_string_new (NULL);
  gsize failed = 0;
  guint counts[QN_OUTCOME_COUNT] = { 0 };
  const char *const title = table->study->title;
  for (gsize i = 0; i < table->rows->len; i++) {
    const QnRow *row = &g_array_index (table->rows, QnRow, i);
    failed += row->failed;
    for (int o = 0; o < QN_OUTCOME_COUNT; o++)
      counts[o] += g_strcmp0 (row->outcome, qn_outcome_names[o]) == 0;
  }
  qn_text_append (text, "%s\n", title != NULL ? title : table->study->name);
  qn_text_append (text, _ ("%u of %zu cases are computed, %zu failed\n"),
                  table->rows->len, qn_study_case_count (table->study), failed);
  for (int o = 0; o < QN_OUTCOME_COUNT; o++)
    if (counts[o] > 0)
      qn_text_append (text, "  %6u  %s\n", counts[o],
                      qn_outcome_text ((QnOutcome) o, FALSE));
  gboolean mechanisms = FALSE;
  for (gsize i = table->parameters; i < table->width; i++) {
    if (qn_study_output_is_number (
          qn_study_output (table->study, i - table->parameters))) {
      g_string_append_c (text, '\n');
      append_output (text, table, i);
    } else if (!mechanisms) {
      g_string_append_c (text, '\n');
      append_mechanisms (text, table);
      mechanisms = TRUE;
    }
  }
  if (qn_table_is_sample (table))
    g_string_append (text, _ ("\nIn brackets: intervals that hold the true value with a "
                              "probability of 95 %.\n"));
  return g_string_free (text, FALSE);
}
