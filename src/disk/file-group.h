/* Several files that appear together or not at all.
 *
 * They are collected in a hidden folder beside their places, ".gather.XXXXXX", and replace what was
 * there when all of them are complete. What goes wrong until then, or while they do,
 * leaves the old files as they were; only a kill in the moment of the exchange can leave some new
 * and some old, and a kill before it the hidden folder, which the next group in the same place removes.
 *
 *   QnFileGroup group;
 *   int trouble = qn_file_group_open (&group, "frames");
 *   trouble = qn_file_group_add (&group, "frame-0001.png", &path);      … write to path …
 *   trouble = qn_file_group_commit (&group);      or      qn_file_group_discard (&group);
 *
 * Functions that return int return 0 or the errno of what failed.
 */
#pragma once

#include <glib.h>

typedef struct QnFileGroup {
  char *folder;     /* where the files belong */
  char *hidden;     /* the folder that they gather in */
  GPtrArray *names; /* char *: of the files, in the order they were added */
  int lock; /* descriptor of the hidden folder, locked as long as its writer lives */
} QnFileGroup;

/* The folder must exist. On failure there is nothing to give up. */
int qn_file_group_open (QnFileGroup *group, const char *folder);

/* *path: where the file of this name is to be written now; free with g_free(). Refuses names of
 * folders (EISDIR) and of what is write-protected. */
int qn_file_group_add (QnFileGroup *group, const char *name, char **path);

/* Puts the files in their places and frees the group; on failure the old ones are there. */
int qn_file_group_commit (QnFileGroup *group);

/* Removes what has gathered and frees the group. */
void qn_file_group_discard (QnFileGroup *group);
