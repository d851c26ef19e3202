/* The capacity curve of the model beside a spectrum: which block is controlled, which earthquake; the
 * plot, the checks of both codes, pictures and tables of them. */
#include "app/pages/pages.h"

#include "app/forms/form.h"
#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/help.h"
#include "app/widgets/layouts.h"
#include "app/widgets/plot-view.h"
#include "app/widgets/settings.h"

#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/figures.h"
#include "io/exchange/record.h"
#include "io/project/project.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* The plot's text over that of the window. */
#define TEXT_SHARE 0.9

enum { TYPE_1, TYPE_2, FROM_FILE, NONE };

static const char *const units[] = { NULL, "g", "m/s2", "cm/s2" };

typedef struct Form {
  QnForm base;
  QnDocument *document;
  QnCapacitySettings
    entered; /* numbers, the control block, and in `spectrum` the path of a file */
  int kind, soil, unit;
  QnRecord points;           /* of that file */
  char *read;                /* what they were read from: path and unit; NULL: nothing */
  QnCapacityAnswer answer;   /* of the model as it was when the curve was found */
  char *title;               /* of then */
  gboolean found;            /* whether there is a curve */
  char *digest;              /* of the model and its settings then */
  char *message;             /* below the buttons, or NULL */
  GCancellable *cancellable; /* while it is searched */
  char *stored; /* the project's member as it was read or written last; NULL: none */
  gboolean storing;
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (MECHANISM, "mechanism", NULL, Form, entered.mechanism)                         \
  FIELD (CONTROL, "control", NULL)                                                       \
  FIELD (TAKE_SELECTED, "take_selected", NULL)                                           \
  MEMBER (KIND, "kind", NULL, Form, kind)                                                \
  FIELD (AG, "ag", NULL)                                                                 \
  MEMBER (SOIL, "soil", NULL, Form, soil)                                                \
  MEMBER (DAMPING, "damping", NULL, Form, entered.damping)                               \
  MEMBER (UNIT_OF_FILE, "unit", NULL, Form, unit)                                        \
  FIELD (FILE_BUTTON, "file", NULL)                                                      \
  FIELD (FILE_NAME, "file_name", NULL)                                                   \
  MEMBER (CONFIDENCE, "confidence", NULL, Form, entered.confidence)                      \
  MEMBER (TIE_STRAIN, "tie_strain", NULL, Form, entered.tie_strain)                      \
  MEMBER (PART_PERIOD, "part_period", NULL, Form, entered.part_period)                   \
  MEMBER (HEIGHT, "height", NULL, Form, entered.floor.height)                            \
  MEMBER (BUILDING_HEIGHT, "building_height", NULL, Form, entered.floor.building)        \
  MEMBER (STOREYS, "storeys", NULL, Form, entered.floor.storeys)                         \
  MEMBER (BUILDING_PERIOD, "building_period", NULL, Form, entered.floor.period)          \
  MEMBER (BUILDING_DAMPING, "building_damping", NULL, Form, entered.floor.damping)       \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (MESSAGE, "message", NULL)                                                       \
  FIELD (PLOT, "plot", NULL)                                                             \
  FIELD (TABLE, "table", NULL)                                                           \
  FIELD (FIND, "find", NULL)                                                             \
  FIELD (CANCEL, "cancel", NULL)                                                         \
  FIELD (EXPORT_PICTURE, "export_picture", NULL)                                         \
  FIELD (EXPORT_TABLE, "export_table", NULL)
QN_FORM_FIELDS;

/* ---- what is entered ---- */

static const char *const kinds[] = { "type1", "type2" };

/* As the project keeps it, with its name for the file; strings are borrowed. */
static QnCapacitySettings
settings_of (const Form *form, const char *file)
{
  static const char *const soils[] = { "A", "B", "C", "D", "E" };
  const gboolean of_code = form->kind <= TYPE_2;
  QnCapacitySettings s = form->entered;
  s.direct = TRUE;
  s.spectrum = (char *) (of_code                   ? kinds[form->kind]
                         : form->kind == FROM_FILE ? file
                                                   : NULL);
  s.ag = of_code ? s.ag : 0;
  s.soil = of_code ? (char *) soils[form->soil] : NULL;
  s.unit = !of_code && s.spectrum != NULL ? (char *) units[form->unit] : NULL;
  if (s.spectrum == NULL || !(s.floor.height > 0))
    s.floor = (QnFloor){ 0 };
  return s;
}

/* Holds the curve against what is entered; FALSE with a message where the file does not say it. */
static gboolean
check (Form *form)
{
  QnCapacitySettings settings = settings_of (form, form->entered.spectrum);
  g_autofree char *source =
    form->kind == FROM_FILE
      ? g_strdup_printf ("%s\n%d", form->entered.spectrum, form->unit)
      : NULL;
  g_autoptr (GError) error = NULL;
  settings.control = NULL; /* told once a curve is to be found */
  if (g_strcmp0 (source, form->read) != 0) {
    qn_record_clear (&form->points);
    g_free (form->read);
    form->read = g_steal_pointer (&source);
  }
  if (!qn_capacity_settings_apply (&settings, qn_document_get_project (form->document),
                                   TRUE, &form->answer, &form->points, &error)) {
    form->answer.has_spectrum = FALSE;
    g_free (form->message);
    form->message = g_strdup (error->message);
  } else if (form->found)
    qn_capacity_answer_check (&form->answer);
  return error == NULL;
}

/* Keeps what is entered, as one step for a run of entries. */
static void
store (Form *form)
{
  const char *folder = form->document->folder;
  const char *file = form->entered.spectrum;
  g_autofree char *beside = file != NULL ? g_path_get_dirname (file) : NULL;
  g_autofree char *name = file == NULL                      ? NULL
                          : g_strcmp0 (beside, folder) == 0 ? g_path_get_basename (file)
                                                            : g_strdup (file);
  QnCapacitySettings settings = settings_of (form, name);
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
  qn_capacity_answer_clear (&form->answer);
  g_clear_pointer (&form->title, g_free);
  form->found = FALSE;
}

static void
say (gpointer data, const char *message)
{
  Form *form = data;
  g_free (form->message);
  form->message = g_strdup (message);
  qn_form_show (form);
}

static void
on_found (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (GError) error = NULL;
  Form *form = data;
  g_clear_object (&form->cancellable);
  form->found = qn_capacity_find_finish (result, &form->answer, &error);
  if (form->found)
    check (form);
  if (!form->base.closed)
    say (form, error != NULL ? error->message : NULL);
  qn_form_unref (form);
}

static void
find (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  Form *form = data;
  const QnModel *model = &form->document->project.model;
  QnId control = form->entered.control != NULL
                   ? qn_model_find_block (model, form->entered.control)
                   : QN_NONE;
  if (form->entered.control != NULL && control == QN_NONE) {
    g_autofree char *message =
      g_strdup_printf (_ ("No block is called %s"), form->entered.control);
    say (form, message);
    return;
  }
  clear_curve (form);
  g_free (form->digest);
  form->digest = qn_model_digest (qn_document_get_project (form->document), NULL);
  form->title = g_strdup (model->title);
  form->cancellable = g_cancellable_new ();
  form->answer.control = control;
  qn_capacity_find_async (model, &form->answer, form->cancellable, on_found,
                          g_rc_box_acquire (form));
  say (form, NULL);
}

static void
cancel (GSimpleAction *action, GVariant *parameter, gpointer form)
{
  g_cancellable_cancel (((Form *) form)->cancellable);
}

/* ---- files ---- */

static gboolean
read_points (gpointer data, const char *path, GError **error)
{
  Form *form = data;
  g_autofree char *before = form->entered.spectrum;
  form->entered.spectrum = g_strdup (path);
  g_clear_pointer (&form->read, g_free); /* it may have changed */
  g_clear_pointer (&form->message, g_free);
  if (!check (form)) { /* one that cannot be read is not taken */
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, form->message);
    g_free (form->entered.spectrum);
    form->entered.spectrum = g_steal_pointer (&before);
    check (form);
    return FALSE;
  }
  store (form);
  say (form, NULL);
  return TRUE;
}

static gboolean
write_file (gpointer data, const char *path, GError **error)
{
  Form *form = data;
  QnMetadata metadata;
  qn_document_get_metadata (form->document, &metadata);
  return qn_capacity_answer_export (&form->answer, form->title, &metadata, path, error);
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
                          .use = read_points,
                          .failed = say }
      : (QnFileQuestion){ .title = _ ("Export Capacity Curve"),
                          .accept = _ ("_Export"),
                          .name = field == EXPORT_PICTURE ? _ ("capacity.pdf")
                                                          : _ ("capacity.csv"),
                          .endings = field == EXPORT_PICTURE ? pictures : tables,
                          .use = write_file,
                          .told = say };
  qn_chooser_ask (form->base.root, &question, form);
}

/* ---- fields ---- */

static char *
dup_facts (const Form *form)
{
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
  g_autofree char *digest =
    qn_model_digest (qn_document_get_project (form->document), NULL);
  g_autofree char *facts =
    qn_capacity_answer_dup_facts (&form->answer, qn_settings_get_units ());
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

/* A row for each limit state; those of another curve are emptied. */
static void
fill_table (Form *form)
{
  g_autoptr (GPtrArray) cells =
    qn_capacity_answer_make_table (&form->answer, qn_settings_get_units ());
  GtkGrid *grid = GTK_GRID (form->base.widgets[TABLE]);
  for (int i = 0; i < QN_CAPACITY_COLUMNS * (QN_CAPACITY_STATE_COUNT + 1); i++) {
    const int column = i % QN_CAPACITY_COLUMNS, row = i / QN_CAPACITY_COLUMNS;
    const char *text = (guint) i < cells->len ? cells->pdata[i] : "";
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
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  gboolean busy = form->cancellable != NULL;
  gboolean code = form->kind == TYPE_1 || form->kind == TYPE_2;
  switch (field) {
  case MECHANISM:
    return !busy;
  case CONTROL:
    value->text = g_strdup (form->entered.control != NULL ? form->entered.control : "");
    return TRUE;
  case AG:
    value->number = form->entered.ag / QN_STANDARD_GRAVITY;
    return code;
  case SOIL:
  case DAMPING:
    return code;
  case UNIT_OF_FILE:
  case FILE_BUTTON:
    return form->kind == FROM_FILE;
  case FILE_NAME:
    if (form->entered.spectrum != NULL)
      value->text = g_path_get_basename (form->entered.spectrum);
    return form->kind == FROM_FILE && form->entered.spectrum != NULL;
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
    return form->kind != NONE && form->entered.floor.height > 0;
  case FACTS:
    value->text = dup_facts (form);
    return TRUE;
  case MESSAGE:
    value->text = g_strdup (form->message);
    return form->message != NULL;
  case PLOT:
    gtk_widget_queue_draw (form->base.widgets[PLOT]);
    return TRUE;
  case TABLE:
    if (form->found && form->answer.has_spectrum)
      fill_table ((Form *) data);
    return form->found && form->answer.has_spectrum;
  case CANCEL:
    qn_actions_enable (form->base.root, "cancel", busy);
    return busy;
  case FIND:
    qn_actions_enable (form->base.root, "run", !busy);
    return !busy;
  case EXPORT_PICTURE:
  case EXPORT_TABLE:
    value->disabled = !form->found;
    break;
  }
  return TRUE;
}

static void
take_selected (Form *form)
{
  guint count = 0;
  const QnId *ids = qn_selection_get (form->document->selection, QN_PICK_BLOCK, &count);
  if (count != 1) {
    say (form, _ ("Select one block in the drawing first"));
    return;
  }
  g_free (form->entered.control);
  form->entered.control = g_strdup (form->document->project.model.blocks[ids[0]].name);
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Form *form = (Form *) data;
  g_clear_pointer (&form->message, g_free);
  switch (field) {
  case MECHANISM:
  case TIE_STRAIN:
    clear_curve (form);
    break;
  case CONTROL:
    g_free (form->entered.control);
    form->entered.control =
      value->text != NULL && *value->text != '\0' ? g_strdup (value->text) : NULL;
    break;
  case TAKE_SELECTED:
    take_selected (form);
    break;
  case AG:
    form->entered.ag = value->number * QN_STANDARD_GRAVITY;
    break;
  case HEIGHT:
  case BUILDING_HEIGHT:
    form->entered.floor.building =
      fmax (form->entered.floor.building, form->entered.floor.height);
    break;
  case FILE_BUTTON:
  case EXPORT_PICTURE:
  case EXPORT_TABLE:
    ask (form, field);
    return TRUE;
  default:
    break;
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
  *message =
    g_strdup (form->cancellable != NULL
                ? ""
                : _ ("Choose a spectrum, then compute the curve: it appears here."));
  return NULL;
}

static double
share_or (double share, double usual)
{
  return share > 0 && share < 1 ? share : usual;
}

/* Takes up what the project keeps; what it does not say is as at first. */
static void
load (Form *form)
{
  const QnProject *project = qn_document_get_project (form->document);
  QnCapacitySettings *kept = &form->entered;
  QnFloor *floor = &kept->floor;
  g_autoptr (GError) error = NULL;
  g_free (form->stored);
  form->stored = qn_project_dup_extra (project, QN_CAPACITY_MEMBER);
  g_clear_pointer (&form->message, g_free);
  qn_capacity_settings_clear (kept);
  if (!qn_capacity_settings_read (project, kept, &error))
    form->message = g_strdup (error->message);
  g_autofree char *spectrum = g_steal_pointer (&kept->spectrum);
  g_autofree char *soil = g_steal_pointer (&kept->soil);
  g_autofree char *unit = g_steal_pointer (&kept->unit);
  kept->ag = kept->ag > 0 ? kept->ag : 0.25 * QN_STANDARD_GRAVITY;
  kept->damping = share_or (kept->damping, 0.05);
  kept->confidence = fmax (kept->confidence, 1);
  floor->building = fmax (floor->building, floor->height);
  floor->storeys = MAX (floor->storeys, 1);
  floor->period = floor->period > 0 ? floor->period : 0.3;
  floor->damping = share_or (floor->damping, 0.05);
  form->soil = soil != NULL && *soil >= 'A' && *soil <= 'E' ? *soil - 'A' : QN_SOIL_B;
  form->unit = 0;
  for (int i = 1; i < (int) G_N_ELEMENTS (units); i++)
    if (g_strcmp0 (units[i], unit) == 0)
      form->unit = i;
  form->kind = spectrum != NULL ? FROM_FILE : form->stored != NULL ? NONE : TYPE_1;
  for (int i = TYPE_1; i <= TYPE_2; i++)
    if (g_strcmp0 (spectrum, kinds[i]) == 0)
      form->kind = i;
  if (form->kind == FROM_FILE)
    kept->spectrum = qn_file_inside (form->document->folder, spectrum, FALSE, NULL);
  if (form->answer.kinematic != kept->mechanism && form->cancellable == NULL)
    clear_curve (form);
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
  qn_form_show (form);
}

static void
on_destroy (Form *form)
{
  g_cancellable_cancel (form->cancellable);
}

static void
clear (QnForm *data)
{
  Form *form = (Form *) data;
  clear_curve (form);
  qn_record_clear (&form->points);
  qn_capacity_settings_clear (&form->entered);
  g_free (form->read);
  g_free (form->stored);
  g_free (form->digest);
  g_free (form->message);
  g_object_unref (form->document);
}

GtkWidget *
qn_capacity_page_new (QnDocument *document)
{
  static const QnFormKind kind = QN_FORM_KIND ("capacity-page", Form, .clear = clear);
  static const QnPlotHand hand = { .text_share = TEXT_SHARE, .make = make_plot };
  static const GActionEntry entries[] = { { .name = "run", .activate = find },
                                          { .name = "cancel", .activate = cancel } };
  Form *form = qn_form_new (&kind, NULL);
  form->document = g_object_ref (document);
  qn_actions_insert (form->base.root, "capacity", entries, G_N_ELEMENTS (entries), form);
  g_signal_connect_swapped (form->base.root, "destroy", G_CALLBACK (on_destroy), form);
  qn_plot_view_init (form->base.widgets[PLOT], &hand, form);
  qn_layout_wrap_pair (
    gtk_widget_get_parent (gtk_widget_get_parent (form->base.widgets[PLOT])));
  qn_watch (form->base.root, document, "changed", G_CALLBACK (on_model_changed), form);
  qn_help_set_page (form->base.root, "earthquakes");
  load (form);
  return qn_form_show (form);
}
