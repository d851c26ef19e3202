#include "app/dialogs/study-window.h"

#include "app/widgets/build-tree.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "app/widgets/help.h"
#include "app/widgets/quantity-entry.h"
#include "core/base/integer.h"
#include "io/text/io-error.h"
#include "io/text/number-text.h"
#include "study/cases/study-job.h"
#include "study/plan/draft.h"
#include "study/report/figures.h"
#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* ms between two looks at a study that runs. */
#define INTERVAL 250

/* px: a click this near to a point means it. */
#define NEAR 12.0

/* px of a point of text on the screen. */
#define UNIT (96.0 / 72.0)

#define STEPS_OF_LOAD 41

typedef struct StudyWindow {
  QnStudyParent parent;
  GtkWindow *window;
  GtkListBox *parameters;
  GtkDropDown *analysis, *plan, *figure, *of, *by, *by_second;
  GtkSpinButton *count;
  GtkWidget *outputs, *plot, *over, *and;
  GtkProgressBar *progress;
  GtkLabel *status;
  GSimpleActionGroup *actions;
  GObject *chooser;

  QnDraft *draft;
  QnStudyJob *job; /* while it runs */
  guint timeout;
  gboolean showing; /* the draft is being shown: nobody has entered anything */

  char *running; /* folder of the results that are computed now, or last */
  char *folder;  /* of the results shown, or NULL */
  QnStudy study; /* that they belong to */
  QnTable table;
  gint64 chosen;    /* row, or -1 */
  gboolean scatter; /* points were drawn, and lie at `place` */
  QnPlotPlace place;
} StudyWindow;

static void show_draft (StudyWindow *self);

/* ---- results ---- */

static void
tell (StudyWindow *self, const char *text)
{
  gtk_label_set_text (self->status, text);
}

static void
forget_results (StudyWindow *self)
{
  if (self->folder == NULL)
    return;
  qn_table_clear (&self->table);
  qn_study_clear (&self->study);
  g_clear_pointer (&self->folder, g_free);
  self->chosen = -1;
}

/* Folder of the present state of a study. */
static char *
dup_folder (const QnStudy *study, const char *path)
{
  g_autofree char *sum = g_strndup (study->sha256, 8);
  g_autofree char *stem = g_str_has_suffix (path, ".quoin-study")
                            ? g_strndup (path, strlen (path) - strlen (".quoin-study"))
                            : g_strdup (path);
  return g_strdup_printf ("%s-study-%s", stem, sum);
}

static void
fill (GtkDropDown *choice, const QnStudy *study, gboolean outputs)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  for (guint i = 0; !outputs && i < study->parameters->len; i++)
    g_strv_builder_add (names, qn_study_parameter (study, i)->name);
  for (guint i = 0; outputs && i < study->outputs->len; i++)
    if (qn_study_output_is_number (qn_study_output (study, i)))
      g_strv_builder_add (names, qn_study_output_names[qn_study_output (study, i)]);
  g_auto (GStrv) strings = g_strv_builder_end (names);
  g_autoptr (GtkStringList) list = gtk_string_list_new ((const char *const *) strings);
  gtk_drop_down_set_model (choice, G_LIST_MODEL (list));
}

/* What has come in since, of a study that runs. */
static void
read_more (StudyWindow *self)
{
  QnTable table;
  if (!qn_table_read (&table, &self->study, self->folder, NULL))
    return;
  qn_table_clear (&self->table);
  self->table = table;
  gtk_widget_queue_draw (self->plot);
}

/* Reads what has been computed of the study as it is now; none is no error. */
static void
read_results (StudyWindow *self)
{
  QnStudy study;
  QnTable table;
  if (!qn_study_read (qn_draft_get_path (self->draft), NULL, &study, NULL))
    return;
  g_autofree char *folder = dup_folder (&study, qn_draft_get_path (self->draft));
  gboolean same = g_strcmp0 (folder, self->folder) == 0;
  forget_results (self);
  self->study = study;
  if (!qn_table_read (&table, &self->study, folder, NULL)) {
    qn_study_clear (&self->study);
    return;
  }
  self->table = table;
  self->folder = g_steal_pointer (&folder);
  if (!same) {
    fill (self->of, &self->study, TRUE);
    fill (self->by, &self->study, FALSE);
    fill (self->by_second, &self->study, FALSE);
    if (self->study.parameters->len > 1)
      gtk_drop_down_set_selected (self->by_second, 1);
  }
  gtk_widget_queue_draw (self->plot);
}

static int
column_of (StudyWindow *self, GtkDropDown *choice)
{
  GtkStringObject *item = gtk_drop_down_get_selected_item (choice);
  return item != NULL ? qn_table_find (&self->table, gtk_string_object_get_string (item))
                      : -1;
}

static gboolean
chosen_figure (StudyWindow *self, QnStudyFigure *figure)
{
  static const QnStudyFigureKind kinds[] = {
    QN_STUDY_FIGURE_CUMULATIVE, QN_STUDY_FIGURE_SCATTER,  QN_STUDY_FIGURE_HISTOGRAM,
    QN_STUDY_FIGURE_TORNADO,    QN_STUDY_FIGURE_ENVELOPE, QN_STUDY_FIGURE_SURFACE
  };
  guint row = gtk_drop_down_get_selected (self->figure);
  if (self->folder == NULL || row >= G_N_ELEMENTS (kinds))
    return FALSE;
  *figure = (QnStudyFigure){ .kind = kinds[row],
                             .column = column_of (self, self->of),
                             .parameters = { column_of (self, self->by),
                                             column_of (self, self->by_second) } };
  return figure->column >= 0 && figure->parameters[0] >= 0 && figure->parameters[1] >= 0;
}

static void
draw_message (cairo_t *cr, GtkWidget *widget, const char *text, int width, int height)
{
  g_autoptr (PangoLayout) layout = gtk_widget_create_pango_layout (widget, text);
  int w, h;
  pango_layout_set_width (layout, (width - 40) * PANGO_SCALE);
  pango_layout_set_alignment (layout, PANGO_ALIGN_CENTER);
  pango_layout_get_pixel_size (layout, &w, &h);
  cairo_set_source_rgb (cr, 0.35, 0.35, 0.35);
  cairo_move_to (cr, 20, (height - h) / 2.0);
  pango_cairo_show_layout (cr, layout);
}

static void
draw_plot (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  StudyWindow *self = data;
  QnStudyFigure figure;
  g_autoptr (GError) error = NULL;
  self->scatter = FALSE;
  /* Figures are drawn on paper, in a dark window too. */
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  if (!chosen_figure (self, &figure)) {
    draw_message (cr, GTK_WIDGET (area),
                  _ ("Choose what varies, then run the study: its cases appear here."),
                  width, height);
    return;
  }
  if (!qn_study_figure_draw (&figure, &self->table, cr, width, height, UNIT, &self->place,
                             &error)) {
    draw_message (cr, GTK_WIDGET (area), _ ("No case has this output yet."), width,
                  height);
    return;
  }
  self->scatter =
    figure.kind == QN_STUDY_FIGURE_SCATTER || figure.kind == QN_STUDY_FIGURE_ENVELOPE;
  if (!self->scatter || self->chosen < 0
      || (guint64) self->chosen >= self->table.rows->len)
    return;
  double x =
    qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.parameters[0]);
  double y = qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.column);
  if (isnan (y))
    return;
  cairo_new_path (cr);
  cairo_arc (cr, self->place.x_zero + self->place.x_scale * x,
             self->place.y_zero + self->place.y_scale * y, 7, 0, 2 * G_PI);
  cairo_set_source_rgb (cr, 0.85, 0.35, 0);
  cairo_set_line_width (cr, 2);
  cairo_stroke (cr);
}

/* ---- a case in the drawing ---- */

typedef struct Opening {
  char *folder;
  gsize index;
  double *values;
  char *name;
  QnRun *run;
} Opening;

static void
free_opening (gpointer data)
{
  Opening *opening = data;
  g_clear_pointer (&opening->run, qn_run_unref);
  g_free (opening->folder);
  g_free (opening->values);
  g_free (opening->name);
  g_free (opening);
}

/* In a thread of its own: the case analysed again, from the copies in its folder. */
static void
solve_case (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  Opening *opening = data;
  QnStudy study;
  QnCaseSolver solver;
  QnCaseModel model;
  QnCaseResult result;
  GError *error = NULL;
  (void) source;
  (void) cancellable;
  if (!qn_folder_read_study (opening->folder, &study, &error)) {
    g_task_return_error (task, error);
    return;
  }
  if (!qn_case_solver_init (&solver, &study, &error)) {
    qn_study_clear (&study);
    g_task_return_error (task, error);
    return;
  }
  qn_case_solve (&solver, opening->values, NULL, &model, &result);
  if (result.failed) {
    error = g_error_new_literal (QN_IO_ERROR, QN_IO_ERROR_INVALID, result.reason);
  } else {
    opening->run = qn_run_new (opening->name, "");
    opening->run->model = model.project.model;
    opening->run->contacts = model.contacts;
    opening->run->result = model.result;
    model.project.model = (QnModel){ 0 };
    model.contacts = (QnContacts){ 0 };
    model.result = (QnResult){ 0 };
    qn_case_model_clear (&model);
  }
  qn_case_result_clear (&result);
  qn_case_solver_clear (&solver);
  qn_study_clear (&study);
  if (error != NULL)
    g_task_return_error (task, error);
  else
    g_task_return_boolean (task, TRUE);
}

static void
on_solved (GObject *source, GAsyncResult *task, gpointer data)
{
  QnViewState *state = QN_VIEW_STATE (source);
  g_autoptr (GtkLabel) status = data;
  Opening *opening = g_task_get_task_data (G_TASK (task));
  g_autoptr (GError) error = NULL;
  if (!g_task_propagate_boolean (G_TASK (task), &error)) {
    gtk_label_set_text (status, error->message);
    return;
  }
  QnRun *run = opening->run;
  qn_document_add_run (qn_view_state_get_document (state), run);
  qn_view_state_set_view (state, run->result.mechanism != NULL ? QN_VIEW_MECHANISM
                                 : run->result.step_count > 0  ? QN_VIEW_DEFORMED
                                                               : QN_VIEW_MODEL);
  g_autofree char *text = g_strdup_printf (_ ("%s is shown in the drawing."), run->name);
  gtk_label_set_text (status, text);
}

static void
open_case (StudyWindow *self)
{
  if (self->folder == NULL || self->chosen < 0)
    return;
  gsize row = (gsize) self->chosen;
  Opening *opening = g_new0 (Opening, 1);
  opening->index = g_array_index (self->table.rows, QnRow, row).index;
  opening->folder = g_strdup (self->folder);
  opening->values = g_memdup2 (self->table.numbers + row * self->table.width,
                               self->table.parameters * sizeof (double));
  opening->name = g_strdup_printf (_ ("Case %zu"), opening->index + 1);
  g_autoptr (GTask) task =
    g_task_new (self->parent.state, NULL, on_solved, g_object_ref (self->status));
  g_task_set_task_data (task, opening, free_opening);
  g_task_run_in_thread (task, solve_case);
}

static void
choose (StudyWindow *self, gint64 row)
{
  QnStudyFigure figure;
  if (!chosen_figure (self, &figure) || row < 0 || row >= (gint64) self->table.rows->len)
    return;
  const QnRow *found = &g_array_index (self->table.rows, QnRow, (guint) row);
  self->chosen = row;
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_append_printf (text, _ ("Case %zu"), found->index + 1);
  for (gsize k = 0; k < self->table.parameters; k++)
    g_string_append_printf (text, " · %s %.4g", qn_table_column_name (&self->table, k),
                            qn_table_number (&self->table, (gsize) row, k));
  if (found->failed)
    g_string_append_printf (text, " · %s", found->reason);
  else
    g_string_append_printf (
      text, " · %s %.4g%s%s", qn_table_column_name (&self->table, (gsize) figure.column),
      qn_table_number (&self->table, (gsize) row, (gsize) figure.column),
      found->mechanism != NULL ? " · " : "",
      found->mechanism != NULL ? found->mechanism : "");
  tell (self, text->str);
  gtk_widget_queue_draw (self->plot);
}

static void
on_click (GtkGestureClick *gesture, int count, double x, double y, StudyWindow *self)
{
  QnStudyFigure figure;
  double best = NEAR;
  gint64 nearest = -1;
  (void) gesture;
  (void) count;
  gtk_widget_grab_focus (self->plot);
  if (!self->scatter || !chosen_figure (self, &figure))
    return;
  for (guint i = 0; i < self->table.rows->len; i++) {
    double px = self->place.x_zero
                + self->place.x_scale
                    * qn_table_number (&self->table, i, (gsize) figure.parameters[0]);
    double py =
      self->place.y_zero
      + self->place.y_scale * qn_table_number (&self->table, i, (gsize) figure.column);
    double distance = hypot (px - x, py - y);
    if (distance < best) { /* false for NaN */
      best = distance;
      nearest = i;
    }
  }
  if (nearest < 0)
    return;
  choose (self, nearest);
  open_case (self);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, StudyWindow *self)
{
  (void) controller;
  (void) keycode;
  (void) modifiers;
  switch (keyval) {
  case GDK_KEY_Right:
    choose (self, self->chosen + 1);
    return TRUE;
  case GDK_KEY_Left:
    choose (self, self->chosen - 1);
    return TRUE;
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
    open_case (self);
    return TRUE;
  default:
    return FALSE;
  }
}

/* ---- running ---- */

static void
update_actions (StudyWindow *self)
{
  const struct {
    const char *name;
    gboolean enabled;
  } actions[] = { { "run", self->job == NULL && qn_draft_count (self->draft) > 0 },
                  { "cancel", self->job != NULL },
                  { "undo", qn_draft_can_undo (self->draft) && self->job == NULL },
                  { "redo", qn_draft_can_redo (self->draft) && self->job == NULL },
                  { "export", self->folder != NULL } };
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
    g_simple_action_set_enabled (G_SIMPLE_ACTION (g_action_map_lookup_action (
                                   G_ACTION_MAP (self->actions), actions[i].name)),
                                 actions[i].enabled);
}

static void
show_progress (StudyWindow *self, const QnStudyProgress *progress)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text, _ ("%zu of %zu cases, %zu failed"), progress->present,
                   progress->wanted, progress->failed);
  if (self->job != NULL && !isnan (progress->to_go) && progress->present > 0) {
    guint seconds = (guint) qn_to_integer (progress->to_go, 0, G_MAXINT32);
    g_string_append_printf (text, _ (", %u:%02u:%02u to go"), seconds / 3600,
                            seconds / 60 % 60, seconds % 60);
  }
  tell (self, text->str);
  if (progress->wanted > 0)
    gtk_progress_bar_set_fraction (self->progress, (double) progress->present
                                                     / (double) progress->wanted);
}

static gboolean
on_timeout (gpointer data)
{
  StudyWindow *self = data;
  QnStudyProgress progress;
  g_autoptr (GError) error = NULL;
  QnStudyJobState state = qn_study_job_look (self->job, &progress, &error);
  if (g_strcmp0 (self->folder, self->running) == 0)
    read_more (self);
  else
    read_results (self);
  if (state == QN_STUDY_JOB_RUNS) {
    show_progress (self, &progress);
    return G_SOURCE_CONTINUE;
  }
  g_clear_pointer (&self->job, qn_study_job_free);
  self->timeout = 0;
  gtk_widget_set_visible (GTK_WIDGET (self->progress), FALSE);
  if (error != NULL)
    tell (self, error->message);
  else
    show_progress (self, &progress);
  update_actions (self);
  return G_SOURCE_REMOVE;
}

/* quoin-cli, which computes the cases: beside this program, in the build tree, or in the path. */
static char *
dup_program (void)
{
  g_autofree char *own = g_file_read_link ("/proc/self/exe", NULL);
  g_autofree char *folder = g_path_get_dirname (own != NULL ? own : "");
  char *beside = g_build_filename (folder, "quoin-cli", NULL);
  if (g_file_test (beside, G_FILE_TEST_IS_EXECUTABLE))
    return beside;
  g_free (beside);
  g_autofree char *sources = qn_build_tree_dup_folder ("src");
  if (sources != NULL)
    return g_build_filename (sources, "cli", "quoin-cli", NULL);
  return g_find_program_in_path ("quoin-cli");
}

static gboolean
start (StudyWindow *self, GError **error)
{
  QnStudy study;
  g_autofree char *program = dup_program ();
  const char *path = qn_draft_get_path (self->draft);
  if (qn_document_is_modified (self->parent.document)) {
    g_set_error_literal (
      error, QN_IO_ERROR, QN_IO_ERROR_FILE,
      _ ("Save the project first: a study computes what its file says."));
    return FALSE;
  }
  if (program == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("quoin-cli, which computes the cases, is not installed."));
    return FALSE;
  }
  if (!qn_draft_save (self->draft, error) || !qn_study_read (path, NULL, &study, error))
    return FALSE;
  g_free (self->running);
  self->running = dup_folder (&study, path);
  qn_study_clear (&study);
  self->job =
    qn_study_job_start (path, self->running, program, g_get_num_processors (), error);
  return self->job != NULL;
}

static void
run (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  g_autoptr (GError) error = NULL;
  (void) action;
  (void) parameter;
  if (self->job != NULL)
    return;
  if (!start (self, &error)) {
    tell (self, error->message);
    return;
  }
  tell (self, "");
  gtk_progress_bar_set_fraction (self->progress, 0);
  gtk_widget_set_visible (GTK_WIDGET (self->progress), TRUE);
  self->timeout = g_timeout_add (INTERVAL, on_timeout, self);
  update_actions (self);
}

static void
cancel (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  (void) action;
  (void) parameter;
  if (self->job != NULL)
    qn_study_job_cancel (self->job);
}

static void
undo (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  (void) action;
  (void) parameter;
  qn_draft_undo (self->draft);
  show_draft (self);
}

static void
redo (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  (void) action;
  (void) parameter;
  qn_draft_redo (self->draft);
  show_draft (self);
}

/* ---- export ---- */

static gboolean
export_to (StudyWindow *self, const char *what, const char *path, GError **error)
{
  QnOutput output;
  QnStudyFigure figure = { .kind = QN_STUDY_FIGURE_MECHANISMS };
  const QnMetadata metadata = { .title = self->study.title };
  if (g_str_equal (what, "table"))
    return qn_table_write (&self->table, path, error);
  qn_output_init (&output);
  if (g_str_equal (what, "figure") && !chosen_figure (self, &figure))
    return FALSE;
  return qn_study_figure_export (&figure, &self->table, path, &output, &metadata, error);
}

static void
on_export_response (GtkNativeDialog *dialog, int response, StudyWindow *self)
{
  static const char *const tables[] = { ".csv", NULL };
  static const char *const figures[] = { ".png", ".svg", ".pdf", NULL };
  const char *what = g_object_get_data (G_OBJECT (dialog), "qn-what");
  g_autoptr (GError) error = NULL;
  if (response == GTK_RESPONSE_ACCEPT && self->folder != NULL) {
    g_autofree char *path = qn_dialog_dup_chosen_path (
      dialog, g_str_equal (what, "table") ? tables : figures, &error);
    if (path != NULL && export_to (self, what, path, &error)) {
      g_autofree char *text = g_strdup_printf (_ ("Written to %s"), path);
      tell (self, text);
    } else if (error != NULL) {
      tell (self, error->message);
    }
  }
  g_clear_object (&self->chooser);
}

static void
export_results (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  const char *what = g_variant_get_string (parameter, NULL);
  gboolean table = g_str_equal (what, "table");
  (void) action;
  GtkFileChooserNative *chooser = qn_chooser_begin (
    self->window, &self->chooser, GTK_FILE_CHOOSER_ACTION_SAVE,
    table ? _ ("Export Table of the Study") : _ ("Export Figure of the Study"),
    _ ("_Export"));
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser),
                                     table ? "study.csv" : "study.png");
  g_object_set_data_full (G_OBJECT (chooser), "qn-what", g_strdup (what), g_free);
  g_signal_connect (chooser, "response", G_CALLBACK (on_export_response), self);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

/* The same without asking: (what, path). */
static void
export_path (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  const char *what, *path;
  g_autoptr (GError) error = NULL;
  (void) action;
  g_variant_get (parameter, "(&s&s)", &what, &path);
  if (self->folder != NULL && !export_to (self, what, path, &error) && error != NULL)
    tell (self, error->message);
}

/* The main window draws; it comes back with qn_study_window_move_load(). */
static void
move_load (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  StudyWindow *self = data;
  (void) action;
  (void) parameter;
  gtk_window_present (self->parent.window);
  gtk_widget_activate_action (GTK_WIDGET (self->parent.window), "win.tool", "s", "path");
}

/* ---- the draft ---- */

static guint
index_of (GtkWidget *row_part)
{
  GtkWidget *row = gtk_widget_get_ancestor (row_part, GTK_TYPE_LIST_BOX_ROW);
  return (guint) gtk_list_box_row_get_index (GTK_LIST_BOX_ROW (row));
}

/* Fields of a row, kept with it. */
typedef struct Row {
  GtkDropDown *kind;
  QnQuantityEntry *first, *second, *levels;
  GtkEntry *name;
} Row;

static void
on_values (GtkWidget *part, StudyWindow *self)
{
  Row *row = g_object_get_data (
    G_OBJECT (gtk_widget_get_ancestor (part, GTK_TYPE_LIST_BOX_ROW)), "qn-row");
  if (self->showing)
    return;
  qn_draft_set_values (
    self->draft, index_of (part), (QnDraftKind) gtk_drop_down_get_selected (row->kind),
    qn_quantity_entry_get_value (row->first), qn_quantity_entry_get_value (row->second),
    (int) qn_to_integer (qn_quantity_entry_get_value (row->levels), 0,
                         QN_STUDY_MAX_VALUES));
  show_draft (self);
}

static void
on_kind (GtkDropDown *choice, GParamSpec *pspec, StudyWindow *self)
{
  (void) pspec;
  if (gtk_drop_down_get_selected (choice) < QN_DRAFT_OTHER)
    on_values (GTK_WIDGET (choice), self);
}

static void
on_name (GtkEntry *entry, StudyWindow *self)
{
  if (self->showing)
    return;
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  qn_draft_set_name (self->draft, index_of (GTK_WIDGET (entry)), name);
  show_draft (self);
}

static void
on_remove (GtkButton *button, StudyWindow *self)
{
  qn_draft_remove (self->draft, index_of (GTK_WIDGET (button)));
  show_draft (self);
}

static void
name_for_readers (gpointer widget, const char *what)
{
  gtk_accessible_update_property (GTK_ACCESSIBLE (widget), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  what, -1);
  gtk_widget_set_tooltip_text (widget, what);
}

static QnQuantityEntry *
add_number (StudyWindow *self, GtkWidget *box, const char *what, double value)
{
  GtkWidget *entry = qn_quantity_entry_new (QN_QUANTITY_NUMBER, -1e18, 1e18);
  qn_quantity_entry_set_value (QN_QUANTITY_ENTRY (entry), value);
  gtk_widget_set_hexpand (entry, TRUE);
  name_for_readers (entry, what);
  g_signal_connect (entry, "committed", G_CALLBACK (on_values), self);
  gtk_box_append (GTK_BOX (box), entry);
  return QN_QUANTITY_ENTRY (entry);
}

static void
add_row (StudyWindow *self, guint index)
{
  const char *const kinds[] = { _ ("From, to"), _ ("Normal"), _ ("Lognormal"),
                                _ ("Values from, to"), NULL };
  g_autofree Row *row = g_new0 (Row, 1);
  QnDraftParameter parameter = qn_draft_parameter (self->draft, index);
  g_autofree char *path = parameter.path;
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
  GtkWidget *head = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  GtkWidget *values = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  GtkWidget *place = gtk_label_new (path);
  GtkWidget *remove = gtk_button_new_from_icon_name ("user-trash-symbolic");
  row->name = GTK_ENTRY (gtk_entry_new ());
  gtk_editable_set_text (GTK_EDITABLE (row->name), parameter.name);
  gtk_editable_set_width_chars (GTK_EDITABLE (row->name), 12);
  name_for_readers (row->name, _ ("Name of the parameter"));
  g_signal_connect (row->name, "activate", G_CALLBACK (on_name), self);
  gtk_label_set_ellipsize (GTK_LABEL (place), PANGO_ELLIPSIZE_START);
  gtk_label_set_xalign (GTK_LABEL (place), 0.0f);
  gtk_widget_set_hexpand (place, TRUE);
  gtk_widget_set_tooltip_text (place, path);
  gtk_widget_add_css_class (place, "dim-label");
  gtk_widget_add_css_class (remove, "flat");
  name_for_readers (remove, _ ("Leave it as it is"));
  g_signal_connect (remove, "clicked", G_CALLBACK (on_remove), self);
  gtk_box_append (GTK_BOX (head), GTK_WIDGET (row->name));
  gtk_box_append (GTK_BOX (head), place);
  gtk_box_append (GTK_BOX (head), remove);
  gtk_box_append (GTK_BOX (box), head);
  if (parameter.kind == QN_DRAFT_OTHER) {
    GtkWidget *text = gtk_label_new (parameter.line ? _ ("along the line that was drawn")
                                                    : _ ("as the study file says"));
    gtk_label_set_xalign (GTK_LABEL (text), 0.0f);
    gtk_box_append (GTK_BOX (values), text);
  } else {
    gboolean ends =
      parameter.kind == QN_DRAFT_UNIFORM || parameter.kind == QN_DRAFT_RANGE;
    row->kind = GTK_DROP_DOWN (gtk_drop_down_new_from_strings (kinds));
    gtk_drop_down_set_selected (row->kind, parameter.kind);
    name_for_readers (row->kind, _ ("Distribution"));
    g_signal_connect (row->kind, "notify::selected", G_CALLBACK (on_kind), self);
    gtk_box_append (GTK_BOX (values), GTK_WIDGET (row->kind));
    row->first =
      add_number (self, values, ends ? _ ("Least") : _ ("Mean"), parameter.first);
    row->second = add_number (self, values, ends ? _ ("Greatest") : _ ("Deviation"),
                              parameter.second);
    row->levels = add_number (self, values, _ ("Number of values"), parameter.levels);
    int count;
    QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
    gtk_widget_set_visible (GTK_WIDGET (row->levels), parameter.kind == QN_DRAFT_RANGE
                                                        || plan == QN_PLAN_GRID
                                                        || plan == QN_PLAN_ONE_AT_A_TIME);
  }
  gtk_box_append (GTK_BOX (box), values);
  for (GtkWidget *part = gtk_widget_get_first_child (values); part != NULL;
       part = gtk_widget_get_next_sibling (part))
    if (GTK_IS_ENTRY (part))
      gtk_editable_set_width_chars (GTK_EDITABLE (part), 5);
  gtk_widget_set_margin_top (box, 6);
  gtk_widget_set_margin_bottom (box, 6);
  gtk_widget_set_margin_start (box, 6);
  gtk_widget_set_margin_end (box, 6);
  GtkWidget *line = gtk_list_box_row_new ();
  gtk_list_box_row_set_activatable (GTK_LIST_BOX_ROW (line), FALSE);
  gtk_widget_set_focusable (line, FALSE);
  gtk_list_box_row_set_child (GTK_LIST_BOX_ROW (line), box);
  g_object_set_data_full (G_OBJECT (line), "qn-row", g_steal_pointer (&row), g_free);
  gtk_list_box_append (self->parameters, line);
}

static void
on_output (GtkCheckButton *check, StudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_output (
    self->draft,
    (QnStudyOutput) GPOINTER_TO_INT (g_object_get_data (G_OBJECT (check), "qn-output")),
    gtk_check_button_get_active (check));
  show_draft (self);
}

static void
show_outputs (StudyWindow *self)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (self->outputs)) != NULL)
    gtk_box_remove (GTK_BOX (self->outputs), child);
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++) {
    QnStudyOutput output = (QnStudyOutput) i;
    if (!qn_study_run_gives (qn_draft_get_run (self->draft), output))
      continue;
    GtkWidget *check = gtk_check_button_new_with_label (qn_study_output_names[i]);
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                                 qn_draft_has_output (self->draft, output));
    g_object_set_data (G_OBJECT (check), "qn-output", GINT_TO_POINTER (i));
    g_signal_connect (check, "toggled", G_CALLBACK (on_output), self);
    gtk_box_append (GTK_BOX (self->outputs), check);
  }
}

/* Rows are made anew outside of the signals of their own widgets. */
static gboolean
show_now (gpointer data)
{
  StudyWindow *self = data;
  GtkListBoxRow *row;
  int count;
  self->showing = TRUE;
  while ((row = gtk_list_box_get_row_at_index (self->parameters, 0)) != NULL)
    gtk_list_box_remove (self->parameters, GTK_WIDGET (row));
  for (guint i = 0; i < qn_draft_count (self->draft); i++)
    add_row (self, i);
  gtk_widget_set_visible (GTK_WIDGET (self->parameters),
                          qn_draft_count (self->draft) > 0);
  QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
  gtk_drop_down_set_selected (self->plan, plan);
  gtk_drop_down_set_selected (self->analysis, qn_draft_get_run (self->draft));
  gtk_widget_set_sensitive (GTK_WIDGET (self->count),
                            plan != QN_PLAN_GRID && plan != QN_PLAN_ONE_AT_A_TIME);
  gtk_spin_button_set_value (self->count, count);
  show_outputs (self);
  self->showing = FALSE;
  update_actions (self);
  return G_SOURCE_REMOVE;
}

static void
show_draft (StudyWindow *self)
{
  g_idle_add_full (G_PRIORITY_HIGH_IDLE, show_now, self, NULL);
}

static void
on_plan (StudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_plan (self->draft, (QnPlanKind) gtk_drop_down_get_selected (self->plan),
                     gtk_spin_button_get_value_as_int (self->count));
  show_draft (self);
}

static void
on_analysis (StudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_run (self->draft,
                    (QnStudyRun) gtk_drop_down_get_selected (self->analysis));
  show_draft (self);
}

static void
on_figure (StudyWindow *self)
{
  guint row = gtk_drop_down_get_selected (self->figure);
  gboolean surface = row == 5, by = row == 1 || row == 4 || surface;
  gtk_widget_set_visible (GTK_WIDGET (self->by), by);
  gtk_widget_set_visible (self->over, by);
  gtk_widget_set_visible (GTK_WIDGET (self->by_second), surface);
  gtk_widget_set_visible (self->and, surface);
  gtk_widget_queue_draw (self->plot);
}

/* ---- the window ---- */

/* The parent is still there: it goes after the windows over it. */
static void
on_destroy (StudyWindow *self)
{
  g_object_set_data (G_OBJECT (self->parent.window), "qn-study-window", NULL);
  g_clear_handle_id (&self->timeout, g_source_remove);
  while (g_idle_remove_by_data (self))
    ;
  g_clear_pointer (&self->job, qn_study_job_free);
  if (qn_draft_count (self->draft) > 0 || qn_draft_can_undo (self->draft))
    qn_draft_save (self->draft, NULL);
}

static void
free_window (gpointer data)
{
  StudyWindow *self = data;
  forget_results (self);
  g_object_unref (self->parent.document);
  g_object_unref (self->parent.state);
  qn_draft_free (self->draft);
  g_clear_object (&self->chooser);
  g_clear_object (&self->actions);
  g_free (self->running);
  g_free (self);
}

static void
connect (StudyWindow *self)
{
  static const GActionEntry entries[] = {
    { .name = "run", .activate = run },
    { .name = "cancel", .activate = cancel },
    { .name = "undo", .activate = undo },
    { .name = "redo", .activate = redo },
    { .name = "export", .activate = export_results, .parameter_type = "s" },
    { .name = "export-path", .activate = export_path, .parameter_type = "(ss)" },
    { .name = "move-load", .activate = move_load },
  };
  static const struct {
    const char *keys, *action;
  } keys[] = { { "F5", "study.run" },
               { "<Shift>F5", "study.cancel" },
               { "<Control>z", "study.undo" },
               { "<Control><Shift>z", "study.redo" } };
  self->actions = g_simple_action_group_new ();
  g_action_map_add_action_entries (G_ACTION_MAP (self->actions), entries,
                                   G_N_ELEMENTS (entries), self);
  gtk_widget_insert_action_group (GTK_WIDGET (self->window), "study",
                                  G_ACTION_GROUP (self->actions));
  GtkEventController *shortcuts = gtk_shortcut_controller_new ();
  for (gsize i = 0; i < G_N_ELEMENTS (keys); i++)
    gtk_shortcut_controller_add_shortcut (
      GTK_SHORTCUT_CONTROLLER (shortcuts),
      gtk_shortcut_new (gtk_shortcut_trigger_parse_string (keys[i].keys),
                        gtk_named_action_new (keys[i].action)));
  gtk_widget_add_controller (GTK_WIDGET (self->window), shortcuts);

  g_signal_connect_swapped (self->plan, "notify::selected", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->count, "value-changed", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->analysis, "notify::selected", G_CALLBACK (on_analysis),
                            self);
  GtkDropDown *const shown[] = { self->figure, self->of, self->by, self->by_second };
  for (gsize i = 0; i < G_N_ELEMENTS (shown); i++)
    g_signal_connect_swapped (shown[i], "notify::selected", G_CALLBACK (on_figure), self);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (self->plot), draw_plot, self, NULL);
  GtkGesture *click = gtk_gesture_click_new ();
  g_signal_connect (click, "released", G_CALLBACK (on_click), self);
  gtk_widget_add_controller (self->plot, GTK_EVENT_CONTROLLER (click));
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (self->plot, key);
}

static StudyWindow *
new_window (const QnStudyParent *parent, QnDraft *draft)
{
  StudyWindow *self = g_new0 (StudyWindow, 1);
  g_autoptr (GtkBuilder) builder =
    gtk_builder_new_from_resource ("/io/github/quoin/Quoin/study-window.ui");
#define GET(type, name) type (gtk_builder_get_object (builder, name))
  *self = (StudyWindow){
    .parent = *parent,
    .draft = draft,
    .chosen = -1,
    .window = GTK_WINDOW (qn_dialog_new (parent->window, _ ("Study"), 1040, 720)),
    .parameters = GET (GTK_LIST_BOX, "parameters"),
    .analysis = GET (GTK_DROP_DOWN, "analysis"),
    .plan = GET (GTK_DROP_DOWN, "plan"),
    .figure = GET (GTK_DROP_DOWN, "figure"),
    .of = GET (GTK_DROP_DOWN, "of"),
    .by = GET (GTK_DROP_DOWN, "by"),
    .by_second = GET (GTK_DROP_DOWN, "by_second"),
    .count = GET (GTK_SPIN_BUTTON, "count"),
    .outputs = GET (GTK_WIDGET, "outputs"),
    .plot = GET (GTK_WIDGET, "plot"),
    .over = GET (GTK_WIDGET, "over"),
    .and = GET (GTK_WIDGET, "and"),
    .progress = GET (GTK_PROGRESS_BAR, "progress"),
    .status = GET (GTK_LABEL, "status"),
  };
  gtk_window_set_modal (self->window, FALSE);
  qn_help_set_page (GTK_WIDGET (self->window), "uncertainty");
  gtk_window_set_titlebar (self->window, GET (GTK_WIDGET, "header"));
  gtk_window_set_child (self->window, GET (GTK_WIDGET, "content"));
#undef GET
  g_autofree char *name = g_path_get_basename (qn_draft_get_path (draft));
  g_autofree char *title = g_strdup_printf (_ ("Study: %s"), name);
  gtk_window_set_title (self->window, title);
  g_object_ref (parent->document);
  g_object_ref (parent->state);
  g_signal_connect_swapped (self->window, "destroy", G_CALLBACK (on_destroy), self);
  connect (self);
  on_figure (self);
  g_object_set_data_full (G_OBJECT (self->window), "qn-study", self, free_window);
  return self;
}

char *
qn_study_path_of_project (const char *project)
{
  g_autofree char *stem = g_str_has_suffix (project, ".quoin")
                            ? g_strndup (project, strlen (project) - strlen (".quoin"))
                            : g_strdup (project);
  return g_strconcat (stem, ".quoin-study", NULL);
}

GtkWindow *
qn_study_window_show (const QnStudyParent *parent, const char *path, GError **error)
{
  GtkWindow *present = g_object_get_data (G_OBJECT (parent->window), "qn-study-window");
  const char *project = qn_document_get_path (parent->document);
  if (project == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("Save the project first: its study is kept beside it."));
    return NULL;
  }
  g_autofree char *own =
    path != NULL ? g_strdup (path) : qn_study_path_of_project (project);
  if (present != NULL) {
    StudyWindow *shown = g_object_get_data (G_OBJECT (present), "qn-study");
    if (path == NULL || g_str_equal (qn_draft_get_path (shown->draft), own)) {
      gtk_window_present (present);
      return present;
    }
    gtk_window_destroy (present);
  }
  g_autofree char *model = g_path_get_basename (project);
  QnDraft *draft = g_file_test (own, G_FILE_TEST_EXISTS) ? qn_draft_load (own, error)
                                                         : qn_draft_new (own, model);
  if (draft == NULL)
    return NULL;
  StudyWindow *self = new_window (parent, draft);
  g_object_set_data (G_OBJECT (parent->window), "qn-study-window", self->window);
  show_now (self);
  read_results (self);
  update_actions (self);
  gtk_window_present (self->window);
  return self->window;
}

/* Whether the project reads with a fraction there: counts and seeds do not. */
static gboolean
takes_fractions (QnDocument *document, const char *path, double base)
{
  const char *text = qn_document_get_text (document);
  char number[QN_NUMBER_TEXT_SIZE];
  g_autofree char *override =
    g_strconcat (path, "=", qn_number_text (floor (base) + 0.5, number), NULL);
  const char *const overrides[] = { override, NULL };
  QnProject probe;
  if (base != rint (base))
    return TRUE;
  if (!qn_project_parse (text, strlen (text), "", overrides, &probe, NULL))
    return FALSE;
  qn_project_clear (&probe);
  return TRUE;
}

void
qn_study_window_vary (GtkWindow *window, const char *path, double base)
{
  StudyWindow *self = g_object_get_data (G_OBJECT (window), "qn-study");
  g_autofree char *text = NULL;
  if (qn_draft_vary (self->draft, path, base,
                     !takes_fractions (self->parent.document, path, base)))
    text = g_strdup_printf (_ ("%s varies now."), path);
  else
    text = g_strdup_printf (_ ("%s varies already."), path);
  tell (self, text);
  show_now (self);
}

void
qn_study_window_move_load (GtkWindow *window, const char *path, const GArray *line)
{
  StudyWindow *self = g_object_get_data (G_OBJECT (window), "qn-study");
  qn_draft_move_load (self->draft, path, (const QnVec2 *) (void *) line->data, line->len,
                      STEPS_OF_LOAD);
  gtk_drop_down_set_selected (self->figure, 4);
  show_now (self);
  gtk_window_present (window);
}
