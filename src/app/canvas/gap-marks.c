#include "app/canvas/gap-marks.h"

#define GAP_COLOR    0.84, 0.15, 0.16, 0.8
#define LEAST_GAP_PX 1.0

void
qn_gap_marks_draw (const QnGaps *gaps, const QnCamera *camera, cairo_t *cr)
{
  cairo_set_source_rgba (cr, GAP_COLOR);
  cairo_set_line_width (cr, LEAST_GAP_PX);
  cairo_new_path (cr);
  for (size_t i = 0; i < gaps->count; i++) {
    const QnGap *gap = &gaps->items[i];
    const QnVec2 corners[] = { gap->sides[0][0], gap->sides[0][1], gap->sides[1][1],
                               gap->sides[1][0] };
    cairo_new_sub_path (cr);
    for (size_t k = 0; k < sizeof corners / sizeof *corners; k++) {
      QnVec2 at = qn_camera_to_screen (camera, corners[k]);
      cairo_line_to (cr, at.x, at.y);
    }
    cairo_close_path (cr);
  }
  cairo_fill_preserve (cr);
  cairo_stroke (cr);
}
