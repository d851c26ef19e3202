#include "support/contacts.h"
#include "support/generate.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

static void
assert_same (const QnContacts *found, const QnContacts *expected)
{
  test_assert_same_faces (found, expected);
  g_assert_cmpuint (found->findings.count, ==, expected->findings.count);
  for (size_t i = 0; i < found->findings.count; i++) {
    const QnFinding *f = &found->findings.items[i], *e = &expected->findings.items[i];
    g_assert_cmpint (f->problem, ==, e->problem);
    g_assert_cmpint (f->block_a, ==, e->block_a);
    g_assert_cmpint (f->block_b, ==, e->block_b);
    g_assert_cmpfloat (f->at.x, ==, e->at.x);
    g_assert_cmpfloat (f->at.y, ==, e->at.y);
    g_assert_cmpfloat (f->value, ==, e->value);
  }
}

/* A copy of the blocks without `without`, with the vertices as `edit` leaves them and `added`
 * (nullable) at the end. */
typedef void (*Edit) (QnVec2 *vertices, QnId count, QnId block, void *data);

static void
rebuild (const QnModel *from, QnModel *to, QnId without, const QnVec2 *added, Edit edit,
         void *data)
{
  test_model_init (to);
  to->contact = from->contact;
  for (size_t i = 0; i < from->block_count; i++) {
    const QnBlock *old = &from->blocks[i];
    QnVec2 vertices[64];
    if ((QnId) i == without)
      continue;
    memcpy (vertices, qn_model_block_vertices (from, (QnId) i),
            (size_t) old->vertex_count * sizeof *vertices);
    if (edit != NULL)
      edit (vertices, old->vertex_count, (QnId) i, data);
    QnBlock *block =
      qn_model_add_block (to, old->name, vertices, (size_t) old->vertex_count);
    block->thickness = old->thickness;
    block->unit_weight = old->unit_weight;
    memcpy (block->support, old->support, sizeof old->support);
  }
  if (added != NULL)
    qn_model_add_block (to, "added", added, 4)->thickness = 1;
}

typedef struct {
  QnId block;
  QnVec2 shift;
} Shift;

static void
shift_block (QnVec2 *vertices, QnId count, QnId block, void *data)
{
  const Shift *shift = data;
  for (QnId i = 0; i < count && block == shift->block; i++)
    vertices[i] = qn_vec2_add (vertices[i], shift->shift);
}

static void
stretch_block (QnVec2 *vertices, QnId count, QnId block, void *data)
{
  const Shift *shift = data;
  for (QnId i = 0; i < count / 2 && block == shift->block; i++)
    vertices[i] = qn_vec2_add (vertices[i], shift->shift);
}

/* A step of the size that matters: none at all, a little gap, a little overlap, a block length. */
static double
draw_step (GRand *random)
{
  const double steps[] = { 0, 1e-3, -1e-3, 1e-6, -1e-6, 0.05, -0.05, 0.2, -0.2, 0.4, 5 };
  return steps[g_rand_int_range (random, 0, G_N_ELEMENTS (steps))];
}

/* Long chains of edits: after each, what the update says is what a detection says. */
static void
test_equals_detection (void)
{
  GRand *random = g_rand_new_with_seed (23);
  for (uint64_t seed = 1; seed <= 8; seed++) {
    QnModel model;
    QnContacts contacts;
    QnWallRecipe recipe = qn_wall_recipe_default ();
    recipe.length = 8;
    recipe.courses = 10;
    recipe.openings = (int32_t) seed / 2;
    recipe.seed = seed;
    qn_model_init (&model);
    g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
    if (seed % 2 == 0)
      test_model_rotate (&model, (double) seed);
    test_detect (&model, &contacts);

    for (int step = 0; step < 120; step++) {
      QnModel next;
      QnContacts found, expected;
      QnId block = g_rand_int_range (random, 0, (gint32) model.block_count);
      Shift shift = { block, { draw_step (random), draw_step (random) } };
      QnVec2 c = model.blocks[block].centroid;
      const QnVec2 added[] = { { c.x, c.y + 0.2 },
                               { c.x + 0.3, c.y + 0.2 },
                               { c.x + 0.3, c.y + 0.5 },
                               { c.x, c.y + 0.5 } };
      int kind = g_rand_int_range (random, 0, 8);
      bool may_add = qn_model_find_block (&model, "added") == QN_NONE;
      rebuild (&model, &next, kind == 0 && block != 0 ? block : QN_NONE,
               kind == 1 && may_add ? added : NULL,
               kind < 2    ? NULL
               : kind == 2 ? stretch_block
                           : shift_block,
               &shift);
      QnDiag diag;
      if (qn_model_prepare (&next, &diag) != QN_OK) { /* stretched beyond itself */
        qn_model_clear (&next);
        continue;
      }
      g_assert_cmpint (qn_contacts_update (&model, &contacts, &next, &found, NULL), ==,
                       QN_OK);
      g_assert_cmpint (qn_contacts_detect (&next, &expected, NULL), ==, QN_OK);
      assert_same (&found, &expected);
      qn_contacts_clear (&expected);
      qn_contacts_clear (&contacts);
      qn_model_clear (&model);
      model = next;
      contacts = found;
    }
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
  g_rand_free (random);
}

/* What forces a full detection: other numbering, another tolerance, everything moved, nothing
 * known before. */
static void
test_large_changes (void)
{
  for (int kind = 0; kind < 4; kind++) {
    g_auto (QnModel) model, next;
    g_auto (QnContacts) contacts, found, expected;
    test_model_init_wall (&model, 4, 0);
    g_assert_cmpint (qn_model_expand_walls (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_model_copy (&model, &next, NULL), ==, QN_OK);
    test_detect (&model, &contacts);
    if (kind == 0)
      test_model_renumber (&next, 5);
    else if (kind == 1)
      next.contact.tolerance = 1e-4;
    else if (kind == 2)
      test_model_translate (&next, 3, 4);
    g_assert_cmpint (qn_model_prepare (&next, NULL), ==, QN_OK);
    QnModel none = { 0 };
    QnContacts nothing = { 0 };
    g_assert_cmpint (qn_contacts_update (kind == 3 ? &none : &model,
                                         kind == 3 ? &nothing : &contacts, &next, &found,
                                         NULL),
                     ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&next, &expected, NULL), ==, QN_OK);
    assert_same (&found, &expected);
  }
}

/* Laws, pairs and supports are taken from the new model although no block has moved. */
static void
test_settings_count (void)
{
  g_auto (QnModel) model, next;
  g_auto (QnContacts) contacts, found, expected;
  test_model_init_wall (&model, 2, 0);
  g_assert_cmpint (qn_model_expand_walls (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_copy (&model, &next, NULL), ==, QN_OK);
  test_detect (&model, &contacts);
  next.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 3 };
  next.blocks[0].support[0] = next.blocks[0].support[1] = next.blocks[0].support[2] =
    false;
  qn_model_add_law (&next, "other")->kind = QN_LAW_ELASTIC;
  next.laws[1].kn = next.laws[1].ks = 1;
  next.blocks[5].law = 1;
  g_assert_cmpint (qn_model_prepare (&next, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_update (&model, &contacts, &next, &found, NULL), ==,
                   QN_OK);
  g_assert_cmpint (qn_contacts_detect (&next, &expected, NULL), ==, QN_OK);
  assert_same (&found, &expected);
  g_assert_cmpuint (found.pair_count, ==, 3 * found.face_count);
  g_assert_cmpuint (test_count_findings (&found, QN_PROBLEM_NO_SUPPORT), ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/contacts-update/equals-detection", test_equals_detection);
  g_test_add_func ("/contacts-update/large-changes", test_large_changes);
  g_test_add_func ("/contacts-update/settings-count", test_settings_count);
}
