/* Ties drawn, moved, copied, renamed, followed through edits of their blocks, deleted; undone to the byte. */
#include "core/model/bar.h"
#include "doc/edit/edit-frame.h"
#include "doc/edit/edit-tie.h"

#include "doc/fixture.h"
#include "support/room.h"

/* Two stones side by side on the ground, and one that is free. */
static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"left\", \"vertices\": [[0,0],[1,0],[1,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"right\", \"vertices\": [[3,0],[4,0],[4,1],[3,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"top\", \"vertices\": [[0,1],[1,1],[1,2],[0,2]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" } }";

typedef struct Line {
  QnVec2 from, to;
} Line;

static gboolean
add (QnModel *model, gpointer data, GError **error)
{
  const Line *line = data;
  return qn_edit_draw_tie (model, line->from, line->to, error);
}

static const Line across = { { 0.5, 1.5 }, { 3.5, 0.5 } };
static const Line aside = { { 0.5, 1.2 }, { -2, 1.2 } };

/* Ends take the block that is there, or the ground, and say so before they are drawn. */
static void
test_add (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  static const struct {
    char *(*dup_text) (const QnModel *model, QnVec2 at);
    QnVec2 at;
    const char *text;
  } held[] = {
    { qn_tie_end_dup_text, { 0.5, 1.5 }, "on block top" },
    { qn_tie_end_dup_text, { 4, 0.5 }, "on block right" }, /* on its edge */
    { qn_tie_end_dup_text, { 4.001, 0.5 }, "in the ground" },
    { qn_beam_end_dup_text, { 0.5, 1.5 }, "on block top" },
    { qn_beam_end_dup_text, { -2, 1.2 }, "free" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (held); i++) {
    g_autofree char *words = held[i].dup_text (&document->project.model, held[i].at);
    g_assert_cmpstr (words, ==, held[i].text);
  }
  const QnModel *model = edit (document, add, &across);
  model = edit (document, add, &aside);
  g_assert_cmpuint (model->tie_count, ==, 2);
  g_assert_cmpint (model->ties[0].ends[0].block, ==, qn_model_find_block (model, "top"));
  g_assert_cmpint (model->ties[0].ends[1].block, ==,
                   qn_model_find_block (model, "right"));
  g_assert_cmpint (model->ties[1].ends[1].block, ==, QN_NONE);
  g_assert_cmpstr (model->ties[1].name, ==, "t2");
  const Line inside = { { 0.2, 1.2 }, { 0.8, 1.8 } }; /* both ends on one block */
  refuse (document, add, &inside);
  const Line nowhere = { { -5, 5 }, { -6, 5 } };
  refuse (document, add, &nowhere);
  g_autofree char *words =
    qn_tie_dup_text (model, &model->ties[0], (QnUnits){ .length = QN_LENGTH_M });
  g_assert_nonnull (strstr (words, "top – right"));
  while (qn_document_undo (document))
    ;
  g_assert_cmpuint (document->project.model.tie_count, ==, 0);
}

static gboolean
place (QnModel *model, gpointer data, GError **error)
{
  const QnVec2 *at = data;
  return qn_edit_place_tie_end (model, 0, 1, *at, error);
}

static gboolean
duplicate (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_duplicate_item (model, QN_PICK_TIE, *(QnId *) data, error) >= 0;
}

static gboolean
rename_first (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_take_name (&model->ties[0].name, data, error);
}

static gboolean
remove_tie (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_remove_item (model, QN_PICK_TIE, *(QnId *) data, error);
}

static void
test_change (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  const QnModel *model = edit (document, add, &across);
  QnVec2 far = qn_vec2 (6, 0.5), back = qn_vec2 (3.2, 0.9), own = qn_vec2 (0.9, 1.9);
  QnId first = 0, none = 7;
  model = edit (document, place, &far);
  g_assert_cmpint (model->ties[0].ends[1].block, ==, QN_NONE);
  model = edit (document, place, &back);
  g_assert_cmpint (model->ties[0].ends[1].block, ==,
                   qn_model_find_block (model, "right"));
  refuse (document, place, &own);
  model = edit (document, duplicate, &first);
  g_assert_cmpuint (model->tie_count, ==, 2);
  double apart =
    qn_vec2_length (qn_vec2_sub (model->ties[1].ends[0].at, model->ties[0].ends[0].at));
  g_assert_cmpfloat_with_epsilon (apart, 4 * qn_bar_get_diameter (model->ties[0].area),
                                  1e-12);
  model = edit (document, rename_first, (gpointer) "rod");
  g_assert_cmpint (qn_model_find_tie (model, "rod"), ==, 0);
  refuse (document, rename_first, model->ties[1].name);
  model = edit (document, remove_tie, &first);
  g_assert_cmpuint (model->tie_count, ==, 1);
  g_assert_cmpint (qn_model_find_tie (model, "rod"), ==, QN_NONE);
  refuse (document, remove_tie, &none);
}

static gboolean
move_top (QnModel *model, gpointer data, GError **error)
{
  const QnId id = qn_model_find_block (model, "top");
  (void) data;
  return qn_edit_transform_blocks (model, (QnBlockSet){ &id, 1 },
                                   qn_transform_translation (0, 0.5), error);
}

static gboolean
delete_block (QnModel *model, gpointer data, GError **error)
{
  const QnId id = qn_model_find_block (model, data);
  return qn_edit_delete_blocks (model, (QnBlockSet){ &id, 1 }, error);
}

/* Ends go with their block; a tie goes where its block does. */
static void
test_follow (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &across);
  const QnModel *model = edit (document, add, &aside);
  model = edit (document, move_top, NULL);
  g_assert_cmpfloat (model->ties[0].ends[0].at.y, ==, 2);
  g_assert_cmpfloat (model->ties[0].ends[1].at.y, ==, 0.5);
  g_assert_cmpfloat (model->ties[1].ends[1].at.y, ==, 1.2); /* the ground stays */
  model = edit (document, delete_block, (gpointer) "left");
  g_assert_cmpuint (model->tie_count, ==, 2);
  g_assert_cmpint (model->ties[1].ends[0].block, ==, qn_model_find_block (model, "top"));
  model = edit (document, delete_block, (gpointer) "right");
  g_assert_cmpuint (model->tie_count, ==, 1);
  g_assert_cmpint (model->ties[0].ends[1].block, ==, QN_NONE);
}

static gboolean
stretch_and_glue (QnModel *model, gpointer data, GError **error)
{
  const Line *line = data;
  model->ties[0].ends[0].at = line->from;
  model->ties[0].ends[1].at = line->to;
  return qn_edit_glue_tie (model, 0, error);
}

/* Glued from the ground to the top, along a face, a strip is the chain of the example; one within a block
 * crosses no joint. */
static void
test_glue (void)
{
  g_autoptr (QnDocument) document = open_example ("63-strip-of-fibres.quoin");
  const Line whole = { { 0, -0.3 }, { 0, 3 } }, within = { { 0, 0.2 }, { 0, 0.8 } };
  static const double middles[] = { -0.15, 0.5, 1.5, 2.5 };
  const QnModel *model = edit (document, stretch_and_glue, (gpointer) &whole);
  g_assert_cmpuint (model->tie_count, ==, 5);
  for (gsize i = 0; i < 3; i++) {
    const QnTie *part = &model->ties[i == 0 ? 0 : i + 2], *like = &model->ties[i];
    for (int end = 0; end < 2; end++) {
      g_assert_cmpint (part->ends[end].block, ==, like->ends[end].block);
      g_assert_cmpfloat_with_epsilon (part->ends[end].at.y, middles[i + (gsize) end],
                                      1e-12);
    }
    g_assert_cmpfloat (part->strip.fracture_energy, ==, 300);
  }
  refuse (document, stretch_and_glue, (gpointer) &within);
}

QN_TESTS
{
  g_test_add_func ("/edit-tie/glue", test_glue);
  g_test_add_func ("/edit-tie/add", test_add);
  g_test_add_func ("/edit-tie/change", test_change);
  g_test_add_func ("/edit-tie/follow", test_follow);
}
