#include "app/dialogs/study-private.h"

#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include "app/widgets/help.h"
#include "doc/text/path-text.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>
#include <math.h>

/* Places of a moving load along its way. */
#define STEPS_OF_LOAD 41

/* Beyond so many blocks a new study has the bound of limit analysis: the path takes too long. */
#define SLOW_BLOCKS 1000

void
qn_study_window_tell (QnStudyWindow *self, const char *text)
{
  gtk_label_set_text (self->status, text);
}

void
qn_study_window_update_actions (QnStudyWindow *self)
{
  int count;
  gboolean varied = qn_draft_count (self->draft) > 0
                    || qn_draft_get_plan (self->draft, &count) == QN_PLAN_COMBINATIONS;
  const struct {
    const char *name;
    gboolean enabled;
  } actions[] = { { "run", self->job == NULL && varied },
                  { "cancel", self->job != NULL },
                  { "undo", qn_draft_can_undo (self->draft) && self->job == NULL },
                  { "redo", qn_draft_can_redo (self->draft) && self->job == NULL },
                  { "export", self->folder != NULL } };
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
    g_simple_action_set_enabled (G_SIMPLE_ACTION (g_action_map_lookup_action (
                                   G_ACTION_MAP (self->actions), actions[i].name)),
                                 actions[i].enabled);
}

static gboolean
show_now (gpointer data)
{
  QnStudyWindow *self = data;
  self->showing = TRUE;
  qn_study_window_show_parameters (self);
  qn_study_window_show_plan (self);
  self->showing = FALSE;
  qn_study_window_update_actions (self);
  return G_SOURCE_REMOVE;
}

void
qn_study_window_show_draft (QnStudyWindow *self)
{
  g_idle_add_full (G_PRIORITY_HIGH_IDLE, show_now, self, NULL);
}

/* ---- actions ---- */

static void
run (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  qn_study_window_run (data);
}

static void
cancel (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  qn_study_job_cancel (self->job);
}

static void
undo (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  qn_draft_undo (self->draft);
  qn_study_window_show_draft (self);
}

static void
redo (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  qn_draft_redo (self->draft);
  qn_study_window_show_draft (self);
}

static void
export_results (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  qn_study_window_export (data, g_variant_get_string (parameter, NULL));
}

static void
open_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  qn_study_window_open_case (data);
}

/* The case that is chosen is told in the line under the figure. */
static void
copy_case (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  gdk_clipboard_set_text (gtk_widget_get_clipboard (self->plot),
                          gtk_label_get_text (self->status));
}

static void
remove_parameter (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  qn_draft_remove (self->draft, g_variant_get_uint32 (parameter));
  qn_study_window_show_draft (self);
}

/* The same without asking: (what, path). */
static void
export_path (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  const char *what, *path;
  g_variant_get (parameter, "(&s&s)", &what, &path);
  qn_study_window_export_to (data, what, path);
}

/* The main window draws; it comes back with qn_study_window_move_load(). */
static void
move_load (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyWindow *self = data;
  gtk_window_present (self->parent.window);
  gtk_widget_activate_action (GTK_WIDGET (self->parent.window), "win.tool", "s", "path");
}

/* ---- the window ---- */

/* The parent is still there: it goes after the windows over it. */
static void
on_destroy (QnStudyWindow *self)
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
  QnStudyWindow *self = data;
  qn_study_window_forget_results (self);
  g_object_unref (self->parent.document);
  g_object_unref (self->parent.state);
  qn_draft_free (self->draft);
  g_clear_object (&self->chooser);
  g_clear_object (&self->actions);
  g_free (self->running);
  g_free (self);
}

static void
connect (QnStudyWindow *self)
{
  static const GActionEntry entries[] = {
    { .name = "run", .activate = run },
    { .name = "cancel", .activate = cancel },
    { .name = "undo", .activate = undo },
    { .name = "redo", .activate = redo },
    { .name = "export", .activate = export_results, .parameter_type = "s" },
    { .name = "export-path", .activate = export_path, .parameter_type = "(ss)" },
    { .name = "move-load", .activate = move_load },
    { .name = "open-case", .activate = open_case },
    { .name = "copy-case", .activate = copy_case },
    { .name = "remove", .activate = remove_parameter, .parameter_type = "u" },
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
  qn_study_window_connect_plan (self);
  qn_study_window_connect_plot (self);
}

static QnStudyWindow *
new_window (const QnStudyParent *parent, QnDraft *draft)
{
  QnStudyWindow *self = g_new0 (QnStudyWindow, 1);
  g_autoptr (GtkBuilder) builder = qn_builder_new ("study-window");
#define GET(type, name) type (gtk_builder_get_object (builder, name))
  *self = (QnStudyWindow){
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
    .cases = GET (GTK_WIDGET, "cases"),
    .outputs = GET (GTK_WIDGET, "outputs"),
    .plot = GET (GTK_WIDGET, "plot"),
    .over = GET (GTK_WIDGET, "over"),
    .and = GET (GTK_WIDGET, "and"),
    .progress = GET (GTK_PROGRESS_BAR, "progress"),
    .status = GET (GTK_LABEL, "status"),
    .failed = GET (GTK_LABEL, "failed"),
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
  g_object_set_data_full (G_OBJECT (self->window), "qn-study", self, free_window);
  return self;
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
  g_autofree char *own = path != NULL ? g_strdup (path) : path_of_project (project);
  if (present != NULL) {
    QnStudyWindow *shown = g_object_get_data (G_OBJECT (present), "qn-study");
    if (path == NULL || g_str_equal (qn_draft_get_path (shown->draft), own)) {
      gtk_window_present (present);
      return present;
    }
    gtk_window_destroy (present);
  }
  g_autofree char *model = g_path_get_basename (project);
  const QnModel *structure = qn_document_get_model (parent->document);
  QnStudyRun run = structure->block_count > SLOW_BLOCKS ? QN_STUDY_LIMIT : QN_STUDY_SOLVE;
  QnDraft *draft = g_file_test (own, G_FILE_TEST_EXISTS) ? qn_draft_load (own, error)
                                                         : qn_draft_new (own, model, run);
  if (draft == NULL)
    return NULL;
  QnStudyWindow *self = new_window (parent, draft);
  g_object_set_data (G_OBJECT (parent->window), "qn-study-window", self->window);
  show_now (self);
  qn_study_window_read_results (self);
  qn_study_window_update_actions (self);
  gtk_window_present (self->window);
  return self->window;
}

/* Whether a fraction can stand there: counts and seeds are whole. */
static gboolean
takes_fractions (QnStudyWindow *self, const char *path, double base)
{
  return base != rint (base)
         || qn_study_window_takes_value (self, path, floor (base) + 0.5, NULL);
}

void
qn_study_window_vary (GtkWindow *window, const char *path, double base)
{
  QnStudyWindow *self = g_object_get_data (G_OBJECT (window), "qn-study");
  g_autofree char *words =
    qn_path_dup_text (qn_document_get_model (self->parent.document), path);
  gboolean added =
    qn_draft_vary (self->draft, path, base, !takes_fractions (self, path, base));
  g_autofree char *text =
    g_strdup_printf (added ? _ ("%s varies now.") : _ ("%s varies already."), words);
  qn_study_window_tell (self, text);
  show_now (self);
}

void
qn_study_window_move_load (GtkWindow *window, const char *path, const GArray *line)
{
  QnStudyWindow *self = g_object_get_data (G_OBJECT (window), "qn-study");
  qn_draft_move_load (self->draft, path, (const QnVec2 *) (void *) line->data, line->len,
                      STEPS_OF_LOAD);
  gtk_drop_down_set_selected (self->figure, QN_STUDY_ROW_ENVELOPE);
  show_now (self);
  gtk_window_present (window);
}
