/* The rules of nodes, sections, beams and ties, and what is derived of them; part of
 * qn_model_prepare(). */
#pragma once

#include "core/model/model.h"

/* Checks numbers and references of ties and of expanded beams. */
QnStatus qn_model_check_beams (const QnModel *model, QnDiag *diag);

/* Finds out which nodes have a rotation of their own. Beams must be checked. */
void qn_model_mark_turning_nodes (QnModel *model);

/* Places nodes and computes sections. Blocks must be derived and beams be checked; refuses what
 * shows only then: beams without length, moments that nothing takes. */
QnStatus qn_model_derive_beams (QnModel *model, QnDiag *diag);
