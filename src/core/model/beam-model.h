/* Rules and derived values of nodes, sections, beams and ties; part of qn_model_prepare(). */
#pragma once

#include "core/model/model.h"

/* Checks numbers and references of ties and of expanded beams. */
QnStatus qn_model_check_beams (const QnModel *model, QnDiag *diag);

/* Finds out which nodes have a rotation of their own. Beams must be checked. */
void qn_model_mark_turning_nodes (QnModel *model);

/* Places nodes and computes sections. Blocks must be derived and beams be checked. Refuses beams without
 * length, and moments on nodes without a rotation. */
QnStatus qn_model_derive_beams (QnModel *model, QnDiag *diag);
