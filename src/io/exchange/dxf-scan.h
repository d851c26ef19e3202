/* First reading of a DXF file: is it one, what is in it, and what of it may dxflib see?
 *
 * A DXF file is a list of pairs: a line with a number that says what the next line is. Here every
 * pair is checked, so that a bad file is refused with its line; entities that are no outlines
 * are counted and left out; counts that a careless reader would trust are made true. What is
 * left is given to dxflib as text, in which the layer of each entity is its number in `sources`.
 */
#ifndef QN_IO_DXF_SCAN_H
#define QN_IO_DXF_SCAN_H

#include "io/exchange/drawing.h"

typedef struct QnDxfSource {
  const char *layer; /* kept by the drawing */
  guint line;
} QnDxfSource;

typedef struct QnDxfScan {
  GString *text;   /* for dxflib */
  GArray *sources; /* QnDxfSource */
} QnDxfScan;

/* `name` stands for the file in messages. Notes and the declared unit go to `drawing`. `scan` is
 * overwritten without being cleared. FALSE with an error, domain QN_IO_ERROR. */
gboolean qn_dxf_scan (const char *text, gsize length, const char *name,
                      QnDrawing *drawing, QnDxfScan *scan, GError **error);

void qn_dxf_scan_clear (QnDxfScan *scan);

/* Number of $INSUNITS for a unit of so many metres; 0 where it has none. */
int qn_dxf_unit_code (double metres);

#endif
