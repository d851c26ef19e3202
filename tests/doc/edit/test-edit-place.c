#include "doc/edit/edit-place.h"

#include "doc/edit/edit-masonry.h"
#include "doc/fixture.h"
#include "doc/masonry/masonry-plan.h"
#include "support/room.h"

#include <math.h>

/* Three blocks beside each other, of 2 x 1, 1 x 1 and 0.5 x 2 m, and a triangle. */
static const char project[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"a\", \"vertices\": [[0,0],[2,0],[2,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"b\", \"vertices\": [[3,2],[4,2],[4,3],[3,3]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 },"
  "    { \"name\": \"c\", \"vertices\": [[9,1],[9.5,1],[9.5,3],[9,3]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" } }";

typedef struct Place {
  QnPartSet set;
  int how;
  double value;
} Place;

static gboolean
set_extent (QnProject *draft, gpointer data, GError **error)
{
  const Place *p = data;
  return qn_edit_set_extent (draft, p->set, (QnExtentField) p->how, p->value, error);
}

static void
edit_place (QnDocument *document, QnEditFunc func, Place place)
{
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_document_edit (document, "place", NULL, func, &place, &error));
  g_assert_no_error (error);
}

static void
refuse_place (QnDocument *document, QnEditFunc func, Place place)
{
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_document_edit (document, "place", NULL, func, &place, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
}

static QnExtent
extent_of (QnDocument *document, const QnId *ids, guint count)
{
  QnExtent extent;
  g_assert_true (qn_extent_find (&document->project.model,
                                 (QnPartSet){ { ids, count }, { NULL, 0 } }, &extent));
  return extent;
}

static const QnId ids[] = { 0, 1, 2 };
#define ALL    ((QnPartSet){ { ids, 3 }, { NULL, 0 } })
#define ONE(i) ((QnPartSet){ { &ids[i], 1 }, { NULL, 0 } })

static void
check_box (QnDocument *document, guint i, double x0, double y0, double x1, double y1)
{
  QnBox box = extent_of (document, &ids[i], 1).box;
  g_assert_cmpfloat_with_epsilon (box.min.x, x0, 1e-12);
  g_assert_cmpfloat_with_epsilon (box.min.y, y0, 1e-12);
  g_assert_cmpfloat_with_epsilon (box.max.x, x1, 1e-12);
  g_assert_cmpfloat_with_epsilon (box.max.y, y1, 1e-12);
}

static void
test_extents (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  QnExtent all = extent_of (document, ids, 3);
  g_assert_cmpfloat (all.area, ==, 4.0);
  g_assert_cmpfloat (all.weight, ==, 4e4);
  g_assert_cmpfloat_with_epsilon (all.centroid.x, (2 * 1.0 + 3.5 + 9.25) / 4.0, 1e-12);
  g_assert_cmpfloat (all.angle, ==, 0.0);
  g_assert_cmpfloat_with_epsilon (extent_of (document, &ids[2], 1).angle, G_PI_2, 1e-12);
  QnExtent none;
  g_assert_false (qn_extent_find (&document->project.model, (QnPartSet){ 0 }, &none));
}

/* Place, size and angle of one block and of several; each is one step that undo takes back. */
static void
test_numbers (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  edit_place (document, set_extent, (Place){ ONE (1), QN_EXTENT_X, 2.5 });
  check_box (document, 1, 2.5, 2, 3.5, 3);
  edit_place (document, set_extent, (Place){ ONE (1), QN_EXTENT_Y, 1.0 });
  edit_place (document, set_extent, (Place){ ONE (1), QN_EXTENT_WIDTH, 3.0 });
  edit_place (document, set_extent, (Place){ ONE (1), QN_EXTENT_HEIGHT, 0.5 });
  check_box (document, 1, 2.5, 1, 5.5, 1.5);
  edit_place (document, set_extent,
              (Place){ ONE (1), QN_EXTENT_ANGLE, 30.0 * G_PI / 180.0 });
  g_assert_cmpfloat_with_epsilon (extent_of (document, &ids[1], 1).angle,
                                  30.0 * G_PI / 180.0, 1e-9);
  edit_place (document, set_extent, (Place){ ONE (1), QN_EXTENT_ANGLE, 0.0 });
  check_box (document, 1, 2.5, 1, 5.5, 1.5);
  for (int i = 0; i < 6; i++)
    g_assert_true (qn_document_undo (document));
  check_box (document, 1, 3, 2, 4, 3);

  edit_place (document, set_extent, (Place){ ALL, QN_EXTENT_X, 1.0 });
  check_box (document, 2, 10, 1, 10.5, 3);
  edit_place (document, set_extent, (Place){ ALL, QN_EXTENT_WIDTH, 19.0 });
  check_box (document, 0, 1, 0, 5, 1);
  check_box (document, 2, 19, 1, 20, 3);
  refuse_place (document, set_extent, (Place){ ALL, QN_EXTENT_WIDTH, 0.0 });
}

static gboolean
add_walls (QnProject *draft, gpointer data, GError **error)
{
  (void) data;
  const QnMasonryStyle style = { .unit = { 0.5, 0.25 },
                                 .lap = 0.5,
                                 .thickness = 1.0,
                                 .unit_weight = 1e4,
                                 .law = QN_NONE,
                                 .base = FALSE };
  for (int i = 0; i < 2; i++) {
    QnMasonry wall;
    qn_plan_wall (&wall, &style, qn_vec2 (20.0 + 5.0 * i, 0.0),
                  qn_vec2 (22.0 + 5.0 * i, 1.0 + i));
    if (!qn_edit_add_masonry (draft, &wall, error))
      return FALSE;
  }
  return TRUE;
}

/* Walls move as wholes and stay parametric. */
static void
test_walls (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_document_edit (document, "walls", NULL, add_walls, NULL, &error));
  const QnModel *model = &document->project.model;
  g_autofree QnId *walls = g_new (QnId, model->block_count);
  guint count = 0;
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      walls[count++] = i;
  g_assert_cmpuint (count, >, 10);
  QnPartSet set = { { walls, count }, { NULL, 0 } };
  g_assert_false (qn_extent_can_scale (model, set));
  edit_place (document, set_extent, (Place){ set, QN_EXTENT_Y, 1.0 });
  model = &document->project.model;
  QnBox first = QN_BOX_EMPTY;
  guint parametric = 0;
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    parametric += model->blocks[i].masonry != QN_NONE;
    const QnVec2 *v = qn_model_block_vertices (model, i);
    for (QnId k = 0; k < model->blocks[i].vertex_count && model->blocks[i].masonry == 0;
         k++)
      qn_box_add_point (&first, v[k]);
  }
  g_assert_cmpuint (parametric, ==, count);
  g_assert_cmpfloat_with_epsilon (first.min.y, 1.0, 1e-9);
  g_assert_cmpfloat_with_epsilon (first.max.y, 2.0, 1e-9);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-place/extents", test_extents);
  g_test_add_func ("/doc/edit-place/numbers", test_numbers);
  g_test_add_func ("/doc/edit-place/walls", test_walls);
}
