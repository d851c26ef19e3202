/* Contacts found during the motion, in a result. */
#pragma once

#include "core/result/result.h"

/* Forces of the found contacts at a step: *count, contiguous. */
const QnFoundForce *qn_step_found (const QnResult *result, size_t step, size_t *count);

/* Corner of a found contact, undeformed, m. */
QnVec2 qn_found_corner (const QnModel *model, const QnFoundContact *contact);

/* The normal of the side, out of its block, undeformed. */
QnVec2 qn_found_normal (const QnModel *model, const QnFoundContact *contact);

/* The force on the block of the side, N, as that block lies after displacements (a row for every block,
 * or NULL). */
QnVec2 qn_found_force (const QnModel *model, const QnFoundContact *contact,
                       const QnFoundForce *force, const double *displacements);
