#include "core/dynamics/energy.h"

#include "core/base/numbers.h"

static double
elastic (const QnTimeStep *step, const QnInstant *instant)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  double sum = instant->beam_energy;

  for (size_t p = 0; p < as->pair_count; p++)
    if (!as->inactive[p])
      sum +=
        qn_pair_elastic_energy (&step->elasticity[p], instant->at.responses[p].force);
  return sum;
}

/* x' M y */
static double
product (const QnTimeStep *step, const double *ax, const double *x, const double *y)
{
  QnEquilibrium *eq = step->equation.eq;

  qn_assembly_multiply (&eq->assembly, ax, y, eq->trial);
  return qn_dot (x, eq->trial, (size_t) eq->assembly.unknown_count);
}

QnEnergy
qn_energy_start (const QnTimeStep *step)
{
  const QnInstant *start = &step->start;
  QnEnergy energy = { { 0 } };

  energy.sums[QN_ENERGY_KINETIC] = 0.5 * product (step, step->mass, start->v, start->v);
  energy.sums[QN_ENERGY_ELASTIC] = elastic (step, start);
  energy.sums[QN_ENERGY_INPUT] =
    energy.sums[QN_ENERGY_KINETIC] + energy.sums[QN_ENERGY_ELASTIC];
  return energy;
}

/* Energy dissipated by slip, plastic hinges and dashpots of pairs. */
static void
add_losses (const QnTimeStep *step, QnEnergy *energy)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  const QnInstant *start = &step->start, *end = &step->end;
  double friction = 0;

  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairInstant before = qn_instant_pair (start, start->at.responses, p),
                  after = qn_instant_pair (end, end->at.responses, p);
    if (as->inactive[p])
      continue;
    friction +=
      qn_pair_friction (&step->elasticity[p], &step->forces[p], &before, &after);
    for (int i = 0; i < 2; i++)
      energy->sums[QN_ENERGY_DAMPING] +=
        step->forces[p].dashpot[i] * (after.q[i] - before.q[i]);
  }
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnBeamResponse *before = &start->at.beams.responses[b],
                         *after = &end->at.beams.responses[b];
    for (int i = 0; i < 2; i++)
      friction += 0.5 * (before->force[1 + i] + after->force[1 + i])
                  * (after->memory.plastic[i] - before->memory.plastic[i]);
    friction += 0.5 * (before->force[0] + after->force[0])
                * (after->memory.stretch - before->memory.stretch);
  }
  energy->sums[QN_ENERGY_FRICTION] += friction;
}

QnEnergy
qn_energy_after (const QnTimeStep *step, const QnEnergy *before, double h, QnVec2 mean,
                 QnVec2 change)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start, *end = &step->end;
  double *motion = step->equation.eq->live_step, *jump = step->equation.eq->step;
  double *drag = step->equation.eq->trial;
  double damping = 0, input = 0, numerical = 0;
  QnEnergy energy = *before;

  /* dashpots on masses and beams */
  for (int32_t i = 0; i < as->unknown_count; i++) {
    motion[i] = (1 - s->alpha_f) * end->v[i] + s->alpha_f * start->v[i];
    jump[i] = end->at.u[i] - start->at.u[i];
  }
  if (step->settings->mass_damping > 0)
    damping += step->settings->mass_damping * product (step, step->mass, jump, motion);
  if (step->settings->joint_damping > 0 && as->beams.count > 0)
    damping +=
      step->settings->joint_damping * product (step, step->beam_damping, jump, motion);
  energy.sums[QN_ENERGY_DAMPING] += damping;

  /* D, with [R] = -[residual] + M i [g] */
  for (int32_t i = 0; i < as->unknown_count; i++)
    motion[i] = end->a[i] - start->a[i];
  qn_assembly_multiply (as, step->mass, motion, drag);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    double du = end->at.u[i] - start->at.u[i], dv = end->v[i] - start->v[i];
    double ground = step->inertia[0][i] * mean.x + step->inertia[1][i] * mean.y;
    double r = start->residual[i] - end->residual[i] + step->inertia[0][i] * change.x
               + step->inertia[1][i] * change.y;
    input += (0.5 * (start->dead[i] + end->dead[i]) - ground) * du;
    numerical += (0.5 - s->alpha_f) * du * (r + drag[i])
                 + h * (s->beta - 0.5 * s->gamma) * drag[i] * dv;
  }
  energy.sums[QN_ENERGY_INPUT] += input;
  energy.sums[QN_ENERGY_NUMERICAL] += numerical;

  add_losses (step, &energy);
  energy.sums[QN_ENERGY_ELASTIC] = elastic (step, end);
  energy.sums[QN_ENERGY_KINETIC] = 0.5 * product (step, step->mass, end->v, end->v);
  return energy;
}

void
qn_energy_renew (const QnTimeStep *step, QnEnergy *energy)
{
  double now = elastic (step, &step->start);

  energy->sums[QN_ENERGY_FRICTION] += energy->sums[QN_ENERGY_ELASTIC] - now;
  energy->sums[QN_ENERGY_ELASTIC] = now;
}

double
qn_energy_error (const QnEnergy *energy)
{
  double rest = energy->sums[QN_ENERGY_INPUT];

  for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
    rest -= energy->sums[kind];
  return rest;
}
