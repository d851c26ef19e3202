/* A typical law of every kind, with the history that shows what is particular about it. */
#ifndef QN_CLI_LAW_PRESETS_H
#define QN_CLI_LAW_PRESETS_H

#include "core/law.h"

#include <glib.h>

/* Most turning points of a history. */
#define QN_LAW_MAX_TURNS 64

typedef struct QnLawPreset {
  QnLaw law;
  gboolean shear;                 /* the history is one of slip, with `pressed` held */
  double pressed;                 /* normal elongation meanwhile, m or strain */
  double turns[QN_LAW_MAX_TURNS]; /* elongations that the history goes through, from 0 */
  gsize turn_count;
} QnLawPreset;

const QnLawPreset *qn_law_preset (QnLawKind kind);

#endif
