/* The forms and dialogs one after the other: whatever a user can press or fill in has a name for
 * screen readers, and an icon says besides what it does. Pictures of all are kept for the eye. */
#include "driver.h"

#include "io/project/typical-joint.h"
#include "support/edit-model.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

/* What GTK makes of its own inside of other widgets, which those name, and its own windows. */
static gboolean
is_inside (GtkWidget *widget)
{
  GtkWidget *parent = gtk_widget_get_parent (widget);
  return parent != NULL
         && (GTK_IS_DROP_DOWN (parent) || GTK_IS_MENU_BUTTON (parent)
             || GTK_IS_WINDOW_CONTROLS (parent) || GTK_IS_SPIN_BUTTON (parent)
             || GTK_IS_SWITCH (parent) || GTK_IS_STACK_SWITCHER (parent)
             || gtk_widget_get_ancestor (widget, GTK_TYPE_POPOVER_MENU) != NULL
             || gtk_widget_get_ancestor (widget, GTK_TYPE_DROP_DOWN) != NULL
             || gtk_widget_get_ancestor (widget, GTK_TYPE_SHORTCUTS_WINDOW) != NULL
             || gtk_widget_get_ancestor (widget, GTK_TYPE_ABOUT_DIALOG) != NULL
             || g_str_has_prefix (G_OBJECT_TYPE_NAME (parent), "GtkColumnView")
             || GTK_IS_COLUMN_VIEW (
               gtk_widget_get_ancestor (widget, GTK_TYPE_COLUMN_VIEW))
             || gtk_widget_get_ancestor (widget, GTK_TYPE_INFO_BAR) != NULL);
}

static gboolean
is_label_with_text (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LABEL (widget) && *gtk_label_get_text (GTK_LABEL (widget)) != '\0';
}

static gboolean
is_icon (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_IMAGE (widget) || GTK_IS_PICTURE (widget);
}

static gboolean
has_name (GtkWidget *widget)
{
  GtkAccessible *accessible = GTK_ACCESSIBLE (widget);
  return gtk_test_accessible_has_property (accessible, GTK_ACCESSIBLE_PROPERTY_LABEL)
         || gtk_test_accessible_has_relation (accessible,
                                              GTK_ACCESSIBLE_RELATION_LABELLED_BY);
}

static gboolean
has_description (GtkWidget *widget)
{
  return gtk_widget_get_tooltip_text (widget) != NULL
         || gtk_test_accessible_has_property (GTK_ACCESSIBLE (widget),
                                              GTK_ACCESSIBLE_PROPERTY_DESCRIPTION);
}

static void
complain (GtkWidget *widget, const char *what, const char *lacks)
{
  GString *path = g_string_new (NULL);
  for (GtkWidget *w = widget; w != NULL; w = gtk_widget_get_parent (w))
    g_string_append_printf (path, "%s%s", path->len > 0 ? " in " : "",
                            G_OBJECT_TYPE_NAME (w));
  const char *action = GTK_IS_ACTIONABLE (widget)
                         ? gtk_actionable_get_action_name (GTK_ACTIONABLE (widget))
                         : NULL;
  const char *tooltip = gtk_widget_get_tooltip_text (widget);
  g_test_message ("%s: no %s: %s, action %s, tooltip %s", what, lacks, path->str,
                  action != NULL ? action : "none", tooltip != NULL ? tooltip : "none");
  g_string_free (path, TRUE);
  g_test_fail ();
}

static void
walk (GtkWidget *widget, const char *what)
{
  gboolean button =
    GTK_IS_BUTTON (widget) || GTK_IS_MENU_BUTTON (widget) || GTK_IS_CHECK_BUTTON (widget);
  gboolean field = GTK_IS_ENTRY (widget) || GTK_IS_DROP_DOWN (widget)
                   || GTK_IS_SEARCH_ENTRY (widget) || GTK_IS_PROGRESS_BAR (widget)
                   || GTK_IS_SWITCH (widget) || GTK_IS_SCALE (widget)
                   || GTK_IS_SPIN_BUTTON (widget) || GTK_IS_LIST_BOX (widget)
                   || GTK_IS_DRAWING_AREA (widget) || GTK_IS_TEXT_VIEW (widget)
                   || GTK_IS_COLUMN_VIEW (widget) || QN_IS_CANVAS (widget);
  if ((button || field) && !is_inside (widget)) {
    gboolean text =
      button && driver_find_widget (widget, is_label_with_text, NULL) != NULL;
    gboolean icon = button && driver_find_widget (widget, is_icon, NULL) != NULL;
    /* GTK says of an icon that it names its button, and nothing of the icon. */
    gboolean named = icon ? gtk_test_accessible_has_property (
                       GTK_ACCESSIBLE (widget), GTK_ACCESSIBLE_PROPERTY_LABEL)
                          : has_name (widget);
    if (!text && !named)
      complain (widget, what, "name");
    if (button && icon && !has_description (widget))
      complain (widget, what, "description");
  }
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    walk (child, what);
}

static void
look_at (GtkWidget *root, const char *what)
{
  driver_settle ();
  g_autofree char *name = g_strdup_printf ("form-%s", what);
  driver_screenshot (root, name);
  walk (root, what);
}

typedef struct State {
  const char *name, *example, *panel;
  const char *tool; /* or NULL */
  int block, beam, face, opening;
  const char *run; /* an action before, or NULL */
} State;

static const State states[] = {
  { "start", NULL, NULL, NULL, -1, -1, -1, -1, NULL },
  { "block", "05-stack.quoin", "properties", NULL, 1, -1, -1, -1, NULL },
  { "wall", "ferris-tin-loi/wall1.quoin", "properties", NULL, 3, -1, -1, -1, NULL },
  { "masonry", "12-facade.quoin", "properties", NULL, 12, -1, -1, -1, NULL },
  { "arch", "14-pointed-arch.quoin", "properties", NULL, 5, -1, -1, -1, NULL },
  { "rubble", "15-rubble-pier.quoin", "properties", NULL, 5, -1, -1, -1, NULL },
  { "opening", "12-facade.quoin", "properties", NULL, -1, -1, -1, 0, NULL },
  { "beam", "36-mast-on-block.quoin", "properties", NULL, -1, 0, -1, -1, "win.run" },
  { "face", "02-overturning-block.quoin", "properties", NULL, -1, -1, 0, -1, "win.run" },
  { "style-wall", "05-stack.quoin", "properties", "wall", -1, -1, -1, -1, NULL },
  { "style-opening", "05-stack.quoin", "properties", "opening", -1, -1, -1, -1, NULL },
  { "style-arch", "05-stack.quoin", "properties", "arch", -1, -1, -1, -1, NULL },
  { "style-column", "05-stack.quoin", "properties", "column", -1, -1, -1, -1, NULL },
  { "style-beam", "05-stack.quoin", "properties", "beam", -1, -1, -1, -1, NULL },
  { "style-force", "05-stack.quoin", "properties", "force", -1, -1, -1, -1, NULL },
  { "style-joint", "05-stack.quoin", "properties", "joint", -1, -1, -1, -1, NULL },
  { "style-mirror", "05-stack.quoin", "properties", "mirror", -1, -1, -1, -1, NULL },
  { "analysis", "16-load-stages.quoin", "analysis", NULL, -1, -1, -1, -1, NULL },
  { "law-curve", "17-unloading.quoin", "analysis", NULL, -1, -1, -1, -1, NULL },
  { "result", "02-overturning-block.quoin", "result", NULL, -1, -1, -1, -1, "win.run" },
  { "bars", "09-reinforced-cantilever.quoin", "analysis", NULL, -1, -1, -1, -1, NULL },
  { "frames", "34-frame-hybrid.quoin", "result", NULL, -1, -1, -1, -1, "win.run" },
  { "dynamic", "42-arch-pulse.quoin", "analysis", NULL, -1, -1, -1, -1, NULL },
  { "history", "41-column-impulse.quoin", "result", NULL, -1, -1, -1, -1, "win.run" },
  { "modes", "11-vibrating-beam.quoin", "result", NULL, -1, -1, -1, -1,
    "win.run-modes::loaded" },
  { "findings", "05-stack.quoin", "findings", NULL, -1, -1, -1, -1, NULL },
};

static void
test_state (gconstpointer data)
{
  const State *state = data;
  QnWindow *window = driver_open_window (1280, 1900);
  QnSelection *selection = qn_window_get_document (window)->selection;
  if (state->example != NULL) {
    g_autofree char *path = driver_example_path (state->example);
    g_assert_true (qn_window_open_path (window, path));
    driver_activate_target (window, "win.show-panel",
                            g_variant_new_string (state->panel));
  }
  if (state->run != NULL) {
    driver_activate (window, state->run);
    driver_wait_for_job (window);
    driver_activate_target (window, "win.show-panel",
                            g_variant_new_string (state->panel));
  }
  if (state->tool != NULL)
    driver_activate_target (window, "win.tool", g_variant_new_string (state->tool));
  if (state->block >= 0) {
    const QnId id = state->block;
    qn_selection_set (selection, QN_PICK_BLOCK, &id, 1);
  }
  if (state->beam >= 0) {
    const QnId id = state->beam;
    qn_selection_set (selection, QN_PICK_BEAM, &id, 1);
  }
  if (state->face >= 0)
    qn_selection_set_one (selection, QN_PICK_FACE, state->face);
  if (state->opening >= 0)
    qn_selection_set_opening (selection, 0, state->opening);
  driver_unfold (GTK_WIDGET (window));
  look_at (GTK_WIDGET (window), state->name);
  driver_discard (window);
}

/* Windows beside the main one and pages in it, and what opens them; "app." those of the program. */
static const struct {
  const char *what, *action, *target, *title;
} dialogs[] = {
  { "export", "win.export", NULL, "Export Figure" },
  { "figures", "win.figures", NULL, NULL },
  { "import", "win.take-path", "dxf/wall-clutter.dxf", "Import" },
  { "preferences", "app.preferences", NULL, "Preferences" },
  { "help", "app.help", NULL, "Help" },
  { "shortcuts", "win.shortcuts", NULL, NULL },
  { "about", "app.about", NULL, NULL },
  { "compare", "win.compare", NULL, NULL },
  { "animation", "win.export-result", "animation", "Export Animation" },
  { "report", "win.export-result", "report", "Export Report" },
  { "capacity", "win.capacity", NULL, NULL },
};

static void
test_dialogs (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  for (gsize i = 0; i < G_N_ELEMENTS (dialogs); i++) {
    g_autofree char *path = g_str_equal (dialogs[i].action, "win.take-path")
                              ? driver_example_path (dialogs[i].target)
                              : g_strdup (dialogs[i].target);
    if (g_str_has_prefix (dialogs[i].action, "app."))
      g_action_group_activate_action (G_ACTION_GROUP (driver_application ()),
                                      dialogs[i].action + strlen ("app."), NULL);
    else if (path != NULL)
      driver_activate_target (window, dialogs[i].action, g_variant_new_string (path));
    else
      driver_activate (window, dialogs[i].action);
    driver_settle ();
    GtkWidget *page = qn_window_get_page (window);
    GtkWidget *dialog = page != NULL ? page : driver_find_other ();
    if (dialog == NULL)
      g_error ("no window %s", dialogs[i].what);
    if (dialogs[i].title != NULL)
      g_assert_true (
        g_str_has_prefix (gtk_window_get_title (GTK_WINDOW (dialog)), dialogs[i].title));
    driver_unfold (dialog);
    look_at (dialog, dialogs[i].what);
    if (page != NULL)
      driver_activate (window, "win.close-page");
    else
      gtk_window_destroy (GTK_WINDOW (dialog));
    driver_settle ();
  }
  driver_discard (window);
}

/* A study with a number that varies, of a copy that may have one beside it. */
static void
test_study (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "ferris-tin-loi/wall3.quoin");
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.65);
  driver_settle ();
  GtkWidget *dialog = driver_find_page ("Study");
  g_assert_nonnull (dialog);
  look_at (dialog, "study");
  driver_discard (window);
}

static gboolean
is_called (GtkWidget *widget, gconstpointer id)
{
  return GTK_IS_BUILDABLE (widget) && !GTK_IS_LABEL (widget)
         && g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), id) == 0;
}

/* A typical joint is one step, for the law that is shown, and with its source. */
static void
test_joint (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *before = g_strdup (document->text->text);
  driver_open_analysis (window);
  GtkWidget *joint = driver_find_widget (GTK_WIDGET (window), is_called, "joint");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (joint), 1 + QN_JOINT_LIME_MORTAR);
  g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (joint)), ==, 0);
  const QnLaw *law = &document->project.model.laws[0];
  g_assert_cmpfloat (law->cohesion, ==, 1e5);
  g_assert_cmpint (law->basis, ==, QN_BASIS_SURFACE);
  g_assert_cmpstr (law->source, ==, qn_typical_joints[QN_JOINT_LIME_MORTAR].source);
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, before);
  driver_discard (window);
}

static void
press (QnWindow *window, const char *id)
{
  GtkWidget *button = driver_find_widget (GTK_WIDGET (window), is_called, id);
  g_assert_nonnull (button);
  g_assert_true (gtk_widget_get_sensitive (button));
  g_signal_emit_by_name (button, "clicked");
}

static GtkWidget *
row_at (GtkWidget *list, int index)
{
  return GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), index));
}

static int
width_of (GtkWidget *root, const char *id)
{
  return gtk_widget_get_width (driver_find_widget (root, is_called, id));
}

/* A case tells how many loads it has; F2 and a double click go to its name, Delete removes it. Fields
 * that were folded away are as wide as each other. */
static void
test_cases (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_open_analysis (window);
  GtkWidget *box = driver_find_widget (GTK_WIDGET (window), is_called, "loads_card");
  driver_unfold (box);
  driver_settle ();
  GtkWidget *list = driver_find_widget (box, is_called, "cases");
  GtkWidget *cases = gtk_widget_get_ancestor (list, GTK_TYPE_EXPANDER);
  GtkWidget *add = driver_find_widget (cases, is_called, "add");
  g_signal_emit_by_name (add, "clicked");
  g_signal_emit_by_name (add, "clicked");
  driver_settle ();
  g_assert_cmpint (width_of (cases, "name"), ==, width_of (cases, "factor"));
  g_assert_nonnull (driver_find_widget (row_at (list, 1), driver_says, "for 0 loads"));
  GtkWidget *loads = driver_find_widget (box, is_called, "loads");
  gtk_list_box_select_row (GTK_LIST_BOX (loads), GTK_LIST_BOX_ROW (row_at (loads, 0)));
  gtk_drop_down_set_selected (GTK_DROP_DOWN (driver_find_widget (box, is_called, "case")),
                              2);
  driver_settle ();
  g_assert_nonnull (driver_find_widget (row_at (list, 1), driver_says, "for 1 load"));

  GtkWidget *name = driver_find_widget (cases, is_called, "name");
  for (int way = 0; way < 2; way++) {
    gtk_list_box_select_row (GTK_LIST_BOX (list), GTK_LIST_BOX_ROW (row_at (list, way)));
    gtk_widget_grab_focus (row_at (list, way));
    driver_settle ();
    if (way == 0)
      driver_key ("F2");
    else
      g_signal_emit_by_name (row_at (list, 1), "activate");
    driver_settle ();
    g_assert_true (
      gtk_widget_has_focus (name)
      || gtk_widget_is_ancestor (gtk_window_get_focus (GTK_WINDOW (window)), name));
    driver_type (way == 0 ? "wind" : "snow");
    driver_key ("Return");
  }
  const QnModel *model = &document->project.model;
  g_assert_cmpstr (model->load_cases[0].name, ==, "wind");
  g_assert_cmpstr (model->load_cases[1].name, ==, "snow");

  /* "none" and the codes, "the same in all" and the actions; the second one is selected. */
  gtk_drop_down_set_selected (
    GTK_DROP_DOWN (driver_find_widget (cases, is_called, "action")), 2);
  driver_settle ();
  gtk_drop_down_set_selected (
    GTK_DROP_DOWN (driver_find_widget (cases, is_called, "code")), 3);
  driver_settle ();
  g_assert_cmpstr (model_of (window)->load_cases[1].action, ==, "non-structural");
  g_assert_cmpstr (model_of (window)->combinations.code, ==, "ntc2018");
  g_assert_true (qn_document_undo (document));
  g_assert_true (qn_document_undo (document));
  g_assert_cmpstr (model_of (window)->load_cases[1].action, ==, "");
  g_assert_cmpstr (model_of (window)->combinations.code, ==, "");
  gtk_list_box_select_row (GTK_LIST_BOX (list), GTK_LIST_BOX_ROW (row_at (list, 0)));
  gtk_widget_grab_focus (row_at (list, 0));
  driver_key ("KP_Delete");
  g_assert_cmpuint (model_of (window)->load_case_count, ==, 1);
  g_assert_cmpstr (model_of (window)->load_cases[0].name, ==, "snow");
  driver_discard (window);
}

/* Added with its source, applied to joints and to all others, found again, duplicated, and removed with
 * another one in its place; each is a step. */
static void
test_laws (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  QnDocument *document = qn_window_get_document (window);
  QnSelection *selection = document->selection;
  g_autofree char *before = g_strdup (document->text->text);
  guint steps = 0, count = 0;
  driver_open_analysis (window);
  GtkWidget *box = driver_find_widget (GTK_WIDGET (window), is_called, "materials");
  GtkWidget *list = driver_find_widget (box, is_called, "law");
  GtkWidget *add = driver_find_widget (box, is_called, "add");
  GtkWidget *joint = driver_find_widget (box, is_called, "joint");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (joint), 1 + QN_JOINT_DRY_STONE);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (add), 1 + QN_JOINT_BRICK);
  steps += 2;
  g_assert_cmpuint (document->project.model.law_count, ==, 2);
  g_assert_cmpint (
    gtk_list_box_row_get_index (gtk_list_box_get_selected_row (GTK_LIST_BOX (list))), ==,
    1);
  GtkWidget *apply = driver_find_widget (box, is_called, "apply");
  g_assert_false (gtk_widget_get_sensitive (apply)); /* nothing is selected */
  qn_selection_set_one (selection, QN_PICK_FACE, 1);
  driver_settle ();
  press (window, "apply");
  steps++;
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpint (contacts->faces[1].law_a, ==, 1);
  g_assert_cmpint (contacts->faces[1].law_b, ==, 1);
  g_assert_cmpint (contacts->faces[0].law_a, ==, 0);
  gtk_widget_grab_focus (driver_find_widget (box, is_called, "source"));
  driver_screenshot (GTK_WIDGET (window), "laws-list");
  qn_selection_clear (selection);
  press (window, "select");
  const QnId *faces = qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, 1);
  g_assert_cmpint (faces[0], ==, 1);
  press (window, "duplicate");
  press (window, "apply_to_all");
  steps += 2;
  const QnModel *model = &document->project.model;
  g_assert_cmpint (model->contact.law, ==, 2);
  g_assert_cmpstr (model->laws[2].source, ==, model->laws[1].source);
  /* The law of all others has one in its place, or stays. */
  GtkWidget *by = driver_find_widget (box, is_called, "by");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (by), 1);
  gtk_widget_grab_focus (
    GTK_WIDGET (gtk_list_box_get_selected_row (GTK_LIST_BOX (list))));
  driver_key ("Delete");
  steps++;
  model = &document->project.model;
  g_assert_cmpuint (model->law_count, ==, 2);
  g_assert_cmpint (model->contact.law, ==, 0);
  g_assert_cmpuint (document->history->steps->len, ==, steps);
  for (guint i = 0; i < steps; i++)
    driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, before);
  driver_discard (window);
}

static gboolean
take_fracture_energy (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->laws[0].cohesion = 1e5;
  model->laws[0].fracture_energy_shear = 50;
  return TRUE;
}

/* How a bond softens is asked where it has a fracture energy; a choice is one step. */
static void
test_softening (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_open_analysis (window);
  GtkWidget *softening = driver_find_widget (GTK_WIDGET (window), is_called, "softening");
  g_assert_nonnull (softening);
  g_assert_false (gtk_widget_get_visible (gtk_widget_get_parent (softening)));
  g_assert_true (edit_model (document, "Bond", NULL, take_fracture_energy, NULL, NULL));
  driver_settle ();
  g_assert_true (gtk_widget_get_visible (gtk_widget_get_parent (softening)));
  g_autofree char *before = g_strdup (document->text->text);
  gtk_widget_grab_focus (softening);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (softening), 1);
  g_assert_true (document->project.model.laws[0].exponential);
  g_assert_nonnull (strstr (document->text->text, "\"softening\": \"exponential\""));
  driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, before);
  driver_discard (window);
}

/* The plot of a law takes the focus, and then keys zoom it. */
static void
test_law_plot (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  driver_open_analysis (window);
  GtkWidget *softening = driver_find_widget (GTK_WIDGET (window), is_called, "softening");
  g_assert_nonnull (softening);
  GtkWidget *form = gtk_widget_get_parent (gtk_widget_get_parent (softening));
  GtkWidget *plot = driver_find_id (form, "view");
  QnBox whole = driver_plot_range (plot);
  g_assert_true (gtk_widget_grab_focus (plot));
  g_assert_true (gtk_widget_has_focus (plot));
  driver_key ("plus");
  QnBox part = driver_plot_range (plot);
  g_assert_cmpfloat (part.max.x - part.min.x, <, 0.9 * (whole.max.x - whole.min.x));
  driver_key ("0");
  part = driver_plot_range (plot);
  g_assert_cmpfloat_with_epsilon (part.max.x - part.min.x, whole.max.x - whole.min.x,
                                  1e-9);
  driver_discard (window);
}

static void
enter (GtkWidget *root, const char *id, const char *text)
{
  GtkWidget *entry = driver_find_widget (root, is_called, id);
  g_assert_nonnull (entry);
  gtk_editable_set_text (GTK_EDITABLE (entry), text);
  g_signal_emit_by_name (entry, "activate");
}

/* Title and gravity, which makes weights of densities, are steps; an empty title is none. */
static void
test_project (void)
{
  QnWindow *window = driver_open_example ("25-four-bricks.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *before = g_strdup (document->text->text);
  double weight = document->project.model.blocks[1].weight;
  double gravity = document->project.model.gravity;
  driver_open_analysis (window);
  enter (GTK_WIDGET (window), "title", "A stack on the Moon");
  enter (GTK_WIDGET (window), "gravity", "1.62");
  const QnModel *model = &document->project.model;
  g_assert_cmpstr (model->title, ==, "A stack on the Moon");
  g_assert_cmpfloat (model->gravity, ==, 1.62);
  g_assert_cmpfloat_with_epsilon (model->blocks[1].weight, weight * 1.62 / gravity,
                                  1e-9 * weight);
  enter (GTK_WIDGET (window), "title", "");
  g_assert_null (document->project.model.title);
  g_assert_cmpuint (document->history->steps->len, ==, 3);
  for (int i = 0; i < 3; i++)
    driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, before);
  driver_discard (window);
}

/* What is refused stays in its field, marked, with the reason, until another is taken. */
static void
test_refusal (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  QnDocument *document = qn_window_get_document (window);
  const QnId top = 1;
  qn_selection_set (document->selection, QN_PICK_BLOCK, &top, 1);
  driver_settle ();
  g_autofree char *before = g_strdup (document->text->text);
  const QnModel *model = &document->project.model;
  GtkWidget *name = driver_find_widget (GTK_WIDGET (window), is_called, "name");
  gtk_editable_set_text (GTK_EDITABLE (name), model->blocks[0].name);
  g_signal_emit_by_name (name, "activate");
  g_assert_cmpstr (document->text->text, ==, before);
  g_assert_true (gtk_widget_has_css_class (name, "error"));
  g_assert_nonnull (gtk_widget_get_tooltip_text (name));
  g_assert_cmpstr (gtk_editable_get_text (GTK_EDITABLE (name)), ==,
                   model->blocks[0].name);
  gtk_editable_set_text (GTK_EDITABLE (name), "another");
  g_signal_emit_by_name (name, "activate");
  g_assert_cmpstr (document->project.model.blocks[1].name, ==, "another");
  qn_selection_set (document->selection, QN_PICK_BLOCK, &top, 1);
  g_assert_false (gtk_widget_has_css_class (name, "error"));
  g_assert_null (gtk_widget_get_tooltip_text (name));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  for (gsize i = 0; i < G_N_ELEMENTS (states); i++) {
    g_autofree char *path = g_strdup_printf ("/app/forms/%s", states[i].name);
    g_test_add_data_func (path, &states[i], test_state);
  }
  g_test_add_func ("/app/forms/dialogs", test_dialogs);
  g_test_add_func ("/app/forms/study", test_study);
  g_test_add_func ("/app/forms/joint", test_joint);
  g_test_add_func ("/app/forms/laws", test_laws);
  g_test_add_func ("/app/forms/softening", test_softening);
  g_test_add_func ("/app/forms/law-plot", test_law_plot);
  g_test_add_func ("/app/forms/cases", test_cases);
  g_test_add_func ("/app/forms/project", test_project);
  g_test_add_func ("/app/forms/refusal", test_refusal);
}
