/* Every allocation between a recipe and its contacts fails once, alone and with all after it. */
#include "core/contact/contacts.h"
#include "support/failing-memory.h"
#include "support/generate.h"
#include "support/room.h"

#include <glib.h>

/* What brings every kind of finding: a gap, an overlap, a touching corner, a floating block, a
 * polygon of many vertices, an exception without a face. */
static QnStatus
add_trouble (QnModel *model, QnDiag *diag)
{
  enum { MANY = 80 };
  QnVec2 round[MANY];
  for (int i = 0; i < MANY; i++)
    round[i] = qn_vec2 (20 + cos (2 * G_PI * i / MANY), sin (2 * G_PI * i / MANY));
  const QnVec2 gap[] = { { 0.8, 0.001 }, { 1.2, 0.001 }, { 1.2, 0.2 }, { 0.8, 0.2 } };
  const QnVec2 overlap[] = {
    { 1, 0.1 }, { 1.6, 0.1 }, { 1.3, 0.2 }, { 1.6, 0.4 }, { 1, 0.4 }
  };
  const QnVec2 diamond[] = { { 5, 0 }, { 6, 1 }, { 5, 2 }, { 4, 1 } };
  const QnVec2 slab[] = { { 3, -1 }, { 7, -1 }, { 7, 0 }, { 3, 0 } };
  const struct {
    const QnVec2 *vertices;
    size_t count;
  } blocks[] = {
    { round, MANY }, { gap, 4 }, { overlap, 5 }, { diamond, 4 }, { slab, 4 }
  };
  const char *const names[] = { "round", "gap", "overlap", "diamond", "slab" };

  for (size_t i = 0; i < G_N_ELEMENTS (blocks); i++) {
    QnBlock *block =
      qn_model_add_block (model, names[i], blocks[i].vertices, blocks[i].count);
    if (block == NULL)
      return qn_diag_no_memory (diag);
    block->thickness = 1;
  }
  QnFaceOverride *override = qn_model_add_override (model);
  if (override == NULL)
    return qn_diag_no_memory (diag);
  override->block_a = 0;
  override->block_b = 1;
  return QN_OK;
}

/* Faces and findings found, or -1 where memory was refused. */
static int
run_cycle (void)
{
  QnModel model;
  QnDiag diag = { 0 };
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = 2;
  recipe.courses = 2;
  qn_model_init (&model);
  QnStatus status = qn_generate_wall (&model, &recipe, &diag);
  if (status == QN_OK)
    status = add_trouble (&model, &diag);

  int found = -1;
  QnContacts contacts;
  if (status == QN_OK)
    status = qn_model_prepare (&model, &diag);
  if (status == QN_OK)
    status = qn_contacts_detect (&model, &contacts, &diag);
  if (status == QN_OK) {
    found = (int) (contacts.face_count + 100 * contacts.findings.count);
    qn_contacts_clear (&contacts);
  }
  if (status != QN_OK) {
    g_assert_cmpint (status, ==, QN_ERROR_NO_MEMORY);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_MEMORY);
  }
  qn_model_clear (&model);
  return found;
}

static void
test_every_allocation (const void *data)
{
  bool onwards = GPOINTER_TO_INT (data);
  int expected = run_cycle ();
  g_assert_cmpint (expected, >, 400);
  long number = 0;
  for (bool hit = true; hit; number++) {
    failing_memory_arm (number, onwards);
    int found = run_cycle ();
    hit = failing_memory_disarm ();
    g_assert_cmpint (found, ==, hit ? -1 : expected);
  }
  g_assert_cmpint (number, >, 40);
}

QN_TESTS
{
  g_test_add_data_func ("/contacts-memory/single", GINT_TO_POINTER (false),
                        test_every_allocation);
  g_test_add_data_func ("/contacts-memory/onwards", GINT_TO_POINTER (true),
                        test_every_allocation);
}
