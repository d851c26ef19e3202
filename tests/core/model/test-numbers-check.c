/* Numbers that mean nothing are refused, each by its key. */
#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <stddef.h>

enum {
  EDGE,
  SURCHARGE,
  BACKFILL,
  FILL,
  VEHICLE,
  SETTLEMENT,
  LOADS,
  CART = LOADS,
  SECTION,
  TIE,
  PULSE,
  START,
  MODEL
};

/* A load of each kind on a block of 2 m by 1 m, all dead but the settlement; and one of whatever else has
 * numbers. */
static void
init_sound (QnModel *model)
{
  static const QnLoadKind kinds[LOADS] = { QN_LOAD_EDGE,     QN_LOAD_SURCHARGE,
                                           QN_LOAD_BACKFILL, QN_LOAD_FILL,
                                           QN_LOAD_VEHICLE,  QN_LOAD_SETTLEMENT };
  test_model_init_block_on_plane (model, 2, 1);
  QnVehicle *vehicle = qn_model_add_vehicle (model, "cart");
  vehicle->axle_count = vehicle->line_count = 1;
  vehicle->axles[0] = (QnAxle){ .at = 1, .load = 1000 };
  vehicle->lines[0] = (QnLineLoad){ .from = 0, .to = 1, .intensity = 100 };
  vehicle->patch[0] = vehicle->patch[1] = 0.3;
  for (int i = 0; i < LOADS; i++) {
    QnLoad *load =
      i == SETTLEMENT ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
    load->kind = kinds[i];
    load->block = i == SETTLEMENT ? 0 : 1;
    load->vector = qn_vec2 (0, -1);
    load->edge = 2;
    load->edge_count = 1;
    load->part[1] = 1;
    load->span[0] = 0;
    load->span[1] = 1;
    load->side = QN_BLOCK_SIDE_LEFT;
    load->surface[0] = qn_vec2 (-2, 2);
    load->surface[1] = qn_vec2 (4, 2);
    load->surface_count = 2;
    load->stiffness = 1e6;
    load->vehicle = 0;
    load->convoy = 1;
    load->value = 0.01;
  }
  QnSection *section = qn_model_add_section (model, "steel");
  section->young = 2e11;
  section->width = section->height = 0.1;
  QnTie *tie = qn_model_add_tie (model, "rod");
  tie->ends[0] = (QnTieEnd){ .block = 1, .at = { 1, 1 } };
  tie->ends[1] = (QnTieEnd){ .block = QN_NONE, .at = { 3, 1 } };
  tie->area = 1e-4;
  tie->elasticity = 2e11;
  QnGroundMotion *pulse = qn_model_add_ground_motion (model);
  pulse->kind = QN_SIGNAL_PULSE;
  pulse->direction = qn_vec2 (1, 0);
  pulse->pulse = (QnPulse){ .amplitude = 1, .duration = 1 };
  qn_model_add_initial_motion (model)->block = 1;
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.dynamic = (QnDynamicSettings){
    .duration = 1, .time_step = 0.01, .tolerance = 1e-8, .rho = 0.8
  };
}

/* What a row of the tables below changes. */
static char *
object_of (QnModel *model, int which, QnEntity *entity)
{
  switch (which) {
  case SETTLEMENT:
    *entity = QN_ENTITY_LIVE_LOAD;
    return (char *) &model->live_loads[0];
  case CART:
    *entity = QN_ENTITY_VEHICLE;
    return (char *) &model->vehicles[0];
  case SECTION:
    *entity = QN_ENTITY_SECTION;
    return (char *) &model->sections[0];
  case TIE:
    *entity = QN_ENTITY_TIE;
    return (char *) &model->ties[0];
  case PULSE:
    *entity = QN_ENTITY_GROUND_MOTION;
    return (char *) &model->ground[0];
  case START:
    *entity = QN_ENTITY_INITIAL_MOTION;
    return (char *) &model->initial[0];
  case MODEL:
    *entity = QN_ENTITY_ANALYSIS;
    return (char *) &model->analysis;
  default:
    *entity = QN_ENTITY_DEAD_LOAD;
    return (char *) &model->dead_loads[which];
  }
}

static const struct {
  int of;
  size_t offset;
  double value;
  const char *field;
} numbers[] = {
#define OF(member)     offsetof (QnLoad, member)
#define IN(of, member) offsetof (Qn##of, member)
  { EDGE, OF (intensity[0]), NAN, "intensity" },
  { EDGE, OF (intensity[1]), INFINITY, "intensity" },
  { EDGE, OF (part[0]), -0.1, "part" },
  { EDGE, OF (part[1]), 1.1, "part" },
  { EDGE, OF (part[1]), 0, "part" },
  { EDGE, OF (vector.x), NAN, "direction" },
  { EDGE, OF (vector.x), 1e30, "direction" },
  { SURCHARGE, OF (pressure), -1, "pressure" },
  { SURCHARGE, OF (unit_weight), -1, "unit_weight" },
  { SURCHARGE, OF (level), INFINITY, "level" },
  { SURCHARGE, OF (coefficient), -1, "coefficient" },
  { SURCHARGE, OF (span[0]), NAN, "from" },
  { SURCHARGE, OF (span[1]), NAN, "to" },
  { SURCHARGE, OF (span[1]), -1, "from" },
  { BACKFILL, OF (pressure), NAN, "surcharge" },
  { BACKFILL, OF (span[0]), NAN, "bottom" },
  { BACKFILL, OF (span[1]), NAN, "top" },
  { BACKFILL, OF (span[1]), INFINITY, "top" },
  { BACKFILL, OF (friction_angle), -0.1, "friction_angle" },
  { BACKFILL, OF (friction_angle), 1.6, "friction_angle" },
  { FILL, OF (surface[1].y), NAN, "surface" },
  { FILL, OF (surface[1].x), -2, "surface" },
  { FILL, OF (unit_weight), -1, "unit_weight" },
  { FILL, OF (friction_angle), -0.1, "friction_angle" },
  { FILL, OF (friction_angle), 1.6, "friction_angle" },
  { FILL, OF (mobilisation), -0.1, "mobilisation" },
  { FILL, OF (mobilisation), 1.1, "mobilisation" },
  { FILL, OF (stiffness), 0, "stiffness" },
  { FILL, OF (span[0]), NAN, "bottom" },
  { VEHICLE, OF (position), NAN, "position" },
  { VEHICLE, OF (headway), -1, "headway" },
  { VEHICLE, OF (width), -1, "width" },
  { VEHICLE, OF (effective), -1, "effective_width" },
  { SETTLEMENT, OF (value), NAN, "value" },
  { CART, IN (Vehicle, patch[0]), 0, "patch" },
  { CART, IN (Vehicle, patch[1]), NAN, "patch" },
  { CART, IN (Vehicle, track), -1, "track" },
  { CART, IN (Vehicle, axles[0].at), -1, "axles" },
  { CART, IN (Vehicle, axles[0].load), NAN, "axles" },
  { CART, IN (Vehicle, lines[0].to), 0, "lines" },
  { CART, IN (Vehicle, lines[0].to), 2e4, "lines" },
  { CART, IN (Vehicle, lines[0].intensity), -1, "lines" },
  { SECTION, IN (Section, young), 0, "young" },
  { SECTION, IN (Section, shear_modulus), -1, "shear_modulus" },
  { SECTION, IN (Section, poisson), -1, "poisson" },
  { SECTION, IN (Section, poisson), 0.6, "poisson" },
  { SECTION, IN (Section, shear_factor), 0, "shear_factor" },
  { SECTION, IN (Section, yield), -1, "yield" },
  { SECTION, IN (Section, plastic_moment), -1, "plastic_moment" },
  { SECTION, IN (Section, width), -1, "width" },
  { SECTION, IN (Section, height), -1, "height" },
  { SECTION, IN (Section, density), NAN, "density" },
  { SECTION, IN (Section, unit_weight), -1, "unit_weight" },
  { TIE, IN (Tie, area), 0, "area" },
  { TIE, IN (Tie, elasticity), 0, "elasticity" },
  { TIE, IN (Tie, yield), -1, "yield" },
  { TIE, IN (Tie, prestress), -1, "prestress" },
  { TIE, IN (Tie, slack), -1, "slack" },
  { TIE, IN (Tie, anchor), -1, "anchor" },
  { TIE, IN (Tie, plate.diameter), -1, "plate.diameter" },
  { TIE, IN (Tie, plate.wall), -1, "plate.wall" },
  { TIE, IN (Tie, plate.shear), -1, "plate.shear" },
  { TIE, IN (Tie, plate.compression), -1, "plate.compression" },
  { TIE, IN (Tie, strip.width), -1, "strip.width" },
  { TIE, IN (Tie, strip.fracture_energy), -1, "strip.fracture_energy" },
  { TIE, IN (Tie, ends[0].at.x), NAN, "ends" },
  { TIE, IN (Tie, ends[1].at.y), NAN, "ends" },
  { PULSE, IN (GroundMotion, direction.x), NAN, "direction" },
  { PULSE, IN (GroundMotion, direction.x), 0, "direction" },
  { PULSE, IN (GroundMotion, scale), NAN, "scale" },
  { PULSE, IN (GroundMotion, peak), -1, "peak" },
  { PULSE, IN (GroundMotion, time_step), -1, "time_step" },
  { PULSE, IN (GroundMotion, pulse.amplitude), NAN, "pulse.amplitude" },
  { PULSE, IN (GroundMotion, pulse.duration), 0, "pulse.duration" },
  { PULSE, IN (GroundMotion, pulse.start), -1, "pulse.start" },
  { START, IN (InitialMotion, displacement[0]), NAN, "displacement" },
  { START, IN (InitialMotion, velocity[1]), INFINITY, "velocity" },
  { MODEL, IN (AnalysisSettings, dynamic.duration), -1, "dynamic.duration" },
  { MODEL, IN (AnalysisSettings, dynamic.time_step), 0, "dynamic.time_step" },
  { MODEL, IN (AnalysisSettings, dynamic.time_step), 1e-300, "dynamic.time_step" },
  { MODEL, IN (AnalysisSettings, dynamic.mass_damping), -1, "dynamic.damping.mass" },
  { MODEL, IN (AnalysisSettings, dynamic.joint_damping), -1, "dynamic.damping.stiffness" },
  { MODEL, IN (AnalysisSettings, dynamic.tolerance), 0, "dynamic.tolerance" },
  { MODEL, IN (AnalysisSettings, dynamic.output_interval), -1, "dynamic.output_interval" },
  { MODEL, IN (AnalysisSettings, dynamic.rho), -0.1, "dynamic.rho" },
  { MODEL, IN (AnalysisSettings, dynamic.rho), 1.1, "dynamic.rho" },
}, indices[] = {
  { EDGE, OF (block), 99, "block" },
  { EDGE, OF (edge), 99, "edge" },
  { EDGE, OF (edge_count), 0, "count" },
  { EDGE, OF (load_case), 1, "case" },
  { BACKFILL, OF (side), QN_BLOCK_SIDE_TOP, "side" },
  { FILL, OF (surface_count), 1, "surface" },
  { VEHICLE, OF (vehicle), 1, "vehicle" },
  { VEHICLE, OF (convoy), 0, "convoy" },
  { VEHICLE, OF (convoy), QN_MAX_CONVOY + 1, "convoy" },
  { SETTLEMENT, OF (block), 1, "component" },
  { TIE, IN (Tie, ends[0].block), 99, "ends" },
  { TIE, IN (Tie, ends[0].block), QN_NONE, "ends" },
  { TIE, IN (Tie, ends[1].block), 1, "ends" },
  { START, IN (InitialMotion, block), 99, "block" },
#undef OF
#undef IN
};

static void
expect_refused (QnModel *model, QnEntity entity, int index, const char *field)
{
  QnDiag diag;
  g_assert_cmpint (qn_model_prepare (model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.entity, ==, entity);
  g_assert_cmpint (diag.index, ==, index);
  g_assert_cmpstr (diag.field, ==, field);
  qn_model_clear (model);
}

static int
index_of (int which)
{
  return which == MODEL ? QN_NONE : which < SETTLEMENT ? which : 0;
}

static void
test_refused (void)
{
  QnModel model;
  QnEntity entity;
  init_sound (&model);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  qn_model_clear (&model);
  for (size_t i = 0; i < G_N_ELEMENTS (numbers); i++) {
    init_sound (&model);
    char *object = object_of (&model, numbers[i].of, &entity);
    *(double *) (void *) (object + numbers[i].offset) = numbers[i].value;
    expect_refused (&model, entity, index_of (numbers[i].of), numbers[i].field);
  }
  for (size_t i = 0; i < G_N_ELEMENTS (indices); i++) {
    init_sound (&model);
    char *object = object_of (&model, indices[i].of, &entity);
    *(int32_t *) (void *) (object + indices[i].offset) = (int32_t) indices[i].value;
    expect_refused (&model, entity, index_of (indices[i].of), indices[i].field);
  }
  init_sound (&model);
  model.vehicles[0].axle_count = model.vehicles[0].line_count = 0;
  expect_refused (&model, QN_ENTITY_VEHICLE, 0, "axles");
}

QN_TESTS
{
  g_test_add_func ("/numbers-check/refused", test_refused);
}
