#include "doc/document/import.h"

#include "doc/fixture.h"
#include "io/exchange/drawing-import.h"
#include "support/room.h"

static void
read_drawing (const char *name, QnProject *project)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "dxf", name, NULL);
  const QnImportSettings settings = QN_IMPORT_DEFAULTS;
  g_auto (QnImportReport) report;
  g_autoptr (GError) error = NULL;
  qn_import_file (path, &settings, project, &report, &error);
  g_assert_no_error (error);
}

/* An empty drawing becomes the imported one, in one step that can be undone. */
static void
test_into_empty (void)
{
  g_auto (QnProject) project;
  read_drawing ("wall-clean.dxf", &project);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autofree char *empty = g_strdup (document->text->text);
  g_autoptr (GError) error = NULL;
  qn_document_import (document, NULL, &project, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (document->project.model.block_count, ==, project.model.block_count);
  g_assert_cmpfloat (document->project.model.laws[0].kn, ==, project.model.laws[0].kn);
  g_assert_cmpstr (qn_history_get_name (document->history, 0), ==,
                   "Import wall-clean.dxf");
  g_assert_true (qn_document_undo (document));
  g_assert_cmpstr (document->text->text, ==, empty);
}

/* Into another drawing the blocks come with their supports, under names that are free. */
static void
test_into_drawing (void)
{
  g_auto (QnProject) project;
  read_drawing ("wall-clean.dxf", &project);
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall1.quoin");
  gsize before = document->project.model.block_count;
  for (int i = 0; i < 2; i++) {
    g_autoptr (GError) error = NULL;
    qn_document_import (document, NULL, &project, &error);
    g_assert_no_error (error);
  }
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, before + 2 * project.model.block_count);
  gsize fixed = 0, imported_fixed = 0;
  for (gsize i = 0; i < model->block_count; i++)
    fixed += model->blocks[i].support[QN_DOF_UX];
  for (gsize i = 0; i < project.model.block_count; i++)
    imported_fixed += project.model.blocks[i].support[QN_DOF_UX];
  g_assert_cmpuint (fixed, ==, 1 + 2 * imported_fixed);
}

static void
test_kinds (void)
{
  g_assert_true (qn_import_knows_file ("/a/b/Wall.DXF"));
  g_assert_true (qn_import_knows_file ("x.svg"));
  g_assert_false (qn_import_knows_file ("x.quoin"));
  g_assert_true (qn_import_is_picture ("Photo.JPeG"));
  g_assert_false (qn_import_is_picture ("x.svg"));
}

QN_TESTS
{
  g_test_add_func ("/doc/import/into-empty", test_into_empty);
  g_test_add_func ("/doc/import/into-drawing", test_into_drawing);
  g_test_add_func ("/doc/import/kinds", test_kinds);
}
