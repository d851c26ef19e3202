/* Does at random what users do, valid or not: actions, keys, pointer, buttons, lists, dialogs,
 * windows, while analyses run. Nothing may crash, warn, or outlive its window. What it does is told
 * with the seed that leads there again, as far as analyses in threads and the server keep time:
 * test-app-monkey --seed R02S… */
#include "driver.h"

#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#define MOST_WINDOWS 3
#define MOST_DIALOGS 3

#define HEADER_PX 60

/* With QUOIN_MONKEY_STEADY nothing depends on time: only actions, windows and the answers to dialogs,
 * each once the analyses before it have ended. */
static gboolean
is_steady (void)
{
  return g_getenv ("QUOIN_MONKEY_STEADY") != NULL;
}

/* How many things are done: QUOIN_MONKEY, or by itself enough for every kind many times. */
#define USUAL_COUNT 1500

typedef struct Monkey {
  char *folder;         /* with copies of examples, which may be overwritten */
  GPtrArray *projects;  /* their paths */
  GPtrArray *windows;   /* DriverParts of every window that there was */
  GOutputStream *tools; /* standard input of xdotool */
} Monkey;

static const char *
one_of (const char *const *words, guint count)
{
  return words[g_test_rand_int_range (0, (int) count)];
}

#define ONE_OF(words) one_of (words, G_N_ELEMENTS (words))

/* Lets everything happen that is due, without waiting for more. */
static void
settle (void)
{
  gdk_display_sync (gdk_display_get_default ());
  for (int i = 0; i < 200 && g_main_context_iteration (NULL, FALSE); i++)
    ;
}

/* ---- windows ---- */

static QnWindow *
any_window (void)
{
  GList *windows = gtk_application_get_windows (driver_application ());
  g_autoptr (GPtrArray) ours = g_ptr_array_new ();
  for (GList *l = windows; l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data))
      g_ptr_array_add (ours, l->data);
  QnWindow *window =
    ours->len > 0 ? ours->pdata[g_test_rand_int_range (0, (int) ours->len)] : NULL;
  return window;
}

/* Windows and dialogs on the screen; free the array. */
static GPtrArray *
shown_toplevels (gboolean dialogs)
{
  GPtrArray *found = g_ptr_array_new ();
  GListModel *toplevels = gtk_window_get_toplevels ();
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    if (gtk_widget_get_mapped (toplevel) && QN_IS_WINDOW (toplevel) != dialogs)
      g_ptr_array_add (found, toplevel);
  }
  return found;
}

/* Choosers of files and printers are GTK's own, which does not survive this itself: what would open
 * one does nothing here. */
static void
spare_choosers (GtkWidget *widget)
{
  static const char *const actions[] = { "open",          "import",         "picture",
                                         "save",          "save-as",        "open-result",
                                         "export-result", "export-drawing", "shortcuts" };
  for (gsize i = 0; QN_IS_WINDOW (widget) && i < G_N_ELEMENTS (actions); i++) {
    g_autoptr (GSimpleAction) idle = g_simple_action_new (
      actions[i],
      g_str_equal (actions[i], "export-result") ? G_VARIANT_TYPE_STRING : NULL);
    g_action_map_add_action (G_ACTION_MAP (widget), G_ACTION (idle));
  }
  const char *label =
    GTK_IS_BUTTON (widget) ? gtk_button_get_label (GTK_BUTTON (widget)) : NULL;
  const char *tooltip = gtk_widget_get_tooltip_text (widget);
  if (GTK_IS_BUTTON (widget)
      && ((label != NULL
           && (g_str_has_suffix (label, "…") || g_str_equal (label, "_Save")))
          || (tooltip != NULL && g_str_has_suffix (tooltip, "…"))))
    gtk_widget_set_sensitive (widget, FALSE);
}

static void
spare_choosers_below (GtkWidget *widget)
{
  spare_choosers (widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    spare_choosers_below (child);
}

/* Remembers windows that have come by themselves too, by files opened into new ones. */
static void
watch_windows (Monkey *monkey)
{
  g_autoptr (GPtrArray) dialogs = shown_toplevels (TRUE);
  for (guint i = 0; i < dialogs->len; i++)
    spare_choosers_below (dialogs->pdata[i]);
  g_autoptr (GPtrArray) windows = shown_toplevels (FALSE);
  for (guint i = 0; i < windows->len; i++) {
    QnWindow *window = windows->pdata[i];
    if (g_object_get_data (G_OBJECT (window), "monkey") != NULL)
      continue;
    spare_choosers_below (GTK_WIDGET (window));
    g_object_set_data (G_OBJECT (window), "monkey", GINT_TO_POINTER (1));
    g_ptr_array_add (monkey->windows, driver_watch_parts (window));
  }
}

static void
open_window (Monkey *monkey)
{
  QnWindow *window = qn_window_new (driver_application ());
  gtk_window_set_default_size (GTK_WINDOW (window), 1100, 760);
  gtk_window_present (GTK_WINDOW (window));
  if (g_test_rand_bit ())
    qn_window_open_path (
      window,
      monkey->projects->pdata[g_test_rand_int_range (0, (int) monkey->projects->len)]);
}

static gboolean
is_destructive (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return gtk_widget_has_css_class (widget, "destructive-action");
}

/* As the user answers who does not want to keep anything, or changes his mind. */
static void
answer (GtkWidget *dialog)
{
  GtkWidget *discard = g_str_equal (gtk_widget_get_name (dialog), "question")
                         ? driver_find_widget (dialog, is_destructive, NULL)
                         : NULL;
  if (discard != NULL && g_test_rand_bit ())
    g_signal_emit_by_name (discard, "clicked");
  else if (GTK_IS_DIALOG (dialog))
    gtk_dialog_response (GTK_DIALOG (dialog), GTK_RESPONSE_CANCEL);
  else
    gtk_window_close (GTK_WINDOW (dialog));
}

static void
close_something (void)
{
  g_autoptr (GPtrArray) dialogs = shown_toplevels (TRUE);
  if (dialogs->len > 0)
    answer (dialogs->pdata[dialogs->len - 1]);
  else if (g_test_rand_int_range (0, 3) == 0) {
    QnWindow *window = any_window ();
    if (window != NULL)
      gtk_window_close (GTK_WINDOW (window));
  }
}

/* ---- actions ---- */

/* A parameter of the type that an action takes, sometimes one that means something. */
static GVariant *
make_parameter (Monkey *monkey, const GVariantType *type)
{
  static const char *const words[] = {
    "model",      "contacts",
    "deformed",   "mechanism",
    "forces",     "diagrams",
    "wall",       "opening",
    "arch",       "select",
    "force",      "measure",
    "course",     "law",
    "line",       "direction",
    "vertical",   "horizontal",
    "M",          "V",
    "N",          "loaded",
    "dead",       "associative",
    "animation",  "non-associative",
    "result",     "analysis",
    "properties", "findings",
    "left",       "gaps-x",
    "fixed",      "free",
    "stress",     "displacement",
    "nonsense",   "",
  };
  double number = g_test_rand_double_range (-2.0, 2.0);
  if (g_variant_type_equal (type, G_VARIANT_TYPE_STRING))
    return g_variant_new_string (ONE_OF (words));
  if (g_variant_type_equal (type, G_VARIANT_TYPE_DOUBLE))
    return g_variant_new_double (90.0 * number);
  if (g_variant_type_equal (type, G_VARIANT_TYPE_INT32))
    return g_variant_new_int32 (g_test_rand_int_range (-1, 20));
  if (g_variant_type_equal (type, G_VARIANT_TYPE ("(dd)")))
    return g_variant_new ("(dd)", number, -number);
  if (g_variant_type_equal (type, G_VARIANT_TYPE ("(iddd)")))
    return g_variant_new ("(iddd)", g_test_rand_int_range (-1, 4), number, number,
                          g_test_rand_bit () ? 0.0 : number);
  if (g_variant_type_equal (type, G_VARIANT_TYPE ("(bi)")))
    return g_variant_new ("(bi)", g_test_rand_bit (), g_test_rand_int_range (-1, 3));
  if (g_variant_type_equal (type, G_VARIANT_TYPE ("(sd)"))) {
    static const char *const numbers[] = { "laws[0].friction", "laws[0].kn", "nonsense" };
    return g_variant_new ("(sd)", ONE_OF (numbers), number);
  }
  if (g_variant_type_equal (type, G_VARIANT_TYPE ("ad"))) {
    const double way[] = { number, 1.0, -number, 1.0 };
    return g_variant_new_fixed_array (G_VARIANT_TYPE_DOUBLE, way, G_N_ELEMENTS (way),
                                      sizeof *way);
  }
  g_assert_true (g_variant_type_equal (type, G_VARIANT_TYPE ("(ss)")));
  g_autofree char *path = g_build_filename (monkey->folder, "out.csv", NULL);
  return g_variant_new ("(ss)", ONE_OF (words), path);
}

/* Files are named by a path of the folder alone. */
static GVariant *
make_path (Monkey *monkey, const char *action)
{
  if (g_str_equal (action, "save-path")) {
    g_autofree char *path = g_build_filename (monkey->folder, "saved.quoin", NULL);
    return g_variant_new_string (path);
  }
  return g_variant_new_string (
    monkey->projects->pdata[g_test_rand_int_range (0, (int) monkey->projects->len)]);
}

static void
do_action (Monkey *monkey)
{
  QnWindow *window = any_window ();
  if (window == NULL)
    return;
  g_auto (GStrv) names = g_action_group_list_actions (G_ACTION_GROUP (window));
  const char *name = names[g_test_rand_int_range (0, (int) g_strv_length (names))];
  const GVariantType *type =
    g_action_group_get_action_parameter_type (G_ACTION_GROUP (window), name);
  g_autoptr (GVariant) parameter =
    type == NULL ? NULL
    : g_str_has_suffix (name, "path")
        && g_variant_type_equal (type, G_VARIANT_TYPE_STRING)
      ? g_variant_ref_sink (make_path (monkey, name))
      : g_variant_ref_sink (make_parameter (monkey, type));
  g_autofree char *told =
    parameter != NULL ? g_variant_print (parameter, FALSE) : g_strdup ("");
  g_test_message ("action %s %s", name, told);
  g_action_group_activate_action (G_ACTION_GROUP (window), name, parameter);
}

/* ---- widgets ---- */

/* What is scrolled out of the window cannot be reached; a menu there would open off the screen. */
static gboolean
is_in_view (GtkWidget *widget)
{
  GtkWidget *root = GTK_WIDGET (gtk_widget_get_root (widget));
  double x, y;
  return gtk_widget_translate_coordinates (widget, root,
                                           0.5 * gtk_widget_get_width (widget),
                                           0.5 * gtk_widget_get_height (widget), &x, &y)
         && x >= 0 && y >= 0 && x < gtk_widget_get_width (root)
         && y < gtk_widget_get_height (root);
}

static void
collect_usable (GtkWidget *widget, GPtrArray *found)
{
  if (!gtk_widget_get_mapped (widget) || !gtk_widget_get_sensitive (widget))
    return;
  gboolean usable = GTK_IS_BUTTON (widget) || GTK_IS_CHECK_BUTTON (widget)
                    || GTK_IS_DROP_DOWN (widget) || GTK_IS_LIST_BOX (widget)
                    || GTK_IS_EXPANDER (widget) || GTK_IS_ENTRY (widget)
                    || GTK_IS_RANGE (widget) || GTK_IS_SWITCH (widget);
  if (usable && is_in_view (widget))
    g_ptr_array_add (found, widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    collect_usable (child, found);
}

static void
use (GtkWidget *widget)
{
  static const char *const texts[] = { "0",     "1",   "0.35", "-2",       "1e9",
                                       "12 kN", "abc", "",     "0,1; 0,5", "nan" };
  if (GTK_IS_BUTTON (widget))
    g_signal_emit_by_name (widget, "clicked");
  else if (GTK_IS_CHECK_BUTTON (widget))
    gtk_check_button_set_active (GTK_CHECK_BUTTON (widget), g_test_rand_bit ());
  else if (GTK_IS_SWITCH (widget))
    gtk_switch_set_active (GTK_SWITCH (widget), g_test_rand_bit ());
  else if (GTK_IS_DROP_DOWN (widget)) {
    GListModel *items = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
    guint count = items != NULL ? g_list_model_get_n_items (items) : 0;
    if (count > 0)
      gtk_drop_down_set_selected (GTK_DROP_DOWN (widget),
                                  (guint) g_test_rand_int_range (0, (int) count));
  } else if (GTK_IS_LIST_BOX (widget))
    gtk_list_box_select_row (GTK_LIST_BOX (widget),
                             gtk_list_box_get_row_at_index (
                               GTK_LIST_BOX (widget), g_test_rand_int_range (0, 4)));
  else if (GTK_IS_EXPANDER (widget))
    gtk_expander_set_expanded (GTK_EXPANDER (widget), g_test_rand_bit ());
  else if (GTK_IS_RANGE (widget))
    gtk_range_set_value (GTK_RANGE (widget), g_test_rand_double_range (0.0, 100.0));
  else {
    gtk_editable_set_text (GTK_EDITABLE (widget), ONE_OF (texts));
    if (g_test_rand_bit ())
      g_signal_emit_by_name (widget, "activate");
    else
      gtk_widget_grab_focus (widget);
  }
}

static void
use_widget (void)
{
  g_autoptr (GPtrArray) found = g_ptr_array_new ();
  g_autoptr (GPtrArray) dialogs = shown_toplevels (TRUE);
  g_autoptr (GPtrArray) windows = shown_toplevels (FALSE);
  GPtrArray *from = dialogs->len > 0 ? dialogs : windows;
  if (from->len == 0)
    return;
  collect_usable (from->pdata[g_test_rand_int_range (0, (int) from->len)], found);
  if (found->len == 0)
    return;
  GtkWidget *widget = found->pdata[g_test_rand_int_range (0, (int) found->len)];
  g_test_message ("%s %s", G_OBJECT_TYPE_NAME (widget),
                  GTK_IS_BUTTON (widget) && gtk_button_get_label (GTK_BUTTON (widget))
                    ? gtk_button_get_label (GTK_BUTTON (widget))
                    : "");

  g_object_ref (widget);
  use (widget);
  g_object_unref (widget);
}

/* ---- pointer and keys ---- */

static void
tell_tools (Monkey *monkey, const char *text)
{
  g_autofree char *told = g_strdup (text);
  g_test_message ("%s", g_strchomp (told));
  g_assert_true (
    g_output_stream_write_all (monkey->tools, text, strlen (text), NULL, NULL, NULL));
  g_usleep (3000); /* for the server, to which xdotool speaks by itself */
}

static void
press_key (Monkey *monkey)
{
  static const char *const keys[] = {
    "v",         "w",      "o",      "a",      "c",         "r",      "p",      "b",
    "x",         "t",      "y",      "l",      "s",         "f",      "m",      "i",
    "j",         "1",      "2",      "period", "semicolon", "comma",  "minus",  "space",
    "Return",    "Escape", "Tab",    "Left",   "Right",     "Up",     "Down",   "Delete",
    "BackSpace", "ctrl+z", "ctrl+y", "ctrl+a", "ctrl+c",    "ctrl+x", "ctrl+v", "ctrl+d",
    "ctrl+0",    "ctrl+1", "ctrl+2", "ctrl+3", "ctrl+4",    "ctrl+5", "ctrl+6", "F5",
    "shift+F5",  "F10",    "Menu",   "F9",     "shift+F10", "ctrl+w", "ctrl+e", "ctrl+n",
  };
  g_autofree char *line = g_strdup_printf ("key %s\n", ONE_OF (keys));
  tell_tools (monkey, line);
}

static void
move_pointer (Monkey *monkey)
{
  static const char *const verbs[] = { "",          "mousedown 1\n", "mouseup 1\n",
                                       "click 1\n", "click 4\n",     "click 5\n",
                                       "click 3\n" };
  /* Below the header bar, by which windows would be pulled off the screen, where GTK cannot open
   * any menu. */
  g_autofree char *line =
    g_strdup_printf ("mousemove %d %d\n%s", g_test_rand_int_range (0, 1100),
                     g_test_rand_int_range (HEADER_PX, 760), ONE_OF (verbs));
  tell_tools (monkey, line);
}

/* ---- the test ---- */

static gboolean
any_job (void)
{
  for (GList *l = gtk_application_get_windows (driver_application ()); l != NULL;
       l = l->next)
    if (QN_IS_WINDOW (l->data) && qn_window_get_document (l->data)->job != NULL)
      return TRUE;
  return FALSE;
}

static void
await_jobs (void)
{
  while (any_job ())
    g_main_context_iteration (NULL, TRUE);
}

static void
monkey_init (Monkey *monkey)
{
  static const char *const names[] = { "06-arch.quoin",
                                       "09-reinforced-cantilever.quoin",
                                       "16-load-stages.quoin",
                                       "19-settling-wall.quoin",
                                       "34-frame-hybrid.quoin",
                                       "36-mast-on-block.quoin",
                                       "ferris-tin-loi/wall3.quoin" };
  monkey->folder = g_dir_make_tmp ("quoin-monkey-XXXXXX", NULL);
  g_assert_cmpint (g_chdir (monkey->folder), ==, 0);
  monkey->projects = g_ptr_array_new_with_free_func (g_free);
  monkey->windows = g_ptr_array_new ();
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autofree char *from = driver_example_path (names[i]);
    g_autofree char *base = g_path_get_basename (from);
    g_autofree char *to = g_build_filename (monkey->folder, base, NULL);
    g_autofree char *text = NULL;
    g_assert_true (g_file_get_contents (from, &text, NULL, NULL));
    g_assert_true (g_file_set_contents (to, text, -1, NULL));
    g_ptr_array_add (monkey->projects, g_steal_pointer (&to));
  }
  /* The start page shows them, too. */
  g_setenv ("QUOIN_EXAMPLES", monkey->folder, TRUE);
  g_autoptr (GSubprocess) tools =
    g_subprocess_new (G_SUBPROCESS_FLAGS_STDIN_PIPE, NULL, "xdotool", "-", NULL);
  g_assert_nonnull (tools);
  monkey->tools = g_object_ref (g_subprocess_get_stdin_pipe (tools));
}

static void
close_all (Monkey *monkey)
{
  tell_tools (monkey, "mouseup 1\n");
  for (int i = 0; i < 50; i++) {
    g_autoptr (GPtrArray) dialogs = shown_toplevels (TRUE);
    for (guint k = 0; k < dialogs->len; k++)
      answer (dialogs->pdata[k]);
    settle ();
    if (dialogs->len == 0)
      break;
  }
  QnWindow *window;
  while ((window = any_window ()) != NULL) {
    gtk_window_destroy (GTK_WINDOW (window));
    settle ();
  }
  for (guint i = 0; i < monkey->windows->len; i++)
    driver_wait_until_gone (monkey->windows->pdata[i]);
  g_clear_object (&monkey->tools);
  const char *argv[] = { "rm", "-r", monkey->folder, NULL };
  g_assert_cmpint (g_chdir ("/"), ==, 0);
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_SEARCH_PATH, NULL,
                               NULL, NULL, NULL, NULL, NULL));
  g_ptr_array_unref (monkey->projects);
  g_ptr_array_unref (monkey->windows);
  g_free (monkey->folder);
}

static void
test_monkey (void)
{
  Monkey monkey = { 0 };
  const char *given = g_getenv ("QUOIN_MONKEY");
  int count = given != NULL ? atoi (given) : USUAL_COUNT;
  monkey_init (&monkey);
  g_application_hold (G_APPLICATION (driver_application ()));
  driver_pass_over_gtk ();
  for (int i = 0; i < count; i++) {
    g_autoptr (GPtrArray) windows = shown_toplevels (FALSE);
    g_autoptr (GPtrArray) dialogs = shown_toplevels (TRUE);
    int what = g_test_rand_int_range (0, 100);
    if (windows->len == 0)
      open_window (&monkey);
    else if (dialogs->len > MOST_DIALOGS || (dialogs->len > 0 && what < 25))
      close_something ();
    else if (windows->len > MOST_WINDOWS)
      gtk_window_destroy (windows->pdata[0]);
    else if (what < 3)
      close_something ();
    else if (what < 5)
      open_window (&monkey);
    else if (what < 35 || is_steady ())
      do_action (&monkey);
    else if (what < 60)
      use_widget ();
    else if (what < 80)
      press_key (&monkey);
    else
      move_pointer (&monkey);
    if (is_steady ())
      await_jobs ();
    settle ();
    watch_windows (&monkey);
  }
  close_all (&monkey);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  gtk_init ();
  g_test_add_func ("/app/monkey", test_monkey);
  return g_test_run ();
}
