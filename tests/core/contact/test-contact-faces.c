#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

#define CLOSE(a, b, tolerance) g_assert_cmpfloat_with_epsilon ((a), (b), (tolerance))

static QnBlock *
add_polygon (QnModel *model, const char *name, const QnVec2 *vertices, size_t count)
{
  QnBlock *block = qn_model_add_block (model, name, vertices, count);
  g_assert_nonnull (block);
  block->thickness = 1;
  block->unit_weight = 10000;
  return block;
}

/* Two unit squares, the second one above and shifted by `shift`, all of it turned by `angle`. */
static void
detect_shifted (QnModel *model, QnContacts *contacts, double shift, double gap,
                double angle)
{
  test_model_init (model);
  test_model_add_base (model, 0, 0, 1, 1);
  test_model_add_rectangle (model, "upper", shift, 1 + gap, 1, 1);
  test_model_rotate (model, angle);
  test_detect (model, contacts);
}

/* Every angle by 15 degrees, 45 and 135 among them: full, partial and no overlap. */
static void
test_overlap_at_every_angle (void)
{
  const double shifts[] = { 0, 0.3, -0.3, 0.999, 1, -1, 1.5 };
  for (int turn = 0; turn < 24; turn++) {
    for (size_t s = 0; s < G_N_ELEMENTS (shifts); s++) {
      g_auto (QnModel) model;
      g_auto (QnContacts) contacts;
      double angle = turn * G_PI / 12;
      detect_shifted (&model, &contacts, shifts[s], 0, angle);
      double length = fmax (0, 1 - fabs (shifts[s]));
      g_assert_cmpuint (contacts.face_count, ==, length > 0 ? 1 : 0);
      if (length > 0) {
        const QnContactFace *face = &contacts.faces[0];
        CLOSE (face->length, length, 1e-12);
        CLOSE (face->normal.x, -sin (angle), 1e-12);
        CLOSE (face->normal.y, cos (angle), 1e-12);
        g_assert_cmpint (face->edge_a, ==, 2);
        g_assert_cmpint (face->edge_b, ==, 0);
      }
    }
  }
}

/* What was drawn is what is found: ends are vertices as given, to the last bit. */
static void
test_ends_are_vertices (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, 0.1, -0.175, 0.7, 0.175);
  test_model_add_rectangle (&model, "b", 0.3, 0, 0.4, 0.175);
  test_detect (&model, &contacts);
  const QnContactFace *face = &contacts.faces[0];
  g_assert_cmpfloat (face->start.x, ==,
                     0.3 + 0.4); /* the base's upper side runs leftwards */
  g_assert_cmpfloat (face->end.x, ==, 0.3);
  g_assert_cmpfloat (face->start.y, ==, 0);
  g_assert_cmpfloat (face->normal.y, ==, 1);
}

/* A T-joint: two blocks side by side on a long one, one more across both of them. */
static void
test_t_joints (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 4, 1);
  test_model_add_rectangle (&model, "left", 0.5, 0, 1.5, 1);
  test_model_add_rectangle (&model, "right", 2, 0, 1.5, 1);
  test_model_add_rectangle (&model, "top", 1, 1, 2, 1);
  test_detect (&model, &contacts);
  /* base-left, base-right, left-right, left-top, right-top */
  const QnId pairs[][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  const double lengths[] = { 1.5, 1.5, 1, 1, 1 };
  g_assert_cmpuint (contacts.face_count, ==, G_N_ELEMENTS (pairs));
  for (size_t i = 0; i < G_N_ELEMENTS (pairs); i++) {
    g_assert_cmpint (contacts.faces[i].a, ==, pairs[i][0]);
    g_assert_cmpint (contacts.faces[i].b, ==, pairs[i][1]);
    CLOSE (contacts.faces[i].length, lengths[i], 1e-15);
  }
  g_assert_cmpuint (contacts.findings.count, ==, 0);
}

/* The paper's Figure 5: seven blocks, twelve faces. */
static void
test_seven_blocks_twelve_faces (void)
{
  const double outer[] = { 1, 1 }, inner[] = { 0.5, 1, 0.5 };
  for (int turn = 0; turn < 8; turn++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    QnWall *wall = qn_model_add_wall (&model, "w");
    wall->unit = qn_vec2 (0.4, 0.175);
    wall->thickness = 1;
    g_assert_true (qn_wall_add_course (wall, outer, 2)
                   && qn_wall_add_course (wall, inner, 3)
                   && qn_wall_add_course (wall, outer, 2));
    test_model_rotate (&model, turn * G_PI / 8);
    test_detect (&model, &contacts);
    g_assert_cmpuint (model.block_count, ==, 7);
    g_assert_cmpuint (contacts.face_count, ==, 12);
  }
}

/* An upright U under a beam: two faces between the same two blocks, in order along the joint. */
static void
test_concave_two_faces (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 u[] = { { 0, 0 }, { 5, 0 }, { 5, 3 }, { 4, 3 },
                       { 4, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
  test_model_init (&model);
  add_polygon (&model, "u", u, 8);
  test_model_add_rectangle (&model, "beam", -1, 3, 7, 1);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 2);
  g_assert_cmpint (contacts.faces[0].edge_a, ==, 2);
  g_assert_cmpint (contacts.faces[1].edge_a, ==, 6);
  g_assert_cmpint (contacts.faces[0].edge_b, ==, contacts.faces[1].edge_b);
  CLOSE (contacts.faces[0].length, 1, 1e-15);
  g_assert_cmpfloat (contacts.faces[0].start.x, ==, 5);
  g_assert_cmpfloat (contacts.faces[1].end.x, ==, 0);
  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP), ==, 0);
}

/* A beam whose lower side is interrupted by a notch, on one long side: the long side's two faces
 * are sorted along it. */
static void
test_two_faces_on_one_side (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 notched[] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 3, 1 },
                             { 3, 0 }, { 6, 0 }, { 6, 2 }, { 0, 2 } };
  test_model_init (&model);
  test_model_add_base (&model, -1, -1, 8, 1);
  add_polygon (&model, "notched", notched, 8);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 2);
  CLOSE (contacts.faces[0].length, 3, 1e-15); /* the base's upper side runs leftwards */
  CLOSE (contacts.faces[1].length, 2, 1e-15);
}

/* A block in a corner: two faces at a right angle. */
static void
test_block_in_corner (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 l[] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
  test_model_init (&model);
  add_polygon (&model, "l", l, 6);
  test_model_add_rectangle (&model, "b", 1, 1, 1, 1);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 2);
  CLOSE (contacts.faces[0].normal.y, 1, 1e-15);
  CLOSE (contacts.faces[1].normal.x, 1, 1e-15);
  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_POINT_CONTACT), ==, 0);
}

/* Vertices in the middle of a joint, on either block, do not split it. */
static void
test_collinear_vertices_make_one_face (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 lower[] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 2, 1 }, { 1.5, 1 }, { 0, 1 } };
  const QnVec2 upper[] = { { 1, 1 }, { 3, 1 }, { 3, 2 }, { 0, 2 }, { 0, 1 } };
  test_model_init (&model);
  add_polygon (&model, "lower", lower, 6);
  add_polygon (&model, "upper", upper, 5);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 1);
  g_assert_cmpint (contacts.faces[0].edge_a, ==, 2);
  g_assert_cmpint (contacts.faces[0].edge_b, ==, 4);
  CLOSE (contacts.faces[0].length, 3, 1e-15);
}

/* Gaps up to the tolerance close, wider ones are named with place and width, wide ones are the
 * user's intention. The tolerance is relative: characteristic length 1 here. */
static void
test_gaps (void)
{
  for (int turn = 0; turn < 7; turn++) {
    double angle = turn * 0.9;
    QnModel model;
    QnContacts contacts;
    detect_shifted (&model, &contacts, 0.25, 0.9e-6, angle);
    g_assert_cmpuint (contacts.face_count, ==, 1);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_NEAR_MISS_GAP), ==, 0);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);

    const double widths[] = { 1.2e-6, 1e-3, 9e-3, 19e-3 };
    for (int i = 0; i < 4; i++) {
      detect_shifted (&model, &contacts, 0.25, widths[i], angle);
      g_assert_cmpuint (contacts.face_count, ==, 0);
      const QnFinding *gap = test_the_finding (&contacts, QN_PROBLEM_NEAR_MISS_GAP);
      g_assert_cmpint (gap->block_a, ==, 0);
      g_assert_cmpint (gap->block_b, ==, 1);
      CLOSE (gap->value, widths[i], 1e-12);
      QnVec2 place = qn_vec2_rotate (qn_vec2 (0.625, 1), cos (angle), sin (angle));
      g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (gap->at, place)), <, 0.01);
      qn_contacts_clear (&contacts);
      qn_model_clear (&model);
    }

    detect_shifted (&model, &contacts, 0.25, 0.021, angle);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_NEAR_MISS_GAP), ==, 0);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

/* A joint that gapes at one end is no face, and is told. */
static void
test_wedge_gap (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 tilted[] = { { 0, 1 }, { 1, 1.0005 }, { 1, 2 }, { 0, 2 } };
  test_model_init (&model);
  test_model_add_base (&model, 0, 0, 1, 1);
  add_polygon (&model, "tilted", tilted, 4);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 0);
  CLOSE (test_the_finding (&contacts, QN_PROBLEM_NEAR_MISS_GAP)->value, 5e-4, 1e-9);
}

/* A sheet of lead between two blocks is a block, not a gap. */
static void
test_filled_gap (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, 0, 0, 1, 1);
  test_model_add_rectangle (&model, "sheet", 0, 1, 1, 0.004);
  test_model_add_rectangle (&model, "upper", 0, 1.004, 1, 1);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 2);
  g_assert_cmpuint (contacts.findings.count, ==, 0);
}

/* A pebble on a slab of a kilometre, a splinter on the pebble. */
static void
test_sizes_far_apart (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, -500, -10, 1000, 10);
  test_model_add_rectangle (&model, "pebble", 3, 0, 0.1, 0.1);
  test_model_add_rectangle (&model, "splinter", 3.05, 0.1, 0.001, 0.001);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 2);
  CLOSE (contacts.faces[0].length, 0.1, 1e-12);
  CLOSE (contacts.faces[1].length, 0.001, 1e-12);
}

static void
test_thickness_is_the_smaller (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, 1, 1);
  model.blocks[0].thickness = 3;
  model.blocks[1].thickness = 0.25;
  test_detect (&model, &contacts);
  g_assert_cmpfloat (contacts.faces[0].thickness, ==, 0.25);
}

QN_TESTS
{
  g_test_add_func ("/contact-faces/overlap-at-every-angle", test_overlap_at_every_angle);
  g_test_add_func ("/contact-faces/ends-are-vertices", test_ends_are_vertices);
  g_test_add_func ("/contact-faces/t-joints", test_t_joints);
  g_test_add_func ("/contact-faces/seven-blocks-twelve-faces",
                   test_seven_blocks_twelve_faces);
  g_test_add_func ("/contact-faces/concave-two-faces", test_concave_two_faces);
  g_test_add_func ("/contact-faces/two-faces-on-one-side", test_two_faces_on_one_side);
  g_test_add_func ("/contact-faces/block-in-corner", test_block_in_corner);
  g_test_add_func ("/contact-faces/collinear-vertices",
                   test_collinear_vertices_make_one_face);
  g_test_add_func ("/contact-faces/gaps", test_gaps);
  g_test_add_func ("/contact-faces/wedge-gap", test_wedge_gap);
  g_test_add_func ("/contact-faces/filled-gap", test_filled_gap);
  g_test_add_func ("/contact-faces/sizes-far-apart", test_sizes_far_apart);
  g_test_add_func ("/contact-faces/thickness", test_thickness_is_the_smaller);
}
