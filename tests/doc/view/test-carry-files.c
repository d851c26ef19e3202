#include "doc/view/figures.h"
#include "io/project/project.h"

#include "doc/view/view-state.h"
#include "fixture.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static const char record[] = "time [s],acceleration [m/s2]\n0,0\n0.01,1\n0.02,0\n";

static const char project[] =
  "{\"format\": \"quoin\", \"version\": 1,"
  "\"laws\": [{\"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "\"friction\": 0.4}],"
  "\"blocks\": [{\"name\": \"base\", \"vertices\": [[0,-1],[4,-1],[4,0],[0,0]],"
  "\"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true,true,true]},"
  "{\"name\": \"top\", \"vertices\": [[1,0],[2,0],[2,1],[1,1]],"
  "\"thickness\": 1, \"unit_weight\": 1e4}],"
  "\"contact\": {\"law\": \"dry\"},"
  "\"analysis\": {\"procedure\": \"dynamic\", \"dynamic\": {\"time_step\": 0.01,"
  "\"duration\": 0.02, \"ground\": [{\"direction\": [1, 0],"
  "\"record\": \"data/ground.csv\"}]}},"
  "\"underlay\": {\"image\": \"photo.png\", \"width\": 4}}";

typedef struct Rig {
  char *from, *to, *model, *copy;
} Rig;

static void
write_text (const char *folder, const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_autofree char *parent = g_path_get_dirname (path);
  g_assert_cmpint (g_mkdir_with_parents (parent, 0700), ==, 0);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static void
expect_text (const char *folder, const char *name, const char *expected)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_autofree char *text = NULL;
  g_assert_cmpint (g_file_get_contents (path, &text, NULL, NULL), ==, expected != NULL);
  g_assert_cmpstr (text, ==, expected);
}

static void
rig_init (Rig *rig)
{
  rig->from = test_scratch_new ();
  rig->to = test_scratch_new ();
  rig->model = g_build_filename (rig->from, "shaken.quoin", NULL);
  rig->copy = g_build_filename (rig->to, "mine.quoin", NULL);
  write_text (rig->from, "shaken.quoin", project);
  write_text (rig->from, "data/ground.csv", record);
  g_autofree char *photo = g_build_filename (rig->from, "photo.png", NULL);
  cairo_surface_t *image = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 40, 20);
  g_assert_cmpint (cairo_surface_write_to_png (image, photo), ==, CAIRO_STATUS_SUCCESS);
  cairo_surface_destroy (image);
}

static void
rig_clear (Rig *rig)
{
  test_scratch_free (rig->from);
  test_scratch_free (rig->to);
  g_free (rig->model);
  g_free (rig->copy);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Rig, rig_clear)

/* What a copy names is found before it is saved, and beside it afterwards; the file that it came
 * from stays as it was. */
static void
test_copy (void)
{
  g_auto (Rig) rig;
  rig_init (&rig);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_copy (document, rig.model, &error);
  g_assert_no_error (error);
  g_assert_null (document->path);
  g_assert_false (qn_document_is_modified (document));
  g_assert_cmpstr (document->folder, ==, rig.from);
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  g_assert_nonnull (state->options.underlay.image);
  qn_document_analyse (document, &error);
  g_assert_no_error (error);
  qn_document_cancel (document);

  g_assert_true (qn_document_carry_files (document, rig.copy, &error));
  g_assert_true (qn_document_save (document, rig.copy, &error));
  g_assert_no_error (error);
  expect_text (rig.from, "shaken.quoin", project);
  expect_text (rig.to, "data/ground.csv", record);
  g_assert_cmpstr (document->path, ==, rig.copy);
  g_assert_cmpstr (document->folder, ==, rig.to);

  g_autoptr (QnDocument) again = qn_document_new ();
  g_assert_true (qn_document_load (again, rig.copy, &error));
  g_autoptr (QnViewState) its_state = qn_view_state_new (again);
  g_assert_nonnull (its_state->options.underlay.image);
  g_assert_true (qn_document_analyse (again, &error));
  qn_document_cancel (again);
  g_clear_object (&its_state);
  g_clear_object (&state);
}

/* Another file of the name is not written over; a project saved elsewhere takes its record along
 * and leaves its picture where it is. */
static void
test_elsewhere (void)
{
  g_auto (Rig) rig;
  rig_init (&rig);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_document_load (document, rig.model, &error));
  write_text (rig.to, "data/ground.csv", "another");
  g_assert_false (qn_document_carry_files (document, rig.copy, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_EXISTS);
  g_clear_error (&error);
  expect_text (rig.to, "data/ground.csv", "another");

  write_text (rig.to, "data/ground.csv", record);
  g_assert_true (qn_document_carry_files (document, rig.copy, &error));
  expect_text (rig.to, "photo.png", NULL);
  g_autofree char *json =
    qn_project_dup_extra (qn_document_get_project (document), "underlay");
  g_assert_nonnull (strstr (json, rig.from));
}

QN_TESTS
{
  g_test_add_func ("/doc/carry-files/copy", test_copy);
  g_test_add_func ("/doc/carry-files/elsewhere", test_elsewhere);
}
