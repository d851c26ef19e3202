/* A photo of a plane, seen at an angle, shown as that plane seen from the front.
 *
 * Four points of the photo are the corners of a rectangle, from its lower left one counter-clockwise.
 * Places on the photo are parts of its width from the left and of its height from below; places on the
 * plane parts of the rectangle's width and height from its lower left corner. The two are related by a
 * plane projective transformation (P. Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989,
 * section 2.2.3: unit square to quadrilateral). */
#pragma once

#include "core/base/box.h"

#include <cairo.h>
#include <glib.h>
#include <stdbool.h>

/* Margin of the plane shown beyond each side of the rectangle, in its width or height: towards the horizon
 * the plane has no end. */
#define QN_RECTIFY_MARGIN 1.0

/* Pixels of the picture that is made, at most. */
#define QN_RECTIFY_MOST_PIXELS 12000000

/* Whether they are the corners of a convex quadrilateral, counter-clockwise. */
bool qn_rectify_is_convex (const QnVec2 points[4]);

/* Puts four points in order: counter-clockwise, the lower left one first. FALSE where they are not the
 * corners of a convex quadrilateral. */
bool qn_rectify_sort (QnVec2 points[4]);

/* From a place on the plane to that on the photo, and back. FALSE where it is beyond the horizon. */
bool qn_rectify_to_photo (const QnVec2 points[4], QnVec2 plane, QnVec2 *photo);
bool qn_rectify_to_plane (const QnVec2 points[4], QnVec2 photo, QnVec2 *plane);

/* The plane seen from the front, so far beyond the rectangle at most, and in `seen` the part of it that the
 * picture shows. NULL without memory. `points` are sorted. The caller destroys it. */
cairo_surface_t *qn_rectify (cairo_surface_t *photo, const QnVec2 points[4],
                             double margin, QnBox *seen);

/* Reads a PNG, JPEG, TIFF … file, turned the right way up as the camera noted. NULL with an
 * error (QN_RENDER_ERROR_FILE). */
cairo_surface_t *qn_photo_load (const char *path, GError **error);
