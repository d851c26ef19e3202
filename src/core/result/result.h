/* Result of an analysis: the path of converged equilibria and how it ended. */
#pragma once

#include "core/contact/contact-pair.h"
#include "core/contact/contacts.h"
#include "core/result/fault.h"

typedef enum {
  QN_OUTCOME_COLLAPSE,           /* no equilibrium beyond collapse_multiplier */
  QN_OUTCOME_TARGET_REACHED,     /* max_multiplier or the control target was reached */
  QN_OUTCOME_SNAP,               /* stopped at a limit point, as asked */
  QN_OUTCOME_UNBOUNDED,          /* no multiplier is too large */
  QN_OUTCOME_DEAD_LOAD_UNSTABLE, /* no equilibrium under the dead load */
  QN_OUTCOME_CANCELLED,
  QN_OUTCOME_NOT_CONVERGED,
  QN_OUTCOME_REST, /* in time: nothing moves any more after the ground has stopped */
  QN_OUTCOME_COUNT
} QnOutcome;

/* Why a path of displacement, work or arc-length control ended where it did. */
typedef enum {
  QN_STOP_UNKNOWN,        /* another procedure: see the outcome */
  QN_STOP_DISPLACEMENT,   /* the controlled displacement came to its target */
  QN_STOP_MULTIPLIER,     /* max_multiplier was reached */
  QN_STOP_ZERO,           /* the multiplier fell back to zero */
  QN_STOP_PLATEAU,        /* the multiplier was constant while the motion grew */
  QN_STOP_FALL,           /* parts fall although the measure is held */
  QN_STOP_LIMIT_POINT,    /* peak or jump, and the settings ask to stop there */
  QN_STOP_STEP_TOO_SMALL, /* no equilibrium within the smallest step */
  QN_STOP_STEPS,          /* more steps than a path may have */
  QN_STOP_FACTORIZATIONS, /* of any procedure: max_factorizations */
  QN_STOP_TIME,           /* of any procedure: max_seconds */
  QN_STOP_CHECK,          /* of any procedure: the result is not true (core/check) */
  QN_STOP_CANCELLED,
  QN_STOP_COUNT
} QnStop;

typedef enum { QN_EVENT_NONE, QN_EVENT_SNAP, QN_EVENT_COLLAPSE, QN_EVENT_COUNT } QnEvent;

/* Events on a path under a growing load. */
typedef enum {
  QN_EVENT_KIND_LOCAL, /* a jump of less than 5 % of the displacement */
  QN_EVENT_KIND_SNAP,  /* a larger one */
  QN_EVENT_KIND_BUCKLING, /* the branch loses its stability, and the path continues on another one: no
                             jump, no energy */
  QN_EVENT_KIND_COLLAPSE, /* the path does not climb above this multiplier again */
  QN_EVENT_KIND_COUNT
} QnEventKind;

/* A jump as a part of the displacement that it ends with: from the first part on it is a snap,
 * below the second it is not reported. */
#define QN_JUMP_SNAP  0.05
#define QN_JUMP_LEAST 0.005

/* Blocks that move by this part of the largest motion take part in an event. */
#define QN_TAKES_PART 0.1

typedef struct QnPathEvent {
  QnEventKind kind;
  int32_t stage; /* as of QnStep */
  double multiplier;
  /* Largest since the dead load, m; COLLAPSE: `after` is the end of the followed motion. */
  double displacement_before, displacement_after;
  double energy; /* set free, J */
  QnId *blocks;  /* moving blocks, ascending */
  size_t block_count;
} QnPathEvent;

/* One converged equilibrium. The first step is the dead load alone, multiplier 0. The multiplier is that of
 * the load sets driven by the stage. */
typedef struct QnStep {
  double multiplier;
  int32_t iterations; /* spent on this step */
  double residual;    /* out-of-balance relative to the forces in the model */
  QnEvent event; /* SNAP: the first equilibrium after a jump; COLLAPSE: the last one */
  int32_t
    stage;     /* number of the stage it belongs to, from 1; 0: dead load, or no stages */
  double time; /* s, of an analysis in time; 0 otherwise */
  /* The forces do not follow from the last step by one evaluation of the laws: joints slid during a motion
   * that came to rest here, or forces of the central path were kept, equal to the laws' to 1/1000. */
  bool relaxed;
} QnStep;

/* Energy of an analysis in time, J, in the frame that moves with the ground. At any time
 *
 *   INPUT = KINETIC + ELASTIC + FRICTION + DAMPING + NUMERICAL + error of the balance
 *
 * INPUT: energy at the start, plus work of the ground (on the masses) and of the dead loads. ELASTIC: stored
 * in joints and beams, including that of the dead load. FRICTION: lost by slip, dilatancy, plastic
 * deformation and replaced contacts. DAMPING: lost in dashpots. NUMERICAL: dissipated by the integration.
 * Each term has its own formula; none is the difference of the others. */
typedef enum {
  QN_ENERGY_INPUT,
  QN_ENERGY_KINETIC,
  QN_ENERGY_ELASTIC,
  QN_ENERGY_FRICTION,
  QN_ENERGY_DAMPING,
  QN_ENERGY_NUMERICAL,
  QN_ENERGY_KIND_COUNT
} QnEnergyKind;

/* A row of the history: time, acceleration of the ground in x and y, energies, tracks. */
enum { QN_HISTORY_TIME, QN_HISTORY_GROUND_X, QN_HISTORY_GROUND_Y, QN_HISTORY_ENERGY };
#define QN_HISTORY_TRACK (QN_HISTORY_ENERGY + QN_ENERGY_KIND_COUNT)

/* A block that has turned by more, rad, has overturned. */
#define QN_OVERTURNED 1.57079632679489661923

/* Blocks with at least this part of the fastest velocity count as unstable: on a path, where elastic joints
 * drag other blocks along; for rigid blocks. */
#define QN_UNSTABLE_SHARE 0.1
#define QN_UNSTABLE_RIGID 1e-3

/* History of an analysis in time: one row per multiple of its longest step. */
typedef struct QnHistory {
  size_t row_count, width; /* width = QN_HISTORY_TRACK + tracks; 0: no analysis in time */
  double *rows;
  size_t capacity;
  double *peaks;           /* block_count: largest displacement since the dead load, m */
  double peak_time;        /* s: of the largest of them; NAN: not known */
  double energy_error;     /* largest error of the balance over the largest input */
  double largest_residual; /* of all steps, relative to the forces */
  double largest_slip;     /* of a joint over the length of its face; valid if small */
  double collapse_time;    /* s; where the outcome is COLLAPSE */
  double end;              /* s, reached */
  double shortest_step;    /* s */
  int32_t steps, rejected; /* taken, and rejected for shorter ones */
} QnHistory;

/* A contact found during the motion, and when it first carried a force. Forces are on the block
 * whose side it is, as of pairs: along the normal of the side out of that block, and along the side. */
typedef struct QnFound {
  QnFoundContact contact;
  double time; /* s */
} QnFound;

/* Force of a found contact at a kept step; without an entry the force is 0. */
typedef struct QnFoundForce {
  int32_t step;
  QnId found;
  double normal, shear; /* N */
  QnPairState state;
} QnFoundForce;

/* A joint as drawn released by its blocks: its pairs carry no force from then on. */
typedef struct QnLeftFace {
  QnId face;
  double time; /* s */
} QnLeftFace;

/* Force of a contact pair on block a of its face is normal_force * normal + shear_force *
 * tangent; the opposite acts on block b. */
typedef struct QnPairResult {
  QnPairState state;
  double normal_force; /* N, <= 0 in compression */
  double shear_force;  /* N */
  double damage;       /* of the bond: 0 whole, or none there; 1 broken */

  bool has_springs; /* whether what follows is known; limit analysis has no springs */
  QnVec2 hinge;     /* point C between the two springs, deformed, m */
  double elongation_a[2], elongation_b[2]; /* (normal, tangential) of the springs, m */
} QnPairResult;

typedef struct QnStatistics {
  double seconds;
  double factor_seconds;   /* of these: factorising and solving */
  double assembly_seconds; /* scattering element tangents and residuals */
  double law_seconds;      /* evaluating constitutive laws */
  int32_t iterations;
  int32_t factorizations;
  double
    factorization_work; /* the same in whole factorisations: those of few new values are
                                parts of one */
  int64_t peak_memory_bytes; /* filled by layers that can measure it, else 0 */
} QnStatistics;

/* Adds the statistics of another part of an analysis; peak memory is the larger of the two. */
void qn_statistics_add (QnStatistics *total, const QnStatistics *part);

/* Sets times and memory, which differ from run to run, to 0: not measured. */
void qn_statistics_clear_timings (QnStatistics *statistics);

/* A collapse that is proved: forces within the strength of every joint balance the loads at this
 * multiplier, and the flow rules of the joints allow a mechanism under them. A structure whose
 * joints dilate by less than their friction may have many. */
typedef struct QnSolution {
  double multiplier;
  QnProcedure
    found_by; /* LOAD: with the multiplier prescribed; DISPLACEMENT, WORK, ARC_LENGTH: at the
                           peak of a path that prescribed these; LIMIT: of rigid blocks */
  double
    displacement; /* largest since the dead load, m; NAN: of rigid blocks, or not known */
} QnSolution;

/* Whether displacements exceeded the validity of linear geometry before the multiplier settled. */
typedef enum {
  QN_LINEARITY_UNKNOWN, /* not judged */
  QN_LINEARITY_HOLDS,   /* no; or geometry is nonlinear, or blocks are rigid */
  QN_LINEARITY_BEYOND
} QnLinearity;

/* Mode of vibration that is stored as the mechanism. */
typedef struct QnVibration {
  bool dead_load; /* state under dead load alone, else the last one of the analysis */
  int32_t mode;   /* from 1, by frequency; 0: the mechanism is no mode */
  double omega;   /* rad/s */
  bool sliding;   /* tangent with sliding joints; else closed joints are elastic */
} QnVibration;

/* The result of a search for the loss of stability. */
typedef enum {
  QN_STABILITY_UNKNOWN, /* the analysis is no such search */
  QN_STABILITY_KEPT,    /* every step is stable */
  QN_STABILITY_LOST,    /* every step is stable; lost at first_limit_multiplier */
  QN_STABILITY_COUNT
} QnStability;

/* Most solutions that a result keeps. */
#define QN_RESULT_SOLUTIONS 12

/* Figures of limit analysis; guarantees in limit.h. */
typedef struct QnLimitFigures {
  bool given;
  QnFlow flow;
  double lower_bound; /* associative: static value; non-associative: least fixed point */
  double upper_bound; /* associative: kinematic value; else greatest fixed point */
  double uncertainty; /* of the least fixed point (QnLimitSolution); else 0 */
} QnLimitFigures;

/* Contact forces of all steps are kept up to this many pairs x steps (17 bytes each), or if the settings ask
 * for them; forces of the last step are always kept. */
#define QN_RESULT_FORCE_BUDGET 2000000

typedef struct QnResult {
  QnOutcome outcome;
  int32_t stage; /* number of the stage in which the analysis ended, from 1; 0: without */
  QnStop stop;
  bool has_collapse_multiplier;
  double collapse_multiplier; /* largest multiplier with an equilibrium */
  bool has_first_limit_multiplier;
  double first_limit_multiplier; /* of the first snap, or of `stability` */

  QnPathEvent *events; /* stage by stage, as the multiplier meets them */
  size_t event_count, event_capacity;
  bool events_unknown; /* read from a file of an earlier version, which has none */

  QnSolution solutions[QN_RESULT_SOLUTIONS]; /* as they were met */
  int32_t solution_count;
  bool has_associative_bound; /* limit analysis was run for it */
  double associative_bound;
  bool has_broken_bound; /* likewise, with the bond of every joint broken: */
  double broken_bound;   /* 0: not even the dead load stands */

  QnFault
    refused[QN_CLAIM_COUNT]; /* false claims, removed with all that depends on them */
  int32_t refused_count;
  bool has_unproved_multiplier; /* collapse multiplier of such a result */
  double unproved_multiplier;

  QnLinearity linearity;           /* as qn_result_judge_linearity() says */
  double beyond_linear_multiplier; /* of BEYOND, 0 in time: at which it was */

  QnLimitFigures limit;
  QnVibration vibration;
  QnStability stability;

  size_t block_count;
  size_t node_count;    /* of beams */
  size_t element_count; /* of beams */
  size_t pair_count;

  QnStep *steps;
  size_t step_count, step_capacity;
  double *displacements; /* step_count x (block_count + node_count) x 3; m, m, rad at
                            centroids and nodes */
  size_t displacement_capacity;
  QnBeamForces *beam_forces; /* step_count x element_count; NULL: unknown */
  size_t beam_force_capacity;
  size_t tie_count;
  QnTieResult *ties; /* step_count x tie_count; NULL where there are none */
  size_t tie_capacity;

  QnId *supports; /* blocks with a fixed degree of freedom, ascending; none in limit
                     analysis */
  size_t support_count;
  double *reactions; /* step_count x support_count x 3, on the blocks: N, N, N m about the
                        centroid; 0 where the block is free */
  size_t reaction_capacity;

  double *velocities; /* in time: step_count x bodies x 3, m/s, rad/s; NULL: not kept */
  size_t velocity_capacity;

  QnPairResult *pairs; /* at the last equilibrium */
  double *step_forces; /* step_count x pair_count x 2: normal, shear, N; NULL: not kept */
  uint8_t *step_states; /* step_count x pair_count: QnPairState */
  double *step_damage; /* step_count x pair_count; NULL: no bond is damaged at any step */
  size_t step_force_capacity, step_state_capacity, step_damage_capacity;
  bool forces_dropped; /* there were more than the budget */
  double *mechanism;   /* (block_count + node_count) x 3 velocities at collapse, scaled by
                        qn_result_set_mechanism(); NULL: none */
  bool mechanism_uncertain; /* it is the motion up to the last followed state */

  bool mechanism_by_work; /* proved by its second-order work, not by the flow of joints */

  QnId *unstable_blocks; /* DEAD_LOAD_UNSTABLE: blocks that move, most moved first */
  size_t unstable_count;

  QnHistory history;

  QnFound *found; /* contacts found during motion, in order */
  size_t found_count, found_capacity;
  QnFoundForce *found_forces; /* by step, then by contact */
  size_t found_force_count, found_force_capacity;
  QnLeftFace *left; /* in the order of their release */
  size_t left_count, left_capacity;

  QnStatistics statistics;
} QnResult;

/* Result-file spelling: "collapse", "target-reached", … and "stick", "slip", "open", "yield". */
extern const char *const qn_outcome_names[QN_OUTCOME_COUNT];
extern const char *const qn_pair_state_names[QN_PAIR_STATE_COUNT];

/* An empty result for a model with this many blocks and pairs; where it has beams, node_count and
 * element_count are to be set before the first step, where it has ties, tie_count. */
QnStatus qn_result_init (QnResult *result, size_t block_count, size_t pair_count,
                         QnDiag *diag);

void qn_result_clear (QnResult *result);

/* Appends a step; displacements: a row for every block and node. False when memory runs out. */
bool qn_result_add_step (QnResult *result, QnStep step, const double *displacements);

/* Keeps the first `count` steps of a result without time, and the contacts found or released by then. */
void qn_result_keep_steps (QnResult *result, size_t count);

/* Appends an event, whose blocks become the result's, even where memory runs out (false). The first
 * snap sets first_limit_multiplier. */
bool qn_result_add_event (QnResult *result, QnPathEvent event);

void qn_result_set_first_limit (QnResult *result, double multiplier);

/* Keeps a solution, as long as there is room. */
void qn_result_add_solution (QnResult *result, QnSolution solution);

/* Interval of collapse: least solution, with the procedure that found it, and associative bound; NAN:
 * unknown. */
void qn_result_collapse_interval (const QnResult *result, double *least,
                                  QnProcedure *found_by, double *bound);

/* Removes collapse from the result: multipliers, solutions, mechanism. */
void qn_result_clear_collapse (QnResult *result);

/* Linear geometry is valid as long as no block has moved by more than this part of the least width
 * of a block (of a rectangle, its least side) since the dead load. */
#define QN_LINEAR_MOTION 0.1

/* A multiplier whose remaining change is at most this part of itself is settled. */
#define QN_SETTLED 1e-4

/* Sets `linearity`: whether a path in linear geometry exceeds QN_LINEAR_MOTION before the multiplier has
 * settled at collapse or at the end of the path (linear interpolation between steps); in time, whether the
 * peak of a block exceeds it. */
void qn_result_judge_linearity (const QnModel *model, QnResult *result);

/* Largest displacement of a block or node from one step to another, rotations aside, m. */
double qn_result_motion (const QnResult *result, size_t from, size_t to);

/* Result-file spelling: "kept", "lost". */
extern const char *const qn_stability_names[QN_STABILITY_COUNT];

/* Result-file spelling: "local", "snap", "buckling", "collapse". */
extern const char *const qn_event_kind_names[QN_EVENT_KIND_COUNT];

/* Drops all events, and first_limit_multiplier. */
void qn_result_clear_events (QnResult *result);

/* Section forces by element of the step that was added last. False when memory runs out. */
bool qn_result_add_beam_forces (QnResult *result, const QnBeamForces *forces);

/* The same of ties; NULL: not known. */
bool qn_result_add_ties (QnResult *result, const QnTieResult *ties);

/* Sets the blocks with reactions; appends the reactions of the last step added: block_count x 3, of which
 * the rows of the supports are kept. False when memory runs out. */
bool qn_result_set_supports (QnResult *result, const QnModel *model);
bool qn_result_add_reactions (QnResult *result, const double *reactions);

/* Appends the velocities of the last step added, a row for every body. */
bool qn_result_add_velocities (QnResult *result, const double *velocities);

/* Copies the forces in `pairs` to the last step added, within the budget unless `all`.
 * False when memory runs out. */
bool qn_result_add_forces (QnResult *result, bool all);

/* Append found contacts, their forces, released joints. False when memory runs out. */
bool qn_result_add_found (QnResult *result, QnFound found);
bool qn_result_add_found_force (QnResult *result, QnFoundForce force);
bool qn_result_add_left (QnResult *result, QnLeftFace left);

/* The largest displacement of a block in an analysis in time, m; *block (nullable) is that block. */
double qn_result_peak (const QnResult *result, QnId *block);

/* Appends a row to the history, whose width is set. False when memory runs out. */
bool qn_result_add_history (QnResult *result, const double *row);

/* Result-file spelling: "input", "kinetic", … */
extern const char *const qn_energy_names[QN_ENERGY_KIND_COUNT];

bool qn_result_has_forces (const QnResult *result, size_t step);

/* State and forces of a pair at a step whose forces are known; its springs are known at the
 * last step alone. */
QnPairResult qn_result_pair_at (const QnResult *result, size_t step, size_t pair);

/* Multiplier of every load set (factors: QN_MAX_LOAD_SETS) at a step: that of the step for the
 * sets that its stage drives, for others where earlier stages left them. */
void qn_result_load_factors (const QnModel *model, const QnResult *result, size_t step,
                             double *factors);

/* Figures of stages. */
typedef struct QnStageFigures {
  size_t last;            /* step */
  double multiplier;      /* of its load sets there */
  double lowest, highest; /* multipliers of its steps and of its begin */
  double work; /* of its load sets, J, arms undeformed; closed cycle: dissipation */
} QnStageFigures;

/* Figures of the stages from `first` to `last` (from 1), which drive the same loads. False if the result has
 * no step of them, or memory runs out. */
bool qn_result_stage_figures (const QnModel *model, const QnResult *result, int32_t first,
                              int32_t last, QnStageFigures *figures);

/* The work that driven loads have done up to every step, J, as above. sums: step_count. False when memory runs
 * out. */
bool qn_result_sum_work (const QnModel *model, const QnResult *result, double *sums);

/* The first stage of the cycle that ends with a stage; 0: none does, or it was not completed. */
int32_t qn_result_cycle_start (const QnModel *model, const QnResult *result,
                               int32_t stage);

/* Keeps `velocities` (a row for every block and node), scaled so that the largest of |(ux, uy)|
 * over the rows, or of |rz| x characteristic length where that is larger, is 1. */
QnStatus qn_result_set_mechanism (QnResult *result, const double *velocities,
                                  double characteristic_length, QnDiag *diag);

/* Lists the blocks that fall, the fastest first: those that move in the mechanism by QN_UNSTABLE_SHARE of
 * the fastest or more, or where blocks are `rigid` by more than QN_UNSTABLE_RIGID. */
QnStatus qn_result_name_unstable (QnResult *result, double characteristic_length,
                                  bool rigid, QnDiag *diag);

/* Rows of displacements and mechanism: blocks, then nodes. */
static inline size_t
qn_result_body_count (const QnResult *result)
{
  return result->block_count + result->node_count;
}

/* Displacements of one step: a row for every block, then for every node. */
static inline const double *
qn_result_step_displacements (const QnResult *result, size_t step)
{
  return result->displacements + step * qn_result_body_count (result) * QN_DOF_COUNT;
}

/* Ties at a step, and section forces of beams by element; NULL where they are not known. */
static inline const QnTieResult *
qn_result_step_ties (const QnResult *result, size_t step)
{
  const QnTieResult *ties =
    result->ties != NULL ? result->ties + step * result->tie_count : NULL;
  return ties != NULL && !isnan (ties->force) ? ties : NULL;
}

static inline const QnBeamForces *
qn_result_step_beam_forces (const QnResult *result, size_t step)
{
  return result->beam_forces != NULL ? result->beam_forces + step * result->element_count
                                     : NULL;
}

/* Reactions of one step, support_count x 3; NULL where they are not known. */
static inline const double *
qn_result_step_reactions (const QnResult *result, size_t step)
{
  return result->reactions != NULL
           ? result->reactions + step * result->support_count * QN_DOF_COUNT
           : NULL;
}

/* Losses of stability that reports mention. */

/* Whether a path has a first limit point at 1/1000 of the collapse multiplier or more. At lower loads joints
 * settle, and displacements are so small that any jump is relatively large. */
bool qn_result_has_felt_limit (const QnResult *result);

/* Whether an event is reported: not LOCAL, and at 1/1000 of the collapse multiplier or more. */
bool qn_result_is_felt (const QnResult *result, const QnPathEvent *event);

/* The first event BUCKLING, or NULL. */
const QnPathEvent *qn_result_find_buckling (const QnResult *result);

/* First step of the event's stage at its multiplier; -1: none. */
ptrdiff_t qn_result_buckling_step (const QnResult *result, const QnPathEvent *event);
