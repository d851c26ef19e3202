#include "app/window/action-table.h"

#include "app/tools/tools.h"
#include <glib/gi18n.h>

#define SOLVABLE (QN_NEEDS_WORK | QN_NEEDS_MODEL | QN_NEEDS_IDLE)
#define DRAWN    (QN_NEEDS_WORK | QN_NEEDS_MODEL)

const QnActionRow qn_action_rows[] = {
  /* Files. */
  { .name = "app.new-window",
    .keys = "<Control>n",
    .group = QN_GROUP_FILES,
    .label = N_ ("New window") },
  { .name = "win.open",
    .keys = "<Control>o",
    .group = QN_GROUP_FILES,
    .label = N_ ("Open") },
  { .name = "win.open-path" },
  { .name = "win.open-example" },
  { .name = "win.save",
    .needs = QN_NEEDS_WORK,
    .keys = "<Control>s",
    .group = QN_GROUP_FILES,
    .label = N_ ("Save") },
  { .name = "win.save-as",
    .needs = QN_NEEDS_WORK,
    .keys = "<Control><Shift>s",
    .group = QN_GROUP_FILES,
    .label = N_ ("Save as") },
  { .name = "win.save-path" },
  { .name = "win.keep-history" },
  { .name = "win.export",
    .needs = DRAWN,
    .keys = "<Control>e",
    .group = QN_GROUP_FILES,
    .label = N_ ("Export a figure") },
  { .name = "win.repeat-export",
    .needs = QN_NEEDS_WORK | QN_NEEDS_EXPORTED,
    .keys = "<Control><Shift>e",
    .group = QN_GROUP_FILES,
    .label = N_ ("Repeat the last export") },
  { .name = "win.figures", .needs = QN_NEEDS_WORK },
  { .name = "win.export-result", .needs = QN_NEEDS_RUN },
  { .name = "win.export-drawing", .needs = DRAWN },
  { .name = "win.export-path" },
  { .name = "win.compare" },
  { .name = "win.open-result", .needs = DRAWN },
  { .name = "win.open-result-path", .needs = DRAWN },
  { .name = "win.import",
    .keys = "<Control>i",
    .group = QN_GROUP_FILES,
    .label = N_ ("Import a drawing") },
  { .name = "win.take-path" },
  { .name = "win.picture" },
  { .name = "win.picture-path" },
  { .name = "win.remove-picture" },
  { .name = "win.print",
    .needs = DRAWN,
    .keys = "<Control>p",
    .group = QN_GROUP_FILES,
    .label = N_ ("Print") },
  { .name = "win.print-path", .needs = DRAWN },
  { .name = "win.close",
    .keys = "<Control>w",
    .group = QN_GROUP_FILES,
    .label = N_ ("Close the window") },

  /* Editing. */
  { .name = "win.undo",
    .needs = QN_NEEDS_WORK | QN_NEEDS_UNDO,
    .keys = "<Control>z",
    .group = QN_GROUP_EDITING,
    .label = N_ ("Undo") },
  { .name = "win.redo",
    .needs = QN_NEEDS_WORK | QN_NEEDS_REDO,
    .keys = "<Control><Shift>z <Control>y",
    .group = QN_GROUP_EDITING,
    .label = N_ ("Redo") },
  { .name = "win.go-to-step", .needs = QN_NEEDS_WORK },
  { .name = "win.copy",
    .needs = QN_NEEDS_BLOCKS,
    .keys = "<Control>c",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_EDITING,
    .label = N_ ("Copy") },
  { .name = "win.cut",
    .needs = QN_NEEDS_BLOCKS,
    .keys = "<Control>x",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_EDITING,
    .label = N_ ("Cut") },
  { .name = "win.paste",
    .needs = QN_NEEDS_WORK,
    .keys = "<Control>v",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_EDITING,
    .label = N_ ("Paste") },
  { .name = "win.duplicate",
    .needs = QN_NEEDS_COPYABLE,
    .keys = "<Control>d",
    .group = QN_GROUP_EDITING,
    .label = N_ ("Duplicate") },
  { .name = "win.select-all",
    .needs = QN_NEEDS_MODEL,
    .keys = "<Control>a",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_EDITING,
    .label = N_ ("Select all") },
  { .name = "win.select-like", .needs = QN_NEEDS_BLOCKS },
  { .name = "win.select-faces-like", .needs = QN_NEEDS_FACE },
  { .name = "win.delete",
    .needs = QN_NEEDS_THING,
    .keys = "Delete BackSpace",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_EDITING,
    .label = N_ ("Delete") },
  { .name = "win.align", .needs = QN_NEEDS_PARTS },
  { .name = "win.distribute", .needs = QN_NEEDS_PARTS },
  { .name = "win.support", .needs = QN_NEEDS_BLOCKS },
  { .name = "win.joint-law", .needs = QN_NEEDS_FACE },
  { .name = "win.copy-text" },
  { .keys = "Menu <Shift>F10", .group = QN_GROUP_EDITING, .label = N_ ("Context menu") },
  { .name = "win.side-panel",
    .keys = "F9",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Side panel") },
  { .name = "win.detach", .needs = QN_NEEDS_BLOCKS },
  { .name = "win.mirror", .needs = QN_NEEDS_PARTS },
  { .name = "win.rotate", .needs = QN_NEEDS_PARTS },
  { .name = "win.array", .needs = QN_NEEDS_PARTS },
  { .name = "win.nudge", .needs = QN_NEEDS_MOVABLE },
  { .name = "win.nudge((-1.0,0.0))", .keys = "Left", .reach = QN_REACH_DRAWING },
  { .name = "win.nudge((1.0,0.0))", .keys = "Right", .reach = QN_REACH_DRAWING },
  { .name = "win.nudge((0.0,1.0))", .keys = "Up", .reach = QN_REACH_DRAWING },
  { .name = "win.nudge((0.0,-1.0))", .keys = "Down", .reach = QN_REACH_DRAWING },
  { .keys = "Left Right Up Down",
    .group = QN_GROUP_EDITING,
    .label = N_ ("Move what is selected") },
  { .keys = "Left Right Up Down",
    .group = QN_GROUP_EDITING,
    .label = N_ ("Move the pointer, with a drawing tool") },
  { .keys = "Return", .group = QN_GROUP_EDITING, .label = N_ ("Click at the pointer") },
  { .keys = "Escape", .group = QN_GROUP_EDITING, .label = N_ ("Cancel the gesture") },

  /* Tools have keys of their own, which their table has. */
  { .name = "win.tool" },
  { .name = "win.draw" },
  { .name = "win.join",
    .needs = QN_NEEDS_TWO_BLOCKS,
    .keys = "j",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_TOOLS,
    .label = N_ ("Join blocks") },

  /* Analysis. */
  { .name = "win.run",
    .needs = SOLVABLE,
    .keys = "F5",
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Solve") },
  { .name = "win.run-limit", .needs = SOLVABLE },
  { .name = "win.remove-run", .needs = QN_NEEDS_RUN },
  { .name = "win.run-all", .needs = SOLVABLE },
  { .name = "win.run-modes", .needs = SOLVABLE },
  { .name = "win.study",
    .needs = DRAWN,
    .keys = "<Control><Shift>u",
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Study of uncertain parameters") },
  { .name = "win.capacity",
    .needs = SOLVABLE,
    .keys = "<Control><Shift>k",
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Capacity curve against a spectrum") },
  { .name = "win.vary", .needs = DRAWN },
  { .name = "win.move-load", .needs = DRAWN },
  { .name = "win.run-stability", .needs = SOLVABLE },
  { .name = "win.cancel",
    .needs = QN_NEEDS_JOB,
    .keys = "<Shift>F5",
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Cancel") },
  { .name = "win.pause", .needs = QN_NEEDS_JOB },
  { .name = "win.live" },
  { .name = "win.play",
    .needs = QN_NEEDS_RUN,
    .keys = "space",
    .reach = QN_REACH_DRAWING,
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Play the motion") },
  { .name = "win.next-step",
    .needs = QN_NEEDS_RUN,
    .keys = "period",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Next step") },
  { .name = "win.previous-step",
    .needs = QN_NEEDS_RUN,
    .keys = "comma",
    .reach = QN_REACH_NO_ENTRY,
    .group = QN_GROUP_ANALYSIS,
    .label = N_ ("Previous step") },

  /* View. */
  { .name = "win.view" },
  { .name = "win.view::model",
    .keys = "<Control>1",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Model") },
  { .name = "win.view::contacts",
    .keys = "<Control>2",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Contacts") },
  { .name = "win.view::deformed",
    .keys = "<Control>3",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Deformed") },
  { .name = "win.view::mechanism",
    .keys = "<Control>4",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Mechanism") },
  { .name = "win.view::forces",
    .keys = "<Control>5",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Forces") },
  { .name = "win.view::diagrams",
    .keys = "<Control>6",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Section forces of beams") },
  { .name = "win.field", .needs = QN_NEEDS_RUN },
  { .name = "win.diagram", .needs = QN_NEEDS_RUN | QN_NEEDS_BEAM_FORCES },
  { .name = "win.zoom-in",
    .keys = "<Control>plus <Control>equal",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Zoom in") },
  { .name = "win.zoom-out",
    .keys = "<Control>minus",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Zoom out") },
  { .name = "win.fit",
    .keys = "<Control>0",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Fit") },
  { .name = "win.fullscreen",
    .keys = "F11",
    .group = QN_GROUP_VIEW,
    .label = N_ ("Full screen") },
  { .name = "win.show-panel" },
  { .name = "win.ghost" },
  { .name = "win.symbols" },
  { .name = "win.loads" },
  { .name = "win.dimensions" },
  { .name = "win.names" },
  { .name = "win.values" },
  { .name = "win.monochrome" },
  { .name = "win.snap" },
  { .name = "win.grid" },

  /* General. */
  { .name = "app.help", .keys = "F1", .group = QN_GROUP_GENERAL, .label = N_ ("Help") },
  { .name = "win.show-help-overlay",
    .keys = "<Control>question",
    .group = QN_GROUP_GENERAL,
    .label = N_ ("Keyboard shortcuts") },
  { .name = "app.preferences",
    .keys = "<Control>comma",
    .group = QN_GROUP_GENERAL,
    .label = N_ ("Preferences") },
  { .name = "app.about" },
  { .name = "app.quit",
    .keys = "<Control>q",
    .group = QN_GROUP_GENERAL,
    .label = N_ ("Quit") },
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

static char *
dup_first_key (const char *keys)
{
  const char *end = strchr (keys, ' ');
  return end != NULL ? g_strndup (keys, (gsize) (end - keys)) : g_strdup (keys);
}

/* ---- tooltips ---- */

char *
qn_action_dup_tooltip (const char *text, const char *detailed_name)
{
  const QnActionRow *row = qn_action_find (detailed_name);
  guint keyval = 0;
  GdkModifierType modifiers = 0;
  if (row == NULL || row->keys == NULL)
    return g_strdup (text);
  g_autofree char *key = dup_first_key (row->keys);
  gtk_accelerator_parse (key, &keyval, &modifiers);
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
    if (row->name == NULL || row->keys == NULL || row->reach != QN_REACH_ALL)
      continue;
    g_auto (GStrv) keys = g_strsplit (row->keys, " ", -1);
    gtk_application_set_accels_for_action (application, row->name,
                                           (const char *const *) keys);
  }
}

/* ---- the window of shortcuts, which GTK makes of a description alone ---- */

static void
describe_shortcut (GString *xml, const char *label, const char *keys)
{
  g_autofree char *text = g_markup_printf_escaped (
    "<child><object class='GtkShortcutsShortcut'><property name='title'>%s</property>"
    "<property name='accelerator'>%s</property></object></child>",
    label, keys);
  g_string_append (xml, text);
}

static void
describe_group (GString *xml, QnActionGroup group, const char *title)
{
  g_autofree char *head = g_markup_printf_escaped (
    "<child><object class='GtkShortcutsGroup'><property name='title'>%s</property>",
    title);
  g_string_append (xml, head);
  for (int i = 0; group == QN_GROUP_TOOLS && qn_tools[i] != NULL; i++)
    describe_shortcut (xml, _ (qn_tools[i]->label), qn_tools[i]->accel);
  for (gsize i = 0; i < qn_action_row_count; i++) {
    const QnActionRow *row = &qn_action_rows[i];
    if (row->group != group)
      continue;
    g_autofree char *first = dup_first_key (row->keys);
    describe_shortcut (xml, _ (row->label), row->name != NULL ? first : row->keys);
  }
  g_string_append (xml, "</object></child>");
}

GtkShortcutsWindow *
qn_action_new_shortcuts_window (void)
{
  static const char *const titles[QN_GROUP_COUNT] = {
    [QN_GROUP_FILES] = N_ ("Files"), [QN_GROUP_EDITING] = N_ ("Editing"),
    [QN_GROUP_TOOLS] = N_ ("Tools"), [QN_GROUP_ANALYSIS] = N_ ("Analysis"),
    [QN_GROUP_VIEW] = N_ ("View"),   [QN_GROUP_GENERAL] = N_ ("General"),
  };
  g_autoptr (GString) xml = g_string_new (
    "<interface><object class='GtkShortcutsWindow' id='help_overlay'>"
    "<property name='modal'>1</property><child><object class='GtkShortcutsSection'>"
    "<property name='section-name'>shortcuts</property>"
    "<property name='max-height'>12</property>");
  for (QnActionGroup group = QN_GROUP_FILES; group < QN_GROUP_COUNT; group++)
    describe_group (xml, group, _ (titles[group]));
  g_string_append (xml, "</object></child></object></interface>");
  g_autoptr (GtkBuilder) builder = gtk_builder_new_from_string (xml->str, -1);
  return GTK_SHORTCUTS_WINDOW (
    g_object_ref (gtk_builder_get_object (builder, "help_overlay")));
}
