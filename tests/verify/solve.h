/* Solving test models, and an independent look at what comes out. */
#pragma once

#include "core/model/model.h"
#include "core/path/analysis.h"

/* A solved model with everything that belongs to it. */
typedef struct Solved {
  QnModel model;
  QnContacts contacts;
  QnResult result;
} Solved;

/* Prepares (where that is not done yet) and solves the model, which moves into *solved; fails
 * the test when the core refuses it or the result breaks equilibrium or joint strength by
 * more than 1e-6. */
void verify_solve (Solved *solved, QnModel *model);

void verify_clear (Solved *solved);

/* Multiplier at which the model collapses; fails unless it does. Clears the model. */
double verify_collapse (QnModel *model);

/* Resultant of all contact forces on one block about its centroid: fx, fy, m. */
void verify_contact_resultant (const Solved *solved, QnId block, double resultant[3]);
