/* Joints that are not quite where the drawing has them.
 *
 * Corners that pieces share are moved as one, at random, so that who touches whom stays as it was
 * and no gap opens:
 *
 *   - a corner in the middle of another piece's side stays on that side, and so do the ends of the
 *     side: the bed joints of a wall stay straight, its head joints lean;
 *   - what lies on a straight part of the outline stays on it;
 *   - corners of the outline that belong to one piece alone, and corners of foundations, stay.
 *
 * A corner moves by `size` times its distance from what it does not belong to, at most.
 */
#pragma once

#include "stereotomy/pieces.h"

/* Greatest size: two neighbours cannot pass each other. */
#define QN_MAX_PERTURBATION 0.4

/* size: 0 to QN_MAX_PERTURBATION. */
void qn_pieces_perturb (double size, uint32_t seed, QnPieces *pieces);
