#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "cli/figure/sheet-input.h"
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
  QnInput input;
  QnReportItem report;
} Item;

static void
item_clear (Item *item)
{
  qn_report_item_clear (&item->report);
  qn_input_clear (&item->input);
}

static QnExit
load_item (Item *item, const char *model, const char *result,
           const QnInputOptions *options)
{
  QnExit code =
    qn_input_load_with_result (&item->input, &item->report.file, model, result, options);
  if (code != QN_EXIT_DONE)
    return code;
  item->report.name = g_path_get_basename (result);
  qn_report_item_check (&item->report, &item->input.project, &item->input.contacts,
                        result);
  /* What shook the structure is shown where its records are still there. */
  if (item->input.project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    qn_project_read_records (&item->input.project, NULL, options->allow_outside, NULL);
  return QN_EXIT_DONE;
}

/* A project without results is solved. */
static QnExit
solve_item (Item *item, const char *model, const QnInputOptions *options)
{
  QnSheetItem solved;
  GError *error = NULL;
  QnExit code = qn_sheet_item_load (&solved, model, NULL, options);
  if (code != QN_EXIT_DONE)
    return code;
  gsize length;
  g_autofree char *text = qn_result_dup_text (
    &solved.input.project, &solved.input.contacts, &solved.file.result, &length);
  item->input = solved.input;
  solved.input = (QnInput){ 0 };
  if (!qn_report_item_parse (&item->report, text, length, _ ("Analysis of the project"),
                             &item->input.project, &item->input.contacts, &error)) {
    qn_input_clear (&item->input);
    code = qn_cli_fail (error);
  }
  qn_sheet_item_clear (&solved);
  return code;
}

/* Numbers of a report go with its words, as those of its pictures do. */
static void
use_numbers_of_words (void)
{
  setlocale (LC_NUMERIC, "");
  if (strcmp (localeconv ()->decimal_point, C_ ("decimal sign", ".")) != 0)
    setlocale (LC_NUMERIC, "C");
}

static QnExit
write_report (const ReportOptions *options, const QnInput *input, const Item *items,
              gsize count, const QnReportTemplate *plan)
{
  GError *error = NULL;
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, count + 1);
  for (gsize i = 0; i < count; i++)
    runs[i] = qn_report_item_get_run (&items[i].report, &items[i].input.project,
                                      &items[i].input.contacts);
  QnTerminalProgress progress;
  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, FALSE);
  use_numbers_of_words ();
  g_autoptr (GBytes) bytes =
    qn_report_encode_runs (&input->project, &input->contacts, plan, runs, count,
                           qn_terminal_progress_update, &progress, &error);
  setlocale (LC_NUMERIC, "C");
  qn_terminal_progress_done (&progress);
  if (g_error_matches (error, G_IO_ERROR, G_IO_ERROR_CANCELLED)) {
    g_error_free (error);
    return qn_cli_cancelled (input->project.name);
  }
  gsize length;
  const void *data = bytes != NULL ? g_bytes_get_data (bytes, &length) : NULL;
  if (data != NULL)
    qn_file_replace (options->output, data, length, &error);
  return qn_cli_end (error);
}

/* What the project keeps, and what options say instead. */
static QnExit
plan_report (const QnSubcommand *self, const ReportOptions *options,
             const QnProject *project, QnReportTemplate *plan)
{
  g_autoptr (GError) error = NULL;
  const char *const given[][2] = { { "paper", options->paper },
                                   { "demand", options->demand },
                                   { "sections", options->sections } };
  if (!qn_report_template_read (plan, project, &error))
    return qn_cli_fail (g_steal_pointer (&error));
  for (gsize i = 0; i < G_N_ELEMENTS (given); i++)
    if (given[i][1] != NULL
        && !qn_report_template_set (plan, given[i][0], given[i][1], &error))
      return qn_cli_usage_error (self->name, "--%s: %s", given[i][0], error->message);
  return QN_EXIT_DONE;
}

static QnExit
make_report (const QnSubcommand *self, const ReportOptions *options, const char *model)
{
  QnReportTemplate plan;
  guint given = options->results != NULL ? g_strv_length (options->results) : 0;
  g_autofree Item *items = g_new0 (Item, given + 1);
  gsize count = 0;
  QnInput input;
  QnExit code = qn_input_load (&input, model, &options->input);
  if (code != QN_EXIT_DONE)
    return code;
  code = plan_report (self, options, &input.project, &plan);
  for (guint i = 0; i < given && code == QN_EXIT_DONE; i++) {
    code = load_item (&items[i], model, options->results[i], &options->input);
    count += code == QN_EXIT_DONE;
  }
  if (given == 0 && code == QN_EXIT_DONE) {
    code = solve_item (&items[0], model, &options->input);
    count += code == QN_EXIT_DONE;
  }
  if (code == QN_EXIT_DONE)
    code = write_report (options, &input, items, count, &plan);
  for (gsize i = 0; i < count; i++)
    item_clear (&items[i]);
  qn_report_template_clear (&plan);
  qn_input_clear (&input);
  return code;
}

static QnExit
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
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv)) {
    if (options.output == NULL)
      qn_cli_usage_error (self->name, _ ("-o is missing"));
    else
      code = make_report (self, &options, argv[1]);
  }
  qn_subcommand_free_values (entries);
  return code;
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
