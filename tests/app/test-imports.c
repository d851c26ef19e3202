/* What comes into a window: drawings of other programs, walls by numbers, pictures behind. */
#include "driver.h"

#include "doc/document/underlay.h"
#include "io/exchange/drawing-import.h"
#include "io/project/project.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

static gboolean
is_joints_choice (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  GtkStringObject *item = GTK_IS_DROP_DOWN (widget)
                            ? gtk_drop_down_get_selected_item (GTK_DROP_DOWN (widget))
                            : NULL;
  return item != NULL
         && g_str_has_prefix (gtk_string_object_get_string (item), "Close: blocks");
}

/* Begins to import an example: its dialog. */
static GtkWidget *
begin_import (QnWindow *window, const char *example)
{
  g_autofree char *path = driver_example_path (example);
  driver_activate_target (window, "win.take-path", g_variant_new_string (path));
  GtkWidget *dialog = driver_find_dialog ("Import");
  g_assert_nonnull (dialog);
  return dialog;
}

/* A drawing is previewed with its extents, taken over as one step, and undone. */
static void
test_import (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  GtkWidget *dialog = begin_import (window, "dxf/wall-gaps.dxf");
  driver_screenshot (dialog, "import");
  driver_press (dialog, "Import");
  gsize count = model_of (window)->block_count;
  g_assert_cmpuint (count, >, 0);
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  g_assert_cmpuint (document->contacts.face_count, >, 0);

  /* Again, into a drawing that has blocks: they are added, and stand in each other's way. */
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->block_count, ==, 0);
  driver_activate (window, "win.redo");
  g_assert_cmpuint (model_of (window)->block_count, ==, count);
  dialog = begin_import (window, "dxf/wall-gaps.dxf");
  driver_press (dialog, "Add to Drawing");
  g_assert_cmpuint (model_of (window)->block_count, ==, 2 * count);
  driver_discard (window);
}

static gboolean
holds_text (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_ENTRY (widget)
         && g_str_has_prefix (gtk_editable_get_text (GTK_EDITABLE (widget)), text);
}

/* A strip by its numbers: what is wrong is said and not drawn; one step draws it with loads, ties and what
 * its mechanism is checked by; another drawing gets a window of its own. */
static void
test_facade_strip (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.facade-strip");
  GtkWidget *dialog = driver_find_dialog ("Strip of a Façade");
  g_assert_nonnull (dialog);
  GtkWidget *storeys = driver_find_widget (dialog, holds_text, "3");
  g_assert_nonnull (storeys);
  gtk_editable_set_text (GTK_EDITABLE (storeys), "3.2; high");
  driver_settle ();
  g_assert_true (gtk_widget_has_css_class (storeys, "error"));
  gtk_editable_set_text (GTK_EDITABLE (storeys), "3.2; 3; 2");
  driver_settle ();
  g_assert_false (gtk_widget_has_css_class (storeys, "error"));
  driver_screenshot (dialog, "facade-strip");
  driver_press (dialog, "Draw");
  g_assert_cmpuint (model_of (window)->block_count, ==, 13);
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  g_assert_nonnull (strstr (document->text->text, "\"mechanism\": true"));
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->block_count, ==, 0);
  g_assert_null (strstr (document->text->text, "\"mechanism\""));
  driver_activate (window, "win.redo");
  const guint windows =
    g_list_length (gtk_application_get_windows (driver_application ()));
  driver_activate (window, "win.facade-strip");
  driver_press (driver_find_dialog ("Strip of a Façade"), "Draw");
  GList *all = gtk_application_get_windows (driver_application ());
  g_assert_cmpuint (g_list_length (all), ==, windows + 1);
  g_assert_cmpuint (model_of (window)->block_count, ==, 13);
  for (GList *l = all; l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data) && l->data != window) {
      g_assert_cmpuint (model_of (l->data)->block_count, ==, 9);
      driver_discard (l->data);
      break;
    }
  driver_discard (window);
}

/* A drawing with mortar says so, closes the joints unless told otherwise, and what was left open is
 * closed afterwards in one step. */
static void
test_mortar (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  GtkWidget *dialog = begin_import (window, "dxf/wall-mortar.dxf");
  driver_screenshot (dialog, "import-mortar");
  driver_press (dialog, "Import");
  gsize faces = document->contacts.face_count;
  g_assert_cmpuint (faces, ==, 158);
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  driver_activate (window, "win.undo");

  dialog = begin_import (window, "dxf/wall-mortar.dxf");
  GtkWidget *choice = driver_find_widget (dialog, is_joints_choice, NULL);
  g_assert_nonnull (choice);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (choice), 0);
  driver_press (dialog, "Import");
  g_assert_cmpuint (document->contacts.face_count, ==, 0);
  driver_activate_target (window, "win.show-panel", g_variant_new_string ("findings"));
  driver_screenshot (GTK_WIDGET (window), "findings-mortar");
  driver_press (GTK_WIDGET (window), "Close Gaps");
  g_assert_cmpuint (document->contacts.face_count, ==, faces);
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  driver_screenshot (GTK_WIDGET (window), "findings-closed");
  driver_activate (window, "win.undo");
  g_assert_cmpuint (document->contacts.face_count, ==, 0);
  driver_discard (window);
}

static gboolean
is_role_choice (GtkWidget *widget, gconstpointer data)
{
  GListModel *model =
    GTK_IS_DROP_DOWN (widget) ? gtk_drop_down_get_model (GTK_DROP_DOWN (widget)) : NULL;
  (void) data;
  return model != NULL && g_list_model_get_n_items (model) == 4;
}

/* The layers of a drawing are listed with what their names propose; what the user says instead counts
 * at once. */
static void
test_layers (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  GtkWidget *dialog = begin_import (window, "dxf/wall-clean.dxf");
  GtkWidget *choice = driver_find_widget (dialog, is_role_choice, NULL);
  g_assert_nonnull (choice);
  driver_screenshot (dialog, "import-layers");
  guint role = gtk_drop_down_get_selected (GTK_DROP_DOWN (choice));
  gtk_drop_down_set_selected (GTK_DROP_DOWN (choice), QN_ROLE_IGNORED);
  driver_settle ();
  g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (choice)), ==,
                    QN_ROLE_IGNORED);
  driver_press (dialog, "Import");
  /* The wall without its base. */
  g_assert_cmpuint (role, ==, QN_ROLE_SUPPORT);
  g_assert_cmpuint (model_of (window)->block_count, ==, 46);
  driver_discard (window);
}

/* A made-up survey, 200 x 100 px. */
static char *
make_picture (const char *folder)
{
  char *path = g_build_filename (folder, "survey.png", NULL);
  cairo_surface_t *surface = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 200, 100);
  cairo_t *cr = cairo_create (surface);
  cairo_set_source_rgb (cr, 0.8, 0.6, 0.5);
  cairo_paint (cr);
  cairo_set_source_rgb (cr, 0.2, 0.2, 0.3);
  cairo_rectangle (cr, 50.0, 30.0, 100.0, 70.0);
  cairo_fill (cr);
  cairo_destroy (cr);
  g_assert_cmpint (cairo_surface_write_to_png (surface, path), ==, CAIRO_STATUS_SUCCESS);
  cairo_surface_destroy (surface);
  return path;
}

/* The lines between corners of a picture end at the lowest of them. */
static void
assert_lines_end_at (QnWindow *window, double lowest)
{
  GtkWidget *canvas = GTK_WIDGET (canvas_of (window));
  QnVec2 at = qn_canvas_to_screen (QN_CANVAS (canvas), qn_vec2 (0.0, lowest));
  cairo_surface_t *picture = driver_picture (GTK_WIDGET (window));
  int stride = cairo_image_surface_get_stride (picture), last = -1;
  const unsigned char *data = cairo_image_surface_get_data (picture);
  double x, y;
  gtk_widget_translate_coordinates (canvas, GTK_WIDGET (window), at.x, at.y, &x, &y);
  for (int row = 0; row < cairo_image_surface_get_height (picture); row++) {
    const guint32 *pixels = (const guint32 *) (gconstpointer) (data + row * stride);
    for (int i = 0; i < cairo_image_surface_get_width (picture); i++) {
      int red = pixels[i] >> 16 & 0xff, green = pixels[i] >> 8 & 0xff,
          blue = pixels[i] & 0xff;
      if (red > 170 && green < 40 && ABS (blue - 102) < 20)
        last = row;
    }
  }
  cairo_surface_destroy (picture);
  g_assert_cmpfloat (last, >, y - 20);
  g_assert_cmpfloat (last, <, y + 40);
}

/* Laid behind an empty drawing, moved with the pointer, scaled by two points, saved beside the
 * project and undone. */
static void
test_picture (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *picture = make_picture (folder);
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  QnViewState *state = state_of (window);
  g_autofree char *empty = g_strdup (document->text->text);
  driver_activate_target (window, "win.take-path", g_variant_new_string (picture));
  const QnUnderlay *underlay = &state->options.underlay;
  g_assert_nonnull (underlay->image);
  g_assert_cmpfloat (underlay->width, ==, 5.0);
  g_assert_cmpfloat (underlay->origin.x, ==, 0.0);

  /* What is gripped comes to the grid, which the pointer is beside. */
  QnCanvas *canvas = canvas_of (window);
  double scale = qn_canvas_to_screen (canvas, qn_vec2 (1.0, 0.0)).x
                 - qn_canvas_to_screen (canvas, qn_vec2 (0.0, 0.0)).x;
  double pixel = qn_canvas_to_screen (canvas, qn_vec2 (1.013, 0.3)).x;
  double gripped = 1.013 + (round (pixel) - pixel) / scale;
  driver_drag (window, 1.013, 0.3, 1.51, 0.3);
  underlay = &state->options.underlay;
  g_assert_cmpfloat_with_epsilon (underlay->origin.x, 1.5 - gripped, 1e-5);
  g_assert_cmpuint (document->history->steps->len, ==, 2);

  /* The dark door is 2.5 m wide on the screen; it is 1.25 m wide in truth. */
  double left = underlay->origin.x + 1.25;
  driver_click (window, left, 0.5);
  driver_click (window, left + 2.5, 0.5);
  driver_type ("1,25");
  driver_screenshot (GTK_WIDGET (window), "picture");
  driver_key ("Return");
  underlay = &state->options.underlay;
  g_assert_cmpfloat_with_epsilon (underlay->width, 2.5, 0.02);

  /* Four corners, in any order, become a rectangle of typed size. */
  left = underlay->origin.x + 0.625;
  driver_click (window, left + 1.2, 0.9);
  driver_click (window, left, 0.1);
  driver_click (window, left + 1.25, 0.1);
  driver_click (window, left + 0.1, 0.7);
  driver_screenshot (GTK_WIDGET (window), "picture-corners");
  assert_lines_end_at (window, 0.1);
  driver_type ("2; 1,5");
  driver_key ("Return");
  underlay = &state->options.underlay;
  g_assert_true (underlay->rectified);
  g_assert_cmpfloat (underlay->width, ==, 2.0);
  g_assert_cmpfloat (underlay->height, ==, 1.5);
  /* Its lower left corner comes to the grid. */
  g_assert_cmpfloat_with_epsilon (underlay->origin.x, left, 0.1);
  g_assert_cmpfloat_with_epsilon (10.0 * underlay->origin.x,
                                  round (10.0 * underlay->origin.x), 1e-9);
  driver_screenshot (GTK_WIDGET (window), "picture-rectified");
  driver_click_on (GTK_WIDGET (window), driver_is_check, "Cropped to the rectangle");
  g_assert_true (state->options.underlay.cropped);
  g_assert_cmpfloat (state->options.underlay.seen.max.x, ==, 1.0);
  driver_press (GTK_WIDGET (window), "Show as Taken");
  g_assert_false (state->options.underlay.rectified);
  driver_activate (window, "win.undo");
  g_assert_true (state->options.underlay.rectified);

  g_autofree char *path = g_build_filename (folder, "survey.quoin", NULL);
  driver_activate_target (window, "win.save-path", g_variant_new_string (path));
  g_assert_false (qn_document_is_modified (document));
  g_autofree char *json =
    qn_project_dup_extra (qn_document_get_project (document), "underlay");
  g_assert_nonnull (strstr (json, "\"survey.png\""));
  g_assert_nonnull (state->options.underlay.image);

  while (document->history->position > 0)
    driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, empty);
  g_assert_null (state->options.underlay.image);
  driver_discard (window);
  g_unlink (path);
  g_unlink (picture);
  g_rmdir (folder);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/imports/drawing", test_import);
  g_test_add_func ("/app/imports/facade-strip", test_facade_strip);
  g_test_add_func ("/app/imports/layers", test_layers);
  g_test_add_func ("/app/imports/mortar", test_mortar);
  g_test_add_func ("/app/imports/picture", test_picture);
}
