/* Which reader a file to import needs. */
#include "io/exchange/compas-import.h"
#include "io/exchange/drawing-import.h"
#include "io/exchange/dxf-import.h"
#include "io/exchange/hybridfem-import.h"
#include "io/exchange/svg-import.h"
#include "io/text/file-read.h"

typedef gboolean (*ReadFunc) (const char *text, gsize length, const char *name,
                              QnDrawing *drawing, GError **error);

/* By the ending; where that says nothing, a file with boxes is HybriDFEM's and any other DXF. */
static ReadFunc
reader_of (const char *path, const char *text, gsize length)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  if (g_str_has_suffix (lower, ".svg") || g_str_has_suffix (lower, ".svgz"))
    return qn_svg_import;
  if (g_str_has_suffix (lower, ".json") || g_str_has_suffix (lower, ".obj"))
    return qn_compas_import;
  if (!g_str_has_suffix (lower, ".dxf")
      && g_strstr_len (text, (gssize) length, "Box") != NULL)
    return qn_hybridfem_import;
  return qn_dxf_import;
}

gboolean
qn_import_file (const char *path, const QnImportSettings *settings, QnProject *project,
                QnImportReport *report, GError **error)
{
  gsize length;
  *project = (QnProject){ 0 };
  *report = (QnImportReport){ 0 };
  g_autofree char *text = qn_file_read (path, &length, error);
  if (text == NULL)
    return FALSE;
  QnDrawing drawing;
  if (!reader_of (path, text, length) (text, length, path, &drawing, error))
    return FALSE;
  gboolean done =
    qn_drawing_to_project (&drawing, path, settings, project, report, error);
  qn_drawing_clear (&drawing);
  return done;
}
