/* The scene: the whole picture as one sorted array of drawing commands.
 *
 * Builders (scene/scene-build.h) decide what is drawn; the back ends (draw-cairo.h, draw-gl.h)
 * and the picker only walk this array and agree therefore by construction.
 *
 * Places are in model coordinates (m, y up). Line widths, marker sizes and text sizes are in
 * typographic points and do not grow with zoom. Commands are ordered by layer, then by the
 * order in which they were added; later ones cover earlier ones.
 */
#pragma once

#include "core/result/mechanism.h"
#include "render/drawing/camera.h"
#include "render/drawing/color.h"

#include <cairo.h>
#include <glib.h>

typedef enum {
  QN_LAYER_UNDERLAY,
  QN_LAYER_GHOST,
  QN_LAYER_BLOCKS,
  QN_LAYER_GAPS, /* open joints, filled */
  QN_LAYER_HATCH,
  QN_LAYER_OUTLINES,
  QN_LAYER_JOINTS, /* contact faces, sliding joints */
  QN_LAYER_ONION,  /* outlines of a second result */
  QN_LAYER_LOADS,
  QN_LAYER_FORCES,
  QN_LAYER_SYMBOLS,
  QN_LAYER_DIMENSIONS,
  QN_LAYER_LABELS,
  QN_LAYER_COUNT
} QnLayer;

typedef enum {
  QN_COMMAND_FILL,   /* polygon, simple, concave allowed */
  QN_COMMAND_STROKE, /* open or closed line */
  QN_COMMAND_MARKER, /* a symbol of fixed size at one point */
  QN_COMMAND_TEXT,   /* a label of fixed size at one point */
  QN_COMMAND_IMAGE   /* a photo over the parallelogram of four points */
} QnCommandKind;

/* Symbols that stay different in black and white. */
typedef enum {
  QN_MARKER_DOT,        /* filled disc */
  QN_MARKER_RING,       /* white disc with a rim: hinge */
  QN_MARKER_SLIDE,      /* two opposed half arrows along the joint */
  QN_MARKER_CROSS,      /* x: collapse point, separated joint */
  QN_MARKER_ARROW_HEAD, /* filled, tip at the point, pointing along the angle */
  QN_MARKER_SQUARE,     /* filled */
  QN_MARKER_DIAMOND,    /* white with a rim: limit point */
  QN_MARKER_TICK,       /* short oblique stroke of dimension lines */
  QN_MARKER_COUNT
} QnMarker;

/* Kind of the entity of a command, for picking; the first ones can be selected, those from the loads on
 * stand in lists. */
typedef enum {
  QN_PICK_NOTHING,
  QN_PICK_BLOCK,
  QN_PICK_BEAM,
  QN_PICK_FACE,
  QN_PICK_DEAD_LOAD,
  QN_PICK_LIVE_LOAD, /* those of all sets */
  QN_PICK_BAR,
  QN_PICK_TIE,
  QN_PICK_PAIR,
  QN_PICK_FOUND /* a contact found on the way */
} QnPickKind;
#define QN_PICK_LOAD(live) ((live) ? QN_PICK_LIVE_LOAD : QN_PICK_DEAD_LOAD)

typedef struct QnCommand {
  uint8_t layer, kind, marker;
  bool closed, dashed;
  bool mirrored; /* MARKER: about its axis */
  uint8_t pick;  /* QnPickKind */
  QnId id;       /* index of the picked entity, or QN_NONE */
  QnColor color;
  float size;  /* pt: stroke width, marker size, text height */
  float angle; /* rad, counter-clockwise: direction of a marker or of a line of text */
  float align_x,
    align_y;    /* text: 0 = the point is left/bottom, 0.5 middle, 1 right/top */
  float extent; /* m: size of the annotated object; drawn from `least` pt on. 0: always */
  float least;  /* pt */
  float most;   /* pt: left out where `extent` is as large or larger. 0: never */
  uint32_t first, count; /* into QnScene.points */
  const char *text;      /* TEXT: owned by the scene */
  QnBox box;             /* m, of the points */
} QnCommand;

/* One line of the legend. */
typedef struct QnLegendEntry {
  uint8_t kind; /* QnCommandKind: how the sample is drawn */
  uint8_t marker;
  bool dashed, hatched;
  QnColor color;
  float size; /* pt */
  char *text;
} QnLegendEntry;

/* The colour bar of a field. */
typedef struct QnColorBar {
  bool shown, diverging;
  double min, max; /* in SI */
  char *title;     /* with unit, for values multiplied by `factor` */
  double factor;
} QnColorBar;

typedef struct QnScene {
  GArray *commands; /* of QnCommand */
  GArray *points;   /* of QnVec2 */
  GArray *legend;   /* of QnLegendEntry */
  GStringChunk *strings;
  QnColorBar bar;
  cairo_surface_t *image; /* of the IMAGE command, referenced; or NULL */
  QnBox box;              /* of all commands */
  double
    fineness;   /* m: smaller side of an ordinary block; thins lines of distant views */
  double scale; /* displacement factor used, or 0 where nothing is displaced */
  QnMechanismKind mechanism; /* kind of the one that is shown; NONE where none is */
  bool monochrome;
  uint64_t revision; /* changes whenever the content does; never 0 */
} QnScene;

/* An empty scene, for builders. */
QnScene *qn_scene_new (void);
void qn_scene_free (QnScene *scene);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnScene, qn_scene_free)

/* ---- for builders ---------------------------------------------------------------------- */

/* Adds a command; the pointer is valid until the next addition. */
QnCommand *qn_scene_fill (QnScene *scene, QnLayer layer, const QnVec2 *points,
                          size_t count, QnColor color);
QnCommand *qn_scene_stroke (QnScene *scene, QnLayer layer, const QnVec2 *points,
                            size_t count, bool closed, double width, QnColor color);
QnCommand *qn_scene_marker (QnScene *scene, QnLayer layer, QnMarker marker, QnVec2 at,
                            double size, double angle, QnColor color);
QnCommand *qn_scene_text (QnScene *scene, QnLayer layer, QnVec2 at, double size,
                          const char *text, QnColor color);
/* A line with an arrow head at `to`, which takes most of a short arrow and never all of it. `extent`:
 * size below which all of it is left out, m, or 0. */
void qn_scene_arrow (QnScene *scene, QnLayer layer, QnVec2 from, QnVec2 to, double width,
                     QnColor color, QnPickKind pick, QnId id, double extent);

/* Sets the entity of a command, for picking. */
static inline void
qn_command_set_pick (QnCommand *command, QnPickKind pick, QnId id)
{
  command->pick = (uint8_t) pick;
  command->id = id;
}

/* Size of the annotated object, m: the command is left out if that is less than `least` pt. */
static inline void
qn_command_set_extent (QnCommand *command, double extent, double least)
{
  command->extent = (float) extent;
  command->least = (float) least;
}

/* Whether the size of the annotated object is within the limits of the command. */
static inline bool
qn_command_has_size (const QnCommand *command, const QnCamera *camera)
{
  double size = command->extent * camera->scale / camera->unit;
  return !(command->extent > 0)
         || (size >= command->least && !(command->most > 0 && size >= command->most));
}

/* Adds a line to the legend; valid until the next addition. `size`: of a line or of a marker, which is a dot
 * unless it is set, pt. */
QnLegendEntry *qn_scene_legend (QnScene *scene, QnCommandKind kind, double size,
                                QnColor color, const char *format, ...)
  G_GNUC_PRINTF (5, 6);

/* Sorts the commands and computes the box. To be called once, when all is added. */
void qn_scene_finish (QnScene *scene);

static inline const QnCommand *
qn_scene_command (const QnScene *scene, size_t i)
{
  return &g_array_index (scene->commands, QnCommand, i);
}

static inline const QnVec2 *
qn_scene_points (const QnScene *scene, const QnCommand *command)
{
  return &g_array_index (scene->points, QnVec2, command->first);
}

/* Colour of a value of the field: a diverging map is centred at zero. */
QnColor qn_color_bar_color (const QnColorBar *bar, double value, int monochrome);

/* Whether a command is worth drawing: inside the viewport and not below its least size. Both
 * back ends and the picker use it. */
bool qn_command_is_visible (const QnCommand *command, const QnCamera *camera,
                            QnBox visible);

/* Factor, 0 .. 1, on the widths of the lines of blocks and joints: where blocks are few pixels
 * tall, lines must not drown them. */
double qn_scene_line_factor (const QnScene *scene, const QnCamera *camera);

/* Whether the factor applies to a command. */
static inline bool
qn_command_is_thinned (const QnCommand *command)
{
  return command->layer == QN_LAYER_OUTLINES || command->layer == QN_LAYER_GHOST
         || command->layer == QN_LAYER_HATCH || command->layer == QN_LAYER_JOINTS
         || command->layer == QN_LAYER_FORCES;
}

/* What is under the pointer in the drawn scene. */
typedef struct QnPick {
  QnPickKind kind; /* QN_PICK_NOTHING: nothing there */
  QnId id;
} QnPick;

/* The topmost visible command within `reach` px of the screen point. `kinds` is a set of
 * bits 1 << QnPickKind, or 0 for every kind. */
QnPick qn_pick_at (const QnScene *scene, const QnCamera *camera, QnVec2 screen,
                   double reach, unsigned kinds);

/* Appends to `ids` (of QnId) every entity of one kind whose commands lie wholly inside the
 * rectangle between two screen points; each once. */
void qn_pick_inside (const QnScene *scene, const QnCamera *camera, QnVec2 corner_a,
                     QnVec2 corner_b, QnPickKind kind, GArray *ids);
