#include "app/forms/form.h"

void
qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
          gpointer data)
{
  GClosure *closure = g_cclosure_new_swap (func, data, NULL);
  g_object_watch_closure (G_OBJECT (owner), closure);
  g_signal_connect_closure (object, signal, closure, FALSE);
}

static void
on_owner_gone (gpointer data, GObject *where)
{
  g_free (data);
}

void
qn_own (GtkWidget *owner, gpointer data)
{
  g_object_weak_ref (G_OBJECT (owner), on_owner_gone, data);
}
