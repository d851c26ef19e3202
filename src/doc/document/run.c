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
  g_free (run->fingerprint);
}

void
qn_run_unref (QnRun *run)
{
  g_atomic_rc_box_release_full (run, clear);
}
