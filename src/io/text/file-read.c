#include "io/text/file-read.h"

#include "io/text/io-error.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Reads to the end of the file; 0 or an errno. */
static int
read_all (int descriptor, GByteArray *bytes)
{
  struct stat status;
  if (fstat (descriptor, &status) != 0)
    return errno;
  if (S_ISDIR (status.st_mode))
    return EISDIR;

  /* A regular file is read in one piece, anything else in pieces of this size. */
  gsize piece = 1 << 16, most = QN_STREAM_READ_LIMIT;
  if (S_ISREG (status.st_mode) && status.st_size > 0) {
    most = QN_FILE_READ_LIMIT - 2;
    if ((guint64) status.st_size > most)
      return EFBIG;
    piece = (gsize) status.st_size + 1;
  }

  for (;;) {
    gsize used = bytes->len;
    if (used + piece > most)
      return EFBIG;
    g_byte_array_set_size (bytes, (guint) (used + piece));
    gssize count = read (descriptor, bytes->data + used, piece);
    g_byte_array_set_size (bytes, (guint) (used + (gsize) MAX (count, 0)));
    if (count == 0)
      return 0;
    if (count < 0 && errno != EINTR)
      return errno;
    piece = 1 << 16;
  }
}

char *
qn_file_read (const char *path, gsize *length, GError **error)
{
  gboolean standard_input = strcmp (path, "-") == 0;
  int descriptor = standard_input ? STDIN_FILENO : open (path, O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    qn_io_error_set_errno (error, path, _ ("cannot be opened"), errno);
    return NULL;
  }

  GByteArray *bytes = g_byte_array_new ();
  int trouble = read_all (descriptor, bytes);
  if (!standard_input)
    close (descriptor);
  if (trouble != 0) {
    qn_io_error_set_errno (error, path, _ ("cannot be read"), trouble);
    g_byte_array_unref (bytes);
    return NULL;
  }

  *length = bytes->len;
  g_byte_array_append (bytes, (const guint8 *) "", 1);
  return (char *) g_byte_array_free (bytes, FALSE);
}

static gboolean
begins (const char *bytes, gsize size, const char *mark, gsize length)
{
  return size >= length && memcmp (bytes, mark, length) == 0;
}

char *
qn_text_decode (const char *bytes, gsize size, const char *charset, gsize *length)
{
  gsize mark = begins (bytes, size, "\xef\xbb\xbf", 3) ? 3 : 0;
  const char *from = begins (bytes, size, "\xff\xfe", 2)   ? "UTF-16LE"
                     : begins (bytes, size, "\xfe\xff", 2) ? "UTF-16BE"
                                                           : NULL;
  if (from != NULL)
    mark = 2;
  else if (!g_utf8_validate_len (bytes + mark, size - mark, NULL))
    from = charset != NULL ? charset : "WINDOWS-1252";
  bytes += mark;
  size -= mark;
  char *text = from != NULL
                 ? g_convert (bytes, (gssize) size, "UTF-8", from, NULL, length, NULL)
                 : NULL;
  if (text == NULL) {
    text = g_utf8_make_valid (bytes, (gssize) size);
    *length = strlen (text);
  }
  /* "\r\n" and "\r" become "\n". */
  gsize kept = 0;
  for (gsize i = 0; i < *length; i++)
    if (text[i] != '\r')
      text[kept++] = text[i];
    else if (text[i + 1] != '\n')
      text[kept++] = '\n';
  text[kept] = '\0';
  *length = kept;
  return text;
}

/* Where a path leads when all symbolic links are followed; NULL where that cannot be decided. */
static char *
resolve (const char *path)
{
  char *real = realpath (path, NULL), *own = g_strdup (real);
  free (real);
  return own;
}

/* A file that does not exist yet is where its folder is. A link without a target may lead anywhere, and so
 * may a folder that does not exist. */
static gboolean
is_inside (const char *folder, const char *path)
{
  g_autofree char *base = resolve (folder), *real = resolve (path);
  g_autofree char *parent = g_path_get_dirname (path), *name = g_path_get_basename (path);
  if (real == NULL && !g_file_test (path, G_FILE_TEST_IS_SYMLINK)
      && strcmp (name, "..") != 0 && strcmp (name, ".") != 0) {
    g_autofree char *above = resolve (parent);
    real = above != NULL ? g_build_filename (above, name, NULL) : NULL;
  }
  g_autofree char *inside = base != NULL ? g_build_filename (base, "/", NULL) : NULL;
  return inside != NULL && real != NULL && g_str_has_prefix (real, inside);
}

/* A pipe or a device: to open one may take for ever. */
static gboolean
is_stream (const char *path)
{
  struct stat status;
  return stat (path, &status) == 0 && !S_ISREG (status.st_mode)
         && !S_ISDIR (status.st_mode);
}

char *
qn_file_inside (const char *folder, const char *file, gboolean allow_outside,
                GError **error)
{
  g_autofree char *path = folder == NULL || g_path_is_absolute (file)
                            ? g_strdup (file)
                            : g_build_filename (folder, file, NULL);
  g_autofree char *parent = g_path_get_dirname (path);
  gboolean inside = folder != NULL && is_inside (folder, path);
  if (!allow_outside && folder != NULL && !inside
      && !g_file_test (parent, G_FILE_TEST_EXISTS)) {
    qn_io_error_set_errno (error, path, _ ("cannot be opened"), ENOENT);
    return NULL;
  }
  if (allow_outside || (inside && !is_stream (path)))
    return g_steal_pointer (&path);
  g_autofree char *shown = g_filename_display_name (file);
  g_autofree char *line = g_strescape (shown, "\"");
  g_set_error (
    error, QN_IO_ERROR, inside ? QN_IO_ERROR_FILE : QN_IO_ERROR_OUTSIDE,
    inside ? _ ("%s: the project names this file, which is a pipe or a device")
           : _ ("%s: the project names this file, which is outside the project's folder"),
    line);
  return NULL;
}
