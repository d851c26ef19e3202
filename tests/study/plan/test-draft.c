/* Study files that are being written: edits, undo, what stays as it was. */
#include "study/plan/draft.h"

#include "study/fixture.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static void
test_new (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "s.quoin-study", NULL);
  g_autofree char *model =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "01-sliding-block.quoin", NULL);
  g_autoptr (GError) error = NULL;
  QnDraft *draft = qn_draft_new (path, model, QN_STUDY_SOLVE);
  QnStudy study;
  int count;
  g_assert_true (qn_draft_vary (draft, "laws[0].friction", 0.5, FALSE));
  g_assert_false (qn_draft_vary (draft, "laws[0].friction", 0.5, FALSE));
  g_assert_true (qn_draft_vary (draft, "laws[0].kn", 1e7, FALSE));
  qn_draft_set_values (draft, 1, QN_DRAFT_LOGNORMAL, 1e7, 2e6, 0);
  qn_draft_set_plan (draft, QN_PLAN_GRID, 0);
  g_assert_true (qn_draft_save (draft, &error));
  g_assert_no_error (error);
  g_assert_true (qn_study_read (path, NULL, &study, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (qn_study_case_count (&study), ==, 25); /* levels came by themselves */
  qn_study_clear (&study);

  QnDraftParameter kn = qn_draft_parameter (draft, 1);
  g_assert_cmpstr (kn.path, ==, "laws[0].kn");
  g_assert_cmpint (kn.kind, ==, QN_DRAFT_LOGNORMAL);
  g_assert_true (kn.first == 1e7 && kn.second == 2e6);
  qn_draft_undo (draft);
  g_assert_cmpint (qn_draft_get_plan (draft, &count), ==, QN_PLAN_LATIN_HYPERCUBE);
  g_assert_cmpint (count, ==, 200);
  qn_draft_undo (draft);
  qn_draft_undo (draft);
  g_assert_cmpuint (qn_draft_count (draft), ==, 1);
  qn_draft_redo (draft);
  g_assert_cmpuint (qn_draft_count (draft), ==, 2);
  qn_draft_remove (draft, 0);
  g_assert_false (qn_draft_can_redo (draft));
  g_assert_cmpuint (qn_draft_count (draft), ==, 1);
  qn_draft_free (draft);
}

/* Limits become the 5 % and 95 % fractiles of a distribution, and these limits again. */
static void
test_kinds (void)
{
  static const QnDraftKind kinds[] = { QN_DRAFT_NORMAL, QN_DRAFT_LOGNORMAL };
  QnDraft *draft = qn_draft_new ("s.quoin-study", "m.quoin", QN_STUDY_SOLVE);
  g_assert_true (qn_draft_vary (draft, "laws[0].friction", 0.5, FALSE));
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    double low, high;
    qn_draft_set_values (draft, 0, QN_DRAFT_UNIFORM, 0.45, 0.55, 0);
    qn_draft_set_kind (draft, 0, kinds[i]);
    QnDraftParameter now = qn_draft_parameter (draft, 0);
    g_assert_cmpint (now.kind, ==, kinds[i]);
    g_assert_cmpfloat_with_epsilon (now.first, 0.5, 2e-3);
    g_assert_cmpfloat_with_epsilon (now.second, 0.0304, 2e-4);
    qn_draft_get_fractiles (&now, &low, &high);
    /* Against the quantiles that a study computes with. */
    QnDistribution distribution = { .kind = QN_DISTRIBUTION_NORMAL,
                                    .first = now.first,
                                    .second = now.second,
                                    .min = -INFINITY,
                                    .max = INFINITY };
    if (kinds[i] == QN_DRAFT_LOGNORMAL)
      qn_distribution_set_lognormal (&distribution, now.first, now.second);
    g_assert_cmpfloat_with_epsilon (qn_distribution_quantile (&distribution, 0.05), 0.45,
                                    1e-9);
    g_assert_cmpfloat_with_epsilon (qn_distribution_quantile (&distribution, 0.95), 0.55,
                                    1e-9);
    g_assert_cmpfloat_with_epsilon (low, 0.45, 1e-12);
    g_assert_cmpfloat_with_epsilon (high, 0.55, 1e-12);
    qn_draft_set_kind (draft, 0, QN_DRAFT_RANGE);
    now = qn_draft_parameter (draft, 0);
    g_assert_cmpfloat_with_epsilon (now.first, 0.45, 1e-12);
    g_assert_cmpfloat_with_epsilon (now.second, 0.55, 1e-12);
  }
  qn_draft_set_values (draft, 0, QN_DRAFT_NORMAL, 0.5, 0.05, 0);
  qn_draft_set_kind (draft, 0, QN_DRAFT_LOGNORMAL);
  QnDraftParameter now = qn_draft_parameter (draft, 0);
  g_assert_true (now.first == 0.5 && now.second == 0.05);
  qn_draft_free (draft);
}

/* What a form does not know stays in the file. */
static void
test_load (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "s.quoin-study", NULL);
  g_autofree char *text =
    fixture_study_text ("{ \"kind\": \"latin-hypercube\", \"count\": 50 }",
                        ", \"correlation\": [[\"friction\", \"weight\", 0.2]], "
                        "\"limits\": { \"seconds\": 9 }");
  g_autoptr (GError) error = NULL;
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  QnDraft *draft = qn_draft_load (path, &error);
  g_assert_no_error (error);
  QnDraftParameter weight = qn_draft_parameter (draft, 1);
  g_assert_cmpint (weight.kind, ==, QN_DRAFT_RANGE);
  g_assert_cmpint (weight.levels, ==, 3);
  qn_draft_set_output (draft, QN_STUDY_MECHANISM_SHAPE, TRUE);
  qn_draft_set_output (draft, QN_STUDY_MECHANISM_KIND, FALSE);
  g_assert_true (qn_draft_save (draft, &error));
  QnStudy study;
  g_assert_true (qn_study_read (path, NULL, &study, &error));
  g_assert_no_error (error);
  g_assert_nonnull (study.correlation);
  g_assert_cmpfloat (study.seconds, ==, 9);
  g_assert_cmpuint (study.outputs->len, ==, 2);
  g_assert_cmpint (qn_study_output (&study, 1), ==, QN_STUDY_MECHANISM_SHAPE);
  qn_study_clear (&study);
  qn_draft_free (draft);

  g_assert_true (g_file_set_contents (path, "[1", -1, NULL));
  g_assert_null (qn_draft_load (path, &error));
  g_assert_nonnull (strstr (error->message, "s.quoin-study:1:"));
}

/* Counts go up and down by one at least, and stay counts. */
static void
test_whole (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "s.quoin-study", NULL);
  g_autofree char *model =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "01-sliding-block.quoin", NULL);
  g_autoptr (GError) error = NULL;
  QnDraft *draft = qn_draft_new (path, model, QN_STUDY_SOLVE);
  g_auto (QnStudy) study;
  g_assert_true (qn_draft_vary (draft, "analysis.increments", 10, TRUE));
  QnDraftParameter counted = qn_draft_parameter (draft, 0);
  g_assert_cmpstr (counted.path, ==, "analysis.increments");
  g_assert_cmpfloat (counted.first, ==, 9);
  g_assert_cmpfloat (counted.second, ==, 11);
  g_assert_true (qn_draft_save (draft, &error));
  g_assert_no_error (error);
  g_assert_true (qn_study_read (path, NULL, &study, &error));
  g_assert_no_error (error);
  g_assert_true (qn_study_parameter (&study, 0)->whole);
  /* At another place it is the same study, of the same project, with nothing to undo. */
  g_autofree char *elsewhere = g_build_filename (folder, "t.quoin-study", NULL);
  g_auto (QnStudy) moved;
  g_assert_true (qn_draft_save_as (draft, elsewhere, model, &error));
  g_assert_cmpstr (qn_draft_get_path (draft), ==, elsewhere);
  g_assert_false (qn_draft_can_undo (draft));
  g_assert_true (qn_study_read (elsewhere, NULL, &moved, &error));
  g_assert_cmpstr (qn_study_parameter (&moved, 0)->paths[0], ==, "analysis.increments");
  qn_draft_free (draft);
}

QN_TESTS
{
  g_test_add_func ("/study/draft/new", test_new);
  g_test_add_func ("/study/draft/kinds", test_kinds);
  g_test_add_func ("/study/draft/whole", test_whole);
  g_test_add_func ("/study/draft/load", test_load);
}
