/* Where linear geometry ends. */
#include "core/base/polygon.h"
#include "core/result/result.h"

#include <math.h>

double
qn_result_motion (const QnResult *result, size_t from, size_t to)
{
  const double *was = qn_result_step_displacements (result, from);
  const double *is = qn_result_step_displacements (result, to);
  double largest = 0;

  for (size_t i = 0; i < qn_result_body_count (result) * QN_DOF_COUNT; i += QN_DOF_COUNT)
    largest = fmax (largest, hypot (is[i] - was[i], is[i + 1] - was[i + 1]));
  return largest;
}

double
qn_result_peak (const QnResult *result, QnId *block)
{
  double largest = 0;
  QnId at = QN_NONE;

  for (size_t b = 0; b < result->block_count && result->history.peaks != NULL; b++)
    if (at == QN_NONE || result->history.peaks[b] > largest) {
      at = (QnId) b;
      largest = result->history.peaks[b];
    }
  if (block != NULL)
    *block = at;
  return largest;
}

void
qn_result_judge_linearity (const QnModel *model, QnResult *result)
{
  double most = INFINITY, before = 0;

  result->linearity = QN_LINEARITY_HOLDS;
  result->beyond_linear_multiplier = 0;
  if (model->analysis.geometry != QN_GEOMETRY_LINEAR || result->limit.given)
    return;
  for (size_t b = 0; b < model->block_count; b++)
    most = fmin (most, QN_LINEAR_MOTION
                         * qn_polygon_width (qn_model_block_vertices (model, (QnId) b),
                                             (size_t) model->blocks[b].vertex_count));
  if (result->history.width > 0) {
    for (size_t b = 0; b < result->block_count && result->step_count > 0; b++)
      if (result->history.peaks[b] > most)
        result->linearity = QN_LINEARITY_BEYOND;
    return;
  }
  for (size_t i = 1; i < result->step_count; i++) {
    double now = qn_result_motion (result, 0, i);
    double to = result->steps[i].multiplier;
    bool same = result->steps[i - 1].stage == result->steps[i].stage || i == 1;
    double from = same ? result->steps[i - 1].multiplier : to;
    if (now > most && before <= most) {
      result->linearity = QN_LINEARITY_BEYOND;
      result->beyond_linear_multiplier =
        from + (most - before) / (now - before) * (to - from);
    }
    /* Whether the analysis ends at the multiplier of this step: at its collapse, or with
     * its last step. */
    if (i + 1 == result->step_count
        || (result->has_collapse_multiplier && result->steps[i].stage == result->stage
            && to == result->collapse_multiplier)) {
      if (result->has_collapse_multiplier
          && fabs (to - result->beyond_linear_multiplier) <= QN_SETTLED * fabs (to)) {
        result->linearity = QN_LINEARITY_HOLDS;
        result->beyond_linear_multiplier = 0;
      }
      break;
    }
    before = fmax (before, now);
  }
}
