#include "io/exchange/drawing-import.h"
#include "io/exchange/drawing.h"
#include "io/exchange/dxf-export.h"
#include "support/models.h"
#include "support/room.h"
#include "support/scratch.h"

/* Out and in again: the same coordinates, bit for bit, in metres; to the digits of the file in
 * millimetres. */
static void
round_trip (double unit, double tolerance)
{
  g_auto (QnModel) model;
  test_model_init_wall (&model, 4, 0);
  test_model_rotate (&model, 0.1234);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "wall.dxf", NULL);
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_dxf_export (&model, NULL, NULL, 1, unit, path, &error));

  g_auto (QnProject) project;
  g_auto (QnImportReport) report;
  if (!qn_import_file (path, &QN_IMPORT_DEFAULTS, &project, &report, &error))
    g_error ("%s", error->message);
  g_assert_cmpuint (project.model.block_count, ==, model.block_count);
  for (size_t i = 0; i < model.block_count; i++) {
    const QnBlock *a = &model.blocks[i], *b = &project.model.blocks[i];
    g_assert_cmpint (a->vertex_count, ==, b->vertex_count);
    g_assert_cmpint (a->support[0], ==, b->support[0]);
    for (QnId k = 0; k < a->vertex_count; k++) {
      QnVec2 p = qn_model_block_vertices (&model, (QnId) i)[k];
      QnVec2 q = qn_model_block_vertices (&project.model, (QnId) i)[k];
      g_assert_cmpfloat (fabs (p.x - q.x), <=, tolerance);
      g_assert_cmpfloat (fabs (p.y - q.y), <=, tolerance);
    }
  }
  /* The same file again from what was read. */
  g_autofree char *again = g_build_filename (folder, "again.dxf", NULL);
  g_assert_true (qn_dxf_export (&project.model, NULL, NULL, 1, unit, again, &error));
  g_autofree char *first = NULL, *second = NULL;
  g_assert_true (g_file_get_contents (path, &first, NULL, NULL));
  g_assert_true (g_file_get_contents (again, &second, NULL, NULL));
  g_assert_cmpstr (first, ==, second);

  test_scratch_free (folder);
}

static void
test_metres (void)
{
  round_trip (1, 0);
}

static void
test_millimetres (void)
{
  round_trip (0.001, 1e-14);
}

static void
test_layers (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, 1, 2);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_auto (QnResult) result;
  g_assert_cmpint (qn_result_init (&result, 2, contacts.pair_count, NULL), ==, QN_OK);
  g_assert_true (
    qn_result_add_step (&result, (QnStep){ 0 }, (const double[]){ 0, 0, 0, 0.25, 0, 0 }));
  char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "block.dxf", NULL);
  g_assert_true (qn_dxf_export (&model, &contacts, &result, 2, 1, path, NULL));
  g_auto (QnDrawing) drawing;
  g_autofree char *text = NULL;
  gsize length;
  g_assert_true (g_file_get_contents (path, &text, &length, NULL));
  g_assert_true (qn_drawing_read (qn_dxf_import, text, length, path, &drawing, NULL));
  const char *const layers[] = { "SUPPORTS", "BLOCKS", "CONTACTS", "DEFORMED",
                                 "DEFORMED" };
  g_assert_cmpuint (drawing.paths->len, ==, G_N_ELEMENTS (layers));
  for (guint i = 0; i < drawing.paths->len; i++)
    g_assert_cmpstr (g_array_index (drawing.paths, QnDrawingPath, i).layer, ==,
                     layers[i]);
  const QnDrawingPath *moved = &g_array_index (drawing.paths, QnDrawingPath, 4);
  const QnDrawingPath *still = &g_array_index (drawing.paths, QnDrawingPath, 1);
  g_assert_cmpfloat_with_epsilon (moved->points[0].x, still->points[0].x + 0.5, 1e-12);
  g_assert_cmpfloat (drawing.unit, ==, 1);
  test_scratch_free (folder);
}

QN_TESTS
{
  g_test_add_func ("/dxf-export/metres", test_metres);
  g_test_add_func ("/dxf-export/millimetres", test_millimetres);
  g_test_add_func ("/dxf-export/layers", test_layers);
}
