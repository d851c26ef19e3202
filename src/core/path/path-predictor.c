#include "core/path/path-predictor.h"

#include <string.h>

void
qn_path_predictor_init (QnPathPredictor *predictor, const QnAssembly *as, QnPool *pool)
{
  *predictor = (QnPathPredictor){ 0 };
  for (int k = 0; k < QN_PREDICTOR_STATES; k++)
    predictor->u[k] = qn_pool_alloc (pool, (size_t) as->unknown_count, sizeof (double));
}

void
qn_path_predictor_note (QnPathPredictor *predictor, const QnEquilibrium *eq,
                        double advance, bool smooth)
{
  double *oldest = predictor->u[QN_PREDICTOR_STATES - 1];

  if (!smooth) {
    predictor->count = 0;
    return;
  }
  for (int k = QN_PREDICTOR_STATES - 1; k > 0; k--) {
    predictor->u[k] = predictor->u[k - 1];
    predictor->multiplier[k] = predictor->multiplier[k - 1];
    predictor->advance[k] = predictor->advance[k - 1];
  }
  predictor->u[0] = oldest;
  predictor->multiplier[0] = eq->committed.multiplier;
  predictor->advance[0] = advance;
  memcpy (oldest, eq->committed.u, (size_t) eq->assembly.unknown_count * sizeof *oldest);
  if (predictor->count < QN_PREDICTOR_STATES)
    predictor->count++;
}

/* Weights of the polynomial of Lagrange through the committed state, at 0, and those before it. */
static void
find_weights (const QnPathPredictor *predictor, double advance, double *weights)
{
  double at[QN_PREDICTOR_STATES + 1] = { 0 };

  for (int k = 1; k <= QN_PREDICTOR_STATES; k++)
    at[k] = at[k - 1] - predictor->advance[k - 1];
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
    eq->multiplier += weight * (predictor->multiplier[k] - committed);
    for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
      eq->u[i] += weight * (predictor->u[k][i] - eq->committed.u[i]);
  }
  return qn_assembly_evaluate (&eq->assembly, eq->u);
}
