/* The rules that a model's numbers and references must keep, and what is derived; parts of qn_model_prepare(). */
#pragma once

#include "core/base/require.h"
#include "core/model/model.h"

/* Checks one block of a model: name, polygon, numbers. A fault in a block that came from a wall
 * is reported as the wall's. */
QnStatus qn_model_check_block (const QnModel *model, QnId block, QnDiag *diag);

/* Checks everything outside blocks and walls: gravity, laws, contact settings, exceptions,
 * loads, analysis settings. Walls must be expanded. */
QnStatus qn_model_check_settings (const QnModel *model, QnDiag *diag);

/* Parts of it: loads and settlements; analysis settings and stages; ground motions, initial motions,
 * tracks and the settings of the integration, where the procedure is dynamic. qn_model_check_signal()
 * checks records, after they have been read. */
bool qn_model_check_loads (const QnModel *model, QnDiag *diag);
bool qn_model_check_analysis (const QnModel *model, QnDiag *diag);
bool qn_model_check_dynamic (const QnModel *model, QnDiag *diag);

/* Checks numbers and references of ties and of expanded beams. */
QnStatus qn_model_check_beams (const QnModel *model, QnDiag *diag);

/* Finds out which nodes have a rotation of their own. Beams must be checked. */
void qn_model_mark_turning_nodes (QnModel *model);

/* Places nodes and computes sections. Blocks must be derived and beams be checked. Refuses beams without
 * length, and moments on nodes without a rotation. */
QnStatus qn_model_derive_beams (QnModel *model, QnDiag *diag);

/* Renumbers loaded edges of clockwise blocks for the reversed polygon. Loads must be checked, polygons not
 * yet be reversed. */
void qn_model_renumber_loaded_edges (QnModel *model);

/* Fills QnModel.edge_forces. Blocks must be derived. Refuses TOO_LARGE and TOO_MANY_EDGE_FORCES. */
QnStatus qn_model_resolve_edge_loads (QnModel *model, QnDiag *diag);

/* A block, or the wall that it came from. */
static inline QnSubject
qn_block_subject (const QnModel *model, QnId block, QnDiag *diag)
{
  QnId wall = model->blocks[block].wall;
  return wall == QN_NONE ? (QnSubject){ QN_ENTITY_BLOCK, block, diag }
                         : (QnSubject){ QN_ENTITY_WALL, wall, diag };
}

/* A load: dead ones come first. */
static inline QnSubject
qn_load_subject (const QnModel *model, size_t source, QnDiag *diag)
{
  return source < model->dead_load_count
           ? (QnSubject){ QN_ENTITY_DEAD_LOAD, (QnId) source, diag }
           : (QnSubject){ QN_ENTITY_LIVE_LOAD, (QnId) (source - model->dead_load_count),
                          diag };
}

/* The index of a block. */
static inline bool
qn_require_block (QnSubject of, const char *field, QnId block, const QnModel *model)
{
  return qn_require_index (of, field, block, model->block_count,
                           QN_PROBLEM_BLOCK_UNKNOWN);
}
