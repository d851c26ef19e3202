/* Laws, blocks and walls: what is refused, with its place. */
#include "io/project-text.h"
#include "support/room.h"

#include <string.h>

typedef struct Case {
  const char *what, *by, *message;
} Case;

static void
expect_errors (const char *text, const Case *cases, gsize count)
{
  for (gsize i = 0; i < count; i++) {
    g_autofree char *changed = test_replace (text, cases[i].what, cases[i].by);
    g_autofree char *message = test_parse_error (changed, NULL);
    g_assert_cmpstr (message, ==, cases[i].message);
  }
}

static void
test_laws (void)
{
  static const Case cases[] = {
    { "\"name\": \"joint\", ", "", "4:5: laws[0].name: required key is missing" },
    { "\"name\": \"joint\"", "\"name\": \"\"", "4:15: laws[0].name: name is empty" },
    { "\"name\": \"joint\"", "\"name\": 7",
      "4:15: laws[0].name: expected a string, found a number" },
    { "\"coulomb\"", "\"plastic\"",
      "4:32: laws[0].kind: \"plastic\" is not one of elastic, no-tension, coulomb, "
      "mohr-coulomb, bilinear, elastic-plastic, concrete, steel, curve" },
    { "\"kind\": \"coulomb\", ", "", "4:5: laws[0].kind: required key is missing" },
    { "\"kn\": 1e7, ", "", "4:5: laws[0].kn: required key is missing" },
    { "\"kn\": 1e7", "\"kn\": 0", "4:49: laws[0].kn: number must be positive" },
    { "\"kn\": 1e7", "\"kn\": -1e7", "4:49: laws[0].kn: number must be positive" },
    { "\"kn\": 1e7", "\"kn\": 1e999", "4:49: laws[0].kn: number is not finite" },
    { "\"kn\": 1e7", "\"kn\": NaN", "4:49: laws[0].kn: number is not finite" },
    { "\"kn\": 1e7", "\"kn\": \"1e7\"",
      "4:49: laws[0].kn: expected a number, found a string" },
    { "\"ks\": 1e7", "\"ks\": -1", "4:60: laws[0].ks: number must be positive" },
    { "\"friction\": 0.65", "\"friction\": -0.1",
      "4:77: laws[0].friction: number must not be negative" },
    { ", \"friction\": 0.65", "", "4:5: laws[0].friction: required key is missing" },
    { "0.65", "0.65, \"cohesion\": -1",
      "4:95: laws[0].cohesion: number must not be negative" },
    { "0.65", "0.65, \"dilatancy\": 0.7",
      "4:96: laws[0].dilatancy: dilatancy exceeds friction" },
    { "0.65", "0.65, \"basis\": \"joint\"",
      "4:92: laws[0].basis: \"joint\" is not one of contact, surface, material" },
    { "0.65 } ]",
      "0.65 }, { \"name\": \"joint\", \"kind\": \"elastic\", \"kn\": 1, \"ks\": 1 } ]",
      "4:95: laws[1].name: name is used twice" },
    { "0.65 } ]", "0.65 }, 3 ]", "4:85: laws[1]: expected an object, found a number" },
  };
  expect_errors (test_project_text, cases, G_N_ELEMENTS (cases));
}

static void
test_blocks (void)
{
  static const Case cases[] = {
    { "[[0, -1], [2, -1], [2, 0], [0, 0]]", "[]",
      "6:35: blocks[0].vertices: polygon has fewer than three vertices (block "
      "\"base\")" },
    { "[[0, -1], [2, -1], [2, 0], [0, 0]]", "[[0, -1], [2, -1]]",
      "6:35: blocks[0].vertices: polygon has fewer than three vertices (block "
      "\"base\")" },
    { "[[0, -1], [2, -1], [2, 0], [0, 0]]", "[[0, 0], [1, 0], [2, 0]]",
      "6:35: blocks[0].vertices: polygon has no area (block \"base\")" },
    { "[[0, -1], [2, -1], [2, 0], [0, 0]]", "[[0, -1], [2, 0], [2, -1], [0, 0]]",
      "6:35: blocks[0].vertices: polygon crosses itself (block \"base\")" },
    { "[2, -1], [2, 0]", "[2, -1], [2, -1], [2, 0]",
      "6:54: blocks[0].vertices[2]: polygon repeats a vertex (block \"base\")" },
    { "[2, -1]", "[2]", "6:45: blocks[0].vertices[1]: expected two numbers" },
    { "[2, -1]", "[2, \"-1\"]",
      "6:49: blocks[0].vertices[1][1]: expected a number, found a string" },
    { "[2, -1]", "[2, 1e999]", "6:49: blocks[0].vertices[1][1]: number is not finite" },
    { "\"vertices\": [[0, -1], [2, -1], [2, 0], [0, 0]], ", "",
      "6:5: blocks[0].vertices: required key is missing" },
    { "\"thickness\": 1", "\"thickness\": -1",
      "6:84: blocks[0].thickness: number must be positive" },
    { "\"thickness\": 1, ", "", "6:5: blocks[0].thickness: required key is missing" },
    { "\"unit_weight\": 10000", "\"unit_weight\": -1",
      "6:102: blocks[0].unit_weight: number must not be negative" },
    { "\"unit_weight\": 10000, ", "",
      "6:5: blocks[0].unit_weight: required key is missing" },
    { "\"unit_weight\": 10000", "\"unit_weight\": 10000, \"density\": 1000",
      "6:120: blocks[0].density: density and unit_weight exclude each other" },
    { "[true, true, true]", "[true, true]",
      "6:120: blocks[0].support: expected three values: ux, uy, rz fixed or not" },
    { "[true, true, true]", "[true, 1, true]",
      "6:127: blocks[0].support[1]: expected true or false" },
    { "\"name\": \"top\"", "\"name\": \"base\"",
      "7:15: blocks[1].name: name is used twice (block \"base\")" },
    { "\"name\": \"top\"", "\"name\": \"top\", \"law\": \"glue\"",
      "7:29: blocks[1].law: no law has this name: \"glue\"" },
    { "\"name\": \"top\"",
      "\"name\": \"top\", \"law\": \"joint\", \"material\": \"joint\"",
      "7:50: blocks[1].material: law and material exclude each other" },
    { "\"blocks\": [", "\"blocks\": 3, \"x\": [",
      "5:13: blocks: expected an array, found a number" },
    { "\"blocks\"", "\"Blocks\"", "1:1: blocks: required key is missing" },
  };
  expect_errors (test_project_text, cases, G_N_ELEMENTS (cases));
}

static void
test_walls (void)
{
  static const Case cases[] = {
    { "[1, 2]]", "[1, 0]]", "5:81: walls[0].courses[1][1]: length in a course is zero" },
    { "[1, 2]]", "[1, 1e9]]", "5:81: walls[0].courses[1][1]: number is too large" },
    { "[1, 2]]", "[]]", "5:77: walls[0].courses[1]: course is empty" },
    { "[1, 2]]", "3]", "5:77: walls[0].courses[1]: expected an array, found a number" },
    { "[1, 2]]", "[1, null]]",
      "5:81: walls[0].courses[1][1]: expected a number, found null" },
    { "[[1], [1, 2]]", "[]", "5:71: walls[0].courses: course is empty" },
    { "[1, 1]", "[1, -1]", "5:36: walls[0].unit: number must be positive" },
    { "\"unit\": [1, 1], ", "", "5:13: walls[0].unit: required key is missing" },
    { "\"name\": \"w\"", "\"name\": \"\"", "5:23: walls[0].name: name is empty" },
  };
  char *text = test_replace (test_project_text, "  \"blocks\": [\n",
                             "  \"walls\": [{ \"name\": \"w\", \"unit\": [1, 1], "
                             "\"thickness\": 1, \"courses\": [[1], [1, 2]], "
                             "\"unit_weight\": 1 }], \"blocks\": [\n");
  expect_errors (text, cases, G_N_ELEMENTS (cases));
  g_free (text);
}

static void
test_choices_that_are_free (void)
{
  char *text =
    test_replace (test_project_text, "\"name\": \"top\", ", "\"material\": \"joint\", ");
  char *more = test_replace (text, "\"unit_weight\": 10000", "\"density\": 1000");
  QnProject project;
  test_parse (more, &project);
  g_assert_cmpuint (project.warnings->len, ==, 0);
  g_assert_cmpstr (project.model.blocks[1].name, ==, "b2");
  g_assert_cmpint (project.model.blocks[1].law, ==, 0);
  g_assert_cmpfloat (project.model.blocks[0].unit_weight, ==, 9810);
  qn_project_clear (&project);
  g_free (more);
  g_free (text);

  text = test_replace (test_project_text, "\"coulomb\"", "\"no-tension\"");
  test_parse (text, &project);
  g_assert_cmpuint (project.warnings->len, ==, 1);
  g_assert_cmpstr (
    g_ptr_array_index (project.warnings, 0), ==,
    "wall.quoin:4:80: laws[0].friction: has no effect for this kind of law");
  qn_project_clear (&project);
  g_free (text);
}

QN_TESTS
{
  g_test_add_func ("/project-structure/laws", test_laws);
  g_test_add_func ("/project-structure/blocks", test_blocks);
  g_test_add_func ("/project-structure/walls", test_walls);
  g_test_add_func ("/project-structure/free-choices", test_choices_that_are_free);
}
