#include "core/contact/plausible.h"

#include "core/base/box.h"
#include "core/base/numbers.h"
#include "core/contact/contact-search.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* A sliver is thinner than this part of the median block and has less than this part of its area: of a wall
 * that block is the uncut unit, of which nobody lays less than a quarter, in length (a closer, whose width is
 * half that of the unit) or in height (a strip, with a third of it). Beds of mortar are as thin, but long.
 * Where more than a tenth of the blocks, of 10 or more, are like this they are meant to be. */
#define SLIVER_WIDTH (1.0 / 3.0)
#define SLIVER_AREA  0.25
#define LINTEL_AREA  2.5

/* Findings of one row; more would hide the others. */
#define MOST_OF_A_ROW 3

/* Share of its height that a block may sink into its joints: under its own weight, and under the dead
 * load on it where softness lowers the multiplier, in large displacements, and where not, in linear
 * geometry and in time. */
#define OWN_SINKING      1e-3
#define MOST_SINKING     1e-2
#define HARMLESS_SINKING 5e-2

/* A joint bears whose normal is nearer to the dead load than to its perpendicular; blocks that bear on
 * less than this part of their width hang or rest on an edge, whatever the joints. */
#define LEAST_BEARING 0.25

/* The rows of numbers that are worked out, or not of every item; the others belong to a member of every item, or
 * to a parameter of laws. */
typedef enum {
  KN, /* by basis, here and for KS */
  KS = KN + QN_BASIS_COUNT,
  APEX = KS + QN_BASIS_COUNT,
  UNIT_WEIGHT,
  DENSITY,
  BLOCK_SIZE,
  EXTENT,
  TIE_PRESTRESS,
  TIE_ANCHOR,
  SECTION_AREA,
  SECTION_INERTIA,
  SECTION_WIDTH,
  SECTION_HEIGHT,
  DEAD_WEIGHT,
  DEAD_FORCE,
  DEAD_INTENSITY,
  SETTLEMENT,
  TURN,
  TARGET,
  TARGET_TURN,
  PULSE,
  SIGNAL,
  MASS_DAMPING,
  STIFFNESS_DAMPING,
  FRICTION, /* the first of the parameters of laws */
  DILATION_END = FRICTION + 11,
  MEMBERS /* those of every item, from here on */
} Row;

#define RANGE(entity, key, unit, least, greatest, doubt)                                 \
  {                                                                                      \
    QN_ENTITY_##entity, key, unit, least, greatest, QN_PROBLEM_DOUBT_##doubt, 0          \
  }
#define MEMBER(entity, type, member, unit, least, greatest, doubt)                       \
  {                                                                                      \
    QN_ENTITY_##entity, #member, unit, least, greatest, QN_PROBLEM_DOUBT_##doubt,        \
      offsetof (type, member)                                                            \
  }

static const QnUsualRange ranges[] = {
  /* From a pebble's joint up; stiffer ones stand for what is rigid, here and below. */
  [KN + QN_BASIS_CONTACT] = RANGE (LAW, "kn", "N/m", 1e4, 1e18, STIFFNESS),
  [KS + QN_BASIS_CONTACT] = RANGE (LAW, "ks", "N/m", 1e4, 1e18, STIFFNESS),
  /* Joints of mortar have 4e10 to 1.1e11 Pa/m (P. B. Lourenço, Computational Strategies for Masonry
   * Structures, Delft 1996), dry ones less. */
  [KN + QN_BASIS_SURFACE] = RANGE (LAW, "kn", "Pa/m", 1e7, 1e18, STIFFNESS),
  [KS + QN_BASIS_SURFACE] = RANGE (LAW, "ks", "Pa/m", 1e6, 1e18, STIFFNESS),
  /* From rubber up; masonry has 1000 times its strength (EN 1996-1-1:2005, 3.7.2). */
  [KN + QN_BASIS_MATERIAL] = RANGE (LAW, "kn", "Pa", 1e6, 1e18, STIFFNESS),
  [KS + QN_BASIS_MATERIAL] = RANGE (LAW, "ks", "Pa", 1e5, 1e18, STIFFNESS),
  [APEX] = RANGE (LAW, "tension", "× cohesion/friction", 0, 1, APEX),
  /* EN 1991-1-1:2002, annex A: timber from 3.5, lightweight concrete from 9, masonry 16 to 30, steel
   * 78.5, lead 114 kN/m3. */
  [UNIT_WEIGHT] = RANGE (BLOCK, "unit_weight", "N/m3", 2500, 1.2e5, UNIT_WEIGHT),
  [DENSITY] = RANGE (BLOCK, "density", "kg/m3", 250, 12000, DENSITY),
  /* The largest hewn blocks, at Baalbek, are 20 m long. */
  [BLOCK_SIZE] = RANGE (BLOCK, "vertices", "m", 2e-3, 30, LENGTH),
  /* The Pont du Gard was 360 m long. */
  [EXTENT] = RANGE (MODEL, "blocks", "m", 0.02, 500, LENGTH),
  /* Over the free weight, as forces. */
  [TIE_PRESTRESS] = RANGE (TIE, "prestress", "× W", 5e-5, 1e3, FORCE),
  [TIE_ANCHOR] = RANGE (TIE, "anchor", "× W", 5e-5, 1e4, FORCE),
  [SECTION_AREA] = RANGE (SECTION, "area", "m2", 7e-7, 100, AREA),
  /* As the height of the rectangle with this area. */
  [SECTION_INERTIA] = RANGE (SECTION, "inertia", "m of height", 1e-3, 10, LENGTH),
  [SECTION_WIDTH] = RANGE (SECTION, "width", "m", 1e-3, 100, LENGTH),
  [SECTION_HEIGHT] = RANGE (SECTION, "height", "m", 1e-3, 10, LENGTH),
  /* Times the weight, which is a force already. */
  [DEAD_WEIGHT] = RANGE (DEAD_LOAD, "direction", "× W", 0.2, 5, WEIGHT),
  /* Over the free weight: less is not seen in any result. */
  [DEAD_FORCE] = RANGE (DEAD_LOAD, "value", "× W", 5e-4, 1e4, FORCE),
  [DEAD_INTENSITY] = RANGE (DEAD_LOAD, "intensity", "N/m", 20, 1e8, FORCE),
  /* Over the largest extent of the structure, as the target. */
  [SETTLEMENT] = RANGE (LIVE_LOAD, "value", "× L", 0, 0.5, LENGTH),
  [TURN] = RANGE (LIVE_LOAD, "value", "rad", 0, 2 * QN_PI, ANGLE),
  [TARGET] = RANGE (ANALYSIS, "control.target", "× L", 0, 2, LENGTH),
  [TARGET_TURN] = RANGE (ANALYSIS, "control.target", "rad", 0, 2 * QN_PI, ANGLE),
  /* The strongest record has 4 g: IWTH25, Iwate-Miyagi 2008 (S. Aoi et al., Science 322 (2008)
   * 727-730). */
  [PULSE] = RANGE (GROUND_MOTION, "pulse.amplitude", "m/s2", 0, 50, ACCELERATION),
  [SIGNAL] = RANGE (GROUND_MOTION, "points", "m/s2", 0, 50, ACCELERATION),
  /* Two times damping ratio times circular frequency, and over it: a ratio of 0.2 at 10 Hz; of 0.3 at
   * 5 Hz. */
  [MASS_DAMPING] = RANGE (ANALYSIS, "dynamic.damping.mass", "1/s", 0, 25, DAMPING),
  [STIFFNESS_DAMPING] =
    RANGE (ANALYSIS, "dynamic.damping.stiffness", "s", 0, 0.02, DAMPING),
  /* Rough joints of rock at low stress reach 70 degrees, tan 2.7 (N. Barton, V. Choubey, The shear
   * strength of rock joints in theory and practice, Rock Mechanics 10 (1977) 1-54). */
  [FRICTION] = RANGE (LAW, "friction", "", 0.02, 3, TANGENT),
  /* EN 1996-1-1:2005, 3.6: initial shear and flexural strengths from 0.05 to 0.4 MPa. EN 1992-1-1:2004,
   * table 3.1: concrete 1.6 to 5 MPa in tension, 12 to 90 MPa in compression. Natural stone: to 20 and
   * 400 MPa. EN 1993-1-1:2005, table 3.1: steel from 215 MPa; wires 2 GPa. */
  RANGE (LAW, "cohesion", "Pa", 100, 5e7, STRESS),
  RANGE (LAW, "tension", "Pa", 100, 5e7, STRESS),
  RANGE (LAW, "compression", "Pa", 1e4, 1e9, STRESS),
  RANGE (LAW, "yield", "Pa", 1e4, 5e9, STRESS),
  RANGE (LAW, "strength", "Pa", 1e4, 5e9, STRESS),
  RANGE (LAW, "ultimate_strain", "", 1e-4, 0.5, RATIO),
  /* Joints of brick and mortar: 5 to 20 J/m2 in tension, 10 to 250 in shear (R. van der Pluijm, cited by
   * Lourenço 1996, above); concrete 110 to 160 (fib Model Code 2010, 5.1.5.2), crushed a hundred times. */
  RANGE (LAW, "fracture_energy_tension", "J/m2", 0.5, 1e4, ENERGY),
  RANGE (LAW, "fracture_energy_shear", "J/m2", 0.5, 1e5, ENERGY),
  RANGE (LAW, "fracture_energy", "J/m2", 0.5, 1e7, ENERGY),
  RANGE (LAW, "crushing_energy", "J/m2", 50, 1e7, ENERGY),
  [DILATION_END] = RANGE (LAW, "dilation_end", "m", 1e-6, 0.2, LENGTH),
  /* From a model of cards to a barrel vault of 100 m. */
  [MEMBERS] = MEMBER (BLOCK, QnBlock, thickness, "m", 1e-3, 100, LENGTH),
  /* Normal gravity is 9.780 to 9.832 m/s2 (World Geodetic System 1984); often rounded to 10. */
  MEMBER (MODEL, QnModel, gravity, "m/s2", 9.5, 10.5, GRAVITY),
  /* From a wire of 1 mm to a tie of 300 mm. */
  MEMBER (BAR, QnBar, area, "m2", 7e-7, 0.1, AREA),
  MEMBER (TIE, QnTie, area, "m2", 7e-7, 0.1, AREA),
  /* Ropes of fibres from 1 GPa, carbon up to 600 GPa; yield as of laws. */
  MEMBER (TIE, QnTie, elasticity, "Pa", 1e9, 1e12, STIFFNESS),
  MEMBER (TIE, QnTie, yield, "Pa", 1e6, 5e9, STRESS),
  MEMBER (TIE, QnTie, slack, "m", 0, 0.1, LENGTH),
  MEMBER (TIE, QnTie, plate.diameter, "m", 0.02, 3, LENGTH),
  MEMBER (TIE, QnTie, plate.wall, "m", 0.05, 10, LENGTH),
  MEMBER (TIE, QnTie, plate.shear, "Pa", 100, 1e7, STRESS),
  MEMBER (TIE, QnTie, plate.compression, "Pa", 1e4, 1e9, STRESS),
  MEMBER (TIE, QnTie, strip.width, "m", 0.005, 3, LENGTH),
  MEMBER (TIE, QnTie, strip.fracture_energy, "J/m2", 5, 1e4, ENERGY),
  MEMBER (SECTION, QnSection, young, "Pa", 1e7, 1.3e12, STIFFNESS),
  MEMBER (SECTION, QnSection, yield, "Pa", 1e5, 5e9, STRESS),
  MEMBER (SECTION, QnSection, unit_weight, "N/m3", 2500, 1.2e5, UNIT_WEIGHT),
  /* EN 1991-1-1:2002, table 6.2: from 1.5 kN/m2; snow and roofs from 0.4. A live one may be a unit. */
  MEMBER (DEAD_LOAD, QnLoad, pressure, "Pa", 20, 1e7, STRESS),
  MEMBER (LIVE_LOAD, QnLoad, pressure, "Pa", 0.5, 1e7, STRESS),
  /* Expanded clay to ore: EN 1991-1-1:2002, annex A. */
  MEMBER (DEAD_LOAD, QnLoad, unit_weight, "N/m3", 2500, 5e4, UNIT_WEIGHT),
  MEMBER (LIVE_LOAD, QnLoad, unit_weight, "N/m3", 2500, 5e4, UNIT_WEIGHT),
  /* Active in gravel to passive with wall friction (EN 1997-1:2004, annex C). */
  MEMBER (DEAD_LOAD, QnLoad, coefficient, "", 0.05, 30, RATIO),
  MEMBER (LIVE_LOAD, QnLoad, coefficient, "", 0.05, 30, RATIO),
};

#define ROW_COUNT QN_N_ELEMENTS (ranges)

const QnUsualRange *
qn_usual_ranges (size_t *count)
{
  *count = ROW_COUNT;
  return ranges;
}

typedef struct Doubts {
  QnContacts *contacts;
  const QnModel *model;
  double last[ROW_COUNT]; /* the number of a row that was found last */
  int found[ROW_COUNT];
} Doubts;

/* Whether a number lies in the range of its row; `block` is the block concerned, or QN_NONE. */
static void
examine (Doubts *d, Row row, size_t index, QnId block, double value)
{
  const QnUsualRange *range = &ranges[row];
  double size = fabs (value);
  if (size == 0 || !isfinite (size) || (size >= range->least && size <= range->greatest)
      || value == d->last[row] || d->found[row] == MOST_OF_A_ROW)
    return;
  d->last[row] = value;
  d->found[row]++;
  qn_contacts_report (d->contacts, (QnFinding){ .problem = range->doubt,
                                                .block_a = block,
                                                .block_b = QN_NONE,
                                                .at = block != QN_NONE
                                                        ? d->model->blocks[block].centroid
                                                        : qn_vec2 (0, 0),
                                                .value = value,
                                                .subject = (QnId) index,
                                                .range = range });
}

/* The members of an item that have a row. */
static void
examine_members (Doubts *d, QnEntity entity, size_t index, QnId block, const void *item)
{
  for (size_t row = MEMBERS; row < ROW_COUNT; row++)
    if (ranges[row].entity == entity) {
      double value;
      memcpy (&value, (const char *) item + ranges[row].offset, sizeof value);
      examine (d, (Row) row, index, block, value);
    }
}

static void
examine_laws (Doubts *d)
{
  for (size_t i = 0; i < d->model->law_count; i++) {
    const QnLaw *law = &d->model->laws[i];
    size_t count;
    const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
    examine (d, (Row) (KN + law->basis), i, QN_NONE, law->kn);
    examine (d, (Row) (KS + law->basis), i, QN_NONE, law->ks);
    if (qn_law_may_bond (law->kind) && law->tension * law->friction > 0)
      examine (d, APEX, i, QN_NONE,
               fmin (law->tension * law->friction / law->cohesion, 1e9));
    for (size_t k = 0; k < count; k++) {
      double value = qn_law_get (law, &parameters[k]);
      /* A strength in N or an energy in J depends on the size of what it belongs to. */
      for (Row row = FRICTION; row <= DILATION_END; row++)
        if (strcmp (parameters[k].key, ranges[row].key) == 0
            && (law->basis != QN_BASIS_CONTACT || row == FRICTION || row == DILATION_END))
          examine (d, row, i, QN_NONE, value);
    }
  }
}

static double
size_of (QnBox box)
{
  return fmax (box.max.x - box.min.x, box.max.y - box.min.y);
}

/* Returns the largest extent of all, m. A ground that stands for the earth has any size. */
static double
examine_blocks (Doubts *d)
{
  const QnModel *model = d->model;
  QnBox all = QN_BOX_EMPTY;
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    QnBox box = qn_model_block_box (model, (QnId) i);
    qn_box_add_box (&all, box);
    examine (d, block->density >= 0 ? DENSITY : UNIT_WEIGHT, i, (QnId) i,
             block->density >= 0 ? block->density : block->unit_weight);
    examine_members (d, QN_ENTITY_BLOCK, i, (QnId) i, block);
    if (!block->support[QN_DOF_UY])
      examine (d, BLOCK_SIZE, i, (QnId) i, size_of (box));
  }
  if (model->block_count == 0)
    return 0;
  examine (d, EXTENT, 0, QN_NONE, size_of (all));
  return size_of (all);
}

static double
free_weight (const QnModel *model)
{
  double weight = 0;
  for (size_t i = 0; i < model->block_count; i++)
    if (!model->blocks[i].support[QN_DOF_UY])
      weight += model->blocks[i].weight;
  return weight;
}

static void
examine_loads (Doubts *d, double extent)
{
  const QnModel *model = d->model;
  double weight = free_weight (model);
  for (size_t i = 0; i < model->dead_load_count && weight > 0; i++) {
    const QnLoad *load = &model->dead_loads[i];
    double size = qn_vec2_length (load->vector);
    if (load->kind == QN_LOAD_FORCE)
      examine (d, DEAD_FORCE, i, load->block, size / weight);
    else if (load->kind == QN_LOAD_WEIGHT)
      examine (d, DEAD_WEIGHT, i, QN_NONE, size);
    else if (load->kind == QN_LOAD_EDGE)
      examine (d, DEAD_INTENSITY, i, load->block,
               fmax (fabs (load->intensity[0]), fabs (load->intensity[1])));
  }
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad *load = qn_model_load (model, i);
    int live = i >= model->dead_load_count;
    examine_members (d, live ? QN_ENTITY_LIVE_LOAD : QN_ENTITY_DEAD_LOAD,
                     i - (live ? model->dead_load_count : 0), QN_NONE, load);
  }
  for (size_t i = 0; i < model->live_load_count && extent > 0; i++) {
    const QnLoad *load = &model->live_loads[i];
    bool turns = load->dof == QN_DOF_RZ;
    if (load->kind == QN_LOAD_SETTLEMENT)
      examine (d, turns ? TURN : SETTLEMENT, i, load->block,
               load->value / (turns ? 1 : extent));
  }
}

static void
examine_analysis (Doubts *d, double extent)
{
  const QnModel *model = d->model;
  const QnAnalysisSettings *analysis = &model->analysis;
  bool turns = analysis->control.dof == QN_DOF_RZ;
  if (extent > 0
      && (analysis->procedure == QN_PROCEDURE_DISPLACEMENT
          || analysis->procedure == QN_PROCEDURE_ARC_LENGTH))
    examine (d, turns ? TARGET_TURN : TARGET, 0, QN_NONE,
             analysis->control.target / (turns ? 1 : extent));
  if (analysis->procedure != QN_PROCEDURE_DYNAMIC)
    return;
  examine (d, MASS_DAMPING, 0, QN_NONE, analysis->dynamic.mass_damping);
  examine (d, STIFFNESS_DAMPING, 0, QN_NONE, analysis->dynamic.joint_damping);
  for (size_t i = 0; i < model->ground_count; i++) {
    const QnGroundMotion *motion = &model->ground[i];
    double factor = motion->scale * qn_vec2_length (motion->direction), peak = 0;
    if (motion->kind == QN_SIGNAL_PULSE)
      examine (d, PULSE, i, QN_NONE, factor * motion->pulse.amplitude);
    for (size_t k = 0; k < motion->point_count; k++)
      peak = fmax (peak, fabs (motion->points[k].y));
    examine (d, SIGNAL, i, QN_NONE, factor * peak);
  }
}

static void
examine_bars_and_beams (Doubts *d)
{
  const QnModel *model = d->model;
  for (size_t i = 0; i < model->bar_count; i++)
    examine_members (d, QN_ENTITY_BAR, i, QN_NONE, &model->bars[i]);
  const double weight = free_weight (model);
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    examine_members (d, QN_ENTITY_TIE, i, QN_NONE, tie);
    if (weight > 0) {
      examine (d, TIE_PRESTRESS, i, QN_NONE, tie->prestress / weight);
      examine (d, TIE_ANCHOR, i, QN_NONE, tie->anchor / weight);
    }
  }
  for (size_t i = 0; i < model->section_count; i++) {
    const QnSection *section = &model->sections[i];
    examine_members (d, QN_ENTITY_SECTION, i, QN_NONE, section);
    if (section->height > 0) {
      examine (d, SECTION_HEIGHT, i, QN_NONE, section->height);
      examine (d, SECTION_WIDTH, i, QN_NONE, section->width);
    } else {
      examine (d, SECTION_AREA, i, QN_NONE, section->area);
      examine (d, SECTION_INERTIA, i, QN_NONE,
               sqrt (12 * section->inertia / section->area));
    }
  }
}

/* ---- the dead load ---- */

/* Whether the joints of some law carry nothing unless they are pressed together. */
static bool
needs_pressure (const QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++) {
    const QnLaw *law = &model->laws[i];
    if (law->kind == QN_LAW_NO_TENSION
        || (qn_law_may_bond (law->kind) && law->cohesion == 0 && law->tension == 0))
      return true;
  }
  return false;
}

static void
examine_dead_load (Doubts *d)
{
  const QnModel *model = d->model;
  bool any = false;
  for (size_t i = 0; i < model->dead_load_count; i++)
    any |= qn_vec2_length (qn_model_load_resultant (model, i)) > 0;
  if (any || model->live_load_count == 0 || model->block_count < 2 || model->bar_count > 0
      || model->tie_count > 0 || !needs_pressure (model))
    return;
  qn_contacts_tell (d->contacts, QN_PROBLEM_DOUBT_NO_DEAD_LOAD, QN_NONE, QN_NONE, QN_NONE,
                    qn_vec2 (0, 0), 0);
}

/* A face that bears, seen along the dead load. */
typedef struct Bearing {
  double depth; /* of the upper block's centroid along the load */
  QnId upper, lower;
  double stiffness; /* along the load, N/m */
} Bearing;

static int
compare_bearings (const void *a, const void *b)
{
  const Bearing *p = a, *q = b;
  if (p->depth != q->depth)
    return p->depth < q->depth ? -1 : 1;
  return (p->upper > q->upper) - (p->upper < q->upper);
}

/* What every block stands on. */
typedef struct Seat {
  double stiffness, width; /* N/m, m */
  double load;             /* its own and what it got from above, N */
} Seat;

/* Sinking of a block over the allowed sinking; 0: unknown. */
static double
excess_of (const QnModel *model, QnId block, const Seat *seat, double own, QnVec2 down,
           double *sinking)
{
  const bool *support = model->blocks[block].support;
  double height = qn_contacts_block_extent (model, block, down);
  double width = qn_contacts_block_extent (model, block, qn_vec2_perp (down));
  bool lowers = model->analysis.geometry == QN_GEOMETRY_NONLINEAR
                && model->analysis.procedure != QN_PROCEDURE_DYNAMIC;
  if (support[QN_DOF_UX] || support[QN_DOF_UY] || !(seat->stiffness > 0)
      || seat->width < LEAST_BEARING * width)
    return 0;
  *sinking = seat->load / seat->stiffness;
  return fmax (own / seat->stiffness / (OWN_SINKING * height),
               *sinking / ((lowers ? MOST_SINKING : HARMLESS_SINKING) * height));
}

/* Distributes the load of every block, with that from above, to the blocks below by the stiffness of its
 * joints. Reports the block that sinks most if it sinks too far. */
static void
examine_sinking (Doubts *d)
{
  QnContacts *contacts = d->contacts;
  const QnModel *model = d->model;
  /* Sum of the dead loads on weights, as part of the weight. */
  QnVec2 weight = { 0, 0 };
  for (size_t i = 0; i < model->dead_load_count; i++) {
    const QnLoad *load = &model->dead_loads[i];
    if (load->kind == QN_LOAD_WEIGHT)
      weight =
        qn_vec2_add_scaled (weight, qn_model_load_factor (model, load), load->vector);
  }
  double part = qn_vec2_length (weight), sinking = 0, deepest = 0;
  if (!(part > 0) || contacts->face_count == 0)
    return;
  QnVec2 down = qn_vec2_scale (1 / part, weight);
  Bearing *bearings =
    qn_pool_alloc (&contacts->room, contacts->face_count, sizeof *bearings);
  Seat *seats = qn_pool_alloc (&contacts->room, model->block_count, sizeof *seats);
  QnId worst = QN_NONE;
  if (contacts->room.failed)
    return;
  for (size_t i = 0; i < model->block_count; i++)
    seats[i].load = part * model->blocks[i].weight;
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *of = &contacts->faces[i];
    double a = qn_vec2_dot (model->blocks[of->a].centroid, down);
    double b = qn_vec2_dot (model->blocks[of->b].centroid, down);
    Bearing bearing = { fmin (a, b), a <= b ? of->a : of->b, a <= b ? of->b : of->a, 0 };
    double n = qn_vec2_dot (of->normal, down), t = qn_vec2_dot (of->tangent, down);
    for (int32_t k = 0; k < of->pair_count && fabs (n) >= fabs (t); k++) {
      QnPairSprings s =
        qn_contacts_pair_springs (model, contacts, (size_t) (of->first_pair + k));
      double stiffness[2];
      qn_pair_elastic_stiffness (&s, stiffness);
      bearing.stiffness += stiffness[0] * n * n + stiffness[1] * t * t;
    }
    bearings[i] = bearing;
    seats[bearing.upper].stiffness += bearing.stiffness;
    if (bearing.stiffness > 0)
      seats[bearing.upper].width += of->length;
  }
  qsort (bearings, contacts->face_count, sizeof *bearings, compare_bearings);
  for (size_t i = 0; i < contacts->face_count; i++) {
    const Bearing *of = &bearings[i];
    const Seat *seat = &seats[of->upper];
    /* the bearings of a block follow one another */
    double excess =
      i > 0 && of->upper == bearings[i - 1].upper
        ? 0
        : excess_of (model, of->upper, seat, part * model->blocks[of->upper].weight, down,
                     &sinking);
    if (excess > 1 && sinking > deepest) {
      worst = of->upper;
      deepest = sinking;
    }
    if (of->stiffness > 0)
      seats[of->lower].load += seat->load * of->stiffness / seat->stiffness;
  }
  if (worst != QN_NONE)
    qn_contacts_tell (contacts, QN_PROBLEM_DOUBT_SOFT, worst, QN_NONE, QN_NONE,
                      model->blocks[worst].centroid, deepest);
}

/* ---- slivers ---- */

/* Of a long strip its width, m. */
static double
width_of (const QnModel *model, size_t block)
{
  const QnVec2 *v = qn_model_block_vertices (model, (QnId) block);
  const int count = model->blocks[block].vertex_count;
  double perimeter = 0;
  for (int i = 0; i < count; i++)
    perimeter += qn_vec2_length (qn_vec2_sub (v[(i + 1) % count], v[i]));
  return 2 * model->blocks[block].area / perimeter;
}

bool
qn_contacts_find_slivers (const QnModel *model, QnContacts *contacts, QnId **rows,
                          QnId **neighbours)
{
  const size_t n = model->block_count;
  const double unit = model->characteristic_length * model->characteristic_length;
  if (n < 10)
    return false;
  double *sizes = qn_pool_alloc (&contacts->room, n, sizeof *sizes);
  QnId *beside = *neighbours = qn_pool_alloc (&contacts->room, n, sizeof *beside);
  QnId *row = *rows = qn_pool_alloc (&contacts->room, n, sizeof *row);
  size_t count = 0;
  if (contacts->room.failed)
    return false;
  for (size_t i = 0; i < n; i++)
    sizes[i] = width_of (model, i);
  qsort (sizes, n, sizeof *sizes, qn_compare_doubles);
  const double width = sizes[n / 2];
  for (size_t i = 0; i < n; i++) {
    const bool sliver = model->blocks[i].area < SLIVER_AREA * unit
                        && width_of (model, i) < SLIVER_WIDTH * width;
    row[i] = sliver ? (QnId) i : QN_NONE;
    count += sliver;
    sizes[i] = 0; /* from now on the longest face of each */
    beside[i] = QN_NONE;
  }
  if (count == 0 || 10 * count > n)
    return false;
  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    const QnId ends[2] = { face->a, face->b };
    if (row[face->a] != QN_NONE && row[face->b] == face->b)
      row[face->b] = row[face->a];
    for (int k = 0; k < 2; k++) {
      const double part = model->blocks[ends[1 - k]].area > LINTEL_AREA * unit ? 1e-3 : 1;
      if (part * face->length > sizes[ends[k]]) {
        sizes[ends[k]] = part * face->length;
        beside[ends[k]] = ends[1 - k];
      }
    }
  }
  return true;
}

void
qn_contacts_report_doubts (const QnModel *model, QnContacts *contacts)
{
  Doubts d = { .contacts = contacts, .model = model };
  double extent = examine_blocks (&d);
  examine_members (&d, QN_ENTITY_MODEL, 0, QN_NONE, model);
  examine_laws (&d);
  examine_bars_and_beams (&d);
  examine_loads (&d, extent);
  examine_analysis (&d, extent);
  examine_dead_load (&d);
  examine_sinking (&d);
  /* Of slivers side by side the first is told, with their number. */
  QnId *row, *beside;
  const size_t n = model->block_count;
  QnId *counts = qn_pool_alloc (&contacts->room, n, sizeof *counts);
  if (counts == NULL || !qn_contacts_find_slivers (model, contacts, &row, &beside))
    return;
  for (size_t i = 0; i < n; i++)
    if (row[i] != QN_NONE)
      counts[row[i]]++;
  for (size_t i = 0; i < n; i++)
    if (counts[i] > 0)
      qn_contacts_tell (contacts, QN_PROBLEM_BLOCK_SLIVER, (QnId) i, beside[i], counts[i],
                        model->blocks[i].centroid, 0);
}
