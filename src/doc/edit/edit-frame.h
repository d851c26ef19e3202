/* Edits of beams, their nodes and their sections.
 *
 * They work on the draft of qn_document_edit() with errors as in edit.h. Lengths are m, stresses
 * Pa. A node that several beams share is one joint: what moves it moves all their ends.
 */
#pragma once

#include "doc/edit/edit.h"
#include "io/project/project.h"

/* Beams, by number. */
typedef struct QnBeamSet {
  const QnId *ids;
  guint count;
} QnBeamSet;

/* Blocks and beams together. */
typedef struct QnPartSet {
  QnBlockSet blocks;
  QnBeamSet beams;
} QnPartSet;

/* Properties of a new beam. */
typedef struct QnBeamStyle {
  const char *section; /* name; NULL or unknown: the first there is, or a new one */
  QnBeamKind kind;
  bool hinge[2];
  int32_t element_count; /* >= 1 */
} QnBeamStyle;

/* ---- beams (edit-frame.c) ---- */

/* A beam from place to place. An end takes the node that lies there already; otherwise it gets
 * one of its own, which rides on the block there, if any, or stands free. */
gboolean qn_edit_add_beam (QnModel *model, QnVec2 from, QnVec2 to, QnBeamStyle style,
                           GError **error);

/* Blocks and beams; one of the sets may be empty. With the beams go their nodes that carry no other
 * one, and the loads on both. */
gboolean qn_edit_delete_all (QnModel *model, QnPartSet set, GError **error);

/* What all beams of a set may be given, as a number: a section, a QnBeamKind, a count of elements, 1 or 0. */
typedef enum {
  QN_BEAM_SECTION,
  QN_BEAM_KIND,
  QN_BEAM_ELEMENTS, /* loads on nodes between them go to the nearest of the new ones */
  QN_BEAM_FIRST_HINGE,
  QN_BEAM_SECOND_HINGE
} QnBeamField;
gboolean qn_edit_set_beams (QnModel *model, QnBeamSet set, QnBeamField field,
                            double value, GError **error);

/* The one force along each of these beams, N/m; zero takes it away. `live`: it grows. */
gboolean qn_edit_set_line_load (QnModel *model, QnBeamSet set, gboolean live,
                                QnVec2 value, GError **error);
/* Sum of the beam's line loads, dead or live (set 0). */
QnVec2 qn_model_line_load (const QnModel *model, QnId beam, gboolean live);

/* ---- beams together with blocks ---- */

/* As qn_edit_transform(); nodes of the beams go along where they stand free or at given points
 * of blocks that stay, and nodes on blocks of the set go with these. */
gboolean qn_edit_transform_all (QnProject *draft, QnPartSet set, QnTransform transform,
                                GError **error);

/* As qn_edit_copy(). Copied beams are joined where the originals are, and hold on to the nodes
 * and blocks that lie where their ends come to be. */
gboolean qn_edit_copy_all (QnProject *draft, QnPartSet set, QnTransform transform,
                           int copies, GError **error);

/* ---- nodes ---- */

/* The block that a node or the end of a tie at this place would ride on, or QN_NONE: the one that contains
 * it, or has it on its outline, the last of several. */
QnId qn_model_block_under (const QnModel *model, QnVec2 at);

/* What a beam or a tie that ends at a place is held by, for the one who draws it. The caller frees it. */
char *qn_beam_end_dup_text (const QnModel *model, QnVec2 at);
char *qn_tie_end_dup_text (const QnModel *model, QnVec2 at);

/* The node nearest to a place and not farther than `reach`, or QN_NONE; of those that the project
 * names, not those that cut a beam. */
QnId qn_model_node_near (const QnModel *model, QnVec2 at, double reach);

/* Puts a node somewhere: on another node it becomes one with that; on a block it rides there;
 * elsewhere it stands free. */
gboolean qn_edit_place_node (QnModel *model, QnId node, QnVec2 at, GError **error);

/* How it is held by a block: side counts for QN_SEAT_SIDE. FREE takes no block. */
gboolean qn_edit_set_node_seat (QnModel *model, QnId node, QnSeat seat, QnId block,
                                QnBlockSide side, GError **error);
gboolean qn_edit_set_node_support (QnModel *model, QnId node,
                                   const bool support[QN_DOF_COUNT], GError **error);

/* Gives this end of a beam a node of its own at the same place. */
gboolean qn_edit_part_beam (QnModel *model, QnId beam, int end, GError **error);

/* How many beams end at a node. */
guint qn_model_node_beams (const QnModel *model, QnId node);

/* A force at a node, dead or live. */
gboolean qn_edit_add_node_force (QnModel *model, QnId node, gboolean live, QnVec2 force,
                                 GError **error);

/* ---- sections ---- */

/* Whether it is a rectangle, or has area and inertia, which stay what they are. */
gboolean qn_edit_set_section_shape (QnModel *model, QnId section, gboolean rectangle,
                                    GError **error);

/* Adds a section like an existing one (QN_NONE: concrete, 0.2 x 0.2 m) under a free name; its
 * number is that of the last one. */
gboolean qn_edit_add_section (QnModel *model, QnId like, GError **error);
void qn_edit_remove_unused_sections (QnModel *model);

/* Before blocks are moved: forces, nodes and ends of ties at given points of them go where the transform
 * takes them, and loads stay on their edges; so do nodes and ends that stand free where every block of
 * the model is among them. flags: one per block. */
void qn_edit_transform_attached (QnModel *model, const gboolean *flags,
                                 QnTransform transform);
