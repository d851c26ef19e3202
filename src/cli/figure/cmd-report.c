#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "doc/view/report-item.h"
#include "io/exchange/record.h"

#include <glib/gi18n.h>
#include <locale.h>
#include <string.h>

typedef struct ReportOptions {
  char *output, *paper, *sections, *demand;
  char **results;
  QnInputOptions input;
} ReportOptions;

/* One result, and the project it was computed of. */
typedef struct Item {
  QnInput *input;
  QnReportItem report;
} Item;

static void
load_item (Item *item, const char *model, const char *result,
           const QnInputOptions *options)
{
  QnInput *input = item->input = qn_input_load_with_result (model, result, options);
  item->report.file = input->file;
  item->report.name = g_path_get_basename (result);
  qn_report_item_check (&item->report, &input->project, &input->contacts, result);
  /* What shook the structure is shown where its records are still there. */
  if (input->project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    qn_project_read_records (&input->project, NULL, options->allow_outside, NULL);
}

/* A project without results is solved. */
static void
solve_item (Item *item, const char *model, const QnInputOptions *options)
{
  gsize length;
  QnInput *input = item->input = qn_input_load_or_solve (model, NULL, options);
  g_autofree char *text = qn_result_dup_text (
    &input->project, &input->contacts, &input->file.result, QN_DETAIL_FORCES, &length);
  qn_result_clear (&input->file.result);
  qn_cli_must (qn_report_item_parse (&item->report, text, length,
                                     _ ("Analysis of the project"), &input->project,
                                     &input->contacts, QN_TROUBLE));
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
write_report (const ReportOptions *options, const QnInput *input, const Item *items,
              gsize count, const QnReportTemplate *plan)
{
  gsize length;
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, count + 1);
  for (gsize i = 0; i < count; i++)
    runs[i] = qn_report_item_get_run (&items[i].report, &items[i].input->project,
                                      &items[i].input->contacts);
  QnTerminalProgress progress;
  qn_terminal_progress_begin (&progress, FALSE);
  use_numbers_of_words ();
  g_autoptr (GBytes) bytes = qn_report_encode_runs (
    &input->project, &input->contacts, plan, runs, count, QN_UNITS_REPORT,
    qn_terminal_progress_update, &progress, QN_TROUBLE);
  setlocale (LC_NUMERIC, "C");
  qn_terminal_progress_done (&progress);
  if (g_error_matches (qn_cli_trouble, G_IO_ERROR, G_IO_ERROR_CANCELLED))
    qn_cli_cancelled (input->project.name);
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
  QnReportTemplate *plan = qn_cli_keep (g_new0 (QnReportTemplate, 1));
  Item *items = qn_cli_keep (g_new0 (Item, count + 1));
  const QnInput *input = qn_input_load (model, &options->input);
  plan_report (options, &input->project, plan);
  for (guint i = 0; i < count; i++)
    load_item (&items[i], model, options->results[i], &options->input);
  if (count == 0)
    solve_item (&items[count++], model, &options->input);
  write_report (options, input, items, count, plan);
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
