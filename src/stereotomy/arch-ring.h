/* The geometry of arches: intrados, extrados and voussoirs. Private to this layer.
 *
 * Positions along the arch are given by u, 0 at the left springing and 1 at the right one: the
 * part of the intrados' length, of the length of its two arcs (pointed).
 * The extrados is the parallel curve at the ring's thickness, so joints are normal to both;
 * only at the crown of a pointed arch, where the two halves meet, the joint is the vertical.
 *
 * Curves become chords with ends on the curve; `straight` sides have one chord per voussoir
 * (two at a pointed keystone), `curved` ones as many as keep the sagitta below
 * QN_ARCH_SAGITTA of the radius. Mirrored points are mirrored exactly.
 */
#pragma once

#include "stereotomy/masonry.h"
#include "stereotomy/ring.h"

#define QN_ARCH_SAGITTA 0.002

typedef struct QnArchRing {
  QnArch arch;
  double radius;  /* m, circular and pointed */
  double centre;  /* height of the centre (circular), or its distance beyond the middle of
                     the span (pointed), m */
  double opening; /* rad: from springing to crown, as seen from the centre */
  double outer_opening; /* pointed: the same on the extrados */
  double half_length;   /* m, the other shapes: half the intrados */
  double crown_radius;  /* m, three-centred: of the circle in the middle, */
  double crown_opening; /* half of the angle it turns by, rad */
  int32_t chords;       /* per voussoir */
} QnArchRing;

/* `arch` has passed qn_arch_check(). */
void qn_arch_ring_init (QnArchRing *ring, const QnArch *arch);

/* Point at a distance outside the intrados, relative to the left springing. */
QnVec2 qn_arch_ring_point (const QnArchRing *ring, double u, double offset);

/* End on the extrados of the joint at u. */
static inline QnVec2
qn_arch_ring_extrados (const QnArchRing *ring, double u)
{
  return qn_arch_ring_point (ring, u, ring->arch.ring);
}

/* Voussoir `index` from the left of a ring, counted from 0 inside; counter-clockwise. */
QnRing qn_arch_ring_voussoir (const QnArchRing *ring, int32_t course, int32_t index);

/* How many rings there are; the smaller radius of a three-centred arch, m. */
static inline int32_t
qn_arch_rings (const QnArch *arch)
{
  return arch->rings == 0 ? 1 : arch->rings;
}

double qn_arch_haunch (const QnArch *arch);

/* The intrados, for the hole below it, or the extrados, from the left springing up to a level or to the
 * right one, as the voussoirs have it: an open line. */
QnRing qn_arch_ring_line (const QnArchRing *ring, bool outside, double level);
