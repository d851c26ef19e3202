/* First reading of a DXF file: from pairs of lines to entities.
 *
 * A DXF file is a list of pairs: a line with a number that says what the next line is. Every pair is
 * checked, so that a bad file is refused with its line; entities that are no outlines are counted
 * and left out. The shape of an entity is kept in its own coordinates: dxf-import.c puts it in its
 * place.
 */
#pragma once

#include "io/exchange/drawing.h"

typedef enum {
  QN_DXF_LINE, /* two points */
  QN_DXF_ARC, /* centre; radius, from, to in degrees in `numbers`; a circle is from 0 to 360 */
  QN_DXF_ELLIPSE, /* centre and end of the major axis as from there; ratio, from, to in rad */
  QN_DXF_POLYLINE, /* points with bulges */
  QN_DXF_SPLINE,   /* points with weights, knots; degree in numbers[0] */
  QN_DXF_FACE,     /* filled: its corners */
  QN_DXF_HATCH, /* one boundary of a hatch, closed, as a polyline; 1 for the first of each */
  QN_DXF_INSERT /* point; scales x y z, angle in degrees, columns, rows, spacings x y */
} QnDxfKind;

/* The last is the bulge or the weight. */
typedef struct QnDxfPoint {
  double x, y, z, extra;
} QnDxfPoint;

typedef struct QnDxfEntity {
  QnDxfKind kind;
  const char *layer,
    *name; /* kept by the drawing; the name of an insert's block, else NULL */
  guint line;
  gboolean closed;
  gboolean outside;   /* of blocks */
  gboolean in_plane;  /* coordinates are those of the plane that the normal defines */
  gboolean invisible; /* by itself, as parts of dynamic blocks are */
  double normal[3];
  double numbers[8];
  guint first_point, point_count, first_knot, knot_count; /* of the scan's */
} QnDxfEntity;

typedef struct QnDxfBlock {
  double base[3];
  guint first, end; /* of the scan's entities */
} QnDxfBlock;

typedef struct QnDxfScan {
  GArray *entities;   /* QnDxfEntity, those of blocks included */
  GArray *points;     /* QnDxfPoint */
  GArray *knots;      /* double */
  GHashTable *blocks; /* name, kept by the drawing, in lower case -> QnDxfBlock */
  GHashTable
    *hidden; /* layers that are off or frozen, in lower case -> QN_DXF_OFF, FROZEN */
} QnDxfScan;

enum { QN_DXF_OFF = 1, QN_DXF_FROZEN };

/* `name` stands for the file in messages. The text is as qn_text_decode() gives it, and cut into lines
 * that the scan points to. Notes and the declared unit go to `drawing`. `scan` is overwritten without
 * being cleared. FALSE with an error, domain QN_IO_ERROR. */
gboolean qn_dxf_scan (char *text, const char *name, QnDrawing *drawing, QnDxfScan *scan,
                      GError **error);

void qn_dxf_scan_clear (QnDxfScan *scan);

/* Iconv's name of the encoding that a file states ("ANSI_1252"); NULL where it states none. Free with
 * g_free(). */
char *qn_dxf_dup_charset (const char *bytes, gsize size);

/* Number of $INSUNITS for a unit of so many metres; 0 where it has none. */
int qn_dxf_unit_code (double metres);
