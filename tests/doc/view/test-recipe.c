#include "doc/view/recipe.h"
#include "io/project/project.h"
#include "io/text/io-error.h"
#include "support/instructions.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char head[] =
  "{\"format\": \"quoin\", \"version\": 1, \"title\": \"Block\","
  "\"laws\": [{\"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "\"friction\": 0.4}],"
  "\"blocks\": [{\"name\": \"base\", \"vertices\": [[0,-1],[4,-1],[4,0],[0,0]],"
  "\"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true,true,true]},"
  "{\"name\": \"b\", \"vertices\": [[1,0],[2,0],[2,1],[1,1]], \"thickness\": %s,"
  "\"unit_weight\": 1e4}],"
  "\"contact\": {\"law\": \"dry\"}";

/* A project whose figures are this JSON text. */
static void
load (QnProject *project, const char *thickness, const char *figures)
{
  GError *error = NULL;
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text, head, thickness);
  if (figures != NULL)
    g_string_append_printf (text, ",\n\"figures\": %s", figures);
  g_string_append_c (text, '}');
  g_assert_true (
    qn_project_parse (text->str, text->len, "test.quoin", NULL, project, &error));
  g_assert_no_error (error);
}

static void
test_reads (void)
{
  g_auto (QnProject) project;
  GError *error = NULL;
  load (
    &project, "1",
    "[{\"name\": \"plain\"},"
    "{\"name\": \"full\", \"view\": \"deformed\", \"file\": \"out.pdf\", \"step\": 3,"
    "\"scale\": 250, \"field\": \"rotation\", \"size\": \"160mmx120mm\", \"dpi\": 600,"
    "\"title\": \"T\", \"caption\": \"\", \"result\": \"r.json\", \"ghost\": false,"
    "\"monochrome\": true, \"transparent\": true, \"backend\": \"gl\", \"colour\": 1},"
    "{\"name\": \"last\", \"view\": \"forces\", \"step\": \"last\", \"scale\": "
    "\"auto\"}]");
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&project, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (recipes->len, ==, 3);

  const QnRecipe *plain = g_ptr_array_index (recipes, 0);
  g_assert_cmpstr (plain->file, ==, "plain.png");
  g_assert_cmpint (plain->view.view, ==, QN_VIEW_MODEL);
  g_assert_false (qn_recipe_needs_result (plain));

  const QnRecipe *full = g_ptr_array_index (recipes, 1);
  g_assert_cmpstr (full->file, ==, "out.pdf");
  g_assert_cmpstr (full->result, ==, "r.json");
  g_assert_cmpstr (full->caption, ==, "");
  g_assert_cmpint (full->view.view, ==, QN_VIEW_DEFORMED);
  g_assert_cmpint (full->view.step, ==, 3);
  g_assert_cmpfloat (full->view.scale, ==, 250);
  g_assert_cmpint (full->view.field, ==, QN_FIELD_ROTATION);
  g_assert_false (full->view.ghost);
  g_assert_true (full->view.monochrome && full->output.transparent);
  g_assert_true (full->output.millimetres);
  g_assert_cmpfloat (full->output.width, ==, 160);
  g_assert_cmpfloat (full->output.dpi, ==, 600);
  g_assert_cmpint (full->output.backend, ==, QN_BACKEND_GL);
  g_assert_true (qn_recipe_needs_result (full));

  const QnRecipe *last = g_ptr_array_index (recipes, 2);
  g_assert_cmpint (last->view.step, ==, QN_STEP_LAST);
  g_assert_cmpfloat (last->view.scale, ==, QN_SCALE_AUTO);

  g_assert_cmpuint (project.warnings->len, ==, 1);
  g_assert_nonnull (strstr (g_ptr_array_index (project.warnings, 0), "colour"));
}

static void
test_none (void)
{
  g_auto (QnProject) project;
  load (&project, "1", NULL);
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&project, NULL);
  g_assert_cmpuint (recipes->len, ==, 0);
}

static void
test_refusals (void)
{
  static const char *const wrong[][2] = {
    { "{}", "figures" },
    { "[{}]", "figures[0].name" },
    { "[{\"name\": \"\"}]", "figures[0].name" },
    { "[{\"name\": \"a/b\"}]", "figures[0].name" },
    { "[{\"name\": \"a\"}, {\"name\": \"a\"}]", "figures[1].name" },
    { "[{\"name\": \"a\", \"view\": \"round\"}]", "figures[0].view" },
    { "[{\"name\": \"a\", \"field\": \"colour\"}]", "figures[0].field" },
    { "[{\"name\": \"a\", \"file\": \"a.bmp\"}]", "figures[0].file" },
    { "[{\"name\": \"a\", \"size\": \"big\"}]", "figures[0].size" },
    { "[{\"name\": \"a\", \"size\": \"0x5\"}]", "figures[0].size" },
    { "[{\"name\": \"a\", \"step\": \"first\"}]", "figures[0].step" },
    { "[{\"name\": \"a\", \"step\": 1.5}]", "figures[0].step" },
    { "[{\"name\": \"a\", \"scale\": -1}]", "figures[0].scale" },
    { "[{\"name\": \"a\", \"ghost\": 1}]", "figures[0].ghost" },
    { "[{\"name\": \"a\", \"dpi\": 0}]", "figures[0].dpi" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_auto (QnProject) project;
    GError *error = NULL;
    load (&project, "1", wrong[i][0]);
    g_assert_null (qn_recipes_read (&project, &error));
    g_assert_nonnull (error);
    g_assert_nonnull (strstr (error->message, wrong[i][1]));
    g_assert_nonnull (strstr (error->message, "test.quoin:2:"));
    g_assert_null (strchr (error->message, '\n'));
    g_clear_error (&error);
  }
}

/* What is written reads back and is written the same again. */
static void
test_round_trip (void)
{
  g_auto (QnProject) project;
  g_autoptr (GPtrArray) recipes =
    g_ptr_array_new_with_free_func ((GDestroyNotify) qn_recipe_free);
  for (int view = 0; view < QN_VIEW_COUNT; view++) {
    QnRecipe *recipe = qn_recipe_new (qn_view_names[view], (QnView) view);
    recipe->title = g_strdup ("\"quoted\" ä");
    recipe->view.names = view % 2 == 0;
    recipe->view.ghost = view % 2 != 0;
    recipe->view.step = view == 2 ? 7 : QN_STEP_LAST;
    recipe->view.scale = view == 3 ? 12.5 : QN_SCALE_AUTO;
    recipe->output.dpi = view == 1 ? 300 : 0;
    recipe->output.millimetres = view == 1;
    g_ptr_array_add (recipes, recipe);
  }
  g_autofree char *first = qn_recipes_to_json (recipes);
  load (&project, "1", first);
  g_autoptr (GPtrArray) back = qn_recipes_read (&project, NULL);
  g_assert_nonnull (back);
  g_autofree char *second = qn_recipes_to_json (back);
  g_assert_cmpstr (first, ==, second);
}

static void
test_stale (void)
{
  QnProject before, after;
  load (&before, "1", NULL);
  load (&after, "2", NULL);
  g_autoptr (QnRecipe) recipe = qn_recipe_new ("a", QN_VIEW_MODEL);
  g_assert_false (qn_recipe_is_stale (recipe, &after));
  recipe->digest = qn_model_digest (&before, NULL);
  g_assert_false (qn_recipe_is_stale (recipe, &before));
  g_assert_true (qn_recipe_is_stale (recipe, &after));
  qn_project_clear (&before);

  /* A figure more or less is no other model. */
  load (&before, "1", "[{\"name\": \"x\"}]");
  g_assert_false (qn_recipe_is_stale (recipe, &before));
  qn_project_clear (&before);
  qn_project_clear (&after);
}

/* One picture never takes the place of another, however its file is written. */
static void
test_same_file (void)
{
  g_auto (QnProject) project;
  GError *error = NULL;
  load (&project, "1",
        "[{\"name\": \"a\"}, {\"name\": \"b\", \"file\": \"x/../a.png\"},"
        "{\"name\": \"c\"}]");
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&project, &error);
  g_assert_no_error (error);
  g_assert_false (qn_recipes_check_files (recipes, NULL, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_nonnull (strstr (error->message, "\"b\""));
  g_clear_error (&error);
  const char *const both[] = { "a", "b", NULL }, *const apart[] = { "b", "c", NULL };
  g_assert_false (qn_recipes_check_files (recipes, both, NULL));
  g_assert_true (qn_recipes_check_files (recipes, apart, &error));
  g_assert_no_error (error);
}

/* ---- many ---- */

/* Twice as many recipes take twice the work. */
#define MOST_GROWTH 1.1

#define FEW  250
#define MANY 4000

/* What runs under callgrind. */
static int
read_many (int count)
{
  g_autoptr (GString) figures = g_string_new ("[");
  for (int i = 0; i < count; i++)
    g_string_append_printf (figures, "%s{\"name\": \"f%d\"}", i > 0 ? "," : "", i);
  g_string_append_c (figures, ']');
  g_auto (QnProject) project;
  load (&project, "1", figures->str);
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&project, NULL);
  g_assert_cmpuint (recipes->len, ==, count);
  return 0;
}

static void
test_growth (gconstpointer self)
{
  double work[2];
  for (int i = 0; i < 2; i++) {
    const char *const arguments[] = { self, "--read",
                                      i == 0 ? G_STRINGIFY (FEW) : G_STRINGIFY (MANY),
                                      NULL };
    work[i] = count_instructions (arguments, "qn_recipes_read", NULL);
  }
  if (work[0] == 0) {
    g_test_skip ("instructions cannot be counted here");
    return;
  }
  double growth = log (work[1] / work[0]) / log ((double) MANY / FEW);
  g_test_message ("%.0f instructions each, exponent %.3f", work[1] / MANY, growth);
  g_assert_cmpfloat (work[0], >, 100 * FEW); /* something was counted */
  g_assert_cmpfloat (growth, <=, MOST_GROWTH);
}

int
main (int argc, char **argv)
{
  if (argc == 3 && g_str_equal (argv[1], "--read"))
    return read_many (atoi (argv[2]));
  const char *self = argv[0];
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/recipe/reads", test_reads);
  g_test_add_func ("/doc/recipe/none", test_none);
  g_test_add_func ("/doc/recipe/refusals", test_refusals);
  g_test_add_func ("/doc/recipe/round-trip", test_round_trip);
  g_test_add_func ("/doc/recipe/stale", test_stale);
  g_test_add_func ("/doc/recipe/same-file", test_same_file);
  g_test_add_data_func ("/doc/recipe/growth", self, test_growth);
  return g_test_run ();
}
