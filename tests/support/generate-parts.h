/* What the generators share; see generate.h. */
#pragma once

#include "support/generate.h"

/* Refuses a number of a recipe that is not positive (or, if allowed, zero), finite and sane. */
QnStatus qn_generate_check (double value, bool zero_allowed, const char *field,
                            QnDiag *diag);

/* Refuses more blocks than a model may have. */
QnStatus qn_generate_check_blocks (double count, const char *field, QnDiag *diag);

/* Refuses a material that makes no sense, by its member. */
QnStatus qn_generate_check_material (const QnGenerateMaterial *material, QnDiag *diag);

/* Adds the law and the loads. */
QnStatus qn_generate_begin (QnModel *model, const QnGenerateMaterial *material,
                            QnDiag *diag);

/* Adds one block called `prefix` (at most 15 characters) and, from 0 on, `number`. */
QnStatus qn_generate_add (QnModel *model, const QnGenerateMaterial *material,
                          const char *prefix, int32_t number, const QnVec2 *vertices,
                          size_t count, QnDiag *diag);

/* The same, fixed in all degrees of freedom. */
QnStatus qn_generate_add_fixed (QnModel *model, const QnGenerateMaterial *material,
                                const char *name, const QnVec2 *vertices, size_t count,
                                QnDiag *diag);
