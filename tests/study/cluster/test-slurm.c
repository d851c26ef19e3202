/* What a submission asks Slurm for; the rest is tested with a controller (tests/cli/slurm). */
#include "study/cluster/slurm.h"

#include "study/fixture.h"
#include "support/room.h"

#include <string.h>

static void
expect_range (const char *marks, const char *expected)
{
  guint8 flags[16];
  for (gsize i = 0; marks[i] != '\0'; i++)
    flags[i] = marks[i] == 'x';
  g_autofree char *range = qn_slurm_dup_range (flags, (guint) strlen (marks));
  g_assert_cmpstr (range, ==, expected);
}

static void
test_ranges (void)
{
  expect_range ("....", "");
  expect_range ("x...", "1");
  expect_range ("xxxx", "1-4");
  expect_range ("x.xx.x", "1,3-4,6");
}

/* A folder with a space, a percent sign and a quote. */
static void
test_script (void)
{
  g_auto (QnStudy) study;
  QnSubmission submission;
  g_autoptr (GError) error = NULL;
  test_autoscratch char *scratch = test_scratch_new ();
  g_autofree char *folder = g_build_filename (scratch, "a 50 % 'slice'", NULL);
  QnSlurmSettings settings = {
    .program = "/usr/bin/quoin-cli", .array_size = 4, .partition = "long", .dry_run = TRUE
  };
  fixture_study (&study, "{ \"kind\": \"monte-carlo\", \"count\": 10 }", "");
  g_assert_true (qn_folder_prepare (folder, &study, &error));
  g_assert_true (qn_study_submit (&study, folder, &settings, &submission, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (submission.tasks, ==, 4);
  g_assert_cmpuint (submission.missing, ==, 10);
  g_assert_null (submission.job);
  static const char *const parts[] = { "#!/bin/sh\n",
                                       "--array=1-4\n",
                                       "--partition=long\n",
                                       "a 50 %% 'slice'/slurm-%A-%a.log\"\n",
                                       "a 50 % '\\''slice'\\'''",
                                       "--shard \"$SLURM_ARRAY_TASK_ID/4\"" };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++)
    if (strstr (submission.script, parts[i]) == NULL)
      g_test_fail_printf ("'%s' lacks '%s'", submission.script, parts[i]);
  qn_submission_clear (&submission);
  /* No more slices than cases. */
  settings.array_size = 99;
  g_assert_true (qn_study_submit (&study, folder, &settings, &submission, &error));
  g_assert_cmpuint (submission.tasks, ==, 10);
  qn_submission_clear (&submission);
}

QN_TESTS
{
  g_test_add_func ("/study/slurm/ranges", test_ranges);
  g_test_add_func ("/study/slurm/script", test_script);
}
