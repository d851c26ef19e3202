#include "io/exchange/drawing.h"
#include "io/exchange/svg-path.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>

gboolean
qn_hybridfem_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
                     GError **error)
{
  g_autofree char *copy = g_strndup (text, length);
  g_auto (GStrv) lines = g_strsplit (copy, "\n", -1);
  drawing->unit = 1;
  for (guint i = 0; lines[i] != NULL; i++) {
    const char *line = g_strstrip (lines[i]);
    if (g_ascii_strncasecmp (line, "FE", 2) == 0)
      qn_drawing_note (drawing, _ ("finite elements left out"), i + 1);
    if (g_ascii_strncasecmp (line, "Box", 3) != 0)
      continue;
    guint box = i + 1;
    do
      i++;
    while (lines[i] != NULL && g_strstrip (lines[i])[0] == '\0');
    /* "[0, 0], [1, 0.5]" has numbers in pairs, as the points of a polygon in SVG. */
    QnSvgPen pen = { .drawing = drawing, .layer = "BLOCKS", .line = box };
    if (lines[i] == NULL
        || !qn_svg_read_points (&pen, g_strdelimit (lines[i], "[]()", ' '), TRUE)
        || pen.path == NULL || pen.path->count < 3)
      return qn_io_fail (
        error, QN_IO_ERROR_INVALID,
        _ ("%s:%u: expected the vertices of a box: [x, y], [x, y], [x, y] …"), name,
        lines[i] == NULL ? i : i + 1);
  }
  return drawing->paths->len > 0
         || qn_io_fail (error, QN_IO_ERROR_INVALID,
                        _ ("%s:1: neither DXF, SVG, COMPAS nor text with boxes"), name);
}
