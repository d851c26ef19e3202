/* Files that a project names: pictures behind the drawing, results and pictures of figures.
 *
 * A project may come from anywhere. What it names stays inside the project's folder, symbolic links
 * followed, unless the user allows more.
 */
#pragma once

#include <glib.h>

/* Path of `file`, which is relative to `folder` unless it is absolute. It need not exist yet. NULL
 * with QN_IO_ERROR_OUTSIDE where it lies outside the folder and that is not allowed, and with
 * QN_IO_ERROR_FILE where it is a pipe or a device, which is not allowed either. `folder` NULL:
 * the project has no place yet, and only absolute paths name anything. Free with g_free(). */
char *qn_file_inside (const char *folder, const char *file, gboolean allow_outside,
                      GError **error);
