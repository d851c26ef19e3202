/* Counting instructions, with valgrind: unlike times they are the same however
 * busy the machine is. */
#pragma once

#include <glib.h>

/* Runs a program with its arguments (NULL-terminated) and counts what it executes within a function
 * and those that it calls. *output (nullable) is what the program printed; free with g_free(). What
 * fails, fails the test. 0 where nothing can be counted here: without valgrind, or in a program
 * built with a sanitizer. */
double count_instructions (const char *const *arguments, const char *function,
                           char **output);

/* The same of a whole program beyond what it takes to start, whatever exit code it ends with. The
 * program is the same in all calls. */
double count_program (const char *const *arguments, int *code);

/* The same of a program and all that it starts, loading them included; it must end well. */
double count_processes (const char *const *arguments);
