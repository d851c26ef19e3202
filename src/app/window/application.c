#include "app/window/application.h"

#include "app/dialogs/dialogs.h"
#include "app/widgets/help.h"
#include "app/widgets/settings.h"
#include "app/window/action-table.h"
#include "app/window/window.h"
#include "doc/document/recovery.h"
#include <glib/gi18n.h>

struct _QnApplication {
  GtkApplication parent_instance;
  gboolean recovery_offered;
};

G_DEFINE_FINAL_TYPE (QnApplication, qn_application, GTK_TYPE_APPLICATION)

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

static void
offer_recovery (QnApplication *self)
{
  if (self->recovery_offered)
    return;
  self->recovery_offered = TRUE;
  g_autoptr (GPtrArray) paths = qn_recovery_list ();
  for (guint i = 0; i < paths->len; i++)
    qn_window_open_with (find_host (self), g_ptr_array_index (paths, i),
                         qn_window_open_recovered);
}

static void
qn_application_activate (GApplication *application)
{
  QnApplication *self = QN_APPLICATION (application);
  offer_recovery (self);
  GtkWindow *window = active_window (application);
  if (window == NULL)
    window = GTK_WINDOW (qn_window_new (GTK_APPLICATION (application)));
  gtk_window_present (window);
}

static void
qn_application_open (GApplication *application, GFile **files, int count,
                     const char *hint)
{
  offer_recovery (QN_APPLICATION (application));
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
qn_application_window_removed (GtkApplication *application, GtkWindow *window)
{
  GTK_APPLICATION_CLASS (qn_application_parent_class)
    ->window_removed (application, window);
  if (QN_IS_WINDOW (window))
    qn_window_save_next (application);
}

static int
qn_application_handle_local_options (GApplication *application, GVariantDict *options)
{
  if (g_variant_dict_contains (options, "version")) {
    g_print ("quoin %s\n", QN_VERSION);
    return 0;
  }
  if (g_variant_dict_contains (options, "new-window")) {
    if (!g_application_register (application, NULL, NULL))
      return 1;
    g_action_group_activate_action (G_ACTION_GROUP (application), "new-window", NULL);
    return g_application_get_is_remote (application) ? 0 : -1;
  }
  return -1;
}

static void
qn_application_startup (GApplication *application)
{
  static const GActionEntry actions[] = {
    { .name = "new-window", .activate = on_new_window },
    { .name = "preferences", .activate = on_preferences },
    { .name = "about", .activate = on_about },
    { .name = "help", .activate = on_help },
    { .name = "quit", .activate = on_quit },
  };
  G_APPLICATION_CLASS (qn_application_parent_class)->startup (application);
  g_action_map_add_action_entries (G_ACTION_MAP (application), actions,
                                   G_N_ELEMENTS (actions), application);
  gtk_window_set_default_icon_name ("io.github.quoin.Quoin");
  /* Choosers of files have title bars like the windows. */
  g_object_set (gtk_settings_get_default (), "gtk-dialogs-use-header", TRUE, NULL);
  qn_settings_apply_style ();
  g_autoptr (GtkCssProvider) provider = gtk_css_provider_new ();
  gtk_css_provider_load_from_resource (provider, "/io/github/quoin/Quoin/style.css");
  gtk_style_context_add_provider_for_display (gdk_display_get_default (),
                                              GTK_STYLE_PROVIDER (provider),
                                              GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
  qn_action_add_accelerators (GTK_APPLICATION (application));
}

static void
qn_application_class_init (QnApplicationClass *klass)
{
  GApplicationClass *application_class = G_APPLICATION_CLASS (klass);
  application_class->activate = qn_application_activate;
  application_class->open = qn_application_open;
  application_class->startup = qn_application_startup;
  GTK_APPLICATION_CLASS (klass)->window_removed = qn_application_window_removed;
  application_class->handle_local_options = qn_application_handle_local_options;
}

static void
qn_application_init (QnApplication *self)
{
  const GOptionEntry options[] = {
    { "new-window", 'w', 0, G_OPTION_ARG_NONE, NULL, N_ ("Open a new window"), NULL },
    { "version", 0, 0, G_OPTION_ARG_NONE, NULL, N_ ("Show the version"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_application_add_main_option_entries (G_APPLICATION (self), options);
}

QnApplication *
qn_application_new (void)
{
  return g_object_new (QN_TYPE_APPLICATION, "application-id", "io.github.quoin.Quoin",
                       "flags", G_APPLICATION_HANDLES_OPEN, "resource-base-path",
                       "/io/github/quoin/Quoin", NULL);
}
