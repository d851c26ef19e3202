/* Tables as comma-separated values, units in the header, quoted where RFC 4180 requires it. Files
 * are written whole or not at all; errors are QN_IO_ERROR. */
#pragma once

#include "core/result/result.h"
#include "io/project/project.h"

/* Name of a block or, behind the blocks, of a node of beams. */
const char *qn_result_body_name (const QnModel *model, QnId body);

typedef enum {
  /* Load–displacement curve, a row per step: step number, multiplier, displacements of the block
   * of qn_result_curve_motion(), iterations, residual, event. */
  QN_TABLE_CURVE,
  QN_TABLE_DISPLACEMENTS, /* of every block at the last step */
  QN_TABLE_CONTACTS, /* every pair at the last equilibrium: forces, state, damage of the bond */
  QN_TABLE_BEAMS, /* section forces at the last equilibrium, at both ends of every element */
  QN_TABLE_BARS, /* the crossings of all bars at the last equilibrium: force, stress, state */
  QN_TABLE_TIES, /* at every step that tells them */
  QN_TABLE_COUNT
} QnResultTable;

/* Only the header where the result has nothing of it. */
gboolean qn_result_table_write (const char *path, QnResultTable table,
                                const QnProject *project, const QnContacts *contacts,
                                const QnResult *result, GError **error);
