#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "cli/project/check-report.h"
#include "io/exchange/record.h"
#include "io/result/result-derived.h"
#include "io/text/fault-text.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"

#include <glib/gi18n.h>

typedef struct CheckOptions {
  char *result;
  QnInputOptions input;
  gboolean json;
} CheckOptions;

static QnExit
tell (const CheckOptions *options, const QnCheckReport *report)
{
  GError *error = NULL;
  gsize length;
  if (!options->json) {
    qn_check_report_print (report);
    return QN_EXIT_DONE;
  }
  g_autofree char *text = qn_check_report_dup_json (report, &length);
  qn_file_write ("-", text, length, &error);
  return qn_cli_end (error);
}

static QnExit
check_model (const CheckOptions *options, const char *path)
{
  QnInput input;
  QnExit code = qn_input_read (&input, path, &options->input);
  if (code != QN_EXIT_DONE)
    return code;

  QnCheckReport report = { .project = &input.project, .contacts = &input.contacts };
  GError *unread = NULL;
  gboolean complete = input.project.model.analysis.procedure != QN_PROCEDURE_DYNAMIC
                      || qn_project_read_records (&input.project, NULL,
                                                  options->input.allow_outside, &unread);
  QnDiag diag = { 0 };
  gboolean sound =
    qn_contacts_require_sound (&input.project.model, &input.contacts, &diag) == QN_OK;
  report.sound = complete && sound;
  code = tell (options, &report);
  if (!complete)
    code = qn_cli_fail (unread);
  else if (code == QN_EXIT_DONE && !sound)
    code = qn_input_refuse (&input.project, &diag);
  qn_input_clear (&input);
  return code;
}

/* One line, which names what is not true. */
static void
tell_first_fault (const QnCheckReport *report)
{
  g_autofree char *text = qn_fault_dup_text (&report->project->model, report->contacts,
                                             &report->faults->items[0]);
  qn_cli_error (_ ("%s: not true: %s"), report->result_name, text);
}

/* Everything that the result says. */
static gboolean
find_faults (const CheckOptions *options, QnInput *input, const QnResultFile *file,
             const char *text, gsize length, QnCheckReport *report,
             QnResultFaults *faults, GError **error)
{
  const char *name = options->result;
  if (file->result.history.width > 0
      && !qn_project_read_records (&input->project, NULL, options->input.allow_outside,
                                   error))
    return FALSE;
  return qn_result_file_find_faults (file, name, &input->project, &input->contacts,
                                     faults, error)
         && (faults->count > 0
             || qn_result_text_agrees (text, length, name, file, &input->project,
                                       &input->contacts, report->unproved, error));
}

static QnExit
check_result (const CheckOptions *options, const char *path)
{
  QnInput input;
  QnResultFile file;
  GError *error = NULL;
  gsize length;
  g_autofree char *text = qn_file_read (options->result, &length, &error);
  if (text == NULL
      || !qn_result_file_parse (text, length, options->result, &file, &error))
    return qn_cli_fail (error);
  gboolean same_bytes;
  QnExit code = qn_input_load_for_result (&input, &file, path, options->result,
                                          &options->input, &same_bytes);
  if (code != QN_EXIT_DONE)
    return code;

  QnResultFaults faults;
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  QnCheckReport report = { .project = &input.project,
                           .contacts = &input.contacts,
                           .sound = TRUE,
                           .result_name = options->result,
                           .faults = &faults,
                           .unproved = unproved };
  if (!find_faults (options, &input, &file, text, length, &report, &faults, &error)) {
    code = qn_cli_fail (error);
  } else {
    code = tell (options, &report);
    if (code == QN_EXIT_DONE && faults.count > 0) {
      code = QN_EXIT_INVALID;
      tell_first_fault (&report);
    }
  }
  qn_input_clear (&input);
  qn_result_file_clear (&file);
  return code;
}

static QnExit
run_check (const QnSubcommand *self, int argc, char **argv)
{
  CheckOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "json", 0, 0, G_OPTION_ARG_NONE, &options.json,
      N_ ("Print a form that programs can read"), NULL },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Check everything in this result as well"), N_ ("RESULT.json") },
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = options.result != NULL ? check_result (&options, argv[1])
                                  : check_model (&options, argv[1]);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_check = {
  .name = "check",
  .arguments = "MODEL",
  .summary =
    N_ ("List the contact faces and pairs of a project and what is wrong with it"),
  .help =
    N_ ("Gaps, overlaps and loose blocks are reported with their place. A result is "
        "checked without solving again: it must be of this very project; the forces of "
        "every step are those that its displacements cause, within the strength of the "
        "joints and in equilibrium; states, events, outcome, mechanism, reactions and "
        "bounds are those of the forces."),
  .run = run_check,
};
