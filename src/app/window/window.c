#include "app/window/window-private.h"

#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include "app/widgets/layouts.h"
#include "app/widgets/settings.h"
#include "app/widgets/shortened.h"
#include "app/widgets/text-unit.h"
#include "app/window/action-table.h"
#include "doc/document/document.h"
#include "doc/document/import.h"
#include "doc/text/explain.h"
#include "io/exchange/drawing-import.h"
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <string.h>

/* How long good news stay. */
#define MESSAGE_SECONDS 6

/* px of the window beside the side panel, below which the panel folds away. */
#define DRAWING_WIDTH 550

/* px beside the side panel below which there is no drawing while it is open, with text of usual size: its
 * buttons need them. */
#define LEAST_DRAWING 260

/* px of the window below which the title has no room between all buttons, with text of usual size. */
#define TITLED_WIDTH 800

/* Of what is told of a running analysis, where there is room. */
#define PROGRESS_CHARS 24

G_DEFINE_FINAL_TYPE (QnWindow, qn_window, GTK_TYPE_APPLICATION_WINDOW)

QnDocument *
qn_window_get_document (QnWindow *self)
{
  return self->document;
}

/* ---- what the window says ---- */

static void
update_title (QnWindow *self)
{
  g_autofree char *name = qn_document_dup_display_name (self->document);
  const char *path = self->document->path;
  g_autofree char *base = path != NULL ? g_path_get_basename (path) : NULL;
  gboolean modified =
    qn_document_is_modified (self->document) && !qn_window_is_blank (self);
  g_autofree char *title = g_strdup_printf ("%s%s", modified ? "• " : "", name);
  g_autofree char *subtitle = g_strdup (_ ("Not saved yet"));
  if (path != NULL) {
    g_free (subtitle);
    g_autofree char *place = qn_shortened_dup_folder (path);
    /* A project without a title is called by its file. */
    subtitle = g_str_equal (base, name) ? g_steal_pointer (&place)
                                        : g_strdup_printf ("%s — %s", base, place);
  }
  gboolean blank = qn_window_is_blank (self);
  gtk_label_set_text (self->title_label, blank ? _ ("Quoin") : title);
  gtk_label_set_text (
    self->subtitle_label,
    self->is_small && base != NULL && !g_str_equal (base, name) ? base : subtitle);
  gtk_widget_set_tooltip_text (gtk_widget_get_parent (GTK_WIDGET (self->title_label)),
                               blank ? NULL : subtitle);
  gtk_widget_set_visible (GTK_WIDGET (self->subtitle_label), !blank);
  g_autofree char *window_title =
    blank ? g_strdup (_ ("Quoin")) : g_strdup_printf ("%s — Quoin", title);
  gtk_window_set_title (GTK_WINDOW (self), window_title);
}

static void
update_history (QnWindow *self)
{
  QnEditHistory *history = self->document->history;
  guint position = history->position;
  gboolean own = qn_window_page_has (self, "undo");
  g_autofree char *undo =
    own ? g_strdup (_ ("Undo"))
    : history->position > 0
      ? g_strdup_printf (_ ("Undo %s"), qn_history_get_name (history, position - 1))
      : g_strdup (_ ("Nothing to undo"));
  g_autofree char *redo =
    own ? g_strdup (_ ("Redo"))
    : history->position < history->steps->len
      ? g_strdup_printf (_ ("Redo %s"), qn_history_get_name (history, position))
      : g_strdup (_ ("Nothing to redo"));
  g_autofree char *undo_tooltip = qn_action_dup_tooltip (undo, "win.undo");
  g_autofree char *redo_tooltip = qn_action_dup_tooltip (redo, "win.redo");
  gtk_widget_set_tooltip_text (GTK_WIDGET (self->undo_button), undo_tooltip);
  gtk_widget_set_tooltip_text (GTK_WIDGET (self->redo_button), redo_tooltip);
  update_title (self);
  qn_window_update_actions (self);
}

static void
update_counts (QnWindow *self)
{
  const QnModel *model = &self->document->project.model;
  const QnContacts *contacts = &self->document->contacts;
  const QnCount counts[] = { { QN_COUNTED_BEAMS, model->beam_count },
                             { QN_COUNTED_BLOCKS, model->block_count },
                             { QN_COUNTED_FACES, contacts->face_count },
                             { QN_COUNTED_FINDINGS, contacts->findings.count } };
  gsize skipped = model->beam_count > 0 ? 0 : 1;
  g_autofree char *text =
    qn_counts_dup_text (counts + skipped, G_N_ELEMENTS (counts) - skipped, " · ");
  gtk_label_set_text (self->status_counts, text);
}

static void
update_status (QnWindow *self)
{
  g_autofree char *pointer = qn_canvas_dup_status (self->canvas);
  gtk_label_set_text (self->status_hint, _ (self->canvas->tool->hint));
  gtk_label_set_text (self->status_pointer, pointer);
}

static void
update_stale (QnWindow *self)
{
  const QnRun *run = self->document->run;
  gboolean shown = run != NULL && qn_view_needs_result (self->state->options.view);
  QnRunAge age = shown ? qn_document_get_run_age (self->document, run) : QN_RUN_CURRENT;
  gtk_label_set_text (GTK_LABEL (self->stale_label), qn_run_age_text (age));
  gtk_widget_set_css_classes (
    self->stale_label,
    (const char *[]){ age == QN_RUN_OF_STUDY ? "live" : "stale", NULL });
  gtk_widget_set_visible (self->stale_label, age != QN_RUN_CURRENT);
}

/* The name of the view on the button that stands for all of them where the drawing is narrow. */
static void
update_view_menu (QnWindow *self)
{
  for (GtkWidget *child = gtk_widget_get_first_child (GTK_WIDGET (self->view_switcher));
       child != NULL; child = gtk_widget_get_next_sibling (child))
    if (gtk_toggle_button_get_active (GTK_TOGGLE_BUTTON (child)))
      gtk_menu_button_set_label (self->view_button,
                                 gtk_button_get_label (GTK_BUTTON (child)));
}

/* Beams have views that blocks do not need. Colours, and section forces in their place, keep it where
 * they say nothing, so that the buttons beside them keep theirs. */
static void
update_view_buttons (QnWindow *self)
{
  const QnRun *run = self->document->run;
  gboolean beams = self->document->project.model.beam_count > 0
                   || (run != NULL && run->result.beam_forces != NULL);
  gboolean shown = self->state->options.view == QN_VIEW_DIAGRAMS;
  gtk_widget_set_visible (self->diagrams_button, beams || shown);
  QnView view = self->state->options.view;
  gtk_widget_set_visible (self->shown_stack, run != NULL || qn_view_needs_result (view));
  gtk_widget_set_sensitive (self->field_button, qn_view_needs_result (view));
  gtk_stack_set_visible_child (GTK_STACK (self->shown_stack),
                               shown ? self->diagram_box : self->field_button);
}

static void
on_document_changed (QnWindow *self)
{
  gtk_widget_set_visible (self->info_bar, FALSE);
  update_title (self);
  update_counts (self);
  update_stale (self);
  update_view_buttons (self);
  qn_window_update_actions (self);
}

static void
on_view_changed (QnWindow *self)
{
  update_stale (self);
  update_view_buttons (self);
  qn_window_update_actions (self);
  update_view_menu (self);
}

void
qn_window_show_error (gpointer window, const char *message)
{
  QnWindow *self = window;
  /* Work that outlives its window has nobody to tell. */
  if (self->info_label == NULL)
    return;
  g_clear_handle_id (&self->message_timeout, g_source_remove);
  gtk_widget_add_css_class (self->info_bar, "warning");
  gtk_label_set_text (self->info_label, message);
  gtk_widget_set_visible (GTK_WIDGET (self->info_button), FALSE);
  gtk_widget_set_visible (self->info_bar, TRUE);
}

static gboolean
on_message_timeout (gpointer data)
{
  QnWindow *self = data;
  self->message_timeout = 0;
  gtk_widget_set_visible (self->info_bar, FALSE);
  return G_SOURCE_REMOVE;
}

void
qn_window_show_message (gpointer window, const char *message)
{
  QnWindow *self = window;
  qn_window_show_error (self, message);
  if (self->info_label == NULL)
    return;
  gtk_widget_remove_css_class (self->info_bar, "warning");
  self->message_timeout =
    g_timeout_add_seconds (MESSAGE_SECONDS, on_message_timeout, self);
}

void
qn_window_show_error_at (QnWindow *self, const char *message, QnVec2 at)
{
  qn_window_show_error (self, message);
  self->info_place = at;
  gtk_widget_set_visible (GTK_WIDGET (self->info_button), TRUE);
}

static void
on_info_button (QnWindow *self)
{
  qn_canvas_show_place (self->canvas, self->info_place);
}

/* Undo, Solve and Cancel act on what is in sight. */
static void
on_page_changed (QnWindow *self)
{
  const char *page = gtk_stack_get_visible_child_name (self->pages);
  const char *const labels[] = { _ ("So_lve"), _ ("_Find Envelope"), _ ("_Compute Curve"),
                                 _ ("_Run Study") };
  const char *const hints[] = { _ ("Solve"), _ ("Find the worst position of the load"),
                                _ ("Capacity curve against a spectrum"),
                                _ ("Compute the cases of the study") };
  const int what = !qn_window_page_has (self, "run")   ? 0
                   : g_strcmp0 (page, "envelope") == 0 ? 1
                   : g_strcmp0 (page, "capacity") == 0 ? 2
                                                       : 3;
  gtk_button_set_label (self->run_button, labels[what]);
  g_autofree char *hint = qn_action_dup_tooltip (hints[what], "win.run-shown");
  gtk_widget_set_tooltip_text (GTK_WIDGET (self->run_button), hint);
  gtk_accessible_update_property (GTK_ACCESSIBLE (self->run_button),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, hints[what], -1);
  update_history (self);
}

static void
on_info_close (QnWindow *self)
{
  gtk_widget_set_visible (self->info_bar, FALSE);
}

/* ---- opening ---- */

gboolean
qn_window_is_blank (QnWindow *self)
{
  return g_strcmp0 (gtk_stack_get_visible_child_name (self->main_stack), "start") == 0;
}

void
qn_window_show_work (QnWindow *self)
{
  gtk_stack_set_visible_child_name (self->main_stack, "work");
  gtk_widget_grab_focus (GTK_WIDGET (self->canvas));
  update_title (self);
  qn_window_update_actions (self);
}

static gboolean
show_loaded (QnWindow *self, const GError *error)
{
  if (error != NULL) {
    qn_window_show_error (self, error->message);
    return FALSE;
  }
  gtk_window_present (GTK_WINDOW (self));
  qn_window_show_work (self);
  qn_view_state_set_view (self->state, QN_VIEW_MODEL);
  qn_canvas_fit (self->canvas);
  const GPtrArray *warnings = qn_document_get_project (self->document)->warnings;
  if (warnings != NULL && warnings->len > 0)
    qn_window_show_error (self, g_ptr_array_index (warnings, 0));
  return TRUE;
}

gboolean
qn_window_open_path (QnWindow *self, const char *path)
{
  g_autofree char *absolute = g_canonicalize_filename (path, NULL);
  g_autoptr (GError) error = NULL;
  if (qn_import_knows_file (path) || qn_import_is_picture (path)
      || qn_is_result_file (path)) {
    gtk_window_present (GTK_WINDOW (self));
    qn_window_take_file (self, absolute);
    return TRUE;
  }
  if (g_str_has_suffix (path, ".quoin-study"))
    return qn_window_open_study (self, absolute);
  qn_document_load (self->document, absolute, &error);
  if (!show_loaded (self, error))
    return FALSE;
  qn_window_remember_recent (absolute);
  return TRUE;
}

gboolean
qn_window_open_copy (QnWindow *self, const char *path)
{
  g_autoptr (GError) error = NULL;
  qn_document_load_copy (self->document, path, &error);
  return show_loaded (self, error);
}

gboolean
qn_window_open_recovered (QnWindow *self, const char *recovery_path)
{
  g_autofree char *text = NULL, *original = NULL;
  g_autoptr (GError) error = NULL;
  if (!qn_recovery_read (recovery_path, &text, &original, &error)
      || !qn_document_load_recovered (self->document, text, original, &error)) {
    qn_window_show_error (self, error->message);
    return FALSE;
  }
  gtk_window_present (GTK_WINDOW (self));
  if (qn_recovery_flush (self->recovery))
    g_unlink (recovery_path);
  qn_window_show_work (self);
  qn_canvas_fit (self->canvas);
  g_autofree char *message =
    original != NULL ? g_strdup_printf (
      _ ("Recovered what was not saved to %s. Save it to keep it."), original)
                     : g_strdup (_ ("Recovered an unsaved drawing. Save it to keep it."));
  qn_window_show_error (self, message);
  return TRUE;
}

/* ---- construction ---- */

static void
build_tools (QnWindow *self)
{
  for (int i = 0; qn_tools[i] != NULL; i++) {
    const QnTool *tool = qn_tools[i];
    GtkWidget *button = gtk_toggle_button_new ();
    gtk_button_set_icon_name (GTK_BUTTON (button), tool->icon);
    gtk_widget_add_css_class (button, "flat");
    g_autofree char *key = g_ascii_strup (tool->accel, -1);
    g_autofree char *tooltip = g_strdup_printf ("%s (%s)", _ (tool->label), key);
    gtk_widget_set_tooltip_text (button, tooltip);
    gtk_accessible_update_property (GTK_ACCESSIBLE (button),
                                    GTK_ACCESSIBLE_PROPERTY_LABEL, _ (tool->label), -1);
    gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.tool");
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", tool->name);
    gtk_box_append (self->tool_box, button);
  }
  qn_layout_even_columns (GTK_WIDGET (self->tool_box));
}

static void
connect_document (QnWindow *self)
{
  const struct {
    gpointer source;
    const char *signal;
    void (*func) (QnWindow *);
  } signals[] = {
    { self->document, "changed", on_document_changed },
    { self->document, "history-changed", update_history },
    { self->document, "file-changed", update_title },
    { self->document, "runs-changed", on_view_changed },
    { self->state, "changed", on_view_changed },
    { self->document->selection, "changed", qn_window_update_actions },
    { self->canvas, "status", update_status },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (signals); i++)
    qn_watch (GTK_WIDGET (self), signals[i].source, signals[i].signal,
              G_CALLBACK (signals[i].func), self);
  qn_watch (GTK_WIDGET (self), self->canvas, "failed", G_CALLBACK (qn_window_show_error),
            self);
}

static void
build_panels (QnWindow *self)
{
  GtkWidget *drawing = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  gtk_box_append (GTK_BOX (drawing), qn_properties_panel_new (self->canvas));
  gtk_box_append (GTK_BOX (drawing),
                  qn_form_show (qn_form_new (&qn_picture_form, self->canvas)));
  gtk_scrolled_window_set_child (self->properties_scroller, drawing);
  gtk_scrolled_window_set_child (self->analysis_scroller,
                                 qn_analysis_panel_new (self->canvas));
  gtk_scrolled_window_set_child (self->result_scroller,
                                 qn_result_panel_new (self->canvas));
  gtk_scrolled_window_set_child (self->findings_scroller,
                                 qn_findings_panel_new (self->canvas));
  self->playback = qn_playback_bar_new (self->state);
  gtk_box_append (self->canvas_box, self->playback);
  gtk_box_append (self->start_box, qn_start_page_new ());
  GtkWidget *popover = gtk_popover_new ();
  gtk_popover_set_child (GTK_POPOVER (popover), qn_history_list_new (self->document));
  gtk_menu_button_set_popover (self->history_button, popover);
}

/* Messages lie over the drawing, not over the side panel. */
static gboolean
place_message (GtkOverlay *overlay, GtkWidget *message, GdkRectangle *place,
               QnWindow *self)
{
  graphene_rect_t room;
  int least, usual;
  gtk_widget_measure (message, GTK_ORIENTATION_HORIZONTAL, -1, &least, &usual, NULL,
                      NULL);
  if (!gtk_widget_get_mapped (GTK_WIDGET (self->canvas))
      || !gtk_widget_compute_bounds (GTK_WIDGET (self->canvas), GTK_WIDGET (overlay),
                                     &room)
      || room.size.width < (float) least)
    return FALSE;
  place->width = MIN (usual, (int) room.size.width);
  gtk_widget_measure (message, GTK_ORIENTATION_VERTICAL, place->width, NULL,
                      &place->height, NULL, NULL);
  place->x = (int) (room.origin.x + 0.5f * (room.size.width - (float) place->width));
  place->y = (int) (room.origin.y + room.size.height) - place->height;
  return TRUE;
}

/* In a narrow window the drawing comes first: the side panel folds away, and comes back where there is
 * room again, or when it is asked for. */
static void
on_layout (GdkSurface *surface, int width, int height, QnWindow *self)
{
  if (!gtk_widget_has_css_class (self->side_panel, "fitted"))
    gtk_widget_measure (GTK_WIDGET (self->side_stack), GTK_ORIENTATION_HORIZONTAL, -1,
                        &self->panel_width, NULL, NULL, NULL);
  const int panel = self->panel_width;
  const double text = qn_text_unit (GTK_WIDGET (self)) / QN_TEXT_UNIT;
  gboolean narrow = width < DRAWING_WIDTH + panel;
  gboolean tight = width < LEAST_DRAWING * text + panel,
           small = width < TITLED_WIDTH * text;
  if (small != self->is_small) { /* the menu has them too */
    self->is_small = small;
    gtk_widget_set_visible (self->open_button, !small);
    gtk_widget_set_visible (self->save_button, !small);
    gtk_label_set_width_chars (self->progress_label, small ? 3 : PROGRESS_CHARS);
    update_title (self);
  }
  if (tight != self->is_tight) {
    self->is_tight = tight;
    qn_window_arrange (self);
  }
  /* Large text asks for more than there may be. */
  if (width < panel)
    gtk_widget_add_css_class (self->side_panel, "fitted");
  else
    gtk_widget_remove_css_class (self->side_panel, "fitted");
  if (narrow == self->is_narrow)
    return;
  self->is_narrow = narrow;
  gtk_widget_set_visible (self->export_button, !narrow); /* the menu has it too */
  g_action_group_change_action_state (G_ACTION_GROUP (self), "side-panel",
                                      g_variant_new_boolean (!narrow));
  qn_window_arrange (self);
}

void
qn_window_arrange (QnWindow *self)
{
  gboolean panel = gtk_widget_get_visible (self->side_panel);
  gboolean covered = gtk_widget_get_visible (self->page_box)
                     && gtk_toggle_button_get_active (self->fill_button);
  gtk_widget_set_visible (GTK_WIDGET (self->canvas_box), !covered);
  gtk_widget_set_visible (GTK_WIDGET (self->tool_box),
                          !covered && (!self->is_narrow || !panel));
  /* Where there is no room for both, the panel is there instead of the drawing. */
  gtk_widget_set_visible (GTK_WIDGET (self->middle), !self->is_tight || !panel);
  gtk_widget_set_hexpand (self->side_panel, self->is_tight);
  on_page_changed (self);
}

/* A window that begins narrow must not grow by its side panel first. */
static void
on_realize (QnWindow *self)
{
  int width = 0, height = 0;
  gtk_window_get_default_size (GTK_WINDOW (self), &width, &height);
  on_layout (NULL, width, height, self);
  g_signal_connect_object (gtk_native_get_surface (GTK_NATIVE (self)), "layout",
                           G_CALLBACK (on_layout), self, 0);
}

static const QnToolSettings first_settings = { .masonry = { .unit = { 0.4, 0.175 },
                                                            .bond = QN_BOND_RUNNING,
                                                            .lap = 0.5,
                                                            .thickness = 1.0,
                                                            .law = QN_NONE,
                                                            .base = TRUE,
                                                            .kind = QN_MASONRY_COLUMN,
                                                            .head = QN_HEAD_FLAT,
                                                            .span = QN_SPAN_LINTEL,
                                                            .shape = QN_ARCH_CIRCULAR,
                                                            .ring = 0.3,
                                                            .voussoirs = 15,
                                                            .top_to_foot = 1.0 },
                                               .elements = 1,
                                               .force = 1000.0,
                                               .intensity = 1e4,
                                               .live = TRUE };

static void
qn_window_init (QnWindow *self)
{
  g_type_ensure (QN_TYPE_CANVAS);
  gtk_widget_init_template (GTK_WIDGET (self));
  qn_layout_first_fit (gtk_widget_get_parent (GTK_WIDGET (self->view_switcher)));
  qn_action_complete_tooltips (GTK_WIDGET (self));
  qn_shortened_tell (GTK_WIDGET (self));
  qn_popovers_attend (GTK_WIDGET (self));
  self->document = qn_document_new ();
  self->state = qn_view_state_new (self->document);
  self->tool_settings = first_settings;
  self->tool_settings.masonry.unit_weight = QN_IMPORT_DEFAULTS.unit_weight;
  qn_canvas_set_state (self->canvas, self->state, &self->tool_settings, &qn_tool_select);
  qn_window_add_actions (self);
  qn_window_add_keys (self);
  build_tools (self);
  build_panels (self);
  qn_window_add_help_pages (self);
  connect_document (self);
  qn_window_connect_analysis (self);
  self->recovery = qn_recovery_watch (self->document);
  /* Opposite to the legend, which stays where it is in every script. */
  gtk_widget_set_direction (GTK_WIDGET (self->view_box), GTK_TEXT_DIR_LTR);
  g_set_weak_pointer (&self->canvas->corner, GTK_WIDGET (self->view_box));
  /* A new window is as the last one; none follows another. */
  static const char *const places[][2] = { { "window-width", "default-width" },
                                           { "window-height", "default-height" },
                                           { "window-maximized", "maximized" } };
  for (gsize i = 0; i < G_N_ELEMENTS (places); i++)
    g_settings_bind (qn_settings_get (), places[i][0], self, places[i][1],
                     G_SETTINGS_BIND_DEFAULT | G_SETTINGS_BIND_GET_NO_CHANGES);
  g_signal_connect (self, "realize", G_CALLBACK (on_realize), NULL);
  qn_window_add_context_menu (self);
  qn_window_accept_drops (self);
  update_counts (self);
  update_history (self);
  update_status (self);
  update_view_buttons (self);
  update_view_menu (self);
}

void
qn_window_commit_entry (QnWindow *self)
{
  gboolean drawing = gtk_widget_get_mapped (GTK_WIDGET (self->canvas));
  if (GTK_IS_EDITABLE (gtk_window_get_focus (GTK_WINDOW (self))))
    gtk_window_set_focus (GTK_WINDOW (self), drawing ? GTK_WIDGET (self->canvas) : NULL);
  GtkWindow *apart = GTK_WINDOW (self->page_window);
  if (apart != NULL && GTK_IS_EDITABLE (gtk_window_get_focus (apart)))
    gtk_window_set_focus (apart, NULL);
}

static gboolean
qn_window_close_request (GtkWindow *window)
{
  QnWindow *self = QN_WINDOW (window);
  qn_window_commit_entry (self);
  if (!qn_window_may_close (self))
    return TRUE;
  qn_document_cancel (self->document);
  if (self->reporting != NULL)
    g_cancellable_cancel (self->reporting);
  qn_window_take_pages_back (self);
  return GTK_WINDOW_CLASS (qn_window_parent_class)->close_request (window);
}

static void
qn_window_dispose (GObject *object)
{
  QnWindow *self = QN_WINDOW (object);
  g_clear_handle_id (&self->live_timeout, g_source_remove);
  g_clear_handle_id (&self->message_timeout, g_source_remove);
  g_clear_pointer (&self->recovery, qn_recovery_end);
  if (self->document != NULL)
    qn_document_cancel (self->document);
  qn_window_forget_settings (self);
  if (self->pages != NULL)
    qn_window_remove_pages (self);
  /* Forms act on the canvas, also while they lose focus and rows: they go before it does. */
  GtkScrolledWindow *scrollers[] = { self->properties_scroller, self->analysis_scroller,
                                     self->result_scroller, self->findings_scroller };
  for (gsize i = 0; i < G_N_ELEMENTS (scrollers); i++)
    if (scrollers[i] != NULL)
      gtk_scrolled_window_set_child (scrollers[i], NULL);
  gtk_widget_dispose_template (GTK_WIDGET (self), QN_TYPE_WINDOW);
  G_OBJECT_CLASS (qn_window_parent_class)->dispose (object);
}

static void
qn_window_finalize (GObject *object)
{
  QnWindow *self = QN_WINDOW (object);
  g_clear_object (&self->reporting);
  g_clear_object (&self->state);
  g_clear_object (&self->document);
  g_free (self->after_save);
  g_free (self->last_export);
  g_clear_pointer (&self->last_recipe, qn_recipe_free);
  g_free (self->tool_settings.joint_law);
  g_free (self->tool_settings.section);
  G_OBJECT_CLASS (qn_window_parent_class)->finalize (object);
}

static void
qn_window_class_init (QnWindowClass *klass)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  G_OBJECT_CLASS (klass)->dispose = qn_window_dispose;
  G_OBJECT_CLASS (klass)->finalize = qn_window_finalize;
  GTK_WINDOW_CLASS (klass)->close_request = qn_window_close_request;
  gtk_widget_class_set_template_from_resource (widget_class,
                                               "/io/github/quoin/Quoin/window.ui");
#define BIND(type, name)                                                                 \
  gtk_widget_class_bind_template_child (widget_class, QnWindow, name);
  QN_WINDOW_CHILDREN (BIND)
#undef BIND
  gtk_widget_class_bind_template_callback (widget_class, place_message);
  gtk_widget_class_bind_template_callback (widget_class, on_info_button);
  gtk_widget_class_bind_template_callback (widget_class, on_page_changed);
  gtk_widget_class_bind_template_callback_full (widget_class, "qn_window_arrange_pages",
                                                G_CALLBACK (qn_window_arrange));
  gtk_widget_class_bind_template_callback (widget_class, on_info_close);
}

QnWindow *
qn_window_new (GtkApplication *application)
{
  return g_object_new (QN_TYPE_WINDOW, "application", application, NULL);
}
