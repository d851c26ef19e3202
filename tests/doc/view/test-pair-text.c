#include "doc/view/pair-text.h"

#include "doc/edit/edit.h"
#include "support/locale.h"
#include "support/room.h"

static void
test_parse (void)
{
  QnPairRule rule = { .placement = QN_PLACEMENT_ENDS };
  g_autoptr (GError) error = NULL;
  qn_pair_rule_parse (&rule, "0,1; 0.5;0,9", "1 2 1", &error);
  g_assert_no_error (error);
  g_assert_cmpint (rule.placement, ==, QN_PLACEMENT_EXPLICIT);
  g_assert_cmpint (rule.count, ==, 3);
  g_assert_cmpfloat (rule.positions[0], ==, 0.1);
  g_assert_cmpfloat (rule.weights[1], ==, 0.5);
  g_autofree char *positions = qn_pair_rule_dup_positions (&rule);
  g_autofree char *weights = qn_pair_rule_dup_weights (&rule);
  g_autofree char *expected_positions = test_with_decimal_sign ("0.1; 0.5; 0.9");
  g_autofree char *expected_weights = test_with_decimal_sign ("0.25; 0.5; 0.25");
  g_assert_cmpstr (positions, ==, expected_positions);
  g_assert_cmpstr (weights, ==, expected_weights);
  QnPairRule again = { .placement = QN_PLACEMENT_ENDS };
  g_assert_true (qn_pair_rule_parse (&again, positions, weights, NULL));
  g_assert_cmpfloat (again.weights[2], ==, rule.weights[2]);

  /* Nothing given: the ends, equally. */
  g_assert_true (qn_pair_rule_parse (&rule, " ", "", NULL));
  g_assert_cmpint (rule.count, ==, 2);
  g_assert_cmpfloat (rule.positions[1], ==, 1.0);
  g_autofree char *equal = qn_pair_rule_dup_weights (&rule);
  g_assert_cmpstr (equal, ==, "");
}

/* What is wrong changes nothing. */
static void
test_refused (void)
{
  static const char *const cases[][2] = { { "0.5; x", "" }, { "0.1; 0.9", "1" } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnPairRule rule = { .placement = QN_PLACEMENT_UNIFORM, .count = 7 };
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_pair_rule_parse (&rule, cases[i][0], cases[i][1], &error));
    g_assert_nonnull (error);
    g_assert_cmpint (rule.placement, ==, QN_PLACEMENT_UNIFORM);
    g_assert_cmpint (rule.count, ==, 7);
  }
  g_autoptr (GString) many = g_string_new (NULL);
  for (int i = 0; i <= QN_MAX_EXPLICIT_PAIRS; i++)
    g_string_append_printf (many, "0.%03d;", i + 1);
  QnPairRule rule = { .placement = QN_PLACEMENT_ENDS };
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_pair_rule_parse (&rule, many->str, "", &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
}

/* Lists that can be read, but are no rule. */
static void
test_refused_by_model (void)
{
  static const char *const cases[][2] = {
    { "0.5; 0.1", "" },     { "-0.1; 0.5", "" },     { "0.5; 1.1", "" },
    { "0.1; 0.9", "1; 0" }, { "0.1; 0.9", "1; -2" }, { "0.1; 0.9", "1; -1" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnModel model;
    QnDiag diag;
    qn_model_init (&model);
    g_assert_true (
      qn_pair_rule_parse (&model.contact.pairs, cases[i][0], cases[i][1], NULL));
    g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==,
                     *cases[i][1] == '\0' ? QN_PROBLEM_PAIR_POSITION
                                          : QN_PROBLEM_PAIR_WEIGHTS);
    qn_model_clear (&model);
  }
}

/* As the rule comes out on a face, in words. */
static void
test_text (void)
{
  static const struct {
    QnBasis basis;
    QnPairRule rule;
    const char *text;
  } cases[] = {
    { QN_BASIS_CONTACT, { .offset = 0 }, "2 per joint, at the ends" },
    { QN_BASIS_SURFACE, { .offset = 0 }, "5 per joint, at Gauss–Lobatto points" },
    { QN_BASIS_SURFACE,
      { .placement = QN_PLACEMENT_ENDS, .offset = 0.02 },
      "2 per joint, at the ends, the outer ones 0.02 m from the corners" },
    { QN_BASIS_CONTACT,
      { .placement = QN_PLACEMENT_UNIFORM, .count = 10 },
      "10 per joint, evenly spaced" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const QnLaw law = { .kind = QN_LAW_COULOMB, .basis = cases[i].basis };
    g_autofree char *text = qn_pair_rule_dup_text (&cases[i].rule, &law, QN_UNITS_SI);
    g_autofree char *expected = test_with_decimal_sign (cases[i].text);
    g_assert_cmpstr (text, ==, expected);
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/pair-text/parse", test_parse);
  g_test_add_func ("/doc/pair-text/refused", test_refused);
  g_test_add_func ("/doc/pair-text/refused-by-model", test_refused_by_model);
  g_test_add_func ("/doc/pair-text/text", test_text);
}
