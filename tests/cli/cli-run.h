/* Runs the real quoin-cli and keeps what it said. */
#pragma once

#include "support/scratch.h"

#include <glib.h>

typedef struct CliRun {
  int code;        /* exit code; 128 + signal where it was killed */
  char *out, *err; /* standard output and standard error */
} CliRun;

/* Runs with these arguments, NULL-terminated. Never fails but for the machine's sake. */
CliRun cli_run (const char *first, ...) G_GNUC_NULL_TERMINATED;

/* The same with the arguments as a vector and with one more environment variable. */
CliRun cli_run_with (const char *const *arguments, const char *variable,
                     const char *value);

void cli_run_clear (CliRun *run);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (CliRun, cli_run_clear)

/* Fails unless the run ended with this code; a failed run must have said one line, behind
 * warnings, that begins with "quoin-cli: " and contains `part` (nullable). Clears the run. */
void cli_assert_failed (CliRun *run, int code, const char *part);

/* Fails unless the run ended well and said nothing but warnings on standard error. */
void cli_assert_done (const CliRun *run);

/* Runs, with the words of cli_run(), and fails unless that ended well and quietly. */
#define cli_do(...) cli_expect_done (cli_run (__VA_ARGS__))
void cli_expect_done (CliRun run);

/* The same, and fails unless `part` is on standard output. */
#define cli_says(part, ...) cli_expect_said (cli_run (__VA_ARGS__), part)
void cli_expect_said (CliRun run, const char *part);

/* Runs and fails unless that failed, as cli_assert_failed() says. */
#define cli_fails(code, part, ...)                                                       \
  cli_assert_failed ((CliRun[]){ cli_run (__VA_ARGS__) }, code, part)

/* Writes a file into the folder; the path is returned. Free with g_free(). */
char *cli_write (const char *folder, const char *name, const char *text);

/* The text of a file; fails where there is none. */
char *cli_read (const char *path);

/* Path of an example; free with g_free(). */
char *cli_example (const char *name);

/* A sound project: a block on a fixed ground, which slides at 0.4. */
extern const char cli_sliding_block[];

/* `text` with the first occurrence of `from`, which must be there, replaced. */
char *cli_replace (const char *text, const char *from, const char *to);
