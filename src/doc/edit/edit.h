/* Edits of a model by the commands of the drawing.
 *
 * Each works on the copy that qn_document_edit() hands out and either does the whole of it or
 * refuses with an error (domain QN_EDIT_ERROR) that says why in the user's language. Lengths
 * are m, forces N. Blocks of a parametric wall follow their wall: what concerns single ones
 * either changes the wall's courses or first turns the wall into free blocks.
 */
#pragma once

#include "core/contact/contacts.h"
#include "core/model/model.h"
#include "render/drawing/scene.h"
#include "stereotomy/masonry.h"

#include <glib.h>

/* Its message says all: it has no codes. */
#define QN_EDIT_ERROR (qn_edit_error_quark ())
GQuark qn_edit_error_quark (void);

/* A set of blocks, by number. */
typedef struct QnBlockSet {
  const QnId *ids;
  guint count;
} QnBlockSet;

/* (x, y) -> (xx x + xy y + x0, yx x + yy y + y0) */
typedef struct QnTransform {
  double xx, xy, yx, yy, x0, y0;
} QnTransform;

QnTransform qn_transform_translation (double x, double y);
QnTransform qn_transform_rotation (QnVec2 center,
                                   double angle);     /* rad, counter-clockwise */
QnTransform qn_transform_mirror (QnVec2 a, QnVec2 b); /* about the line through */
QnTransform qn_transform_compose (QnTransform first, QnTransform second);
QnVec2 qn_transform_apply (QnTransform transform, QnVec2 point);

/* ---- blocks (edit-block.c) ---- */

/* Properties of a new block. */
typedef struct QnBlockStyle {
  double thickness;   /* m */
  double unit_weight; /* N/m3 */
  QnId law;           /* or QN_NONE: the contact law */
  bool support[QN_DOF_COUNT];
} QnBlockStyle;

/* Adds a block of count >= 3 corners, m, in either orientation, under a free name. */
gboolean qn_edit_add_block (QnModel *model, const QnVec2 *vertices, guint count,
                            QnBlockStyle style, GError **error);

/* Wall blocks become openings of their length. */
gboolean qn_edit_delete_blocks (QnModel *model, QnBlockSet set, GError **error);

/* Walls of which every block is in the set and which are only shifted stay parametric;
 * others are turned into free blocks. */
gboolean qn_edit_transform_blocks (QnModel *model, QnBlockSet set, QnTransform transform,
                                   GError **error);

/* Adds `copies` copies, the k-th moved by the transform applied k times. Copies are free
 * blocks. */
gboolean qn_edit_copy_blocks (QnModel *model, QnBlockSet set, QnTransform transform,
                              int copies, GError **error);

/* A wall without courses goes when the model is built again. */
void qn_wall_remove_courses (QnWall *wall);

/* Turns the walls and masonry of these blocks into free blocks of the same names and numbers. FALSE, or
 * refused, where none of them belongs to any. */
gboolean qn_edit_take_apart (QnModel *model, QnBlockSet set);
gboolean qn_edit_detach (QnModel *model, QnBlockSet set, GError **error);

/* Fixes or frees `count` degrees of freedom from `first` on; the others stay as each block has them. */
gboolean qn_edit_set_support (QnModel *model, QnBlockSet set, int first, int count,
                              const bool *support, GError **error);

/* What all blocks of a set may be given, as a number; for wall blocks it holds for the whole wall. */
typedef enum { QN_BLOCK_THICKNESS, QN_BLOCK_UNIT_WEIGHT, QN_BLOCK_LAW } QnBlockField;
gboolean qn_edit_set_blocks (QnModel *model, QnBlockSet set, QnBlockField field,
                             double value, GError **error);
gboolean qn_edit_rename_block (QnModel *model, QnId block, const char *name,
                               GError **error);

/* ---- loads, laws (edit-load.c) ---- */

/* A force at a point of a block; `live`: grows with the multiplier. */
gboolean qn_edit_add_force (QnModel *model, QnId block, gboolean live, QnVec2 force,
                            QnVec2 at, GError **error);
/* A new dead or live load, on nothing yet; NULL with an error where memory runs out. */
QnLoad *qn_edit_new_load (QnModel *model, gboolean live, GError **error);

/* A stretch of a block's outline: `count` edges, counter-clockwise, from edge `first` on. */
typedef struct QnEdgeChain {
  QnId block; /* QN_NONE: no chain */
  QnId first, count;
} QnEdgeChain;

/* The edge nearest to a point, within `reach`, m; of two that lie on each other the one of the block
 * that the point is in. `of`: only edges of this block. */
QnEdgeChain qn_model_find_edge (const QnModel *model, QnVec2 at, double reach, QnId of);
/* From one edge to another of its block, the shorter way round. */
QnEdgeChain qn_model_join_edges (const QnModel *model, QnEdgeChain from, QnEdgeChain to);

/* Adds a load of the same intensity, N/m, along these edges, at right angles into the block. */
gboolean qn_edit_add_edge_load (QnModel *model, QnEdgeChain chain, gboolean live,
                                double intensity, GError **error);
/* Puts a load of kind QN_LOAD_EDGE on other edges. */
void qn_load_set_chain (QnLoad *load, QnEdgeChain chain);

/* Before blocks are moved, one flag per block: loads on their sides stay on these edges, also where
 * the sides face elsewhere then. */
void qn_edit_move_edge_loads (QnModel *model, const gboolean *blocks,
                              QnTransform transform);

/* Moves the loads on the edges of a block that goes to the edges that take their place: what lies
 * on the loaded ones of the blocks from `first` on. */
gboolean qn_edit_carry_edge_loads (QnModel *model, QnId gone, QnId first, GError **error);

/* The one load of kind weight; a zero direction removes it. */
gboolean qn_edit_set_weight_load (QnModel *model, gboolean live, QnVec2 direction,
                                  GError **error);

/* Adds a law like an existing one under a free name like this one; its number is that of the last law. */
gboolean qn_edit_add_law (QnModel *model, QnId like, const char *name, GError **error);

/* How many blocks, walls, joints, bars and general rules name the law. */
guint qn_edit_count_law_uses (const QnModel *model, QnId law);

/* Removes a law; what has it gets `by`, or, where that is QN_NONE, the law of the contacts. Refused
 * where nothing can stand in its place. */
gboolean qn_edit_delete_law (QnModel *model, QnId law, QnId by, GError **error);

/* ---- contact faces (edit-load.c): exceptions from the general law and placement of pairs ----
 *
 * A face is told by its two blocks; an exception holds for all faces between them. Exceptions
 * that say nothing any more are removed. */

/* A set of faces by their blocks; numbers that the contacts do not have are passed over. */
typedef struct QnFaceSet {
  const QnContacts *contacts;
  const QnId *ids;
  guint count;
} QnFaceSet;

/* The exception for a face, or NULL. */
const QnFaceOverride *qn_model_find_override (const QnModel *model,
                                              const QnContactFace *face);

/* Whether an exception is for these two blocks. */
gboolean qn_override_concerns (const QnFaceOverride *override, QnId a, QnId b);

/* The law where one is given, QN_NONE for that of the blocks or of all contacts; else the pairs, NULL for
 * those of all contacts. */
gboolean qn_edit_set_faces (QnModel *model, QnFaceSet set, const QnId *law,
                            const QnPairRule *rule, GError **error);

/* ---- lists of loads, bars and ties (edit-list.c) ---- */

gsize qn_model_count_items (const QnModel *model, QnPickKind kind);
/* Whether there is one of this number; an error where there is none. */
gboolean qn_edit_has_item (const QnModel *model, QnPickKind kind, QnId item,
                           GError **error);
gboolean qn_edit_remove_item (QnModel *model, QnPickKind kind, QnId item, GError **error);
/* Adds one like it: a load behind it, a bar or tie as the last, four diameters to the left of it. Returns its
 * number; QN_NONE with an error. */
QnId qn_edit_duplicate_item (QnModel *model, QnPickKind kind, QnId item, GError **error);

/* ---- for edits (edit-rebuild.c) ---- */

/* Builds the model again, as it is done when an edit ends: blocks without corners and walls without courses
 * are left out, walls are expanded from their courses as they are now, and all else follows its blocks or
 * goes with them. The parametric masonry is laid again from this list (NULL: left as it is). */
gboolean qn_edit_rebuild (QnModel *model, const QnMasonries *masonry, GError **error);

/* A name that is not taken in the list at this place of QnModel: the word, what stands behind it, and a number, from this one on. The caller frees
 * it. */
char *qn_edit_dup_new_name (const QnModel *model, gsize items, const char *word,
                            const char *between, gsize number);
/* The word, where that is not taken, or such a name from "word 2" on. */
char *qn_edit_dup_free_name (const QnModel *model, gsize items, const char *word);
/* Puts a copy of a name into the place of another. */
gboolean qn_edit_take_name (char **place, const char *name, GError **error);
/* The same of a text, of which an empty one is none. */
gboolean qn_edit_take_text (char **place, const char *text, GError **error);
/* Takes an item, whose own memory is free already, out of an array of `count`. */
void qn_edit_drop (gpointer items, size_t *count, gsize size, gsize index);

/* Set the error of an edit that ran out of memory, or that cannot be done here; return FALSE. */
gboolean qn_edit_no_memory (GError **error);
gboolean qn_edit_refuse (GError **error, const char *format, ...) G_GNUC_PRINTF (2, 3);
gboolean qn_edit_refuse_diag (GError **error, const QnModel *model, const QnDiag *diag);

/* The box of some blocks, or of all that are not fixed. */
QnBox qn_edit_box_of (const QnModel *model, QnBlockSet set);

/* Which blocks are in the set: one flag per block. The caller frees it. */
gboolean *qn_block_set_to_flags (QnBlockSet set, const QnModel *model);
