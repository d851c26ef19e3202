/* Edits of ties, on the draft of qn_document_edit(), with errors as in edit.h. What breaks a rule of ties
 * (both ends on one block, or on the ground) is refused when the draft becomes the document. */
#pragma once

#include "core/model/bar.h"
#include "doc/edit/edit.h"
#include "doc/text/units.h"

/* Steels that forms offer: modulus of elasticity and yield stress, Pa. */
typedef struct QnTieSteel {
  const char *name;
  double elasticity, yield;
} QnTieSteel;

#define QN_TIE_STEELS 4
extern const QnTieSteel qn_tie_steels[QN_TIE_STEELS];

/* Diameters of round bars that forms offer, m. */
#define QN_TIE_DIAMETERS 9
extern const double qn_tie_diameters[QN_TIE_DIAMETERS];

/* A tie of 20 mm and the first steel from point to point, m, without prestress and limit of its anchors. An
 * end on a block is fixed to it, elsewhere to the ground. */
gboolean qn_edit_draw_tie (QnModel *model, QnVec2 from, QnVec2 to, GError **error);

/* A strip that is glued to the blocks along its line: a tie from each of them to the next, from middle to
 * middle of what it covers, in place of the tie. */
gboolean qn_edit_glue_tie (QnModel *model, QnId tie, GError **error);

/* Moves an end, to the block there or to the ground. */
gboolean qn_edit_place_tie_end (QnModel *model, QnId tie, int end, QnVec2 at,
                                GError **error);

/* "t1, Ø 20 mm: left – right"; the caller frees it. */
char *qn_tie_dup_text (const QnModel *model, const QnTie *tie, QnUnits units);

/* "4 m, 53 kN/mm, strength 4.5 kN (anchor)"; the caller frees it. */
char *qn_tie_dup_facts (const QnTie *tie, QnUnits units);

/* Adds a bar of 16 mm through the middle of the box of these blocks, level or upright, which
 * meets more of them. Its law is
 * the first of a ductile metal, or a new one of steel. */
gboolean qn_edit_add_bar (QnModel *model, QnBlockSet set, GError **error);

/* Adds one of 16 mm from point to point, m. */
gboolean qn_edit_draw_bar (QnModel *model, QnVec2 start, QnVec2 end, GError **error);

/* "steel, Ø 16 mm: 0; 0.2 m – 2.9; 0.2 m"; the caller frees it. */
char *qn_bar_dup_text (const QnModel *model, const QnBar *bar, QnUnits units);
