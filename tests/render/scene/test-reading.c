#include "core/path/analysis.h"
#include "io/project/project.h"
#include "render/fixture.h"
#include "render/scene/reading.h"
#include "render/scene/scene-build.h"
#include "render/scene/thrust.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <string.h>

/* An example with its solution. */
typedef struct Solved {
  QnProject project;
  const QnModel *model;
  QnContacts contacts;
  QnResult result;
  size_t step; /* the last one */
} Solved;

static void
solve (Solved *s, const char *name)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *path = g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
  g_assert_true (qn_project_load (path, NULL, &s->project, &error));
  g_assert_no_error (error);
  s->model = &s->project.model;
  g_assert_cmpint (qn_contacts_detect (s->model, &s->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (s->model, &s->contacts, NULL, NULL, &s->result, NULL),
                   ==, QN_OK);
  g_assert_cmpuint (s->result.step_count, >, 0);
  s->step = s->result.step_count - 1;
}

static void
clear (Solved *s)
{
  qn_result_clear (&s->result);
  qn_contacts_clear (&s->contacts);
  qn_project_clear (&s->project);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Solved, clear)

/* Loads on every block at the last step: fx, fy, m. The caller frees them. */
static double *
dup_loads (const Solved *s)
{
  size_t count = 3 * s->model->block_count;
  double *loads = g_new0 (double, count);
  g_autofree double *live = g_new0 (double, count);
  qn_model_set_forces (s->model, NULL, loads);
  qn_model_live_forces (s->model, live);
  for (size_t i = 0; i < count; i++)
    loads[i] += s->result.steps[s->step].multiplier * live[i];
  return loads;
}

static double
heaviest (const QnModel *model)
{
  double weight = 0;
  for (size_t i = 0; i < model->block_count; i++)
    weight = fmax (weight, model->blocks[i].weight);
  return weight;
}

static const char *const examples[] = { "06-arch.quoin", "15-rubble-pier.quoin",
                                        "18-spreading-arch.quoin",
                                        "ferris-tin-loi/wall3.quoin" };

/* What the joints of a block carry holds its loads, by force and moment: N, T, the moment about
 * the middle and the eccentricity of every joint are those of the solution. */
static void
test_equilibrium (void)
{
  for (size_t e = 0; e < G_N_ELEMENTS (examples); e++) {
    Solved s;
    solve (&s, examples[e]);
    g_autofree QnPairResult *pairs = qn_step_pairs (&s.contacts, &s.result, s.step);
    g_assert_nonnull (pairs);
    g_autofree double *sums = dup_loads (&s);
    g_autofree double *by_place = dup_loads (&s);
    for (size_t f = 0; f < s.contacts.face_count; f++) {
      const QnContactFace *face = &s.contacts.faces[f];
      QnJointReading r = qn_joint_reading (&s.contacts, (QnId) f, pairs);
      QnVec2 force = qn_vec2_add (qn_vec2_scale (r.normal, face->normal),
                                  qn_vec2_scale (r.shear, face->tangent));
      QnVec2 middle = qn_vec2_lerp (face->start, face->end, 0.5);
      for (int side = 0; side < 2; side++) {
        QnId block = side == 0 ? face->a : face->b;
        double sign = side == 0 ? 1 : -1;
        QnVec2 arm = qn_vec2_sub (middle, s.model->blocks[block].centroid);
        QnVec2 place = qn_vec2_add_scaled (arm, r.eccentricity, face->tangent);
        sums[3 * block] += sign * force.x;
        sums[3 * block + 1] += sign * force.y;
        sums[3 * block + 2] += sign * (qn_vec2_cross (arm, force) + r.moment);
        by_place[3 * block + 2] += sign * qn_vec2_cross (place, force);
      }
      if (r.place != QN_PLACE_NOWHERE)
        g_assert_cmpfloat_with_epsilon (r.moment, -r.normal * r.eccentricity,
                                        1e-9 * fabs (r.normal) * face->length);
    }
    double least = 1e-6 * heaviest (s.model);
    for (size_t i = 0; i < s.model->block_count; i++)
      for (int dof = 0; dof < 3; dof++) {
        if (s.model->blocks[i].support[dof])
          continue;
        g_assert_cmpfloat (fabs (sums[3 * i + (size_t) dof]), <, least);
        if (dof == QN_DOF_RZ)
          g_assert_cmpfloat (fabs (by_place[3 * i + 2]), <, least);
      }
    clear (&s);
  }
}

/* A block says of its joints what they say themselves, alone or with all others; its mean stress
 * times its volume is what its loads and joints do at a homogeneous strain. */
static void
test_blocks (void)
{
  Solved s;
  solve (&s, "ferris-tin-loi/wall3.quoin");
  g_autofree QnPairResult *pairs = qn_step_pairs (&s.contacts, &s.result, s.step);
  g_autofree QnBlockReading *all =
    qn_block_readings (s.model, &s.contacts, pairs, NULL, 0, NULL);
  g_autofree double *loads = dup_loads (&s);
  double least = 1e-6 * heaviest (s.model);
  for (size_t i = 0; i < s.model->block_count; i++) {
    QnBlockReading one = all[i];
    g_assert_cmpfloat (one.principal[0], <=, one.principal[1]);
    if (s.model->blocks[i].support[QN_DOF_UX])
      continue;
    g_assert_cmpfloat (fabs (one.force.x + loads[3 * i]), <, least);
    g_assert_cmpfloat (fabs (one.force.y + loads[3 * i + 1]), <, least);
    g_assert_cmpfloat (fabs (one.moment + loads[3 * i + 2]), <, least);
  }
  clear (&s);
}

/* A state of stress in the axes of a wall, Pa and Pa/m. */
typedef struct State {
  double middle[3];  /* xx, yy, xy at the origin */
  double bending[2]; /* of xx per y, of yy per x */
} State;

enum { CELLS = 3 };
#define TURNED 0.3 /* rad */

/* The traction on a free edge of a cell, as forces at its two Gauss points: its middle and its outward
 * normal, in the axes of the wall. */
static void
add_traction (QnModel *model, const State *state, QnId block, QnVec2 middle,
              QnVec2 normal, double length)
{
  const double c = cos (TURNED), s = sin (TURNED), area = length * 0.2 / 2;
  for (int side = -1; side <= 1; side += 2) {
    const QnVec2 at =
      qn_vec2_add_scaled (middle, side * length / sqrt (12), qn_vec2_perp (normal));
    const double xx = state->middle[0] + state->bending[0] * at.y, xy = state->middle[2];
    const double yy = state->middle[1] + state->bending[1] * at.x;
    const QnVec2 force = { area * (xx * normal.x + xy * normal.y),
                           area * (xy * normal.x + yy * normal.y) };
    QnLoad *load = normal.x + normal.y > 0 ? qn_model_add_dead_load (model)
                                           : qn_model_add_live_load (model);
    load->kind = QN_LOAD_FORCE;
    load->block = block;
    load->vector = qn_vec2_rotate (force, c, s);
    load->has_at = true;
    load->at = qn_vec2_rotate (at, c, s);
  }
}

/* Nine cells, turned, in this state. */
static void
init_cells (QnModel *model, const State *state)
{
  const double c = cos (TURNED), s = sin (TURNED), size[2] = { 0.4, 0.25 };
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "grid");
  law->kind = QN_LAW_ELASTIC;
  law->basis = QN_BASIS_MATERIAL;
  law->kn = law->ks = 30e9;
  model->contact.law = 0;
  for (int i = 0; i < CELLS * CELLS; i++) {
    const int cell[2] = { i % CELLS, i / CELLS };
    const QnVec2 middle = { (cell[0] - 1) * size[0], (cell[1] - 1) * size[1] };
    const double x = size[0] / 2, y = size[1] / 2;
    QnVec2 corners[] = { { -x, -y }, { x, -y }, { x, y }, { -x, y } };
    for (int k = 0; k < 4; k++)
      corners[k] = qn_vec2_rotate (qn_vec2_add (middle, corners[k]), c, s);
    g_autofree char *name = g_strdup_printf ("c%d", i);
    QnBlock *block = qn_model_add_block (model, name, corners, 4);
    block->thickness = 0.2;
    for (int dof = 0; dof < 3; dof++)
      block->support[dof] = i == CELLS * CELLS / 2;
    for (int e = 0; e < 4; e++) {
      const int axis = e / 2, sign = e % 2 == 0 ? -1 : 1;
      const QnVec2 normal = axis == 0 ? qn_vec2 (sign, 0) : qn_vec2 (0, sign);
      if (cell[axis] == (sign < 0 ? 0 : CELLS - 1))
        add_traction (model, state, i,
                      qn_vec2_add_scaled (middle, size[axis] / 2, normal), normal,
                      size[1 - axis]);
    }
  }
  model->analysis.increments = 1;
  model->analysis.max_multiplier = 1;
}

/* The mean stress of each cell is that of the continuum at its centroid: of uniform states and of bending
 * about either axis, at the edges too, where the loads are part of it. */
static void
test_stresses (void)
{
  static const State states[] = {
    { { -2e6, 0, 0 }, { 0, 0 } },   { { 1e6, -3e6, 0 }, { 0, 0 } },
    { { 0, 0, 1.5e6 }, { 0, 0 } },  { { 0, 0, 0 }, { 0, 4e6 } },
    { { 0, 0, 0 }, { -4e6, 1e6 } }, { { 1e6, -2e6, 3e6 }, { 2e6, 2e6 } },
  };
  const double c = cos (TURNED), s = sin (TURNED);
  for (size_t k = 0; k < G_N_ELEMENTS (states); k++) {
    g_auto (TestRun) run = { 0 };
    const State *state = &states[k];
    init_cells (&run.model, state);
    test_run_solve (&run);
    const size_t last = run.result.step_count - 1;
    double factors[QN_MAX_LOAD_SETS];
    qn_result_load_factors (&run.model, &run.result, last, factors);
    g_autofree QnPairResult *pairs = qn_step_pairs (&run.contacts, &run.result, last);
    g_autofree QnBlockReading *all =
      qn_block_readings (&run.model, &run.contacts, pairs, NULL, 0, factors);
    for (size_t i = 0; i < run.model.block_count; i++) {
      const QnBlockReading one = all[i];
      const QnVec2 at = qn_vec2_rotate (run.model.blocks[i].centroid, c, -s);
      const double xx = state->middle[0] + state->bending[0] * at.y;
      const double yy = state->middle[1] + state->bending[1] * at.x;
      const double xy = state->middle[2];
      const double expected[] = { c * c * xx + s * s * yy - 2 * c * s * xy,
                                  s * s * xx + c * c * yy + 2 * c * s * xy,
                                  c * s * (xx - yy) + (c * c - s * s) * xy };
      for (int j = 0; j < 3; j++)
        g_assert_cmpfloat_with_epsilon (one.stress[j], expected[j], 1e-3);
    }
  }
}

/* A block of 1 x 1 m under its weight W in the middle of one with twice the width: e = 0, the
 * whole joint pressed; with a load at its side the force moves there. */
static void
test_places (void)
{
  Fixture f;
  fixture_init_block (&f, 1, 1);
  const QnContactFace *face = &f.contacts.faces[0];
  QnPairResult pairs[2] = { 0 };
  const struct {
    double first, last;
    QnPressurePlace place;
    double eccentricity; /* over the length */
  } cases[] = {
    { -1, -1, QN_PLACE_KERN, 0 },      { -3, -2, QN_PLACE_KERN, -0.1 },
    { -1, -3, QN_PLACE_INSIDE, 0.25 }, { 0, -1, QN_PLACE_EDGE, 0.5 },
    { 1, -3, QN_PLACE_OUTSIDE, 1 },    { 1, -1, QN_PLACE_NOWHERE, 0 },
    { 1, 1, QN_PLACE_NOWHERE, 0 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    pairs[0].normal_force = cases[i].first;
    pairs[1].normal_force = cases[i].last;
    QnJointReading r = qn_joint_reading (&f.contacts, 0, pairs);
    double spread =
      f.contacts.pairs[1].abscissa - f.contacts.pairs[0].abscissa; /* pairs at the ends */
    g_assert_cmpfloat_with_epsilon (spread, face->length, 1e-12);
    g_assert_cmpint (r.place, ==, cases[i].place);
    g_assert_cmpfloat_with_epsilon (r.eccentricity, cases[i].eccentricity * face->length,
                                    1e-12);
  }
  fixture_clear (&f);
}

/* Along the arch the line goes from springing to springing, through every joint. */
static void
test_thrust_of_arch (void)
{
  g_auto (Solved) s;
  QnThrust thrust;
  solve (&s, "06-arch.quoin");
  g_autofree QnPairResult *pairs = qn_step_pairs (&s.contacts, &s.result, s.step);
  qn_thrust_find (&thrust, s.model, &s.contacts, pairs, NULL, 0);
  g_assert_cmpuint (thrust.count, ==, s.contacts.face_count);
  int ends = 0;
  for (size_t c = 0; c < thrust.count; c++)
    for (int side = 0; side < 2; side++)
      ends += thrust.cuts[c].next[side] == QN_NONE;
  g_assert_cmpint (ends, ==, 2);
  qn_thrust_clear (&thrust);
}

/* In bending alone, or where bars pull, the force acts outside the joint: no line leads there. */
static void
test_thrust_needs_pressure (void)
{
  static const char *const bent[] = { "07-cantilever.quoin",
                                      "09-reinforced-cantilever.quoin",
                                      "34-frame-hybrid.quoin" };
  for (size_t e = 0; e < G_N_ELEMENTS (bent); e++) {
    g_auto (Solved) s;
    QnThrust thrust;
    solve (&s, bent[e]);
    g_autofree QnPairResult *pairs = qn_step_pairs (&s.contacts, &s.result, s.step);
    qn_thrust_find (&thrust, s.model, &s.contacts, pairs, NULL, 0);
    g_assert_cmpuint (thrust.count, >, 0);
    for (size_t c = 0; c < thrust.count; c++)
      for (int side = 0; side < 2; side++)
        g_assert_cmpint (thrust.cuts[c].next[side], ==, QN_NONE);
    qn_thrust_clear (&thrust);
  }
}

/* Numbers stand in the corner between joint and line of thrust, and where joints are too near for
 * all of them, every second or fourth has its own. */
static void
test_thrust_numbers (void)
{
  g_auto (Solved) s;
  QnViewOptions options;
  solve (&s, "28-arch-under-fill.quoin");
  qn_view_options_init (&options, QN_VIEW_FORCES);
  g_autoptr (QnScene) scene =
    qn_scene_build (s.model, &s.contacts, &s.result, &options, NULL);
  g_assert_nonnull (scene);
  float least = G_MAXFLOAT, most = 0;
  int numbers = 0, raised = 0;
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind != QN_COMMAND_TEXT)
      continue;
    g_autofree char *digits =
      g_strndup (command->text, strspn (command->text, "0123456789."));
    g_assert_cmpuint (strlen (digits), ==, strchr (digits, '.') != NULL ? 4 : 3);
    raised += command->align_y < 0.25F || command->align_y > 0.75F;
    least = MIN (least, command->extent);
    most = MAX (most, command->extent);
    numbers++;
  }
  g_assert_cmpint (numbers, ==, 26);
  g_assert_cmpint (raised, >=, 6); /* about the crown, where the line is level */
  g_assert_cmpfloat (most, >, 15 * least);
}

/* Between neighbours of the line the forces and the loads on the blocks there are in equilibrium:
 * for a pier of several blocks a course as well. */
static void
test_thrust_balances (void)
{
  for (size_t e = 0; e < G_N_ELEMENTS (examples); e++) {
    Solved s;
    QnThrust thrust;
    solve (&s, examples[e]);
    g_autofree QnPairResult *pairs = qn_step_pairs (&s.contacts, &s.result, s.step);
    g_autofree double *loads = dup_loads (&s);
    qn_thrust_find (&thrust, s.model, &s.contacts, pairs, NULL, 0);
    size_t links = 0;
    for (size_t c = 0; c < thrust.count; c++) {
      const QnCut *cut = &thrust.cuts[c];
      for (int side = 0; side < 2; side++) {
        if (cut->next[side] == QN_NONE)
          continue;
        const QnCut *next = &thrust.cuts[cut->next[side]];
        int back = next->next[0] == (QnId) c ? 0 : 1;
        /* On the blocks between: of the cut from its other side, of the next one likewise. */
        QnVec2 here = qn_vec2_scale (side == 0 ? 1 : -1, cut->force);
        QnVec2 there = qn_vec2_scale (back == 0 ? 1 : -1, next->force);
        QnVec2 sum = qn_vec2_add (here, there);
        g_autofree bool *between = g_new0 (bool, s.model->block_count);
        for (size_t f = 0; f < s.contacts.face_count; f++) {
          const QnContactFace *face = &s.contacts.faces[f];
          QnVec2 along = qn_vec2_perp (cut->normal);
          QnVec2 off = qn_vec2_sub (face->start, cut->start);
          bool on_line = fabs (qn_vec2_dot (off, cut->normal)) < 1e-9
                         && fabs (qn_vec2_dot (face->normal, along)) < 1e-9
                         && qn_vec2_dot (off, along) > -1e-9
                         && qn_vec2_dot (off, along) < cut->length + 1e-9;
          bool aligned = qn_vec2_dot (face->normal, cut->normal) > 0;
          if (on_line)
            between[aligned == (side == 0) ? face->a : face->b] = true;
        }
        for (size_t i = 0; i < s.model->block_count; i++)
          if (between[i])
            sum = qn_vec2_add (sum, qn_vec2 (loads[3 * i], loads[3 * i + 1]));
        /* What is below the least share does not count as a force there. */
        g_assert_cmpfloat (qn_vec2_length (sum), <,
                           QN_THRUST_LEAST_SHARE * thrust.largest * 2);
        links++;
      }
    }
    if (g_str_has_suffix (examples[e], "wall3.quoin"))
      g_assert_cmpuint (links, >=, 20);
    qn_thrust_clear (&thrust);
    clear (&s);
  }
}

/* A contact that was found on the way pushes both blocks at one place with opposite forces, however
 * they have turned since; blocks, stresses and the line of thrust know it. */
static void
test_touch (void)
{
  Fixture f;
  fixture_init_block (&f, 0.5, 1.0);
  QnResult *r = &f.result;
  size_t step = r->step_count - 1, count;
  double *u = r->displacements + step * f.model.block_count * QN_DOF_COUNT;
  const double moved[] = { 0.03, -0.02, 0.4, 0.11, 0.07, -1.1 };
  memcpy (u, moved, sizeof moved);
  const QnFound found = { .contact = { .block = 0, .side = 1, .other = 1, .corner = 2 } };
  const QnFoundForce force = { .step = (int32_t) step, .normal = -1000, .shear = 300 };
  g_assert_true (qn_result_add_found (r, found));
  g_assert_true (qn_result_add_found_force (r, force));
  g_autofree QnTouch *touches = qn_step_touches (&f.model, r, step, &count);
  g_assert_cmpuint (count, ==, 1);

  QnMotion motion = { .model = &f.model, .displacements = u, .scale = 1 };
  QnVec2 here = qn_motion_place (&motion, 0, touches->at[0], 1);
  QnVec2 there = qn_motion_place (&motion, 1, touches->at[1], 1);
  g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (here, there)), <, 1e-12);
  QnVec2 a = qn_vec2_rotate (touches->on[0], cos (u[2]), sin (u[2]));
  QnVec2 b = qn_vec2_rotate (touches->on[1], cos (u[5]), sin (u[5]));
  g_assert_cmpfloat (qn_vec2_length (qn_vec2_add (a, b)), <, 1e-9);
  g_assert_cmpfloat_with_epsilon (qn_vec2_length (a), hypot (1000, 300), 1e-9);
  QnVec2 same = qn_found_force (&f.model, &found.contact, &force, u);
  g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (a, same)), <, 1e-9);

  g_autofree QnPairResult *none = g_new0 (QnPairResult, f.contacts.pair_count);
  g_autofree QnBlockReading *all =
    qn_block_readings (&f.model, &f.contacts, none, touches, count, NULL);
  for (int i = 0; i < 2; i++) {
    QnBlockReading one = all[i];
    g_assert_cmpfloat_with_epsilon (one.force.x, touches->on[i].x, 1e-9);
    g_assert_cmpfloat_with_epsilon (one.force.y, touches->on[i].y, 1e-9);
    double volume = f.model.blocks[i].area * f.model.blocks[i].thickness;
    QnVec2 arm = qn_vec2_sub (touches->at[i], f.model.blocks[i].centroid);
    g_assert_cmpfloat_with_epsilon (one.stress[0] * volume, touches->on[i].x * arm.x,
                                    1e-9);
  }

  QnThrust thrust;
  qn_thrust_find (&thrust, &f.model, &f.contacts, none, touches, count);
  const QnCut *cut = &thrust.cuts[thrust.cut_of[f.contacts.face_count]];
  g_assert_cmpint (cut->face, ==, f.contacts.face_count);
  g_assert_cmpfloat_with_epsilon (thrust.largest, hypot (1000, 300), 1e-9);
  g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (cut->at, touches->at[0])), <, 1e-12);
  qn_thrust_clear (&thrust);
  fixture_clear (&f);
}

/* On request the values of every joint stand beside it, and what they are in the legend. */
static void
test_values (void)
{
  g_auto (Solved) s;
  solve (&s, "06-arch.quoin");
  for (int on = 0; on < 2; on++) {
    g_autoptr (GError) error = NULL;
    QnViewOptions options;
    qn_view_options_init (&options, QN_VIEW_FORCES);
    *qn_view_switch (&options, "values") = on;
    g_autoptr (QnScene) scene =
      qn_scene_build (s.model, &s.contacts, &s.result, &options, &error);
    g_assert_no_error (error);
    size_t labels = 0;
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *c = qn_scene_command (scene, i);
      labels += c->kind == QN_COMMAND_TEXT && g_str_has_prefix (c->text, "N ")
                && strstr (c->text, "\nT ") != NULL && strstr (c->text, "\nM ") != NULL
                && strstr (c->text, "\ne ") != NULL;
    }
    g_assert_cmpuint (labels, ==, on ? s.contacts.face_count : 0);
  }
}

QN_TESTS
{
  g_test_add_func ("/render/reading/equilibrium", test_equilibrium);
  g_test_add_func ("/render/reading/blocks", test_blocks);
  g_test_add_func ("/render/reading/stresses", test_stresses);
  g_test_add_func ("/render/reading/places", test_places);
  g_test_add_func ("/render/reading/touch", test_touch);
  g_test_add_func ("/render/reading/values", test_values);
  g_test_add_func ("/render/thrust/arch", test_thrust_of_arch);
  g_test_add_func ("/render/thrust/needs-pressure", test_thrust_needs_pressure);
  g_test_add_func ("/render/thrust/numbers", test_thrust_numbers);
  g_test_add_func ("/render/thrust/balances", test_thrust_balances);
}
