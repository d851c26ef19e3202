/* Comparing pictures, for the tests of the back ends.
 *
 * References lie in tests/golden and are replaced by tests/golden/accept.sh. On failure the
 * picture, the reference and their difference are left as NAME-out.png, NAME-ref.png and
 * NAME-diff.png in the folder image-diffs of the build. */
#pragma once

#include <cairo.h>

typedef struct ImageTolerance {
  int slight;          /* largest difference of a channel that is not counted, 0 .. 255 */
  int gross;           /* difference above which a pixel counts as grossly wrong */
  double slight_share; /* most pixels above `slight`, as a share of all */
  double gross_share;  /* most pixels above `gross` */
} ImageTolerance;

#define IMAGE_EXACT ((ImageTolerance){ 0, 0, 0, 0 })

/* Fails the test unless the two pictures agree. */
void image_assert_equal (const char *name, cairo_surface_t *out,
                         cairo_surface_t *reference, ImageTolerance tolerance);

/* The same against tests/golden/NAME.png; with QUOIN_ACCEPT_IMAGES set the reference is
 * written instead. */
void image_assert_golden (const char *name, cairo_surface_t *out,
                          ImageTolerance tolerance);

/* A new image whose pixel (x, y) is that of the source at (a x + b y, c x + d y) from the
 * respective corner: mirrors and quarter turns. */
cairo_surface_t *image_transform (cairo_surface_t *source, int a, int b, int c, int d);
