/* Ties: unbonded tension members between two points of blocks, or of a block and the ground.
 *
 * A tie pulls along the straight line between its ends, with the force
 *
 *   N = E A / L (e - slack - plastic),   0 <= N <= min (A yield, anchor)
 *
 * where e is the increase of the distance of its ends and L the length as drawn. At the strength the steel
 * yields or the anchor gives, at constant force: `plastic` grows, and stays. A shortened tie is slack.
 *
 * A tie with a prestress P is tensioned under the dead load: its force there is P, whatever the
 * deformation, or more where the dead load stretches it,
 *
 *   N = max (P, P + E A / L e)
 *
 * and from then on it is an elastic tie that has this force. A tie has no weight.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

typedef struct QnTieEnd {
  QnId block; /* that the end is fixed to, or QN_NONE: the ground */
  QnVec2 at;  /* m, as drawn */
} QnTieEnd;

/* A round plate at the outside of a wall, and the strengths of this wall, as the user reduces them:
 *
 *   punching   shear pi t (D + t): a cone of 45 degrees through the wall, its surface projected on the
 *              plane of the wall, without vertical stress (used by Master Magazine 7, pages 75 and 99,
 *              masteritalia.org: a secondary source)
 *   bearing    compression pi D^2 / 4: the pressure below the plate, not raised for its small area
 *
 * Where a number is missing, 0, that strength is not known and limits nothing. */
typedef struct QnTiePlate {
  double diameter;    /* D, m */
  double wall;        /* t, thickness that the cone goes through, m */
  double shear;       /* strength of the masonry without compression, Pa */
  double compression; /* strength of the masonry across the wall, Pa */
} QnTiePlate;

/* A strip of fibres that is glued to blocks. Beside a joint it debonds at a constant force as long as
 * there is glued length behind. Per debonded length the strip releases N^2/(2 E A), and width times
 * fracture energy is dissipated:
 *
 *   debonding   width sqrt (2 E t fracture_energy),  t = area / width
 *
 * CNR-DT 200 R1/2013 and others have this form with a fracture energy and factors of their own, which
 * could not be read: the user gives it. */
typedef struct QnTieStrip {
  double width;           /* m; 0: no strip */
  double fracture_energy; /* of the bond, J/m2; 0: not known, limits nothing */
} QnTieStrip;

typedef struct QnTie {
  char *name; /* owned, unique among ties */
  QnTieEnd ends[2];
  double area;       /* A, m2, > 0 */
  double elasticity; /* E, Pa, > 0 */
  double yield;      /* Pa; 0: does not yield */
  double prestress;  /* P, N, >= 0, at most the strength */
  double slack;      /* m, >= 0; 0 where there is prestress */
  double anchor;     /* what an anchor holds, N; 0: no limit */
  QnTiePlate plate;  /* of the weaker anchor; limits it likewise */
  QnTieStrip strip;  /* and so does its debonding */
  int32_t note;      /* as in QnBlock */
} QnTie;

typedef enum {
  QN_TIE_SLACK,
  QN_TIE_ELASTIC,
  QN_TIE_YIELDS, /* the steel has its strength */
  QN_TIE_ANCHOR, /* the anchor has */
  QN_TIE_STATE_COUNT
} QnTieState;

/* State of a tie at a step. */
typedef struct QnTieResult {
  double force;      /* N, >= 0; NAN: not known */
  double elongation; /* e, m */
  QnTieState state;
} QnTieResult;

/* Spelling in result files: "slack", "elastic", "yields", "anchor". */
extern const char *const qn_tie_state_names[QN_TIE_STATE_COUNT];

double qn_tie_length (const QnTie *tie);    /* L, m */
double qn_tie_stiffness (const QnTie *tie); /* E A / L, N/m */

/* Strength of the wall at a plate and along a strip, N; INFINITY: not known. Least of these and of
 * `anchor`. */
double qn_tie_plate_punching (const QnTiePlate *plate);
double qn_tie_plate_bearing (const QnTiePlate *plate);
double qn_tie_debonding (const QnTie *tie);
double qn_tie_anchor (const QnTie *tie);

/* Largest force, N; INFINITY: no limit. And which limit it is: the steel or the anchor. */
double qn_tie_strength (const QnTie *tie);
QnTieState qn_tie_weakest (const QnTie *tie);

/* State of a tie with this force, N; a limit is reached within `little`, N. */
QnTieState qn_tie_state (const QnTie *tie, double force, double little);
