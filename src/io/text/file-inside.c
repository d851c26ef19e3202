#include "io/text/file-inside.h"

#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Where a path leads when all symbolic links are followed; of a file that does not exist yet, what
 * its folder's path leads to with the name behind. NULL where that cannot be decided: a link
 * without a target, a folder that does not exist. */
static char *
resolve (const char *path)
{
  char *real = realpath (path, NULL);
  if (real != NULL || g_file_test (path, G_FILE_TEST_IS_SYMLINK))
    return real;
  g_autofree char *name = g_path_get_basename (path);
  g_autofree char *parent = g_path_get_dirname (path);
  char *folder = realpath (parent, NULL);
  if (folder == NULL || strcmp (name, "..") == 0 || strcmp (name, ".") == 0) {
    free (folder);
    return NULL;
  }
  char *whole = g_build_filename (folder, name, NULL);
  free (folder);
  return whole;
}

static gboolean
is_inside (const char *folder, const char *path)
{
  char *base = realpath (folder, NULL), *real = resolve (path);
  gsize length = base != NULL ? strlen (base) : 0;
  while (length > 0 && base[length - 1] == G_DIR_SEPARATOR) /* of the root */
    length--;
  gboolean inside = base != NULL && real != NULL && strncmp (base, real, length) == 0
                    && real[length] == G_DIR_SEPARATOR;
  free (base);
  free (real);
  return inside;
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
