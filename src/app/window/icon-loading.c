#include <dlfcn.h>
#include <gtk/gtk.h>

typedef void (*Run) (GTask *task, GTaskThreadFunc function);

/* Stands in front of GLib's function in the whole program: icons are loaded at once, everything else in a
 * thread as usual. GTK 4.8 loads each icon in a thread. Where the widget lets go of the icon before that,
 * the thread frees it while a window may be finding it in GTK's cache, and the program crashes. */
void
g_task_run_in_thread (GTask *task, GTaskThreadFunc function)
{
  gpointer source = g_task_get_source_object (task);
  if (source != NULL && GTK_IS_ICON_PAINTABLE (source)) {
    function (task, source, g_task_get_task_data (task), g_task_get_cancellable (task));
    return;
  }
  Run run;
  *(void **) &run = dlsym (RTLD_NEXT, "g_task_run_in_thread");
  run (task, function);
}
