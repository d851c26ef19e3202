/* Reading a whole file into memory. */
#pragma once

#include <glib.h>

/* Largest file that is read; and how much is read of what has no size, a pipe or a device that may
 * never end. */
#define QN_FILE_READ_LIMIT   ((gsize) 2 << 30)
#define QN_STREAM_READ_LIMIT ((gsize) 128 << 20)

/* The bytes of a file (or of a pipe; "-" is standard input), with a NUL byte behind them that
 * `length` does not count. Free with g_free(). NULL with an error in the domain QN_IO_ERROR,
 * code FILE, for what is missing, unreadable, a folder or too large. */
char *qn_file_read (const char *path, gsize *length, GError **error);
