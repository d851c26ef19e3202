/* Cases of a study on a cluster, by Slurm: an array of tasks, each of which computes one slice into
 * a database of its own in the folder, which all nodes share.
 *
 * The database of the folder keeps the submitted tasks: a second submission covers only slices that
 * lack cases and are neither waiting nor running, because their tasks failed or were lost.
 */
#pragma once

#include "study/cases/folder.h"

typedef struct QnSlurmSettings {
  const char *program;   /* quoin-cli, where the nodes find it */
  guint array_size;      /* slices; 0: as before, or QN_SLURM_ARRAY_SIZE */
  const char *partition; /* nullable */
  gboolean dry_run;      /* makes the script and submits nothing */
} QnSlurmSettings;

#define QN_SLURM_ARRAY_SIZE 100

typedef struct QnSubmission {
  char *script;  /* NULL: nothing is left to submit. Owned */
  char *job;     /* Slurm's number of the array; NULL for a dry run. Owned */
  guint tasks;   /* slices that it computes */
  guint active;  /* slices that wait or run already */
  gsize missing; /* cases without a row */
} QnSubmission;

/* Gathers finished slices, then submits missing ones. Errors, QN_IO_ERROR: Slurm refuses or is not
 * there; another number of slices while tasks of the old ones wait or run. */
gboolean qn_study_submit (const QnStudy *study, const char *folder,
                          const QnSlurmSettings *settings, QnSubmission *submission,
                          GError **error);

void qn_submission_clear (QnSubmission *submission);

/* "1,3-5" of the marked places, numbered from 1: Slurm's way to name array tasks. Free with
 * g_free(). */
char *qn_slurm_dup_range (const guint8 *marks, guint count);
