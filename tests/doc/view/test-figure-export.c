#include "doc/view/figures.h"

#include "doc/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

static gboolean
bytes_contain (const char *path, const char *text)
{
  g_autofree char *bytes = NULL;
  gsize length = 0;
  if (!g_file_get_contents (path, &bytes, &length, NULL))
    return FALSE;
  gsize wanted = strlen (text);
  for (gsize i = 0; i + wanted <= length; i++) {
    if (memcmp (bytes + i, text, wanted) == 0)
      return TRUE;
  }
  return FALSE;
}

/* A picture says what it shows: title, model, version, digest of the file. */
static void
test_metadata (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "model.png", NULL);
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  QnMetadata metadata;
  qn_document_get_metadata (document, &metadata);
  g_assert_cmpstr (metadata.model, ==, "01-sliding-block.quoin");
  g_assert_cmpuint (strlen (metadata.model_sha256), ==, 64);

  g_autoptr (QnRecipe) recipe = qn_recipe_new ("model", QN_VIEW_MODEL);
  g_autoptr (GError) error = NULL;
  qn_view_state_export_as (state, recipe, path, &error);
  g_assert_no_error (error);
  g_assert_true (bytes_contain (path, "01-sliding-block.quoin"));
  g_assert_true (bytes_contain (path, metadata.model_sha256));
  g_assert_true (bytes_contain (path, "quoin "));
  g_unlink (path);
  g_rmdir (folder);
}

static void
test_needs_result (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  g_autoptr (GError) error = NULL;
  g_autoptr (QnRecipe) mechanism = qn_recipe_new ("mechanism", QN_VIEW_MECHANISM);
  QnFigure figure;
  g_assert_false (qn_view_state_get_figure_as (state, mechanism, &figure, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);

  const QnRun *run = solve_example (document);
  g_assert_true (qn_view_state_get_figure_as (state, mechanism, &figure, &error));
  g_assert_true (figure.result == &run->result);
  g_assert_true (figure.options.titles);

  /* A recipe decides for itself what it shows. */
  g_autoptr (QnRecipe) recipe = qn_recipe_new ("plan", QN_VIEW_MODEL);
  recipe->title = g_strdup ("A plan");
  g_assert_true (qn_view_state_get_figure_as (state, recipe, &figure, &error));
  g_assert_null (figure.result);
  g_assert_cmpint (figure.options.view, ==, QN_VIEW_MODEL);
  g_assert_cmpstr (figure.title, ==, "A plan");
}

/* An ending that is no picture's, and a folder that is not there: an error, and no file. */
static void
test_refused (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  g_autoptr (QnRecipe) recipe = qn_recipe_new ("model", QN_VIEW_MODEL);
  static const char *const paths[] = { "/tmp/quoin-nowhere/x.png", "/tmp/quoin-x.doc" };
  for (gsize i = 0; i < G_N_ELEMENTS (paths); i++) {
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_view_state_export_as (state, recipe, paths[i], &error));
    g_assert_nonnull (error);
    g_assert_false (g_file_test (paths[i], G_FILE_TEST_EXISTS));
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/figure-export/metadata", test_metadata);
  g_test_add_func ("/doc/figure-export/needs-result", test_needs_result);
  g_test_add_func ("/doc/figure-export/refused", test_refused);
}
