#include "cli/verify/verify-cases-beams.h"

#include <glib/gi18n.h>

/* Cantilever: PL^3/3EI + PL/kGA, PL^2/2EI. Column: pi^2 EI/(2L)^2 in kN. Mast: 20 kN x 0.5 m
 * over 3 m. Timoshenko beam, simply supported, its ends axially fixed. */
const QnVerifyCase qn_verify_beams[QN_VERIFY_BEAM_CASES] = {
  { .name = N_ ("Cantilever, end (m)"),
    .model = "30-beam-cantilever.quoin",
    .reference = -0.01464,
    .tolerance = 1e-9,
    .quantity = QN_VERIFY_DISPLACEMENT,
    .block = "tip",
    .dof = QN_DOF_UY },
  { .name = N_ ("Cantilever, turned"),
    .model = "30-beam-cantilever.quoin",
    .reference = -0.0072,
    .tolerance = 1e-9,
    .quantity = QN_VERIFY_DISPLACEMENT,
    .block = "tip",
    .dof = QN_DOF_RZ },
  { .name = N_ ("Column, Euler (kN)"),
    .model = "35-beam-column.quoin",
    .reference = 616.850275,
    .tolerance = 1e-3,
    .quantity = QN_VERIFY_CRITICAL },
  { .name = N_ ("Mast overturns its block"),
    .model = "36-mast-on-block.quoin",
    .reference = 10. / 3,
    .tolerance = 1e-5 },
  { .name = N_ ("Rod, mode 1 (rad/s)"),
    .model = "37-beam-vibrating.quoin",
    .reference = 315.819,
    .tolerance = 1e-3,
    .quantity = QN_VERIFY_FREQUENCY,
    .number = 1 },
  { .name = N_ ("Rod, mode 2"),
    .model = "37-beam-vibrating.quoin",
    .reference = 1151.685,
    .tolerance = 1e-3,
    .quantity = QN_VERIFY_FREQUENCY,
    .number = 2 },
  { .name =
      N_ ("Rod, mode 3"), /* after the first one of stretching, pi sqrt (E / rho) / L */
    .model = "37-beam-vibrating.quoin",
    .reference = 2304.893,
    .tolerance = 1e-3,
    .quantity = QN_VERIFY_FREQUENCY,
    .number = 4 },
};

#define ELASTICA(label, component, value, stage)                                         \
  {                                                                                      \
    .name = label, .model = "31-beam-elastica.quoin", .reference = value,                \
    .tolerance = 0.005, .quantity = QN_VERIFY_DISPLACEMENT, .block = "tip",              \
    .dof = component, .number = stage                                                    \
  }

const QnVerifyCase qn_verify_beam_elastica[QN_VERIFY_ELASTICA_CASES] = {
  QN_VERIFY_ELASTICA (ELASTICA),
};

/* Sway of the frame 3 x 3 m under H = 4 kN: H h^3/6EIc + H h^2 L/12EIb in bending (4.5 mm), in
 * shear H h/2kGAc + H h^2/L kGAb, by the columns' shortening 2 H h^3/L^2 EAc, and half of the
 * beam's, H L/4EAb. Collapse: H h = 2 Mp of the beam. */
#define SWAY(label, file, corner)                                                        \
  {                                                                                      \
    .name = label, .model = file, .reference = 0.00455190, .tolerance = 0.01,            \
    .quantity = QN_VERIFY_DISPLACEMENT, .block = corner, .dof = QN_DOF_UX                \
  }

const QnVerifyCase qn_verify_frame_sway[QN_VERIFY_FRAME_CASES] = {
  SWAY (N_ ("Beams only"), "32-frame-beams.quoin", "left corner"),
  SWAY (N_ ("Blocks only"), "33-frame-blocks.quoin", "left corner"),
  SWAY (N_ ("Blocks where it yields"), "34-frame-hybrid.quoin", "left corner"),
};

#define YIELDS(label, file, allowed)                                                     \
  {                                                                                      \
    .name = label, .model = file, .reference = 80. / 3, .tolerance = allowed             \
  }

const QnVerifyCase qn_verify_frame_collapse[QN_VERIFY_FRAME_CASES] = {
  YIELDS (N_ ("Beams only"), "32-frame-beams.quoin", 1e-5),
  YIELDS (N_ ("Blocks only"), "33-frame-blocks.quoin", 0.02),
  YIELDS (N_ ("Blocks where it yields"), "34-frame-hybrid.quoin", 0.02),
};
