#include "app/canvas/canvas-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/paper-area.h"
#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/edit/edit-place.h"
#include "doc/text/explain.h"
#include "io/project/project-masonry.h"
#include <glib/gi18n.h>

/* px: how near the pointer must be to pick. */
#define PICK_REACH_PX 4.0
#define CLICK_PX      4.0
#define NODE_REACH_PX 7.0

G_DEFINE_FINAL_TYPE (QnCanvas, qn_canvas, GTK_TYPE_WIDGET)

enum { SIGNAL_STATUS, SIGNAL_TOOL, SIGNAL_FAILED, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

void
qn_canvas_emit_status (QnCanvas *self)
{
  g_signal_emit (self, signals[SIGNAL_STATUS], 0);
}

void
qn_canvas_tell (QnCanvas *self, const char *message)
{
  g_signal_emit (self, signals[SIGNAL_FAILED], 0, message);
}

/* ---- scene ---- */

const QnScene *
qn_canvas_get_scene (QnCanvas *self)
{
  if (self->scene != NULL || self->scene_error != NULL || self->state == NULL)
    return self->scene;
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (!qn_view_state_get_content (self->state, self->state->options.view, &model,
                                  &contacts, &result)
      || (model->block_count == 0 && model->beam_count == 0
          && self->state->options.underlay.image == NULL))
    return NULL;
  QnViewOptions options = qn_view_state_get_options (self->state);
  self->scene = qn_scene_build (model, contacts, result, &options, &self->scene_error);
  return self->scene;
}

/* Another view takes other room; steps and phases of a motion do not move the paper. */
static void
on_state_changed (QnCanvas *self)
{
  QnView view = self->state->options.view;
  if (view != self->shown_view && self->keeps_fit)
    self->wants_fit = TRUE;
  self->shown_view = view;
  g_clear_pointer (&self->scene, qn_scene_free);
  g_clear_error (&self->scene_error);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
update_description (QnCanvas *self)
{
  const QnModel *model = qn_canvas_get_model (self);
  const QnContacts *contacts = &self->document->contacts;
  const QnCount counts[] = { { QN_COUNTED_BLOCKS, model->block_count },
                             { QN_COUNTED_FACES, contacts->face_count },
                             { QN_COUNTED_BEAMS, model->beam_count } };
  g_autofree char *content = qn_counts_dup_text (counts, G_N_ELEMENTS (counts), ", ");
  g_autofree char *text = g_strdup_printf (
    _ (
      "Drawing: %s; the arrow keys move the selection, or the pointer of a drawing tool, "
      "and Enter clicks there"),
    content);
  gtk_accessible_update_property (GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  _ ("Drawing"), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                  text, -1);
}

/* ---- widget ---- */

static void
qn_canvas_snapshot (GtkWidget *widget, GtkSnapshot *snapshot)
{
  QnCanvas *self = QN_CANVAS (widget);
  int width = gtk_widget_get_width (widget), height = gtk_widget_get_height (widget);
  if (self->state == NULL || width <= 0 || height <= 0)
    return;
  gboolean resized = self->camera.width != width || self->camera.height != height;
  self->camera.width = width;
  self->camera.height = height;
  self->camera.unit = qn_text_unit (widget);
  if (self->wants_fit || (resized && self->keeps_fit))
    qn_canvas_fit_now (self);
  const graphene_rect_t all = GRAPHENE_RECT_INIT (0, 0, (float) width, (float) height);
  const QnScene *scene = qn_canvas_get_scene (self);
  /* A photo stays as it is, of which nothing would be recognised. */
  gboolean dark = self->state->options.underlay.image == NULL
                  && qn_paper_area_push_dark (widget, snapshot);
  cairo_t *cr = gtk_snapshot_append_cairo (snapshot, &all);
  if (qn_gl_layer_prepare (&self->gl_layer, scene, &self->camera)) {
    qn_scene_cache_clear (&self->cache);
    qn_canvas_draw_below (self, TRUE, cr);
    cairo_destroy (cr);
    gtk_widget_snapshot_child (widget, self->gl_layer.area, snapshot);
    cr = gtk_snapshot_append_cairo (snapshot, &all);
    qn_canvas_draw_above (self, TRUE, cr);
  } else {
    qn_canvas_draw (self, cr);
  }
  cairo_destroy (cr);
  if (dark)
    gtk_snapshot_pop (snapshot);
}

static void
qn_canvas_size_allocate (GtkWidget *widget, int width, int height, int baseline)
{
  GtkWidget *area = QN_CANVAS (widget)->gl_layer.area;
  if (gtk_widget_should_layout (area))
    gtk_widget_allocate (area, width, height, baseline, NULL);
}

static void
forget_masonry (QnCanvas *self)
{
  qn_masonries_clear (&self->masonry);
  self->has_masonry = FALSE;
}

/* A gesture that has seen the press of one button and not the end of another keeps the widget that keeps
 * it (GTK 4.8): drawing and document
 * would outlive their window. */
static void
qn_canvas_unroot (GtkWidget *widget)
{
  g_autoptr (GListModel) controllers = gtk_widget_observe_controllers (widget);
  for (guint i = 0; i < g_list_model_get_n_items (controllers); i++) {
    g_autoptr (GtkEventController) controller = g_list_model_get_item (controllers, i);
    gtk_event_controller_reset (controller);
  }
  GTK_WIDGET_CLASS (qn_canvas_parent_class)->unroot (widget);
}

static void
qn_canvas_dispose (GObject *object)
{
  QnCanvas *self = QN_CANVAS (object);
  g_clear_handle_id (&self->place_timeout, g_source_remove);
  g_clear_handle_id (&self->inspect_timeout, g_source_remove);
  g_clear_handle_id (&self->rest_timeout, g_source_remove);
  g_clear_handle_id (&self->gl_layer.wake, g_source_remove);
  gtk_widget_dispose_template (GTK_WIDGET (self), QN_TYPE_CANVAS);
  g_clear_weak_pointer (&self->corner);
  qn_scene_cache_clear (&self->cache);
  g_clear_pointer (&self->scene, qn_scene_free);
  g_clear_error (&self->scene_error);
  g_clear_object (&self->state);
  G_OBJECT_CLASS (qn_canvas_parent_class)->dispose (object);
}

static void
qn_canvas_finalize (GObject *object)
{
  QnCanvas *self = QN_CANVAS (object);
  g_free (self->magnet_skip);
  g_string_free (self->typed, TRUE);
  forget_masonry (self);
  g_array_unref (self->gesture.points);
  qn_gaps_clear (&self->gaps);
  G_OBJECT_CLASS (qn_canvas_parent_class)->finalize (object);
}

static void
qn_canvas_class_init (QnCanvasClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  object_class->dispose = qn_canvas_dispose;
  object_class->finalize = qn_canvas_finalize;
  widget_class->snapshot = qn_canvas_snapshot;
  widget_class->size_allocate = qn_canvas_size_allocate;
  widget_class->unroot = qn_canvas_unroot;
  signals[SIGNAL_STATUS] = g_signal_new ("status", QN_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0,
                                         NULL, NULL, NULL, G_TYPE_NONE, 0);
  signals[SIGNAL_TOOL] = g_signal_new ("tool-changed", QN_TYPE_CANVAS, G_SIGNAL_RUN_LAST,
                                       0, NULL, NULL, NULL, G_TYPE_NONE, 0);
  signals[SIGNAL_FAILED] = g_signal_new ("failed", QN_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0,
                                         NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
  gtk_widget_class_set_css_name (widget_class, "canvas");
  gtk_widget_class_set_accessible_role (widget_class, GTK_ACCESSIBLE_ROLE_IMG);
  gtk_widget_class_set_template_from_resource (widget_class,
                                               "/io/github/quoin/Quoin/canvas.ui");
  gtk_widget_class_bind_template_child_full (widget_class, "area", FALSE,
                                             G_STRUCT_OFFSET (QnCanvas, gl_layer.area));
  qn_canvas_bind_pointer (widget_class);
  qn_canvas_bind_camera (widget_class);
  qn_canvas_bind_keys (widget_class);
}

static void
qn_canvas_init (QnCanvas *self)
{
  gtk_widget_init_template (GTK_WIDGET (self));
  /* A drawing is the same in every script. */
  gtk_widget_set_direction (GTK_WIDGET (self), GTK_TEXT_DIR_LTR);
  self->camera.scale = 100.0;
  self->camera.unit = 1.0;
  self->typed = g_string_new (NULL);
  self->gesture.points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  qn_gl_layer_init (&self->gl_layer);
  self->wants_fit = self->keeps_fit = TRUE;
}

static void
on_document_changed (QnCanvas *self)
{
  forget_masonry (self);
  /* Gestures point at blocks of the model that has just gone. */
  if (self->in_gesture)
    qn_canvas_cancel_gesture (self);
  update_description (self);
}

void
qn_canvas_set_state (QnCanvas *self, QnViewState *state, QnToolSettings *settings,
                     const QnTool *resting)
{
  g_return_if_fail (self->state == NULL);
  self->state = g_object_ref (state);
  self->document = state->document;
  self->selection = state->document->selection;
  self->settings = settings;
  self->tool = self->resting = resting;
  qn_watch (GTK_WIDGET (self), state, "changed", G_CALLBACK (on_state_changed), self);
  qn_watch (GTK_WIDGET (self), state->document, "changed",
            G_CALLBACK (on_document_changed), self);
  qn_watch (GTK_WIDGET (self), state->document->selection, "changed",
            G_CALLBACK (gtk_widget_queue_draw), self);
  qn_watch (GTK_WIDGET (self), qn_settings_get (), "changed",
            G_CALLBACK (gtk_widget_queue_draw), self);
  update_description (self);
}

const QnModel *
qn_canvas_get_model (QnCanvas *self)
{
  return &self->document->project.model;
}

void
qn_canvas_cancel_gesture (QnCanvas *self)
{
  g_string_truncate (self->typed, 0);
  if (self->tool->cancel != NULL)
    self->tool->cancel (self);
  qn_canvas_set_magnet_skip (self, NULL);
  qn_canvas_set_in_gesture (self, FALSE);
}

void
qn_canvas_set_in_gesture (QnCanvas *self, gboolean in_gesture)
{
  self->in_gesture = in_gesture;
  if (!in_gesture) {
    g_string_truncate (self->typed, 0);
    g_array_set_size (self->gesture.points, 0);
    self->gesture.dragging = FALSE;
    self->gesture.band = FALSE;
    self->gesture.phase = 0;
    self->gesture.grip = (QnGrip){ .kind = QN_GRIP_NONE };
  }
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

void
qn_canvas_set_tool (QnCanvas *self, const QnTool *tool)
{
  if (self->in_gesture)
    qn_canvas_cancel_gesture (self);
  self->tool = tool;
  gtk_widget_set_cursor_from_name (GTK_WIDGET (self),
                                   tool == self->resting ? NULL : "crosshair");
  gtk_widget_queue_draw (GTK_WIDGET (self));
  g_signal_emit (self, signals[SIGNAL_TOOL], 0);
  qn_canvas_emit_status (self);
}

/* ---- for tools ---- */

gboolean
qn_canvas_is_drag (QnCanvas *self, const QnToolEvent *event)
{
  QnVec2 moved = qn_vec2_sub (event->screen, self->gesture.from_screen);
  return qn_vec2_length (moved) > CLICK_PX;
}

QnVec2
qn_canvas_to_screen (QnCanvas *self, QnVec2 point)
{
  return qn_camera_to_screen (&self->camera, point);
}

QnPick
qn_canvas_pick (QnCanvas *self, QnVec2 screen, unsigned kinds)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  if (scene == NULL)
    return (QnPick){ QN_PICK_NOTHING, QN_NONE };
  return qn_pick_at (scene, &self->camera, screen, PICK_REACH_PX, kinds);
}

void
qn_canvas_pick_inside (QnCanvas *self, QnVec2 a, QnVec2 b, GArray *ids)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  if (scene != NULL)
    qn_pick_inside (scene, &self->camera, a, b, QN_PICK_BLOCK, ids);
}

static gboolean
is_between (QnVec2 p, QnVec2 a, QnVec2 b)
{
  return p.x >= MIN (a.x, b.x) && p.x <= MAX (a.x, b.x) && p.y >= MIN (a.y, b.y)
         && p.y <= MAX (a.y, b.y);
}

void
qn_canvas_beams_inside (QnCanvas *self, QnVec2 a, QnVec2 b, GArray *ids)
{
  const QnModel *model = qn_canvas_get_model (self);
  for (QnId i = 0; i < (QnId) model->beam_count; i++) {
    const QnId *ends = model->beams[i].nodes;
    if (is_between (model->nodes[ends[0]].at, a, b)
        && is_between (model->nodes[ends[1]].at, a, b))
      g_array_append_val (ids, i);
  }
}

void
qn_canvas_faces_inside (QnCanvas *self, QnVec2 a, QnVec2 b, GArray *ids)
{
  const QnContacts *contacts = &self->document->contacts;
  for (QnId i = 0; i < (QnId) contacts->face_count; i++) {
    QnVec2 m = qn_vec2_lerp (contacts->faces[i].start, contacts->faces[i].end, 0.5);
    if (is_between (m, a, b))
      g_array_append_val (ids, i);
  }
}

const QnMasonries *
qn_canvas_get_masonry (QnCanvas *self)
{
  if (!self->has_masonry) {
    const QnProject *project = qn_document_get_project (self->document);
    /* What the document holds was read before. */
    qn_project_get_masonry (project, &self->masonry, NULL);
    self->has_masonry = TRUE;
  }
  return &self->masonry;
}

gboolean
qn_canvas_get_parts_box (QnCanvas *self, QnVec2 *low, QnVec2 *high)
{
  QnExtent extent;
  gboolean any = qn_extent_find (qn_canvas_get_model (self),
                                 qn_selection_get_parts (self->selection), &extent);
  *low = extent.box.min;
  *high = extent.box.max;
  return any;
}

QnId
qn_canvas_pick_node (QnCanvas *self, QnVec2 screen)
{
  const QnModel *model = qn_canvas_get_model (self);
  return qn_model_node_near (model, qn_camera_to_model (&self->camera, screen),
                             NODE_REACH_PX / self->camera.scale);
}

gboolean
qn_canvas_snaps (QnCanvas *self)
{
  return g_settings_get_boolean (qn_settings_get (), "snap")
         && (self->modifiers & GDK_ALT_MASK) == 0;
}

void
qn_canvas_set_magnet_skip (QnCanvas *self, gboolean *skip)
{
  g_free (self->magnet_skip);
  self->magnet_skip = skip;
}

gboolean
qn_canvas_begin_edit (QnCanvas *self, QnCanvasDraft *draft)
{
  g_autoptr (GError) error = NULL;
  draft->model = &draft->project.model;
  draft->error = NULL;
  if (qn_document_begin_edit (self->document, &draft->project, &error))
    return TRUE;
  qn_canvas_tell (self, error->message);
  return FALSE;
}

gboolean
qn_canvas_end_edit (QnCanvas *self, QnCanvasDraft *draft, const char *name,
                    const char *key, gboolean done)
{
  QnDocument *document = self->document;
  done = qn_document_end_edit (document, &draft->project, name, key, done, &draft->error);
  if (!done)
    qn_canvas_tell (self, draft->error->message);
  else if (document->dissolved)
    qn_canvas_tell (self, _ ("The wall is now a set of free blocks without "
                             "parameters. Undo restores the wall."));
  g_clear_error (&draft->error);
  return done;
}

gboolean
qn_canvas_transform (QnCanvas *self, const char *name, const char *key,
                     QnTransform transform, int copies)
{
  QnCanvasDraft draft;
  QnPartSet set = qn_selection_get_parts (self->selection);
  return qn_canvas_begin_edit (self, &draft)
         && qn_canvas_end_edit (
           self, &draft, name, key,
           copies > 0
             ? qn_edit_copy_all (&draft.project, set, transform, copies, &draft.error)
             : qn_edit_transform_all (&draft.project, set, transform, &draft.error));
}

char *
qn_canvas_dup_status (QnCanvas *self)
{
  if (!self->pointer_inside || self->state == NULL)
    return g_strdup ("");
  static const char *const words[] = {
    [QN_MAGNET_NODE] = N_ ("node"),
    [QN_MAGNET_CORNER] = N_ ("corner"),
    [QN_MAGNET_EDGE] = N_ ("edge"),
    [QN_MAGNET_MIDDLE] = N_ ("middle of an edge"),
    [QN_MAGNET_COURSE] = N_ ("course line"),
    [QN_MAGNET_GRID] = N_ ("grid"),
  };
  QnUnits units = qn_settings_get_units ();
  QnVec2 p = self->hit.point;
  double resolution = 1.0 / self->camera.scale;
  p = qn_vec2 (round (p.x / resolution) * resolution,
               round (p.y / resolution) * resolution);
  if (self->hit.kind != QN_MAGNET_NOTHING)
    p = self->hit.point;
  g_autofree char *place = qn_units_format_pair (units, QN_QUANTITY_LENGTH, p, 5);
  return self->hit.kind != QN_MAGNET_NOTHING
           ? g_strdup_printf ("%s  (%s)", place, _ (words[self->hit.kind]))
           : g_steal_pointer (&place);
}
