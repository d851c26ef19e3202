/* A vehicle that moves over the structure: it is dragged over it, with the multipliers of all positions below
 * over the same axis. What is chosen is kept with the project; the answers are found again. */
#include "app/pages/pages.h"

#include "app/forms/form.h"
#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/help.h"
#include "app/widgets/text-unit.h"
#include "core/base/integer.h"
#include "doc/document/digest.h"
#include "doc/text/explain.h"
#include "doc/view/figure-export.h"
#include "io/project/project-vehicle.h"
#include "study/report/envelope-figure.h"
#include <glib/gi18n.h>
#include <math.h>

/* ms between two looks at an envelope that is being found; s of one motion to collapse and back. */
#define INTERVAL 50
#define PERIOD   3.0

/* px: a curve this near to the pointer is meant. */
#define NEAR 40.0

typedef struct Page {
  QnDocument *document;
  GtkWidget *page, *area, *scale, *vehicles;
  GtkLabel *status, *chosen;
  GtkDropDown *ways, *method, *line;
  GtkSpinButton *step, *convoy;
  GtkAdjustment *position;
  GtkProgressBar *progress;
  GtkToggleButton *animate;
  GSimpleActionGroup *actions;
  GObject *chooser;
  gboolean showing; /* what is kept is being shown: nobody has entered anything */

  QnEnvelopeSettings settings;
  QnEnvelope envelope; /* .count 0: none */
  QnModel moved;       /* the structure with the vehicle at the position that is shown */
  QnEnvelopeFigure figure;
  char *digest,
    *digest_put;     /* of the project when it was found, and with the vehicle put */
  gboolean outdated; /* the project is neither */

  GThread *thread; /* while it is being found; it owns what follows until it has ended */
  QnStatus ended;
  QnDiag diag;
  gint cancelled, over; /* atomic */
  guint timeout, tick;
} Page;

static void
tell (Page *self, const char *text)
{
  gtk_label_set_text (self->status, text);
}

static void
update_actions (Page *self)
{
  QnEnvelopePlace least;
  const gboolean found = self->envelope.count > 0;
  const struct {
    const char *name;
    gboolean enabled;
  } actions[] = {
    { "run", self->thread == NULL },
    { "cancel", self->thread != NULL },
    { "put", found },
    { "worst", found && qn_envelope_find_least (&self->envelope, &least) },
    { "export", found && self->thread == NULL },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
    g_simple_action_set_enabled (G_SIMPLE_ACTION (g_action_map_lookup_action (
                                   G_ACTION_MAP (self->actions), actions[i].name)),
                                 actions[i].enabled);
}

/* ---- the position that is shown ---- */

static void
compare_digests (Page *self)
{
  g_autofree char *digest = qn_model_digest (qn_document_get_project (self->document));
  self->outdated =
    g_strcmp0 (digest, self->digest) != 0 && g_strcmp0 (digest, self->digest_put) != 0;
}

static void
tell_position (Page *self)
{
  const QnEnvelope *e = &self->envelope;
  if (isnan (qn_envelope_multiplier (e, self->figure.shown))) {
    tell (self, self->thread != NULL ? "" : _ ("Nothing collapses at this position."));
    return;
  }
  g_autofree char *words =
    qn_envelope_dup_text (e, self->figure.shown, self->thread == NULL);
  g_autofree char *text =
    self->outdated ? g_strjoin ("\n", words, _ ("The model has changed since."), NULL)
                   : g_steal_pointer (&words);
  tell (self, text);
}

static void
show_position (Page *self, QnEnvelopePlace at)
{
  QnModel moved;
  QnDiag diag;
  if (self->envelope.count == 0
      || qn_envelope_move (&self->envelope, at, &moved, &diag) != QN_OK)
    return;
  qn_model_clear (&self->moved);
  self->moved = moved;
  self->figure.shown = at;
  self->showing = TRUE;
  gtk_adjustment_set_value (self->position, (double) at.position);
  gtk_drop_down_set_selected (self->line, (guint) at.line);
  self->showing = FALSE;
  tell_position (self);
  gtk_widget_queue_draw (self->area);
}

static void
on_position (Page *self)
{
  if (!self->showing)
    show_position (self, (QnEnvelopePlace){
                           gtk_drop_down_get_selected (self->line),
                           (gsize) qn_to_integer (
                             gtk_adjustment_get_value (self->position), 0, G_MAXINT32) });
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  Page *self = data;
  const QnPage page = {
    width, height, qn_text_unit (GTK_WIDGET (area)), true, false, NULL
  };
  g_autoptr (GError) error = NULL;
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  if (self->envelope.count > 0 && !qn_envelope_draw (cr, &page, &self->figure, &error))
    tell (self, error->message);
}

/* The front follows the pointer; near a curve that curve is meant. */
static void
go_to (Page *self, double x, double y)
{
  const QnEnvelope *e = &self->envelope;
  const QnPlotPlace *place = &self->figure.place;
  if (e->count == 0 || !(place->x_scale > 0))
    return;
  const double step = e->count > 1 ? e->x[1] - e->x[0] : 1;
  QnEnvelopePlace at = self->figure.shown;
  double nearest = NEAR;
  at.position =
    (gsize) qn_to_integer (rint (((x - place->x_zero) / place->x_scale - e->x[0]) / step),
                           0, (int32_t) e->count - 1);
  for (gsize k = 0; k < e->line_count; k++) {
    double m = qn_envelope_multiplier (e, (QnEnvelopePlace){ k, at.position });
    double distance = fabs (place->y_zero + place->y_scale * m - y);
    if (distance < nearest) { /* false for NaN */
      nearest = distance;
      at.line = k;
    }
  }
  show_position (self, at);
}

static void
on_drag_begin (GtkGestureDrag *gesture, double x, double y, Page *self)
{
  gtk_widget_grab_focus (self->scale); /* for its keys */
  go_to (self, x, y);
}

static void
on_drag_update (GtkGestureDrag *gesture, double dx, double dy, Page *self)
{
  double x, y;
  if (gtk_gesture_drag_get_start_point (gesture, &x, &y))
    go_to (self, x + dx, y + dy);
}

static gboolean
on_tick (GtkWidget *area, GdkFrameClock *clock, gpointer data)
{
  Page *self = data;
  double time = (double) gdk_frame_clock_get_frame_time (clock) / G_USEC_PER_SEC;
  self->figure.phase = 0.5 - 0.5 * cos (2 * G_PI * time / PERIOD);
  gtk_widget_queue_draw (area);
  return G_SOURCE_CONTINUE;
}

static void
on_animate (Page *self)
{
  if (self->tick != 0)
    gtk_widget_remove_tick_callback (self->area, self->tick);
  self->tick = gtk_toggle_button_get_active (self->animate)
                 ? gtk_widget_add_tick_callback (self->area, on_tick, self, NULL)
                 : 0;
  self->figure.phase = 1;
  gtk_widget_queue_draw (self->area);
}

/* ---- what is chosen ---- */

static const QnLoad *
load_of (Page *self)
{
  const QnModel *model = qn_document_get_model (self->document);
  gsize load = qn_find_vehicle_load (model);
  return load == G_MAXSIZE ? NULL : &model->live_loads[load];
}

static void
store (Page *self)
{
  g_autofree char *json = qn_envelope_settings_to_json (&self->settings);
  g_autoptr (GError) error = NULL;
  if (!qn_document_edit_extra (self->document, _ ("Set Moving Load"), QN_ENVELOPE_MEMBER,
                               QN_ENVELOPE_MEMBER, json, &error))
    tell (self, error->message);
}

static gboolean
set_convoy (QnModel *model, gpointer data, GError **error)
{
  model->live_loads[qn_find_vehicle_load (model)].convoy = *(const int32_t *) data;
  return TRUE;
}

static void
on_setting (Page *self)
{
  int32_t convoy = gtk_spin_button_get_value_as_int (self->convoy);
  const QnLoad *load = load_of (self);
  g_autoptr (GError) error = NULL;
  if (self->showing || load == NULL)
    return;
  self->settings.ways = (QnWays) gtk_drop_down_get_selected (self->ways);
  self->settings.method = (QnEnvelopeMethod) gtk_drop_down_get_selected (self->method);
  self->settings.step = gtk_spin_button_get_value (self->step);
  if (load->convoy == convoy)
    store (self);
  else if (!qn_document_edit (self->document, _ ("Set Convoy"), "envelope-convoy",
                              set_convoy, &convoy, &error))
    tell (self, error->message);
}

static void
on_vehicle (Page *self)
{
  if (self->showing)
    return;
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  gsize count = 0;
  for (GtkWidget *check = gtk_widget_get_first_child (self->vehicles); check != NULL;
       check = gtk_widget_get_next_sibling (check))
    if (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)) && ++count > 0)
      g_strv_builder_add (names, gtk_check_button_get_label (GTK_CHECK_BUTTON (check)));
  g_strfreev (self->settings.vehicles);
  self->settings.vehicles = count > 0 ? g_strv_builder_end (names) : NULL;
  store (self);
}

/* The vehicles of the project and those that are built in, with those that are moved checked. */
static void
show_vehicles (Page *self, const QnModel *model, const QnLoad *load)
{
  g_auto (GStrv) names = qn_dup_vehicle_names (model);
  const char *own[] = { model->vehicles[load->vehicle].name, NULL };
  const char *const *chosen =
    self->settings.vehicles != NULL ? (const char *const *) self->settings.vehicles : own;
  g_autofree char *text = g_strjoinv (", ", (char **) chosen);
  GtkWidget *check = gtk_widget_get_first_child (self->vehicles), *next;
  gtk_label_set_text (self->chosen, text);
  for (gsize i = 0; names[i] != NULL; i++) {
    if (check == NULL) {
      check = gtk_check_button_new ();
      gtk_box_append (GTK_BOX (self->vehicles), check);
      g_signal_connect_swapped (check, "toggled", G_CALLBACK (on_vehicle), self);
    }
    gtk_check_button_set_label (GTK_CHECK_BUTTON (check), names[i]);
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                                 g_strv_contains (chosen, names[i]));
    check = gtk_widget_get_next_sibling (check);
  }
  for (; check != NULL; check = next) {
    next = gtk_widget_get_next_sibling (check);
    gtk_box_remove (GTK_BOX (self->vehicles), check);
  }
}

static void
show_settings (Page *self)
{
  const QnLoad *load = load_of (self);
  g_autoptr (GError) error = NULL;
  if (self->envelope.count > 0)
    compare_digests (self);
  qn_envelope_settings_clear (&self->settings);
  gboolean read = qn_envelope_settings_read (qn_document_get_project (self->document),
                                             &self->settings, &error);
  self->showing = TRUE;
  gtk_drop_down_set_selected (self->ways, self->settings.ways);
  gtk_drop_down_set_selected (self->method, self->settings.method);
  gtk_spin_button_set_value (self->step, self->settings.step);
  if (load != NULL) {
    gtk_spin_button_set_value (self->convoy, load->convoy);
    show_vehicles (self, qn_document_get_model (self->document), load);
  }
  self->showing = FALSE;
  if (!read)
    tell (self, error->message);
  else if (load == NULL)
    tell (self, _ ("No vehicle is among the growing loads: add one to them first."));
  else if (self->envelope.count == 0)
    tell (self, _ ("Choose vehicles, then find the envelope: the vehicle is moved from "
                   "place to place, and the least multiplier is its adequacy factor."));
  else
    tell_position (self);
}

/* ---- finding it ---- */

static bool
on_progress (const QnProgress *progress, void *data)
{
  Page *self = data;
  return !g_atomic_int_get (&self->cancelled);
}

static gpointer
find_in_thread (gpointer data)
{
  Page *self = data;
  self->ended = qn_envelope_run (&self->envelope, on_progress, self, &self->diag);
  g_atomic_int_set (&self->over, TRUE);
  return NULL;
}

/* In the end the worst position is shown. */
static void
finish (Page *self)
{
  QnEnvelopePlace least = { 0, 0 };
  g_thread_join (g_steal_pointer (&self->thread));
  gboolean found = qn_envelope_find_least (&self->envelope, &least);
  gtk_widget_set_visible (GTK_WIDGET (self->progress), FALSE);
  show_position (self, least);
  if (self->ended != QN_OK && self->ended != QN_ERROR_CANCELLED) {
    g_autofree char *reason = qn_explain_diag (&self->envelope.model, &self->diag);
    tell (self, reason);
  } else if (self->envelope.unstable) {
    tell (self, _ ("There is no stable equilibrium under the dead load."));
  } else if (!found) {
    tell (self, _ ("No position gives a collapse."));
  }
  update_actions (self);
}

static gboolean
on_timeout (gpointer data)
{
  Page *self = data;
  const QnEnvelope *e = &self->envelope;
  gboolean over = g_atomic_int_get (&self->over);
  gtk_progress_bar_set_fraction (self->progress, (double) g_atomic_int_get (&e->done)
                                                   / (double) (e->line_count * e->count));
  gtk_widget_queue_draw (self->area);
  if (!over)
    return G_SOURCE_CONTINUE;
  self->timeout = 0;
  finish (self);
  return G_SOURCE_REMOVE;
}

static void
forget (Page *self)
{
  g_atomic_int_set (&self->cancelled, TRUE);
  if (self->thread != NULL)
    g_thread_join (g_steal_pointer (&self->thread));
  g_clear_handle_id (&self->timeout, g_source_remove);
  qn_envelope_clear (&self->envelope);
}

static void
run (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Page *self = data;
  g_autoptr (GError) error = NULL;
  forget (self);
  if (!qn_envelope_init (&self->envelope, qn_document_get_model (self->document),
                         &self->settings, &error)) {
    show_settings (self);
    tell (self, error->message);
    gtk_widget_queue_draw (self->area);
    return;
  }
  g_free (self->digest);
  g_clear_pointer (&self->digest_put, g_free);
  self->digest = qn_model_digest (qn_document_get_project (self->document));
  self->outdated = FALSE;
  g_autoptr (GtkStringList) names = gtk_string_list_new (NULL);
  for (gsize k = 0; k < self->envelope.line_count; k++)
    gtk_string_list_take (names, qn_envelope_dup_line_name (&self->envelope, k));
  self->showing = TRUE;
  gtk_drop_down_set_model (self->line, G_LIST_MODEL (names));
  gtk_adjustment_configure (self->position, 0, 0, (double) self->envelope.count - 1, 1,
                            10, 0);
  self->showing = FALSE;
  self->cancelled = self->over = FALSE;
  self->thread = g_thread_new ("envelope", find_in_thread, self);
  self->timeout = g_timeout_add (INTERVAL, on_timeout, self);
  gtk_progress_bar_set_fraction (self->progress, 0);
  gtk_widget_set_visible (GTK_WIDGET (self->progress), TRUE);
  show_position (self, (QnEnvelopePlace){ 0, 0 });
  update_actions (self);
}

static void
cancel (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  g_atomic_int_set (&((Page *) data)->cancelled, TRUE);
}

static void
go_to_worst (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Page *self = data;
  QnEnvelopePlace least;
  if (qn_envelope_find_least (&self->envelope, &least))
    show_position (self, least);
}

static gboolean
put_vehicle (QnModel *model, gpointer data, GError **error)
{
  const Page *self = data;
  const QnEnvelopeLine *line = &self->envelope.lines[self->figure.shown.line];
  QnLoad *load = &model->live_loads[qn_find_vehicle_load (model)];
  load->vehicle =
    qn_model_take_vehicle (model, self->envelope.model.vehicles[line->vehicle].name);
  load->position = self->envelope.x[self->figure.shown.position];
  load->reversed = line->reversed;
  return TRUE;
}

/* The answers are of the structure with the vehicle anywhere: they are as new as they were. */
static void
put (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Page *self = data;
  const gboolean outdated = self->outdated;
  g_autoptr (GError) error = NULL;
  if (load_of (self) == NULL
      || !qn_document_edit (self->document, _ ("Move Vehicle"), NULL, put_vehicle, self,
                            &error)) {
    tell (self, error != NULL ? error->message : "");
    return;
  }
  if (!outdated) {
    g_free (self->digest_put);
    self->digest_put = qn_model_digest (qn_document_get_project (self->document));
    self->outdated = FALSE;
  }
  tell_position (self);
}

/* ---- files ---- */

static void
export_to (gpointer data, const char *path, const GError *refused)
{
  Page *self = data;
  QnMetadata metadata;
  QnOutput output;
  g_autoptr (GError) error = refused != NULL ? g_error_copy (refused) : NULL;
  qn_document_get_metadata (self->document, &metadata);
  qn_output_init (&output);
  metadata.title = self->envelope.model.title;
  if (path != NULL && g_str_has_suffix (path, ".csv"))
    qn_envelope_write_table (&self->envelope, path, &error);
  else if (path != NULL)
    qn_envelope_export (&self->envelope, self->figure.shown, path, &output, &metadata,
                        &error);
  if (error != NULL)
    tell (self, error->message);
}

static void
export_file (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  static const char *const endings[] = { ".pdf", ".svg", ".png", ".csv", NULL };
  Page *self = data;
  const QnFileQuestion question = { _ ("Export Envelope"), _ ("_Export"),
                                    _ ("envelope.pdf"), endings, export_to };
  qn_chooser_ask (GTK_WINDOW (gtk_widget_get_root (self->page)), &self->chooser,
                  &question, self);
}

/* The same without asking. */
static void
export_path (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  export_to (data, g_variant_get_string (parameter, NULL), NULL);
}

/* ---- the page ---- */

static void
free_page (gpointer data)
{
  Page *self = data;
  qn_model_clear (&self->moved);
  qn_envelope_settings_clear (&self->settings);
  g_clear_object (&self->chooser);
  g_object_unref (self->document);
  g_free (self->digest);
  g_free (self->digest_put);
  g_free (self);
}

static void
connect (Page *self)
{
  static const GActionEntry entries[] = {
    { .name = "run", .activate = run },
    { .name = "cancel", .activate = cancel },
    { .name = "worst", .activate = go_to_worst },
    { .name = "put", .activate = put },
    { .name = "export", .activate = export_file },
    { .name = "export-path", .activate = export_path, .parameter_type = "s" },
  };
  GtkGesture *drag = gtk_gesture_drag_new ();
  const struct {
    gpointer object;
    const char *signal;
    void (*handler) (Page *self);
  } links[] = {
    { self->ways, "notify::selected", on_setting },
    { self->method, "notify::selected", on_setting },
    { self->step, "value-changed", on_setting },
    { self->convoy, "value-changed", on_setting },
    { self->line, "notify::selected", on_position },
    { self->position, "value-changed", on_position },
    { self->animate, "toggled", on_animate },
    { self->page, "destroy", forget },
  };
  self->actions = g_simple_action_group_new ();
  g_action_map_add_action_entries (G_ACTION_MAP (self->actions), entries,
                                   G_N_ELEMENTS (entries), self);
  gtk_widget_insert_action_group (self->page, "envelope", G_ACTION_GROUP (self->actions));
  g_object_set_data_full (G_OBJECT (self->page), QN_PAGE_ACTIONS, self->actions,
                          g_object_unref);
  for (gsize i = 0; i < G_N_ELEMENTS (links); i++)
    g_signal_connect_swapped (links[i].object, links[i].signal,
                              G_CALLBACK (links[i].handler), self);
  gtk_widget_set_direction (self->area, GTK_TEXT_DIR_LTR);
  gtk_widget_set_direction (self->scale, GTK_TEXT_DIR_LTR);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (self->area), draw, self, NULL);
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_drag_begin), self);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_drag_update), self);
  gtk_widget_add_controller (self->area, GTK_EVENT_CONTROLLER (drag));
  qn_watch (self->page, self->document, "changed", G_CALLBACK (show_settings), self);
}

GtkWidget *
qn_envelope_page_new (QnDocument *document)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("envelope-page");
  Page *self = g_new0 (Page, 1);
#define GET(type, name) type (gtk_builder_get_object (builder, name))
  *self = (Page){
    .document = g_object_ref (document),
    .page = qn_builder_take_widget (builder, "page"),
    .area = GET (GTK_WIDGET, "area"),
    .scale = GET (GTK_WIDGET, "scale"),
    .vehicles = GET (GTK_WIDGET, "vehicles"),
    .status = GET (GTK_LABEL, "status"),
    .chosen = GET (GTK_LABEL, "chosen"),
    .ways = GET (GTK_DROP_DOWN, "ways"),
    .method = GET (GTK_DROP_DOWN, "method"),
    .line = GET (GTK_DROP_DOWN, "line"),
    .step = GET (GTK_SPIN_BUTTON, "step"),
    .convoy = GET (GTK_SPIN_BUTTON, "convoy"),
    .position = GET (GTK_ADJUSTMENT, "positions"),
    .progress = GET (GTK_PROGRESS_BAR, "progress"),
    .animate = GET (GTK_TOGGLE_BUTTON, "animate"),
  };
#undef GET
  self->figure = (QnEnvelopeFigure){ &self->envelope, &self->moved, .phase = 1 };
  qn_help_set_page (self->page, "bridges");
  g_object_set_data_full (G_OBJECT (self->page), "qn-envelope", self, free_page);
  connect (self);
  show_settings (self);
  update_actions (self);
  return self->page;
}
