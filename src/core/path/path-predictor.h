/* Predictor of the next equilibrium in large displacements.
 *
 * A linear step in which blocks turn by dr strains joints by dr^2 x arm: at 1e9 N/m a motion of 0.5 mm already
 * changes forces by more than the weight of a block. A polynomial in the measure through k earlier
 * equilibria has an error of order k, so that stiff joints do not require short steps.
 */
#pragma once

#include "core/equilibrium/equilibrium.h"
#include "core/path/tuning.h"

/* Equilibria before the committed one; with fewer nothing is predicted. */
#define QN_PREDICTOR_STATES 3

typedef struct QnPredictorState {
  double *u;
  double multiplier, advance; /* of the measure to the next equilibrium */
} QnPredictorState;

typedef struct QnPathPredictor {
  QnPredictorState states[QN_PREDICTOR_STATES]; /* the last one first */
  int count;
} QnPathPredictor;

void qn_path_predictor_init (QnPathPredictor *predictor, const QnAssembly *assembly,
                             QnPool *pool);

/* Call before a step with this advance of the measure is accepted. Unless `smooth` (all slip was along the
 * path), earlier equilibria are dropped. */
void qn_path_predictor_note (QnPathPredictor *predictor, const QnEquilibrium *eq,
                             double advance, bool smooth);

/* Moves the solver from the committed state to the prediction at this advance of the measure; false, without
 * motion, if too few equilibria are known. */
bool qn_path_predictor_go (const QnPathPredictor *predictor, QnEquilibrium *eq,
                           double advance);
