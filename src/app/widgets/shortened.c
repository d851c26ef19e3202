#include "app/widgets/shortened.h"

#include <string.h>

static gboolean
on_query_tooltip (GtkLabel *label, int x, int y, gboolean by_key, GtkTooltip *tooltip)
{
  gtk_tooltip_set_text (tooltip, gtk_label_get_text (label));
  return pango_layout_is_ellipsized (gtk_label_get_layout (label));
}

static void
tell (GtkLabel *label)
{
  if (gtk_label_get_ellipsize (label) == PANGO_ELLIPSIZE_NONE
      || gtk_widget_get_has_tooltip (GTK_WIDGET (label)))
    return;
  g_signal_connect (label, "query-tooltip", G_CALLBACK (on_query_tooltip), NULL);
  gtk_widget_set_has_tooltip (GTK_WIDGET (label), TRUE);
}

void
qn_shortened_tell (GtkWidget *widget)
{
  if (GTK_IS_LABEL (widget))
    tell (GTK_LABEL (widget));
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    qn_shortened_tell (child);
}

void
qn_shortened_set (GtkLabel *label, PangoEllipsizeMode mode)
{
  gtk_label_set_ellipsize (label, mode);
  tell (label);
}

char *
qn_shortened_dup_folder (const char *path)
{
  const char *home = g_get_home_dir ();
  const gsize length = strlen (home);
  g_autofree char *folder = g_path_get_dirname (path);
  if (g_str_has_prefix (folder, home)
      && (folder[length] == '\0' || G_IS_DIR_SEPARATOR (folder[length])))
    return g_strconcat ("~", folder + length, NULL);
  return g_steal_pointer (&folder);
}
