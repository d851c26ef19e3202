/* A typical law of every kind, with the history that shows what is particular about it. */
#pragma once

#include "core/law/law.h"

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

/* The preset of a kind; static. */
const QnLawPreset *qn_law_preset (QnLawKind kind);

/* Another kind for a law: what the new kind requires and the law does not have is typical. Laws of
 * members come with their basis and stiffness, and without a source; joints keep theirs. */
void qn_law_change_kind (QnLaw *law, QnLawKind kind);
