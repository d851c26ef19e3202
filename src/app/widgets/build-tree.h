/* A program that is run from the tree it was built in finds its data there. */
#ifndef QN_APP_BUILD_TREE_H
#define QN_APP_BUILD_TREE_H

#include <glib.h>

/* Path of a folder at the top of the build tree ("data", "po"), or NULL for an installed
 * program. The caller frees it. */
char *qn_build_tree_dup_folder (const char *name);

#endif
