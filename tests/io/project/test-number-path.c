#include "io/project/number-path.h"
#include "support/room.h"

#include <math.h>

static const struct {
  const char *name, *before, *after, *path;
  double number;
} cases[] = {
  { "number", "{\"a\": [{\"b\": 1}, {\"b\": 2}]}", "{\"a\": [{\"b\": 1}, {\"b\": 3}]}",
    "a[1].b", 2 },
  { "added", "{\"a\": {}}", "{\"a\": {\"c\": {\"d\": 0.5}}}", "a.c.d", NAN },
  { "removed", "{\"a\": {\"d\": 4}}", "{\"a\": {}}", "a.d", 4 },
  { "with-seed", "{\"a\": {}}", "{\"a\": {\"seed\": 1, \"b\": 3}}", "a.b", NAN },
  { "two-new", "{\"a\": {}}", "{\"a\": {\"seed\": 1, \"b\": 2}}", NULL, NAN },
  { "same", "{\"a\": 1}", "{\"a\": 1}", NULL, NAN },
  { "two", "{\"a\": [1, 2]}", "{\"a\": [2, 3]}", NULL, NAN },
  { "word", "{\"a\": \"x\"}", "{\"a\": \"y\"}", NULL, NAN },
  { "number-and-word", "{\"a\": 1, \"b\": \"x\"}", "{\"a\": 2, \"b\": \"y\"}", NULL,
    NAN },
  { "longer", "{\"a\": [1]}", "{\"a\": [1, 2]}", NULL, NAN },
  { "other-type", "{\"a\": 1}", "{\"a\": [1]}", NULL, NAN },
  { "drawing", "{\"underlay\": {\"x\": 1}}", "{\"underlay\": {\"x\": 2}}", NULL, NAN },
};

static void
test_find (gconstpointer data)
{
  gsize i = GPOINTER_TO_SIZE (data);
  double number;
  g_autofree char *path =
    qn_number_path_find (cases[i].before, cases[i].after, 3, &number);
  g_assert_cmpstr (path, ==, cases[i].path);
  if (path != NULL)
    g_assert_true (number == cases[i].number
                   || (isnan (number) && isnan (cases[i].number)));
}

QN_TESTS
{
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *name = g_strconcat ("/io/number-path/", cases[i].name, NULL);
    g_test_add_data_func (name, GSIZE_TO_POINTER (i), test_find);
  }
}
