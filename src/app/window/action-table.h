/* Every action of the program and its windows, with its shortcut, and when it can be carried out.
 * Accelerators, the window of shortcuts and the shortcuts in tooltips are made from this table;
 * actions that menus, buttons and sources name are checked against it. */
#pragma once

#include <gtk/gtk.h>

/* What must hold for an action to be enabled; all of them. */
typedef enum {
  QN_NEEDS_NOTHING = 0,
  QN_NEEDS_WORK = 1 << 0,        /* a drawing is shown, not the start page */
  QN_NEEDS_MODEL = 1 << 1,       /* with blocks or beams */
  QN_NEEDS_IDLE = 1 << 2,        /* no analysis runs that the user has asked for */
  QN_NEEDS_JOB = 1 << 3,         /* one does */
  QN_NEEDS_RUN = 1 << 4,         /* a result is chosen */
  QN_NEEDS_COPYABLE = 1 << 5,    /* blocks, beams, a load or a bar are selected */
  QN_NEEDS_BEAM_FORCES = 1 << 6, /* the result has section forces */
  QN_NEEDS_UNDO = 1 << 7,        /* there is a step to undo */
  QN_NEEDS_REDO = 1 << 8,        /* there is a step to do again */
  QN_NEEDS_BLOCKS = 1 << 9,      /* blocks are selected */
  QN_NEEDS_TWO_BLOCKS = 1 << 10, /* at least two */
  QN_NEEDS_PARTS = 1 << 11,      /* blocks or beams are selected */
  QN_NEEDS_MOVABLE = 1 << 12,    /* blocks, beams or an opening are selected */
  QN_NEEDS_FACE = 1 << 13,       /* a contact face is selected */
  QN_NEEDS_EXPORTED = 1 << 14,   /* a figure has been exported */
  QN_NEEDS_THING = 1 << 15,      /* what can be copied, or an opening, is selected */
  QN_NEEDS_READY = 1 << 16, /* a page in sight that has something to run can run it */
} QnNeeds;

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
  QnNeeds needs;
  const char *keys; /* accelerators with spaces between them, or NULL */
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

/* The window of shortcuts, for one main window. */
GtkShortcutsWindow *qn_action_new_shortcuts_window (void);
