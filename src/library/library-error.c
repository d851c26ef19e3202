#include "io/text/io-error.h"
#include "library/library-private.h"
#include "render/drawing/render-error.h"

#include <string.h>

struct QuoinError {
  QuoinErrorKind kind;
  char *message, *file, *key;
  int line, column;
};

const char *
quoin_version (void)
{
  return QN_VERSION;
}

void
quoin_free (void *memory)
{
  g_free (memory);
}

static QuoinErrorKind
kind_of (const GError *cause)
{
  if (g_error_matches (cause, QN_IO_ERROR, QN_IO_ERROR_INVALID))
    return QUOIN_ERROR_INVALID;
  if (g_error_matches (cause, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE)
      || g_error_matches (cause, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE)
      || g_error_matches (cause, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE))
    return QUOIN_ERROR_USAGE;
  if (g_error_matches (cause, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY)
      || g_error_matches (cause, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED))
    return QUOIN_ERROR_NO_MEMORY;
  return QUOIN_ERROR_FILE;
}

/* ":12:7: blocks[3].vertices: " behind the name of the file. A key path has no spaces. */
static void
read_place (QuoinError *error, const char *place)
{
  char *end;
  if (*place != ':')
    return;
  gint64 line = g_ascii_strtoll (place + 1, &end, 10);
  if (end != place + 1 && *end == ':') {
    const char *start = end + 1;
    gint64 column = g_ascii_strtoll (start, &end, 10);
    if (end == start || *end != ':' || line > G_MAXINT || column > G_MAXINT)
      return;
    error->line = (int) line;
    error->column = (int) column;
    place = end;
  }
  place += strspn (place, ": ");
  const char *colon = strstr (place, ": ");
  if (colon != NULL && memchr (place, ' ', (size_t) (colon - place)) == NULL)
    error->key = g_strndup (place, (gsize) (colon - place));
}

void *
quoin_library_take_error (QuoinError **error, const char *name, GError *cause)
{
  if (error != NULL && *error == NULL) {
    QuoinError *made = g_new0 (QuoinError, 1);
    made->kind = kind_of (cause);
    made->message = g_strdup (cause->message);
    if (name != NULL && g_str_has_prefix (cause->message, name)) {
      made->file = g_strdup (name);
      read_place (made, cause->message + strlen (name));
    }
    *error = made;
  }
  g_error_free (cause);
  return NULL;
}

void *
quoin_library_take_diag (QuoinError **error, const QnProject *project, const QnDiag *diag)
{
  GError *cause = NULL;
  if (qn_problem_is_of_state (diag->problem))
    return quoin_library_set_error (error, QUOIN_ERROR_NO_ANSWER, "%s: %s", project->name,
                                    qn_problem_text (diag->problem));
  qn_project_set_error (project, diag, &cause);
  return quoin_library_take_error (error, project->name, cause);
}

void *
quoin_library_set_error (QuoinError **error, QuoinErrorKind kind, const char *format, ...)
{
  if (error == NULL || *error != NULL)
    return NULL;
  va_list arguments;
  va_start (arguments, format);
  *error = g_new0 (QuoinError, 1);
  (*error)->kind = kind;
  (*error)->message = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  return NULL;
}

bool
quoin_library_given (const void *argument, const char *name, QuoinError **error)
{
  if (argument == NULL)
    quoin_library_set_error (error, QUOIN_ERROR_USAGE, "%s is NULL", name);
  return argument != NULL;
}

QUOIN_GET (QuoinErrorKind, quoin_error_get_kind, QuoinError, QUOIN_ERROR_USAGE, of->kind)
QUOIN_GET (const char *, quoin_error_get_message, QuoinError, NULL, of->message)
QUOIN_GET (const char *, quoin_error_get_file, QuoinError, NULL, of->file)
QUOIN_GET (int, quoin_error_get_line, QuoinError, 0, of->line)
QUOIN_GET (int, quoin_error_get_column, QuoinError, 0, of->column)
QUOIN_GET (const char *, quoin_error_get_key, QuoinError, NULL, of->key)

void
quoin_error_free (QuoinError *error)
{
  if (error == NULL)
    return;
  g_free (error->message);
  g_free (error->file);
  g_free (error->key);
  g_free (error);
}
