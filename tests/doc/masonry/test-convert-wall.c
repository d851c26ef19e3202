#include "doc/edit/edit-masonry.h"
#include "io/project/project-masonry.h"

#include "doc/fixture.h"
#include "support/room.h"

#include <math.h>

static gboolean
convert (QnProject *draft, gpointer data, GError **error)
{
  return qn_edit_convert_wall (draft, *(const QnId *) data, error);
}

/* Every published wall keeps its blocks, one by one. */
static void
test_same_blocks (void)
{
  for (int number = 1; number <= 6; number++) {
    g_autofree char *name = g_strdup_printf ("ferris-tin-loi/wall%d.quoin", number);
    g_autoptr (QnDocument) before = open_example (name);
    g_autoptr (QnDocument) after = open_example (name);
    QnId wall = 0;
    g_autoptr (GError) error = NULL;
    qn_document_edit (after, "Convert", NULL, convert, &wall, &error);
    g_assert_no_error (error);

    const QnModel *a = &before->project.model, *b = &after->project.model;
    g_assert_cmpuint (b->wall_count, ==, a->wall_count - 1);
    g_assert_cmpuint (a->block_count, ==, b->block_count);
    for (gsize i = 0; i < a->block_count; i++) {
      gboolean found = FALSE;
      for (gsize k = 0; k < b->block_count; k++)
        found =
          found
          || (qn_vec2_length (qn_vec2_sub (a->blocks[i].centroid, b->blocks[k].centroid))
                < 1e-9
              && fabs (a->blocks[i].area - b->blocks[k].area) < 1e-9);
      g_assert_true (found);
    }
    g_assert_cmpuint (before->contacts.face_count, ==, after->contacts.face_count);
  }
}

/* A gap that like courses explain becomes an opening, with the long block above as its lintel;
 * filled, the wall is whole. */
static void
test_openings (void)
{
  static const char text[] =
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ],"
    "  \"walls\": [ { \"name\": \"w\", \"unit\": [0.4, 0.2], \"thickness\": 1,"
    "    \"unit_weight\": 1e4, \"courses\": [ [1, 1, 1, 1], [0.5, 1, -1, 1, 0.5],"
    "    [1, 0.5, -1, 0.5, 1], [0.5, 0.5, 2, 0.5, 0.5], [1, 1, 1, 1],"
    "    [0.5, 1, 1, 1, 0.5] ] } ],"
    "  \"contact\": { \"law\": \"dry\" } }";
  g_autoptr (QnDocument) document = open_text (text);
  g_autoptr (GError) error = NULL;
  QnId wall = 0;
  qn_document_edit (document, "Convert", NULL, convert, &wall, &error);
  g_assert_no_error (error);

  QnMasonries list;
  g_assert_true (
    qn_project_get_masonry (qn_document_get_project (document), &list, NULL));
  g_assert_cmpuint (list.count, ==, 1);
  g_assert_cmpuint (list.items[0].wall.opening_count, ==, 1);
  const QnOpening *opening = &list.items[0].wall.openings[0];
  g_assert_cmpfloat_with_epsilon (opening->at.x, 0.6, 1e-12);
  g_assert_cmpfloat_with_epsilon (opening->at.y, 0.2, 1e-12);
  g_assert_cmpfloat_with_epsilon (opening->width, 0.4, 1e-12);
  g_assert_cmpfloat_with_epsilon (opening->height, 0.4, 1e-12);
  g_assert_cmpint (opening->span, ==, QN_SPAN_LINTEL);
  g_assert_cmpfloat_with_epsilon (opening->bearing, 0.2, 1e-12);
  qn_masonries_clear (&list);
  g_assert_cmpint (qn_model_find_block (&document->project.model, "w.o1.lintel"), !=,
                   QN_NONE);

  g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (document->project.model.wall_count, ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/doc/convert-wall/same-blocks", test_same_blocks);
  g_test_add_func ("/doc/convert-wall/openings", test_openings);
}
