/* Tools: what the pointer does on the drawing.
 *
 * A tool is a row in a table: its names and its answers to the pointer. Gestures go press,
 * motion, release; a tool that builds up a figure over several clicks keeps it in its state
 * until it is complete or cancelled with Escape. While a gesture is under way, typed numbers
 * go to the tool too, so that a wall can be drawn as "2,4; 1,5" and Enter.
 */
#ifndef QN_APP_TOOL_H
#define QN_APP_TOOL_H

#include "doc/edit.h"
#include "doc/magnet.h"
#include <gtk/gtk.h>

#define QN_TYPE_CANVAS (qn_canvas_get_type ())
G_DECLARE_FINAL_TYPE (QnCanvas, qn_canvas, QN, CANVAS, GtkWidget)

/* Where the pointer is. */
typedef struct QnToolEvent {
  QnVec2 screen; /* px of the canvas */
  QnVec2 model;  /* m, exactly there */
  QnVec2 point;  /* m, where the magnet puts it */
  GdkModifierType modifiers;
  int press_count;
} QnToolEvent;

/* What a gesture has so far; one per canvas, the tool's to use. */
typedef struct QnGesture {
  QnVec2 from, to;    /* m */
  QnVec2 from_screen; /* px, where the button went down */
  gboolean dragging;  /* moved far enough to be no click */
  gboolean band;      /* a selection rectangle rather than a move */
  GArray *points;     /* of QnVec2, of a polygon */
} QnGesture;

typedef struct QnTool {
  const char *name; /* target of the window's action "tool" */
  const char *icon;
  const char *label; /* translatable, shown as tooltip */
  const char *hint;  /* translatable, shown in the status bar */
  const char *accel; /* single key */
  gboolean magnetic; /* whether the magnet works before a gesture has begun */

  void (*press) (QnCanvas *canvas, const QnToolEvent *event);
  void (*motion) (QnCanvas *canvas, const QnToolEvent *event);
  void (*release) (QnCanvas *canvas, const QnToolEvent *event);
  /* Completes the gesture with typed numbers (SI); false: these are not the right ones. */
  gboolean (*numbers) (QnCanvas *canvas, const double *values, int count);
  /* Gives up the gesture. */
  void (*cancel) (QnCanvas *canvas);
  /* Draws the gesture in px of the canvas. */
  void (*draw) (QnCanvas *canvas, cairo_t *cr);
} QnTool;

/* All tools, in the order of the palette; NULL-terminated. */
extern const QnTool *const qn_tools[];
const QnTool *qn_tool_find (const char *name);

extern const QnTool qn_tool_select;
extern const QnTool qn_tool_wall;
extern const QnTool qn_tool_opening;
extern const QnTool qn_tool_rectangle;
extern const QnTool qn_tool_polygon;
extern const QnTool qn_tool_support;
extern const QnTool qn_tool_force;
extern const QnTool qn_tool_measure;
extern const QnTool qn_tool_picture;

/* What the tools draw with; shared by all of a window's tools and shown in its panel. */
typedef struct QnToolSettings {
  QnWallPlan wall; /* origin and size are the gesture's */
  gboolean lintel; /* of new openings */
  double force;    /* N, of new forces */
  gboolean live;   /* whether new forces grow with the multiplier */
} QnToolSettings;

#endif
