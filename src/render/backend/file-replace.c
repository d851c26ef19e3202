/* Writing a file as a whole or not at all. */
#include "disk/whole-file.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>

bool
qn_file_replace (const char *path, const void *data, size_t length, GError **error)
{
  int trouble = qn_whole_file_replace (path, data, length);

  if (trouble != 0)
    g_set_error (
      error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE, _ ("%s: cannot be written: %s"),
      g_str_equal (path, "-") ? _ ("standard output") : path, g_strerror (trouble));
  return trouble == 0;
}
