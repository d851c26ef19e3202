/* Soil that is pushed: where a block moves into the fill beside it, its pressure grows from that at rest to
 * a part of the passive pressure, and no further; where the block moves away it falls to the active one.
 *
 * The active pressure is a dead load (core/model/edge-load.c). Pressure above it is a tie per free block, on the
 * side of the fill's thrust: it pulls the block away from the fill, with a force between 0 and
 *
 *   F = (max (m Kp, Ka) - Ka) S,     Ka = (1 - sin phi) / (1 + sin phi), Kp = 1 / Ka (Rankine 1857),
 *
 * where S is the vertical stress, weight times depth, summed up over the upright projection of the block's
 * edges in the fill; it acts where S does. Under the dead load it has (K0 - Ka) S at least, K0 = 1 - sin phi
 * (Jaky 1944), F at most. Its stiffness is that of the soil times the projection. It ends on the ground so
 * far away that it stays level. So paths, limit analysis, dynamics and checks take it as any tie.
 */
#pragma once

#include "core/model/model.h"

/* Drops the soil ties of a model. */
void qn_model_drop_soil (QnModel *model);

/* Adds those of one fill from the edge forces that it was resolved into, which must be the last. Refuses
 * nothing; QN_ERROR_NO_MEMORY. */
QnStatus qn_model_add_soil (QnModel *model, size_t source, QnDiag *diag);

/* Ka of a fill. */
double qn_fill_active (const QnLoad *fill);
