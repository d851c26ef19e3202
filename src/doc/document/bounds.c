#include "doc/document/bounds.h"

#include <glib/gi18n.h>
#include <math.h>

/* Relative distance below which two multipliers are called equal. */
#define ALIKE 0.01

enum { PATH, FIRST_LIMIT, LOWER, UPPER, LEAST, GREATEST, KINDS };

static const struct {
  const char *label, *guarantee;
} words[KINDS] = {
  [PATH] = { N_ ("HybriDFEM, last equilibrium of the path"),
             N_ ("Equilibria were followed up to here; beyond it the blocks keep "
                 "accelerating. With dilatancy below friction the answer is not unique: "
                 "another path may end elsewhere.") },
  [FIRST_LIMIT] = { N_ ("HybriDFEM, first limit point"),
                    N_ ("Here the path first loses stability: a real wall would jump to "
                        "another equilibrium, or fall.") },
  [LOWER] = { N_ ("Limit analysis, lower bound (static)"),
              N_ (
                "Forces within the strength of every joint balance the load up to here. "
                "With dilatancy = friction the structure stands; with less it may have "
                "failed before.") },
  [UPPER] = { N_ ("Limit analysis, upper bound (kinematic)"),
              N_ ("A mechanism proves that no equilibrium exists above, whatever the "
                  "dilatancy.") },
  [LEAST] = { N_ ("Limit analysis with the laws' dilatancy, least value found"),
              N_ ("Forces and mechanism are consistent here. It is no bound: a path may "
                  "end below.") },
  [GREATEST] = { N_ ("Limit analysis with the laws' dilatancy, greatest value found"),
                 N_ ("Forces and mechanism are consistent here too. Never above the "
                     "associative upper bound.") },
};

static void
take (double *values, const QnRun *run)
{
  const QnResult *result = &run->result;
  const QnAnalysisSettings *settings = &run->model.analysis;
  if (settings->procedure == QN_PROCEDURE_DYNAMIC)
    return; /* it has no multiplier */
  if (settings->procedure != QN_PROCEDURE_LIMIT) {
    values[PATH] = result->has_collapse_multiplier ? result->collapse_multiplier : NAN;
    gboolean apart =
      result->has_first_limit_multiplier && result->has_collapse_multiplier
      && fabs (result->first_limit_multiplier - result->collapse_multiplier)
           > 1e-3 * fabs (result->collapse_multiplier);
    values[FIRST_LIMIT] = apart ? result->first_limit_multiplier : NAN;
  } else if (settings->flow == QN_FLOW_ASSOCIATIVE) {
    values[LOWER] = values[UPPER] = NAN;
    if (result->outcome == QN_OUTCOME_UNBOUNDED)
      values[LOWER] = INFINITY;
    else if (result->limit.given) {
      values[LOWER] = result->limit.lower_bound;
      values[UPPER] = result->limit.upper_bound;
    }
  } else {
    values[LEAST] = values[GREATEST] = NAN;
    if (result->limit.given) {
      values[LEAST] = result->limit.lower_bound;
      values[GREATEST] = result->limit.upper_bound;
    }
  }
}

GArray *
qn_bounds_collect (QnDocument *document)
{
  double values[KINDS];
  for (int i = 0; i < KINDS; i++)
    values[i] = NAN;
  const GPtrArray *runs = qn_document_get_runs (document);
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = g_ptr_array_index (runs, i);
    if (run->kind == QN_RUN_ANALYSIS && !qn_document_is_stale (document, run))
      take (values, run);
  }
  GArray *bounds = g_array_new (FALSE, FALSE, sizeof (QnBound));
  for (int i = 0; i < KINDS; i++) {
    if (isnan (values[i]))
      continue;
    QnBound bound = { _ (words[i].label), values[i], _ (words[i].guarantee) };
    g_array_append_val (bounds, bound);
  }
  return bounds;
}

static double
find (const GArray *bounds, int kind)
{
  for (guint i = 0; i < bounds->len; i++) {
    const QnBound *bound = &g_array_index (bounds, QnBound, i);
    if (g_str_equal (bound->label, _ (words[kind].label)))
      return bound->value;
  }
  return NAN;
}

char *
qn_bounds_dup_verdict (const GArray *bounds)
{
  double path = find (bounds, PATH), upper = find (bounds, UPPER);
  double least = find (bounds, LEAST), greatest = find (bounds, GREATEST);
  if (isnan (path) || isnan (upper))
    return NULL;
  double share = (upper - path) / fabs (upper);
  if (share < -ALIKE)
    return g_strdup_printf (
      _ ("The path ends %.1f %% above the upper bound of rigid blocks: the joints of the "
         "model are not those of limit analysis, or the increments of the path are too "
         "large."),
      -100.0 * share);
  if (share <= ALIKE)
    return g_strdup (_ ("The path reaches the bound of limit analysis: no other path can "
                        "carry more."));
  if (!isnan (least) && path >= least * (1.0 - ALIKE) && path <= greatest * (1.0 + ALIKE))
    return g_strdup_printf (
      _ ("The path ends %.1f %% below the associative bound and within the interval of "
         "the laws' own dilatancy."),
      100.0 * share);
  return g_strdup_printf (_ ("The path ends %.1f %% below the associative bound: an "
                             "effect of dilatancy below friction."),
                          100.0 * share);
}
