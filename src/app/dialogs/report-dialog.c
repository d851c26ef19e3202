/* The report of the window: which sections, which paper, and quoin-cli that writes it meanwhile. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/build-tree.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "app/widgets/help.h"
#include "app/widgets/row.h"
#include "doc/document/run-file.h"
#include "doc/view/report.h"
#include <glib/gi18n.h>
#include <glib/gstdio.h>

#define PULSE_MS 100

static const char *const section_labels[QN_REPORT_SECTION_COUNT] = {
  [QN_REPORT_TITLE] = N_ ("Title page"),
  [QN_REPORT_MODEL] = N_ ("Model with dimensions"),
  [QN_REPORT_MATERIALS] = N_ ("Materials"),
  [QN_REPORT_LOADS] = N_ ("Loads"),
  [QN_REPORT_FINDINGS] = N_ ("Findings"),
  [QN_REPORT_CONTACTS] = N_ ("Contacts"),
  [QN_REPORT_RESULTS] = N_ ("Results"),
  [QN_REPORT_CERTIFICATE] = N_ ("Independent check"),
  [QN_REPORT_COMPARISON] = N_ ("Comparison"),
  [QN_REPORT_FILES] = N_ ("Files and versions"),
};

static const char *const papers[] = { "a4", "letter" };

typedef struct Report {
  GtkWindow *parent;
  QnDocument *document;
  QnTellFunc tell;
  GtkWidget *dialog, *write, *progress, *checks[QN_REPORT_SECTION_COUNT];
  GtkDropDown *paper;
  GObject *chooser;
  GSubprocess *process; /* while it writes */
  char *folder;         /* of the results handed over */
  GPtrArray *results;   /* paths there */
  char *path;
  guint pulse;
  gboolean closed;
} Report;

static void
remove_results (Report *report)
{
  for (guint i = 0; report->results != NULL && i < report->results->len; i++)
    g_unlink (report->results->pdata[i]);
  g_clear_pointer (&report->results, g_ptr_array_unref);
  if (report->folder != NULL)
    g_rmdir (report->folder);
  g_clear_pointer (&report->folder, g_free);
}

static void
report_free (Report *report)
{
  remove_results (report);
  g_clear_object (&report->chooser);
  g_free (report->path);
  g_free (report);
}

/* While the process runs the struct waits for its end. */
static void
on_closed (gpointer data, GObject *where)
{
  (void) where;
  Report *report = data;
  g_clear_handle_id (&report->pulse, g_source_remove);
  report->closed = TRUE;
  if (report->process != NULL)
    g_subprocess_force_exit (report->process);
  else
    report_free (report);
}

/* ---- writing ---- */

/* The current load paths and limit analyses, as files for the other process. */
static gboolean
write_results (Report *report, GError **error)
{
  const GPtrArray *runs = qn_document_get_runs (report->document);
  report->results = g_ptr_array_new_with_free_func (g_free);
  report->folder = g_dir_make_tmp ("quoin-XXXXXX", error);
  for (guint i = 0; report->folder != NULL && i < runs->len; i++) {
    const QnRun *run = runs->pdata[i];
    if (run->kind != QN_RUN_ANALYSIS || qn_document_is_stale (report->document, run))
      continue;
    g_autofree char *name = g_strdup_printf ("%u.json", report->results->len + 1);
    char *path = g_build_filename (report->folder, name, NULL);
    g_ptr_array_add (report->results, path);
    if (!qn_document_write_result (report->document, run, path, error))
      return FALSE;
  }
  return report->folder != NULL;
}

static char *
dup_sections (Report *report)
{
  GString *list = g_string_new (NULL);
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++)
    if (gtk_check_button_get_active (GTK_CHECK_BUTTON (report->checks[i])))
      g_string_append_printf (list, "%s%s", list->len > 0 ? "," : "",
                              qn_report_section_names[i]);
  return g_string_free (list, FALSE);
}

static gboolean
on_pulse (gpointer data)
{
  Report *report = data;
  gtk_progress_bar_pulse (GTK_PROGRESS_BAR (report->progress));
  return G_SOURCE_CONTINUE;
}

static void
set_busy (Report *report, gboolean busy)
{
  gtk_widget_set_sensitive (report->write, !busy);
  gtk_widget_set_visible (report->progress, busy);
  g_clear_handle_id (&report->pulse, g_source_remove);
  if (busy)
    report->pulse = g_timeout_add (PULSE_MS, on_pulse, report);
}

static void
on_written (GObject *process, GAsyncResult *result, gpointer data)
{
  Report *report = data;
  g_autofree char *errors = NULL;
  gboolean done = g_subprocess_communicate_utf8_finish (G_SUBPROCESS (process), result,
                                                        NULL, &errors, NULL)
                  && g_subprocess_get_successful (G_SUBPROCESS (process));
  g_clear_object (&report->process);
  remove_results (report);
  if (report->closed) {
    report_free (report);
    return;
  }
  set_busy (report, FALSE);
  g_autofree char *message = done ? g_strdup_printf (_ ("Written to %s"), report->path)
                                  : g_strdup (errors != NULL && *errors != '\0'
                                                ? g_strchomp (errors)
                                                : _ ("The report was not written"));
  report->tell (report->parent, message, !done);
  if (done)
    gtk_window_destroy (GTK_WINDOW (report->dialog));
}

static gboolean
start (Report *report, GError **error)
{
  g_autofree char *program = qn_build_tree_dup_cli ();
  g_autofree char *sections = dup_sections (report);
  if (program == NULL) {
    g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_NOT_FOUND,
                         _ ("quoin-cli, which writes reports, was not found"));
    return FALSE;
  }
  if (*sections == '\0') {
    g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_INVALID_ARGUMENT,
                         _ ("Choose at least one section"));
    return FALSE;
  }
  if (!write_results (report, error))
    return FALSE;
  g_autoptr (GPtrArray) line = g_ptr_array_new ();
  const char *const head[] = { program,
                               "report",
                               qn_document_get_path (report->document),
                               "-o",
                               report->path,
                               "--paper",
                               papers[gtk_drop_down_get_selected (report->paper)],
                               "--sections",
                               sections };
  for (gsize i = 0; i < G_N_ELEMENTS (head); i++)
    g_ptr_array_add (line, (gpointer) head[i]);
  for (guint i = 0; i < report->results->len; i++) {
    g_ptr_array_add (line, (gpointer) "-r");
    g_ptr_array_add (line, report->results->pdata[i]);
  }
  g_ptr_array_add (line, NULL);
  report->process = g_subprocess_newv (
    (const char *const *) line->pdata,
    G_SUBPROCESS_FLAGS_STDERR_PIPE | G_SUBPROCESS_FLAGS_STDOUT_SILENCE, error);
  if (report->process == NULL)
    return FALSE;
  g_subprocess_communicate_utf8_async (report->process, NULL, NULL, on_written, report);
  return TRUE;
}

static void
write_to (Report *report, const char *path)
{
  g_autoptr (GError) error = NULL;
  g_free (report->path);
  report->path = g_strdup (path);
  if (start (report, &error)) {
    set_busy (report, TRUE);
    return;
  }
  remove_results (report);
  report->tell (report->parent, error->message, TRUE);
}

static void
on_file_chosen (GtkNativeDialog *dialog, int response, Report *report)
{
  if (response == GTK_RESPONSE_ACCEPT) {
    const char *const endings[] = { ".pdf", NULL };
    g_autoptr (GError) error = NULL;
    g_autofree char *path = qn_dialog_dup_chosen_path (dialog, endings, &error);
    if (path != NULL)
      write_to (report, path);
    else
      report->tell (report->parent, error->message, TRUE);
  }
  g_clear_object (&report->chooser);
}

static void
on_write (Report *report)
{
  GtkFileChooserNative *chooser =
    qn_chooser_begin (GTK_WINDOW (report->dialog), &report->chooser,
                      GTK_FILE_CHOOSER_ACTION_SAVE, _ ("Write Report"), _ ("_Write"));
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), _ ("report.pdf"));
  g_signal_connect (chooser, "response", G_CALLBACK (on_file_chosen), report);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

/* ---- building ---- */

void
qn_report_dialog_show (GtkWindow *parent, QnDocument *document, QnTellFunc tell,
                       const char *path)
{
  Report *report = g_new0 (Report, 1);
  report->parent = parent;
  report->document = document;
  report->tell = tell;
  report->dialog = qn_dialog_new (parent, _ ("Report"), 420, -1);
  qn_help_set_page (report->dialog, "export");
  GtkWidget *form = qn_form_new ();
  qn_form_add_heading (form, _ ("Sections"));
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++) {
    report->checks[i] = gtk_check_button_new_with_label (_ (section_labels[i]));
    gtk_check_button_set_active (GTK_CHECK_BUTTON (report->checks[i]), TRUE);
    qn_form_add_wide (form, report->checks[i]);
  }
  const char *const choices[] = { _ ("A4"), _ ("Letter"), NULL };
  report->paper = GTK_DROP_DOWN (gtk_drop_down_new_from_strings (choices));
  qn_form_add_wide (form, qn_row_new (_ ("_Paper"), GTK_WIDGET (report->paper)));
  report->progress = gtk_progress_bar_new ();
  gtk_accessible_update_property (GTK_ACCESSIBLE (report->progress),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Report"), -1);
  gtk_widget_set_visible (report->progress, FALSE);
  qn_form_add_wide (form, report->progress);
  report->write = gtk_button_new_with_mnemonic (_ ("_Write…"));
  gtk_widget_add_css_class (report->write, "suggested-action");
  gtk_widget_set_tooltip_text (report->write,
                               _ ("Current runs are reported; a project without one is "
                                  "solved first. Closing this window cancels."));
  g_signal_connect_swapped (report->write, "clicked", G_CALLBACK (on_write), report);
  GtkWidget *header = gtk_window_get_titlebar (GTK_WINDOW (report->dialog));
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), report->write);
  gtk_window_set_child (GTK_WINDOW (report->dialog), form);
  g_object_weak_ref (G_OBJECT (form), on_closed, report);
  gtk_window_present (GTK_WINDOW (report->dialog));
  if (path != NULL)
    write_to (report, path);
}
