#include "app/forms/panel.h"
#include "app/widgets/build-tree.h"
#include "app/widgets/builder.h"
#include "app/widgets/preview.h"
#include "app/widgets/shortened.h"

#include "doc/document/document.h"
#include <string.h>

#define THUMBNAIL_WIDTH  200
#define THUMBNAIL_HEIGHT 130
#define MOST_RECENT      8

/* Folder of the examples, installed or of the source tree. */
static char *
dup_examples_folder (void)
{
  const char *given = g_getenv ("QUOIN_EXAMPLES");
  if (given != NULL)
    return g_strdup (given);
  g_autofree char *data = qn_build_tree_dup_folder ("data");
  g_autofree char *mark =
    data != NULL ? g_build_filename (data, "examples.path", NULL) : NULL;
  g_autofree char *path = NULL;
  if (mark != NULL && g_file_get_contents (mark, &path, NULL, NULL))
    return g_strdup (g_strstrip (path));
  return g_strdup (QN_EXAMPLES_DIR);
}

/* ---- thumbnails, drawn one by one while the window is idle ---- */

/* Of an area: the file that it shows. */
#define PATH "qn-path"

static void
draw_thumbnail (GtkDrawingArea *area, cairo_t *cr, int width, int height,
                gpointer surface)
{
  cairo_set_source_surface (cr, surface, 0.5 * (width - THUMBNAIL_WIDTH),
                            0.5 * (height - THUMBNAIL_HEIGHT));
  cairo_paint (cr);
}

static gboolean
on_idle (gpointer area)
{
  QnProject project;
  if (!qn_project_load (g_object_get_data (area, PATH), NULL, &project, NULL))
    return G_SOURCE_REMOVE;
  cairo_surface_t *surface =
    cairo_image_surface_create (CAIRO_FORMAT_RGB24, THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT);
  cairo_t *cr = cairo_create (surface);
  qn_preview_draw (&project.model, FALSE, cr, THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT, NULL);
  cairo_destroy (cr);
  qn_project_clear (&project);
  gtk_drawing_area_set_draw_func (area, draw_thumbnail, surface,
                                  (GDestroyNotify) cairo_surface_destroy);
  return G_SOURCE_REMOVE;
}

/* ---- page ---- */

static char *
dup_label (const char *path)
{
  g_autofree char *base = g_path_get_basename (path);
  char *dot = strrchr (base, '.');
  if (dot != NULL)
    *dot = '\0';
  for (char *c = base; *c != '\0'; c++) {
    if (*c == '-')
      *c = ' ';
  }
  return g_steal_pointer (&base);
}

static int
compare_paths (gconstpointer a, gconstpointer b)
{
  return strcmp (*(const char *const *) a, *(const char *const *) b);
}

static void
collect_examples (const char *folder, GPtrArray *paths, int depth)
{
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *name;
  while (dir != NULL && (name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL);
    if (g_str_has_suffix (name, ".quoin"))
      g_ptr_array_add (paths, g_steal_pointer (&path));
    else if (depth > 0 && g_file_test (path, G_FILE_TEST_IS_DIR))
      collect_examples (path, paths, depth - 1);
  }
}

static void
add_examples (GtkFlowBox *flow)
{
  g_autofree char *folder = dup_examples_folder ();
  g_autoptr (GPtrArray) paths = g_ptr_array_new_with_free_func (g_free);
  collect_examples (folder, paths, 1);
  g_ptr_array_sort (paths, compare_paths);
  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *name = dup_label (path);
    g_autoptr (GtkBuilder) builder = qn_builder_new ("start-rows");
    GtkWidget *button = qn_builder_take_widget (builder, "example");
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (builder, "example_name")),
                        name);
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", path);
    gtk_flow_box_insert (flow, button, -1);
    gtk_widget_set_focusable (gtk_widget_get_parent (button), FALSE);

    GObject *area = gtk_builder_get_object (builder, "picture");
    g_object_set_data_full (area, PATH, g_strdup (path), g_free);
    g_idle_add_full (G_PRIORITY_LOW, on_idle, g_object_ref (area), g_object_unref);
  }
}

GtkWidget *
qn_start_page_new (void)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("start-page");
  GtkWidget *recent = qn_builder_get_widget (builder, "recent");
  GList *items = gtk_recent_manager_get_items (gtk_recent_manager_get_default ());
  int shown = 0;
  for (GList *l = items; l != NULL && shown < MOST_RECENT; l = l->next) {
    g_autofree char *path =
      g_filename_from_uri (gtk_recent_info_get_uri (l->data), NULL, NULL);
    if (path == NULL || !g_str_has_suffix (path, ".quoin")
        || !g_file_test (path, G_FILE_TEST_EXISTS))
      continue;
    /* Name of the file, and where it is in fewer words. */
    g_autoptr (GtkBuilder) row = qn_builder_new ("start-rows");
    g_autofree char *name = dup_label (path), *place = qn_shortened_dup_folder (path);
    GtkWidget *button = qn_builder_take_widget (row, "recent");
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (row, "recent_name")), name);
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (row, "place")), place);
    gtk_widget_set_tooltip_text (button, path);
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", path);
    gtk_box_append (GTK_BOX (recent), button);
    shown++;
  }
  g_list_free_full (items, (GDestroyNotify) gtk_recent_info_unref);
  gtk_widget_set_visible (recent, shown > 0);
  gtk_widget_set_visible (qn_builder_get_widget (builder, "recent_title"), shown > 0);
  add_examples (GTK_FLOW_BOX (qn_builder_get_widget (builder, "examples")));
  return qn_builder_take_widget (builder, "page");
}
