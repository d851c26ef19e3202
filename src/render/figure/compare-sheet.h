/* A sheet of several figures at one scale, with title above and words beneath each: the
 * comparison of mechanisms in a report. */
#pragma once

#include "render/figure/figure.h"

typedef struct QnCompareSheet {
  QnFigure *figures; /* borrowed; caption: multiplier and mechanism class where NULL */
  size_t count;
  int columns;       /* 0: chosen for the format of the page */
  const char *title; /* of the sheet, or NULL */
} QnCompareSheet;

/* Mechanisms of one structure whose velocity fields have this cosine with the first of their group
 * or more fall into one group. */
#define QN_ALIKE_COSINE 0.95

/* Sorts figures of the same structure (same blocks in the same places) by how they move:
 * groups[i] is the number of figure i's group, from 0 in order of appearance, or QN_NONE where no
 * other figure shows the same structure with a mechanism. False when memory runs out. */
bool qn_compare_sheet_groups (const QnFigure *figures, size_t count, QnId *groups);

/* Writes the sheet as qn_page_export() does. */
bool qn_compare_sheet_export (const QnCompareSheet *sheet, const char *path,
                              const QnOutput *output, const QnMetadata *metadata,
                              GError **error);
