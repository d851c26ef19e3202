/* The inside of a window, shared by the files that make it up. */
#pragma once

#include "app/widgets/chooser.h"
#include "app/window/window.h"
#include "doc/document/recovery.h"
#include "doc/view/recipe.h"
#include "doc/view/report.h"

/* No method waits for another to end. */
#define QN_NO_METHOD G_MAXUINT

typedef enum QnClosing {
  QN_CLOSING_NOT,
  QN_CLOSING_LATER, /* is saved first, when those before it have gone */
  QN_CLOSING_NOW    /* unsaved changes have been dealt with */
} QnClosing;

/* What window.ui has. */
#define QN_WINDOW_CHILDREN(CHILD)                                                        \
  CHILD (GtkLabel, title_label)                                                          \
  CHILD (GtkLabel, subtitle_label)                                                       \
  CHILD (GtkLabel, info_label)                                                           \
  CHILD (GtkLabel, live_label)                                                           \
  CHILD (GtkLabel, status_hint)                                                          \
  CHILD (GtkLabel, status_pointer)                                                       \
  CHILD (GtkLabel, status_counts)                                                        \
  CHILD (GtkLabel, progress_label)                                                       \
  CHILD (GtkStack, main_stack)                                                           \
  CHILD (GtkStack, side_stack)                                                           \
  CHILD (GtkBox, start_box)                                                              \
  CHILD (GtkBox, tool_box)                                                               \
  CHILD (GtkBox, canvas_box)                                                             \
  CHILD (GtkBox, view_box)                                                               \
  CHILD (GtkBox, view_switcher)                                                          \
  CHILD (GtkWidget, info_bar)                                                            \
  CHILD (GtkButton, info_button)                                                         \
  CHILD (GtkButton, run_button)                                                          \
  CHILD (GtkButton, undo_button)                                                         \
  CHILD (GtkButton, redo_button)                                                         \
  CHILD (GtkWidget, progress_box)                                                        \
  CHILD (GtkWidget, pause_button)                                                        \
  CHILD (GtkWidget, stale_label)                                                         \
  CHILD (GtkWidget, diagrams_button)                                                     \
  CHILD (GtkWidget, diagram_box)                                                         \
  CHILD (GtkWidget, field_button)                                                        \
  CHILD (GtkWidget, shown_stack)                                                         \
  CHILD (GtkProgressBar, progress_bar)                                                   \
  CHILD (GtkMenuButton, history_button)                                                  \
  CHILD (GtkMenuButton, view_button)                                                     \
  CHILD (GtkScrolledWindow, properties_scroller)                                         \
  CHILD (GtkScrolledWindow, analysis_scroller)                                           \
  CHILD (GtkScrolledWindow, result_scroller)                                             \
  CHILD (GtkScrolledWindow, findings_scroller)                                           \
  CHILD (GtkPaned, middle)                                                               \
  CHILD (GtkWidget, page_box)                                                            \
  CHILD (GtkToggleButton, fill_button)                                                   \
  CHILD (GtkStack, pages)                                                                \
  CHILD (QnCanvas, canvas)                                                               \
  CHILD (GtkWidget, side_panel)                                                          \
  CHILD (GtkWidget, open_button)                                                         \
  CHILD (GtkWidget, save_button)                                                         \
  CHILD (GtkWidget, export_button)

struct _QnWindow {
  GtkApplicationWindow parent_instance;

  QnDocument *document;
  QnViewState *state;
  QnToolSettings tool_settings;
  QnRecovery *recovery;
  GtkWidget *page_window; /* the pages' own, or NULL: they are under the drawing */
  guint live_timeout, message_timeout;
  guint next_method;    /* of all that are run one after the other, or QN_NO_METHOD */
  gboolean was_running; /* an analysis that was asked for, when the document last told */
  QnClosing closing;
  char *after_save;              /* action that waits until there is a file, or NULL */
  char *last_export;             /* path of the last exported figure */
  QnRecipe *last_recipe;         /* what it looked like */
  const QnFileKind *chosen_kind; /* what the file chooser on the screen opens */
  gsize exported;                /* what it asks for a file for */
  GCancellable *reporting;       /* while a report is written */
  QnVec2 info_place;             /* of what the bar says, where it has a button for it */

#define CHILD(type, name) type *name;
  QN_WINDOW_CHILDREN (CHILD)
#undef CHILD
  GtkWidget *playback;
  int panel_width;    /* px that the side panel asks for, where it has them */
  gboolean is_narrow; /* too narrow for drawing and side panel beside each other */
  gboolean is_tight;  /* too narrow for any drawing beside the side panel */
  gboolean is_small;  /* too narrow for a title between all buttons */
};

/* window-actions.c: actions of viewing, tools, panels. */
void qn_window_add_actions (QnWindow *window);
void qn_window_update_actions (QnWindow *window);
void qn_window_add_keys (QnWindow *window);

/* Before the window goes: its actions may stay longer, because a tooltip that is due holds them (GTK
 * 4.8), and settings would tell them of changes. */
void qn_window_forget_settings (QnWindow *window);

/* Drawing, tools, side panel and page share the room that there is. */
void qn_window_arrange (QnWindow *window);

/* window-menu.c: the context menu of the drawing. */
void qn_window_add_context_menu (QnWindow *window);

/* window-help.c: pages of the manual. */
void qn_window_add_help_pages (QnWindow *window);

/* Takes over a value that is being typed, as leaving its field does. */
void qn_window_commit_entry (QnWindow *window);

/* window-files.c: open, save, close. */
void qn_window_remember_recent (const char *path);
/* Asks about unsaved changes; TRUE when the window may close at once. */
gboolean qn_window_may_close (QnWindow *window);

/* window-import.c: drawings of other programs, pictures, dropped files. */
void qn_window_accept_drops (QnWindow *window);
/* Opens, imports or lays behind the drawing, by the kind of file. */
void qn_window_take_file (QnWindow *window, const char *path);

/* Asks for a file of the kind that the action of that name opens. */
void qn_window_choose_file (QnWindow *window, const char *name);

/* window-analysis.c: run, progress, live mode. */
void qn_window_connect_analysis (QnWindow *window);

/* A result file of the project: added to the runs and shown. */
void qn_window_open_result (QnWindow *window, const char *path);

/* Shows the drawing instead of the start page. */
void qn_window_show_work (QnWindow *window);

/* window-pages.c: pages under the drawing. */
void qn_window_remove_pages (QnWindow *window);
/* The one in sight, or NULL. */
GtkWidget *qn_window_get_page (QnWindow *window);
/* Whether it has an action of its own (undo, redo, run, cancel), whether that can be used, and that carried out
 * where it has it. */
gboolean qn_window_page_has (QnWindow *window, const char *action);
gboolean qn_window_page_can (QnWindow *window, const char *action);
gboolean qn_window_page_does (QnWindow *window, const char *action);
/* Under the drawing, where they are in a window of their own. */
void qn_window_take_pages_back (QnWindow *window);
/* Where a page has its place; `alone`: without any page. */
void qn_window_show_drawing (QnWindow *window, gboolean alone);
/* Opens the project that a study file names, and shows the study. */
gboolean qn_window_open_study (QnWindow *window, const char *path);

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

#define QN_NEEDS_DRAWN    (QN_NEEDS_WORK | QN_NEEDS_MODEL)
#define QN_NEEDS_SOLVABLE (QN_NEEDS_DRAWN | QN_NEEDS_IDLE)

/* Actions of one source; the last has no name. What is done gets the parameter where that is a text ("s"),
 * or the name of an action without a parameter; `take` is in its place for parameters of other types. */
typedef struct QnWindowAction {
  const char *name;
  const char *parameter; /* its type, or NULL */
  union {
    void (*func) (QnWindow *window, const char *text);
    void (*take) (QnWindow *window, GVariant *parameter);
  };
  QnNeeds needs;
} QnWindowAction;
extern const QnWindowAction qn_window_edit_actions[], qn_window_file_actions[],
  qn_window_import_actions[], qn_window_analysis_actions[], qn_window_export_actions[],
  qn_window_page_actions[];
