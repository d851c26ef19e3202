/* Reading a whole file into memory. */
#pragma once

#include <glib.h>

/* Largest file that is read; largest input from a pipe or
 * a device, which have no size. */
#define QN_FILE_READ_LIMIT   ((gsize) 2 << 30)
#define QN_STREAM_READ_LIMIT ((gsize) 128 << 20)

/* The bytes of a file (or of a pipe; "-" is standard input), with a NUL byte behind them that
 * `length` does not count. Free with g_free(). NULL with an error in the domain QN_IO_ERROR,
 * code FILE, for a file that is missing, unreadable, a folder or too large. */
char *qn_file_read (const char *path, gsize *length, GError **error);

/* The text in UTF-8 with ends of lines "\n", whatever they were, and a NUL byte that `length` does
 * not count. Its encoding is that of its byte order mark (UTF-8, UTF-16); without one UTF-8 where
 * the bytes are that, else `charset` (NULL: Windows' for western Europe). Invalid bytes
 * become replacement characters. */
char *qn_text_decode (const char *bytes, gsize size, const char *charset, gsize *length);

/* Path of `file`, which is relative to `folder` unless it is absolute. It need not exist yet. NULL
 * with QN_IO_ERROR_OUTSIDE where it lies outside the folder and that is not allowed, and with
 * QN_IO_ERROR_FILE where it is a pipe or a device, which is not allowed either. `folder` NULL:
 * the project has no place yet, and only absolute paths are allowed. Free with g_free(). */
char *qn_file_inside (const char *folder, const char *file, gboolean allow_outside,
                      GError **error);
