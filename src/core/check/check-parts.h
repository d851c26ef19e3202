/* Shared by the parts of the check of a result; private to this room. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/check/result-check.h"
#include "core/contact/contact-follow.h"
#include "core/linalg/inertia.h"

/* Tolerance of balance and strength over the largest force, at least 10 x the project's residual tolerance; of
 * corners within blocks over the smallest block; of times over the length of a row of the history; of rates that
 * turn away from what a joint carries over the largest velocity (rounding of a linear program). */
#define QN_CHECK_TOLERANCE 1e-6

/* Tolerance of forces computed from displacements, over the largest force: the central path leaves small
 * forces in open joints; of multipliers of bounds, over 1 + multiplier. */
#define QN_CHECK_FORCES 1e-5

/* Rounding of displacements, relative to the largest. */
#define QN_CHECK_EXACT 1e-11

/* Rounding of step forces in files: half a unit of the eighth digit. */
#define QN_CHECK_DIGITS 5e-8

/* Tolerance of elongations computed from forces and flow (residual of the central path), over the largest
 * change of an elongation in the step; of a critical multiplier, over the multiplier tolerance. */
#define QN_CHECK_STRAIN 1e-3

/* In a mechanism a strength is reached within this part of the largest force. Where stability is lost so much
 * is left of the stiffness against the mode: the multiplier is resolved to 1e-7 of itself, and stiffness is
 * lost at least like the root of what is missing. */
#define QN_CHECK_LITTLE 1e-2

/* Zero forces and reached strengths are judged to this part of the largest force. */
#define QN_CHECK_STATE 1e-4

typedef struct QnCheck {
  QnPool pool; /* of arrays */
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  QnCheckDepth depth;
  QnResultFaults *faults;
  QnAssembly assembly;       /* of the contacts as drawn and those found on the way */
  bool follows;              /* contacts follow the blocks */
  QnContactFollow follow;    /* if `follows` */
  QnContacts all;            /* drawn and found contacts; empty unless `follows` */
  const QnFoundForce *found; /* of the step */
  size_t found_count;
  QnPairResult
    *stated;    /* by pair: what the step states, or the laws answer; found ones last */
  bool known;   /* the step states the forces of drawn pairs */
  bool *begins; /* by pair: found on the way, without force at the step before */
  double tolerance; /* of forces, relative to `scale` */
  double scale;     /* N: largest force of the step */
  double largest;   /* m: largest displacement of the step */
  double change;    /* m: largest change of an elongation in a step so far */
  bool relaxed; /* some step so far does not follow from the step before by the laws */
  bool lost;    /* such a step has no forces: unknown until the next stated forces */
  double slack; /* m: tolerance of elongations, summed over the steps */
  double stiffness_at_rest;  /* N/m: against the mechanism, at the first step */
  double *u, *residual;      /* unknowns */
  double *rows, *live;       /* scratch, a row for every body */
  double *rates;             /* scratch, 2 per pair */
  QnBeamForces *beam_forces; /* scratch, by element */
  double *velocity;          /* scratch, unknowns */
  bool *unknown;             /* by pair: memory of its law is unknown */
  double *elongations;       /* 2 per pair: at the step before */
  double *mass;              /* in time: in the pattern of the tangent */
  QnInertia *inertia;        /* of the tangent, where stability is stated */
} QnCheck;

/* Records a false claim, the first of each kind. */
void qn_check_tell (QnCheck *check, QnClaim claim, QnId step, QnEntity entity, QnId index,
                    double stated, double found);

/* A false claim on the whole structure. */
void qn_check_tell_model (QnCheck *check, QnClaim claim, QnId step, double stated,
                          double found);

/* Compares rows of so many bodies with check->rows. */
void qn_check_rows (QnCheck *check, QnClaim claim, QnId step, const double *stated,
                    size_t bodies, double tolerance);

/* A false claim on a pair; a found one is named by its block. */
void qn_check_tell_pair (QnCheck *check, QnClaim claim, size_t step, size_t pair,
                         double stated, double found);

/* Steps of a stage of loading, or of an analysis without stages. */
typedef struct QnCheckStage {
  int32_t number; /* 0: none */
  size_t base, last;
  double before[QN_MAX_LOAD_SETS]; /* factor of every load set at the begin */
  double origin;                   /* factor of the driven sets at the begin */
  double sense;                    /* -1: the multiplier falls */
  uint32_t sets;                   /* driven load sets, bit by bit */
  QnProcedure procedure;
} QnCheckStage;

QnCheckStage qn_check_stage (const QnCheck *check, int32_t number);

/* |stated - found| <= tolerance; false for NaN. */
bool qn_check_agrees (double stated, double found, double tolerance);

/* Prepares the check of found contacts; false when memory runs out. Records found contacts with invalid
 * references, and then checks none. */
bool qn_check_found_init (QnCheck *check, QnDiag *diag);
void qn_check_found_clear (QnCheck *check);

/* Reads the forces of found contacts at a step and makes the others inactive. Call for every step, in order,
 * before pairs are evaluated. */
void qn_check_found_take (QnCheck *check, size_t step);

/* No corner lies within another block without a contact. After qn_check_found_take(). */
QnStatus qn_check_found_missing (QnCheck *check, size_t step, QnDiag *diag);

/* Displacements, forces, states and balance at an evaluated step (check-forces.c). */
void qn_check_forces (QnCheck *check, size_t step);

/* Balance of every body at a step with the forces of check->stated; writes faults->last (check-balance.c). */
void qn_check_balance (QnCheck *check, size_t step);

/* Excess of the stated force of a drawn pair over the strength of its laws, N. */
double qn_check_excess (const QnCheck *check, size_t pair);

/* Order of the steps, the outcome and its multipliers, events (check-course.c). */
QnStatus qn_check_course (QnCheck *check, QnDiag *diag);

/* The mechanism at the last step (check-mechanism.c). */
void qn_check_mechanism (QnCheck *check);

/* Supports are fixed in the mechanism; nodes on blocks move with their blocks. */
void qn_check_bodies (QnCheck *check);

/* Vibrations and stability, at the state of a step (check-modes.c). */
QnStatus qn_check_modes (QnCheck *check, size_t step, QnDiag *diag);

/* The bounds of limit analysis, and its outcomes without equilibrium (check-bounds.c). */
QnStatus qn_check_bounds (QnCheck *check, QnDiag *diag);

/* Analysis in time (check-history.c): the history; the energies at the last evaluated step. */
void qn_check_history (QnCheck *check);
QnStatus qn_check_motion (QnCheck *check, size_t step, QnDiag *diag);
