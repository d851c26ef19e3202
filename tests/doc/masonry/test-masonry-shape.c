#include "doc/masonry/masonry-field.h"
#include "doc/masonry/masonry-shape.h"
#include "stereotomy/masonry.h"
#include "support/auto-clear.h"
#include "support/room.h"

static QnMasonry
make_wall (void)
{
  QnMasonry wall;
  qn_masonry_init (&wall, QN_MASONRY_WALL, "w");
  wall.origin = qn_vec2 (1.0, 2.0);
  wall.wall.height = 2.0;
  wall.wall.leaves[0].length = 3.2;
  wall.wall.leaves[0].unit = qn_vec2 (0.4, 0.2);
  return wall;
}

static void
assert_point (QnVec2 a, double x, double y)
{
  g_assert_cmpfloat_with_epsilon (a.x, x, 1e-12);
  g_assert_cmpfloat_with_epsilon (a.y, y, 1e-12);
}

static void
test_frame (void)
{
  g_auto (QnMasonry) wall = make_wall ();
  wall.rotation = G_PI_2;
  QnVec2 p = qn_masonry_to_model (&wall, qn_vec2 (2.0, 1.0));
  assert_point (p, 0.0, 4.0);
  assert_point (qn_masonry_to_local (&wall, p), 2.0, 1.0);
  g_assert_true (qn_masonry_wall_contains (&wall, p));
  g_assert_false (qn_masonry_wall_contains (&wall, qn_vec2 (2.0, 3.0)));
}

static void
test_opening_box (void)
{
  g_auto (QnMasonry) wall = make_wall ();
  QnOpening opening = { .voussoirs = 1 };
  g_assert_true (qn_masonry_set_opening_box (&wall, &opening, qn_vec2 (3.05, 3.31),
                                             qn_vec2 (2.18, 2.57), TRUE));
  assert_point (opening.at, 1.2, 0.6);
  g_assert_cmpfloat_with_epsilon (opening.width, 0.8, 1e-12);
  g_assert_cmpfloat_with_epsilon (opening.height, 0.8, 1e-12);
  /* Beyond the wall it ends at the wall; without an area there is none. */
  g_assert_true (qn_masonry_set_opening_box (&wall, &opening, qn_vec2 (0.0, 2.0),
                                             qn_vec2 (9.0, 3.0), FALSE));
  g_assert_cmpfloat_with_epsilon (opening.width, 3.2, 1e-12);
  g_assert_false (qn_masonry_set_opening_box (&wall, &opening, qn_vec2 (2.0, 3.0),
                                              qn_vec2 (2.01, 3.01), TRUE));
}

static void
test_drag_opening (void)
{
  g_auto (QnMasonry) wall = make_wall ();
  QnOpening *opening = qn_masonry_add_opening (&wall);
  *opening =
    (QnOpening){ .at = { 1.2, 0.6 }, .width = 0.8, .height = 0.8, .voussoirs = 1 };
  QnHandle handles[QN_HANDLE_COUNT];
  guint count = qn_masonry_get_handles (&wall, 0, handles);
  g_assert_cmpuint (count, ==, 9);
  for (guint i = 0; i < count; i++) {
    if (handles[i].kind == QN_HANDLE_TOP_RIGHT)
      assert_point (handles[i].at, 3.0, 3.4);
  }
  QnVec2 from = qn_vec2 (3.0, 3.4);
  qn_masonry_drag (&wall, 0, QN_HANDLE_TOP_RIGHT, from, qn_vec2 (3.17, 3.29), TRUE);
  g_assert_cmpfloat_with_epsilon (opening->width, 1.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (opening->height, 0.6, 1e-12);
  /* An edge does not pass the one opposite, and nothing leaves the wall. */
  qn_masonry_drag (&wall, 0, QN_HANDLE_LEFT, from, qn_vec2 (9.0, 3.0), FALSE);
  g_assert_cmpfloat (opening->width, >, 0.0);
  qn_masonry_drag (&wall, 0, QN_HANDLE_MIDDLE, qn_vec2 (0, 0), qn_vec2 (-9, -9), TRUE);
  assert_point (opening->at, 0.0, 0.0);
}

/* Whatever head and span are asked for, what comes out can be laid. */
static void
test_heads (void)
{
  for (int head = 0; head < QN_HEAD_COUNT; head++) {
    for (int span = 0; span < QN_SPAN_COUNT; span++) {
      g_auto (QnMasonry) wall = make_wall ();
      wall.unit_weight = 1e4;
      QnOpening *opening = qn_masonry_add_opening (&wall);
      *opening =
        (QnOpening){ .at = { 1.2, 0.4 }, .width = 0.8, .height = 0.8, .voussoirs = 1 };
      qn_opening_set_head (opening, (QnHead) head, (QnSpan) span, 0.2);
      g_auto (QnModel) model;
      QnDiag diag = { 0 };
      qn_model_init (&model);
      g_assert_cmpint (qn_masonry_expand (&wall, 0, &model, &diag), ==, QN_OK);
      g_assert_cmpuint (model.block_count, >, 50);
    }
  }
}

/* Sets the field of this label. */
static void
set_field (QnMasonry *masonry, const char *label, double value)
{
  for (guint field = 0; field < QN_MASONRY_FIELDS; field++)
    if (qn_masonry_has_field (masonry, QN_NO_OPENING, field)
        && g_str_equal (qn_masonry_field_info (field).label, label)) {
      qn_masonry_set_field (masonry, QN_NO_OPENING, field, value);
      return;
    }
  g_assert_not_reached ();
}

/* Handles and numbers resize cells, whose number stays; the size of a cell as a number divides anew. */
static void
test_cells (void)
{
  g_auto (QnMasonry) grid;
  qn_masonry_init (&grid, QN_MASONRY_WALL, "g");
  qn_masonry_set_grid (&grid.wall, qn_vec2 (3, 2), qn_vec2 (12, 5));
  qn_masonry_drag (&grid, QN_NO_OPENING, QN_HANDLE_RIGHT, qn_vec2 (3, 1),
                   qn_vec2 (4.37, 1), TRUE);
  qn_masonry_drag (&grid, QN_NO_OPENING, QN_HANDLE_LEFT, qn_vec2 (0, 1), qn_vec2 (1, 1),
                   TRUE);
  set_field (&grid, "Height", 3.1);
  const QnLeaf *leaf = &grid.wall.leaves[0];
  g_assert_cmpfloat_with_epsilon (leaf->length, 3.37, 1e-12);
  g_assert_cmpfloat_with_epsilon (leaf->unit.x, 3.37 / 12, 1e-12);
  g_assert_cmpfloat_with_epsilon (leaf->unit.y, 3.1 / 5, 1e-12);
  set_field (&grid, "Block length", 0.5);
  g_assert_cmpfloat_with_epsilon (leaf->unit.x, 3.37 / 7, 1e-12);
  g_assert_cmpfloat_with_epsilon (leaf->unit.y, 3.1 / 5, 1e-12);

  g_auto (QnMasonry) cells;
  QnHandle handles[QN_HANDLE_COUNT];
  qn_masonry_init (&cells, QN_MASONRY_RUBBLE, "v");
  qn_masonry_set_voronoi (&cells.rubble, qn_vec2 (3, 2), 0.2);
  g_assert_cmpuint (qn_masonry_get_handles (&cells, QN_NO_OPENING, handles), ==, 2);
  qn_masonry_drag (&cells, QN_NO_OPENING, QN_HANDLE_RIGHT, qn_vec2 (3, 1), qn_vec2 (6, 1),
                   TRUE);
  set_field (&cells, "Height", 4);
  g_assert_cmpfloat_with_epsilon (cells.rubble.width, 6, 1e-12);
  g_assert_cmpfloat_with_epsilon (cells.rubble.top, 6, 1e-12);
  g_assert_cmpfloat_with_epsilon (cells.rubble.stone, 0.4, 1e-12);
}

static void
test_drag_objects (void)
{
  QnMasonry wall = make_wall ();
  qn_masonry_drag (&wall, QN_NO_OPENING, QN_HANDLE_RIGHT, qn_vec2 (0, 0),
                   qn_vec2 (4.73, 3.0), TRUE);
  g_assert_cmpfloat_with_epsilon (wall.wall.leaves[0].length, 3.8, 1e-12);
  qn_masonry_drag (&wall, QN_NO_OPENING, QN_HANDLE_LEFT, qn_vec2 (0, 0),
                   qn_vec2 (1.38, 3.0), TRUE);
  assert_point (wall.origin, 1.4, 2.0);
  g_assert_cmpfloat_with_epsilon (wall.wall.leaves[0].length, 3.4, 1e-12);
  qn_masonry_drag (&wall, QN_NO_OPENING, QN_HANDLE_TOP, qn_vec2 (0, 0),
                   qn_vec2 (3.0, 3.52), TRUE);
  g_assert_cmpfloat_with_epsilon (wall.wall.height, 1.6, 1e-12);
  qn_masonry_clear (&wall);

  g_auto (QnMasonry) arch;
  qn_masonry_init (&arch, QN_MASONRY_ARCH, "a");
  arch.arch = (QnArch){ .span = 2.0, .rise = 0.5, .ring = 0.2, .voussoirs = 9 };
  qn_masonry_drag (&arch, QN_NO_OPENING, QN_HANDLE_RIGHT, qn_vec2 (0, 0),
                   qn_vec2 (0.0, 4.0), TRUE);
  g_assert_cmpfloat_with_epsilon (arch.arch.span, 4.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (arch.arch.rise, 1.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (arch.rotation, G_PI_2, 1e-12);
  qn_masonry_drag (&arch, QN_NO_OPENING, QN_HANDLE_RISE, qn_vec2 (0, 0),
                   qn_vec2 (-3.0, 2.0), TRUE);
  g_assert_cmpint (arch.arch.shape, ==, QN_ARCH_POINTED);
}

/* From a listed wall to any bond, the size stays. */
static void
test_set_bond (void)
{
  g_auto (QnMasonry) wall = make_wall ();
  QnLeaf *leaf = &wall.wall.leaves[0];
  const double course[] = { 1.0, 1.0, 0.5 };
  leaf->bond = QN_BOND_CUSTOM;
  g_assert_true (qn_wall_add_course (&wall.wall.courses, course, 3));
  g_assert_true (qn_wall_add_course (&wall.wall.courses, course, 3));
  QnVec2 size = qn_masonry_wall_size (&wall);
  assert_point (size, 1.0, 0.4);
  g_assert_cmpuint (
    qn_masonry_get_handles (&wall, QN_NO_OPENING, (QnHandle[QN_HANDLE_COUNT]){ 0 }), ==,
    0);
  qn_masonry_set_bond (&wall, QN_BOND_FLEMISH, 0.5);
  assert_point (qn_masonry_wall_size (&wall), size.x, size.y);
}

QN_TESTS
{
  g_test_add_func ("/doc/masonry-shape/frame", test_frame);
  g_test_add_func ("/doc/masonry-shape/opening-box", test_opening_box);
  g_test_add_func ("/doc/masonry-shape/drag-opening", test_drag_opening);
  g_test_add_func ("/doc/masonry-shape/cells", test_cells);
  g_test_add_func ("/doc/masonry-shape/heads", test_heads);
  g_test_add_func ("/doc/masonry-shape/drag-objects", test_drag_objects);
  g_test_add_func ("/doc/masonry-shape/set-bond", test_set_bond);
}
