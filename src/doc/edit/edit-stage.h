/* Edits of load sets, of single loads, and of the stages that they are applied in.
 *
 * They work on the draft of qn_document_edit(), with errors as in edit.h; what breaks a rule of
 * stages (model-check-loading.c) is refused when the draft becomes the document.
 */
#pragma once

#include "doc/edit/edit.h"

/* ---- lists of loads ---- */

/* Adds an empty set, or a case of factor 1, under a free name ("set 1", "case 1", …); its number, counted
 * from 1, is that of the last. */
gboolean qn_edit_add_load_list (QnModel *model, gboolean cases, GError **error);
gboolean qn_edit_rename_load_list (QnModel *model, gboolean cases, int32_t number,
                                   const char *name, GError **error);
/* The loads of a set go with it, and stages that drive only this set; those of a case stay without one. */
gboolean qn_edit_delete_load_set (QnModel *model, int32_t set, GError **error);
gboolean qn_edit_delete_load_case (QnModel *model, int32_t number, GError **error);

/* A new load of a kind on edges: on the top of the first of the blocks, or above or beside all of them;
 * of the structure, where the set is empty. */
gboolean qn_edit_make_edge_load (QnModel *model, QnLoadKind kind, QnBlockSet set,
                                 QnLoad *load, GError **error);

/* Of the i-th of the dead or of the live loads: the one before (by = -1) or behind it (1) in its set,
 * settlements apart; QN_NONE: there is none. They change places. */
QnId qn_model_load_beside (const QnModel *model, gboolean live, QnId load, int by);
gboolean qn_edit_move_load (QnModel *model, gboolean live, QnId load, int by,
                            GError **error);

/* ---- stages ---- */

/* Appends a stage: the first takes over the procedure of the analysis and its live loads; others
 * drive the first set that no stage drives yet, or go on with that of the stage before. Where
 * that had no end it gets one. */
gboolean qn_edit_add_stage (QnModel *model, GError **error);
gboolean qn_edit_delete_stage (QnModel *model, gsize stage, GError **error);

/* Swaps a stage with the one before (by = -1) or behind it (1); of both, what would now lack an
 * end gets one. Returns where it is then; -1: nowhere. A cyclic protocol, known by its first stage, is
 * deleted, moved, changed and named as a whole (core/model/cycles.h). */
int qn_edit_move_stage (QnModel *model, gsize stage, int by, GError **error);

/* Replaces the settings of a stage, all but its name, and with count above 0 makes a protocol of it, of so
 * many cycles of each amplitude. */
gboolean qn_edit_change_stage (QnModel *model, gsize stage, const QnStage *settings,
                               const double *amplitudes, gsize count, gsize cycles,
                               GError **error);
/* An empty name is none: its number stands for it. */
gboolean qn_edit_rename_stage (QnModel *model, gsize stage, const char *name,
                               GError **error);

/* How a stage ends. */
typedef enum {
  QN_STAGE_END_COLLAPSE,    /* nowhere: only the last one may */
  QN_STAGE_END_MULTIPLIER,  /* at a multiplier */
  QN_STAGE_END_DISPLACEMENT /* at a displacement */
} QnStageEnd;
QnStageEnd qn_stage_get_end (const QnStage *stage);
