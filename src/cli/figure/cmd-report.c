#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "doc/view/report.h"
#include "io/exchange/record.h"

#include <glib/gi18n.h>
#include <locale.h>
#include <string.h>

static char *report_output, *report_paper, *report_sections, *report_demand;
static char **report_results;

static void
load_run (QnReportRun *run, const char *model, const char *result)
{
  QnInput *input = qn_input_load_with_result (model, result);
  *run = (QnReportRun){ .project = &input->project,
                        .contacts = &input->contacts,
                        .name = g_path_get_basename (result),
                        .file = input->file };
  qn_report_run_check (run, result);
  /* What shook the structure is shown where its records are still there. */
  if (input->project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    qn_project_read_records (&input->project, NULL, qn_allow_outside, NULL);
}

/* A project without results is solved. */
static void
solve_run (QnReportRun *run, const char *model)
{
  QnInput *input = qn_input_load_or_solve (model, NULL);
  *run = (QnReportRun){ .project = &input->project,
                        .contacts = &input->contacts,
                        .name = g_strdup (_ ("Analysis of the project")) };
  qn_cli_must (qn_report_run_take (run, &input->file.result, QN_TROUBLE));
  qn_result_clear (&input->file.result);
}

static void
write_report (QnReport *report)
{
  gsize length;
  qn_terminal_progress_begin ();
  /* Numbers of a report go with its words, as those of its pictures do. */
  setlocale (LC_NUMERIC, "");
  if (strcmp (localeconv ()->decimal_point, C_ ("decimal sign", ".")) != 0)
    setlocale (LC_NUMERIC, "C");
  report->progress = qn_terminal_progress_update;
  g_autoptr (GBytes) bytes = qn_report_encode (report, QN_TROUBLE);
  setlocale (LC_NUMERIC, "C");
  qn_terminal_progress_done ();
  if (g_error_matches (qn_cli_trouble, G_IO_ERROR, G_IO_ERROR_CANCELLED))
    qn_cli_cancelled (report->project->name);
  qn_cli_must (bytes != NULL);
  const void *data = g_bytes_get_data (bytes, &length);
  qn_cli_must (qn_file_replace (report_output, data, length, QN_TROUBLE));
}

static const GOptionEntry report_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &report_output, N_ ("Write the report here"),
    N_ ("OUT.pdf") },
  { "result", 'r', 0, G_OPTION_ARG_FILENAME_ARRAY, &report_results,
    N_ ("Result that is reported; may be given again"), N_ ("RESULT.json") },
  { "paper", 0, 0, G_OPTION_ARG_STRING, &report_paper, N_ ("Size of the pages (a4)"),
    "a4|letter" },
  { "sections", 0, 0, G_OPTION_ARG_STRING, &report_sections,
    N_ ("Only these, commas between them"),
    "title,model,materials,loads,assumptions,findings,contacts,results,mechanism,"
    "combinations,joints,certificate,comparison,files" },
  { "demand", 0, 0, G_OPTION_ARG_STRING, &report_demand,
    N_ ("Say whether this load multiplier is carried"), N_ ("MULTIPLIER") },
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_report (char **arguments)
{
  if (report_output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  guint count = report_results != NULL ? g_strv_length (report_results) : 0;
  QnReportRun *runs = qn_cli_keep (g_new0 (QnReportRun, count + 1));
  const QnInput *input = qn_input_load (arguments[0]);
  QnReport *report = qn_cli_keep (g_new0 (QnReport, 1));
  *report = (QnReport){ .project = &input->project,
                        .contacts = &input->contacts,
                        .runs = runs,
                        .units = QN_UNITS_REPORT };
  /* What the project keeps, and what options say instead. */
  const char *const given[][2] = { { "paper", report_paper },
                                   { "demand", report_demand },
                                   { "sections", report_sections } };
  qn_cli_must (qn_report_template_read (&report->plan, &input->project, QN_TROUBLE));
  for (gsize i = 0; i < G_N_ELEMENTS (given); i++)
    if (given[i][1] != NULL
        && !qn_report_template_set (&report->plan, given[i][0], given[i][1], QN_TROUBLE))
      qn_cli_usage_error ("--%s: %s", given[i][0], qn_cli_trouble->message);
  for (guint i = 0; i < count; i++)
    load_run (&runs[i], arguments[0], report_results[i]);
  if (count == 0)
    solve_run (&runs[count++], arguments[0]);
  report->run_count = count;
  write_report (report);
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
  .options = report_entries,
  .run = run_report,
};
