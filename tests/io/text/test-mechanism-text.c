#include "core/path/analysis.h"
#include "io/text/mechanism-text.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

/* Solves the model by limit analysis and says how it moves: the title and the sentences. */
static void
collapse_in_words (QnModel *model, char **title, char **text)
{
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnMechanism mechanism;

  model->analysis.procedure = QN_PROCEDURE_LIMIT;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_nonnull (result.mechanism);
  g_assert_cmpint (qn_mechanism_of_result (&mechanism, model, &contacts, &result, NULL),
                   ==, QN_OK);
  *title = qn_mechanism_dup_title (&mechanism);
  *text = qn_mechanism_dup_text (model, &mechanism);
  qn_mechanism_clear (&mechanism);
  qn_model_clear (model);
}

static void
assert_words (QnModel *model, const char *expected_title, const char *const *expected)
{
  g_autofree char *title = NULL, *text = NULL;

  collapse_in_words (model, &title, &text);
  g_test_message ("%s", text);
  g_assert_cmpstr (title, ==, expected_title);
  g_assert_true (g_str_has_prefix (text, title));
  for (; *expected != NULL; expected++)
    if (strstr (text, *expected) == NULL)
      g_error ("\"%s\" does not say \"%s\"", text, *expected);
}

/* A high column turns about the corner of its foot, as one body of all its blocks. */
static void
test_overturning (void)
{
  static const char *const words[] = { "(3 blocks)", "clockwise about", NULL };
  for (int direction = -1; direction <= 1; direction += 2) {
    QnModel model;
    test_model_init_stack (&model, 3, 1, 1);
    test_model_add_weight_loads (&model, direction);
    assert_words (&model,
                  direction > 0 ? "Overturning to the right" : "Overturning to the left",
                  words);
  }
}

/* A block that cohesion alone holds slides along its bed. */
static void
test_sliding (void)
{
  static const char *const words[] = { "block", "slide", NULL };
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 0.5);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].friction = 0;
  model.laws[0].cohesion = 1000;
  assert_words (&model, "Sliding to the right", words);
}

/* The title of a mechanism of two bodies of two blocks each that move so. */
static void
assert_title (QnMechanismKind kind, QnVec2 first, QnVec2 second, const char *expected)
{
  QnMechanismBody bodies[] = { { .block_count = 2, .velocity = first },
                               { .block_count = 2, .velocity = second } };
  QnMechanism mechanism = { .kind = kind, .bodies = bodies, .body_count = 2 };
  g_autofree char *title = qn_mechanism_dup_title (&mechanism);
  g_assert_cmpstr (title, ==, expected);
}

/* A title tells the direction that its bodies have in common, and none where they part. */
static void
test_direction (void)
{
  const QnVec2 right = { 1, 0.1 }, left = { -1, 0.1 }, up = { 0, 1 }, down = { 0.1, -1 };
  assert_title (QN_MECHANISM_KIND_SLIDING, right, right, "Sliding to the right");
  assert_title (QN_MECHANISM_KIND_SLIDING, left, left, "Sliding to the left");
  assert_title (QN_MECHANISM_KIND_SLIDING, up, up, "Sliding upwards");
  assert_title (QN_MECHANISM_KIND_SLIDING, down, down, "Sliding downwards");
  assert_title (QN_MECHANISM_KIND_SLIDING, right, left, "Sliding");
  assert_title (QN_MECHANISM_KIND_ROCKING, left, right, "Rocking");
  assert_title (QN_MECHANISM_KIND_ROCKING, down, down, "Rocking");
  assert_title (QN_MECHANISM_KIND_MIXED, left, left, "Rocking and sliding to the left");
  assert_title (QN_MECHANISM_KIND_FALLING, up, up, "Lifting off");
  assert_title (QN_MECHANISM_KIND_FALLING, down, down, "Falling");
}

/* Every wall is told with its bodies by the names of their blocks, and its joints counted. */
static void
test_every_wall (void)
{
  static const char *const words[] = { "w.", "blocks)", "hinge", "open", NULL };
  static const char *const titles[TEST_WALL_COUNT] = {
    "Stepped crack, opening to the right",
    "Stepped crack, opening to the right",
    "Rocking to the right",
    "Rocking to the right",
    "Rocking to the right",
    "Rocking to the right",
  };
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    QnModel model;
    test_model_init_wall (&model, number, 0.65);
    assert_words (&model, titles[number - 1], words);
  }
}

/* Loaded to the left, a wall moves to the left. */
static void
test_mirrored_wall (void)
{
  static const char *const words[] = { "w.", NULL };
  QnModel model;
  test_model_init_wall (&model, 3, 0.65);
  test_model_mirror (&model);
  assert_words (&model, "Rocking to the left", words);
}

QN_TESTS
{
  g_test_add_func ("/mechanism-text/overturning", test_overturning);
  g_test_add_func ("/mechanism-text/sliding", test_sliding);
  g_test_add_func ("/mechanism-text/direction", test_direction);
  g_test_add_func ("/mechanism-text/walls", test_every_wall);
  g_test_add_func ("/mechanism-text/mirrored-wall", test_mirrored_wall);
}
