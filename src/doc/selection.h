/* What is selected: blocks, or a contact face.
 *
 * Blocks are remembered by name across edits, because their numbers change. Emits "changed".
 */
#ifndef QN_DOC_SELECTION_H
#define QN_DOC_SELECTION_H

#include "core/contacts.h"
#include <glib-object.h>

#define QN_TYPE_SELECTION (qn_selection_get_type ())
G_DECLARE_FINAL_TYPE (QnSelection, qn_selection, QN, SELECTION, GObject)

QnSelection *qn_selection_new (void);

gboolean qn_selection_has_block (QnSelection *selection, QnId block);
/* Numbers of the selected blocks, ascending; borrowed. */
const QnId *qn_selection_get_blocks (QnSelection *selection, guint *count);

void qn_selection_clear (QnSelection *selection);
void qn_selection_set_blocks (QnSelection *selection, const QnId *blocks, guint count);
void qn_selection_add_blocks (QnSelection *selection, const QnId *blocks, guint count);
void qn_selection_toggle_block (QnSelection *selection, QnId block);

/* Selects a face and nothing else; QN_NONE for none. */
void qn_selection_set_face (QnSelection *selection, QnId face);
QnId qn_selection_get_face (QnSelection *selection);

/* Sets of blocks that belong together: the course of a wall block, its whole wall, all blocks
 * of the same law. `block` is in every one of them. */
void qn_selection_select_all (QnSelection *selection, const QnModel *model);
void qn_selection_select_course (QnSelection *selection, const QnModel *model,
                                 QnId block);
void qn_selection_select_wall (QnSelection *selection, const QnModel *model, QnId block);
void qn_selection_select_same_law (QnSelection *selection, const QnModel *model,
                                   QnId block);

/* Follows the blocks of `before` to those of the same names in `after`. */
void qn_selection_follow (QnSelection *selection, const QnModel *before,
                          const QnModel *after);

#endif
