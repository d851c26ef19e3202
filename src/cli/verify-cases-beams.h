/* Cases with beam elements. */
#ifndef QN_CLI_VERIFY_CASES_BEAMS_H
#define QN_CLI_VERIFY_CASES_BEAMS_H

#include "cli/verify-cases.h"

#define QN_VERIFY_BEAM_CASES     7
#define QN_VERIFY_ELASTICA_CASES 12
#define QN_VERIFY_FRAME_CASES    3

extern const QnVerifyCase qn_verify_beams[QN_VERIFY_BEAM_CASES];
extern const QnVerifyCase qn_verify_beam_elastica[QN_VERIFY_ELASTICA_CASES];

/* The frame three ways: its sway under 4 kN, and its collapse. */
extern const QnVerifyCase qn_verify_frame_sway[QN_VERIFY_FRAME_CASES];
extern const QnVerifyCase qn_verify_frame_collapse[QN_VERIFY_FRAME_CASES];

#endif
