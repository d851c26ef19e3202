/* The drawing: shows what the view state says, and hands the pointer to the current tool.
 *
 * Zooms about the pointer (wheel, pinch), pans with the middle button or two fingers, fits on
 * request. Grid, rulers, selection, findings and the tool's gesture are drawn over the scene.
 *
 * Signals: "status" (without arguments) when pointer, hint or snapping have changed; "tool-changed";
 * "failed" (message) when an edit was refused.
 */
#pragma once

#include "app/canvas/gl-layer.h"
#include "app/canvas/scene-cache.h"
#include "app/canvas/tool.h"
#include "doc/edit/edit-frame.h"
#include "doc/view/view-state.h"
#include "render/drawing/scene.h"
#include "stereotomy/gaps.h"

/* All but `gesture` and `corner` is only read outside of this room. */
struct _QnCanvas {
  GtkWidget parent_instance;

  QnViewState *state;
  QnDocument *document;     /* of the state */
  QnSelection *selection;   /* of the document */
  QnToolSettings *settings; /* the window's */
  const QnTool *tool, *resting;
  QnGesture gesture;   /* the one of the canvas, the current tool's to change */
  gboolean in_gesture; /* a tool has begun something that Escape gives up */
  QnCamera camera;     /* what part is in view */
  GtkWidget *corner;   /* over which something lies: the legend gives way to it; weak */

  /* The rest is of the files of the canvas alone. */
  QnScene *scene; /* NULL: to be built */
  GError *scene_error;
  QnSceneCache cache;
  QnGlLayer gl_layer; /* large scenes by OpenGL */
  guint rest_timeout; /* runs while the camera moves */
  gboolean wants_fit; /* at the next drawing */
  gboolean keeps_fit; /* until the user zooms or pans */
  QnView shown_view;

  QnVec2 pointer; /* px */
  gboolean pointer_inside;
  GdkModifierType modifiers;
  QnMagnetHit hit;
  gboolean *magnet_skip;
  gboolean pressed;
  GString *typed;           /* numbers typed during a gesture */
  QnVec2 mouse;             /* where the pointing device is, px */
  gboolean keyboard_cursor; /* the pointer was last moved by keys */
  QnMasonries masonry;      /* of the document, read when needed */
  gboolean has_masonry;
  QnVec2 zoom_center;
  QnCamera gesture_camera;

  gboolean has_rested;     /* the pointer, long enough to be told what is there … */
  QnView rested_view;      /* … in this view, … */
  const QnRun *rested_run; /* … of this run, which may be gone */
  guint inspect_timeout;
  QnVec2 place; /* ringed while the timeout runs, m */
  guint place_timeout;
  QnBox card;  /* beside the pointer, px, as drawn last; empty: none */
  QnGaps gaps; /* marked */
};

/* Connects a canvas made by a template; once, before anything else. `resting` is the tool that it
 * begins with and that Escape returns to; arrow keys move what is selected with it. */
void qn_canvas_set_state (QnCanvas *canvas, QnViewState *state, QnToolSettings *settings,
                          const QnTool *resting);

const QnModel *qn_canvas_get_model (QnCanvas *canvas); /* the document's */

void qn_canvas_set_tool (QnCanvas *canvas, const QnTool *tool);
/* Gives up the gesture of the current tool. */
void qn_canvas_cancel_gesture (QnCanvas *canvas);

/* Brings everything into view when the canvas is drawn next, and keeps it there until the user
 * zooms or pans. */
void qn_canvas_fit (QnCanvas *canvas);
void qn_canvas_zoom (QnCanvas *canvas, double factor); /* about the middle */
/* Brings a place into view and rings it. */
void qn_canvas_show_place (QnCanvas *canvas, QnVec2 at);

/* Marks gaps in the views of the model from now on; takes them over. */
void qn_canvas_show_gaps (QnCanvas *canvas, QnGaps *gaps);

/* Brings an area into view, where it is not. */
void qn_canvas_show_area (QnCanvas *canvas, QnVec2 low, QnVec2 high);

/* One line on the pointer: place and what the magnet took; the caller frees it. */
char *qn_canvas_dup_status (QnCanvas *canvas);

/* ---- for tools ---- */

/* Whether the pointer has moved too far since the press to be a click. */
gboolean qn_canvas_is_drag (QnCanvas *canvas, const QnToolEvent *event);

/* Screen place of a point of the model. */
QnVec2 qn_canvas_to_screen (QnCanvas *canvas, QnVec2 point);

/* Topmost entity of these kinds under the pointer; kinds as of qn_pick_at(). */
QnPick qn_canvas_pick (QnCanvas *canvas, QnVec2 screen, unsigned kinds);
void qn_canvas_pick_inside (QnCanvas *canvas, QnVec2 a, QnVec2 b, GArray *ids);

/* The joint of the view's model that is drawn under the pointer, in any view, or QN_NONE; none beside
 * blocks that are small on the screen. */
QnId qn_canvas_pick_joint (QnCanvas *canvas, QnVec2 screen);

/* Faces whose middle lies in the rectangle between two points of the model. */
void qn_canvas_faces_inside (QnCanvas *canvas, QnVec2 a, QnVec2 b, GArray *ids);

/* Beams whose both ends lie there. */
void qn_canvas_beams_inside (QnCanvas *canvas, QnVec2 a, QnVec2 b, GArray *ids);

/* The document's parametric masonry; borrowed until the next change. */
const QnMasonries *qn_canvas_get_masonry (QnCanvas *canvas);

/* Box around the selected blocks and beams; FALSE where there are none. */
gboolean qn_canvas_get_parts_box (QnCanvas *canvas, QnVec2 *low, QnVec2 *high);

/* The node of beams under the pointer, or QN_NONE. */
QnId qn_canvas_pick_node (QnCanvas *canvas, QnVec2 screen);

/* Whether the magnet is on at the moment. */
gboolean qn_canvas_snaps (QnCanvas *canvas);
/* Where the magnet has a point; the point where it is off. */
QnVec2 qn_canvas_snap (QnCanvas *canvas, QnVec2 point);

/* Blocks that the magnet leaves alone, one flag per block, taken over; NULL for none. */
void qn_canvas_set_magnet_skip (QnCanvas *canvas, gboolean *skip);

/* Begin and end an edit as qn_document_begin_edit() and qn_document_end_edit() do; FALSE where it is
 * refused, which the signal "failed" has told then. */
gboolean qn_canvas_begin_edit (QnCanvas *canvas, QnCanvasDraft *draft);
gboolean qn_canvas_end_edit (QnCanvas *canvas, QnCanvasDraft *draft, const char *name,
                             const char *key, gboolean done);
/* Moves the selected blocks and beams in one step; with `copies` adds so many, each moved against the one
 * before, and leaves the selected ones where they are. */
gboolean qn_canvas_transform (QnCanvas *canvas, const char *name, const char *key,
                              QnTransform transform, int copies);

/* Tells the user why something cannot be done. */
void qn_canvas_tell (QnCanvas *canvas, const char *message);

/* Says that a gesture is under way (Escape gives it up, numbers are typed for it) or over. */
void qn_canvas_set_in_gesture (QnCanvas *canvas, gboolean in_gesture);

/* Draws a dimension line with its length between two points of the model. */
void qn_canvas_draw_dimension (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);
/* A text on paper, its upper left corner at a place of the screen. */
void qn_canvas_draw_label (QnCanvas *canvas, cairo_t *cr, const char *text,
                           QnVec2 screen);
/* Traces a polygon of the model as a path. */
void qn_canvas_trace (QnCanvas *canvas, cairo_t *cr, const QnVec2 *points, gsize count);
void qn_canvas_trace_line (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);
