/* Bars across faces: where they make pairs, and what is refused. */
#include "core/contact/contact-bars.h"
#include "core/model/bar.h"
#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

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

/* The pairs of bars: how many, and the sum of their areas. */
static size_t
count_bars (const QnContacts *contacts, double *area)
{
  size_t count = 0;

  *area = 0;
  for (size_t i = 0; i < contacts->pair_count; i++)
    if (contacts->pairs[i].bar != QN_NONE) {
      const QnContactPair *pair = &contacts->pairs[i];
      *area += pair->tributary * contacts->faces[pair->face].thickness;
      count++;
    }
  return count;
}

/* Aslant it is longer, and its pair answers along it alone: by the cosine in both directions of the face. */
static void
test_aslant (void)
{
  QnModel model;
  QnContacts contacts;
  double area;
  init (&model, 0.2, 0.1, 0.8, 1.3);
  test_detect (&model, &contacts);
  g_assert_cmpuint (count_bars (&contacts, &area), ==, 2);
  const size_t p = (size_t) contacts.faces[1].first_pair + 2;
  const double s = contacts.pairs[p].slant, c = sqrt (1 - s * s);
  g_assert_cmpfloat_with_epsilon (fabs (s), 0.6 / hypot (0.6, 1.2), 1e-12);
  QnPairSprings springs = qn_contacts_pair_springs (&model, &contacts, p);
  g_assert_cmpfloat_with_epsilon (springs.a.kn / (2e11 * 3e-4 / 0.5 * c), 1, 1e-12);

  static const double elongations[][2] = { { 1e-4, 3e-5 },
                                           { 4e-3, -1e-3 },
                                           { -5e-3, 0 } };
  for (size_t i = 0; i < G_N_ELEMENTS (elongations); i++) {
    const QnPairMemory memory = { 0 };
    const double *q = elongations[i], h = 1e-8;
    QnPairResponse at, up, down;
    g_assert_true (qn_pair_evaluate (&springs, &memory, q, &at));
    double along = qn_bar_axial (&contacts.pairs[p], at.force[0], at.force[1]);
    double free = springs.a.kn * (c * q[0] + s * q[1]);
    g_assert_cmpfloat_with_epsilon (along / fmin (fmax (free, -1.5e5), 1.5e5), 1, 1e-9);
    g_assert_cmpfloat (fabs (s * at.force[0] - c * at.force[1]), <, 1e-5 * fabs (free));
    for (int j = 0; j < 2; j++) {
      double plus[2] = { q[0], q[1] }, minus[2] = { q[0], q[1] };
      plus[j] += h;
      minus[j] -= h;
      g_assert_true (qn_pair_evaluate (&springs, &memory, plus, &up));
      g_assert_true (qn_pair_evaluate (&springs, &memory, minus, &down));
      for (int k = 0; k < 2; k++)
        g_assert_cmpfloat_with_epsilon ((up.force[k] - down.force[k]) / (2 * h),
                                        at.tangent[k][j], 1e-6 * springs.a.kn);
    }
  }
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

/* A wall of 2 x 2 cells of 1 m. */
static void
init_cells (QnModel *model, QnVec2 start, QnVec2 end)
{
  init (model, start.x, start.y, end.x, end.y);
  for (int i = 0; i < 4; i++) {
    g_autofree char *name = g_strdup_printf ("c%d", i);
    test_model_add_rectangle (model, name, 10 + i % 2, i / 2, 1, 1);
  }
}

/* Between two rows of cells, on their outline, through the corner of four: no section twice, none lost. */
static void
test_ends_of_faces (void)
{
  static const struct {
    QnVec2 start, end;
    size_t pairs;
    double sections;
  } cases[] = {
    { { 10.2, 1 }, { 11.8, 1 }, 2, 1 },     { { 10.2, 0 }, { 11.8, 0 }, 1, 1 },
    { { 10.2, 2 }, { 11.8, 2 }, 1, 1 },     { { 10.2, 0.2 }, { 11.8, 1.8 }, 4, 2 },
    { { 11.8, 1.8 }, { 10.2, 0.2 }, 4, 2 }, { { 10.2, 0.3 }, { 11.8, 1.8 }, 2, 2 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnModel model;
    QnContacts contacts;
    double area;
    init_cells (&model, cases[i].start, cases[i].end);
    test_detect (&model, &contacts);
    g_assert_cmpuint (count_bars (&contacts, &area), ==, cases[i].pairs);
    g_assert_cmpfloat_with_epsilon (area, cases[i].sections * 3e-4, 1e-15);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

/* A bar that bends, on a face too; a mesh. */
static void
test_lines (void)
{
  QnModel model;
  QnContacts contacts;
  double area;
  init_cells (&model, qn_vec2 (10.5, 0.5), qn_vec2 (10.5, 1.5));
  QnBar *bar = &model.bars[0];
  bar->via_count = 3;
  bar->via[0] = qn_vec2 (11, 0.5); /* goes on through the face */
  bar->via[1] = qn_vec2 (11.5, 0.5);
  bar->via[2] = qn_vec2 (11.5, 1.5);
  g_assert_cmpfloat_with_epsilon (qn_bar_length (bar), 3, 1e-12);
  test_detect (&model, &contacts);
  g_assert_cmpuint (count_bars (&contacts, &area), ==, 3);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);

  init_cells (&model, qn_vec2 (11.8, 1.9), qn_vec2 (10.2, 0.1));
  model.bars[0].spacing = qn_vec2 (0.4, 0.5); /* 5 upright, 4 level with 0.15 m aside */
  g_assert_cmpuint (qn_bar_line_count (&model.bars[0]), ==, 9);
  QnVec2 ends[2];
  qn_bar_line (&model.bars[0], 5, ends);
  g_assert_cmpfloat_with_epsilon (ends[0].y, 0.25, 1e-12);
  test_detect (&model, &contacts);
  g_assert_cmpuint (count_bars (&contacts, &area), ==,
                    10); /* one at x = 11 along the joint */
  g_assert_cmpfloat_with_epsilon (area, (5 + 4) * 3e-4, 1e-15);
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
  init (&model, 0.2, 0.5, 0.4, 0.5); /* along a joint */
  expect_refusal (&model, QN_PROBLEM_BAR_UNUSED);
  init (&model, 3, 0, 3, 2); /* beside */
  expect_refusal (&model, QN_PROBLEM_BAR_END);
  init (&model, 0.2, 0.1, 0.2, 1.6); /* out at the top, by 0.1 m */
  expect_refusal (&model, QN_PROBLEM_BAR_END);
  init (&model, 0.2, 0.1, 0.2, 1.4);
  model.bars[0].spacing = qn_vec2 (0.1, 0);
  expect_refusal (&model, QN_PROBLEM_BAR_MESH);
  init (&model, 0.2, 0.1, 0.4, 1.4);
  model.bars[0].spacing = qn_vec2 (1e-6, 0);
  expect_refusal (&model, QN_PROBLEM_BAR_TOO_MANY);
  init (&model, 0.2, 0.1, 0.4, 1.4);
  model.bars[0].via_count = 1;
  model.bars[0].via[0] = qn_vec2 (0.4, 1.4);
  expect_refusal (&model, QN_PROBLEM_BAR_SHORT);
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
  g_test_add_func ("/contact-bars/aslant", test_aslant);
  g_test_add_func ("/contact-bars/ends-of-faces", test_ends_of_faces);
  g_test_add_func ("/contact-bars/lines", test_lines);
  g_test_add_func ("/contact-bars/refused", test_refused);
}
