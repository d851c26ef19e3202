/* Which reader a file to import needs. */
#include "io/exchange/drawing-import.h"
#include "io/exchange/drawing.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

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

/* The number of an option, or NULL. */
static double *
find_number (QnImportSettings *settings, const char *option)
{
  const struct {
    const char *name;
    double *number;
  } numbers[] = {
    { "tolerance", &settings->tolerance },     { "thickness", &settings->thickness },
    { "unit-weight", &settings->unit_weight }, { "friction", &settings->friction },
    { "close-joints", &settings->gap_width },  { "mortar-joints", &settings->gap_width }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++)
    if (strcmp (numbers[i].name, option) == 0)
      return numbers[i].number;
  return NULL;
}

gboolean
qn_import_settings_set (QnImportSettings *settings, const char *option, const char *value,
                        GError **error)
{
  double *number = find_number (settings, option);
  const char *problem = NULL;
  char *end = NULL;
  if (strcmp (option, "unit") == 0) {
    settings->unit = qn_import_unit (value);
    problem = settings->unit == 0 ? _ ("must be mm, cm, dm, m, in or ft") : NULL;
  } else if (number == NULL) {
    problem = _ ("no such option");
  } else {
    gboolean gaps = number == &settings->gap_width;
    gboolean again = gaps && settings->gaps != QN_GAPS_OPEN;
    *number = g_ascii_strtod (value, &end);
    if (gaps)
      settings->gaps = option[0] == 'c' ? QN_GAPS_CLOSED : QN_GAPS_FILLED;
    problem = end == value || *end != '\0' || !isfinite (*number) ? _ ("must be a number")
              : *number < 0 ? _ ("must not be negative")
              : number == &settings->thickness && *number == 0 ? _ ("must be positive")
              : again ? _ ("and the other treatment of joints exclude each other")
                      : NULL;
  }
  if (problem == NULL)
    return TRUE;
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE, "%s %s", option, problem);
  return FALSE;
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
