/* The folder of a study: copies of the study and its project, the database of results.
 *
 *   study.quoin-study  model.quoin     as they were when the study began
 *   study.db                           a row for every case that has been computed
 *   shard-3-of-10.db                   the same of one slice, until it is gathered
 *   results/                           full results of single cases, on request
 *
 * The process that computes holds a lock beside the database; the system releases it when the
 * process ends in any way: a database has one writer at a time.
 */
#pragma once

#include "study/plan/study.h"

/* A slice of the cases: those whose place modulo `count` is `index`; 0 of 1 is all. */
typedef struct QnShard {
  guint index, count;
} QnShard;

/* Path of the database of a slice. Free with g_free(). */
char *qn_folder_dup_database (const char *folder, QnShard shard);

/* Makes the folder where there is none and puts the copies there; where there are copies, they
 * must be of this study. Errors: QN_IO_ERROR. */
gboolean qn_folder_prepare (const char *folder, const QnStudy *study, GError **error);

/* Folder of the results of the study of a file as it is now, in that of all its states, which is named
 * after it: the window keeps them there. Free with g_free(). */
char *qn_folder_dup_of_state (const QnStudy *study, const char *path);

/* The folder with the study that a command names: that folder itself, or, where it is that of all states of a
 * study beside it, the one of its present state. Free with g_free(). */
char *qn_folder_dup_named (const char *folder);

/* Reads the study of a folder from its copies. */
gboolean qn_folder_read_study (const char *folder, QnStudy *study, GError **error);

/* Takes the lock of a database: a file descriptor to close, or -1 with an error where another
 * process holds it. */
int qn_folder_lock (const char *database, GError **error);

/* Path of the kept result of a case (number from 1). Free with g_free(). */
char *qn_folder_dup_result (const char *folder, gsize number);
