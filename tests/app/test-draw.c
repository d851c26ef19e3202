/* Every drawing tool, by pointer and by keys. */
#include "driver.h"

#include "app/tools/tools.h"
#include "app/widgets/paper-area.h"
#include "app/widgets/row.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-masonry.h"
#include "doc/text/law-text.h"
#include "io/project/project-masonry.h"
#include "stereotomy/masonry.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <string.h>

static guint
steps_of (QnWindow *window)
{
  return qn_window_get_document (window)->history->position;
}

static QnMasonries
masonry_of (QnWindow *window)
{
  QnMasonries list;
  g_assert_true (qn_project_get_masonry (
    qn_document_get_project (qn_window_get_document (window)), &list, NULL));
  return list;
}

static double
total_area (const QnModel *model)
{
  double area = 0.0;
  for (gsize i = 0; i < model->block_count; i++)
    area += model->blocks[i].support[0] ? 0.0 : model->blocks[i].area;
  return area;
}

/* An empty drawing, ready to draw walls. */
static QnWindow *
open_blank (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.draw");
  return window;
}

/* Back to nothing and forth again: the same text at every step. */
static void
check_history (QnWindow *window)
{
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *text = g_strdup (document->text->text);
  guint steps = steps_of (window);
  g_autoptr (GPtrArray) texts = g_ptr_array_new_with_free_func (g_free);
  for (guint i = 0; i < steps; i++) {
    g_ptr_array_add (texts, g_strdup (document->text->text));
    g_assert_true (qn_document_undo (document));
  }
  for (guint i = steps; i > 0; i--) {
    g_assert_true (qn_document_redo (document));
    g_assert_cmpstr (document->text->text, ==, g_ptr_array_index (texts, i - 1));
  }
  g_assert_cmpstr (document->text->text, ==, text);
}

static void
open_wall_with_window (QnWindow *window)
{
  driver_drag (window, 0.0, 0.0, 3.2, 2.1);
  driver_key ("o");
  driver_drag (window, 1.15, 0.65, 2.05, 1.42);
}

/* The opening is dragged by its middle and its side, changed in the panel, nudged, filled. */
static void
test_opening (void)
{
  QnWindow *window = open_blank ();
  open_wall_with_window (window);
  QnMasonries list = masonry_of (window);
  g_assert_cmpuint (list.count, ==, 1);
  g_assert_cmpuint (list.items[0].wall.opening_count, ==, 1);
  QnOpening opening = list.items[0].wall.openings[0];
  QnVec2 origin = list.items[0].origin;
  g_assert_cmpint (opening.span, ==, QN_SPAN_LINTEL);
  g_assert_cmpfloat_with_epsilon (opening.width, 0.8, 1e-9);
  qn_masonries_clear (&list);

  driver_key ("v");
  QnVec2 middle = qn_vec2_add (origin, qn_vec2 (opening.at.x + 0.5 * opening.width,
                                                opening.at.y + 0.5 * opening.height));
  driver_screenshot (GTK_WIDGET (window), "opening-selected");
  driver_drag (window, middle.x, middle.y + 0.1, middle.x + 0.4, middle.y + 0.1);
  list = masonry_of (window);
  g_assert_cmpfloat_with_epsilon (list.items[0].wall.openings[0].at.x, opening.at.x + 0.4,
                                  1e-9);
  g_assert_cmpstr (driver_last_step (window), ==, "Move Opening");
  qn_masonries_clear (&list);

  double right = middle.x + 0.4 + 0.5 * opening.width;
  driver_drag (window, right, middle.y, right + 0.2, middle.y);
  list = masonry_of (window);
  g_assert_cmpfloat_with_epsilon (list.items[0].wall.openings[0].width, 1.0, 1e-9);
  g_assert_cmpstr (driver_last_step (window), ==, "Resize Opening");
  qn_masonries_clear (&list);

  driver_key ("Left");
  driver_key ("Left");
  list = masonry_of (window);
  g_assert_cmpfloat_with_epsilon (list.items[0].wall.openings[0].at.x, opening.at.x,
                                  1e-9);
  qn_masonries_clear (&list);
  g_assert_cmpint (qn_model_find_block (model_of (window), "w1.o1.lintel"), !=, QN_NONE);

  driver_key ("Delete");
  list = masonry_of (window);
  g_assert_cmpuint (list.items[0].wall.opening_count, ==, 0);
  qn_masonries_clear (&list);
  check_history (window);
  driver_discard (window);
}

static QnVec2
place_of_stone (QnWindow *window)
{
  QnId stone = qn_model_find_block (model_of (window), "w1.6.3");
  g_assert_cmpint (stone, !=, QN_NONE);
  return model_of (window)->blocks[stone].centroid;
}

static gsize
count_objects (QnWindow *window)
{
  g_auto (QnMasonries) list = masonry_of (window);
  gsize count = list.count;
  return count;
}

/* A wall that is selected as a whole is dragged as one. A stone that is dragged, selected or not, comes
 * out of its wall; the step says so, and undo gives the wall back. */
static void
test_whole_wall (void)
{
  QnWindow *window = open_blank ();
  driver_drag (window, 0.0, 0.0, 2.0, 1.05);
  driver_key ("v");
  QnVec2 at = place_of_stone (window);
  driver_click (window, at.x, at.y);
  driver_activate (window, "win.select-like::wall");
  driver_drag (window, at.x, at.y, at.x + 1.0, at.y);
  QnMasonries list = masonry_of (window);
  g_assert_cmpuint (list.count, ==, 1);
  g_assert_cmpfloat (list.items[0].origin.x, >, 0.9);
  qn_masonries_clear (&list);

  driver_key ("Escape");
  at = place_of_stone (window);
  driver_drag (window, at.x, at.y, at.x, at.y + 0.8);
  g_assert_cmpuint (count_objects (window), ==, 0);
  g_assert_cmpfloat (place_of_stone (window).y, >, at.y + 0.5);
  g_assert_cmpstr (driver_last_step (window), ==, "Move, Wall to Free Blocks");
  guint moved = 0;
  qn_selection_get (qn_window_get_document (window)->selection, QN_PICK_BLOCK, &moved);
  g_assert_cmpuint (moved, ==, 1);
  driver_key ("ctrl+z");
  g_assert_cmpuint (count_objects (window), ==, 1);
  check_history (window);
  driver_discard (window);
}

/* An opening that was just cut is changed by its handle without another tool. */
static void
test_opening_tool_handles (void)
{
  QnWindow *window = open_blank ();
  open_wall_with_window (window);
  driver_screenshot (GTK_WIDGET (window), "opening-cut");
  driver_drag (window, 2.0, 1.05, 2.4, 1.05);
  QnMasonries list = masonry_of (window);
  g_assert_cmpuint (list.items[0].wall.opening_count, ==, 1);
  g_assert_cmpfloat_with_epsilon (list.items[0].wall.openings[0].width, 1.2, 1e-9);
  qn_masonries_clear (&list);
  driver_discard (window);
}

static gboolean
change_kind (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  qn_law_change_kind (&model->laws[0], *(const QnLawKind *) data);
  return TRUE;
}

static gboolean
is_paper_area (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return QN_IS_PAPER_AREA (widget) && gtk_widget_get_mapped (widget);
}

/* Brightness of a corner of the paper, 0 to 255. */
static int
corner_of (GtkWidget *paper)
{
  const int width = gtk_widget_get_width (paper), height = gtk_widget_get_height (paper);
  g_autoptr (GdkPaintable) paintable = gtk_widget_paintable_new (paper);
  GtkSnapshot *snapshot = gtk_snapshot_new ();
  gdk_paintable_snapshot (paintable, GDK_SNAPSHOT (snapshot), width, height);
  GskRenderNode *node = gtk_snapshot_free_to_node (snapshot);
  g_assert_nonnull (node);
  g_autoptr (GdkTexture) texture = gsk_renderer_render_texture (
    gtk_native_get_renderer (gtk_widget_get_native (paper)), node, NULL);
  gsize stride = 4 * (gsize) gdk_texture_get_width (texture);
  g_autofree guchar *pixels =
    g_malloc (stride * (gsize) gdk_texture_get_height (texture));
  gdk_texture_download (texture, pixels, stride);
  gsk_render_node_unref (node);
  return pixels[3 * stride + 3 * 4 + 1];
}

/* The form shows every kind of law, in a light window and, on dark paper, in a dark one. */
static void
test_laws (void)
{
  for (int dark = 0; dark < 2; dark++) {
    g_settings_set_string (qn_settings_get (), "style", dark ? "dark" : "light");
    QnWindow *window = open_blank ();
    driver_drag (window, 0.0, 0.0, 2.0, 1.05);
    driver_open_analysis (window);
    for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
      g_autoptr (GError) error = NULL;
      edit_model (qn_window_get_document (window), "Kind", NULL, change_kind, &kind,
                  &error);
      g_assert_no_error (error);
      driver_settle ();
    }
    qn_document_undo (qn_window_get_document (window));
    GtkWidget *button =
      driver_find_widget (GTK_WIDGET (window), driver_is_button, "_Duplicate Law");
    g_assert_nonnull (button);
    GtkWidget *paper = driver_find_widget (GTK_WIDGET (window), is_paper_area, NULL);
    gtk_widget_grab_focus (paper); /* into sight */
    driver_settle ();
    g_assert_cmpint (corner_of (paper), ==, dark ? 33 : 255);
    gtk_widget_grab_focus (button);
    driver_screenshot (GTK_WIDGET (window), dark ? "laws-dark" : "laws");
    driver_discard (window);
  }
  g_settings_reset (qn_settings_get (), "style");
}

/* A wall of the published kind, listed course by course, gets an opening and stays parametric. */
static void
test_listed_wall (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall1.quoin");
  double before = total_area (model_of (window));
  driver_activate (window, "win.tool::opening");
  const QnWall *wall = &model_of (window)->walls[0];
  QnVec2 unit = wall->unit, low = wall->origin;
  driver_drag (window, low.x + 1.5 * unit.x, low.y + 1.1 * unit.y, low.x + 2.5 * unit.x,
               low.y + 2.9 * unit.y);
  g_assert_cmpuint (model_of (window)->wall_count, ==, 0);
  g_assert_cmpfloat_with_epsilon (total_area (model_of (window)),
                                  before - 2.0 * unit.x * unit.y, 1e-9);
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->wall_count, ==, 1);
  driver_discard (window);
}

/* Span by drag, rise by a click; then all of it typed. */
static void
test_arch (void)
{
  QnWindow *window = open_blank ();
  driver_key ("a");
  driver_drag (window, 0.5, 0.5, 3.5, 0.5);
  driver_click (window, 2.0, 1.5);
  QnMasonries list = masonry_of (window);
  g_assert_cmpuint (list.count, ==, 1);
  g_assert_cmpint (list.items[0].kind, ==, QN_MASONRY_ARCH);
  g_assert_cmpfloat_with_epsilon (list.items[0].arch.span, 3.0, 0.02);
  g_assert_cmpfloat_with_epsilon (list.items[0].arch.rise, 1.0, 0.02);
  qn_masonries_clear (&list);
  driver_activate (window, "win.fit");

  driver_click (window, 0.5, 2.5);
  driver_point (window, 1.0, 2.5);
  driver_type ("2; 0,6; 0.25; 9");
  driver_screenshot (GTK_WIDGET (window), "arch-typed");
  driver_key ("Return");
  list = masonry_of (window);
  g_assert_cmpuint (list.count, ==, 2);
  const QnArch *arch = &list.items[1].arch;
  g_assert_cmpfloat_with_epsilon (arch->span, 2.0, 1e-9);
  g_assert_cmpfloat_with_epsilon (arch->rise, 0.6, 1e-9);
  g_assert_cmpfloat_with_epsilon (arch->ring, 0.25, 1e-9);
  g_assert_cmpint (arch->voussoirs, ==, 9);
  qn_masonries_clear (&list);

  /* The crown is dragged up by its handle. */
  driver_key ("v");
  driver_activate (window, "win.fit");
  QnId stone = qn_model_find_block (model_of (window), "arch2.v2");
  QnVec2 at = model_of (window)->blocks[stone].centroid;
  driver_click (window, at.x, at.y);
  driver_activate (window, "win.select-like::wall");
  driver_screenshot (GTK_WIDGET (window), "arch-selected");
  driver_drag (window, 1.5, 3.1, 1.5, 3.3);
  list = masonry_of (window);
  g_assert_cmpfloat (list.items[1].arch.rise, >, 0.7);
  qn_masonries_clear (&list);
  check_history (window);
  driver_discard (window);
}

static void
test_column (void)
{
  QnWindow *window = open_blank ();
  driver_key ("c");
  driver_click (window, 1.0, 0.5);
  driver_point (window, 1.2, 1.0);
  driver_type ("0.5; 2.1");
  driver_key ("Return");
  QnMasonries list = masonry_of (window);
  g_assert_cmpuint (list.count, ==, 1);
  g_assert_cmpint (list.items[0].kind, ==, QN_MASONRY_COLUMN);
  g_assert_cmpint (list.items[0].column.drums, ==, 12);
  qn_masonries_clear (&list);
  g_assert_cmpfloat_with_epsilon (total_area (model_of (window)), 0.5 * 2.1, 1e-9);
  driver_screenshot (GTK_WIDGET (window), "column");
  driver_discard (window);
}

static gboolean
is_kind (GtkWidget *widget, gconstpointer id)
{
  return GTK_IS_DROP_DOWN (widget) && gtk_widget_get_mapped (widget)
         && g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), id) == 0;
}

/* The column tool also draws what its panel says: the upright face of a buttress is where the drag
 * began. */
static void
test_kinds (void)
{
  static const struct {
    QnMasonryKind kind;
    const char *step;
  } cases[] = {
    { QN_MASONRY_COLUMN, "Add Column" },      { QN_MASONRY_BUTTRESS, "Add Buttress" },
    { QN_MASONRY_PORTAL, "Add Portal" },      { QN_MASONRY_RUBBLE, "Add Rubble" },
    { QN_MASONRY_WALL, "Add Grid of Cells" }, { QN_MASONRY_RUBBLE, "Add Voronoi Cells" }
  };
  QnWindow *window = open_blank ();
  driver_key ("c");
  GtkWidget *kind = driver_find_widget (GTK_WIDGET (window), is_kind, "kind");
  g_assert_nonnull (kind);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    gtk_drop_down_set_selected (GTK_DROP_DOWN (kind), (guint) i);
    driver_settle ();
    double x = 0.9 * (double) i;
    driver_drag (window, x + 0.6, 0.2, x, 1.6);
    QnMasonries list = masonry_of (window);
    g_assert_cmpuint (list.count, ==, i + 1);
    g_assert_cmpint (list.items[i].kind, ==, cases[i].kind);
    if (cases[i].kind == QN_MASONRY_BUTTRESS)
      g_assert_false (list.items[i].buttress.leans_right);
    g_assert_cmpint (list.items[i].wall.grid, ==, i == 4);
    g_assert_cmpint (list.items[i].rubble.relaxed, ==, i == 5);
    qn_masonries_clear (&list);
    g_assert_cmpstr (driver_last_step (window), ==, cases[i].step);
  }
  driver_screenshot (GTK_WIDGET (window), "kinds");
  driver_discard (window);
}

/* A block is cut, its parts are joined again. */
static void
test_cut_join (void)
{
  QnWindow *window = open_blank ();
  driver_key ("r");
  driver_drag (window, 1.0, 1.0, 2.0, 2.0);
  g_assert_cmpuint (model_of (window)->block_count, ==, 1);
  double area = total_area (model_of (window));
  driver_key ("x");
  driver_drag (window, 0.5, 1.2, 2.5, 1.8);
  g_assert_cmpuint (model_of (window)->block_count, ==, 2);
  g_assert_cmpfloat_with_epsilon (total_area (model_of (window)), area, 1e-9);
  g_assert_cmpuint (qn_window_get_document (window)->contacts.face_count, ==, 1);
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.join");
  g_assert_cmpuint (model_of (window)->block_count, ==, 1);
  g_assert_cmpint (model_of (window)->blocks[0].vertex_count, ==, 4);

  /* A line beside the block is refused and says why. */
  guint steps = steps_of (window);
  driver_drag (window, 0.2, 0.2, 0.6, 0.4);
  g_assert_cmpuint (steps_of (window), ==, steps);
  check_history (window);
  driver_discard (window);
}

/* Turned by a typed angle and by the handle, mirrored with the original kept, set in a ring. */
static void
test_turn_mirror_array (void)
{
  QnWindow *window = open_blank ();
  driver_key ("r");
  driver_drag (window, 1.0, 1.0, 2.0, 1.5);
  driver_activate (window, "win.select-all");
  driver_key ("t");
  driver_click (window, 1.0, 1.0);
  driver_point (window, 2.0, 1.0);
  driver_type ("90");
  driver_key ("Return");
  QnVec2 c = model_of (window)->blocks[0].centroid;
  g_assert_cmpfloat_with_epsilon (c.x, 0.75, 0.02);
  g_assert_cmpfloat_with_epsilon (c.y, 1.5, 0.02);

  driver_key ("v");
  double above = 28.0 / canvas_of (window)->camera.scale;
  driver_screenshot (GTK_WIDGET (window), "turn-handle");
  driver_drag (window, c.x, 2.0 + above, c.x + 1.0, c.y);
  g_assert_cmpstr (driver_last_step (window), ==, "Rotate");
  c = model_of (window)->blocks[0].centroid;
  g_assert_cmpfloat_with_epsilon (c.x, 0.75, 0.02);

  driver_key ("y");
  driver_drag (window, 2.0, 0.5, 2.0, 2.5);
  c = model_of (window)->blocks[0].centroid;
  g_assert_cmpfloat_with_epsilon (c.x, 3.25, 0.02);
  driver_activate (window, "win.array((3, 1.5, 0.0, 0.0))");
  g_assert_cmpuint (model_of (window)->block_count, ==, 4);
  check_history (window);
  driver_discard (window);
}

static gboolean
is_action_button (GtkWidget *widget, gconstpointer action)
{
  return GTK_IS_BUTTON (widget) && gtk_widget_get_mapped (widget)
         && g_strcmp0 (gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)), action)
              == 0;
}

static gboolean
is_shown_entry (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_ENTRY (widget) && gtk_widget_get_mapped (widget);
}

/* Without touching the mouse: a wall between two corners, Enter at each. */
static void
test_keyboard (void)
{
  QnWindow *window = open_blank ();
  driver_point (window, 4.0, 3.0);
  driver_key ("w");
  for (int i = 0; i < 3; i++)
    driver_key ("Left");
  driver_key ("Return");
  for (int i = 0; i < 2; i++)
    driver_key ("ctrl+Left");
  for (int i = 0; i < 2; i++)
    driver_key ("ctrl+Down");
  driver_screenshot (GTK_WIDGET (window), "keyboard-cursor");
  driver_key ("Return");
  g_assert_cmpuint (steps_of (window), ==, 1);
  g_assert_cmpstr (driver_last_step (window), ==, "Add Wall");
  g_assert_cmpuint (model_of (window)->block_count, >, 4);

  /* Every tool has a key that chooses it. */
  for (int i = 0; qn_tools[i] != NULL; i++) {
    driver_key (qn_tools[i]->accel);
    g_assert_true (canvas_of (window)->tool == qn_tools[i]);
    for (int k = 0; k < i; k++)
      g_assert_cmpstr (qn_tools[i]->accel, !=, qn_tools[k]->accel);
  }

  /* They and other shortcuts work after a button has taken the focus, but entries keep theirs. */
  GtkWidget *root = GTK_WIDGET (window);
  GtkWidget *save = driver_find_widget (root, is_action_button, "win.save");
  g_assert_true (gtk_widget_grab_focus (save));
  driver_key ("r");
  g_assert_true (canvas_of (window)->tool == &qn_tool_rectangle);
  g_assert_true (gtk_widget_grab_focus (save));
  driver_key ("Escape");
  g_assert_true (canvas_of (window)->tool == &qn_tool_select);
  g_assert_true (gtk_widget_grab_focus (save));
  driver_key ("ctrl+a");
  guint selected = 0;
  QnSelection *selection = canvas_of (window)->selection;
  qn_selection_get (selection, QN_PICK_BLOCK, &selected);
  g_assert_cmpuint (selected, ==, model_of (window)->block_count);
  GtkWidget *entry = driver_find_widget (root, is_shown_entry, NULL);
  g_assert_nonnull (entry);
  gtk_widget_grab_focus (entry);
  driver_key ("w");
  driver_key ("Delete");
  g_assert_true (canvas_of (window)->tool == &qn_tool_select);
  g_assert_cmpuint (model_of (window)->block_count, >, 4);
  driver_discard (window);
}

static gboolean
add_law (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_add_law (model, 0, "rough", error);
}

/* Joints get a law by the tool; they are selected by line and law; after a run the inspector shows
 * their forces. */
static void
test_joints (void)
{
  QnWindow *window = open_blank ();
  QnDocument *document = qn_window_get_document (window);
  QnSelection *selection = document->selection;
  driver_drag (window, 0.0, 0.0, 2.4, 1.75);
  g_assert_true (edit_model (document, "Law", NULL, add_law, NULL, NULL));
  driver_key ("l");
  QnCanvas *canvas = canvas_of (window);
  g_free (canvas->settings->joint_law);
  canvas->settings->joint_law = g_strdup ("rough");
  driver_drag (window, -0.2, 0.3, 2.6, 0.4);
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpuint (model_of (window)->override_count, >, 3);
  guint rough = 0;
  QnId face = QN_NONE;
  for (QnId i = 0; i < (QnId) contacts->face_count; i++) {
    if (contacts->faces[i].law_a == 1) {
      rough++;
      face = i;
    }
  }
  g_assert_cmpuint (rough, >, 3);

  driver_key ("v");
  QnVec2 at = qn_vec2_lerp (contacts->faces[face].start, contacts->faces[face].end, 0.4);
  driver_click (window, at.x, at.y);
  guint count = 0;
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, 1);
  driver_activate (window, "win.select-faces-like::law");
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, rough);
  driver_screenshot (GTK_WIDGET (window), "faces-selected");
  driver_activate (window, "win.select-faces-like::line");
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, >, 1);

  driver_key ("F5");
  driver_wait_for_job (window);
  g_assert_nonnull (document->run);
  driver_activate (window, "win.view::contacts");
  driver_activate (window, "win.show-panel::properties");
  qn_selection_set_one (selection, QN_PICK_FACE, face);
  driver_screenshot (GTK_WIDGET (window), "joint-forces");
  driver_discard (window);
}

/* A block a little above another one: the finding leads there, the fix closes the gap. */
static void
test_findings (void)
{
  static const char text[] =
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ],"
    "  \"blocks\": [ { \"name\": \"below\", \"vertices\": [[0,0],[1,0],[1,0.5],[0,0.5]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
    "    { \"name\": \"above\", \"vertices\": [[0,0.5004],[1,0.5004],[1,1],[0,1]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
    "  \"contact\": { \"law\": \"dry\" } }";
  QnWindow *window = open_blank ();
  QnDocument *document = qn_window_get_document (window);
  g_assert_true (qn_document_load_recovered (document, text, NULL, NULL));
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpuint (contacts->face_count, ==, 0);
  g_assert_cmpuint (contacts->findings.count, >, 0);
  driver_activate (window, "win.fit");
  driver_activate (window, "win.show-panel::findings");
  driver_screenshot (GTK_WIDGET (window), "findings");
  driver_press (GTK_WIDGET (window), "Snap");
  contacts = &document->contacts;
  g_assert_cmpuint (contacts->face_count, ==, 1);
  g_assert_cmpuint (contacts->findings.count, ==, 0);
  g_assert_cmpuint (steps_of (window), ==, 1);
  driver_activate (window, "win.undo");
  g_assert_cmpuint (document->contacts.face_count, ==, 0);
  driver_discard (window);
}

static gboolean
is_brick (GtkWidget *widget, gconstpointer name)
{
  g_autofree char *own =
    QN_IS_ROW (widget) && gtk_widget_get_mapped (widget)
      ? g_strdup (gtk_label_get_text (GTK_LABEL (qn_row_get_label (QN_ROW (widget)))))
      : NULL;
  return own != NULL && g_str_has_prefix (own, name);
}

/* A wall that is selected stays selected as a whole when its bricks become others. */
static void
test_other_bricks (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.draw");
  driver_drag (window, 0.5, 0.5, 2.5, 2.25);
  driver_key ("v");
  QnVec2 at = model_of (window)->blocks[model_of (window)->block_count / 2].centroid;
  g_object_set (gtk_settings_get_default (), "gtk-double-click-time", 10000, NULL);
  for (int i = 0; i < 3; i++)
    driver_click (window, at.x, at.y);
  g_object_set (gtk_settings_get_default (), "gtk-double-click-time", 1, NULL);
  guint selected = 0;
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &selected);
  g_assert_cmpuint (selected, ==, model_of (window)->block_count);
  gsize before = model_of (window)->block_count;

  driver_activate (window, "win.show-panel::properties");
  GtkWidget *row = driver_find_widget (GTK_WIDGET (window), is_brick, "Block length");
  g_assert_nonnull (row);
  gtk_widget_grab_focus (qn_row_get_field (QN_ROW (row)));
  driver_key ("ctrl+a");
  driver_type ("25 cm");
  driver_key ("Return");
  g_assert_cmpuint (model_of (window)->block_count, >, before);
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &selected);
  g_assert_cmpuint (selected, ==, model_of (window)->block_count);
  driver_screenshot (GTK_WIDGET (window), "other-bricks");
  driver_activate (window, "win.undo");
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &selected);
  g_assert_cmpuint (selected, ==, before);
  driver_discard (window);
}

/* The words in the middle of the drawing, as pixels. */
static GBytes *
words_of (QnWindow *window, const char *tool)
{
  driver_activate_target (window, "win.tool", g_variant_new_string (tool));
  driver_settle ();
  const QnCamera *camera = &canvas_of (window)->camera;
  const int height = 100, width = (int) (0.7 * camera->width);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  cairo_t *cr = cairo_create (image);
  cairo_translate (cr, -0.15 * camera->width, -0.5 * (camera->height - height));
  qn_canvas_draw_above (canvas_of (window), FALSE, cr);
  cairo_destroy (cr);
  cairo_surface_flush (image);
  GBytes *pixels =
    g_bytes_new (cairo_image_surface_get_data (image),
                 (gsize) height * (gsize) cairo_image_surface_get_stride (image));
  cairo_surface_destroy (image);
  return pixels;
}

/* Where nothing is drawn yet, tools that can begin say how; the others name the tool of walls. Words go with
 * the first block. */
static void
test_empty_hint (void)
{
  QnWindow *window = open_blank ();
  g_autoptr (GBytes) arch = words_of (window, "arch");
  g_autoptr (GBytes) polygon = words_of (window, "polygon");
  g_autoptr (GBytes) select = words_of (window, "select");
  g_autoptr (GBytes) force = words_of (window, "force");
  g_assert_false (g_bytes_equal (arch, polygon));
  g_assert_false (g_bytes_equal (arch, select));
  g_assert_true (g_bytes_equal (select, force));
  driver_screenshot (GTK_WIDGET (window), "empty-hint");
  driver_activate (window, "win.tool::rectangle");
  driver_drag (window, 4.0, 3.0, 4.4, 3.4);
  g_assert_cmpuint (model_of (window)->block_count, ==, 1);
  qn_selection_clear (selection_of (window));
  g_autoptr (GBytes) none = words_of (window, "arch");
  gsize size;
  const guint8 *bytes = g_bytes_get_data (none, &size);
  for (gsize i = 0; i < size; i++)
    g_assert_cmpint (bytes[i], ==, 0);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/draw/opening", test_opening);
  g_test_add_func ("/app/draw/empty-hint", test_empty_hint);
  g_test_add_func ("/app/draw/opening-tool-handles", test_opening_tool_handles);
  g_test_add_func ("/app/draw/whole-wall", test_whole_wall);
  g_test_add_func ("/app/draw/laws", test_laws);
  g_test_add_func ("/app/draw/listed-wall", test_listed_wall);
  g_test_add_func ("/app/draw/arch", test_arch);
  g_test_add_func ("/app/draw/column", test_column);
  g_test_add_func ("/app/draw/kinds", test_kinds);
  g_test_add_func ("/app/draw/cut-join", test_cut_join);
  g_test_add_func ("/app/draw/turn-mirror-array", test_turn_mirror_array);
  g_test_add_func ("/app/draw/keyboard", test_keyboard);
  g_test_add_func ("/app/draw/joints", test_joints);
  g_test_add_func ("/app/draw/findings", test_findings);
  g_test_add_func ("/app/draw/other-bricks", test_other_bricks);
}
