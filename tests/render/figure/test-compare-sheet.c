#include "render/figure/compare-sheet.h"
#include "render/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

/* The legend is of all pictures: each mark once, without a number of its own for each. */
static void
check_legend (const char *svg)
{
  static const char *const marks[] = { "open joint", "hinge", "sliding joint" };
  guint told = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (marks); i++) {
    g_autofree char *text = g_strconcat (">", marks[i], NULL);
    g_auto (GStrv) parts = g_strsplit (svg, text, -1);
    g_assert_cmpuint (g_strv_length (parts), <=, 2);
    g_assert_true (parts[1] == NULL || parts[1][0] == '<');
    told += parts[1] != NULL;
  }
  g_assert_cmpuint (told, >, 1);
}

static void
test_formats (void)
{
  Fixture f[3];
  QnFigure figures[3];
  QnOutput output;
  QnMetadata metadata;
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  for (int i = 0; i < 3; i++) {
    fixture_init_wall (&f[i], 2 + i, 3 + 2 * i);
    qn_figure_init (&figures[i], &f[i].model, &f[i].contacts, &f[i].result,
                    QN_VIEW_MECHANISM);
  }
  QnCompareSheet sheet = { .figures = figures, .count = 3, .title = "Three" };
  static const char *const names[] = { "s.png", "s.svg", "s.pdf" };
  static const char *const starts[] = { "\x89PNG", "<?xml", "%PDF" };
  for (int i = 0; i < 3; i++) {
    GError *error = NULL;
    g_autofree char *path = g_build_filename (folder, names[i], NULL);
    g_autofree char *content = NULL;
    gsize length;
    for (sheet.columns = 0; sheet.columns <= 4; sheet.columns += 2)
      g_assert_true (qn_compare_sheet_export (&sheet, path, &output, &metadata, &error));
    g_assert_no_error (error);
    g_assert_true (g_file_get_contents (path, &content, &length, NULL));
    g_assert_cmpint (strncmp (content, starts[i], 4), ==, 0);
    if (g_str_has_suffix (path, ".svg"))
      check_legend (content);
    g_unlink (path);
  }
  for (int i = 0; i < 3; i++)
    fixture_clear (&f[i]);
  g_rmdir (folder);
}

static void
test_refusals (void)
{
  Fixture f;
  QnFigure figure;
  QnOutput output;
  QnMetadata metadata;
  GError *error = NULL;
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  QnCompareSheet sheet = { .count = 0 };
  g_assert_false (qn_compare_sheet_export (&sheet, "x.png", &output, &metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);

  fixture_init_wall (&f, 2, 2);
  qn_figure_init (&figure, &f.model, &f.contacts, NULL, QN_VIEW_MECHANISM);
  sheet = (QnCompareSheet){ .figures = &figure, .count = 1 };
  g_assert_false (qn_compare_sheet_export (&sheet, "x.png", &output, &metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_assert_nonnull (strstr (error->message, "Running bond"));
  g_clear_error (&error);
  fixture_clear (&f);
}

/* Mechanisms of one structure are grouped by how they move, whatever their scale; another
 * structure, and a figure without a mechanism, stand alone. */
static void
test_groups (void)
{
  enum { COUNT = 5 };
  Fixture f[COUNT];
  QnFigure figures[COUNT];
  QnId groups[COUNT];
  for (int i = 0; i < COUNT; i++) {
    fixture_init_wall (&f[i], 2, i == 3 ? 5 : 3);
    qn_figure_init (&figures[i], &f[i].model, &f[i].contacts, &f[i].result,
                    QN_VIEW_MECHANISM);
    g_assert_nonnull (f[i].result.mechanism);
  }
  size_t values = f[0].result.block_count * QN_DOF_COUNT;
  for (size_t k = 0; k < values; k++) {
    f[1].result.mechanism[k] = k % QN_DOF_COUNT == QN_DOF_UX ? 1 : 0;
    f[2].result.mechanism[k] = 3 * f[0].result.mechanism[k];
  }
  figures[4].result = NULL;

  g_assert_true (qn_compare_sheet_groups (figures, COUNT, groups));
  g_assert_cmpint (groups[0], ==, 0);
  g_assert_cmpint (groups[1], ==, 1);
  g_assert_cmpint (groups[2], ==, 0);
  g_assert_cmpint (groups[3], ==, QN_NONE);
  g_assert_cmpint (groups[4], ==, QN_NONE);
  for (int i = 0; i < COUNT; i++)
    fixture_clear (&f[i]);
}

QN_TESTS
{
  g_test_add_func ("/render/compare-sheet/formats", test_formats);
  g_test_add_func ("/render/compare-sheet/groups", test_groups);
  g_test_add_func ("/render/compare-sheet/refusals", test_refusals);
}
