#include "app/window/action-table.h"

#include "app/tools/tools.h"
#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include <glib/gi18n.h>
#include <string.h>

/* In its group of the window of shortcuts. */
#define KEYED(group, name, reach, keys, label)                                           \
  {                                                                                      \
    name, keys, QN_REACH_##reach, QN_GROUP_##group, label                                \
  }

const QnActionRow qn_action_rows[] = {
  /* Files. */
  KEYED (FILES, "app.new-window", ALL, "<Control>n", N_ ("New window")),
  KEYED (FILES, "win.open", ALL, "<Control>o", N_ ("Open")),
  KEYED (FILES, "win.save", ALL, "<Control>s", N_ ("Save")),
  KEYED (FILES, "win.save-as", ALL, "<Control><Shift>s", N_ ("Save as")),
  KEYED (FILES, "win.export", ALL, "<Control>e", N_ ("Export a figure")),
  KEYED (FILES, "win.repeat-export", ALL, "<Control><Shift>e",
         N_ ("Repeat the last export")),
  KEYED (FILES, "win.import", ALL, "<Control>i", N_ ("Import a drawing")),
  KEYED (FILES, "win.close", ALL, "<Control>w", N_ ("Close the window")),

  /* Editing. */
  KEYED (EDITING, "win.undo", ALL, "<Control>z", N_ ("Undo")),
  KEYED (EDITING, "win.redo", ALL, "<Control><Shift>z <Control>y", N_ ("Redo")),
  KEYED (EDITING, "win.copy", NO_ENTRY, "<Control>c", N_ ("Copy")),
  KEYED (EDITING, "win.cut", NO_ENTRY, "<Control>x", N_ ("Cut")),
  KEYED (EDITING, "win.paste", NO_ENTRY, "<Control>v", N_ ("Paste")),
  KEYED (EDITING, "win.duplicate", ALL, "<Control>d", N_ ("Duplicate")),
  KEYED (EDITING, "win.select-all", NO_ENTRY, "<Control>a", N_ ("Select all")),
  KEYED (EDITING, "win.delete", NO_ENTRY, "Delete BackSpace", N_ ("Delete")),
  KEYED (EDITING, NULL, ALL, "Menu <Shift>F10", N_ ("Context menu")),
  KEYED (VIEW, "win.side-panel", ALL, "F9", N_ ("Side panel")),
  KEYED (NONE, "win.nudge((-1.0,0.0))", DRAWING, "Left", NULL),
  KEYED (NONE, "win.nudge((1.0,0.0))", DRAWING, "Right", NULL),
  KEYED (NONE, "win.nudge((0.0,1.0))", DRAWING, "Up", NULL),
  KEYED (NONE, "win.nudge((0.0,-1.0))", DRAWING, "Down", NULL),
  KEYED (EDITING, NULL, ALL, "Left Right Up Down", N_ ("Move what is selected")),
  KEYED (EDITING, NULL, ALL, "Left Right Up Down",
         N_ ("Move the pointer, with a drawing tool")),
  KEYED (EDITING, NULL, ALL, "Return", N_ ("Click at the pointer")),
  KEYED (EDITING, NULL, ALL, "Escape", N_ ("Cancel the gesture")),

  KEYED (TOOLS, "win.join", NO_ENTRY, "j", N_ ("Join blocks")),

  /* Analysis. */
  KEYED (ANALYSIS, "win.run-shown", ALL, "F5", N_ ("Solve, or run the study")),
  KEYED (ANALYSIS, "win.study", ALL, "<Control><Shift>u",
         N_ ("Study of uncertain parameters")),
  KEYED (ANALYSIS, "win.capacity", ALL, "<Control><Shift>k",
         N_ ("Capacity curve against a spectrum")),
  KEYED (ANALYSIS, "win.cancel", ALL, "<Shift>F5", N_ ("Cancel")),
  KEYED (ANALYSIS, "win.play", DRAWING, "space", N_ ("Play the motion")),
  KEYED (ANALYSIS, "win.next-step", NO_ENTRY, "period", N_ ("Next step")),
  KEYED (ANALYSIS, "win.previous-step", NO_ENTRY, "comma", N_ ("Previous step")),

  /* View. */
  KEYED (VIEW, "win.view::model", ALL, "<Control>1", N_ ("Model")),
  KEYED (VIEW, "win.view::contacts", ALL, "<Control>2", N_ ("Contacts")),
  KEYED (VIEW, "win.view::deformed", ALL, "<Control>3", N_ ("Deformed")),
  KEYED (VIEW, "win.view::mechanism", ALL, "<Control>4", N_ ("Mechanism")),
  KEYED (VIEW, "win.view::forces", ALL, "<Control>5", N_ ("Forces")),
  KEYED (VIEW, "win.view::diagrams", ALL, "<Control>6", N_ ("Section forces of beams")),
  KEYED (VIEW, "win.zoom-in", ALL, "<Control>plus <Control>equal", N_ ("Zoom in")),
  KEYED (VIEW, "win.zoom-out", ALL, "<Control>minus", N_ ("Zoom out")),
  KEYED (VIEW, "win.fit", ALL, "<Control>0", N_ ("Fit")),
  KEYED (VIEW, "win.fullscreen", ALL, "F11", N_ ("Full screen")),

  /* General. */
  KEYED (GENERAL, "app.help", ALL, "F1", N_ ("Help")),
  KEYED (GENERAL, "win.shortcuts", ALL, "<Control>question", N_ ("Keyboard shortcuts")),
  KEYED (GENERAL, "app.preferences", ALL, "<Control>comma", N_ ("Preferences")),
  KEYED (GENERAL, "app.quit", ALL, "<Control>q", N_ ("Quit")),
};
const gsize qn_action_row_count = G_N_ELEMENTS (qn_action_rows);

const QnActionRow *
qn_action_find (const char *detailed_name)
{
  for (gsize i = 0; i < qn_action_row_count; i++)
    if (g_strcmp0 (qn_action_rows[i].name, detailed_name) == 0)
      return &qn_action_rows[i];
  return NULL;
}

/* ---- tooltips ---- */

char *
qn_action_dup_tooltip (const char *text, const char *detailed_name)
{
  const QnActionRow *row = qn_action_find (detailed_name);
  guint keyval = 0;
  GdkModifierType modifiers = 0;
  if (row == NULL)
    return g_strdup (text);
  g_auto (GStrv) keys = g_strsplit (row->keys, " ", 2);
  gtk_accelerator_parse (keys[0], &keyval, &modifiers);
  g_autofree char *shown = gtk_accelerator_get_label (keyval, modifiers);
  return g_strdup_printf ("%s (%s)", text, shown);
}

void
qn_action_complete_tooltips (GtkWidget *widget)
{
  const char *text = gtk_widget_get_tooltip_text (widget);
  const char *name = GTK_IS_ACTIONABLE (widget)
                       ? gtk_actionable_get_action_name (GTK_ACTIONABLE (widget))
                       : NULL;
  if (text != NULL && (GTK_IS_BUTTON (widget) || GTK_IS_MENU_BUTTON (widget)))
    gtk_accessible_update_property (GTK_ACCESSIBLE (widget),
                                    GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
  if (text != NULL && name != NULL) {
    GVariant *target = gtk_actionable_get_action_target_value (GTK_ACTIONABLE (widget));
    g_autofree char *detailed = g_action_print_detailed_name (name, target);
    g_autofree char *whole = qn_action_dup_tooltip (text, detailed);
    gtk_widget_set_tooltip_text (widget, whole);
  }
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    qn_action_complete_tooltips (child);
}

/* ---- keys ---- */

static gboolean
has_key (const char *keys, guint keyval, GdkModifierType modifiers)
{
  g_auto (GStrv) each = g_strsplit (keys, " ", -1);
  for (char **key = each; *key != NULL; key++) {
    guint its = 0;
    GdkModifierType held = 0;
    if (gtk_accelerator_parse (*key, &its, &held) && its == keyval && held == modifiers)
      return TRUE;
  }
  return FALSE;
}

char *
qn_action_dup_for_key (guint keyval, GdkModifierType modifiers, gboolean on_drawing)
{
  GdkModifierType held = modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK | GDK_SHIFT_MASK);
  guint lower = gdk_keyval_to_lower (keyval);
  for (gsize i = 0; i < qn_action_row_count; i++) {
    const QnActionRow *row = &qn_action_rows[i];
    gboolean here =
      row->reach == QN_REACH_NO_ENTRY || (row->reach == QN_REACH_DRAWING && on_drawing);
    if (here && has_key (row->keys, lower, held))
      return g_strdup (row->name);
  }
  for (int i = 0; qn_tools[i] != NULL && held == 0; i++)
    if (gdk_keyval_to_unicode (lower) == (gunichar) qn_tools[i]->accel[0])
      return g_strconcat ("win.tool::", qn_tools[i]->name, NULL);
  return NULL;
}

void
qn_action_add_accelerators (GtkApplication *application)
{
  for (gsize i = 0; i < qn_action_row_count; i++) {
    const QnActionRow *row = &qn_action_rows[i];
    if (row->name == NULL || row->reach != QN_REACH_ALL)
      continue;
    g_auto (GStrv) keys = g_strsplit (row->keys, " ", -1);
    gtk_application_set_accels_for_action (application, row->name,
                                           (const char *const *) keys);
  }
}

/* ---- the window of shortcuts ---- */

/* Of a row: what the search looks in. */
#define TEXT "qn-text"

static void
add_shortcut (GtkGrid *grid, int row, const char *label, const char *accelerators)
{
  g_auto (GStrv) keys = g_strsplit (accelerators, " ", -1);
  GtkWidget *keycaps = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 4);
  GString *text = g_string_new (label);
  for (char **key = keys; *key != NULL; key++) {
    guint keyval = 0;
    GdkModifierType modifiers = 0;
    gtk_accelerator_parse (*key, &keyval, &modifiers);
    g_autofree char *shown = gtk_accelerator_get_label (keyval, modifiers);
    GtkWidget *keycap = gtk_label_new (shown);
    gtk_widget_add_css_class (keycap, "keycap");
    gtk_box_append (GTK_BOX (keycaps), keycap);
    g_string_append_printf (text, " %s", shown);
  }
  GtkWidget *words = g_object_new (GTK_TYPE_LABEL, "label", label, "xalign", 0.0, "wrap",
                                   TRUE, "wrap-mode", PANGO_WRAP_WORD_CHAR, NULL);
  g_object_set_data_full (G_OBJECT (words), TEXT,
                          g_utf8_casefold (text->str, (gssize) text->len), g_free);
  g_string_free (text, TRUE);
  gtk_widget_set_valign (keycaps, GTK_ALIGN_START);
  gtk_grid_attach (grid, keycaps, 0, row, 1, 1);
  gtk_grid_attach (grid, words, 1, row, 1, 1);
}

/* The rows whose words or keys have what is typed, with the titles of their groups. */
static void
on_searched (GtkEditable *entry, GtkWidget *columns)
{
  const char *typed = gtk_editable_get_text (entry);
  g_autofree char *folded = g_utf8_casefold (typed, -1);
  gboolean in_columns = FALSE;
  for (GtkWidget *column = gtk_widget_get_first_child (columns); column != NULL;
       column = gtk_widget_get_next_sibling (column)) {
    GtkWidget *grid = gtk_flow_box_child_get_child (GTK_FLOW_BOX_CHILD (column));
    gboolean in_group = FALSE, in_grid = FALSE;
    for (GtkWidget *words = gtk_widget_get_last_child (grid), *keys; words != NULL;
         words = gtk_widget_get_prev_sibling (keys)) {
      const char *text = g_object_get_data (G_OBJECT (words), TEXT);
      gboolean found =
        text != NULL
          ? strstr (text, folded) != NULL
              || g_str_match_string (typed, gtk_label_get_text (GTK_LABEL (words)), TRUE)
          : in_group;
      keys = text != NULL ? gtk_widget_get_prev_sibling (words) : words;
      in_group = text != NULL && (in_group || found);
      in_grid = in_grid || found;
      gtk_widget_set_visible (keys, found);
      gtk_widget_set_visible (words, found);
    }
    gtk_widget_set_visible (column, in_grid);
    in_columns = in_columns || in_grid;
  }
  gtk_widget_set_visible (gtk_widget_get_next_sibling (columns), !in_columns);
}

static gboolean
on_escape (GtkWidget *entry, guint key)
{
  gboolean clears =
    key == GDK_KEY_Escape && *gtk_editable_get_text (GTK_EDITABLE (entry)) != '\0';
  if (clears)
    gtk_editable_set_text (GTK_EDITABLE (entry), "");
  return clears;
}

void
qn_action_show_shortcuts (GtkWindow *parent)
{
  static const char *const titles[QN_GROUP_COUNT] = {
    [QN_GROUP_FILES] = N_ ("Files"), [QN_GROUP_EDITING] = N_ ("Editing"),
    [QN_GROUP_TOOLS] = N_ ("Tools"), [QN_GROUP_ANALYSIS] = N_ ("Analysis"),
    [QN_GROUP_VIEW] = N_ ("View"),   [QN_GROUP_GENERAL] = N_ ("General"),
  };
  g_autoptr (GtkBuilder) builder = qn_builder_new ("shortcuts");
  GtkWidget *dialog = qn_builder_get_widget (builder, "window");
  GtkWidget *columns = qn_builder_get_widget (builder, "columns");
  GtkWidget *entry = qn_builder_get_widget (builder, "search");
  GtkGrid *grid = NULL;
  for (int group = QN_GROUP_FILES, row = 0; group < QN_GROUP_COUNT; group++) {
    if (grid == NULL || group == QN_GROUP_TOOLS || group == QN_GROUP_ANALYSIS) {
      grid = GTK_GRID (gtk_grid_new ());
      gtk_flow_box_append (GTK_FLOW_BOX (columns), GTK_WIDGET (grid));
      gtk_widget_set_focusable (gtk_widget_get_parent (GTK_WIDGET (grid)), FALSE);
    }
    GtkWidget *title =
      g_object_new (GTK_TYPE_LABEL, "label", _ (titles[group]), "xalign", 0.0, NULL);
    gtk_widget_add_css_class (title, "heading");
    gtk_grid_attach (grid, title, 0, row++, 2, 1);
    for (int i = 0; group == QN_GROUP_TOOLS && qn_tools[i] != NULL; i++)
      add_shortcut (grid, row++, _ (qn_tools[i]->label), qn_tools[i]->accel);
    for (gsize i = 0; i < qn_action_row_count; i++)
      if ((int) qn_action_rows[i].group == group)
        add_shortcut (grid, row++, _ (qn_action_rows[i].label), qn_action_rows[i].keys);
  }
  g_signal_connect_object (gtk_builder_get_object (builder, "keys"), "key-pressed",
                           G_CALLBACK (on_escape), entry, G_CONNECT_SWAPPED);
  gtk_search_entry_set_key_capture_widget (GTK_SEARCH_ENTRY (entry), dialog);
  g_signal_connect (entry, "changed", G_CALLBACK (on_searched), columns);
  g_signal_connect_swapped (entry, "stop-search", G_CALLBACK (gtk_window_close), dialog);
  qn_dialog_present (dialog, parent, NULL, entry);
}
