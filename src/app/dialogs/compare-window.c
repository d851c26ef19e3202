/* Compare: two to six runs of the open drawings side by side, at one scale, with linked zoom and
 * phase of motion; the first as an outline over the others on request. */
#include "app/dialogs/compare-cell.h"
#include "app/dialogs/dialogs.h"
#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "app/widgets/help.h"
#include "app/widgets/settings.h"
#include "render/figure/compare-sheet.h"
#include <glib/gi18n.h>

#define MOST_RUNS   6
#define ZOOM_FACTOR 1.25

typedef struct Compare {
  GtkWindow *parent;
  QnDocument *document;
  QnDocumentsFunc list_others;
  GtkWidget *dialog, *grid, *list, *play, *outline, *hint;
  GtkLabel *message;
  GPtrArray *shown; /* of QnRun, in the order chosen */
  QnCompareView view;
  gint64 started;
  guint tick;
  GObject *chooser;
} Compare;

static void
compare_free (gpointer data, GObject *where)
{
  (void) where;
  Compare *compare = data;
  g_clear_object (&compare->chooser);
  g_ptr_array_unref (compare->shown);
  g_free (compare);
}

/* ---- cells ---- */

static void
each_cell (Compare *compare, void (*func) (GtkWidget *cell, gpointer data), gpointer data)
{
  for (GtkWidget *cell = gtk_widget_get_first_child (compare->grid); cell != NULL;
       cell = gtk_widget_get_next_sibling (cell))
    func (cell, data);
}

static void
take_scale (GtkWidget *cell, gpointer data)
{
  double *scale = data;
  double fitting = qn_compare_cell_fit_scale (cell);
  if (fitting > 0.0)
    *scale = MIN (*scale, fitting);
}

static void
redraw_cell (GtkWidget *cell, gpointer data)
{
  (void) data;
  qn_compare_cell_redraw (cell);
}

/* One scale for all: that of the one with the least room. */
static void
redraw (gpointer data)
{
  Compare *compare = data;
  double scale = INFINITY;
  each_cell (compare, take_scale, &scale);
  compare->view.base_scale = isfinite (scale) ? scale : 0.0;
  each_cell (compare, redraw_cell, NULL);
}

static void
fill (Compare *compare)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (compare->grid)) != NULL)
    gtk_grid_remove (GTK_GRID (compare->grid), child);
  guint count = compare->shown->len;
  int columns = count <= 1 ? 1 : count <= 4 ? 2 : 3;
  compare->view.first = count > 0 ? g_ptr_array_index (compare->shown, 0) : NULL;
  for (guint i = 0; i < count; i++)
    gtk_grid_attach (
      GTK_GRID (compare->grid),
      qn_compare_cell_new (g_ptr_array_index (compare->shown, i), &compare->view),
      (int) i % columns, (int) i / columns, 1, 1);
  gtk_widget_set_visible (compare->hint, count < 2);
  redraw (compare);
}

/* ---- choosing ---- */

static void
on_run_toggled (GtkCheckButton *check, Compare *compare)
{
  QnRun *run = g_object_get_data (G_OBJECT (check), "qn-run");
  if (!gtk_check_button_get_active (check))
    g_ptr_array_remove (compare->shown, run);
  else if (compare->shown->len < MOST_RUNS)
    g_ptr_array_add (compare->shown, qn_run_ref (run));
  else
    gtk_check_button_set_active (check, FALSE);
  fill (compare);
}

static void
add_run (Compare *compare, QnDocument *document, QnRun *run)
{
  g_autofree char *title = qn_document_dup_display_name (document);
  g_autofree char *label = g_strdup_printf (_ ("%s: %s"), title, run->name);
  GtkWidget *check = gtk_check_button_new_with_label (label);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                               g_ptr_array_find (compare->shown, run, NULL));
  g_object_set_data_full (G_OBJECT (check), "qn-run", qn_run_ref (run),
                          (GDestroyNotify) qn_run_unref);
  g_signal_connect (check, "toggled", G_CALLBACK (on_run_toggled), compare);
  gtk_box_append (GTK_BOX (compare->list), check);
}

/* The runs of all windows, those of this one first. */
static void
list_runs (Compare *compare)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (compare->list)) != NULL)
    gtk_box_remove (GTK_BOX (compare->list), child);
  g_autoptr (GPtrArray) documents = compare->list_others (compare->parent);
  g_ptr_array_insert (documents, 0, compare->document);
  for (guint k = 0; k < documents->len; k++) {
    QnDocument *document = g_ptr_array_index (documents, k);
    const GPtrArray *runs = qn_document_get_runs (document);
    for (guint i = 0; i < runs->len; i++)
      add_run (compare, document, g_ptr_array_index (runs, i));
  }
}

/* What was solved here last, until the user chooses otherwise. */
static void
choose_first (Compare *compare)
{
  const GPtrArray *runs = qn_document_get_runs (compare->document);
  guint first = runs->len > MOST_RUNS ? runs->len - MOST_RUNS : 0;
  for (guint i = first; i < runs->len; i++)
    g_ptr_array_add (compare->shown, qn_run_ref (g_ptr_array_index (runs, i)));
}

static void
on_runs_changed (Compare *compare)
{
  if (compare->shown->len < 2) {
    g_ptr_array_set_size (compare->shown, 0);
    choose_first (compare);
    fill (compare);
  }
  list_runs (compare);
}

/* ---- motion and zoom ---- */

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer data)
{
  (void) widget;
  Compare *compare = data;
  gint64 now = gdk_frame_clock_get_frame_time (clock);
  if (compare->started == 0)
    compare->started = now;
  double period = g_settings_get_double (qn_settings_get (), "animation-period");
  double turns = 1e-6 * (double) (now - compare->started) / period;
  compare->view.phase = 0.5 - 0.5 * cos (G_PI * turns);
  redraw (compare);
  return G_SOURCE_CONTINUE;
}

static void
on_play (GtkToggleButton *button, Compare *compare)
{
  gboolean active = gtk_toggle_button_get_active (button);
  if (active && compare->tick == 0 && !qn_settings_reduced_motion ()) {
    compare->started = 0;
    compare->tick = gtk_widget_add_tick_callback (compare->grid, on_tick, compare, NULL);
  } else if (!active && compare->tick != 0) {
    gtk_widget_remove_tick_callback (compare->grid, compare->tick);
    compare->tick = 0;
    compare->view.phase = 1.0;
    redraw (compare);
  }
}

static void
on_outline (GtkToggleButton *button, Compare *compare)
{
  compare->view.outline = gtk_toggle_button_get_active (button);
  redraw (compare);
}

static void
zoom (Compare *compare, double factor)
{
  compare->view.zoom = CLAMP (compare->view.zoom * factor, 0.2, 200.0);
  redraw (compare);
}

static void
on_fit (Compare *compare)
{
  compare->view.zoom = 1.0;
  compare->view.pan = qn_vec2 (0.0, 0.0);
  redraw (compare);
}

static void
on_zoom_in (Compare *compare)
{
  zoom (compare, ZOOM_FACTOR);
}

static void
on_zoom_out (Compare *compare)
{
  zoom (compare, 1.0 / ZOOM_FACTOR);
}

/* ---- the sheet as a file ---- */

gboolean
qn_compare_export (const GPtrArray *runs, const char *path, GError **error)
{
  g_autofree QnFigure *figures = g_new0 (QnFigure, runs->len + 1);
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = g_ptr_array_index (runs, i);
    qn_figure_init (&figures[i], &run->model, &run->contacts, &run->result,
                    run->result.mechanism != NULL ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED);
    figures[i].options.loads = figures[i].options.dimensions = false;
    figures[i].title = run->name;
  }
  QnOutput output;
  QnMetadata metadata;
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  metadata.generator = "quoin " QN_VERSION;
  const QnCompareSheet sheet = { .figures = figures, .count = runs->len };
  return qn_compare_sheet_export (&sheet, path, &output, &metadata, error);
}

static void
on_file_chosen (GtkNativeDialog *dialog, int response, Compare *compare)
{
  if (response == GTK_RESPONSE_ACCEPT) {
    const char *const endings[] = { ".png", ".svg", ".pdf", NULL };
    g_autoptr (GError) error = NULL;
    g_autofree char *path = qn_dialog_dup_chosen_path (dialog, endings, &error);
    gboolean written = path != NULL && qn_compare_export (compare->shown, path, &error);
    g_autofree char *message =
      written ? g_strdup_printf (_ ("Figure written to %s"), path) : NULL;
    gtk_label_set_text (compare->message, written ? message : error->message);
    gtk_widget_set_visible (GTK_WIDGET (compare->message), TRUE);
  }
  g_clear_object (&compare->chooser);
}

static void
on_export (Compare *compare)
{
  GtkFileChooserNative *chooser =
    qn_chooser_begin (GTK_WINDOW (compare->dialog), &compare->chooser,
                      GTK_FILE_CHOOSER_ACTION_SAVE, _ ("Export Sheet"), _ ("_Export"));
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), _ ("comparison.png"));
  g_signal_connect (chooser, "response", G_CALLBACK (on_file_chosen), compare);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

/* ---- building ---- */

static GtkWidget *
make_button (const char *icon, const char *tooltip, GCallback clicked, Compare *compare)
{
  GtkWidget *button = gtk_button_new_from_icon_name (icon);
  gtk_widget_set_tooltip_text (button, tooltip);
  gtk_accessible_update_property (GTK_ACCESSIBLE (button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  tooltip, -1);
  g_signal_connect_swapped (button, "clicked", clicked, compare);
  return button;
}

static GtkWidget *
make_toggle (const char *icon, const char *tooltip, GCallback toggled, Compare *compare)
{
  GtkWidget *button = gtk_toggle_button_new ();
  gtk_button_set_icon_name (GTK_BUTTON (button), icon);
  gtk_widget_set_tooltip_text (button, tooltip);
  gtk_accessible_update_property (GTK_ACCESSIBLE (button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  tooltip, -1);
  g_signal_connect (button, "toggled", toggled, compare);
  return button;
}

static GtkWidget *
make_header (Compare *compare)
{
  GtkWidget *header = gtk_header_bar_new ();
  compare->play =
    make_toggle ("media-playback-start-symbolic", _ ("Play all in the same phase"),
                 G_CALLBACK (on_play), compare);
  compare->outline =
    make_toggle ("view-dual-symbolic", _ ("Outline of the first over the others"),
                 G_CALLBACK (on_outline), compare);
  compare->list = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
  GtkWidget *popover = gtk_popover_new ();
  gtk_popover_set_child (GTK_POPOVER (popover), compare->list);
  GtkWidget *runs = gtk_menu_button_new ();
  gtk_menu_button_set_label (GTK_MENU_BUTTON (runs), _ ("Runs"));
  gtk_menu_button_set_popover (GTK_MENU_BUTTON (runs), popover);

  GtkWidget *start[] = { runs, compare->play, compare->outline };
  for (gsize i = 0; i < G_N_ELEMENTS (start); i++)
    gtk_header_bar_pack_start (GTK_HEADER_BAR (header), start[i]);
  GtkWidget *end[] = {
    make_button ("document-save-symbolic", _ ("Export Sheet…"), G_CALLBACK (on_export),
                 compare),
    make_button ("zoom-in-symbolic", _ ("Zoom In"), G_CALLBACK (on_zoom_in), compare),
    make_button ("quoin-fit-symbolic", _ ("Fit"), G_CALLBACK (on_fit), compare),
    make_button ("zoom-out-symbolic", _ ("Zoom Out"), G_CALLBACK (on_zoom_out), compare)
  };
  for (gsize i = 0; i < G_N_ELEMENTS (end); i++)
    gtk_header_bar_pack_end (GTK_HEADER_BAR (header), end[i]);
  return header;
}

static GtkWidget *
make_content (Compare *compare)
{
  compare->hint = gtk_label_new (
    _ ("Choose two to six runs above; those of all open windows are there. Change the "
       "model or the procedure and solve again to get another."));
  gtk_label_set_wrap (GTK_LABEL (compare->hint), TRUE);
  gtk_widget_add_css_class (compare->hint, "dim-label");
  gtk_widget_set_margin_top (compare->hint, 12);
  compare->grid = gtk_grid_new ();
  gtk_widget_set_vexpand (compare->grid, TRUE);
  gtk_grid_set_row_homogeneous (GTK_GRID (compare->grid), TRUE);
  gtk_grid_set_column_homogeneous (GTK_GRID (compare->grid), TRUE);
  gtk_grid_set_row_spacing (GTK_GRID (compare->grid), 12);
  gtk_grid_set_column_spacing (GTK_GRID (compare->grid), 12);
  compare->message = GTK_LABEL (gtk_label_new (NULL));
  gtk_label_set_wrap (compare->message, TRUE);
  gtk_label_set_selectable (compare->message, TRUE);
  gtk_widget_set_visible (GTK_WIDGET (compare->message), FALSE);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  gtk_box_append (GTK_BOX (box), compare->hint);
  gtk_box_append (GTK_BOX (box), compare->grid);
  gtk_box_append (GTK_BOX (box), GTK_WIDGET (compare->message));
  return box;
}

void
qn_compare_window_show (GtkWindow *parent, QnDocument *document,
                        QnDocumentsFunc list_others)
{
  Compare *compare = g_new0 (Compare, 1);
  compare->parent = parent;
  compare->document = document;
  compare->list_others = list_others;
  compare->shown = g_ptr_array_new_with_free_func ((GDestroyNotify) qn_run_unref);
  compare->view = (QnCompareView){
    .zoom = 1.0, .phase = 1.0, .changed = redraw, .changed_data = compare
  };
  compare->dialog = qn_dialog_new (parent, _ ("Compare Runs"), 1000, 720);
  qn_help_set_page (compare->dialog, "results");
  gtk_window_set_modal (GTK_WINDOW (compare->dialog), FALSE);
  gtk_window_set_titlebar (GTK_WINDOW (compare->dialog), make_header (compare));
  gtk_window_set_child (GTK_WINDOW (compare->dialog), make_content (compare));
  g_object_weak_ref (G_OBJECT (compare->grid), compare_free, compare);
  qn_watch (compare->grid, document, "runs-changed", G_CALLBACK (on_runs_changed),
            compare);
  choose_first (compare);
  list_runs (compare);
  fill (compare);
  gtk_window_present (GTK_WINDOW (compare->dialog));
}
