/* What has been computed of a study, and what comes in while it runs. */
#include "app/dialogs/study-private.h"

#include "doc/text/path-text.h"
#include "study/report/output-text.h"
#include <glib/gi18n.h>

char *
qn_study_window_dup_folder (const QnStudy *study, const char *path)
{
  g_autofree char *sum = g_strndup (study->sha256, 8);
  g_autofree char *stem = g_str_has_suffix (path, ".quoin-study")
                            ? g_strndup (path, strlen (path) - strlen (".quoin-study"))
                            : g_strdup (path);
  return g_strdup_printf ("%s-study-%s", stem, sum);
}

/* What the figures leave out is said above them. */
static void
show_failed (QnStudyWindow *self)
{
  guint failed = 0;
  const char *reason = NULL;
  for (guint i = 0; i < self->table.rows->len; i++) {
    const QnRow *row = &g_array_index (self->table.rows, QnRow, i);
    failed += row->failed ? 1 : 0;
    reason = row->failed && reason == NULL ? row->reason : reason;
  }
  g_autofree char *why = g_strdup (reason != NULL ? reason : "");
  for (guint i = 0; i < self->study.parameters->len; i++) {
    if (qn_study_parameter (&self->study, i)->paths[0] == NULL)
      continue;
    char *shorter =
      qn_path_dup_reason (why, qn_study_parameter (&self->study, i)->paths[0]);
    g_free (why);
    why = shorter;
  }
  g_autofree char *text = g_strdup_printf (
    _ ("%u of %u cases have no answer; the figures are of the others. First reason: %s"),
    failed, self->table.rows->len, why);
  gtk_label_set_text (self->failed, text);
  gtk_widget_set_visible (GTK_WIDGET (self->failed), failed > 0);
  gtk_widget_queue_draw (self->plot);
}

void
qn_study_window_forget_results (QnStudyWindow *self)
{
  if (self->folder == NULL)
    return;
  qn_table_clear (&self->table);
  qn_study_clear (&self->study);
  g_clear_pointer (&self->folder, g_free);
  self->chosen = -1;
}

static void
fill (GtkDropDown *choice, const QnStudy *study, gboolean outputs)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  for (guint i = 0; !outputs && i < study->parameters->len; i++)
    g_strv_builder_add (names, qn_study_parameter (study, i)->name);
  for (guint i = 0; outputs && i < study->outputs->len; i++)
    if (qn_study_output_is_number (qn_study_output (study, i)))
      g_strv_builder_add (names, qn_study_output_text (qn_study_output (study, i)));
  g_auto (GStrv) strings = g_strv_builder_end (names);
  g_autoptr (GtkStringList) list = gtk_string_list_new ((const char *const *) strings);
  gtk_drop_down_set_model (choice, G_LIST_MODEL (list));
}

void
qn_study_window_read_results (QnStudyWindow *self)
{
  QnStudy study;
  QnTable table;
  if (!qn_study_read (qn_draft_get_path (self->draft), NULL, &study, NULL))
    return;
  g_autofree char *folder =
    qn_study_window_dup_folder (&study, qn_draft_get_path (self->draft));
  gboolean same = g_strcmp0 (folder, self->folder) == 0;
  qn_study_window_forget_results (self);
  gtk_widget_set_visible (GTK_WIDGET (self->failed), FALSE);
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
  show_failed (self);
}

void
qn_study_window_read_more (QnStudyWindow *self)
{
  QnTable table;
  if (g_strcmp0 (self->folder, self->running) != 0) {
    qn_study_window_read_results (self);
    return;
  }
  if (!qn_table_read (&table, &self->study, self->folder, NULL))
    return;
  qn_table_clear (&self->table);
  self->table = table;
  show_failed (self);
}
