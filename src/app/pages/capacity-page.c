/* The capacity curve of the model beside a spectrum: which block is controlled, which earthquake; the
 * plot, the checks of both codes, pictures and tables of them. */
#include "app/pages/pages.h"

#include "app/forms/bound-form.h"
#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/help.h"
#include "app/widgets/plot-view.h"
#include "app/widgets/settings.h"

#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/figures.h"
#include "io/exchange/record.h"
#include "io/project/project.h"
#include "io/text/file-read.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* The plot's text over that of the window. */
#define TEXT_SHARE 0.9

/* Where the page keeps its form. */
#define FORM "capacity-form"

enum { TYPE_1, TYPE_2, FROM_FILE, NONE };

static const char *const units[] = { NULL, "g", "m/s2", "cm/s2" };

typedef struct Form {
  QnBoundForm base;
  QnDocument *document;
  char *control; /* name of the block; NULL: to be chosen */
  int kind, unit;
  QnSpectrum spectrum; /* what is entered; points are those of `points` */
  QnRecord points;
  char *file;                /* path of the points */
  QnCapacityAnswer answer;   /* of the model as it was when the curve was found */
  char *block, *title;       /* names of then */
  char *reason;              /* why its path ended before multiplier 0, or NULL */
  gboolean found;            /* whether there is a curve */
  char *digest;              /* of the model and its settings then */
  char *message;             /* NULL: what there is to say of the curve */
  GCancellable *cancellable; /* while it is searched */
  GObject *chooser;
  char *stored; /* the project's member as it was read or written last; NULL: none */
  gboolean storing;
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (MECHANISM, "mechanism", NULL)                                                   \
  FIELD (CONTROL, "control", NULL)                                                       \
  FIELD (TAKE_SELECTED, "take_selected", NULL)                                           \
  MEMBER (KIND, "kind", NULL, Form, kind)                                                \
  FIELD (AG, "ag", NULL)                                                                 \
  MEMBER (SOIL, "soil", NULL, Form, spectrum.soil)                                       \
  MEMBER (DAMPING, "damping", NULL, Form, spectrum.damping)                              \
  MEMBER (UNIT_OF_FILE, "unit", NULL, Form, unit)                                        \
  FIELD (FILE_BUTTON, "file", NULL)                                                      \
  FIELD (FILE_NAME, "file_name", NULL)                                                   \
  MEMBER (CONFIDENCE, "confidence", NULL, Form, answer.confidence)                       \
  MEMBER (TIE_STRAIN, "tie_strain", NULL, Form, answer.tie_strain)                       \
  MEMBER (PART_PERIOD, "part_period", NULL, Form, answer.part_period)                    \
  MEMBER (HEIGHT, "height", NULL, Form, spectrum.floor.height)                           \
  MEMBER (BUILDING_HEIGHT, "building_height", NULL, Form, spectrum.floor.building)       \
  MEMBER (STOREYS, "storeys", NULL, Form, spectrum.floor.storeys)                        \
  MEMBER (BUILDING_PERIOD, "building_period", NULL, Form, spectrum.floor.period)         \
  MEMBER (BUILDING_DAMPING, "building_damping", NULL, Form, spectrum.floor.damping)      \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (PLOT, "plot", NULL)                                                             \
  FIELD (TABLE, "table", NULL)                                                           \
  FIELD (FIND, "find", NULL)                                                             \
  FIELD (CANCEL, "cancel", NULL)                                                         \
  FIELD (EXPORT_PICTURE, "export_picture", NULL)                                         \
  FIELD (EXPORT_TABLE, "export_table", NULL)
QN_FORM_FIELDS;

/* ---- the answer ---- */

/* Holds the curve against what is entered. */
static void
check (Form *form)
{
  QnCapacityAnswer *answer = &form->answer;
  answer->spectrum = form->spectrum;
  answer->spectrum.kind = form->kind == TYPE_1   ? QN_SPECTRUM_EN_1
                          : form->kind == TYPE_2 ? QN_SPECTRUM_EN_2
                                                 : QN_SPECTRUM_POINTS;
  answer->spectrum.points = form->points.points;
  answer->spectrum.point_count = form->points.count;
  answer->has_spectrum =
    form->kind != NONE && (form->kind != FROM_FILE || form->points.count > 0);
  if (form->found)
    qn_capacity_answer_check (answer);
}

/* ---- what the project keeps ---- */

static const char *const kinds[] = { "type1", "type2" };

/* Keeps what is entered, as one step for a run of entries. */
static void
store (Form *form)
{
  const char soil[] = { (char) ('A' + (int) form->spectrum.soil), '\0' };
  gboolean of_code = form->kind == TYPE_1 || form->kind == TYPE_2;
  const char *folder = qn_document_get_folder (form->document);
  g_autofree char *beside = form->file != NULL ? g_path_get_dirname (form->file) : NULL;
  g_autofree char *name = form->file == NULL ? NULL
                          : g_strcmp0 (beside, folder) == 0
                            ? g_path_get_basename (form->file)
                            : g_strdup (form->file);
  QnCapacitySettings settings = {
    .control = form->control,
    .spectrum = of_code                   ? (char *) kinds[form->kind]
                : form->kind == FROM_FILE ? name
                                          : NULL,
    .ag = of_code ? form->spectrum.ground_acceleration : 0,
    .soil = of_code ? (char *) soil : NULL,
    .damping = form->spectrum.damping,
    .confidence = form->answer.confidence,
    .mechanism = form->answer.kinematic,
    .tie_strain = form->answer.tie_strain,
    .part_period = form->answer.part_period,
    .floor = form->spectrum.floor.height > 0 ? form->spectrum.floor : (QnFloor){ 0 },
    .unit = form->kind == FROM_FILE ? (char *) units[form->unit] : NULL,
  };
  g_autofree char *json = qn_capacity_settings_to_json (&settings);
  g_autoptr (GError) error = NULL;
  form->storing = TRUE;
  if (qn_document_edit_extra (form->document, _ ("Set Spectrum"), QN_CAPACITY_MEMBER,
                              QN_CAPACITY_MEMBER, json, &error)) {
    g_free (form->stored);
    form->stored =
      qn_project_dup_extra (qn_document_get_project (form->document), QN_CAPACITY_MEMBER);
  }
  form->storing = FALSE;
}

static void
clear_curve (Form *form)
{
  qn_capacity_clear (&form->answer.capacity);
  g_clear_pointer (&form->block, g_free);
  g_clear_pointer (&form->title, g_free);
  g_clear_pointer (&form->reason, g_free);
  form->found = FALSE;
}

static void
say (Form *form, const char *message)
{
  g_free (form->message);
  form->message = g_strdup (message);
  qn_bound_form_show (form);
}

static void
on_found (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *block = NULL, *reason = NULL;
  g_autofree QnCapacity *curve =
    qn_capacity_find_finish (result, &block, &reason, &error);
  /* The page may have been closed meanwhile. */
  g_autoptr (GObject) root = g_weak_ref_get (data);
  Form *form = root != NULL ? g_object_get_data (root, FORM) : NULL;
  g_weak_ref_clear (data);
  g_free (data);
  if (form == NULL) {
    if (curve != NULL)
      qn_capacity_clear (curve);
    return;
  }
  g_clear_object (&form->cancellable);
  form->found = curve != NULL;
  if (form->found) {
    form->answer.capacity = *curve;
    form->block = g_steal_pointer (&block);
    form->reason = g_steal_pointer (&reason);
    check (form);
  }
  say (form, error != NULL ? error->message : NULL);
}

static void
find (Form *form)
{
  const QnModel *model = qn_document_get_model (form->document);
  QnId control =
    form->control != NULL ? qn_model_find_block (model, form->control) : QN_NONE;
  if (form->control != NULL && control == QN_NONE) {
    g_autofree char *message =
      g_strdup_printf (_ ("No block is called %s"), form->control);
    say (form, message);
    return;
  }
  clear_curve (form);
  g_free (form->digest);
  form->digest = qn_model_digest (qn_document_get_project (form->document));
  form->title = g_strdup (model->title);
  form->cancellable = g_cancellable_new ();
  GWeakRef *root = g_new0 (GWeakRef, 1);
  g_weak_ref_init (root, form->base.root);
  form->answer.control = control;
  qn_capacity_find_async (model, &form->answer, form->cancellable, on_found, root);
  say (form, NULL);
}

/* ---- what is told ---- */

static char *
dup_facts (const Form *form)
{
  if (form->message != NULL)
    return g_strdup (form->message);
  if (form->cancellable != NULL)
    return g_strdup (form->answer.kinematic ? _ ("Searching the mechanism…")
                                            : _ ("Following the path through its peak…"));
  if (!form->found)
    return g_strdup (
      form->answer.kinematic
        ? _ ("The live load is weight times a horizontal direction. Limit analysis finds "
             "the mechanism; its parts are moved about their hinges until they carry "
             "nothing any more.")
        : _ ("The live load is weight times a horizontal direction. The path in "
             "large displacements is followed until it carries nothing any "
             "more."));
  g_autofree char *digest = qn_model_digest (qn_document_get_project (form->document));
  g_autofree char *facts = qn_capacity_answer_dup_facts (
    &form->answer, form->block, form->reason, qn_settings_get_units ());
  GString *text = g_string_new (NULL);
  if (g_strcmp0 (form->digest, digest) != 0)
    g_string_append_printf (text, "%s\n\n", _ ("The model has changed since."));
  g_string_append (text, facts);
  for (int k = 0; k < qn_capacity_answer_count_states (&form->answer); k++)
    if (form->answer.states[k].refused) {
      g_autofree char *basis =
        qn_capacity_dup_basis (&form->answer.states[k], (QnCapacityCheck) k);
      g_string_append_printf (text, "\n%s", basis);
    }
  return g_string_free (text, FALSE);
}

/* ---- files ---- */

static void
read_points (Form *form, const char *path)
{
  QnRecord record;
  g_autoptr (GError) error = NULL;
  if (!qn_capacity_read_spectrum (path, units[form->unit], &record, &error)) {
    say (form, error->message);
    return;
  }
  qn_record_clear (&form->points);
  form->points = record;
  g_free (form->file);
  form->file = g_strdup (path);
  check (form);
  say (form, NULL);
}

static void
on_points_chosen (gpointer form, const char *path, const GError *error)
{
  if (path == NULL) {
    say (form, error->message);
    return;
  }
  read_points (form, path);
  store (form);
}

static gboolean
write_file (gpointer data, const char *path, GError **error)
{
  Form *form = data;
  QnMetadata metadata;
  qn_document_get_metadata (form->document, &metadata);
  return qn_capacity_answer_export (&form->answer, form->title, &metadata, path, error);
}

/* Above what there is to say of the curve, which is still there. */
static void
on_told (gpointer form, const char *message, gboolean trouble)
{
  say (form, NULL);
  g_autofree char *facts = dup_facts (form);
  g_autofree char *both = g_strjoin ("\n\n", message, facts, NULL);
  say (form, both);
}

/* Asks for the file of what a button reads or writes. */
static void
ask (Form *form, guint field)
{
  static const char *const pictures[] = { ".png", ".svg", ".pdf", NULL };
  static const char *const tables[] = { ".csv", NULL };
  const QnFileQuestion question =
    field == FILE_BUTTON
      ? (QnFileQuestion){ .title = _ ("Read Spectrum"),
                          .accept = _ ("_Open"),
                          .chosen = on_points_chosen }
      : (QnFileQuestion){ .title = _ ("Export Capacity Curve"),
                          .accept = _ ("_Export"),
                          .name = field == EXPORT_PICTURE ? _ ("capacity.pdf")
                                                          : _ ("capacity.csv"),
                          .endings = field == EXPORT_PICTURE ? pictures : tables,
                          .write = write_file,
                          .told = on_told };
  qn_chooser_ask (form->base.root, &form->chooser, &question, form);
}

/* ---- fields ---- */

static void
set_cell (Form *form, int column, int row, const char *text)
{
  GtkGrid *grid = GTK_GRID (form->base.widgets[TABLE]);
  GtkWidget *label = gtk_grid_get_child_at (grid, column, row);
  if (label == NULL) {
    label = gtk_label_new (NULL);
    gtk_label_set_xalign (GTK_LABEL (label), column < 2 ? 0.0f : 1.0f);
    gtk_widget_add_css_class (label, row == 0 ? "dim-label" : "numeric");
    gtk_grid_attach (grid, label, column, row, 1, 1);
  }
  if (strcmp (gtk_label_get_text (GTK_LABEL (label)), text) != 0)
    gtk_label_set_text (GTK_LABEL (label), text);
}

/* A row for each limit state; those of another curve are emptied. */
static void
fill_table (Form *form)
{
  g_autoptr (GPtrArray) cells =
    qn_capacity_answer_make_table (&form->answer, qn_settings_get_units ());
  for (int i = 0; i < QN_CAPACITY_COLUMNS * (QN_CAPACITY_STATE_COUNT + 1); i++)
    set_cell (form, i % QN_CAPACITY_COLUMNS, i / QN_CAPACITY_COLUMNS,
              (guint) i < cells->len ? cells->pdata[i] : "");
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  gboolean busy = form->cancellable != NULL;
  gboolean code = form->kind == TYPE_1 || form->kind == TYPE_2;
  switch (field) {
  case MECHANISM:
    value->number = form->answer.kinematic;
    return !busy;
  case CONTROL:
    value->text = g_strdup (form->control != NULL ? form->control : "");
    return TRUE;
  case AG:
    value->number = form->spectrum.ground_acceleration / QN_STANDARD_GRAVITY;
    return code;
  case SOIL:
  case DAMPING:
    return code;
  case UNIT_OF_FILE:
  case FILE_BUTTON:
    return form->kind == FROM_FILE;
  case FILE_NAME:
    value->text = form->file != NULL ? g_path_get_basename (form->file) : g_strdup ("");
    return form->kind == FROM_FILE && form->file != NULL;
  case CONFIDENCE:
  case HEIGHT:
    return form->kind != NONE;
  case TIE_STRAIN:
    return form->answer.kinematic && !busy;
  case PART_PERIOD:
    return form->answer.kinematic && form->kind != NONE;
  case BUILDING_HEIGHT:
  case STOREYS:
  case BUILDING_PERIOD:
  case BUILDING_DAMPING:
    return form->kind != NONE && form->spectrum.floor.height > 0;
  case FACTS:
    value->text = dup_facts (form);
    return TRUE;
  case PLOT:
    gtk_widget_queue_draw (form->base.widgets[PLOT]);
    return TRUE;
  case TABLE:
    if (form->found && form->answer.has_spectrum)
      fill_table (data);
    return form->found && form->answer.has_spectrum;
  case CANCEL:
    return busy;
  case FIND:
    return !busy;
  case EXPORT_PICTURE:
  case EXPORT_TABLE:
    value->disabled = !form->found;
    return TRUE;
  default:
    return TRUE;
  }
}

static void
take_selected (Form *form)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get (qn_document_get_selection (form->document), QN_PART_BLOCK, &count);
  if (count != 1) {
    say (form, _ ("Select one block in the drawing first"));
    return;
  }
  g_free (form->control);
  form->control = g_strdup (qn_document_get_model (form->document)->blocks[ids[0]].name);
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  g_clear_pointer (&form->message, g_free);
  switch (field) {
  case MECHANISM:
    form->answer.kinematic = value->number != 0;
    clear_curve (form);
    break;
  case TIE_STRAIN:
    clear_curve (form);
    break;
  case CONTROL:
    g_free (form->control);
    form->control =
      value->text != NULL && *value->text != '\0' ? g_strdup (value->text) : NULL;
    break;
  case TAKE_SELECTED:
    take_selected (form);
    break;
  case AG:
    form->spectrum.ground_acceleration = value->number * QN_STANDARD_GRAVITY;
    break;
  case UNIT_OF_FILE:
    if (form->file != NULL) {
      g_autofree char *path = g_strdup (form->file);
      read_points (form, path);
    }
    break;
  case HEIGHT:
  case BUILDING_HEIGHT:
    form->spectrum.floor.building =
      fmax (form->spectrum.floor.building, form->spectrum.floor.height);
    break;
  case KIND:
  case SOIL:
  case DAMPING:
  case CONFIDENCE:
  case PART_PERIOD:
  case STOREYS:
  case BUILDING_PERIOD:
  case BUILDING_DAMPING:
    break;
  case FILE_BUTTON:
  case EXPORT_PICTURE:
  case EXPORT_TABLE:
    ask (form, field);
    return TRUE;
  case FIND:
    find (form);
    return TRUE;
  case CANCEL:
    g_cancellable_cancel (form->cancellable);
    return TRUE;
  default:
    return TRUE;
  }
  check (form);
  store (form);
  return TRUE;
}

/* ---- what is shown ---- */

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const Form *form = data;
  if (form->found)
    return qn_capacity_answer_plot (&form->answer);
  *message = g_strdup (_ ("Choose a spectrum, then compute the curve: it appears here."));
  return NULL;
}

/* Takes up what the project keeps; what it does not say is as at first. */
static void
load (Form *form)
{
  QnCapacitySettings kept;
  g_free (form->stored);
  form->stored =
    qn_project_dup_extra (qn_document_get_project (form->document), QN_CAPACITY_MEMBER);
  g_clear_pointer (&form->message, g_free);
  g_autoptr (GError) error = NULL;
  if (!qn_capacity_settings_read (qn_document_get_project (form->document), &kept,
                                  &error))
    form->message = g_strdup (error->message);
  const char *soil = kept.soil != NULL ? kept.soil : "B";
  gboolean is_soil = *soil >= 'A' && *soil <= 'E';
  form->spectrum =
    (QnSpectrum){ .ground_acceleration =
                    kept.ag > 0 ? kept.ag : 0.25 * QN_STANDARD_GRAVITY,
                  .soil = is_soil ? (QnSoil) (*soil - 'A') : QN_SOIL_B,
                  .damping = kept.damping > 0 && kept.damping < 1 ? kept.damping : 0.05,
                  .floor = kept.floor };
  QnFloor *floor = &form->spectrum.floor;
  floor->building = fmax (floor->building, floor->height);
  floor->storeys = MAX (floor->storeys, 1);
  floor->period = floor->period > 0 ? floor->period : 0.3;
  floor->damping = floor->damping > 0 && floor->damping < 1 ? floor->damping : 0.05;
  form->answer.tie_strain = kept.tie_strain;
  form->answer.part_period = kept.part_period;
  form->answer.confidence = fmax (kept.confidence, 1);
  if (form->answer.kinematic != kept.mechanism && form->cancellable == NULL) {
    form->answer.kinematic = kept.mechanism;
    clear_curve (form);
  }
  g_free (form->control);
  form->control = g_strdup (kept.control);
  form->unit = 0;
  for (int i = 1; i < (int) G_N_ELEMENTS (units); i++)
    if (g_strcmp0 (units[i], kept.unit) == 0)
      form->unit = i;
  form->kind = form->stored != NULL ? NONE : TYPE_1;
  for (int i = TYPE_1; i <= TYPE_2; i++)
    if (g_strcmp0 (kept.spectrum, kinds[i]) == 0)
      form->kind = i;
  if (kept.spectrum != NULL && form->kind == NONE) {
    form->kind = FROM_FILE;
    g_autofree char *path = qn_file_inside (qn_document_get_folder (form->document),
                                            kept.spectrum, FALSE, NULL);
    if (path != NULL)
      read_points (form, path);
  }
  qn_capacity_settings_clear (&kept);
  check (form);
}

static void
on_model_changed (Form *form)
{
  if (form->storing)
    return;
  g_autofree char *kept =
    qn_project_dup_extra (qn_document_get_project (form->document), QN_CAPACITY_MEMBER);
  if (g_strcmp0 (kept, form->stored) != 0)
    load (form); /* undone or done again */
  qn_bound_form_show (form);
}

static void
clear (gpointer data)
{
  Form *form = data;
  g_object_set_data (G_OBJECT (form->base.root), FORM, NULL);
  if (form->cancellable != NULL)
    g_cancellable_cancel (form->cancellable);
  g_clear_object (&form->cancellable);
  g_clear_object (&form->chooser);
  clear_curve (form);
  qn_record_clear (&form->points);
  g_free (form->control);
  g_free (form->file);
  g_free (form->stored);
  g_free (form->digest);
  g_free (form->message);
  g_object_unref (form->document);
}

GtkWidget *
qn_capacity_page_new (QnDocument *document)
{
  static const QnFormKind kind = QN_FORM_KIND ("capacity-page", Form);
  static const QnPlotHand hand = { .text_share = TEXT_SHARE, .make = make_plot };
  Form *form = qn_bound_form_new (&kind, NULL);
  form->base.clear = clear;
  form->document = g_object_ref (document);
  g_object_set_data (G_OBJECT (form->base.root), FORM, form);
  qn_plot_view_init (form->base.widgets[PLOT], &hand, form);
  qn_watch (form->base.root, document, "changed", G_CALLBACK (on_model_changed), form);
  qn_help_set_page (form->base.root, "earthquakes");
  load (form);
  return qn_bound_form_show (form);
}
