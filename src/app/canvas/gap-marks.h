/* Joints of mortar marked over a drawing, before they are closed. */
#ifndef QN_APP_GAP_MARKS_H
#define QN_APP_GAP_MARKS_H

#include "render/drawing/camera.h"
#include "stereotomy/gaps.h"
#include <cairo.h>

/* Fills the place of each gap, at least a pixel wide. */
void qn_gap_marks_draw (const QnGaps *gaps, const QnCamera *camera, cairo_t *cr);

#endif
