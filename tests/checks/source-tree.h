/* The source tree as the checks see it: its files and their lines. */
#pragma once

#include <glib.h>

/* Root of the source tree; a static string. */
const char *source_tree_root (void);

/* Paths relative to the root, sorted, of all files below `folder` whose name ends in one of
 * the `suffixes` (NULL-terminated). Free with g_ptr_array_unref(). */
GPtrArray *source_tree_files (const char *folder, const char *const *suffixes);

/* The text of a file given by its path below the root; free with g_free(). */
char *source_tree_read (const char *path);

/* Its lines; free with g_strfreev(). */
char **source_tree_lines (const char *path);

/* Adds a line to a list of complaints; a check passes when the list stays empty. */
void complain (GString *complaints, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* Fails the running test with all complaints, if there are any. Frees the list. */
void assert_no_complaints (GString *complaints);

/* For self-tests: fails unless there is a complaint that contains `part`. Frees the list. */
void assert_complaint (GString *complaints, const char *part);
