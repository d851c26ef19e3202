#include "app/views/start-page.h"

#include "app/widgets/build-tree.h"
#include "app/widgets/shortened.h"

#include "doc/document/document.h"
#include "render/backend/draw-cairo.h"
#include "render/scene/scene-build.h"
#include <glib/gi18n.h>
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

typedef struct Thumbnail {
  GtkPicture *picture;
  char *path;
} Thumbnail;

static void
thumbnail_free (gpointer data)
{
  Thumbnail *thumbnail = data;
  g_object_unref (thumbnail->picture);
  g_free (thumbnail->path);
  g_free (thumbnail);
}

static cairo_surface_t *
draw_model (const QnModel *model)
{
  QnContacts contacts = { 0 };
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.loads = false;
  options.dimensions = false;
  QnScene *scene = qn_scene_build (model, &contacts, NULL, &options, NULL);
  if (scene == NULL)
    return NULL;
  cairo_surface_t *surface =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT);
  cairo_t *cr = cairo_create (surface);
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  QnCamera camera = {
    .width = THUMBNAIL_WIDTH, .height = THUMBNAIL_HEIGHT, .scale = 1.0, .unit = 0.8
  };
  qn_camera_fit (&camera, scene->box, 10.0);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, true, cr, NULL);
  cairo_destroy (cr);
  qn_scene_free (scene);
  return surface;
}

static gboolean
on_idle (gpointer data)
{
  const Thumbnail *thumbnail = data;
  QnProject project;
  if (!qn_project_load (thumbnail->path, NULL, &project, NULL))
    return G_SOURCE_REMOVE;
  cairo_surface_t *surface = draw_model (&project.model);
  qn_project_clear (&project);
  if (surface == NULL)
    return G_SOURCE_REMOVE;
  gsize stride = (gsize) cairo_image_surface_get_stride (surface);
  g_autoptr (GBytes) bytes =
    g_bytes_new (cairo_image_surface_get_data (surface), stride * THUMBNAIL_HEIGHT);
  g_autoptr (GdkTexture) texture = gdk_memory_texture_new (
    THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT, GDK_MEMORY_DEFAULT, bytes, stride);
  gtk_picture_set_paintable (thumbnail->picture, GDK_PAINTABLE (texture));
  cairo_surface_destroy (surface);
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
let_wrap (GtkWidget *label)
{
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_justify (GTK_LABEL (label), GTK_JUSTIFY_CENTER);
}

static GtkWidget *
make_heading (const char *text)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_widget_add_css_class (label, "title-4");
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_widget_set_margin_top (label, 18);
  return label;
}

static GtkWidget *
make_action_button (const char *label, const char *action, gboolean suggested)
{
  GtkWidget *button = gtk_button_new_with_mnemonic (label);
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), action);
  gtk_widget_add_css_class (button, "pill");
  if (suggested)
    gtk_widget_add_css_class (button, "suggested-action");
  return button;
}

static GtkWidget *
make_examples (void)
{
  GtkWidget *flow = gtk_flow_box_new ();
  gtk_flow_box_set_selection_mode (GTK_FLOW_BOX (flow), GTK_SELECTION_NONE);
  gtk_flow_box_set_max_children_per_line (GTK_FLOW_BOX (flow), 6);
  gtk_flow_box_set_min_children_per_line (GTK_FLOW_BOX (flow), 1);
  gtk_flow_box_set_homogeneous (GTK_FLOW_BOX (flow), TRUE);
  g_autofree char *folder = dup_examples_folder ();
  g_autoptr (GPtrArray) paths = g_ptr_array_new_with_free_func (g_free);
  collect_examples (folder, paths, 1);
  g_ptr_array_sort (paths, compare_paths);
  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    GtkWidget *button = gtk_button_new (),
              *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *picture = gtk_picture_new ();
    gtk_widget_set_size_request (picture, THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT);
    gtk_widget_add_css_class (picture, "thumbnail");
    g_autofree char *label = dup_label (path);
    gtk_box_append (GTK_BOX (box), picture);
    gtk_box_append (GTK_BOX (box), gtk_label_new (label));
    gtk_button_set_child (GTK_BUTTON (button), box);
    gtk_widget_add_css_class (button, "flat");
    gtk_widget_set_tooltip_text (button, _ ("Open a copy of this example"));
    gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.open-example");
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", path);
    gtk_flow_box_insert (GTK_FLOW_BOX (flow), button, -1);
    GtkWidget *cell = gtk_widget_get_parent (button);
    gtk_widget_set_focusable (cell, FALSE);

    Thumbnail *thumbnail = g_new (Thumbnail, 1);
    *thumbnail = (Thumbnail){ g_object_ref (GTK_PICTURE (picture)), g_strdup (path) };
    g_idle_add_full (G_PRIORITY_LOW, on_idle, thumbnail, thumbnail_free);
  }
  return flow;
}

/* Name of a file, and where it is in fewer words. */
static GtkWidget *
make_recent (const char *path)
{
  g_autofree char *name = dup_label (path), *place = qn_shortened_dup_folder (path);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 12);
  GtkWidget *label = gtk_label_new (place);
  gtk_label_set_ellipsize (GTK_LABEL (label), PANGO_ELLIPSIZE_START);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 40);
  gtk_widget_add_css_class (label, "dim-label");
  gtk_box_append (GTK_BOX (box), gtk_label_new (name));
  gtk_box_append (GTK_BOX (box), label);
  return box;
}

GtkWidget *
qn_start_page_new (void)
{
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 12);
  gtk_widget_set_margin_start (box, 36);
  gtk_widget_set_margin_end (box, 36);
  gtk_widget_set_margin_bottom (box, 36);
  GtkWidget *image = gtk_image_new_from_icon_name ("io.github.quoin.Quoin");
  gtk_image_set_pixel_size (GTK_IMAGE (image), 96);
  gtk_widget_set_margin_top (image, 36);
  GtkWidget *title = gtk_label_new (_ ("How does it stand, and how would it fall?"));
  gtk_widget_add_css_class (title, "title-2");
  let_wrap (title);
  GtkWidget *buttons = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 12);
  gtk_widget_set_halign (buttons, GTK_ALIGN_CENTER);
  gtk_box_append (GTK_BOX (buttons),
                  make_action_button (_ ("_New Drawing"), "win.draw", TRUE));
  gtk_box_append (GTK_BOX (buttons),
                  make_action_button (_ ("_Open…"), "win.open", FALSE));
  GtkWidget *hint =
    gtk_label_new (_ ("Or drop a project, a DXF drawing or a picture here"));
  gtk_widget_add_css_class (hint, "dim-label");
  let_wrap (hint);

  GtkWidget *parts[] = { image, title, buttons, hint };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++)
    gtk_box_append (GTK_BOX (box), parts[i]);
  GtkRecentManager *manager = gtk_recent_manager_get_default ();
  GList *items = gtk_recent_manager_get_items (manager);
  int shown = 0;
  for (GList *l = items; l != NULL && shown < MOST_RECENT; l = l->next) {
    GtkRecentInfo *info = l->data;
    g_autofree char *path =
      g_filename_from_uri (gtk_recent_info_get_uri (info), NULL, NULL);
    if (path == NULL || !g_str_has_suffix (path, ".quoin")
        || !g_file_test (path, G_FILE_TEST_EXISTS))
      continue;
    if (shown++ == 0)
      gtk_box_append (GTK_BOX (box), make_heading (_ ("Recent")));
    GtkWidget *button = gtk_button_new ();
    gtk_button_set_child (GTK_BUTTON (button), make_recent (path));
    gtk_widget_set_tooltip_text (button, path);
    gtk_widget_add_css_class (button, "flat");
    gtk_widget_set_halign (button, GTK_ALIGN_START);
    gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.open-path");
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", path);
    gtk_box_append (GTK_BOX (box), button);
  }
  g_list_free_full (items, (GDestroyNotify) gtk_recent_info_unref);
  gtk_box_append (GTK_BOX (box), make_heading (_ ("Examples")));
  gtk_box_append (GTK_BOX (box), make_examples ());

  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_policy (GTK_SCROLLED_WINDOW (scroller), GTK_POLICY_NEVER,
                                  GTK_POLICY_AUTOMATIC);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), box);
  gtk_widget_set_vexpand (scroller, TRUE);
  return scroller;
}
