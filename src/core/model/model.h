/* The model: everything an analysis needs to know about a structure, in flat arrays.
 *
 * Entities are plain structs in arrays owned by the model and refer to each other by index.
 * A zeroed QnModel is empty and may be cleared. Fill it with the qn_model_add_ functions, then
 * call qn_model_prepare() once: it expands walls into blocks, computes derived geometry and
 * refuses what breaks a rule. Afterwards the model is read-only.
 */
#pragma once

#include "core/base/box.h"
#include "core/base/name-index.h"
#include "core/base/status.h"
#include "core/base/workers.h"
#include "core/law/law.h"
#include "core/model/beam.h"
#include "core/model/ground-motion.h"
#include "core/model/tie.h"
#include "core/model/vehicle.h"

/* Most blocks that one model may have; far above what a plane masonry structure needs, far
 * below what would exhaust a machine. */
#define QN_MAX_BLOCKS 1000000

/* Largest absolute coordinate, m: beyond it double precision leaves less than a tenth of a
 * millimetre. */
#define QN_MAX_COORDINATE 1e12

/* Longest block or opening in a course, in units of the wall; longer ones are typing errors. */
#define QN_MAX_COURSE_LENGTH 1e6

/* Most contact pairs on one face, and how many there are at the abscissae of Gauss and Lobatto. */
#define QN_MAX_PAIRS_PER_FACE  1000
#define QN_LEAST_LOBATTO_PAIRS 3
#define QN_MOST_LOBATTO_PAIRS  9

/* Most pairs that are placed one by one. */
#define QN_MAX_EXPLICIT_PAIRS 32

/* Most sets of loads, that of the live loads included. */
#define QN_MAX_LOAD_SETS 32

/* Most load cases, and most stretches of edges that the loads on them are resolved into. */
#define QN_MAX_LOAD_CASES  1000
#define QN_ACTION_SIZE     24
#define QN_MAX_EDGE_FORCES 500000

/* Most corners of the surface of fill, and most vehicles in a convoy. */
#define QN_MAX_SURFACE_POINTS 24
#define QN_MAX_CONVOY         20

/* Default for fill, Pa/m. */
#define QN_USUAL_SOIL_STIFFNESS 1e7

/* Most stages of one analysis. */
#define QN_MAX_STAGES 1000

/* Largest contact tolerance, relative to the characteristic block length: a larger one would join
 * blocks that are clearly apart. */
#define QN_MAX_CONTACT_TOLERANCE 0.05

/* Entities of a project have a `note`: a number by which the layers above find other members of the
 * file, 0: none. The core copies it with the entity and does not use it. */

/* A rigid block: a simple polygon with three degrees of freedom at its centroid. */
typedef struct QnBlock {
  char *name;         /* owned, unique in the model */
  QnId first_vertex;  /* into QnModel.vertices */
  QnId vertex_count;  /* >= 3, counter-clockwise after qn_model_prepare() */
  double thickness;   /* m, > 0 */
  double unit_weight; /* N/m3, >= 0; follows from density where that was given */
  double density;     /* kg/m3 as given in the file, or < 0 where unit_weight was given */
  bool support[QN_DOF_COUNT]; /* fixed degrees of freedom */
  bool rigid;                 /* its side of a joint by material does not deform */
  QnId law;      /* law of the springs on this block's side, or QN_NONE: contact law */
  int32_t ring;  /* of an arch in several rings, from 1 on inside; 0: none */
  QnId ring_law; /* in place of `law` towards blocks of other rings, or QN_NONE */
  QnId wall;     /* wall that this block came from, or QN_NONE */
  int32_t wall_entry; /* which of the wall's lengths it is */
  QnId masonry; /* parametric object of the layers above that it came from, or QN_NONE */
  int32_t note;

  /* Derived by qn_model_prepare(). */
  double area;         /* m2 */
  QnVec2 centroid;     /* m */
  double polar_moment; /* second moment of area about the centroid, m4 */
  double weight;       /* unit_weight x area x thickness, N */
} QnBlock;

/* A parametric wall, laid course by course from the bottom. */
typedef struct QnWall {
  char *name;         /* owned */
  QnVec2 origin;      /* lower left corner, m */
  QnVec2 unit;        /* length and height of the full block, m */
  double thickness;   /* m */
  double unit_weight; /* N/m3 */
  double density;     /* as in QnBlock */
  QnId law;           /* as in QnBlock */
  double *lengths;    /* owned: all courses one after the other, in multiples of unit.x;
                         negative = opening of that length */
  int32_t
    *course_ends; /* owned: course i is lengths[course_ends[i-1] .. course_ends[i]) */
  int32_t course_count;
  size_t length_capacity, course_capacity;
  int32_t note;
} QnWall;

typedef enum {
  QN_PLACEMENT_DEFAULT, /* by the face's law: ENDS where it counts per pair, else LOBATTO */
  QN_PLACEMENT_ENDS,    /* two pairs, each `offset` away from its end of the face */
  QN_PLACEMENT_LOBATTO, /* `count` pairs at the abscissae of Gauss and Lobatto: the ends and more */
  QN_PLACEMENT_UNIFORM,  /* `count` pairs, each in the middle of its tributary length */
  QN_PLACEMENT_GAUSS,    /* `count` pairs at the abscissae of Gauss and Legendre */
  QN_PLACEMENT_EXPLICIT, /* `count` pairs at `positions` */
  QN_PLACEMENT_COUNT
} QnPlacement;

typedef struct QnPairRule {
  QnPlacement placement;
  double offset; /* m, >= 0, for DEFAULT, ENDS and LOBATTO; stands for rounded corners */
  int32_t
    count; /* >= 1, for all but DEFAULT and ENDS; of LOBATTO 3 to 9, or 0: by the law */
  double
    positions[QN_MAX_EXPLICIT_PAIRS];    /* EXPLICIT: parts of the face's length from its
                                              start, ascending, 0 to 1 */
  double weights[QN_MAX_EXPLICIT_PAIRS]; /* part of the length of each pair; sum 1 */
} QnPairRule;

/* Most corners of a bar between its ends, and most bars of a mesh. */
#define QN_MAX_BAR_CORNERS 30
#define QN_MAX_MESH_BARS   10000

/* A reinforcing bar: a line that makes a pair of its own, with its own law and section, on every
 * contact face that it crosses; or a mesh of them (core/model/bar.h). */
typedef struct QnBar {
  QnId law;
  double area;                    /* of each bar, m2, > 0 */
  QnVec2 start, end;              /* of a mesh: two opposite corners of its rectangle */
  QnVec2 via[QN_MAX_BAR_CORNERS]; /* corners on the way; not of a mesh */
  int32_t via_count;
  QnVec2
    spacing; /* of a mesh: of its upright bars and of its level ones, m, >= 0; 0: none
                     of these, both 0: no mesh */
  int32_t note;
} QnBar;

/* Exception for the faces between two given blocks. */
typedef struct QnFaceOverride {
  QnId block_a, block_b;
  QnId law;       /* or QN_NONE: unchanged */
  bool has_pairs; /* whether `pairs` replaces the general rule */
  QnPairRule pairs;
  int32_t note;
} QnFaceOverride;

typedef struct QnContactSettings {
  QnId law;         /* law of every spring that has no other */
  double tolerance; /* relative to the model's characteristic block length */
  QnPairRule pairs;
} QnContactSettings;

typedef enum {
  QN_LOAD_WEIGHT,     /* on every block and beam: weight x direction */
  QN_LOAD_FORCE,      /* on one block: force and moment */
  QN_LOAD_SETTLEMENT, /* of one fixed degree of freedom of one block */
  QN_LOAD_LINE,       /* on one beam: force per undeformed length */
  QN_LOAD_EDGE,       /* on a chain of edges of one block: force per length */
  QN_LOAD_SURCHARGE,  /* downwards on edges seen from above: pressure, weight of fill */
  QN_LOAD_BACKFILL,   /* earth pressure on edges seen from one side */
  QN_LOAD_FILL,       /* weight and pressure of soil below a surface */
  QN_LOAD_VEHICLE,    /* a vehicle, spread through the fill below it */
  QN_LOAD_NODE,       /* force and moment on one node */
  QN_LOAD_KIND_COUNT
} QnLoadKind;

/* How the coefficient K of earth pressure is found. */
typedef enum {
  QN_EARTH_GIVEN,   /* as a number */
  QN_EARTH_AT_REST, /* K0 = 1 - sin phi (Jaky 1944) */
  QN_EARTH_ACTIVE,  /* Ka = (1 - sin phi) / (1 + sin phi) (Rankine 1857) */
  QN_EARTH_COUNT
} QnEarth;

/* Dead loads act from the start. The others belong to a set that grows with a multiplier: the
 * live loads are set 0, sets with names follow (QnModel.load_sets). */
typedef struct QnLoad {
  QnLoadKind kind;
  int32_t set;       /* of loads that are not dead: 0 = live */
  int32_t load_case; /* 0: none, factor 1; i: QnModel.load_cases[i - 1] */
  QnVec2 vector;     /* WEIGHT: direction of any length (1 = one weight); FORCE, NODE: N;
                    LINE: N/m; EDGE: direction, which multiplies the intensity */
  QnId block;        /* FORCE, SETTLEMENT and EDGE */
  QnId node;         /* NODE */
  QnId beam;         /* LINE */
  double moment;     /* N m about the point of application; FORCE, NODE */
  bool has_at;       /* FORCE: whether `at` is given; the centroid otherwise */
  QnVec2 at;         /* m */
  QnDof dof;         /* SETTLEMENT: which degree of freedom */
  double value;      /* SETTLEMENT: how far at multiplier 1, m or rad */

  /* EDGE: a chain of edges, counter-clockwise; edge i goes from vertex i to the next one. */
  bool has_side;   /* the straight part of the outline that faces `side` most; */
  QnId edge;       /* else the first of */
  QnId edge_count; /* so many edges */
  double part[2]; /* of the chain's length, from its start: 0 <= part[0] < part[1] <= 1 */
  double intensity[2]; /* at both ends of that part, linear between, N/m */
  bool normal; /* whether it pushes at right angles into the block; `vector` otherwise */

  QnBlockSide side; /* EDGE; BACKFILL: left or right, where the soil is */
  double span[2];  /* SURCHARGE: from x to x; BACKFILL: from y to y, m; may be infinite */
  double pressure; /* SURCHARGE, BACKFILL: on the fill's surface, Pa, >= 0 */
  double unit_weight; /* of the fill, N/m3, >= 0 */
  double level;       /* SURCHARGE: of the fill's surface, m */
  QnEarth earth;      /* BACKFILL: where K comes from: */
  double coefficient; /* GIVEN: K, >= 0 */
  double
    friction_angle; /* of the soil, rad, 0 to pi/2; FILL: 0: it presses downwards alone */

  /* FILL: below the surface that these points give from left to right, on what is seen from above. With
   * a friction angle also active pressure on the upright projection of its edges, and soil ties
   * (core/model/soil.h) where it is mobilised. span[0]: its lower end on upright faces. */
  QnVec2 surface[QN_MAX_SURFACE_POINTS];
  int32_t surface_count; /* >= 2 */
  double mobilisation;   /* part of the passive coefficient that is reached, 0 to 1 */
  double stiffness;      /* of the soil against what moves into it, Pa/m, > 0 */

  /* VEHICLE: on the first fill among the dead loads that lies below, or on the blocks. */
  QnId vehicle;
  double position; /* x of its front, m */
  bool reversed;   /* it goes to the left, its axles stand to the right of the front */
  int32_t convoy;  /* so many behind each other, >= 1; */
  double headway;  /* m from the end of one to the front of the next */
  int32_t beside;  /* computed: axles with neither fill nor blocks below them */
  QnDispersal dispersal;
  double width; /* of the structure, m: no load spreads over more; 0: not limited */
  double
    effective; /* m: width across that carries an axle at any depth; 0: by `dispersal` */
  int32_t note;
} QnLoad;

/* Loads of one origin, which a factor multiplies: permanent, traffic, … */
typedef struct QnLoadCase {
  char *name;                  /* owned, unique among cases */
  double factor;               /* >= 0 */
  char action[QN_ACTION_SIZE]; /* kind of action in a code; "": the same in all
                                  combinations. The layers above know the names */
} QnLoadCase;

/* Code for combinations of load cases, and partial factors of strengths. */
typedef struct QnCombinationRules {
  char code[QN_ACTION_SIZE]; /* "": none */
  double friction, strength; /* > 0: of coefficients of friction, of bonds and crushing */
  double seismic_friction, seismic_strength; /* the same with seismic actions */
} QnCombinationRules;

/* A stretch of an edge that carries a load of one direction, linear along it and nowhere of the
 * other sign. Its resultant acts at one point of the rigid block: Q = L (q0 + q1) / 2 at the part
 * (q0 + 2 q1) / (3 (q0 + q1)) of the stretch. So one force at one point replaces it, in large
 * displacements too, where it keeps its direction and moves with the block. */
typedef struct QnEdgeForce {
  size_t source; /* load, counted through the dead and then the live loads */
  QnId block;
  QnVec2 ends[2];      /* of the stretch, m */
  QnVec2 intensity[2]; /* at them, N/m, without the factor of the case */
  QnVec2 force;        /* resultant, N, */
  QnVec2 at;           /* and its point, m */
} QnEdgeForce;

typedef enum {
  QN_PROCEDURE_LOAD,
  QN_PROCEDURE_DISPLACEMENT,
  QN_PROCEDURE_WORK,
  QN_PROCEDURE_ARC_LENGTH,
  QN_PROCEDURE_LIMIT,
  QN_PROCEDURE_DYNAMIC, /* through time, under ground motion */
  QN_PROCEDURE_COUNT
} QnProcedure;

typedef enum { QN_GEOMETRY_LINEAR, QN_GEOMETRY_NONLINEAR, QN_GEOMETRY_COUNT } QnGeometry;

/* At a limit point of the path: jump to the equilibrium beyond it, or stop there. */
typedef enum {
  QN_SNAP_THROUGH_JUMP,
  QN_SNAP_THROUGH_STOP,
  QN_SNAP_THROUGH_COUNT
} QnSnapThrough;

typedef enum { QN_FLOW_ASSOCIATIVE, QN_FLOW_NON_ASSOCIATIVE, QN_FLOW_COUNT } QnFlow;

/* Whether limit analysis computes the associative bound of a path that ends in collapse. */
typedef enum {
  QN_BOUND_AUTO, /* where that takes little: up to QN_BOUND_PAIRS contact pairs */
  QN_BOUND_ALWAYS,
  QN_BOUND_NEVER,
  QN_BOUND_CHOICE_COUNT
} QnBoundChoice;

/* A linear program of so many pairs takes about a second, and less than a quarter of the path. */
#define QN_BOUND_PAIRS 5000

/* Factorisations that an analysis may need unless its settings say otherwise: fifteen times what the
 * longest of the examples needs. */
#define QN_MAX_FACTORIZATIONS 50000

/* What is prescribed, or shown: a displacement of a block, or of a node that stands free; of neither: nothing. */
typedef struct QnControl {
  QnId block, node; /* or QN_NONE; at most one of both */
  QnDof dof;
  double target; /* m or rad; of a stage as a total, and 0 too */
} QnControl;

typedef struct QnAnalysisSettings {
  QnProcedure procedure;
  QnGeometry geometry;
  QnSnapThrough snap;
  QnFlow flow;           /* for QN_PROCEDURE_LIMIT; default associative */
  int32_t increments;    /* >= 1; the first increment of the multiplier is 1/increments */
  double max_multiplier; /* >= 0; 0: the dead load alone; INFINITY by default */
  double multiplier_tolerance; /* relative to the multiplier; default 1e-4 */
  double residual_tolerance;   /* relative to the forces in the model; default 1e-8 */
  int32_t
    max_factorizations; /* >= 1, of a stage in the mean; beyond, the analysis ends as not
                                  converged */
  double max_seconds;   /* > 0; likewise; INFINITY by default */
  QnBoundChoice bound;  /* whether a path's collapse gets its associative bound */
  QnControl control;
  bool
    follow; /* contacts follow the blocks along a path, in nonlinear geometry; this is done by
                  core/path/path.c */
  QnDynamicSettings dynamic; /* for QN_PROCEDURE_DYNAMIC */
  /* Of the run, not of the project: */
  bool all_forces;          /* see QN_RESULT_FORCE_BUDGET */
  const QnWorkers *workers; /* borrowed; NULL: everything in the caller's thread */
} QnAnalysisSettings;

/* A stage of loading: its sets go from the multiplier that they stand at to another one while all
 * others are held. Slip, yield and cracks of joints and members carry over from stage to stage.
 * Settings that a stage does not have are those of the analysis. */
typedef struct QnStage {
  char *name;    /* owned; may be NULL */
  uint32_t sets; /* bit i: set i is driven */
  QnProcedure procedure;
  int32_t increments; /* 0: as the analysis says */
  bool has_target;    /* whether the stage ends at a multiplier, */
  double target;      /* this one; any sign */
  QnControl control;
  int32_t
    leg; /* from 1, of a cyclic protocol: each of its cycles is three stages, there, to the other side, and
                  back to 0; 0: of none */
  int32_t note;
} QnStage;

/* Stages of a cycle. */
#define QN_CYCLE_LEGS 3

/* The cycle that a stage belongs to, from 1; 0: none. */
static inline int32_t
qn_stage_cycle (const QnStage *stage)
{
  return (stage->leg + QN_CYCLE_LEGS - 1) / QN_CYCLE_LEGS;
}

typedef struct QnModel {
  char *title;    /* owned, may be NULL */
  double gravity; /* m/s2 */

  QnVec2 *vertices;
  size_t vertex_count, vertex_capacity;
  QnLaw *laws;
  size_t law_count, law_capacity;
  QnBlock *blocks; /* those of the file first, then those of the walls in order */
  size_t block_count, block_capacity;
  QnNameIndex law_names, block_names;
  QnNode
    *nodes; /* those of the file first, then those that cut the beams, beam by beam */
  size_t node_count, node_capacity;
  QnSection *sections;
  size_t section_count, section_capacity;
  QnBeam *beams;
  size_t beam_count, beam_capacity;
  QnBeamElement *elements; /* beam by beam */
  size_t element_count, element_capacity;
  size_t expanded_beam_count; /* beams whose elements are in `elements` already */
  QnNameIndex node_names, section_names, beam_names;
  QnWall *walls;
  size_t wall_count, wall_capacity;
  size_t expanded_wall_count; /* walls whose blocks are in `blocks` already */
  QnFaceOverride *overrides;
  size_t override_count, override_capacity;
  QnBar *bars;
  size_t bar_count, bar_capacity;
  QnTie *ties;
  size_t tie_count, tie_capacity;
  QnTie *soil_ties; /* derived; see core/model/soil.h */
  size_t soil_tie_count, soil_tie_capacity;
  QnVehicle *vehicles;
  size_t vehicle_count, vehicle_capacity;
  QnNameIndex tie_names;
  QnLoad *dead_loads;
  size_t dead_load_count, dead_load_capacity;
  QnLoad *live_loads; /* those of all sets */
  size_t live_load_count, live_load_capacity;
  char **load_sets; /* owned names of set 1, 2, … */
  size_t load_set_count, load_set_capacity;
  QnLoadCase *load_cases;
  size_t load_case_count, load_case_capacity;
  QnCombinationRules combinations;
  QnEdgeForce *edge_forces; /* derived, load by load */
  size_t edge_force_count, edge_force_capacity;
  QnStage *stages; /* none: the live loads in one go */
  size_t stage_count, stage_capacity;
  QnGroundMotion *ground; /* this and what follows: for QN_PROCEDURE_DYNAMIC */
  size_t ground_count, ground_capacity;
  QnInitialMotion *initial;
  size_t initial_count, initial_capacity;
  QnTrack *tracks;
  size_t track_count, track_capacity;

  QnContactSettings contact;
  QnAnalysisSettings analysis;

  double
    characteristic_length; /* median of the square roots of the block areas, m; derived */
} QnModel;

/* An empty model with the defaults of the project file format. */
void qn_model_init (QnModel *model);

/* Frees everything the model owns and leaves it zeroed. */
void qn_model_clear (QnModel *model);

/* Deep copy, prepared if `source` is. `copy` is overwritten without being cleared. */
QnStatus qn_model_copy (const QnModel *source, QnModel *copy, QnDiag *diag);

/* Adds an item with a copy of its name (nullable; items of some lists have none) to the list at this place
 * of QnModel: a pointer to it, valid until the next one is added, or NULL when memory runs out. It is zeroed
 * but for these: both ends of a tie are on the ground. A block or wall has law = wall = masonry = QN_NONE and
 * density = -1; a node stands free; a section has density = -1, shear_factor = 5/6; a beam is a Timoshenko
 * beam of one element; a ground motion has scale 1 and no points. */
void *qn_model_add_item (QnModel *model, size_t items, const char *name);

#define QN_ADD(model, type, items, name)                                                 \
  ((type *) qn_model_add_item (model, offsetof (QnModel, items), name))
#define qn_model_add_law(model, name)      QN_ADD (model, QnLaw, laws, name)
#define qn_model_add_wall(model, name)     QN_ADD (model, QnWall, walls, name)
#define qn_model_add_override(model)       QN_ADD (model, QnFaceOverride, overrides, NULL)
#define qn_model_add_node(model, name)     QN_ADD (model, QnNode, nodes, name)
#define qn_model_add_section(model, name)  QN_ADD (model, QnSection, sections, name)
#define qn_model_add_beam(model, name)     QN_ADD (model, QnBeam, beams, name)
#define qn_model_add_bar(model)            QN_ADD (model, QnBar, bars, NULL)
#define qn_model_add_tie(model, name)      QN_ADD (model, QnTie, ties, name)
#define qn_model_add_vehicle(model, name)  QN_ADD (model, QnVehicle, vehicles, name)
#define qn_model_add_dead_load(model)      QN_ADD (model, QnLoad, dead_loads, NULL)
#define qn_model_add_live_load(model)      QN_ADD (model, QnLoad, live_loads, NULL)
#define qn_model_add_stage(model, name)    QN_ADD (model, QnStage, stages, name)
#define qn_model_add_ground_motion(model)  QN_ADD (model, QnGroundMotion, ground, NULL)
#define qn_model_add_initial_motion(model) QN_ADD (model, QnInitialMotion, initial, NULL)
#define qn_model_add_track(model)          QN_ADD (model, QnTrack, tracks, NULL)

QnBlock *qn_model_add_block (QnModel *model, const char *name, const QnVec2 *vertices,
                             size_t vertex_count);

/* False when memory runs out. */
bool qn_ground_motion_add_point (QnGroundMotion *motion, double time,
                                 double acceleration);
/* End of an analysis in time, s: the duration of its settings, or the end of the last ground motion; 0: not
 * known, because a record has not been read. */
double qn_model_duration (const QnModel *model);

/* Checks the points of one ground motion: two or more, finite, times ascending from 0 or later. */
QnStatus qn_model_check_signal (const QnModel *model, QnId ground, QnDiag *diag);

/* Checks that the duration, known once all points are there, has not too many steps. */
QnStatus qn_model_check_steps (const QnModel *model, QnDiag *diag);

/* Number of the load set with this name, added where there is none; "live" is 0. QN_NONE where
 * memory runs out or QN_MAX_LOAD_SETS are there already. */
int32_t qn_model_add_load_set (QnModel *model, const char *name);

/* The same without adding: QN_NONE where there is none. */
int32_t qn_model_find_load_set (const QnModel *model, const char *name);

/* Name of a load set, "live" for 0. */
const char *qn_model_load_set_name (const QnModel *model, int32_t set);

/* Index of the load case with this name, from 1 as in QnLoad.load_case, added with factor 1 where
 * there is none; QN_NONE where memory runs out or QN_MAX_LOAD_CASES are there already. */
int32_t qn_model_add_load_case (QnModel *model, const char *name);

/* The same without adding: QN_NONE where there is none. */
int32_t qn_model_find_load_case (const QnModel *model, const char *name);

/* x, m, of a place `behind` the front of vehicle n (from 0) of the convoy of a VEHICLE. */
double qn_load_behind_front (const QnModel *model, const QnLoad *load, int32_t n,
                             double behind);
/* The height of a FILL's surface at x; NAN where it has none. */
double qn_load_surface_at (const QnLoad *load, double x);

/* The chain of edges that an EDGE load is on. */
void qn_load_chain (const QnModel *model, const QnLoad *load, QnId *first, QnId *count);

/* K of a BACKFILL. */
double qn_load_earth_coefficient (const QnLoad *load);
/* K0 = 1 - sin phi (Jaky 1944); Ka = (1 - sin phi)/(1 + sin phi), level soil (Rankine 1857). */
double qn_earth_at_rest (double friction_angle);
double qn_earth_active (double friction_angle);

/* Appends a course to a wall; false when memory runs out. */
bool qn_wall_add_course (QnWall *wall, const double *lengths, size_t count);

/* Turns the walls that are not yet expanded into blocks named `<wall>.<course>.<position>`,
 * both counted from 1, openings not counted. Afterwards loads and overrides can refer to them
 * by index. qn_model_prepare() does it too; call it first to look up such names.
 * More than QN_MAX_BLOCKS are refused before anything is allocated. */
QnStatus qn_model_expand_walls (QnModel *model, QnDiag *diag);

/* Cuts the beams that are not yet expanded into elements, at nodes named `<beam>.<n>`, n from
 * 1. Afterwards loads can refer to those nodes by index; where they are follows in
 * qn_model_prepare(). */
QnStatus qn_model_expand_beams (QnModel *model, QnDiag *diag);

/* Index of the item with this name in the list at this place of QnModel, or QN_NONE; of equal names the
 * first, in constant time but for vehicles, load sets and cases. A name must not be changed behind the
 * model's back. */
QnId qn_model_find_item (const QnModel *model, size_t items, const char *name);

/* The name of an item of a list of named ones, or NULL where the list has no such item. */
const char *qn_model_item_name (const QnModel *model, size_t items, QnId index);

#define QN_FIND(model, items, name)                                                      \
  qn_model_find_item (model, offsetof (QnModel, items), name)
#define qn_model_find_law(model, name)     QN_FIND (model, laws, name)
#define qn_model_find_block(model, name)   QN_FIND (model, blocks, name)
#define qn_model_find_node(model, name)    QN_FIND (model, nodes, name)
#define qn_model_find_section(model, name) QN_FIND (model, sections, name)
#define qn_model_find_beam(model, name)    QN_FIND (model, beams, name)
#define qn_model_find_tie(model, name)     QN_FIND (model, ties, name)
#define qn_model_find_vehicle(model, name) QN_FIND (model, vehicles, name)

/* Expands walls, orients polygons counter-clockwise, computes areas, centroids and weights,
 * and checks every number and reference that can be checked without contacts. The first
 * problem found is reported; the model may only be cleared then. A model without blocks and beams
 * is legal; qn_contacts_require_sound() refuses to analyse it. */
QnStatus qn_model_prepare (QnModel *model, QnDiag *diag);

/* Ties as analyses take them: those of the project, then those of soil. */
static inline size_t
qn_model_tie_count (const QnModel *model)
{
  return model->tie_count + model->soil_tie_count;
}

static inline const QnTie *
qn_model_tie (const QnModel *model, size_t index)
{
  return index < model->tie_count ? &model->ties[index]
                                  : &model->soil_ties[index - model->tie_count];
}

/* Bodies: the blocks, then the nodes. A node on a block has no unknowns; its row of displacements follows from
 * the block's. */
static inline size_t
qn_model_body_count (const QnModel *model)
{
  return model->block_count + model->node_count;
}

/* The body whose degrees of freedom move a node: its block, or itself. */
static inline size_t
qn_model_node_body (const QnModel *model, QnId node)
{
  QnId block = model->nodes[node].block;
  return block != QN_NONE ? (size_t) block : model->block_count + (size_t) node;
}

/* Length of the undeformed beam, m. */
static inline double
qn_model_beam_length (const QnModel *model, QnId beam)
{
  const QnId *nodes = model->beams[beam].nodes;
  return qn_vec2_length (
    qn_vec2_sub (model->nodes[nodes[1]].at, model->nodes[nodes[0]].at));
}

static inline bool
qn_control_is_given (const QnControl *control)
{
  return control->block != QN_NONE || control->node != QN_NONE;
}

/* As files and pictures name them: "ux". */
extern const char *const qn_dof_names[QN_DOF_COUNT];

/* The body that a control names, by block or by node; SIZE_MAX where it names neither. */
static inline size_t
qn_model_controlled_body (const QnModel *model, const QnControl *control)
{
  if (control->node != QN_NONE)
    return model->block_count + (size_t) control->node;
  return control->block != QN_NONE ? (size_t) control->block : SIZE_MAX;
}

/* Displayed displacement of an analysis in time: the first track, else the controlled displacement, else ux of
 * the highest block free in x; *body = SIZE_MAX: none. */
void qn_model_followed (const QnModel *model, size_t *body, QnDof *dof);

/* Factorisations that an analysis may take. */
int64_t qn_model_most_factorizations (const QnModel *model);

/* Where a point of a block as drawn lies after displacements (rows ux, uy, rz of all bodies), with
 * finite rotation; and the point of the block as drawn that lies at a place. */
static inline QnVec2
qn_block_place (const QnModel *model, QnId block, const double *displacements,
                QnVec2 point)
{
  const double *u = displacements + QN_DOF_COUNT * block;
  QnVec2 centroid = model->blocks[block].centroid;
  QnVec2 arm = qn_vec2_rotate (qn_vec2_sub (point, centroid), cos (u[QN_DOF_RZ]),
                               sin (u[QN_DOF_RZ]));

  return qn_vec2_add (qn_vec2_add (centroid, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY])), arm);
}

static inline QnVec2
qn_block_unplace (const QnModel *model, QnId block, const double *displacements,
                  QnVec2 place)
{
  const double *u = displacements + QN_DOF_COUNT * block;
  QnVec2 centroid = model->blocks[block].centroid;
  QnVec2 moved = qn_vec2_add (centroid, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]));

  return qn_vec2_add (centroid, qn_vec2_rotate (qn_vec2_sub (place, moved),
                                                cos (u[QN_DOF_RZ]), -sin (u[QN_DOF_RZ])));
}

/* Velocity at an arm r from a body's centroid: v + rz x r; rows of three. */
static inline void
qn_body_velocity_at (const double body[3], QnVec2 arm, double out[3])
{
  out[QN_DOF_UX] = body[QN_DOF_UX] - arm.y * body[QN_DOF_RZ];
  out[QN_DOF_UY] = body[QN_DOF_UY] + arm.x * body[QN_DOF_RZ];
  out[QN_DOF_RZ] = body[QN_DOF_RZ];
}

/* Fills in the rows of riding nodes in displacements of bodies (body_count x 3) from those of
 * their blocks: by finite rotations, or linearly. */
void qn_model_move_riding_nodes (const QnModel *model, bool finite,
                                 double *displacements);

/* Whether a block or node is held: in all degrees of freedom; in one of them at least. */
static inline bool
qn_support_is_full (const bool support[QN_DOF_COUNT])
{
  return support[QN_DOF_UX] && support[QN_DOF_UY] && support[QN_DOF_RZ];
}

static inline bool
qn_support_is_any (const bool support[QN_DOF_COUNT])
{
  return support[QN_DOF_UX] || support[QN_DOF_UY] || support[QN_DOF_RZ];
}

/* Whether a degree of freedom of a body is fixed, or moved by that of another body. */
bool qn_model_body_is_fixed (const QnModel *model, size_t body, QnDof dof);

/* The dead loads and those of all sets. */
static inline size_t
qn_model_load_count (const QnModel *model)
{
  return model->dead_load_count + model->live_load_count;
}

/* Loads as analyses take them: the dead ones, the live ones, then the forces that loads on edges
 * come to, each times the factor of its case. Dead ones have the set QN_NONE. The model must be
 * prepared; index < qn_model_acting_count(). */
static inline size_t
qn_model_acting_count (const QnModel *model)
{
  return qn_model_load_count (model) + model->edge_force_count;
}

QnLoad qn_model_acting_load (const QnModel *model, size_t index);

/* The load that an acting one comes from, counted through the dead and then the live loads. */
size_t qn_model_acting_source (const QnModel *model, size_t index);

/* The edge forces of one load: *count of them from the returned one on. */
const QnEdgeForce *qn_model_edge_forces_of (const QnModel *model, size_t source,
                                            size_t *count);

/* The dead loads, or those of all sets; *count (nullable): their number. */
static inline QnLoad *
qn_model_loads (const QnModel *model, bool live, size_t *count)
{
  if (count != NULL)
    *count = live ? model->live_load_count : model->dead_load_count;
  return live ? model->live_loads : model->dead_loads;
}

/* One of the loads, counted through the dead and then the live ones; its factor. */
QnLoad *qn_model_load (const QnModel *model, size_t source);
double qn_model_load_factor (const QnModel *model, const QnLoad *load);

/* Whether a load is resolved into forces on edges. */
static inline bool
qn_load_is_on_edges (QnLoadKind kind)
{
  return kind == QN_LOAD_EDGE || kind == QN_LOAD_SURCHARGE || kind == QN_LOAD_BACKFILL
         || kind == QN_LOAD_FILL || kind == QN_LOAD_VEHICLE;
}

/* The force that one load (counted likewise) exerts on the structure as a whole, its factor
 * included, N: on fixed blocks and along beams too; {0, 0} of settlements. */
QnVec2 qn_model_load_resultant (const QnModel *model, size_t source);

/* Resultant on every body of the loads of all sets, each times its own factor (factors: QN_MAX_LOAD_SETS),
 * or of the dead loads where `factors` is NULL; of the live loads (set 0). Without loads distributed over
 * beams. Settlements are no forces.
 *
 * forces: body_count x 3: fx, fy in N and the moment about centroid or node in N m. Loads on
 * riding nodes count as the block's. */
void qn_model_set_forces (const QnModel *model, const double *factors, double *forces);
void qn_model_live_forces (const QnModel *model, double *forces);

/* Whether there is a force or a weight among the loads of some sets, bit by bit as in QnStage.
 * Sets of settlements alone go as far as their values say, to multiplier 1. */
bool qn_model_sets_have_force (const QnModel *model, uint32_t sets);

/* Whether some law has a bond that may break. */
bool qn_model_has_bonds (const QnModel *model);

/* Whether joints slide with less dilatancy than friction. */
bool qn_model_is_non_associative (const QnModel *model);

/* The body that a FORCE or a NODE load acts on, and the arm from its centroid. */
size_t qn_model_load_body (const QnModel *model, const QnLoad *load);
QnVec2 qn_model_load_arm (const QnModel *model, const QnLoad *load);

/* Load distributed over every element, in the axes of the model: element_count vectors, N/m of
 * undeformed length. Loads of all sets, each times its own factor; or the dead loads where
 * `factors` is NULL. */
void qn_model_element_loads (const QnModel *model, const double *factors, QnVec2 *loads);

/* Law of the springs on a block's side of its joints with another block. */
static inline QnId
qn_model_side_law (const QnModel *model, QnId block, QnId other)
{
  const QnBlock *b = &model->blocks[block], *o = &model->blocks[other];
  bool rings = b->ring > 0 && o->ring > 0 && b->ring != o->ring;
  QnId own = rings && b->ring_law != QN_NONE ? b->ring_law : b->law;

  return own != QN_NONE ? own : model->contact.law;
}

/* Copies all of a block but name, shape, origin and note. */
static inline void
qn_block_inherit (QnBlock *block, const QnBlock *from)
{
  block->thickness = from->thickness;
  block->unit_weight = from->unit_weight;
  block->density = from->density;
  block->law = from->law;
  block->ring = from->ring;
  block->ring_law = from->ring_law;
  block->rigid = from->rigid;
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    block->support[dof] = from->support[dof];
}

/* Vertices of a block. */
static inline const QnVec2 *
qn_model_block_vertices (const QnModel *model, QnId block)
{
  return model->vertices + model->blocks[block].first_vertex;
}

/* The block from `first` on, of masonry alone if asked, in which a point lies deepest, or that it is nearest
 * to, and its depth (qn_polygon_depth()). QN_NONE and -INFINITY without one. */
QnId qn_model_deepest_block (const QnModel *model, QnId first, bool masonry, QnVec2 at,
                             double *depth);

/* Whether weights depend on gravity. */
bool qn_model_has_density (const QnModel *model);

/* The box around a block. */
static inline QnBox
qn_model_block_box (const QnModel *model, QnId block)
{
  return qn_box_of_points (qn_model_block_vertices (model, block),
                           (size_t) model->blocks[block].vertex_count);
}
