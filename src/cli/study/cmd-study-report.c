#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/shown-text.h"
#include "cli/study/cmd-study.h"
#include "core/base/word.h"
#include "study/cases/folder.h"
#include "study/report/figures.h"
#include "study/report/summary.h"

#include <glib/gi18n.h>

/* The rows of the study of a folder, for the rest of the program. */
static QnTable *
load_table (const char *name)
{
  const char *folder = qn_cli_keep (qn_folder_dup_named (name));
  QnStudy *study = qn_cli_keep (g_new0 (QnStudy, 1));
  QnTable *table = qn_cli_keep (g_new0 (QnTable, 1));
  qn_cli_must (qn_folder_read_study (folder, study, QN_TROUBLE)
               && qn_table_read (table, study, folder, QN_TROUBLE));
  return table;
}

static void
run_table (const QnSubcommand *self, int argc, char **argv)
{
  char *path = (char *) "-";
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &path,
      N_ ("Write the table here; standard output by default"), N_ ("TABLE.csv") },
    G_OPTION_ENTRY_NULL,
  };
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    qn_cli_must (qn_table_write (load_table (argv[1]), path, QN_TROUBLE));
}

const QnSubcommand qn_study_action_table = {
  .name = "study table",
  .arguments = "FOLDER",
  .summary = N_ ("Write the cases of a study as a table (CSV)"),
  .run = run_table,
};

static void
run_summary (const QnSubcommand *self, int argc, char **argv)
{
  const GOptionEntry entries[] = { G_OPTION_ENTRY_NULL };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  g_autofree char *text = qn_summary_dup_text (load_table (argv[1]));
  qn_print_text (text);
}

const QnSubcommand qn_study_action_summary = {
  .name = "study summary",
  .arguments = "FOLDER",
  .summary =
    N_ ("Print mean, deviation, quantiles, fragility, sensitivities, mechanisms"),
  .run = run_summary,
};

typedef struct PlotOptions {
  QnPictureOptions picture;
  char *kind, *of;
  char **by;
} PlotOptions;

/* The first output that is a number, where none is named. */
static int
default_output (const QnTable *table)
{
  for (gsize i = table->parameters; i < table->width; i++)
    if (qn_study_output_is_number (qn_study_output (table->study, i - table->parameters)))
      return (int) i;
  return -1;
}

/* Columns by their names; the first ones that fit where none are named. */
static void
find_columns (const PlotOptions *options, const QnTable *table, QnStudyFigure *figure)
{
  guint given = options->by != NULL ? g_strv_length (options->by) : 0;
  gboolean one =
    figure->kind == QN_STUDY_FIGURE_SCATTER || figure->kind == QN_STUDY_FIGURE_ENVELOPE;
  guint wanted = figure->kind == QN_STUDY_FIGURE_SURFACE ? 2 : one;
  figure->column =
    options->of != NULL ? qn_table_find (table, options->of) : default_output (table);
  if (figure->kind == QN_STUDY_FIGURE_MECHANISMS)
    return;
  if (figure->column < (int) table->parameters
      || !qn_study_output_is_number (
        qn_study_output (table->study, (gsize) figure->column - table->parameters)))
    qn_cli_usage_error (_ ("--of names an output of the study that is a number"));
  if (given > wanted || table->parameters < wanted)
    qn_cli_usage_error (_ ("--by names the parameter of a scatter or an envelope, or the "
                           "two of a surface"));
  for (guint i = 0; i < wanted; i++) {
    figure->parameters[i] = i < given ? qn_table_find (table, options->by[i]) : (int) i;
    if (figure->parameters[i] < 0 || figure->parameters[i] >= (int) table->parameters)
      qn_cli_usage_error (_ ("--by names a parameter of the study"));
  }
  if (wanted == 2 && figure->parameters[0] == figure->parameters[1])
    qn_cli_usage_error (_ ("a surface needs two different parameters"));
}

static void
run_plot (const QnSubcommand *self, int argc, char **argv)
{
  PlotOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "kind", 'k', 0, G_OPTION_ARG_STRING, &options.kind, N_ ("What is drawn"),
      "scatter|histogram|cumulative|tornado|surface|envelope|mechanisms" },
    { "of", 0, 0, G_OPTION_ARG_STRING, &options.of,
      N_ ("The output; the first one by default"), N_ ("NAME") },
    { "by", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.by,
      N_ ("A parameter; the first by default; a surface has two"), N_ ("NAME") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    G_OPTION_ENTRY_NULL,
  };
  QnStudyFigure figure = { 0 };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  if (options.kind == NULL)
    qn_cli_usage_error (_ ("--kind is missing"));
  if (!qn_find_word (options.kind, qn_study_figure_names, QN_STUDY_FIGURE_COUNT,
                     &figure.kind))
    qn_cli_refuse_name (options.kind, qn_study_figure_names, QN_STUDY_FIGURE_COUNT);
  qn_picture_output (&options.picture);
  figure.monochrome = options.picture.monochrome;
  const QnTable *table = load_table (argv[1]);
  find_columns (&options, table, &figure);
  qn_cli_must (qn_study_figure_export (&figure, table, options.picture.path,
                                       &options.picture.output, QN_TROUBLE));
}

const QnSubcommand qn_study_action_plot = {
  .name = "study plot",
  .arguments = "FOLDER",
  .summary = N_ ("Draw the cases of a study: PNG, SVG or PDF"),
  .help =
    N_ ("A tornado shows Sobol indices of a plan \"sobol\", ranges of a plan "
        "\"one-at-a-time\", else rank correlations. An envelope has the least value "
        "over a parameter, as of a moving load by its place. Mechanisms shows a "
        "typical case of every shape or kind."),
  .run = run_plot,
};
