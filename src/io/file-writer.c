#include "io/file-writer.h"

#include "io/io-error.h"
#include "io/json-text.h"
#include "io/number-text.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define BUFFER_SIZE (1 << 16)

struct QnFileWriter {
  char *name;      /* for messages */
  char *target;    /* what the temporary file is renamed to; NULL when written directly */
  char *temporary; /* NULL when written directly */
  int descriptor;
  int trouble; /* errno of the first failure, 0 while all is well */
  GString *buffer;
};

/* The file that a path leads to through symbolic links, so that a rename replaces the file and
 * not the link; the path itself where there is no file yet. Free with g_free(). */
static char *
resolve (const char *path)
{
  char *real = realpath (path, NULL);
  char *resolved = g_strdup (real != NULL ? real : path);
  free (real);
  return resolved;
}

/* Opens a temporary file beside the target with the mode the target has or would get. */
static gboolean
open_temporary (QnFileWriter *writer, const struct stat *existing)
{
  char *folder = g_path_get_dirname (writer->target);
  char *base = g_path_get_basename (writer->target);
  /* A long name leaves no room for the suffix in the file system's limit of 255 bytes. */
  writer->temporary = g_strdup_printf ("%s/.%.200s.XXXXXX", folder, base);
  g_free (folder);
  g_free (base);

  writer->descriptor = g_mkstemp_full (writer->temporary, O_RDWR | O_CLOEXEC, 0666);
  if (writer->descriptor < 0)
    return FALSE;
  /* Where the mode cannot be carried over, the new file has that of a new file. */
  if (existing != NULL && fchmod (writer->descriptor, existing->st_mode & 07777) != 0)
    errno = 0;
  return TRUE;
}

static gboolean
open_target (QnFileWriter *writer, const char *path)
{
  if (strcmp (path, "-") == 0) {
    writer->descriptor = STDOUT_FILENO;
    return TRUE;
  }

  struct stat status;
  gboolean exists = stat (path, &status) == 0;
  if (exists && S_ISDIR (status.st_mode)) {
    errno = EISDIR;
    return FALSE;
  }
  if (exists && !S_ISREG (status.st_mode)) {
    writer->descriptor = open (path, O_WRONLY | O_CLOEXEC);
    return writer->descriptor >= 0;
  }
  /* Renaming over a write-protected file would succeed, but is not what was asked for. */
  if (exists && access (path, W_OK) != 0)
    return FALSE;
  writer->target = resolve (path);
  return open_temporary (writer, exists ? &status : NULL);
}

static void
writer_free (QnFileWriter *writer)
{
  g_free (writer->name);
  g_free (writer->target);
  g_free (writer->temporary);
  g_string_free (writer->buffer, TRUE);
  g_free (writer);
}

QnFileWriter *
qn_file_writer_open (const char *path, GError **error)
{
  QnFileWriter *writer = g_new0 (QnFileWriter, 1);
  writer->name = g_strdup (path);
  writer->buffer = g_string_sized_new (BUFFER_SIZE + 1024);
  if (open_target (writer, path))
    return writer;

  qn_io_error_set_errno (error, path, _ ("cannot be written"), errno);
  writer_free (writer);
  return NULL;
}

static void
flush (QnFileWriter *writer)
{
  const char *bytes = writer->buffer->str;
  gsize left = writer->buffer->len;
  while (left > 0 && writer->trouble == 0) {
    gssize count = write (writer->descriptor, bytes, left);
    if (count >= 0) {
      bytes += count;
      left -= (gsize) count;
    } else if (errno != EINTR) {
      writer->trouble = errno;
    }
  }
  g_string_truncate (writer->buffer, 0);
}

static inline void
flush_when_full (QnFileWriter *writer)
{
  if (writer->buffer->len >= BUFFER_SIZE)
    flush (writer);
}

void
qn_file_writer_write (QnFileWriter *writer, const char *bytes, gsize length)
{
  g_string_append_len (writer->buffer, bytes, (gssize) length);
  flush_when_full (writer);
}

void
qn_file_writer_puts (QnFileWriter *writer, const char *text)
{
  qn_file_writer_write (writer, text, strlen (text));
}

void
qn_file_writer_printf (QnFileWriter *writer, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_string_append_vprintf (writer->buffer, format, arguments);
  va_end (arguments);
  flush_when_full (writer);
}

void
qn_file_writer_number (QnFileWriter *writer, double number)
{
  char text[QN_NUMBER_TEXT_SIZE];
  qn_file_writer_puts (writer, qn_number_text (number, text));
}

void
qn_file_writer_json_string (QnFileWriter *writer, const char *text)
{
  qn_json_append_string (writer->buffer, text);
  flush_when_full (writer);
}

gboolean
qn_file_writer_failed (const QnFileWriter *writer)
{
  return writer->trouble != 0;
}

/* Puts the temporary file in the target's place, with its bytes on the disk first. */
static void
replace_target (QnFileWriter *writer)
{
  if (writer->trouble == 0 && fsync (writer->descriptor) != 0)
    writer->trouble = errno;
  if (close (writer->descriptor) != 0 && writer->trouble == 0)
    writer->trouble = errno;
  if (writer->trouble == 0 && g_rename (writer->temporary, writer->target) != 0)
    writer->trouble = errno;
  if (writer->trouble != 0)
    g_unlink (writer->temporary);
}

gboolean
qn_file_writer_commit (QnFileWriter *writer, GError **error)
{
  flush (writer);
  if (writer->temporary != NULL)
    replace_target (writer);
  else if (writer->descriptor != STDOUT_FILENO && close (writer->descriptor) != 0
           && writer->trouble == 0)
    writer->trouble = errno;

  gboolean done = writer->trouble == 0;
  if (!done)
    qn_io_error_set_errno (error, writer->name, _ ("cannot be written"), writer->trouble);
  writer_free (writer);
  return done;
}

void
qn_file_writer_discard (QnFileWriter *writer)
{
  if (writer == NULL)
    return;
  if (writer->descriptor != STDOUT_FILENO)
    close (writer->descriptor);
  if (writer->temporary != NULL)
    g_unlink (writer->temporary);
  writer_free (writer);
}

gboolean
qn_file_write (const char *path, const char *bytes, gsize length, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_write (writer, bytes, length);
  return qn_file_writer_commit (writer, error);
}
