#include "io/text/file-writer.h"

#include "disk/whole-file.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"
#include "io/text/text-format.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#define BUFFER_SIZE (1 << 16)

struct QnFileWriter {
  char *name; /* for messages; NULL: in memory */
  QnWholeFile file;
  int trouble; /* errno of the first failure, 0 while all is well */
  GString *buffer;
  char last; /* that was handed on */
};

static void
writer_free (QnFileWriter *writer)
{
  g_free (writer->name);
  g_string_free (writer->buffer, TRUE);
  g_free (writer);
}

QnFileWriter *
qn_file_writer_open (const char *path)
{
  return qn_file_writer_open_as (path, path, 0);
}

QnFileWriter *
qn_file_writer_open_as (const char *path, const char *name, int trouble)
{
  QnFileWriter *writer = g_new0 (QnFileWriter, 1);
  writer->name = g_strdup (name);
  writer->buffer = g_string_sized_new (BUFFER_SIZE + 1024);
  writer->file.fd = -1;
  writer->trouble = trouble != 0 ? trouble : qn_whole_file_open (&writer->file, path);
  return writer;
}

QnFileWriter *
qn_file_writer_new_in_memory (void)
{
  QnFileWriter *writer = g_new0 (QnFileWriter, 1);
  writer->buffer = g_string_sized_new (BUFFER_SIZE);
  return writer;
}

char *
qn_file_writer_steal (QnFileWriter *writer, gsize *length)
{
  *length = writer->buffer->len;
  char *text = g_string_free (writer->buffer, FALSE);
  g_free (writer);
  return text;
}

static void
flush (QnFileWriter *writer)
{
  if (writer->buffer->len > 0)
    writer->last = writer->buffer->str[writer->buffer->len - 1];
  if (writer->trouble == 0)
    writer->trouble =
      qn_whole_file_write (&writer->file, writer->buffer->str, writer->buffer->len);
  g_string_truncate (writer->buffer, 0);
}

static inline void
flush_when_full (QnFileWriter *writer)
{
  if (writer->name != NULL && writer->buffer->len >= BUFFER_SIZE)
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
  if (!isfinite (number))
    qn_file_writer_fail (writer, EDOM);
  qn_file_writer_puts (writer, qn_number_text (number, text));
}

void
qn_file_writer_rounded (QnFileWriter *writer, double number, const char *format)
{
  char text[G_ASCII_DTOSTR_BUF_SIZE];
  if (isfinite (number))
    qn_file_writer_puts (writer, g_ascii_formatd (text, sizeof text, format, number));
  else
    qn_file_writer_number (writer, number);
}

void
qn_file_writer_puts_number (QnFileWriter *writer, const char *text, double number)
{
  qn_file_writer_puts (writer, text);
  qn_file_writer_number (writer, number);
}

void
qn_file_writer_quoted (QnFileWriter *writer, const char *text)
{
  qn_file_writer_puts (writer, "\"");
  for (const char *quote; (quote = strchr (text, '"')) != NULL; text = quote + 1) {
    qn_file_writer_write (writer, text, (gsize) (quote - text));
    qn_file_writer_puts (writer, "\"\"");
  }
  qn_file_writer_puts (writer, text);
  qn_file_writer_puts (writer, "\"");
}

/* What a terminal would take for a command, or would turn the direction of the line, becomes U+FFFD. */
static void
put_field (QnFileWriter *writer, const char *name)
{
  g_autoptr (GString) text = g_string_new (NULL);
  for (const char *c = name; *c != '\0'; c = g_utf8_next_char (c)) {
    gunichar at = g_utf8_get_char (c);
    g_string_append_unichar (text, qn_is_plain_character (at) ? at : 0xfffd);
  }
  if (strpbrk (text->str, ",\"\r\n") == NULL)
    qn_file_writer_puts (writer, text->str);
  else
    qn_file_writer_quoted (writer, text->str);
}

static void
put_json (QnFileWriter *writer, const char *text)
{
  if (text != NULL)
    qn_json_append_string (writer->buffer, text);
  else
    qn_file_writer_puts (writer, "null");
}

/* By a format as the header tells, strings in the way of `put`. */
static void
put_values (QnFileWriter *writer, void (*put) (QnFileWriter *writer, const char *text),
            const char *format, va_list values)
{
  for (const char *c; (c = strchr (format, '%')) != NULL; format = c + 1) {
    qn_file_writer_write (writer, format, (gsize) (c - format));
    switch (*++c) {
    case 's':
      put (writer, va_arg (values, const char *));
      break;
    case 'g':
      qn_file_writer_number (writer, va_arg (values, double));
      break;
    case 'f':
      qn_json_append_number (writer->buffer, va_arg (values, double));
      break;
    case 'i':
      qn_file_writer_puts (writer, va_arg (values, int) != 0 ? "true" : "false");
      break;
    case 'd':
      qn_file_writer_printf (writer, "%d", va_arg (values, int));
      break;
    case 'z':
      g_assert (*++c == 'u');
      qn_file_writer_printf (writer, "%zu", va_arg (values, gsize));
      break;
    default:
      g_assert_not_reached ();
    }
  }
  qn_file_writer_puts (writer, format);
}

void
qn_file_writer_json (QnFileWriter *writer, const char *format, ...)
{
  va_list values;
  char last =
    writer->buffer->len > 0 ? writer->buffer->str[writer->buffer->len - 1] : writer->last;
  va_start (values, format);
  put_values (writer, put_json, format + (*format == ',' && last == '['), values);
  va_end (values);
}

void
qn_file_writer_csv (QnFileWriter *writer, const char *format, ...)
{
  va_list values;
  va_start (values, format);
  put_values (writer, put_field, format, values);
  va_end (values);
}

GString *
qn_file_writer_buffer (QnFileWriter *writer)
{
  flush_when_full (writer);
  return writer->buffer;
}

void
qn_file_writer_fail (QnFileWriter *writer, int error_number)
{
  if (writer->trouble == 0)
    writer->trouble = error_number;
}

gboolean
qn_file_writer_failed (const QnFileWriter *writer)
{
  return writer->trouble != 0;
}

gboolean
qn_file_writer_commit (QnFileWriter *writer, GError **error)
{
  flush (writer);
  if (writer->trouble == 0)
    writer->trouble = qn_whole_file_commit (&writer->file);
  else
    qn_whole_file_discard (&writer->file);

  gboolean done = writer->trouble == 0;
  if (!done)
    qn_io_error_set_errno (error, writer->name, _ ("cannot be written"), writer->trouble);
  writer_free (writer);
  return done;
}

gboolean
qn_file_write (const char *path, const char *bytes, gsize length, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_write (writer, bytes, length);
  return qn_file_writer_commit (writer, error);
}

gboolean
qn_file_can_be_written (const char *path, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  const int trouble = writer->trouble;
  qn_whole_file_discard (&writer->file);
  writer_free (writer);
  if (trouble != 0)
    qn_io_error_set_errno (error, path, _ ("cannot be written"), trouble);
  return trouble == 0;
}
