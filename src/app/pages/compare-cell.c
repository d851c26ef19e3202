#include "app/pages/compare-private.h"

#include "app/widgets/paper-area.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include "render/backend/draw-cairo.h"
#include "render/scene/scene-build.h"
#include <glib/gi18n.h>
#include <string.h>

#define MARGIN_PX    24.0
#define LEAST_PX     150
#define CAPTION_PX   60
#define WHEEL_FACTOR 1.15

typedef struct Cell {
  QnRun *run;
  QnCompareView *view;
  GtkWidget *area;
  QnBox box; /* of the whole motion */
  gboolean has_box;
  QnVec2 pan_from;
} Cell;

static void
cell_free (gpointer data)
{
  Cell *cell = data;
  qn_run_unref (cell->run);
  g_free (cell);
}

static Cell *
cell_of (GtkWidget *widget)
{
  return g_object_get_data (G_OBJECT (widget), "qn-cell");
}

static QnScene *
build_scene (const Cell *cell, double phase)
{
  const QnRun *run = cell->run, *first = cell->view->first;
  QnViewOptions options;
  qn_view_options_init (&options, qn_view_of_result (&run->result));
  options.titles = options.legend = options.dimensions = options.loads = false;
  options.phase = phase;
  gboolean comparable =
    first != NULL && first != run && first->result.block_count == run->result.block_count
    && (options.view == QN_VIEW_MECHANISM ? first->result.mechanism != NULL
                                          : first->result.step_count > 0);
  if (cell->view->outline && comparable)
    options.onion = &first->result;
  return qn_scene_build (&run->model, &run->contacts, &run->result, &options, NULL);
}

static QnCamera
camera_of (const Cell *cell, int width, int height)
{
  QnCamera camera = { .width = width, .height = height, .scale = 1.0, .unit = 1.0 };
  qn_camera_fit (&camera, cell->box, MARGIN_PX);
  if (cell->view->base_scale > 0.0)
    camera.scale = cell->view->base_scale * cell->view->zoom;
  camera.center = qn_vec2_add (camera.center, cell->view->pan);
  return camera;
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const Cell *cell = data;
  QnScene *scene = build_scene (cell, cell->view->phase);
  if (scene == NULL)
    return;
  QnCamera camera = camera_of (cell, width, height);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, true, cr, NULL);
  qn_scene_free (scene);
}

QnRun *
qn_compare_cell_get_run (GtkWidget *widget)
{
  return cell_of (widget)->run;
}

double
qn_compare_cell_fit_scale (GtkWidget *widget)
{
  const Cell *cell = cell_of (widget);
  int width = gtk_widget_get_width (cell->area);
  int height = gtk_widget_get_height (cell->area);
  if (!cell->has_box || width <= 0 || height <= 0)
    return 0.0;
  QnCamera camera = { .width = width, .height = height, .scale = 1.0, .unit = 1.0 };
  qn_camera_fit (&camera, cell->box, MARGIN_PX);
  return camera.scale;
}

void
qn_compare_cell_redraw (GtkWidget *widget, gpointer unused)
{
  gtk_widget_queue_draw (cell_of (widget)->area);
}

/* ---- zoom and pan, for all cells ---- */

static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, Cell *cell)
{
  QnCompareView *view = cell->view;
  view->zoom = CLAMP (view->zoom * pow (WHEEL_FACTOR, -dy), 0.2, 200.0);
  view->changed (view->changed_data);
  return TRUE;
}

static void
on_pan_begin (GtkGestureDrag *gesture, double x, double y, Cell *cell)
{
  cell->pan_from = cell->view->pan;
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, Cell *cell)
{
  QnCompareView *view = cell->view;
  double scale = view->base_scale * view->zoom;
  if (!(scale > 0.0))
    return;
  view->pan = qn_vec2 (cell->pan_from.x - dx / scale, cell->pan_from.y + dy / scale);
  view->changed (view->changed_data);
}

static void
on_resize (GtkDrawingArea *area, int width, int height, Cell *cell)
{
  cell->view->changed (cell->view->changed_data);
}

/* ---- building ---- */

char *
qn_compare_cell_dup_caption (const QnRun *run, const char *name)
{
  if (run->kind != QN_RUN_ANALYSIS) {
    g_autofree char *title = qn_run_dup_title (run);
    return g_strdup_printf ("%s\n%s\n", name, title);
  }
  g_autofree char *words =
    qn_explain_mechanism_briefly (&run->model, &run->contacts, &run->result);
  g_autofree char *value =
    run->result.has_collapse_multiplier
      ? g_strdup_printf ("λ\u00a0=\u00a0%.4f", run->result.collapse_multiplier)
      : g_strdup (qn_explain_outcome_label (&run->result));
  return g_strdup_printf ("%s\n%s\n%s", name, value, words != NULL ? words : "");
}

void
qn_compare_cell_set_title (GtkWidget *widget, const char *title, const char *above)
{
  const Cell *cell = cell_of (widget);
  g_autofree char *caption = qn_compare_cell_dup_caption (cell->run, title);
  const char *beneath =
    g_strcmp0 (title, above) == 0 ? strchr (caption, '\n') + 1 : caption;
  GtkWidget *label = gtk_widget_get_last_child (widget);
  int width, height;
  gtk_label_set_text (GTK_LABEL (label), beneath);
  /* As high in a wide cell as in the narrowest: a GtkPaned asks how wide its child is at the height that
   * it has, which may not be less than it needs at its least width. */
  gtk_widget_set_size_request (label, -1, CAPTION_PX);
  gtk_widget_measure (label, GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL, NULL, NULL);
  gtk_widget_measure (label, GTK_ORIENTATION_VERTICAL, MAX (width, LEAST_PX), &height,
                      NULL, NULL, NULL);
  gtk_widget_set_size_request (label, -1, height);
  gtk_accessible_update_property (GTK_ACCESSIBLE (cell->area),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, caption, -1);
}

GtkWidget *
qn_compare_cell_new (QnRun *run, QnCompareView *view)
{
  Cell *cell = g_new0 (Cell, 1);
  cell->run = qn_run_ref (run);
  cell->view = view;
  /* Room for the whole motion, so that nothing jumps while it plays. */
  QnScene *whole = build_scene (cell, 1.0);
  cell->has_box = whole != NULL;
  if (whole != NULL)
    cell->box = whole->box;
  qn_scene_free (whole);

  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
  cell->area = g_object_new (QN_TYPE_PAPER_AREA, NULL);
  gtk_widget_set_size_request (cell->area, LEAST_PX, 130);
  gtk_widget_set_hexpand (cell->area, TRUE);
  gtk_widget_set_vexpand (cell->area, TRUE);
  g_object_set_data_full (G_OBJECT (box), "qn-cell", cell, cell_free);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (cell->area), draw, cell, NULL);
  g_signal_connect (cell->area, "resize", G_CALLBACK (on_resize), cell);
  GtkEventController *scroll =
    gtk_event_controller_scroll_new (GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
  g_signal_connect (scroll, "scroll", G_CALLBACK (on_scroll), cell);
  gtk_widget_add_controller (cell->area, scroll);
  GtkGesture *drag = gtk_gesture_drag_new ();
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_pan_begin), cell);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_pan_update), cell);
  gtk_widget_add_controller (cell->area, GTK_EVENT_CONTROLLER (drag));
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 50);
  gtk_label_set_justify (GTK_LABEL (label), GTK_JUSTIFY_CENTER);
  gtk_box_append (GTK_BOX (box), cell->area);
  gtk_box_append (GTK_BOX (box), label);
  return box;
}
