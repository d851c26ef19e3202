#include "doc/document/run.h"

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
qn_run_step_at (const QnRun *run, double time)
{
  const QnStep *steps = run->result.steps;
  gsize low = 0, high = run->result.step_count - 1;
  while (high - low > 1) {
    gsize middle = low + (high - low) / 2;
    if (steps[middle].time <= time)
      low = middle;
    else
      high = middle;
  }
  return (int) (time - steps[low].time <= steps[high].time - time ? low : high);
}
