/* Where the force of a contact pair acts.
 *
 * In linear geometry equilibrium is that of the undeformed structure: the force acts where the
 * pair was detected, along the normal found there. In nonlinear geometry it is that of the
 * deformed one: the two springs meet half-way between the points A and B that the pair joins,
 * and the frame of the pair has turned by the mean of its blocks' rotations. That both forces
 * act at this one point follows from the pair's elastic energy being a function of the distance
 * of A and B in that frame (see core/contact/pair-kinematics.h). */
#pragma once

#include "core/result/result.h"

/* Displacements of the last equilibrium where it is one of the deformed structure; NULL where
 * it is one of the undeformed structure, or where there is none. */
const double *qn_result_deformation (const QnModel *model, const QnResult *result);

/* Place and normal of a detected pair; `deformation` as above. */
void qn_result_contact_place (const QnModel *model, const QnContacts *contacts,
                              size_t pair, const double *deformation, QnVec2 *point,
                              QnVec2 *normal);
