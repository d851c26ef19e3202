/* A project with its contacts, as every subcommand that reads a MODEL needs it. */
#pragma once

#include "cli/base/exit-code.h"
#include "doc/view/sheet.h"
#include "io/result/result-file.h"

/* How a MODEL is read: options that all subcommands which read one take alike. */
typedef struct QnInputOptions {
  char **overrides;       /* of --set; NULL where there are none */
  gboolean allow_outside; /* files that the project names may lie outside its folder */
} QnInputOptions;

/* Entries for a GOptionEntry array; `options` is a QnInputOptions. */
/* clang-format off */
#define QN_INPUT_ENTRIES(options)                                                        \
  { "set", 0, 0, G_OPTION_ARG_STRING_ARRAY, &(options).overrides,                        \
    N_ ("Override any key of the project file, e.g. analysis.increments=37"),            \
    N_ ("PATH=VALUE") },                                                                 \
  { "allow-outside", 0, 0, G_OPTION_ARG_NONE, &(options).allow_outside,                  \
    N_ ("Use files that the project names outside its folder"), NULL }
/* clang-format on */

/* The option --no-timings. */
#define QN_INPUT_TIMINGS_ENTRY(variable)                                                 \
  {                                                                                      \
    "no-timings", 0, 0, G_OPTION_ARG_NONE, (variable),                                   \
      N_ ("Leave times and memory out of the result: two runs give equal bytes"), NULL   \
  }

/* The option --quiet. */
#define QN_INPUT_QUIET_ENTRY(variable)                                                   \
  {                                                                                      \
    "quiet", 'q', 0, G_OPTION_ARG_NONE, (variable),                                      \
      N_ ("Print errors and warnings only"), NULL                                        \
  }

typedef struct QnInput {
  QnProject project;
  QnContacts contacts;
  QnResultFile
    file; /* that was read with it; only `result` is filled where it was computed here */
} QnInput;

/* Puts an override before those of the user, or behind them. */
void qn_input_override (QnInputOptions *options, const char *override, gboolean before);

/* Reads the project and detects its contacts, for the rest of the program. Warnings about the file go to
 * standard error; what cannot be read ends the program, as in all functions below. */
QnInput *qn_input_load (const char *path, const QnInputOptions *options);

/* The same without a word about warnings. */
QnInput *qn_input_read (const char *path, const QnInputOptions *options);

/* What every analysis of the project does first: reads the ground motions that it names, refuses
 * what qn_input_require_sound() does and a path without a live load. */
void qn_input_prepare (QnInput *input, const QnInputOptions *options);

/* Refuses what cannot be analysed, as qn_contacts_require_sound() does; else says what is to be looked at:
 * gaps, loose blocks, numbers that are hardly meant. */
void qn_input_require_sound (const QnInput *input);

/* Tells the user what is wrong with the project and where, and ends the program. */
void qn_input_refuse (const QnProject *project, const QnDiag *diag);

/* What an analysis was about. */
typedef enum { QN_INPUT_DEAD_LOAD, QN_INPUT_PATH } QnInputState;

/* Tells the user why an analysis failed, and ends the program: with QN_EXIT_NO_ANSWER where not the input
 * but the state that was found is the reason. */
void qn_input_fail (const QnInput *input, QnInputState state, const QnDiag *diag);

/* Reads a result file and the project with the overrides that the result was computed with;
 * those of `options` come after them. Refuses a result that is not of this project. */
QnInput *qn_input_load_with_result (const char *path, const char *result_path,
                                    const QnInputOptions *options);

/* The same of a result that has been read already and is taken over. *same_bytes: whether the project is
 * what it was then, byte for byte. */
QnInput *qn_input_load_for_result (const QnResultFile *file, const char *path,
                                   const char *result_path, const QnInputOptions *options,
                                   gboolean *same_bytes);

/* Solves the project. An end without an answer is a warning: what there is can be shown. */
void qn_input_solve (QnInput *input, const QnInputOptions *options);

/* Reads a project with the result of that name, or solves it where `result` is NULL. */
QnInput *qn_input_load_or_solve (const char *path, const char *result,
                                 const QnInputOptions *options);

/* Loads count arguments of the form MODEL[=RESULT], or solves those without a result. An argument that is
 * itself the name of a file is taken as that, "=" or not. The runs, for the rest of the program, are named
 * by their results. */
QnSheetRun *qn_input_load_runs (char **arguments, gsize count,
                                const QnInputOptions *options);
