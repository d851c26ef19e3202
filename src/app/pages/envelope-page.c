/* A vehicle that moves over the structure: it is dragged over it, with the multipliers of all positions below
 * over the same axis. What is chosen is kept with the project; the answers are found again. */
#include "app/pages/pages.h"

#include "app/forms/form.h"
#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/help.h"
#include "app/widgets/text-unit.h"
#include "core/base/integer.h"
#include "doc/text/explain.h"
#include "doc/view/figures.h"
#include "io/project/project-vehicle.h"
#include "io/project/project.h"
#include "study/report/envelope-figure.h"
#include <glib/gi18n.h>
#include <math.h>

/* ms between two looks at an envelope that is being found; s of one motion to collapse and back. */
#define INTERVAL 50
#define PERIOD   3.0

/* px: a curve this near to the pointer is meant. */
#define NEAR 40.0

typedef struct Page {
  QnForm base;
  QnDocument *document;
  char *told; /* below the picture */

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

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (VEHICLES, "vehicles", NULL)                                                     \
  FIELD (CHOSEN, "chosen", NULL)                                                         \
  MEMBER (WAYS, "ways", NULL, Page, settings.ways)                                       \
  MEMBER (STEP, "step", NULL, Page, settings.step)                                       \
  FIELD (CONVOY, "convoy", NULL)                                                         \
  MEMBER (METHOD, "method", NULL, Page, settings.method)                                 \
  FIELD (LINE, "line", NULL)                                                             \
  FIELD (POSITION, "scale", NULL)                                                        \
  FIELD (AREA, "area", NULL)                                                             \
  FIELD (ANIMATE, "animate", NULL)                                                       \
  FIELD (CANCEL, "cancel", NULL)                                                         \
  FIELD (PUT, "put", NULL)                                                               \
  FIELD (PROGRESS, "progress", NULL)                                                     \
  FIELD (STATUS, "status", NULL)
QN_FORM_FIELDS;

static void
tell (Page *self, const char *text)
{
  g_free (self->told);
  self->told = g_strdup (text);
  qn_form_show (self);
}

static const QnLoad *
load_of (Page *self)
{
  const QnModel *model = &self->document->project.model;
  gsize load = qn_find_vehicle_load (model);
  return load == G_MAXSIZE ? NULL : &model->live_loads[load];
}

static void
update_actions (Page *self)
{
  QnEnvelopePlace least;
  const gboolean found = self->envelope.count > 0;
  GtkWidget *page = self->base.root;
  qn_actions_enable (page, "run", self->thread == NULL && load_of (self) != NULL);
  qn_actions_enable (page, "cancel", self->thread != NULL);
  qn_actions_enable (page, "put", found && self->thread == NULL);
  qn_actions_enable (page, "worst",
                     found && qn_envelope_find_least (&self->envelope, &least));
  qn_actions_enable (page, "export", found && self->thread == NULL);
}

/* ---- the position that is shown ---- */

static void
tell_position (Page *self)
{
  const QnEnvelope *e = &self->envelope;
  if (isnan (qn_envelope_multiplier (e, self->figure.shown))) {
    tell (self, self->thread != NULL ? ""
                : qn_envelope_is_open (e, self->figure.shown)
                  ? _ ("The analysis came to no answer at this position.")
                  : _ ("Nothing collapses at this position."));
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
  tell_position (self);
  gtk_widget_queue_draw (self->base.widgets[AREA]);
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  Page *self = data;
  const QnPage page = { .width = width,
                        .height = height,
                        .unit = qn_text_unit (GTK_WIDGET (area)) };
  g_autoptr (GError) error = NULL;
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
  gtk_widget_grab_focus (self->base.widgets[POSITION]); /* for its keys */
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
animate (Page *self, gboolean on)
{
  GtkWidget *area = self->base.widgets[AREA];
  if (self->tick != 0)
    gtk_widget_remove_tick_callback (area, self->tick);
  self->tick = on ? gtk_widget_add_tick_callback (area, on_tick, self, NULL) : 0;
  self->figure.phase = 1;
  gtk_widget_queue_draw (area);
}

/* ---- what is chosen ---- */

static gboolean
set_convoy (QnProject *draft, gpointer data, GError **error)
{
  QnModel *model = &draft->model;
  model->live_loads[qn_find_vehicle_load (model)].convoy = *(const int32_t *) data;
  return TRUE;
}

/* The vehicles of the project and those that are built in, with a bit for each that is moved. */
static char **
dup_vehicles (Page *self, const QnLoad *load, guint32 *moved)
{
  const QnModel *model = &self->document->project.model;
  const char *own[] = { model->vehicles[load->vehicle].name, NULL };
  char **names = qn_dup_vehicle_names (model);
  *moved = 0;
  for (guint i = 0; names[i] != NULL; i++)
    if (g_strv_contains (self->settings.vehicles != NULL
                           ? (const char *const *) self->settings.vehicles
                           : own,
                         names[i]))
      *moved |= 1u << i;
  return names;
}

/* Those whose bits are set; NULL: none. */
static char **
dup_chosen (char **names, guint32 moved)
{
  g_autoptr (GStrvBuilder) chosen = g_strv_builder_new ();
  for (guint i = 0; names[i] != NULL; i++)
    if ((moved >> i & 1) != 0)
      g_strv_builder_add (chosen, names[i]);
  return moved != 0 ? g_strv_builder_end (chosen) : NULL;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  Page *self = (Page *) data;
  const QnLoad *load = load_of (self);
  const QnEnvelope *e = &self->envelope;
  guint32 moved;
  switch (field) {
  case VEHICLES:
  case CHOSEN:
    if (load == NULL)
      return FALSE;
    value->rows = dup_vehicles (self, load, &moved);
    value->number = moved;
    if (field == CHOSEN) {
      g_auto (GStrv) chosen = dup_chosen (value->rows, moved);
      value->text = chosen != NULL ? g_strjoinv (", ", chosen) : g_strdup ("");
    }
    return TRUE;
  case CONVOY:
    value->number = load != NULL ? load->convoy : 1;
    return TRUE;
  case LINE:
    for (gsize k = 0; e->count > 0 && k < e->line_count; k++)
      qn_value_take_row (value, qn_envelope_dup_line_name (e, k));
    value->number = (double) self->figure.shown.line;
    return TRUE;
  case POSITION:
    gtk_range_set_range (GTK_RANGE (self->base.widgets[POSITION]), 0,
                         e->count > 0 ? (double) e->count - 1 : 0);
    value->number = (double) self->figure.shown.position;
    return TRUE;
  case ANIMATE:
    value->number = self->tick != 0;
    value->disabled = e->count == 0;
    return TRUE;
  case CANCEL:
  case PROGRESS:
    return self->thread != NULL;
  case PUT:
    return self->thread == NULL;
  case STATUS:
    value->text = g_strdup (self->told);
    break;
  }
  return TRUE;
}

/* What is entered becomes a step, by which all is shown again. */
static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Page *self = (Page *) data;
  const QnLoad *load = load_of (self);
  QnEnvelopePlace at = self->figure.shown;
  guint32 moved;
  int32_t convoy = qn_value_int (value);
  g_autoptr (GError) fault = NULL;
  if (field == LINE || field == POSITION) {
    *(field == LINE ? &at.line : &at.position) = (gsize) qn_value_int (value);
    show_position (self, at);
    return TRUE;
  }
  if (field == ANIMATE)
    animate (self, value->number != 0.0);
  if (field == ANIMATE || load == NULL)
    return TRUE;
  if (field == VEHICLES) {
    g_auto (GStrv) names = dup_vehicles (self, load, &moved);
    g_strfreev (self->settings.vehicles);
    self->settings.vehicles = dup_chosen (names, (guint32) value->number);
  }
  g_autofree char *json = qn_envelope_settings_to_json (&self->settings);
  if (field == CONVOY
        ? !qn_document_edit (self->document, _ ("Set Convoy"), "envelope-convoy",
                             set_convoy, &convoy, &fault)
        : !qn_document_edit_extra (self->document, _ ("Set Moving Load"),
                                   QN_ENVELOPE_MEMBER, QN_ENVELOPE_MEMBER, json, &fault))
    tell (self, fault->message);
  return fault == NULL;
}

static void
on_changed (Page *self)
{
  g_autoptr (GError) error = NULL;
  if (self->envelope.count > 0) {
    g_autofree char *digest =
      qn_model_digest (qn_document_get_project (self->document), NULL);
    self->outdated =
      g_strcmp0 (digest, self->digest) != 0 && g_strcmp0 (digest, self->digest_put) != 0;
  }
  qn_envelope_settings_clear (&self->settings);
  if (!qn_envelope_settings_read (qn_document_get_project (self->document),
                                  &self->settings, &error))
    tell (self, error->message);
  else if (load_of (self) == NULL)
    tell (self, _ ("No vehicle is among the growing loads: add one to them first."));
  else if (self->envelope.count == 0)
    tell (self, _ ("Choose vehicles, then find the envelope: the vehicle is moved from "
                   "place to place, and the least multiplier is its adequacy factor."));
  else
    tell_position (self);
  update_actions (self);
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

static gboolean
on_timeout (gpointer data)
{
  Page *self = data;
  const QnEnvelope *e = &self->envelope;
  gboolean over = g_atomic_int_get (&self->over);
  gtk_progress_bar_set_fraction (GTK_PROGRESS_BAR (self->base.widgets[PROGRESS]),
                                 (double) g_atomic_int_get (&e->done)
                                   / (double) (e->line_count * e->count));
  gtk_widget_queue_draw (self->base.widgets[AREA]);
  if (!over)
    return G_SOURCE_CONTINUE;
  self->timeout = 0;
  g_thread_join (g_steal_pointer (&self->thread));
  /* In the end the worst position is shown. */
  QnEnvelopePlace least = { 0, 0 };
  gboolean found = qn_envelope_find_least (e, &least);
  show_position (self, least);
  if (self->ended != QN_OK && self->ended != QN_ERROR_CANCELLED) {
    g_autofree char *reason = qn_explain_diag (&e->model, &self->diag);
    tell (self, reason);
  } else if (e->unstable) {
    tell (self, _ ("There is no stable equilibrium under the dead load."));
  } else if (!found) {
    tell (self, _ ("No position gives a collapse."));
  }
  update_actions (self);
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
  if (!qn_envelope_init (&self->envelope, &self->document->project.model, &self->settings,
                         &error)) {
    tell (self, error->message);
    gtk_widget_queue_draw (self->base.widgets[AREA]);
    return;
  }
  g_free (self->digest);
  g_clear_pointer (&self->digest_put, g_free);
  self->digest = qn_model_digest (qn_document_get_project (self->document), NULL);
  self->outdated = FALSE;
  self->cancelled = self->over = FALSE;
  self->thread = g_thread_new ("envelope", find_in_thread, self);
  self->timeout = g_timeout_add (INTERVAL, on_timeout, self);
  gtk_progress_bar_set_fraction (GTK_PROGRESS_BAR (self->base.widgets[PROGRESS]), 0);
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
put_vehicle (QnProject *draft, gpointer data, GError **error)
{
  QnModel *model = &draft->model;
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
    self->digest_put = qn_model_digest (qn_document_get_project (self->document), NULL);
    self->outdated = FALSE;
  }
  tell_position (self);
}

/* ---- files ---- */

static gboolean
write_file (gpointer data, const char *path, GError **error)
{
  Page *self = data;
  QnMetadata metadata;
  QnOutput output;
  qn_document_get_metadata (self->document, &metadata);
  qn_output_init (&output);
  metadata.title = self->envelope.model.title;
  if (g_str_has_suffix (path, ".csv"))
    return qn_envelope_write_table (&self->envelope, path, error);
  return qn_envelope_export (&self->envelope, self->figure.shown, path, &output,
                             &metadata, error);
}

/* Below what there is to say of the position. */
static void
on_told (gpointer data, const char *message)
{
  Page *self = data;
  tell_position (self);
  g_autofree char *both = g_strjoin ("\n", self->told, message, NULL);
  tell (self, both);
}

/* Asks for the file, but where it is given. */
static void
export_file (GSimpleAction *action, GVariant *path, gpointer data)
{
  static const char *const endings[] = { ".pdf", ".svg", ".png", ".csv", NULL };
  Page *self = data;
  const QnFileQuestion question = { .title = _ ("Export Envelope"),
                                    .accept = _ ("_Export"),
                                    .name = _ ("envelope.pdf"),
                                    .endings = endings,
                                    .use = write_file,
                                    .told = on_told,
                                    .given = path != NULL
                                               ? g_variant_get_string (path, NULL)
                                               : NULL };
  qn_chooser_ask (self->base.root, &question, self);
}

/* ---- the page ---- */

static void
clear (QnForm *data)
{
  Page *self = (Page *) data;
  qn_model_clear (&self->moved);
  qn_envelope_settings_clear (&self->settings);
  g_object_unref (self->document);
  g_free (self->digest);
  g_free (self->digest_put);
  g_free (self->told);
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
    { .name = "export-path", .activate = export_file, .parameter_type = "s" },
  };
  GtkGesture *drag = gtk_gesture_drag_new ();
  GtkWidget *area = self->base.widgets[AREA], *page = self->base.root;
  qn_actions_insert (page, "envelope", entries, G_N_ELEMENTS (entries), self);
  gtk_widget_set_direction (area, GTK_TEXT_DIR_LTR);
  gtk_widget_set_direction (self->base.widgets[POSITION], GTK_TEXT_DIR_LTR);
  gtk_range_set_increments (GTK_RANGE (self->base.widgets[POSITION]), 1, 10);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw, self, NULL);
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_drag_begin), self);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_drag_update), self);
  gtk_widget_add_controller (area, GTK_EVENT_CONTROLLER (drag));
  g_signal_connect_swapped (page, "destroy", G_CALLBACK (forget), self);
  qn_watch (page, self->document, "changed", G_CALLBACK (on_changed), self);
}

GtkWidget *
qn_envelope_page_new (QnDocument *document)
{
  static const QnFormKind kind = QN_FORM_KIND ("envelope-page", Page, .clear = clear);
  Page *self = qn_form_new (&kind, NULL);
  self->document = g_object_ref (document);
  self->figure = (QnEnvelopeFigure){ &self->envelope, &self->moved, .phase = 1 };
  qn_help_set_page (self->base.root, "bridges");
  connect (self);
  on_changed (self);
  return self->base.root;
}
