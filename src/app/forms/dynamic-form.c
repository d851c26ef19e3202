/* The analysis in time: its settings, where selected blocks start, the list of ground motions. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/chooser.h"
#include "app/widgets/plot-view.h"
#include "core/modal/modal.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/view/ground-preview.h"
#include "io/exchange/record.h"

#include <glib/gi18n.h>

/* The plot's text over that of the window: the panel is narrow. */
#define TEXT_SHARE 0.825

typedef struct Form {
  QnForm base;
  QnGroundPreviewKind preview;
  QnGroundPreview sampled; /* what the plot shows */
  char *fault;             /* why its record cannot be read, or NULL */
} Form;

#define CHANGE    N_ ("Change Analysis")
#define INITIALLY N_ ("Change Initial Motion")
#define MOTION    N_ ("Change Ground Motion")

/* INITIAL: of the selected blocks, ux, uy, rz and their rates. RESTS: of a record in a file. */
#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (DURATION, "duration", CHANGE, QnDynamicSettings, duration)                     \
  MEMBER (TIME_STEP, "time_step", CHANGE, QnDynamicSettings, time_step)                  \
  MEMBER (RHO, "rho", CHANGE, QnDynamicSettings, rho)                                    \
  MEMBER (MASS_DAMPING, "mass_damping", CHANGE, QnDynamicSettings, mass_damping)         \
  MEMBER (JOINT_DAMPING, "joint_damping", CHANGE, QnDynamicSettings, joint_damping)      \
  FIELD (RATIO, "ratio", N_ ("Change Damping"))                                          \
  MEMBER (OF, "of", CHANGE, QnDynamicSettings, of)                                       \
  MEMBER (FOLLOW, "follow", CHANGE, QnDynamicSettings, follow)                           \
  MEMBER (FALL, "fall", CHANGE, QnDynamicSettings, fall)                                 \
  FIELD (INITIAL_TITLE, "initial_title", NULL)                                           \
  FIELD (INITIAL, "initial_ux", INITIALLY)                                               \
  FIELD (INITIAL_UY, "initial_uy", INITIALLY)                                            \
  FIELD (INITIAL_RZ, "initial_rz", INITIALLY)                                            \
  FIELD (INITIAL_VX, "initial_vx", INITIALLY)                                            \
  FIELD (INITIAL_VY, "initial_vy", INITIALLY)                                            \
  FIELD (INITIAL_WZ, "initial_wz", INITIALLY)                                            \
  FIELD (MOTIONS, "motions", NULL)                                                       \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (PREVIEW, "preview", NULL)                                                       \
  FIELD (PLOT, "plot", NULL)                                                             \
  FIELD (FAULT, "fault", NULL)                                                           \
  MEMBER (KIND, "kind", MOTION, QnGroundMotion, pulse.kind)                              \
  MEMBER (AMPLITUDE, "amplitude", MOTION, QnGroundMotion, pulse.amplitude)               \
  MEMBER (LENGTH, "length", MOTION, QnGroundMotion, pulse.duration)                      \
  MEMBER (START, "start", MOTION, QnGroundMotion, pulse.start)                           \
  MEMBER (SCALE, "scale", MOTION, QnGroundMotion, scale)                                 \
  MEMBER (X, "x", MOTION, QnGroundMotion, direction.x)                                   \
  MEMBER (Y, "y", MOTION, QnGroundMotion, direction.y)                                   \
  MEMBER (RESTS, "rests", MOTION, QnGroundMotion, rests)                                 \
  FIELD (ADD, "add", N_ ("Add Ground Motion"))                                           \
  FIELD (IMPORT, "import", NULL)                                                         \
  FIELD (REMOVE, "remove", N_ ("Remove Ground Motion"))
QN_FORM_FIELDS;

/* Whether a record's unit may be wrong, or samples are missing. */
static char *
dup_doubt (const QnGroundMotion *motion)
{
  QnRecord record = { .points = motion->points, .count = motion->point_count };
  char *doubt = qn_record_dup_doubt (&record);
  qn_record_find_gap (&record);
  return doubt != NULL ? doubt : qn_record_dup_gap (&record, NULL);
}

/* Records are read from their files where no analysis has done so yet, however long they are. */
static void
sample (Form *form)
{
  QnDocument *document = form->base.canvas->document;
  const QnModel *model = &document->project.model;
  QnProject read;
  g_autoptr (GError) error = NULL;
  qn_ground_preview_clear (&form->sampled);
  g_clear_pointer (&form->fault, g_free);
  if (form->base.selected < 0)
    return;
  const QnGroundMotion *motion = &model->ground[form->base.selected];
  gsize index = (gsize) form->base.selected;
  if (motion->record == NULL || motion->point_count > 0) {
    qn_ground_preview_init (&form->sampled, model, index, form->preview);
    form->fault = dup_doubt (motion);
    return;
  }
  if (!qn_project_copy (qn_document_get_project (document), &read, NULL))
    return;
  read.model.ground[index].rests = true;
  if (qn_project_read_record (&read, index, document->folder, FALSE, &error)) {
    qn_ground_preview_init (&form->sampled, &read.model, index, form->preview);
    form->fault = dup_doubt (&read.model.ground[index]);
  } else
    form->fault = g_strdup (error->message);
  qn_project_clear (&read);
}

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  if (model->analysis.procedure != QN_PROCEDURE_DYNAMIC || model->stage_count > 0)
    return FALSE;
  /* The first one is selected where there was none. */
  form->base.selected = MIN (MAX (form->base.selected, 0), (int) model->ground_count - 1);
  sample (form);
  return TRUE;
}

/* The settings, or the selected ground motion. */
static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return field < MOTIONS ? (gpointer) &model->analysis.dynamic
                         : qn_form_item (form, model);
}

static char *
dup_row (const QnModel *model, gsize index)
{
  return qn_ground_motion_dup_text (&model->ground[index]);
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
  QnBlockSet set = form->base.parts.blocks;
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
  for (guint i = 0; i < form->base.parts.blocks.count; i++) {
    QnInitialMotion motion = qn_initial_motion_of (model, form->base.parts.blocks.ids[i]);
    *initial_number (&motion, field) = number;
    if (!qn_edit_set_initial (model, &motion, error))
      return FALSE;
  }
  return TRUE;
}

/* ---- damping by modes ---- */

/* The frequencies of those that have been found; free omega with g_free(). */
static QnModes
found_modes (const Form *form)
{
  QnModes modes = { 0 };
  modes.omega = qn_document_dup_omegas (form->base.canvas->document, &modes.count);
  return modes;
}

/* That of the first mode that is no rigid motion. */
static void
show_ratio (const Form *form, const QnDynamicSettings *settings, QnValue *value)
{
  QnModes modes = found_modes (form);
  double omega = modes.count > 0 ? modes.omega[qn_modes_damping (&modes, 0).first] : 0;
  value->disabled = omega == 0;
  if (omega > 0)
    value->number =
      0.5 * (settings->mass_damping / omega + settings->joint_damping * omega);
  g_free (modes.omega);
}

static gboolean
take_ratio (const Form *form, QnDynamicSettings *settings, double ratio)
{
  QnModes modes = found_modes (form);
  if (modes.count == 0)
    return FALSE;
  QnModesDamping damping = qn_modes_damping (&modes, ratio);
  settings->mass_damping = damping.mass;
  settings->joint_damping = damping.stiffness;
  g_free (modes.omega);
  return TRUE;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnGroundMotion *motion = qn_form_item (form, model);
  gboolean pulse = motion != NULL && motion->kind == QN_SIGNAL_PULSE;
  if (field >= INITIAL_TITLE && field < MOTIONS)
    return show_initial (form, model, field, value);
  switch (field) {
  case JOINT_DAMPING:
    value->disabled =
      model->analysis.dynamic.of == QN_DAMPING_IMPACT && model->beam_count == 0;
    return TRUE;
  case RATIO:
    show_ratio (form, &model->analysis.dynamic, value);
    return TRUE;
  case FOLLOW:
    return model->analysis.geometry == QN_GEOMETRY_NONLINEAR;
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
    break;
  }
  return TRUE;
}

/* ---- records ---- */

static gboolean
import_path (gpointer data, const char *path, GError **error)
{
  Form *form = data;
  QnCanvasDraft draft;
  if (!qn_canvas_begin_edit (form->base.canvas, &draft)
      || !qn_canvas_end_edit (form->base.canvas, &draft, _ ("Import Ground Motion"), NULL,
                              qn_edit_add_record (draft.model, path, &draft.error)))
    return TRUE; /* the canvas has told why not */
  form->base.selected = (int) qn_canvas_get_model (form->base.canvas)->ground_count - 1;
  qn_form_show (form);
  return TRUE;
}

static void
tell (gpointer form, const char *message)
{
  qn_canvas_tell (((Form *) form)->base.canvas, message);
}

/* ---- changes ---- */

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Form *form = (Form *) data;
  if (field >= INITIAL && field < MOTIONS)
    return take_initial (form, model, field, value->number, error);
  switch (field) {
  case OF:
    if (model->analysis.dynamic.of == QN_DAMPING_IMPACT && model->beam_count == 0)
      model->analysis.dynamic.joint_damping = 0;
    return TRUE;
  case RATIO:
    return take_ratio (form, &model->analysis.dynamic, value->number);
  case PREVIEW:
    form->preview = (QnGroundPreviewKind) value->number;
    return TRUE;
  case ADD:
    form->base.wanted = (int) model->ground_count;
    return qn_edit_add_pulse (model, error);
  case IMPORT:
    qn_chooser_ask (form->base.root,
                    &(QnFileQuestion){ .title = _ ("Import Ground Motion"),
                                       .accept = _ ("_Import"),
                                       .use = import_path,
                                       .failed = tell },
                    form);
    return TRUE;
  case REMOVE:
    return qn_edit_remove_ground_motion (model, (gsize) form->base.selected, error);
  }
  return TRUE;
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const Form *form = data;
  if (form->sampled.count == 0)
    return NULL;
  QnPlot *plot = qn_ground_preview_plot (&form->sampled, form->preview);
  if (form->preview == QN_GROUND_SPECTRUM) {
    QnModes modes = found_modes (form);
    qn_ground_preview_add_periods (plot, &form->sampled, modes.omega, modes.count);
    g_free (modes.omega);
  }
  return plot;
}

static void
on_destroy (GtkWidget *root, Form *form)
{
  qn_ground_preview_clear (&form->sampled);
  g_free (form->fault);
}

/* As it is before anything is shown. */
static void
init (QnForm *data)
{
  static const QnPlotHand hand = { .text_share = TEXT_SHARE, .make = make_plot };
  Form *form = (Form *) data;
  qn_plot_view_init (form->base.widgets[PLOT], &hand, form);
  qn_accept_files (form->base.root,
                   &(QnFileQuestion){ .use = import_path, .failed = tell }, form);
  g_signal_connect (form->base.root, "destroy", G_CALLBACK (on_destroy), form);
}

static const QnFormList list =
  QN_FORM_LIST (MOTIONS, EMPTY, ground, ground_count, dup_row, QN_PICK_NOTHING);

const QnFormKind qn_dynamic_form =
  QN_FORM_KIND ("dynamic-form", Form, .list = &list, .subject = subject, .look = look,
                .follows = QN_FOLLOW_SELECTION | QN_FOLLOW_RUNS, .init = init);
