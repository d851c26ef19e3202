/* Every action that has a shortcut. Accelerators, the window of shortcuts and the shortcuts in tooltips are made
 * from this table. */
#pragma once

#include <gtk/gtk.h>

/* Where the keys of an action work: wherever the focus is, not in entries, in the drawing alone. */
typedef enum { QN_REACH_ALL, QN_REACH_NO_ENTRY, QN_REACH_DRAWING } QnReach;

typedef enum {
  QN_GROUP_NONE, /* not in the window of shortcuts */
  QN_GROUP_FILES,
  QN_GROUP_EDITING,
  QN_GROUP_TOOLS,
  QN_GROUP_ANALYSIS,
  QN_GROUP_VIEW,
  QN_GROUP_GENERAL,
  QN_GROUP_COUNT
} QnActionGroup;

typedef struct QnActionRow {
  const char *name; /* detailed, e.g. "win.view::model"; NULL: keys without an action */
  const char *keys; /* accelerators with spaces between them */
  QnReach reach;
  QnActionGroup group;
  const char *label; /* translatable, in the window of shortcuts */
} QnActionRow;

extern const QnActionRow qn_action_rows[];
extern const gsize qn_action_row_count;

/* The row of an action, by its detailed name; or NULL. */
const QnActionRow *qn_action_find (const char *detailed_name);

/* A tooltip with the first shortcut of an action behind it, "Save (Ctrl+S)"; the caller frees it. */
char *qn_action_dup_tooltip (const char *text, const char *detailed_name);

/* Adds the shortcuts of their actions to the tooltips of a widget and all below it. */
void qn_action_complete_tooltips (GtkWidget *widget);

/* The action of a key, detailed; NULL for none. `on_drawing`: the drawing has the focus. Tools have
 * their single keys. The caller frees it. */
char *qn_action_dup_for_key (guint keyval, GdkModifierType modifiers,
                             gboolean on_drawing);

/* Sets the accelerators that work everywhere. */
void qn_action_add_accelerators (GtkApplication *application);

/* Shows the window of shortcuts over a main window. */
void qn_action_show_shortcuts (GtkWindow *parent);
