/* Exit codes of quoin-cli; scripts rely on them. */
#pragma once

typedef enum {
  QN_EXIT_DONE = 0,       /* a collapse that was found is a success */
  QN_EXIT_INTERNAL = 1,   /* the program failed; a published case was missed (verify) */
  QN_EXIT_USAGE = 2,      /* unknown option or subcommand, missing argument */
  QN_EXIT_INVALID = 3,    /* the input breaks a rule */
  QN_EXIT_NO_ANSWER = 4,  /* dead load does not stand, or the analysis did not converge */
  QN_EXIT_FILE = 5,       /* a file cannot be read or written */
  QN_EXIT_CANCELLED = 130 /* by Ctrl+C; what had converged is kept */
} QnExit;
