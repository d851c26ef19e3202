/* Small vibrations about an equilibrium: frequencies and modes.
 *
 *   K phi = omega^2 M phi
 *
 * K is the stiffness of the state: closed joints are elastic, whether they slide under the load or
 * not, and open joints have none; or the tangent, with sliding joints (QN_MODAL_SLIDING). M is
 * the mass: of rigid blocks weight over gravity, with the polar moment of inertia about the
 * centroid for the rotation, diagonal at the centroids; of beams consistent with their shape
 * functions. The lowest frequencies come from Lanczos iteration (lanczos.h) with a small negative
 * shift, so that structures without supports have their rigid motions as modes of frequency zero.
 */
#pragma once

#include "core/base/progress.h"
#include "core/result/result.h"

typedef struct QnModes {
  size_t count, block_count, node_count;
  double *omega;  /* rad/s, ascending; rigid motions and what is numerically zero: 0 */
  double *shapes; /* count x (block_count + node_count) x 3: m, m, rad; largest
                     displacement 1 m */
  double *
    masses; /* count x 3, kg: of the mode so scaled, phi' M phi; and the effective ones in x and
                     y, (phi' M r)^2 / phi' M phi with r the unit translation: those of all modes sum up
                     to the mass that moves */
  size_t open,
    slides; /* open pairs, without stiffness; sliding pairs with elastic stiffness */
} QnModes;

/* State about which the structure vibrates. */
typedef enum {
  QN_MODAL_DEAD_LOAD = 0, /* the equilibrium under dead load */
  QN_MODAL_LOADED = 1,    /* the last equilibrium of the analysis of the settings */
  QN_MODAL_SLIDING = 2    /* or'ed to either: the tangent, with joints that slide */
} QnModalState;

/* Solves for the `wanted` (>= 1) lowest modes, or as many as there are. *result holds the path up
 * to the state; where it has no equilibrium, or its outcome is CANCELLED, *modes is empty. The
 * path is proved as that of every analysis; the modes are proved by their residuals, their
 * orthogonality, and the inertia of the stiffness, which shows that none is missing. Refuses
 * states that are not stable, blocks without mass, and with SLIDING states in which pairs slip
 * without dilatancy, whose stiffness is not symmetric. Both outputs are overwritten without being
 * cleared, and empty on failure. */
QnStatus qn_modal_run (const QnModel *model, const QnContacts *contacts,
                       QnModalState state, size_t wanted, QnProgressFunc progress,
                       void *user_data, QnModes *modes, QnResult *result, QnDiag *diag);

/* Rayleigh's damping, 2 ratio omega = mass + stiffness omega^2, of the first mode that is no rigid motion
 * and of the last one, counted from 0: coefficients of mass, 1/s, and of stiffness, s. */
typedef struct QnModesDamping {
  size_t first, last;
  double mass, stiffness;
} QnModesDamping;

QnModesDamping qn_modes_damping (const QnModes *modes, double ratio);

/* The mode with the largest effective mass along x, counted from 0, that is no rigid motion; modes->count
 * where there is none. */
size_t qn_modes_main (const QnModes *modes);

/* Stores a mode (from 0) as the mechanism of `result`, which holds the state of the modes. */
QnStatus qn_modes_show (const QnModes *modes, size_t mode, const QnModel *model,
                        QnResult *result, QnDiag *diag);

void qn_modes_clear (QnModes *modes);
