/* Where the force of a contact pair acts, and the forces of contacts found during the motion.
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

/* Whether found contacts are at sides and corners of the model's blocks, and their forces of such contacts and of
 * steps. */
bool qn_result_found_exist (const QnResult *result, const QnModel *model);

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
