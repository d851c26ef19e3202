#include "doc/document/recovery.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#define DELAY_SECONDS 2

struct QnRecovery {
  QnDocument *document;
  char *path;
  int lock; /* descriptor of the file there, locked; -1: none yet */
  guint timeout;
};

char *
qn_recovery_dup_folder (void)
{
  return g_build_filename (g_get_user_state_dir (), "quoin", "recovery", NULL);
}

/* The descriptor of a file that is locked for us, until it is closed or the program ends however it
 * ends; -1 where another one has the lock. */
static int
lock_file (const char *path)
{
  int fd = g_open (path, O_RDONLY | O_CLOEXEC, 0);
  if (fd >= 0 && flock (fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close (fd);
    fd = -1;
  }
  return fd;
}

/* First line: the file it belongs to, escaped; then the text. It is locked before it has its name, so
 * that whoever lists the folder sees that it is in use. */
static gboolean
write_file (QnRecovery *recovery)
{
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autofree char *fresh = g_strconcat (recovery->path, ".new", NULL);
  const char *original = recovery->document->path;
  g_autofree char *escaped = g_strescape (original != NULL ? original : "", NULL);
  g_autofree char *content =
    g_strdup_printf ("%s\n%s", escaped, recovery->document->text->text);
  g_autoptr (GError) error = NULL;
  if (g_mkdir_with_parents (folder, 0700) != 0
      || !g_file_set_contents (fresh, content, -1, &error)) {
    g_info ("recovery file not written: %s",
            error != NULL ? error->message : g_strerror (errno));
    return FALSE;
  }
  int before = recovery->lock;
  recovery->lock = lock_file (fresh);
  gboolean written = g_rename (fresh, recovery->path) == 0;
  if (before >= 0)
    close (before);
  return written;
}

static gboolean
on_timeout (gpointer data)
{
  QnRecovery *recovery = data;
  recovery->timeout = 0;
  write_file (recovery);
  return G_SOURCE_REMOVE;
}

static void
on_history_changed (QnDocument *document, gpointer data)
{
  QnRecovery *recovery = data;
  g_clear_handle_id (&recovery->timeout, g_source_remove);
  if (qn_document_is_modified (document))
    recovery->timeout = g_timeout_add_seconds (DELAY_SECONDS, on_timeout, recovery);
  else
    g_unlink (recovery->path);
}

QnRecovery *
qn_recovery_watch (QnDocument *document)
{
  QnRecovery *recovery = g_new0 (QnRecovery, 1);
  recovery->document = g_object_ref (document);
  recovery->lock = -1;
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autofree char *unique = g_uuid_string_random ();
  g_autofree char *name = g_strconcat (unique, ".recovery", NULL);
  recovery->path = g_build_filename (folder, name, NULL);
  g_signal_connect (document, "history-changed", G_CALLBACK (on_history_changed),
                    recovery);
  return recovery;
}

gboolean
qn_recovery_flush (QnRecovery *recovery)
{
  if (recovery->timeout == 0)
    return TRUE;
  g_clear_handle_id (&recovery->timeout, g_source_remove);
  return write_file (recovery);
}

void
qn_recovery_end (QnRecovery *recovery)
{
  if (recovery == NULL)
    return;
  g_clear_handle_id (&recovery->timeout, g_source_remove);
  g_signal_handlers_disconnect_by_data (recovery->document, recovery);
  g_unlink (recovery->path);
  if (recovery->lock >= 0)
    close (recovery->lock);
  g_object_unref (recovery->document);
  g_free (recovery->path);
  g_free (recovery);
}

/* Whether a program that runs has it. Process numbers would not tell: in a sandbox every program has
 * the same. */
static gboolean
is_in_use (const char *path)
{
  int fd = lock_file (path);
  if (fd >= 0)
    close (fd);
  return fd < 0;
}

GPtrArray *
qn_recovery_list (void)
{
  GPtrArray *paths = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *name;
  while (dir != NULL && (name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL);
    if (g_str_has_suffix (name, ".recovery") && !is_in_use (path))
      g_ptr_array_add (paths, g_steal_pointer (&path));
  }
  return paths;
}

gboolean
qn_recovery_read (const char *recovery_path, char **text, char **original, GError **error)
{
  g_autofree char *content = NULL;
  if (!g_file_get_contents (recovery_path, &content, NULL, error))
    return FALSE;
  char *newline = strchr (content, '\n');
  if (newline != NULL)
    *newline = '\0';
  g_autofree char *file = g_strcompress (content);
  *original = *file != '\0' ? g_steal_pointer (&file) : NULL;
  *text = g_strdup (newline != NULL ? newline + 1 : "");
  return TRUE;
}
