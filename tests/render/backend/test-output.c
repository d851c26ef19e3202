#include "render/backend/output.h"

#include "render/drawing/text.h"
#include "support/room.h"

#include <gio/gio.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

static void
test_sizes (void)
{
  QnOutput output;
  QnPage page;
  g_autoptr (GError) error = NULL;
  qn_output_init (&output);
  g_assert_true (qn_output_parse_size (&output, "800x600", &error));
  g_assert_true (qn_output_page (&output, &page, &error));
  g_assert_cmpfloat (page.width, ==, 800);
  g_assert_cmpfloat (page.height, ==, 600);

  g_assert_true (qn_output_parse_size (&output, "160mmx120mm", &error));
  output.dpi = 254;
  g_assert_true (qn_output_page (&output, &page, &error));
  g_assert_cmpfloat (page.width, ==, 1600);
  g_assert_cmpfloat (page.height, ==, 1200);
  g_assert_cmpfloat_with_epsilon (page.unit, 254 / 72.0, 1e-12);
}

static void
test_sizes_refused (void)
{
  const char *malformed[] = { "",          "800", "800x",    "x600",     "800x600x2",
                              "160mmx120", "axb", "nanxnan", "800 x 600" };
  for (size_t i = 0; i < G_N_ELEMENTS (malformed); i++) {
    QnOutput output;
    g_autoptr (GError) error = NULL;
    qn_output_init (&output);
    g_assert_false (qn_output_parse_size (&output, malformed[i], &error));
    g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  }
  const double resolutions[] = { -1, NAN, INFINITY, 1e6 };
  for (size_t i = 0; i < G_N_ELEMENTS (resolutions); i++) {
    QnOutput output;
    QnPage page;
    g_autoptr (GError) error = NULL;
    qn_output_init (&output);
    output.dpi = resolutions[i];
    g_assert_false (qn_output_page (&output, &page, &error));
    g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
    g_assert_nonnull (strstr (error->message, "at most 100,000"));
  }
  const char *absurd[] = { "0x600",   "800x0", "-1x5",       "1000000x1000000",
                           "1e6x1e6", "0.2x3", "31999x31999" };
  for (size_t i = 0; i < G_N_ELEMENTS (absurd); i++) {
    QnOutput output;
    QnPage page;
    g_autoptr (GError) error = NULL;
    qn_output_init (&output);
    g_assert_true (qn_output_parse_size (&output, absurd[i], &error));
    g_assert_false (qn_output_page (&output, &page, &error));
    g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
    g_assert_null (strchr (error->message, '\n'));
  }
}

static bool
draw_square (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  (void) data;
  (void) error;
  cairo_rectangle (cr, 0.25 * page->width, 0.25 * page->height, 0.5 * page->width,
                   0.5 * page->height);
  cairo_fill (cr);
  return true;
}

static GBytes *
encode (QnFormat format, bool transparent)
{
  QnOutput output;
  QnMetadata metadata;
  GError *error = NULL;
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  output.width = output.height = 40;
  output.transparent = transparent;
  metadata.title = "Wänd <1>";
  metadata.generator = "quoin 9.9";
  metadata.model = "wall.quoin";
  metadata.model_sha256 = "abc123";
  metadata.multiplier = 0.35581;
  GBytes *bytes = qn_page_encode (format, &output, &metadata, draw_square, NULL, &error);
  g_assert_no_error (error);
  return bytes;
}

static bool
contains (GBytes *bytes, const char *text)
{
  gsize length, wanted = strlen (text);
  const char *data = g_bytes_get_data (bytes, &length);
  for (gsize i = 0; i + wanted <= length; i++)
    if (memcmp (data + i, text, wanted) == 0)
      return true;
  return false;
}

static void
test_metadata (void)
{
  g_autoptr (GBytes) png = encode (QN_FORMAT_PNG, false);
  g_autoptr (GBytes) svg = encode (QN_FORMAT_SVG, false);
  const char *words[] = { "0.35581", "quoin 9.9", "wall.quoin", "abc123" };
  for (size_t i = 0; i < G_N_ELEMENTS (words); i++) {
    g_assert_true (contains (png, words[i]));
    g_assert_true (contains (svg, words[i]));
  }
  g_assert_true (contains (png, "Wänd <1>"));
  g_assert_true (contains (svg, "<title>Wänd &lt;1&gt;</title>"));

  /* Cairo 1.18 compresses what a PDF says of itself. */
  g_autoptr (GBytes) pdf = encode (QN_FORMAT_PDF, false), told = NULL;
  g_autoptr (GError) error = NULL;
  g_autoptr (GSubprocess) program =
    g_subprocess_new (G_SUBPROCESS_FLAGS_STDIN_PIPE | G_SUBPROCESS_FLAGS_STDOUT_PIPE,
                      &error, "pdfinfo", "-enc", "UTF-8", "-", NULL);
  if (program == NULL) {
    g_test_skip (error->message);
    return;
  }
  g_assert_true (g_subprocess_communicate (program, pdf, NULL, &told, NULL, NULL));
  g_assert_true (contains (told, "Wänd <1>"));
  for (size_t i = 0; i < G_N_ELEMENTS (words); i++)
    g_assert_true (contains (told, words[i]));
  g_assert_false (contains (told, "CreationDate"));
}

static bool
draw_words (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  QnTextStyle style = { .size = 8, .halo = 1 }, narrow = { .size = 8, .width = 30 };
  QnColor red = qn_rgb (0xff0000);
  (void) data;
  (void) error;
  qn_text_draw (cr, &style, "σ < 5 kN/m²", page->width / 2, 10, 0.5, 0, 0, red);
  qn_text_draw (cr, &style, "Höhe", 5, page->height / 2, 0.5, 0.5, G_PI / 2, red);
  qn_text_draw (cr, &narrow, "one two three four five six seven", 2, 20, 0, 0, 0, red);
  cairo_rectangle (cr, 0, 0, page->width, 9);
  cairo_clip (cr);
  qn_text_draw (cr, &style, "hidden", 5, 30, 0, 0, 0, red);
  return true;
}

/* Words of an SVG are text, in the place, order and clip of what is drawn; and a text that was
 * shortened says so. */
static void
test_words (void)
{
  QnOutput output;
  g_autoptr (GError) error = NULL;
  qn_output_init (&output);
  output.width = output.height = 60;
  g_autoptr (GBytes) svg =
    qn_page_encode (QN_FORMAT_SVG, &output, &(QnMetadata){ 0 }, draw_words, NULL, &error);
  g_assert_no_error (error);
  g_assert_true (contains (svg, ">σ &lt; 5 kN/m²</text>"));
  g_assert_true (contains (svg, ">Höhe</text>"));
  g_assert_true (contains (svg, ">one"));
  g_assert_true (contains (svg, "…</text>"));
  g_assert_true (contains (svg, " fill=\"#ff0000\""));
  g_assert_false (contains (svg, "seven"));
  g_assert_false (contains (svg, "hidden"));
  g_assert_false (contains (svg, "<symbol"));
  g_assert_false (contains (svg, "rgb(1.2"));
}

static void
test_same_bytes_twice (void)
{
  for (int format = QN_FORMAT_PNG; format <= QN_FORMAT_PDF; format++) {
    g_autoptr (GBytes) first = encode ((QnFormat) format, false);
    g_autoptr (GBytes) second = encode ((QnFormat) format, false);
    g_assert_true (g_bytes_equal (first, second));
  }
}

static void
test_transparent_ground (void)
{
  for (int transparent = 0; transparent < 2; transparent++) {
    g_autoptr (GBytes) bytes = encode (QN_FORMAT_PNG, transparent);
    const guint8 *data = g_bytes_get_data (bytes, NULL);
    /* Colour type of the IHDR chunk: 2 is RGB, 6 is RGB with alpha. */
    g_assert_cmpint (data[25], ==, transparent ? 6 : 2);
  }
}

static void
test_endings (void)
{
  QnFormat format;
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_format_of_path ("a.PNG", &format, &error));
  g_assert_cmpint (format, ==, QN_FORMAT_PNG);
  g_assert_true (qn_format_of_path ("x.y/a.pdf", &format, &error));
  g_assert_cmpint (format, ==, QN_FORMAT_PDF);
  g_assert_true (qn_format_of_path ("-", &format, &error));
  g_assert_false (qn_format_of_path ("a.bmp", &format, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
}

static void
test_writing (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "a.png", NULL);
  g_autofree char *lost = g_build_filename (folder, "none", "a.png", NULL);
  GError *error = NULL;
  g_assert_true (qn_file_replace (path, "one", 3, &error));
  g_assert_true (qn_file_replace (path, "three", 5, &error));
  g_autofree char *content = NULL;
  g_assert_true (g_file_get_contents (path, &content, NULL, NULL));
  g_assert_cmpstr (content, ==, "three");

  g_assert_false (qn_file_replace (lost, "x", 1, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE);
  g_assert_nonnull (strstr (error->message, lost));
  g_clear_error (&error);
  g_assert_false (qn_file_replace (folder, "x", 1, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE);
  g_clear_error (&error);
  if (g_file_test ("/dev/full", G_FILE_TEST_EXISTS)) {
    g_assert_false (qn_file_replace ("/dev/full", "x", 1, &error));
    g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE);
    g_clear_error (&error);
  }
  g_unlink (path);
  g_assert_cmpint (g_rmdir (folder), ==, 0); /* nothing else was left */
}

QN_TESTS
{
  g_test_add_func ("/render/output/sizes", test_sizes);
  g_test_add_func ("/render/output/sizes-refused", test_sizes_refused);
  g_test_add_func ("/render/output/metadata", test_metadata);
  g_test_add_func ("/render/output/words", test_words);
  g_test_add_func ("/render/output/same-bytes", test_same_bytes_twice);
  g_test_add_func ("/render/output/transparent", test_transparent_ground);
  g_test_add_func ("/render/output/endings", test_endings);
  g_test_add_func ("/render/output/writing", test_writing);
}
