#include "app/pages/study-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/help.h"
#include "app/widgets/plot-view.h"
#include "doc/text/explain.h"
#include "io/text/io-error.h"
#include "study/report/table.h"
#include <glib/gi18n.h>
#include <math.h>

/* Beyond so many blocks a new study has the bound of limit analysis: the path takes too long. */
#define SLOW_BLOCKS 1000

/* px: a click this near to a point means it. */
#define NEAR 12.0

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (PARAMETERS, "varied", NULL)                                                     \
  FIELD (ANALYSIS, "analysis", NULL)                                                     \
  FIELD (PLAN, "plan", NULL)                                                             \
  FIELD (CASES, "cases", NULL)                                                           \
  FIELD (COUNT, "count", NULL)                                                           \
  FIELD (OUTPUTS, "outputs", NULL)                                                       \
  MEMBER (FIGURE, "figure", NULL, QnStudyPage, figure)                                   \
  MEMBER (OF, "of", NULL, QnStudyPage, of)                                               \
  FIELD (OVER, "over", NULL)                                                             \
  MEMBER (BY, "by", NULL, QnStudyPage, by)                                               \
  FIELD (AND, "and", NULL)                                                               \
  MEMBER (BY_SECOND, "by_second", NULL, QnStudyPage, by_second)                          \
  FIELD (FAILED, "failed", NULL)                                                         \
  FIELD (PLOT, "plot", NULL)                                                             \
  FIELD (STATISTICS, "statistics", NULL)                                                 \
  FIELD (PROGRESS, "progress", NULL)                                                     \
  FIELD (STATUS, "status", NULL)
QN_FORM_FIELDS;

void
qn_study_page_tell (gpointer self, const char *text)
{
  gtk_label_set_text (((QnStudyPage *) self)->status, text);
}

static void
update_actions (QnStudyPage *self)
{
  int count;
  gboolean varied = qn_draft_count (self->draft) > 0
                    || qn_draft_get_plan (self->draft, &count) == QN_PLAN_COMBINATIONS;
  const gboolean idle = self->job == NULL;
  GtkWidget *page = self->base.root;
  qn_actions_enable (page, "run", idle && varied);
  qn_actions_enable (page, "cancel", !idle);
  qn_actions_enable (page, "undo", idle && qn_draft_can_undo (self->draft));
  qn_actions_enable (page, "redo", idle && qn_draft_can_redo (self->draft));
  qn_actions_enable (page, "save-as", idle);
  qn_actions_enable (page, "export", self->folder != NULL);
}

void
qn_study_page_show (QnStudyPage *self)
{
  qn_form_show (self);
  update_actions (self);
}

/* ---- the figure ---- */

/* The column of the chosen output, or -1. */
static int
column_of_output (const QnStudyPage *self)
{
  int row = self->of;
  for (guint i = 0; i < self->study.outputs->len; i++) {
    const QnStudyOutput output = qn_study_output (&self->study, i);
    if (!qn_study_output_is_number (output) || row-- > 0)
      continue;
    for (gsize k = 0; k < self->table.width; k++)
      if (strcmp (qn_table_column_text (&self->table, k), qn_study_output_text (output))
          == 0)
        return (int) k;
    break;
  }
  return -1;
}

/* The first columns are those of the parameters. */
gboolean
qn_study_page_chosen_figure (QnStudyPage *self, QnStudyFigure *figure)
{
  if (self->folder == NULL)
    return FALSE;
  *figure = (QnStudyFigure){ .kind = (QnStudyFigureKind) self->figure,
                             .column = column_of_output (self),
                             .parameters = { self->by, self->by_second } };
  return figure->column >= 0
         && (gsize) MAX (self->by, self->by_second) < self->table.parameters;
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  QnStudyPage *self = data;
  QnStudyFigure figure;
  self->points = FALSE;
  if (!qn_study_page_chosen_figure (self, &figure)) {
    *message =
      g_strdup (_ ("Choose what varies, then run the study: its cases appear here."));
    return NULL;
  }
  QnPlot *plot = qn_study_figure_plot (&figure, &self->table, NULL);
  if (plot == NULL) {
    *message = g_strdup (_ ("No case has this output yet."));
    return NULL;
  }
  self->points =
    figure.kind == QN_STUDY_FIGURE_SCATTER || figure.kind == QN_STUDY_FIGURE_ENVELOPE;
  if (!self->points || self->chosen < 0
      || (guint64) self->chosen >= self->table.rows->len)
    return plot;
  double *place = qn_plot_keep (plot, g_new (double, 2));
  place[0] =
    qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.parameters[0]);
  place[1] = qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.column);
  qn_plot_points (plot, NULL, 1, place, place + 1, 1, QN_MARKER_RING, 10.0);
  return plot;
}

static void
choose (QnStudyPage *self, gint64 row)
{
  QnStudyFigure figure;
  if (!qn_study_page_chosen_figure (self, &figure) || row < 0
      || row >= (gint64) self->table.rows->len)
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
      text, " · %s %.4g%s%s", qn_table_column_text (&self->table, (gsize) figure.column),
      qn_table_number (&self->table, (gsize) row, (gsize) figure.column),
      found->mechanism != NULL ? " · " : "",
      found->mechanism != NULL ? qn_study_word (found->mechanism) : "");
  qn_study_page_tell (self, text->str);
  gtk_widget_queue_draw (self->base.widgets[PLOT]);
}

/* The case whose point is nearest to a place of the plot, or -1 where none is near. */
static gint64
find_point (QnStudyPage *self, double x, double y)
{
  QnStudyFigure figure;
  const QnPlotPlace *place = qn_plot_view_get_place (self->base.widgets[PLOT]);
  double best = NEAR;
  gint64 nearest = -1;
  if (!self->points || !qn_study_page_chosen_figure (self, &figure))
    return -1;
  for (guint i = 0; i < self->table.rows->len; i++) {
    double px =
      place->x_zero
      + place->x_scale * qn_table_number (&self->table, i, (gsize) figure.parameters[0]);
    double py =
      place->y_zero
      + place->y_scale * qn_table_number (&self->table, i, (gsize) figure.column);
    double distance = hypot (px - x, py - y);
    if (distance < best) { /* false for NaN */
      best = distance;
      nearest = i;
    }
  }
  return nearest;
}

static void
on_click (GtkGestureClick *gesture, int count, double x, double y, QnStudyPage *self)
{
  gtk_widget_grab_focus (self->base.widgets[PLOT]);
  gint64 nearest = find_point (self, x, y);
  if (nearest < 0)
    return;
  choose (self, nearest);
  qn_study_page_open_case (self);
}

/* The case under the pointer, or the one that the keys have chosen; and what can be written. */
static GMenuModel *
make_menu (GtkWidget *plot, QnMenuPlace *place, gpointer data)
{
  QnStudyPage *self = data;
  GMenu *menu = g_menu_new (), *one = g_menu_new (), *all = g_menu_new ();
  gtk_widget_grab_focus (plot);
  gint64 nearest = place->by_key ? self->chosen : find_point (self, place->x, place->y);
  if (!place->by_key && nearest >= 0)
    choose (self, nearest);
  if (nearest >= 0) {
    g_menu_append (one, _ ("_Open Case in the Drawing"), "study.open-case");
    g_menu_append (one, _ ("_Copy Text"), "study.copy-case");
  }
  g_menu_append (all, _ ("_Table…"), "study.export::table");
  g_menu_append (all, _ ("_Figure…"), "study.export::figure");
  g_menu_append (all, _ ("_Mechanisms…"), "study.export::mechanisms");
  qn_menu_add_section (menu, one);
  qn_menu_add_section (menu, all);
  return G_MENU_MODEL (menu);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnStudyPage *self)
{
  switch (keyval) {
  case GDK_KEY_Right:
    choose (self, self->chosen + 1);
    return TRUE;
  case GDK_KEY_Left:
    choose (self, self->chosen - 1);
    return TRUE;
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
    gtk_widget_activate_action (self->base.root, "study.open-case", NULL);
    return TRUE;
  default:
    return FALSE;
  }
}

/* ---- fields ---- */

static gboolean
gives (const QnStudyPage *self, int output)
{
  return qn_study_run_gives (qn_draft_get_run (self->draft),
                             &self->document->project.model.analysis,
                             (QnStudyOutput) output);
}

static void
show_outputs (const QnStudyPage *self, QnValue *value)
{
  guint32 bits = 0;
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++)
    if (gives (self, i)) {
      if (qn_draft_has_output (self->draft, (QnStudyOutput) i))
        bits |= 1u << value->row_count;
      qn_value_add_row (value, qn_study_output_text ((QnStudyOutput) i));
    }
  value->number = bits;
}

static void
take_outputs (QnStudyPage *self, guint32 bits)
{
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++)
    if (gives (self, i)) {
      const gboolean wanted = bits & 1;
      if (qn_draft_has_output (self->draft, (QnStudyOutput) i) != wanted)
        qn_draft_set_output (self->draft, (QnStudyOutput) i, wanted);
      bits >>= 1;
    }
}

/* What can be drawn, or over which parameter. */
static void
show_names (const QnStudyPage *self, QnValue *value, gboolean outputs)
{
  const QnStudy *study = &self->study;
  if (self->folder == NULL)
    return;
  for (guint i = 0; !outputs && i < study->parameters->len; i++)
    qn_value_add_row (value, qn_study_parameter (study, i)->name);
  for (guint i = 0; outputs && i < study->outputs->len; i++)
    if (qn_study_output_is_number (qn_study_output (study, i)))
      qn_value_add_row (value, qn_study_output_text (qn_study_output (study, i)));
}

/* What the figures leave out is said above them; NULL: nothing. */
static char *
dup_failed (const QnStudyPage *self)
{
  guint failed = 0, count = self->folder != NULL ? self->table.rows->len : 0;
  const char *reason = NULL;
  for (guint i = 0; i < count; i++) {
    const QnRow *row = &g_array_index (self->table.rows, QnRow, i);
    failed += row->failed ? 1 : 0;
    reason = row->failed && reason == NULL ? row->reason : reason;
  }
  if (failed == 0)
    return NULL;
  g_autofree char *why = g_strdup (reason != NULL ? reason : "");
  for (guint i = 0; i < self->study.parameters->len; i++) {
    if (qn_study_parameter (&self->study, i)->paths[0] == NULL)
      continue;
    char *shorter =
      qn_path_dup_reason (why, qn_study_parameter (&self->study, i)->paths[0]);
    g_free (why);
    why = shorter;
  }
  return g_strdup_printf (
    _ ("%u of %u cases have no answer; the figures are of the others. First reason: %s"),
    failed, count, why);
}

/* Moments and fractiles of the output that is shown. */
static char *
dup_statistics (QnStudyPage *self)
{
  QnStudyFigure figure;
  gsize count = 0;
  g_autofree double *sorted = NULL;
  if (qn_study_page_chosen_figure (self, &figure))
    sorted = qn_table_dup_sorted (&self->table, (gsize) figure.column, &count);
  if (count < 2)
    return NULL;
  QnMoments moments = qn_moments (sorted, count);
  return g_strdup_printf (
    _ ("%u cases: mean %.4g, deviation %.3g; 5 %% lie below %.4g, "
       "half below %.4g, 95 %% below %.4g"),
    (guint) count, moments.mean, moments.deviation, qn_quantile (sorted, count, 0.05),
    qn_quantile (sorted, count, 0.5), qn_quantile (sorted, count, 0.95));
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  QnStudyPage *self = (QnStudyPage *) data;
  GtkWidget *widget = self->base.widgets[field];
  const gboolean surface = self->figure == QN_STUDY_FIGURE_SURFACE;
  int count;
  const QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
  switch (field) {
  case PARAMETERS:
    qn_study_page_show_parameters (self,
                                   GTK_LIST_BOX (gtk_widget_get_first_child (widget)));
    return self->rows->len > 0;
  case ANALYSIS:
    value->number = qn_draft_get_run (self->draft);
    return TRUE;
  case PLAN:
    value->number = plan;
    return TRUE;
  case CASES:
  case COUNT:
    value->number = count;
    return !qn_plan_is_by_levels (plan);
  case OUTPUTS:
    show_outputs (self, value);
    return TRUE;
  case OF:
  case BY:
  case BY_SECOND:
    show_names (self, value, field == OF);
    break;
  case FAILED:
    value->text = dup_failed (self);
    return value->text != NULL;
  case PLOT:
    gtk_widget_queue_draw (widget);
    return TRUE;
  case STATISTICS:
    value->text = dup_statistics (self);
    return value->text != NULL;
  case PROGRESS:
    gtk_progress_bar_set_fraction (GTK_PROGRESS_BAR (widget), self->share);
    return self->job != NULL;
  default:
    break;
  }
  return field == STATUS || field <= OF
         || (field <= BY
             && (surface || self->figure == QN_STUDY_FIGURE_SCATTER
                 || self->figure == QN_STUDY_FIGURE_ENVELOPE))
         || surface;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnStudyPage *self = (QnStudyPage *) data;
  const QnAnalysisSettings *analysis = &self->document->project.model.analysis;
  const int number = qn_value_int (value);
  int count;
  const QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
  if (field == OUTPUTS)
    take_outputs (self, (guint32) value->number);
  else if (field == PLAN)
    qn_draft_set_plan (self->draft, (QnPlanKind) number, count);
  else if (field == COUNT)
    qn_draft_set_plan (self->draft, plan, number);
  else if (field == ANALYSIS)
    qn_draft_set_run (self->draft, qn_study_run_of ((QnStudyRun) number, analysis));
  else
    qn_plot_view_fit (self->base.widgets[PLOT]);
  update_actions (self);
  return TRUE;
}

/* ---- actions ---- */

static void
cancel (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  qn_study_job_cancel (self->job);
}

static void
undo_or_redo (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  const gboolean undo = g_str_equal (g_action_get_name (G_ACTION (action)), "undo");
  (undo ? qn_draft_undo : qn_draft_redo) (self->draft);
  qn_study_page_show (self);
}

static gboolean
write_study (gpointer data, const char *path, GError **error)
{
  QnStudyPage *self = data;
  const char *project = self->document->path;
  g_autofree char *name = g_path_get_basename (project);
  g_autofree char *from = g_path_get_dirname (project), *to = g_path_get_dirname (path);
  const gboolean written =
    qn_draft_save_as (self->draft, path, g_str_equal (from, to) ? name : project, error);
  qn_study_page_read_results (self);
  qn_study_page_show (self);
  return written;
}

/* Its results are kept beside it. */
static void
save_as (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  static const char *const endings[] = { ".quoin-study", NULL };
  QnStudyPage *self = data;
  const QnFileQuestion question = { .title = _ ("Save Study As"),
                                    .accept = _ ("_Save"),
                                    .name = "study.quoin-study",
                                    .endings = endings,
                                    .use = write_study,
                                    .told = qn_study_page_tell,
                                    .path = qn_draft_get_path (self->draft) };
  qn_chooser_ask (self->base.root, &question, self);
}

static void
open_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  qn_study_page_open_case (self);
  gtk_widget_activate_action (self->base.root, "win.show-drawing", NULL);
}

/* The case that is chosen is told in the line under the figure. */
static void
copy_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  gdk_clipboard_set_text (gtk_widget_get_clipboard (self->base.root),
                          gtk_label_get_text (self->status));
}

static void
remove_parameter (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  qn_draft_remove (self->draft, g_variant_get_uint32 (parameter));
  qn_study_page_show (self);
}

/* ---- the page ---- */

static void
on_destroy (QnStudyPage *self)
{
  g_clear_handle_id (&self->timeout, g_source_remove);
  g_clear_pointer (&self->job, qn_study_job_free);
  if (qn_draft_count (self->draft) > 0 || qn_draft_can_undo (self->draft))
    qn_draft_save (self->draft, NULL);
}

static void
clear (QnForm *data)
{
  QnStudyPage *self = (QnStudyPage *) data;
  qn_study_page_forget_results (self);
  g_object_unref (self->document);
  g_object_unref (self->state);
  qn_draft_free (self->draft);
  g_ptr_array_unref (self->rows);
  g_free (self->running);
}

static void
connect (QnStudyPage *self)
{
  static const QnPlotHand hand = { .make = make_plot };
  static const GActionEntry entries[] = {
    { .name = "run", .activate = qn_study_page_run },
    { .name = "cancel", .activate = cancel },
    { .name = "undo", .activate = undo_or_redo },
    { .name = "redo", .activate = undo_or_redo },
    { .name = "save-as", .activate = save_as },
    { .name = "export", .activate = qn_study_page_export, .parameter_type = "s" },
    { .name = "export-path", .activate = qn_study_page_export, .parameter_type = "(ss)" },
    { .name = "open-case", .activate = open_case },
    { .name = "copy-case", .activate = copy_case },
    { .name = "remove", .activate = remove_parameter, .parameter_type = "u" },
  };
  GtkWidget *page = self->base.root, *plot = self->base.widgets[PLOT];
  qn_actions_insert (page, "study", entries, G_N_ELEMENTS (entries), self);
  g_signal_connect_swapped (page, "destroy", G_CALLBACK (on_destroy), self);
  qn_plot_view_init (plot, &hand, self);
  GtkGesture *click = gtk_gesture_click_new ();
  g_signal_connect (click, "released", G_CALLBACK (on_click), self);
  gtk_widget_add_controller (plot, GTK_EVENT_CONTROLLER (click));
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (plot, key);
  qn_context_menu_attach (plot, make_menu, self);
}

static QnDraft *
take_draft (QnDocument *document, const char *path, GError **error)
{
  const char *project = document->path;
  if (project == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("Save the project first: its study is kept beside it."));
    return NULL;
  }
  const gboolean ends = g_str_has_suffix (project, ".quoin");
  g_autofree char *stem =
    g_strndup (project, strlen (project) - (ends ? strlen (".quoin") : 0));
  g_autofree char *own =
    path != NULL ? g_strdup (path) : g_strconcat (stem, ".quoin-study", NULL);
  g_autofree char *model = g_path_get_basename (project);
  const QnModel *structure = &document->project.model;
  QnStudyRun run = qn_study_run_of (QN_STUDY_SOLVE, &structure->analysis);
  if (run == QN_STUDY_SOLVE && structure->block_count > SLOW_BLOCKS)
    run = QN_STUDY_LIMIT;
  return g_file_test (own, G_FILE_TEST_EXISTS) ? qn_draft_load (own, error)
                                               : qn_draft_new (own, model, run);
}

GtkWidget *
qn_study_page_new (QnViewState *state, const char *path, GError **error)
{
  static const QnFormKind kind = QN_FORM_KIND ("study-page", QnStudyPage, .clear = clear);
  QnDraft *draft = take_draft (state->document, path, error);
  if (draft == NULL)
    return NULL;
  QnStudyPage *self = qn_form_new (&kind, NULL);
  self->document = g_object_ref (state->document);
  self->state = g_object_ref (state);
  self->draft = draft;
  self->rows = g_ptr_array_new ();
  self->chosen = -1;
  self->status = GTK_LABEL (self->base.widgets[STATUS]);
  qn_help_set_page (self->base.root, "uncertainty");
  connect (self);
  qn_study_page_read_results (self);
  qn_study_page_show (self);
  return self->base.root;
}

void
qn_study_page_vary (GtkWidget *page, const char *path, double base)
{
  QnStudyPage *self = g_object_get_data (G_OBJECT (page), QN_FORM);
  g_autofree char *words = qn_path_dup_text (&self->document->project.model, path);
  /* Counts and seeds are whole: a fraction cannot stand there. */
  const gboolean whole =
    base == rint (base)
    && !qn_study_page_takes_value (self, path, floor (base) + 0.5, NULL);
  gboolean added = qn_draft_vary (self->draft, path, base, whole);
  g_autofree char *text =
    g_strdup_printf (added ? _ ("%s varies now.") : _ ("%s varies already."), words);
  qn_study_page_tell (self, text);
  qn_study_page_show (self);
}

const char *
qn_study_page_get_path (GtkWidget *page)
{
  QnStudyPage *self = g_object_get_data (G_OBJECT (page), QN_FORM);
  return qn_draft_get_path (self->draft);
}
