/* Contact faces and contact pairs, as detected in the undeformed configuration.
 *
 * A contact face is the overlap of an edge of block a with an edge of block b on a common
 * line, a < b. Every face carries contact pairs: places where two springs in series join the
 * two blocks. Source: HybriDFEM in 2D, sections 3 and 4 (see README, "Method").
 */
#pragma once

#include "core/base/memory.h"
#include "core/contact/contact-pair.h"
#include "core/contact/finding.h"
#include "core/model/model.h"

typedef struct QnContactFace {
  QnId a, b;           /* blocks, a < b */
  QnId edge_a, edge_b; /* first vertex, within the block, of the edge or collinear run */
  QnVec2 start, end;   /* m; end - start points along `tangent` */
  QnVec2 normal;       /* unit, from a to b */
  QnVec2 tangent;      /* unit, normal turned by +90 degrees */
  double length;       /* m */
  double thickness;    /* m, the smaller of the two blocks' */
  QnId law_a, law_b;   /* laws of the springs on the two sides */
  QnId first_pair;     /* into QnContacts.pairs */
  int32_t pair_count;
} QnContactFace;

typedef struct QnContactPair {
  QnId face;
  QnId bar;     /* into QnModel.bars, or QN_NONE: part of the joint itself */
  int32_t line; /* number of the line within the bar */
  double slant; /* sine of the line's angle to the face's normal, towards the tangent */
  QnVec2 point; /* where A, B and C coincide in the undeformed state, m */
  double abscissa; /* distance of the point from face.start, m */
  double
    tributary; /* tributary length, m; x thickness of the face: area, also of a bar */
  bool found;  /* during motion (contact-follow.h): `point` is a corner of block b */
  QnVec2 foot; /* found pairs: point on or below the side of block a, undeformed, m */
} QnContactPair;

/* A corner of one block near a side of another. */
typedef struct QnFoundContact {
  QnId block, side;   /* block of the side, and the side's first vertex within it */
  QnId other, corner; /* block of the corner, and the vertex within it */
  double foot;        /* m from the side's first vertex: point of zero shear elongation */
  double inset;       /* m below the side, >= 0: depth of zero normal elongation */
} QnFoundContact;

/* Faces are sorted by (a, b, position along the joint); pairs face by face, by abscissa, those
 * of bars after the others. */
typedef struct QnContacts {
  QnContactFace *faces;
  size_t face_count, face_capacity;
  QnContactPair *pairs;
  size_t pair_count, pair_capacity;
  QnFindings findings; /* gaps, overlaps, point contacts, loose and floating blocks */
  QnPool room; /* what detection needs for a while; failed: not all has been found */
} QnContacts;

/* Finds all faces and pairs of a prepared model in O(n log n) time. Overlaps deeper than the tolerance and
 * floating blocks become findings; qn_contacts_require_sound() refuses them. Refuses more than
 * QN_MOST_OVERLAPS or QN_MOST_NEIGHBOURS pairs of blocks, which would take quadratic time. `contacts` is
 * overwritten without being cleared, empty on failure. */
QnStatus qn_contacts_detect (const QnModel *model, QnContacts *contacts, QnDiag *diag);

/* Refuses models without blocks or supports, with overlapping or with floating blocks. */
QnStatus qn_contacts_require_sound (const QnModel *model, const QnContacts *contacts,
                                    QnDiag *diag);

/* Law of the spring on side 0 (block a) or 1 (block b) of a pair: the bar's or the face's. */
QnId qn_contacts_pair_law (const QnModel *model, const QnContacts *contacts, size_t pair,
                           int side);

/* Extent of a block along a direction, m. */
double qn_contacts_block_extent (const QnModel *model, QnId block, QnVec2 direction);

/* The springs of a pair. In the material basis each is as long as half the extent of its block
 * along the face's normal: a block's other half belongs to its far side. */
QnPairSprings qn_contacts_pair_springs (const QnModel *model, const QnContacts *contacts,
                                        size_t pair);

void qn_contacts_clear (QnContacts *contacts);
