#include "driver.h"

#include "app/canvas/canvas-private.h"
#include "app/tools/tools.h"
#include "app/widgets/settings.h"
#include "app/window/action-table.h"
#include "doc/long-analysis.h"
#include "doc/view/figures.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <dlfcn.h>
#include <glib/gstdio.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static gsize
free_blocks (const QnModel *model)
{
  gsize count = 0;
  for (gsize i = 0; i < model->block_count; i++)
    count += model->blocks[i].wall == QN_NONE && model->blocks[i].masonry == QN_NONE;
  return count;
}

static void
test_start (void)
{
  gint64 before = g_get_monotonic_time ();
  QnWindow *window = driver_open_window (1280, 800);
  g_test_message ("window on the screen after %.2f s",
                  1e-6 * (double) (g_get_monotonic_time () - before));
  g_assert_true (qn_window_is_blank (window));
  driver_screenshot (GTK_WIDGET (window), "start");
  driver_discard (window);
}

/* Seconds of processor time that a process has taken. */
static double
processor_seconds (GPid pid)
{
  g_autofree char *path = g_strdup_printf ("/proc/%d/stat", (int) pid);
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  /* Behind the name in brackets: user and system time are the 12th and 13th field. */
  g_auto (GStrv) fields = g_strsplit (strrchr (text, ')') + 2, " ", 15);
  double ticks = g_ascii_strtod (fields[11], NULL) + g_ascii_strtod (fields[12], NULL);
  return ticks / (double) sysconf (_SC_CLK_TCK);
}

/* The program itself, from nothing to a window: a second on a machine that does nothing else, so
 * processor time is judged; that of a sanitizer is none of the program's. */
static void
test_startup (void)
{
  const char *argv[] = { g_getenv ("QUOIN_WINDOW"), NULL };
  const char *search[] = { "xdotool", "search", "--sync", "--onlyvisible",
                           "--class", "quoin",  NULL };
  GPid pid;
  int status = -1;
  gint64 before = g_get_monotonic_time ();
  g_assert_true (g_spawn_async (NULL, (char **) argv, NULL, G_SPAWN_DO_NOT_REAP_CHILD,
                                NULL, NULL, &pid, NULL));
  g_assert_true (g_spawn_sync (NULL, (char **) search, NULL,
                               G_SPAWN_SEARCH_PATH | G_SPAWN_STDOUT_TO_DEV_NULL, NULL,
                               NULL, NULL, NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  double seconds = processor_seconds (pid);
  g_test_message ("shown after %.2f s, of them %.2f s of processor time",
                  1e-6 * (double) (g_get_monotonic_time () - before), seconds);
  kill (pid, SIGTERM);
  g_spawn_close_pid (pid);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  g_assert_cmpfloat (seconds, <, 1.0);
#endif
}

/* A copy of the program in a build tree of its own, with nothing installed. */
typedef struct Copy {
  char *root, *folder, *data, *program;
} Copy;

static void
copy_init (Copy *copy)
{
  copy->root = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  copy->folder = g_build_filename (copy->root, "src", "app", NULL);
  copy->data = g_build_filename (copy->root, "data", NULL);
  copy->program = g_build_filename (copy->folder, "quoin", NULL);
  g_assert_cmpint (g_mkdir_with_parents (copy->folder, 0755), ==, 0);
  g_assert_cmpint (g_mkdir_with_parents (copy->data, 0755), ==, 0);
  const char *argv[] = { "cp", g_getenv ("QUOIN_WINDOW"), copy->program, NULL };
  int status = -1;
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_SEARCH_PATH, NULL,
                               NULL, NULL, NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  g_autofree char *mark = g_build_filename (copy->data, "examples.path", NULL);
  g_assert_true (g_file_set_contents (mark, "/nowhere", -1, NULL));
}

static void
copy_clear (Copy *copy)
{
  const char *argv[] = { "rm", "-r", copy->root, NULL };
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_SEARCH_PATH, NULL,
                               NULL, NULL, NULL, NULL, NULL));
  g_free (copy->root);
  g_free (copy->folder);
  g_free (copy->data);
  g_free (copy->program);
}

/* Starts it with the machine's data or with none, with folders of the user's or without any; what it
 * said on standard error, and how it ended, where it did so by itself. */
typedef enum Place { PLACE_USUAL, PLACE_BARE, PLACE_HOMELESS } Place;

static char *
copy_start (const Copy *copy, Place place, int *status)
{
  static const char *const own[] = { "HOME",           "XDG_CONFIG_HOME",
                                     "XDG_DATA_HOME",  "XDG_STATE_HOME",
                                     "XDG_CACHE_HOME", "XDG_RUNTIME_DIR" };
  const char *argv[] = { "timeout", "3", copy->program, NULL };
  g_auto (GStrv) environment = g_get_environ ();
  if (place == PLACE_BARE)
    environment = g_environ_setenv (environment, "XDG_DATA_DIRS", "/nonexistent", TRUE);
  if (place == PLACE_HOMELESS)
    environment = g_environ_unsetenv (
      g_environ_unsetenv (environment, "GSETTINGS_BACKEND"), "G_DEBUG");
  for (gsize i = 0; place == PLACE_HOMELESS && i < G_N_ELEMENTS (own); i++)
    environment = g_environ_setenv (environment, own[i], "/proc/nonexistent", TRUE);
#ifdef __SANITIZE_ADDRESS__
  /* LLVM stays loaded, as in the tests themselves: see driver.c. */
  g_autofree char *options = g_strconcat (g_environ_getenv (environment, "ASAN_OPTIONS"),
                                          ":verify_asan_link_order=0", NULL);
  environment = g_environ_setenv (environment, "ASAN_OPTIONS", options, TRUE);
  environment = g_environ_setenv (environment, "LD_PRELOAD", "libOSMesa.so.8", TRUE);
#endif
  char *said = NULL;
  g_assert_true (g_spawn_sync (NULL, (char **) argv, environment, G_SPAWN_SEARCH_PATH,
                               NULL, NULL, NULL, &said, status, NULL));
  return said;
}

/* Without its settings schema the program says so and ends; the build tree's serves as well as an
 * installed one. It needs no folder that can be written. */
static void
test_uninstalled (void)
{
  Copy copy;
  int status = -1;
  copy_init (&copy);
  g_autofree char *missing = copy_start (&copy, PLACE_BARE, &status);
  g_assert_true (WIFEXITED (status));
  g_assert_cmpint (WEXITSTATUS (status), ==, EXIT_FAILURE);
  g_assert_nonnull (strstr (missing, "the settings schema"));

  g_autofree char *schema = g_build_filename (g_getenv ("QUOIN_WINDOW"), "..", "..", "..",
                                              "data", "gschemas.compiled", NULL);
  g_autofree char *real = g_canonicalize_filename (schema, NULL);
  const char *argv[] = { "cp", real, copy.data, NULL };
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_SEARCH_PATH, NULL,
                               NULL, NULL, NULL, NULL, NULL));
  g_autofree char *silent = copy_start (&copy, PLACE_USUAL, &status);
  g_assert_cmpstr (silent, ==, "");
  g_assert_cmpint (WEXITSTATUS (status), ==, 124); /* ended by timeout, not by itself */
  /* Libraries tell once what they cannot keep; settings would tell at every reading. */
  g_autofree char *told = copy_start (&copy, PLACE_HOMELESS, &status);
  g_assert_null (strstr (told, "dconf"));
  g_assert_cmpint (WEXITSTATUS (status), ==, 124);
  copy_clear (&copy);
}

/* Every example opens, without complaint, and shows all of its blocks. */
static void
test_examples (void)
{
  static const char *const names[] = {
    "01-sliding-block.quoin",
    "02-overturning-block.quoin",
    "03-rounded-block.quoin",
    "04-block-on-slope.quoin",
    "05-stack.quoin",
    "06-arch.quoin",
    "ferris-tin-loi/wall1.quoin",
    "ferris-tin-loi/wall2.quoin",
    "ferris-tin-loi/wall3.quoin",
    "ferris-tin-loi/wall4.quoin",
    "ferris-tin-loi/wall5.quoin",
    "ferris-tin-loi/wall6.quoin",
  };
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    QnWindow *window = driver_open_example (names[i]);
    g_assert_cmpuint (model_of (window)->block_count, >, 0);
    g_assert_cmpuint (qn_window_get_document (window)->contacts.face_count, >, 0);
    g_assert_false (qn_document_is_modified (qn_window_get_document (window)));
    driver_activate (window, "win.view::contacts");
    if (i == 8)
      driver_screenshot (GTK_WIDGET (window), "contacts");
    driver_discard (window);
  }
}

/* The name of an action without its target. */
static char *
dup_plain_name (const char *detailed)
{
  g_autofree char *name = NULL;
  g_autoptr (GVariant) target = NULL;
  g_assert_true (g_action_parse_detailed_name (detailed, &name, &target, NULL));
  return g_steal_pointer (&name);
}

static gsize
count_shortcuts (GtkWidget *widget)
{
  gsize count = gtk_widget_has_css_class (widget, "keycap")
                && gtk_widget_get_prev_sibling (widget) == NULL;
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    count += count_shortcuts (child);
  return count;
}

/* The table of keys names actions that there are, each key once, and shows in tooltips. */
static void
test_actions (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  GActionGroup *groups[] = { G_ACTION_GROUP (driver_application ()),
                             G_ACTION_GROUP (window) };
  g_autoptr (GHashTable) keys =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  for (gsize i = 0; i < qn_action_row_count; i++) {
    const QnActionRow *row = &qn_action_rows[i];
    g_assert_cmpint (row->group != QN_GROUP_NONE, ==, row->label != NULL);
    if (row->name == NULL)
      continue;
    g_autofree char *name = dup_plain_name (row->name);
    gboolean window_action = g_str_has_prefix (name, "win.");
    g_assert_true (g_action_group_has_action (groups[window_action], name + 4));
    g_auto (GStrv) each = g_strsplit (row->keys, " ", -1);
    for (char **key = each; *key != NULL; key++) {
      guint keyval = 0;
      GdkModifierType modifiers = 0;
      g_assert_true (gtk_accelerator_parse (*key, &keyval, &modifiers));
      g_assert_true (g_hash_table_add (keys, g_strdup (*key)));
    }
  }
  g_autofree char *tooltip = qn_action_dup_tooltip ("Save", "win.save");
  g_assert_cmpstr (tooltip, ==, "Save (Ctrl+S)");
  g_autofree char *none = qn_action_dup_tooltip ("Compare", "win.compare");
  g_assert_cmpstr (none, ==, "Compare");
  driver_activate (window, "win.shortcuts");
  GtkWidget *shortcuts = driver_find_dialog ("Keyboard shortcuts");
  g_assert_nonnull (shortcuts);
  driver_screenshot (shortcuts, "shortcuts");
  gsize rows = 0;
  for (gsize i = 0; i < qn_action_row_count; i++)
    rows += qn_action_rows[i].label != NULL;
  for (int i = 0; qn_tools[i] != NULL; i++)
    rows++;
  g_assert_cmpuint (count_shortcuts (shortcuts), ==, rows);
  driver_discard (window);
}

/* What is typed is searched in words and keys; Escape takes it back, then closes. */
static void
test_search_shortcuts (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  driver_activate (window, "win.shortcuts");
  GtkWidget *shortcuts = driver_find_dialog ("Keyboard shortcuts");
  driver_type ("solve");
  g_assert_nonnull (driver_find_widget (shortcuts, driver_says, "Solve, or run"));
  g_assert_null (driver_find_widget (shortcuts, driver_says, "Files"));
  driver_key ("Escape");
  g_assert_nonnull (driver_find_widget (shortcuts, driver_says, "Files"));
  driver_type ("ctrl+z");
  g_assert_nonnull (driver_find_widget (shortcuts, driver_says, "Redo"));
  g_assert_null (driver_find_widget (shortcuts, driver_says, "Save"));
  driver_type ("zz");
  g_assert_nonnull (driver_find_widget (shortcuts, driver_says, "No shortcut has"));
  driver_key ("Tab");
  driver_key ("Escape");
  g_assert_null (driver_find_widget (shortcuts, driver_says, "No shortcut has"));
  driver_key ("Escape");
  g_assert_null (driver_find_dialog ("Keyboard shortcuts"));
  driver_discard (window);
}

/* A wall and an opening drawn with the pointer, a block typed, all of it undone. */
static void
test_draw (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *empty = g_strdup (document->text->text);
  driver_activate (window, "win.draw");
  driver_drag (window, 0.5, 0.5, 2.5, 2.25);
  const QnModel *model = model_of (window);
  /* Ten courses of five blocks, or of six with halves at the ends, on a base. */
  g_assert_cmpuint (model->block_count, ==, 5 * 5 + 5 * 6 + 1);
  g_assert_cmpint (qn_model_find_block (model, "w1.base"), !=, QN_NONE);
  g_assert_cmpuint (free_blocks (model), ==, 0);
  gsize full = model->block_count;

  driver_key ("o");
  driver_drag (window, 1.1, 1.0, 1.9, 1.7);
  g_assert_cmpuint (model_of (window)->block_count, <, full);
  driver_screenshot (GTK_WIDGET (window), "drawn");

  driver_key ("r");
  driver_click (window, 3.2, 0.5);
  driver_type ("0,4; 0.8");
  driver_key ("Return");
  model = model_of (window);
  g_assert_cmpuint (free_blocks (model), ==, 1);
  double area = 0.0;
  for (gsize i = 0; i < model->block_count; i++) {
    if (model->blocks[i].masonry == QN_NONE)
      area = model->blocks[i].area;
  }
  g_assert_cmpfloat_with_epsilon (area, 0.32, 1e-9);

  while (document->history->position > 0)
    driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, empty);
  g_assert_cmpuint (model_of (window)->block_count, ==, 0);
  while (document->history->position < document->history->steps->len)
    driver_activate (window, "win.redo");
  g_assert_cmpuint (free_blocks (model_of (window)), ==, 1);
  driver_discard (window);
}

/* Select, move with the pointer and the keys, copy, mirror, delete. */
static void
test_edit (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  QnSelection *selection = document->selection;
  gsize count = model_of (window)->block_count;
  QnId top = 0;
  for (QnId i = 0; i < (QnId) count; i++) {
    if (!model_of (window)->blocks[i].support[0])
      top = i;
  }
  QnVec2 c = model_of (window)->blocks[top].centroid;
  driver_click (window, c.x, c.y);
  g_assert_true (qn_selection_has (selection, QN_PICK_BLOCK, top));
  driver_key ("Right");
  g_assert_cmpfloat (model_of (window)->blocks[top].centroid.x, >, c.x);
  driver_key ("Right");
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  driver_activate (window, "win.undo");
  g_assert_cmpfloat (model_of (window)->blocks[top].centroid.x, ==, c.x);

  driver_drag (window, c.x, c.y, c.x, c.y + 0.8);
  g_assert_cmpfloat (model_of (window)->blocks[top].centroid.y, >, c.y + 0.5);
  driver_activate (window, "win.duplicate");
  g_assert_cmpuint (model_of (window)->block_count, ==, count + 1);
  driver_activate (window, "win.mirror::vertical");
  driver_activate (window, "win.rotate(90.0)");
  driver_screenshot (GTK_WIDGET (window), "edited");
  driver_key ("Delete");
  g_assert_cmpuint (model_of (window)->block_count, ==, count);
  driver_discard (window);
}

static void
test_solve (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_key ("F5");
  driver_wait_for_job (window);
  QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (fabs (run->result.collapse_multiplier - 0.356), <, 0.01 * 0.356);
  g_assert_cmpint (state_of (window)->options.view, ==, QN_VIEW_MECHANISM);
  driver_screenshot (GTK_WIDGET (window), "mechanism");
  driver_activate (window, "win.view::forces");
  driver_screenshot (GTK_WIDGET (window), "forces");
  driver_activate (window, "win.view::deformed");
  driver_activate (window, "win.previous-step");
  g_assert_cmpint (qn_view_state_get_step (state_of (window)), ==,
                   (int) run->result.step_count - 2);
  driver_screenshot (GTK_WIDGET (window), "deformed");

  /* An edit makes the result outdated, undoing it makes it current again. */
  g_assert_false (qn_document_is_stale (document, run));
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((0.0,1.0))");
  g_assert_true (qn_document_is_stale (document, run));
  driver_screenshot (GTK_WIDGET (window), "outdated");
  driver_activate (window, "win.undo");
  g_assert_false (qn_document_is_stale (document, run));
  driver_discard (window);
}

static gboolean
exists (gpointer path)
{
  return g_file_test (path, G_FILE_TEST_EXISTS);
}

static gboolean
is_on_its_way (gpointer data)
{
  const QnViewState *state = data;
  const double phase = state->options.phase;
  return phase > 0.0 && phase < 1.0;
}

static void
test_animate (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  QnViewState *state = state_of (window);
  driver_key ("F5");
  driver_wait_for_job (window);
  g_assert_nonnull (qn_window_get_document (window)->run);
  g_assert_cmpfloat (state->options.phase, ==, 1.0);
  driver_set_animated (TRUE);
  driver_activate (window, "win.play");
  driver_wait (is_on_its_way, state);
  driver_activate (window, "win.play");
  driver_set_animated (FALSE);
  double held = state->options.phase;
  driver_settle ();
  g_assert_cmpfloat (state->options.phase, ==, held);
  driver_activate (window, "win.compare");

  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  static const char *const kinds[][2] = { { "animation", "a.gif" },
                                          { "curve", "b.csv" },
                                          { "contacts", "c.csv" },
                                          { "beams", "d.csv" } };
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = g_build_filename (folder, kinds[i][1], NULL);
    g_autofree char *action =
      g_strdup_printf ("win.export-path(('%s', '%s'))", kinds[i][0], path);
    driver_activate (window, action);
    driver_wait (exists, path);
    g_unlink (path);
  }
  g_rmdir (folder);
  driver_discard (window);
}

/* Ends long before the analysis would, keeps what had converged, and leaves the window ready for the next run. */
static void
test_cancel (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall6.quoin");
  QnDocument *document = qn_window_get_document (window);
  long_analysis_ask (document);
  driver_activate (window, "win.run");
  g_assert_nonnull (document->job);
  driver_activate (window, "win.pause");
  g_assert_nonnull (document->job);
  driver_screenshot (GTK_WIDGET (window), "running");
  driver_activate (window, "win.cancel");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_true (run == NULL || run->result.outcome == QN_OUTCOME_CANCELLED);
  g_assert_true (g_action_group_get_action_enabled (G_ACTION_GROUP (window), "run"));
  driver_discard (window);
}

/* The window and the command line write the same bytes. */
static void
test_export (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *model = driver_example_path ("ferris-tin-loi/wall3.quoin");
  g_autoptr (QnRecipe) recipe = qn_recipe_new ("model", QN_VIEW_MODEL);
  static const char *const endings[] = { "png", "svg", "pdf" };
  for (gsize i = 0; i < G_N_ELEMENTS (endings); i++) {
    g_autofree char *ours = g_strdup_printf ("%s/window.%s", folder, endings[i]);
    g_autofree char *theirs = g_strdup_printf ("%s/cli.%s", folder, endings[i]);
    g_autoptr (GError) error = NULL;
    qn_view_state_export_as (state_of (window), recipe, ours, &error);
    g_assert_no_error (error);
    const char *argv[] = {
      g_getenv ("QUOIN_CLI"), "render", model, "--view", "model", "-o", theirs, NULL
    };
    int status = -1;
    g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_DEFAULT, NULL, NULL,
                                 NULL, NULL, &status, &error));
    g_assert_cmpint (status, ==, 0);
    g_autofree char *a = NULL, *b = NULL;
    gsize na = 0, nb = 0;
    g_assert_true (g_file_get_contents (ours, &a, &na, NULL));
    g_assert_true (g_file_get_contents (theirs, &b, &nb, NULL));
    g_assert_cmpmem (a, na, b, nb);
    g_unlink (ours);
    g_unlink (theirs);
  }
  driver_activate (window, "win.export");
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    if (toplevel != GTK_WIDGET (window) && gtk_widget_get_mapped (toplevel))
      driver_screenshot (toplevel, "export-dialog");
  }
  driver_discard (window);
  g_rmdir (folder);
}

static gboolean
window_is_open (QnWindow *window)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    if (toplevel == GTK_WIDGET (window))
      return TRUE;
  }
  return FALSE;
}

static void
test_unsaved (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  g_assert_true (qn_document_is_modified (qn_window_get_document (window)));

  gtk_window_close (GTK_WINDOW (window));
  driver_settle ();
  GtkWidget *dialog = driver_find_message ();
  g_assert_nonnull (dialog);
  driver_screenshot (dialog, "unsaved");
  gtk_window_close (GTK_WINDOW (dialog));
  driver_settle ();
  g_assert_true (window_is_open (window));
  g_assert_null (driver_find_message ());

  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "saved.quoin", NULL);
  g_autofree char *action = g_strdup_printf ("win.save-path::%s", path);
  driver_activate (window, action);
  g_assert_false (qn_document_is_modified (qn_window_get_document (window)));
  driver_activate (window, "win.nudge((1.0,0.0))");
  gtk_window_close (GTK_WINDOW (window));
  driver_settle ();
  driver_press (driver_find_message (), "Discard");
  driver_settle ();
  g_assert_false (window_is_open (window));
  g_unlink (path);
  g_rmdir (folder);
}

/* A file that cannot be read is explained, with its place, and the window stays usable. */
static void
test_bad_file (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "bad.quoin", NULL);
  g_assert_true (g_file_set_contents (path, "{ \"format\": 3", -1, NULL));
  QnWindow *window = driver_open_window (1280, 800);
  g_assert_false (qn_window_open_path (window, path));
  driver_screenshot (GTK_WIDGET (window), "bad-file");
  driver_activate (window, "win.draw");
  driver_drag (window, 0.5, 0.5, 2.5, 2.25);
  g_assert_cmpuint (model_of (window)->block_count, >, 20);
  driver_discard (window);
  g_unlink (path);
  g_rmdir (folder);
}

static gboolean
edit_nudge (QnModel *model, gpointer data, GError **error)
{
  QnId block = 0;
  (void) data;
  return qn_edit_transform_blocks (model, (QnBlockSet){ &block, 1 },
                                   qn_transform_translation (0.0, -0.001), error);
}

/* Ten thousand blocks: what a frame and an edit take is told, not judged, because the machine
 * may be busy. */
static void
test_large_model (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  QnCanvas *canvas = canvas_of (window);
  driver_activate (window, "win.draw");
  g_autoptr (GError) error = NULL;
  gint64 before = g_get_monotonic_time ();
  driver_lay_large_wall (window);
  g_test_message ("wall of %u blocks laid in %.3f s",
                  (guint) model_of (window)->block_count,
                  1e-6 * (double) (g_get_monotonic_time () - before));
  g_assert_cmpuint (model_of (window)->block_count, >=, 10000);
  driver_activate (window, "win.fit");
  driver_screenshot (GTK_WIDGET (window), "large-model");

  before = g_get_monotonic_time ();
  edit_model (document, "Nudge", NULL, edit_nudge, NULL, &error);
  g_assert_no_error (error);
  g_test_message ("one block moved in %.3f s",
                  1e-6 * (double) (g_get_monotonic_time () - before));
  g_assert_true (qn_document_undo (document));

  enum { FRAMES = 20 };
  cairo_surface_t *surface = cairo_image_surface_create (CAIRO_FORMAT_ARGB32, 880, 700);
  for (int zoom = 0; zoom < 2; zoom++) {
    before = g_get_monotonic_time ();
    for (int i = 0; i < FRAMES; i++) {
      QnCamera camera = canvas->camera;
      qn_camera_pan (&camera, qn_vec2 (3.0, 1.0));
      move_camera (canvas, &camera);
      cairo_t *cr = cairo_create (surface);
      qn_canvas_draw (canvas, cr);
      cairo_destroy (cr);
    }
    g_test_message ("a frame takes %.1f ms%s",
                    1e-3 * (double) (g_get_monotonic_time () - before) / FRAMES,
                    zoom == 0 ? " with everything in view" : " close up");
    qn_canvas_zoom (canvas, 12.0);
  }
  cairo_surface_destroy (surface);
  driver_discard (window);
}

static gboolean
is_choice_of_views (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  if (!GTK_IS_DROP_DOWN (widget))
    return FALSE;
  GListModel *names = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
  return g_list_model_get_n_items (names) == QN_VIEW_COUNT;
}

static gboolean
is_refusal (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LABEL (widget)
         && strstr (gtk_label_get_text (GTK_LABEL (widget)), "result") != NULL;
}

/* What cannot be done is refused without harm: an empty clipboard, a panel that is not there. */
static void
test_invalid_actions (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  gsize before = model_of (window)->block_count;
  gdk_clipboard_set_text (gtk_widget_get_clipboard (GTK_WIDGET (window)), "");
  driver_activate (window, "win.paste");
  g_assert_cmpuint (model_of (window)->block_count, ==, before);
  driver_activate (window, "win.show-panel::nonsense");
  driver_discard (window);
}

/* A figure that cannot be drawn is told in the dialog. */
static void
test_figure_without_result (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  driver_activate (window, "win.export");
  GtkWidget *dialog = driver_find_dialog ("Export Figure");
  g_assert_nonnull (dialog);
  GtkWidget *view = driver_find_widget (dialog, is_choice_of_views, NULL);
  g_assert_nonnull (view);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (view), QN_VIEW_FORCES);
  driver_settle ();
  g_assert_nonnull (driver_find_widget (dialog, is_refusal, NULL));
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_discard (window);
}

static void
test_appearance (void)
{
  GSettings *settings = qn_settings_get ();
  g_settings_set_string (settings, "style", "dark");
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall6.quoin");
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  driver_screenshot (GTK_WIDGET (window), "dark");
  driver_open_analysis (window);
  driver_screenshot (GTK_WIDGET (window), "dark-analysis");
  driver_discard (window);
  g_settings_set_string (settings, "style", "light");

  window = driver_open_window (1900, 1040);
  g_autofree char *path = driver_example_path ("ferris-tin-loi/wall4.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.view::contacts");
  qn_selection_set_one (qn_window_get_document (window)->selection, QN_PICK_FACE, 10);
  driver_screenshot (GTK_WIDGET (window), "large");
  g_action_group_activate_action (G_ACTION_GROUP (driver_application ()), "preferences",
                                  NULL);
  g_action_group_activate_action (G_ACTION_GROUP (driver_application ()), "help", NULL);
  driver_settle ();
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    const char *title = gtk_window_get_title (GTK_WINDOW (toplevel));
    if (g_strcmp0 (title, "Preferences") == 0)
      driver_screenshot (toplevel, "preferences");
    else if (g_strcmp0 (title, "Help") == 0)
      driver_screenshot (toplevel, "help");
  }
  driver_discard (window);
}

static void
note_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  (void) source;
  (void) cancellable;
  *(GThread **) data = g_thread_self ();
  g_task_return_boolean (task, TRUE);
}

static GThread *
thread_of_task (gpointer source)
{
  GThread *thread = NULL;
  g_autoptr (GTask) task = g_task_new (source, NULL, NULL, NULL);
  g_task_set_task_data (task, &thread, NULL);
  g_task_run_in_thread (task, note_thread);
  while (!g_task_get_completed (task))
    g_main_context_iteration (NULL, TRUE);
  return thread;
}

/* Icons are loaded by the thread that asks for them, and GTK asks the function that sees to it. */
static void
test_icons (void)
{
  Dl_info program, library, asked;
  GtkIconTheme *theme = gtk_icon_theme_get_for_display (gdk_display_get_default ());
  g_autoptr (GtkIconPaintable) icon = gtk_icon_theme_lookup_icon (
    theme, "document-open-symbolic", NULL, 16, 1, GTK_TEXT_DIR_NONE, 0);
  g_assert_true (thread_of_task (icon) == g_thread_self ());
  g_assert_true (thread_of_task (theme) != g_thread_self ());
  g_assert_true (thread_of_task (NULL) != g_thread_self ());

  g_assert_cmpint (dladdr (dlsym (RTLD_DEFAULT, "g_task_run_in_thread"), &asked), !=, 0);
  g_assert_cmpint (dladdr ((void *) (guintptr) test_icons, &program), !=, 0);
  g_assert_cmpint (dladdr ((void *) (guintptr) g_task_new, &library), !=, 0);
  g_assert_true (asked.dli_fbase == program.dli_fbase);
  g_assert_true (asked.dli_fbase != library.dli_fbase);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/window/start", test_start);
  g_test_add_func ("/app/window/startup", test_startup);
  g_test_add_func ("/app/window/icons", test_icons);
  g_test_add_func ("/app/window/uninstalled", test_uninstalled);
  g_test_add_func ("/app/window/examples", test_examples);
  g_test_add_func ("/app/window/actions", test_actions);
  g_test_add_func ("/app/window/search-shortcuts", test_search_shortcuts);
  g_test_add_func ("/app/window/draw", test_draw);
  g_test_add_func ("/app/window/edit", test_edit);
  g_test_add_func ("/app/window/solve", test_solve);
  g_test_add_func ("/app/window/animate", test_animate);
  g_test_add_func ("/app/window/cancel", test_cancel);
  g_test_add_func ("/app/window/export", test_export);
  g_test_add_func ("/app/window/unsaved", test_unsaved);
  g_test_add_func ("/app/window/bad-file", test_bad_file);
  g_test_add_func ("/app/window/large-model", test_large_model);
  g_test_add_func ("/app/window/invalid-actions", test_invalid_actions);
  g_test_add_func ("/app/window/figure-without-result", test_figure_without_result);
  g_test_add_func ("/app/window/appearance", test_appearance);
}
