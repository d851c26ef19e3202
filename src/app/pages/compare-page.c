/* Compare: runs of the open drawings and of files side by side, at one scale, with linked zoom and
 * phase of motion; the first as an outline over the others on request; their numbers as a table and
 * their curves over each other. Files are opened and solved where they have no result. */
#include "app/pages/compare-private.h"
#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/help.h"
#include "app/widgets/settings.h"
#include "doc/document/document.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include "doc/view/sheet.h"
#include "render/backend/draw-cairo.h"
#include "render/scene/scene-build.h"
#include <glib/gi18n.h>
#include <string.h>

#define MOST_RUNS 12

#define MARGIN_PX    24.0
#define LEAST_PX     150 /* as in compare-cell.ui */
#define CAPTION_PX   60
#define WHEEL_FACTOR 1.15

/* One run: its mechanism, or its last displacements, and what it is called. */
typedef struct Cell {
  Compare *compare;
  QnRun *run;
  GtkWidget *box, *area, *name, *words;
  QnBox whole; /* of the whole motion */
  gboolean has_whole;
  QnVec2 pan_from;
} Cell;

static void
compare_free (gpointer data, GObject *where)
{
  Compare *compare = data;
  g_signal_handlers_disconnect_by_data (compare->batch, compare);
  g_object_unref (compare->batch);
  g_hash_table_unref (compare->known);
  g_ptr_array_unref (compare->shown);
  g_ptr_array_unref (compare->cells);
  g_free (compare);
}

/* ---- documents ---- */

GPtrArray *
qn_compare_list_documents (Compare *compare)
{
  GPtrArray *documents = compare->list_others (compare->document);
  const GPtrArray *files = compare->batch->documents;
  g_ptr_array_insert (documents, 0, compare->document);
  for (guint i = 0; i < files->len; i++)
    g_ptr_array_add (documents, files->pdata[i]);
  return documents;
}

/* ---- cells ---- */

static QnScene *
build_scene (const Cell *cell, double phase)
{
  const QnRun *run = cell->run, *first = cell->compare->shown->pdata[0];
  QnViewOptions options;
  qn_view_options_init (&options, qn_view_of_result (&run->result));
  options.titles = options.legend = options.dimensions = options.loads = false;
  options.phase = phase;
  gboolean comparable =
    first != run && first->result.block_count == run->result.block_count
    && (options.view == QN_VIEW_MECHANISM ? first->result.mechanism != NULL
                                          : first->result.step_count > 0);
  if (cell->compare->outline && comparable)
    options.onion = &first->result;
  return qn_scene_build (&run->model, &run->contacts, &run->result, &options, NULL);
}

/* That shows all of a cell. */
static QnCamera
fit_camera (const Cell *cell)
{
  QnCamera camera = { .width = gtk_widget_get_width (cell->area),
                      .height = gtk_widget_get_height (cell->area),
                      .scale = 1.0,
                      .unit = 1.0 };
  qn_camera_fit (&camera, cell->whole, MARGIN_PX);
  return camera;
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const Cell *cell = data;
  const Compare *compare = cell->compare;
  QnScene *scene = build_scene (cell, compare->phase);
  if (scene == NULL)
    return;
  QnCamera camera = fit_camera (cell);
  if (compare->base_scale > 0.0)
    camera.scale = compare->base_scale * compare->zoom;
  camera.center = qn_vec2_add (camera.center, compare->pan);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, cr);
  qn_scene_free (scene);
}

/* One scale for all: that of the one with the least room. */
static void
redraw (Compare *compare)
{
  double scale = INFINITY;
  for (guint i = 0; i < compare->cells->len; i++) {
    const Cell *cell = compare->cells->pdata[i];
    gtk_widget_queue_draw (cell->area);
    if (cell->has_whole && gtk_widget_get_width (cell->area) > 0
        && gtk_widget_get_height (cell->area) > 0)
      scale = MIN (scale, fit_camera (cell).scale);
  }
  compare->base_scale = isfinite (scale) ? scale : 0.0;
}

/* What stands beneath a picture, or is copied. */
static char *
dup_caption (const QnRun *run, const char *name)
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

/* Without the title where that is above it already. */
static void
show_name (const Cell *cell)
{
  g_autofree char *title = qn_compare_dup_title (cell->compare, cell->run);
  g_autofree char *caption = dup_caption (cell->run, title);
  const char *above = cell->run->label;
  int width, height;
  gtk_editable_set_text (GTK_EDITABLE (cell->name), above != NULL ? above : "");
  gtk_label_set_text (GTK_LABEL (cell->words), g_strcmp0 (title, above) == 0
                                                 ? strchr (caption, '\n') + 1
                                                 : caption);
  /* As high in a wide cell as in the narrowest: a GtkPaned asks how wide its child is at the height that
   * it has, which may not be less than it needs at its least width. */
  gtk_widget_set_size_request (cell->words, -1, CAPTION_PX);
  gtk_widget_measure (cell->words, GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL, NULL,
                      NULL);
  gtk_widget_measure (cell->words, GTK_ORIENTATION_VERTICAL, MAX (width, LEAST_PX),
                      &height, NULL, NULL, NULL);
  gtk_widget_set_size_request (cell->words, -1, height);
  gtk_accessible_update_property (GTK_ACCESSIBLE (cell->area),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, caption, -1);
}

static void add_cell (Compare *compare, QnRun *run, int column, int row);
static void tell (gpointer compare, const char *text);
static void remove_run (Compare *compare, guint at);

static void
fill (Compare *compare)
{
  GtkWidget *child;
  g_ptr_array_set_size (compare->cells, 0);
  while ((child = gtk_widget_get_first_child (compare->grid)) != NULL)
    gtk_grid_remove (GTK_GRID (compare->grid), child);
  guint count = compare->shown->len;
  int columns = count <= 1 ? 1 : count <= 4 ? 2 : count <= 9 ? 3 : 4;
  for (guint i = 0; i < count; i++)
    add_cell (compare, compare->shown->pdata[i], (int) i % columns, (int) i / columns);
  gtk_widget_set_visible (qn_part (compare->page, "hint"), count < 2);
  qn_compare_fill_table (compare);
  gtk_widget_queue_draw (compare->curves);
  redraw (compare);
}

/* ---- order ---- */

/* The cell of the run at a place, or of the last one. */
static void
focus_cell (Compare *compare, guint at)
{
  const guint count = compare->cells->len;
  if (count > 0)
    gtk_widget_grab_focus (((Cell *) compare->cells->pdata[MIN (at, count - 1)])->box);
}

/* Puts a run at a place of the order. */
static void
move_run (Compare *compare, QnRun *run, guint to)
{
  guint from;
  if (!g_ptr_array_find (compare->shown, run, &from) || to >= compare->shown->len
      || to == from)
    return;
  g_autoptr (QnRun) kept = qn_run_ref (run);
  g_ptr_array_remove_index (compare->shown, from);
  g_ptr_array_insert (compare->shown, (int) to, qn_run_ref (kept));
  fill (compare);
  focus_cell (compare, to);
}

static GdkContentProvider *
on_drag_prepare (GtkDragSource *source, double x, double y, Cell *cell)
{
  return gdk_content_provider_new_typed (G_TYPE_POINTER, cell->run);
}

static gboolean
on_cell_drop (GtkDropTarget *target, const GValue *value, double x, double y, Cell *cell)
{
  guint to;
  gboolean found = g_ptr_array_find (cell->compare->shown, cell->run, &to);
  if (found)
    move_run (cell->compare, g_value_get_pointer (value), to);
  return found;
}

static gboolean
on_cell_key (GtkEventControllerKey *controller, guint key, guint code,
             GdkModifierType state, Cell *cell)
{
  Compare *compare = cell->compare;
  guint at;
  if (!g_ptr_array_find (compare->shown, cell->run, &at))
    return FALSE;
  if (key == GDK_KEY_Delete || key == GDK_KEY_KP_Delete)
    remove_run (compare, at);
  else if ((state & GDK_ALT_MASK) && (key == GDK_KEY_Left || key == GDK_KEY_Right))
    move_run (compare, cell->run, key == GDK_KEY_Right ? at + 1 : at - 1);
  else
    return FALSE;
  return TRUE;
}

/* What can be done with a picture by hand, too. */
static GMenuModel *
make_cell_menu (GtkWidget *widget, QnMenuPlace *place, gpointer data)
{
  const Cell *cell = data;
  GMenu *menu = g_menu_new (), *order = g_menu_new (), *rest = g_menu_new ();
  guint at;
  if (!g_ptr_array_find (cell->compare->shown, cell->run, &at))
    return NULL;
  if (at > 0) {
    qn_menu_add_target (order, _ ("_Reference for the Comparison"), "compare.move",
                        g_variant_new ("(uu)", at, 0));
    qn_menu_add_target (order, _ ("_Earlier"), "compare.move",
                        g_variant_new ("(uu)", at, at - 1));
  }
  if (at + 1 < cell->compare->shown->len)
    qn_menu_add_target (order, _ ("_Later"), "compare.move",
                        g_variant_new ("(uu)", at, at + 1));
  qn_menu_add_target (rest, _ ("_Copy Text"), "compare.copy", g_variant_new_uint32 (at));
  qn_menu_add_target (rest, _ ("_Remove from Comparison"), "compare.remove",
                      g_variant_new_uint32 (at));
  qn_menu_add_section (menu, order);
  qn_menu_add_section (menu, rest);
  return G_MENU_MODEL (menu);
}

static void
move_by_menu (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Compare *compare = data;
  guint from, to;
  g_variant_get (parameter, "(uu)", &from, &to);
  if (from < compare->shown->len)
    move_run (compare, compare->shown->pdata[from], to);
}

static void
copy_by_menu (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Compare *compare = data;
  guint at = g_variant_get_uint32 (parameter);
  if (at >= compare->shown->len)
    return;
  g_autofree char *title = qn_compare_dup_title (compare, compare->shown->pdata[at]);
  g_autofree char *text = dup_caption (compare->shown->pdata[at], title);
  gdk_clipboard_set_text (gtk_widget_get_clipboard (compare->page), text);
}

/* ---- what a cell does ---- */

static void
on_renamed (GtkWidget *entry, Cell *cell)
{
  QnDocument *document = qn_compare_find_document (cell->compare, cell->run);
  g_autoptr (GError) error = NULL;
  if (document != NULL
      && !qn_document_rename_run (document, cell->run,
                                  gtk_editable_get_text (GTK_EDITABLE (entry)), &error))
    tell (cell->compare, error->message);
}

static void
on_left (GtkEventController *focus, Cell *cell)
{
  if (gtk_widget_get_mapped (cell->name)) /* not while the window goes */
    on_renamed (cell->name, cell);
}

static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, Cell *cell)
{
  Compare *compare = cell->compare;
  compare->zoom = CLAMP (compare->zoom * pow (WHEEL_FACTOR, -dy), 0.2, 200.0);
  redraw (compare);
  return TRUE;
}

static void
on_pan_begin (GtkGestureDrag *gesture, double x, double y, Cell *cell)
{
  cell->pan_from = cell->compare->pan;
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, Cell *cell)
{
  Compare *compare = cell->compare;
  double scale = compare->base_scale * compare->zoom;
  if (!(scale > 0.0))
    return;
  compare->pan = qn_vec2 (cell->pan_from.x - dx / scale, cell->pan_from.y + dy / scale);
  redraw (compare);
}

static void
on_resize (GtkDrawingArea *area, int width, int height, Compare *compare)
{
  redraw (compare);
}

static void
free_cell (gpointer data)
{
  Cell *cell = data;
  qn_run_unref (cell->run);
  g_free (cell);
}

/* All are zoomed and panned together. The words beneath a picture are dragged onto another one, Alt and the arrows do
 * the same; what the run is called stands over them, to be typed over. */
static void
add_cell (Compare *compare, QnRun *run, int column, int row)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("compare-cell");
  Cell *cell = g_new0 (Cell, 1);
  *cell = (Cell){ .compare = compare,
                  .run = qn_run_ref (run),
                  .box = qn_builder_take_widget (builder, "cell"),
                  .area = qn_builder_get_widget (builder, "area"),
                  .name = qn_builder_get_widget (builder, "name"),
                  .words = qn_builder_get_widget (builder, "words") };
  /* Room for the whole motion, so that nothing jumps while it plays. */
  QnScene *whole = build_scene (cell, 1.0);
  cell->has_whole = whole != NULL;
  if (whole != NULL)
    cell->whole = whole->box;
  qn_scene_free (whole);
  const struct {
    const char *id, *signal;
    GCallback handler;
  } links[] = {
    { "scroll", "scroll", G_CALLBACK (on_scroll) },
    { "pan", "drag-begin", G_CALLBACK (on_pan_begin) },
    { "pan", "drag-update", G_CALLBACK (on_pan_update) },
    { "keys", "key-pressed", G_CALLBACK (on_cell_key) },
    { "source", "prepare", G_CALLBACK (on_drag_prepare) },
    { "name", "activate", G_CALLBACK (on_renamed) },
    { "focus", "leave", G_CALLBACK (on_left) },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (links); i++)
    g_signal_connect (gtk_builder_get_object (builder, links[i].id), links[i].signal,
                      links[i].handler, cell);
  GtkDropTarget *target = gtk_drop_target_new (G_TYPE_POINTER, GDK_ACTION_COPY);
  g_signal_connect (target, "drop", G_CALLBACK (on_cell_drop), cell);
  gtk_widget_add_controller (cell->box, GTK_EVENT_CONTROLLER (target));
  g_signal_connect (cell->area, "resize", G_CALLBACK (on_resize), compare);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (cell->area), draw, cell, NULL);
  g_object_set_data_full (G_OBJECT (cell->box), "qn-cell", cell, free_cell);
  gtk_widget_set_visible (cell->name, run->label != NULL);
  qn_context_menu_attach (cell->box, make_cell_menu, cell);
  gtk_grid_attach (GTK_GRID (compare->grid), cell->box, column, row, 1, 1);
  g_ptr_array_add (compare->cells, cell);
  show_name (cell);
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

/* The runs of all windows, those of this one first, and of the files. */
static void
list_runs (Compare *compare)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (compare->list)) != NULL)
    gtk_box_remove (GTK_BOX (compare->list), child);
  g_autoptr (GPtrArray) documents = qn_compare_list_documents (compare);
  for (guint k = 0; k < documents->len; k++) {
    QnDocument *document = g_ptr_array_index (documents, k);
    g_autofree char *title = qn_document_dup_display_name (document);
    for (guint i = 0; i < document->runs->len; i++) {
      QnRun *run = g_ptr_array_index (document->runs, i);
      g_autofree char *label = g_strdup_printf (_ ("%s: %s"), title, run->name);
      GtkWidget *check = gtk_check_button_new_with_label (label);
      gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                                   g_ptr_array_find (compare->shown, run, NULL));
      g_object_set_data_full (G_OBJECT (check), "qn-run", qn_run_ref (run),
                              (GDestroyNotify) qn_run_unref);
      g_signal_connect (check, "toggled", G_CALLBACK (on_run_toggled), compare);
      gtk_box_append (GTK_BOX (compare->list), check);
    }
  }
}

/* What was solved here last, until the user chooses otherwise. */
static void
choose_first (Compare *compare)
{
  const GPtrArray *runs = compare->document->runs;
  guint first = runs->len > MOST_RUNS ? runs->len - MOST_RUNS : 0;
  g_ptr_array_set_size (compare->shown, 0);
  for (guint i = first; i < runs->len; i++)
    g_ptr_array_add (compare->shown, qn_run_ref (g_ptr_array_index (runs, i)));
}

/* Those that were solved again stand where they stood before; whether there are any. */
static gboolean
take_successors (Compare *compare)
{
  const GPtrArray *runs = compare->document->runs;
  gboolean any = FALSE;
  for (guint i = 0; i < compare->shown->len; i++) {
    g_autoptr (QnRun) old = qn_run_ref (compare->shown->pdata[i]);
    if (qn_compare_find_document (compare, old) != NULL)
      continue;
    for (guint k = 0; k < runs->len; k++)
      if (g_strcmp0 (((QnRun *) runs->pdata[k])->name, old->name) == 0) {
        qn_run_unref (compare->shown->pdata[i]);
        compare->shown->pdata[i] = qn_run_ref (runs->pdata[k]);
        any = TRUE;
      }
  }
  return any;
}

static void
on_runs_changed (Compare *compare)
{
  const gboolean few = compare->shown->len < 2;
  if (few)
    choose_first (compare);
  if (few || take_successors (compare)) {
    fill (compare);
  } else {
    for (guint i = 0; i < compare->cells->len; i++)
      show_name (compare->cells->pdata[i]); /* they may have other ones */
    qn_compare_fill_table (compare);
    gtk_widget_queue_draw (compare->curves);
  }
  list_runs (compare);
}

static void
remove_run (Compare *compare, guint at)
{
  if (at >= compare->shown->len)
    return;
  g_ptr_array_remove_index (compare->shown, at);
  fill (compare);
  list_runs (compare);
  focus_cell (compare, at);
}

static void
remove_by_menu (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  remove_run (data, g_variant_get_uint32 (parameter));
}

/* ---- files ---- */

static void
tell (gpointer data, const char *text)
{
  const Compare *compare = data;
  gtk_label_set_text (qn_part (compare->page, "message"), text);
  gtk_widget_set_visible (qn_part (compare->page, "message"), *text != '\0');
}

/* Whether a window has the file as it is on disk, with a result: that one is shown. */
static gboolean
is_solved_in_window (Compare *compare, QnDocument *file)
{
  g_autoptr (GPtrArray) documents = compare->list_others (compare->document);
  g_ptr_array_add (documents, compare->document);
  for (guint i = 0; i < documents->len; i++) {
    QnDocument *open = documents->pdata[i];
    if (g_strcmp0 (open->path, file->path) == 0 && !qn_document_is_modified (open)
        && open->run != NULL)
      return TRUE;
  }
  return FALSE;
}

/* New runs of files are put on show; what goes on and what went wrong is told. */
static void
on_batch_changed (Compare *compare)
{
  const GPtrArray *documents = compare->batch->documents;
  const GPtrArray *messages = compare->batch->messages;
  GString *text = g_string_new (NULL);
  gboolean any = FALSE;
  for (guint i = 0; i < documents->len; i++) {
    QnDocument *document = documents->pdata[i];
    QnRun *run = document->run;
    g_autofree char *name = qn_document_dup_display_name (document);
    if (document->job != NULL)
      g_string_append_printf (text, _ ("Solving %s…\n"), name);
    if (run == NULL || g_hash_table_contains (compare->known, run))
      continue;
    g_hash_table_add (compare->known, qn_run_ref (run));
    any = TRUE;
    if (compare->shown->len < MOST_RUNS
        && !is_solved_in_window (compare, documents->pdata[i]))
      g_ptr_array_add (compare->shown, qn_run_ref (run));
  }
  for (guint i = 0; i < messages->len; i++)
    g_string_append_printf (text, "⚠ %s\n", (const char *) messages->pdata[i]);
  tell (compare, g_strchomp (text->str));
  g_string_free (text, TRUE);
  if (any)
    fill (compare);
  list_runs (compare);
}

static gboolean
use_file (gpointer data, const char *path, GError **error)
{
  qn_batch_add (((Compare *) data)->batch, path);
  return TRUE;
}

static void
add_files (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Compare *compare = data;
  gboolean folder = g_str_equal (g_action_get_name (G_ACTION (action)), "add-folders");
  static const QnFileKind kind = { .name = N_ ("Projects and results"),
                                   .suffixes = { "quoin", "json" } };
  const QnFileQuestion question = { .title = folder ? _ ("Add Folders") : _ ("Add Files"),
                                    .accept = _ ("_Open"),
                                    .use = use_file,
                                    .failed = tell,
                                    .kind = folder ? NULL : &kind,
                                    .folder = folder,
                                    .many = TRUE };
  qn_chooser_ask (compare->page, &question, compare);
}

static void
add_path (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  use_file (data, g_variant_get_string (parameter, NULL), NULL);
}

/* ---- motion and zoom ---- */

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
    compare->phase = 1.0;
    redraw (compare);
  }
}

static void
on_outline (GtkToggleButton *button, Compare *compare)
{
  compare->outline = gtk_toggle_button_get_active (button);
  redraw (compare);
}

/* By a factor; 0 shows all. */
static void
zoom (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Compare *compare = data;
  double factor = g_variant_get_double (parameter);
  compare->zoom = factor > 0.0 ? CLAMP (compare->zoom * factor, 0.2, 200.0) : 1.0;
  if (!(factor > 0.0))
    compare->pan = qn_vec2 (0.0, 0.0);
  redraw (compare);
}

/* ---- the sheet as a file ---- */

static gboolean
write_sheet (gpointer data, const char *path, GError **error)
{
  Compare *compare = data;
  const guint count = compare->shown->len;
  g_autoptr (GPtrArray) titles = g_ptr_array_new_with_free_func (g_free);
  g_autofree QnProject *projects = g_new0 (QnProject, count + 1);
  g_autofree QnSheetRun *sheet = g_new0 (QnSheetRun, count + 1);
  for (guint i = 0; i < count; i++) {
    QnRun *run = compare->shown->pdata[i];
    g_ptr_array_add (titles, qn_compare_dup_title (compare, run));
    projects[i].model = run->model;
    projects[i].model.title = titles->pdata[i];
    sheet[i] = (QnSheetRun){ &projects[i], &run->contacts, &run->result, run->name };
  }
  QnOutput output;
  qn_output_init (&output);
  return qn_comparison_export (sheet, count, 0, NULL, FALSE, path, &output, error);
}

/* Asks for the file, but where it is given. */
static void
export_sheet (GSimpleAction *action, GVariant *path, gpointer data)
{
  static const char *const endings[] = { ".png", ".svg", ".pdf", NULL };
  const QnFileQuestion question = { .title = _ ("Export Sheet"),
                                    .accept = _ ("_Export"),
                                    .name = _ ("comparison.png"),
                                    .endings = endings,
                                    .use = write_sheet,
                                    .told = tell,
                                    .given = path != NULL
                                               ? g_variant_get_string (path, NULL)
                                               : NULL };
  Compare *compare = data;
  qn_chooser_ask (compare->page, &question, compare);
}

/* ---- building ---- */

static void
add_actions (Compare *compare)
{
  static const GActionEntry entries[] = {
    { .name = "add-files", .activate = add_files },
    { .name = "add-folders", .activate = add_files },
    { .name = "add-path", .activate = add_path, .parameter_type = "s" },
    { .name = "export", .activate = export_sheet },
    { .name = "export-path", .activate = export_sheet, .parameter_type = "s" },
    { .name = "zoom", .activate = zoom, .parameter_type = "d" },
    { .name = "move", .activate = move_by_menu, .parameter_type = "(uu)" },
    { .name = "copy", .activate = copy_by_menu, .parameter_type = "u" },
    { .name = "remove", .activate = remove_by_menu, .parameter_type = "u" },
  };
  qn_actions_insert (compare->page, "compare", entries, G_N_ELEMENTS (entries), compare);
}

GtkWidget *
qn_compare_page_new (QnDocument *document, QnDocumentsFunc list_others)
{
  static const QnFileQuestion dropped = { .use = use_file, .failed = tell };
  g_autoptr (GtkBuilder) builder = qn_builder_new ("compare-page");
  Compare *compare = g_new0 (Compare, 1);
  *compare = (Compare){
    .document = document,
    .list_others = list_others,
    .shown = g_ptr_array_new_with_free_func ((GDestroyNotify) qn_run_unref),
    .batch = g_object_new (QN_TYPE_BATCH, NULL),
    .known = g_hash_table_new_full (NULL, NULL, (GDestroyNotify) qn_run_unref, NULL),
    .cells = g_ptr_array_new (),
    .zoom = 1.0,
    .phase = 1.0,
    .page = qn_builder_take_widget (builder, "page"),
    .list = qn_builder_get_widget (builder, "list"),
    .grid = qn_builder_get_widget (builder, "grid"),
    .curves = qn_builder_get_widget (builder, "curves"),
    .table = qn_builder_get_widget (builder, "table"),
  };
  g_signal_connect (qn_builder_get_widget (builder, "play"), "toggled",
                    G_CALLBACK (on_play), compare);
  g_signal_connect (qn_builder_get_widget (builder, "outline"), "toggled",
                    G_CALLBACK (on_outline), compare);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (compare->curves),
                                  qn_compare_draw_curves, compare, NULL);
  g_signal_connect_swapped (compare->batch, "changed", G_CALLBACK (on_batch_changed),
                            compare);
  g_object_weak_ref (G_OBJECT (compare->grid), compare_free, compare);
  qn_help_set_page (compare->page, "results");
  qn_accept_files (compare->page, &dropped, compare);
  add_actions (compare);
  qn_watch (compare->grid, document, "runs-changed", G_CALLBACK (on_runs_changed),
            compare);
  choose_first (compare);
  list_runs (compare);
  fill (compare);
  return compare->page;
}
