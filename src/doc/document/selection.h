/* The selection: blocks and beams, or contact faces, or an opening of parametric masonry, or a load or
 * reinforcing bar.
 *
 * Edits change numbers: blocks and beams are remembered by name, faces by the names of their blocks and
 * their place, loads and bars by their values. Emits "changed".
 */
#pragma once

#include "core/contact/contacts.h"
#include "doc/edit/edit-frame.h"
#include <glib-object.h>

#define QN_TYPE_SELECTION (qn_selection_get_type ())
G_DECLARE_FINAL_TYPE (QnSelection, qn_selection, QN, SELECTION, GObject)

/* Nothing selected. */
QnSelection *qn_selection_new (void);

/* The selected parts. */
typedef enum { QN_PART_BLOCK, QN_PART_BEAM, QN_PART_FACE, QN_PART_COUNT } QnPartKind;

gboolean qn_selection_is_empty (QnSelection *selection);
void qn_selection_clear (QnSelection *selection);
gboolean qn_selection_has (QnSelection *selection, QnPartKind kind, QnId id);
/* Numbers of the selected parts, ascending; borrowed. */
const QnId *qn_selection_get (QnSelection *selection, QnPartKind kind, guint *count);
/* These parts and nothing else. */
void qn_selection_set (QnSelection *selection, QnPartKind kind, const QnId *ids,
                       guint count);
/* These parts beside what is selected: blocks beside beams, faces beside faces alone. */
void qn_selection_add (QnSelection *selection, QnPartKind kind, const QnId *ids,
                       guint count);
void qn_selection_toggle (QnSelection *selection, QnPartKind kind, QnId id);

/* Selects a face and nothing else; QN_NONE for none. */
void qn_selection_set_face (QnSelection *selection, QnId face);
/* The first of the selected faces, or QN_NONE. */
QnId qn_selection_get_face (QnSelection *selection);

/* Selects an opening of a masonry object and nothing else. Both numbers are those of lists that
 * edits change: whoever asks must check that they still are. */
void qn_selection_set_opening (QnSelection *selection, QnId object, int opening);
gboolean qn_selection_get_opening (QnSelection *selection, QnId *object, int *opening);

/* Selects the i-th of the model's dead loads, live loads (those of all sets), bars or ties, and nothing
 * else; QN_NONE for none. */
void qn_selection_set_item (QnSelection *selection, QnItemKind kind, QnId id);
/* The selected one of this kind, or QN_NONE. */
QnId qn_selection_get_item (QnSelection *selection, QnItemKind kind);
/* The one of any kind, and which. */
QnId qn_selection_get_any_item (QnSelection *selection, QnItemKind *kind);

/* Every block and beam. */
void qn_selection_select_all (QnSelection *selection, const QnModel *model);

/* What belongs together: `block` or `face`, and all others that are like it. */
typedef enum {
  QN_LIKE_LAW,
  QN_LIKE_COURSE,   /* blocks: the course of a wall, */
  QN_LIKE_WALL,     /* the whole wall */
  QN_LIKE_LINE,     /* faces: a whole bed joint, or a vertical line of head joints, */
  QN_LIKE_DIRECTION /* all bed joints, all head joints */
} QnLikeness;
void qn_selection_select_blocks_like (QnSelection *selection, const QnModel *model,
                                      QnId block, QnLikeness likeness);
void qn_selection_select_faces_like (QnSelection *selection, const QnContacts *contacts,
                                     QnId face, QnLikeness likeness);

/* The selected blocks and beams; borrowed as long as the selection stays as it is. */
QnPartSet qn_selection_get_parts (QnSelection *selection);

/* Follows the blocks and beams of `before` to those of the same names in `after`, and faces to
 * those between them. */
void qn_selection_follow (QnSelection *selection, const QnModel *before,
                          const QnContacts *contacts_before, const QnModel *after,
                          const QnContacts *contacts_after);
