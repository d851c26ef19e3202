/* Motion: a displacement field over the blocks, scaled for drawing, and what it does to the
 * joints. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/mechanism.h"
#include "core/result/result.h"

#include <glib.h>

typedef struct QnMotion {
  const QnModel *model;
  const double
    *displacements; /* a row (m, m, rad) for every block, then for every node of
                                  beams; NULL: nothing moves */
  /* Where blocks are before they move, as displacements, with finite rotations and never multiplied, of
   * blocks alone; NULL: as the model has them. Matters for places, not for what moves. */
  const double *base;
  bool linear; /* rotations act linearly, as in the analysis; closed joints stay closed */
  double scale; /* displacements and rotations are drawn multiplied by this */
} QnMotion;

/* Place of the point `p` of a block (m), moved by `scale` times the field. */
QnVec2 qn_motion_place (const QnMotion *motion, QnId block, QnVec2 p, double scale);

/* A factor that moves the fastest vertex by about a twelfth of the structure's diagonal and
 * turns no block by more than a quarter of a radian, 0.6 where it is small beside the structure; 1 where nothing moves. Rounded down to
 * two digits. */
double qn_motion_auto_scale (const QnMotion *motion);

/* The displacements of a step, at factor 1; `displacements` is NULL where the result has no
 * steps. */
QnMotion qn_step_motion (const QnModel *model, const QnResult *result, size_t step);

/* The factor that the deformed view of a result chooses for all its steps; 1 or more in nonlinear geometry and in
 * time, where displacements are large as they are. */
double qn_motion_result_scale (const QnModel *model, const QnResult *result);

/* By how much a picture says that displacements are enlarged; translated. */
char *qn_motion_dup_scale (double scale);

/* Largest length of a displacement over the vertices of one block and of all, m, not scaled. */
double qn_motion_of_block (const QnMotion *motion, QnId block);
double qn_motion_largest (const QnMotion *motion);

/* Relative motion of the two sides of a face under the unscaled field, m. What the joint does is not set. */
QnJointMotion qn_motion_joint (const QnMotion *motion, const QnContactFace *face);

/* Joints of all faces (newly allocated, face_count of them, g_free), closed, hinges or opening. `pairs`, nullable, are
 * pair results that decide the states of joints that move by more than 3 % of the largest
 * displacement; without them a joint opens or slides where it moves by more than 2 % of the
 * largest joint motion. */
QnJointMotion *qn_motion_joints (const QnMotion *motion, const QnContacts *contacts,
                                 const QnPairResult *pairs);

/* "overturning", "rocking", "sliding", …; translated. */
const char *qn_mechanism_kind_text (QnMechanismKind kind);
