#include "doc/document/run-text.h"

#include "doc/text/explain.h"
#include <glib/gi18n.h>

static double
hertz_of (const QnRun *run)
{
  return run->omega / (2 * G_PI);
}

static char *
dup_mode_title (const QnRun *run)
{
  return run->omega > 0
           ? g_strdup_printf (_ ("%s: mode %u, %.4g Hz"), run->name, run->mode,
                              hertz_of (run))
           : g_strdup_printf (_ ("%s: mode %u, rigid motion"), run->name, run->mode);
}

char *
qn_run_dup_title (const QnRun *run)
{
  const QnResult *result = &run->result;
  if (run->kind == QN_RUN_MODE && run->mode > 0)
    return dup_mode_title (run);
  if (run->kind == QN_RUN_STABILITY && result->outcome == QN_OUTCOME_SNAP)
    return g_strdup_printf (_ ("%s: %.4f"), run->name, result->first_limit_multiplier);
  if (run->kind == QN_RUN_STABILITY && result->outcome == QN_OUTCOME_TARGET_REACHED)
    return g_strdup_printf (_ ("%s: stable"), run->name);
  return result->has_collapse_multiplier
           ? g_strdup_printf (_ ("%s: %.4f"), run->name, result->collapse_multiplier)
           : g_strdup_printf (_ ("%s: %s"), run->name,
                              qn_explain_outcome_label (result->outcome));
}

static char *
explain_mode (const QnRun *run)
{
  const char *about = run->loaded ? _ ("the last equilibrium of the analysis")
                                  : _ ("the equilibrium under dead load");
  if (!(run->omega > 0))
    return g_strdup_printf (
      _ ("Mode %u of %u about %s: a rigid motion without stiffness."), run->mode,
      run->mode_count, about);
  double hertz = hertz_of (run);
  return g_strdup_printf (_ ("Mode %u of %u about %s: %.5g Hz, period %.4g s."),
                          run->mode, run->mode_count, about, hertz, 1 / hertz);
}

static char *
explain_stability (const QnRun *run)
{
  const QnResult *result = &run->result;
  if (result->outcome == QN_OUTCOME_SNAP)
    return g_strdup_printf (
      _ ("Stability is lost at a load multiplier of %.6g: the structure buckles as the "
         "mechanism shows, although the path of the perfect structure may continue."),
      result->first_limit_multiplier);
  g_autofree char *reason = qn_explain_outcome (&run->model, result);
  return result->outcome == QN_OUTCOME_TARGET_REACHED
           ? g_strdup_printf (_ ("Stable all along. %s"), reason)
           : g_steal_pointer (&reason);
}

char *
qn_run_dup_explanation (const QnRun *run)
{
  if (run->kind == QN_RUN_MODE && run->mode > 0)
    return explain_mode (run);
  if (run->kind == QN_RUN_STABILITY)
    return explain_stability (run);
  return qn_explain_outcome (&run->model, &run->result);
}

char *
qn_run_dup_mechanism (const QnRun *run)
{
  return run->kind == QN_RUN_ANALYSIS
           ? qn_explain_mechanism (&run->model, &run->contacts, &run->result)
           : NULL;
}

gboolean
qn_run_has_curve (const QnRun *run)
{
  return run->kind != QN_RUN_MODE && run->model.analysis.procedure != QN_PROCEDURE_LIMIT;
}
