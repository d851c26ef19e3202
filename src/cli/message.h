/* What quoin-cli says on standard error: one line per message, "quoin-cli: " in front. */
#ifndef QN_CLI_MESSAGE_H
#define QN_CLI_MESSAGE_H

#include "cli/exit-code.h"

#include <glib.h>

/* Line breaks inside the message become spaces: a message stays one line whatever names and
 * paths it quotes. */
void qn_cli_error (const char *format, ...) G_GNUC_PRINTF (1, 2);
void qn_cli_warning (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* Wrong usage: the message and where help is to be found. `subcommand` may be NULL. */
void qn_cli_usage_error (const char *subcommand, const char *message);

/* Prints the error, frees it and says how the program ends. */
QnExit qn_cli_fail (GError *error);

/* The exit code that belongs to an error of the layers below. */
QnExit qn_cli_exit_code (const GError *error);

#endif
