#include "app/widgets/builder.h"

#include "app/widgets/dialog.h"
#include "app/widgets/paper-area.h"
#include "app/widgets/quantity-entry.h"
#include "app/widgets/row.h"
#include "app/widgets/shortened.h"

GtkBuilder *
qn_builder_new (const char *name)
{
  g_autofree char *path = g_strdup_printf ("/io/github/quoin/Quoin/%s.ui", name);
  g_type_ensure (QN_TYPE_PAPER_AREA);
  g_type_ensure (QN_TYPE_ROW);
  g_type_ensure (QN_TYPE_QUANTITY_ENTRY);
  GtkBuilder *builder = gtk_builder_new_from_resource (path);
  g_autoptr (GSList) objects = gtk_builder_get_objects (builder);
  for (GSList *each = objects; each != NULL; each = each->next)
    if (GTK_IS_LABEL (each->data) || GTK_IS_HEADER_BAR (each->data))
      qn_shortened_tell (each->data);
    else if (GTK_IS_SPIN_BUTTON (each->data))
      g_object_set (gtk_editable_get_delegate (each->data), "input-hints",
                    GTK_INPUT_HINT_NO_EMOJI, NULL);
    else if (GTK_IS_WINDOW (each->data))
      qn_dialog_attend (each->data);
  return builder;
}

GtkWidget *
qn_builder_get_widget (GtkBuilder *builder, const char *id)
{
  return GTK_WIDGET (gtk_builder_get_object (builder, id));
}

GtkWidget *
qn_builder_take_widget (GtkBuilder *builder, const char *id)
{
  GObject *taken = gtk_builder_get_object (builder, id);
  g_autoptr (GSList) objects = gtk_builder_get_objects (builder);
  for (GSList *each = objects; each != NULL; each = each->next)
    if (GTK_IS_WIDGET (each->data))
      g_object_set_data (taken, gtk_buildable_get_buildable_id (each->data), each->data);
  if (!GTK_IS_WINDOW (taken)) /* which GTK keeps */
    g_object_force_floating (g_object_ref (taken));
  return GTK_WIDGET (taken);
}

gpointer
qn_part (gpointer taken, const char *id)
{
  return g_object_get_data (taken, id);
}

static void
on_root (GtkWidget *widget, GParamSpec *pspec, GObject *group)
{
  const char *prefix = g_object_get_data (group, "qn-prefix");
  if (gtk_widget_get_root (widget) == NULL)
    return;
  gtk_widget_insert_action_group (widget, prefix, NULL);
  gtk_widget_insert_action_group (widget, prefix, G_ACTION_GROUP (group));
}

void
qn_actions_insert (GtkWidget *widget, const char *prefix, const GActionEntry *entries,
                   gsize count, gpointer data)
{
  GSimpleActionGroup *group = g_simple_action_group_new ();
  g_action_map_add_action_entries (G_ACTION_MAP (group), entries, (int) count, data);
  g_object_set_data (G_OBJECT (group), "qn-prefix", (gpointer) prefix);
  gtk_widget_insert_action_group (widget, prefix, G_ACTION_GROUP (group));
  g_signal_connect_object (widget, "notify::root", G_CALLBACK (on_root), group, 0);
  g_object_set_data_full (G_OBJECT (widget), QN_ACTIONS, group, g_object_unref);
}

void
qn_actions_enable (GtkWidget *widget, const char *name, gboolean enabled)
{
  GActionMap *group = g_object_get_data (G_OBJECT (widget), QN_ACTIONS);
  GAction *action = g_action_map_lookup_action (group, name);
  g_simple_action_set_enabled (G_SIMPLE_ACTION (action), enabled);
}

void
qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
          gpointer data)
{
  GClosure *closure = g_cclosure_new_swap (func, data, NULL);
  g_object_watch_closure (G_OBJECT (owner), closure);
  g_signal_connect_closure (object, signal, closure, FALSE);
}

void
qn_own (GtkWidget *owner, gpointer data)
{
  g_object_set_data_full (G_OBJECT (owner), "qn-owned", data, g_free);
}
