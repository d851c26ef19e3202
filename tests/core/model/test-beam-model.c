#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

/* A block on a plane with a beam from its top to a support beside it. */
static void
init_sound (QnModel *m)
{
  test_model_init_block_on_plane (m, 1, 2);
  QnSection *s = qn_model_add_section (m, "s");
  s->young = 1e9;
  s->width = 0.1;
  s->height = 0.2;
  QnNode *top = qn_model_add_node (m, "top");
  top->seat = QN_SEAT_SIDE;
  top->block = 1;
  top->side = QN_BLOCK_SIDE_TOP;
  QnNode *wall = qn_model_add_node (m, "wall");
  wall->at = qn_vec2 (4, 2);
  wall->support[0] = wall->support[1] = true;
  QnBeam *beam = qn_model_add_beam (m, "tie");
  beam->nodes[0] = 0;
  beam->nodes[1] = 1;
  beam->section = 0;
  beam->element_count = 4;
}

static void
test_expansion (void)
{
  QnModel model, copy;
  init_sound (&model);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (model.node_count, ==, 5);
  g_assert_cmpint (model.element_count, ==, 4);
  g_assert_cmpint (qn_model_find_node (&model, "tie.2"), ==, 3);
  g_assert_cmpfloat (model.nodes[0].at.x, ==, 0);
  g_assert_cmpfloat (model.nodes[0].at.y, ==, 2);
  g_assert_cmpfloat (model.nodes[3].at.x, ==, 2);
  g_assert_cmpfloat_with_epsilon (model.sections[0].inertia, 0.1 * 0.008 / 12, 1e-18);
  g_assert_cmpint (model.elements[3].nodes[0], ==, 4);
  g_assert_cmpint (model.elements[3].nodes[1], ==, 1);

  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
  qn_model_clear (&model);
  g_assert_cmpint (qn_model_prepare (&copy, NULL), ==, QN_OK);
  g_assert_cmpint (copy.node_count, ==, 5);
  g_assert_cmpstr (copy.nodes[4].name, ==, "tie.3");
  g_assert_cmpint (qn_model_find_beam (&copy, "tie"), ==, 0);
  qn_model_clear (&copy);
}

/* The middle of a side that vertices split, on a block that was drawn clockwise. */
static void
test_split_side (void)
{
  const QnVec2 outline[] = { { 0, 0 }, { 0, 1 }, { 0.5, 1 }, { 2, 1 }, { 2, 0 } };
  g_auto (QnModel) model;
  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 2, 1);
  qn_model_add_block (&model, "b", outline, 5)->thickness = 1;
  qn_model_add_section (&model, "s")->young = 1;
  model.sections[0].area = model.sections[0].inertia = 1;
  QnNode *node = qn_model_add_node (&model, "n");
  node->block = 1;
  node->seat = QN_SEAT_SIDE;
  node->side = QN_BLOCK_SIDE_TOP;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpfloat_with_epsilon (model.nodes[0].at.x, 1, 1e-15);
  g_assert_cmpfloat_with_epsilon (model.nodes[0].at.y, 1, 1e-15);
}

typedef struct {
  const char *name;
  void (*spoil) (QnModel *model);
  QnProblem problem;
  QnEntity entity;
  const char *field;
} Rule;

#define SPOIL(name, ...)                                                                 \
  static void name (QnModel *m)                                                          \
  {                                                                                      \
    __VA_ARGS__;                                                                         \
  }

SPOIL (section_unknown, m->beams[0].section = 3)
SPOIL (section_missing, m->beams[0].section = QN_NONE)
SPOIL (node_unknown, m->beams[0].nodes[1] = 7)
SPOIL (no_length, m->nodes[1].at = qn_vec2 (0, 2))
SPOIL (same_node, m->beams[0].nodes[1] = 0)
SPOIL (one_block, m->nodes[1].seat = QN_SEAT_CENTROID; m->nodes[1].block = 1;
       m->nodes[1].support[0] = m->nodes[1].support[1] = false)
SPOIL (block_unknown, m->nodes[0].block = 9)
SPOIL (riding_support, m->nodes[0].support[1] = true)
SPOIL (unused_node, (void) qn_model_add_node (m, "idle"))
SPOIL (node_name, (void) qn_model_add_node (m, "top"))
SPOIL (inner_name, (void) qn_model_add_node (m, "tie.1"))
SPOIL (far_node, m->nodes[1].at.x = 1e13)
SPOIL (no_elements, m->beams[0].element_count = 0)
SPOIL (many_elements, m->beams[0].element_count = QN_MAX_BEAM_ELEMENTS + 1)
SPOIL (young, m->sections[0].young = 0)
SPOIL (poisson, m->sections[0].poisson = 0.6)
SPOIL (width, m->sections[0].width = 0)
SPOIL (height, m->sections[0].height = -1)
SPOIL (area, m->sections[0].width = m->sections[0].height = 0)
SPOIL (inertia, m->sections[0].width = m->sections[0].height = 0; m->sections[0].area = 1)
SPOIL (soft, m->sections[0].young = 1e-20; m->sections[0].height = 1e-6)
SPOIL (stiff, m->sections[0].young = 1e20; m->sections[0].height = 1e6)
SPOIL (yield, m->sections[0].width = m->sections[0].height = 0;
       m->sections[0].area = m->sections[0].inertia = 1; m->sections[0].yield = 1e6)
SPOIL (hinged_moment, m->beams[0].hinge[1] = true;
       QnLoad *load = qn_model_add_live_load (m); load->kind = QN_LOAD_NODE;
       load->node = 1; load->moment = 5)
SPOIL (load_beam, QnLoad *load = qn_model_add_dead_load (m); load->kind = QN_LOAD_LINE;
       load->beam = 2)
SPOIL (load_node, QnLoad *load = qn_model_add_dead_load (m); load->kind = QN_LOAD_NODE;
       load->node = 99)
SPOIL (control_node, m->analysis.control.node = 99; m->analysis.control.target = 1)
SPOIL (control_rides, m->analysis.control.node = 0; m->analysis.control.target = 1)
SPOIL (control_fixed, m->analysis.control.node = 1; m->analysis.control.target = 1)

static const Rule rules[] = {
#define RULE(spoil, problem, entity, field)                                              \
  {                                                                                      \
#spoil, spoil, QN_PROBLEM_##problem, QN_ENTITY_##entity, field                       \
  }
  RULE (section_unknown, SECTION_UNKNOWN, BEAM, "section"),
  RULE (section_missing, SECTION_UNKNOWN, BEAM, "section"),
  RULE (node_unknown, NODE_UNKNOWN, BEAM, "nodes"),
  RULE (no_length, BEAM_SHORT, BEAM, "nodes"),
  RULE (same_node, BEAM_SHORT, BEAM, "nodes"),
  RULE (one_block, BEAM_ON_ONE_BLOCK, BEAM, "nodes"),
  RULE (block_unknown, BLOCK_UNKNOWN, NODE, "block"),
  RULE (riding_support, NODE_SUPPORTED_BY_BLOCK, NODE, "support"),
  RULE (unused_node, NODE_UNUSED, NODE, NULL),
  RULE (node_name, NAME_TAKEN, NODE, "name"),
  RULE (inner_name, NAME_TAKEN, BEAM, "name"),
  RULE (far_node, TOO_LARGE, NODE, "at"),
  RULE (no_elements, NOT_POSITIVE, BEAM, "elements"),
  RULE (many_elements, TOO_LARGE, BEAM, "elements"),
  RULE (young, NOT_POSITIVE, SECTION, "young"),
  RULE (poisson, POISSON_RATIO, SECTION, "poisson"),
  RULE (width, NOT_POSITIVE, SECTION, "width"),
  RULE (height, NOT_POSITIVE, SECTION, "height"),
  RULE (area, NOT_POSITIVE, SECTION, "area"),
  RULE (inertia, NOT_POSITIVE, SECTION, "inertia"),
  RULE (soft, TOO_SMALL, BEAM, "section"),
  RULE (stiff, TOO_LARGE, BEAM, "section"),
  RULE (yield, YIELD_SHAPELESS, SECTION, "yield"),
  RULE (hinged_moment, NODE_MOMENT, LIVE_LOAD, "moment"),
  RULE (load_beam, BEAM_UNKNOWN, DEAD_LOAD, "beam"),
  RULE (load_node, NODE_UNKNOWN, DEAD_LOAD, "node"),
  RULE (control_node, NODE_UNKNOWN, ANALYSIS, "control.node"),
  RULE (control_rides, CONTROL_NODE_RIDES, ANALYSIS, "control.node"),
  RULE (control_fixed, CONTROL_DOF_FIXED, ANALYSIS, "control.component"),
#undef RULE
};

static void
test_rules (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (rules); i++) {
    g_auto (QnModel) model;
    QnDiag diag = { 0 };
    init_sound (&model);
    rules[i].spoil (&model);
    g_test_message ("%s", rules[i].name);
    g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, rules[i].problem);
    g_assert_cmpint (diag.entity, ==, rules[i].entity);
    g_assert_cmpstr (diag.field, ==, rules[i].field);
  }
}

QN_TESTS
{
  g_test_add_func ("/beam-model/expansion", test_expansion);
  g_test_add_func ("/beam-model/split-side", test_split_side);
  g_test_add_func ("/beam-model/rules", test_rules);
}
