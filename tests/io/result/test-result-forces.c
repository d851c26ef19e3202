
#include "io/result-fixture.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

/* Gives both steps of the fixture forces of their own. */
static void
add_forces (ResultFixture *fixture)
{
  QnResult *result = &fixture->result;
  size_t count = result->step_count * result->pair_count;
  g_assert_cmpuint (count, ==, 4);
  result->step_forces = calloc (2 * count, sizeof (double));
  result->step_states = calloc (count, 1);
  for (size_t i = 0; i < 2 * count; i++)
    result->step_forces[i] = -1234.5678 * (double) i;
  result->step_states[0] = QN_PAIR_OPEN;
  result->step_states[3] = QN_PAIR_SLIP;
}

static void
test_round_trip (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_auto (QnResultFile) file;
  GError *error = NULL;
  add_forces (fixture);
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_nonnull (strstr (text, "\"states\": \"ok\""));
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_no_error (error);
  for (size_t s = 0; s < 2; s++) {
    g_assert_true (qn_result_has_forces (&file.result, s));
    for (size_t i = 0; i < 4; i++)
      g_assert_cmpfloat_with_epsilon (file.result.step_forces[4 * s + i],
                                      fixture->result.step_forces[4 * s + i], 1e-3);
  }
  g_assert_cmpint (qn_result_pair_at (&file.result, 0, 0).state, ==, QN_PAIR_OPEN);
  g_assert_cmpint (file.result.step_states[3], ==, QN_PAIR_SLIP);
}

/* Results without them, of earlier programs or too large, know their last step. */
static void
test_without (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_auto (QnResultFile) file;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_null (strstr (text, "\"forces\""));
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, NULL));
  g_assert_false (qn_result_has_forces (&file.result, 0));
  g_assert_true (qn_result_has_forces (&file.result, 1));
}

static void
expect_refusal (const char *text, const char *from, const char *to, const char *reason)
{
  QnResultFile file;
  g_autoptr (GError) error = NULL;
  g_auto (GStrv) parts = g_strsplit (text, from, 2);
  g_assert_nonnull (parts[1]);
  g_autofree char *changed = g_strconcat (parts[0], to, parts[1], NULL);
  g_assert_false (
    qn_result_file_parse (changed, strlen (changed), "r.json", &file, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_nonnull (strstr (error->message, reason));
}

static void
test_refusals (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  add_forces (fixture);
  g_autofree char *text = result_fixture_dup_text (fixture);
  expect_refusal (text, "\"ok\"", "\"oz\"", "letters");
  expect_refusal (text, "\"ok\"", "\"o\"", "as many forces as contacts");
  expect_refusal (text, "\"forces\": [0,", "\"forces\": [", "as many forces as contacts");
  expect_refusal (text, "\"forces\": [0,", "\"forces\": [\"0\",", "forces[0]");
}

/* Damage of bonds is read as it was written, of the steps that have any; the reason counts them. */
static void
test_damage (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  static const double damage[4] = { 0, 0, 1, 0.125 };
  g_auto (QnResultFile) file;
  GError *error = NULL;
  add_forces (fixture);
  fixture->result.step_damage = calloc (4, sizeof (double));
  memcpy (fixture->result.step_damage, damage, sizeof damage);
  fixture->result.pairs[0].damage = 1;
  fixture->result.pairs[1].damage = 0.125;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_nonnull (strstr (text, "\"damage\": [0, 1, 1, 0.125]"));
  g_assert_nonnull (strstr (text, "bond of 1 contact pairs is broken, and that of 1"));
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_no_error (error);
  g_assert_cmpmem (file.result.step_damage, sizeof damage, damage, sizeof damage);
  g_assert_cmpfloat (file.result.pairs[0].damage, ==, 1);
  g_assert_cmpfloat (qn_result_pair_at (&file.result, 0, 1).damage, ==, 0);
  expect_refusal (text, "[0, 1, 1, 0.125]", "[0, 1, 7, 0.125]", "forces");
  expect_refusal (text, "[0, 1, 1, 0.125]", "[0, 1, 1, 1.5]", "forces");
  expect_refusal (text, "[0, 1, 1, 0.125]", "[0, 1, 1]", "forces");
}

QN_TESTS
{
  g_test_add ("/io/result-forces/damage", ResultFixture, NULL, result_fixture_set_up,
              test_damage, result_fixture_tear_down);
  g_test_add ("/io/result-forces/round-trip", ResultFixture, NULL, result_fixture_set_up,
              test_round_trip, result_fixture_tear_down);
  g_test_add ("/io/result-forces/without", ResultFixture, NULL, result_fixture_set_up,
              test_without, result_fixture_tear_down);
  g_test_add ("/io/result-forces/refusals", ResultFixture, NULL, result_fixture_set_up,
              test_refusals, result_fixture_tear_down);
}
