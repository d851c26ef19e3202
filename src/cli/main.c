/* quoin-cli: Quoin without a display. */
#include "cli/base/message.h"
#include "cli/base/subcommand.h"

#include <glib/gi18n.h>
#include <locale.h>
#include <signal.h>
#include <string.h>

static const QnSubcommand *const subcommands[] = {
  &qn_cmd_check,   &qn_cmd_solve,   &qn_cmd_limit,  &qn_cmd_envelope,  &qn_cmd_render,
  &qn_cmd_animate, &qn_cmd_compare, &qn_cmd_curve,  &qn_cmd_generate,  &qn_cmd_import,
  &qn_cmd_export,  &qn_cmd_law,     &qn_cmd_modal,  &qn_cmd_stability, &qn_cmd_capacity,
  &qn_cmd_ida,     &qn_cmd_figures, &qn_cmd_report, &qn_cmd_study,     &qn_cmd_verify,
};

int
main (int argc, char **argv)
{
  setlocale (LC_ALL, "");
  /* Numbers look the same everywhere, in files and reports; in pictures they go with the words. */
  setlocale (LC_NUMERIC, "C");
  bindtextdomain (GETTEXT_PACKAGE, QN_LOCALE_DIR);
  bind_textdomain_codeset (GETTEXT_PACKAGE, "UTF-8");
  textdomain (GETTEXT_PACKAGE);
  g_set_prgname ("quoin-cli");
  /* A file beyond what the user may write is an error like others, not a reason to end
   * the program. */
  signal (SIGXFSZ, SIG_IGN);

  if (argc < 2)
    qn_cli_usage_error (_ ("a subcommand is missing"));
  if (strcmp (argv[1], "--help") == 0 || strcmp (argv[1], "-h") == 0) {
    qn_print (
      _ ("Usage: quoin-cli SUBCOMMAND [OPTION…] ARGUMENT…\n\n"
         "Block masonry: contacts, load path, collapse mechanism and pictures.\n\n"
         "Subcommands:\n"));
    for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++)
      qn_print ("  %-10s%s\n", subcommands[i]->name, _ (subcommands[i]->summary));
    qn_print (
      _ ("\n\"quoin-cli SUBCOMMAND --help\" explains one of them; --version tells the "
         "version.\n\n"
         "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 invalid input, 4 no "
         "answer,\n5 file cannot be read or written, 130 cancelled.\n"));
  } else if (strcmp (argv[1], "--version") == 0) {
    qn_print ("quoin %s\n", QN_VERSION);
  } else if (strcmp (argv[1], QN_DESCRIBE) == 0) {
    /* What data/commands.py reads. */
    for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++)
      qn_subcommand_run (subcommands[i], argc, argv);
  } else {
    const QnSubcommand *subcommand = NULL;
    for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++)
      if (strcmp (subcommands[i]->name, argv[1]) == 0)
        subcommand = subcommands[i];
    if (subcommand == NULL)
      qn_cli_usage_error (argv[1][0] == '-' ? _ ("unknown option %s")
                                            : _ ("unknown subcommand %s"),
                          argv[1]);
    qn_subcommand_run (subcommand, argc - 1, argv + 1);
  }
  return (int) qn_cli_complete (QN_EXIT_DONE);
}
