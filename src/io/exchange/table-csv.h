/* Tables as comma-separated values, units in the header, quoted where RFC 4180 requires it. Files
 * are written whole or not at all; errors are QN_IO_ERROR. */
#pragma once

#include "core/result/result.h"
#include "io/project/project.h"

/* Name of a block or, behind the blocks, of a node of beams. */
const char *qn_result_body_name (const QnModel *model, QnId body);

/* Load–displacement curve, a row per step: step number, multiplier, displacements of the block
 * of qn_result_curve_motion(), iterations, residual, event. */
gboolean qn_curve_csv_write (const char *path, const QnProject *project,
                             const QnResult *result, GError **error);

/* Displacements of every block at one step (< result->step_count). */
gboolean qn_displacements_csv_write (const char *path, const QnProject *project,
                                     const QnResult *result, size_t step, GError **error);

/* Every contact pair at the last equilibrium: forces, state, damage of the bond. */
gboolean qn_contacts_csv_write (const char *path, const QnProject *project,
                                const QnContacts *contacts, const QnResult *result,
                                GError **error);

/* The crossings of all bars at the last equilibrium, along each: force, stress, state. */
gboolean qn_bars_csv_write (const char *path, const QnProject *project,
                            const QnContacts *contacts, const QnResult *result,
                            GError **error);

/* Ties at every step that tells them. */
gboolean qn_ties_csv_write (const char *path, const QnProject *project,
                            const QnResult *result, GError **error);

/* Section forces of beams at the last equilibrium: both ends of every element. Only the header
 * where there are none, or the result has none. */
gboolean qn_beams_csv_write (const char *path, const QnProject *project,
                             const QnResult *result, GError **error);
