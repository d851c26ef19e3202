/* Drawings: the common form of files of other programs, before they become blocks.
 *
 * Every importer flattens its file into paths, open or closed, in the unit of the file, with their
 * layer and line. drawing-import.h makes a project of them.
 */
#pragma once

#include "core/base/vec2.h"

#include <glib.h>

/* Chords of curves deviate from them by about this part of the radius. Up to a radius of a hundred blocks
 * that is less than the tolerance of fitting neighbours to each other (0.2 % of a block). */
#define QN_DRAWING_SAGITTA 2e-5

/* Largest coordinate, in any unit: beyond it a double does not resolve a millimetre. */
#define QN_DRAWING_LARGEST 1e15

typedef struct QnDrawingPath {
  QnVec2 *points; /* owned */
  gsize count;
  gboolean closed;   /* as the file says */
  gboolean support;  /* the file itself calls it a support */
  gboolean hidden;   /* on a layer that the file does not show */
  const char *layer; /* kept by the drawing */
  double density;    /* kg/m3; 0 where the file has none */
  double thickness;  /* in the drawing's unit; likewise */
  guint line;        /* of the file, from 1; 0 unknown */
} QnDrawingPath;

/* A repair of the drawing or something left out, reported once per kind with its count and the
 * place of the first. */
typedef struct QnDrawingNote {
  char *text; /* "%u polylines closed" is made of these */
  guint count;
  guint line;     /* of the first; 0 where there is none */
  gboolean minor; /* no part of the structure: texts, dimensions */
} QnDrawingNote;

typedef struct QnDrawing {
  GArray *paths;    /* QnDrawingPath */
  GPtrArray *notes; /* QnDrawingNote * */
  GStringChunk *strings;
  double unit; /* m per unit as the file declares it, 0 where it does not */
} QnDrawing;

void qn_drawing_init (QnDrawing *drawing);
void qn_drawing_clear (QnDrawing *drawing);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnDrawing, qn_drawing_clear)

/* A copy that lives as long as the drawing; equal strings have one. */
const char *qn_drawing_keep_string (QnDrawing *drawing, const char *string);

/* Adds an empty path; valid until the next addition. */
QnDrawingPath *qn_drawing_add_path (QnDrawing *drawing, const char *layer, guint line);
void qn_drawing_path_add (QnDrawingPath *path, QnVec2 point);

/* The paths from `first` up to `end` are the parts of one shape. Those that lie in another of them are
 * holes, or covered by it, and become empty; what lies in a hole stays. A hole that reaches the edge is
 * cut out, others are noted. */
void qn_drawing_join_parts (QnDrawing *drawing, guint first, guint end,
                            gboolean even_odd);

/* Takes out empty paths, and those with a coordinate that is not finite or beyond QN_DRAWING_LARGEST, which the
 * arithmetic of curves and transformations can bring about, and notes them. */
void qn_drawing_drop_unbounded (QnDrawing *drawing);

/* Counts one occurrence of `text`, translated, in the plural:
 * "texts left out". Returns its note. */
QnDrawingNote *qn_drawing_note (QnDrawing *drawing, const char *text, guint line);

/* Flattened curves, appended to a path whose last point, if it has one, is the start. Angles in
 * rad. */

/* From the last point to `end`; bulge = tan of a quarter of the angle, positive to the left. */
void qn_drawing_path_add_bulge (QnDrawingPath *path, QnVec2 end, double bulge);

/* centre + cos(t) major + sin(t) minor for t from `from` to `to`. */
void qn_drawing_path_add_ellipse (QnDrawingPath *path, QnVec2 centre, QnVec2 major,
                                  QnVec2 minor, double from, double to);

/* A rational B-spline (de Boor). False where knots and points do not match. weights may be NULL. */
gboolean qn_drawing_path_add_spline (QnDrawingPath *path, guint degree,
                                     const double *knots, gsize knot_count,
                                     const QnVec2 *points, const double *weights,
                                     gsize point_count);

/* Reads the text of a file, called `name` in messages, into a drawing that is empty before. FALSE with an
 * error, which is one line with file and line, domain QN_IO_ERROR. */
typedef gboolean QnDrawingReader (const char *text, gsize length, const char *name,
                                  QnDrawing *drawing, GError **error);

/* Overwrites `drawing` without clearing it by what a reader reads; empty on failure. */
gboolean qn_drawing_read (QnDrawingReader *reader, const char *text, gsize length,
                          const char *name, QnDrawing *drawing, GError **error);

/* Reads the text of a DXF file: lines, polylines with bulges, arcs, circles, ellipses, splines,
 * solids and inserts nested to any sensible depth, those of layer 0 in a block on the layer of
 * its insert; faces in space and boundaries of hatches where there is nothing else. Entities in an
 * upright plane are seen from the front. Layers that are off or frozen are marked as hidden, invisible
 * parts left out. The text is in UTF-8 or in the code page that the file states. */
QnDrawingReader qn_dxf_import;

/* Reads path, polygon, polyline, rect, circle, ellipse and line elements where the standard (SVG 2)
 * places them: transforms, lengths with units, view ports, used elements and symbols; the label or id
 * of the innermost group is the layer. Shapes that attributes, style or style sheets hide, or do not
 * paint, are marked as hidden. A hole in a shape is cut out where it reaches the edge, else told. The y
 * axis is turned upwards. The unit follows from a width with a unit and the view box. The file may be
 * compressed by gzip. */
QnDrawingReader qn_svg_import;

/* Reads blocks that are prisms with a common direction along y, z or x, tried in this order, from what the
 * classes of COMPAS write as JSON: assemblies of all versions, networks, models with elements; and from
 * Wavefront's OBJ, where an object is a block. The faces of the front become one outline, z (or y)
 * upwards, in metres; `is_support` makes a support. A view in which blocks lie behind each other is
 * rejected. Notes name the view, and why the first one was rejected. */
QnDrawingReader qn_compas_import;

/* Reads blocks of the form
 *
 *   Box 1:
 *   [0, 0], [1, 0], [1, 0.5], [0, 0.5]
 *   rho = 2400
 *   material = 0
 *
 * in metres. Finite elements (FE) and all other text are counted and left out. */
QnDrawingReader qn_hybridfem_import;
