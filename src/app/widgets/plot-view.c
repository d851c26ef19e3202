#include "app/widgets/plot-view.h"

#include "app/widgets/paper-area.h"
#include "app/widgets/text-unit.h"

#include <math.h>
#include <pango/pangocairo.h>

#define ZOOM_STEP 1.25
#define MARGIN    6.0 /* px */

typedef struct View {
  const QnPlotHand *hand;
  gpointer data;
  GtkWidget *area;
  QnPlotPlace place;
  QnBox range, pan_from; /* values in view, where chosen */
  gboolean chosen, inside;
  QnVec2 pointer; /* px */
} View;

static View *
view_of (GtkWidget *area)
{
  return g_object_get_data (G_OBJECT (area), "qn-plot-view");
}

QnVec2
qn_plot_place_value (const QnPlotPlace *place, QnVec2 at)
{
  return qn_vec2 ((at.x - place->x_zero) / place->x_scale,
                  (at.y - place->y_zero) / place->y_scale);
}

/* ---- drawing ---- */

/* In the middle of the paper, or in the corner of the frame where curves that rise leave room. */
static void
draw_text (View *view, cairo_t *cr, const char *text, const QnBox *frame,
           gboolean in_corner)
{
  g_autoptr (PangoLayout) layout = gtk_widget_create_pango_layout (view->area, NULL);
  g_autofree char *small = g_markup_printf_escaped ("<small>%s</small>", text);
  int width, height;
  pango_layout_set_markup (layout, small, -1);
  pango_layout_set_width (layout, (int) (frame->max.x - frame->min.x) * PANGO_SCALE);
  if (!in_corner)
    pango_layout_set_alignment (layout, PANGO_ALIGN_CENTER);
  pango_layout_get_pixel_size (layout, &width, &height);
  double x = in_corner ? frame->max.x - width - 4.0 : frame->min.x;
  double y = in_corner ? frame->max.y - height - 4.0
                       : 0.5 * (frame->min.y + frame->max.y - height);
  if (in_corner) {
    cairo_set_source_rgba (cr, 1.0, 1.0, 1.0, 0.85);
    cairo_rectangle (cr, x - 3.0, y - 2.0, width + 6.0, height + 4.0);
    cairo_fill (cr);
  }
  cairo_set_source_rgb (cr, 0.2, 0.2, 0.2);
  cairo_move_to (cr, x, y);
  pango_cairo_show_layout (cr, layout);
}

static void
draw_cursor (View *view, cairo_t *cr)
{
  double x = view->place.x_zero + view->place.x_scale * view->hand->cursor (view->data);
  if (!(x >= view->place.frame.min.x - 1.0 && x <= view->place.frame.max.x + 1.0))
    return;
  cairo_set_source_rgb (cr, 0.9, 0.35, 0.0);
  cairo_set_line_width (cr, 1.0);
  cairo_move_to (cr, floor (x) + 0.5, view->place.frame.min.y);
  cairo_line_to (cr, floor (x) + 0.5, view->place.frame.max.y);
  cairo_stroke (cr);
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  View *view = data;
  const QnPlotHand *hand = view->hand;
  const QnFrame frame = { MARGIN, MARGIN, width - 2.0 * MARGIN, height - 2.0 * MARGIN };
  const QnBox paper = { { 20.0, MARGIN }, { width - 20.0, height - MARGIN } };
  double share = hand->text_share > 0.0 ? hand->text_share : 1.0;
  g_autofree char *message = NULL, *told = NULL;
  g_autoptr (QnPlot) plot = hand->make (view->data, view->chosen, &message);
  view->place = (QnPlotPlace){ 0 };
  if (plot != NULL) {
    if (view->chosen) {
      plot->x.low = view->range.min.x;
      plot->x.high = view->range.max.x;
      plot->y.low = view->range.min.y;
      plot->y.high = view->range.max.y;
    }
    qn_plot_draw (plot, cr, share * qn_text_unit (view->area), &frame, &view->place);
    if (hand->cursor != NULL)
      draw_cursor (view, cr);
    told = hand->tell != NULL
             ? hand->tell (view->data, view->inside ? &view->pointer : NULL)
             : NULL;
  }
  if (message != NULL)
    draw_text (view, cr, message, &paper, FALSE);
  if (told != NULL)
    draw_text (view, cr, told, &view->place.frame, TRUE);
  if (gtk_widget_has_focus (view->area)) {
    cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
    cairo_set_line_width (cr, 1.0);
    cairo_rectangle (cr, 1.5, 1.5, width - 3.0, height - 3.0);
    cairo_stroke (cr);
  }
}

/* ---- hand ---- */

/* What is in view. */
static QnBox
find_range (const View *view)
{
  const QnBox *frame = &view->place.frame;
  return (
    QnBox){ qn_plot_place_value (&view->place, qn_vec2 (frame->min.x, frame->max.y)),
            qn_plot_place_value (&view->place, qn_vec2 (frame->max.x, frame->min.y)) };
}

static void
choose_range (View *view, QnBox range)
{
  double width = range.max.x - range.min.x, height = range.max.y - range.min.y;
  if (!(width > 1e-12 && height > 1e-12 && width < 1e9 && height < 1e15))
    return;
  view->range = range;
  view->chosen = TRUE;
  gtk_widget_queue_draw (view->area);
}

/* Shows `share` of the range, keeping what is at this place. */
static void
zoom (View *view, double share, QnVec2 at)
{
  QnBox range = find_range (view);
  QnVec2 still = qn_plot_place_value (&view->place, at);
  range.min = qn_vec2_add (still, qn_vec2_scale (share, qn_vec2_sub (range.min, still)));
  range.max = qn_vec2_add (still, qn_vec2_scale (share, qn_vec2_sub (range.max, still)));
  choose_range (view, range);
}

static void
on_drag_begin (GtkGestureDrag *gesture, double x, double y, View *view)
{
  gtk_widget_grab_focus (view->area);
  if (view->hand->go_to != NULL)
    view->hand->go_to (view->data, qn_vec2 (x, y));
}

static void
on_drag_update (GtkGestureDrag *gesture, double dx, double dy, View *view)
{
  double x, y;
  if (view->hand->go_to != NULL && gtk_gesture_drag_get_start_point (gesture, &x, &y))
    view->hand->go_to (view->data, qn_vec2 (x + dx, y + dy));
}

static void
on_click (GtkGestureClick *gesture, int presses, double x, double y, View *view)
{
  if (presses == 2)
    qn_plot_view_fit (view->area);
}

static void
on_pan_begin (GtkGestureDrag *gesture, double x, double y, View *view)
{
  view->pan_from = find_range (view);
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, View *view)
{
  QnVec2 moved = { -dx / view->place.x_scale, -dy / view->place.y_scale };
  choose_range (view, (QnBox){ qn_vec2_add (view->pan_from.min, moved),
                               qn_vec2_add (view->pan_from.max, moved) });
}

static void
point (View *view, gboolean inside)
{
  view->inside = inside;
  if (view->hand->point != NULL)
    view->hand->point (view->data, inside ? &view->pointer : NULL);
  if (view->hand->tell != NULL)
    gtk_widget_queue_draw (view->area);
}

static void
on_motion (GtkEventControllerMotion *controller, double x, double y, View *view)
{
  view->pointer = qn_vec2 (x, y);
  point (view, TRUE);
}

static void
on_leave (GtkEventControllerMotion *controller, View *view)
{
  point (view, FALSE);
}

/* Without Ctrl and focus the panel scrolls past it. */
static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, View *view)
{
  GdkModifierType held =
    gtk_event_controller_get_current_event_state (GTK_EVENT_CONTROLLER (controller));
  if ((held & GDK_CONTROL_MASK) == 0 && !gtk_widget_has_focus (view->area))
    return FALSE;
  zoom (view, pow (ZOOM_STEP, dy), view->pointer);
  return TRUE;
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, View *view)
{
  const QnVec2 origin = { view->place.x_zero, view->place.y_zero };
  if (keyval == GDK_KEY_Left && view->hand->steps)
    gtk_widget_activate_action (view->area, "win.previous-step", NULL);
  else if (keyval == GDK_KEY_Right && view->hand->steps)
    gtk_widget_activate_action (view->area, "win.next-step", NULL);
  else if (keyval == GDK_KEY_plus || keyval == GDK_KEY_KP_Add)
    zoom (view, 1.0 / ZOOM_STEP, origin);
  else if (keyval == GDK_KEY_minus || keyval == GDK_KEY_KP_Subtract)
    zoom (view, ZOOM_STEP, origin);
  else if (keyval == GDK_KEY_0 || keyval == GDK_KEY_KP_0)
    qn_plot_view_fit (view->area);
  else
    return FALSE;
  return TRUE;
}

void
qn_plot_view_init (GtkWidget *area, const QnPlotHand *hand, gpointer data)
{
  View *view = g_new0 (View, 1);
  *view = (View){ .hand = hand, .data = data, .area = area };
  g_object_set_data_full (G_OBJECT (area), "qn-plot-view", view, g_free);
  gtk_widget_set_focusable (area, TRUE);
  gtk_widget_set_direction (area, GTK_TEXT_DIR_LTR);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw, view, NULL);
  const double height = gtk_drawing_area_get_content_height (GTK_DRAWING_AREA (area));
  gtk_drawing_area_set_content_height (
    GTK_DRAWING_AREA (area), (int) (height * qn_text_unit (area) / QN_TEXT_UNIT));
  GtkGesture *drag = gtk_gesture_drag_new (), *pan = gtk_gesture_drag_new ();
  GtkGesture *click = gtk_gesture_click_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (pan), GDK_BUTTON_MIDDLE);
  const struct {
    gpointer controller;
    const char *signal;
    GCallback handler;
  } links[] = {
    { drag, "drag-begin", G_CALLBACK (on_drag_begin) },
    { drag, "drag-update", G_CALLBACK (on_drag_update) },
    { click, "pressed", G_CALLBACK (on_click) },
    { pan, "drag-begin", G_CALLBACK (on_pan_begin) },
    { pan, "drag-update", G_CALLBACK (on_pan_update) },
    { gtk_event_controller_scroll_new (GTK_EVENT_CONTROLLER_SCROLL_VERTICAL), "scroll",
      G_CALLBACK (on_scroll) },
    { gtk_event_controller_key_new (), "key-pressed", G_CALLBACK (on_key) },
    { gtk_event_controller_motion_new (), "enter", G_CALLBACK (on_motion) },
    { NULL, "motion", G_CALLBACK (on_motion) },
    { NULL, "leave", G_CALLBACK (on_leave) },
  };
  gpointer last = NULL;
  for (gsize i = 0; i < G_N_ELEMENTS (links); i++) {
    gpointer controller = links[i].controller != NULL ? links[i].controller : last;
    g_signal_connect (controller, links[i].signal, links[i].handler, view);
    if (controller != last)
      gtk_widget_add_controller (area, controller);
    last = controller;
  }
}

void
qn_plot_view_fit (GtkWidget *area)
{
  view_of (area)->chosen = FALSE;
  gtk_widget_queue_draw (area);
}

const QnPlotPlace *
qn_plot_view_get_place (GtkWidget *area)
{
  return &view_of (area)->place;
}
