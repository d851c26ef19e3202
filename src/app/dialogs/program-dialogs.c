/* Dialogs of the program: preferences, about, help. */
#include "app/dialogs/dialogs.h"

#include "app/forms/bound-form.h"
#include "app/widgets/dialog.h"
#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <string.h>

/* ---- preferences ---- */

/* Ids are the keys of the settings. */
static const QnFormField fields[] = {
  { .id = "style" },       { .id = "reduced-motion" }, { .id = "animation-period" },
  { .id = "length-unit" }, { .id = "force-unit" },     { .id = "stress-unit" },
  { .id = "snap" },        { .id = "grid" },           { .id = "engine" },
  { .id = "live" },        { .id = "live-limit" },
};

static gboolean
look (gpointer form)
{
  (void) form;
  return TRUE;
}

static gboolean
show (gpointer form, guint field, QnValue *value)
{
  GSettings *settings = qn_settings_get ();
  const char *key = fields[field].id;
  g_autoptr (GVariant) kept = g_settings_get_value (settings, key);
  (void) form;
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
take (gpointer form, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  GSettings *settings = qn_settings_get ();
  const char *key = fields[field].id;
  g_autoptr (GVariant) kept = g_settings_get_value (settings, key);
  (void) form;
  (void) draft;
  (void) error;
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
  static const QnFormKind kind = QN_FORM_KIND ("preferences", QnBoundForm, 0);
  GtkWidget *window = qn_bound_form_show (qn_bound_form_new (&kind, NULL));
  gtk_window_set_transient_for (GTK_WINDOW (window), parent);
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

/* ---- help: pages of the resources, headings marked by "# " and "## " ---- */

static const struct {
  const char *name;
  const char *title;
} pages[] = {
  { "tutorial", N_ ("Tutorial") },
  { "reference", N_ ("Reference") },
  { "theory", N_ ("Theory and limits") },
};

static GBytes *
load_page (const char *name)
{
  const char *const *languages = g_get_language_names ();
  for (int i = 0; languages[i] != NULL; i++) {
    g_autofree char *path =
      g_strdup_printf ("/io/github/quoin/Quoin/help/%s.%s.txt", name, languages[i]);
    GBytes *bytes = g_resources_lookup_data (path, 0, NULL);
    if (bytes != NULL)
      return bytes;
  }
  g_autofree char *path = g_strdup_printf ("/io/github/quoin/Quoin/help/%s.txt", name);
  return g_resources_lookup_data (path, 0, NULL);
}

static GtkWidget *
make_page (const char *name, const char *title)
{
  g_autoptr (GBytes) bytes = load_page (name);
  GtkWidget *view = gtk_text_view_new ();
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (GTK_TEXT_VIEW (view));
  gtk_accessible_update_property (GTK_ACCESSIBLE (view), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  title, -1);
  gtk_text_buffer_create_tag (buffer, "h1", "scale", 1.6, "weight", PANGO_WEIGHT_BOLD,
                              NULL);
  gtk_text_buffer_create_tag (buffer, "h2", "scale", 1.2, "weight", PANGO_WEIGHT_BOLD,
                              NULL);
  gsize size = 0;
  const char *text = bytes != NULL ? g_bytes_get_data (bytes, &size) : "";
  g_autofree char *copy = g_strndup (text, size);
  g_auto (GStrv) lines = g_strsplit (copy, "\n", -1);
  GtkTextIter end;
  for (int i = 0; lines[i] != NULL; i++) {
    const char *line = lines[i];
    const char *tag = g_str_has_prefix (line, "## ")  ? "h2"
                      : g_str_has_prefix (line, "# ") ? "h1"
                                                      : NULL;
    gtk_text_buffer_get_end_iter (buffer, &end);
    if (tag != NULL)
      gtk_text_buffer_insert_with_tags_by_name (buffer, &end, strchr (line, ' ') + 1, -1,
                                                tag, NULL);
    else
      gtk_text_buffer_insert (buffer, &end, line, -1);
    gtk_text_buffer_get_end_iter (buffer, &end);
    gtk_text_buffer_insert (buffer, &end, "\n", 1);
  }
  gtk_text_view_set_editable (GTK_TEXT_VIEW (view), FALSE);
  gtk_text_view_set_cursor_visible (GTK_TEXT_VIEW (view), FALSE);
  gtk_text_view_set_wrap_mode (GTK_TEXT_VIEW (view), GTK_WRAP_WORD);
  gtk_text_view_set_left_margin (GTK_TEXT_VIEW (view), 24);
  gtk_text_view_set_right_margin (GTK_TEXT_VIEW (view), 24);
  gtk_text_view_set_top_margin (GTK_TEXT_VIEW (view), 18);
  gtk_text_view_set_bottom_margin (GTK_TEXT_VIEW (view), 18);
  gtk_text_view_set_pixels_inside_wrap (GTK_TEXT_VIEW (view), 3);
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), view);
  return scroller;
}

void
qn_help_show (GtkWindow *parent, const char *page)
{
  GtkWidget *stack = gtk_stack_new ();
  for (gsize i = 0; i < G_N_ELEMENTS (pages); i++)
    gtk_stack_add_titled (GTK_STACK (stack),
                          make_page (pages[i].name, _ (pages[i].title)), pages[i].name,
                          _ (pages[i].title));
  if (page != NULL)
    gtk_stack_set_visible_child_name (GTK_STACK (stack), page);
  GtkWidget *switcher = gtk_stack_switcher_new ();
  gtk_stack_switcher_set_stack (GTK_STACK_SWITCHER (switcher), GTK_STACK (stack));
  GtkWidget *header = gtk_header_bar_new ();
  gtk_header_bar_set_title_widget (GTK_HEADER_BAR (header), switcher);

  /* One works while reading. */
  GtkWidget *window = qn_dialog_new (parent, _ ("Help"), 680, 720);
  gtk_window_set_modal (GTK_WINDOW (window), FALSE);
  gtk_window_set_titlebar (GTK_WINDOW (window), header);
  gtk_window_set_child (GTK_WINDOW (window), stack);
  gtk_window_present (GTK_WINDOW (window));
}
