#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/modal/modal.h"
#include "io/text/file-writer.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>

static char *modal_output, *modal_csv;
static int modal_count = 10, modal_mode = 1;
static double modal_damping;
static gboolean modal_loaded, modal_slip;

static void
write_modes (const QnModel *model, const QnModes *modes)
{
  QnFileWriter *writer = qn_file_writer_open (modal_csv);
  qn_file_writer_puts (writer,
                       "mode,omega [rad/s],frequency [Hz],block number,x [m],y [m],"
                       "ux [m],uy [m],rz [rad]\n");
  for (size_t i = 0; i < modes->count; i++)
    for (size_t b = 0, bodies = modes->block_count + modes->node_count; b < bodies; b++) {
      const double *shape = modes->shapes + (i * bodies + b) * QN_DOF_COUNT;
      const QnVec2 at = b < modes->block_count ? model->blocks[b].centroid
                                               : model->nodes[b - modes->block_count].at;
      qn_file_writer_csv (writer, "%zu,%g,%g,%zu,%g,%g,%g,%g,%g\n", i + 1,
                          modes->omega[i], modes->omega[i] / (2 * G_PI), b, at.x, at.y,
                          shape[QN_DOF_UX], shape[QN_DOF_UY], shape[QN_DOF_RZ]);
    }
  qn_cli_must (qn_file_writer_commit (writer, QN_TROUBLE));
}

static void
print_modes (const QnInput *input, const QnModes *modes)
{
  qn_print ("%6s  %14s  %14s  %14s  %14s  %14s\n", _ ("mode"), _ ("omega [rad/s]"),
            _ ("frequency [Hz]"), _ ("period [s]"), _ ("mass in x [kg]"),
            _ ("mass in y [kg]"));
  for (size_t i = 0; i < modes->count; i++) {
    double hertz = modes->omega[i] / (2 * G_PI);
    qn_print ("%6zu  %14.6f  %14.6f  ", i + 1, modes->omega[i], hertz);
    if (hertz > 0)
      qn_print ("%14.6g", 1 / hertz);
    else
      qn_print ("%14s", _ ("rigid motion"));
    qn_print ("  %14.6g  %14.6g\n", modes->masses[3 * i + 1], modes->masses[3 * i + 2]);
  }
  if (modal_damping > 0) {
    const QnModesDamping damping = qn_modes_damping (modes, modal_damping);
    qn_print (
      _ ("damping by mass %.6g 1/s and by stiffness %.6g s: %.4g of critical for modes "
         "%zu and %zu\n"),
      damping.mass, damping.stiffness, modal_damping, damping.first + 1,
      damping.last + 1);
  }
  if (modes->open + modes->slides > 0)
    qn_print (_ ("closed joints are elastic, also %zu contact pairs that slide under the "
                 "load; %zu of %zu, which are open or carry no compression, are left "
                 "out\n"),
              modes->slides, modes->open, input->contacts.pair_count);
}

static const GOptionEntry modal_entries[] = {
  { "count", 'n', 0, G_OPTION_ARG_INT, &modal_count, N_ ("How many modes (10)"),
    N_ ("N") },
  { "loaded", 0, 0, G_OPTION_ARG_NONE, &modal_loaded,
    N_ ("About the last equilibrium of the analysis instead of the dead load's"), NULL },
  { "damping", 0, 0, G_OPTION_ARG_DOUBLE, &modal_damping,
    N_ ("Print the damping coefficients that give the first and the last mode this "
        "fraction of critical damping"),
    N_ ("RATIO") },
  { "slip", 0, 0, G_OPTION_ARG_NONE, &modal_slip,
    N_ ("With the tangent of joints that slide; else closed joints are elastic"), NULL },
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &modal_csv,
    N_ ("Write frequencies and shapes here; - is standard output"), N_ ("OUT.csv") },
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &modal_output,
    N_ ("Write a result here whose mechanism is the mode of --mode"),
    N_ ("RESULT.json") },
  { "mode", 0, 0, G_OPTION_ARG_INT, &modal_mode, N_ ("Number of the mode, from 1 (1)"),
    N_ ("K") },
  QN_INPUT_ENTRIES,
  QN_TIMINGS_ENTRY,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

static void
run_modal (char **arguments)
{
  if (modal_count < 1 || modal_mode < 1)
    qn_cli_usage_error (_ ("--count and --mode count from 1"));
  if (!(modal_damping >= 0 && modal_damping < 1))
    qn_cli_usage_error (_ ("--damping is from 0 to less than 1"));
  const QnInput *input = qn_input_load (arguments[0]);
  QnModes modes;
  QnResult result;
  QnDiag diag = { 0 };

  qn_terminal_progress_begin ();
  QnStatus status = qn_modal_run (&input->project.model, &input->contacts,
                                  (modal_loaded ? QN_MODAL_LOADED : QN_MODAL_DEAD_LOAD)
                                    | (modal_slip ? QN_MODAL_SLIDING : 0),
                                  (size_t) modal_count, qn_terminal_progress_update, NULL,
                                  &modes, &result, &diag);
  qn_terminal_progress_done ();
  if (status != QN_OK)
    qn_input_fail (input, modal_loaded ? QN_INPUT_PATH : QN_INPUT_DEAD_LOAD, &diag);
  if (qn_no_timings)
    qn_statistics_clear_timings (&result.statistics);
  if (result.outcome == QN_OUTCOME_CANCELLED)
    qn_cli_cancelled (input->project.name);
  if (result.stop == QN_STOP_FACTORIZATIONS || result.stop == QN_STOP_TIME
      || result.stop == QN_STOP_CHECK) {
    g_autofree char *reason = qn_outcome_dup_reason (&input->project.model, &result);
    qn_cli_fail (QN_EXIT_NO_ANSWER, "%s: %s", input->project.name, reason);
  }
  if (modes.count == 0)
    qn_cli_fail (QN_EXIT_NO_ANSWER,
                 _ ("%s: no equilibrium was found, so there are no vibrations about it"),
                 input->project.name);
  if (qn_subcommand_prints ())
    print_modes (input, &modes);
  if (modal_csv != NULL)
    write_modes (&input->project.model, &modes);
  if (modal_output != NULL) {
    /* A result whose mechanism is one of the modes, for pictures and animations. */
    if ((size_t) modal_mode > modes.count)
      qn_cli_fail (QN_EXIT_INVALID, _ ("there is no mode %d: only %zu were found"),
                   modal_mode, modes.count);
    if (qn_modes_show (&modes, (size_t) modal_mode - 1, &input->project.model, &result,
                       &diag)
        != QN_OK)
      qn_cli_fail (QN_EXIT_INTERNAL, _ ("not enough memory"));
    qn_cli_must (qn_result_file_write (modal_output, &input->project, &input->contacts,
                                       &result, QN_DETAIL_FORCES, QN_TROUBLE));
  }
  qn_modes_clear (&modes);
  qn_result_clear (&result);
}

const QnSubcommand qn_cmd_modal = {
  .name = "modal",
  .arguments = "MODEL",
  .summary = N_ ("Frequencies and modes of small vibrations"),
  .help = N_ (
    "Blocks vibrate with their mass, weight over gravity, on their joints: closed ones "
    "are elastic, open ones are left out; with --slip on the tangent stiffness. Beside "
    "each mode stand its effective masses in x and y, which sum up to all that moves. A "
    "result written with --output can be drawn and animated "
    "like a mechanism. Structures without supports have rigid motions of "
    "frequency zero."),
  .options = modal_entries,
  .run = run_modal,
};
