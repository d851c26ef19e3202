#include "app/widgets/popovers.h"

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

void
qn_popovers_close_with (GtkWidget *window)
{
  g_signal_connect (window, "unmap", G_CALLBACK (close_all), NULL);
}
