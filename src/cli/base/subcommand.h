/* Subcommands of quoin-cli.
 *
 * Each lives in a file cmd-NAME.c that defines one QnSubcommand; the table in main.c lists
 * them in the order of the overall help. A new one needs these three: its file, a line below
 * and a line in the table.
 */
#pragma once

#include <glib.h>

typedef struct QnSubcommand QnSubcommand;

struct QnSubcommand {
  const char *name;
  const char *arguments; /* what stands behind the name in the usage line: "MODEL" */
  const char *summary;   /* one line, no full stop; translatable (N_) */
  const char *help;      /* what --help says below the options; translatable, or NULL */
  const GOptionEntry *options; /* to G_OPTION_ENTRY_NULL; NULL: none but --help */
  /* NULL-terminated: `run` chooses one of these by its first argument, and parses nothing before. */
  const QnSubcommand *const *actions;

  gboolean many,
    optional;    /* it takes any number of arguments, or one at most; else one */
  gboolean keys; /* options that it has not stay among its arguments, with their values */

  /* `arguments`: what is no option, NULL-terminated. Where it comes back all is done; else it ends the program
   * (message.h). */
  void (*run) (char **arguments);
};

extern const QnSubcommand qn_cmd_capacity;
extern const QnSubcommand qn_cmd_check;
extern const QnSubcommand qn_cmd_solve;
extern const QnSubcommand qn_cmd_envelope;
extern const QnSubcommand qn_cmd_limit;
extern const QnSubcommand qn_cmd_render;
extern const QnSubcommand qn_cmd_animate;
extern const QnSubcommand qn_cmd_compare;
extern const QnSubcommand qn_cmd_curve;
extern const QnSubcommand qn_cmd_figures;
extern const QnSubcommand qn_cmd_generate;
extern const QnSubcommand qn_cmd_law;
extern const QnSubcommand qn_cmd_ida;
extern const QnSubcommand qn_cmd_import;
extern const QnSubcommand qn_cmd_export;
extern const QnSubcommand qn_cmd_report;
extern const QnSubcommand qn_cmd_modal;
extern const QnSubcommand qn_cmd_stability;
extern const QnSubcommand qn_cmd_study;
extern const QnSubcommand qn_cmd_verify;

/* Asked for by this word alone, a subcommand describes itself instead: see qn_subcommand_run(). */
#define QN_DESCRIBE "--describe"

/* Runs a subcommand; argv[0] is its own name. Options are parsed in the usual way: options and arguments in
 * any order, "--" ends the options, --help prints the help of the subcommand and ends the program, and so does
 * an unknown option or a wrong number of arguments. The values of options are kept until the program ends.
 * QN_DESCRIBE prints the subcommand and its options as lines with tabs, of which the build makes manual pages
 * and completions. */
void qn_subcommand_run (const QnSubcommand *self, int argc, char **argv);

/* --quiet was not given, and no output of the subcommand is standard output ("-"). */
gboolean qn_subcommand_prints (void);
