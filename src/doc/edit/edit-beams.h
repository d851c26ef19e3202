/* Part of rebuilding a model: beams follow the blocks that their nodes ride on. */
#pragma once

#include "doc/edit/edit.h"

/* Where nodes and beams of the old model went; QN_NONE: they are gone. */
typedef struct QnBeamRebuild {
  QnId *nodes, *beams;
} QnBeamRebuild;

/* Copies nodes and beams into a model that has its blocks and sections already, and cuts the beams.
 * follow: the new number of an old block, or QN_NONE. A node goes with its block, a beam with
 * either of its nodes or where it names none, and a node that stands free with the last of its
 * beams. FALSE where memory runs out or, with the
 * reason in `diag`, a beam cannot be cut. Clear the rebuild in either case. */
gboolean qn_edit_copy_beams (const QnModel *from, QnModel *to,
                             QnId (*follow) (gconstpointer data, QnId block),
                             gconstpointer data, QnBeamRebuild *rebuild, QnDiag *diag);

void qn_beam_rebuild_clear (QnBeamRebuild *rebuild);

/* Nodes at given points of the blocks go where the transform takes those blocks; so do nodes
 * that stand free where every block of the model is among them; and so do the ends of ties. flags: one per
 * block. */
void qn_edit_transform_nodes (QnModel *model, const gboolean *flags,
                              QnTransform transform);
