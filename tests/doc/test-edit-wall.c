#include "doc/document.h"
#include "doc/edit.h"

typedef struct Opening {
  QnVec2 a, b;
  gboolean lintel;
} Opening;

static const QnWallPlan plan = { .origin = { 0.0, 0.0 },
                                 .width = 2.0,
                                 .height = 1.75,
                                 .unit = { 0.4, 0.175 },
                                 .bond = QN_WALL_BOND_RUNNING,
                                 .style = { 1.0, 1e4, QN_NONE, { false } },
                                 .base = true };

static gboolean
add_wall (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_add_wall (model, data, error);
}

static gboolean
cut (QnModel *model, gpointer data, GError **error)
{
  const Opening *o = data;
  return qn_edit_cut_opening (model, 0, o->a, o->b, o->lintel, error);
}

static gboolean
fill (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_fill_opening (model, 0, *(const QnVec2 *) data, error);
}

static QnDocument *
document_with_wall (const QnWallPlan *wall)
{
  QnDocument *document = qn_document_new ();
  GError *error = NULL;
  qn_document_edit (document, "Add Wall", NULL, add_wall, (gpointer) wall, &error);
  g_assert_no_error (error);
  return document;
}

static double
total_area (const QnModel *model)
{
  double area = 0.0;
  for (gsize i = 0; i < model->block_count; i++)
    area += model->blocks[i].area;
  return area;
}

static void
test_bonds (void)
{
  for (int bond = 0; bond < QN_WALL_BOND_COUNT; bond++) {
    QnWallPlan wall = plan;
    wall.bond = (QnWallBond) bond;
    g_autoptr (QnDocument) document = document_with_wall (&wall);
    const QnModel *model = qn_document_get_model (document);
    /* Ten courses of 2 m and a base of the same width, without gaps or overlaps. */
    g_assert_cmpfloat_with_epsilon (total_area (model), 2.0 * 11 * 0.175, 1e-9);
    g_assert_cmpuint (qn_document_get_contacts (document)->findings.count, ==, 0);
    /* Running bond: five blocks and six by turns; stack: five; third bond: six. */
    gsize expected[QN_WALL_BOND_COUNT] = { 1 + 5 * 6 + 5 * 5, 1 + 10 * 5, 1 + 10 * 6 };
    g_assert_cmpuint (model->block_count, ==, expected[bond]);
  }
}

static void
test_opening (void)
{
  g_autoptr (QnDocument) document = document_with_wall (&plan);
  double before = total_area (qn_document_get_model (document));
  g_autofree char *text = g_strdup (qn_document_get_text (document));
  g_autoptr (GError) error = NULL;
  /* About 0.8 x 0.7 m, which half blocks and courses make exact. */
  Opening opening = { { 0.63, 0.5 }, { 1.38, 1.25 }, FALSE };
  qn_document_edit (document, "Cut", NULL, cut, &opening, &error);
  g_assert_no_error (error);
  const QnModel *model = qn_document_get_model (document);
  g_assert_cmpfloat_with_epsilon (total_area (model), before - 0.8 * 0.7, 1e-9);

  QnVec2 low, high, middle = { 1.0, 0.9 };
  g_assert_true (qn_wall_find_opening (&model->walls[0], middle, &low, &high));
  g_assert_cmpfloat_with_epsilon (low.x, 0.6, 1e-9);
  g_assert_cmpfloat_with_epsilon (low.y, 0.525, 1e-9);
  g_assert_cmpfloat_with_epsilon (high.x, 1.4, 1e-9);
  g_assert_cmpfloat_with_epsilon (high.y, 1.225, 1e-9);

  qn_document_edit (document, "Fill", NULL, fill, &middle, &error);
  g_assert_no_error (error);
  g_assert_cmpfloat_with_epsilon (total_area (qn_document_get_model (document)), before,
                                  1e-9);
  qn_document_edit (document, "Fill", NULL, fill, &middle, &error);
  g_assert_error (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING);
  while (qn_document_undo (document))
    ;
  qn_document_redo (document);
  g_assert_cmpstr (qn_document_get_text (document), ==, text);
}

/* A lintel is one block that bears half a block on either side. */
static void
test_lintel (void)
{
  g_autoptr (QnDocument) document = document_with_wall (&plan);
  g_autoptr (GError) error = NULL;
  Opening opening = { { 0.6, 0.525 }, { 1.4, 1.225 }, TRUE };
  qn_document_edit (document, "Cut", NULL, cut, &opening, &error);
  g_assert_no_error (error);
  const QnModel *model = qn_document_get_model (document);
  int lintels = 0;
  for (gsize i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    if (block->wall != QN_NONE && block->area > 0.4 * 0.175 + 1e-9) {
      lintels++;
      g_assert_cmpfloat_with_epsilon (block->area, 1.2 * 0.175, 1e-9);
      g_assert_cmpfloat_with_epsilon (block->centroid.x, 1.0, 1e-9);
      g_assert_cmpfloat_with_epsilon (block->centroid.y, 1.225 + 0.0875, 1e-9);
    }
  }
  g_assert_cmpint (lintels, ==, 1);
}

static gboolean
add_force (QnModel *model, gpointer data, GError **error)
{
  QnId block = qn_model_find_block (model, data);
  return qn_edit_add_force (model, block, TRUE, qn_vec2 (1.0, 0.0),
                            model->blocks[block].centroid, error);
}

/* A force stays on the block at its place when positions in the course are counted anew, and
 * goes with the block when that goes. */
static void
test_loads_follow (void)
{
  g_autoptr (QnDocument) document = document_with_wall (&plan);
  g_autoptr (GError) error = NULL;
  char last[] = "w1.5.6";
  QnVec2 at = qn_document_get_model (document)
                ->blocks[qn_model_find_block (qn_document_get_model (document), last)]
                .centroid;
  qn_document_edit (document, "Force", NULL, add_force, last, &error);
  g_assert_no_error (error);
  Opening opening = { { 0.6, 0.525 }, { 1.4, 1.225 }, FALSE };
  qn_document_edit (document, "Cut", NULL, cut, &opening, &error);
  g_assert_no_error (error);
  const QnModel *model = qn_document_get_model (document);
  g_assert_cmpuint (model->live_load_count, ==, 2);
  QnId block = model->live_loads[1].block;
  g_assert_cmpfloat_with_epsilon (model->blocks[block].centroid.x, at.x, 1e-9);
  g_assert_cmpfloat_with_epsilon (model->blocks[block].centroid.y, at.y, 1e-9);
  g_assert_cmpstr (model->blocks[block].name, !=, last);

  Opening corner = { { 1.8, 0.6 }, { 2.0, 1.0 }, FALSE };
  qn_document_edit (document, "Cut", NULL, cut, &corner, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (qn_document_get_model (document)->live_load_count, ==, 1);
}

static void
test_refusals (void)
{
  g_autoptr (QnDocument) document = document_with_wall (&plan);
  g_autofree char *text = g_strdup (qn_document_get_text (document));
  const struct {
    Opening opening;
  } outside[] = { { { { 5.0, 5.0 }, { 6.0, 6.0 }, FALSE } },
                  { { { 1.0, 1.0 }, { 1.01, 1.01 }, FALSE } } };
  for (gsize i = 0; i < G_N_ELEMENTS (outside); i++) {
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_document_edit (document, "Cut", NULL, cut,
                                      (gpointer) &outside[i].opening, &error));
    g_assert_error (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING);
  }
  QnWallPlan huge = plan;
  huge.width = 1e9;
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_document_edit (document, "Wall", NULL, add_wall, &huge, &error));
  g_assert_error (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE);
  g_assert_cmpstr (qn_document_get_text (document), ==, text);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/edit-wall/bonds", test_bonds);
  g_test_add_func ("/doc/edit-wall/opening", test_opening);
  g_test_add_func ("/doc/edit-wall/lintel", test_lintel);
  g_test_add_func ("/doc/edit-wall/loads-follow", test_loads_follow);
  g_test_add_func ("/doc/edit-wall/refusals", test_refusals);
  return g_test_run ();
}
