/* Contents of a picture: the view of the command line and its switches, as plain data. */
#pragma once

#include "core/base/box.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

#include <cairo.h>
#include <stdbool.h>

typedef enum {
  QN_VIEW_MODEL,
  QN_VIEW_CONTACTS,
  QN_VIEW_DEFORMED,
  QN_VIEW_MECHANISM,
  QN_VIEW_FORCES,
  QN_VIEW_DIAGRAMS, /* section forces along beams */
  QN_VIEW_COUNT
} QnView;

/* Quantity shown by colour on the blocks or along the joints. */
typedef enum {
  QN_FIELD_NONE,
  QN_FIELD_DISPLACEMENT,   /* length of the centroid's displacement, m */
  QN_FIELD_DISPLACEMENT_X, /* m */
  QN_FIELD_DISPLACEMENT_Y, /* m */
  QN_FIELD_ROTATION,       /* rad */
  QN_FIELD_STRESS, /* least principal value of the block's mean stress, Pa: compression < 0;
                       from the contact forces */
  QN_FIELD_STRESS_X,  /* of the mean stress: xx, */
  QN_FIELD_STRESS_Y,  /* yy, */
  QN_FIELD_STRESS_XY, /* xy, Pa */
  QN_FIELD_PRINCIPAL, /* its principal values as crosses along their directions, Pa */
  QN_FIELD_OPENING,   /* largest opening along the joint, m */
  QN_FIELD_SLIDING,   /* relative tangential motion of the joint, m */
  QN_FIELD_CRACK,     /* largest width of a crack along the joint, m */
  QN_FIELD_BODIES,    /* which of the mechanism's bodies a block is part of */
  QN_FIELD_COUNT
} QnField;

static inline bool
qn_field_is_stress (QnField field)
{
  return field >= QN_FIELD_STRESS && field <= QN_FIELD_PRINCIPAL;
}

/* Whether a field is read off contact forces. */
static inline bool
qn_field_needs_forces (QnField field)
{
  return qn_field_is_stress (field) || field == QN_FIELD_CRACK;
}

/* Section force that QN_VIEW_DIAGRAMS draws. */
typedef enum {
  QN_DIAGRAM_MOMENT,
  QN_DIAGRAM_SHEAR,
  QN_DIAGRAM_NORMAL,
  QN_DIAGRAM_COUNT
} QnDiagram;

#define QN_STEP_LAST  (-1)
#define QN_SCALE_AUTO 0.0

/* A photo or survey behind the structure. */
typedef struct QnUnderlay {
  cairo_surface_t *image; /* borrowed; NULL: none */
  QnVec2 origin;          /* lower left corner, m */
  double width;           /* m; the height follows from the image */
  double angle;           /* rad, counter-clockwise about the origin */
  double opacity;         /* 0 .. 1 */
  /* Where four points of the photo are the corners of a rectangle (rectify.h), origin and width are
   * those of the rectangle, and `image` is the rectified one. */
  bool rectified;
  QnVec2 points[4]; /* on the photo */
  double height;    /* of the rectangle, m */
  bool cropped;     /* to the rectangle */
  QnBox seen;       /* part of the rectangle's plane in `image` */
} QnUnderlay;

/* Corners of the image in the model, from the lower left one counter-clockwise. False without image. */
bool qn_underlay_corners (const QnUnderlay *underlay, QnVec2 corners[4]);

typedef struct QnViewOptions {
  QnView view;
  QnField field;
  QnDiagram diagram;
  int32_t step; /* of result->steps, or QN_STEP_LAST */
  double scale; /* displacements are multiplied by this; or QN_SCALE_AUTO */
  double phase; /* further factor on displacements for animation, 1 = full */
  bool ghost;   /* undeformed outline behind the deformed structure */
  bool symbols; /* open, sliding and hinging joints */
  bool counts;  /* MECHANISM: of hinges and sliding joints, in the legend */
  bool loads;
  bool dimensions;
  bool names;            /* of blocks */
  bool values;           /* FORCES: N, T, M and eccentricity beside joints */
  bool legend;           /* also the colour bar and the scale bar */
  bool titles;           /* title and multiplier */
  bool monochrome;       /* greys only */
  const QnResult *onion; /* a second result of the same model drawn as outline over the
                            first (DEFORMED, MECHANISM); borrowed, or NULL */
  const bool
    *numbered; /* by contact face: those that show their number; borrowed, or NULL */
  QnUnderlay underlay;
} QnViewOptions;

/* The settings a view starts with. */
void qn_view_options_init (QnViewOptions *options, QnView view);

/* The switches above by name, as in --show, --hide and figure recipes: "ghost", "symbols", …;
 * NULL-terminated. */
extern const char *const qn_view_switches[];
/* The switch of that name, or NULL. */
bool *qn_view_switch (QnViewOptions *options, const char *name);

/* "model", "contacts", … as in --view and figure recipes. */
extern const char *const qn_view_names[QN_VIEW_COUNT];

/* Whether a view shows a result. */
static inline bool
qn_view_needs_result (QnView view)
{
  return view == QN_VIEW_DEFORMED || view == QN_VIEW_MECHANISM || view == QN_VIEW_FORCES
         || view == QN_VIEW_DIAGRAMS;
}

/* The view that says most of a result: how it fails, else how it has moved, else the model alone. */
static inline QnView
qn_view_of_result (const QnResult *result)
{
  return result->mechanism != NULL ? QN_VIEW_MECHANISM
         : result->step_count > 0  ? QN_VIEW_DEFORMED
                                   : QN_VIEW_MODEL;
}

/* "none", "displacement", "displacement-x", …, "bodies". */
extern const char *const qn_field_names[QN_FIELD_COUNT];

/* "M", "V", "N". */
extern const char *const qn_diagram_names[QN_DIAGRAM_COUNT];

/* Sets "field" or "diagram" by the name of one, "step" to "last" or a number from 0, "scale" to "auto", "true" or a
 * positive number, or a switch to "on" or "off". False where that is none of these. */
bool qn_view_options_set (QnViewOptions *options, const char *name, const char *value);
