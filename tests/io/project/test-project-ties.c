/* Ties: read, written and read again; what is refused or doubted, with its place; and results that hold
 * their forces. */
#include "core/path/analysis.h"
#include "io/exchange/dxf-export.h"
#include "io/exchange/table-csv.h"
#include "io/project-text.h"
#include "io/result/result-file.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e9, \"ks\": 1e9,\n"
  "    \"friction\": 0.6 }],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"base\", \"vertices\": [[-2, -1], [2, -1], [2, 0], [-2, 0]],\n"
  "      \"thickness\": 1, \"unit_weight\": 1, \"support\": [true, true, true] },\n"
  "    { \"name\": \"stone\", \"vertices\": [[0, 0], [1, 0], [1, 2], [0, 2]],\n"
  "      \"thickness\": 1, \"unit_weight\": 20000 } ],\n"
  "  \"ties\": [\n"
  "    { \"name\": \"rod\", \"ends\": [{ \"block\": \"stone\", \"at\": [0, 1.5] },\n"
  "      { \"at\": [-3, 1] }], \"area\": 2e-4, \"elasticity\": 2e11, \"yield\": 2.4e8,\n"
  "      \"prestress\": 500, \"anchor\": 4000,\n"
  "      \"plate\": { \"diameter\": 0.2, \"wall\": 0.5, \"shear\": 5e4 } },\n"
  "    { \"ends\": [{ \"block\": \"stone\", \"at\": [0, 1] },\n"
  "      { \"block\": \"base\", \"at\": [-2, 0] }], \"area\": 1e-4, \"elasticity\": "
  "2e11,\n"
  "      \"slack\": 1e-3, \"yield\": 1e8, \"maker\": \"smith\",\n"
  "      \"strip\": { \"width\": 0.1, \"fracture_energy\": 300 } } ],\n"
  "  \"contact\": { \"law\": \"joint\" },\n"
  "  \"loads\": { \"dead\": [{ \"kind\": \"weight\", \"direction\": [0, -1] }],\n"
  "    \"live\": [{ \"kind\": \"force\", \"block\": \"stone\", \"value\": [1000, 0] }] "
  "},\n"
  "  \"analysis\": { \"max_multiplier\": 2 } }\n";

/* The canonical layout says all that there is, what the program does not know included. */
static void
test_round_trip (void)
{
  g_auto (QnProject) project, again;
  test_parse (text, &project);
  const QnTie *ties = project.model.ties;
  g_assert_cmpuint (project.model.tie_count, ==, 2);
  g_assert_cmpstr (ties[1].name, ==, "t2");
  g_assert_cmpint (ties[0].ends[1].block, ==, QN_NONE);
  g_assert_cmpint (ties[1].ends[1].block, ==, 0);
  g_assert_cmpfloat (qn_tie_strength (&ties[0]), ==, 4000);
  g_assert_cmpfloat (ties[1].slack, ==, 1e-3);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  g_assert_nonnull (strstr (written, "\"maker\": \"smith\""));
  test_parse (written, &again);
  g_autofree char *rewritten = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (written, ==, rewritten);
  for (size_t i = 0; i < 2; i++) {
    QnTie a = ties[i], b = again.model.ties[i];
    g_assert_cmpstr (a.name, ==, b.name);
    a.name = b.name = NULL;
    a.note = b.note;
    g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  }
}

static const struct {
  const char *from, *to, *path, *says;
} faults[] = {
  { "{ \"at\": [-3, 1] }", "{ \"block\": \"rock\", \"at\": [-3, 1] }",
    "ties[0].ends[1].block", "no block" },
  { "{ \"at\": [-3, 1] }", "{ \"block\": \"stone\", \"at\": [-3, 1] }", "ties[0].ends",
    "same block" },
  { "\"block\": \"stone\", \"at\": [0, 1.5]", "\"at\": [0, 1.5]", "ties[0].ends",
    "on the ground" },
  { "{ \"at\": [-3, 1] }", "{ \"at\": [0, 1.5] }", "ties[0].ends", "no length" },
  { ",\n      { \"at\": [-3, 1] }", "", "ties[0].ends", "two values" },
  { "{ \"at\": [-3, 1] }", "{ }", "ties[0].ends[1].at", "missing" },
  { "\"area\": 2e-4", "\"area\": 0", "ties[0].area", "positive" },
  { "\"yield\": 2.4e8", "\"yield\": -1", "ties[0].yield", "positive" },
  { "\"diameter\": 0.2, ", "", "ties[0].plate.diameter", "missing" },
  { "\"shear\": 5e4", "\"shear\": -1", "ties[0].plate.shear", "negative" },
  { "\"width\": 0.1, ", "", "ties[1].strip.width", "missing" },
  { "\"fracture_energy\": 300", "\"fracture_energy\": -1",
    "ties[1].strip.fracture_energy", "negative" },
  { "\"prestress\": 500", "\"prestress\": 5000", "ties[0].prestress", "holds" },
  { "\"prestress\": 500", "\"prestress\": 500, \"slack\": 1e-3", "ties[0].slack",
    "no slack" },
  { "{ \"ends\"", "{ \"name\": \"rod\", \"ends\"", "ties[1].name", "twice" },
};

static void
test_faults (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (faults); i++) {
    QnProject project;
    GError *error = NULL;
    g_autofree char *spoiled = test_replace (text, faults[i].from, faults[i].to);
    g_autofree char *path = g_strconcat (": ", faults[i].path, NULL);
    g_assert_false (
      qn_project_parse (spoiled, strlen (spoiled), "t.quoin", NULL, &project, &error));
    g_test_message ("%s", error->message);
    g_assert_nonnull (strstr (error->message, path));
    g_assert_nonnull (strstr (error->message, faults[i].says));
    g_clear_error (&error);
  }
}

/* Ends beside their block, and numbers in other units, are told with their place. */
static void
test_findings (void)
{
  static const struct {
    const char *from, *to, *path;
  } doubts[] = {
    { "\"at\": [0, 1.5]", "\"at\": [-0.2, 1.5]", "ties[0]: end of the tie" },
    { "\"area\": 2e-4", "\"area\": 200", "ties[0].area" },
    { "\"elasticity\": 2e11, \"yield\"", "\"elasticity\": 2e5, \"yield\"",
      "ties[0].elasticity" },
    { "\"yield\": 2.4e8", "\"yield\": 240", "ties[0].yield" },
    { "\"prestress\": 500", "\"prestress\": 0.5", "ties[0].prestress" },
    { "\"slack\": 1e-3", "\"slack\": 1", "ties[1].slack" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (doubts); i++) {
    g_auto (QnProject) project;
    g_auto (QnContacts) contacts;
    g_autofree char *odd = test_replace (text, doubts[i].from, doubts[i].to);
    /* Keeps the prestress below the strength. */
    g_autofree char *strong = test_replace (odd, "\"anchor\": 4000", "\"anchor\": 4001");
    if (i == 3) {
      g_autofree char *less = test_replace (strong, "\"prestress\": 500,", "");
      test_parse (less, &project);
    } else {
      test_parse (strong, &project);
    }
    g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
    g_autoptr (GPtrArray) lines =
      qn_project_dup_finding_texts (&project, &contacts.findings);
    gboolean found = FALSE;
    for (guint k = 0; k < lines->len; k++)
      found |= strstr (lines->pdata[k], doubts[i].path) != NULL;
    g_test_message ("%s", doubts[i].path);
    g_assert_true (found);
  }
}

/* Solved, written, read: the same, and in balance by the file alone; a number that is changed is found. */
static void
check_result (const char *override, const char *procedure)
{
  const char *const overrides[] = { override, procedure, NULL };
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  g_auto (QnResultFile) file;
  QnResultFaults found;
  GError *error = NULL;
  g_assert_true (
    qn_project_parse (text, strlen (text), "t.quoin", overrides, &project, &error));
  const QnModel *model = &project.model;
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "ties.json", NULL);
  g_assert_true (
    qn_result_file_write (path, &project, &contacts, &result, QN_DETAIL_FORCES, &error));
  g_assert_true (qn_result_file_read (path, &file, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (file.result.tie_count, ==, 2);
  size_t last = 2 * (result.step_count - 1);
  g_assert_cmpuint (result.step_count, ==, file.result.step_count);
  for (size_t i = result.limit.given ? last : 0; i < last + 2; i++) {
    g_assert_cmpfloat (file.result.ties[i].force, ==, result.ties[i].force);
    g_assert_cmpfloat (file.result.ties[i].elongation, ==, result.ties[i].elongation);
    g_assert_cmpint (file.result.ties[i].state, ==, result.ties[i].state);
  }
  for (int spoil = 0; spoil < 4; spoil++) {
    QnTieResult *tie = &result.ties[last], kept = *tie;
    tie->force += spoil == 1 ? 5 : 0;
    tie->elongation += spoil == 2 ? 1e-6 : 0;
    tie->state =
      spoil == 3 ? (QnTieState) ((kept.state + 1) % QN_TIE_STATE_COUNT) : kept.state;
    g_assert_cmpint (qn_result_find_faults (model, &contacts, &result,
                                            QN_CHECK_RECOMPUTED, &found, NULL),
                     ==, QN_OK);
    bool told = false;
    for (int i = 0; i < found.count; i++)
      told |=
        found.items[i].claim == QN_CLAIM_TIES || found.items[i].claim == QN_CLAIM_BALANCE;
    g_test_message ("%s, spoilt %d: %d faults", procedure, spoil, found.count);
    g_assert_true (spoil == 0 ? found.count == 0 : told);
    g_assert_true (spoil == 1 || found.last.out_of_balance < 1e-6);
    *tie = kept;
  }
  /* A row for every step that tells them and every tie; lines on a layer of their own. */
  g_autofree char *table = g_build_filename (folder, "ties.csv", NULL);
  g_autofree char *drawing = g_build_filename (folder, "ties.dxf", NULL);
  g_autofree char *rows = NULL, *dxf = NULL;
  g_assert_true (
    qn_result_table_write (table, QN_TABLE_TIES, &project, &contacts, &result, &error));
  g_assert_true (g_file_get_contents (table, &rows, NULL, NULL));
  g_auto (GStrv) lines = g_strsplit (rows, "\n", -1);
  size_t told = result.limit.given ? 1 : result.step_count;
  g_assert_cmpuint (g_strv_length (lines), ==, 2 + 2 * told);
  g_autofree char *begins = g_strdup_printf ("%zu,", result.step_count - told);
  g_assert_true (g_str_has_prefix (lines[1], begins));
  g_assert_nonnull (strstr (lines[1], ",rod,"));
  g_assert_true (qn_dxf_export (model, &contacts, NULL, 1, 1, drawing, &error));
  g_assert_true (g_file_get_contents (drawing, &dxf, NULL, NULL));
  g_auto (GStrv) pieces = g_strsplit (dxf, "  8\nTIES\n", -1);
  g_assert_cmpuint (g_strv_length (pieces), ==, 3);
  test_scratch_free (folder);
}

static void
test_results (void)
{
  check_result ("analysis.geometry=linear", "analysis.procedure=load");
  check_result ("analysis.geometry=nonlinear", "analysis.procedure=load");
  check_result ("analysis.geometry=linear", "analysis.procedure=limit");
}

QN_TESTS
{
  g_test_add_func ("/project-ties/round-trip", test_round_trip);
  g_test_add_func ("/project-ties/faults", test_faults);
  g_test_add_func ("/project-ties/findings", test_findings);
  g_test_add_func ("/project-ties/results", test_results);
}
