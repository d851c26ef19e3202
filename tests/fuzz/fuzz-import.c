/* Any bytes as a drawing, all the way to a project. Built once per importer: FUZZ_READER is the
 * function that reads one. */
#include "fuzz.h"
#include "io/exchange/compas-import.h"
#include "io/exchange/drawing-import.h"
#include "io/exchange/dxf-import.h"
#include "io/exchange/hybridfem-import.h"
#include "io/exchange/svg-import.h"
#include "io/text/io-error.h"

#include <string.h>

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  QnDrawing drawing;
  QnProject project;
  QnImportReport report;
  GError *error = NULL;
  /* As qn_file_read() gives it: with a NUL byte behind. */
  g_autofree char *text = g_malloc (size + 1);
  memcpy (text, data, size);
  text[size] = '\0';
  if (!FUZZ_READER (text, size, "fuzz", &drawing, &error)) {
    fuzz_check_error (error);
    return 0;
  }
  if (qn_drawing_to_project (&drawing, "fuzz", &QN_IMPORT_DEFAULTS, &project, &report,
                             &error)) {
    qn_project_clear (&project);
    qn_import_report_clear (&report);
  } else {
    fuzz_check_error (error);
  }
  qn_drawing_clear (&drawing);
  return 0;
}
