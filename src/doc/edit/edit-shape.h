/* Edits of the shape of blocks: cutting, joining, corners.
 *
 * As in edit.h: on the copy that qn_document_edit() hands out, whole or refused. Blocks of walls
 * and masonry become free blocks of the same names first. Loads stay at their points of
 * application. Lengths in m. */
#pragma once

#include "core/result/mechanism.h"
#include "doc/edit/edit.h"
#include "stereotomy/ring.h"

/* Whether the segment passes through the inside of a block. */
gboolean qn_block_is_crossed (const QnModel *model, QnId block, QnVec2 a, QnVec2 b);

/* Cuts the blocks of the set, or all blocks where it is empty, that the segment from a to b
 * passes through, along the whole of its line. The largest part keeps the name. */
gboolean qn_edit_cut_blocks (QnModel *model, QnBlockSet set, QnVec2 a, QnVec2 b,
                             GError **error);

/* Makes one block of several that hang together; it takes everything else from the first. */
gboolean qn_edit_join_blocks (QnModel *model, QnBlockSet set, GError **error);

/* Makes one block of each body of a mechanism that was found in this model; of blocks that differ in thickness
 * or weight one each. */
gboolean qn_edit_join_bodies (QnModel *model, const QnMechanism *mechanism,
                              GError **error);

/* Moves every corner at a place to another one, so that joints stay closed. Corners of the set
 * only, or of all blocks where it is empty. */
gboolean qn_edit_move_corner (QnModel *model, QnBlockSet set, QnVec2 from, QnVec2 to,
                              GError **error);

/* ---- for edits ---- */

/* Puts other polygons in the place of the first block, which is free: it becomes the largest, loads go to the
 * one they act on. Other blocks in `gone` lose their corners, their loads go to the new ones. Numbers of
 * blocks stay until the model is built again. */
gboolean qn_edit_replace_blocks (QnModel *model, const QnId *gone, guint count,
                                 const QnRings *rings, GError **error);

/* The polygon of a block; clear it. */
QnRing qn_block_to_ring (const QnModel *model, QnId block);
