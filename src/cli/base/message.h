/* What quoin-cli says: on standard error one line per message, "quoin-cli: " in front; on standard output
 * text for a terminal; and how it ends.
 *
 * A command that cannot go on ends the program there and then. Functions below that say so do not come
 * back, but are neither declared like that nor beside qn_cli_stop(), which shows it: what their callers hold
 * stays within reach, where tools that look for leaks find it. What is made for the whole command is never freed (qn_cli_keep()).
 *
 * Names and titles come from files of anybody: an escape sequence in one could rewrite the window's title, hide
 * lines or turn their order, so it is shown as \u001b.
 */
#pragma once

#include <glib.h>

/* Exit codes; scripts rely on them. */
typedef enum {
  QN_EXIT_DONE = 0,       /* a collapse that was found is a success */
  QN_EXIT_INTERNAL = 1,   /* the program failed; a published case was missed (verify) */
  QN_EXIT_USAGE = 2,      /* unknown option or subcommand, missing argument */
  QN_EXIT_INVALID = 3,    /* the input breaks a rule */
  QN_EXIT_NO_ANSWER = 4,  /* dead load does not stand, or the analysis did not converge */
  QN_EXIT_FILE = 5,       /* a file cannot be read or written */
  QN_EXIT_CANCELLED = 130 /* by Ctrl+C; what had converged is kept */
} QnExit;

/* Line breaks inside the message become spaces: a message stays one line whatever names and paths it
 * quotes. */
void qn_cli_error (const char *format, ...) G_GNUC_PRINTF (1, 2);
void qn_cli_warning (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* The subcommand that runs, for what follows; borrowed for good. */
void qn_cli_set_subcommand (const char *subcommand);

/* Completes standard output and ends the program; with a message before. */
void qn_cli_stop (QnExit code);
void qn_cli_fail (QnExit code, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* Keeps memory, and all that it holds, until the program ends; returns it. */
void *qn_cli_keep (void *memory);

/* Ends the program for wrong usage: the message and where help is to be found. */
void qn_cli_usage_error (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* The same for the value of an option that is none of these. */
void qn_cli_refuse_name (const char *value, const char *const *names, size_t count);

/* An override that the subcommand puts before those of the user: where an error names it as what set a
 * value, the subcommand is named instead. Borrowed for good. */
void qn_cli_set_own_override (const char *override);

/* The subcommand has --allow-outside: an error about a file outside the project's folder names it. */
void qn_cli_offer_outside (void);

/* What a call has to say that did not succeed, for qn_cli_must(). */
extern GError *qn_cli_trouble;
#define QN_TROUBLE (&qn_cli_trouble)

/* Goes on where a call with QN_TROUBLE was done; else prints the trouble and ends the program. */
void qn_cli_must (gboolean done);

/* Ends the program since the analysis of this project was cancelled. */
void qn_cli_cancelled (const char *project);

/* The text with all control characters but tab and line break, and those that turn the direction of
 * writing, as \uXXXX; bytes that are no UTF-8 as \xXX. Free with g_free(). */
char *qn_shown_text_dup (const char *text);

/* Prints on standard output, as qn_text_printf() writes: a line break in a name begins no line, and what
 * is no number is shown as "–" and ends the program with QN_EXIT_NO_ANSWER. Files that are written there
 * ("-o -") do not go this way. */
void qn_print (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* The same of lines that are complete. */
void qn_print_text (const char *text);

/* Completes standard output; the exit code of a program that would end with this one. */
QnExit qn_cli_complete (QnExit code);
