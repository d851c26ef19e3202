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

static void
tell (const CheckOptions *options, const QnCheckReport *report)
{
  gsize length;
  if (!options->json) {
    qn_check_report_print (report);
    return;
  }
  g_autofree char *text = qn_check_report_dup_json (report, &length);
  qn_cli_must (qn_file_write ("-", text, length, QN_TROUBLE));
}

static void
check_model (const CheckOptions *options, const char *path)
{
  QnInput *input = qn_input_read (path, &options->input);
  QnCheckReport report = { .project = &input->project, .contacts = &input->contacts };
  GError *unread = NULL;
  QnDiag diag = { 0 };
  gboolean complete = input->project.model.analysis.procedure != QN_PROCEDURE_DYNAMIC
                      || qn_project_read_records (&input->project, NULL,
                                                  options->input.allow_outside, &unread);
  gboolean sound =
    qn_contacts_require_sound (&input->project.model, &input->contacts, &diag) == QN_OK;
  report.sound = complete && sound;
  tell (options, &report);
  qn_cli_trouble = unread;
  qn_cli_must (complete);
  if (!sound)
    qn_input_refuse (&input->project, &diag);
}

static void
check_result (const CheckOptions *options, const char *path)
{
  const char *name = options->result;
  QnResultFile file;
  gsize length;
  gboolean same_bytes;
  g_autofree char *text = qn_file_read (name, &length, QN_TROUBLE);
  qn_cli_must (text != NULL
               && qn_result_file_parse (text, length, name, &file, QN_TROUBLE));
  QnInput *input =
    qn_input_load_for_result (&file, path, name, &options->input, &same_bytes);
  QnProject *project = &input->project;
  const QnContacts *contacts = &input->contacts;
  QnResultFaults faults;
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  QnCheckReport report = { .project = project,
                           .contacts = contacts,
                           .sound = TRUE,
                           .result_name = name,
                           .faults = &faults,
                           .unproved = unproved };
  qn_cli_must (
    file.result.history.width == 0
    || qn_project_read_records (project, NULL, options->input.allow_outside, QN_TROUBLE));
  qn_cli_must (qn_result_file_find_faults (&input->file, name, project, contacts, &faults,
                                           QN_TROUBLE));
  qn_cli_must (faults.count > 0
               || qn_result_text_agrees (text, length, name, &input->file, project,
                                         contacts, unproved, QN_TROUBLE));
  tell (options, &report);
  if (faults.count > 0) {
    g_autofree char *first =
      qn_fault_dup_text (&project->model, contacts, &faults.items[0]);
    qn_cli_fail (QN_EXIT_INVALID, _ ("%s: not true: %s"), name, first);
  }
}

static void
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
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    (options.result != NULL ? check_result : check_model) (&options, argv[1]);
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
