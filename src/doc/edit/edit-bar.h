/* Edits of reinforcing bars, on the draft of qn_document_edit(), with errors as in edit.h. What breaks
 * a rule of bars (they cross joints at right angles, their law has a basis of its own) is refused when
 * the draft becomes the document. */
#pragma once

#include "core/model/bar.h"
#include "doc/edit/edit.h"
#include "doc/text/units.h"

/* Adds a bar of 16 mm through the middle of the box of these blocks, level or upright, which
 * meets more of them. Its law is
 * the first of a ductile metal, or a new one of steel. */
gboolean qn_edit_add_bar (QnModel *model, QnBlockSet set, GError **error);

/* Adds one of 16 mm from point to point, m. */
gboolean qn_edit_draw_bar (QnModel *model, QnVec2 start, QnVec2 end, GError **error);
gboolean qn_edit_remove_bar (QnModel *model, QnId bar, GError **error);
/* Adds one like it as the last, four diameters to the left of it. */
gboolean qn_edit_duplicate_bar (QnModel *model, QnId bar, GError **error);

/* The bar nearest to a point, within `reach`, m; or QN_NONE. */
QnId qn_model_find_bar (const QnModel *model, QnVec2 at, double reach);

/* "steel, Ø 16 mm: 0; 0.2 m – 2.9; 0.2 m"; the caller frees it. */
char *qn_bar_dup_text (const QnModel *model, const QnBar *bar, QnUnits units);
