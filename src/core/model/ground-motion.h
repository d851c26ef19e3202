/* Input of analyses in time: accelerations of the ground, initial motion of blocks, settings of the time
 * integration.
 *
 * The ground is rigid and does not turn: all supports move alike. Its acceleration is the sum of
 * all ground motions, each a signal a(t) in m/s2 times its scale and its direction.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

/* Most points of one signal, and most steps of `time_step` in one analysis. */
#define QN_MAX_SIGNAL_POINTS 5000000
#define QN_MAX_TIME_STEPS    10000000

typedef enum {
  QN_SIGNAL_POINTS, /* straight lines between points; nothing before and after */
  QN_SIGNAL_RECORD, /* the same, from a file: the layers above fill in the points */
  QN_SIGNAL_PULSE
} QnSignalKind;

/* With s = t - start, amplitude A and duration T:
 *
 *   half-sine     A sin(pi s/T)                         0 <= s <= T
 *   sine          A sin(2 pi s/T)                       0 <= s <= T
 *   rectangle     A                                     0 <= s <= T
 *   ricker        A (1 - 2 x^2) exp(-x^2),
 *                 x = pi (s - T)/T                      0 <= s <= 2 T: T is the main period
 *   step-impulse  A for 0 <= s <= T, then -A/2          until s = 3 T */
typedef enum {
  QN_PULSE_HALF_SINE,
  QN_PULSE_SINE,
  QN_PULSE_RECTANGLE,
  QN_PULSE_RICKER,
  QN_PULSE_STEP_IMPULSE,
  QN_PULSE_KIND_COUNT
} QnPulseKind;

typedef struct QnPulse {
  QnPulseKind kind;
  double amplitude; /* m/s2 */
  double duration;  /* s, > 0 */
  double start;     /* s, >= 0 */
} QnPulse;

typedef struct QnGroundMotion {
  QnSignalKind kind;
  QnVec2 direction; /* of any length */
  double scale;     /* default 1 */
  QnPulse pulse;
  QnVec2 *points; /* owned: (s, m/s2), times ascending */
  size_t point_count, point_capacity;
  char *record; /* owned: name of the file, as the project says it */
  char *unit; /* owned: unit of its accelerations where the file does not say it; NULL */
  const char *record_unit; /* of the file's numbers once they were read; not owned */
  double time_step;        /* of its samples, s, where the file does not say it; 0 */
  double peak;             /* m/s2, of the record before `scale`; 0: that of the file */
  bool rests; /* a record may end before the duration: the ground rests from then on */
  int32_t note;
} QnGroundMotion;

/* Initial motion of a block, from the equilibrium under dead load. */
typedef struct QnInitialMotion {
  QnId block;
  double displacement[QN_DOF_COUNT]; /* m, m, rad */
  double velocity[QN_DOF_COUNT];     /* m/s, m/s, rad/s, relative to the ground */
  int32_t note;
} QnInitialMotion;

/* A displacement whose history is kept. */
typedef struct QnTrack {
  QnId block;
  QnDof dof;
  int32_t note;
} QnTrack;

/* Dashpots of joints are proportional to a stiffness, or follow from the inertia of the blocks. */
typedef enum {
  QN_DAMPING_CURRENT, /* the current stiffness: none in an open or sliding joint */
  QN_DAMPING_INITIAL, /* that of closed joints */
  QN_DAMPING_IMPACT, /* from the loss of an impact, in closed joints; joint_damping is of beams */
  QN_DAMPING_STIFFNESS_COUNT
} QnDampingStiffness;

typedef struct QnDynamicSettings {
  double duration;  /* s; 0: to the end of the ground motion, see qn_model_duration() */
  double time_step; /* s, > 0: the longest step */
  double rho;       /* spectral radius at infinite frequency, 0 to 1 */
  double mass_damping;  /* 1/s, >= 0 */
  double joint_damping; /* s, >= 0: times the stiffness */
  QnDampingStiffness of;
  double
    tolerance; /* largest local error of a step, relative to the characteristic length */
  double output_interval; /* s; 0: a five-hundredth of the duration */
  bool adaptive;          /* false: every step is as long as time_step */
  bool
    follow; /* contacts follow the blocks (core/contact/contact-follow.h); nonlinear geometry */
  bool fall; /* the motion is followed on after something has overturned */
} QnDynamicSettings;

/* "half-sine", "sine", …; "current", "initial", "impact". */
extern const char *const qn_pulse_kind_names[QN_PULSE_KIND_COUNT];
extern const char *const qn_damping_stiffness_names[QN_DAMPING_STIFFNESS_COUNT];

/* When a signal is over, s. */
double qn_ground_motion_end (const QnGroundMotion *motion);
