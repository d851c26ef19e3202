/* Bars across faces: where they make pairs, and what is refused. */
#include "core/contact/contacts.h"
#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

/* A stack of three blocks, 1 x 0.5 m, thickness 1 m, about x = 0, with one vertical bar. */
static void
init (QnModel *model, double x0, double y0, double x1, double y1)
{
  test_model_init_stack (model, 3, 1, 0.5);
  QnLaw *law = qn_model_add_law (model, "steel");
  law->kind = QN_LAW_ELASTIC_PLASTIC;
  law->basis = QN_BASIS_MATERIAL;
  law->kn = 2e11;
  law->ks = 8e10;
  law->yield = 5e8;
  QnBar *bar = qn_model_add_bar (model);
  *bar = (QnBar){ .law = 1, .area = 3e-4, .start = { x0, y0 }, .end = { x1, y1 } };
}

static void
test_crossing (void)
{
  QnModel model;
  QnContacts contacts;
  init (&model, 0.2, 0.1, 0.2, 1.4); /* ends in the first and in the third block */
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 3);
  g_assert_cmpuint (contacts.pair_count, ==, 2 + 3 + 3);
  for (size_t f = 0; f < 3; f++) {
    const QnContactFace *face = &contacts.faces[f];
    g_assert_cmpint (face->pair_count, ==, f == 0 ? 2 : 3);
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      g_assert_cmpint (contacts.pairs[p].bar, ==, p < face->first_pair + 2 ? QN_NONE : 0);
    if (f == 0)
      continue;
    size_t bar = (size_t) face->first_pair + 2;
    const QnContactPair *pair = &contacts.pairs[bar];
    g_assert_cmpfloat_with_epsilon (pair->point.x, 0.2, 1e-14);
    g_assert_cmpfloat_with_epsilon (pair->point.y, 0.5 * (double) f, 1e-14);
    g_assert_cmpfloat_with_epsilon (pair->tributary * face->thickness, 3e-4, 1e-18);
    g_assert_cmpint (qn_contacts_pair_law (&model, &contacts, bar, 0), ==, 1);
    g_assert_cmpint (qn_contacts_pair_law (&model, &contacts, bar, 1), ==, 1);

    /* Half a block on either side: 0.5 m of bar in all. */
    QnPairSprings springs = qn_contacts_pair_springs (&model, &contacts, bar);
    g_assert_true (springs.equal);
    g_assert_cmpfloat_with_epsilon (springs.a.kn / (2e11 * 3e-4 / 0.5), 1, 1e-14);
    g_assert_cmpfloat_with_epsilon (springs.a.yield, 1.5e5, 1e-9);
  }
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

static void
expect_refusal (QnModel *model, QnProblem problem)
{
  QnDiag diag = { 0 };
  QnContacts contacts;
  if (qn_model_prepare (model, &diag) == QN_OK
      && qn_contacts_detect (model, &contacts, &diag) == QN_OK)
    qn_contacts_clear (&contacts);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, qn_problem_text (problem));
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_BAR);
  g_assert_cmpint (diag.index, ==, 0);
  qn_model_clear (model);
}

static void
test_refused (void)
{
  QnModel model;
  init (&model, 0.2, 0.55, 0.2, 0.95); /* within one block */
  expect_refusal (&model, QN_PROBLEM_BAR_UNUSED);
  init (&model, 3, 0, 3, 2); /* beside */
  expect_refusal (&model, QN_PROBLEM_BAR_UNUSED);
  init (&model, -0.4, 0.1, 0.4, 1.4);
  expect_refusal (&model, QN_PROBLEM_BAR_OBLIQUE);
  init (&model, 0.2, 0.1, 0.2, 0.1);
  expect_refusal (&model, QN_PROBLEM_BAR_SHORT);
  init (&model, 0.2, 0.1, 0.2, 1.4);
  model.bars[0].area = 0;
  expect_refusal (&model, QN_PROBLEM_NOT_POSITIVE);
  init (&model, 0.2, 0.1, 0.2, 1.4);
  model.bars[0].law = 0;
  expect_refusal (&model, QN_PROBLEM_BAR_BASIS);
  init (&model, 0.2, 0.1, 0.2, 1.4);
  model.bars[0].law = 7;
  expect_refusal (&model, QN_PROBLEM_LAW_UNKNOWN);
  init (&model, 0.2, 0.1, 0.2, 1.4);
  model.bars[0].end.x = NAN;
  expect_refusal (&model, QN_PROBLEM_NOT_FINITE);
}

QN_TESTS
{
  g_test_add_func ("/contact-bars/crossing", test_crossing);
  g_test_add_func ("/contact-bars/refused", test_refused);
}
