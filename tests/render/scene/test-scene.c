#include "render/backend/draw-cairo.h"
#include "render/backend/output.h"
#include "render/drawing/scene.h"
#include "render/fixture.h"
#include "render/scene/reading.h"
#include "render/scene/scene-build.h"
#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>

static QnScene *
build (const Fixture *f, QnView view, QnViewOptions *options)
{
  GError *error = NULL;
  qn_view_options_init (options, view);
  QnScene *scene = qn_scene_build (&f->model, &f->contacts, &f->result, options, &error);
  g_assert_no_error (error);
  return scene;
}

static guint
count_commands (const QnScene *scene, QnLayer layer, QnPickKind pick)
{
  guint count = 0;
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    count += command->layer == layer && command->pick == pick;
  }
  return count;
}

static void
test_sorted_with_boxes (void)
{
  Fixture f;
  fixture_init_wall (&f, 4, 5);
  for (int view = 0; view < QN_VIEW_DIAGRAMS; view++) {
    QnViewOptions options;
    g_autoptr (QnScene) scene = build (&f, (QnView) view, &options);
    g_assert_cmpuint (count_commands (scene, QN_LAYER_BLOCKS, QN_PICK_BLOCK), ==,
                      f.model.block_count);
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *command = qn_scene_command (scene, i);
      if (i > 0)
        g_assert_cmpint (command->layer, >=, qn_scene_command (scene, i - 1)->layer);
      const QnVec2 *p = qn_scene_points (scene, command);
      for (uint32_t k = 0; k < command->count; k++) {
        g_assert_cmpfloat (p[k].x, >=, command->box.min.x);
        g_assert_cmpfloat (p[k].y, <=, command->box.max.y);
      }
    }
  }
  fixture_clear (&f);
}

/* A support among blocks however small is hatched so that it is seen in a picture of the whole. */
static void
test_hatch_among_small_blocks (void)
{
  Fixture f;
  QnViewOptions options;
  guint lines = 0;

  fixture_init_wall (&f, 4, 5);
  f.model.characteristic_length = 1e-3;
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_MODEL, &options);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->layer != QN_LAYER_HATCH)
      continue;
    g_assert_cmpfloat (command->extent, >, 0.005 * qn_box_diagonal (scene->box));
    lines++;
  }
  g_assert_cmpuint (lines, >, 0);
  fixture_clear (&f);
}

/* Direction of the bar of the only resultant. */
static double
bar_angle (const Fixture *f)
{
  QnViewOptions options;
  g_autoptr (QnScene) scene = build (f, QN_VIEW_FORCES, &options);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    const QnVec2 *p = qn_scene_points (scene, command);
    if (command->layer == QN_LAYER_FORCES && command->pick == QN_PICK_FACE
        && command->kind == QN_COMMAND_STROKE)
      return atan2 (p[1].y - p[0].y, p[1].x - p[0].x);
  }
  g_assert_not_reached ();
}

/* In nonlinear geometry forces turn with the frames of their joints, by half of what the one
 * block turns, and are drawn where the blocks have moved to. */
static void
test_forces_of_nonlinear_geometry (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_block (&f, 0.5, 1.5);
  double *u = f.result.displacements + 6 * (f.result.step_count - 1);
  u[3] = u[4] = 0;
  u[5] = 0.3;
  double linear = bar_angle (&f);
  f.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  g_assert_cmpfloat_with_epsilon (bar_angle (&f), linear + 0.15, 1e-9);

  g_autoptr (QnScene) scene = build (&f, QN_VIEW_FORCES, &options);
  double top = -G_MAXDOUBLE;
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->layer == QN_LAYER_BLOCKS)
      top = fmax (top, command->box.max.y);
  }
  g_assert_cmpfloat_with_epsilon (top, 0.75 + 0.75 * cos (0.3) + 0.25 * sin (0.3), 1e-9);
  fixture_clear (&f);
}

static void
test_contacts_are_all_there (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_wall (&f, 4, 5);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_CONTACTS, &options);
  guint dots = 0;
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *c = qn_scene_command (scene, i);
    dots += c->pick == QN_PICK_PAIR && c->kind == QN_COMMAND_MARKER && c->least < 3;
  }
  g_assert_cmpuint (dots, ==, f.contacts.pair_count);
  fixture_clear (&f);
}

static void
test_refusals (void)
{
  Fixture f;
  QnViewOptions options;
  GError *error = NULL;
  fixture_init_wall (&f, 3, 2);
  qn_view_options_init (&options, QN_VIEW_MECHANISM);
  g_assert_null (qn_scene_build (&f.model, &f.contacts, NULL, &options, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);

  options.view = QN_VIEW_DEFORMED;
  options.step = (int32_t) f.result.step_count;
  g_assert_null (qn_scene_build (&f.model, &f.contacts, &f.result, &options, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);

  options.view = QN_VIEW_FORCES;
  options.step = 1;
  g_assert_null (qn_scene_build (&f.model, &f.contacts, &f.result, &options, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);

  QnResult other = f.result;
  other.block_count++;
  options.step = QN_STEP_LAST;
  g_assert_null (qn_scene_build (&f.model, &f.contacts, &other, &options, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);
  fixture_clear (&f);
}

static guint
count_visible (const QnScene *scene, const QnCamera *camera)
{
  guint count = 0;
  for (guint i = 0; i < scene->commands->len; i++)
    count += qn_command_is_visible (qn_scene_command (scene, i), camera,
                                    qn_camera_visible_box (camera));
  return count;
}

/* Zoomed in, only what is near is drawn; zoomed far out, nothing too small to see. */
static void
test_culling (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_wall (&f, 40, 50);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_MODEL, &options);
  QnCamera camera = { .width = 300, .height = 200, .unit = 1, .scale = 1 };
  guint other_heads = 0; /* of the two heads of an arrow, one fits */

  qn_camera_fit (&camera, scene->box, 0);
  camera.scale = 400;
  guint near = count_visible (scene, &camera);
  g_assert_cmpuint (near, <, 60);
  g_assert_cmpuint (near, >, 8);

  camera.width = 3000;
  camera.height = 2000;
  qn_camera_fit (&camera, scene->box, 0);
  guint all = count_visible (scene, &camera);
  for (guint i = 0; i < scene->commands->len; i++)
    other_heads += !qn_command_has_size (qn_scene_command (scene, i), &camera);
  g_assert_cmpuint (all + other_heads, ==, scene->commands->len);

  camera.scale = 1;
  guint far = count_visible (scene, &camera);
  g_assert_cmpuint (far, <, all / 2);
  g_assert_cmpuint (far, >=, f.model.block_count);
  fixture_clear (&f);
}

static void
test_picking (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_wall (&f, 4, 5);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_CONTACTS, &options);
  QnCamera camera = { .width = 800, .height = 600, .unit = 1, .scale = 1 };
  qn_camera_fit (&camera, scene->box, 20);

  for (size_t i = 0; i < f.model.block_count; i++) {
    QnVec2 off = qn_vec2_add (f.model.blocks[i].centroid, qn_vec2 (0.06, 0.05));
    QnPick pick = qn_pick_at (scene, &camera, qn_camera_to_screen (&camera, off), 3,
                              1u << QN_PICK_BLOCK);
    g_assert_cmpint (pick.kind, ==, QN_PICK_BLOCK);
    g_assert_cmpint (pick.id, ==, (QnId) i);
  }
  for (size_t i = 0; i < f.contacts.face_count; i++) {
    const QnContactFace *face = &f.contacts.faces[i];
    QnVec2 at = qn_vec2_lerp (face->start, face->end, 0.3);
    QnPick pick = qn_pick_at (scene, &camera, qn_camera_to_screen (&camera, at), 3,
                              1u << QN_PICK_FACE);
    g_assert_cmpint (pick.kind, ==, QN_PICK_FACE);
    g_assert_cmpint (pick.id, ==, (QnId) i);
  }
  QnPick nothing = qn_pick_at (scene, &camera, qn_vec2 (2, 2), 3, 0);
  g_assert_cmpint (nothing.kind, ==, QN_PICK_NOTHING);

  g_autoptr (GArray) ids = g_array_new (FALSE, FALSE, sizeof (QnId));
  qn_pick_inside (scene, &camera, qn_vec2 (0, 0), qn_vec2 (800, 600), QN_PICK_BLOCK, ids);
  g_assert_cmpuint (ids->len, ==, f.model.block_count);
  g_array_set_size (ids, 0);
  qn_pick_inside (scene, &camera, qn_vec2 (0, 0), qn_vec2 (1, 1), QN_PICK_BLOCK, ids);
  g_assert_cmpuint (ids->len, ==, 0);
  fixture_clear (&f);
}

/* What pictures of a large wall leave out, command by command: joints where courses are too
 * low to be told apart, and all that is not near. */
static void
test_culling_large (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_wall (&f, 320, 313);
  g_assert_cmpuint (f.model.block_count, >=, 100000);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_MODEL, &options);
  QnCamera camera = { .width = 1600, .height = 1200, .unit = 2, .scale = 1 };

  qn_camera_fit (&camera, scene->box, 10);
  guint full = count_visible (scene, &camera);
  g_assert_cmpuint (full, >=, f.model.block_count);
  g_assert_cmpuint (scene->commands->len - full, >=, f.model.block_count);

  /* A fortieth of the width: some eight blocks abreast. */
  camera.scale *= 40;
  guint zoomed = count_visible (scene, &camera);
  g_assert_cmpuint (zoomed, >=, 100);
  g_assert_cmpuint (zoomed, <=, 600);
  fixture_clear (&f);
}

static const QnCommand *
find_command (const QnScene *scene, QnPickKind pick, QnLayer layer)
{
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->pick == pick && command->layer == layer)
      return command;
  }
  return NULL;
}

static bool
has_legend (const QnScene *scene, const char *text)
{
  bool found = false;
  for (guint i = 0; i < scene->legend->len; i++)
    found |= g_str_equal (g_array_index (scene->legend, QnLegendEntry, i).text, text);
  return found;
}

static QnScene *
build_step (const Fixture *f, QnView view, int32_t step)
{
  GError *error = NULL;
  QnViewOptions options;
  qn_view_options_init (&options, view);
  options.step = step;
  options.scale = 1;
  QnScene *scene = qn_scene_build (&f->model, &f->contacts, &f->result, &options, &error);
  g_assert_no_error (error);
  return scene;
}

/* A block has left its joint and stands with a corner on the top of the base: a dot on that corner in
 * both views, an arrow of the force in that of forces, where the base is turned by a right angle; and
 * the joint is drawn no more. At steps where the contact carries nothing there is neither. */
static void
test_found (void)
{
  Fixture f;
  fixture_init_block (&f, 0.5, 1.0);
  QnResult *r = &f.result;
  f.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  int32_t last = (int32_t) r->step_count - 1;
  const QnVec2 *v = qn_model_block_vertices (&f.model, 0);
  QnId top = 0;
  while (v[(top + 1) % f.model.blocks[0].vertex_count].x >= v[top].x)
    top++;
  QnFound found = { .contact = { .block = 0, .side = top, .other = 1, .corner = 1 } };
  QnFoundForce force = {
    .step = last, .normal = -1000, .shear = 300, .state = QN_PAIR_SLIP
  };
  g_assert_true (qn_result_add_found (r, found));
  g_assert_true (qn_result_add_found_force (r, force));
  for (int32_t step = 0; step <= last; step++)
    r->steps[step].time = step;

  size_t count;
  g_assert_true (qn_step_found (r, (size_t) last, &count)->normal == -1000);
  g_assert_cmpuint (count, ==, 1);
  qn_step_found (r, 0, &count);
  g_assert_cmpuint (count, ==, 0);

  /* On the base: down, and along its top side, which runs to the left. */
  QnVec2 on = qn_found_force (&f.model, &found.contact, &force, NULL);
  g_assert_cmpfloat_with_epsilon (on.x, -300, 1e-9);
  g_assert_cmpfloat_with_epsilon (on.y, -1000, 1e-9);
  const double turned[] = { 0, 0, G_PI / 2 };
  on = qn_found_force (&f.model, &found.contact, &force, turned);
  g_assert_cmpfloat_with_epsilon (on.x, 1000, 1e-9);
  g_assert_cmpfloat_with_epsilon (on.y, -300, 1e-9);

  const QnView views[] = { QN_VIEW_DEFORMED, QN_VIEW_FORCES };
  for (gsize i = 0; i < G_N_ELEMENTS (views); i++) {
    g_autoptr (QnScene) scene = build_step (&f, views[i], last);
    const QnCommand *dot = find_command (scene, QN_PICK_FOUND, QN_LAYER_SYMBOLS);
    g_assert_nonnull (dot);
    g_assert_cmpint (dot->id, ==, force.found);
    QnMotion motion = qn_step_motion (&f.model, r, (size_t) last);
    QnVec2 corner =
      qn_motion_place (&motion, 1, qn_found_corner (&f.model, &found.contact), 1);
    g_assert_cmpfloat_with_epsilon (qn_scene_points (scene, dot)->x, corner.x, 1e-12);
    g_assert_cmpfloat_with_epsilon (qn_scene_points (scene, dot)->y, corner.y, 1e-12);
    g_assert_true (has_legend (scene, "contact found during the motion"));
    const QnCommand *arrow = find_command (scene, QN_PICK_FOUND, QN_LAYER_FORCES);
    g_assert_cmpint (arrow != NULL, ==, views[i] == QN_VIEW_FORCES);
  }

  g_autoptr (QnScene) before = build_step (&f, QN_VIEW_DEFORMED, 0);
  g_assert_null (find_command (before, QN_PICK_FOUND, QN_LAYER_SYMBOLS));
  g_assert_false (has_legend (before, "contact found during the motion"));

  g_autoptr (QnScene) open = build_step (&f, QN_VIEW_DEFORMED, last);
  g_assert_cmpuint (count_commands (open, QN_LAYER_GAPS, QN_PICK_FACE), ==, 1);
  g_assert_true (qn_result_add_left (r, (QnLeftFace){ 0, last - 0.5 }));
  g_autoptr (QnScene) left = build_step (&f, QN_VIEW_DEFORMED, last);
  g_assert_cmpuint (count_commands (left, QN_LAYER_GAPS, QN_PICK_FACE), ==, 0);
  g_autofree bool *yet = qn_step_left (&f.contacts, r, (size_t) last - 1);
  g_assert_null (yet);
  fixture_clear (&f);
}

/* A rectangle as a block of unit thickness. */
static QnBlock *
add_rectangle (QnModel *model, const char *name, double left, double bottom, double right,
               double top)
{
  const QnVec2 corners[] = {
    { left, bottom }, { right, bottom }, { right, top }, { left, top }
  };
  QnBlock *block = qn_model_add_block (model, name, corners, 4);
  block->thickness = 1;
  block->unit_weight = 20000;
  return block;
}

/* The pressure of a backfill is told within the height that it presses, at its foot and at its head:
 * beyond stands the ground, or nothing. */
static void
test_pressure_label (void)
{
  for (int surcharge = 0; surcharge < 2; surcharge++) {
    QnModel model;
    qn_model_init (&model);
    QnLaw *law = qn_model_add_law (&model, "joint");
    law->kind = QN_LAW_COULOMB;
    law->kn = law->ks = 1e7;
    law->basis = QN_BASIS_CONTACT;
    law->friction = 0.65;
    model.contact.law = 0;
    QnBlock *ground = add_rectangle (&model, "ground", -1, -1, 2, 0);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      ground->support[dof] = true;
    add_rectangle (&model, "wall", 0, 0, 1, 3);
    QnLoad *load = qn_model_add_live_load (&model);
    load->kind = QN_LOAD_BACKFILL;
    load->side = QN_BLOCK_SIDE_LEFT;
    load->unit_weight = surcharge ? 0 : 18000;
    load->pressure = surcharge ? 9000 : 0;
    load->span[0] = 0;
    load->span[1] = 3;
    load->friction_angle = G_PI / 6;
    load->earth = QN_EARTH_ACTIVE;
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    QnViewOptions options;
    qn_view_options_init (&options, QN_VIEW_MODEL);
    options.loads = true;
    g_autoptr (QnScene) scene = qn_scene_build (&model, NULL, NULL, &options, NULL);
    guint labels = 0;
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *command = qn_scene_command (scene, i);
      if (command->text == NULL || !g_str_has_suffix (command->text, " kPa"))
        continue;
      gboolean low = qn_scene_points (scene, command)->y < 1.5;
      g_assert_true (low ? command->align_y < 0 : command->align_y > 1);
      g_assert_true (low || surcharge);
      labels++;
    }
    g_assert_cmpuint (labels, ==, 1);
    qn_model_clear (&model);
  }
}

/* An arrow has its head as long as it is drawn, one of the two, and the head is never all of it. */
static void
test_arrow_heads (void)
{
  const QnColor black = { 0, 0, 0, 255 };
  const double length = 0.1, width = 1;
  g_autoptr (QnScene) scene = qn_scene_new ();
  qn_scene_arrow (scene, QN_LAYER_LOADS, qn_vec2 (0, 0), qn_vec2 (length, 0), width,
                  black, QN_PICK_NOTHING, QN_NONE, length);
  for (double scale = 1; scale < 2000; scale *= 1.1) {
    const QnCamera camera = { .width = 100, .height = 100, .unit = 1, .scale = scale };
    double head = 0;
    guint heads = 0, shafts = 0;
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *command = qn_scene_command (scene, i);
      if (!qn_command_has_size (command, &camera))
        continue;
      shafts += command->kind == QN_COMMAND_STROKE;
      heads += command->kind != QN_COMMAND_STROKE;
      if (command->kind == QN_COMMAND_MARKER)
        head = command->size;
      if (command->kind == QN_COMMAND_FILL)
        head = scale * (command->box.max.x - command->box.min.x);
    }
    g_assert_cmpuint (heads, ==, shafts);
    g_assert_cmpuint (shafts, ==, scale * length >= 3);
    g_assert_cmpfloat (head, <=, 0.61 * scale * length);
    g_assert_cmpfloat (head, <=, 3 + 2.5 * width + 1e-6);
  }
}

/* Names of blocks stand above or beside the arrow in the middle, those of supports in it. */
static void
test_names_beside_loads (void)
{
  static const struct {
    QnVec2 load;
    float x, y;
  } cases[] = {
    { { 0, 0 }, 0.5f, 0.5f },
    { { 1, 0 }, 0.5f, -0.2f },
    { { 0.5, -0.6 }, -0.1f, 0.5f },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    Fixture f;
    QnViewOptions options;
    fixture_init_block (&f, 2, 1);
    f.model.live_load_count = 0;
    QnLoad *load = qn_model_add_live_load (&f.model);
    load->kind = QN_LOAD_WEIGHT;
    load->vector = cases[i].load;
    qn_view_options_init (&options, QN_VIEW_MODEL);
    options.loads = options.names = true;
    g_autoptr (QnScene) scene = qn_scene_build (&f.model, NULL, NULL, &options, NULL);
    guint names = 0;
    for (guint k = 0; k < scene->commands->len; k++) {
      const QnCommand *command = qn_scene_command (scene, k);
      if (command->text == NULL || command->pick != QN_PICK_BLOCK)
        continue;
      g_assert_cmpfloat (command->align_x, ==, command->id == 0 ? 0.5f : cases[i].x);
      g_assert_cmpfloat (command->align_y, ==, command->id == 0 ? 0.5f : cases[i].y);
      names++;
    }
    g_assert_cmpuint (names, ==, 2);
    fixture_clear (&f);
  }
}

/* The legend names what is drawn without words, and what shakes the ground, where an analysis in
 * time does. */
static void
test_legend (void)
{
  Fixture f;
  QnViewOptions options;
  fixture_init_block (&f, 1, 1);
  g_autoptr (QnScene) contacts = build (&f, QN_VIEW_CONTACTS, &options);
  g_assert_true (has_legend (contacts, "normal of a face"));
  QnGroundMotion *motion = qn_model_add_ground_motion (&f.model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->scale = 2;
  motion->pulse = (QnPulse){ .amplitude = 1.5, .duration = 0.25 };
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.loads = true;
  for (int shaken = 0; shaken < 2; shaken++) {
    f.model.analysis.procedure = shaken ? QN_PROCEDURE_DYNAMIC : QN_PROCEDURE_LOAD;
    g_autoptr (QnScene) scene =
      qn_scene_build (&f.model, &f.contacts, NULL, &options, NULL);
    g_assert_cmpint (has_legend (scene, "ground motion: pulse of 3 m/s²"), ==, shaken);
  }
  fixture_clear (&f);
}

/* A cross at every pair whose bond is broken at the step shown, and what it means. */
static void
test_broken_bonds (void)
{
  for (int broken = 0; broken < 2; broken++) {
    g_auto (TestRun) run;
    QnViewOptions options;
    g_autoptr (GError) error = NULL;
    guint crosses = 0;
    test_model_init_block_on_plane (&run.model, 2, 0.5);
    test_model_add_weight_loads (&run.model, 1);
    run.model.laws[0].cohesion = 1e3;
    run.model.analysis.max_multiplier = 0.1;
    test_run_solve (&run);
    run.result.pairs[1].damage = broken ? 1 : 0.9;
    qn_view_options_init (&options, QN_VIEW_DEFORMED);
    g_autoptr (QnScene) scene =
      qn_scene_build (&run.model, &run.contacts, &run.result, &options, &error);
    g_assert_no_error (error);
    g_assert_cmpint (has_legend (scene, "broken bond"), ==, broken);
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *command = &g_array_index (scene->commands, QnCommand, i);
      crosses += command->kind == QN_COMMAND_MARKER
                 && command->marker == (int) QN_MARKER_CROSS
                 && command->pick == QN_PICK_FACE;
    }
    g_assert_cmpuint (crosses, ==, broken);
  }
}

static bool
has_text (const QnScene *scene, const char *text)
{
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind == QN_COMMAND_TEXT && g_str_equal (command->text, text))
      return true;
  }
  return false;
}

/* A stack of 1 x 1.5 m is measured without the block below it; where all is held, all of it. */
static void
test_dimensions_without_supports (void)
{
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.dimensions = true;
  for (int held = 0; held < 2; held++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init_stack (&model, 3, 1, 0.5);
    for (size_t i = 0; i < model.block_count && held; i++)
      model.blocks[i].support[0] = model.blocks[i].support[1] =
        model.blocks[i].support[2] = true;
    test_detect (&model, &contacts);
    g_autoptr (QnScene) scene = qn_scene_build (&model, &contacts, NULL, &options, NULL);
    g_assert_true (has_text (scene, "1.50 m") == !held);
    g_assert_true (has_text (scene, "1.00 m") == !held);
  }
}

/* A length between whole centimetres keeps its millimetres. */
static void
test_dimensions_in_millimetres (void)
{
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_MODEL);
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_stack (&model, 3, 1.004, 0.645);
  test_detect (&model, &contacts);
  g_autoptr (QnScene) scene = qn_scene_build (&model, &contacts, NULL, &options, NULL);
  g_assert_true (has_text (scene, "1.935 m"));
  g_assert_true (has_text (scene, "1.004 m"));
}

QN_TESTS
{
  g_test_add_func ("/render/scene/dimensions-in-millimetres",
                   test_dimensions_in_millimetres);
  g_test_add_func ("/render/scene/dimensions", test_dimensions_without_supports);
  g_test_add_func ("/render/scene/sorted", test_sorted_with_boxes);
  g_test_add_func ("/render/scene/hatch", test_hatch_among_small_blocks);
  g_test_add_func ("/render/scene/contacts", test_contacts_are_all_there);
  g_test_add_func ("/render/scene/refusals", test_refusals);
  g_test_add_func ("/render/scene/culling", test_culling);
  g_test_add_func ("/render/scene/culling-large", test_culling_large);
  g_test_add_func ("/render/scene/picking", test_picking);
  g_test_add_func ("/render/scene/nonlinear-forces", test_forces_of_nonlinear_geometry);
  g_test_add_func ("/render/scene/found", test_found);
  g_test_add_func ("/render/scene/legend", test_legend);
  g_test_add_func ("/render/scene/broken-bonds", test_broken_bonds);
  g_test_add_func ("/render/scene/arrow-heads", test_arrow_heads);
  g_test_add_func ("/render/scene/names-beside-loads", test_names_beside_loads);
  g_test_add_func ("/scene/pressure-label", test_pressure_label);
}
