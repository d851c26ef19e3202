/* The database of a study: one row for every case that has been computed (SQLite).
 *
 * Rows are written in transactions; until qn_store_commit() a crash leaves the database as it was
 * at the last one. Table `cases`: "case" (from 1), status (done, failed), a column for every
 * parameter and every output of the study, outcome, reason, seconds, version, model_sha256.
 * Table `study`: the study that the rows belong to.
 *
 * Functions that return gboolean set an error, QN_IO_ERROR, where they return FALSE.
 */
#pragma once

#include "study/cases/case.h"
#include "study/cases/folder.h"

typedef struct QnStore QnStore;

/* Opens a database of this study, which must outlive it; makes it where there is none and `create`
 * says so. Refuses one of another study. */
QnStore *qn_store_open (const char *path, const QnStudy *study, gboolean create,
                        GError **error);

/* Sets marks[i] for every case (place from 0) that has a row. */
gboolean qn_store_mark_present (QnStore *store, guint8 *marks, gsize count,
                                GError **error);

/* Removes the rows of cases that failed, so that they are computed again. */
gboolean qn_store_forget_failed (QnStore *store, GError **error);

/* Adds a row, begins a transaction where none is open. */
gboolean qn_store_add (QnStore *store, gsize index, const double *values,
                       const QnCaseResult *result, GError **error);

/* Copies rows of another database of the study: those that are missing, and those that failed here
 * and are done there. *added counts them. An empty database is that of a task that has just begun. */
gboolean qn_store_merge (QnStore *store, const char *path, gsize *added, GError **error);

gboolean qn_store_commit (QnStore *store, GError **error);

/* Calls `row` for every row by ascending case number, until it returns FALSE. Values and result
 * are borrowed for the call. */
typedef gboolean (*QnStoreRowFunc) (gsize index, const double *values,
                                    const QnCaseResult *result, gpointer data);
gboolean qn_store_read (QnStore *store, QnStoreRowFunc row, gpointer data,
                        GError **error);

/* Rows that are there, and how many of them failed. */
gboolean qn_store_count (QnStore *store, gsize *rows, gsize *failed, GError **error);

/* A note in the database, by key; *value NULL: none. Free with g_free(). */
gboolean qn_store_get_note (QnStore *store, const char *key, char **value,
                            GError **error);
gboolean qn_store_set_note (QnStore *store, const char *key, const char *value,
                            GError **error);

/* Discards uncommitted rows. NULL is allowed. */
void qn_store_close (QnStore *store);

/* ---- slices ---- */

typedef struct QnGathered {
  gsize added;                  /* rows that came over now */
  gsize present, failed, count; /* rows in all, of these failed, cases of the study */
} QnGathered;

/* Takes over the rows of every slice's database in the folder: those that are missing, and done
 * ones in place of failed ones. Safe to repeat, and while slices are being computed. A slice that
 * cannot be read ends it with an error that names it; what came before stays. */
gboolean qn_study_gather (const QnStudy *study, const char *folder, QnGathered *gathered,
                          GError **error);
