/* Edits of parametric masonry: walls, openings, arches and columns that stay parameters.
 *
 * They work on the draft that qn_document_edit() hands out, like those of edit.h on its
 * model, with errors in the same domain. Objects are told by their position in the project's
 * list, which is QnBlock.masonry of their blocks. Loads and exceptions for faces follow the
 * blocks they were at: by name, or where that is gone by place.
 */
#pragma once

#include "doc/edit/edit.h"
#include "io/project/project.h"

/* Adds an object, whose content is taken over. Without a name it gets a free one. */
gboolean qn_edit_add_masonry (QnProject *draft, QnMasonry *masonry, GError **error);

/* Changes the parameters of an object. */
typedef gboolean (*QnMasonryEditFunc) (QnMasonry *masonry, gpointer user_data,
                                       GError **error);
gboolean qn_edit_change_masonry (QnProject *draft, QnId object, QnMasonryEditFunc func,
                                 gpointer user_data, GError **error);

/* Removes an opening of a wall: the fabric closes. */
gboolean qn_edit_remove_opening (QnProject *draft, QnId object, gsize opening,
                                 GError **error);

/* As qn_edit_transform_blocks(), but objects of which every block is in the set stay
 * parametric, unless they are mirrored. */
gboolean qn_edit_transform (QnProject *draft, QnBlockSet set, QnTransform transform,
                            GError **error);

/* As qn_edit_copy_blocks(), but copies of whole objects are such objects again. */
gboolean qn_edit_copy (QnProject *draft, QnBlockSet set, QnTransform transform,
                       int copies, GError **error);

/* The listed wall whose outline contains the point, the last one first, or QN_NONE. */
QnId qn_model_wall_at (const QnModel *model, QnVec2 at);

/* Turns a wall that is listed course by course into an object of the same blocks: rectangular
 * gaps become openings that can be moved wherever a like course tells what they took away. */
gboolean qn_edit_convert_wall (QnProject *draft, QnId wall, GError **error);

/* Which objects have all of their blocks in the set, one flag per object. The caller frees
 * it. */
gboolean *qn_edit_whole_objects (const QnModel *model, QnBlockSet set, gsize *count);
