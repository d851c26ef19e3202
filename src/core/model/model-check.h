/* The rules that a model's numbers and references must keep; part of qn_model_prepare(). */
#ifndef QN_CORE_MODEL_CHECK_H
#define QN_CORE_MODEL_CHECK_H

#include "core/base/numbers.h"
#include "core/model/model.h"

/* Checks one block of a model: name, polygon, numbers. A fault in a block that came from a wall
 * is reported as the wall's. */
QnStatus qn_model_check_block (const QnModel *model, QnId block, QnDiag *diag);

/* Checks everything outside blocks and walls: gravity, laws, contact settings, exceptions,
 * loads, analysis settings. Walls must be expanded. */
QnStatus qn_model_check_settings (const QnModel *model, QnDiag *diag);

/* Parts of it: loads and settlements; analysis settings and stages. */
QnStatus qn_model_check_loads (const QnModel *model, QnDiag *diag);
QnStatus qn_model_check_analysis (const QnModel *model, QnDiag *diag);

/* Ground motions, initial motions, tracks and the settings of the integration, where the procedure
 * is dynamic. Records are checked once they have been read: qn_model_check_signal(). */
QnStatus qn_model_check_dynamic (const QnModel *model, QnDiag *diag);

typedef struct QnNumberRule {
  const char *field;
  double value;
  QnRange range;
} QnNumberRule;

/* Numbers, one, both of a vector, or the index of a block: the first problem as the field's. */
QnStatus qn_check_numbers (const QnNumberRule *rules, size_t count, QnEntity entity,
                           QnId index, QnDiag *diag);
QnStatus qn_check_number (double value, QnRange range, QnEntity entity, QnId index,
                          const char *field, QnDiag *diag);
QnStatus qn_check_vector (QnVec2 vector, QnEntity entity, QnId index, const char *field,
                          QnDiag *diag);
QnStatus qn_check_block_reference (const QnModel *model, QnId block, QnEntity entity,
                                   QnId index, const char *field, QnDiag *diag);

#endif
