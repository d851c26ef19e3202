/* Studies: a project, its uncertain parameters, and the plan of cases.
 *
 * The format of the file (*.quoin-study) is described key by key in data/study-format.md. A study
 * that has been read is sound: the project reads, every path leads to a number of it, and the
 * plan has as many cases as QN_STUDY_MAX_CASES at most.
 */
#pragma once

#include "io/project/combinations.h"
#include "study/plan/distribution.h"

/* Most cases of a plan, most parameters, and most values of one parameter. */
#define QN_STUDY_MAX_CASES      1000000
#define QN_STUDY_MAX_PARAMETERS 100
#define QN_STUDY_MAX_VALUES     10000

/* Default time limit of a case, s. */
#define QN_STUDY_SECONDS 3600

typedef enum {
  QN_STUDY_SOLVE,
  QN_STUDY_LIMIT,
  QN_STUDY_MODAL,
  QN_STUDY_DYNAMIC,
  QN_STUDY_RUN_COUNT
} QnStudyRun;

typedef enum {
  QN_PLAN_GRID,            /* every level of one with every level of all others */
  QN_PLAN_ONE_AT_A_TIME,   /* the project as it is, then each parameter by itself */
  QN_PLAN_MONTE_CARLO,     /* independent points */
  QN_PLAN_LATIN_HYPERCUBE, /* one point in each of `count` layers of every parameter */
  QN_PLAN_SOBOL,           /* Saltelli's plan on a Sobol sequence, for Sobol indices */
  QN_PLAN_COMBINATIONS, /* a grid with the combinations of load cases as its last parameter */
  QN_PLAN_COUNT
} QnPlanKind;

/* Outputs of a case: enumeration, name for readers with its unit, key in files. Displacements are of any
 * block, at the last step or, the peak, at any time from the dead load on; cracks are openings of joints,
 * and their misfit, where the path has reached its target, the root mean square of computed less measured
 * widths. The kind of a mechanism is a word, its shape in the database as case.h has it and in tables the
 * number of the group of cases that move alike. COLLAPSED to ENERGY_ERROR are of runs in time. */
/* clang-format off */
#define QN_STUDY_OUTPUTS(X) \
  X (COLLAPSE_MULTIPLIER, N_ ("Collapse multiplier λ"), "collapse_multiplier") \
  X (ASSOCIATIVE_MULTIPLIER, N_ ("Associative bound of λ"), "associative_multiplier") \
  X (FIRST_LIMIT_MULTIPLIER, N_ ("Multiplier λ at the first jump"), "first_limit_multiplier") \
  X (LOWER_BOUND, N_ ("Limit analysis of λ: static value"), "lower_bound") \
  X (UPPER_BOUND, N_ ("Limit analysis of λ: kinematic value"), "upper_bound") \
  X (MECHANISM_KIND, N_ ("Kind of mechanism"), "mechanism_kind") \
  X (MECHANISM_SHAPE, N_ ("Shape of mechanism"), "mechanism_shape") \
  X (LAST_MULTIPLIER, N_ ("Multiplier λ of the last step"), "last_multiplier") \
  X (LARGEST_DISPLACEMENT, N_ ("Largest displacement (m)"), "largest_displacement") \
  X (STEPS, N_ ("Number of steps"), "steps") \
  X (ITERATIONS, N_ ("Number of iterations"), "iterations") \
  X (WIDEST_CRACK, N_ ("Widest crack (m)"), "widest_crack") \
  X (CRACK_MISFIT, N_ ("Misfit of measured cracks (m)"), "crack_misfit") \
  X (COLLAPSED, N_ ("Collapsed (1: yes, 0: no)"), "collapsed") \
  X (TIME_OF_COLLAPSE, N_ ("Time of collapse (s)"), "time_of_collapse") \
  X (PEAK_DISPLACEMENT, N_ ("Peak displacement (m)"), "peak_displacement") \
  X (FRICTION_ENERGY, N_ ("Energy lost by friction (J)"), "friction_energy") \
  X (LARGEST_SLIP, N_ ("Largest slip, over the length of its joint"), "largest_slip") \
  X (ENERGY_ERROR, N_ ("Error of the energy balance, over the input"), "energy_error") \
  X (FREQUENCY_1, N_ ("1st frequency (Hz)"), "frequency_1") \
  X (FREQUENCY_2, N_ ("2nd frequency (Hz)"), "frequency_2") \
  X (FREQUENCY_3, N_ ("3rd frequency (Hz)"), "frequency_3") \
  X (FREQUENCY_4, N_ ("4th frequency (Hz)"), "frequency_4") \
  X (FREQUENCY_5, N_ ("5th frequency (Hz)"), "frequency_5") \
  X (FREQUENCY_6, N_ ("6th frequency (Hz)"), "frequency_6")
/* clang-format on */

typedef enum {
#define QN_STUDY_OUTPUT_MEMBER(name, text, key) QN_STUDY_##name,
  QN_STUDY_OUTPUTS (QN_STUDY_OUTPUT_MEMBER)
#undef QN_STUDY_OUTPUT_MEMBER
    QN_STUDY_OUTPUT_COUNT
} QnStudyOutput;

typedef struct QnParameter {
  char *name;   /* owned */
  char **paths; /* owned: of the numbers in the project, all set to the same value; none
                   for combinations */
  QnDistribution distribution;
  int32_t levels; /* of a continuous distribution in plans by levels; 0: not given */
  bool whole;     /* values are rounded to whole numbers */
  double base;    /* the project's own value at the first path; NaN where it has none */
} QnParameter;

/* A measured crack between two blocks. */
typedef struct QnMeasuredCrack {
  char *blocks[2]; /* names, owned */
  double width;    /* m, >= 0 */
} QnMeasuredCrack;

typedef struct QnStudy {
  char *name;  /* what messages call the file */
  char *title; /* nullable */
  char *model; /* the project's file, as the study names it */
  char *text;  /* the file's bytes */
  gsize length;
  char *sha256; /* of these bytes, those of the project and of its records, hexadecimal */

  QnProject project; /* as it is, without any parameter */
  char *folder;      /* where it lies, with the records of ground motions that it names */

  QnStudyRun run;
  GArray *parameters;      /* of QnParameter */
  GPtrArray *combinations; /* of QnCombination, of that plan; NULL: none */
  double *correlation; /* of ranks: square matrix of the parameters; NULL: independent */
  QnPlanKind plan;
  int32_t count; /* of random plans: points; sobol: of the base sample */
  uint32_t seed;
  GArray *cracks;         /* of QnMeasuredCrack */
  GArray *outputs;        /* of QnStudyOutput, each once */
  double seconds;         /* that a case may take */
  int32_t factorizations; /* likewise; 0: as the project says */
  GPtrArray *warnings;    /* of char *, as those of a project */
} QnStudy;

extern const char *const qn_study_run_names[QN_STUDY_RUN_COUNT];
extern const char *const qn_plan_kind_names[QN_PLAN_COUNT];
extern const char *const qn_study_output_names[QN_STUDY_OUTPUT_COUNT];

/* Name of an output for readers, translated. */
const char *qn_study_output_text (QnStudyOutput output);

/* Whether a plan is made of the levels of its parameters, not of random points. */
gboolean qn_plan_is_by_levels (QnPlanKind kind);

/* What a run is of a project: "solve" of one that is analysed in time is "dynamic". */
QnStudyRun qn_study_run_of (QnStudyRun run, const QnAnalysisSettings *analysis);

/* Override of the project by a kind of run; NULL: none. */
const char *qn_study_run_override (QnStudyRun run);

/* Whether a kind of run of a project gives a bound from above in place of a collapse multiplier: limit
 * analysis with associative flow. */
gboolean qn_study_run_bounds (QnStudyRun run, const QnAnalysisSettings *analysis);

/* Whether a kind of run of a project knows an output. */
gboolean qn_study_run_gives (QnStudyRun run, const QnAnalysisSettings *analysis,
                             QnStudyOutput output);

/* Whether an output is a number with a distribution: not those of mechanisms. */
gboolean qn_study_output_is_number (QnStudyOutput output);

/* Reads a study file, and the project that it names relative to its own folder; or that at
 * `model_path`, where this is not NULL. `study` is overwritten without being cleared and holds
 * nothing on failure. Errors: QN_IO_ERROR. */
gboolean qn_study_read (const char *path, const char *model_path, QnStudy *study,
                        GError **error);

/* A study without parameters, to be filled. */
void qn_study_init (QnStudy *study);

void qn_study_clear (QnStudy *study);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnStudy, qn_study_clear)

/* Ground motions of the project that its cases may read records for: those of a run in time. */
gsize qn_study_record_count (const QnStudy *study);

/* Number of cases of the plan. */
gsize qn_study_case_count (const QnStudy *study);

/* Levels of a parameter in plans by levels: the values of a list, or quantiles in the middle of
 * equal shares. */
gsize qn_parameter_level_count (const QnParameter *parameter);
double qn_parameter_level (const QnParameter *parameter, gsize level);

/* The combination that a value of a parameter stands for; NULL: it is a number. */
const QnCombination *qn_study_combination (const QnStudy *study, gsize parameter,
                                           double value);

static inline const QnParameter *
qn_study_parameter (const QnStudy *study, gsize index)
{
  return &g_array_index (study->parameters, QnParameter, index);
}

static inline QnStudyOutput
qn_study_output (const QnStudy *study, gsize index)
{
  return g_array_index (study->outputs, QnStudyOutput, index);
}
