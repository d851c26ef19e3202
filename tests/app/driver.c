#include "driver.h"

#include "app/widgets/plot-view.h"
#include "doc/edit/edit-masonry.h"

#include <execinfo.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A wait that is longer has failed, under sanitizers on a busy machine too. */
#define LONGEST_WAIT_US (120 * G_USEC_PER_SEC)

#define LOOK_MS 5 /* between two looks at a condition that no event tells of */

#ifdef __SANITIZE_ADDRESS__
#include <dlfcn.h>
#include <sanitizer/lsan_interface.h>

/* GLib lets go of the table of its quarks when it grows, on purpose, so that nobody has to lock it
 * for reading. What the constructors of libraries allocate is nobody's leak: they run between
 * these two. The drivers that GTK opens and closes bring LLVM with them; it stays loaded, for what it
 * keeps can only be told from a leak while it is there. */
static void
before_libraries (void)
{
  __lsan_disable ();
}

__attribute__ ((section (".preinit_array"),
                used)) static void (*const first) (void) = before_libraries;

__attribute__ ((constructor)) static void
after_libraries (void)
{
  dlopen ("libOSMesa.so.8", RTLD_LAZY | RTLD_NODELETE);
  __lsan_enable ();
}
#endif

GtkApplication *
driver_application (void)
{
  static GtkApplication *application;
  if (application == NULL) {
    application = qn_application_new ();
    g_application_set_flags (G_APPLICATION (application),
                             G_APPLICATION_HANDLES_OPEN | G_APPLICATION_NON_UNIQUE);
    g_assert_true (g_application_register (G_APPLICATION (application), NULL, NULL));
    /* What moves for ever never settles, and no click is the second one of a pair by chance. */
    driver_set_animated (FALSE);
    g_object_set (gtk_settings_get_default (), "gtk-cursor-blink", FALSE,
                  "gtk-double-click-time", 1, NULL);
  }
  return GTK_APPLICATION (application);
}

static void
go_on (gint64 begun)
{
  g_assert_cmpint (g_get_monotonic_time (), <, begun + LONGEST_WAIT_US);
  g_main_context_iteration (NULL, TRUE);
}

/* Frames after which a window that moves for ever has been laid out and drawn. */
enum { FRAMES_OF_MOTION = 3 };

void
driver_set_animated (gboolean animated)
{
  g_object_set (gtk_settings_get_default (), "gtk-enable-animations", animated, NULL);
}

/* An analysis shows how far it is, and a motion is played, in every frame. */
static gboolean
moves (gpointer window)
{
  gboolean animated;
  g_object_get (gtk_settings_get_default (), "gtk-enable-animations", &animated, NULL);
  return animated
         || (QN_IS_WINDOW (window) && qn_window_get_document (window)->job != NULL);
}

/* GDK's clock of frames has a source of the main loop, whose data it is itself, for as long as a frame is
 * due: for a layout, a drawing, an animation or a pointer that has moved. `frames` has the number of the
 * first frame that each clock was seen at. */
static gboolean
is_frame_due (GHashTable *frames)
{
  GListModel *windows = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (windows); i++) {
    g_autoptr (GtkNative) window = g_list_model_get_item (windows, i);
    GdkSurface *surface = gtk_native_get_surface (window);
    if (surface == NULL)
      continue;
    GdkFrameClock *clock = gdk_surface_get_frame_clock (surface);
    if (g_main_context_find_source_by_user_data (NULL, clock) == NULL)
      continue;
    gint64 frame = gdk_frame_clock_get_frame_counter (clock);
    if (!g_hash_table_contains (frames, clock))
      g_hash_table_insert (frames, clock, GINT_TO_POINTER ((int) frame));
    if (!moves (window)
        || (int) frame - GPOINTER_TO_INT (g_hash_table_lookup (frames, clock))
             < FRAMES_OF_MOTION)
      return TRUE;
  }
  return FALSE;
}

void
driver_settle (void)
{
  gint64 begun = g_get_monotonic_time ();
  g_autoptr (GHashTable) frames = g_hash_table_new (NULL, NULL);
  do {
    while (g_main_context_pending (NULL) || is_frame_due (frames))
      go_on (begun);
    /* What the server has sent by now is taken in. */
    gdk_display_sync (gdk_display_get_default ());
  } while (g_main_context_pending (NULL) || is_frame_due (frames));
}

static gboolean
on_look (gpointer data)
{
  (void) data;
  return G_SOURCE_CONTINUE;
}

void
driver_wait (DriverCondition condition, gpointer data)
{
  gint64 begun = g_get_monotonic_time ();
  guint look = g_timeout_add (LOOK_MS, on_look, NULL);
  while (!condition (data))
    go_on (begun);
  g_source_remove (look);
  driver_settle ();
}

/* ---- warnings ---- */

/* What GTK 4.8 says of itself, and windows of GTK's own widgets alone show. Every other warning ends
 * the test. */
static const char *const told_by_gtk[] = {
  /* It counts how often a widget is pressed, and loses count where the widget under a held button
   * goes away, or a window is moved without a window manager. */
  "Broken accounting of active state",
  /* A tooltip that is due when its menu or window has just closed asks where the pointer is over a
   * surface that is gone. */
  "gdk_surface_get_device_position: assertion 'GDK_IS_SURFACE (surface)' failed",
  "_gtk_widget_find_at_coords: assertion 'GDK_IS_SURFACE (surface)' failed",
  /* A popover that is laid out asks for the size of the monitor that its window is on, where that is on
   * none (any more). */
  "gdk_monitor_get_geometry: assertion 'GDK_IS_MONITOR (monitor)' failed",
  /* Its chooser of files draws the buttons of a path that have just come, before they are laid out. */
  "Trying to snapshot GtkButton",
  /* That of GTK 4.18 takes buttons out of a path that it has made anew meanwhile. */
  "gtk_box_remove: assertion 'gtk_widget_get_parent (child) == (GtkWidget *)box' failed",
};

static gboolean passes_over_gtk;

static gboolean
is_told_by_gtk (const char *message)
{
  for (gsize i = 0; passes_over_gtk && i < G_N_ELEMENTS (told_by_gtk); i++)
    if (g_str_has_prefix (message, told_by_gtk[i]))
      return TRUE;
  return FALSE;
}

static gboolean
is_fatal (const char *domain, GLogLevelFlags level, const char *message, gpointer data)
{
  (void) domain;
  (void) level;
  (void) data;
  if (is_told_by_gtk (message))
    return FALSE;
  /* Where it comes from, for whoever reads the log. */
  void *frames[64];
  backtrace_symbols_fd (frames, backtrace (frames, G_N_ELEMENTS (frames)), STDERR_FILENO);
  return TRUE;
}

/* The handler of GLib's tests says of fatal messages that the test is over. */
static GLogFunc usual_handler;

static void
handle_log (const char *domain, GLogLevelFlags level, const char *message, gpointer data)
{
  if (!is_told_by_gtk (message))
    usual_handler (domain, level, message, data);
}

static GLogWriterOutput
write_log (GLogLevelFlags level, const GLogField *fields, gsize count, gpointer data)
{
  for (gsize i = 0; i < count; i++)
    if (g_str_equal (fields[i].key, "MESSAGE") && is_told_by_gtk (fields[i].value))
      return G_LOG_WRITER_HANDLED;
  return g_log_writer_default (level, fields, count, data);
}

static void
hear_warnings (void)
{
  if (usual_handler == NULL) {
    usual_handler = g_log_set_default_handler (handle_log, NULL);
    g_log_set_writer_func (write_log, NULL, NULL);
  }
  g_test_log_set_fatal_handler (is_fatal, NULL);
}

void
driver_pass_over_gtk (void)
{
  passes_over_gtk = TRUE;
  hear_warnings ();
}

static gboolean
is_mapped (gpointer window)
{
  return gtk_widget_get_mapped (window) && gtk_widget_get_width (window) > 0;
}

QnWindow *
driver_open_window (int width, int height)
{
  hear_warnings ();
  QnWindow *window = qn_window_new (driver_application ());
  gtk_window_set_default_size (GTK_WINDOW (window), width, height);
  gtk_window_present (GTK_WINDOW (window));
  driver_wait (is_mapped, window);
  return window;
}

char *
driver_example_path (const char *name)
{
  return g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
}

static QnWindow *
open_path (const char *path)
{
  QnWindow *window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  driver_settle ();
  return window;
}

QnWindow *
driver_open_example (const char *name)
{
  g_autofree char *path = driver_example_path (name);
  return open_path (path);
}

QnWindow *
driver_open_copy (const char *folder, const char *name)
{
  g_autofree char *source = driver_example_path (name);
  g_autofree char *text = NULL;
  g_autofree char *path = g_build_filename (folder, "wall.quoin", NULL);
  g_assert_true (g_file_get_contents (source, &text, NULL, NULL));
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  return open_path (path);
}

static gboolean
has_no_job (gpointer window)
{
  return qn_window_get_document (window)->job == NULL;
}

void
driver_wait_for_job (QnWindow *window)
{
  driver_wait (has_no_job, window);
}

/* ---- pointer and keys ---- */

static guint inputs;

guint
driver_take_inputs (void)
{
  guint count = inputs;
  inputs = 0;
  return count;
}

/* Buttons and keys that go down. */
static guint
count_inputs (const char *const *arguments)
{
  static const char *const verbs[] = { "click", "mousedown", "key", "keydown", NULL };
  if (g_str_equal (arguments[0], "type"))
    return (guint) g_utf8_strlen (arguments[3], -1);
  return g_strv_contains (verbs, arguments[0]) ? 1 : 0;
}

void
driver_xdotool (const char *const *arguments)
{
  inputs += count_inputs (arguments);
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();
  g_strv_builder_add (builder, "xdotool");
  g_strv_builder_addv (builder, (const char **) arguments);
  g_auto (GStrv) argv = g_strv_builder_end (builder);
  int status = 0;
  g_assert_true (g_spawn_sync (NULL, argv, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, NULL,
                               NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  gdk_display_sync (gdk_display_get_default ());
  driver_settle ();
}

void
driver_point_at (GtkWidget *widget, double x, double y)
{
  GtkNative *native = gtk_widget_get_native (widget);
  double left, top, offset_x, offset_y;
  g_assert_true (
    gtk_widget_translate_coordinates (widget, GTK_WIDGET (native), x, y, &left, &top));
  gtk_native_get_surface_transform (native, &offset_x, &offset_y);
  for (GdkSurface *surface = gtk_native_get_surface (native); GDK_IS_POPUP (surface);
       surface = gdk_popup_get_parent (GDK_POPUP (surface))) {
    offset_x += gdk_popup_get_position_x (GDK_POPUP (surface));
    offset_y += gdk_popup_get_position_y (GDK_POPUP (surface));
  }
  g_autofree char *px = g_strdup_printf ("%.0f", left + offset_x);
  g_autofree char *py = g_strdup_printf ("%.0f", top + offset_y);
  const char *const arguments[] = { "mousemove", px, py, NULL };
  driver_xdotool (arguments);
}

void
driver_press_button (const char *number)
{
  const char *const arguments[] = { "click", number, NULL };
  driver_xdotool (arguments);
}

void
driver_point (QnWindow *window, double x, double y)
{
  QnCanvas *canvas = canvas_of (window);
  QnVec2 s = qn_canvas_to_screen (canvas, qn_vec2 (x, y));
  driver_point_at (GTK_WIDGET (canvas), s.x, s.y);
}

void
driver_hold_button (gboolean down)
{
  const char *const arguments[] = { down ? "mousedown" : "mouseup", "1", NULL };
  driver_xdotool (arguments);
}

void
driver_drag (QnWindow *window, double x0, double y0, double x1, double y1)
{
  driver_point (window, x0, y0);
  driver_hold_button (TRUE);
  driver_point (window, 0.5 * (x0 + x1), 0.5 * (y0 + y1));
  driver_point (window, x1, y1);
  driver_hold_button (FALSE);
}

void
driver_click (QnWindow *window, double x, double y)
{
  driver_point (window, x, y);
  driver_hold_button (TRUE);
  driver_hold_button (FALSE);
}

void
driver_key (const char *key)
{
  const char *const arguments[] = { "key", key, NULL };
  driver_xdotool (arguments);
}

void
driver_hold_key (const char *key, gboolean down)
{
  const char *const arguments[] = { down ? "keydown" : "keyup", key, NULL };
  driver_xdotool (arguments);
}

void
driver_type (const char *text)
{
  const char *const arguments[] = { "type", "--delay", "20", text, NULL };
  driver_xdotool (arguments);
}

void
driver_activate (QnWindow *window, const char *detailed_action)
{
  g_autofree char *name = NULL;
  g_autoptr (GVariant) target = NULL;
  g_assert_true (g_action_parse_detailed_name (detailed_action, &name, &target, NULL));
  g_assert_true (gtk_widget_activate_action_variant (GTK_WIDGET (window), name, target));
  driver_settle ();
}

void
driver_activate_target (QnWindow *window, const char *action, GVariant *target)
{
  g_autoptr (GVariant) kept = g_variant_ref_sink (target);
  g_assert_true (gtk_widget_activate_action_variant (GTK_WIDGET (window), action, kept));
  driver_settle ();
}

GtkWidget *
driver_find_dialog (const char *title)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    const char *its = gtk_window_get_title (GTK_WINDOW (toplevel));
    if (!QN_IS_WINDOW (toplevel) && its != NULL && g_str_has_prefix (its, title))
      return toplevel;
  }
  return NULL;
}

GtkWidget *
driver_find_page (const char *title)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    GtkWidget *page =
      QN_IS_WINDOW (toplevel) ? qn_window_get_page (QN_WINDOW (toplevel)) : NULL;
    if (page != NULL
        && g_str_has_prefix (gtk_stack_page_get_title (
                               gtk_stack_get_page (QN_WINDOW (toplevel)->pages, page)),
                             title))
      return page;
  }
  return NULL;
}

GtkWidget *
driver_find_message (void)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    if (g_str_equal (gtk_widget_get_name (toplevel), "question"))
      return toplevel;
  }
  return NULL;
}

GtkWidget *
driver_find_widget (GtkWidget *root, DriverMatch match, gconstpointer data)
{
  if (match (root, data))
    return root;
  for (GtkWidget *child = gtk_widget_get_first_child (root); child != NULL;
       child = gtk_widget_get_next_sibling (child)) {
    GtkWidget *found = driver_find_widget (child, match, data);
    if (found != NULL)
      return found;
  }
  return NULL;
}

static gboolean
is_button_called (GtkWidget *widget, gconstpointer label)
{
  if (!GTK_IS_BUTTON (widget) || gtk_button_get_label (GTK_BUTTON (widget)) == NULL)
    return FALSE;
  g_auto (GStrv) parts = g_strsplit (gtk_button_get_label (GTK_BUTTON (widget)), "_", 2);
  g_autofree char *plain = g_strjoinv ("", parts);
  return g_str_equal (plain, label);
}

gboolean
driver_has_id (GtkWidget *widget, gconstpointer id)
{
  return g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), id) == 0;
}

gboolean
driver_has_name (GtkWidget *widget, gconstpointer name)
{
  return strcmp (gtk_widget_get_name (widget), name) == 0;
}

QnBox
driver_plot_range (GtkWidget *plot)
{
  driver_settle ();
  const QnPlotPlace *place = qn_plot_view_get_place (plot);
  const QnBox *frame = &place->frame;
  return (QnBox){ qn_plot_place_value (place, qn_vec2 (frame->min.x, frame->max.y)),
                  qn_plot_place_value (place, qn_vec2 (frame->max.x, frame->min.y)) };
}

gboolean
driver_says (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_LABEL (widget) && gtk_widget_get_mapped (widget)
         && strstr (gtk_label_get_text (GTK_LABEL (widget)), text) != NULL;
}

gboolean
driver_is_button (GtkWidget *widget, gconstpointer label)
{
  return GTK_IS_BUTTON (widget)
         && g_strcmp0 (gtk_button_get_label (GTK_BUTTON (widget)), label) == 0;
}

gboolean
driver_is_check (GtkWidget *widget, gconstpointer label)
{
  return GTK_IS_CHECK_BUTTON (widget)
         && g_strcmp0 (gtk_check_button_get_label (GTK_CHECK_BUTTON (widget)), label)
              == 0;
}

gboolean
driver_is_expander (GtkWidget *widget, gconstpointer label)
{
  if (!GTK_IS_EXPANDER (widget))
    return FALSE;
  GtkWidget *title = gtk_expander_get_label_widget (GTK_EXPANDER (widget));
  if (GTK_IS_BOX (title)) /* of a card */
    title = gtk_widget_get_first_child (title);
  return GTK_IS_LABEL (title)
         && g_strcmp0 (gtk_label_get_label (GTK_LABEL (title)), label) == 0;
}

gboolean
driver_is_menu (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_POPOVER_MENU (widget) && gtk_widget_get_mapped (widget);
}

gboolean
driver_is_cell (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return g_object_get_data (G_OBJECT (widget), "qn-cell") != NULL;
}

GtkWidget *
driver_find_id (GtkWidget *root, const char *id)
{
  GtkWidget *found = driver_find_widget (root, driver_has_id, id);
  g_assert_nonnull (found);
  return found;
}

GtkWidget *
driver_find_other (void)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    if (!QN_IS_WINDOW (toplevel) && gtk_widget_get_mapped (toplevel))
      return toplevel;
  }
  return NULL;
}

const char *
driver_last_step (QnWindow *window)
{
  QnEditHistory *history = qn_window_get_document (window)->history;
  return qn_history_get_name (history, history->position - 1);
}

void
driver_click_on (GtkWidget *root, DriverMatch match, const char *label)
{
  GtkWidget *item = driver_find_widget (root, match, label);
  if (item == NULL)
    g_error ("nothing is called %s", label);
  driver_point_at (item, 0.5 * gtk_widget_get_width (item),
                   0.5 * gtk_widget_get_height (item));
  driver_press_button ("1");
}

void
driver_open_analysis (QnWindow *window)
{
  driver_activate (window, "win.show-panel::analysis");
  driver_unfold (gtk_stack_get_visible_child (window->side_stack));
  driver_settle ();
}

void
driver_unfold (GtkWidget *widget)
{
  if (GTK_IS_EXPANDER (widget))
    gtk_expander_set_expanded (GTK_EXPANDER (widget), TRUE);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    driver_unfold (child);
}

void
driver_press (GtkWidget *root, const char *label)
{
  GtkWidget *button = driver_find_widget (root, is_button_called, label);
  g_assert_nonnull (button);
  g_assert_true (gtk_widget_get_sensitive (button));
  g_signal_emit_by_name (button, "clicked");
  driver_settle ();
}

/* What a window takes with it: pointers that become NULL. */
struct DriverParts {
  GPtrArray *objects; /* gpointer *, each weak */
};

static void
watch (DriverParts *parts, gpointer object)
{
  gpointer *place = g_new (gpointer, 1);
  *place = object;
  g_object_add_weak_pointer (object, place);
  g_ptr_array_add (parts->objects, place);
}

/* GTK has one tooltip, which it gives to the next window, may keep the text of an entry that showed its menu,
 * and keeps a menu that has closed with a submenu open. */
static void
watch_tree (DriverParts *parts, GtkWidget *widget)
{
  if (g_str_equal (G_OBJECT_TYPE_NAME (widget), "GtkTooltipWindow")
      || GTK_IS_TEXT (widget) || GTK_IS_POPOVER_MENU (widget))
    return;
  watch (parts, widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    watch_tree (parts, child);
}

DriverParts *
driver_watch_parts (QnWindow *window)
{
  DriverParts *parts = g_new (DriverParts, 1);
  parts->objects = g_ptr_array_new_with_free_func (g_free);
  watch (parts, state_of (window));
  watch (parts, qn_window_get_document (window));
  GListModel *windows = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (windows); i++) {
    g_autoptr (GtkWindow) each = g_list_model_get_item (windows, i);
    if (each == GTK_WINDOW (window)
        || gtk_window_get_transient_for (each) == GTK_WINDOW (window))
      watch_tree (parts, GTK_WIDGET (each));
  }
  return parts;
}

static gboolean
are_gone (gpointer data)
{
  const DriverParts *parts = data;
  for (guint i = 0; i < parts->objects->len; i++)
    if (*(gpointer *) g_ptr_array_index (parts->objects, i) != NULL)
      return FALSE;
  return TRUE;
}

void
driver_wait_until_gone (DriverParts *parts)
{
  driver_wait (are_gone, parts);
  g_ptr_array_unref (parts->objects);
  g_free (parts);
}

void
driver_discard (QnWindow *window)
{
  DriverParts *parts = driver_watch_parts (window);
  gtk_window_destroy (GTK_WINDOW (window));
  driver_wait_until_gone (parts);
}

static GdkTexture *
take_texture (GtkWidget *window)
{
  driver_wait (is_mapped, window);
  float factor = (float) gtk_widget_get_scale_factor (window);
  g_autoptr (GdkPaintable) paintable = gtk_widget_paintable_new (window);
  GtkSnapshot *snapshot = gtk_snapshot_new ();
  gtk_snapshot_scale (snapshot, factor, factor);
  /* With the shadow around it: another size would be scaled and blur. */
  gdk_paintable_snapshot (paintable, GDK_SNAPSHOT (snapshot),
                          gdk_paintable_get_intrinsic_width (paintable),
                          gdk_paintable_get_intrinsic_height (paintable));
  GskRenderNode *node = gtk_snapshot_free_to_node (snapshot);
  g_assert_nonnull (node);
  GskRenderer *renderer = gtk_native_get_renderer (GTK_NATIVE (window));
  GdkTexture *texture = gsk_renderer_render_texture (renderer, node, NULL);
  gsk_render_node_unref (node);
  return texture;
}

static gboolean
add_large_wall (QnProject *draft, gpointer data, GError **error)
{
  (void) data;
  const QnMasonryStyle style = { .unit = { 0.4, 0.175 },
                                 .lap = 0.5,
                                 .thickness = 1.0,
                                 .unit_weight = 1e4,
                                 .law = QN_NONE,
                                 .base = TRUE };
  QnMasonry wall;
  qn_plan_wall (&wall, &style, qn_vec2 (0.0, 0.0), qn_vec2 (40.0, 17.5));
  return qn_edit_add_masonry (draft, &wall, error);
}

void
driver_lay_large_wall (QnWindow *window)
{
  g_autoptr (GError) error = NULL;
  qn_document_edit (qn_window_get_document (window), "Wall", NULL, add_large_wall, NULL,
                    &error);
  g_assert_no_error (error);
}

cairo_surface_t *
driver_picture (GtkWidget *window)
{
  g_autoptr (GdkTexture) texture = take_texture (window);
  cairo_surface_t *picture =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, gdk_texture_get_width (texture),
                                gdk_texture_get_height (texture));
  gdk_texture_download (texture, cairo_image_surface_get_data (picture),
                        (gsize) cairo_image_surface_get_stride (picture));
  cairo_surface_mark_dirty (picture);
  return picture;
}

void
driver_screenshot (GtkWidget *widget, const char *name)
{
  const char *folder = g_getenv ("QUOIN_SCREENSHOTS");
  if (folder == NULL)
    return;
  g_autoptr (GdkTexture) texture =
    take_texture (GTK_WIDGET (gtk_widget_get_root (widget)));
  g_autofree char *file = g_strdup_printf ("%s.png", name);
  g_autofree char *path = g_build_filename (folder, file, NULL);
  g_mkdir_with_parents (folder, 0755);
  g_assert_true (gdk_texture_save_to_png (texture, path));
}
