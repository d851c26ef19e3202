/* The rules that a model's numbers and references must keep; part of qn_model_prepare(). */
#ifndef QN_CORE_MODEL_CHECK_H
#define QN_CORE_MODEL_CHECK_H

#include "core/model.h"

/* Checks one block of a model: name, polygon, numbers. A fault in a block that came from a wall
 * is reported as the wall's. */
QnStatus qn_model_check_block (const QnModel *model, QnId block, QnDiag *diag);

/* Checks everything outside blocks and walls: gravity, laws, contact settings, exceptions,
 * loads, analysis settings. Walls must be expanded. */
QnStatus qn_model_check_settings (const QnModel *model, QnDiag *diag);

#endif
