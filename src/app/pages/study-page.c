#include "app/pages/study-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/chooser.h"
#include "app/widgets/help.h"
#include "doc/text/explain.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>
#include <math.h>

/* Beyond so many blocks a new study has the bound of limit analysis: the path takes too long. */
#define SLOW_BLOCKS 1000

void
qn_study_page_tell (QnStudyPage *self, const char *text)
{
  gtk_label_set_text (self->status, text);
}

void
qn_study_page_update_actions (QnStudyPage *self)
{
  int count;
  gboolean varied = qn_draft_count (self->draft) > 0
                    || qn_draft_get_plan (self->draft, &count) == QN_PLAN_COMBINATIONS;
  const gboolean idle = self->job == NULL;
  qn_actions_enable (self->actions, "run", idle && varied);
  qn_actions_enable (self->actions, "cancel", !idle);
  qn_actions_enable (self->actions, "undo", idle && qn_draft_can_undo (self->draft));
  qn_actions_enable (self->actions, "redo", idle && qn_draft_can_redo (self->draft));
  qn_actions_enable (self->actions, "save-as", idle);
  qn_actions_enable (self->actions, "export", self->folder != NULL);
}

/* ---- plan ---- */

static void
on_output (GtkCheckButton *check, QnStudyPage *self)
{
  if (self->showing)
    return;
  qn_draft_set_output (
    self->draft,
    (QnStudyOutput) GPOINTER_TO_INT (g_object_get_data (G_OBJECT (check), "qn-output")),
    gtk_check_button_get_active (check));
  qn_study_page_show_draft (self);
}

static void
on_plan (QnStudyPage *self)
{
  if (self->showing)
    return;
  qn_draft_set_plan (self->draft, (QnPlanKind) gtk_drop_down_get_selected (self->plan),
                     gtk_spin_button_get_value_as_int (self->count));
  qn_study_page_show_draft (self);
}

static void
on_analysis (QnStudyPage *self)
{
  QnStudyRun run = (QnStudyRun) gtk_drop_down_get_selected (self->analysis);
  if (self->showing)
    return;
  qn_draft_set_run (
    self->draft,
    qn_study_run_of (run, &qn_document_get_model (self->document)->analysis));
  qn_study_page_show_draft (self);
}

static void
show_plan (QnStudyPage *self)
{
  int count;
  const QnModel *model = qn_document_get_model (self->document);
  QnPlanKind plan = qn_draft_get_plan (self->draft, &count);
  gtk_drop_down_set_selected (self->plan, plan);
  gtk_drop_down_set_selected (self->analysis, qn_draft_get_run (self->draft));
  gboolean by_levels = qn_plan_is_by_levels (plan);
  gtk_widget_set_visible (self->cases, !by_levels);
  gtk_widget_set_visible (GTK_WIDGET (self->count), !by_levels);
  gtk_spin_button_set_value (self->count, count);
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (self->outputs)) != NULL)
    gtk_box_remove (GTK_BOX (self->outputs), child);
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++) {
    QnStudyOutput output = (QnStudyOutput) i;
    if (!qn_study_run_gives (qn_draft_get_run (self->draft), &model->analysis, output))
      continue;
    GtkWidget *check = gtk_check_button_new_with_label (qn_study_output_text (output));
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                                 qn_draft_has_output (self->draft, output));
    g_object_set_data (G_OBJECT (check), "qn-output", GINT_TO_POINTER (i));
    g_signal_connect (check, "toggled", G_CALLBACK (on_output), self);
    gtk_box_append (GTK_BOX (self->outputs), check);
  }
}

static gboolean
show_now (gpointer data)
{
  QnStudyPage *self = data;
  self->showing = TRUE;
  qn_study_page_show_parameters (self);
  show_plan (self);
  self->showing = FALSE;
  qn_study_page_update_actions (self);
  return G_SOURCE_REMOVE;
}

void
qn_study_page_show_draft (QnStudyPage *self)
{
  g_idle_add_full (G_PRIORITY_HIGH_IDLE, show_now, self, NULL);
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
  qn_study_page_show_draft (self);
}

static void
on_saved (gpointer data, const char *path, const GError *error)
{
  QnStudyPage *self = data;
  g_autoptr (GError) fault = NULL;
  g_autofree char *text = NULL;
  if (path != NULL) {
    const char *project = qn_document_get_path (self->document);
    g_autofree char *name = g_path_get_basename (project);
    g_autofree char *from = g_path_get_dirname (project), *to = g_path_get_dirname (path);
    if (qn_draft_save_as (self->draft, path, g_str_equal (from, to) ? name : project,
                          &fault))
      text = g_strdup_printf (_ ("Written to %s"), path);
    qn_study_page_read_results (self);
    qn_study_page_show_draft (self);
  }
  qn_study_page_tell (self, text != NULL    ? text
                            : fault != NULL ? fault->message
                                            : error->message);
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
                                    .chosen = on_saved,
                                    .path = qn_draft_get_path (self->draft) };
  qn_chooser_ask (self->page, &self->chooser, &question, self);
}

static void
open_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  qn_study_page_open_case (self);
  gtk_widget_activate_action (self->page, "win.show-drawing", NULL);
}

/* The case that is chosen is told in the line under the figure. */
static void
copy_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  gdk_clipboard_set_text (gtk_widget_get_clipboard (self->plot),
                          gtk_label_get_text (self->status));
}

static void
remove_parameter (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  qn_draft_remove (self->draft, g_variant_get_uint32 (parameter));
  qn_study_page_show_draft (self);
}

/* ---- the page ---- */

static void
on_destroy (QnStudyPage *self)
{
  g_clear_handle_id (&self->timeout, g_source_remove);
  while (g_idle_remove_by_data (self))
    ;
  g_clear_pointer (&self->job, qn_study_job_free);
  if (qn_draft_count (self->draft) > 0 || qn_draft_can_undo (self->draft))
    qn_draft_save (self->draft, NULL);
}

static void
free_page (gpointer data)
{
  QnStudyPage *self = data;
  qn_study_page_forget_results (self);
  g_object_unref (self->document);
  g_object_unref (self->state);
  qn_draft_free (self->draft);
  g_clear_object (&self->chooser);
  g_free (self->running);
  g_free (self);
}

static void
connect (QnStudyPage *self)
{
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
  self->actions =
    qn_actions_insert (self->page, "study", entries, G_N_ELEMENTS (entries), self);
  g_object_set_data_full (G_OBJECT (self->page), QN_PAGE_ACTIONS,
                          g_object_ref (self->actions), g_object_unref);
  g_signal_connect_swapped (self->plan, "notify::selected", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->count, "value-changed", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->analysis, "notify::selected", G_CALLBACK (on_analysis),
                            self);
  qn_study_page_connect_plot (self);
}

/* Path of the study of a project file. */
static char *
path_of_project (const char *project)
{
  g_autofree char *stem = g_str_has_suffix (project, ".quoin")
                            ? g_strndup (project, strlen (project) - strlen (".quoin"))
                            : g_strdup (project);
  return g_strconcat (stem, ".quoin-study", NULL);
}

static QnDraft *
take_draft (QnDocument *document, const char *path, GError **error)
{
  const char *project = qn_document_get_path (document);
  if (project == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("Save the project first: its study is kept beside it."));
    return NULL;
  }
  g_autofree char *own = path != NULL ? g_strdup (path) : path_of_project (project);
  g_autofree char *model = g_path_get_basename (project);
  const QnModel *structure = qn_document_get_model (document);
  QnStudyRun run = qn_study_run_of (QN_STUDY_SOLVE, &structure->analysis);
  if (run == QN_STUDY_SOLVE && structure->block_count > SLOW_BLOCKS)
    run = QN_STUDY_LIMIT;
  return g_file_test (own, G_FILE_TEST_EXISTS) ? qn_draft_load (own, error)
                                               : qn_draft_new (own, model, run);
}

GtkWidget *
qn_study_page_new (QnViewState *state, const char *path, GError **error)
{
  QnDocument *document = qn_view_state_get_document (state);
  QnDraft *draft = take_draft (document, path, error);
  if (draft == NULL)
    return NULL;
  QnStudyPage *self = g_new0 (QnStudyPage, 1);
  g_autoptr (GtkBuilder) builder = qn_builder_new ("study-page");
#define GET(type, name) type (gtk_builder_get_object (builder, name))
  *self = (QnStudyPage){
    .document = g_object_ref (document),
    .state = g_object_ref (state),
    .draft = draft,
    .chosen = -1,
    .page = qn_builder_take_widget (builder, "page"),
    .parameters = GET (GTK_LIST_BOX, "parameters"),
    .analysis = GET (GTK_DROP_DOWN, "analysis"),
    .plan = GET (GTK_DROP_DOWN, "plan"),
    .figure = GET (GTK_DROP_DOWN, "figure"),
    .of = GET (GTK_DROP_DOWN, "of"),
    .by = GET (GTK_DROP_DOWN, "by"),
    .by_second = GET (GTK_DROP_DOWN, "by_second"),
    .count = GET (GTK_SPIN_BUTTON, "count"),
    .cases = GET (GTK_WIDGET, "cases"),
    .outputs = GET (GTK_WIDGET, "outputs"),
    .plot = GET (GTK_WIDGET, "plot"),
    .over = GET (GTK_WIDGET, "over"),
    .and = GET (GTK_WIDGET, "and"),
    .progress = GET (GTK_PROGRESS_BAR, "progress"),
    .status = GET (GTK_LABEL, "status"),
    .statistics = GET (GTK_LABEL, "statistics"),
    .failed = GET (GTK_LABEL, "failed"),
  };
#undef GET
  qn_help_set_page (self->page, "uncertainty");
  g_object_set_data_full (G_OBJECT (self->page), "qn-study", self, free_page);
  g_signal_connect_swapped (self->page, "destroy", G_CALLBACK (on_destroy), self);
  connect (self);
  show_now (self);
  qn_study_page_read_results (self);
  qn_study_page_update_actions (self);
  return self->page;
}

/* Whether a fraction can stand there: counts and seeds are whole. */
static gboolean
takes_fractions (QnStudyPage *self, const char *path, double base)
{
  return base != rint (base)
         || qn_study_page_takes_value (self, path, floor (base) + 0.5, NULL);
}

void
qn_study_page_vary (GtkWidget *page, const char *path, double base)
{
  QnStudyPage *self = g_object_get_data (G_OBJECT (page), "qn-study");
  g_autofree char *words =
    qn_path_dup_text (qn_document_get_model (self->document), path);
  gboolean added =
    qn_draft_vary (self->draft, path, base, !takes_fractions (self, path, base));
  g_autofree char *text =
    g_strdup_printf (added ? _ ("%s varies now.") : _ ("%s varies already."), words);
  qn_study_page_tell (self, text);
  show_now (self);
}

const char *
qn_study_page_get_path (GtkWidget *page)
{
  QnStudyPage *self = g_object_get_data (G_OBJECT (page), "qn-study");
  return qn_draft_get_path (self->draft);
}
