/* What comes in from outside: drawings of other programs, pictures behind the drawing, and files
 * dropped on the window. */
#include "app/window-private.h"

#include "doc/import.h"
#include "doc/picture.h"
#include <glib/gi18n.h>

/* ---- pictures ---- */

static void
insert_picture (QnWindow *self, const char *path)
{
  g_autoptr (GError) error = NULL;
  gboolean blank = qn_window_is_blank (self);
  qn_window_show_work (self);
  QnBox view = qn_camera_visible_box (qn_canvas_get_camera (self->canvas));
  if (blank || !(view.max.x > view.min.x))
    view = (QnBox){ { 0.0, 0.0 }, { 5.0, 4.0 } };
  if (!qn_document_insert_picture (self->document, path, view, &error)) {
    qn_window_show_error (self, error->message);
    return;
  }
  gtk_stack_set_visible_child_name (self->side_stack, "properties");
  gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s", "picture");
  qn_canvas_fit (self->canvas);
}

static void
picture_path (QnWindow *self, GVariant *parameter)
{
  insert_picture (self, g_variant_get_string (parameter, NULL));
}

static void
remove_picture (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  g_autoptr (GError) error = NULL;
  if (!qn_document_remove_picture (self->document, &error))
    qn_window_show_error (self, error->message);
}

/* ---- files of every kind ---- */

void
qn_window_take_file (QnWindow *self, const char *path)
{
  if (qn_import_is_picture (path))
    insert_picture (self, path);
  else if (qn_import_knows_file (path))
    qn_import_dialog_show (self, path);
  else
    gtk_widget_activate_action (GTK_WIDGET (self), "win.open-path", "s", path);
}

static void
take_path (QnWindow *self, GVariant *parameter)
{
  qn_window_take_file (self, g_variant_get_string (parameter, NULL));
}

static gboolean
on_drop (GtkDropTarget *target, const GValue *value, double x, double y, QnWindow *self)
{
  (void) target;
  (void) x;
  (void) y;
  gboolean taken = FALSE;
  for (GSList *l = g_value_get_boxed (value); l != NULL; l = l->next) {
    g_autofree char *path = g_file_get_path (l->data);
    if (path != NULL)
      qn_window_take_file (self, path);
    else
      qn_window_show_error (self, _ ("Only local files can be opened"));
    taken |= path != NULL;
  }
  return taken;
}

void
qn_window_accept_drops (QnWindow *self)
{
  GtkDropTarget *drop = gtk_drop_target_new (GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
  g_signal_connect (drop, "drop", G_CALLBACK (on_drop), self);
  gtk_widget_add_controller (GTK_WIDGET (self), GTK_EVENT_CONTROLLER (drop));
}

/* ---- choosing ---- */

static void
on_response (GtkNativeDialog *dialog, int response, QnWindow *self)
{
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (dialog));
    g_autofree char *path = g_file_get_path (file);
    if (path != NULL)
      gtk_widget_activate_action (GTK_WIDGET (self), "win.take-path", "s", path);
    else
      qn_window_show_error (self, _ ("Only local files can be opened"));
  }
  g_clear_object (&self->chooser);
}

static void
choose (QnWindow *self, const char *title, const char *accept, const char *kind,
        const char *const *patterns)
{
  GtkFileChooserNative *chooser = gtk_file_chooser_native_new (
    title, GTK_WINDOW (self), GTK_FILE_CHOOSER_ACTION_OPEN, accept, NULL);
  g_autoptr (GtkFileFilter) filter = gtk_file_filter_new ();
  gtk_file_filter_set_name (filter, kind);
  for (gsize i = 0; patterns[i] != NULL; i++)
    gtk_file_filter_add_suffix (filter, patterns[i]);
  gtk_file_chooser_add_filter (GTK_FILE_CHOOSER (chooser), filter);
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
  g_signal_connect (chooser, "response", G_CALLBACK (on_response), self);
  g_set_object (&self->chooser, G_OBJECT (chooser));
  g_object_unref (chooser);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

static void
import_drawing (QnWindow *self, GVariant *parameter)
{
  static const char *const patterns[] = { "dxf", "svg", "json", "txt", NULL };
  (void) parameter;
  choose (self, _ ("Import Drawing"), _ ("_Import"),
          _ ("Drawings: DXF, SVG, COMPAS, HybriDFEM"), patterns);
}

static void
picture (QnWindow *self, GVariant *parameter)
{
  static const char *const patterns[] = { "png", "jpg",  "jpeg", "tif",
                                          "bmp", "tiff", "webp", NULL };
  (void) parameter;
  choose (self, _ ("Picture behind the Drawing"), _ ("_Open"), _ ("Pictures"), patterns);
}

void
qn_window_add_import_actions (QnWindow *self)
{
  static const QnWindowAction actions[] = {
    { "import", NULL, import_drawing },
    { "take-path", "s", take_path },
    { "picture", NULL, picture },
    { "picture-path", "s", picture_path },
    { "remove-picture", NULL, remove_picture },
  };
  qn_window_add_action_table (self, actions, G_N_ELEMENTS (actions));
}
