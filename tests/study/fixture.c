#include "study/fixture.h"

char *
fixture_study_text (const char *plan, const char *more)
{
  return g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"title\": \"Sliding\",\n"
    "  \"model\": \"%s/01-sliding-block.quoin\", \"run\": \"solve\",\n"
    "  \"parameters\": [\n"
    "    { \"name\": \"friction\", \"path\": \"laws[0].friction\",\n"
    "      \"distribution\": { \"kind\": \"uniform\", \"min\": 0.2, \"max\": 0.8 },\n"
    "      \"levels\": 3 },\n"
    "    { \"name\": \"weight\", \"path\": \"blocks[1].unit_weight\",\n"
    "      \"range\": [10000, 20000, 3] } ],\n"
    "  \"plan\": %s,\n"
    "  \"outputs\": [\"collapse_multiplier\", \"mechanism_kind\"]%s }\n",
    g_getenv ("QUOIN_EXAMPLES"), plan, more);
}

gboolean
fixture_read (const char *folder, const char *text, QnStudy *study, GError **error)
{
  g_autofree char *path = g_build_filename (folder, "s.quoin-study", NULL);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  return qn_study_read (path, NULL, study, error);
}

void
fixture_study (QnStudy *study, const char *plan, const char *more)
{
  g_autofree char *text = fixture_study_text (plan, more);
  g_autoptr (GError) error = NULL;
  test_autoscratch char *folder = test_scratch_new ();
  fixture_read (folder, text, study, &error);
  g_assert_no_error (error);
}
