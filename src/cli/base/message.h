/* What quoin-cli says on standard error: one line per message, "quoin-cli: " in front; and how it ends.
 *
 * A command that cannot go on ends the program there and then. Functions below that say so do not come
 * back, but are neither declared like that nor beside qn_cli_stop(), which shows it: what their callers hold
 * stays within reach, where tools that look for leaks find it. What is made for the whole command is never freed (qn_cli_keep()). */
#pragma once

#include "cli/base/exit-code.h"

#include <glib.h>

/* Line breaks inside the message become spaces, and control characters are shown as \u001b: a message
 * stays one line whatever names and paths it quotes. */
void qn_cli_error (const char *format, ...) G_GNUC_PRINTF (1, 2);
void qn_cli_warning (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* The subcommand that runs, for what follows; borrowed for good. */
void qn_cli_set_subcommand (const char *subcommand);

/* Completes standard output (shown-text.c) and ends the program; with a message before. */
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
