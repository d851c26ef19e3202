/* A project with its contacts, as every subcommand that reads a MODEL needs it. */
#pragma once

#include "cli/base/message.h"
#include "doc/view/sheet.h"
#include "io/result/result-file.h"

/* How a MODEL is read, by options that all subcommands which read one take alike: overrides of --set (NULL
 * where there are none); files that the project names may lie outside its folder. */
extern char **qn_overrides;
extern gboolean qn_allow_outside;

/* Entries for a GOptionEntry array. */
/* clang-format off */
#define QN_INPUT_ENTRIES                                                                 \
  { "set", 0, 0, G_OPTION_ARG_STRING_ARRAY, &qn_overrides,                               \
    N_ ("Override any key of the project file, e.g. analysis.increments=37"),            \
    N_ ("PATH=VALUE") },                                                                 \
  { "allow-outside", 0, 0, G_OPTION_ARG_NONE, &qn_allow_outside,                         \
    N_ ("Use files that the project names outside its folder"), NULL }
/* clang-format on */

/* The option --no-timings, and what it does. */
#define QN_TIMINGS_ENTRY                                                                 \
  {                                                                                      \
    "no-timings", 0, 0, G_OPTION_ARG_NONE, &qn_no_timings,                               \
      N_ ("Leave times and memory out of the result: two runs give equal bytes"), NULL   \
  }
extern gboolean qn_no_timings;

typedef struct QnInput {
  QnProject project;
  QnContacts contacts;
  QnResultFile
    file; /* that was read with it; only `result` is filled where it was computed here */
} QnInput;

/* Puts an override before those of the user, or behind them. */
void qn_input_override (const char *override, gboolean before);

/* Reads the project and detects its contacts, for the rest of the program. Warnings about the file go to
 * standard error; what cannot be read ends the program, as in all functions below. */
QnInput *qn_input_load (const char *path);

/* The same without a word about warnings. */
QnInput *qn_input_read (const char *path);

/* What every analysis of the project does first: reads the ground motions that it names, refuses
 * what qn_input_require_sound() does and a path without a live load. */
void qn_input_prepare (QnInput *input);

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

/* Reads a project and, unless its path is NULL, a result with the overrides that it was computed with;
 * those of the user come after them. Refuses a result that is not of this project. */
QnInput *qn_input_load_with_result (const char *path, const char *result_path);

/* The same of a result that has been read already and is taken over. *same_bytes: whether the project is
 * what it was then, byte for byte. */
QnInput *qn_input_load_for_result (const QnResultFile *file, const char *path,
                                   const char *result_path, gboolean *same_bytes);

/* Solves the project. An end without an answer is a warning: what there is can be shown. */
void qn_input_solve (QnInput *input);

/* Reads a project with the result of that name, or solves it where `result` is NULL. */
QnInput *qn_input_load_or_solve (const char *path, const char *result);

/* Loads count arguments of the form MODEL[=RESULT], or solves those without a result. An argument that is
 * itself the name of a file is taken as that, "=" or not. The runs, for the rest of the program, are named
 * by their results. */
QnSheetRun *qn_input_load_runs (char **arguments, gsize count);
