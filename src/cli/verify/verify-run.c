#include "cli/verify/verify-run.h"

#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/path/stability.h"

#include <math.h>

/* The last step of a stage, or of the path where `stage` is 0; -1 where there is none. */
static gssize
find_step (const QnResult *result, int stage)
{
  for (gssize i = (gssize) result->step_count - 1; i >= 0; i--)
    if (stage == 0 || result->steps[i].stage == stage)
      return i;
  return -1;
}

static double
find_reaction (const QnVerifyCase *test, const QnModel *model, const QnResult *result)
{
  QnId block = qn_model_find_block (model, test->block);
  for (size_t s = 0; s < result->support_count; s++)
    if (result->supports[s] == block)
      return qn_result_step_reactions (
        result, result->step_count - 1)[s * QN_DOF_COUNT + (size_t) test->dof];
  return NAN;
}

/* Displacement along x of the vertex of the block that lies furthest up and right. */
static double
corner_displacement (const QnModel *model, QnId block, const double *u)
{
  const QnVec2 *vertices = qn_model_block_vertices (model, block);
  QnVec2 corner = vertices[0];
  for (QnId v = 1; v < model->blocks[block].vertex_count; v++)
    if (vertices[v].x + vertices[v].y > corner.x + corner.y)
      corner = vertices[v];

  QnVec2 arm = qn_vec2_sub (corner, model->blocks[block].centroid);
  double rz = u[QN_DOF_RZ];
  return u[QN_DOF_UX] + qn_vec2_rotate (arm, cos (rz), sin (rz)).x - arm.x;
}

/* Not-a-number where the path does not come there. */
static double
read_branch (const QnVerifyCase *test, const QnModel *model, const QnResult *result)
{
  QnId block = qn_model_find_block (model, test->block);
  double before = NAN;
  if (block == QN_NONE)
    return NAN;
  for (size_t i = 0; i < result->step_count; i++) {
    const double *u =
      qn_result_step_displacements (result, i) + (size_t) block * QN_DOF_COUNT;
    double moved = corner_displacement (model, block, u);
    if (before < test->at && moved >= test->at) {
      double share = (test->at - before) / (moved - before);
      double last = result->steps[i - 1].multiplier;
      return last + share * (result->steps[i].multiplier - last);
    }
    before = moved;
  }
  return NAN;
}

/* Results of the path of an analysis. */
static double
read_path (const QnVerifyCase *test, const QnModel *model, const QnResult *result)
{
  if (test->quantity == QN_VERIFY_COLLAPSE)
    return result->outcome == QN_OUTCOME_COLLAPSE ? result->collapse_multiplier : NAN;
  if (test->quantity == QN_VERIFY_BRANCH)
    return read_branch (test, model, result);
  gssize step = find_step (result, test->number);
  if (result->outcome != QN_OUTCOME_TARGET_REACHED || step < 0)
    return NAN;
  if (test->quantity == QN_VERIFY_MULTIPLIER)
    return result->steps[step].multiplier;
  if (test->quantity == QN_VERIFY_REACTION)
    return find_reaction (test, model, result);
  QnId block = qn_model_find_block (model, test->block);
  QnId node = qn_model_find_node (model, test->block);
  if (block == QN_NONE && node == QN_NONE)
    return NAN;
  size_t body = block != QN_NONE ? (size_t) block : model->block_count + (size_t) node;
  return qn_result_step_displacements (
    result, (size_t) step)[body * QN_DOF_COUNT + (size_t) test->dof];
}

static QnStatus
run_modes (const QnVerifyCase *test, const QnInput *input, QnProgressFunc progress,
           void *user_data, QnResult *result, double *value, QnDiag *diag)
{
  QnModes modes;
  size_t wanted = (size_t) test->number;
  QnStatus status =
    qn_modal_run (&input->project.model, &input->contacts, QN_MODAL_DEAD_LOAD, wanted,
                  progress, user_data, &modes, result, diag);
  if (status != QN_OK)
    return status;
  if (modes.count >= wanted)
    *value = modes.omega[wanted - 1];
  qn_modes_clear (&modes);
  return QN_OK;
}

QnStatus
qn_verify_run (const QnVerifyCase *test, const QnInput *input, QnProgressFunc progress,
               void *user_data, QnResult *result, double *value, QnDiag *diag)
{
  const QnModel *model = &input->project.model;
  const QnContacts *contacts = &input->contacts;
  QnStatus status;

  *value = NAN;
  switch (test->quantity) {
  case QN_VERIFY_FREQUENCY:
    return run_modes (test, input, progress, user_data, result, value, diag);
  case QN_VERIFY_CRITICAL:
    status = qn_stability_run (model, contacts, progress, user_data, result, diag);
    if (status == QN_OK && result->outcome == QN_OUTCOME_SNAP)
      *value = result->first_limit_multiplier;
    return status;
  case QN_VERIFY_COLLAPSE:
  case QN_VERIFY_DISPLACEMENT:
  case QN_VERIFY_MULTIPLIER:
  case QN_VERIFY_REACTION:
  case QN_VERIFY_BRANCH:
    break;
  }
  status = qn_analysis_run (model, contacts, progress, user_data, result, diag);
  if (status == QN_OK)
    *value = read_path (test, model, result);
  return status;
}
