/* Check of the history of an analysis in time: energies, peaks, tracks. */
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/dynamics/dynamics.h"
#include "core/dynamics/pair-motion.h"

#include <math.h>
#include <string.h>

/* Row of the history at the time of a step; NULL where none is. Of two steps at the start the second has
 * the initial motion. */
static const double *
find_row (const QnCheck *check, size_t step)
{
  const QnHistory *h = &check->result->history;
  double time = check->result->steps[step].time;
  double apart = h->row_count > 1 ? h->rows[h->width] - h->rows[0] : 1;
  double place = apart > 0 && h->row_count > 0 ? rint (time / apart) : -1;

  if ((step == 0 && check->model->initial_count > 0)
      || !(place >= 0 && place < (double) h->row_count))
    return NULL;
  const double *row = h->rows + (size_t) place * h->width;
  return fabs (row[QN_HISTORY_TIME] - time) <= QN_CHECK_TOLERANCE * apart ? row : NULL;
}

static double
kinetic_energy (QnCheck *check)
{
  const QnAssembly *as = &check->assembly;

  qn_assembly_multiply (as, check->mass, check->velocity, check->residual);
  return 0.5 * qn_dot (check->velocity, check->residual, (size_t) as->unknown_count);
}

/* No step has moved further than the peaks say, and tracks are its displacements. */
static void
check_places (QnCheck *check, size_t step, const double *row)
{
  const QnResult *r = check->result;
  const double *start = qn_result_step_displacements (r, 0);
  const double *u = qn_result_step_displacements (r, step);

  for (size_t b = 0; b < r->block_count; b++) {
    const double *now = u + QN_DOF_COUNT * b, *then = start + QN_DOF_COUNT * b;
    double moved = hypot (now[0] - then[0], now[1] - then[1]);
    if (!(moved <= r->history.peaks[b] * (1 + QN_CHECK_EXACT) + QN_CHECK_EXACT))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_BLOCK, (QnId) b,
                     r->history.peaks[b], moved);
  }
  for (size_t t = 0; t < check->model->track_count; t++) {
    const QnTrack *track = &check->model->tracks[t];
    double at = u[QN_DOF_COUNT * track->block + (int) track->dof];
    if (!qn_check_agrees (row[QN_HISTORY_TRACK + t], at,
                          QN_CHECK_EXACT * (1 + fabs (at))))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_TRACK, (QnId) t,
                     row[QN_HISTORY_TRACK + t], at);
  }
}

/* Kinetic energy by the velocities and masses, elastic energy by the forces. Beams, and contacts found on the
 * way, store energy that is not counted here. */
QnStatus
qn_check_motion (QnCheck *check, size_t step, QnDiag *diag)
{
  const QnResult *r = check->result;
  const QnHistory *h = &r->history;
  const QnAssembly *as = &check->assembly;
  const double *row = find_row (check, step);
  double largest = 0;

  if (r->velocities != NULL) {
    /* Unknowns from the velocities of bodies; supports have none, and nodes on blocks
     * ride with them. */
    size_t bodies = qn_result_body_count (r), count = bodies * QN_DOF_COUNT;
    const double *stated = r->velocities + step * count;
    memset (check->velocity, 0, (size_t) as->unknown_count * sizeof *check->velocity);
    qn_assembly_collect (as, stated, check->velocity);
    qn_assembly_expand_rates (as, check->u, check->velocity, check->rows);
    qn_check_rows (check, QN_CLAIM_HISTORY, (QnId) step, stated, bodies,
                   QN_CHECK_EXACT * qn_largest (check->rows, count));
    /* Slower than what is called rest, where the outcome says so. */
    const QnModel *model = check->model;
    double most = QN_REST_SPEED * sqrt (model->gravity * model->characteristic_length);
    double fastest = qn_largest (check->velocity, (size_t) as->unknown_count);
    if (r->outcome == QN_OUTCOME_REST && step + 1 == r->step_count
        && !(fastest <= most * (1 + QN_CHECK_EXACT)))
      qn_check_tell (check, QN_CLAIM_OUTCOME, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                     fastest, most);
  }
  /* The last step may lie between two rows, and the dead load has none. */
  if (row == NULL && step > 0 && step + 1 < r->step_count)
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                   r->steps[step].time, NAN);
  if (row == NULL || h->width != QN_HISTORY_TRACK + check->model->track_count)
    return QN_OK;
  check_places (check, step, row);
  if (check->mass == NULL) {
    check->mass = qn_pool_alloc (&check->pool, (size_t) as->ap[as->unknown_count],
                                 sizeof *check->mass);
    if (check->mass == NULL)
      return qn_diag_no_memory (diag);
    QnStatus status = qn_assembly_mass (as, check->mass, diag);
    if (status != QN_OK)
      return status;
  }
  const double *energy = row + QN_HISTORY_ENERGY;
  for (size_t i = 0; i < h->row_count; i++)
    largest = fmax (largest, qn_largest (h->rows + i * h->width + QN_HISTORY_ENERGY,
                                         QN_ENERGY_KIND_COUNT));
  double kinetic = r->velocities != NULL ? kinetic_energy (check) : 0;
  double elastic = 0;
  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairElasticity pair = qn_pair_elasticity (&as->springs[p]);
    elastic += qn_pair_elastic_energy (&pair, as->responses[p].force);
  }
  for (size_t b = check->model->element_count; b < as->beams.count; b++) { /* ties */
    double force = as->beams.responses[b].force[0];
    elastic += 0.5 * force * force / as->beams.beams[b].properties.axial;
  }
  bool stores =
    check->model->element_count > 0 || r->found_count > 0 || r->left_count > 0;
  if (r->velocities != NULL
      && !qn_check_agrees (energy[QN_ENERGY_KINETIC], kinetic, QN_CHECK_EXACT * largest))
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                   energy[QN_ENERGY_KINETIC], kinetic);
  if (!stores
      && !qn_check_agrees (energy[QN_ENERGY_ELASTIC], elastic, QN_CHECK_FORCES * largest))
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                   energy[QN_ENERGY_ELASTIC], elastic);
  return QN_OK;
}

void
qn_check_history (QnCheck *check)
{
  const QnHistory *h = &check->result->history;

  if (h->width == 0 || check->result->step_count == 0)
    return;
  if (h->width != QN_HISTORY_TRACK + check->model->track_count) {
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_TRACK, QN_NONE, NAN, NAN);
    return;
  }
  /* Rows are as far apart as the first two, but for the last, which comes before the end
   * or with it; that is the last step's. */
  double end = check->result->steps[check->result->step_count - 1].time;
  double apart = h->row_count > 1 ? h->rows[h->width] - h->rows[0] : 0;
  bool in_order = qn_check_agrees (h->end, end, QN_CHECK_TOLERANCE * end);
  for (size_t i = 1; i < h->row_count; i++) {
    const double *row = h->rows + i * h->width;
    double time = row[QN_HISTORY_TIME];
    in_order = in_order
               && (i + 1 < h->row_count ? qn_check_agrees (time, apart * (double) i,
                                                           QN_CHECK_TOLERANCE * apart)
                                        : time > (row - h->width)[QN_HISTORY_TIME]
                                            && time <= end + QN_CHECK_TOLERANCE * apart);
  }
  if (!in_order)
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_ANALYSIS, QN_NONE, h->end,
                   end);
  /* INPUT = the sum of the others within the stated error. */
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
