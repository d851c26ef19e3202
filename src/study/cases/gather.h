/* Joining the slices of a study, computed here or elsewhere, into one database. */
#pragma once

#include "study/cases/folder.h"

typedef struct QnGathered {
  gsize added;                  /* rows that came over now */
  gsize present, failed, count; /* rows in all, of these failed, cases of the study */
} QnGathered;

/* Takes over the rows of every slice's database in the folder: those that are missing, and done
 * ones in place of failed ones. Safe to repeat, and while slices are being computed. A slice that
 * cannot be read ends it with an error that names it; what came before stays. */
gboolean qn_study_gather (const QnStudy *study, const char *folder, QnGathered *gathered,
                          GError **error);
