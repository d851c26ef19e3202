#include "core/result/result-contact.h"

#include "io/result-fixture.h"
#include "support/room.h"

/* The right pair of the fixture, in either order of the pairs. */
static size_t
right_pair (const ResultFixture *fixture)
{
  return fixture->contacts.pairs[0].point.x > 1 ? 0 : 1;
}

static void
test_deformation (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnModel *model = &fixture->project.model;
  QnResult *result = &fixture->result;
  g_assert_null (qn_result_deformation (model, result));
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  g_assert_true (qn_result_deformation (model, result)
                 == qn_result_step_displacements (result, 1));
  result->limit.given = true;
  g_assert_null (qn_result_deformation (model, result));
  result->limit.given = false;
  result->step_count = 0;
  g_assert_null (qn_result_deformation (model, result));
}

static void
test_at_rest (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnVec2 point, normal;
  qn_result_contact_place (&fixture->project.model, &fixture->contacts,
                           right_pair (fixture), NULL, &point, &normal);
  g_assert_cmpfloat (point.x, ==, 1.5);
  g_assert_cmpfloat (point.y, ==, 0);
  g_assert_cmpfloat (normal.y, ==, 1);
}

/* The block lifts off by a quarter turn about its centre (1, 0.5) and moves 1 to the right: its
 * corner (1.5, 0) goes to (2.5, 1). */
static void
test_moved (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  const double deformation[6] = { 0, 0, 0, 1, 0, G_PI / 2 };
  QnVec2 point, normal;
  qn_result_contact_place (&fixture->project.model, &fixture->contacts,
                           right_pair (fixture), deformation, &point, &normal);
  g_assert_cmpfloat_with_epsilon (point.x, 2, 1e-12);
  g_assert_cmpfloat_with_epsilon (point.y, 0.5, 1e-12);
  g_assert_cmpfloat_with_epsilon (normal.x, -sqrt (0.5), 1e-12);
  g_assert_cmpfloat_with_epsilon (normal.y, sqrt (0.5), 1e-12);
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-contact/deformation", test_deformation);
  RESULT_FIXTURE_ADD ("/result-contact/at-rest", test_at_rest);
  RESULT_FIXTURE_ADD ("/result-contact/moved", test_moved);
}
