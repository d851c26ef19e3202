/* Every row of the table of ranges: a number inside of it is not doubted, one outside of it is, and the
 * finding names value, range and what is probably meant. */
#include "core/contact/plausible.h"

#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

/* Two blocks on a base with a bar, a beam, loads of all kinds and a ground motion. */
static void
init_all (QnModel *model)
{
  test_model_init_stack (model, 2, 1, 0.5);
  test_model_add_weight_loads (model, 1);
  QnLoad *force = qn_model_add_dead_load (model);
  force->kind = QN_LOAD_FORCE;
  force->block = 1;
  force->vector = qn_vec2 (500, 0);
  QnLoad *settlement = qn_model_add_live_load (model);
  settlement->kind = QN_LOAD_SETTLEMENT;
  settlement->block = 0;
  settlement->dof = QN_DOF_UY;
  settlement->value = -0.01;
  QnLaw *steel = qn_model_add_law (model, "steel");
  steel->kind = QN_LAW_ELASTIC;
  steel->basis = QN_BASIS_SURFACE;
  steel->kn = steel->ks = 2e11;
  QnBar *bar = qn_model_add_bar (model);
  bar->law = 1;
  bar->area = 1e-4;
  bar->start = qn_vec2 (0, -0.2);
  bar->end = qn_vec2 (0, 0.9);
  QnTie *tie = qn_model_add_tie (model, "t");
  tie->ends[0] = (QnTieEnd){ 1, qn_vec2 (0, 0.2) };
  tie->ends[1].at = qn_vec2 (3, 0.2);
  tie->area = 1e-4;
  tie->elasticity = 2e11;
  QnSection *section = qn_model_add_section (model, "s");
  section->young = 3e10;
  section->poisson = 0.2;
  section->area = 0.01;
  section->inertia = 1e-5;
  model->analysis.control.block = 2;
  model->analysis.control.target = 0.1;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ QN_PULSE_SINE, 2, 0.5, 0 };
  model->analysis.dynamic.duration = 1;
  model->analysis.dynamic.time_step = 0.01;
}

/* Finds doubts and returns how many are of the row of `key` with this unit. */
static guint
count_of (QnModel *model, const QnUsualRange *range, double *value)
{
  QnContacts contacts = { 0 };
  QnDiag diag = { 0 };
  guint count = 0;
  if (qn_model_prepare (model, &diag) != QN_OK)
    g_error ("%s: %s", diag.field != NULL ? diag.field : "",
             qn_problem_text (diag.problem));
  qn_contacts_report_doubts (model, &contacts);
  g_assert_false (contacts.room.failed);
  for (size_t i = 0; i < contacts.findings.count; i++)
    if (contacts.findings.items[i].range == range) {
      count++;
      *value = contacts.findings.items[i].value;
      g_assert_cmpint (contacts.findings.items[i].problem, ==, range->doubt);
    }
  qn_contacts_clear (&contacts);
  return count;
}

/* The largest extent, m. */
static double
extent_of (const QnModel *model)
{
  QnVec2 low = model->vertices[0], high = low;
  for (size_t i = 0; i < model->vertex_count; i++) {
    QnVec2 v = model->vertices[i];
    low = qn_vec2 (fmin (low.x, v.x), fmin (low.y, v.y));
    high = qn_vec2 (fmax (high.x, v.x), fmax (high.y, v.y));
  }
  return fmax (high.x - low.x, high.y - low.y);
}

static void
put_tie (QnTie *tie, const char *key, double number)
{
  const double weight = 2 * 0.5 * 10000;
  const struct {
    const char *key;
    double *at, unit;
  } numbers[] = { { "area", &tie->area, 1 },
                  { "elasticity", &tie->elasticity, 1 },
                  { "yield", &tie->yield, 1 },
                  { "prestress", &tie->prestress, weight },
                  { "anchor", &tie->anchor, weight },
                  { "slack", &tie->slack, 1 },
                  { "plate.diameter", &tie->plate.diameter, 1 },
                  { "plate.wall", &tie->plate.wall, 1 },
                  { "plate.shear", &tie->plate.shear, 1 },
                  { "plate.compression", &tie->plate.compression, 1 },
                  { "strip.width", &tie->strip.width, 1 },
                  { "strip.fracture_energy", &tie->strip.fracture_energy, 1 } };
  for (size_t i = 0; i < G_N_ELEMENTS (numbers); i++)
    if (strcmp (key, numbers[i].key) == 0)
      *numbers[i].at = number * numbers[i].unit;
}

static void
put_section (QnSection *section, const char *key, double number)
{
  if (strcmp (key, "young") == 0) {
    section->young = number;
  } else if (strcmp (key, "unit_weight") == 0) {
    section->unit_weight = number;
  } else if (strcmp (key, "inertia") == 0) {
    section->inertia = section->area * number * number / 12;
  } else {
    section->height = section->width = 0.1;
    section->area = section->inertia = 0;
    *(strcmp (key, "height") == 0  ? &section->height
      : strcmp (key, "width") == 0 ? &section->width
                                   : &section->yield) = number;
  }
}

static void
put_load (QnModel *model, const QnUsualRange *range, double number)
{
  const double weight = 2 * 0.5 * 10000;
  const bool dead = range->entity == QN_ENTITY_DEAD_LOAD;
  const char *key = range->key;
  QnLoad *load;
  if (strcmp (range->unit, "rad") == 0) {
    model->live_loads[1].dof = QN_DOF_RZ;
    model->live_loads[1].value = number;
  } else if (strcmp (key, "value") == 0 && !dead) {
    model->live_loads[1].value = -extent_of (model) * number;
  } else if (strcmp (key, "value") == 0) {
    model->dead_loads[1].vector = qn_vec2 (0, number * weight);
  } else if (strcmp (key, "direction") == 0) {
    model->dead_loads[0].vector = qn_vec2 (0, -number);
  } else if (strcmp (key, "intensity") == 0) {
    load = qn_model_add_dead_load (model);
    load->kind = QN_LOAD_EDGE;
    load->block = 1;
    load->has_side = load->normal = true;
    load->part[1] = 1;
    load->intensity[1] = -number;
  } else {
    load = dead ? qn_model_add_dead_load (model) : qn_model_add_live_load (model);
    load->kind = QN_LOAD_BACKFILL;
    load->span[0] = -HUGE_VAL;
    load->span[1] = 0.4;
    load->unit_weight = 18000;
    load->coefficient = 0.3;
    *(strcmp (key, "pressure") == 0      ? &load->pressure
      : strcmp (key, "unit_weight") == 0 ? &load->unit_weight
                                         : &load->coefficient) = number;
  }
}

/* Puts a number where the row says. */
static void
put (QnModel *model, const QnUsualRange *range, double number)
{
  QnLaw *law = &model->laws[0];
  const char *key = range->key;
  const gboolean of_law = range->entity == QN_ENTITY_LAW;
  if (of_law && strcmp (key, "friction") != 0)
    law->basis = strcmp (range->unit, "N/m") == 0    ? QN_BASIS_CONTACT
                 : strcmp (range->unit, "Pa/m") == 0 ? QN_BASIS_SURFACE
                                                     : QN_BASIS_MATERIAL;
  if (of_law && strcmp (key, "kn") != 0)
    law->kn = 1e9;
  if (of_law && strcmp (key, "ks") != 0)
    law->ks = 1e9;
  if (of_law && strcmp (key, "compression") == 0) {
    law->kind = QN_LAW_MOHR_COULOMB;
  } else if (of_law && strcmp (key, "yield") == 0) {
    law->kind = QN_LAW_BILINEAR;
    law->friction = 0;
  } else if (of_law
             && (strcmp (key, "strength") == 0 || strcmp (key, "ultimate_strain") == 0
                 || strcmp (key, "fracture_energy") == 0
                 || strcmp (key, "crushing_energy") == 0)) {
    law->kind = QN_LAW_CONCRETE;
    law->strength = 3e7;
    law->kn = law->ks = 1e14;
    law->crushing_energy = 5e4;
    law->ultimate_strain = 0.0035;
    law->friction = 0;
  } else if (of_law && strncmp (key, "fracture_energy_", 16) == 0) {
    law->cohesion = law->tension = 1e5;
    law->fracture_energy_tension = 100;
  } else if (of_law && strcmp (key, "dilation_end") == 0) {
    law->dilatancy = 0.1;
  } else if (g_str_has_suffix (range->unit, "friction")) {
    law->friction = 0.5;
    law->cohesion = 1e5;
    number *= 2e5;
  }
  if (of_law && (strcmp (key, "kn") == 0 || strcmp (key, "ks") == 0)) {
    *(strcmp (key, "kn") == 0 ? &law->kn : &law->ks) = number;
  } else if (of_law) {
    size_t count;
    const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
    for (size_t i = 0; i < count; i++)
      if (strcmp (parameters[i].key, key) == 0)
        *qn_law_at (law, &parameters[i]) = number;
  } else if (range->entity == QN_ENTITY_SECTION && strcmp (key, "area") != 0) {
    put_section (&model->sections[0], key, number);
  } else if (range->entity == QN_ENTITY_DEAD_LOAD
             || range->entity == QN_ENTITY_LIVE_LOAD) {
    put_load (model, range, number);
  } else if (strcmp (key, "unit_weight") == 0) {
    model->blocks[1].unit_weight = number;
  } else if (strcmp (key, "density") == 0) {
    model->blocks[1].density = number;
  } else if (strcmp (key, "thickness") == 0) {
    model->blocks[1].thickness = number;
  } else if (strcmp (key, "vertices") == 0) {
    test_model_scale (model, number); /* the free blocks are 1 m wide */
  } else if (strcmp (key, "blocks") == 0) {
    test_model_scale (model, number / extent_of (model));
  } else if (strcmp (key, "gravity") == 0) {
    model->gravity = number;
  } else if (range->entity == QN_ENTITY_BAR) {
    model->bars[0].area = number;
  } else if (range->entity == QN_ENTITY_TIE) {
    put_tie (&model->ties[0], key, number);
  } else if (strcmp (key, "area") == 0) {
    model->sections[0].inertia *= pow (number / model->sections[0].area, 2);
    model->sections[0].area = number;
  } else if (strcmp (key, "control.target") == 0) {
    model->analysis.procedure = QN_PROCEDURE_DISPLACEMENT;
    model->analysis.control.dof =
      strcmp (range->unit, "rad") == 0 ? QN_DOF_RZ : QN_DOF_UX;
    model->analysis.control.target =
      number * (strcmp (range->unit, "rad") == 0 ? 1 : extent_of (model));
  } else {
    model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
    model->live_load_count = 1; /* no settlement in time */
    if (strcmp (key, "dynamic.damping.mass") == 0)
      model->analysis.dynamic.mass_damping = number;
    else if (strcmp (key, "dynamic.damping.stiffness") == 0)
      model->analysis.dynamic.joint_damping = number;
    else if (strcmp (key, "pulse.amplitude") == 0)
      model->ground[0].pulse.amplitude = -number;
    else {
      model->ground[0].kind = QN_SIGNAL_POINTS;
      qn_ground_motion_add_point (&model->ground[0], 0, 0);
      qn_ground_motion_add_point (&model->ground[0], 0.1, number);
    }
  }
}

static void
test_rows (void)
{
  size_t count;
  const QnUsualRange *ranges = qn_usual_ranges (&count);
  for (size_t row = 0; row < count; row++) {
    const QnUsualRange *range = &ranges[row];
    const double numbers[] = { range->least * 1.01, range->greatest * 0.99,
                               range->least * 0.99, range->greatest * 1.01 };
    g_test_message ("%s, %s", range->key, range->unit);
    g_assert_cmpfloat (range->least, <, range->greatest);
    for (int i = 0; i < 4; i++) {
      g_auto (QnModel) model;
      double value = NAN;
      if (numbers[i] == 0)
        continue;
      init_all (&model);
      put (&model, range, numbers[i]);
      guint found = count_of (&model, range, &value);
      g_test_message ("%g: %g", numbers[i], value);
      g_assert_cmpuint (found, ==, i < 2 ? 0 : 1);
      if (found > 0)
        g_assert_cmpfloat_with_epsilon (fabs (value), numbers[i], 1e-9 * numbers[i]);
    }
  }
}

/* Zero is no slip; equal numbers are told once, and of different ones three at most. */
static void
test_counts (void)
{
  size_t count;
  const QnUsualRange *ranges = qn_usual_ranges (&count);
  const QnUsualRange *weight = NULL;
  for (size_t i = 0; i < count; i++)
    if (ranges[i].entity == QN_ENTITY_BLOCK && strcmp (ranges[i].key, "unit_weight") == 0)
      weight = &ranges[i];
  double value;
  for (int kind = 0; kind < 3; kind++) {
    g_auto (QnModel) model;
    test_model_init_stack (&model, 9, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    for (size_t i = 1; i < model.block_count; i++)
      model.blocks[i].unit_weight = kind == 0 ? 0 : kind == 1 ? 20 : 20 + (double) i;
    g_assert_cmpuint (count_of (&model, weight, &value), ==,
                      kind == 0   ? 0
                      : kind == 1 ? 1
                                  : 3);
  }
}

static guint
count_problem (QnModel *model, QnProblem problem, double *value)
{
  g_auto (QnContacts) contacts = { 0 };
  guint count = 0;
  test_detect (model, &contacts);
  for (size_t i = 0; i < contacts.findings.count; i++)
    if (contacts.findings.items[i].problem == problem) {
      *value = contacts.findings.items[i].value;
      count++;
    }
  return count;
}

/* Joints that need pressure, and a live load without a dead one. */
static void
test_no_dead_load (void)
{
  double value;
  for (int kind = 0; kind < 5; kind++) {
    g_auto (QnModel) model;
    test_model_init_stack (&model, 2, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    model.dead_load_count = kind == 0 ? 1 : 0;
    if (kind == 4) { /* which carries */
      QnLaw *steel = qn_model_add_law (&model, "steel");
      *steel = (QnLaw){ .name = steel->name,
                        .kind = QN_LAW_ELASTIC,
                        .basis = QN_BASIS_MATERIAL,
                        .kn = 2e11,
                        .ks = 2e11,
                        .shear_factor = 1 };
      QnBar *bar = qn_model_add_bar (&model);
      *bar =
        (QnBar){ .law = 1, .area = 1e-4, .start = { 0.5, -0.25 }, .end = { 0.5, 0.75 } };
    }
    if (kind == 2)
      model.laws[0].kind = QN_LAW_ELASTIC;
    if (kind == 3)
      model.laws[0].tension = model.laws[0].cohesion = 100;
    g_assert_cmpuint (count_problem (&model, QN_PROBLEM_DOUBT_NO_DEAD_LOAD, &value), ==,
                      kind == 1 ? 1 : 0);
  }
}

/* A stack on two pairs of two springs in series each, so that kn / 2 x 2 = kn is the stiffness of a joint:
 * the limits of what a block sinks under its own weight, and the lowest one under all of them. Also
 * turned with its dead load, and in linear geometry. */
static void
test_sinking (void)
{
  static const struct {
    int blocks;
    QnGeometry geometry;
    double share; /* of its height, what the lowest block may sink */
  } rows[] = {
    { 1, QN_GEOMETRY_LINEAR, 1e-3 },     { 1, QN_GEOMETRY_NONLINEAR, 1e-3 },
    { 20, QN_GEOMETRY_NONLINEAR, 1e-2 }, { 20, QN_GEOMETRY_LINEAR, 2e-2 },
    { 60, QN_GEOMETRY_LINEAR, 5e-2 },
  };
  for (gsize row = 0; row < G_N_ELEMENTS (rows); row++)
    for (int turn = 0; turn < 4; turn++)
      for (int soft = 0; soft < 2; soft++) {
        g_auto (QnModel) model;
        double value = NAN, sinking = rows[row].share * (soft == 1 ? 1.01 : 0.99) * 0.5;
        test_model_init_stack (&model, rows[row].blocks, 1, 0.5);
        test_model_add_weight_loads (&model, 1);
        model.analysis.geometry = rows[row].geometry;
        model.laws[0].kn = rows[row].blocks * 1 * 0.5 * 10000 / sinking;
        model.laws[0].ks = 1e-3 * model.laws[0].kn;
        test_model_rotate (&model, turn * G_PI / 2);
        g_assert_cmpuint (count_problem (&model, QN_PROBLEM_DOUBT_SOFT, &value), ==,
                          soft);
        if (soft == 1)
          g_assert_cmpfloat_with_epsilon (value, sinking, 1e-6 * sinking);
      }
}

/* A strip of a fifth of a course is told, a closer of a quarter of a unit is not. */
static void
test_cut_pieces (void)
{
  static const struct {
    double width, height;
    guint count;
  } pieces[] = { { 1, 0.1, 1 }, { 0.1, 0.5, 1 }, { 0.25, 0.5, 0 }, { 1, 0.125, 0 } };
  for (gsize i = 0; i < G_N_ELEMENTS (pieces); i++) {
    g_auto (QnModel) model;
    QnContacts contacts;
    test_model_init_stack (&model, 12, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    const QnVec2 corner = qn_model_block_vertices (&model, 12)[3];
    test_model_add_rectangle (&model, "piece", corner.x, corner.y, pieces[i].width,
                              pieces[i].height);
    test_detect (&model, &contacts);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_SLIVER), ==,
                      pieces[i].count);
    qn_contacts_clear (&contacts);
  }
}

/* A crumb between twelve blocks is told with the block that it lies on; where every second block is as small
 * they are meant. */
static void
test_slivers (void)
{
  for (int crumbs = 0; crumbs < 8; crumbs += 1 + 5 * crumbs) {
    g_auto (QnModel) model;
    QnContacts contacts;
    test_model_init_stack (&model, 12, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    const QnVec2 corner = qn_model_block_vertices (&model, 12)[3];
    for (int i = 0; i < crumbs; i++) {
      g_autofree char *name = g_strdup_printf ("crumb %d", i);
      test_model_add_rectangle (&model, name, corner.x + 0.1 * i, corner.y, 0.05, 0.004);
    }
    test_detect (&model, &contacts);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_SLIVER), ==,
                      crumbs == 1 ? 1 : 0);
    if (crumbs == 1) {
      const QnFinding *sliver = test_the_finding (&contacts, QN_PROBLEM_BLOCK_SLIVER);
      g_assert_cmpint (sliver->block_a, ==, (QnId) model.block_count - 1);
      g_assert_cmpint (sliver->block_b, ==, 12);
    }
    qn_contacts_clear (&contacts);
  }
}

/* A thin course on top is one finding, with the number of its blocks. */
static void
test_thin_course (void)
{
  g_auto (QnModel) model;
  QnContacts contacts;
  test_model_init_stack (&model, 24, 1, 0.5);
  test_model_add_weight_loads (&model, 1);
  const QnVec2 corner = qn_model_block_vertices (&model, 24)[3];
  test_model_add_rectangle (&model, "left", corner.x, corner.y, 0.5, 0.025);
  test_model_add_rectangle (&model, "right", corner.x + 0.5, corner.y, 0.5, 0.025);
  test_detect (&model, &contacts);
  const QnFinding *course = test_the_finding (&contacts, QN_PROBLEM_BLOCK_SLIVER);
  g_assert_cmpint (course->block_a, ==, (QnId) model.block_count - 2);
  g_assert_cmpint (course->block_b, ==, 24);
  g_assert_cmpint (course->subject, ==, 2);
  qn_contacts_clear (&contacts);
}

QN_TESTS
{
  g_test_add_func ("/plausible/rows", test_rows);
  g_test_add_func ("/plausible/thin-course", test_thin_course);
  g_test_add_func ("/plausible/counts", test_counts);
  g_test_add_func ("/plausible/no-dead-load", test_no_dead_load);
  g_test_add_func ("/plausible/sinking", test_sinking);
  g_test_add_func ("/plausible/cut-pieces", test_cut_pieces);
  g_test_add_func ("/plausible/slivers", test_slivers);
}
