#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "doc/text/law-text.h"
#include "io/project/project.h"
#include "io/text/file-writer.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

static char *law_csv, *law_model, *law_path;
static char **law_settings;
static double law_length = 0.1;

static const GOptionEntry law_entries[] = {
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &law_csv,
    N_ ("Write the history as a table here; - is standard output"), N_ ("OUT.csv") },
  { "plot", 0, 0, G_OPTION_ARG_FILENAME, &qn_picture.path, N_ ("Draw the history here"),
    N_ ("OUT.png|svg|pdf") },
  { "model", 0, 0, G_OPTION_ARG_FILENAME, &law_model,
    N_ ("Take the law of this name from a project"), N_ ("MODEL") },
  { "set", 0, 0, G_OPTION_ARG_STRING_ARRAY, &law_settings,
    N_ ("Change a number of the law, or its basis"), N_ ("KEY=VALUE") },
  { "path", 0, 0, G_OPTION_ARG_STRING, &law_path,
    N_ ("Elongations (strains in the material basis) to go through, from 0"),
    N_ ("E1,E2,…") },
  { "length", 0, 0, G_OPTION_ARG_DOUBLE, &law_length,
    N_ ("Length of the block's side, m, for the material basis (0.1)"), N_ ("M") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf")),
  G_OPTION_ENTRY_NULL,
};

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

static void
apply_setting (QnLaw *law, const char *setting)
{
  g_auto (GStrv) parts = g_strsplit (setting, "=", 2);
  if (parts[0] == NULL || parts[1] == NULL)
    qn_cli_usage_error (_ ("“%s” is not KEY=VALUE"), setting);
  if (strcmp (parts[0], "basis") == 0) {
    if (!qn_find_word (parts[1], qn_basis_names, QN_BASIS_COUNT, &law->basis))
      qn_cli_usage_error (_ ("no basis is called “%s”"), parts[1]);
    return;
  }
  double *number = find_number (law, parts[0]);
  if (number == NULL)
    qn_cli_usage_error (_ ("this kind of law has no “%s”"), parts[0]);
  if (!parse_number (parts[1], number))
    qn_cli_usage_error (_ ("“%s” is not a number"), parts[1]);
}

static void
prepare (const char *name, History *history)
{
  QnLawPreset *what = &history->what;
  QnDiag diag = { 0 };
  QnLawKind kind = QN_LAW_ELASTIC;
  if (law_model != NULL) {
    QnProject *project = qn_cli_keep (g_new0 (QnProject, 1));
    qn_cli_must (qn_project_load (law_model, NULL, project, QN_TROUBLE));
    QnId id = qn_model_find_law (&project->model, name);
    if (id == QN_NONE)
      qn_cli_fail (QN_EXIT_INVALID, _ ("%s: no law is called “%s”"), law_model, name);
    *what = *qn_law_preset (project->model.laws[id].kind);
    what->law = project->model.laws[id];
    what->law.name = what->law.source = NULL;
  } else if (qn_find_word (name, qn_law_kind_names, QN_LAW_KIND_COUNT, &kind))
    *what = *qn_law_preset (kind);
  else
    qn_cli_usage_error (_ ("no law is called “%s”"), name);
  for (char **setting = law_settings; setting && *setting; setting++)
    apply_setting (&what->law, *setting);
  if (law_path != NULL) {
    g_auto (GStrv) parts = g_strsplit (law_path, ",", -1);
    gsize count = g_strv_length (parts);
    gboolean good = count >= 1 && count <= QN_LAW_MAX_TURNS;
    for (gsize i = 0; i < count && good; i++)
      good = parse_number (parts[i], &what->turns[i]);
    what->turn_count = count;
    if (!good)
      qn_cli_usage_error (_ ("--path takes 1 to 64 elongations with commas between"));
  }
  if (!(law_length > 0 && isfinite (law_length)))
    qn_cli_usage_error (_ ("--length must be positive"));

  QnLaw named = what->law;
  named.name = (char *) name;
  if (qn_law_check (&named, 0, &diag) != QN_OK)
    qn_cli_fail (QN_EXIT_INVALID, "%s: %s", diag.field,
                 _ (qn_problem_text (diag.problem)));
  history->length = what->law.basis == QN_BASIS_MATERIAL ? law_length : 1;
}

static void
write_history (const History *history, const char *path)
{
  static const char *const units[QN_BASIS_COUNT][3] = {
    [QN_BASIS_CONTACT] = { "m", "N", "N/m" },
    [QN_BASIS_SURFACE] = { "m", "Pa", "Pa/m" },
    [QN_BASIS_MATERIAL] = { "-", "Pa", "Pa" },
  };
  const char *const *unit = units[history->what.law.basis];
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_printf (writer,
                         "normal elongation [%s],tangential elongation [%s],normal force "
                         "[%s],shear force [%s],normal tangent [%s],shear tangent [%s]\n",
                         unit[0], unit[0], unit[1], unit[1], unit[2], unit[2]);
  for (guint i = 0; i < history->samples->len; i++) {
    const QnLawSample *s = &g_array_index (history->samples, QnLawSample, i);
    qn_file_writer_csv (writer, "%g,%g,%g,%g,%g,%g\n", s->elongation[0], s->elongation[1],
                        s->force[0], s->force[1], s->tangent[0], s->tangent[1]);
  }
  qn_cli_must (qn_file_writer_commit (writer, QN_TROUBLE));
}

static void
run_law (char **arguments)
{
  const char *name = arguments[0];
  History history = { .samples =
                        qn_cli_keep (g_array_new (FALSE, FALSE, sizeof (QnLawSample))) };
  prepare (name, &history);
  qn_picture_if_any ();
  if (!qn_law_trace (&history.what, history.length, history.samples))
    qn_cli_fail (QN_EXIT_INVALID, "%s",
                 _ (qn_problem_text (QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL)));
  if (qn_picture.path != NULL) {
    g_autoptr (QnPlot) plot = qn_law_plot (&history.what, history.samples);
    qn_picture_plot (plot, name, NULL);
  }
  if (law_csv != NULL || qn_picture.path == NULL)
    write_history (&history, law_csv != NULL ? law_csv : "-");
}

const QnSubcommand qn_cmd_law = {
  .name = "law",
  .arguments = "elastic|no-tension|coulomb|mohr-coulomb|bilinear|elastic-plastic|"
               "concrete|steel|curve|NAME",
  .summary = N_ ("Show how a constitutive law responds to a history of elongations"),
  .help =
    N_ ("A kind has typical numbers; NAME is a law of the project that --model names. "
        "Without --plot the table goes to standard output."),
  .options = law_entries,
  .run = run_law,
};
