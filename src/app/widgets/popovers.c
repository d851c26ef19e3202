#include "app/widgets/popovers.h"

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
