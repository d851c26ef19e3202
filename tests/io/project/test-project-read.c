/* The document as a whole, its entry points and what they refuse. */
#include "io/project-text.h"
#include "io/project/project.h"
#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

#include <cjson/cJSON.h>
#include <string.h>

/* A project with every key of the format. */
static const char full[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"Täst\", \"gravity\": 10,\n"
  "  \"laws\": [ { \"name\": \"j\", \"kind\": \"coulomb\", \"basis\": \"contact\", "
  "\"kn\": 1e7,\n"
  "    \"ks\": 2e7, \"friction\": 0.65, \"cohesion\": 1, \"tension\": 2, \"dilatancy\": "
  "0.1 },\n"
  "    { \"name\": \"glue\", \"kind\": \"elastic\", \"kn\": 1e9, \"ks\": 1e9 } ],\n"
  "  \"blocks\": [ { \"name\": \"base\", \"vertices\": [[0, -1], [2, -1], [2, 0], [0, "
  "0]],\n"
  "    \"thickness\": 0.5, \"density\": 1800, \"support\": [true, true, true],\n"
  "    \"law\": \"glue\" } ],\n"
  "  \"walls\": [ { \"name\": \"w\", \"origin\": [0, 0], \"unit\": [1, 0.5],\n"
  "    \"thickness\": 0.5, \"unit_weight\": 20000, \"courses\": [[1, 1], [0.5, -1, 0.5]] "
  "} ],\n"
  "  \"contact\": { \"law\": \"j\", \"tolerance\": 1e-5,\n"
  "    \"pairs\": { \"placement\": \"uniform\", \"count\": 3 },\n"
  "    \"faces\": [ { \"blocks\": [\"w.1.1\", \"base\"], \"law\": \"glue\",\n"
  "      \"pairs\": { \"placement\": \"ends\", \"offset\": 0.02 } } ] },\n"
  "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],\n"
  "    \"live\": [ { \"kind\": \"force\", \"block\": \"w.2.2\", \"value\": [3, 4],\n"
  "      \"moment\": 5, \"at\": [1, 1] } ] },\n"
  "  \"analysis\": { \"procedure\": \"displacement\", \"geometry\": \"linear\",\n"
  "    \"increments\": 37, \"max_multiplier\": 2, \"multiplier_tolerance\": 1e-3,\n"
  "    \"residual_tolerance\": 1e-7, \"snap\": \"stop\", \"flow\": \"non-associative\",\n"
  "    \"control\": { \"block\": \"w.2.1\", \"component\": \"ux\", \"target\": 0.05 } "
  "},\n"
  "  \"view\": { \"zoom\": 2 }, \"figures\": [[\"no\", \"figure\"]] }";

static void
check_settings (const QnModel *model)
{
  g_assert_cmpfloat (model->contact.tolerance, ==, 1e-5);
  g_assert_cmpint (model->contact.pairs.placement, ==, QN_PLACEMENT_UNIFORM);
  g_assert_cmpint (model->contact.pairs.count, ==, 3);
  g_assert_cmpuint (model->override_count, ==, 1);
  g_assert_cmpint (model->overrides[0].block_a, ==, qn_model_find_block (model, "w.1.1"));
  g_assert_cmpint (model->overrides[0].block_b, ==, 0);
  g_assert_cmpint (model->overrides[0].law, ==, 1);
  g_assert_true (model->overrides[0].has_pairs);
  g_assert_cmpfloat (model->overrides[0].pairs.offset, ==, 0.02);

  const QnAnalysisSettings *analysis = &model->analysis;
  g_assert_cmpint (analysis->procedure, ==, QN_PROCEDURE_DISPLACEMENT);
  g_assert_cmpint (analysis->increments, ==, 37);
  g_assert_cmpfloat (analysis->max_multiplier, ==, 2);
  g_assert_cmpfloat (analysis->multiplier_tolerance, ==, 1e-3);
  g_assert_cmpfloat (analysis->residual_tolerance, ==, 1e-7);
  g_assert_cmpint (analysis->snap, ==, QN_SNAP_THROUGH_STOP);
  g_assert_cmpint (analysis->flow, ==, QN_FLOW_NON_ASSOCIATIVE);
  g_assert_cmpint (analysis->control.block, ==, qn_model_find_block (model, "w.2.1"));
  g_assert_cmpint (analysis->control.dof, ==, QN_DOF_UX);
  g_assert_cmpfloat (analysis->control.target, ==, 0.05);
}

static void
test_every_key (void)
{
  g_auto (QnProject) project;
  test_parse (full, &project);
  const QnModel *model = &project.model;
  g_assert_cmpuint (project.warnings->len, ==, 0);
  g_assert_cmpstr (model->title, ==, "Täst");
  g_assert_cmpfloat (model->gravity, ==, 10);
  g_assert_cmpuint (model->law_count, ==, 2);
  g_assert_cmpfloat (model->laws[0].ks, ==, 2e7);
  g_assert_cmpfloat (model->laws[0].cohesion, ==, 1);
  g_assert_cmpfloat (model->laws[0].tension, ==, 2);
  g_assert_cmpfloat (model->laws[0].dilatancy, ==, 0.1);
  g_assert_cmpint (model->laws[1].kind, ==, QN_LAW_ELASTIC);
  g_assert_cmpuint (model->block_count, ==, 5);
  g_assert_cmpfloat (model->blocks[0].unit_weight, ==, 18000);
  g_assert_cmpint (model->blocks[0].law, ==, 1);
  g_assert_cmpstr (model->blocks[4].name, ==, "w.2.2");
  g_assert_cmpfloat (model->blocks[4].centroid.x, ==, 1.75);
  check_settings (model);

  g_assert_cmpuint (model->live_load_count, ==, 1);
  g_assert_cmpint (model->live_loads[0].block, ==, 4);
  g_assert_cmpfloat (model->live_loads[0].moment, ==, 5);
  g_assert_true (model->live_loads[0].has_at);
  g_assert_nonnull (cJSON_GetObjectItem (project.extras, "view"));
  g_assert_nonnull (cJSON_GetObjectItem (project.extras, "figures"));
}

static void
test_defaults (void)
{
  g_auto (QnProject) project;
  test_parse (test_project_text, &project);
  const QnModel *model = &project.model;
  g_assert_null (model->title);
  g_assert_cmpint (model->laws[0].basis, ==, QN_BASIS_CONTACT);
  g_assert_cmpfloat (model->laws[0].dilatancy, ==, 0);
  g_assert_cmpint (model->analysis.procedure, ==, QN_PROCEDURE_LOAD);
  g_assert_cmpint (model->analysis.increments, ==, 100);
  g_assert_true (isinf (model->analysis.max_multiplier));
  g_assert_cmpfloat (model->analysis.multiplier_tolerance, ==, 1e-4);
  g_assert_cmpfloat (model->analysis.residual_tolerance, ==, 1e-8);
  g_assert_cmpint (model->analysis.snap, ==, QN_SNAP_THROUGH_JUMP);
  g_assert_cmpint (model->contact.pairs.placement, ==, QN_PLACEMENT_DEFAULT);
  g_assert_cmpfloat (model->contact.pairs.offset, ==, 0);
  g_assert_null (project.extras);
  g_assert_null (project.path);
}

static void
test_unknown_keys (void)
{
  char *text =
    test_replace (test_project_text, "\"kn\": 1e7", "\"kn\": 1e7, \"colour\": 3");
  g_autofree char *more = test_replace (text, "  \"laws\"", "  \"ropes\": [], \"laws\"");
  g_auto (QnProject) project;
  test_parse (more, &project);
  g_assert_cmpuint (project.warnings->len, ==, 2);
  g_assert_cmpstr (g_ptr_array_index (project.warnings, 0), ==,
                   "wall.quoin:3:12: ropes: unknown key");
  g_assert_cmpstr (g_ptr_array_index (project.warnings, 1), ==,
                   "wall.quoin:4:64: laws[0].colour: unknown key");
  g_free (text);
}

/* The solver's switches were settings of a project once. */
static void
test_shortcuts_of_older_files (void)
{
  char *text = test_replace (full, "\"snap\": \"stop\",",
                             "\"snap\": \"stop\", \"shortcuts\": "
                             "{ \"growing_increments\": false },");
  g_auto (QnProject) project;
  test_parse (text, &project);
  g_assert_cmpuint (project.warnings->len, ==, 1);
  g_assert_true (g_str_has_suffix (g_ptr_array_index (project.warnings, 0),
                                   ": analysis.shortcuts: unknown key"));
  check_settings (&project.model);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  g_assert_nonnull (strstr (written, "\"growing_increments\""));
  g_free (text);
}

static void
test_overrides (void)
{
  static const char *const overrides[] = { "analysis.increments=37",
                                           "laws[0].dilatancy=0.65",
                                           "contact.pairs.offset=0.02",
                                           "analysis.snap=stop", NULL };
  g_auto (QnProject) project;
  GError *error = NULL;
  g_assert_true (qn_project_parse (test_project_text, strlen (test_project_text),
                                   "wall.quoin", overrides, &project, &error));
  g_assert_no_error (error);
  g_assert_cmpint (project.model.analysis.increments, ==, 37);
  g_assert_cmpfloat (project.model.laws[0].dilatancy, ==, 0.65);
  g_assert_cmpfloat (project.model.contact.pairs.offset, ==, 0.02);
  g_assert_cmpint (project.model.analysis.snap, ==, QN_SNAP_THROUGH_STOP);
  g_assert_cmpstr (project.overrides[1], ==, "laws[0].dilatancy=0.65");

  /* The sum is that of the file, whatever was overridden. */
  g_autofree char *sum =
    g_compute_checksum_for_string (G_CHECKSUM_SHA256, test_project_text, -1);
  g_assert_cmpstr (project.sha256, ==, sum);
}

static void
expect_override_error (const char *override, const char *message)
{
  const char *const overrides[] = { override, NULL };
  g_autofree char *found = test_parse_error (test_project_text, overrides);
  g_assert_cmpstr (found, ==, message);
}

/* A key that changes nothing, set by an override: no answer of a project without it. In the file the
 * same key is a warning. */
static void
test_idle_overrides (void)
{
  static const char *const rows[][2] = {
    { "analysis.incrments=3", "unknown key; the nearest known one is \"increments\"" },
    { "anlysis.increments=3", "unknown key; the nearest known one is \"analysis\"" },
    { "laws[0].frictoin=1", "unknown key; the nearest known one is \"friction\"" },
    { "laws[0].yield=1", "has no effect for this kind of law" },
    { "contact.pairs={\"offst\": 1}", "the nearest known one is \"offset\"" },
    { "contact.pairs.count=3", "has no effect with this placement" },
    { "loads.live[0].factor=2", "unknown key" },
    { "blocks[0].widht=1", "unknown key" },
    { "analysis.control.componet=ux", "the nearest known one is \"component\"" },
    { "analysis.dynamic={\"durration\": 1}", "the nearest known one is \"duration\"" },
    { "masonry=[{\"kind\": \"arch\", \"spam\": 1}]",
      "the nearest known one is \"span\"" },
    { "colour=3", "unknown key" },
    { "report={\"demnd\": 0.3}",
      "report.demnd: unknown key; the nearest known one is \"demand\"" },
    { "capacity={\"spectrm\": \"type1\"}", "the nearest known one is \"spectrum\"" },
    { "underlay={\"imag\": \"a.png\"}", "the nearest known one is \"image\"" },
    { "figures=[{\"name\": \"a\"}, {\"viw\": \"model\"}]",
      "figures[1].viw: unknown key" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++) {
    const char *const overrides[] = { rows[i][0], NULL };
    QnProject project;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_project_parse (test_project_text, strlen (test_project_text),
                                      "wall.quoin", overrides, &project, &error));
    g_test_message ("%s", error->message);
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
    g_assert_nonnull (strstr (error->message, rows[i][1]));
    g_assert_nonnull (strstr (error->message, "(set by "));
  }
}

static void
test_override_errors (void)
{
  expect_override_error ("laws[0].friction=-1",
                         " laws[0].friction: number must not be negative "
                         "(set by \"laws[0].friction=-1\")");
  expect_override_error ("laws[0].dilatancy=0.7",
                         " laws[0].dilatancy: dilatancy exceeds friction "
                         "(set by \"laws[0].dilatancy=0.7\")");
  expect_override_error ("analysis.increments=many",
                         " analysis.increments: expected a number, found a string "
                         "(set by \"analysis.increments=many\")");
  expect_override_error ("laws[7].kn=1",
                         " \"laws[7].kn=1\": the project has no such place: laws has 1 "
                         "element, counted from 0");

  static const char *const malformed[] = { "analysis", NULL };
  QnProject project;
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_project_parse (test_project_text, strlen (test_project_text),
                                    "wall.quoin", malformed, &project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
}

/* Texts that are no project at all: the place and the reason. */
static void
test_no_project (void)
{
  static const char *const cases[][2] = {
    { "", "1:1: file is empty" },
    { "not JSON", "1:1: this is not a JSON value" },
    { "[]", "1:1: expected an object, found an array" },
    { "3", "1:1: expected an object, found a number" },
    { "{}", "1:1: format: required key is missing" },
    { "{ \"format\": 1 }", "1:13: format: expected a string, found a number" },
    { "{ \"format\": \"quoin-result\", \"version\": 1 }",
      "1:13: format: this is not a Quoin project: expected \"quoin\"" },
    { "{ \"format\": \"quoin\" }", "1:1: version: required key is missing" },
    { "{ \"format\": \"quoin\", \"version\": 2 }",
      "1:33: version: this program reads version 1 of the format only" },
    { "{ \"format\": \"quoin\", \"version\": \"1\" }",
      "1:33: version: expected a number, found a string" },
    { "{ \"format\": \"quoin\", \"version\": 1 }", "1:1: laws: required key is missing" },
    { "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [] }",
      "1:44: laws: there must be at least one law" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *message = test_parse_error (cases[i][0], NULL);
    g_assert_cmpstr (message, ==, cases[i][1]);
  }
}

/* Wherever the text stops, it is refused in one line. */
static void
test_truncated (void)
{
  gsize length = strlen (test_project_text) - 2;
  for (gsize i = 0; i < length; i++) {
    g_autofree char *text = g_strndup (test_project_text, i);
    g_free (test_parse_error (text, NULL));
  }
  g_autofree char *longer = g_strconcat (test_project_text, "x", NULL);
  g_autofree char *message = test_parse_error (longer, NULL);
  g_assert_cmpstr (message, ==, "11:1: text after the end of the document");
}

static void
test_deep_nesting (void)
{
  g_autofree char *brackets = g_strnfill (10000000, '[');
  g_autofree char *message = test_parse_error (brackets, NULL);
  g_assert_nonnull (strstr (message, "nested too deeply"));
  g_assert_cmpuint (strlen (message), <, 1000);
}

static void
test_files (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "wall.quoin", NULL);
  QnProject project;
  GError *error = NULL;

  g_assert_false (qn_project_load (path, NULL, &project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&error);
  g_assert_false (qn_project_load (folder, NULL, &project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&error);

  g_assert_true (g_file_set_contents (path, test_project_text, -1, NULL));
  g_assert_true (qn_project_load (path, NULL, &project, &error));
  g_assert_no_error (error);
  g_assert_cmpstr (project.path, ==, path);
  g_assert_cmpuint (project.model.block_count, ==, 2);
  qn_project_clear (&project);

  g_assert_true (g_file_set_contents (path, "\xff\xfe{", 3, NULL));
  g_assert_false (qn_project_load (path, NULL, &project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_true (g_str_has_suffix (error->message, "wall.quoin:1:1: text is not UTF-8"));
  g_clear_error (&error);
}

static void
test_large (void)
{
  enum { BLOCKS = 100000 };
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_append_len (text, test_project_text,
                       strstr (test_project_text, " ],\n  \"contact\"")
                         - test_project_text);
  for (int i = 0; i < BLOCKS; i++)
    g_string_append_printf (
      text,
      ",\n{ \"name\": \"n%d\", \"vertices\": [[%d, 2], [%d.5, 2], [%d.5, 3], "
      "[%d, 3]], \"thickness\": 1, \"unit_weight\": 10000 }",
      i, i, i, i, i);
  g_string_append (text, strstr (test_project_text, " ],\n  \"contact\""));
  g_auto (QnProject) project;
  test_parse (text->str, &project);
  g_assert_cmpuint (project.model.block_count, ==, BLOCKS + 2);
}

QN_TESTS
{
  g_test_add_func ("/project-read/every-key", test_every_key);
  g_test_add_func ("/project-read/defaults", test_defaults);
  g_test_add_func ("/project-read/unknown-keys", test_unknown_keys);
  g_test_add_func ("/project-read/shortcuts", test_shortcuts_of_older_files);
  g_test_add_func ("/project-read/overrides", test_overrides);
  g_test_add_func ("/project-read/override-errors", test_override_errors);
  g_test_add_func ("/project-read/idle-overrides", test_idle_overrides);
  g_test_add_func ("/project-read/no-project", test_no_project);
  g_test_add_func ("/project-read/truncated", test_truncated);
  g_test_add_func ("/project-read/deep-nesting", test_deep_nesting);
  g_test_add_func ("/project-read/files", test_files);
  g_test_add_func ("/project-read/large", test_large);
}
