#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

#define CLOSE(a, b) g_assert_cmpfloat_with_epsilon ((a), (b), 1e-14)

static void
test_ends (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, 2, 1);
  model.contact.pairs.offset = 0.25;
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.pair_count, ==, 2);
  CLOSE (contacts.pairs[0].abscissa, 0.25);
  CLOSE (contacts.pairs[1].abscissa, 1.75);
  CLOSE (contacts.pairs[0].tributary, 1);
  CLOSE (contacts.pairs[1].tributary, 1);
  CLOSE (contacts.pairs[0].point.x, 0.75); /* the base's upper side runs leftwards */
  CLOSE (contacts.pairs[1].point.x, -0.75);
}

/* Without offset the pairs sit on the corners exactly. */
static void
test_ends_at_corners (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_wall (&model, 4, 0);
  test_model_rotate (&model, 1);
  test_detect (&model, &contacts);
  for (size_t i = 0; i < contacts.face_count; i++) {
    const QnContactFace *face = &contacts.faces[i];
    const QnContactPair *pairs = &contacts.pairs[face->first_pair];
    g_assert_cmpfloat (pairs[0].point.x, ==, face->start.x);
    g_assert_cmpfloat (pairs[0].point.y, ==, face->start.y);
    CLOSE (pairs[1].point.x, face->end.x);
    CLOSE (pairs[1].point.y, face->end.y);
  }
}

static void
test_uniform (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, 2, 1);
  model.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 5 };
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.pair_count, ==, 5);
  for (int i = 0; i < 5; i++) {
    CLOSE (contacts.pairs[i].abscissa, 0.2 + 0.4 * i);
    /* Equal shares, but for what makes bending exact: 1 + a (x^2 - m), a = 15 n^2 / (4 (n^2 -
     * 1) (n^2 - 4)) = 0.1860, m = 0.32, x = 0.8, 0.4, 0. */
    double x = 0.4 * i - 0.8, a = 15. * 25 / (4 * 24 * 21);
    CLOSE (contacts.pairs[i].tributary, 0.4 * (1 + a * (x * x - 0.32)));
    CLOSE (contacts.pairs[i].point.x, 0.8 - 0.4 * i);
    CLOSE (contacts.pairs[i].point.y, 0);
  }
}

/* The law of a spring is that of its block, else the contact law; an exception beats both. */
static void
test_laws (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 3, 1, 0.5);
  for (int i = 1; i < 3; i++) {
    QnLaw *law = qn_model_add_law (&model, i == 1 ? "stone" : "lead");
    law->kind = QN_LAW_ELASTIC;
    law->kn = law->ks = 1e6;
  }
  model.blocks[2].law = 1;
  QnFaceOverride *override = qn_model_add_override (&model);
  override->block_a = 3;
  override->block_b = 2;
  override->law = 2;
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 3);
  const QnId laws[][2] = { { 0, 0 }, { 0, 1 }, { 2, 2 } };
  for (int i = 0; i < 3; i++) {
    g_assert_cmpint (contacts.faces[i].law_a, ==, laws[i][0]);
    g_assert_cmpint (contacts.faces[i].law_b, ==, laws[i][1]);
  }
}

/* Exceptions name blocks in any order, the later one counts, and one without a face is told. */
static void
test_exceptions (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 4, 1, 0.5);
  const QnId blocks[][2] = { { 4, 3 }, { 2, 1 }, { 1, 4 }, { 1, 2 }, { 0, 1 } };
  const int counts[] = { 3, 4, 5, 6, 0 };
  for (int i = 0; i < 5; i++) {
    QnFaceOverride *override = qn_model_add_override (&model);
    override->block_a = blocks[i][0];
    override->block_b = blocks[i][1];
    override->has_pairs = counts[i] > 0;
    override->pairs =
      (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = counts[i] };
  }
  test_detect (&model, &contacts);
  const int32_t expected[] = { 2, 6, 2, 3 };
  g_assert_cmpuint (contacts.face_count, ==, 4);
  for (int i = 0; i < 4; i++)
    g_assert_cmpint (contacts.faces[i].pair_count, ==, expected[i]);
  g_assert_cmpuint (contacts.findings.count, ==, 1);
  const QnFinding *unused = test_the_finding (&contacts, QN_PROBLEM_OVERRIDE_UNUSED);
  g_assert_cmpint (unused->block_a, ==, 1);
  g_assert_cmpint (unused->block_b, ==, 4);
}

/* Without a rule each face has the pairs of its own law, of which the block's, the exception's and the
 * general one have different bases. */
static void
test_default_by_face (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 4, 1, 0.5);
  const QnBasis bases[] = { QN_BASIS_SURFACE, QN_BASIS_MATERIAL };
  for (int i = 0; i < 2; i++) {
    QnLaw *law = qn_model_add_law (&model, i == 0 ? "mortar" : "stone");
    law->kind = QN_LAW_ELASTIC;
    law->basis = bases[i];
    law->kn = law->ks = 1e9;
    QnFaceOverride *override = qn_model_add_override (&model);
    override->block_a = i + 1;
    override->block_b = i + 2;
    override->law = i + 1;
    override->has_pairs = i == 1;
    override->pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 4 };
  }
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  test_detect (&model, &contacts);
  const int32_t expected[] = { 2, 5, 4, 2 };
  g_assert_cmpuint (contacts.face_count, ==, 4);
  for (int i = 0; i < 4; i++)
    g_assert_cmpint (contacts.faces[i].pair_count, ==, expected[i]);
  g_assert_cmpuint (contacts.findings.count, ==, 0);
}

/* Pairs that misstate bending are a finding in large displacements where the law counts by area; the
 * one of the worst joint stands for all. */
static void
test_bending_finding (void)
{
  static const struct {
    QnPairRule rule;
    double value; /* 0: no finding */
  } rules[] = {
    { { .placement = QN_PLACEMENT_DEFAULT }, 0 },
    { { .placement = QN_PLACEMENT_ENDS }, 3 },
    { { .placement = QN_PLACEMENT_ENDS, .offset = 0.1 }, 1.92 },
    { { .placement = QN_PLACEMENT_LOBATTO, .count = 3 }, 0 },
    { { .placement = QN_PLACEMENT_LOBATTO, .offset = 0.1 }, 0 },
    { { .placement = QN_PLACEMENT_UNIFORM, .count = 2 }, 0.75 },
    { { .placement = QN_PLACEMENT_UNIFORM, .count = 3 }, 0 },
    { { .placement = QN_PLACEMENT_GAUSS, .count = 2 }, 0 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (rules); i++)
    for (int basis = QN_BASIS_CONTACT; basis <= QN_BASIS_SURFACE; basis++)
      for (int geometry = QN_GEOMETRY_LINEAR; geometry <= QN_GEOMETRY_NONLINEAR;
           geometry++) {
        g_auto (QnModel) model;
        g_auto (QnContacts) contacts;
        bool told = basis == QN_BASIS_SURFACE && geometry == QN_GEOMETRY_NONLINEAR;
        test_model_init_stack (&model, 3, 1, 0.5);
        model.laws[0].basis = (QnBasis) basis;
        model.analysis.geometry = (QnGeometry) geometry;
        model.contact.pairs = rules[i].rule;
        test_detect (&model, &contacts);
        if (rules[i].value == 0 || !told) {
          g_assert_cmpuint (contacts.findings.count, ==, 0);
          continue;
        }
        const QnFinding *found = test_the_finding (&contacts, QN_PROBLEM_PAIRS_BENDING);
        CLOSE (found->value, rules[i].value);
        g_assert_cmpint (found->subject, ==, 3);
        g_assert_cmpint (found->block_a, ==, 0);
        g_assert_cmpint (found->block_b, ==, 1);
      }
}

/* End pairs that are crushed are a finding with any basis and geometry. */
static void
test_crushing_finding (void)
{
  for (int basis = QN_BASIS_CONTACT; basis <= QN_BASIS_SURFACE; basis++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init_stack (&model, 3, 1, 0.5);
    model.laws[0].kind = QN_LAW_MOHR_COULOMB;
    model.laws[0].compression = 1e6;
    model.laws[0].basis = (QnBasis) basis;
    test_detect (&model, &contacts);
    if (basis == QN_BASIS_SURFACE) {
      g_assert_cmpuint (contacts.findings.count, ==, 0);
      qn_contacts_clear (&contacts);
      model.contact.pairs.placement = QN_PLACEMENT_ENDS;
      g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    }
    const QnFinding *found = test_the_finding (&contacts, QN_PROBLEM_PAIRS_CRUSHING);
    CLOSE (found->value, 2);
    g_assert_cmpint (found->subject, ==, 3);
  }
}

/* An offset that leaves no room between the pairs is refused, with the blocks of the face. */
static void
test_offset_too_large (void)
{
  const double offsets[] = { 0.49, 0.5, 2 };
  for (int i = 0; i < 3; i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    QnDiag diag;
    test_model_init_stack (&model, 2, 1, 0.5);
    model.contact.pairs.offset = offsets[i];
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    QnStatus status = qn_contacts_detect (&model, &contacts, &diag);
    if (i == 0) {
      g_assert_cmpint (status, ==, QN_OK);
    } else {
      g_assert_cmpint (status, ==, QN_ERROR_INVALID);
      g_assert_cmpint (diag.problem, ==, QN_PROBLEM_PAIR_OFFSET_TOO_LARGE);
      g_assert_cmpint (diag.entity, ==, QN_ENTITY_BLOCK);
      g_assert_cmpint (diag.index, ==, 0);
      g_assert_cmpint (diag.other, ==, 1);
      g_assert_cmpfloat (diag.value, ==, 1);
      g_assert_null (contacts.faces);
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/pair-placement/ends", test_ends);
  g_test_add_func ("/pair-placement/ends-at-corners", test_ends_at_corners);
  g_test_add_func ("/pair-placement/uniform", test_uniform);
  g_test_add_func ("/pair-placement/laws", test_laws);
  g_test_add_func ("/pair-placement/exceptions", test_exceptions);
  g_test_add_func ("/pair-placement/default-by-face", test_default_by_face);
  g_test_add_func ("/pair-placement/bending-finding", test_bending_finding);
  g_test_add_func ("/pair-placement/crushing-finding", test_crushing_finding);
  g_test_add_func ("/pair-placement/offset-too-large", test_offset_too_large);
}
