#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "doc/view/report.h"
#include "io/exchange/record.h"

#include <glib/gi18n.h>
#include <locale.h>
#include <string.h>

typedef struct ReportOptions {
  char *output, *paper, *sections, *demand;
  char **results;
  QnInputOptions input;
} ReportOptions;

static void
load_run (QnReportRun *run, const char *model, const char *result,
          const QnInputOptions *options)
{
  QnInput *input = qn_input_load_with_result (model, result, options);
  *run = (QnReportRun){ .project = &input->project,
                        .contacts = &input->contacts,
                        .name = g_path_get_basename (result),
                        .file = input->file };
  qn_report_run_check (run, result);
  /* What shook the structure is shown where its records are still there. */
  if (input->project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    qn_project_read_records (&input->project, NULL, options->allow_outside, NULL);
}

/* A project without results is solved. */
static void
solve_run (QnReportRun *run, const char *model, const QnInputOptions *options)
{
  QnInput *input = qn_input_load_or_solve (model, NULL, options);
  *run = (QnReportRun){ .project = &input->project,
                        .contacts = &input->contacts,
                        .name = g_strdup (_ ("Analysis of the project")) };
  qn_cli_must (qn_report_run_take (run, &input->file.result, QN_TROUBLE));
  qn_result_clear (&input->file.result);
}

/* Numbers of a report go with its words, as those of its pictures do. */
static void
use_numbers_of_words (void)
{
  setlocale (LC_NUMERIC, "");
  if (strcmp (localeconv ()->decimal_point, C_ ("decimal sign", ".")) != 0)
    setlocale (LC_NUMERIC, "C");
}

static void
write_report (const ReportOptions *options, QnReport *report)
{
  gsize length;
  QnTerminalProgress progress;
  qn_terminal_progress_begin (&progress, FALSE);
  use_numbers_of_words ();
  report->progress = qn_terminal_progress_update;
  report->progress_data = &progress;
  g_autoptr (GBytes) bytes = qn_report_encode (report, QN_TROUBLE);
  setlocale (LC_NUMERIC, "C");
  qn_terminal_progress_done (&progress);
  if (g_error_matches (qn_cli_trouble, G_IO_ERROR, G_IO_ERROR_CANCELLED))
    qn_cli_cancelled (report->project->name);
  qn_cli_must (bytes != NULL);
  const void *data = g_bytes_get_data (bytes, &length);
  qn_cli_must (qn_file_replace (options->output, data, length, QN_TROUBLE));
}

/* What the project keeps, and what options say instead. */
static void
plan_report (const ReportOptions *options, const QnProject *project,
             QnReportTemplate *plan)
{
  const char *const given[][2] = { { "paper", options->paper },
                                   { "demand", options->demand },
                                   { "sections", options->sections } };
  qn_cli_must (qn_report_template_read (plan, project, QN_TROUBLE));
  for (gsize i = 0; i < G_N_ELEMENTS (given); i++)
    if (given[i][1] != NULL
        && !qn_report_template_set (plan, given[i][0], given[i][1], QN_TROUBLE))
      qn_cli_usage_error ("--%s: %s", given[i][0], qn_cli_trouble->message);
}

static void
make_report (const ReportOptions *options, const char *model)
{
  guint count = options->results != NULL ? g_strv_length (options->results) : 0;
  QnReportRun *runs = qn_cli_keep (g_new0 (QnReportRun, count + 1));
  const QnInput *input = qn_input_load (model, &options->input);
  QnReport *report = qn_cli_keep (g_new0 (QnReport, 1));
  *report = (QnReport){ .project = &input->project,
                        .contacts = &input->contacts,
                        .runs = runs,
                        .units = QN_UNITS_REPORT };
  plan_report (options, &input->project, &report->plan);
  for (guint i = 0; i < count; i++)
    load_run (&runs[i], model, options->results[i], &options->input);
  if (count == 0)
    solve_run (&runs[count++], model, &options->input);
  report->run_count = count;
  write_report (options, report);
}

static void
run_report (const QnSubcommand *self, int argc, char **argv)
{
  ReportOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
      N_ ("Write the report here"), N_ ("OUT.pdf") },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME_ARRAY, &options.results,
      N_ ("Result that is reported; may be given again"), N_ ("RESULT.json") },
    { "paper", 0, 0, G_OPTION_ARG_STRING, &options.paper, N_ ("Size of the pages (a4)"),
      "a4|letter" },
    { "sections", 0, 0, G_OPTION_ARG_STRING, &options.sections,
      N_ ("Only these, commas between them"),
      "title,model,materials,loads,assumptions,findings,contacts,results,mechanism,"
      "combinations,joints,certificate,comparison,files" },
    { "demand", 0, 0, G_OPTION_ARG_STRING, &options.demand,
      N_ ("Say whether this load multiplier is carried"), N_ ("MULTIPLIER") },
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  if (options.output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  make_report (&options, argv[1]);
}

const QnSubcommand qn_cmd_report = {
  .name = "report",
  .arguments = "MODEL",
  .summary = N_ ("Write a report on a project and its results as PDF"),
  .help = N_ (
    "Model with dimensions, materials, loads, findings, contacts, every result "
    "with its mechanism and curve, the forces of joints, the independent check of "
    "each, a comparison, files and versions. A project without a result is "
    "solved first. Tables of joints are whole where their section is named. The project "
    "may keep sections, paper, author and an introduction in \"report\"."),
  .run = run_report,
};
