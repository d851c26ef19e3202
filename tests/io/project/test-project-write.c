#include "io/project/project.h"

#include "io/project-text.h"
#include "io/text/io-error.h"
#include "support/models.h"
#include "support/room.h"
#include "support/scratch.h"

#include <cjson/cJSON.h>
#include <string.h>

#define ASSERT_SAME(a, b, member) g_assert_true ((a)->member == (b)->member)

static void
assert_same_laws (const QnModel *a, const QnModel *b)
{
  ASSERT_SAME (a, b, law_count);
  for (size_t i = 0; i < a->law_count; i++) {
    const QnLaw *x = &a->laws[i], *y = &b->laws[i];
    g_assert_cmpstr (x->name, ==, y->name);
    ASSERT_SAME (x, y, kind);
    ASSERT_SAME (x, y, basis);
    ASSERT_SAME (x, y, kn);
    ASSERT_SAME (x, y, ks);
    ASSERT_SAME (x, y, friction);
    ASSERT_SAME (x, y, cohesion);
    ASSERT_SAME (x, y, tension);
    ASSERT_SAME (x, y, dilatancy);
  }
}

static void
assert_same_blocks (const QnModel *a, const QnModel *b)
{
  ASSERT_SAME (a, b, block_count);
  ASSERT_SAME (a, b, vertex_count);
  g_assert_cmpmem (a->vertices, a->vertex_count * sizeof *a->vertices, b->vertices,
                   b->vertex_count * sizeof *b->vertices);
  for (size_t i = 0; i < a->block_count; i++) {
    const QnBlock *x = &a->blocks[i], *y = &b->blocks[i];
    g_assert_cmpstr (x->name, ==, y->name);
    ASSERT_SAME (x, y, vertex_count);
    ASSERT_SAME (x, y, thickness);
    ASSERT_SAME (x, y, unit_weight);
    ASSERT_SAME (x, y, density);
    ASSERT_SAME (x, y, law);
    ASSERT_SAME (x, y, wall);
    ASSERT_SAME (x, y, weight);
    g_assert_cmpmem (x->support, sizeof x->support, y->support, sizeof y->support);
  }
}

static void
assert_same_walls (const QnModel *a, const QnModel *b)
{
  ASSERT_SAME (a, b, wall_count);
  for (size_t i = 0; i < a->wall_count; i++) {
    const QnWall *x = &a->walls[i], *y = &b->walls[i];
    g_assert_cmpstr (x->name, ==, y->name);
    ASSERT_SAME (x, y, origin.x);
    ASSERT_SAME (x, y, origin.y);
    ASSERT_SAME (x, y, unit.x);
    ASSERT_SAME (x, y, unit.y);
    ASSERT_SAME (x, y, course_count);
    size_t ends = (size_t) x->course_count * sizeof *x->course_ends;
    g_assert_cmpmem (x->course_ends, ends, y->course_ends, ends);
    size_t lengths = (size_t) x->course_ends[x->course_count - 1] * sizeof *x->lengths;
    g_assert_cmpmem (x->lengths, lengths, y->lengths, lengths);
  }
}

static void
assert_same_loads (const QnLoad *a, size_t a_count, const QnLoad *b, size_t b_count)
{
  g_assert_cmpuint (a_count, ==, b_count);
  for (size_t i = 0; i < a_count; i++) {
    ASSERT_SAME (&a[i], &b[i], kind);
    ASSERT_SAME (&a[i], &b[i], vector.x);
    ASSERT_SAME (&a[i], &b[i], vector.y);
    ASSERT_SAME (&a[i], &b[i], block);
    ASSERT_SAME (&a[i], &b[i], moment);
    ASSERT_SAME (&a[i], &b[i], has_at);
    ASSERT_SAME (&a[i], &b[i], at.x);
    ASSERT_SAME (&a[i], &b[i], at.y);
    ASSERT_SAME (&a[i], &b[i], load_case);
    ASSERT_SAME (&a[i], &b[i], has_side);
    ASSERT_SAME (&a[i], &b[i], side);
    ASSERT_SAME (&a[i], &b[i], edge);
    ASSERT_SAME (&a[i], &b[i], edge_count);
    ASSERT_SAME (&a[i], &b[i], normal);
    ASSERT_SAME (&a[i], &b[i], pressure);
    ASSERT_SAME (&a[i], &b[i], unit_weight);
    ASSERT_SAME (&a[i], &b[i], level);
    ASSERT_SAME (&a[i], &b[i], earth);
    ASSERT_SAME (&a[i], &b[i], coefficient);
    ASSERT_SAME (&a[i], &b[i], friction_angle);
    for (int end = 0; end < 2; end++) {
      ASSERT_SAME (&a[i], &b[i], part[end]);
      ASSERT_SAME (&a[i], &b[i], intensity[end]);
      ASSERT_SAME (&a[i], &b[i], span[end]);
    }
  }
}

static void
assert_same_pairs (const QnPairRule *a, const QnPairRule *b)
{
  ASSERT_SAME (a, b, placement);
  ASSERT_SAME (a, b, offset);
  ASSERT_SAME (a, b, count);
}

static void
assert_same_settings (const QnModel *a, const QnModel *b)
{
  ASSERT_SAME (a, b, gravity);
  ASSERT_SAME (a, b, contact.law);
  ASSERT_SAME (a, b, contact.tolerance);
  assert_same_pairs (&a->contact.pairs, &b->contact.pairs);
  ASSERT_SAME (a, b, override_count);
  for (size_t i = 0; i < a->override_count; i++) {
    ASSERT_SAME (&a->overrides[i], &b->overrides[i], block_a);
    ASSERT_SAME (&a->overrides[i], &b->overrides[i], block_b);
    ASSERT_SAME (&a->overrides[i], &b->overrides[i], law);
    ASSERT_SAME (&a->overrides[i], &b->overrides[i], has_pairs);
    assert_same_pairs (&a->overrides[i].pairs, &b->overrides[i].pairs);
  }
  const QnAnalysisSettings *x = &a->analysis, *y = &b->analysis;
  ASSERT_SAME (x, y, procedure);
  ASSERT_SAME (x, y, geometry);
  ASSERT_SAME (x, y, snap);
  ASSERT_SAME (x, y, flow);
  ASSERT_SAME (x, y, increments);
  ASSERT_SAME (x, y, max_multiplier);
  ASSERT_SAME (x, y, multiplier_tolerance);
  ASSERT_SAME (x, y, residual_tolerance);
  ASSERT_SAME (x, y, control.block);
  ASSERT_SAME (x, y, control.dof);
  ASSERT_SAME (x, y, control.target);
}

/* Writes and reads back: the same model, and the second writing gives the same bytes. */
static void
round_trip (const QnProject *project)
{
  g_auto (QnProject) again;
  gsize length;
  g_autofree char *text = qn_project_to_text (project, &length);
  g_assert_cmpuint (strlen (text), ==, length);
  test_parse (text, &again);
  g_assert_cmpuint (again.warnings->len, ==, project->warnings->len);

  const QnModel *a = &project->model, *b = &again.model;
  g_assert_cmpstr (a->title, ==, b->title);
  assert_same_laws (a, b);
  assert_same_blocks (a, b);
  assert_same_walls (a, b);
  assert_same_loads (a->dead_loads, a->dead_load_count, b->dead_loads,
                     b->dead_load_count);
  assert_same_loads (a->live_loads, a->live_load_count, b->live_loads,
                     b->live_load_count);
  assert_same_settings (a, b);
  g_assert_true (cJSON_Compare (project->extras, again.extras, TRUE)
                 || (project->extras == NULL && again.extras == NULL));

  g_autofree char *second = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (second, ==, text);
}

static void
round_trip_text (const char *text)
{
  g_auto (QnProject) project;
  test_parse (text, &project);
  round_trip (&project);
}

/* A project written from the text of another one gives what is written without: blocks that moved,
 * came, went, changed places or have members of their own. */
static void
test_like (void)
{
  static const char before[] =
    "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"a \\\"blocks\\\": [ title\","
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 }, { \"name\": \"wet\", \"kind\": \"elastic\", \"kn\": 1e7,"
    "    \"ks\": 1e7 } ],"
    "  \"blocks\": ["
    "    { \"name\": \"a\", \"vertices\": [[0,0],[3,0],[3,1],[0,1]], \"thickness\": 1,"
    "      \"density\": 2000, \"support\": [true, true, true], \"colour\": 1 },"
    "    { \"name\": \"b\", \"vertices\": [[0,1],[1,1],[1,2],[0,2]], \"thickness\": 1,"
    "      \"unit_weight\": 1e4, \"law\": \"wet\" },"
    "    { \"name\": \"c\", \"vertices\": [[1,1],[2,1],[2,2],[1,2]], \"thickness\": 1,"
    "      \"unit_weight\": 1e4 } ],"
    "  \"walls\": [ { \"name\": \"w\", \"origin\": [0, 2], \"unit\": [1, 1],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"courses\": [[1, 1, 1]] } ],"
    "  \"contact\": { \"law\": \"dry\" } }";
  static const char *const changes[][2] = {
    { "[0,2]]", "[0,1.5]]" },
    { "\"name\": \"b\"", "\"name\": \"x\"" },
    { "\"law\": \"wet\"", "\"law\": \"dry\"" },
    { "\"wet\"", "\"damp\"" },
    { "\"colour\": 1", "\"colour\": 2" },
    { "\"density\"", "\"unit_weight\"" },
    { "\"unit_weight\": 1e4 }", "\"unit_weight\": 2e4 }" },
    { "\"thickness\": 1,", "\"thickness\": 2," },
    { "\"courses\": [[1, 1, 1]]", "\"courses\": [[1, 1], [1, 1]]" },
    { "{ \"name\": \"c\", \"vertices\": [[1,1],[2,1],[2,2],[1,2]], \"thickness\": 1,"
      "      \"unit_weight\": 1e4 }",
      "{ \"name\": \"e\", \"vertices\": [[2,1],[3,1],[3,2],[2,2]], \"thickness\": 1,"
      " \"unit_weight\": 1 }, { \"name\": \"c\", \"vertices\": [[1,1],[2,1],[2,2],[1,2]],"
      " \"thickness\": 1, \"unit_weight\": 1e4 }" },
  };
  g_auto (QnProject) old;
  test_parse (before, &old);
  QnProjectText *old_text = qn_project_write (&old, NULL, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (changes); i++) {
    g_auto (GStrv) parts = g_strsplit (before, changes[i][0], -1);
    g_assert_cmpuint (g_strv_length (parts), >, 1);
    g_autofree char *after = g_strjoinv (changes[i][1], parts);
    g_auto (QnProject) project;
    test_parse (after, &project);
    g_autofree char *whole = qn_project_to_text (&project, NULL);
    QnProjectText *text = qn_project_write (&project, &old, old_text);
    g_assert_cmpstr (text->text, ==, whole);
    g_assert_cmpuint (text->length, ==, strlen (whole));
    for (gsize k = 0; k < project.model.block_count; k++) {
      gboolean listed = project.model.blocks[k].wall == QN_NONE;
      g_assert_cmpint (text->blocks[k][1] > text->blocks[k][0], ==, listed);
      g_assert_true (!listed || text->text[text->blocks[k][0]] == '{');
    }
    qn_project_text_free (text);
  }
  qn_project_text_free (old_text);
}

static void
test_small (void)
{
  round_trip_text (test_project_text);
}

/* Every setting that differs from its default, names that need escapes, awkward numbers. */
static void
test_everything (void)
{
  round_trip_text (
    "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"a \\\"b\\\"\\n\\\\ ü\", "
    "\"gravity\": 9.80665, \"laws\": [ { \"name\": \"j\\t1\", \"kind\": \"coulomb\", "
    "\"basis\": \"surface\", \"kn\": 1.2345678901234567e7, \"ks\": 0.1, \"friction\": "
    "0.65, "
    "\"cohesion\": 0.30000000000000004, \"tension\": 1e-300, \"dilatancy\": 0.1 }, "
    "{ \"name\": \"n\", \"kind\": \"no-tension\", \"kn\": 1, \"ks\": 1 } ], "
    "\"blocks\": [ { \"name\": \"base\", \"vertices\": [[0, -1], [0, 0], [2.1, 0], [2.1, "
    "-1]], "
    "\"thickness\": 0.3, \"density\": 1801.7, \"support\": [true, false, true] } ], "
    "\"walls\": [ { \"name\": \"w\", \"origin\": [0.05, 0], \"unit\": [0.7, 0.1], "
    "\"thickness\": 0.3, \"density\": 1700, \"law\": \"n\", "
    "\"courses\": [[1, -0.5, 1], [0.333333333333333333]] } ], "
    "\"contact\": { \"law\": \"j\\t1\", \"tolerance\": 1e-7, \"pairs\": "
    "{ \"placement\": \"uniform\", \"count\": 5 }, \"faces\": [ { \"blocks\": [\"base\", "
    "\"w.1.1\"], \"law\": \"n\", \"pairs\": { \"offset\": 0.02 } }, { \"blocks\": "
    "[\"w.1.2\", \"base\"] } ] }, \"loads\": { \"live\": [ { \"kind\": \"force\", "
    "\"block\": "
    "\"w.1.2\", \"value\": [1, 0], \"moment\": -3, \"at\": [0.1, 0.2] }, { \"kind\": "
    "\"force\", \"block\": \"base\", \"value\": [0, 0] } ] }, \"analysis\": { "
    "\"procedure\": "
    "\"displacement\", \"geometry\": \"nonlinear\", \"increments\": 7, "
    "\"max_multiplier\": "
    "0.7, \"multiplier_tolerance\": 3e-4, \"residual_tolerance\": 3e-9, \"snap\": "
    "\"stop\", "
    "\"flow\": \"non-associative\", \"control\": { \"block\": \"w.1.1\", \"component\": "
    "\"rz\", \"target\": -0.01 } }, \"view\": { \"a\": [1, "
    "null, { \"b\": \"c\" }] }, "
    "\"my own\": [true, 1e-7] }");
}

static void
test_examples (void)
{
  const char *root = g_getenv ("QUOIN_EXAMPLES");
  static const char *const folders[] = { ".", "ferris-tin-loi" };
  guint count = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (folders); i++) {
    char *folder = g_build_filename (root, folders[i], NULL);
    GDir *entries = g_dir_open (folder, 0, NULL);
    const char *name;
    while (entries != NULL && (name = g_dir_read_name (entries)) != NULL) {
      if (!g_str_has_suffix (name, ".quoin"))
        continue;
      char *path = g_build_filename (folder, name, NULL);
      QnProject project;
      GError *error = NULL;
      qn_project_load (path, NULL, &project, &error);
      g_assert_no_error (error);
      round_trip (&project);
      qn_project_clear (&project);
      g_free (path);
      count++;
    }
    g_clear_pointer (&entries, g_dir_close);
    g_free (folder);
  }
  g_assert_cmpuint (count, >, 6);
}

/* Random doubles as coordinates: the last bit survives. */
static void
test_digits (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  QnProject project;
  qn_project_init (&project);
  qn_model_clear (&project.model);
  test_model_init (&project.model);
  for (int i = 0; i < 200; i++) {
    g_autofree char *name = g_strdup_printf ("n%d", i);
    test_model_add_rectangle (&project.model, name, 3 * i + g_rand_double (random),
                              g_rand_double (random) * 1e-3, 0.1 + g_rand_double (random),
                              0.1 + g_rand_double (random) * 1e6);
  }
  g_assert_cmpint (qn_model_prepare (&project.model, NULL), ==, QN_OK);
  round_trip (&project);
  qn_project_clear (&project);
}

static void
test_layout (void)
{
  g_auto (QnProject) project;
  test_parse (test_project_text, &project);
  g_autofree char *text = qn_project_to_text (&project, NULL);
  g_assert_cmpstr (
    text, ==,
    "{\n"
    "  \"format\": \"quoin\", \"version\": 1,\n"
    "  \"laws\": [\n"
    "    { \"name\": \"joint\", \"kind\": \"coulomb\", \"basis\": \"contact\", \"kn\": "
    "10000000, "
    "\"ks\": 10000000, \"friction\": 0.65, \"cohesion\": 0, \"tension\": 0, "
    "\"dilatancy\": 0 } "
    "],\n"
    "  \"blocks\": [\n"
    "    { \"name\": \"base\", \"vertices\": [[0, -1], [2, -1], [2, 0], [0, 0]], "
    "\"thickness\": 1, \"unit_weight\": 10000, \"support\": [true, true, true] },\n"
    "    { \"name\": \"top\", \"vertices\": [[0.5, 0], [1.5, 0], [1.5, 1], [0.5, 1]], "
    "\"thickness\": 1, \"unit_weight\": 10000 } ],\n"
    "  \"contact\": { \"law\": \"joint\", \"tolerance\": 1e-6 },\n"
    "  \"loads\": {\n"
    "    \"dead\": [\n"
    "      { \"kind\": \"weight\", \"direction\": [0, -1] } ],\n"
    "    \"live\": [\n"
    "      { \"kind\": \"weight\", \"direction\": [1, 0] } ] },\n"
    "  \"analysis\": { \"procedure\": \"load\", \"geometry\": \"linear\", "
    "\"increments\": 100 }\n"
    "}\n");
}

/* Every kind of load on edges, with and without what may be left out; a case that nothing uses. */
static void
test_edge_loads (void)
{
  g_autofree char *text = test_replace (
    test_project_text, "\"loads\": {",
    "\"loads\": { \"cases\": { \"soil\": 1.35, \"a \\\"b\\\"\": 0 }, "
    "\"sets\": { \"s\": [ "
    "{ \"kind\": \"edge\", \"block\": \"top\", \"edge\": 3, \"count\": 2, "
    "\"part\": [0.25, 0.5], \"intensity\": [1, -2], \"direction\": [0, -1] }, "
    "{ \"kind\": \"edge\", \"case\": \"soil\", \"block\": \"top\", \"side\": \"left\", "
    "\"intensity\": 3 }, "
    "{ \"kind\": \"surcharge\", \"pressure\": 5000 }, "
    "{ \"kind\": \"surcharge\", \"unit_weight\": 2, \"level\": 3, \"from\": -1, "
    "\"to\": 1 }, "
    "{ \"kind\": \"backfill\", \"side\": \"right\", \"top\": 1, \"unit_weight\": 2, "
    "\"coefficient\": 0.3, \"mine\": 7 }, "
    "{ \"kind\": \"backfill\", \"case\": \"soil\", \"side\": \"left\", \"top\": 1, "
    "\"bottom\": 0.5, \"unit_weight\": 2, \"friction_angle\": 0.5, "
    "\"earth\": \"at-rest\", \"surcharge\": 4 } ] },");
  round_trip_text (text);
}

static void
test_save (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "copy.quoin", NULL);
  QnProject project, again;
  GError *error = NULL;
  test_parse (test_project_text, &project);
  g_assert_true (qn_project_save (&project, path, &error));
  g_assert_no_error (error);
  g_assert_true (qn_project_load (path, NULL, &again, &error));
  g_assert_no_error (error);
  qn_project_clear (&again);

  g_assert_false (qn_project_save (&project, "/dev/full", &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&error);
  qn_project_clear (&project);
}

/* Unknown members inside laws, blocks, contact, loads and analysis come back, whatever they
 * are, and stay with the block of their name when others go. */
static void
test_inner_members (void)
{
  static const char *const kept[] = {
    "\"source\": \"test 12\"", "\"colour\": ", "\"empty\": null",
    "\"remark\": true",        "\"note\": 5",  "\"by\": [1, 2]"
  };
  char *first = test_replace (test_project_text, "\"kn\": 1e7",
                              "\"kn\": 1e7, \"source\": \"test 12\"");
  char *second =
    test_replace (first, "\"name\": \"top\"",
                  "\"name\": \"top\", \"colour\": { \"r\": 1 }, \"empty\": null");
  char *third =
    test_replace (second, "\"contact\": {", "\"contact\": { \"remark\": true,");
  char *fourth = test_replace (third, "\"loads\": {", "\"loads\": { \"note\": 5,");
  char *text = test_replace (fourth, "\"version\": 1,",
                             "\"version\": 1, \"analysis\": { \"by\": [1, 2] },");
  g_auto (QnProject) project, again;
  test_parse (text, &project);
  char *written = qn_project_to_text (&project, NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (kept); i++)
    g_assert_nonnull (strstr (written, kept[i]));
  test_parse (written, &again);
  char *rewritten = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (rewritten, ==, written);
  g_assert_cmpuint (project.warnings->len, ==, again.warnings->len);
  char *list[] = { first, second, third, fourth, text, written, rewritten };
  for (size_t i = 0; i < G_N_ELEMENTS (list); i++)
    g_free (list[i]);
}

/* Members that no layer knows, in everything that has no name as well. */
static void
test_note_members (void)
{
  static const char json[] =
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"basis\": \"surface\","
    "    \"kn\": 1e9, \"ks\": 1e9, \"friction\": 0.6, \"k1\": 1 } ],"
    "  \"blocks\": [ { \"name\": \"a\", \"vertices\": [[0,0],[1,0],[1,1],[0,1]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true], "
    "\"k2\": 2 },"
    "    { \"name\": \"b\", \"vertices\": [[0,1],[1,1],[1,2],[0,2]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
    "  \"walls\": [ { \"name\": \"w\", \"origin\": [0, 2], \"unit\": [1, 1],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"courses\": [[1]], \"k3\": 3 } ],"
    "  \"sections\": [ { \"name\": \"s\", \"young\": 1e9, \"width\": 1, \"height\": 1,"
    "    \"k4\": 4 } ],"
    "  \"nodes\": [ { \"name\": \"n\", \"block\": \"b\", \"k5\": 5 },"
    "    { \"name\": \"m\", \"at\": [3, 3], \"k6\": 6 } ],"
    "  \"beams\": [ { \"name\": \"beam\", \"nodes\": [\"n\", \"m\"], \"section\": \"s\","
    "    \"k7\": 7 } ],"
    "  \"bars\": [ { \"law\": \"dry\", \"area\": 1e-4, \"start\": [0.5, 0.5],"
    "    \"end\": [0.5, 1.5], \"k8\": 8 } ],"
    "  \"contact\": { \"law\": \"dry\", \"pairs\": { \"placement\": \"ends\", \"k9\": 9 "
    "},"
    "    \"faces\": [ { \"blocks\": [\"a\", \"b\"], \"law\": \"dry\", \"k10\": 10 } ] },"
    "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] },"
    "      { \"kind\": \"weight\", \"direction\": [0, -1], \"k11\": 11 } ],"
    "    \"live\": [ { \"kind\": \"force\", \"block\": \"b\", \"value\": [1, 0], "
    "\"k12\": 12 } ],"
    "    \"sets\": { \"a.b\": [ { \"kind\": \"force\", \"block\": \"b\", \"value\": [2, "
    "0] },"
    "      { \"kind\": \"force\", \"block\": \"b\", \"value\": [3, 0], \"k13\": 13 } ] } "
    "},"
    "  \"analysis\": { \"control\": { \"block\": \"b\", \"component\": \"ux\","
    "      \"target\": 1, \"k14\": 14 },"
    "    \"stages\": [ { \"loads\": \"live\", \"target\": 1 },"
    "      { \"loads\": \"a.b\", \"target\": 1, \"k15\": { \"deep\": [15] } } ] } }";
  g_auto (QnProject) project, again;
  test_parse (json, &project);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  test_parse (written, &again);
  g_autofree char *rewritten = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (rewritten, ==, written);
  for (int k = 1; k <= 15; k++) {
    g_autofree char *member = k < 15 ? g_strdup_printf ("\"k%d\": %d", k, k)
                                     : g_strdup ("\"k15\": { \"deep\": [15] }");
    const char *first = strstr (written, member);
    g_assert_nonnull (first);
    g_assert_null (strstr (first + 1, member));
  }
  /* They are those of the second load of the set, and go where it goes. */
  QnModel *model = &again.model;
  g_assert_cmpint (model->live_loads[1].note, ==, 0);
  g_assert_cmpint (model->live_loads[2].note, !=, 0);
  QnLoad other = model->live_loads[1];
  model->live_loads[1] = model->live_loads[2];
  model->live_loads[2] = other;
  g_autofree char *swapped = qn_project_to_text (&again, NULL);
  g_assert_nonnull (strstr (swapped, "\"value\": [3, 0], \"k13\": 13 }"));
}

/* Load sets, settlements and stages. */
static void
test_stages (void)
{
  char *loads = test_replace (
    test_project_text, "\"loads\": {",
    "\"loads\": { \"sets\": { \"top\": [ { \"kind\": \"force\", \"block\": "
    "\"top\", \"value\": [0, -5] } ], \"ground, left\": [ { \"kind\": "
    "\"settlement\", \"block\": \"base\", \"component\": \"uy\", \"value\": -0.01 "
    "} ] },");
  char *text = test_replace (
    loads, "\"version\": 1,",
    "\"version\": 1, \"analysis\": { \"stages\": [ { \"name\": \"first\", \"loads\": "
    "[\"top\", "
    "\"live\"], \"target\": 2, \"increments\": 3 }, { \"loads\": \"ground, left\" "
    "}, { \"loads\": [\"live\", \"top\"], \"procedure\": \"displacement\", "
    "\"control\": { \"block\": \"top\", \"component\": \"ux\", \"target\": 0 } } "
    "] },");
  g_auto (QnProject) project, again;
  test_parse (text, &project);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  test_parse (written, &again);
  const QnProject *both[] = { &project, &again };
  for (int i = 0; i < 2; i++) {
    const QnModel *model = &both[i]->model;
    g_assert_cmpuint (model->load_set_count, ==, 2);
    g_assert_cmpstr (model->load_sets[1], ==, "ground, left");
    g_assert_cmpuint (model->stage_count, ==, 3);
    const QnStage *stages = model->stages;
    g_assert_cmpstr (stages[0].name, ==, "first");
    g_assert_cmpuint (stages[0].sets, ==, 3);
    g_assert_true (stages[0].has_target);
    g_assert_cmpfloat (stages[0].target, ==, 2);
    g_assert_cmpint (stages[0].increments, ==, 3);
    g_assert_null (stages[1].name);
    g_assert_cmpuint (stages[1].sets, ==, 4);
    g_assert_false (stages[1].has_target);
    g_assert_cmpint (stages[2].procedure, ==, QN_PROCEDURE_DISPLACEMENT);
    g_assert_cmpfloat (stages[2].control.target, ==, 0);
    const QnLoad *ground = &model->live_loads[model->live_load_count - 1];
    g_assert_cmpint (ground->kind, ==, QN_LOAD_SETTLEMENT);
    g_assert_cmpint (ground->set, ==, 2);
    g_assert_cmpint (ground->dof, ==, QN_DOF_UY);
    g_assert_cmpfloat (ground->value, ==, -0.01);
  }
  g_free (loads);
  g_free (text);
}

static char *
with_protocol (const char *protocol)
{
  g_autofree char *stage = g_strdup_printf (
    "\"version\": 1, \"analysis\": { \"stages\": [ { \"name\": \"push\", \"loads\": "
    "\"live\", "
    "\"procedure\": \"displacement\", \"control\": { \"block\": \"top\", \"component\": "
    "\"ux\" }, %s, \"key\": 1 }, { \"loads\": \"live\", \"target\": 3 } ] },",
    protocol);
  return test_replace (test_project_text, "\"version\": 1,", stage);
}

/* The short form of a cyclic protocol becomes three stages for each cycle, and is written as short as it was. */
static void
test_cycles (void)
{
  static const struct {
    const char *read, *written;
    guint cycles;
  } forms[] = {
    { "\"amplitudes\": [0.001, -0.002], \"cycles\": 2",
      "\"amplitudes\": [0.001, -0.002], \"cycles\": 2", 4 },
    { "\"amplitudes\": [0.001]", "\"amplitudes\": [0.001]", 1 },
    { "\"amplitudes\": [1, 1, 2]", "\"amplitudes\": [1, 1, 2]", 3 },
    { "\"amplitudes\": [1, 1, 2, 2]", "\"amplitudes\": [1, 2], \"cycles\": 2", 4 },
    { "\"amplitudes\": [1, 2, 2]", "\"amplitudes\": [1, 2, 2]", 3 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (forms); i++) {
    g_auto (QnProject) project, again;
    g_autofree char *text = with_protocol (forms[i].read);
    test_parse (text, &project);
    g_autofree char *written = qn_project_to_text (&project, NULL);
    g_assert_nonnull (strstr (written, forms[i].written));
    g_assert_null (strstr (strstr (written, "\"key\": 1") + 1, "\"key\""));
    test_parse (written, &again);
    const QnModel *model = &again.model;
    g_assert_cmpuint (model->stage_count, ==, 3 * forms[i].cycles + 1);
    for (guint s = 0; s < 3 * forms[i].cycles; s++) {
      const QnStage *stage = &model->stages[s];
      double there = project.model.stages[s - s % 3].control.target;
      g_assert_cmpint (stage->leg, ==, (int) s + 1);
      g_assert_cmpfloat (stage->control.target, ==,
                         s % 3 == 0   ? there
                         : s % 3 == 1 ? -there
                                      : 0);
      g_assert_cmpint (stage->control.block, ==, model->stages[0].control.block);
      g_assert_false (stage->has_target);
    }
    g_assert_cmpfloat (model->stages[3 * forms[i].cycles].target, ==, 3);
    g_autofree char *rewritten = qn_project_to_text (&again, NULL);
    g_assert_cmpstr (rewritten, ==, written);
  }
}

QN_TESTS
{
  g_test_add_func ("/project-write/small", test_small);
  g_test_add_func ("/project-write/like", test_like);
  g_test_add_func ("/project-write/everything", test_everything);
  g_test_add_func ("/project-write/examples", test_examples);
  g_test_add_func ("/project-write/digits", test_digits);
  g_test_add_func ("/project-write/layout", test_layout);
  g_test_add_func ("/project-write/save", test_save);
  g_test_add_func ("/project-write/edge-loads", test_edge_loads);
  g_test_add_func ("/project-write/inner-members", test_inner_members);
  g_test_add_func ("/project-write/note-members", test_note_members);
  g_test_add_func ("/project-write/stages", test_stages);
  g_test_add_func ("/project-write/cycles", test_cycles);
}
