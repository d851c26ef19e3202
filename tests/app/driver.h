/* Drives real windows from a test: waits, moves the pointer, presses buttons and keys, takes
 * pictures. The pointer and the keys go through the X server, as a user's do. */
#pragma once

#include "app/canvas/canvas-private.h"
#include "app/window/application.h"
#include "app/window/window-private.h"

/* The program, started once for all tests of a process. */
GtkApplication *driver_application (void);

/* A window that is on the screen, of this size. */
QnWindow *driver_open_window (int width, int height);

/* A window with a file of the examples. */
QnWindow *driver_open_example (const char *name);

/* The same of a copy that may be written to, wall.quoin in the folder. */
QnWindow *driver_open_copy (const char *folder, const char *name);

/* Parts of windows and of their drawing; borrowed. */
static inline QnCanvas *
canvas_of (QnWindow *window)
{
  return window->canvas;
}

static inline QnViewState *
state_of (QnWindow *window)
{
  return window->state;
}

static inline QnBox
card_of (QnCanvas *canvas)
{
  return canvas->card;
}

static inline void
move_camera (QnCanvas *canvas, const QnCamera *camera)
{
  canvas->camera = *camera;
  qn_canvas_zoom (canvas, 1.0);
}

static inline QnGlLayer *
gl_layer_of (QnCanvas *canvas)
{
  return &canvas->gl_layer;
}

static inline const QnModel *
model_of (QnWindow *window)
{
  return &qn_window_get_document (window)->project.model;
}

static inline QnSelection *
selection_of (QnWindow *window)
{
  return qn_window_get_document (window)->selection;
}

/* Path of an example; the caller frees it. */
char *driver_example_path (const char *name);

/* Waits are for what is looked at, never for a time; they fail after two minutes. All that follows here
 * waits until the window has settled. */

/* Runs the main loop until nothing is left to be done: no event, no layout, no drawing. A window whose
 * analysis runs is drawn a few times. */
void driver_settle (void);

/* Runs it until a condition holds, and the window has settled. */
typedef gboolean (*DriverCondition) (gpointer data);
void driver_wait (DriverCondition condition, gpointer data);

/* Whether a motion can be played; windows do not settle while one is. Not from the beginning. */
void driver_set_animated (gboolean animated);

/* Waits until no analysis runs. */
void driver_wait_for_job (QnWindow *window);

/* Pointer at a place of the model in the drawing. */
void driver_point (QnWindow *window, double x, double y);
void driver_drag (QnWindow *window, double x0, double y0, double x1, double y1);
void driver_click (QnWindow *window, double x, double y);
/* Pointer at a place of a widget, px, and any button of it, 4 and 5 for the wheel. */
void driver_point_at (GtkWidget *widget, double x, double y);
void driver_press_button (const char *number);

/* The first button goes down or up. */
void driver_hold_button (gboolean down);
/* Words of a command line of xdotool, NULL-terminated; waits until it has been heard. */
void driver_xdotool (const char *const *arguments);
/* How many buttons and keys have gone down since this was asked last. */
guint driver_take_inputs (void);
/* Keys as xdotool spells them. */
void driver_key (const char *key);
void driver_hold_key (const char *key, gboolean down);
void driver_type (const char *text);

void driver_activate (QnWindow *window, const char *detailed_action);

/* Closes without asking, and waits until the window and all that belongs to it are gone. */
void driver_discard (QnWindow *window);

/* Remembers a window and its dialogs with all widgets in them, its view state and its document; waits
 * until they are gone, and forgets them. Fails where one of them stays. */
typedef struct DriverParts DriverParts;
DriverParts *driver_watch_parts (QnWindow *window);
void driver_wait_until_gone (DriverParts *parts);

/* Lays a wall of 10,000 blocks in the drawing, 40 x 17.5 m. */
void driver_lay_large_wall (QnWindow *window);

/* Picture of a window in device pixels; the caller frees it. */
cairo_surface_t *driver_picture (GtkWidget *window);

/* Picture of the window of a widget as <name>.png in the folder QUOIN_SCREENSHOTS. */
void driver_screenshot (GtkWidget *widget, const char *name);

/* The same with a parameter, taken over. */
void driver_activate_target (QnWindow *window, const char *action, GVariant *target);

/* The window on the screen, other than a main one, whose title starts so; or NULL. */
GtkWidget *driver_find_dialog (const char *title);

/* The page in sight under the drawing of a window, whose title starts so; or NULL. */
GtkWidget *driver_find_page (const char *title);

/* The question that is on the screen, or NULL. */
GtkWidget *driver_find_message (void);

/* The first widget below `root`, itself included, that matches; or NULL. */
typedef gboolean (*DriverMatch) (GtkWidget *widget, gconstpointer data);
GtkWidget *driver_find_widget (GtkWidget *root, DriverMatch match, gconstpointer data);

/* Matches: by the id in a .ui file; by name; labels in sight that hold some words; by label; menus that are
 * open; a run in the page of comparisons. */
gboolean driver_has_id (GtkWidget *widget, gconstpointer id);
gboolean driver_has_name (GtkWidget *widget, gconstpointer name);
gboolean driver_says (GtkWidget *widget, gconstpointer text);
gboolean driver_is_button (GtkWidget *widget, gconstpointer label);
gboolean driver_is_check (GtkWidget *widget, gconstpointer label);
gboolean driver_is_expander (GtkWidget *widget, gconstpointer label);
gboolean driver_is_menu (GtkWidget *widget, gconstpointer data);
gboolean driver_is_cell (GtkWidget *widget, gconstpointer data);

/* The widget of that id, which must be there. */
GtkWidget *driver_find_id (GtkWidget *root, const char *id);

/* The window on the screen that is no main one, or NULL. */
GtkWidget *driver_find_other (void);

/* The values in view of a plot (app/widgets/plot-view.h). */
QnBox driver_plot_range (GtkWidget *plot);

/* Name of the last step of the history. */
const char *driver_last_step (QnWindow *window);

/* Clicks with the pointer on the first widget that matches; there must be one. */
void driver_click_on (GtkWidget *root, DriverMatch match, const char *label);

/* Shows the panel of the analysis with all of its cards open. */
void driver_open_analysis (QnWindow *window);

/* Unfolds all that is folded below a widget, which is no part of the tree before. */
void driver_unfold (GtkWidget *widget);

/* Presses the button of that label, which must be there and sensitive. */
void driver_press (GtkWidget *root, const char *label);

/* From here on warnings that GTK 4.8 gives of itself end nothing: those that are listed in driver.c, no
 * other. */
void driver_pass_over_gtk (void);
