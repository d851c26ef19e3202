#include "cli/figure/sheet-input.h"

#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "core/path/analysis.h"
#include "io/text/outcome-text.h"

#include <string.h>

QnExit
qn_sheet_item_solve (QnSheetItem *item, const QnInputOptions *options)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  const QnProject *project = &item->input.project;
  QnResult *result = &item->file.result;
  QnExit code = qn_input_prepare (&item->input, options);
  if (code != QN_EXIT_DONE)
    return code;

  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, FALSE);
  QnStatus status =
    qn_analysis_run (&project->model, &item->input.contacts, qn_terminal_progress_update,
                     &progress, result, &diag);
  qn_terminal_progress_done (&progress);
  if (qn_interrupt_seen ())
    return qn_cli_cancelled (project->name);
  if (status != QN_OK)
    return qn_input_refuse (project, &diag);
  if (result->outcome == QN_OUTCOME_NOT_CONVERGED
      || result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    g_autofree char *cause = qn_outcome_dup_cause (&project->model, result);
    qn_cli_warning ("%s: %s", project->name, cause);
  }
  return QN_EXIT_DONE;
}

QnExit
qn_sheet_item_load (QnSheetItem *item, const char *model, const char *result,
                    const QnInputOptions *options)
{
  memset (item, 0, sizeof *item);
  if (result != NULL)
    return qn_input_load_with_result (&item->input, &item->file, model, result, options);

  QnExit code = qn_input_load (&item->input, model, options);
  if (code != QN_EXIT_DONE)
    return code;
  code = qn_sheet_item_solve (item, options);
  if (code != QN_EXIT_DONE)
    qn_sheet_item_clear (item);
  return code;
}

void
qn_sheet_item_clear (QnSheetItem *item)
{
  qn_result_file_clear (&item->file);
  qn_input_clear (&item->input);
}

QnExit
qn_sheet_items_load (char **arguments, gsize count, const QnInputOptions *options,
                     QnSheetItem **items)
{
  *items = g_new0 (QnSheetItem, count);
  for (gsize i = 0; i < count; i++) {
    const char *argument = arguments[i], *equals = strrchr (argument, '=');
    if (g_file_test (argument, G_FILE_TEST_EXISTS))
      equals = NULL;
    g_autofree char *model = equals != NULL
                               ? g_strndup (argument, (gsize) (equals - argument))
                               : g_strdup (argument);
    QnExit code = qn_sheet_item_load (&(*items)[i], model,
                                      equals != NULL ? equals + 1 : NULL, options);
    if (code != QN_EXIT_DONE) {
      qn_sheet_items_free (*items, i);
      *items = NULL;
      return code;
    }
  }
  return QN_EXIT_DONE;
}

void
qn_sheet_items_free (QnSheetItem *items, gsize count)
{
  for (gsize i = 0; i < count; i++)
    qn_sheet_item_clear (&items[i]);
  g_free (items);
}

QnSheetRun *
qn_sheet_items_get_runs (const QnSheetItem *items, char **arguments, gsize count)
{
  QnSheetRun *runs = g_new0 (QnSheetRun, count);
  for (gsize i = 0; i < count; i++) {
    const char *equals = strrchr (arguments[i], '=');
    const char *name = equals != NULL ? equals + 1 : arguments[i];
    const char *slash = strrchr (name, G_DIR_SEPARATOR);
    runs[i] = (QnSheetRun){ .project = &items[i].input.project,
                            .contacts = &items[i].input.contacts,
                            .result = &items[i].file.result,
                            .name = slash != NULL ? slash + 1 : name };
  }
  return runs;
}
