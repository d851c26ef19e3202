/* Analysis and plan of a study, the number of its cases, and the outputs that are kept. */
#include "app/dialogs/study-private.h"

#include "study/report/output-text.h"

static void
on_output (GtkCheckButton *check, QnStudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_output (
    self->draft,
    (QnStudyOutput) GPOINTER_TO_INT (g_object_get_data (G_OBJECT (check), "qn-output")),
    gtk_check_button_get_active (check));
  qn_study_window_show_draft (self);
}

static void
on_plan (QnStudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_plan (self->draft, (QnPlanKind) gtk_drop_down_get_selected (self->plan),
                     gtk_spin_button_get_value_as_int (self->count));
  qn_study_window_show_draft (self);
}

static void
on_analysis (QnStudyWindow *self)
{
  if (self->showing)
    return;
  qn_draft_set_run (self->draft,
                    (QnStudyRun) gtk_drop_down_get_selected (self->analysis));
  qn_study_window_show_draft (self);
}

void
qn_study_window_show_plan (QnStudyWindow *self)
{
  int count;
  const QnModel *model = qn_document_get_model (self->parent.document);
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

void
qn_study_window_connect_plan (QnStudyWindow *self)
{
  g_signal_connect_swapped (self->plan, "notify::selected", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->count, "value-changed", G_CALLBACK (on_plan), self);
  g_signal_connect_swapped (self->analysis, "notify::selected", G_CALLBACK (on_analysis),
                            self);
}
