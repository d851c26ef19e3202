/* Preview of a motion of the ground: acceleration, velocity, displacement, response spectrum. */
#pragma once

#include "core/model/model.h"

#include "render/figure/plot.h"
#include <glib.h>

typedef enum {
  QN_GROUND_ACCELERATION, /* m/s2 over s, along the motion's direction */
  QN_GROUND_VELOCITY, /* m/s, exact; what is left at the end is the drift of the base line */
  QN_GROUND_DISPLACEMENT, /* m */
  QN_GROUND_SPECTRUM,     /* pseudo-acceleration, m/s2, over the period, s, 5 % damped */
  QN_GROUND_PREVIEW_COUNT
} QnGroundPreviewKind;

/* Damping of the spectrum. */
#define QN_GROUND_DAMPING 0.05

typedef struct QnGroundPreview {
  double *x, *y; /* owned */
  gsize count;   /* 0: there is nothing to show */
} QnGroundPreview;

/* Of one motion of a model, its factor included. Free with qn_ground_preview_clear(). */
void qn_ground_preview_init (QnGroundPreview *preview, const QnModel *model, gsize motion,
                             QnGroundPreviewKind kind);
void qn_ground_preview_clear (QnGroundPreview *preview);

/* A plot of it, which borrows its numbers. */
QnPlot *qn_ground_preview_plot (const QnGroundPreview *preview, QnGroundPreviewKind kind);

/* Adds to that of a spectrum points where the periods of modes lie on it: of angular frequencies, rad/s. */
void qn_ground_preview_add_periods (QnPlot *plot, const QnGroundPreview *spectrum,
                                    const double *omegas, gsize count);
