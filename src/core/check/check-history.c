/* What an analysis in time keeps: energies, peaks, tracks. */
#include "core/check/check-parts.h"
#include "core/dynamics/ground.h"

#include <math.h>

/* Steps and rows of the history that fall together, in lengths of a row. */
#define SAME_TIME 1e-6

/* INPUT = the sum of the others, to within the error that is told. */
static void
check_energy (QnCheck *check)
{
  const QnHistory *h = &check->result->history;
  double most = 0, worst = 0;
  size_t at = 0;

  for (size_t i = 0; i < h->row_count; i++) {
    const double *energy = h->rows + i * h->width + QN_HISTORY_ENERGY;
    double left = energy[QN_ENERGY_INPUT];
    for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
      left -= energy[kind];
    most = fmax (most, fabs (energy[QN_ENERGY_INPUT]));
    if (fabs (left) > worst) {
      worst = fabs (left);
      at = i;
    }
  }
  /* The largest input may lie between two rows. */
  if (!(worst <= 2 * h->energy_error * most + QN_CHECK_TOLERANCE * most))
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) at, QN_ENTITY_ANALYSIS, QN_NONE, worst,
                   h->energy_error * most);
}

/* No step has moved further than the peaks say. */
static void
check_peaks (QnCheck *check)
{
  const QnResult *r = check->result;
  const double *start = qn_result_step_displacements (r, 0);

  for (size_t i = 1; i < r->step_count; i++)
    for (size_t b = 0; b < r->block_count; b++) {
      const double *u = qn_result_step_displacements (r, i) + QN_DOF_COUNT * b;
      const double *u0 = start + QN_DOF_COUNT * b;
      double moved = hypot (u[0] - u0[0], u[1] - u0[1]);
      if (!(moved <= r->history.peaks[b] * (1 + QN_CHECK_EXACT) + QN_CHECK_EXACT))
        qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_BLOCK, (QnId) b,
                       r->history.peaks[b], moved);
    }
}

/* Tracks are the displacements of the steps at the same times; the ground moves as the model says. */
static void
check_rows (QnCheck *check, const QnGround *ground)
{
  const QnResult *r = check->result;
  const QnHistory *h = &r->history;
  const QnModel *model = check->model;
  double apart = h->row_count > 1 ? h->rows[h->width] - h->rows[0] : 1;
  size_t step = 0;

  for (size_t i = 0; i < h->row_count; i++) {
    const double *row = h->rows + i * h->width;
    double time = row[QN_HISTORY_TIME];
    QnVec2 moved = qn_ground_acceleration (ground, time);
    double size = 1e-6 * (1 + hypot (moved.x, moved.y));
    if ((i > 0 && !(time > row[QN_HISTORY_TIME - (ptrdiff_t) h->width]))
        || !qn_check_agrees (row[QN_HISTORY_GROUND_X], moved.x, size)
        || !qn_check_agrees (row[QN_HISTORY_GROUND_Y], moved.y, size))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_GROUND_MOTION, QN_NONE,
                     row[QN_HISTORY_GROUND_X], moved.x);
    while (step + 1 < r->step_count
           && (step == 0 || r->steps[step].time < time - SAME_TIME * apart))
      step++;
    if (i == 0 || fabs (r->steps[step].time - time) > SAME_TIME * apart)
      continue;
    const double *u = qn_result_step_displacements (r, step);
    for (size_t t = 0; t < model->track_count; t++) {
      const QnTrack *track = &model->tracks[t];
      double at = u[QN_DOF_COUNT * track->block + (int) track->dof];
      if (!qn_check_agrees (row[QN_HISTORY_TRACK + t], at,
                            QN_CHECK_EXACT * (1 + fabs (at))))
        qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_TRACK, (QnId) t,
                       row[QN_HISTORY_TRACK + t], at);
    }
  }
}

static bool
has_all_records (const QnModel *model)
{
  for (size_t i = 0; i < model->ground_count; i++)
    if (model->ground[i].kind == QN_SIGNAL_RECORD && model->ground[i].point_count < 2)
      return false;
  return true;
}

void
qn_check_history (QnCheck *check)
{
  const QnHistory *h = &check->result->history;
  QnGround ground;

  if (h->width == 0 || check->result->step_count == 0)
    return;
  if (h->width != QN_HISTORY_TRACK + check->model->track_count) {
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_TRACK, QN_NONE, NAN, NAN);
    return;
  }
  check_energy (check);
  check_peaks (check);
  if (has_all_records (check->model) && qn_ground_init (&ground, check->model)) {
    check_rows (check, &ground);
    qn_ground_clear (&ground);
  }
}
