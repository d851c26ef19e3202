#include "io/text/file-read.h"

#include "io/text/io-error.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
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
