/* Cases with beam elements. */
#ifndef QN_CLI_VERIFY_CASES_BEAMS_H
#define QN_CLI_VERIFY_CASES_BEAMS_H

#include "cli/verify/verify-cases.h"

#define QN_VERIFY_BEAM_CASES  7
#define QN_VERIFY_FRAME_CASES 3

/* Elastica, the same of beams and of blocks: tip of a cantilever of length 1 under P L^2/EI = 1, 2,
 * 5, 10 in four stages: down, in, turned. CASE (name, component, reference, stage). */
#define QN_VERIFY_ELASTICA_CASES 12
#define QN_VERIFY_ELASTICA(CASE)                                                         \
  CASE (N_ ("a = 1, down"), QN_DOF_UY, -0.30172, 1),                                     \
    CASE (N_ ("a = 1, in"), QN_DOF_UX, -0.05643, 1),                                     \
    CASE (N_ ("a = 1, turned"), QN_DOF_RZ, -0.46135, 1),                                 \
    CASE (N_ ("a = 2, down"), QN_DOF_UY, -0.49346, 2),                                   \
    CASE (N_ ("a = 2, in"), QN_DOF_UX, -0.16064, 2),                                     \
    CASE (N_ ("a = 2, turned"), QN_DOF_RZ, -0.78175, 2),                                 \
    CASE (N_ ("a = 5, down"), QN_DOF_UY, -0.71379, 3),                                   \
    CASE (N_ ("a = 5, in"), QN_DOF_UX, -0.38763, 3),                                     \
    CASE (N_ ("a = 5, turned"), QN_DOF_RZ, -1.21537, 3),                                 \
    CASE (N_ ("a = 10, down"), QN_DOF_UY, -0.81061, 4),                                  \
    CASE (N_ ("a = 10, in"), QN_DOF_UX, -0.55500, 4),                                    \
    CASE (N_ ("a = 10, turned"), QN_DOF_RZ, -1.43029, 4)

extern const QnVerifyCase qn_verify_beams[QN_VERIFY_BEAM_CASES];
extern const QnVerifyCase qn_verify_beam_elastica[QN_VERIFY_ELASTICA_CASES];

/* The frame three ways: its sway under 4 kN, and its collapse. */
extern const QnVerifyCase qn_verify_frame_sway[QN_VERIFY_FRAME_CASES];
extern const QnVerifyCase qn_verify_frame_collapse[QN_VERIFY_FRAME_CASES];

#endif
