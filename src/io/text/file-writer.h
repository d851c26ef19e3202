/* Writing a file whole or not at all, whatever fails; "-",
 * devices and pipes: see disk/whole-file.h.
 *
 *   QnFileWriter *writer = qn_file_writer_open (path);
 *   qn_file_writer_puts (writer, "…");
 *   return qn_file_writer_commit (writer, &error);
 *
 * The first error is kept and reported by the commit: callers need no checks before.
 */
#pragma once

#include "core/base/vec2.h"

#include <glib.h>

typedef struct QnFileWriter QnFileWriter;

/* Where the target cannot be written, the commit says so. */
QnFileWriter *qn_file_writer_open (const char *path);

/* The same for a file that messages call by another name; with an errno, one that cannot be written. */
QnFileWriter *qn_file_writer_open_as (const char *path, const char *name, int trouble);

/* Writes into memory instead: ended by qn_file_writer_steal(), which frees the writer and returns the
 * text, NUL-terminated; free with g_free(). */
QnFileWriter *qn_file_writer_new_in_memory (void);
char *qn_file_writer_steal (QnFileWriter *writer, gsize *length);

/* Append. The first error is kept until the commit, which reports it. */
void qn_file_writer_write (QnFileWriter *writer, const char *bytes, gsize length);
void qn_file_writer_puts (QnFileWriter *writer, const char *text);
void qn_file_writer_printf (QnFileWriter *writer, const char *format, ...)
  G_GNUC_PRINTF (2, 3);

/* The shortest decimal text that reads back as the same double; see text-format.h. Or rounded by a printf
 * format. A number that is not finite is an error, EDOM: the file is not written. */
void qn_file_writer_number (QnFileWriter *writer, double number);
void qn_file_writer_rounded (QnFileWriter *writer, double number, const char *format);

/* A text, and the number behind it. */
void qn_file_writer_puts_number (QnFileWriter *writer, const char *text, double number);

/* A field of a table in quotes, which are doubled within. */
void qn_file_writer_quoted (QnFileWriter *writer, const char *text);

/* JSON by a format of values that the compiler checks: %s a string, with its quotes, or null; %g a number,
 * refused where it is not finite, and %f one that is null then; %d and %zu whole numbers; %i true or
 * false. A comma that the format begins with is left out behind an opening bracket. */
void qn_file_writer_json (QnFileWriter *writer, const char *format, ...)
  G_GNUC_PRINTF (2, 3);

/* The same of a table: %s is a field, in quotes where it would be taken for several, and without characters
 * that are commands of a terminal. */
void qn_file_writer_csv (QnFileWriter *writer, const char *format, ...)
  G_GNUC_PRINTF (2, 3);

/* The buffer of text not yet written to the file, to append to. */
GString *qn_file_writer_buffer (QnFileWriter *writer);

/* Keeps an error, as an errno. */
void qn_file_writer_fail (QnFileWriter *writer, int error_number);

/* Whether an error has occurred: a long writing loop may stop early. */
gboolean qn_file_writer_failed (const QnFileWriter *writer);

/* Completes the file and frees the writer. On failure the target is as it was before. */
gboolean qn_file_writer_commit (QnFileWriter *writer, GError **error);

/* All of it at once. */
gboolean qn_file_write (const char *path, const char *bytes, gsize length,
                        GError **error);

/* Whether a file could be written; leaves it as it is. */
gboolean qn_file_can_be_written (const char *path, GError **error);
