/* Joints of usual masonry, with the literature that their numbers come from: docs/method/laws.md. */
#pragma once

#include "core/law/law.h"

#include <glib.h>

typedef enum {
  QN_JOINT_DRY_STONE,
  QN_JOINT_LIME_MORTAR, /* of squared stone */
  QN_JOINT_BRICK,       /* and cement-lime mortar */
  QN_JOINT_SOIL,        /* under a foundation: springs that do not pull, Winkler's */
  QN_JOINT_COUNT
} QnTypicalJointKind;

typedef struct QnTypicalJoint {
  const char *name;   /* to be translated */
  double friction;    /* tangent */
  double cohesion;    /* Pa */
  double fracture;    /* J/m2, energy of slip; exponential softening; 0: brittle */
  double kn, ks;      /* Pa/m, of the joint: each of its two springs has twice as much */
  double unit_weight; /* N/m3, of the blocks */
  const char *source; /* to be translated where it is shown; files have it as it is */
} QnTypicalJoint;

extern const QnTypicalJoint qn_typical_joints[QN_JOINT_COUNT];

/* Makes a law the Coulomb law of such a joint by area, without tensile strength and dilatancy, and
 * sets its source. FALSE when memory runs out. */
gboolean qn_law_make_joint (QnLaw *law, QnTypicalJointKind kind);

/* The source of a law, translated if it is a typical joint's; NULL where it has none. `holds`: whether
 * the law still has the numbers of the joint; TRUE where the source is no typical joint's. */
const char *qn_law_get_source (const QnLaw *law, gboolean *holds);

typedef struct QnTypicalStone {
  const char *name;   /* to be translated */
  double unit_weight; /* N/m3: the middle of the range that the source gives */
  const char *source; /* with that range; to be translated */
} QnTypicalStone;

enum { QN_STONE_COUNT = 8 };

extern const QnTypicalStone qn_typical_stones[QN_STONE_COUNT];

/* The first that weighs as much, or -1. */
int qn_typical_stone_find (double unit_weight);
