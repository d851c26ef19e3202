#include "cli/figure/sheet-input.h"

#include "cli/base/message.h"

#include <string.h>

QnSheetRun *
qn_sheet_runs_load (char **arguments, gsize count, const QnInputOptions *options)
{
  QnSheetRun *runs = qn_cli_keep (g_new0 (QnSheetRun, count));
  for (gsize i = 0; i < count; i++) {
    const char *argument = arguments[i], *equals = strrchr (argument, '=');
    const char *name = equals != NULL ? equals + 1 : argument;
    const char *slash = strrchr (name, G_DIR_SEPARATOR);
    if (g_file_test (argument, G_FILE_TEST_EXISTS))
      equals = NULL;
    g_autofree char *model = equals != NULL
                               ? g_strndup (argument, (gsize) (equals - argument))
                               : g_strdup (argument);
    const QnInput *input =
      qn_input_load_or_solve (model, equals != NULL ? equals + 1 : NULL, options);
    runs[i] = (QnSheetRun){ .project = &input->project,
                            .contacts = &input->contacts,
                            .result = &input->file.result,
                            .name = slash != NULL ? slash + 1 : name };
  }
  return runs;
}
