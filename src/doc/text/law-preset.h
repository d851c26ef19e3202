/* A typical law of every kind, with the history that shows what is particular about it. */
#ifndef QN_DOC_LAW_PRESET_H
#define QN_DOC_LAW_PRESET_H

#include "core/law/law.h"

#include <glib.h>

/* Most turning points of a history. */
#define QN_LAW_MAX_TURNS 64

typedef struct QnLawPreset {
  QnLaw law;
  gboolean shear;                 /* the history is one of slip, with `pressed` held */
  double pressed;                 /* normal elongation meanwhile, m or strain */
  double turns[QN_LAW_MAX_TURNS]; /* elongations that the history goes through, from 0 */
  gsize turn_count;
} QnLawPreset;

/* The preset of a kind; static. */
const QnLawPreset *qn_law_preset (QnLawKind kind);

/* Joints of usual masonry; sources of the values: docs/method/laws.md. */
typedef enum {
  QN_JOINT_DRY_STONE,
  QN_JOINT_LIME_MORTAR,
  QN_JOINT_CEMENT_MORTAR, /* of bricks */
  QN_JOINT_COUNT
} QnJointPreset;

/* Makes a law the Coulomb law of such a joint, without tensile strength and dilatancy; its basis and
 * stiffness stay. FALSE, and nothing changes, where the joint has a cohesion, which is a stress, and
 * the basis of the law is the contact pair. */
gboolean qn_law_make_joint (QnLaw *law, QnJointPreset joint);

/* Another kind for a law: what the new kind requires and the law does not have is typical. Laws of
 * members come with their basis and stiffness, joints keep theirs. */
void qn_law_change_kind (QnLaw *law, QnLawKind kind);

#endif
