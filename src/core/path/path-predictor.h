/* Where the next equilibrium is sought first, in large displacements.
 *
 * A linear step of blocks that turn by dr strains joints by dr^2 times their arms, which is nothing beside
 * the motion and everything beside what stiff joints yield: half a millimetre of motion opens and
 * overloads joints of 1e9 N/m by more than a block weighs. A polynomial in the measure through the
 * equilibria before errs by the power that it has terms, so that steps need not be the shorter, the
 * stiffer the joints are.
 */
#pragma once

#include "core/equilibrium/equilibrium.h"
#include "core/path/tuning.h"

/* Equilibria before the committed one. */
#define QN_PREDICTOR_STATES 3

typedef struct QnPathPredictor {
  double *u[QN_PREDICTOR_STATES]; /* the last one first */
  double multiplier[QN_PREDICTOR_STATES];
  double advance[QN_PREDICTOR_STATES]; /* of the measure, to the one after it */
  int count;
} QnPathPredictor;

void qn_path_predictor_init (QnPathPredictor *predictor, const QnAssembly *assembly,
                             QnPool *pool);

/* To be called just before a step is accepted that advanced the measure so far. `smooth`: no joint
 * has slid but along the path; otherwise nothing before it counts. */
void qn_path_predictor_note (QnPathPredictor *predictor, const QnEquilibrium *eq,
                             double advance, bool smooth);

/* Moves the solver from the committed state to where the measure will have advanced so far, if enough
 * equilibria are known. False where it stays. */
bool qn_path_predictor_go (const QnPathPredictor *predictor, QnEquilibrium *eq,
                           double advance);
