/* The analysis in time: its settings, where selected blocks start, the list of ground motions. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "app/widgets/chooser.h"
#include "app/widgets/plot-view.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/view/ground-preview.h"
#include "io/exchange/record.h"

#include <glib/gi18n.h>

/* The plot's text over that of the window: the panel is narrow. */
#define TEXT_SHARE 0.825

typedef struct Form {
  QnBoundForm base;
  int selected; /* ground motion, or -1 */
  QnGroundPreviewKind preview;
  QnGroundPreview sampled; /* what the plot shows */
  char *fault;             /* why its record cannot be read, or NULL */
  GObject *chooser;
} Form;

enum {
  DURATION,
  TIME_STEP,
  RHO,
  MASS_DAMPING,
  JOINT_DAMPING,
  OF,
  FOLLOW,
  FALL,
  INITIAL_TITLE,
  INITIAL, /* of the selected blocks: ux, uy, rz and their rates */
  MOTIONS = INITIAL + 2 * QN_DOF_COUNT,
  PREVIEW,
  PLOT,
  FAULT,
  KIND,
  AMPLITUDE,
  LENGTH,
  START,
  SCALE,
  X,
  Y,
  RESTS, /* of a record in a file */
  ADD,
  IMPORT,
  REMOVE
};

static const QnFormField fields[] = {
  [DURATION] = { .id = "duration", .step = N_ ("Change Analysis") },
  [TIME_STEP] = { .id = "time_step", .step = N_ ("Change Analysis") },
  [RHO] = { .id = "rho", .step = N_ ("Change Analysis") },
  [MASS_DAMPING] = { .id = "mass_damping", .step = N_ ("Change Analysis") },
  [JOINT_DAMPING] = { .id = "joint_damping", .step = N_ ("Change Analysis") },
  [OF] = { .id = "of", .step = N_ ("Change Analysis") },
  [FOLLOW] = { .id = "follow", .step = N_ ("Change Analysis") },
  [FALL] = { .id = "fall", .step = N_ ("Change Analysis") },
  [INITIAL_TITLE] = { .id = "initial_title" },
  [INITIAL] = { .id = "initial_ux", .step = N_ ("Change Initial Motion") },
  [INITIAL + 1] = { .id = "initial_uy", .step = N_ ("Change Initial Motion") },
  [INITIAL + 2] = { .id = "initial_rz", .step = N_ ("Change Initial Motion") },
  [INITIAL + 3] = { .id = "initial_vx", .step = N_ ("Change Initial Motion") },
  [INITIAL + 4] = { .id = "initial_vy", .step = N_ ("Change Initial Motion") },
  [INITIAL + 5] = { .id = "initial_wz", .step = N_ ("Change Initial Motion") },
  [MOTIONS] = { .id = "motions" },
  [PREVIEW] = { .id = "preview" },
  [PLOT] = { .id = "plot" },
  [FAULT] = { .id = "fault" },
  [KIND] = { .id = "kind", .step = N_ ("Change Ground Motion") },
  [AMPLITUDE] = { .id = "amplitude", .step = N_ ("Change Ground Motion") },
  [LENGTH] = { .id = "length", .step = N_ ("Change Ground Motion") },
  [START] = { .id = "start", .step = N_ ("Change Ground Motion") },
  [SCALE] = { .id = "scale", .step = N_ ("Change Ground Motion") },
  [X] = { .id = "x", .step = N_ ("Change Ground Motion") },
  [Y] = { .id = "y", .step = N_ ("Change Ground Motion") },
  [RESTS] = { .id = "rests", .step = N_ ("Change Ground Motion") },
  [ADD] = { .id = "add", .step = N_ ("Add Ground Motion") },
  [IMPORT] = { .id = "import" },
  [REMOVE] = { .id = "remove", .step = N_ ("Remove Ground Motion") },
};

/* Whether a record's unit may be wrong. */
static char *
dup_doubt (const QnGroundMotion *motion)
{
  return qn_record_dup_doubt (
    &(QnRecord){ .points = motion->points, .count = motion->point_count });
}

/* Records are read from their files where no analysis has done so yet, however long they are. */
static void
sample (Form *form)
{
  QnDocument *document = qn_canvas_get_document (form->base.canvas);
  const QnModel *model = qn_document_get_model (document);
  QnProject read;
  g_autoptr (GError) error = NULL;
  qn_ground_preview_clear (&form->sampled);
  g_clear_pointer (&form->fault, g_free);
  if (form->selected < 0)
    return;
  const QnGroundMotion *motion = &model->ground[form->selected];
  gsize index = (gsize) form->selected;
  if (motion->record == NULL || motion->point_count > 0) {
    qn_ground_preview_init (&form->sampled, model, index, form->preview);
    form->fault = dup_doubt (motion);
    return;
  }
  if (!qn_project_copy (qn_document_get_project (document), &read, NULL))
    return;
  read.model.ground[index].rests = true;
  if (qn_project_read_record (&read, index, qn_document_get_folder (document), FALSE,
                              &error)) {
    qn_ground_preview_init (&form->sampled, &read.model, index, form->preview);
    form->fault = dup_doubt (&read.model.ground[index]);
  } else
    form->fault = g_strdup (error->message);
  qn_project_clear (&read);
}

static gboolean
look (gpointer data)
{
  Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  if (model->analysis.procedure != QN_PROCEDURE_DYNAMIC || model->stage_count > 0)
    return FALSE;
  /* The first one is selected where there was none. */
  form->selected = MIN (MAX (form->selected, 0), (int) model->ground_count - 1);
  sample (form);
  return TRUE;
}

/* What a field shows, of the selected ground motion or of `none`. */
static QnBound
bound_of (QnModel *model, int selected, QnGroundMotion *none, guint field)
{
  QnDynamicSettings *d = &model->analysis.dynamic;
  QnGroundMotion *m = selected >= 0 ? &model->ground[selected] : none;
  const QnBound all[G_N_ELEMENTS (fields)] = {
    [DURATION] = QN_BOUND (&d->duration),
    [TIME_STEP] = QN_BOUND (&d->time_step),
    [RHO] = QN_BOUND (&d->rho),
    [MASS_DAMPING] = QN_BOUND (&d->mass_damping),
    [JOINT_DAMPING] = QN_BOUND (&d->joint_damping),
    [OF] = QN_BOUND (&d->of),
    [FOLLOW] = QN_BOUND (&d->follow),
    [FALL] = QN_BOUND (&d->fall),
    [KIND] = QN_BOUND (&m->pulse.kind),
    [AMPLITUDE] = QN_BOUND (&m->pulse.amplitude),
    [LENGTH] = QN_BOUND (&m->pulse.duration),
    [START] = QN_BOUND (&m->pulse.start),
    [SCALE] = QN_BOUND (&m->scale),
    [X] = QN_BOUND (&m->direction.x),
    [Y] = QN_BOUND (&m->direction.y),
    [RESTS] = QN_BOUND (&m->rests),
  };
  return all[field];
}

/* ---- initial motion ---- */

static double *
initial_number (QnInitialMotion *motion, guint field)
{
  guint i = field - INITIAL;
  return i < QN_DOF_COUNT ? &motion->displacement[i]
                          : &motion->velocity[i - QN_DOF_COUNT];
}

/* Of the first selected block. */
static gboolean
show_initial (const Form *form, const QnModel *model, guint field, QnValue *value)
{
  QnBlockSet set = qn_canvas_get_selected (form->base.canvas);
  if (set.count == 0)
    return FALSE;
  QnInitialMotion motion = qn_initial_motion_of (model, set.ids[0]);
  if (field == INITIAL_TITLE)
    value->text =
      set.count == 1
        ? g_strdup_printf (_ ("Start of Block %s"), model->blocks[set.ids[0]].name)
        : g_strdup_printf (
          ngettext ("Start of %u Block", "Start of %u Blocks", set.count), set.count);
  else
    value->number = *initial_number (&motion, field);
  return TRUE;
}

static gboolean
take_initial (const Form *form, QnModel *model, guint field, double number,
              GError **error)
{
  QnBlockSet set = qn_canvas_get_selected (form->base.canvas);
  for (guint i = 0; i < set.count; i++) {
    QnInitialMotion motion = qn_initial_motion_of (model, set.ids[i]);
    *initial_number (&motion, field) = number;
    if (!qn_edit_set_initial (model, (QnBlockSet){ set.ids + i, 1 }, motion.displacement,
                              motion.velocity, error))
      return FALSE;
  }
  return TRUE;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  QnModel model = *qn_canvas_get_model (form->base.canvas);
  const QnGroundMotion *motion =
    form->selected >= 0 ? &model.ground[form->selected] : NULL;
  gboolean pulse = motion != NULL && motion->kind == QN_SIGNAL_PULSE;
  QnGroundMotion none = { 0 };
  qn_value_show (value, bound_of (&model, form->selected, &none, field));
  if (field >= INITIAL_TITLE && field < MOTIONS)
    return show_initial (form, &model, field, value);
  switch (field) {
  case FOLLOW:
    return model.analysis.geometry == QN_GEOMETRY_NONLINEAR;
  case MOTIONS:
    for (gsize i = 0; i < model.ground_count; i++)
      qn_value_take_row (value, qn_ground_motion_dup_text (&model.ground[i]));
    value->number = form->selected;
    return TRUE;
  case PREVIEW:
    value->number = form->preview;
    return motion != NULL;
  case PLOT:
    gtk_widget_queue_draw (form->base.widgets[PLOT]);
    return form->sampled.count > 0;
  case FAULT:
    value->text = g_strdup (form->fault);
    return form->fault != NULL;
  case KIND:
    for (int i = 0; i < QN_PULSE_KIND_COUNT; i++)
      qn_value_add_row (value, qn_pulse_kind_text ((QnPulseKind) i));
    return pulse;
  case AMPLITUDE:
  case LENGTH:
  case START:
    return pulse;
  case SCALE:
  case X:
  case Y:
    return motion != NULL;
  case RESTS:
    return motion != NULL && motion->record != NULL;
  case REMOVE:
    value->disabled = motion == NULL;
    return TRUE;
  default:
    return TRUE;
  }
}

/* ---- records ---- */

static gboolean
add_record (QnModel *model, gpointer path, GError **error)
{
  return qn_edit_add_record (model, path, error);
}

static gboolean
import_file (GFile *file, gpointer data)
{
  Form *form = data;
  g_autofree char *path = g_file_get_path (file);
  if (path == NULL)
    qn_canvas_tell (form->base.canvas, _ ("Only local files can be read"));
  else if (qn_canvas_edit (form->base.canvas, _ ("Import Ground Motion"), NULL,
                           add_record, path)) {
    form->selected = (int) qn_canvas_get_model (form->base.canvas)->ground_count - 1;
    qn_bound_form_show (form);
  }
  return path != NULL;
}

static void
on_chosen (GtkNativeDialog *dialog, int response, Form *form)
{
  g_autoptr (GFile) file = response == GTK_RESPONSE_ACCEPT
                             ? gtk_file_chooser_get_file (GTK_FILE_CHOOSER (dialog))
                             : NULL;
  if (file != NULL)
    import_file (file, form);
  g_clear_object (&form->chooser);
}

static void
choose_file (Form *form)
{
  GtkFileChooserNative *chooser = qn_chooser_begin (
    GTK_WINDOW (gtk_widget_get_root (form->base.root)), &form->chooser,
    GTK_FILE_CHOOSER_ACTION_OPEN, _ ("Import Ground Motion"), _ ("_Import"));
  g_signal_connect (chooser, "response", G_CALLBACK (on_chosen), form);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

/* ---- changes ---- */

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnGroundMotion none;
  if (draft != NULL)
    qn_value_take (value, bound_of (&draft->model, form->selected, &none, field));
  if (field >= INITIAL && field < MOTIONS)
    return take_initial (form, &draft->model, field, value->number, error);
  switch (field) {
  case MOTIONS:
    form->selected = (int) value->number;
    return TRUE;
  case PREVIEW:
    form->preview = (QnGroundPreviewKind) value->number;
    return TRUE;
  case ADD:
    if (!qn_edit_add_pulse (&draft->model, error))
      return FALSE;
    form->selected = (int) draft->model.ground_count - 1;
    return TRUE;
  case IMPORT:
    choose_file (form);
    return TRUE;
  case REMOVE:
    return qn_edit_remove_ground_motion (&draft->model, (gsize) form->selected, error);
  default:
    return TRUE;
  }
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const Form *form = data;
  return form->sampled.count > 0 ? qn_ground_preview_plot (&form->sampled, form->preview)
                                 : NULL;
}

static void
on_destroy (GtkWidget *root, Form *form)
{
  g_clear_object (&form->chooser);
  qn_ground_preview_clear (&form->sampled);
  g_free (form->fault);
}

GtkWidget *
qn_dynamic_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND ("dynamic-form", Form, QN_FOLLOW_SELECTION);
  static const QnPlotHand hand = { .text_share = TEXT_SHARE, .make = make_plot };
  Form *form = qn_bound_form_new (&kind, canvas);
  form->selected = 0;
  qn_plot_view_init (form->base.widgets[PLOT], &hand, form);
  qn_accept_files (form->base.root, import_file, form);
  g_signal_connect (form->base.root, "destroy", G_CALLBACK (on_destroy), form);
  return qn_bound_form_show (form);
}
