#include "app/canvas/canvas-private.h"
#include "app/canvas/gap-marks.h"
#include "app/canvas/gesture.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "doc/edit/edit-dynamic.h"
#include "render/backend/draw-cairo.h"
#include "render/drawing/paint.h"
#include "render/figure/figure-furniture.h"

#include <glib/gi18n.h>
#include <pango/pangocairo.h>

#define RULER_POINTS 15.0
#define GRID_PX      60.0 /* least distance of labelled grid lines */
#define MOST_MARKS   300  /* of findings: more hide the drawing */
#define MARK_PX      7.0
#define RING_PX      16.0
#define CURSOR_PX    14.0
#define LABEL_PAD    4.0
#define LEGEND_INSET 10.0
#define LEGEND_PAD   4.0
#define LEGEND_TOP   42.0 /* points: below the choice of view */

/* A legend that would cover more of the canvas than this shows its scales alone: the structure would
 * be small beside it. */
#define LEGEND_MOST 0.18

static void
set_selection_ink (cairo_t *cr, double alpha)
{
  qn_set_color (cr, qn_ink (QN_INK_SELECTION, false), alpha);
}

PangoLayout *
qn_canvas_make_text (QnCanvas *self, const char *text, double points)
{
  PangoLayout *layout = gtk_widget_create_pango_layout (GTK_WIDGET (self), text);
  PangoFontDescription *font =
    pango_font_description_copy (pango_context_get_font_description (
      gtk_widget_get_pango_context (GTK_WIDGET (self))));
  pango_font_description_set_absolute_size (font,
                                            points * self->camera.unit * PANGO_SCALE);
  pango_layout_set_font_description (layout, font);
  pango_font_description_free (font);
  return layout;
}

static double
ruler_px (const QnCanvas *self)
{
  return RULER_POINTS * self->camera.unit;
}

double
qn_canvas_grid_distance (QnCanvas *self)
{
  return qn_magnet_round_distance (GRID_PX / self->camera.scale);
}

/* ---- grid and rulers ---- */

static void
draw_grid_lines (QnCanvas *self, cairo_t *cr, double distance)
{
  QnBox box = qn_camera_visible_box (&self->camera);
  for (double i = ceil (box.min.x / distance); i * distance <= box.max.x; i++) {
    double x = floor (qn_canvas_to_screen (self, qn_vec2 (i * distance, 0.0)).x) + 0.5;
    cairo_move_to (cr, x, 0.0);
    cairo_line_to (cr, x, self->camera.height);
  }
  for (double i = ceil (box.min.y / distance); i * distance <= box.max.y; i++) {
    double y = floor (qn_canvas_to_screen (self, qn_vec2 (0.0, i * distance)).y) + 0.5;
    cairo_move_to (cr, 0.0, y);
    cairo_line_to (cr, self->camera.width, y);
  }
  cairo_set_line_width (cr, 1.0);
  cairo_stroke (cr);
}

static void
draw_ruler_ticks (QnCanvas *self, cairo_t *cr, gboolean vertical)
{
  double distance = qn_canvas_grid_distance (self) / 5.0;
  QnBox box = qn_camera_visible_box (&self->camera);
  double from = vertical ? box.min.y : box.min.x, to = vertical ? box.max.y : box.max.x;
  for (double i = ceil (from / distance); i * distance <= to; i++) {
    double value = i * distance;
    QnVec2 s = qn_canvas_to_screen (self, qn_vec2 (value, value));
    gboolean major = fmod (fabs (i), 5.0) < 0.5;
    double length = major ? ruler_px (self) : 5.0;
    if (vertical) {
      cairo_move_to (cr, ruler_px (self), floor (s.y) + 0.5);
      cairo_line_to (cr, ruler_px (self) - length, floor (s.y) + 0.5);
    } else {
      cairo_move_to (cr, floor (s.x) + 0.5, ruler_px (self));
      cairo_line_to (cr, floor (s.x) + 0.5, ruler_px (self) - length);
    }
    cairo_stroke (cr);
    if (major) {
      g_autofree char *text = qn_units_format (
        qn_settings_get_units (), QN_QUANTITY_LENGTH, i == 0.0 ? 0.0 : value, 6);
      g_autoptr (PangoLayout) layout = qn_canvas_make_text (self, text, 7.0);
      cairo_save (cr);
      cairo_move_to (cr, vertical ? 2.0 : s.x + 3.0, vertical ? s.y - 3.0 : 2.0);
      if (vertical)
        cairo_rotate (cr, -G_PI_2);
      pango_cairo_show_layout (cr, layout);
      cairo_restore (cr);
    }
  }
}

static void
draw_rulers (QnCanvas *self, cairo_t *cr)
{
  cairo_save (cr);
  cairo_set_source_rgb (cr, 0.955, 0.955, 0.95);
  cairo_rectangle (cr, 0.0, 0.0, self->camera.width, ruler_px (self));
  cairo_rectangle (cr, 0.0, 0.0, ruler_px (self), self->camera.height);
  cairo_fill (cr);
  cairo_set_source_rgb (cr, 0.35, 0.37, 0.4);
  cairo_set_line_width (cr, 1.0);

  cairo_save (cr);
  cairo_rectangle (cr, ruler_px (self), 0.0, self->camera.width, ruler_px (self));
  cairo_clip (cr);
  draw_ruler_ticks (self, cr, FALSE);
  cairo_restore (cr);
  cairo_save (cr);
  cairo_rectangle (cr, 0.0, ruler_px (self), ruler_px (self), self->camera.height);
  cairo_clip (cr);
  draw_ruler_ticks (self, cr, TRUE);
  cairo_restore (cr);

  if (self->pointer_inside) {
    QnVec2 s = qn_canvas_to_screen (self, self->hit.point);
    set_selection_ink (cr, 1.0);
    cairo_move_to (cr, floor (s.x) + 0.5, 0.0);
    cairo_rel_line_to (cr, 0.0, ruler_px (self));
    cairo_move_to (cr, 0.0, floor (s.y) + 0.5);
    cairo_rel_line_to (cr, ruler_px (self), 0.0);
    cairo_stroke (cr);
  }
  g_autoptr (PangoLayout) unit = qn_canvas_make_text (
    self, qn_units_symbol (qn_settings_get_units (), QN_QUANTITY_LENGTH), 7.0);
  cairo_set_source_rgb (cr, 0.955, 0.955, 0.95);
  cairo_rectangle (cr, 0.0, 0.0, ruler_px (self), ruler_px (self));
  cairo_fill (cr);
  cairo_set_source_rgb (cr, 0.35, 0.37, 0.4);
  cairo_move_to (cr, 4.0, 3.0);
  pango_cairo_show_layout (cr, unit);
  cairo_restore (cr);
}

/* ---- over the scene ---- */

void
qn_canvas_trace (QnCanvas *self, cairo_t *cr, const QnVec2 *points, gsize count)
{
  cairo_new_sub_path (cr);
  for (gsize i = 0; i < count; i++) {
    QnVec2 s = qn_canvas_to_screen (self, points[i]);
    cairo_line_to (cr, s.x, s.y);
  }
  cairo_close_path (cr);
}

void
qn_canvas_trace_line (QnCanvas *self, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  QnVec2 s = qn_canvas_to_screen (self, a), t = qn_canvas_to_screen (self, b);
  cairo_move_to (cr, s.x, s.y);
  cairo_line_to (cr, t.x, t.y);
}

/* What the scene draws of a load, bar or tie, where it is displaced too; of a load with the edges it lies on. */
static void
trace_item (QnCanvas *self, cairo_t *cr, QnPick item, gboolean displaced)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  const QnModel *model = qn_canvas_get_model (self);
  const gboolean live = item.kind == QN_PICK_LIVE_LOAD;
  for (guint i = 0; scene != NULL && i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    const QnVec2 *v = qn_scene_points (scene, command);
    for (uint32_t k = 1; command->pick == item.kind && command->id == item.id
                         && command->kind == QN_COMMAND_STROKE && k < command->count;
         k++)
      qn_canvas_trace_line (self, cr, v[k - 1], v[k]);
  }
  gsize count = 0;
  if (displaced || !(live || item.kind == QN_PICK_DEAD_LOAD))
    return;
  qn_model_loads (model, live, &count);
  if ((gsize) item.id >= count)
    return;
  const QnEdgeForce *forces = qn_model_edge_forces_of (
    model, (gsize) item.id + (live ? model->dead_load_count : 0), &count);
  for (gsize i = 0; i < count; i++)
    qn_canvas_trace_line (self, cr, forces[i].ends[0], forces[i].ends[1]);
}

/* Beams along their axes, wider than these are drawn; so bars, ties and the arrows of loads. */
static void
draw_selected_lines (QnCanvas *self, cairo_t *cr, gboolean displaced)
{
  const QnModel *model = qn_canvas_get_model (self);
  guint count = 0;
  const QnId *ids = qn_selection_get (self->selection, QN_PICK_BEAM, &count);
  for (guint i = 0; i < count && !displaced; i++) {
    if ((gsize) ids[i] >= model->beam_count)
      continue;
    const QnId *ends = model->beams[ids[i]].nodes;
    qn_canvas_trace_line (self, cr, model->nodes[ends[0]].at, model->nodes[ends[1]].at);
  }
  const QnPick item = qn_selection_get_item (self->selection);
  if (item.id != QN_NONE)
    trace_item (self, cr, item, displaced);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
  const QnColor c = qn_ink (QN_INK_SELECTION, false);
  GdkRGBA ink = { c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, 1.0f }, halo = ink;
  halo.alpha = 0.3f;
  qn_gesture_stroke (cr, halo, 9.0, ink, 3.0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
}

/* Selected things are outlined where the view draws them: displaced blocks too, unless the result
 * is of another model. */
static void
draw_selection (QnCanvas *self, cairo_t *cr)
{
  QnDocument *document = self->document;
  const QnModel *model = &document->project.model;
  const QnContacts *contacts = &document->contacts;
  const QnRun *run = document->run;
  gboolean displaced = qn_view_needs_result (self->state->options.view);
  if (displaced && (run == NULL || qn_document_is_stale (document, run)))
    return;
  QnMotion motion = displaced ? qn_canvas_get_motion (self) : (QnMotion){ 0 };
  if (displaced && motion.model == NULL)
    return;
  guint count = 0;
  const QnId *blocks = qn_selection_get (self->selection, QN_PICK_BLOCK, &count);
  for (guint i = 0; i < count; i++) {
    if ((gsize) blocks[i] >= model->block_count)
      continue;
    qn_canvas_trace_placed (self, cr, &motion, model, blocks[i]);
  }
  set_selection_ink (cr, 0.18);
  cairo_fill_preserve (cr);
  set_selection_ink (cr, 1.0);
  cairo_set_line_width (cr, 2.0);
  cairo_stroke (cr);

  const QnId *faces = qn_selection_get (self->selection, QN_PICK_FACE, &count);
  for (guint i = 0; i < count; i++) {
    if ((gsize) faces[i] >= contacts->face_count)
      continue;
    QnVec2 line[2];
    qn_canvas_joint_line (self, &motion, &contacts->faces[faces[i]], line);
    cairo_move_to (cr, line[0].x, line[0].y);
    cairo_line_to (cr, line[1].x, line[1].y);
  }
  cairo_set_line_width (cr, 6.0);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
  cairo_stroke (cr);
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_BUTT);
  draw_selected_lines (self, cr, displaced);
}

/* A warning triangle at the place of each finding. */
static void
draw_findings (QnCanvas *self, cairo_t *cr)
{
  const QnFindings *findings = &self->document->contacts.findings;
  gsize shown = MIN (findings->count, MOST_MARKS);
  for (gsize i = 0; i < shown; i++) {
    if (!qn_finding_has_place (&findings->items[i]))
      continue;
    QnVec2 s = qn_canvas_to_screen (self, findings->items[i].at);
    cairo_move_to (cr, s.x, s.y - MARK_PX);
    cairo_line_to (cr, s.x + MARK_PX, s.y + 0.7 * MARK_PX);
    cairo_line_to (cr, s.x - MARK_PX, s.y + 0.7 * MARK_PX);
    cairo_close_path (cr);
    cairo_set_source_rgb (cr, 1.0, 0.82, 0.2);
    cairo_fill_preserve (cr);
    cairo_set_source_rgb (cr, 0.2, 0.15, 0.0);
    cairo_set_line_width (cr, 1.3);
    cairo_stroke (cr);
    cairo_rectangle (cr, s.x - 0.8, s.y - 3.0, 1.6, 4.2);
    cairo_rectangle (cr, s.x - 0.8, s.y + 2.0, 1.6, 1.6);
    cairo_fill (cr);
  }
}

static void
draw_magnet (QnCanvas *self, cairo_t *cr)
{
  QnVec2 s = qn_canvas_to_screen (self, self->hit.point);
  set_selection_ink (cr, 1.0);
  cairo_set_line_width (cr, 1.5);
  switch (self->hit.kind) {
  case QN_MAGNET_NODE:
    cairo_arc (cr, s.x, s.y, 6.0, 0.0, 2.0 * G_PI);
    break;
  case QN_MAGNET_CORNER:
    cairo_rectangle (cr, s.x - 5.0, s.y - 5.0, 10.0, 10.0);
    break;
  case QN_MAGNET_MIDDLE:
    cairo_move_to (cr, s.x, s.y - 6.0);
    cairo_line_to (cr, s.x + 6.0, s.y + 5.0);
    cairo_line_to (cr, s.x - 6.0, s.y + 5.0);
    cairo_close_path (cr);
    break;
  case QN_MAGNET_EDGE:
  case QN_MAGNET_COURSE:
    qn_canvas_trace_line (self, cr, self->hit.a, self->hit.b);
    cairo_new_sub_path (cr);
    cairo_arc (cr, s.x, s.y, 4.0, 0.0, 2.0 * G_PI);
    break;
  case QN_MAGNET_GRID:
    cairo_move_to (cr, s.x - 6.0, s.y);
    cairo_line_to (cr, s.x + 6.0, s.y);
    cairo_move_to (cr, s.x, s.y - 6.0);
    cairo_line_to (cr, s.x, s.y + 6.0);
    break;
  case QN_MAGNET_NOTHING:
    return;
  }
  cairo_stroke (cr);
}

/* The pointer that the arrow keys move. */
static void
draw_cursor (QnCanvas *self, cairo_t *cr)
{
  QnVec2 s = qn_canvas_to_screen (self, self->hit.point);
  cairo_move_to (cr, s.x - CURSOR_PX, s.y);
  cairo_line_to (cr, s.x + CURSOR_PX, s.y);
  cairo_move_to (cr, s.x, s.y - CURSOR_PX);
  cairo_line_to (cr, s.x, s.y + CURSOR_PX);
  qn_gesture_stroke (cr, (GdkRGBA){ 1.0f, 1.0f, 1.0f, 0.9f }, 4.0,
                     (GdkRGBA){ 0.1f, 0.1f, 0.1f, 1.0f }, 1.5);
}

/* What is typed for the gesture, beside the pointer. */
static void
draw_typed (QnCanvas *self, cairo_t *cr)
{
  const char *label =
    self->gesture.grip.kind == QN_GRIP_TURN ? N_ ("angle") : self->tool->numbers_label;
  g_autofree char *text =
    g_strdup_printf ("%s▏   %s", self->typed->str, label != NULL ? _ (label) : "");
  g_autoptr (PangoLayout) layout = qn_canvas_make_text (self, text, 10.0);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  double x = self->pointer.x + 16.0, y = self->pointer.y + 16.0;
  cairo_rectangle (cr, x - 6.0, y - 4.0, width + 12.0, height + 8.0);
  cairo_set_source_rgb (cr, 1.0, 1.0, 0.92);
  cairo_fill_preserve (cr);
  set_selection_ink (cr, 1.0);
  cairo_set_line_width (cr, 1.0);
  cairo_stroke (cr);
  cairo_set_source_rgb (cr, 0.1, 0.1, 0.1);
  cairo_move_to (cr, x, y);
  pango_cairo_show_layout (cr, layout);
}

static void
draw_layout (cairo_t *cr, PangoLayout *layout, QnVec2 at)
{
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  cairo_set_source_rgba (cr, 1.0, 1.0, 1.0, 0.85);
  cairo_rectangle (cr, at.x - 2.0, at.y, width + 4.0, height);
  cairo_fill (cr);
  set_selection_ink (cr, 1.0);
  cairo_move_to (cr, at.x, at.y);
  pango_cairo_show_layout (cr, layout);
}

void
qn_canvas_draw_dimension (QnCanvas *self, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  QnVec2 middle = qn_canvas_to_screen (self, qn_vec2_lerp (a, b, 0.5));
  double length = qn_vec2_length (qn_vec2_sub (b, a));
  set_selection_ink (cr, 1.0);
  cairo_set_line_width (cr, 1.0);
  qn_canvas_trace_line (self, cr, a, b);
  cairo_stroke (cr);

  g_autofree char *text =
    qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_LENGTH, length, 4);
  g_autoptr (PangoLayout) layout = qn_canvas_make_text (self, text, 9.0);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  draw_layout (cr, layout, qn_vec2 (middle.x - 0.5 * width, middle.y - 0.5 * height));
}

void
qn_canvas_draw_label (QnCanvas *self, cairo_t *cr, const char *text, QnVec2 screen)
{
  g_autoptr (PangoLayout) layout = qn_canvas_make_text (self, text, 9.0);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  /* What would lie beyond the drawing is read at its edge. */
  screen.x = fmin (screen.x, self->camera.width - width - LABEL_PAD);
  screen.y = fmin (screen.y, self->camera.height - height - LABEL_PAD);
  draw_layout (cr, layout, screen);
}

/* ---- all of it ---- */

/* Where blocks start from, as ghosts. */
static void
draw_initial (QnCanvas *self, cairo_t *cr)
{
  static const double dashes[] = { 5.0, 3.0 };
  const QnModel *model = qn_canvas_get_model (self);
  if (model->analysis.procedure != QN_PROCEDURE_DYNAMIC || model->initial_count == 0)
    return;
  for (gsize i = 0; i < model->initial_count; i++)
    qn_gesture_trace_block (self, cr, model->initial[i].block,
                            qn_initial_transform (model, &model->initial[i]));
  set_selection_ink (cr, 0.12);
  cairo_fill_preserve (cr);
  set_selection_ink (cr, 1.0);
  cairo_set_line_width (cr, 1.5);
  cairo_set_dash (cr, dashes, G_N_ELEMENTS (dashes), 0.0);
  cairo_stroke (cr);
  cairo_set_dash (cr, NULL, 0, 0.0);
}

/* Around its paper. */
static QnBox
legend_box (const QnFurniture *furniture)
{
  QnVec2 corner = qn_vec2 (furniture->x - LEGEND_PAD, furniture->y - LEGEND_PAD);
  QnVec2 size =
    qn_vec2 (furniture->width + 2 * LEGEND_PAD, furniture->height + 2 * LEGEND_PAD);
  return (QnBox){ corner, qn_vec2_add (corner, size) };
}

/* What a box on the screen hides of what is filled. */
static double
hidden_by (const QnCanvas *self, const QnScene *scene, QnBox box)
{
  double sum = 0.0;
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind != QN_COMMAND_FILL)
      continue;
    QnBox part = qn_box_of_points (qn_scene_points (scene, command), command->count);
    QnVec2 low = qn_camera_to_screen (&self->camera, part.min);
    QnVec2 high = qn_camera_to_screen (&self->camera, part.max);
    double width = fmin (box.max.x, high.x) - fmax (box.min.x, low.x);
    double height = fmin (box.max.y, low.y) - fmax (box.min.y, high.y);
    if (width > 0.0 && height > 0.0)
      sum += width * height;
  }
  return sum;
}

/* In the corner where it hides least of the structure: the lower left one, then the upper ones, below
 * the choice of view. Foundations are below, so that the lower right one, where buttons are, is none.
 */
static void
place_legend (QnCanvas *self, const QnScene *scene, QnFurniture *furniture)
{
  double left = ruler_px (self) + LEGEND_INSET,
         top = ruler_px (self) + LEGEND_TOP * self->camera.unit;
  double right = self->camera.width - furniture->width - LEGEND_INSET;
  const QnVec2 corners[] = {
    { left, furniture->y },
    { left, top },
    { right, top },
  };
  double least = INFINITY;
  QnVec2 best = corners[0];
  for (gsize i = 0; i < G_N_ELEMENTS (corners) && least > 0.0; i++) {
    furniture->x = corners[i].x;
    furniture->y = corners[i].y;
    double hidden = hidden_by (self, scene, legend_box (furniture));
    if (hidden < least) {
      least = hidden;
      best = corners[i];
    }
  }
  furniture->x = best.x;
  furniture->y = best.y;
}

/* Measured and placed. The caller clears it. */
static void
lay_legend (QnCanvas *self, cairo_t *cr, const QnScene *scene, gboolean placed,
            QnFurniture *furniture)
{
  qn_furniture_init (furniture, scene, cr, self->camera.unit, 0.4 * self->camera.width,
                     true);
  qn_furniture_column_size (furniture, &furniture->width, &furniture->height);
  if (furniture->width * furniture->height
      > LEGEND_MOST * self->camera.width * self->camera.height) {
    furniture->count = scene->bar.shown ? 2 : 1;
    qn_furniture_column_size (furniture, &furniture->width, &furniture->height);
  }
  furniture->x = ruler_px (self) + LEGEND_INSET;
  /* Above what lies in the other corner, where both have no room beside each other. */
  graphene_rect_t corner;
  double foot = self->camera.height;
  if (self->corner != NULL
      && gtk_widget_compute_bounds (self->corner, GTK_WIDGET (self), &corner)
      && furniture->x + furniture->width + LEGEND_PAD > corner.origin.x)
    foot = corner.origin.y;
  furniture->y = foot - furniture->height - LEGEND_INSET;
  if (placed)
    place_legend (self, scene, furniture);
}

QnBox
qn_canvas_legend_box (QnCanvas *self, const QnScene *scene)
{
  QnFurniture furniture;
  cairo_surface_t *surface = cairo_recording_surface_create (CAIRO_CONTENT_COLOR, NULL);
  cairo_t *cr = cairo_create (surface);
  lay_legend (self, cr, scene, FALSE, &furniture);
  QnBox box = legend_box (&furniture);
  qn_furniture_clear (&furniture);
  cairo_destroy (cr);
  cairo_surface_destroy (surface);
  return box;
}

/* Symbols and what they mean. */
static void
draw_legend (QnCanvas *self, cairo_t *cr, const QnScene *scene)
{
  QnFurniture furniture;
  lay_legend (self, cr, scene, TRUE, &furniture);
  QnBox box = legend_box (&furniture);
  cairo_set_source_rgba (cr, 1.0, 1.0, 1.0, 0.85);
  cairo_rectangle (cr, box.min.x, box.min.y, box.max.x - box.min.x,
                   box.max.y - box.min.y);
  cairo_fill (cr);
  qn_furniture_draw (&furniture, cr, self->camera.scale, true);
  qn_furniture_clear (&furniture);
}

static void
draw_message (QnCanvas *self, cairo_t *cr, const char *text)
{
  g_autoptr (PangoLayout) layout = qn_canvas_make_text (self, text, 12.0);
  pango_layout_set_alignment (layout, PANGO_ALIGN_CENTER);
  pango_layout_set_width (
    layout, (int) qn_to_integer (0.7 * self->camera.width, 0, G_MAXINT16) * PANGO_SCALE);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  cairo_set_source_rgba (cr, 0.3, 0.3, 0.3, 0.9);
  cairo_move_to (cr, 0.15 * self->camera.width, 0.5 * (self->camera.height - height));
  pango_cairo_show_layout (cr, layout);
}

void
qn_canvas_draw_below (QnCanvas *self, gboolean with_photo, cairo_t *cr)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  if (g_settings_get_boolean (qn_settings_get (), "grid")) {
    double distance = qn_canvas_grid_distance (self);
    cairo_set_source_rgba (cr, 0.2, 0.3, 0.5, 0.05);
    draw_grid_lines (self, cr, distance / 5.0);
    cairo_set_source_rgba (cr, 0.2, 0.3, 0.5, 0.11);
    draw_grid_lines (self, cr, distance);
  }
  if (with_photo && scene != NULL)
    qn_draw_cairo (scene, &self->camera, QN_LAYERS_CAIRO_BELOW, cr);
}

void
qn_canvas_draw_above (QnCanvas *self, gboolean with_labels, cairo_t *cr)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  gboolean undeformed = !qn_view_needs_result (self->state->options.view);
  if (with_labels && scene != NULL)
    qn_draw_cairo (scene, &self->camera, QN_LAYERS_CAIRO_ABOVE, cr);
  draw_selection (self, cr);
  if (undeformed) {
    qn_gap_marks_draw (&self->gaps, &self->camera, cr);
    draw_initial (self, cr);
    draw_findings (self, cr);
  }
  if (scene != NULL)
    draw_legend (self, cr, scene);
  else if (self->scene_error != NULL)
    draw_message (self, cr, self->scene_error->message);
  else if (!self->in_gesture)
    draw_message (self, cr,
                  _ (self->tool->begins
                       ? self->tool->hint
                       : N_ ("Choose the wall tool (W) and drag a rectangle")));

  void (*draw_tool) (QnCanvas *, cairo_t *) =
    self->in_gesture ? self->tool->draw : self->tool->draw_ready;
  cairo_new_path (cr); /* text leaves a current point behind */
  if (draw_tool != NULL)
    draw_tool (self, cr);
  if (self->keyboard_cursor && self->pointer_inside)
    draw_cursor (self, cr);
  if (self->pointer_inside)
    draw_magnet (self, cr);
  if (self->place_timeout != 0) {
    QnVec2 s = qn_canvas_to_screen (self, self->place);
    cairo_new_path (cr);
    cairo_arc (cr, s.x, s.y, RING_PX, 0.0, 2.0 * G_PI);
    qn_gesture_stroke (cr, (GdkRGBA){ 1.0f, 1.0f, 1.0f, 0.9f }, 6.0,
                       (GdkRGBA){ 0.85f, 0.1f, 0.1f, 1.0f }, 2.5);
  }
  draw_rulers (self, cr);
  qn_canvas_draw_inspected (self, cr);
  if (self->typed->len > 0)
    draw_typed (self, cr);
}

void
qn_canvas_draw (QnCanvas *self, cairo_t *cr)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  qn_canvas_draw_below (self, FALSE, cr);
  if (scene != NULL)
    qn_scene_cache_draw (&self->cache, scene, &self->camera, self->rest_timeout != 0,
                         gtk_widget_get_scale_factor (GTK_WIDGET (self)), cr);
  qn_canvas_draw_above (self, FALSE, cr);
}
