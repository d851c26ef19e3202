/* What comes in from outside: drawings of other programs, pictures behind the drawing, and files
 * dropped on the window. */
#include "app/dialogs/dialogs.h"
#include "app/window/window-private.h"

#include "doc/document/document.h"
#include "doc/document/import.h"
#include "doc/document/underlay.h"
#include <glib/gi18n.h>

/* ---- pictures ---- */

static void
remove_picture (QnWindow *self, const char *name)
{
  g_autoptr (GError) error = NULL;
  if (!qn_document_remove_picture (self->document, &error))
    qn_window_show_error (self, error->message);
}

/* ---- files of every kind ---- */

static void
take_import (GtkWindow *window, const QnProject *project)
{
  QnWindow *self = QN_WINDOW (window);
  g_autoptr (GError) error = NULL;
  qn_window_show_work (self);
  if (qn_document_import (self->document, NULL, project, &error))
    qn_canvas_fit (self->canvas);
  else
    qn_window_show_error (self, error->message);
}

/* Its loads and ties would be lost in another drawing. */
static void
take_strip (GtkWindow *window, const QnProject *project)
{
  QnWindow *self = QN_WINDOW (window);
  g_autoptr (GError) error = NULL;
  if (self->document->project.model.block_count > 0)
    self = qn_window_new (gtk_window_get_application (window));
  qn_window_show_work (self);
  if (!qn_document_import (self->document, _ ("Strip of a Façade"), project, &error))
    qn_window_show_error (self, error->message);
  qn_canvas_fit (self->canvas);
}

static void
facade_strip (QnWindow *self, const char *name)
{
  qn_facade_dialog_show (GTK_WINDOW (self), take_strip);
}

void
qn_window_take_file (QnWindow *self, const char *path)
{
  if (qn_is_result_file (path))
    qn_window_open_result (self, path);
  else if (qn_import_is_picture (path)) {
    g_autoptr (GError) error = NULL;
    qn_window_show_work (self);
    if (qn_document_insert_picture (self->document, path, &error)) {
      gtk_stack_set_visible_child_name (self->side_stack, "properties");
      gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s", "picture");
      qn_canvas_fit (self->canvas);
    } else
      qn_window_show_error (self, error->message);
  } else if (qn_import_knows_file (path))
    qn_import_dialog_show (GTK_WINDOW (self), path,
                           self->document->project.model.block_count > 0, take_import);
  else
    gtk_widget_activate_action (GTK_WIDGET (self), "win.open-path", "s", path);
}

static gboolean
use_dropped (gpointer window, const char *path, GError **error)
{
  qn_window_take_file (window, path);
  return TRUE;
}

void
qn_window_accept_drops (QnWindow *self)
{
  const QnFileQuestion question = { .use = use_dropped, .failed = qn_window_show_error };
  qn_accept_files (GTK_WIDGET (self), &question, self);
}

const QnWindowAction qn_window_import_actions[] = {
  { "import", NULL, { qn_window_choose_file }, 0 },
  { "facade-strip", NULL, { facade_strip }, 0 },
  { "take-path", "s", { qn_window_take_file }, 0 },
  { "picture", NULL, { qn_window_choose_file }, 0 },
  { "remove-picture", NULL, { remove_picture }, 0 },
  { .name = NULL },
};
