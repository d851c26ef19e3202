/* Readings: what a result says of one joint or one block at one step, from its contact forces. Pictures of forces, fields by colour and the window all show these numbers.
 *
 * A joint is read on the force that block b puts on block a. Its moment is taken about the middle
 * of the face, counter-clockwise, so that moment = -normal * eccentricity. In equilibrium the
 * forces and moments of all joints of a block sum up to what loads and supports do not carry.
 */
#pragma once

#include "core/result/result-contact.h"
#include "render/scene/motion.h"

/* Where the normal force acts, by its distance from the middle of a joint of length L. */
typedef enum {
  QN_PLACE_NOWHERE, /* no compression as a whole: bending with rounding, or tension */
  QN_PLACE_KERN,    /* up to L/6: the whole joint is pressed, if it is linear */
  QN_PLACE_INSIDE,  /* up to L/2 */
  QN_PLACE_EDGE,    /* within a fiftieth of L of the end: a hinge */
  QN_PLACE_OUTSIDE, /* beyond: tension in the joint or in bars holds it */
  QN_PLACE_COUNT
} QnPressurePlace;

/* `normal`: their sum; `total`: the sum of the sizes of the normal forces, N. */
QnPressurePlace qn_pressure_place (double eccentricity, double length, double normal,
                                   double total);

typedef struct QnJointReading {
  double normal; /* N, <= 0 in compression */
  double shear;  /* N, along the tangent of the face */
  double moment; /* N m */
  double
    eccentricity; /* m, from the middle along the tangent; 0 where place is NOWHERE */
  QnPressurePlace place;
  double pressure; /* Pa, <= 0: the most pressed contact pair over its tributary area */
  QnVec2 at;       /* m, undeformed: where the normal force acts, kept within the face */
  int32_t states[QN_PAIR_STATE_COUNT]; /* how many pairs are in each */
} QnJointReading;

/* `pairs` are all of the contacts. */
QnJointReading qn_joint_reading (const QnContacts *contacts, QnId face,
                                 const QnPairResult *pairs);

typedef struct QnBlockReading {
  QnVec2 force;  /* N: sum of what its joints put on it */
  double moment; /* N m, of these about its centroid, counter-clockwise */
  double
    stress[3]; /* Pa, mean: xx, yy, xy; tension > 0; of loads and joints, bars in them */
  double principal[2]; /* Pa, of these: least, greatest */
} QnBlockReading;

/* A contact found during the motion, at a step, with its two blocks: that of the side, and that of the
 * corner. Places and forces are those on the undeformed blocks, as of joints. */
typedef struct QnTouch {
  QnId found; /* index into the result's contacts found on the way */
  QnId block[2];
  QnVec2 at[2];        /* m */
  QnVec2 on[2];        /* N: the force on each */
  QnVec2 normal;       /* unit: out of the side, of block[0] */
  double force, shear; /* N: along the normal (<= 0 in compression), and along the side */
} QnTouch;

/* The contacts that carry something at a step: *count of them, newly allocated (g_free). */
QnTouch *qn_step_touches (const QnModel *model, const QnResult *result, size_t step,
                          size_t *count);

/* What all blocks read, an array of block_count, newly allocated (g_free). `factors` are those of the load sets
 * (qn_result_load_factors()), nullable: forces that act away from the centroid are part of the stress.
 * Reactions of supports are not. */
QnBlockReading *qn_block_readings (const QnModel *model, const QnContacts *contacts,
                                   const QnPairResult *pairs, const QnTouch *touches,
                                   size_t touch_count, const double *factors);

/* The contact forces of a step, newly allocated (g_free); NULL where the result does not have
 * them or is of other contacts. */
QnPairResult *qn_step_pairs (const QnContacts *contacts, const QnResult *result,
                             size_t step);

/* Which joints have been left by the time of a step: face_count of them, newly allocated (g_free); NULL
 * where none has. */
bool *qn_step_left (const QnContacts *contacts, const QnResult *result, size_t step);

/* Crack of a joint. The width, the same in pictures, reports, tables and studies, is the elongation q of the
 * joint less the elastic one of its remaining tension F (stiffness k),
 *
 *   w = q - max (F, 0) / k
 *
 * for joints by contact and by material alike: in a dry joint (F = 0) the opening; in a softening bond or
 * concrete the crack opening (Hillerborg), 0 while the joint is whole. Joints of bilinear, elastic-plastic
 * and steel laws do not crack. Slip is not counted. w is computed at the ends of the joint, with the force
 * of the pair next to them, and at its pairs, without those of bars. */
typedef struct QnCrack {
  const QnContactFace *face; /* NULL: there is no crack */
  double width, mean;        /* m: largest, and mean over the length of the joint */
  QnVec2 at;                 /* where it is widest, as drawn */
} QnCrack;

/* `pairs`, nullable, are those of all joints: without them (qn_step_pairs()) F counts as none. */
QnCrack qn_joint_crack (const QnContacts *contacts, QnId face, const QnPairResult *pairs,
                        const QnMotion *motion);

/* Of all joints at a step of a result, the widest first; those without a crack are left out. Of QnCrack. */
GArray *qn_result_cracks (const QnModel *model, const QnContacts *contacts,
                          const QnResult *result, size_t step);

/* Whether two faces lie on one straight line: a whole bed joint, or head joints above each other. */
bool qn_faces_in_line (const QnContactFace *a, const QnContactFace *b);

/* The same cracks by whole lines of joints, the widest first: `mean` is over all joints of the line, of which
 * `face` is the one that has opened most. `lines` (nullable): the line of each crack, as many as cracks. */
GArray *qn_cracks_by_line (const QnContacts *contacts, const GArray *cracks,
                           guint *lines);
