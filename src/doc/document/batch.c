#include "doc/document/batch.h"

#include "doc/document/document.h"
#include "io/result/result-file.h"
#include <glib/gi18n-lib.h>
#include <string.h>

/* clang-format off */
G_DEFINE_TYPE (QnBatch, qn_batch, G_TYPE_OBJECT)
/* clang-format on */

static void
tell (QnBatch *self, const char *path, const char *reason)
{
  g_autofree char *base = g_path_get_basename (path);
  /* Readers begin with the file and the line. */
  g_ptr_array_add (self->messages, strstr (reason, base) != NULL
                                     ? g_strdup (reason)
                                     : g_strdup_printf ("%s: %s", base, reason));
}

/* ---- solving ---- */

static void on_job_changed (QnDocument *document, QnBatch *self);

/* Starts the next document that has no run; those that refuse say why. */
static void
go_on (QnBatch *self)
{
  const QnDocument *last = self->next > 0 ? self->documents->pdata[self->next - 1] : NULL;
  if (last != NULL && last->job != NULL)
    return;
  while (self->next < self->documents->len && !self->cancelled) {
    QnDocument *document = self->documents->pdata[self->next++];
    g_autoptr (GError) error = NULL;
    if (document->runs->len > 0)
      continue;
    if (qn_document_analyse (document, &error))
      return;
    tell (self, document->path, error->message);
    g_signal_emit_by_name (self, "changed");
  }
}

static void
on_job_changed (QnDocument *document, QnBatch *self)
{
  const GError *error = document->job_error;
  if (document->job != NULL)
    return;
  if (error != NULL && !g_error_matches (error, G_IO_ERROR, G_IO_ERROR_CANCELLED))
    tell (self, document->path, error->message);
  g_signal_emit_by_name (self, "changed");
  go_on (self);
}

/* ---- opening ---- */

static QnDocument *
find (QnBatch *self, const char *path)
{
  for (guint i = 0; i < self->documents->len; i++) {
    QnDocument *document = self->documents->pdata[i];
    if (g_strcmp0 (document->path, path) == 0)
      return document;
  }
  return NULL;
}

static QnDocument *
open_project (QnBatch *self, const char *path)
{
  QnDocument *document = find (self, path);
  g_autoptr (GError) error = NULL;
  if (document != NULL)
    return document;
  document = qn_document_new ();
  if (!qn_document_load (document, path, &error)) {
    tell (self, path, error->message);
    g_object_unref (document);
    return NULL;
  }
  g_signal_connect (document, "job-changed", G_CALLBACK (on_job_changed), self);
  g_ptr_array_add (self->documents, document);
  return document;
}

static gboolean
open_result (QnBatch *self, const char *path)
{
  QnResultFile file;
  g_autoptr (GError) error = NULL;
  if (!qn_result_file_read (path, &file, &error)) {
    tell (self, path, error->message);
    return FALSE;
  }
  g_autofree char *folder = g_path_get_dirname (path);
  g_autofree char *project =
    g_build_filename (folder, file.model != NULL ? file.model : "", NULL);
  qn_result_file_clear (&file);
  QnDocument *document = open_project (self, project);
  if (document == NULL)
    return FALSE;
  if (qn_document_open_result (document, path, &error))
    return TRUE;
  tell (self, path, error->message);
  return FALSE;
}

static int
compare_paths (gconstpointer a, gconstpointer b)
{
  return g_strcmp0 (*(char *const *) a, *(char *const *) b);
}

/* Projects, then results, by name; NULL where it is no folder. */
static GPtrArray *
list_folder (const char *path)
{
  GDir *dir = g_dir_open (path, 0, NULL);
  if (dir == NULL)
    return NULL;
  GPtrArray *projects = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GPtrArray) results = g_ptr_array_new ();
  const char *name;
  while ((name = g_dir_read_name (dir)) != NULL) {
    char *file = g_build_filename (path, name, NULL);
    if (g_str_has_suffix (name, ".quoin"))
      g_ptr_array_add (projects, file);
    else if (g_str_has_suffix (name, ".json") && qn_is_result_file (file))
      g_ptr_array_add (results, file);
    else
      g_free (file);
  }
  g_dir_close (dir);
  g_ptr_array_sort (projects, compare_paths);
  g_ptr_array_sort (results, compare_paths);
  g_ptr_array_extend_and_steal (projects, g_steal_pointer (&results));
  return projects;
}

guint
qn_batch_add (QnBatch *self, const char *path)
{
  guint count = 0;
  g_autoptr (GPtrArray) files = list_folder (path);
  if (files == NULL) {
    files = g_ptr_array_new_with_free_func (g_free);
    g_ptr_array_add (files, g_canonicalize_filename (path, NULL));
  } else if (files->len == 0)
    tell (self, path, _ ("there are no projects and results in this folder"));
  for (guint i = 0; i < files->len; i++) {
    const char *file = files->pdata[i];
    count += qn_is_result_file (file) ? open_result (self, file)
                                      : open_project (self, file) != NULL;
  }
  self->cancelled = FALSE;
  g_signal_emit_by_name (self, "changed");
  go_on (self);
  return count;
}

/* ---- object ---- */

static void
qn_batch_dispose (GObject *object)
{
  QnBatch *self = QN_BATCH (object);
  self->cancelled = TRUE;
  for (guint i = 0; self->documents != NULL && i < self->documents->len; i++) {
    g_signal_handlers_disconnect_by_data (self->documents->pdata[i], self);
    qn_document_cancel (self->documents->pdata[i]);
  }
  g_clear_pointer (&self->documents, g_ptr_array_unref);
  g_clear_pointer (&self->messages, g_ptr_array_unref);
  G_OBJECT_CLASS (qn_batch_parent_class)->dispose (object);
}

static void
qn_batch_class_init (QnBatchClass *class)
{
  G_OBJECT_CLASS (class)->dispose = qn_batch_dispose;
  g_signal_new ("changed", QN_TYPE_BATCH, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                G_TYPE_NONE, 0);
}

static void
qn_batch_init (QnBatch *self)
{
  self->documents = g_ptr_array_new_with_free_func (g_object_unref);
  self->messages = g_ptr_array_new_with_free_func (g_free);
}
