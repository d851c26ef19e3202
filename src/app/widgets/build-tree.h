/* A program that is run from the tree it was built in finds its data there. */
#pragma once

#include <glib.h>

/* Path of a folder at the top of the build tree ("data", "po"), or NULL for an installed
 * program. The caller frees it. */
char *qn_build_tree_dup_folder (const char *name);
