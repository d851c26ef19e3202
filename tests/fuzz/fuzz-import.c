/* Any bytes as a drawing, all the way to a project, with joints of mortar left open, closed or filled.
 * Built once per importer: FUZZ_READER is the function that reads one. */
#include "fuzz.h"
#include "io/exchange/drawing-import.h"
#include "io/exchange/drawing.h"
#include "io/text/io-error.h"

#include <string.h>

static void
check_import (const char *text, size_t size, QnGapTreatment gaps)
{
  QnDrawing drawing;
  QnProject project;
  QnImportReport report;
  GError *error = NULL;
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  settings.gaps = gaps;
  if (!qn_drawing_read (FUZZ_READER, text, size, "fuzz", &drawing, &error)) {
    fuzz_check_error (error);
    return;
  }
  if (qn_drawing_to_project (&drawing, "fuzz", &settings, &project, &report, &error)) {
    qn_project_clear (&project);
  } else {
    fuzz_check_error (error);
  }
  qn_import_report_clear (&report);
  qn_drawing_clear (&drawing);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  /* As qn_file_read() gives it: with a NUL byte behind. */
  g_autofree char *text = g_malloc (size + 1);
  memcpy (text, data, size);
  text[size] = '\0';
  /* Which, by the size: each in a third of the inputs. */
  check_import (text, size, (QnGapTreatment) (size % QN_GAPS_TREATMENT_COUNT));
  return 0;
}
