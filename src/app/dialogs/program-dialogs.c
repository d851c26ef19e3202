/* Dialogs of the program: preferences, about. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/help.h"
#include "app/widgets/settings.h"
#include <glib/gi18n.h>

/* ---- preferences ---- */

/* Ids are the keys of the settings. */
static const QnFormField fields[] = {
  { .id = "style" },       { .id = "reduced-motion" }, { .id = "animation-period" },
  { .id = "length-unit" }, { .id = "force-unit" },     { .id = "stress-unit" },
  { .id = "snap" },        { .id = "grid" },           { .id = "engine" },
  { .id = "live" },        { .id = "live-limit" },
};

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  GSettings *settings = qn_settings_get ();
  const char *key = fields[field].id;
  g_autoptr (GVariant) kept = g_settings_get_value (settings, key);
  if (g_variant_is_of_type (kept, G_VARIANT_TYPE_STRING))
    value->number = g_settings_get_enum (settings, key);
  else if (g_variant_is_of_type (kept, G_VARIANT_TYPE_BOOLEAN))
    value->number = g_variant_get_boolean (kept);
  else if (g_variant_is_of_type (kept, G_VARIANT_TYPE_INT32))
    value->number = g_variant_get_int32 (kept);
  else
    value->number = g_variant_get_double (kept);
  return TRUE;
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  GSettings *settings = qn_settings_get ();
  const char *key = fields[field].id;
  g_autoptr (GVariant) kept = g_settings_get_value (settings, key);
  if (g_variant_is_of_type (kept, G_VARIANT_TYPE_STRING))
    return g_settings_set_enum (settings, key, (int) value->number);
  if (g_variant_is_of_type (kept, G_VARIANT_TYPE_BOOLEAN))
    return g_settings_set_boolean (settings, key, value->number != 0.0);
  if (g_variant_is_of_type (kept, G_VARIANT_TYPE_INT32))
    return g_settings_set_int (settings, key, (int) value->number);
  return g_settings_set_double (settings, key, value->number);
}

void
qn_preferences_show (GtkWindow *parent)
{
  static const QnFormKind kind = QN_FORM_KIND ("preferences", QnForm, .look = NULL);
  GtkWidget *window = qn_form_show (qn_form_new (&kind, NULL));
  gtk_window_set_transient_for (GTK_WINDOW (window), parent);
  qn_help_set_page (window, "drawing");
  gtk_window_present (GTK_WINDOW (window));
}

void
qn_about_show (GtkWindow *parent)
{
  const char *const authors[] = { _ ("The Quoin developers"), NULL };
  gtk_show_about_dialog (parent, "program-name", "Quoin", "version", QN_VERSION,
                         "logo-icon-name", "io.github.quoin.Quoin", "comments",
                         _ ("A workbench for block masonry: draw a wall, find how and at "
                            "what load it collapses."),
                         "license-type", GTK_LICENSE_GPL_3_0, "authors", authors,
                         "translator-credits", _ ("translator-credits"), NULL);
}
