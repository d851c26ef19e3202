#include "io/project/project-masonry.h"
#include "io/text/io-error.h"
#include "stereotomy/masonry.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

#define HEAD                                                                             \
  "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "   \
  "\"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.65 } ], \"contact\": { "       \
  "\"law\": "                                                                            \
  "\"j\" }, \"masonry\": [\n"
#define TAIL   "] }"
#define COMMON "\"thickness\": 0.5, \"unit_weight\": 20000, \"foundation\": 0.2, "

/* One object of each kind, with most of its keys. */
static const char *const objects[] = {
  "{ \"kind\": \"wall\", \"name\": \"w\", " COMMON "\"law\": \"j\", \"origin\": [1, 2], "
  "\"rotation\": 0.1, \"length\": 4, \"height\": 2, \"unit\": [0.4, 0.2], \"bond\": "
  "\"english\", \"closers\": \"queen\", \"edges\": [\"straight\", \"toothed\"], "
  "\"course_heights\": [0.2, 0.1], \"minimum_piece\": 0.1, \"openings\": [ { \"name\": "
  "\"door\", \"at\": [1, 0], \"width\": 1, \"height\": 1.5, \"head\": \"segmental\", "
  "\"rise\": 0.2, \"span\": \"voussoirs\", \"depth\": 0.2, \"voussoirs\": 7 }, { \"at\": "
  "[2.7, 0.5], \"width\": 0.6, \"height\": 0.6, \"span\": \"lintel\", \"depth\": 0.2, "
  "\"bearing\": 0.1, \"sill\": [0.1, 0.05] } ] }",
  "{ \"kind\": \"wall\", \"name\": \"v\", " COMMON "\"unit\": [0.4, 0.2], \"courses\": "
  "[[0.5, 1, -1, 0.5], [1, 1, 1]] }",
  "{ \"kind\": \"wall\", \"name\": \"u\", " COMMON "\"height\": 1, \"unit\": [0.4, 0.2], "
  "\"leaves\": [ { \"length\": 0.4 }, { \"length\": 0.3, \"unit\": [0.15, 0.1], "
  "\"bond\": "
  "\"stack\" } ] }",
  "{ \"kind\": \"arch\", \"name\": \"a\", " COMMON "\"shape\": \"pointed\", \"span\": 4, "
  "\"rise\": 3, \"ring\": 0.4, \"voussoirs\": 13, \"springer\": 0.3 }",
  "{ \"kind\": \"column\", \"name\": \"c\", " COMMON
  "\"height\": 3, \"width\": [0.8, 0.7], "
  "\"drums\": 4, \"plinth\": [1, 0.2], \"capital\": [1, 0.2] }",
  "{ \"kind\": \"buttress\", \"name\": \"b\", " COMMON
  "\"height\": 3, \"width\": [1.5, 0.6], "
  "\"courses\": 5, \"side\": \"left\" }",
  "{ \"kind\": \"portal\", \"name\": \"p\", " COMMON
  "\"bays\": 2, \"span\": 2, \"pier\": [1, "
  "2], \"courses\": 4, \"arch\": { \"rise\": 1, \"ring\": 0.3, \"voussoirs\": 9 } }",
  "{ \"kind\": \"portal\", \"name\": \"q\", " COMMON
  "\"bays\": 2, \"span\": 2, \"pier\": [1, 2], \"courses\": 4, \"spans\": [2, 3], "
  "\"rises\": [0.8], \"ring_thicknesses\": [0.4, 0.3], \"piers\": [1, 0.8, 1.2], "
  "\"arch\": { \"rise\": 1, \"ring\": 0.3, \"voussoirs\": 9 } }",
  "{ \"kind\": \"rubble\", \"name\": \"r\", " COMMON
  "\"width\": [2, 1.5], \"height\": 2, "
  "\"stone\": 0.4, \"seed\": 3 }",
  "{ \"kind\": \"grid\", \"name\": \"g\", " COMMON
  "\"origin\": [1, 2], \"size\": [3, 2], "
  "\"cells\": [7, 4], \"openings\": [ { \"at\": [1, 0.5], \"width\": 0.8, \"height\": 1 "
  "} ] }",
  "{ \"kind\": \"voronoi\", \"name\": \"z\", " COMMON
  "\"size\": [2, 1.5], \"cell\": 0.4, \"seed\": 3 }",
};

static void
parse (const char *object, QnProject *project)
{
  g_autofree char *text = g_strconcat (HEAD, object, TAIL, NULL);
  g_autoptr (GError) error = NULL;
  if (!qn_project_parse (text, strlen (text), "test", NULL, project, &error))
    g_error ("%s", error->message);
  for (guint i = 0; i < project->warnings->len; i++)
    g_error ("%s", (const char *) project->warnings->pdata[i]);
}

/* 60 degrees and 6 m: 3 tan 30 degrees; a right angle, as rounded, is a semicircle. */
static void
test_springing (void)
{
  static const struct {
    const char *angle;
    double rise;
  } cases[] = { { "1.0471975511965976", 1.7320508075688772 }, { "1.5708", 3 } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *object =
      g_strdup_printf ("{ \"kind\": \"arch\", " COMMON "\"span\": 6, \"ring\": 0.5, "
                       "\"voussoirs\": 15, \"springing\": %s }",
                       cases[i].angle);
    QnProject project;
    parse (object, &project);
    QnMasonries list;
    g_assert_true (qn_project_get_masonry (&project, &list, NULL));
    g_assert_cmpfloat (fabs (list.items[0].arch.rise - cases[i].rise), <, 1e-12);
    qn_masonries_clear (&list);
    qn_project_clear (&project);
  }
}

/* Degrees in place of radians are told, angles up to a full turn are not. */
static void
test_degrees (void)
{
  static const char *const angles[] = { "6.2", "-45" };
  for (gsize i = 0; i < G_N_ELEMENTS (angles); i++) {
    g_autofree char *text =
      g_strdup_printf (HEAD "{ \"kind\": \"arch\", " COMMON
                            "\"rotation\": %s, \"span\": 6, \"rise\": 2, \"ring\": 0.5, "
                            "\"voussoirs\": 15 }" TAIL,
                       angles[i]);
    QnProject project;
    g_assert_true (qn_project_parse (text, strlen (text), "test", NULL, &project, NULL));
    g_assert_cmpuint (project.warnings->len, ==, i);
    g_assert_true (i == 0
                   || strstr (project.warnings->pdata[0], "is this in degrees?") != NULL);
    qn_project_clear (&project);
  }
}

static void
assert_same_blocks (const QnModel *a, const QnModel *b)
{
  g_assert_cmpuint (a->block_count, ==, b->block_count);
  g_assert_cmpmem (a->vertices, a->vertex_count * sizeof (QnVec2), b->vertices,
                   b->vertex_count * sizeof (QnVec2));
  for (size_t i = 0; i < a->block_count; i++)
    g_assert_cmpstr (a->blocks[i].name, ==, b->blocks[i].name);
}

/* Read, written and read again: the same blocks, still parametric. */
static void
test_round_trip (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (objects); i++) {
    g_auto (QnProject) project, again;
    parse (objects[i], &project);
    g_assert_cmpuint (project.model.block_count, >, 4);
    g_autofree char *text = qn_project_to_text (&project, NULL);
    g_assert_nonnull (strstr (text, "\"masonry\""));
    g_autofree char *kind = g_strndup (objects[i] + 2, strcspn (objects[i] + 2, ","));
    g_assert_nonnull (strstr (text, kind));
    g_assert_null (strstr (text, "\"vertices\""));
    g_assert_true (qn_project_parse (text, strlen (text), "again", NULL, &again, NULL));
    assert_same_blocks (&project.model, &again.model);
  }
}

/* The struct written as JSON is the object that was read. */
static void
test_struct_round_trip (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (objects); i++) {
    g_auto (QnProject) project, again;
    g_auto (QnMasonries) list;
    parse (objects[i], &project);
    g_assert_true (qn_project_get_masonry (&project, &list, NULL));
    g_assert_cmpuint (list.count, ==, 1);
    g_autoptr (GString) json = g_string_new (NULL);
    qn_masonry_append_json (json, &list.items[0], &project.model);
    parse (json->str, &again);
    assert_same_blocks (&project.model, &again.model);
  }
}

static void
test_detach (void)
{
  g_auto (QnProject) project, again;
  parse (objects[0], &project);
  g_assert_true (qn_project_has_masonry (&project, 0));
  qn_project_detach_masonry (&project);
  g_assert_false (qn_project_has_masonry (&project, 0));
  g_autofree char *text = qn_project_to_text (&project, NULL);
  g_assert_null (strstr (text, "\"masonry\""));
  g_assert_true (qn_project_parse (text, strlen (text), "again", NULL, &again, NULL));
  assert_same_blocks (&project.model, &again.model);
}

static void
assert_refused (const char *object, const char *path, const char *reason)
{
  g_autofree char *text = g_strconcat (HEAD, object, TAIL, NULL);
  g_autoptr (GError) error = NULL;
  QnProject project;
  g_assert_false (
    qn_project_parse (text, strlen (text), "bad.quoin", NULL, &project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_autofree char *start = g_strconcat ("bad.quoin:2:", NULL);
  g_assert_true (g_str_has_prefix (error->message, start));
  g_assert_nonnull (strstr (error->message, path));
  g_assert_nonnull (strstr (error->message, reason));
  g_assert_null (strchr (error->message, '\n'));
}

static void
test_refuses (void)
{
  assert_refused ("{ \"kind\": \"wall\", " COMMON "\"height\": 2, \"unit\": [0.4, 0.2] }",
                  "masonry[0].length", "missing");
  assert_refused ("{ \"kind\": \"dome\" }", "masonry[0].kind", "");
  assert_refused ("{ \"kind\": \"wall\", " COMMON
                  "\"length\": -2, \"height\": 2, \"unit\": "
                  "[0.4, 0.2] }",
                  "masonry[0].length", "positive");
  assert_refused ("{ \"kind\": \"arch\", " COMMON
                  "\"span\": 2, \"rise\": 3, \"ring\": 0.2, "
                  "\"voussoirs\": 9 }",
                  "masonry[0].rise", "rise does not fit");
  assert_refused (
    "{ \"kind\": \"wall\", " COMMON "\"length\": 3, \"height\": 2, \"unit\": "
    "[0.4, 0.2], \"openings\": [ { \"at\": [1, 0], \"width\": 1, \"height\": 1 }, "
    "{ \"at\": [1.5, 0], \"width\": 1, \"height\": 1 } ] }",
    "masonry[0].openings[1]", "openings overlap");
  assert_refused ("{ \"kind\": \"grid\", " COMMON "\"size\": [3, 2], \"cells\": [6, 4], "
                  "\"openings\": [ { \"at\": [5, 0], \"width\": 1, \"height\": 1 } ] }",
                  "masonry[0].openings[0]", "outside the wall");
  assert_refused ("{ \"kind\": \"wall\", " COMMON
                  "\"length\": 3, \"height\": 2, \"unit\": "
                  "[0.4, 0.2], \"bond\": \"custom\" }",
                  "masonry[0].bond", "courses");
  assert_refused ("{ \"kind\": \"wall\", " COMMON
                  "\"length\": 3, \"height\": 2, \"unit\": "
                  "[1e-9, 0.2] }",
                  "masonry[0].unit", "more blocks");
  assert_refused ("{ \"kind\": \"portal\", " COMMON
                  "\"bays\": 2, \"span\": 2, \"pier\": [1, 2], \"courses\": 4, "
                  "\"lintel\": 0.3, \"arch\": { \"rise\": 1, \"ring\": 0.3, "
                  "\"voussoirs\": 9 } }",
                  "masonry[0].arch", "arch and lintel exclude each other");
  assert_refused ("{ \"kind\": \"portal\", " COMMON
                  "\"bays\": 2, \"span\": 2, \"pier\": [1, 2], \"courses\": 4, "
                  "\"arch\": 3 }",
                  "masonry[0].arch", "expected an object");
  assert_refused ("{ \"kind\": \"portal\", " COMMON
                  "\"bays\": 2, \"span\": 2, \"pier\": [1, 2], \"courses\": 4, "
                  "\"lintel\": 0.3, \"spans\": [2, 2, 2] }",
                  "masonry[0].spans", "up to 2 numbers");
#define SEGMENT                                                                          \
  "{ \"kind\": \"arch\", " COMMON "\"span\": 6, \"ring\": 0.5, \"voussoirs\": 15, "
  assert_refused (SEGMENT "\"rise\": 1, \"springing\": 1 }", "masonry[0].springing",
                  "rise and springing exclude each other");
  assert_refused (SEGMENT "\"springing\": 1.6 }", "masonry[0].springing", "π/2");
  assert_refused (SEGMENT "\"springing\": 0 }", "masonry[0].springing", "positive");
  assert_refused (SEGMENT "\"springing\": 1, \"shape\": \"elliptic\" }",
                  "masonry[0].springing", "only circular");
  assert_refused (SEGMENT "\"sides\": \"curved\" }", "masonry[0]", "rise");
  assert_refused ("{ \"kind\": \"grid\", " COMMON
                  "\"size\": [3, 2], \"cells\": [2.5, 4] }",
                  "masonry[0].cells", "whole numbers");
  assert_refused ("{ \"kind\": \"grid\", " COMMON
                  "\"size\": [3, 2], \"cells\": [10000, 1000] }",
                  "masonry[0].cells", "not more than 200000 cells");
  assert_refused ("{ \"kind\": \"grid\", " COMMON "\"size\": [3, 0], \"cells\": [2, 4] }",
                  "masonry[0]", "positive");
  assert_refused ("{ \"kind\": \"voronoi\", " COMMON "\"size\": [3, 2], \"cell\": 0 }",
                  "masonry[0].cell", "");
  assert_refused ("{ \"kind\": \"voronoi\", " COMMON "\"size\": [3, 2], \"cell\": 1e-4 }",
                  "masonry[0]", "more blocks");
  static const char *const seeds[] = { "1.5", "4294967296" };
  for (gsize i = 0; i < G_N_ELEMENTS (seeds); i++) {
    g_autofree char *rubble = g_strdup_printf (
      "{ \"kind\": \"rubble\", " COMMON
      "\"width\": [2, 1.5], \"height\": 2, \"stone\": 0.4, \"seed\": %s }",
      seeds[i]);
    assert_refused (rubble, "masonry[0].seed", "whole number below 4294967296");
  }
}

/* Loads name blocks of parametric masonry. */
static void
test_names_resolve (void)
{
  g_autofree char *text = g_strconcat (
    HEAD, objects[3],
    "], \"loads\": { \"live\": [ { \"kind\": \"force\", \"block\": \"a.v7\", "
    "\"value\": [0, -1000] } ] } }",
    NULL);
  g_auto (QnProject) project;
  g_assert_true (qn_project_parse (text, strlen (text), "test", NULL, &project, NULL));
  QnId block = project.model.live_loads[0].block;
  g_assert_cmpstr (project.model.blocks[block].name, ==, "a.v7");
  g_autofree char *path = qn_project_dup_key_path (&project, QN_ENTITY_BLOCK, block);
  g_assert_cmpstr (path, ==, "masonry[0]");
}

QN_TESTS
{
  g_test_add_func ("/project-masonry/springing", test_springing);
  g_test_add_func ("/project-masonry/degrees", test_degrees);
  g_test_add_func ("/project-masonry/round-trip", test_round_trip);
  g_test_add_func ("/project-masonry/struct-round-trip", test_struct_round_trip);
  g_test_add_func ("/project-masonry/detach", test_detach);
  g_test_add_func ("/project-masonry/refuses", test_refuses);
  g_test_add_func ("/project-masonry/names-resolve", test_names_resolve);
}
