/* Writing a file as a whole or not at all. */
#include "render/output.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>
#include <unistd.h>

static void
set_write_error (GError **error, const char *path, int code)
{
  g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
               _ ("%s: cannot be written: %s"), path, g_strerror (code));
}

/* Writes everything to a descriptor and closes it where it is not standard output. */
static bool
write_all (int fd, const char *data, size_t length)
{
  while (length > 0) {
    ssize_t n = write (fd, data, length);
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0)
      return false;
    data += n;
    length -= (size_t) n;
  }
  return true;
}

static bool
write_directly (const char *path, const void *data, size_t length, GError **error)
{
  bool to_stdout = g_str_equal (path, "-");
  int fd = to_stdout ? STDOUT_FILENO : g_open (path, O_WRONLY | O_CLOEXEC, 0);
  bool done = fd >= 0 && write_all (fd, data, length);
  int code = errno;
  if (fd >= 0 && !to_stdout && close (fd) != 0 && done) {
    done = false;
    code = errno;
  }
  if (!done)
    set_write_error (error, to_stdout ? _ ("standard output") : path, code);
  return done;
}

bool
qn_file_replace (const char *path, const void *data, size_t length, GError **error)
{
  GStatBuf info;
  bool exists = !g_str_equal (path, "-") && g_stat (path, &info) == 0;
  if (exists && S_ISDIR (info.st_mode)) {
    set_write_error (error, path, EISDIR);
    return false;
  }
  /* A device or pipe has no old content to keep and must not be replaced by a file. */
  if (g_str_equal (path, "-") || (exists && !S_ISREG (info.st_mode)))
    return write_directly (path, data, length, error);
  if (exists && g_access (path, W_OK) != 0) {
    set_write_error (error, path, errno);
    return false;
  }

  /* The target of a symbolic link is replaced, not the link. */
  g_autofree char *target = exists ? realpath (path, NULL) : g_strdup (path);
  g_autoptr (GError) cause = NULL;
  if (!g_file_set_contents_full (target != NULL ? target : path, data, (gssize) length,
                                 G_FILE_SET_CONTENTS_CONSISTENT, 0666, &cause)) {
    int code = g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_NOSPC)    ? ENOSPC
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_NOENT)  ? ENOENT
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_ACCES)  ? EACCES
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_NOTDIR) ? ENOTDIR
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_ROFS)   ? EROFS
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_PERM)   ? EPERM
               : g_error_matches (cause, G_FILE_ERROR, G_FILE_ERROR_NAMETOOLONG)
                 ? ENAMETOOLONG
                 : EIO;
    set_write_error (error, path, code);
    return false;
  }
  return true;
}
