/* Cases that are being computed: quoin-cli computes them, this window looks at them. */
#include "app/dialogs/study-private.h"

#include "app/widgets/build-tree.h"
#include "core/base/integer.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>
#include <math.h>

/* ms between two looks at a study that runs. */
#define INTERVAL 250

static void
show_progress (QnStudyWindow *self, const QnStudyProgress *progress)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text, _ ("%zu of %zu cases, %zu failed"), progress->present,
                   progress->wanted, progress->failed);
  if (self->job != NULL && !isnan (progress->to_go) && progress->present > 0) {
    guint seconds = (guint) qn_to_integer (progress->to_go, 0, G_MAXINT32);
    g_string_append_printf (text, _ (", %u:%02u:%02u left"), seconds / 3600,
                            seconds / 60 % 60, seconds % 60);
  }
  qn_study_window_tell (self, text->str);
  if (progress->wanted > 0)
    gtk_progress_bar_set_fraction (self->progress, (double) progress->present
                                                     / (double) progress->wanted);
}

static gboolean
on_timeout (gpointer data)
{
  QnStudyWindow *self = data;
  QnStudyProgress progress;
  g_autoptr (GError) error = NULL;
  QnStudyJobState state = qn_study_job_look (self->job, &progress, &error);
  qn_study_window_read_more (self);
  if (state == QN_STUDY_JOB_RUNS) {
    show_progress (self, &progress);
    return G_SOURCE_CONTINUE;
  }
  g_clear_pointer (&self->job, qn_study_job_free);
  self->timeout = 0;
  gtk_widget_set_visible (GTK_WIDGET (self->progress), FALSE);
  if (error != NULL)
    qn_study_window_tell (self, error->message);
  else
    show_progress (self, &progress);
  qn_study_window_update_actions (self);
  return G_SOURCE_REMOVE;
}

/* quoin-cli, which computes the cases: beside this program, in the build tree, or in the path. */
static char *
dup_program (void)
{
  g_autofree char *own = g_file_read_link ("/proc/self/exe", NULL);
  g_autofree char *folder = g_path_get_dirname (own != NULL ? own : "");
  char *beside = g_build_filename (folder, "quoin-cli", NULL);
  if (g_file_test (beside, G_FILE_TEST_IS_EXECUTABLE))
    return beside;
  g_free (beside);
  g_autofree char *sources = qn_build_tree_dup_folder ("src");
  if (sources != NULL)
    return g_build_filename (sources, "cli", "quoin-cli", NULL);
  return g_find_program_in_path ("quoin-cli");
}

static gboolean
start (QnStudyWindow *self, GError **error)
{
  QnStudy study;
  g_autofree char *program = dup_program ();
  const char *path = qn_draft_get_path (self->draft);
  if (qn_document_is_modified (self->parent.document)) {
    g_set_error_literal (
      error, QN_IO_ERROR, QN_IO_ERROR_FILE,
      _ ("Save the project first: a study computes what its file says."));
    return FALSE;
  }
  if (program == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("quoin-cli, which computes the cases, is not installed."));
    return FALSE;
  }
  if (!qn_draft_save (self->draft, error) || !qn_study_read (path, NULL, &study, error))
    return FALSE;
  g_free (self->running);
  self->running = qn_study_window_dup_folder (&study, path);
  qn_study_clear (&study);
  self->job =
    qn_study_job_start (path, self->running, program, g_get_num_processors (), error);
  return self->job != NULL;
}

void
qn_study_window_run (QnStudyWindow *self)
{
  g_autoptr (GError) error = NULL;
  if (!start (self, &error)) {
    qn_study_window_tell (self, error->message);
    return;
  }
  qn_study_window_tell (self, "");
  gtk_progress_bar_set_fraction (self->progress, 0);
  gtk_widget_set_visible (GTK_WIDGET (self->progress), TRUE);
  self->timeout = g_timeout_add (INTERVAL, on_timeout, self);
  qn_study_window_update_actions (self);
}
