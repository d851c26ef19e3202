#include "cli/figure/sheet-input.h"

#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "core/path/analysis.h"

#include <string.h>

QnExit
qn_sheet_item_solve (QnSheetItem *item)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  QnExit code = qn_input_read_records (&item->input, FALSE);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&item->input);
  if (code != QN_EXIT_DONE)
    return code;

  qn_terminal_progress_init (&progress, FALSE);
  QnStatus status =
    qn_analysis_run (&item->input.project.model, &item->input.contacts,
                     qn_terminal_progress_update, &progress, &item->file.result, &diag);
  qn_terminal_progress_done (&progress);
  if (qn_interrupt_seen ())
    return qn_cli_cancelled (item->input.project.name);
  return status == QN_OK ? QN_EXIT_DONE : qn_input_refuse (&item->input.project, &diag);
}

/* Reads the result named behind "=", or solves the project where none is named. An argument that is
 * itself the name of a file is taken as that, "=" or not. On failure the error is printed and *item
 * is empty. */
static QnExit
load_item (QnSheetItem *item, const char *argument)
{
  const char *equals = strrchr (argument, '=');
  memset (item, 0, sizeof *item);
  if (equals != NULL && !g_file_test (argument, G_FILE_TEST_EXISTS)) {
    g_autofree char *model = g_strndup (argument, (gsize) (equals - argument));
    return qn_input_load_with_result (&item->input, &item->file, model, equals + 1, NULL);
  }

  QnExit code = qn_input_load (&item->input, argument, NULL);
  if (code != QN_EXIT_DONE)
    return code;
  code = qn_sheet_item_solve (item);
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
qn_sheet_items_load (char **arguments, gsize count, QnSheetItem **items)
{
  *items = g_new0 (QnSheetItem, count);
  qn_interrupt_install ();
  for (gsize i = 0; i < count; i++) {
    QnExit code = load_item (&(*items)[i], arguments[i]);
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

const char *
qn_sheet_item_title (const QnSheetItem *item)
{
  const QnProject *project = &item->input.project;
  const char *slash = strrchr (project->name, G_DIR_SEPARATOR);
  if (project->model.title != NULL && *project->model.title != '\0')
    return project->model.title;
  return slash != NULL ? slash + 1 : project->name;
}
