#include "io/json/json-stream.h"

#include "core/base/integer.h"
#include "io/json/json-locate.h"
#include "io/json/json-path.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>

void
qn_json_stream_init (QnJsonStream *stream, const char *text, gsize length,
                     const char *name)
{
  *stream = (QnJsonStream){ .name = name };
  qn_json_scanner_init (&stream->scanner, text, length);
}

/* Records an error unless there is one; the path may be empty. */
static gboolean
fail_at (QnJsonStream *stream, gsize offset, const char *path, const char *message)
{
  if (stream->error != NULL)
    return FALSE;
  gsize line, column;
  qn_json_position (stream->scanner.text, offset, &line, &column);
  stream->error =
    g_error_new (QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 "%s:%" G_GSIZE_FORMAT ":%" G_GSIZE_FORMAT ": %s%s%s", stream->name, line,
                 column, path, path[0] != '\0' ? ": " : "", message);
  return FALSE;
}

gboolean
qn_json_stream_fail (QnJsonStream *stream, const char *message)
{
  GString *path = g_string_new (NULL);
  for (guint i = 0; i < stream->depth; i++) {
    if (stream->steps[i].key != NULL)
      qn_json_path_append_key (path, stream->steps[i].key);
    else
      qn_json_path_append_index (path, stream->steps[i].index);
  }
  /* What the text itself does wrong comes before what we think of its values. */
  const QnJsonScanner *scanner = &stream->scanner;
  fail_at (stream, scanner->start, path->str,
           scanner->token == QN_JSON_ERROR ? scanner->problem : message);
  g_string_free (path, TRUE);
  return FALSE;
}

gboolean
qn_json_stream_fail_at (QnJsonStream *stream, const char *path, const char *message)
{
  gsize offset = qn_json_locate (stream->scanner.text, stream->scanner.length, path);
  return fail_at (stream, offset, path, message);
}

gboolean
qn_json_stream_no_memory (QnJsonStream *stream)
{
  if (stream->error == NULL)
    stream->error = g_error_new (QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s",
                                 stream->name, _ ("not enough memory"));
  return FALSE;
}

gboolean
qn_json_stream_document (QnJsonStream *stream, QnJsonReadFunc read, gpointer target)
{
  qn_json_next (&stream->scanner);
  return read (stream, target)
         && (qn_json_next (&stream->scanner) == QN_JSON_END
             || qn_json_stream_fail (stream, stream->scanner.problem));
}

/* Reads the value behind the current key with the member that it names. */
static gboolean
read_member (QnJsonStream *stream, const QnJsonMember *members, guint count,
             guint64 *seen, gpointer target)
{
  guint i = 0;
  while (i < count && !qn_json_string_is (&stream->scanner, members[i].key))
    i++;
  if (i == count) {
    qn_json_next (&stream->scanner);
    return qn_json_skip (&stream->scanner) || qn_json_stream_fail (stream, NULL);
  }

  gpointer place = (char *) target + members[i].offset;
  stream->steps[stream->depth++].key = members[i].key;
  gboolean done = FALSE;
  if ((*seen >> i & 1) != 0)
    qn_json_stream_fail (stream, _ ("key is given twice"));
  else if (qn_json_next (&stream->scanner) == QN_JSON_ERROR)
    qn_json_stream_fail (stream, NULL);
  else
    done = (members[i].flags & QN_JSON_EACH) != 0
             ? qn_json_stream_array (stream, members[i].read, place)
             : members[i].read (stream, place);
  *seen |= G_GUINT64_CONSTANT (1) << i;
  stream->depth--;
  return done;
}

gboolean
qn_json_stream_object (QnJsonStream *stream, const QnJsonMember *members, guint count,
                       gpointer target)
{
  g_assert (count <= 64 && stream->depth < QN_JSON_STREAM_DEPTH);
  if (stream->scanner.token != QN_JSON_BEGIN_OBJECT)
    return qn_json_stream_fail (stream, _ ("expected an object"));

  gsize start = stream->scanner.start;
  guint64 seen = 0;
  while (qn_json_next (&stream->scanner) == QN_JSON_KEY)
    if (!read_member (stream, members, count, &seen, target))
      return FALSE;
  if (stream->scanner.token != QN_JSON_END_OBJECT)
    return qn_json_stream_fail (stream, NULL);

  for (guint i = 0; i < count; i++) {
    if ((members[i].flags & QN_JSON_REQUIRED) != 0 && (seen >> i & 1) == 0) {
      stream->scanner.start = start;
      stream->steps[stream->depth++].key = members[i].key;
      qn_json_stream_fail (stream, _ ("required key is missing"));
      stream->depth--;
      return FALSE;
    }
  }
  return TRUE;
}

gboolean
qn_json_stream_array (QnJsonStream *stream, QnJsonReadFunc read, gpointer target)
{
  g_assert (stream->depth < QN_JSON_STREAM_DEPTH);
  if (stream->scanner.token != QN_JSON_BEGIN_ARRAY)
    return qn_json_stream_fail (stream, _ ("expected an array"));

  guint step = stream->depth++;
  stream->steps[step].key = NULL;
  stream->steps[step].index = 0;
  gboolean done = TRUE;
  while (done && qn_json_next (&stream->scanner) != QN_JSON_END_ARRAY) {
    done = stream->scanner.token != QN_JSON_ERROR ? read (stream, target)
                                                  : qn_json_stream_fail (stream, NULL);
    stream->steps[step].index++;
  }
  stream->depth--;
  return done;
}

gboolean
qn_json_stream_numbers (QnJsonStream *stream, double *numbers, gsize count)
{
  if (stream->scanner.token != QN_JSON_BEGIN_ARRAY)
    return qn_json_stream_fail (stream, _ ("expected an array"));
  for (gsize i = 0; i < count; i++) {
    qn_json_next (&stream->scanner);
    if (!qn_json_stream_number (stream, &numbers[i]))
      return FALSE;
  }
  return qn_json_next (&stream->scanner) == QN_JSON_END_ARRAY
         || qn_json_stream_fail (stream, _ ("array has too many elements"));
}

gboolean
qn_json_stream_number (QnJsonStream *stream, gpointer target)
{
  if (stream->scanner.token != QN_JSON_NUMBER)
    return qn_json_stream_fail (stream, _ ("expected a number"));
  double number = qn_json_number (&stream->scanner);
  if (!isfinite (number))
    return qn_json_stream_fail (stream, _ ("number is not finite"));
  *(double *) target = number;
  return TRUE;
}

/* A whole number from 0 to `max`. */
static gboolean
read_whole (QnJsonStream *stream, double max, double *number)
{
  if (!qn_json_stream_number (stream, number))
    return FALSE;
  return (*number >= 0 && *number <= max && *number == floor (*number))
         || qn_json_stream_fail (stream,
                                 _ ("expected a whole number that is not negative"));
}

gboolean
qn_json_stream_int32 (QnJsonStream *stream, gpointer target)
{
  double number;
  if (!read_whole (stream, G_MAXINT32, &number))
    return FALSE;
  *(gint32 *) target = (gint32) qn_to_integer (number, 0, G_MAXINT32);
  return TRUE;
}

gboolean
qn_json_stream_int64 (QnJsonStream *stream, gpointer target)
{
  double number;
  if (!read_whole (stream, 0x1p53, &number))
    return FALSE;
  *(gint64 *) target = qn_to_integer (number, 0, G_MAXINT64);
  return TRUE;
}

gboolean
qn_json_stream_string (QnJsonStream *stream, gpointer target)
{
  if (stream->scanner.token != QN_JSON_STRING)
    return qn_json_stream_fail (stream, _ ("expected a string"));
  char **string = target;
  g_free (*string);
  *string = qn_json_dup_string (&stream->scanner);
  return TRUE;
}
