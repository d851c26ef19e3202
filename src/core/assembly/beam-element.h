/* Mechanics of one beam element in its basic system: two ends, six displacements.
 *
 * A rigid motion leaves three deformations: elongation e of the chord and the rotations of
 * both ends against it. With the shear number phi = 12 EI / (k G A L^2), 0 for Euler and
 * Bernoulli,
 *
 *   N = EA/L e
 *   M = EI / (L (1 + phi)) [4 + phi, 2 - phi; 2 - phi, 4 + phi] theta
 *
 * is exact for a Timoshenko beam under end forces. In nonlinear geometry the chord follows
 * the ends (corotational: Crisfield 1991, Non-linear Finite Element Analysis of Solids and
 * Structures 1, section 7.3), rotations are of any size, deformations against the chord small.
 *
 * An end may yield at its plastic moment (0: hinged), perfectly plastic. Its rotation is the sum of the
 * beam's and of the hinge's; return mapping finds the hinge's, at which the moment is the limit.
 *
 * Moments M on the ends are counter-clockwise; displacements in the order u1 v1 r1 u2 v2 r2.
 */
#pragma once

#include "core/model/beam.h"
#include "core/model/tie.h"

typedef struct QnBeamProperties {
  QnVec2 chord;      /* from end to end, undeformed, m */
  double length;     /* m */
  double axial;      /* EA/L, N/m */
  double bending;    /* EI/L, N m */
  double phi;        /* shear number */
  double moments[2]; /* plastic moments of the ends: 0 hinged, INFINITY rigid */
  double mass;       /* kg/m */
  double rotary;     /* rho I, kg m */
  const QnTie *tie;  /* borrowed; NULL: a beam. A tie has hinged ends and no mass */
  double rest;       /* of a tie: elongation at zero force before it yields, m */
} QnBeamProperties;

/* Plastic rotation of a yielding end, rad. */
typedef struct QnBeamMemory {
  double plastic[2];
  double stretch; /* of a tie: plastic elongation, m */
  bool tensioned; /* of a tie: its prestress has been applied */
} QnBeamMemory;

typedef struct QnBeamResponse {
  QnBeamMemory memory;
  double force[3];      /* N, M1, M2 */
  double tangent[3][3]; /* d force / d (e, theta1, theta2) */
  int8_t phase; /* yielding ends and their senses, 0: none; tie: whether it pulls */
} QnBeamResponse;

/* Position of the element; gradient of its deformations by its displacements. */
typedef struct QnBeamKinematics {
  double deformation[3]; /* e, theta1, theta2 */
  double gradient[3][6];
  QnVec2 axis;   /* unit, along the chord */
  double length; /* of the chord, m */
} QnBeamKinematics;

void qn_beam_kinematics_init (QnBeamKinematics *kinematics,
                              const QnBeamProperties *properties);

/* At displacements v (m, m, rad, twice); linear geometry leaves the gradient as it was. */
void qn_beam_kinematics_update (QnBeamKinematics *kinematics,
                                const QnBeamProperties *properties, const double v[6],
                                bool nonlinear);

/* Adds N and M times the second derivatives of the deformations. */
void qn_beam_kinematics_add_stiffness (const QnBeamKinematics *kinematics,
                                       const double force[3], double k[6][6]);

/* Forces and consistent tangent at a deformation, from the committed memory. */
void qn_beam_evaluate (const QnBeamProperties *properties, const QnBeamMemory *committed,
                       const double deformation[3], QnBeamResponse *response);

/* The same of a tie (core/model/tie.h). */
void qn_tie_evaluate (const QnBeamProperties *properties, const QnBeamMemory *committed,
                      const double deformation[3], QnBeamResponse *response);

/* Fixed-end moments of a load q (N/m along y) over the length; 0 at hinged ends. */
void qn_beam_fixed_end_moments (const QnBeamProperties *properties, double q,
                                double moments[2]);

/* Consistent mass matrix for v, by the shape functions of the linear element. */
void qn_beam_mass (const QnBeamProperties *properties, double mass[6][6]);

/* Displacement of the axis against the chord at x = s L, along y, m. From the section moments at
 * the ends (see QnBeamForces), so that hinges show as kinks; q: N/m along y. */
double qn_beam_deflection (const QnBeamProperties *properties, const double moments[2],
                           double q, double s);
