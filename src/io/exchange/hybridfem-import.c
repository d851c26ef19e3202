#include "io/exchange/drawing.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* "[0, 0], [1, 0.5]" into the path; FALSE where that is not what the line says. */
static gboolean
read_vertices (const char *line, QnDrawingPath *path)
{
  double pair[2];
  int have = 0;
  for (const char *c = line; *c != '\0';) {
    if (strchr ("[](), \t", *c) != NULL) {
      c++;
      continue;
    }
    char *end;
    pair[have] = g_ascii_strtod (c, &end);
    if (end == c || !isfinite (pair[have]))
      return FALSE;
    c = end;
    if (++have == 2) {
      qn_drawing_path_add (path, qn_vec2 (pair[0], pair[1]));
      have = 0;
    }
  }
  return have == 0 && path->count >= 3;
}

static gboolean
starts_with (const char *line, const char *word)
{
  return g_ascii_strncasecmp (line, word, strlen (word)) == 0;
}

gboolean
qn_hybridfem_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
                     GError **error)
{
  g_autofree char *copy = g_strndup (text, length);
  g_auto (GStrv) lines = g_strsplit (copy, "\n", -1);
  qn_drawing_init (drawing);
  drawing->unit = 1;
  for (guint i = 0; lines[i] != NULL; i++) {
    const char *line = g_strstrip (lines[i]);
    if (starts_with (line, "FE"))
      qn_drawing_note (drawing, _ ("finite elements left out"), i + 1);
    if (!starts_with (line, "Box"))
      continue;
    guint box = i + 1;
    do
      i++;
    while (lines[i] != NULL && g_strstrip (lines[i])[0] == '\0');
    QnDrawingPath *path = qn_drawing_add_path (drawing, "BLOCKS", box);
    path->closed = TRUE;
    if (lines[i] == NULL || !read_vertices (lines[i], path)) {
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                   _ ("%s:%u: expected the vertices of a box: [x, y], [x, y], [x, y] …"),
                   name, lines[i] == NULL ? i : i + 1);
      qn_drawing_clear (drawing);
      return FALSE;
    }
  }
  if (drawing->paths->len > 0)
    return TRUE;
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
               _ ("%s:1: neither DXF, SVG, COMPAS nor text with boxes"), name);
  qn_drawing_clear (drawing);
  return FALSE;
}
