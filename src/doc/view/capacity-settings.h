/* What a capacity curve is held against, as the project keeps it: `capacity` in data/project-format.md. */
#pragma once

#include "doc/view/capacity-answer.h"
#include "io/exchange/record.h"
#include "io/project/project.h"

#define QN_CAPACITY_MEMBER "capacity"

typedef struct QnCapacitySettings {
  char *control;                  /* name of the block; NULL: to be chosen */
  char *spectrum;                 /* "type1", "type2", or a file; NULL: none */
  double ag;                      /* m/s2; 0: not said */
  char *soil;                     /* "A" to "E"; NULL: not said */
  double damping;                 /* ratio; 0: not said */
  double confidence;              /* 0: not said */
  char *unit;                     /* NULL: as the file says */
  gboolean mechanism;             /* the kinematic curve of a mechanism, not a path */
  double tie_strain, part_period; /* as in QnCapacityAnswer */
  QnFloor floor;                  /* what is 0 is not said */
  gboolean
    direct; /* a file of `spectrum` is a path of the user's, not one beside the project */
} QnCapacitySettings;

/* Reads them; all is empty where the project has none. FALSE with an error that names the place.
 * `settings` is overwritten without being cleared. */
gboolean qn_capacity_settings_read (const QnProject *project,
                                    QnCapacitySettings *settings, GError **error);

/* Sets one of them by its name, as an option of the command line: `ag` in m/s2, or "0.25g". FALSE with
 * QN_IO_ERROR_OVERRIDE, whose message begins with the name. */
gboolean qn_capacity_settings_set (QnCapacitySettings *settings, const char *option,
                                   const char *value, GError **error);

/* What an answer is to be held against: damping 0.05 and confidence 1 where they are not said. `points`, to be
 * cleared, are those of a file, which is read where there are none yet. FALSE with QN_IO_ERROR_OVERRIDE where settings are missing or contradict, and
 * errors of the file, or where no block has the name of `control`. */
gboolean qn_capacity_settings_apply (const QnCapacitySettings *settings,
                                     const QnProject *project, gboolean allow_outside,
                                     QnCapacityAnswer *answer, QnRecord *points,
                                     GError **error);

/* As JSON text, for qn_document_edit_extra(). Free with g_free(). */
char *qn_capacity_settings_to_json (const QnCapacitySettings *settings);

void qn_capacity_settings_clear (QnCapacitySettings *settings);
