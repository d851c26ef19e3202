#include "core/path/path-predictor.h"

#include <string.h>

void
qn_path_predictor_init (QnPathPredictor *predictor, const QnAssembly *as, QnPool *pool)
{
  *predictor = (QnPathPredictor){ 0 };
  for (int k = 0; k < QN_PREDICTOR_STATES; k++)
    predictor->states[k].u =
      qn_pool_alloc (pool, (size_t) as->unknown_count, sizeof (double));
}

void
qn_path_predictor_note (QnPathPredictor *predictor, const QnEquilibrium *eq,
                        double advance, bool smooth)
{
  double *oldest = predictor->states[QN_PREDICTOR_STATES - 1].u;

  if (!smooth) {
    predictor->count = 0;
    return;
  }
  memcpy (oldest, eq->committed.u, (size_t) eq->assembly.unknown_count * sizeof *oldest);
  memmove (predictor->states + 1, predictor->states,
           (QN_PREDICTOR_STATES - 1) * sizeof *predictor->states);
  predictor->states[0] = (QnPredictorState){ oldest, eq->committed.multiplier, advance };
  if (predictor->count < QN_PREDICTOR_STATES)
    predictor->count++;
}

/* Weights of the polynomial of Lagrange through the committed state, at 0, and those before it. */
static void
find_weights (const QnPathPredictor *predictor, double advance, double *weights)
{
  double at[QN_PREDICTOR_STATES + 1] = { 0 };

  for (int k = 1; k <= QN_PREDICTOR_STATES; k++)
    at[k] = at[k - 1] - predictor->states[k - 1].advance;
  for (int i = 0; i <= QN_PREDICTOR_STATES; i++) {
    weights[i] = 1;
    for (int k = 0; k <= QN_PREDICTOR_STATES; k++)
      if (k != i)
        weights[i] *= (advance - at[k]) / (at[i] - at[k]);
  }
}

bool
qn_path_predictor_go (const QnPathPredictor *predictor, QnEquilibrium *eq, double advance)
{
  double weights[QN_PREDICTOR_STATES + 1];
  double committed = eq->committed.multiplier;

  if (predictor->count < QN_PREDICTOR_STATES)
    return false;
  find_weights (predictor, advance, weights);
  for (int k = 0; k < QN_PREDICTOR_STATES; k++) {
    double weight = weights[k + 1];
    eq->multiplier += weight * (predictor->states[k].multiplier - committed);
    for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
      eq->u[i] += weight * (predictor->states[k].u[i] - eq->committed.u[i]);
  }
  return qn_assembly_evaluate (&eq->assembly, eq->u);
}
