/* Tools: what the pointer does on the drawing.
 *
 * A tool is a row in a table: its names and its answers to the pointer. Gestures go press,
 * motion, release; a tool that builds up a figure over several clicks keeps it in its state
 * until it is complete or cancelled with Escape. While a gesture is under way, typed numbers
 * go to the tool too, so that a wall can be drawn as "2,4; 1,5" and Enter.
 */
#pragma once

#include "doc/edit/edit.h"
#include "doc/masonry/masonry-plan.h"
#include "doc/text/units.h"
#include "doc/view/magnet.h"
#include "io/project/project.h"
#include <gtk/gtk.h>

#define QN_TYPE_CANVAS (qn_canvas_get_type ())
G_DECLARE_FINAL_TYPE (QnCanvas, qn_canvas, QN, CANVAS, GtkWidget)

/* Where the pointer is. */
typedef struct QnToolEvent {
  QnVec2 screen; /* px of the canvas */
  QnVec2 model;  /* m, exactly there */
  QnVec2 point;  /* m, where the magnet puts it */
  QnMagnetHit hit;
  GdkModifierType modifiers;
  int press_count;
} QnToolEvent;

/* What a handle drags (handle.h). */
typedef enum {
  QN_GRIP_NONE,
  QN_GRIP_MASONRY, /* a measure of a masonry object or an opening of it */
  QN_GRIP_CORNER,  /* of a block */
  QN_GRIP_NODE,    /* of beams */
  QN_GRIP_TIE,     /* an end: object is the tie, handle which end */
  QN_GRIP_TURN     /* the selection around its middle */
} QnGripKind;

typedef struct QnGrip {
  QnGripKind kind;
  QnVec2 at;     /* m */
  QnId object;   /* MASONRY; NODE: the node */
  int opening;   /* MASONRY: or QN_NO_OPENING */
  int handle;    /* MASONRY: QnHandleKind */
  QnVec2 center; /* TURN: m */
} QnGrip;

/* What a gesture has so far; one per canvas, the tool's to use. */
typedef struct QnGesture {
  QnVec2 from, to;    /* m */
  QnVec2 from_screen; /* px, where the button went down */
  gboolean dragging;  /* moved far enough to be no click */
  gboolean band;      /* a selection rectangle rather than a move */
  QnGrip grip;        /* the handle that is dragged, if any */
  int phase;          /* of a gesture with several, from 0 */
  GArray *points;     /* of QnVec2, of a polygon */
} QnGesture;

/* An edit that is under way: what it changes, and why it is refused. */
typedef struct QnCanvasDraft {
  QnProject project;
  QnModel *model; /* of the project */
  GError *error;
  const char *step; /* its name, translatable, where a tool makes it (QnTool.edit) */
} QnCanvasDraft;

/* Numbers that can be typed at most. */
#define QN_TOOL_NUMBERS 4

typedef struct QnTool {
  const char *name; /* target of the window's action "tool" */
  const char *icon;
  const char *label;         /* translatable, shown as tooltip */
  const char *hint;          /* translatable, shown in the status bar */
  const char *accel;         /* single key */
  gboolean begins;           /* draws where nothing is yet */
  gboolean magnetic;         /* whether the magnet works before a gesture has begun */
  const char *numbers_label; /* translatable: "width; height", what can be typed */
  QnQuantity quantities[QN_TOOL_NUMBERS]; /* of the typed numbers */
  guint least_points;                     /* of lines of many points (gesture.h) */
  gboolean
    numbers_at_rest; /* numbers can be typed for what is selected, without a gesture */

  void (*press) (QnCanvas *canvas, const QnToolEvent *event);
  void (*motion) (QnCanvas *canvas, const QnToolEvent *event);
  void (*release) (QnCanvas *canvas, const QnToolEvent *event);
  /* Completes the gesture with typed numbers (SI); false: these are not the right ones. */
  gboolean (*numbers) (QnCanvas *canvas, const double *values, int count);
  /* For tools that work between two points, or along several (gesture.h): changes the drawing in one undo
   * step, called `step` unless the draft is given another name; `added`, or NULL, selects what is new then. Two
   * points are apart, in both directions where `wide`. */
  const char *step;
  gboolean wide;
  gboolean (*edit) (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture);
  void (*added) (QnCanvas *canvas);
  /* In place of these: carries the gesture out and ends it. */
  void (*complete) (QnCanvas *canvas);
  /* Gives up the gesture. */
  void (*cancel) (QnCanvas *canvas);
  /* Draw, in px of the canvas, what can be taken hold of before a gesture has begun; and the
   * gesture while it is under way. */
  void (*draw_ready) (QnCanvas *canvas, cairo_t *cr);
  void (*draw) (QnCanvas *canvas, cairo_t *cr);
} QnTool;

/* What the tools draw with; shared by all of a window's tools and shown in its panel. */
typedef struct QnToolSettings {
  QnMasonryStyle masonry;
  char *section;        /* name, of new beams; NULL: the first one */
  gboolean hinges[2];   /* of new beams */
  int elements;         /* of new beams */
  double force;         /* N, of new forces */
  double intensity;     /* N/m, of new loads on edges */
  gboolean live;        /* whether new forces and edge loads grow with the multiplier */
  char *joint_law;      /* name, given to joints; NULL: none of their own */
  gboolean mirror_copy; /* whether mirroring keeps the original */
} QnToolSettings;
