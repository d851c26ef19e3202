/* A sheet of several figures at one scale, with title above and words beneath each: the
 * comparison of mechanisms in a report. */
#ifndef QN_RENDER_COMPARE_SHEET_H
#define QN_RENDER_COMPARE_SHEET_H

#include "render/figure.h"

typedef struct QnCompareSheet {
  QnFigure *figures; /* borrowed; caption: multiplier and mechanism class where NULL */
  size_t count;
  int columns;       /* 0: chosen for the format of the page */
  const char *title; /* of the sheet, or NULL */
} QnCompareSheet;

bool qn_compare_sheet_export (const QnCompareSheet *sheet, const char *path,
                              const QnOutput *output, const QnMetadata *metadata,
                              GError **error);

#endif
