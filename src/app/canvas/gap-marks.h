/* Joints of mortar marked over a drawing, before they are closed. */
#pragma once

#include "render/drawing/camera.h"
#include "stereotomy/gaps.h"
#include <cairo.h>

/* Fills the place of each gap, at least a pixel wide. */
void qn_gap_marks_draw (const QnGaps *gaps, const QnCamera *camera, cairo_t *cr);
