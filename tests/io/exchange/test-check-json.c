/* What `check` writes as JSON: one of everything that a project holds, and the faults of a result. */
#include "io/exchange/check-json.h"

#include "io/project-text.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <cjson/cJSON.h>
#include <string.h>

static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e9, \"ks\": 1e9,\n"
  "    \"friction\": 0.6 }],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"base\", \"vertices\": [[-2, -1], [2, -1], [2, 0], [-2, 0]],\n"
  "      \"thickness\": 1, \"unit_weight\": 1, \"support\": [true, true, true] },\n"
  "    { \"name\": \"stone\", \"vertices\": [[0, 0], [1, 0], [1, 2], [0, 2]],\n"
  "      \"thickness\": 1, \"unit_weight\": 20000 },\n"
  "    { \"name\": \"loose\", \"vertices\": [[5, 5], [6, 5], [6, 6]],\n"
  "      \"thickness\": 1, \"unit_weight\": 20000 } ],\n"
  "  \"sections\": [ { \"name\": \"iron\", \"young\": 2e11, \"poisson\": 0.3,\n"
  "    \"width\": 0.1, \"height\": 0.2, \"yield\": 2e8 } ],\n"
  "  \"nodes\": [ { \"name\": \"a\", \"block\": \"stone\", \"at\": [1, 1] },\n"
  "    { \"name\": \"b\", \"at\": [3, 1], \"support\": [true, true, true] } ],\n"
  "  \"beams\": [ { \"name\": \"strut\", \"nodes\": [\"a\", \"b\"],\n"
  "    \"section\": \"iron\" } ],\n"
  "  \"ties\": [ { \"name\": \"rod\", \"ends\": [{ \"block\": \"stone\", \"at\": [0, "
  "1.5] },\n"
  "    { \"at\": [-3, 1] }], \"area\": 2e-4, \"elasticity\": 2e11, \"yield\": 2.4e8,\n"
  "    \"plate\": { \"diameter\": 0.2, \"wall\": 0.5, \"shear\": 5e4,\n"
  "      \"compression\": 2e6 } } ],\n"
  "  \"contact\": { \"law\": \"joint\" },\n"
  "  \"loads\": { \"cases\": { \"own\": 1.5 },\n"
  "    \"dead\": [{ \"kind\": \"weight\", \"direction\": [0, -1], \"case\": \"own\" }],\n"
  "    \"live\": [{ \"kind\": \"force\", \"block\": \"stone\", \"value\": [1, 0] }] },\n"
  "  \"analysis\": { \"procedure\": \"dynamic\", \"dynamic\": { \"time_step\": 0.01,\n"
  "    \"ground\": [ { \"direction\": [1, 0], \"points\": [[0, 0], [0.1, 2], [0.2, 0]] "
  "},\n"
  "      { \"direction\": [0, 1], \"pulse\": { \"kind\": \"half-sine\", \"amplitude\": "
  "1,\n"
  "        \"duration\": 0.1 } } ] } } }\n";

static cJSON *
report (const QnResultFaults *faults)
{
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_autoptr (GPtrArray) unproved = g_ptr_array_new ();
  gsize length;
  test_parse (text, &project);
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
  g_ptr_array_add (unproved, (gpointer) "damage");
  g_ptr_array_add (unproved, (gpointer) "bound");
  const QnCheckReport of = { .project = &project,
                             .contacts = &contacts,
                             .result_name = "r.json",
                             .faults = faults,
                             .unproved = unproved };
  g_autofree char *json = qn_check_report_dup_json (&of, &length);
  cJSON *document = cJSON_ParseWithLength (json, length);
  g_assert_nonnull (document);
  return document;
}

static const cJSON *
at (const cJSON *document, const char *list, int index)
{
  const cJSON *item =
    cJSON_GetArrayItem (cJSON_GetObjectItemCaseSensitive (document, list), index);
  g_assert_nonnull (item);
  return item;
}

static void
assert_number (const cJSON *object, const char *key, double expected)
{
  g_assert_cmpfloat_with_epsilon (
    cJSON_GetNumberValue (cJSON_GetObjectItemCaseSensitive (object, key)), expected,
    1e-9 * fabs (expected));
}

static void
test_project (void)
{
  cJSON *document = report (NULL);
  assert_number (at (document, "nodes", 0), "block", 1);
  g_assert_false (cJSON_HasObjectItem (at (document, "nodes", 1), "block"));
  assert_number (at (document, "beams", 0), "length", 2);
  assert_number (at (document, "beams", 0), "plastic_moment", 2e8 * 0.1 * 0.04 / 4);
  assert_number (at (document, "ties", 0), "stiffness", 4e7 / hypot (3, 0.5));
  g_assert_true (cJSON_HasObjectItem (at (document, "ties", 0), "punching"));
  g_assert_true (cJSON_HasObjectItem (at (document, "ties", 0), "bearing"));
  assert_number (at (document, "loads", 0), "factor", 1.5);
  assert_number (at (document, "ground", 0), "peak", 2);
  g_assert_false (cJSON_HasObjectItem (at (document, "ground", 1), "samples"));
  assert_number (at (document, "faces", 0), "length", 1);
  g_assert_cmpstr (
    cJSON_GetStringValue (cJSON_GetObjectItem (at (document, "findings", 0), "problem")),
    ==, "block-without-contact");
  g_assert_false (cJSON_HasObjectItem (document, "result"));
  cJSON_Delete (document);
}

/* Of a result the equilibrium of the last step, unless there is none; at most one place out of balance. */
static void
test_faults (void)
{
  static const QnEntity entities[] = { QN_ENTITY_BLOCK, QN_ENTITY_NODE, QN_ENTITY_BEAM };
  static const char *const keys[] = { "unbalanced_block", "unbalanced_node",
                                      "unbalanced_element" };
  for (gsize i = 0; i < G_N_ELEMENTS (entities); i++) {
    const QnResultFaults faults = {
      .items = { { .claim = QN_CLAIM_LINEARITY,
                   .step = 2,
                   .index = QN_NONE,
                   .stated = NAN } },
      .count = 1,
      .last = { .multiplier = 0.5, .entity = entities[i], .index = 1 }
    };
    cJSON *document = report (&faults);
    const cJSON *result = cJSON_GetObjectItem (document, "result");
    g_assert_true (cJSON_IsFalse (cJSON_GetObjectItem (result, "passes")));
    assert_number (result, "multiplier", 0.5);
    for (gsize k = 0; k < G_N_ELEMENTS (keys); k++)
      assert_number (result, keys[k], k == i ? 1 : QN_NONE);
    assert_number (at (result, "faults", 0), "step", 2);
    g_assert_cmpstr (cJSON_GetStringValue (at (result, "not_proved", 1)), ==, "bound");
    cJSON_Delete (document);
  }
  const QnResultFaults moving = { .in_time = true, .last = { .multiplier = NAN } };
  cJSON *document = report (&moving);
  const cJSON *result = cJSON_GetObjectItem (document, "result");
  g_assert_true (cJSON_IsTrue (cJSON_GetObjectItem (result, "passes")));
  g_assert_false (cJSON_HasObjectItem (result, "multiplier"));
  cJSON_Delete (document);
}

QN_TESTS
{
  g_test_add_func ("/check-json/project", test_project);
  g_test_add_func ("/check-json/faults", test_faults);
}
