#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

/* A sound model with one of everything, to be spoilt in one place. */
static void
init_sound (QnModel *model)
{
  test_model_init_stack (model, 2, 1, 0.5);
  test_model_add_weight_loads (model, 1);
  QnLoad *force = qn_model_add_live_load (model);
  force->kind = QN_LOAD_FORCE;
  force->block = 2;
  force->vector = qn_vec2 (10, 0);
  force->has_at = true;
  QnFaceOverride *override = qn_model_add_override (model);
  override->block_a = 1;
  override->block_b = 2;
  override->has_pairs = true;
  override->pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 3 };
  model->analysis.control.block = 2;
  model->analysis.control.target = 0.1;
}

static void
test_sound (void)
{
  g_auto (QnModel) model;
  init_sound (&model);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
}

/* Each of these spoils one thing. */
#define SPOIL(name, statement)                                                           \
  static void spoil_##name (QnModel *m)                                                  \
  {                                                                                      \
    statement;                                                                           \
  }

SPOIL (gravity, m->gravity = -1)
SPOIL (name_missing, m->blocks[1].name[0] = '\0')
SPOIL (name_taken, m->blocks[2].name[1] = '1')
SPOIL (vertex, m->vertices[5].x = NAN)
SPOIL (vertex_repeated, m->vertices[5] = m->vertices[4])
SPOIL (thickness, m->blocks[1].thickness = -0.1)
SPOIL (thickness_zero, m->blocks[1].thickness = 0)
SPOIL (thickness_nan, m->blocks[1].thickness = NAN)
SPOIL (unit_weight, m->blocks[2].unit_weight = -1)
SPOIL (unit_weight_infinite, m->blocks[2].unit_weight = INFINITY)
SPOIL (density, m->blocks[2].density = NAN)
SPOIL (block_law, m->blocks[1].law = 1)
SPOIL (law_stiffness, m->laws[0].kn = 0)
SPOIL (law_friction, m->laws[0].friction = -0.1)
SPOIL (contact_law, m->contact.law = 7)
SPOIL (contact_law_missing, m->contact.law = QN_NONE)
SPOIL (tolerance, m->contact.tolerance = -1e-6)
SPOIL (tolerance_large, m->contact.tolerance = 1)
SPOIL (offset, m->contact.pairs.offset = -0.01)
SPOIL (offset_nan, m->contact.pairs.offset = NAN)
SPOIL (count, m->overrides[0].pairs.count = 0)
SPOIL (count_large, m->overrides[0].pairs.count = 1000000)
SPOIL (override_block, m->overrides[0].block_b = QN_NONE)
SPOIL (override_same, m->overrides[0].block_b = 1)
SPOIL (override_law, m->overrides[0].law = 3)
SPOIL (direction, m->dead_loads[0].vector.y = NAN)
SPOIL (load_block, m->live_loads[1].block = 99)
SPOIL (load_block_none, m->live_loads[1].block = QN_NONE)
SPOIL (force, m->live_loads[1].vector.x = INFINITY)
SPOIL (moment, m->live_loads[1].moment = NAN)
SPOIL (at, m->live_loads[1].at.x = NAN)
SPOIL (increments, m->analysis.increments = 0)
SPOIL (max_multiplier, m->analysis.max_multiplier = -1)
SPOIL (max_multiplier_nan, m->analysis.max_multiplier = NAN)
SPOIL (multiplier_tolerance, m->analysis.multiplier_tolerance = -1)
SPOIL (residual_tolerance, m->analysis.residual_tolerance = 0)
SPOIL (multiplier_fine, m->analysis.multiplier_tolerance = 1e-16)
SPOIL (multiplier_coarse, m->analysis.multiplier_tolerance = 0.2)
SPOIL (residual_fine, m->analysis.residual_tolerance = 1e-17)
SPOIL (residual_coarse, m->analysis.residual_tolerance = 0.1)
SPOIL (factorizations, m->analysis.max_factorizations = 0)
SPOIL (seconds, m->analysis.max_seconds = 0)
SPOIL (seconds_nan, m->analysis.max_seconds = NAN)
SPOIL (gravity_small, m->gravity = 1e-320)
SPOIL (thickness_small, m->blocks[1].thickness = 1e-31)
SPOIL (thickness_large, m->blocks[1].thickness = 2e30)
SPOIL (unit_weight_large, m->blocks[2].unit_weight = 1e300)
SPOIL (density_large, m->blocks[2].density = 1e300)
SPOIL (force_large, m->live_loads[1].vector.x = -1e300)
SPOIL (stiffness_small, m->laws[0].kn = 1e-300)
SPOIL (cohesion_large, m->laws[0].cohesion = 1e300)
SPOIL (stiffness, m->laws[0].kn = 1e308)
SPOIL (shear_stiffness, m->laws[0].ks = 1e21)
SPOIL (direction_large, m->dead_loads[0].vector.y = -1e30)
SPOIL (control_block, m->analysis.control.block = 3)
SPOIL (control_target, m->analysis.control.target = 0)
SPOIL (control_fixed, m->analysis.control.block = 0)
SPOIL (control_missing, m->analysis.control.block = QN_NONE;
       m->analysis.procedure = QN_PROCEDURE_DISPLACEMENT)

SPOIL (control_nan, m->analysis.control.target = NAN)
SPOIL (case_nan, qn_model_add_load_case (m, "a"); m->load_cases[0].factor = NAN)
SPOIL (case_large, qn_model_add_load_case (m, "a"); m->load_cases[0].factor = 1e29)

static void
spoil_surface (QnModel *m)
{
  QnLoad *fill = qn_model_add_dead_load (m);
  fill->kind = QN_LOAD_FILL;
  fill->surface_count = QN_MAX_SURFACE_POINTS + 1;
}

static void
settle (QnModel *m, QnProcedure procedure)
{
  QnLoad *load = qn_model_add_live_load (m);
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = 0;
  load->value = 0.1;
  m->analysis.procedure = procedure;
}

SPOIL (settlement_work, settle (m, QN_PROCEDURE_WORK))
SPOIL (settlement_limit, settle (m, QN_PROCEDURE_LIMIT))

/* Of the live loads, up to this multiplier; NaN: to collapse. */
static QnStage *
add_stage (QnModel *m, double target)
{
  QnStage *stage = qn_model_add_stage (m, "s");
  stage->sets = 1;
  stage->procedure = QN_PROCEDURE_LOAD;
  stage->has_target = !isnan (target);
  stage->target = isnan (target) ? 0 : target;
  return stage;
}

static QnStage *
control_stage (QnModel *m, QnId block, double target)
{
  QnStage *stage = add_stage (m, NAN);
  stage->control.block = block;
  stage->control.target = target;
  return stage;
}

SPOIL (stage_limit, add_stage (m, 1)->procedure = QN_PROCEDURE_LIMIT)
SPOIL (stage_dynamic, add_stage (m, 1)->procedure = QN_PROCEDURE_DYNAMIC)
SPOIL (stage_idle, add_stage (m, 1)->sets = 0)
SPOIL (stage_set, add_stage (m, 1)->sets = 2)
SPOIL (stage_increments, add_stage (m, 1)->increments = -1)
SPOIL (stage_target, add_stage (m, INFINITY))
SPOIL (stage_control, add_stage (m, NAN)->procedure = QN_PROCEDURE_DISPLACEMENT)
SPOIL (stage_block, control_stage (m, 9, 0.1))
SPOIL (stage_zero, control_stage (m, 2, 0))
SPOIL (stage_nan, control_stage (m, 2, NAN))
SPOIL (stage_two_ends, control_stage (m, 2, 0.1)->has_target = true)
SPOIL (stage_endless, add_stage (m, NAN); add_stage (m, 1))
SPOIL (stage_no_change, add_stage (m, 1); add_stage (m, 1))
SPOIL (stages_limit, add_stage (m, 1); m->analysis.procedure = QN_PROCEDURE_LIMIT)
SPOIL (stages_multiplier, add_stage (m, 1); m->analysis.max_multiplier = 2)
SPOIL (stages_many, for (int i = 0; i <= QN_MAX_STAGES; i++) add_stage (m, i + 1))

typedef struct {
  const char *name;
  void (*spoil) (QnModel *model);
  QnProblem problem;
  QnEntity entity;
  QnId index;
  const char *field;
} Case;

#define CASE(name, problem, entity, index, field)                                        \
  {                                                                                      \
#name, spoil_##name, QN_PROBLEM_##problem, QN_ENTITY_##entity, index, field          \
  }

static const Case cases[] = {
  CASE (gravity, NEGATIVE, MODEL, QN_NONE, "gravity"),
  CASE (gravity_small, TOO_SMALL, MODEL, QN_NONE, "gravity"),
  CASE (thickness_small, TOO_SMALL, BLOCK, 1, "thickness"),
  CASE (thickness_large, TOO_LARGE, BLOCK, 1, "thickness"),
  CASE (unit_weight_large, TOO_LARGE, BLOCK, 2, "unit_weight"),
  CASE (density_large, TOO_LARGE, BLOCK, 2, "density"),
  CASE (force_large, TOO_LARGE, LIVE_LOAD, 1, "value"),
  CASE (stiffness_small, TOO_SMALL, LAW, 0, "kn"),
  CASE (cohesion_large, TOO_LARGE, LAW, 0, "cohesion"),
  CASE (name_missing, NAME_MISSING, BLOCK, 1, "name"),
  CASE (name_taken, NAME_TAKEN, BLOCK, 2, "name"),
  CASE (vertex, NOT_FINITE, BLOCK, 1, "vertices"),
  CASE (vertex_repeated, DUPLICATE_VERTEX, BLOCK, 1, "vertices"),
  CASE (thickness, NOT_POSITIVE, BLOCK, 1, "thickness"),
  CASE (thickness_zero, NOT_POSITIVE, BLOCK, 1, "thickness"),
  CASE (thickness_nan, NOT_FINITE, BLOCK, 1, "thickness"),
  CASE (unit_weight, NEGATIVE, BLOCK, 2, "unit_weight"),
  CASE (unit_weight_infinite, NOT_FINITE, BLOCK, 2, "unit_weight"),
  CASE (density, NOT_FINITE, BLOCK, 2, "density"),
  CASE (block_law, LAW_UNKNOWN, BLOCK, 1, "law"),
  CASE (contact_law, LAW_UNKNOWN, CONTACT, QN_NONE, "law"),
  CASE (contact_law_missing, LAW_MISSING, CONTACT, QN_NONE, "law"),
  CASE (tolerance, NEGATIVE, CONTACT, QN_NONE, "tolerance"),
  CASE (tolerance_large, TOO_LARGE, CONTACT, QN_NONE, "tolerance"),
  CASE (offset, NEGATIVE, CONTACT, QN_NONE, "pairs.offset"),
  CASE (offset_nan, NOT_FINITE, CONTACT, QN_NONE, "pairs.offset"),
  CASE (count, PAIR_COUNT, FACE_OVERRIDE, 0, "pairs.count"),
  CASE (count_large, TOO_LARGE, FACE_OVERRIDE, 0, "pairs.count"),
  CASE (override_block, BLOCK_UNKNOWN, FACE_OVERRIDE, 0, "blocks"),
  CASE (override_same, SAME_BLOCK, FACE_OVERRIDE, 0, "blocks"),
  CASE (override_law, LAW_UNKNOWN, FACE_OVERRIDE, 0, "law"),
  CASE (direction, NOT_FINITE, DEAD_LOAD, 0, "direction"),
  CASE (load_block, BLOCK_UNKNOWN, LIVE_LOAD, 1, "block"),
  CASE (load_block_none, BLOCK_UNKNOWN, LIVE_LOAD, 1, "block"),
  CASE (force, NOT_FINITE, LIVE_LOAD, 1, "value"),
  CASE (moment, NOT_FINITE, LIVE_LOAD, 1, "moment"),
  CASE (at, NOT_FINITE, LIVE_LOAD, 1, "at"),
  CASE (increments, NOT_POSITIVE, ANALYSIS, QN_NONE, "increments"),
  CASE (max_multiplier, NEGATIVE, ANALYSIS, QN_NONE, "max_multiplier"),
  CASE (max_multiplier_nan, NOT_FINITE, ANALYSIS, QN_NONE, "max_multiplier"),
  CASE (multiplier_tolerance, NOT_POSITIVE, ANALYSIS, QN_NONE, "multiplier_tolerance"),
  CASE (residual_tolerance, NOT_POSITIVE, ANALYSIS, QN_NONE, "residual_tolerance"),
  CASE (multiplier_fine, TOLERANCE_FINE, ANALYSIS, QN_NONE, "multiplier_tolerance"),
  CASE (multiplier_coarse, TOLERANCE_COARSE, ANALYSIS, QN_NONE, "multiplier_tolerance"),
  CASE (residual_fine, TOLERANCE_FINE, ANALYSIS, QN_NONE, "residual_tolerance"),
  CASE (residual_coarse, TOLERANCE_COARSE, ANALYSIS, QN_NONE, "residual_tolerance"),
  CASE (factorizations, NOT_POSITIVE, ANALYSIS, QN_NONE, "max_factorizations"),
  CASE (seconds, NOT_POSITIVE, ANALYSIS, QN_NONE, "max_seconds"),
  CASE (seconds_nan, NOT_FINITE, ANALYSIS, QN_NONE, "max_seconds"),
  CASE (stiffness, TOO_LARGE, LAW, 0, "kn"),
  CASE (shear_stiffness, TOO_LARGE, LAW, 0, "ks"),
  CASE (direction_large, TOO_LARGE, DEAD_LOAD, 0, "direction"),
  CASE (control_block, BLOCK_UNKNOWN, ANALYSIS, QN_NONE, "control.block"),
  CASE (control_target, CONTROL_TARGET_ZERO, ANALYSIS, QN_NONE, "control.target"),
  CASE (control_fixed, CONTROL_DOF_FIXED, ANALYSIS, QN_NONE, "control.component"),
  CASE (control_missing, CONTROL_MISSING, ANALYSIS, QN_NONE, "control"),
  CASE (control_nan, NOT_FINITE, ANALYSIS, QN_NONE, "control.target"),
  CASE (case_nan, NOT_FINITE, LOAD_CASE, 0, NULL),
  CASE (case_large, TOO_LARGE, LOAD_CASE, 0, NULL),
  CASE (surface, TOO_LARGE, DEAD_LOAD, 1, "surface"),
  CASE (settlement_work, SETTLEMENT_WORK, ANALYSIS, QN_NONE, "procedure"),
  CASE (settlement_limit, SETTLEMENT_LIMIT, ANALYSIS, QN_NONE, "procedure"),
  CASE (stage_limit, STAGE_LIMIT, STAGE, 0, "procedure"),
  CASE (stage_dynamic, STAGES_DYNAMIC, STAGE, 0, "procedure"),
  CASE (stage_idle, STAGE_IDLE, STAGE, 0, "loads"),
  CASE (stage_set, LOAD_SET_UNKNOWN, STAGE, 0, "loads"),
  CASE (stage_increments, NOT_POSITIVE, STAGE, 0, "increments"),
  CASE (stage_target, NOT_FINITE, STAGE, 0, "target"),
  CASE (stage_control, CONTROL_MISSING, STAGE, 0, "control"),
  CASE (stage_block, BLOCK_UNKNOWN, STAGE, 0, "control.block"),
  CASE (stage_zero, CONTROL_TARGET_ZERO, STAGE, 0, "control.target"),
  CASE (stage_nan, NOT_FINITE, STAGE, 0, "control.target"),
  CASE (stage_two_ends, STAGE_TWO_ENDS, STAGE, 0, "target"),
  CASE (stage_endless, STAGE_ENDLESS, STAGE, 0, "target"),
  CASE (stage_no_change, STAGE_NO_CHANGE, STAGE, 1, "target"),
  CASE (stages_limit, STAGE_LIMIT, ANALYSIS, QN_NONE, "stages"),
  CASE (stages_multiplier, STAGE_MULTIPLIER, ANALYSIS, QN_NONE, "max_multiplier"),
  CASE (stages_many, TOO_LARGE, ANALYSIS, QN_NONE, "stages"),
};

static void
test_refused (const void *data)
{
  const Case *c = data;
  g_auto (QnModel) model;
  QnDiag diag;
  init_sound (&model);
  c->spoil (&model);
  /* Names are changed in place here: let the model's index know. */
  QnModel copy;
  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
  qn_name_index_clear (&copy.block_names);
  for (size_t i = 0; i < copy.block_count; i++)
    g_assert_true (
      qn_name_index_add (&copy.block_names, copy.blocks, sizeof *copy.blocks, (QnId) i));

  g_assert_cmpint (qn_model_prepare (&copy, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, qn_problem_text (c->problem));
  g_assert_cmpint (diag.entity, ==, c->entity);
  g_assert_cmpint (diag.index, ==, c->index);
  g_assert_cmpstr (diag.field, ==, c->field);
  g_assert_cmpint (qn_model_prepare (&copy, NULL), ==, QN_ERROR_INVALID);
  qn_model_clear (&copy);
}

/* The rules for laws are the laws' own; here only that they are asked. */
static void
test_laws_are_checked (void)
{
  void (*spoils[]) (QnModel *) = { spoil_law_stiffness, spoil_law_friction };
  for (size_t i = 0; i < G_N_ELEMENTS (spoils); i++) {
    g_auto (QnModel) model;
    QnDiag diag;
    init_sound (&model);
    spoils[i](&model);
    g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.entity, ==, QN_ENTITY_LAW);
    g_assert_cmpint (diag.index, ==, 0);
  }
}

static void
test_law_name_taken (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  init_sound (&model);
  QnLaw *law = qn_model_add_law (&model, "joint");
  law->kind = QN_LAW_ELASTIC;
  law->kn = law->ks = 1;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NAME_TAKEN);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_LAW);
  g_assert_cmpint (diag.index, ==, 1);
}

/* Where every block has a law of its own the contact law may be left out. */
static void
test_block_laws_suffice (void)
{
  g_auto (QnModel) model;
  init_sound (&model);
  model.contact.law = QN_NONE;
  for (size_t i = 0; i < model.block_count; i++)
    model.blocks[i].law = 0;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
}

/* A fault in a block that came from a wall is the wall's. */
static void
test_wall_is_blamed (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init_wall (&model, 1, 0);
  model.walls[0].thickness = -1;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NOT_POSITIVE);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_WALL);
  g_assert_cmpint (diag.index, ==, 0);
  g_assert_cmpstr (diag.field, ==, "thickness");
}

QN_TESTS
{
  g_test_add_func ("/model-check/sound", test_sound);
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *path = g_strconcat ("/model-check/refused/", cases[i].name, NULL);
    g_test_add_data_func (path, &cases[i], test_refused);
  }
  g_test_add_func ("/model-check/laws-are-checked", test_laws_are_checked);
  g_test_add_func ("/model-check/law-name-taken", test_law_name_taken);
  g_test_add_func ("/model-check/block-laws-suffice", test_block_laws_suffice);
  g_test_add_func ("/model-check/wall-is-blamed", test_wall_is_blamed);
}
