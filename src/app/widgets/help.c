#include "app/widgets/help.h"

#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include <string.h>

#define RESOURCES "/io/github/quoin/Quoin/help/"
#define PAGE_KEY  "quoin-help-page"

/* px of a page that the list of pages leaves, as in help.ui. */
#define LEAST_PAGE 360

/* In the order of the manual's own list, docs/manual/README.md. */
static const char *const pages[] = {
  "first-wall",
  "openings",
  "drawing",
  "import",
  "joints",
  "contacts",
  "loads",
  "bridges",
  "frames",
  "walls",
  "multipliers",
  "procedures",
  "large-displacements",
  "earthquakes",
  "uncertainty",
  "results",
  "export",
  "command-line",
  "limits",
};

const char *
qn_help_find_page (GtkWidget *widget)
{
  for (; widget != NULL; widget = gtk_widget_get_parent (widget)) {
    const char *page = g_object_get_data (G_OBJECT (widget), PAGE_KEY);
    if (page != NULL)
      return page;
  }
  return NULL;
}

static gboolean
on_key (GtkWidget *window, GVariant *arguments, gpointer data)
{
  qn_help_show (GTK_WINDOW (window), qn_help_find_page (window));
  return TRUE;
}

void
qn_help_set_page (GtkWidget *widget, const char *page)
{
  gboolean has_key = g_object_get_data (G_OBJECT (widget), PAGE_KEY) != NULL;
  g_object_set_data (G_OBJECT (widget), PAGE_KEY, (gpointer) page);
  if (has_key || page == NULL || !GTK_IS_WINDOW (widget))
    return;
  GtkEventController *keys = gtk_shortcut_controller_new ();
  gtk_shortcut_controller_add_shortcut (
    GTK_SHORTCUT_CONTROLLER (keys),
    gtk_shortcut_new (gtk_keyval_trigger_new (GDK_KEY_F1, 0),
                      gtk_callback_action_new (on_key, NULL, NULL)));
  gtk_widget_add_controller (widget, keys);
}

/* ---- the pages in a window: Markdown as the manual uses it ---- */

static char *
dup_page_text (const char *name)
{
  const char *const *languages = g_get_language_names ();
  g_autoptr (GBytes) bytes = NULL;
  for (int i = 0; languages[i] != NULL && bytes == NULL; i++) {
    g_autofree char *path = g_strdup_printf (RESOURCES "%s/%s.md", languages[i], name);
    bytes = g_resources_lookup_data (path, 0, NULL);
  }
  g_autofree char *path = g_strdup_printf (RESOURCES "%s.md", name);
  if (bytes == NULL)
    bytes = g_resources_lookup_data (path, 0, NULL);
  gsize size = 0;
  const char *text = bytes != NULL ? g_bytes_get_data (bytes, &size) : "";
  return g_strndup (text, size);
}

/* Text without the marks of links, emphasis and code. */
static char *
dup_plain (const char *text)
{
  static const char *const marks[][2] = {
    { "!?\\[([^\\]]*)\\]\\([^)]*\\)", "\\1" },
    { "(?<![\\w`*])\\*{1,2}([^*`]+)\\*{1,2}", "\\1" },
    { "`", "" },
  };
  char *plain = g_strdup (text);
  for (gsize i = 0; i < G_N_ELEMENTS (marks); i++) {
    g_autoptr (GRegex) regex = g_regex_new (marks[i][0], 0, 0, NULL);
    char *next = g_regex_replace (regex, plain, -1, 0, marks[i][1], 0, NULL);
    g_free (plain);
    plain = next;
  }
  return plain;
}

static void
insert (GtkTextBuffer *buffer, const char *text, const char *tag)
{
  GtkTextIter end;
  gtk_text_buffer_get_end_iter (buffer, &end);
  if (tag == NULL)
    gtk_text_buffer_insert (buffer, &end, text, -1);
  else
    gtk_text_buffer_insert_with_tags_by_name (buffer, &end, text, -1, tag, NULL);
}

/* A row of a table: its cells one after the other. */
static void
insert_row (GtkTextBuffer *buffer, const char *line)
{
  g_autofree char *inner =
    g_strndup (line + 1, strlen (line) > 2 ? strlen (line) - 2 : 0);
  g_auto (GStrv) cells = g_strsplit (inner, " | ", -1);
  for (int i = 0; cells[i] != NULL; i++) {
    g_autofree char *cell = dup_plain (g_strstrip (cells[i]));
    insert (buffer, i > 0 ? " · " : "", NULL);
    insert (buffer, cell, i == 0 ? "bold" : NULL);
  }
  insert (buffer, "\n", NULL);
}

static GtkWidget *
make_page (const char *text, const char *title)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("help-page");
  GtkTextView *view = GTK_TEXT_VIEW (gtk_builder_get_object (builder, "view"));
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (view);
  gtk_accessible_update_property (GTK_ACCESSIBLE (view), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  title, -1);
  /* Lines of a paragraph belong together; an empty line, or a line of another kind, ends it. */
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_autoptr (GString) paragraph = g_string_new (NULL);
  gboolean code = FALSE;
  for (int i = 0; lines[i] != NULL; i++) {
    const char *line = lines[i];
    if (g_str_has_prefix (line, "```")) {
      code = !code;
    } else if (code || g_str_has_prefix (line, "    ")) {
      insert (buffer, line, "code");
      insert (buffer, "\n", NULL);
    } else if (line[0] == '#') {
      insert (buffer, strchr (line, ' ') + 1, line[1] == '#' ? "h2" : "h1");
      insert (buffer, "\n", NULL);
    } else if (line[0] == '|') {
      if (!g_str_has_prefix (line, "| ---"))
        insert_row (buffer, line);
    } else if (line[0] != '!' && line[0] != '<') {
      gboolean item = g_str_has_prefix (line, "- ");
      const char *next = lines[i + 1] != NULL ? lines[i + 1] : "";
      g_string_append_printf (paragraph, "%s%s", item ? "• " : "", line + 2 * item);
      if (line[0] != '\0' && next[0] != '\0'
          && !g_regex_match_simple ("^(- |[0-9]+\\. |\\||#|!|```)", next, 0, 0)) {
        g_string_append_c (paragraph, ' ');
        continue;
      }
      /* Links and emphasis may go on in the next line. */
      g_autofree char *plain = dup_plain (paragraph->str);
      insert (buffer, plain, NULL);
      insert (buffer, "\n", NULL);
      g_string_truncate (paragraph, 0);
    }
  }
  return qn_builder_take_widget (builder, "page");
}

/* ---- Yelp ---- */

static gboolean
is_installed (void)
{
  g_autoptr (GAppInfo) viewer = g_app_info_get_default_for_uri_scheme ("help");
  const char *const *folders = g_get_system_data_dirs ();
  for (int i = 0; viewer != NULL && folders[i] != NULL; i++) {
    g_autofree char *index =
      g_build_filename (folders[i], "help", "C", "quoin", "index.page", NULL);
    if (g_file_test (index, G_FILE_TEST_EXISTS))
      return TRUE;
  }
  return FALSE;
}

void
qn_help_show (GtkWindow *parent, const char *page)
{
  if (!is_installed ()) {
    g_autoptr (GtkBuilder) builder = qn_builder_new ("help");
    GtkStack *stack = GTK_STACK (gtk_builder_get_object (builder, "stack"));
    GtkWidget *sidebar = qn_builder_get_widget (builder, "sidebar");
    GtkWidget *window = qn_builder_get_widget (builder, "window");
    GtkPaned *content = GTK_PANED (gtk_builder_get_object (builder, "content"));
    for (gsize i = 0; i < G_N_ELEMENTS (pages); i++) {
      g_autofree char *text = dup_page_text (pages[i]);
      g_autofree char *title = g_strndup (text + 2, strcspn (text + 2, "\n"));
      gtk_stack_add_titled (stack, make_page (text, title), pages[i], title);
    }
    if (page != NULL)
      gtk_stack_set_visible_child_name (stack, page);
    int usual;
    gtk_widget_measure (sidebar, GTK_ORIENTATION_HORIZONTAL, -1, NULL, &usual, NULL,
                        NULL);
    gtk_paned_set_position (content, MIN (usual, 900 - LEAST_PAGE));
    qn_dialog_present (window, parent, page, sidebar);
    return;
  }
  g_autofree char *uri =
    page != NULL ? g_strconcat ("help:quoin/", page, NULL) : g_strdup ("help:quoin");
  g_app_info_launch_default_for_uri (uri, NULL, NULL);
}
