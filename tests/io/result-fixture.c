#include "result-fixture.h"

#include "core/base/memory.h"
#include "io/result/result-file.h"
#include "project-text.h"
#include "support/scratch.h"

void
result_fixture_set_up (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  test_parse (test_project_text, &fixture->project);
  g_assert_cmpint (qn_contacts_detect (&fixture->project.model, &fixture->contacts, NULL),
                   ==, QN_OK);
  g_assert_cmpuint (fixture->contacts.pair_count, ==, 2);

  QnResult *result = &fixture->result;
  static const double still[6] = { 0 };
  static const double moved[6] = { 0, 0, 0, 1e-6, -2e-6, 3e-9 };
  static const double velocity[6] = { 0, 0, 0, 1, 0.5, -1 };
  g_assert_cmpint (qn_result_init (result, 2, 2, NULL), ==, QN_OK);
  g_assert_true (
    qn_result_add_step (result, (QnStep){ .iterations = 3, .residual = 1e-12 }, still));
  g_assert_true (qn_result_add_step (
    result,
    (QnStep){
      .multiplier = 0.2, .iterations = 4, .residual = 3e-10, .event = QN_EVENT_COLLAPSE },
    moved));
  g_assert_cmpint (qn_result_set_mechanism (result, velocity, 0.5, NULL), ==, QN_OK);

  result->outcome = QN_OUTCOME_COLLAPSE;
  result->has_collapse_multiplier = true;
  result->collapse_multiplier = 0.2;
  qn_result_add_solution (result, (QnSolution){ .multiplier = 0.2,
                                                .found_by = QN_PROCEDURE_WORK,
                                                .displacement = 2e-6 });
  result->has_associative_bound = true;
  result->associative_bound = 0.25;
  result->linearity = QN_LINEARITY_HOLDS;
  QnId *moving = qn_alloc (1, sizeof *moving);
  g_assert_nonnull (moving);
  moving[0] = 1;
  g_assert_true (qn_result_add_event (result, (QnPathEvent){ .kind = QN_EVENT_KIND_SNAP,
                                                             .multiplier = 0.1,
                                                             .displacement_before = 1e-6,
                                                             .displacement_after = 2e-6,
                                                             .energy = 0.5,
                                                             .blocks = moving,
                                                             .block_count = 1 }));
  result->statistics = (QnStatistics){ .seconds = 0.012,
                                       .iterations = 420,
                                       .factorizations = 400,
                                       .peak_memory_bytes = 12345678 };
  /* The normal points up, the tangent to the left: the plane pushes the block up, and the
   * block, pushed to the right, pulls the plane along. */
  const QnContactPair *pairs = fixture->contacts.pairs;
  for (size_t i = 0; i < 2; i++)
    result->pairs[i] =
      (QnPairResult){ .state = QN_PAIR_STICK,
                      .normal_force = pairs[i].point.x < 1 ? -4000 : -6000,
                      .shear_force = -1000 };
}

void
result_fixture_tear_down (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  qn_result_clear (&fixture->result);
  qn_contacts_clear (&fixture->contacts);
  qn_project_clear (&fixture->project);
}

char *
result_fixture_dup_text (const ResultFixture *fixture)
{
  char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  GError *error = NULL;
  g_assert_true (qn_result_file_write (path, &fixture->project, &fixture->contacts,
                                       &fixture->result, QN_DETAIL_FORCES, &error));
  g_assert_no_error (error);
  char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  test_scratch_free (folder);
  return text;
}
