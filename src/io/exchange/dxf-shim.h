/* dxflib behind a C door. The text must have passed qn_dxf_scan(). */
#ifndef QN_IO_DXF_SHIM_H
#define QN_IO_DXF_SHIM_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
  QN_DXF_BLOCK, /* begin of a block definition: name, base point in numbers[0..1] */
  QN_DXF_BLOCK_END,
  QN_DXF_LINE,     /* x1 y1 x2 y2 */
  QN_DXF_ARC,      /* cx cy radius from to, degrees; a circle is from 0 to 360 */
  QN_DXF_ELLIPSE,  /* cx cy, major axis x y, ratio, from, to in rad */
  QN_DXF_POLYLINE, /* points x y bulge; flags 1 closed, 16 and 64 meshes */
  QN_DXF_SPLINE,   /* points x y weight, knots; numbers[0] degree; flags 1 closed */
  QN_DXF_FACE,     /* filled: four corners x y in numbers */
  QN_DXF_INSERT    /* name; x y, scale x y, angle in degrees, columns rows, spacing x y */
} QnDxfKind;

typedef struct QnDxfEntity {
  QnDxfKind kind;
  const char *layer; /* the number that qn_dxf_scan() put in the layer's place */
  const char *name;  /* of blocks and inserts, else NULL */
  double numbers[9];
  double extrusion_z; /* < 0: drawn on the back, x is mirrored */
  int flags;
  const double *points; /* triples */
  size_t point_count;
  const double *knots;
  size_t knot_count;
} QnDxfEntity;

/* Calls `entity` for each, in the order of the file; all pointers are valid during the call only.
 * False where dxflib fails. */
bool qn_dxf_parse (const char *text, size_t length,
                   void (*entity) (const QnDxfEntity *entity, void *data), void *data);

#ifdef __cplusplus
}
#endif

#endif
