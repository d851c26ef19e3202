/* Where a false claim is, and both numbers, in words. */
#include "io/text/fault-text.h"

#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

/* What the model does not have, as in a result of another model, is told by its number. */
static void
test_places (void)
{
  static const struct {
    QnEntity entity;
    QnId index;
    const char *words;
    bool bare; /* without contacts */
  } cases[] = {
    { QN_ENTITY_BLOCK, 1, "block “block”: ", false },
    { QN_ENTITY_BLOCK, 2, "number 2: ", false },
    { QN_ENTITY_NODE, 0, "node “top”: ", false },
    { QN_ENTITY_NODE, 1, "number 1: ", false },
    { QN_ENTITY_BEAM, 0, "number 0: ", false },
    { QN_ENTITY_TIE, 0, "tie “rod”: ", false },
    { QN_ENTITY_TIE, 1, "number 1: ", false },
    { QN_ENTITY_CONTACT, 1, "pair 1 between “base” and “block”: ", false },
    { QN_ENTITY_CONTACT, 2, "pair 2: ", false },
    { QN_ENTITY_CONTACT, 1, "pair 1: ", true },
  };
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, 1, 1);
  test_detect (&model, &contacts);
  test_model_add_node (&model, "top", 0, 2, "xyr");
  qn_model_add_tie (&model, "rod");
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const QnFault fault = { .claim = QN_CLAIM_FORCES,
                            .entity = cases[i].entity,
                            .index = cases[i].index,
                            .step = 3,
                            .stated = 2,
                            .found = 1.5 };
    g_autofree char *text =
      qn_fault_dup_text (&model, cases[i].bare ? NULL : &contacts, &fault);
    g_autofree char *begin = g_strconcat ("step 3: ", cases[i].words, NULL);
    g_assert_true (g_str_has_prefix (text, begin));
    g_assert_nonnull (strstr (text, ": 2 instead of 1.5 N"));
  }
}

/* A number beside which there is none, and none at all; no step and no place. */
static void
test_numbers (void)
{
  QnFault fault = {
    .claim = QN_CLAIM_FORCES, .index = QN_NONE, .step = QN_NONE, .stated = 2, .found = NAN
  };
  const QnModel model = { 0 };
  for (int i = 0; i < 3; i++) {
    g_autofree char *text = qn_fault_dup_text (&model, NULL, &fault);
    g_assert_null (strstr (text, "step"));
    g_assert_null (strstr (text, "instead"));
    g_assert_cmpint (g_str_has_suffix (text, ": 2 N"), ==, i < 2);
    fault.found = 0;
    if (i == 1)
      fault.stated = NAN;
  }
}

/* Every claim has a name and a sentence, which tells what is stated and found, or neither. */
static void
test_claims (void)
{
  const QnModel model = { 0 };
  for (int claim = 0; claim < QN_CLAIM_COUNT; claim++)
    for (int stated = 0; stated < 2; stated++) {
      const QnFault fault = { .claim = (QnClaim) claim,
                              .entity = QN_ENTITY_TIE,
                              .index = QN_NONE,
                              .step = 1,
                              .stated = stated ? 1.5 : NAN,
                              .found = 2.5 };
      g_autofree char *text = qn_fault_dup_text (&model, NULL, &fault);
      const gboolean numbers = strstr (text, "1.5") != NULL;
      g_assert_true (g_str_has_prefix (text, "step 1: "));
      g_assert_true (g_ascii_isalpha (text[strlen ("step 1: ")]));
      g_assert_true (stated || !numbers);
      g_assert_cmpint (strstr (text, "2.5") != NULL, ==, numbers);
      g_assert_cmpint (qn_claim_from_name (qn_claim_name (fault.claim)), ==, claim);
    }
  g_assert_cmpint (qn_claim_from_name ("fortune"), ==, QN_CLAIM_COUNT);
}

QN_TESTS
{
  g_test_add_func ("/fault-text/places", test_places);
  g_test_add_func ("/fault-text/numbers", test_numbers);
  g_test_add_func ("/fault-text/claims", test_claims);
}
