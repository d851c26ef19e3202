#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "doc/text/law-trace.h"
#include "doc/view/sheet.h"
#include "io/project/project.h"
#include "io/text/file-writer.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

typedef struct LawOptions {
  QnPictureOptions picture;
  char *csv, *model, *path;
  char **settings;
  double length;
} LawOptions;

typedef struct History {
  QnLawPreset what;
  double length; /* m, that strains are over; 1 where there are none */
  GArray *samples;
} History;

static gboolean
parse_number (const char *text, double *number)
{
  char *end = NULL;
  *number = g_ascii_strtod (text, &end);
  return end != text && *end == '\0' && isfinite (*number);
}

/* The number of the law that a key names, or NULL. */
static double *
find_number (QnLaw *law, const char *key)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  if (strcmp (key, "kn") == 0)
    return &law->kn;
  if (strcmp (key, "ks") == 0)
    return &law->ks;
  if (strcmp (key, "shear_factor") == 0)
    return &law->shear_factor;
  for (size_t i = 0; i < count; i++)
    if (strcmp (key, parameters[i].key) == 0)
      return qn_law_at (law, &parameters[i]);
  return NULL;
}

static gboolean
apply_setting (const QnSubcommand *self, QnLaw *law, const char *setting)
{
  g_auto (GStrv) parts = g_strsplit (setting, "=", 2);
  g_autofree char *message = NULL;
  if (parts[0] == NULL || parts[1] == NULL) {
    message = g_strdup_printf (_ ("“%s” is not KEY=VALUE"), setting);
  } else if (strcmp (parts[0], "basis") == 0) {
    for (int basis = 0; basis < QN_BASIS_COUNT; basis++)
      if (strcmp (parts[1], qn_basis_names[basis]) == 0) {
        law->basis = (QnBasis) basis;
        return TRUE;
      }
    message = g_strdup_printf (_ ("no basis is called “%s”"), parts[1]);
  } else {
    double *number = find_number (law, parts[0]);
    if (number == NULL)
      message = g_strdup_printf (_ ("this kind of law has no “%s”"), parts[0]);
    else if (!parse_number (parts[1], number))
      message = g_strdup_printf (_ ("“%s” is not a number"), parts[1]);
  }
  if (message != NULL)
    qn_cli_usage_error (self->name, "%s", message);
  return message == NULL;
}

static gboolean
parse_path (const QnSubcommand *self, const char *text, QnLawPreset *what)
{
  g_auto (GStrv) parts = g_strsplit (text, ",", -1);
  gsize count = g_strv_length (parts);
  gboolean good = count >= 1 && count <= QN_LAW_MAX_TURNS;
  for (gsize i = 0; i < count && good; i++)
    good = parse_number (parts[i], &what->turns[i]);
  what->turn_count = count;
  if (!good)
    qn_cli_usage_error (self->name,
                        _ ("--path takes 1 to 64 elongations with commas between"));
  return good;
}

/* A law of a project, by name. */
static QnExit
take_law_of_project (const LawOptions *options, const char *name, QnLawPreset *what)
{
  QnProject project;
  GError *error = NULL;
  if (!qn_project_load (options->model, NULL, &project, &error))
    return qn_cli_fail (error);
  QnId id = qn_model_find_law (&project.model, name);
  QnExit code = id == QN_NONE ? QN_EXIT_INVALID : QN_EXIT_DONE;
  if (id == QN_NONE) {
    qn_cli_error (_ ("%s: no law is called “%s”"), options->model, name);
  } else {
    const QnLaw *law = &project.model.laws[id];
    *what = *qn_law_preset (law->kind);
    what->law = *law;
    what->law.name = what->law.source = NULL;
  }
  qn_project_clear (&project);
  return code;
}

static QnExit
take_preset (const QnSubcommand *self, const char *name, QnLawPreset *what)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++)
    if (strcmp (name, qn_law_kind_names[kind]) == 0) {
      *what = *qn_law_preset ((QnLawKind) kind);
      return QN_EXIT_DONE;
    }
  return qn_cli_usage_error (self->name, _ ("no law is called “%s”"), name);
}

static QnExit
prepare (const QnSubcommand *self, const LawOptions *options, const char *name,
         History *history)
{
  QnLawPreset *what = &history->what;
  QnDiag diag = { 0 };
  QnExit code = options->model != NULL ? take_law_of_project (options, name, what)
                                       : take_preset (self, name, what);
  for (char **setting = options->settings; code == QN_EXIT_DONE && setting && *setting;
       setting++)
    if (!apply_setting (self, &what->law, *setting))
      code = QN_EXIT_USAGE;
  if (code == QN_EXIT_DONE && options->path != NULL
      && !parse_path (self, options->path, what))
    code = QN_EXIT_USAGE;
  if (code == QN_EXIT_DONE && !(options->length > 0 && isfinite (options->length))) {
    qn_cli_usage_error (self->name, _ ("--length must be positive"));
    code = QN_EXIT_USAGE;
  }
  if (code != QN_EXIT_DONE)
    return code;

  QnLaw named = what->law;
  named.name = (char *) name;
  if (qn_law_check (&named, 0, &diag) != QN_OK) {
    qn_cli_error ("%s: %s", diag.field, _ (qn_problem_text (diag.problem)));
    return QN_EXIT_INVALID;
  }
  history->length = what->law.basis == QN_BASIS_MATERIAL ? options->length : 1;
  return QN_EXIT_DONE;
}

static QnExit
trace (History *history)
{
  if (qn_law_trace (&history->what, history->length, history->samples))
    return QN_EXIT_DONE;
  qn_cli_error ("%s", _ (qn_problem_text (QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL)));
  return QN_EXIT_INVALID;
}

static QnExit
write_history (const History *history, const char *path)
{
  static const char *const units[QN_BASIS_COUNT][3] = {
    [QN_BASIS_CONTACT] = { "m", "N", "N/m" },
    [QN_BASIS_SURFACE] = { "m", "Pa", "Pa/m" },
    [QN_BASIS_MATERIAL] = { "-", "Pa", "Pa" },
  };
  const char *const *unit = units[history->what.law.basis];
  GError *error = NULL;
  QnFileWriter *writer = qn_file_writer_open (path, &error);
  if (writer == NULL)
    return qn_cli_fail (error);
  qn_file_writer_printf (writer,
                         "normal elongation [%s],tangential elongation [%s],normal force "
                         "[%s],shear force [%s],normal tangent [%s],shear tangent [%s]\n",
                         unit[0], unit[0], unit[1], unit[1], unit[2], unit[2]);
  for (guint i = 0; i < history->samples->len; i++) {
    const QnLawSample *s = &g_array_index (history->samples, QnLawSample, i);
    const double row[] = { s->elongation[0], s->elongation[1], s->force[0],
                           s->force[1],      s->tangent[0],    s->tangent[1] };
    qn_file_writer_numbers (writer, row, G_N_ELEMENTS (row), ",");
    qn_file_writer_puts (writer, "\n");
  }
  qn_file_writer_commit (writer, &error);
  return qn_cli_end (error);
}

static QnExit
draw_history (const History *history, const LawOptions *options, const char *name,
              const QnOutput *output)
{
  g_autoptr (QnPlot) plot = qn_law_plot (&history->what, history->samples);
  plot->title = name;
  plot->monochrome = options->picture.monochrome;
  QnMetadata metadata;
  GError *error = NULL;
  qn_project_get_metadata (NULL, &metadata);
  qn_plot_export (plot, options->picture.path, output, &metadata, &error);
  return qn_cli_end (error);
}

static QnExit
show (const QnSubcommand *self, const LawOptions *options, const char *name)
{
  History history = { .samples = g_array_new (FALSE, FALSE, sizeof (QnLawSample)) };
  QnOutput output;
  QnExit code = prepare (self, options, name, &history);
  qn_output_init (&output);
  if (code == QN_EXIT_DONE && options->picture.path != NULL)
    code = qn_picture_output (self, &options->picture, &output);
  if (code == QN_EXIT_DONE)
    code = trace (&history);
  if (code == QN_EXIT_DONE && options->picture.path != NULL)
    code = draw_history (&history, options, name, &output);
  if (code == QN_EXIT_DONE && (options->csv != NULL || options->picture.path == NULL))
    code = write_history (&history, options->csv != NULL ? options->csv : "-");
  g_array_free (history.samples, TRUE);
  return code;
}

static QnExit
run_law (const QnSubcommand *self, int argc, char **argv)
{
  LawOptions options = { .length = 0.1 };
  const GOptionEntry entries[] = {
    { "csv", 0, 0, G_OPTION_ARG_FILENAME, &options.csv,
      N_ ("Write the history as a table here; - is standard output"), N_ ("OUT.csv") },
    { "plot", 0, 0, G_OPTION_ARG_FILENAME, &options.picture.path,
      N_ ("Draw the history here"), N_ ("OUT.png|svg|pdf") },
    { "model", 0, 0, G_OPTION_ARG_FILENAME, &options.model,
      N_ ("Take the law of this name from a project"), N_ ("MODEL") },
    { "set", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.settings,
      N_ ("Change a number of the law, or its basis"), N_ ("KEY=VALUE") },
    { "path", 0, 0, G_OPTION_ARG_STRING, &options.path,
      N_ ("Elongations (strains in the material basis) to go through, from 0"),
      N_ ("E1,E2,…") },
    { "length", 0, 0, G_OPTION_ARG_DOUBLE, &options.length,
      N_ ("Length of the block's side, m, for the material basis (0.1)"), N_ ("M") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    G_OPTION_ENTRY_NULL,
  };
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = show (self, &options, argv[1]);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_law = {
  .name = "law",
  .arguments = "elastic|no-tension|coulomb|mohr-coulomb|bilinear|elastic-plastic|"
               "concrete|steel|curve|NAME",
  .summary = N_ ("Show how a constitutive law responds to a history of elongations"),
  .help =
    N_ ("A kind has typical numbers; NAME is a law of the project that --model names. "
        "Without --plot the table goes to standard output."),
  .run = run_law,
};
