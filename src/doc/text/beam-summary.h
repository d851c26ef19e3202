/* Section forces of a beam in a few numbers: at its ends, and the largest of each. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"
#include "doc/text/units.h"

/* A value and where it is. */
typedef struct QnBeamExtreme {
  double value;
  double x; /* m from the first node */
} QnBeamExtreme;

typedef struct QnBeamSummary {
  double length; /* m */
  QnBeamPoint ends[2];
  QnBeamExtreme normal, shear, moment; /* of the largest size */
} QnBeamSummary;

/* False where the result does not know the section forces of this step. */
bool qn_beam_summary_fill (QnBeamSummary *summary, const QnModel *model,
                           const QnResult *result, size_t step, QnId beam);

/* The same in three lines of text. The caller frees it. */
char *qn_beam_summary_dup_text (const QnBeamSummary *summary, QnUnits units);
