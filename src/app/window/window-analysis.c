#include "app/window/window-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/settings.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include <glib/gi18n.h>
#include <math.h>

/* ms after an edit before a live analysis starts. */
#define LIVE_DELAY_MS 200

static void
show_job_error (QnWindow *self)
{
  const GError *error = self->document->job_error;
  if (error == NULL)
    return;
  const QnDiag *diag = &self->document->job_diag;
  const QnModel *model = &self->document->project.model;
  if (diag->entity == QN_ENTITY_BLOCK && diag->index >= 0
      && (gsize) diag->index < model->block_count) {
    QnId blocks[] = { diag->index, diag->other };
    gboolean two = diag->other >= 0 && (gsize) diag->other < model->block_count;
    qn_view_state_set_view (self->state, QN_VIEW_CONTACTS);
    qn_selection_set (self->document->selection, QN_PICK_BLOCK, blocks, two ? 2 : 1);
    qn_window_show_error_at (self, error->message, model->blocks[diag->index].centroid);
  } else
    qn_window_show_error (self, error->message);
}

/* What the live analysis found, in one line over the drawing. */
static void
update_live_label (QnWindow *self)
{
  gboolean live = g_settings_get_boolean (qn_settings_get (), "live");
  const GError *error = self->document->job_error;
  const QnRun *run = self->document->run;
  g_autofree char *text = NULL;
  if (live && error != NULL)
    text = g_strdup (error->message);
  else if (live && run != NULL && run->live
           && !qn_document_is_stale (self->document, run)) {
    g_autofree char *words =
      qn_explain_mechanism_briefly (&run->model, &run->contacts, &run->result);
    const char *label = qn_explain_outcome_label (&run->result);
    text = run->result.has_collapse_multiplier
             ? g_strdup_printf ("λ = %.4f · %s", run->result.collapse_multiplier,
                                words != NULL ? words : label)
             : g_strdup (label);
  }
  gtk_label_set_text (self->live_label, text != NULL ? text : "");
  gtk_widget_set_visible (GTK_WIDGET (self->live_label), text != NULL);
}

static void
show_run (QnWindow *self)
{
  const QnRun *run = self->document->run;
  if (run == NULL || qn_document_is_stale (self->document, run))
    return;
  gtk_stack_set_visible_child_name (self->side_stack, "result");
  if (run->result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    g_autofree char *message = qn_run_dup_explanation (run);
    const QnId *blocks = run->result.unstable_blocks;
    const guint count = (guint) run->result.unstable_count;
    if (count == 0)
      qn_window_show_error (self, message);
    else { /* the blocks that move are selected and shown */
      qn_view_state_set_view (self->state, QN_VIEW_MODEL);
      qn_selection_set (self->document->selection, QN_PICK_BLOCK, blocks, count);
      qn_window_show_error_at (self, message, run->model.blocks[blocks[0]].centroid);
    }
  } else if (!qn_view_needs_result (self->state->options.view))
    qn_view_state_set_view (self->state, qn_view_of_result (&run->result));
  /* What stands is shown where it was worst. */
  if (qn_run_is_in_time (run) && run->result.outcome != QN_OUTCOME_COLLAPSE
      && isfinite (run->result.history.peak_time))
    qn_view_state_set_step (
      self->state, qn_result_step_at (&run->result, run->result.history.peak_time));
}

/* ---- several analyses one after the other ---- */

/* Starts the next method of those to be compared whose run is not there yet: one that follows a path, with a
 * curve and steps, and both limit analyses, which have neither. Behind the last they are shown. */
static void
start_next (QnWindow *self)
{
  const QnProcedure own = self->document->project.model.analysis.procedure;
  const struct {
    QnProcedure procedure;
    QnFlow flow;
  } all[] = {
    { own == QN_PROCEDURE_LIMIT ? QN_PROCEDURE_LOAD : own, QN_FLOW_ASSOCIATIVE },
    { QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE },
    { QN_PROCEDURE_LIMIT, QN_FLOW_NON_ASSOCIATIVE },
  };
  g_autoptr (GError) error = NULL;
  for (guint i; (i = self->next_method++) < G_N_ELEMENTS (all);) {
    if (qn_document_find_run (self->document, all[i].procedure, all[i].flow, FALSE)
        != NULL)
      continue;
    if (!qn_document_analyse_with (self->document, all[i].procedure, all[i].flow,
                                   &error)) {
      self->next_method = QN_NO_METHOD;
      qn_window_show_error (self, error->message);
    }
    return;
  }
  QnRun *path =
    qn_document_find_run (self->document, all[0].procedure, all[0].flow, FALSE);
  self->next_method = QN_NO_METHOD;
  gtk_stack_set_visible_child_name (self->side_stack, "result");
  if (path != NULL)
    qn_document_set_run (self->document, path);
}

/* HybriDFEM and both limit analyses of the same model. */
static void
run_all (QnWindow *self, const char *name)
{
  gtk_widget_set_visible (self->info_bar, FALSE);
  self->next_method = 0;
  start_next (self);
}

static void
on_job_changed (QnWindow *self)
{
  QnJob *job = self->document->job;
  /* A live analysis is over before one could read how far it is. */
  gboolean running = job != NULL && !qn_job_get_run (job)->live;
  gboolean was_running = self->was_running;
  self->was_running = running;
  gtk_widget_set_visible (self->progress_box, running);
  gtk_widget_set_visible (GTK_WIDGET (self->run_button), !running);
  if (running) {
    gtk_label_set_text (self->progress_label, _ ("Starting…"));
    gtk_button_set_icon_name (GTK_BUTTON (self->pause_button),
                              "media-playback-pause-symbolic");
  } else if (was_running) {
    show_job_error (self);
    show_run (self);
  }
  /* A bar that has pulsed draws the window for every frame until it is told a share. */
  gtk_progress_bar_set_fraction (self->progress_bar, 0.0);
  update_live_label (self);
  qn_window_update_actions (self);
  const QnRun *run = self->document->run;
  if (running || !was_running || self->next_method == QN_NO_METHOD)
    return;
  if (self->document->job_error == NULL && run != NULL
      && run->result.outcome != QN_OUTCOME_CANCELLED)
    start_next (self);
  else
    self->next_method = QN_NO_METHOD;
}

/* "2.35 of 10 s · 12 s left"; the second part once something can be said. */
static char *
dup_time_text (QnJob *job, const QnProgress *progress)
{
  double left = qn_job_get_remaining (job);
  g_autofree char *time =
    g_strdup_printf (_ ("%.2f of %.4g s"), progress->time, progress->end);
  if (left < 0.0)
    return g_steal_pointer (&time);
  int seconds = (int) MIN (ceil (left), 1e6);
  return seconds < 120
           ? g_strdup_printf (_ ("%s · %d s left"), time, seconds)
           : g_strdup_printf (_ ("%s · %d min left"), time, (seconds + 59) / 60);
}

static void
on_job_progress (QnWindow *self)
{
  QnJob *job = self->document->job;
  if (job == NULL)
    return;
  QnProgress progress = qn_job_get_progress (job);
  g_autofree char *text =
    progress.end > 0.0
      ? dup_time_text (job, &progress)
      : g_strdup_printf (_ ("λ %.4f · step %d · %d iterations"), progress.multiplier,
                         progress.steps, progress.iterations);
  gtk_label_set_text (self->progress_label, text);
  if (progress.end > 0.0)
    gtk_progress_bar_set_fraction (self->progress_bar, progress.time / progress.end);
  else
    gtk_progress_bar_pulse (self->progress_bar);
}

/* What was said before is about an earlier analysis. */
static void
begin (QnWindow *self, gboolean begun, GError **error)
{
  gtk_widget_set_visible (self->info_bar, FALSE);
  if (!begun)
    qn_window_show_error (self, (*error)->message);
}

static void
run (QnWindow *self, const char *name)
{
  g_autoptr (GError) error = NULL;
  qn_window_commit_entry (self);
  begin (self, qn_document_analyse (self->document, &error), &error);
}

/* What is in sight: the study, or the drawing. */
static void
run_shown (QnWindow *self, const char *name)
{
  qn_window_commit_entry (self);
  if (!qn_window_page_does (self, "run"))
    run (self, name);
}

static void
cancel (QnWindow *self, const char *name)
{
  if (self->reporting != NULL)
    g_cancellable_cancel (self->reporting);
  if (!qn_window_page_can (self, "cancel") || !qn_window_page_does (self, "cancel"))
    qn_document_cancel (self->document);
}

static void
pause_or_resume (QnWindow *self, const char *name)
{
  QnJob *job = self->document->job;
  if (job == NULL)
    return;
  gboolean paused = !qn_job_is_paused (job);
  qn_job_set_paused (job, paused);
  gtk_button_set_icon_name (GTK_BUTTON (self->pause_button),
                            paused ? "media-playback-start-symbolic"
                                   : "media-playback-pause-symbolic");
}

/* HybriDFEM against limit analysis, on the same model. */
static void
run_limit (QnWindow *self, const char *flow)
{
  g_autoptr (GError) error = NULL;
  begin (self,
         qn_document_analyse_with (self->document, QN_PROCEDURE_LIMIT,
                                   g_str_equal (flow, "associative")
                                     ? QN_FLOW_ASSOCIATIVE
                                     : QN_FLOW_NON_ASSOCIATIVE,
                                   &error),
         &error);
}

/* Modes that are found and listed. */
#define MODES 6

static void
run_modes (QnWindow *self, const char *state)
{
  const gboolean loaded = g_str_equal (state, "loaded");
  g_autoptr (GError) error = NULL;
  begin (self, qn_document_find_modes (self->document, MODES, loaded, &error), &error);
}

static void
run_stability (QnWindow *self, const char *name)
{
  g_autoptr (GError) error = NULL;
  begin (self, qn_document_find_stability (self->document, &error), &error);
}

static gboolean
on_live_timeout (gpointer data)
{
  QnWindow *self = data;
  self->live_timeout = 0;
  qn_document_analyse_live (self->document, NULL);
  return G_SOURCE_REMOVE;
}

static void
on_document_changed (QnWindow *self)
{
  GSettings *settings = qn_settings_get ();
  gsize count = self->document->project.model.block_count;
  g_clear_handle_id (&self->live_timeout, g_source_remove);
  self->next_method = QN_NO_METHOD;
  update_live_label (self);
  if (g_settings_get_boolean (settings, "live") && count > 0
      && count <= (gsize) g_settings_get_int (settings, "live-limit"))
    self->live_timeout = g_timeout_add (LIVE_DELAY_MS, on_live_timeout, self);
}

void
qn_window_connect_analysis (QnWindow *self)
{
  GtkWidget *window = GTK_WIDGET (self);
  qn_watch (window, self->document, "job-changed", G_CALLBACK (on_job_changed), self);
  qn_watch (window, self->document, "job-progress", G_CALLBACK (on_job_progress), self);
  qn_watch (window, self->document, "changed", G_CALLBACK (on_document_changed), self);
  qn_watch (window, qn_settings_get (), "changed::live", G_CALLBACK (on_document_changed),
            self);
  self->next_method = QN_NO_METHOD;
  on_job_changed (self);
}

const QnWindowAction qn_window_analysis_actions[] = {
  { "run", NULL, { run }, QN_NEEDS_SOLVABLE },
  { "run-shown", NULL, { run_shown }, QN_NEEDS_SOLVABLE | QN_NEEDS_READY },
  { "cancel", NULL, { cancel }, QN_NEEDS_JOB },
  { "pause", NULL, { pause_or_resume }, QN_NEEDS_JOB },
  { "run-limit", "s", { run_limit }, QN_NEEDS_SOLVABLE },
  { "run-all", NULL, { run_all }, QN_NEEDS_SOLVABLE },
  { "run-modes", "s", { run_modes }, QN_NEEDS_SOLVABLE },
  { "run-stability", NULL, { run_stability }, QN_NEEDS_SOLVABLE },
  { .name = NULL },
};
