/* Elastic, perfectly plastic in tension and compression: the bilinear law without hardening.
 *
 *   n = kn (q - p),   |n| <= ny
 */
#include "core/law/law-ops.h"

static void
resolve_elastic_plastic (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  spring->yield = law->yield * scale.force;
  spring->strength = INFINITY;
}

static const QnLawParameter elastic_plastic_parameters[] = {
  QN_LAW_PARAMETER ("yield", yield, true, true),
};

const QnLawOps qn_law_ops_elastic_plastic = { .parameters = elastic_plastic_parameters,
                                              .parameter_count = QN_N_ELEMENTS (
                                                elastic_plastic_parameters),
                                              .resolve = resolve_elastic_plastic,
                                              .evaluate = qn_law_bilinear_evaluate };
