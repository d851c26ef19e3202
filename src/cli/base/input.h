/* A project with its contacts, as every subcommand that reads a MODEL needs it. */
#pragma once

#include "cli/base/exit-code.h"
#include "io/project/project.h"
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
} QnInput;

/* Reads the project and detects its contacts. Warnings about the file go to standard error.
 * On failure the user has been told, *input is empty and the exit code is returned;
 * QN_EXIT_DONE otherwise. */
QnExit qn_input_load (QnInput *input, const char *path, const QnInputOptions *options);

/* The same without a word about warnings. */
QnExit qn_input_read (QnInput *input, const char *path, const QnInputOptions *options);

/* What every analysis of the project does first: reads the ground motions that it names, refuses
 * what qn_input_require_sound() does and a path without a live load. On failure the user has been
 * told. */
QnExit qn_input_prepare (QnInput *input, const QnInputOptions *options);

/* Refuses what cannot be analysed, as qn_contacts_require_sound() does, and tells the user; else says
 * what is to be looked at: gaps, loose blocks, numbers that are hardly meant. */
QnExit qn_input_require_sound (const QnInput *input);

/* Tells the user what is wrong with the project and where, and says how the program ends. */
QnExit qn_input_refuse (const QnProject *project, const QnDiag *diag);

/* What an analysis was about. */
typedef enum { QN_INPUT_DEAD_LOAD, QN_INPUT_PATH } QnInputState;

/* Tells the user why an analysis failed, and says how the program ends: QN_EXIT_NO_ANSWER where
 * not the input but the state that was found is the reason. */
QnExit qn_input_fail (const QnInput *input, QnInputState state, const QnDiag *diag);

/* Reads a result file and the project with the overrides that the result was computed with;
 * those of `options` come after them. Refuses a result that is not of this project. */
QnExit qn_input_load_with_result (QnInput *input, QnResultFile *file, const char *path,
                                  const char *result_path, const QnInputOptions *options);

/* The same of a result that has been read already; where it is refused, it is cleared.
 * *same_bytes: whether the project is what it was then, byte for byte. */
QnExit qn_input_load_for_result (QnInput *input, QnResultFile *file, const char *path,
                                 const char *result_path, const QnInputOptions *options,
                                 gboolean *same_bytes);

void qn_input_clear (QnInput *input);
