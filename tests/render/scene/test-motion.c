#include "render/fixture.h"
#include "render/scene/motion.h"
#include "render/scene/reading.h"
#include "render/scene/scene-build.h"
#include "support/room.h"

#include <glib.h>

static void
test_linear_rotation (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 2);
  double u[6] = { 0, 0, 0, 0.1, 0.2, 0.01 };
  QnMotion motion = { .model = &f.model, .displacements = u, .linear = true, .scale = 1 };
  QnVec2 p = qn_motion_place (&motion, 1, qn_vec2 (1, 2), 10);
  g_assert_cmpfloat_with_epsilon (p.x, 1 + 10 * 0.1 - 10 * 0.01 * 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (p.y, 2 + 10 * 0.2 + 10 * 0.01 * 0.5, 1e-12);
  fixture_clear (&f);
}

static void
test_exact_rotation_keeps_lengths (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 2);
  double u[6] = { 0, 0, 0, 0.1, 0.2, 0.5 };
  QnMotion motion = {
    .model = &f.model, .displacements = u, .linear = false, .scale = 1
  };
  QnVec2 a = qn_motion_place (&motion, 1, qn_vec2 (0, 0), 2);
  QnVec2 b = qn_motion_place (&motion, 1, qn_vec2 (1, 2), 2);
  g_assert_cmpfloat_with_epsilon (qn_vec2_length (qn_vec2_sub (b, a)), sqrt (5), 1e-12);
  fixture_clear (&f);
}

/* Without a motion all is where it is, and no model is asked. */
static void
test_at_rest (void)
{
  const QnMotion rest = { 0 };
  QnVec2 p = qn_motion_place (&rest, 7, qn_vec2 (1, 2), 10);
  g_assert_cmpfloat (p.x, ==, 1);
  g_assert_cmpfloat (p.y, ==, 2);
}

/* A block moves on from where it is: its base is turned exactly and not enlarged, and is no part of what
 * its joint does. */
static void
test_base (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 2);
  const double base[6] = { 0, 0, 0, 0.5, 0.25, G_PI_2 };
  double u[6] = { 0, 0, 0, 0.1, 0.2, 0.01 };
  const QnMotion motion = {
    .model = &f.model, .displacements = u, .base = base, .linear = true, .scale = 1
  };
  QnMotion own = motion;
  own.base = NULL;
  QnVec2 p = qn_motion_place (&motion, 1, qn_vec2 (1, 2), 10);
  g_assert_cmpfloat_with_epsilon (p.x, 0.5 + 0.5 - 1 + 10 * 0.1 - 0.1 * 0.5, 1e-12);
  g_assert_cmpfloat_with_epsilon (p.y, 1 + 0.25 + 0.5 + 10 * 0.2 - 0.1 * 1, 1e-12);
  QnJointMotion with = qn_motion_joint (&motion, &f.contacts.faces[0]);
  QnJointMotion without = qn_motion_joint (&own, &f.contacts.faces[0]);
  g_assert_cmpfloat (with.slip, ==, without.slip);
  g_assert_cmpfloat (with.opening_end, ==, without.opening_end);
  g_assert_cmpfloat (qn_motion_largest (&motion), ==, qn_motion_largest (&own));
  fixture_clear (&f);
}

/* In large displacements a mechanism begins at the last equilibrium. */
static void
test_mechanism_begins (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_block (&f, 1, 2);
  qn_view_options_init (&options, QN_VIEW_MECHANISM);
  options.step = QN_STEP_LAST;
  for (int large = 0; large < 2; large++) {
    f.model.analysis.geometry = large ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    g_autoptr (QnScene) scene =
      qn_scene_build (&f.model, &f.contacts, &f.result, &options, NULL);
    QnMotion motion = qn_scene_motion (scene, &f.model, &f.result, &options);
    const double *last =
      qn_result_step_displacements (&f.result, f.result.step_count - 1);
    g_assert_true (motion.base == (large ? last : NULL));
    g_assert_true (motion.displacements == f.result.mechanism);
  }
  fixture_clear (&f);
}

/* The block turns about its lower right corner: one hinge there, an open joint, no sliding. */
static void
test_overturning_block (void)
{
  Fixture f;
  fixture_init_block (&f, 0.5, 1.5);
  QnMotion motion = {
    .model = &f.model, .displacements = f.result.mechanism, .linear = true, .scale = 1
  };
  g_autofree QnJointMotion *joints = qn_motion_joints (&motion, &f.contacts, NULL);
  const QnContactFace *face = &f.contacts.faces[0];
  bool start_is_right = face->start.x > 0.25;
  g_assert_cmpint (joints->kind, ==,
                   start_is_right ? QN_JOINT_HINGE_START : QN_JOINT_HINGE_END);
  g_assert_false (joints->slides);
  double lifted = fmax (joints->opening_start, joints->opening_end);
  g_assert_cmpfloat_with_epsilon (lifted, 0.2 * 0.5, 1e-12);

  fixture_clear (&f);
}

/* What the analysis says of the pairs counts where it is to be seen. */
static void
test_small_motion_is_not_shown (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 1);
  QnPairResult pairs[2] = { { .state = QN_PAIR_SLIP }, { .state = QN_PAIR_OPEN } };
  for (int seen = 0; seen < 2; seen++) {
    /* The base moves along, all but a little. */
    double along = seen ? 0.9 : 0.99;
    double u[6] = { along, along, 0, 1, 1, 0 };
    QnMotion motion = {
      .model = &f.model, .displacements = u, .linear = true, .scale = 1
    };
    g_autofree QnJointMotion *joints = qn_motion_joints (&motion, &f.contacts, pairs);
    g_assert_cmpint (joints->slides, ==, seen);
    g_assert_cmpint (joints->kind, ==, seen ? QN_JOINT_HINGE_START : QN_JOINT_CLOSED);
  }
  fixture_clear (&f);
}

static void
test_sliding_block (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 1);
  double u[6] = { 0, 0, 0, 1, 0, 0 };
  QnMotion motion = { .model = &f.model, .displacements = u, .linear = true, .scale = 1 };
  g_autofree QnJointMotion *joints = qn_motion_joints (&motion, &f.contacts, NULL);
  g_assert_true (joints->slides);
  g_assert_cmpfloat_with_epsilon (joints->slip * f.contacts.faces[0].tangent.x, 1, 1e-12);
  fixture_clear (&f);
}

static QnJointMotion *
mechanism_joints (const Fixture *f, QnMechanismKind *kind)
{
  QnMechanism mechanism;
  g_assert_cmpint (
    qn_mechanism_of_result (&mechanism, &f->model, &f->contacts, &f->result, NULL), ==,
    QN_OK);
  QnJointMotion *joints = g_steal_pointer (&mechanism.joints);
  *kind = mechanism.kind;
  qn_mechanism_clear (&mechanism);
  return joints;
}

/* The core names the mechanism; sliding with dilatancy opens nothing. */
static void
test_mechanism_joints (void)
{
  Fixture f;
  QnMechanismKind kind;
  fixture_init_block (&f, 0.5, 1.5);
  g_autofree QnJointMotion *joints = mechanism_joints (&f, &kind);
  g_assert_cmpint (kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  bool start_is_right = f.contacts.faces[0].start.x > 0.25;
  g_assert_cmpint (joints->kind, ==,
                   start_is_right ? QN_JOINT_HINGE_START : QN_JOINT_HINGE_END);

  double slide[6] = { 0, 0, 0, 1, 0.65, 0 };
  double *own = f.result.mechanism;
  f.result.mechanism = slide;
  f.result.limit = (QnLimitFigures){ .given = true, .flow = QN_FLOW_ASSOCIATIVE };
  g_autofree QnJointMotion *other = mechanism_joints (&f, &kind);
  g_assert_cmpint (kind, ==, QN_MECHANISM_KIND_SLIDING);
  g_assert_cmpint (other->kind, ==, QN_JOINT_SLIDING);
  /* A path whose joints do not dilate has lost this contact. */
  f.result.limit.given = false;
  g_autofree QnJointMotion *parted = mechanism_joints (&f, &kind);
  g_assert_cmpint (parted->kind, ==, QN_JOINT_OPENING);
  g_assert_false (parted->slides);
  f.result.mechanism = own;
  fixture_clear (&f);
}

/* Displacements that are large are never drawn smaller than they are. */
static void
test_true_scale (void)
{
  Fixture f;
  fixture_init_block (&f, 0.5, 1.5);
  double *u = f.result.displacements + (f.result.step_count - 1) * 6 + 3;
  u[0] = 2;
  u[1] = u[2] = 0;
  f.model.analysis.geometry = QN_GEOMETRY_LINEAR;
  g_assert_cmpfloat (qn_motion_result_scale (&f.model, &f.result), <, 1);
  f.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  g_assert_cmpfloat (qn_motion_result_scale (&f.model, &f.result), ==, 1);
  f.model.analysis.geometry = QN_GEOMETRY_LINEAR;
  f.result.history.width = 1;
  g_assert_cmpfloat (qn_motion_result_scale (&f.model, &f.result), ==, 1);
  f.result.history.width = 0;
  fixture_clear (&f);
}

/* A small block that turns beside a large structure is seen to move: by a fortieth of the whole, or by 0.6 rad. */
static void
test_small_block (void)
{
  Fixture f;
  double u[6] = { 0, 0, 0, 0, 0, 1 };
  fixture_init_block (&f, 0.5, 0.5);
  QnMotion motion = { .model = &f.model, .displacements = u, .linear = true, .scale = 1 };
  g_assert_cmpfloat_with_epsilon (qn_motion_auto_scale (&motion), 0.25, 0.01);
  double width = 20 * 0.5; /* of the ground */
  for (QnId i = 0; i < 4; i++) {
    QnVec2 *v = &f.model.vertices[f.model.blocks[0].first_vertex + i];
    v->x = v->x > 0 ? width : -width;
  }
  g_assert_cmpfloat_with_epsilon (qn_motion_auto_scale (&motion), 0.6, 0.01);
  fixture_clear (&f);
}

static void
test_auto_scale (void)
{
  Fixture f;
  fixture_init_wall (&f, 5, 11);
  QnMotion motion = { .model = &f.model, .linear = true, .scale = 1 };
  g_assert_cmpfloat (qn_motion_auto_scale (&motion), ==, 1);
  motion.displacements = f.result.mechanism;
  double first = qn_motion_auto_scale (&motion);
  motion.displacements =
    qn_result_step_displacements (&f.result, f.result.step_count - 1);
  double second = qn_motion_auto_scale (&motion);
  g_assert_cmpfloat (second / first, >, 900);
  g_assert_cmpfloat (second / first, <, 1100);
  double diagonal = hypot (2, 12 * 0.175);
  g_assert_cmpfloat (second * qn_motion_largest (&motion), <=, diagonal / 12);
  g_assert_cmpfloat (second * qn_motion_largest (&motion), >, 0.9 * diagonal / 12);
  fixture_clear (&f);
}

/* All steps of a result are drawn with one factor, that of the step that went farthest. */
static void
test_one_scale_for_all_steps (void)
{
  Fixture f;
  fixture_init_wall (&f, 5, 11);
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_DEFORMED);
  double chosen = qn_motion_result_scale (&f.model, &f.result);
  for (int step = 0; step < (int) f.result.step_count; step++) {
    options.step = step;
    g_autoptr (QnScene) scene =
      qn_scene_build (&f.model, &f.contacts, &f.result, &options, NULL);
    g_assert_cmpfloat (scene->scale, ==, chosen);
  }
  size_t rows = qn_result_body_count (&f.result) * QN_DOF_COUNT;
  double *second = f.result.displacements + rows;
  for (size_t i = 0; i < rows; i++)
    second[i] = 4 * f.result.displacements[3 * rows + i];
  double wider = qn_motion_result_scale (&f.model, &f.result);
  g_assert_cmpfloat (wider, <, 0.3 * chosen);
  fixture_clear (&f);
}

/* Where no caption tells the factor, the legend does. */
static void
test_scale_in_legend (void)
{
  Fixture f;
  fixture_init_wall (&f, 5, 11);
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_DEFORMED);
  const struct {
    double scale;
    bool titles;
    const char *text;
  } cases[] = { { 25, false, "displacements × 25" },
                { 1, false, "displacements in true scale" },
                { 25, true, NULL } };
  for (gsize c = 0; c < G_N_ELEMENTS (cases); c++) {
    options.scale = cases[c].scale;
    options.titles = cases[c].titles;
    g_autoptr (QnScene) scene =
      qn_scene_build (&f.model, &f.contacts, &f.result, &options, NULL);
    const char *told = NULL;
    for (guint i = 0; i < scene->legend->len; i++) {
      const QnLegendEntry *entry = &g_array_index (scene->legend, QnLegendEntry, i);
      if (g_str_has_prefix (entry->text, "displacements"))
        told = entry->text;
    }
    g_assert_cmpstr (told, ==, cases[c].text);
  }
  fixture_clear (&f);
}

/* Three bed joints on one line, of which two have opened, one of them turned round, and one above them: the mean
 * of the line is over all of its 4 m. */
static void
test_crack_lines (void)
{
  QnContactFace faces[] = {
    { .start = { 0, 1 }, .tangent = { 1, 0 }, .normal = { 0, -1 }, .length = 1 },
    { .start = { 3, 1 }, .tangent = { -1, 0 }, .normal = { 0, 1 }, .length = 2 },
    { .start = { 5, 1 }, .tangent = { 1, 0 }, .normal = { 0, -1 }, .length = 1 },
    { .start = { 0, 1.001 }, .tangent = { 1, 0 }, .normal = { 0, -1 }, .length = 1 },
  };
  const QnContacts contacts = { .faces = faces, .face_count = G_N_ELEMENTS (faces) };
  const QnCrack opened[] = { { &faces[1], 5e-3, 4e-3, { 2, 1 } },
                             { &faces[3], 3e-3, 1e-3, { 0, 1.001 } },
                             { &faces[0], 2e-3, 2e-3, { 0, 1 } } };
  g_autoptr (GArray) cracks = g_array_new (FALSE, FALSE, sizeof (QnCrack));
  g_array_append_vals (cracks, opened, G_N_ELEMENTS (opened));
  guint lines[G_N_ELEMENTS (opened)];
  g_autoptr (GArray) found = qn_cracks_by_line (&contacts, cracks, lines);
  const QnCrack *first = &g_array_index (found, QnCrack, 0);
  g_assert_cmpuint (found->len, ==, 2);
  g_assert_true (first->face == &faces[1]);
  g_assert_cmpfloat (first->width, ==, 5e-3);
  g_assert_cmpfloat_with_epsilon (first->mean, (4e-3 * 2 + 2e-3 * 1) / 4, 1e-15);
  g_assert_cmpfloat_with_epsilon (first[1].mean, 1e-3, 1e-15);
  g_assert_cmpuint (lines[0], ==, 0);
  g_assert_cmpuint (lines[1], ==, 1);
  g_assert_cmpuint (lines[2], ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/render/motion/crack-lines", test_crack_lines);
  g_test_add_func ("/render/motion/at-rest", test_at_rest);
  g_test_add_func ("/render/motion/base", test_base);
  g_test_add_func ("/render/motion/mechanism-begins", test_mechanism_begins);
  g_test_add_func ("/render/motion/linear", test_linear_rotation);
  g_test_add_func ("/render/motion/exact", test_exact_rotation_keeps_lengths);
  g_test_add_func ("/render/motion/overturning", test_overturning_block);
  g_test_add_func ("/render/motion/sliding", test_sliding_block);
  g_test_add_func ("/render/motion/mechanism", test_mechanism_joints);
  g_test_add_func ("/render/motion/true-scale", test_true_scale);
  g_test_add_func ("/render/motion/small-block", test_small_block);
  g_test_add_func ("/render/motion/auto-scale", test_auto_scale);
  g_test_add_func ("/render/motion/one-scale", test_one_scale_for_all_steps);
  g_test_add_func ("/render/motion/scale-in-legend", test_scale_in_legend);
  g_test_add_func ("/render/motion/small", test_small_motion_is_not_shown);
}
