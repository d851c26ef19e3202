/* What quoin-cli says on standard error: one line per message, "quoin-cli: " in front. */
#pragma once

#include "cli/base/exit-code.h"

#include <glib.h>

/* Line breaks inside the message become spaces, and control characters are shown as \u001b: a message
 * stays one line whatever names and paths it quotes. */
void qn_cli_error (const char *format, ...) G_GNUC_PRINTF (1, 2);
void qn_cli_warning (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* Wrong usage: the message and where help is to be found. `subcommand` may be NULL. Returns how the
 * program ends, QN_EXIT_USAGE. */
QnExit qn_cli_usage_error (const char *subcommand, const char *format, ...)
  G_GNUC_PRINTF (2, 3);

/* The same for the value of an option that is none of these. */
QnExit qn_cli_refuse_name (const char *subcommand, const char *value,
                           const char *const *names, size_t count);

/* An override that a subcommand puts before those of the user: where an error names it as what set a
 * value, the subcommand is named instead. Both are borrowed for good. */
void qn_cli_set_own_override (const char *override, const char *subcommand);

/* The subcommand has --allow-outside: an error about a file outside the project's folder names it. */
void qn_cli_offer_outside (void);

/* Prints the error, frees it and says how the program ends. */
QnExit qn_cli_fail (GError *error);

/* How a last step ends: QN_EXIT_DONE where it has set no error, as qn_cli_fail() says otherwise. */
QnExit qn_cli_end (GError *error);

/* Tells that the analysis of this project was cancelled; QN_EXIT_CANCELLED. */
QnExit qn_cli_cancelled (const char *project);
