#include "app/widgets/dialog.h"

#include "app/widgets/shortened.h"

#include <glib/gi18n.h>

#define BEFORE "qn-focus-before" /* a weak reference */

static void
close_all (GtkWidget *widget)
{
  for (GtkWidget *child = gtk_widget_get_first_child (widget), *next; child != NULL;
       child = next) {
    next = gtk_widget_get_next_sibling (child);
    close_all (child);
    if (GTK_IS_POPOVER (child))
      gtk_widget_hide (child);
  }
}

static void
free_reference (gpointer reference)
{
  g_weak_ref_clear (reference);
  g_free (reference);
}

/* GTK 4.8 leaves the focus in a submenu that has closed, where no key is heard. It goes back to what had it
 * outside of popovers. */
static void
on_closed (GtkWidget *popover)
{
  GtkRoot *window = gtk_widget_get_root (popover);
  GtkWidget *focus = window != NULL ? gtk_root_get_focus (window) : NULL;
  if (focus == NULL || !gtk_widget_is_ancestor (focus, popover))
    return;
  g_autoptr (GtkWidget) back =
    g_weak_ref_get (g_object_get_data (G_OBJECT (window), BEFORE));
  if (back == NULL || !gtk_widget_get_mapped (back) || !gtk_widget_grab_focus (back))
    gtk_root_set_focus (window, NULL);
}

static void
on_focus (GtkWindow *window)
{
  GtkWidget *focus = gtk_window_get_focus (window);
  GtkWidget *popover =
    focus != NULL ? gtk_widget_get_ancestor (focus, GTK_TYPE_POPOVER) : NULL;
  if (popover == NULL)
    g_weak_ref_set (g_object_get_data (G_OBJECT (window), BEFORE), focus);
  else if (g_signal_handler_find (popover, G_SIGNAL_MATCH_FUNC, 0, 0, NULL, on_closed,
                                  NULL)
           == 0)
    g_signal_connect (popover, "closed", G_CALLBACK (on_closed), NULL);
}

void
qn_popovers_attend (GtkWidget *window)
{
  GWeakRef *before = g_new0 (GWeakRef, 1);
  g_weak_ref_init (before, NULL);
  g_object_set_data_full (G_OBJECT (window), BEFORE, before, free_reference);
  g_signal_connect (window, "unmap", G_CALLBACK (close_all), NULL);
  g_signal_connect (window, "notify::focus-widget", G_CALLBACK (on_focus), NULL);
}

void
qn_dialog_attend (GtkWidget *window)
{
  qn_popovers_attend (window);
  GtkEventController *keys = gtk_shortcut_controller_new ();
  gtk_shortcut_controller_add_shortcut (
    GTK_SHORTCUT_CONTROLLER (keys),
    gtk_shortcut_new (gtk_keyval_trigger_new (GDK_KEY_Escape, 0),
                      gtk_named_action_new ("window.close")));
  gtk_widget_add_controller (window, keys);
}

GtkWidget *
qn_dialog_new (GtkWindow *parent, const char *title, int width, int height)
{
  GtkWidget *dialog = gtk_window_new ();
  gtk_window_set_title (GTK_WINDOW (dialog), title);
  gtk_window_set_transient_for (GTK_WINDOW (dialog), parent);
  gtk_window_set_modal (GTK_WINDOW (dialog), TRUE);
  gtk_window_set_destroy_with_parent (GTK_WINDOW (dialog), TRUE);
  gtk_window_set_default_size (GTK_WINDOW (dialog), width, height);
  GtkWidget *header = gtk_header_bar_new ();
  qn_shortened_tell (header);
  gtk_window_set_titlebar (GTK_WINDOW (dialog), header);
  qn_dialog_attend (dialog);
  return dialog;
}

void
qn_dialog_present (GtkWidget *dialog, GtkWidget *accept)
{
  gtk_window_present (GTK_WINDOW (dialog));
  gtk_widget_grab_focus (accept);
}

char *
qn_dialog_complete_path (const char *path, const char *const *endings, GError **error)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  for (int i = 0; endings[i] != NULL; i++)
    if (g_str_has_suffix (lower, endings[i]))
      return g_strdup (path);
  g_autofree char *whole = g_strconcat (path, endings[0], NULL);
  if (g_file_test (whole, G_FILE_TEST_EXISTS)) {
    g_set_error (error, G_IO_ERROR, G_IO_ERROR_EXISTS,
                 _ ("%s exists already: choose it to replace it"), whole);
    return NULL;
  }
  return g_steal_pointer (&whole);
}

char *
qn_dialog_dup_chosen_path (GtkNativeDialog *chooser, const char *const *endings,
                           GError **error)
{
  g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (chooser));
  g_autofree char *path = file != NULL ? g_file_get_path (file) : NULL;
  if (path != NULL)
    return qn_dialog_complete_path (path, endings, error);
  g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_NOT_SUPPORTED,
                       _ ("Only local files can be written"));
  return NULL;
}
