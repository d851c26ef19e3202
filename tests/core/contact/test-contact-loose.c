#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static QnBlock *
add_polygon (QnModel *model, const char *name, const QnVec2 *vertices, size_t count)
{
  QnBlock *block = qn_model_add_block (model, name, vertices, count);
  block->thickness = 1;
  block->unit_weight = 10000;
  return block;
}

/* Corners of running and of stack bond, of openings and of steps touch: nothing to report. */
static void
test_ordinary_corners (void)
{
  const double running[][3] = { { 1, 1, 1 }, { 0.5, 1, 1.5 } };
  const double stack[] = { 1, 1, 1 }, step[] = { 1, 1 };
  for (int kind = 0; kind < 3; kind++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    QnWall *wall = qn_model_add_wall (&model, "w");
    wall->unit = qn_vec2 (0.4, 0.2);
    wall->thickness = 1;
    for (int course = 0; course < 4; course++)
      g_assert_true (kind == 0   ? qn_wall_add_course (wall, running[course % 2], 3)
                     : kind == 1 ? qn_wall_add_course (wall, stack, 3)
                                 : qn_wall_add_course (wall, step, course < 2 ? 2 : 1));
    test_model_add_base (&model, 0, -0.2, 1.2, 0.2);
    test_model_rotate (&model, 0.4);
    test_detect (&model, &contacts);
    g_assert_cmpuint (contacts.findings.count, ==, 0);
  }
}

/* Two piers with a gap between them, bridged by nothing: the corners of blocks that meet across
 * an empty place bear on a point. */
static void
test_corner_on_corner (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 3, 1);
  test_model_add_rectangle (&model, "low", 0, 0, 1, 1);
  test_model_add_rectangle (&model, "high", 1, 1, 1, 1);
  test_detect (&model, &contacts);
  const QnFinding *point = test_the_finding (&contacts, QN_PROBLEM_POINT_CONTACT);
  g_assert_cmpint (point->block_a, ==, 1);
  g_assert_cmpint (point->block_b, ==, 2);
  g_assert_cmpfloat (point->at.x, ==, 1);
  g_assert_cmpfloat (point->at.y, ==, 1);
  g_assert_cmpint (test_the_finding (&contacts, QN_PROBLEM_BLOCK_FLOATING)->block_a, ==,
                   2);
}

/* A corner on the middle of an edge: a leaning block, at any angle of the whole. */
static void
test_corner_on_edge (void)
{
  const QnVec2 diamond[] = { { 0, 0 }, { 1, 1 }, { 0, 2 }, { -1, 1 } };
  for (int turn = 0; turn < 9; turn++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    test_model_add_base (&model, -2, -1, 4, 1);
    add_polygon (&model, "diamond", diamond, 4);
    test_model_rotate (&model, turn * 0.7);
    test_detect (&model, &contacts);
    g_assert_cmpuint (contacts.face_count, ==, 0);
    const QnFinding *point = test_the_finding (&contacts, QN_PROBLEM_POINT_CONTACT);
    g_assert_cmpfloat (qn_vec2_length (point->at), <, 1e-12);
  }
}

/* Blocks that overlap cross each other's sides, which is no contact at a point, and they do not
 * stand alone either. */
static void
test_overlap_says_it_all (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 9, 1);
  test_model_add_rectangle (&model, "a", 0, 0, 1, 1);
  test_model_add_rectangle (&model, "b", 0.8, 0.5, 1, 0.5);
  test_model_add_rectangle (&model, "alone", 3, 3, 1, 1);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.findings.count, ==, 4);
  g_assert_cmpint (test_the_finding (&contacts, QN_PROBLEM_BLOCKS_OVERLAP)->block_b, ==,
                   2);
  g_assert_cmpint (
    test_the_finding (&contacts, QN_PROBLEM_BLOCK_WITHOUT_CONTACT)->block_a, ==, 3);
  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_FLOATING), ==, 2);
}

/* A wedge that lies on a slope by a face and touches the floor with its tip, which has a face at
 * that very place only with the slope: two blocks bear there, the floor has no face. */
static void
test_one_face_is_not_enough (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  const QnVec2 slope[] = { { 0, 0.5 }, { 2, 2.5 }, { 0, 2.5 } };
  const QnVec2 block[] = { { 0, 0.5 }, { 0.5, 0 }, { 2.5, 2 }, { 2, 2.5 } };
  test_model_init (&model);
  test_model_add_base (&model, -1, -1, 5, 1);
  add_polygon (&model, "slope", slope, 3)->support[0] = true;
  add_polygon (&model, "block", block, 4);
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.face_count, ==, 1);
  const QnFinding *point = test_the_finding (&contacts, QN_PROBLEM_POINT_CONTACT);
  g_assert_cmpint (point->block_a, ==, 0);
  g_assert_cmpint (point->block_b, ==, 2);
  g_assert_cmpfloat (point->at.x, ==, 0.5);
}

/* Every block of a part that hangs on nothing is named, and the analysis refused with the first. */
static void
test_floating_part (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag;
  test_model_init_stack (&model, 3, 1, 0.5);
  test_model_add_rectangle (&model, "loose 1", 10, 0, 1, 1);
  test_model_add_rectangle (&model, "loose 2", 10, 1, 1, 1);
  test_detect (&model, &contacts);
  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_FLOATING), ==, 2);
  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_WITHOUT_CONTACT), ==,
                    0);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_BLOCK_FLOATING);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_BLOCK);
  g_assert_cmpstr (model.blocks[diag.index].name, ==, "loose 1");
  g_assert_cmpfloat (diag.at.x, ==, 10.5);
}

/* A support in one direction is a support. */
static void
test_any_support_holds (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 2, 1, 0.5);
  model.blocks[0].support[QN_DOF_UX] = model.blocks[0].support[QN_DOF_RZ] = false;
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.findings.count, ==, 0);
}

static void
test_no_support (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag;
  test_model_init_wall (&model, 5, 0);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    model.blocks[0].support[dof] = false;
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.findings.count, ==, 1); /* not one for every block */
  g_assert_cmpint (contacts.findings.items[0].problem, ==, QN_PROBLEM_NO_SUPPORT);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_SUPPORT);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_MODEL);
}

/* A fixed block on its own is reported, and does not prevent an analysis. */
static void
test_lonely_support (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 1, 1, 1);
  test_model_add_rectangle (&model, "post", 10, 0, 1, 1)->support[QN_DOF_UY] = true;
  test_detect (&model, &contacts);
  g_assert_cmpuint (contacts.findings.count, ==, 1);
  g_assert_cmpint (
    test_the_finding (&contacts, QN_PROBLEM_BLOCK_WITHOUT_CONTACT)->block_a, ==, 2);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
}

/* A beam on a block and a second one behind it: its end is told, unless it is held, lies on a block,
 * carries a load or is controlled; and one that does not lie on the block that it moves with. */
static void
test_free_end (void)
{
  enum { NOTHING, SUPPORT, BLOCK, OFF_BLOCK, LOAD, CONTROL, CASES };
  for (int with = NOTHING; with < CASES; with++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init_stack (&model, 2, 1, 0.5);
    QnSection *section = qn_model_add_section (&model, "s");
    section->young = 10e9;
    section->width = section->height = 0.2;
    for (int i = 0; i < 3; i++) {
      const char *names[] = { "a", "b", "c" };
      test_model_add_node (&model, names[i], 0.5 + i, 0.75,
                           with == SUPPORT && i == 2 ? "y" : "");
    }
    model.nodes[0].block = 2;
    for (int i = 0; i < 2; i++) {
      QnBeam *beam = qn_model_add_beam (&model, i == 0 ? "first" : "second");
      beam->section = 0;
      beam->nodes[0] = i;
      beam->nodes[1] = i + 1;
    }
    if (with == BLOCK || with == OFF_BLOCK) {
      test_model_add_rectangle (&model, "far", with == BLOCK ? 2.5 : 3.2, 0.25, 1, 1)
        ->support[QN_DOF_UY] = true;
      model.nodes[2].block = 3;
    }
    if (with == LOAD) {
      QnLoad *load = qn_model_add_live_load (&model);
      load->kind = QN_LOAD_NODE;
      load->node = 2;
      load->vector = qn_vec2 (0, -1);
    }
    if (with == CONTROL)
      model.analysis.control.node = 2, model.analysis.control.target = 0.1;
    test_detect (&model, &contacts);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BEAM_END_FREE), ==,
                      with == NOTHING || with == OFF_BLOCK);
    if (with != NOTHING && with != OFF_BLOCK)
      continue;
    const QnFinding *end = test_the_finding (&contacts, QN_PROBLEM_BEAM_END_FREE);
    g_assert_cmpint (end->subject, ==, 1);
    g_assert_cmpfloat (end->at.x, ==, 2.5);
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
  }
}

/* A force at the edge of its block and inside is fine, one beside it is told with block and place. */
static void
test_force_beside_its_block (void)
{
  const double places[] = { 0.5, 1, 1.5 };
  for (size_t i = 0; i < G_N_ELEMENTS (places); i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init_stack (&model, 1, 1, 1);
    QnLoad *load = qn_model_add_dead_load (&model);
    load->kind = QN_LOAD_FORCE;
    load->block = 1;
    load->vector = qn_vec2 (0, -1000);
    load->has_at = true;
    load->at = qn_vec2 (places[i], 0.5);
    test_detect (&model, &contacts);
    if (places[i] <= 1) {
      g_assert_cmpuint (contacts.findings.count, ==, 0);
      continue;
    }
    const QnFinding *off = test_the_finding (&contacts, QN_PROBLEM_LOAD_OFF_BLOCK);
    g_assert_cmpint (off->block_a, ==, 1);
    g_assert_cmpfloat (off->at.x, ==, 1.5);
  }
}

/* Of two axles 2 m apart the rear one stands on a block, on the fill beside it, or beyond its end. */
static void
test_axle_beside (void)
{
  static const double ends[] = { 0, -3, -1.5 };
  static const double places[] = { 2.5, 1, 0 };
  for (size_t i = 0; i < G_N_ELEMENTS (ends); i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    test_model_add_base (&model, 0, -1, 3, 1);
    test_model_add_rectangle (&model, "block", 0, 0, 3, 1);
    QnLoad *fill = qn_model_add_dead_load (&model);
    fill->kind = QN_LOAD_FILL;
    fill->unit_weight = 18e3;
    fill->surface_count = 2;
    fill->surface[0] = qn_vec2 (ends[i], 1.5);
    fill->surface[1] = qn_vec2 (3, 1.5);
    QnVehicle *cart = qn_model_add_vehicle (&model, "cart");
    cart->axles[0] = (QnAxle){ 0, 1e4 };
    cart->axles[1] = (QnAxle){ 2, 1e4 };
    cart->axle_count = 2;
    cart->patch[0] = cart->patch[1] = 0.3;
    QnLoad *load = qn_model_add_live_load (&model);
    load->kind = QN_LOAD_VEHICLE;
    load->vehicle = 0;
    load->position = places[i];
    test_detect (&model, &contacts);
    if (i < 2) {
      g_assert_cmpuint (contacts.findings.count, ==, 0);
      continue;
    }
    g_assert_cmpint (test_the_finding (&contacts, QN_PROBLEM_LOAD_BESIDE)->subject, ==,
                     1);
    g_assert_cmpint (model.live_loads[0].beside, ==, 1);
  }
}

QN_TESTS
{
  g_test_add_func ("/contact-loose/free-end", test_free_end);
  g_test_add_func ("/contact-loose/ordinary-corners", test_ordinary_corners);
  g_test_add_func ("/contact-loose/corner-on-corner", test_corner_on_corner);
  g_test_add_func ("/contact-loose/corner-on-edge", test_corner_on_edge);
  g_test_add_func ("/contact-loose/overlap-says-it-all", test_overlap_says_it_all);
  g_test_add_func ("/contact-loose/one-face-is-not-enough", test_one_face_is_not_enough);
  g_test_add_func ("/contact-loose/floating-part", test_floating_part);
  g_test_add_func ("/contact-loose/any-support-holds", test_any_support_holds);
  g_test_add_func ("/contact-loose/no-support", test_no_support);
  g_test_add_func ("/contact-loose/lonely-support", test_lonely_support);
  g_test_add_func ("/contact-loose/force-beside-its-block", test_force_beside_its_block);
  g_test_add_func ("/contact-loose/axle-beside", test_axle_beside);
}
