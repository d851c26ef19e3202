#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/base/polygon.h"
#include "core/model/model-check.h"

#include <stdlib.h>

/* Derived geometry and weight of one checked block. */
static QnStatus
derive_block (QnModel *model, QnId index, QnDiag *diag)
{
  QnBlock *block = &model->blocks[index];
  QnVec2 *vertices = model->vertices + block->first_vertex;
  size_t count = (size_t) block->vertex_count;

  QnPolygonProperties properties = qn_polygon_properties (vertices, count);
  if (properties.area < 0) {
    qn_polygon_reverse (vertices, count);
    properties = qn_polygon_properties (vertices, count);
  }
  block->area = properties.area;
  block->centroid = properties.centroid;
  block->polar_moment = properties.polar_moment;
  if (block->density >= 0)
    block->unit_weight = block->density * model->gravity;
  block->weight = block->unit_weight * block->area * block->thickness;

  const QnSubject of = qn_block_subject (model, index, diag);
  bool by_density = block->density >= 0;
  return qn_required (
    qn_require (of, block->area > 0, QN_PROBLEM_ZERO_AREA,
                block->wall != QN_NONE ? "unit" : "vertices", block->area)
    && qn_require (of, isfinite (block->weight) && isfinite (block->polar_moment),
                   QN_PROBLEM_TOO_LARGE, by_density ? "density" : "unit_weight",
                   by_density ? block->density : block->unit_weight));
}

/* The upper median of the square roots of the areas: one huge foundation or a crowd of small
 * wedges does not move it. Without blocks that of the lengths of beams; 0 for an empty model. */
static QnStatus
derive_characteristic_length (QnModel *model, QnDiag *diag)
{
  size_t count = model->block_count > 0 ? model->block_count : model->beam_count;
  model->characteristic_length = 0;
  if (count == 0)
    return QN_OK;
  double *sizes = qn_alloc (count, sizeof *sizes);
  if (sizes == NULL)
    return qn_diag_no_memory (diag);
  for (size_t i = 0; i < count; i++)
    sizes[i] = model->block_count > 0 ? sqrt (model->blocks[i].area)
                                      : qn_model_beam_length (model, (QnId) i);
  qsort (sizes, count, sizeof *sizes, qn_compare_doubles);
  model->characteristic_length = sizes[count / 2];
  free (sizes);
  return QN_OK;
}

QnStatus
qn_model_prepare (QnModel *model, QnDiag *diag)
{
  QnStatus status = qn_model_expand_walls (model, diag);
  if (status == QN_OK)
    status = qn_model_expand_beams (model, diag);
  if (status != QN_OK)
    return status;
  if (model->block_count > QN_MAX_BLOCKS)
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_MANY_BLOCKS, QN_ENTITY_MODEL, QN_NONE,
                              "blocks", (double) model->block_count);

  for (size_t i = 0; i < model->block_count && status == QN_OK; i++)
    status = qn_model_check_block (model, (QnId) i, diag);
  if (status == QN_OK)
    status = qn_model_check_beams (model, diag);
  if (status == QN_OK) {
    qn_model_mark_turning_nodes (model);
    status = qn_model_check_settings (model, diag);
  }
  if (status == QN_OK)
    qn_model_renumber_loaded_edges (model);
  for (size_t i = 0; i < model->block_count && status == QN_OK; i++)
    status = derive_block (model, (QnId) i, diag);
  if (status == QN_OK)
    status = qn_model_derive_beams (model, diag);
  if (status == QN_OK)
    status = qn_model_resolve_edge_loads (model, diag);
  return status == QN_OK ? derive_characteristic_length (model, diag) : status;
}
