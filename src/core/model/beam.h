/* Beams: members without a body of their own, between nodes, in one system with the blocks.
 *
 * A node stands free, with three degrees of freedom, or rides on a block: at its centroid
 * (the shared node), at a point of it, or in the middle of one of its sides (rigid links). A
 * beam joins two nodes, has a section, and is cut into elements of equal length by nodes that
 * the model adds.
 *
 * Axes of a beam: x from its first node to its second, y is x turned by +90 degrees.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

/* Most elements of one beam, and most elements and nodes of a model. */
#define QN_MAX_BEAM_ELEMENTS 10000
#define QN_MAX_NODES         1000000

typedef enum {
  QN_SEAT_FREE,     /* stands by itself */
  QN_SEAT_CENTROID, /* rides on a block: its centroid, */
  QN_SEAT_POINT,    /* a point, inside the block or not, */
  QN_SEAT_SIDE,     /* the middle of a side */
  QN_SEAT_COUNT
} QnSeat;

typedef enum {
  QN_BLOCK_SIDE_LEFT,
  QN_BLOCK_SIDE_RIGHT,
  QN_BLOCK_SIDE_BOTTOM,
  QN_BLOCK_SIDE_TOP,
  QN_BLOCK_SIDE_COUNT
} QnBlockSide;

typedef struct QnNode {
  char *name; /* owned, unique among nodes */
  QnSeat seat;
  QnVec2 at;                  /* m; follows from the block for CENTROID and SIDE */
  QnId block;                 /* that the node rides on, or QN_NONE */
  QnBlockSide side;           /* SIDE: the side that faces this way most */
  bool support[QN_DOF_COUNT]; /* fixed degrees of freedom; FREE only */
  QnId beam;                  /* beam that this node cuts, or QN_NONE: of the project */
  int32_t note;               /* as in QnBlock */

  bool turns; /* derived: a beam that is not hinged ends here, or the block turns */
} QnNode;

typedef struct QnSection {
  char *name;            /* owned, unique among sections */
  double young;          /* E, Pa, > 0 */
  double shear_modulus;  /* G, Pa; 0: from E and Poisson's ratio */
  double poisson;        /* nu, -1 < nu <= 0.5 */
  double width, height;  /* of a rectangle, m; height 0: area and inertia are given */
  double area;           /* A, m2 */
  double inertia;        /* I, m4 */
  double shear_factor;   /* k, of A: 5/6 for a rectangle */
  double yield;          /* fy, Pa, rectangles only; 0: does not yield */
  double plastic_moment; /* Mp, N m; 0: from yield */
  double unit_weight;    /* N/m3, >= 0 */
  double density;        /* kg/m3 as given, or < 0 where unit_weight was given */
  int32_t note;          /* as in QnBlock */
} QnSection;

typedef enum {
  QN_BEAM_TIMOSHENKO,
  QN_BEAM_EULER_BERNOULLI,
  QN_BEAM_KIND_COUNT
} QnBeamKind;

typedef struct QnBeam {
  char *name; /* owned, unique among beams */
  QnBeamKind kind;
  QnId nodes[2];
  QnId section;
  bool hinge[2];         /* no moment at this end */
  int32_t element_count; /* >= 1 */
  int32_t note;          /* as in QnBlock */

  QnId first_element; /* derived: into QnModel.elements */
} QnBeam;

/* A part of a beam with end forces of its own; derived. */
typedef struct QnBeamElement {
  QnId beam;
  QnId nodes[2];
  bool hinge[2];
  bool yields[2]; /* whether a plastic hinge may form at this end: one of those at a node
                     inside a beam is enough */
} QnBeamElement;

/* Section forces of an element at its two ends, in the axes of the (deformed) chord. */
typedef struct QnBeamForces {
  double normal[2]; /* N: tension positive */
  double shear[2];  /* V = dM/dx */
  double moment[2]; /* M, N m: positive with tension at the side of -y */
} QnBeamForces;

/* Section forces at one place. */
typedef struct QnBeamPoint {
  double normal, shear; /* N */
  double moment;        /* N m */
} QnBeamPoint;

/* Inside of an element of this length, at x = s length: the load is constant along it, so that N
 * and V are linear and M is quadratic. */
QnBeamPoint qn_beam_forces_at (const QnBeamForces *forces, double length, double s);

/* Spelling in project files: "timoshenko", "euler-bernoulli"; "left", "right", … */
extern const char *const qn_beam_kind_names[QN_BEAM_KIND_COUNT];
extern const char *const qn_block_side_names[QN_BLOCK_SIDE_COUNT];

/* Derived: G, Pa; Mp, N m (INFINITY: never yields); weight per length. */
double qn_section_shear_modulus (const QnSection *section);
double qn_section_plastic_moment (const QnSection *section);
double qn_section_weight (const QnSection *section); /* N/m */
