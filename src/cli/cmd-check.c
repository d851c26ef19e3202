#include "cli/check-report.h"
#include "cli/message.h"
#include "cli/subcommand.h"

#include <glib/gi18n.h>
#include <string.h>

typedef struct Options {
  char *result;
  char **overrides;
  gboolean json;
} Options;

static QnExit
tell (const Options *options, const QnCheckReport *report)
{
  GError *error = NULL;
  if (!options->json)
    qn_check_report_print (report);
  else if (!qn_check_report_write_json (report, &error))
    return qn_cli_fail (error);
  return QN_EXIT_DONE;
}

static QnExit
check_model (const Options *options, const char *path)
{
  QnInput input;
  QnExit code = qn_input_load (&input, path, options->overrides, TRUE);
  if (code != QN_EXIT_DONE)
    return code;

  QnCheckReport report = { .input = &input };
  report.sound =
    qn_contacts_require_sound (&input.project.model, &input.contacts, NULL) == QN_OK;
  code = tell (options, &report);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  qn_input_clear (&input);
  return code;
}

static QnExit
check_result (const Options *options, const char *path)
{
  QnInput input;
  QnResultFile file;
  GError *error = NULL;
  QnExit code = qn_input_load_with_result (&input, &file, path, options->result,
                                           options->overrides, FALSE);
  if (code != QN_EXIT_DONE)
    return code;

  QnResultCheck check;
  if (!qn_result_check (&file, &input.project, &check, &error)) {
    code = qn_cli_fail (error);
  } else {
    QnCheckReport report = {
      .input = &input, .sound = TRUE, .result_name = options->result, .check = &check
    };
    code = tell (options, &report);
    if (code == QN_EXIT_DONE && !qn_check_report_passes (&check)) {
      qn_cli_error (_ ("%s: not an equilibrium that the joints can carry"),
                    options->result);
      code = QN_EXIT_INVALID;
    }
  }
  qn_input_clear (&input);
  qn_result_file_clear (&file);
  return code;
}

static QnExit
run (const QnSubcommand *self, int argc, char **argv)
{
  Options options = { 0 };
  const GOptionEntry entries[] = {
    { "json", 0, 0, G_OPTION_ARG_NONE, &options.json,
      N_ ("Print a form that programs can read"), NULL },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Check equilibrium and joint strength of this result as well"),
      N_ ("RESULT.json") },
    QN_INPUT_SET_ENTRY (&options.overrides),
    G_OPTION_ENTRY_NULL,
  };
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = options.result != NULL ? check_result (&options, argv[1])
                                  : check_model (&options, argv[1]);
  g_free (options.result);
  g_strfreev (options.overrides);
  return code;
}

const QnSubcommand qn_cmd_check = {
  .name = "check",
  .arguments = "MODEL",
  .summary =
    N_ ("List the contact faces and pairs of a project and what is wrong with it"),
  .help =
    N_ ("Gaps, overlaps and loose blocks are reported with their place. A result is "
        "checked from its file alone, without solving again: every free block in "
        "equilibrium, every pair within its strength, both to 1e-6."),
  .run = run,
};
