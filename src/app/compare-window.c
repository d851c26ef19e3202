/* Compare: the runs of a document side by side, at one scale, in the same phase of motion. */
#include "app/window-private.h"

#include "app/form.h"
#include "app/settings.h"
#include "doc/explain.h"
#include "render/draw-cairo.h"
#include <glib/gi18n.h>

#define MOST_RUNS  6
#define MARGIN_PX  24.0
#define CAPTION_PX 44

typedef struct Compare {
  QnDocument *document;
  GtkWidget *flow, *play;
  double phase;
  gint64 started;
  guint tick;
} Compare;

static void
draw_run (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const QnRun *run = data;
  const Compare *compare = g_object_get_data (G_OBJECT (area), "qn-compare");
  QnViewOptions options;
  qn_view_options_init (&options, run->result.mechanism != NULL ? QN_VIEW_MECHANISM
                                                                : QN_VIEW_DEFORMED);
  options.titles = options.legend = options.dimensions = false;
  options.phase = compare->phase;
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  QnScene *scene =
    qn_scene_build (&run->model, &run->contacts, &run->result, &options, NULL);
  if (scene == NULL)
    return;
  /* Room for the whole motion, so that nothing jumps while it plays. */
  QnViewOptions full = options;
  full.phase = 1.0;
  QnScene *whole =
    qn_scene_build (&run->model, &run->contacts, &run->result, &full, NULL);
  QnCamera camera = { .width = width, .height = height, .scale = 1.0, .unit = 1.0 };
  qn_camera_fit (&camera, whole != NULL ? whole->box : scene->box, MARGIN_PX);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, true, cr, NULL);
  qn_scene_free (whole);
  qn_scene_free (scene);
}

static GtkWidget *
make_cell (Compare *compare, QnRun *run)
{
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
  GtkWidget *area = gtk_drawing_area_new ();
  gtk_widget_set_size_request (area, 320, 240);
  gtk_widget_set_hexpand (area, TRUE);
  gtk_widget_set_vexpand (area, TRUE);
  g_object_set_data (G_OBJECT (area), "qn-compare", compare);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw_run, qn_run_ref (run),
                                  (GDestroyNotify) qn_run_unref);
  g_autofree char *words =
    qn_explain_mechanism (&run->model, &run->contacts, &run->result);
  g_autofree char *value =
    run->result.has_collapse_multiplier
      ? g_strdup_printf ("λ = %.4f", run->result.collapse_multiplier)
      : g_strdup (qn_explain_outcome_label (run->result.outcome));
  g_autofree char *caption =
    g_strdup_printf ("%s: %s\n%s", run->name, value, words != NULL ? words : "");
  GtkWidget *label = gtk_label_new (caption);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 50);
  gtk_widget_set_size_request (label, -1, CAPTION_PX);
  gtk_accessible_update_property (GTK_ACCESSIBLE (area), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  caption, -1);
  gtk_box_append (GTK_BOX (box), area);
  gtk_box_append (GTK_BOX (box), label);
  return box;
}

static void
fill (Compare *compare)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (compare->flow)) != NULL)
    gtk_grid_remove (GTK_GRID (compare->flow), child);
  const GPtrArray *runs = qn_document_get_runs (compare->document);
  guint first = runs->len > MOST_RUNS ? runs->len - MOST_RUNS : 0;
  guint shown = runs->len - first;
  int columns = shown <= 1 ? 1 : shown <= 4 ? 2 : 3;
  for (guint i = first; i < runs->len; i++)
    gtk_grid_attach (GTK_GRID (compare->flow),
                     make_cell (compare, g_ptr_array_index (runs, i)),
                     (int) (i - first) % columns, (int) (i - first) / columns, 1, 1);
}

static void
redraw_all (GtkWidget *widget)
{
  for (GtkWidget *cell = gtk_widget_get_first_child (widget); cell != NULL;
       cell = gtk_widget_get_next_sibling (cell))
    gtk_widget_queue_draw (gtk_widget_get_first_child (cell));
}

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer data)
{
  Compare *compare = data;
  gint64 now = gdk_frame_clock_get_frame_time (clock);
  if (compare->started == 0)
    compare->started = now;
  double period = g_settings_get_double (qn_settings_get (), "animation-period");
  double turns = 1e-6 * (double) (now - compare->started) / period;
  compare->phase = 0.5 - 0.5 * cos (G_PI * turns);
  redraw_all (widget);
  return G_SOURCE_CONTINUE;
}

static void
on_play (GtkToggleButton *button, Compare *compare)
{
  gboolean active = gtk_toggle_button_get_active (button);
  if (active && compare->tick == 0 && !qn_settings_reduced_motion ()) {
    compare->started = 0;
    compare->tick = gtk_widget_add_tick_callback (compare->flow, on_tick, compare, NULL);
  } else if (!active && compare->tick != 0) {
    gtk_widget_remove_tick_callback (compare->flow, compare->tick);
    compare->tick = 0;
    compare->phase = 1.0;
    redraw_all (compare->flow);
  }
}

static GtkWidget *
make_header (QnWindow *self, Compare *compare)
{
  (void) self;
  GtkWidget *header = gtk_header_bar_new ();
  compare->play = gtk_toggle_button_new ();
  gtk_button_set_icon_name (GTK_BUTTON (compare->play), "media-playback-start-symbolic");
  gtk_widget_set_tooltip_text (compare->play, _ ("Play all in the same phase"));
  g_signal_connect (compare->play, "toggled", G_CALLBACK (on_play), compare);
  gtk_header_bar_pack_start (GTK_HEADER_BAR (header), compare->play);
  return header;
}

void
qn_compare_window_show (QnWindow *self)
{
  Compare *compare = g_new0 (Compare, 1);
  compare->document = self->document;
  compare->phase = 1.0;
  GtkWidget *window = gtk_window_new ();
  gtk_window_set_title (GTK_WINDOW (window), _ ("Compare Runs"));
  gtk_window_set_transient_for (GTK_WINDOW (window), GTK_WINDOW (self));
  gtk_window_set_destroy_with_parent (GTK_WINDOW (window), TRUE);
  gtk_window_set_default_size (GTK_WINDOW (window), 1000, 720);
  gtk_window_set_titlebar (GTK_WINDOW (window), make_header (self, compare));

  compare->flow = gtk_grid_new ();
  gtk_grid_set_row_homogeneous (GTK_GRID (compare->flow), TRUE);
  gtk_grid_set_column_homogeneous (GTK_GRID (compare->flow), TRUE);
  gtk_grid_set_row_spacing (GTK_GRID (compare->flow), 12);
  gtk_grid_set_column_spacing (GTK_GRID (compare->flow), 12);
  gtk_window_set_child (GTK_WINDOW (window), compare->flow);
  qn_own (compare->flow, compare);
  qn_watch (compare->flow, self->document, "runs-changed", G_CALLBACK (fill), compare);
  fill (compare);
  gtk_window_present (GTK_WINDOW (window));
}
