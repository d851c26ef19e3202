#include "io/exchange/drawing.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

static void
test_boxes (void)
{
  static const char text[] =
    "Box 1:\n[0, 0], [1, 0], [1, 0.5], [0, 0.5]\nrho = 2400\n"
    "material = 0\n\nBox 2:\n[0,0.5],[1,0.5],[0.5,1.25]\nrho = 2400\n"
    "material = 0\nFE 1:\nN1 = [0, 0]\n";
  g_auto (QnDrawing) drawing;
  g_assert_true (qn_drawing_read (qn_hybridfem_import, text, strlen (text), "test.txt",
                                  &drawing, NULL));
  g_assert_cmpuint (drawing.paths->len, ==, 2);
  const QnDrawingPath *second = &g_array_index (drawing.paths, QnDrawingPath, 1);
  g_assert_cmpuint (second->count, ==, 3);
  g_assert_cmpuint (second->line, ==, 6);
  g_assert_true (second->closed);
  g_assert_cmpfloat (second->points[2].y, ==, 1.25);
  g_assert_cmpuint (drawing.notes->len, ==, 1);
}

static void
test_bad_files (void)
{
  static const struct {
    const char *text, *start;
  } cases[] = { { "Box 1:\n[0, 0], [1, 0], [1\n", "bad.txt:2: " },
                { "Box 1:\n[0, 0], [1, 0]\n", "bad.txt:2: " },
                { "Box 1:\n[0, 0], [1, x], [1, 1]\n", "bad.txt:2: " },
                { "Box 1:", "bad.txt:1: " },
                { "nothing", "bad.txt:1: " } };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnDrawing drawing;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_drawing_read (qn_hybridfem_import, cases[i].text,
                                     strlen (cases[i].text), "bad.txt", &drawing,
                                     &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_true (g_str_has_prefix (error->message, cases[i].start));
  }
}

QN_TESTS
{
  g_test_add_func ("/hybridfem-import/boxes", test_boxes);
  g_test_add_func ("/hybridfem-import/bad-files", test_bad_files);
}
