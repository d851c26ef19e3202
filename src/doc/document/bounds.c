#include "doc/document/bounds.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Relative distance below which two multipliers are called equal. */
#define ALIKE 0.01

/* Multipliers of a path and of limit analysis that differ by less than this part count as one. */
#define RESOLVED 1e-4

static const struct {
  const char *label, *guarantee;
} words[QN_BOUND_KIND_COUNT] = {
  [QN_BOUND_PATH] = { N_ ("HybriDFEM, collapse multiplier of the path"),
                      N_ ("Equilibria were followed up to here. With dilatancy below "
                          "friction the answer is not unique: another path may end "
                          "elsewhere.") },
  [QN_BOUND_FIRST_LIMIT] = { N_ ("HybriDFEM, first limit point"),
                             N_ ("Here the path first jumps to another equilibrium.") },
  [QN_BOUND_LOWER] = { N_ ("Limit analysis, lower bound (static)"),
                       N_ ("Forces within the strength of every joint balance the load "
                           "up to here. With dilatancy = friction the structure stands; "
                           "with less it may have failed before.") },
  [QN_BOUND_UPPER] = { N_ ("Limit analysis, upper bound (kinematic)"),
                       N_ (
                         "A mechanism proves that no equilibrium of rigid blocks exists "
                         "above, whatever the dilatancy.") },
  [QN_BOUND_LEAST] = { N_ ("Limit analysis with the laws' dilatancy, least value found"),
                       N_ ("Forces and mechanism are consistent here. It is no bound: a "
                           "path may end below.") },
  [QN_BOUND_GREATEST] = { N_ ("Limit analysis with the laws' dilatancy, greatest value "
                              "found"),
                          N_ ("Forces and mechanism are consistent here too. Never above "
                              "the associative upper bound.") },
};

static void
take (double *values, const QnRun *run)
{
  const QnResult *result = &run->result;
  const QnAnalysisSettings *settings = &run->model.analysis;
  if (settings->procedure == QN_PROCEDURE_DYNAMIC)
    return; /* it has no multiplier */
  if (settings->procedure != QN_PROCEDURE_LIMIT) {
    values[QN_BOUND_PATH] =
      result->has_collapse_multiplier ? result->collapse_multiplier : NAN;
    gboolean apart =
      qn_result_has_felt_limit (result) && result->has_collapse_multiplier
      && fabs (result->first_limit_multiplier - result->collapse_multiplier)
           > 1e-3 * fabs (result->collapse_multiplier);
    values[QN_BOUND_FIRST_LIMIT] = apart ? result->first_limit_multiplier : NAN;
    if (result->has_associative_bound)
      values[QN_BOUND_UPPER] = result->associative_bound;
  } else if (settings->flow == QN_FLOW_ASSOCIATIVE) {
    values[QN_BOUND_LOWER] = values[QN_BOUND_UPPER] = NAN;
    if (result->outcome == QN_OUTCOME_UNBOUNDED)
      values[QN_BOUND_LOWER] = INFINITY;
    else if (result->limit.given) {
      values[QN_BOUND_LOWER] = result->limit.lower_bound;
      values[QN_BOUND_UPPER] = result->limit.upper_bound;
    }
  } else {
    values[QN_BOUND_LEAST] = values[QN_BOUND_GREATEST] = NAN;
    if (result->limit.given) {
      values[QN_BOUND_LEAST] = result->limit.lower_bound;
      values[QN_BOUND_GREATEST] = result->limit.upper_bound;
    }
  }
}

guint
qn_bounds_collect (QnDocument *document, double values[QN_BOUND_KIND_COUNT])
{
  guint count = 0;
  for (int i = 0; i < QN_BOUND_KIND_COUNT; i++)
    values[i] = NAN;
  const GPtrArray *runs = document->runs;
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = g_ptr_array_index (runs, i);
    if (run->kind == QN_RUN_ANALYSIS && !qn_document_is_stale (document, run))
      take (values, run);
  }
  for (int i = 0; i < QN_BOUND_KIND_COUNT; i++)
    count += !isnan (values[i]);
  return count;
}

char *
qn_bounds_dup_text (const double values[QN_BOUND_KIND_COUNT])
{
  GString *text = g_string_new (NULL);
  for (int i = 0; i < QN_BOUND_KIND_COUNT; i++)
    if (isinf (values[i]))
      g_string_append_printf (text, "%s: ∞. %s\n\n", _ (words[i].label),
                              _ (words[i].guarantee));
    else if (!isnan (values[i]))
      g_string_append_printf (text, "%s: %.4f. %s\n\n", _ (words[i].label), values[i],
                              _ (words[i].guarantee));
  return g_string_free (text, FALSE);
}

/* Where the path ends beside what limit analysis finds with the laws' own dilatancy. */
static char *
place_in_interval (double path, double least, double greatest)
{
  if (path < least * (1.0 - RESOLVED))
    return g_strdup_printf (_ ("It is %.1f %% below the least value found with the laws' "
                               "own dilatancy."),
                            100.0 * (least - path) / fabs (least));
  if (path > greatest * (1.0 + RESOLVED))
    return g_strdup_printf (_ ("It is %.1f %% above the greatest value found with the "
                               "laws' own dilatancy."),
                            100.0 * (path - greatest) / fabs (greatest));
  return g_strdup (_ ("It lies within the interval of the laws' own dilatancy."));
}

/* A path below the associative bound, `share` of it. */
static char *
compare_to_bound (double path, double least, double greatest, double share)
{
  if (share <= ALIKE)
    return g_strdup (_ ("The path reaches the bound of limit analysis to 1 %."));
  if (!isnan (least)) {
    g_autofree char *place = place_in_interval (path, least, greatest);
    return g_strdup_printf (_ ("The path ends %.1f %% below the associative bound. %s"),
                            100.0 * share, place);
  }
  return g_strdup_printf (_ ("The path ends %.1f %% below the associative bound. "
                             "Dilatancy below friction can be the cause."),
                          100.0 * share);
}

char *
qn_bounds_dup_verdict (const double values[QN_BOUND_KIND_COUNT])
{
  const double path = values[QN_BOUND_PATH], upper = values[QN_BOUND_UPPER],
               least = values[QN_BOUND_LEAST];
  if (isnan (path) || isnan (upper))
    return NULL;
  double share = (upper - path) / fabs (upper);
  if (share < -ALIKE)
    return g_strdup_printf (
      _ ("The path ends %.1f %% above the upper bound of rigid blocks: its joints or "
         "displacements are not those of limit analysis, or its increments are too "
         "large."),
      -100.0 * share);
  g_autofree char *relation =
    compare_to_bound (path, least, values[QN_BOUND_GREATEST], share);
  return g_strdup_printf (
    _ ("%s To be used: %.4f, the least that was found with the laws "
       "as they are."),
    relation, fmin (upper, fmin (path, least))); /* without NaN */
}
