#include "doc/document/run-text.h"

#include "doc/text/explain.h"
#include "io/text/mechanism-text.h"
#include <glib/gi18n.h>
#include <math.h>

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

char *
qn_run_dup_mechanism_sentence (const QnRun *run)
{
  QnMechanism mechanism;
  if (run->kind != QN_RUN_ANALYSIS || run->result.mechanism == NULL
      || qn_mechanism_init (&mechanism, &run->model, &run->contacts,
                            run->result.mechanism, NULL)
           != QN_OK)
    return NULL;
  char *sentence = qn_mechanism_dup_sentence (&mechanism);
  qn_mechanism_clear (&mechanism);
  return sentence;
}

/* How far anything moves from the step before to this one, m. */
static double
distance_of_step (const QnResult *result, gsize step)
{
  double farthest = 0.0;
  if (step == 0)
    return farthest;
  const double *from = qn_result_step_displacements (result, step - 1);
  const double *to = qn_result_step_displacements (result, step);
  for (gsize r = 0; r < QN_DOF_COUNT * qn_result_body_count (result); r += QN_DOF_COUNT)
    farthest = fmax (farthest, hypot (to[r + QN_DOF_UX] - from[r + QN_DOF_UX],
                                      to[r + QN_DOF_UY] - from[r + QN_DOF_UY]));
  return farthest;
}

GPtrArray *
qn_run_dup_events (const QnRun *run, QnUnits units)
{
  const QnResult *result = &run->result;
  GPtrArray *events = g_ptr_array_new_with_free_func (g_free);
  for (gsize s = 0; s < result->step_count; s++) {
    const QnStep *step = &result->steps[s];
    g_autofree char *size =
      qn_units_format_full (units, QN_QUANTITY_LENGTH, distance_of_step (result, s), 3);
    if (step->event == QN_EVENT_SNAP)
      g_ptr_array_add (events,
                       g_strdup_printf (_ ("Step %u, multiplier %.4f: a jump by %s"),
                                        (guint) s, step->multiplier, size));
    else if (step->event == QN_EVENT_COLLAPSE)
      g_ptr_array_add (events, g_strdup_printf (_ ("Step %u, multiplier %.4f: collapse"),
                                                (guint) s, step->multiplier));
  }
  return events;
}

gboolean
qn_run_has_curve (const QnRun *run)
{
  return run->kind != QN_RUN_MODE && run->model.analysis.procedure != QN_PROCEDURE_LIMIT;
}
