#include "app/window/application.h"

#include "app/dialogs/dialogs.h"
#include "app/widgets/help.h"
#include "app/widgets/settings.h"
#include "app/window/action-table.h"
#include "app/window/window.h"
#include "doc/document/recovery.h"
#include <glib/gi18n.h>

/* ---- actions of the program ---- */

static GtkWindow *
active_window (gpointer application)
{
  return gtk_application_get_active_window (GTK_APPLICATION (application));
}

static void
on_new_window (GSimpleAction *action, GVariant *parameter, gpointer application)
{
  QnWindow *window = qn_window_new (GTK_APPLICATION (application));
  gtk_window_present (GTK_WINDOW (window));
}

static void
on_preferences (GSimpleAction *action, GVariant *parameter, gpointer application)
{
  qn_preferences_show (active_window (application));
}

static void
on_about (GSimpleAction *action, GVariant *parameter, gpointer application)
{
  qn_about_show (active_window (application));
}

static void
on_help (GSimpleAction *action, GVariant *parameter, gpointer application)
{
  GtkWindow *window = active_window (application);
  GtkWidget *focus = window != NULL ? gtk_window_get_focus (window) : NULL;
  qn_help_show (window, QN_IS_WINDOW (window)
                          ? qn_window_get_help_page (QN_WINDOW (window))
                          : qn_help_find_page (focus));
}

static void
on_quit (GSimpleAction *action, GVariant *parameter, gpointer application)
{
  qn_window_quit (application);
}

/* ---- life ---- */

/* The window that is to open a file, or to say why it does not. */
static QnWindow *
find_host (gpointer application)
{
  for (GList *l = gtk_application_get_windows (application); l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data))
      return l->data;
  return qn_window_new (application);
}

/* Once. */
static void
offer_recovery (gpointer application)
{
  static gboolean offered;
  g_autoptr (GPtrArray) paths = offered ? g_ptr_array_new () : qn_recovery_list ();
  offered = TRUE;
  for (guint i = 0; i < paths->len; i++)
    qn_window_open_with (find_host (application), g_ptr_array_index (paths, i),
                         qn_window_open_recovered);
}

static void
on_activate (GApplication *application)
{
  offer_recovery (application);
  gtk_window_present (active_window (application) != NULL
                        ? active_window (application)
                        : GTK_WINDOW (qn_window_new (GTK_APPLICATION (application))));
}

static void
on_open (GApplication *application, GFile **files, int count)
{
  offer_recovery (application);
  for (int i = 0; i < count; i++) {
    g_autofree char *path = g_file_get_path (files[i]);
    QnWindow *window = find_host (application);
    if (path != NULL) {
      qn_window_open (window, path);
      continue;
    }
    gtk_window_present (GTK_WINDOW (window));
    qn_window_show_error (window, _ ("Only local files can be opened"));
  }
}

static void
on_window_removed (GtkApplication *application, GtkWindow *window)
{
  if (QN_IS_WINDOW (window))
    qn_window_save_next (application);
}

static int
on_local_options (GApplication *application, GVariantDict *options)
{
  if (g_variant_dict_contains (options, "version")) {
    g_print ("quoin %s\n", QN_VERSION);
    return 0;
  }
  if (!g_variant_dict_contains (options, "new-window"))
    return -1;
  if (!g_application_register (application, NULL, NULL))
    return 1;
  g_action_group_activate_action (G_ACTION_GROUP (application), "new-window", NULL);
  return g_application_get_is_remote (application) ? 0 : -1;
}

/* After GTK's own, which opens the display. */
static void
on_startup (GtkApplication *application)
{
  gtk_window_set_default_icon_name ("io.github.quoin.Quoin");
  /* Choosers of files have title bars like the windows. */
  g_object_set (gtk_settings_get_default (), "gtk-dialogs-use-header", TRUE, NULL);
  qn_settings_apply_style ();
  g_autoptr (GtkCssProvider) provider = gtk_css_provider_new ();
  gtk_css_provider_load_from_resource (provider, "/io/github/quoin/Quoin/style.css");
  gtk_style_context_add_provider_for_display (gdk_display_get_default (),
                                              GTK_STYLE_PROVIDER (provider),
                                              GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
  qn_action_add_accelerators (application);
}

GtkApplication *
qn_application_new (void)
{
  static const GActionEntry actions[] = {
    { .name = "new-window", .activate = on_new_window },
    { .name = "preferences", .activate = on_preferences },
    { .name = "about", .activate = on_about },
    { .name = "help", .activate = on_help },
    { .name = "quit", .activate = on_quit },
  };
  static const GOptionEntry options[] = {
    { "new-window", 'w', 0, G_OPTION_ARG_NONE, NULL, N_ ("Open a new window"), NULL },
    { "version", 0, 0, G_OPTION_ARG_NONE, NULL, N_ ("Show the version"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  GtkApplication *self =
    gtk_application_new ("io.github.quoin.Quoin", G_APPLICATION_HANDLES_OPEN);
  g_application_set_resource_base_path (G_APPLICATION (self), "/io/github/quoin/Quoin");
  g_application_add_main_option_entries (G_APPLICATION (self), options);
  g_action_map_add_action_entries (G_ACTION_MAP (self), actions, G_N_ELEMENTS (actions),
                                   self);
  g_signal_connect (self, "activate", G_CALLBACK (on_activate), NULL);
  g_signal_connect (self, "open", G_CALLBACK (on_open), NULL);
  g_signal_connect_after (self, "startup", G_CALLBACK (on_startup), NULL);
  g_signal_connect_after (self, "window-removed", G_CALLBACK (on_window_removed), NULL);
  g_signal_connect (self, "handle-local-options", G_CALLBACK (on_local_options), NULL);
  return self;
}
