/* Dialogs of the program: preferences, about, help. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/dialog.h"
#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <string.h>

/* ---- preferences ---- */

static void
on_enum_choice (GtkDropDown *choice, GParamSpec *pspec, const char *key)
{
  (void) pspec;
  g_settings_set_enum (qn_settings_get (), key,
                       (int) gtk_drop_down_get_selected (choice));
}

static void
add_enum (GtkWidget *form, const char *label, const char *key, const char *const *choices)
{
  GtkDropDown *choice = qn_form_add_choice (form, label, choices,
                                            G_CALLBACK (on_enum_choice), (gpointer) key);
  qn_form_set_choice (choice, (guint) g_settings_get_enum (qn_settings_get (), key),
                      (gpointer) key);
}

static void
add_switch (GtkWidget *form, const char *label, const char *key)
{
  GtkWidget *field = gtk_switch_new ();
  gtk_widget_set_valign (field, GTK_ALIGN_CENTER);
  g_settings_bind (qn_settings_get (), key, field, "active", G_SETTINGS_BIND_DEFAULT);
  qn_form_add_row (form, label, field);
  gtk_widget_set_halign (field, GTK_ALIGN_END);
}

static void
add_spin (GtkWidget *form, const char *label, const char *key, double least, double most,
          double step, guint digits)
{
  GtkWidget *field = gtk_spin_button_new_with_range (least, most, step);
  gtk_spin_button_set_digits (GTK_SPIN_BUTTON (field), digits);
  g_settings_bind (qn_settings_get (), key, field, "value", G_SETTINGS_BIND_DEFAULT);
  qn_form_add_row (form, label, field);
}

void
qn_preferences_show (GtkWindow *parent)
{
  const char *const styles[] = { _ ("As the desktop"), _ ("Light"), _ ("Dark"), NULL };
  const char *const lengths[] = { "m", "cm", "mm", NULL };
  const char *const forces[] = { "N", "kN", NULL };
  const char *const stresses[] = { "Pa", "kPa", "MPa", NULL };
  const char *const engines[] = { _ ("Automatic"), "Cairo", "OpenGL", NULL };
  GtkWidget *form = qn_form_new ();
  qn_form_add_heading (form, _ ("Appearance"));
  add_enum (form, _ ("_Style"), "style", styles);
  add_switch (form, _ ("_Reduced motion"), "reduced-motion");
  add_spin (form, _ ("Seconds from rest to the _largest motion"), "animation-period", 0.5,
            20.0, 0.5, 1);
  qn_form_add_heading (form, _ ("Units"));
  add_enum (form, _ ("L_ength"), "length-unit", lengths);
  add_enum (form, _ ("_Force"), "force-unit", forces);
  add_enum (form, _ ("St_ress"), "stress-unit", stresses);
  qn_form_add_heading (form, _ ("Drawing"));
  add_switch (form, _ ("S_nap to corners, edges, courses and grid"), "snap");
  add_switch (form, _ ("Show the _grid"), "grid");
  add_enum (form, _ ("Structures are _drawn by"), "engine", engines);
  qn_form_add_heading (form, _ ("Analysis"));
  add_switch (form, _ ("Solve again after each _edit"), "live");
  add_spin (form, _ ("…for models up to this many _blocks"), "live-limit", 1.0, 5000.0,
            10.0, 0);

  GtkWidget *window = qn_dialog_new (parent, _ ("Preferences"), 460, -1);
  gtk_window_set_child (GTK_WINDOW (window), form);
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
