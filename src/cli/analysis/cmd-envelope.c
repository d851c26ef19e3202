#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "doc/view/sheet.h"
#include "io/project/project-vehicle.h"
#include "study/report/envelope-figure.h"

#include <glib/gi18n.h>

static char *envelope_table, *envelope_vehicles;
static gboolean envelope_one_way, envelope_path;

/* What was given goes before what the project says. */
static QnEnvelopeSettings envelope_settings = { .from = G_MAXDOUBLE,
                                                .to = G_MAXDOUBLE,
                                                .step = G_MAXDOUBLE };

/* Options that are not wrong in themselves are those of the project. */
static void
choose_settings (QnInput *input, QnEnvelopeSettings *settings)
{
  const QnEnvelopeSettings *given = &envelope_settings;
  qn_cli_must (qn_envelope_settings_read (&input->project, settings, QN_TROUBLE));
  qn_cli_must (
    envelope_vehicles == NULL
    || qn_read_vehicle_file (envelope_vehicles, &input->project.model, QN_TROUBLE));
  if (given->vehicles != NULL) {
    g_strfreev (settings->vehicles);
    settings->vehicles = g_strdupv (given->vehicles);
  }
  if (given->from != G_MAXDOUBLE)
    settings->from = given->from;
  if (given->to != G_MAXDOUBLE)
    settings->to = given->to;
  if (given->step != G_MAXDOUBLE)
    settings->step = given->step;
  if (envelope_one_way)
    settings->ways = QN_WAYS_RIGHT;
  if (envelope_path)
    settings->method = QN_ENVELOPE_PATH;
}

static const GOptionEntry envelope_entries[] = {
  { "vehicle", 0, 0, G_OPTION_ARG_STRING_ARRAY, &envelope_settings.vehicles,
    N_ ("Instead of the project's vehicle, one of its list or built in; may be "
        "given several times"),
    N_ ("NAME") },
  { "vehicles", 0, 0, G_OPTION_ARG_FILENAME, &envelope_vehicles,
    N_ ("Read more vehicles from this file"), N_ ("FILE.json") },
  { "from", 0, 0, G_OPTION_ARG_DOUBLE, &envelope_settings.from,
    N_ ("First position of the front, m"), N_ ("X") },
  { "to", 0, 0, G_OPTION_ARG_DOUBLE, &envelope_settings.to, N_ ("Last position, m"),
    N_ ("X") },
  { "step", 0, 0, G_OPTION_ARG_DOUBLE, &envelope_settings.step,
    N_ ("Distance of positions, m (0.25)"), N_ ("LENGTH") },
  { "one-way", 0, 0, G_OPTION_ARG_NONE, &envelope_one_way,
    N_ ("Only to the right; without it to the left too"), NULL },
  { "path", 0, 0, G_OPTION_ARG_NONE, &envelope_path,
    N_ ("Follow the path by the project's procedure instead of limit analysis"), NULL },
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &envelope_table,
    N_ ("Write the multipliers as a table"), N_ ("TABLE.csv") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf")),
  QN_INPUT_ENTRIES,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

static void
run_envelope (char **arguments)
{
  qn_picture_if_any ();
  QnInput *input = qn_input_load (arguments[0]);
  qn_input_require_sound (input);
  QnEnvelope *e = qn_cli_keep (g_new0 (QnEnvelope, 1));
  QnEnvelopeSettings settings = { 0 };
  QnEnvelopePlace worst;
  QnMetadata metadata;
  choose_settings (input, &settings);
  if (!qn_envelope_init (e, &input->project.model, &settings, QN_TROUBLE))
    qn_cli_usage_error ("%s", qn_cli_trouble->message);
  qn_envelope_settings_clear (&settings);
  QnDiag diag = { 0 };
  qn_terminal_progress_begin ();
  QnStatus status = qn_envelope_run (e, qn_terminal_progress_update, NULL, &diag);
  qn_terminal_progress_done ();
  if (qn_interrupt_seen ())
    qn_cli_cancelled (input->project.name);
  if (status != QN_OK)
    qn_input_fail (input, QN_INPUT_PATH, &diag);
  if (e->unstable)
    qn_cli_fail (QN_EXIT_NO_ANSWER, _ ("%s: no stable equilibrium under the dead load"),
                 input->project.name);
  if (!qn_envelope_find_least (e, &worst))
    qn_cli_fail (QN_EXIT_NO_ANSWER, _ ("%s: no position gives a collapse"),
                 input->project.name);
  if (qn_subcommand_prints ()) {
    const QnEnvelopeLine *line = &e->lines[worst.line];
    g_autofree char *text = qn_envelope_dup_text (e, worst, TRUE);
    g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
    for (gsize i = 0; lines[i] != NULL; i++)
      qn_print ("%s\n", lines[i]);
    qn_print (_ ("that position: --set loads.live[%d].position=%.15g --set "
                 "loads.live[%d].reversed=%s\n"),
              (int) e->load, e->x[worst.position], (int) e->load,
              line->reversed ? "true" : "false");
  }
  qn_cli_must (envelope_table == NULL
               || qn_envelope_write_table (e, envelope_table, QN_TROUBLE));
  qn_project_get_metadata (&input->project, &metadata);
  metadata.title = e->model.title;
  qn_cli_must (qn_picture.path == NULL
               || qn_envelope_export (e, worst, qn_picture.path, &qn_picture.output,
                                      &metadata, QN_TROUBLE));
}

const QnSubcommand qn_cmd_envelope = {
  .name = "envelope",
  .arguments = "MODEL",
  .summary = N_ ("Move a vehicle over a bridge and find where it carries least"),
  .help =
    N_ ("The first vehicle among the live loads is moved from place to place, to the "
        "right and to the left. The least multiplier is the adequacy factor. Picture: "
        "the bridge as it collapses at the worst position, and below it the multiplier "
        "over the position."),
  .options = envelope_entries,
  .run = run_envelope,
};
