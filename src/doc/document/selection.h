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

/* To read; blocks, beams and faces may be many. */
struct _QnSelection {
  GObject parent_instance;
  GArray *ids[QN_PICK_TIE + 1]; /* by QnPickKind; of QnId, ascending */
  QnId object;                  /* of the opening, or QN_NONE */
  int opening;
};

gboolean qn_selection_is_empty (QnSelection *selection);
void qn_selection_clear (QnSelection *selection);
gboolean qn_selection_has (QnSelection *selection, QnPickKind kind, QnId id);
/* Numbers of the selected parts, ascending; borrowed. */
const QnId *qn_selection_get (QnSelection *selection, QnPickKind kind, guint *count);
/* These parts and nothing else. */
void qn_selection_set (QnSelection *selection, QnPickKind kind, const QnId *ids,
                       guint count);
/* These parts beside what is selected: blocks beside beams, faces beside faces alone. */
void qn_selection_add (QnSelection *selection, QnPickKind kind, const QnId *ids,
                       guint count);
void qn_selection_toggle (QnSelection *selection, QnPickKind kind, QnId id);

/* Selects one of this kind and nothing else; QN_NONE for none. */
void qn_selection_set_one (QnSelection *selection, QnPickKind kind, QnId id);
/* The first of the selected ones of this kind, or QN_NONE. */
QnId qn_selection_get_one (QnSelection *selection, QnPickKind kind);
/* The selected load, bar or tie. */
QnPick qn_selection_get_item (QnSelection *selection);

/* Selects an opening of a masonry object and nothing else. Both numbers are those of lists that
 * edits change: whoever asks must check that they still are. */
void qn_selection_set_opening (QnSelection *selection, QnId object, int opening);

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
