#include "doc/document/document.h"

#include "doc/edit/edit.h"
#include "io/project/number-path.h"
#include "io/project/project.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include <glib/gi18n-lib.h>
#include <string.h>

/* Member of a project file that keeps the history. */
#define HISTORY "history"

G_DEFINE_FINAL_TYPE (QnDocument, qn_document, G_TYPE_OBJECT)

/* ---- state ---- */

static gboolean
parse (const char *text, const char *name, QnProject *project, GError **error)
{
  return qn_project_parse (text, strlen (text), name, NULL, project, error);
}

static gboolean
detect (const QnModel *model, QnContacts *contacts, GError **error)
{
  QnDiag diag = { 0 };
  if (qn_contacts_detect (model, contacts, &diag) == QN_OK)
    return TRUE;
  return qn_edit_refuse_diag (error, model, &diag);
}

/* Takes over `project` (cleared on failure) as the state, and `text`, what it is written as. */
static gboolean
adopt (QnDocument *self, QnProject *project, QnProjectText *text, GError **error)
{
  QnContacts contacts;
  if (!detect (&project->model, &contacts, error)) {
    qn_project_clear (project);
    qn_project_text_free (text);
    return FALSE;
  }
  QnProject old = self->project;
  QnContacts old_contacts = self->contacts;
  self->project = *project;
  self->contacts = contacts;
  qn_project_text_free (self->text);
  self->text = text;
  g_clear_pointer (&self->fingerprint, g_free);
  qn_selection_follow (self->selection, &old.model, &old_contacts, &self->project.model,
                       &self->contacts);
  qn_project_clear (&old);
  qn_contacts_clear (&old_contacts);
  g_signal_emit_by_name (self, "changed");
  if (qn_document_name_runs (self))
    g_signal_emit_by_name (self, "runs-changed");
  return TRUE;
}

static const char *
name_in_messages (QnDocument *self)
{
  return self->path != NULL ? self->path : _ ("Untitled");
}

const char *
qn_document_get_fingerprint (QnDocument *self)
{
  if (self->fingerprint == NULL) {
    g_autofree char *whole = qn_model_digest (&self->project, self->text);
    g_autofree char *structure = qn_structure_digest (&self->project, self->text);
    self->fingerprint = g_strconcat (whole, " ", structure, NULL);
  }
  return self->fingerprint;
}

/* ---- life ---- */

static void
qn_document_dispose (GObject *object)
{
  qn_document_drop_job (QN_DOCUMENT (object));
  G_OBJECT_CLASS (qn_document_parent_class)->dispose (object);
}

static void
qn_document_finalize (GObject *object)
{
  QnDocument *self = QN_DOCUMENT (object);
  qn_project_clear (&self->project);
  qn_contacts_clear (&self->contacts);
  qn_history_free (self->history);
  g_clear_object (&self->selection);
  g_clear_error (&self->job_error);
  g_free (self->job_text);
  g_clear_pointer (&self->run, qn_run_unref);
  g_ptr_array_unref (self->runs);
  g_free (self->path);
  g_free (self->folder);
  qn_project_text_free (self->text);
  g_free (self->fingerprint);
  g_free (self->file_digest);
  G_OBJECT_CLASS (qn_document_parent_class)->finalize (object);
}

static void
qn_document_class_init (QnDocumentClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  object_class->dispose = qn_document_dispose;
  object_class->finalize = qn_document_finalize;
  static const char *const signals[] = { "changed",      "history-changed",
                                         "file-changed", "runs-changed",
                                         "job-changed",  "job-progress" };
  for (gsize i = 0; i < G_N_ELEMENTS (signals); i++)
    g_signal_new (signals[i], QN_TYPE_DOCUMENT, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                  G_TYPE_NONE, 0);
}

static void
on_selection_changed (QnDocument *self)
{
  qn_history_break (self->history);
}

static void
qn_document_init (QnDocument *self)
{
  qn_project_init (&self->project);
  self->history = qn_history_new ();
  self->selection = g_object_new (QN_TYPE_SELECTION, NULL);
  g_signal_connect_object (self->selection, "changed", G_CALLBACK (on_selection_changed),
                           self, G_CONNECT_SWAPPED);
  self->runs = g_ptr_array_new_with_free_func ((GDestroyNotify) qn_run_unref);
}

QnDocument *
qn_document_new (void)
{
  QnDocument *self = g_object_new (QN_TYPE_DOCUMENT, NULL);
  QnProject project;
  g_autoptr (GError) error = NULL;
  if (!qn_project_begin (&project, "dry joint", &error))
    g_error ("%s", error->message);
  project.name = g_strdup (_ ("Untitled"));
  adopt (self, &project, qn_project_write (&project, NULL, NULL), NULL);
  return self;
}

/* ---- the file ---- */

static void
take_path (QnDocument *self, const char *path)
{
  g_free (self->path);
  g_free (self->folder);
  self->path = g_strdup (path);
  self->folder = path != NULL ? g_path_get_dirname (path) : NULL;
}

/* Starts afresh from a project that was read; `project` is taken over. */
static gboolean
begin (QnDocument *self, QnProject *project, const char *path, GError **error)
{
  /* Who looks at the new state looks for its files beside it. */
  g_autofree char *before = g_strdup (self->path);
  take_path (self, path);
  /* The history starts from the canonical text, whatever the file looks like. */
  if (!adopt (self, project, qn_project_write (project, NULL, NULL), error)) {
    take_path (self, before);
    return FALSE;
  }
  qn_document_drop_job (self);
  g_clear_error (&self->job_error);
  qn_history_free (self->history);
  self->history = qn_history_new ();
  g_clear_pointer (&self->run, qn_run_unref);
  g_ptr_array_set_size (self->runs, 0);
  self->run_number = 0;
  self->never_saved = path == NULL;
  self->keeps_history = FALSE;
  g_clear_pointer (&self->file_digest, g_free);
  g_signal_emit_by_name (self, "file-changed");
  g_signal_emit_by_name (self, "history-changed");
  g_signal_emit_by_name (self, "runs-changed");
  g_signal_emit_by_name (self, "job-changed");
  return TRUE;
}

static void
adopt_history (QnDocument *self, const char *json)
{
  self->keeps_history = json != NULL;
  if (json == NULL)
    return;
  QnEditHistory *history = qn_history_from_json (json, self->text->text);
  if (history != NULL) {
    qn_history_free (self->history);
    self->history = history;
    g_signal_emit_by_name (self, "history-changed");
  } else
    g_ptr_array_add (
      self->project.warnings,
      g_strdup (_ ("The file has been changed elsewhere since its history was kept; the "
                   "steps before cannot be undone")));
}

static char *
digest_file (const char *text, gsize length)
{
  return g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *) text, length);
}

gboolean
qn_document_is_changed_elsewhere (QnDocument *self)
{
  g_autofree char *text = NULL;
  gsize length = 0;
  if (self->path == NULL || self->file_digest == NULL
      || !g_file_get_contents (self->path, &text, &length, NULL))
    return FALSE;
  g_autofree char *digest = digest_file (text, length);
  return !g_str_equal (digest, self->file_digest);
}

gboolean
qn_document_load (QnDocument *self, const char *path, GError **error)
{
  QnProject project;
  gsize length = 0;
  g_autofree char *text = qn_file_read (path, &length, error);
  if (text == NULL || !parse (text, path, &project, error))
    return FALSE;
  /* The history is no part of the state that it leads to. */
  g_autofree char *history = qn_project_dup_extra (&project, HISTORY);
  qn_project_put_extra (&project, HISTORY, NULL);
  if (!begin (self, &project, path, error))
    return FALSE;
  adopt_history (self, history);
  self->file_digest = digest_file (text, length);
  return TRUE;
}

gboolean
qn_document_load_copy (QnDocument *self, const char *path, GError **error)
{
  if (!qn_document_load (self, path, error))
    return FALSE;
  g_clear_pointer (&self->path, g_free);
  g_clear_pointer (&self->file_digest, g_free);
  g_signal_emit_by_name (self, "file-changed");
  return TRUE;
}

gboolean
qn_document_load_recovered (QnDocument *self, const char *text, const char *path,
                            GError **error)
{
  QnProject project;
  const char *name = path != NULL ? path : _ ("Untitled");
  if (!parse (text, name, &project, error) || !begin (self, &project, path, error))
    return FALSE;
  self->never_saved = TRUE;
  g_signal_emit_by_name (self, "history-changed");
  return TRUE;
}

/* Content of a project file. */
static char *
dup_file_text (QnDocument *self, GError **error)
{
  if (!self->keeps_history)
    return g_strdup (self->text->text);
  g_autofree char *json = qn_history_to_json (self->history, self->text->text);
  QnProject draft = self->project;
  draft.extras = cJSON_Duplicate (self->project.extras, 1);
  gboolean done = qn_project_set_extra (&draft, HISTORY, json, error);
  char *text = done ? qn_project_to_text (&draft, NULL) : NULL;
  cJSON_Delete (draft.extras);
  return text;
}

void
qn_document_set_keeps_history (QnDocument *self, gboolean keeps)
{
  if (self->keeps_history == keeps)
    return;
  self->keeps_history = keeps;
  g_signal_emit_by_name (self, "history-changed");
}

gboolean
qn_document_save (QnDocument *self, const char *path, GError **error)
{
  g_autofree char *text = dup_file_text (self, error);
  if (text == NULL || !qn_file_write (path, text, strlen (text), error))
    return FALSE;
  self->history->clean = self->history->position;
  self->never_saved = FALSE;
  g_free (self->file_digest);
  self->file_digest = digest_file (text, strlen (text));
  if (g_strcmp0 (path, self->path) != 0) {
    take_path (self, path);
    g_signal_emit_by_name (self, "file-changed");
  }
  g_signal_emit_by_name (self, "history-changed");
  return TRUE;
}

char *
qn_document_dup_display_name (QnDocument *self)
{
  const char *title = self->project.model.title;
  if (title != NULL && *title != '\0')
    return g_strdup (title);
  return self->path != NULL ? g_path_get_basename (self->path)
                            : g_strdup (_ ("Untitled"));
}

gboolean
qn_document_is_modified (QnDocument *self)
{
  return self->never_saved || self->history->clean != self->history->position;
}

const QnProject *
qn_document_get_project (QnDocument *self)
{
  if (self->project.sha256 == NULL)
    self->project.sha256 = digest_file (self->text->text, self->text->length);
  return &self->project;
}

/* ---- edits ---- */

/* Makes a draft (cleared on failure) the state and a step of the history. */
static gboolean
step_to (QnDocument *self, const char *name, const char *key, QnProject *draft,
         GError **error)
{
  QnProjectText *text = qn_project_write (draft, &self->project, self->text);
  if (strcmp (text->text, self->text->text) == 0) {
    qn_project_text_free (text);
    qn_project_clear (draft);
    return TRUE;
  }
  g_autofree char *before = g_strdup (self->text->text);
  if (!adopt (self, draft, text, error))
    return FALSE;
  qn_history_record (self->history, name, key, before, self->text->text);
  g_signal_emit_by_name (self, "history-changed");
  return TRUE;
}

gboolean
qn_document_begin_edit (QnDocument *self, QnProject *draft, GError **error)
{
  if (!qn_project_copy (&self->project, draft, error))
    return FALSE;
  g_free (draft->name);
  draft->name = g_strdup (name_in_messages (self));
  return TRUE;
}

/* Numbers entities as a file that is read; the draft holds nothing where that is refused. */
static gboolean
complete (QnProject *draft, gboolean done, GError **error)
{
  if (done && qn_edit_rebuild (&draft->model, NULL, error)
      && qn_project_prepare (draft, error))
    return TRUE;
  qn_project_clear (draft);
  return FALSE;
}

static gboolean
is_parametric (const QnBlock *block)
{
  return block->masonry != QN_NONE || block->wall != QN_NONE;
}

/* Whether blocks of walls have become free ones, other than by detaching alone, which moves none. */
static gboolean
dissolves (const QnModel *before, const QnModel *after)
{
  gsize counts[2] = { 0, 0 };
  for (gsize i = 0; i < before->block_count; i++)
    counts[0] += is_parametric (&before->blocks[i]);
  for (gsize i = 0; i < after->block_count; i++)
    counts[1] += is_parametric (&after->blocks[i]);
  gboolean same_shape = before->vertex_count == after->vertex_count
                        && (before->vertex_count == 0
                            || memcmp (before->vertices, after->vertices,
                                       before->vertex_count * sizeof *before->vertices)
                                 == 0);
  if (counts[1] >= counts[0] || same_shape)
    return FALSE;
  for (gsize i = 0; i < after->block_count; i++) {
    QnId old = is_parametric (&after->blocks[i])
                 ? QN_NONE
                 : qn_model_find_block (before, after->blocks[i].name);
    if (old != QN_NONE && is_parametric (&before->blocks[old]))
      return TRUE;
  }
  return FALSE;
}

gboolean
qn_document_end_edit (QnDocument *self, QnProject *draft, const char *name,
                      const char *key, gboolean done, GError **error)
{
  if (!complete (draft, done, error))
    return FALSE;
  self->dissolved = dissolves (&self->project.model, &draft->model);
  g_autofree char *told =
    self->dissolved ? g_strdup_printf (_ ("%s, Wall to Free Blocks"), name) : NULL;
  return step_to (self, told != NULL ? told : name, key, draft, error);
}

gboolean
qn_document_edit (QnDocument *self, const char *name, const char *key, QnEditFunc func,
                  gpointer user_data, GError **error)
{
  QnProject draft;
  return qn_document_begin_edit (self, &draft, error)
         && qn_document_end_edit (self, &draft, name, key,
                                  func (&draft, user_data, error), error);
}

/* The text of the project after an edit; NULL where that is refused. */
static QnProjectText *
write_edited (QnDocument *self, QnEditFunc func, gpointer user_data)
{
  QnProject draft;
  if (!qn_document_begin_edit (self, &draft, NULL)
      || !complete (&draft, func (&draft, user_data, NULL), NULL))
    return NULL;
  QnProjectText *text = qn_project_write (&draft, NULL, NULL);
  qn_project_clear (&draft);
  return text;
}

char *
qn_document_dup_number_path (QnDocument *self, QnEditFunc func, gpointer same,
                             gpointer other, double value, double *number)
{
  QnProjectText *before = write_edited (self, func, same);
  QnProjectText *after = write_edited (self, func, other);
  char *path = before != NULL && after != NULL
                 ? qn_number_path_find (before->text, after->text, value, number)
                 : NULL;
  qn_project_text_free (before);
  qn_project_text_free (after);
  return path;
}

gboolean
qn_document_edit_extra (QnDocument *self, const char *name, const char *key,
                        const char *member, const char *json, GError **error)
{
  QnProject draft;
  if (!qn_project_copy (&self->project, &draft, error))
    return FALSE;
  if (qn_project_set_extra (&draft, member, json, error))
    return step_to (self, name, key, &draft, error);
  qn_project_clear (&draft);
  return FALSE;
}

gboolean
qn_document_go_to (QnDocument *self, guint position)
{
  QnProject project;
  g_autoptr (GError) error = NULL;
  char *text = qn_history_go_to (self->history, self->text->text, position);
  if (text == NULL)
    return FALSE;
  if (!parse (text, name_in_messages (self), &project, &error)) {
    /* The text was written from a state. */
    g_critical ("history: %s", error->message);
    g_free (text);
    return FALSE;
  }
  QnProjectText *state = g_new0 (QnProjectText, 1);
  state->text = text;
  state->length = strlen (text);
  gboolean done = adopt (self, &project, state, NULL);
  g_signal_emit_by_name (self, "history-changed");
  return done;
}

gboolean
qn_document_undo (QnDocument *self)
{
  return qn_document_go_to (self, self->history->position - 1);
}

gboolean
qn_document_redo (QnDocument *self)
{
  return qn_document_go_to (self, self->history->position + 1);
}
