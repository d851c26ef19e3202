/* Analysis of a velocity field: classifies joints, groups blocks into rigid bodies, names the mechanism. Texts
 * are composed above the core.
 *
 * The field may be a mechanism of collapse, the difference of two steps, or any other field of
 * small motions (ux, uy, rz of every block; m, m, rad, or the same per time). Everything is
 * judged relative to the fastest point, so its scale does not matter.
 */
#pragma once

#include "core/base/box.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

typedef enum {
  QN_JOINT_CLOSED,      /* no relative motion */
  QN_JOINT_HINGE_START, /* opens, turning about the corner at face.start */
  QN_JOINT_HINGE_END,   /* … at face.end */
  QN_JOINT_SLIDING, /* shears along the face, opening no more than friction dilates it */
  QN_JOINT_OPENING, /* both corners part */
  QN_JOINT_KIND_COUNT
} QnJointKind;

/* A joint opens if its opening exceeds the dilation by friction by more than this part of its slip. */
#define QN_JOINT_PARTING 0.05

/* Motion of block b relative to block a of a face. */
typedef struct QnJointMotion {
  QnJointKind kind;
  bool slides;          /* a hinge or an opening joint may shear as well */
  double opening_start; /* along the normal, at face.start; < 0: closes (penetrates) */
  double opening_end;   /* … at face.end */
  double slip;          /* mean, along the tangent; > 0: block b moves along +tangent */
} QnJointMotion;

/* Blocks that move as one rigid body. */
typedef struct QnMechanismBody {
  int32_t block_count;
  QnVec2 centroid; /* of its blocks, by area, m */
  QnVec2 velocity; /* of that point */
  double rotation; /* rad, counter-clockwise positive */
  bool turns;      /* rotation is not negligible beside translation */
  QnVec2 centre;   /* fixed point of the motion, m; where it turns */
  double largest;  /* fastest point, relative to that of the whole mechanism */
  QnBox box;       /* around its blocks, m */
} QnMechanismBody;

/* Name of a mechanism. */
typedef enum {
  QN_MECHANISM_KIND_NONE,        /* nothing moves */
  QN_MECHANISM_KIND_OVERTURNING, /* one body turns about hinges at its foot */
  QN_MECHANISM_KIND_ROCKING, /* several bodies rock on hinges, piers above each other */
  QN_MECHANISM_KIND_SLIDING, /* bodies slide along beds, on one level or several */
  QN_MECHANISM_KIND_STEPPED, /* a body turns off a staircase: beds and head joints open */
  QN_MECHANISM_KIND_ARCH,    /* a chain of bodies folds at alternating hinges */
  QN_MECHANISM_KIND_FALLING, /* bodies lose contact: they fall, or are lifted */
  QN_MECHANISM_KIND_SWAYING, /* blocks move sideways, no joint opens or slides: beams, or all joints, deform */
  QN_MECHANISM_KIND_MIXED, /* hinges and sliding joints together, none prevailing */
  QN_MECHANISM_KIND_COUNT
} QnMechanismKind;

typedef struct QnMechanism {
  QnMechanismKind kind;
  QnJointMotion *joints; /* one per face */
  size_t joint_count;
  QnId *body_of_block; /* block_count: body, or QN_NONE where the block stays at rest */
  size_t block_count;
  QnMechanismBody *bodies; /* most blocks first */
  size_t body_count;
  double largest; /* speed of the fastest point, in the field's unit */
  int32_t counts[QN_JOINT_KIND_COUNT]; /* joints of each kind */
  int32_t sliding_count;               /* joints that slide, hinges that slide included */
} QnMechanism;

/* Result-file spelling: "closed", "hinge-start", …; "overturning", "rocking", … */
extern const char *const qn_joint_kind_names[QN_JOINT_KIND_COUNT];
extern const char *const qn_mechanism_kind_names[QN_MECHANISM_KIND_COUNT];

/* Displacements at which the mechanism of a result begins, in large displacements; NULL: those of the
 * undeformed structure: modes of vibration and of buckling, limit analysis, mechanisms with beams. */
const double *qn_mechanism_base (const QnModel *model, const QnResult *result);

/* Analyses the mechanism of a result that has one, with the dilatancy of the analysis: of joints and bodies
 * where qn_mechanism_base() has brought them. Overwritten without being cleared. */
QnStatus qn_mechanism_of_result (QnMechanism *mechanism, const QnModel *model,
                                 const QnContacts *contacts, const QnResult *result,
                                 QnDiag *diag);

void qn_mechanism_clear (QnMechanism *mechanism);

/* Kind of the mechanism from its joints and bodies, as qn_mechanism_of_result() sets it. */
QnMechanismKind qn_mechanism_classify (const QnMechanism *mechanism, const QnModel *model,
                                       const QnContacts *contacts);

/* Points at which the relative motion of a face is computed: its outermost contact pairs; the ends of
 * the face if it has a single pair. */
void qn_joint_corners (const QnContacts *contacts, QnId face, QnVec2 *start, QnVec2 *end);

/* Cosine of two fields of the same model, in the metric of the masses (weights, or areas where
 * nothing weighs): 1 for the same mechanism whatever its scale, 0 for unrelated ones, -1 for
 * the reverse motion; 0 where a field is zero. */
double qn_mechanism_cosine (const QnModel *model, const double *a, const double *b);

/* Clusters of `count` fields whose cosines with the first of their cluster reach `threshold`:
 * groups[i] is the number of field i's cluster, numbered from 0 by first member. Returns the
 * number of clusters. fields: count pointers to block_count x 3. */
int32_t qn_mechanism_cluster (const QnModel *model, const double *const *fields,
                              int32_t count, double threshold, int32_t *groups);
