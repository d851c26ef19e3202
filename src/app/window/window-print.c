/* Printing what the window shows: one page, as figures are exported. */
#include "app/window/window-private.h"

#include "doc/view/figures.h"
#include <glib/gi18n.h>

#define POINTS_PER_INCH 72.0

static gboolean
draw_page (QnWindow *self, cairo_t *cr, double width, double height, GError **error)
{
  QnFigure figure;
  if (!qn_view_state_get_figure (self->state, &figure, error))
    return FALSE;
  const QnPage page = {
    .width = width, .height = height, .unit = 1.0, .antialias = true
  };
  const QnFrame frame = { 0.0, 0.0, width, height };
  return qn_figure_draw (&figure, cr, &page, &frame, NULL, error);
}

static void
on_draw_page (GtkPrintOperation *operation, GtkPrintContext *context, int number,
              QnWindow *self)
{
  cairo_t *cr = gtk_print_context_get_cairo_context (context);
  double points_x = gtk_print_context_get_dpi_x (context) / POINTS_PER_INCH;
  double points_y = gtk_print_context_get_dpi_y (context) / POINTS_PER_INCH;
  g_autoptr (GError) error = NULL;
  /* Figures are drawn in typographic points, whatever the printer's resolution. */
  cairo_scale (cr, points_x, points_y);
  if (draw_page (self, cr, gtk_print_context_get_width (context) / points_x,
                 gtk_print_context_get_height (context) / points_y, &error))
    return;
  qn_window_show_error (self, error->message);
  gtk_print_operation_cancel (operation);
}

static void
on_done (GtkPrintOperation *operation, GtkPrintOperationResult result, QnWindow *self)
{
  g_autoptr (GError) error = NULL;
  if (result == GTK_PRINT_OPERATION_RESULT_ERROR) {
    gtk_print_operation_get_error (operation, &error);
    qn_window_show_error (self, error != NULL ? error->message : _ ("Printing failed"));
  } else if (result == GTK_PRINT_OPERATION_RESULT_APPLY)
    g_set_object (&self->print_settings,
                  gtk_print_operation_get_print_settings (operation));
}

static void
print_by (QnWindow *self, GtkPrintOperationAction action, const char *path)
{
  g_autoptr (GtkPrintOperation) operation = gtk_print_operation_new ();
  g_autofree char *name = qn_document_dup_display_name (self->document);
  g_autoptr (GtkPageSetup) setup = gtk_page_setup_new ();
  g_autoptr (GError) error = NULL;
  gtk_page_setup_set_orientation (setup, GTK_PAGE_ORIENTATION_LANDSCAPE);
  gtk_print_operation_set_default_page_setup (operation, setup);
  gtk_print_operation_set_embed_page_setup (operation, TRUE);
  gtk_print_operation_set_n_pages (operation, 1);
  gtk_print_operation_set_job_name (operation, name);
  gtk_print_operation_set_allow_async (operation, TRUE);
  if (self->print_settings != NULL)
    gtk_print_operation_set_print_settings (operation, self->print_settings);
  if (path != NULL)
    gtk_print_operation_set_export_filename (operation, path);
  g_signal_connect_object (operation, "draw-page", G_CALLBACK (on_draw_page), self, 0);
  g_signal_connect_object (operation, "done", G_CALLBACK (on_done), self, 0);
  if (gtk_print_operation_run (operation, action, GTK_WINDOW (self), &error)
      == GTK_PRINT_OPERATION_RESULT_ERROR)
    qn_window_show_error (self, error->message);
}

static void
print (QnWindow *self, GVariant *parameter)
{
  print_by (self, GTK_PRINT_OPERATION_ACTION_PRINT_DIALOG, NULL);
}

/* The page as a PDF file, without asking. */
static void
print_path (QnWindow *self, GVariant *parameter)
{
  print_by (self, GTK_PRINT_OPERATION_ACTION_EXPORT,
            g_variant_get_string (parameter, NULL));
}

const QnWindowAction qn_window_print_actions[] = {
  { "print", NULL, print, QN_NEEDS_DRAWN },
  { "print-path", "s", print_path, QN_NEEDS_DRAWN },
  { .name = NULL },
};
