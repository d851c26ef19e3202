/* What the parts of the check of a result share; private to this room. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/check/result-check.h"
#include "core/contact/contact-follow.h"
#include "core/linalg/inertia.h"

/* Bodies are in balance and joints within their strength to this part of the largest force, or to
 * ten times the residual that the project asks for. */
#define QN_CHECK_TOLERANCE 1e-6

/* Forces are those of the displacements to this part of the largest: an increment along the central
 * path leaves a little force in joints that open. */
#define QN_CHECK_FORCES 1e-5

/* Rounding of displacements, relative to the largest. */
#define QN_CHECK_EXACT 1e-11

/* Rounding of the forces that a file states of steps before the last: half a unit of the eighth digit. */
#define QN_CHECK_DIGITS 5e-8

/* Elongations of a step are those of its forces and flow to this part of the largest change of one
 * since the step before: what an increment along the central path may leave of them. */
#define QN_CHECK_STRAIN 1e-3

/* A force is none, or a strength is reached, within this part of the largest force. */
#define QN_CHECK_STATE 1e-4

typedef struct QnCheck {
  QnPool pool; /* of arrays */
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  QnCheckDepth depth;
  QnResultFaults *faults;
  QnAssembly assembly;    /* of the contacts as drawn and those found on the way */
  bool follows;           /* contacts follow the blocks */
  QnContactFollow follow; /* where they do */
  QnContacts all;         /* those contacts; empty where they do not */
  size_t first_force,
    next_force;        /* of the result's forces of found contacts: those of the step */
  QnFoundForce *found; /* scratch, by found contact: forces of the step */
  bool *begins; /* likewise: it carried nothing at the step before, and may have slid */
  double tolerance; /* of forces, relative to `scale` */
  double scale;     /* N: largest force of the step */
  double largest;   /* m: largest displacement of the step */
  double change;    /* m: largest change of an elongation in a step so far */
  bool relaxed;     /* some step so far is not the laws' answer to the one before */
  bool lost;    /* and its forces were not kept: none are known until some are stated */
  double slack; /* m: what elongations may be off by, of all steps so far */
  double stiffness_at_rest;  /* N/m: against the mechanism, at the first step */
  double *u, *residual;      /* unknowns */
  double *rows, *live;       /* scratch, a row for every body */
  double *forces;            /* scratch, 2 per pair */
  QnBeamForces *beam_forces; /* scratch, by element */
  double *velocity;          /* scratch, unknowns */
  bool *unknown; /* by pair: what its law remembers, the structure's way being unknown */
  double *elongations; /* 2 per pair: at the step before */
  double *mass;        /* in time: in the pattern of the tangent */
  QnInertia *inertia;  /* of the tangent, where stability is stated */
} QnCheck;

/* Notes a claim that is not true, unless one of its kind has been found before. */
void qn_check_tell (QnCheck *check, QnClaim claim, QnId step, QnEntity entity, QnId index,
                    double stated, double found);

/* The same of the structure as a whole, and of a block or node by the number of its body. */
void qn_check_tell_model (QnCheck *check, QnClaim claim, QnId step, double stated,
                          double found);
void qn_check_tell_body (QnCheck *check, QnClaim claim, QnId step, size_t body,
                         double stated, double found);

/* The same at a pair; one that was found on the way is named by its block. */
void qn_check_tell_pair (QnCheck *check, QnClaim claim, size_t step, size_t pair,
                         double stated, double found);

/* Of a stage of loading, or of an analysis without stages: the step that it begins with, and its last. */
typedef struct QnCheckStage {
  int32_t number; /* 0: none */
  size_t base, last;
  double before[QN_MAX_LOAD_SETS]; /* how much of every load set acts where it begins */
  double origin;                   /* of those that it drives */
  double sense;                    /* -1: its multiplier falls */
  uint32_t sets;                   /* of loads, that it drives */
  QnProcedure procedure;
} QnCheckStage;

QnCheckStage qn_check_stage (const QnCheck *check, int32_t number);

/* False for what is no number, too. */
bool qn_check_agrees (double stated, double found, double tolerance);

/* Makes ready to check contacts that were found on the way; false when memory runs out. Those that
 * name what is not there are told, and none is looked at then. */
bool qn_check_found_init (QnCheck *check, QnDiag *diag);
void qn_check_found_clear (QnCheck *check);

/* Takes up what they carry at a step, and makes the others inactive. To be called for every step, in
 * order, before pairs are evaluated. */
void qn_check_found_take (QnCheck *check, size_t step);

/* No corner lies within another block without a contact. After qn_check_found_take(). */
QnStatus qn_check_found_missing (QnCheck *check, size_t step, QnDiag *diag);

/* Displacements, forces, states and balance at a step, its displacements evaluated (check-forces.c). What
 * follows has the forces as they are stated. */
void qn_check_forces (QnCheck *check, size_t step);

/* Sums what acts on every body at a step, with the pair forces of check->forces; keeps what that comes to in
 * faults->last (check-balance.c). */
void qn_check_balance (QnCheck *check, size_t step);

/* By how much the stated force of a drawn pair exceeds what the laws of its sides can carry, N. */
double qn_check_excess (const QnCheck *check, size_t pair, const QnPairResult *stated);

/* Unknowns from a row of displacements or velocities for every body. */
void qn_check_gather (const QnAssembly *assembly, const double *rows, double *u);

/* Order of the steps, the outcome and its multipliers, events (check-course.c). */
QnStatus qn_check_course (QnCheck *check, QnDiag *diag);

/* The mechanism at the last step (check-mechanism.c). */
void qn_check_mechanism (QnCheck *check);

/* Supports stand in the mechanism, and nodes move with the blocks that they ride on. */
void qn_check_bodies (QnCheck *check);

/* Vibrations and stability, at the state of a step (check-modes.c). */
QnStatus qn_check_modes (QnCheck *check, size_t step, QnDiag *diag);

/* The bounds of limit analysis, and what it says without any equilibrium (check-bounds.c). */
QnStatus qn_check_bounds (QnCheck *check, QnDiag *diag);

/* What an analysis in time keeps (check-history.c): the whole of it, and the energies at a step, at which
 * the assembly was last evaluated. */
void qn_check_history (QnCheck *check);
QnStatus qn_check_motion (QnCheck *check, size_t step, QnDiag *diag);
