/* What is under the pointer, and what is selected, told beside it: the joint or block of every view,
 * with its forces, motions and state. */
#include "app/canvas/canvas-private.h"

#include "app/widgets/settings.h"
#include "core/base/polygon.h"
#include "doc/view/inspect.h"
#include <pango/pangocairo.h>

/* px: how near the pointer must be to a joint; and the least height of the blocks beside it, below
 * which the blocks come first. */
#define JOINT_REACH_PX 4.0
#define LEAST_BLOCK_PX 24.0

/* Radius of the ring around a contact found on the way, px. */
#define FOUND_PX 6.0

#define CARD_POINTS 8.5
#define CARD_PAD    7.0
#define CARD_ASIDE  18.0
#define CARD_GAP    10  /* points, between names and values */
#define REST_MS     500 /* in the view of the model, until it is told what is there */

/* ---- places ---- */

static QnVec2
place_of (QnCanvas *self, const QnMotion *motion, QnId block, QnVec2 p)
{
  return qn_canvas_to_screen (self, qn_motion_place (motion, block, p, motion->scale));
}

void
qn_canvas_trace_placed (QnCanvas *self, cairo_t *cr, const QnMotion *motion,
                        const QnModel *model, QnId block)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  cairo_new_sub_path (cr);
  for (QnId k = 0; k < model->blocks[block].vertex_count; k++) {
    QnVec2 s = place_of (self, motion, block, v[k]);
    cairo_line_to (cr, s.x, s.y);
  }
  cairo_close_path (cr);
}

QnMotion
qn_canvas_get_motion (QnCanvas *self)
{
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  const QnScene *scene = qn_canvas_get_scene (self);
  if (scene == NULL
      || !qn_view_state_get_content (self->state, self->state->options.view, &model,
                                     &contacts, &result))
    return (QnMotion){ 0 };
  QnViewOptions options = qn_view_state_get_options (self->state);
  return qn_scene_motion (scene, model, result, &options);
}

/* Of its two sides the middle. */
void
qn_canvas_joint_line (QnCanvas *self, const QnMotion *motion, const QnContactFace *face,
                      QnVec2 line[2])
{
  const QnVec2 ends[2] = { face->start, face->end };
  for (int i = 0; i < 2; i++)
    line[i] = qn_vec2_lerp (place_of (self, motion, face->a, ends[i]),
                            place_of (self, motion, face->b, ends[i]), 0.5);
}

QnId
qn_canvas_pick_joint (QnCanvas *self, QnVec2 screen)
{
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (self->state->options.view == QN_VIEW_CONTACTS) {
    QnPick pick = qn_canvas_pick (self, screen, 1u << QN_PICK_FACE);
    return pick.kind == QN_PICK_FACE ? pick.id : QN_NONE;
  }
  if (!qn_view_state_get_content (self->state, self->state->options.view, &model,
                                  &contacts, &result))
    return QN_NONE;
  QnMotion motion = qn_canvas_get_motion (self);
  g_autofree bool *left =
    result != NULL && result->step_count > 0
      ? qn_step_left (contacts, result, qn_view_state_get_shown_step (self->state))
      : NULL;
  QnId found = QN_NONE;
  double nearest = JOINT_REACH_PX;
  for (gsize f = 0; motion.model != NULL && f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    if (left != NULL && left[f])
      continue;
    QnVec2 line[2];
    qn_canvas_joint_line (self, &motion, face, line);
    double distance = qn_segment_distance (line[0], line[1], screen);
    if (distance < nearest
        && self->camera.scale
               * fmin (qn_box_smaller_side (qn_model_block_box (model, face->a)),
                       qn_box_smaller_side (qn_model_block_box (model, face->b)))
             >= LEAST_BLOCK_PX) {
      nearest = distance;
      found = (QnId) f;
    }
  }
  return found;
}

/* ---- the card ---- */

static QnPick
find_under_pointer (QnCanvas *self)
{
  QnPick pick = qn_canvas_pick (self, self->pointer, 1u << QN_PICK_FOUND);
  if (pick.kind == QN_PICK_FOUND)
    return pick;
  const QnPick joint = { QN_PICK_FACE, qn_canvas_pick_joint (self, self->pointer) };
  return joint.id != QN_NONE ? joint
                             : qn_canvas_pick (self, self->pointer, 1u << QN_PICK_BLOCK);
}

static gboolean
on_rest (gpointer data)
{
  QnCanvas *self = data;
  self->inspect_timeout = 0;
  self->has_rested = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  return G_SOURCE_REMOVE;
}

void
qn_canvas_pointer_moved (QnCanvas *self)
{
  self->rested_view = self->state->options.view;
  self->rested_run = self->document->run;
  self->has_rested = self->rested_view != QN_VIEW_MODEL;
  g_clear_handle_id (&self->inspect_timeout, g_source_remove);
  if (!self->has_rested)
    self->inspect_timeout = g_timeout_add (REST_MS, on_rest, self);
}

/* What is selected alone is told by the panel of results. */
static gboolean
is_selected (QnCanvas *self, QnPick what)
{
  return what.kind == QN_PICK_FACE
           ? qn_selection_get_one (self->selection, QN_PICK_FACE) == what.id
         : what.kind == QN_PICK_BLOCK
           ? qn_selection_has (self->selection, QN_PICK_BLOCK, what.id)
           : FALSE;
}

/* Whether buttons and labels that lie over the drawing would hide part of it. */
static gboolean
is_covered (QnCanvas *self, QnBox box)
{
  GtkWidget *canvas = GTK_WIDGET (self);
  graphene_rect_t room =
    GRAPHENE_RECT_INIT ((float) box.min.x, (float) box.min.y,
                        (float) (box.max.x - box.min.x), (float) (box.max.y - box.min.y));
  for (GtkWidget *other = gtk_widget_get_first_child (gtk_widget_get_parent (canvas));
       other != NULL; other = gtk_widget_get_next_sibling (other)) {
    graphene_rect_t bounds;
    if (other != canvas && gtk_widget_get_mapped (other)
        && gtk_widget_compute_bounds (other, canvas, &bounds)
        && graphene_rect_intersection (&bounds, &room, NULL))
      return TRUE;
  }
  return FALSE;
}

/* Beside the pointer, where there is room. */
static QnBox
card_place (QnCanvas *self, double width, double height)
{
  double right = self->pointer.x + CARD_ASIDE, below = self->pointer.y + CARD_ASIDE;
  double left = self->pointer.x - CARD_ASIDE - width;
  double above = self->pointer.y - CARD_ASIDE - height;
  const QnVec2 places[] = {
    { right, below }, { left, below }, { right, above }, { left, above }
  };
  QnBox first = { 0 };
  for (gsize i = 0; i < G_N_ELEMENTS (places); i++) {
    QnVec2 at =
      qn_vec2 (CLAMP (places[i].x, 0.0, fmax (self->camera.width - width, 0.0)),
               CLAMP (places[i].y, 0.0, fmax (self->camera.height - height, 0.0)));
    QnBox box = { at, qn_vec2_add (at, qn_vec2 (width, height)) };
    if (i == 0)
      first = box;
    if (at.x == places[i].x && at.y == places[i].y && !is_covered (self, box))
      return box;
  }
  return first;
}

static PangoLayout *
make_card (QnCanvas *self, const char *title, const char *values)
{
  g_autofree char *markup = g_markup_printf_escaped ("<b>%s</b>\n%s", title, values);
  PangoLayout *layout = qn_canvas_make_text (self, NULL, CARD_POINTS);
  /* The values begin beside the longest name. */
  g_auto (GStrv) lines = g_strsplit (values, "\n", -1);
  int widest = 0, width;
  for (int i = 0; lines[i] != NULL; i++) {
    pango_layout_set_text (layout, lines[i], (int) strcspn (lines[i], "\t"));
    pango_layout_get_pixel_size (layout, &width, NULL);
    widest = MAX (widest, width);
  }
  PangoTabArray *tabs = pango_tab_array_new_with_positions (
    1, TRUE, PANGO_TAB_LEFT, widest + (int) (CARD_GAP * self->camera.unit));
  pango_layout_set_tabs (layout, tabs);
  pango_tab_array_free (tabs);
  pango_layout_set_markup (layout, markup, -1);
  return layout;
}

static void
trace_inspected (QnCanvas *self, cairo_t *cr, const QnStepView *view, QnPick what)
{
  QnMotion motion = qn_canvas_get_motion (self);
  if (motion.model == NULL)
    return;
  cairo_new_path (cr);
  if (what.kind == QN_PICK_FOUND) {
    const QnFoundContact *contact = &view->result->found[what.id].contact;
    QnVec2 at =
      place_of (self, &motion, contact->other, qn_found_corner (view->model, contact));
    cairo_arc (cr, at.x, at.y, FOUND_PX, 0.0, 2.0 * G_PI);
    return;
  }
  if (what.kind == QN_PICK_FACE) {
    QnVec2 line[2];
    qn_canvas_joint_line (self, &motion, &view->contacts->faces[what.id], line);
    cairo_move_to (cr, line[0].x, line[0].y);
    cairo_line_to (cr, line[1].x, line[1].y);
    return;
  }
  qn_canvas_trace_placed (self, cr, &motion, view->model, what.id);
}

void
qn_canvas_draw_inspected (QnCanvas *self, cairo_t *cr)
{
  self->card = QN_BOX_EMPTY;
  if (!self->pointer_inside || self->in_gesture || self->tool != self->resting
      || !self->has_rested || self->rested_view != self->state->options.view
      || self->rested_run != self->document->run)
    return;
  QnPick what = find_under_pointer (self);
  QnStepView view;
  if (what.id == QN_NONE || is_selected (self, what)
      || !qn_step_view_init (&view, self->state))
    return;
  g_autofree char *title = qn_inspect_dup_title (&view, what);
  g_autofree char *values =
    qn_inspect_dup_values (&view, what, qn_settings_get_units (), TRUE);
  if (title != NULL && values != NULL) {
    trace_inspected (self, cr, &view, what);
    cairo_set_source_rgba (cr, 0.11, 0.44, 0.85, 0.9);
    cairo_set_line_width (cr, what.kind == QN_PICK_FACE ? 4.0 : 1.5);
    cairo_stroke (cr);

    g_autoptr (PangoLayout) layout = make_card (self, title, values);
    int width, height;
    pango_layout_get_pixel_size (layout, &width, &height);
    self->card = card_place (self, width + 2.0 * CARD_PAD, height + 2.0 * CARD_PAD);
    QnVec2 at = self->card.min;
    cairo_set_source_rgba (cr, 1.0, 1.0, 1.0, 0.95);
    cairo_rectangle (cr, floor (at.x) + 0.5, floor (at.y) + 0.5, width + 2.0 * CARD_PAD,
                     height + 2.0 * CARD_PAD);
    cairo_fill_preserve (cr);
    cairo_set_source_rgb (cr, 0.65, 0.65, 0.65);
    cairo_set_line_width (cr, 1.0);
    cairo_stroke (cr);
    cairo_set_source_rgb (cr, 0.1, 0.1, 0.1);
    cairo_move_to (cr, at.x + CARD_PAD, at.y + CARD_PAD);
    pango_cairo_show_layout (cr, layout);
    cairo_new_path (cr);
  }
  qn_step_view_clear (&view);
}
