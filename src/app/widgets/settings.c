#include "app/widgets/settings.h"

#include "app/widgets/build-tree.h"

#include <glib/gi18n.h>
#include <gtk/gtk.h>
#include <stdlib.h>

#define SCHEMA_ID "io.github.quoin.Quoin"

enum { STYLE_SYSTEM, STYLE_LIGHT, STYLE_DARK };

/* The schema of the build tree for a program that is run there, else the installed one. */
static GSettingsSchema *
find_schema (void)
{
  GSettingsSchemaSource *installed = g_settings_schema_source_get_default ();
  g_autofree char *data = qn_build_tree_dup_folder ("data");
  g_autoptr (GSettingsSchemaSource) built =
    data != NULL
      ? g_settings_schema_source_new_from_directory (data, installed, TRUE, NULL)
      : NULL;
  GSettingsSchemaSource *source = built != NULL ? built : installed;
  return source != NULL ? g_settings_schema_source_lookup (source, SCHEMA_ID, TRUE)
                        : NULL;
}

GSettings *
qn_settings_get (void)
{
  static GSettings *settings;
  if (settings != NULL)
    return settings;
  g_autoptr (GSettingsSchema) schema = find_schema ();
  if (schema == NULL) {
    g_printerr (
      _ ("quoin: the settings schema %s is missing; install the program, or build "
         "all of it\n"),
      SCHEMA_ID);
    exit (EXIT_FAILURE);
  }
  settings = g_settings_new_full (schema, NULL, NULL);
  return settings;
}

QnUnits
qn_settings_get_units (void)
{
  GSettings *settings = qn_settings_get ();
  return (QnUnits){ (QnLengthUnit) g_settings_get_enum (settings, "length-unit"),
                    (QnForceUnit) g_settings_get_enum (settings, "force-unit"),
                    (QnStressUnit) g_settings_get_enum (settings, "stress-unit") };
}

static gboolean system_is_dark;

static void
update_style (void)
{
  GtkSettings *gtk = gtk_settings_get_default ();
  int style = g_settings_get_enum (qn_settings_get (), "style");
  if (gtk == NULL)
    return;
  gboolean dark = style == STYLE_DARK || (style == STYLE_SYSTEM && system_is_dark);
  g_object_set (gtk, "gtk-application-prefer-dark-theme", dark, NULL);
}

static void
take_color_scheme (GVariant *value)
{
  if (g_variant_is_of_type (value, G_VARIANT_TYPE_VARIANT)) {
    g_autoptr (GVariant) inner = g_variant_get_variant (value);
    take_color_scheme (inner);
  }
  if (g_variant_is_of_type (value, G_VARIANT_TYPE_UINT32)) {
    system_is_dark = g_variant_get_uint32 (value) == 1; /* 1: prefers dark */
    update_style ();
  }
}

static void
on_portal_signal (GDBusProxy *proxy, const char *sender, const char *signal,
                  GVariant *parameters, gpointer data)
{
  const char *name_space = NULL, *key = NULL;
  g_autoptr (GVariant) value = NULL;
  g_variant_get (parameters, "(&s&sv)", &name_space, &key, &value);
  if (g_str_equal (name_space, "org.freedesktop.appearance")
      && g_str_equal (key, "color-scheme"))
    take_color_scheme (value);
}

static void
on_color_scheme_read (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (GVariant) reply =
    g_dbus_proxy_call_finish (G_DBUS_PROXY (source), result, NULL);
  if (reply == NULL)
    return;
  g_autoptr (GVariant) value = g_variant_get_child_value (reply, 0);
  take_color_scheme (value);
}

/* Desktops tell their preference through the settings portal; without one windows are light.
 * The proxy lives as long as the program. */
static void
on_portal_ready (GObject *source, GAsyncResult *result, gpointer data)
{
  GDBusProxy *proxy = g_dbus_proxy_new_for_bus_finish (result, NULL);
  if (proxy == NULL)
    return;
  g_signal_connect (proxy, "g-signal::SettingChanged", G_CALLBACK (on_portal_signal),
                    NULL);
  g_dbus_proxy_call (proxy, "Read",
                     g_variant_new ("(ss)", "org.freedesktop.appearance", "color-scheme"),
                     G_DBUS_CALL_FLAGS_NONE, 500, NULL, on_color_scheme_read, NULL);
}

void
qn_settings_apply_style (void)
{
  g_signal_connect (qn_settings_get (), "changed::style", G_CALLBACK (update_style),
                    NULL);
  update_style ();
  g_dbus_proxy_new_for_bus (
    G_BUS_TYPE_SESSION, G_DBUS_PROXY_FLAGS_DO_NOT_LOAD_PROPERTIES, NULL,
    "org.freedesktop.portal.Desktop", "/org/freedesktop/portal/desktop",
    "org.freedesktop.portal.Settings", NULL, on_portal_ready, NULL);
}

gboolean
qn_settings_reduced_motion (void)
{
  gboolean animations = TRUE;
  GtkSettings *gtk = gtk_settings_get_default ();
  if (gtk != NULL)
    g_object_get (gtk, "gtk-enable-animations", &animations, NULL);
  return !animations || g_settings_get_boolean (qn_settings_get (), "reduced-motion");
}
