#include "doc/document/run.h"

#include "doc/text/explain.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n-lib.h>

QnRun *
qn_run_new (const char *name, const char *fingerprint)
{
  QnRun *run = g_atomic_rc_box_new0 (QnRun);
  run->name = g_strdup (name);
  run->fingerprint = g_strdup (fingerprint);
  return run;
}

QnRun *
qn_run_new_beside (QnRun *base, const char *name)
{
  QnRun *run = qn_run_new (name, base->fingerprint);
  run->kind = base->kind;
  run->base = qn_run_ref (base);
  run->model = base->model;
  run->contacts = base->contacts;
  return run;
}

QnRun *
qn_run_ref (QnRun *run)
{
  return g_atomic_rc_box_acquire (run);
}

static void
clear (gpointer data)
{
  QnRun *run = data;
  qn_result_clear (&run->result);
  if (run->base == NULL) {
    qn_contacts_clear (&run->contacts);
    qn_model_clear (&run->model);
  }
  g_clear_pointer (&run->base, qn_run_unref);
  g_free (run->name);
  g_free (run->label);
  g_free (run->proposed);
  g_free (run->method);
  g_free (run->text);
  g_free (run->fingerprint);
}

void
qn_run_unref (QnRun *run)
{
  g_atomic_rc_box_release_full (run, clear);
}

gboolean
qn_run_is_in_time (const QnRun *run)
{
  return run->result.history.width > 0 && run->result.step_count > 0;
}

int
qn_result_step_at (const QnResult *result, double time)
{
  const QnStep *steps = result->steps;
  gsize low = 0, high = result->step_count - 1;
  while (high - low > 1) {
    gsize middle = low + (high - low) / 2;
    if (steps[middle].time <= time)
      low = middle;
    else
      high = middle;
  }
  return (int) (time - steps[low].time <= steps[high].time - time ? low : high);
}

char *
qn_run_dup_title (const QnRun *run)
{
  const QnResult *result = &run->result;
  const QnVibration *mode = &result->vibration;
  if (run->kind == QN_RUN_MODE && mode->mode > 0)
    return mode->omega > 0
             ? g_strdup_printf (_ ("%s: mode %u, %.4g Hz"), run->name, (guint) mode->mode,
                                mode->omega / (2 * G_PI))
             : g_strdup_printf (_ ("%s: mode %u, rigid motion"), run->name,
                                (guint) mode->mode);
  if (run->kind == QN_RUN_STABILITY && result->outcome == QN_OUTCOME_SNAP)
    return g_strdup_printf (_ ("%s: %.4f"), run->name, result->first_limit_multiplier);
  if (run->kind == QN_RUN_STABILITY && result->outcome == QN_OUTCOME_TARGET_REACHED)
    return g_strdup_printf (_ ("%s: stable"), run->name);
  if (result->has_unproved_multiplier)
    return g_strdup_printf (_ ("%s: %.4f, not proved"), run->name,
                            result->unproved_multiplier);
  return result->has_collapse_multiplier
           ? g_strdup_printf (_ ("%s: %.4f"), run->name, result->collapse_multiplier)
           : g_strdup_printf (_ ("%s: %s"), run->name, qn_explain_outcome_label (result));
}

char *
qn_run_dup_explanation (const QnRun *run)
{
  const QnVibration *mode = &run->result.vibration;
  if (run->kind == QN_RUN_MODE && mode->mode > 0) {
    const char *about = run->loaded ? _ ("the last equilibrium of the analysis")
                                    : _ ("the equilibrium under dead load");
    if (!(mode->omega > 0))
      return g_strdup_printf (
        _ ("Mode %u of %u about %s: a rigid motion without stiffness."),
        (guint) mode->mode, run->mode_count, about);
    double hertz = mode->omega / (2 * G_PI);
    return g_strdup_printf (_ ("Mode %u of %u about %s: %.5g Hz, period %.4g s."),
                            (guint) mode->mode, run->mode_count, about, hertz, 1 / hertz);
  }
  if (run->kind == QN_RUN_STABILITY) {
    const QnResult *result = &run->result;
    if (result->outcome == QN_OUTCOME_SNAP)
      return g_strdup_printf (
        _ ("Stability is lost at a load multiplier of %.6g: the structure buckles as the "
           "mechanism shows, although the path of the perfect structure may continue."),
        result->first_limit_multiplier);
    g_autofree char *reason = qn_explain_outcome (&run->model, result);
    return result->outcome == QN_OUTCOME_TARGET_REACHED
             ? g_strdup_printf (_ ("Stable along the whole path. %s"), reason)
             : g_steal_pointer (&reason);
  }
  return qn_explain_outcome (&run->model, &run->result);
}

char *
qn_run_dup_mechanism_sentence (const QnRun *run)
{
  return run->kind == QN_RUN_ANALYSIS ? qn_collapse_dup_words (
           &run->model, &run->contacts, &run->result, qn_mechanism_dup_sentence)
                                      : NULL;
}

static char *
describe_event (const QnPathEvent *event, QnUnits units)
{
  const QnCount moved = { QN_COUNTED_BLOCKS, event->block_count };
  g_autofree char *blocks = qn_counts_dup_text (&moved, 1, ", ");
  if (event->kind == QN_EVENT_KIND_COLLAPSE)
    return g_strdup_printf (_ ("Multiplier %.4f: collapse, %s"), event->multiplier,
                            blocks);
  if (event->kind == QN_EVENT_KIND_BUCKLING)
    return g_strdup_printf (_ ("Multiplier %.4f: the structure buckles, %s"),
                            event->multiplier, blocks);
  QnUnits mm = qn_units_of_motion (units);
  g_autofree char *before =
    qn_units_format_full (mm, QN_QUANTITY_LENGTH, event->displacement_before, 3);
  g_autofree char *after =
    qn_units_format_full (mm, QN_QUANTITY_LENGTH, event->displacement_after, 3);
  return g_strdup_printf (
    _ ("Multiplier %.4f: a jump, the largest displacement grows from %s to %s, %s"),
    event->multiplier, before, after, blocks);
}

char *
qn_run_dup_events (const QnRun *run, QnUnits units, guint *told)
{
  const QnResult *result = &run->result;
  GString *events = g_string_new (NULL);
  gulong settles = 0;
  *told = 0;
  for (gsize i = 0; i < result->event_count; i++) {
    const QnPathEvent *event = &result->events[i];
    if (!qn_result_is_felt (result, event)) {
      settles++;
      continue;
    }
    g_autofree char *text = describe_event (event, units);
    g_autofree char *stage =
      event->stage > 0 ? qn_stage_dup_name (&run->model, event->stage) : NULL;
    g_string_append (events, (*told)++ > 0 ? "\n" : "");
    if (stage != NULL)
      g_string_append_printf (events, _ ("Stage “%s”. %s"), stage, text);
    else
      g_string_append (events, text);
  }
  g_string_append (events, *told > 0 && settles > 0 ? "\n" : "");
  if (settles > 0)
    g_string_append_printf (events,
                            ngettext ("%lu small jump: joints settle",
                                      "%lu small jumps: joints settle", settles),
                            settles);
  return g_string_free (events, FALSE);
}

gboolean
qn_run_has_curve (const QnRun *run)
{
  return run->kind != QN_RUN_MODE && run->model.analysis.procedure != QN_PROCEDURE_LIMIT;
}
