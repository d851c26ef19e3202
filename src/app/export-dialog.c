/* The figure dialog: size and resolution with a live preview, then where to write it. */
#include "app/window-private.h"

#include "app/form.h"
#include "doc/figure-export.h"
#include <glib/gi18n.h>

enum { UNIT_PX, UNIT_MM };

typedef struct Dialog {
  QnWindow *window;
  GtkWidget *dialog, *preview;
  GtkDropDown *unit, *format;
  QnQuantityEntry *width, *height, *dpi;
  GtkWidget *transparent, *monochrome;
  GtkLabel *trouble;
} Dialog;

/* What the last export of this program looked like, for "Repeat Export". */
static QnOutput last_output;

static QnOutput
output_of (const Dialog *dialog)
{
  QnOutput output;
  qn_output_init (&output);
  output.width = qn_quantity_entry_get_value (dialog->width);
  output.height = qn_quantity_entry_get_value (dialog->height);
  output.millimetres = gtk_drop_down_get_selected (dialog->unit) == UNIT_MM;
  output.dpi = output.millimetres ? qn_quantity_entry_get_value (dialog->dpi) : 0.0;
  output.transparent =
    gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->transparent));
  return output;
}

static void
draw_preview (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  (void) area;
  const Dialog *dialog = data;
  QnOutput output = output_of (dialog);
  QnFigure figure;
  QnPage page;
  g_autoptr (GError) error = NULL;
  if (!qn_output_page (&output, &page, &error)
      || !qn_view_state_get_figure (dialog->window->state, &figure, &error)) {
    gtk_label_set_text (dialog->trouble, error->message);
    return;
  }
  figure.options.monochrome =
    gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->monochrome));
  double scale = MIN (width / page.width, height / page.height);
  cairo_translate (cr, 0.5 * (width - scale * page.width),
                   0.5 * (height - scale * page.height));
  cairo_scale (cr, scale, scale);
  cairo_rectangle (cr, 0.0, 0.0, page.width, page.height);
  cairo_clip (cr);
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  QnFrame frame = { 0.0, 0.0, page.width, page.height, 0.0 };
  gboolean drawn = qn_figure_draw (&figure, cr, &page, &frame, NULL, &error);
  gtk_label_set_text (dialog->trouble, drawn ? "" : error->message);
}

static void
redraw (Dialog *dialog)
{
  qn_form_set_row_visible (GTK_WIDGET (dialog->dpi),
                           gtk_drop_down_get_selected (dialog->unit) == UNIT_MM);
  gtk_widget_queue_draw (dialog->preview);
}

static void
on_quantity (QnQuantityEntry *entry, Dialog *dialog)
{
  (void) entry;
  redraw (dialog);
}

static void
on_unit (GtkDropDown *unit, GParamSpec *pspec, Dialog *dialog)
{
  (void) pspec;
  gboolean mm = gtk_drop_down_get_selected (unit) == UNIT_MM;
  qn_quantity_entry_set_value (dialog->width, mm ? 160.0 : 1600.0);
  qn_quantity_entry_set_value (dialog->height, mm ? 120.0 : 1200.0);
  redraw (dialog);
}

static gboolean
export_to (QnWindow *self, const char *path, const QnOutput *output)
{
  g_autoptr (GError) error = NULL;
  if (!qn_view_state_export (self->state, path, output, &error)) {
    qn_window_show_error (self, error->message);
    return FALSE;
  }
  if (path != self->last_export) {
    g_free (self->last_export);
    self->last_export = g_strdup (path);
  }
  last_output = *output;
  qn_window_update_actions (self);
  return TRUE;
}

static void
on_file_chosen (GtkNativeDialog *chooser, int response, Dialog *dialog)
{
  QnWindow *self = dialog->window;
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (chooser));
    g_autofree char *path = g_file_get_path (file);
    QnOutput output = output_of (dialog);
    qn_view_state_set_switch (
      self->state, "monochrome",
      gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->monochrome)));
    if (path != NULL)
      export_to (self, path, &output);
  }
  gtk_window_destroy (GTK_WINDOW (dialog->dialog));
  g_clear_object (&self->chooser);
}

static void
on_export (Dialog *dialog)
{
  static const char *const endings[] = { "png", "svg", "pdf" };
  GtkFileChooserNative *chooser =
    gtk_file_chooser_native_new (_ ("Export Figure"), GTK_WINDOW (dialog->dialog),
                                 GTK_FILE_CHOOSER_ACTION_SAVE, _ ("_Export"), NULL);
  g_autofree char *name = qn_document_dup_display_name (dialog->window->document);
  g_autofree char *proposed = g_strdup_printf (
    "%s – %s.%s", name, qn_view_name (qn_view_state_get_view (dialog->window->state)),
    endings[gtk_drop_down_get_selected (dialog->format)]);
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser),
                                     g_strdelimit (proposed, "/", '-'));
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
  g_signal_connect (chooser, "response", G_CALLBACK (on_file_chosen), dialog);
  g_set_object (&dialog->window->chooser, G_OBJECT (chooser));
  g_object_unref (chooser);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

static GtkWidget *
build_form (Dialog *dialog)
{
  const char *const units[] = { _ ("Pixels"), _ ("Millimetres"), NULL };
  const char *const formats[] = { "PNG", "SVG", "PDF", NULL };
  GtkWidget *form = qn_form_new ();
  GCallback changed = G_CALLBACK (on_quantity);
  dialog->format =
    qn_form_add_choice (form, _ ("_Format"), formats, G_CALLBACK (redraw), dialog);
  g_signal_handlers_disconnect_by_data (dialog->format, dialog);
  dialog->unit =
    qn_form_add_choice (form, _ ("_Size in"), units, G_CALLBACK (on_unit), dialog);
  dialog->width = qn_form_add_quantity (form, _ ("_Width"), QN_QUANTITY_NUMBER, 1.0,
                                        32000.0, changed, dialog);
  dialog->height = qn_form_add_quantity (form, _ ("_Height"), QN_QUANTITY_NUMBER, 1.0,
                                         32000.0, changed, dialog);
  dialog->dpi = qn_form_add_quantity (form, _ ("_Dots per inch"), QN_QUANTITY_NUMBER,
                                      10.0, 2400.0, changed, dialog);
  dialog->transparent = gtk_check_button_new_with_mnemonic (_ ("_Transparent ground"));
  dialog->monochrome = gtk_check_button_new_with_mnemonic (_ ("_Black and white"));
  gtk_check_button_set_active (
    GTK_CHECK_BUTTON (dialog->monochrome),
    qn_view_state_get_switch (dialog->window->state, "monochrome"));
  g_signal_connect_swapped (dialog->transparent, "toggled", G_CALLBACK (redraw), dialog);
  g_signal_connect_swapped (dialog->monochrome, "toggled", G_CALLBACK (redraw), dialog);
  qn_form_add_wide (form, dialog->transparent);
  qn_form_add_wide (form, dialog->monochrome);
  dialog->trouble = qn_form_add_text (form);
  qn_quantity_entry_set_value (dialog->width, 1600.0);
  qn_quantity_entry_set_value (dialog->height, 1200.0);
  qn_quantity_entry_set_value (dialog->dpi, 300.0);

  GtkWidget *button = gtk_button_new_with_mnemonic (_ ("_Export…"));
  gtk_widget_add_css_class (button, "suggested-action");
  gtk_widget_set_margin_top (button, 12);
  g_signal_connect_swapped (button, "clicked", G_CALLBACK (on_export), dialog);
  qn_form_add_wide (form, button);
  return form;
}

void
qn_export_dialog_show (QnWindow *self)
{
  Dialog *dialog = g_new0 (Dialog, 1);
  dialog->window = self;
  dialog->dialog = gtk_window_new ();
  gtk_window_set_title (GTK_WINDOW (dialog->dialog), _ ("Export Figure"));
  gtk_window_set_transient_for (GTK_WINDOW (dialog->dialog), GTK_WINDOW (self));
  gtk_window_set_modal (GTK_WINDOW (dialog->dialog), TRUE);
  gtk_window_set_destroy_with_parent (GTK_WINDOW (dialog->dialog), TRUE);
  gtk_window_set_default_size (GTK_WINDOW (dialog->dialog), 860, 500);

  dialog->preview = gtk_drawing_area_new ();
  gtk_widget_set_hexpand (dialog->preview, TRUE);
  gtk_widget_set_vexpand (dialog->preview, TRUE);
  gtk_widget_set_margin_start (dialog->preview, 12);
  gtk_widget_set_margin_top (dialog->preview, 12);
  gtk_widget_set_margin_bottom (dialog->preview, 12);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog->preview),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Preview"), -1);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 12);
  gtk_box_append (GTK_BOX (box), dialog->preview);
  GtkWidget *form = build_form (dialog);
  gtk_widget_set_hexpand (form, FALSE);
  gtk_box_append (GTK_BOX (box), form);
  gtk_window_set_child (GTK_WINDOW (dialog->dialog), box);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (dialog->preview), draw_preview,
                                  dialog, NULL);
  qn_own (box, dialog);
  redraw (dialog);
  gtk_window_present (GTK_WINDOW (dialog->dialog));
}

void
qn_export_repeat (QnWindow *self)
{
  if (self->last_export != NULL)
    export_to (self, self->last_export, &last_output);
}
