/* The picture of an envelope: the structure with the vehicle at one position, and below it, over the same
 * axis, the multipliers for all positions. */
#pragma once

#include "render/figure/plot.h"
#include "study/cases/envelope.h"

typedef struct QnEnvelopeFigure {
  const QnEnvelope *envelope; /* borrowed, as is … */
  const QnModel *moved;       /* … the structure with the vehicle at: */
  QnEnvelopePlace shown;
  double phase;      /* of the mechanism's motion, 0 .. 1 */
  QnPlotPlace place; /* where the curves were drawn last */
} QnEnvelopeFigure;

/* A QnPageFunc; `figure`: a QnEnvelopeFigure. */
bool qn_envelope_draw (cairo_t *cr, const QnPage *page, void *figure, GError **error);

/* Writes it as PNG, SVG or PDF with the vehicle at that position. */
gboolean qn_envelope_export (const QnEnvelope *envelope, QnEnvelopePlace shown,
                             const char *path, const QnOutput *output,
                             const QnMetadata *metadata, GError **error);
