/* Loads on the edges of blocks, resolved into forces. */
#pragma once

#include "core/model/model.h"

/* Renumbers loaded edges of clockwise blocks for the reversed polygon. Loads must be checked, polygons not
 * yet be reversed. */
void qn_model_renumber_loaded_edges (QnModel *model);

/* Fills QnModel.edge_forces. Blocks must be derived. Refuses TOO_LARGE and TOO_MANY_EDGE_FORCES. */
QnStatus qn_model_resolve_edge_loads (QnModel *model, QnDiag *diag);

/* The chain of edges that an EDGE load is on. */
void qn_load_chain (const QnModel *model, const QnLoad *load, QnId *first, QnId *count);
