/* What a report holds: kept in the project where it is changed, then the window asks for the file. */
#include "app/dialogs/dialogs.h"

#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include "doc/edit/edit.h"
#include "doc/text/units.h"
#include "doc/view/report-template.h"

#include <glib/gi18n.h>
#include <math.h>

typedef struct Dialog {
  GtkWindow *window, *parent;
  QnDocument *document;
  GtkCheckButton *sections[QN_REPORT_SECTION_COUNT], *every_joint, *one_page;
  GtkDropDown *paper;
  GtkEditable *demand, *author, *text;
  GtkLabel *trouble;
  QnReportFunc choose;
} Dialog;

static char *
dup_entry (GtkEditable *entry)
{
  const char *text = gtk_editable_get_text (entry);
  return *text != '\0' ? g_strdup (text) : NULL;
}

/* A load multiplier, as a number or a product of numbers; nothing: 0. */
static gboolean
read_demand (Dialog *dialog, double *demand, GError **error)
{
  const char *text = gtk_editable_get_text (dialog->demand);
  *demand = 0;
  if (*text == '\0')
    return TRUE;
  if (!qn_units_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, text, demand, error))
    return FALSE;
  return (*demand > 0 && isfinite (*demand))
         || qn_edit_refuse (error,
                            _ ("The demand is a load multiplier, a positive number"));
}

static gboolean
keep (Dialog *dialog, GError **error)
{
  QnReportTemplate before = { 0 }, plan = { 0 };
  if (!read_demand (dialog, &plan.demand, error))
    return FALSE;
  gboolean was_sound =
    qn_report_template_read (&before, qn_document_get_project (dialog->document), NULL);
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++)
    plan.sections[i] = gtk_check_button_get_active (dialog->sections[i]);
  plan.every_joint = gtk_check_button_get_active (dialog->every_joint);
  plan.paper =
    gtk_drop_down_get_selected (dialog->paper) == 1 ? QN_PAPER_LETTER : QN_PAPER_A4;
  plan.author = dup_entry (dialog->author);
  plan.text = dup_entry (dialog->text);
  g_autofree char *kept = qn_report_template_to_json (&before);
  g_autofree char *wanted = qn_report_template_to_json (&plan);
  gboolean done =
    (was_sound && g_str_equal (kept, wanted))
    || qn_document_edit_extra (dialog->document, _ ("Change Contents of the Report"),
                               NULL, QN_REPORT_MEMBER, wanted, error);
  qn_report_template_clear (&before);
  qn_report_template_clear (&plan);
  return done;
}

static void
on_export (Dialog *dialog)
{
  g_autoptr (GError) error = NULL;
  GtkWindow *parent = dialog->parent;
  QnReportFunc choose = dialog->choose;
  if (!keep (dialog, &error)) {
    gtk_label_set_text (dialog->trouble, error->message);
    gtk_widget_set_visible (GTK_WIDGET (dialog->trouble), TRUE);
    return;
  }
  gtk_window_destroy (dialog->window);
  choose (parent);
}

/* The title is a summary of one page. */
static void
on_one_page (Dialog *dialog)
{
  const gboolean one = gtk_check_button_get_active (dialog->one_page);
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++)
    gtk_check_button_set_active (dialog->sections[i], !one || i == QN_REPORT_TITLE);
}

static void
update (Dialog *dialog, const QnReportTemplate *plan)
{
  gboolean more = FALSE;
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++) {
    gtk_check_button_set_active (dialog->sections[i], plan->sections[i]);
    more |= plan->sections[i] && i != QN_REPORT_TITLE;
  }
  gtk_check_button_set_active (dialog->one_page, !more);
  gtk_check_button_set_active (dialog->every_joint, plan->every_joint);
  gtk_drop_down_set_selected (dialog->paper, plan->paper == QN_PAPER_LETTER ? 1 : 0);
  g_autofree char *demand =
    qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, plan->demand, 15);
  gtk_editable_set_text (dialog->demand, plan->demand > 0 ? demand : "");
  gtk_editable_set_text (dialog->author, plan->author != NULL ? plan->author : "");
  gtk_editable_set_text (dialog->text, plan->text != NULL ? plan->text : "");
}

void
qn_report_dialog_show (GtkWindow *parent, QnDocument *document, QnReportFunc choose)
{
  Dialog *dialog = g_new0 (Dialog, 1);
  QnReportTemplate plan;
  g_autoptr (GtkBuilder) builder = qn_builder_new ("report-dialog");
  dialog->parent = parent;
  dialog->document = document;
  dialog->choose = choose;
  dialog->window = GTK_WINDOW (qn_builder_get_widget (builder, "form"));
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++)
    dialog->sections[i] =
      GTK_CHECK_BUTTON (qn_builder_get_widget (builder, qn_report_section_names[i]));
  dialog->every_joint = GTK_CHECK_BUTTON (qn_builder_get_widget (builder, "every-joint"));
  dialog->one_page = GTK_CHECK_BUTTON (qn_builder_get_widget (builder, "one-page"));
  dialog->paper = GTK_DROP_DOWN (qn_builder_get_widget (builder, "paper"));
  dialog->demand = GTK_EDITABLE (qn_builder_get_widget (builder, "demand"));
  dialog->author = GTK_EDITABLE (qn_builder_get_widget (builder, "author"));
  dialog->text = GTK_EDITABLE (qn_builder_get_widget (builder, "text"));
  dialog->trouble = GTK_LABEL (qn_builder_get_widget (builder, "trouble"));
  qn_own (GTK_WIDGET (dialog->window), dialog);
  GtkWidget *export = qn_builder_get_widget (builder, "export");
  g_signal_connect_swapped (export, "clicked", G_CALLBACK (on_export), dialog);
  qn_report_template_read (&plan, qn_document_get_project (document), NULL);
  update (dialog, &plan);
  qn_report_template_clear (&plan);
  g_signal_connect_swapped (dialog->one_page, "toggled", G_CALLBACK (on_one_page),
                            dialog);
  qn_dialog_present (GTK_WIDGET (dialog->window), parent, "export", export);
}
