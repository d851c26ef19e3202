/* Elastic, perfectly plastic in tension and compression: the bilinear law without hardening.
 *
 *   n = kn (q - p),   |n| <= ny
 */
#include "core/law/law-ops.h"

static void
resolve (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  spring->yield = law->yield * scale.force;
  spring->strength = INFINITY;
}

static const QnLawParameter parameters[] = {
  QN_LAW_PARAMETER ("yield", yield, true, true),
};

const QnLawOps qn_law_ops_elastic_plastic = { .parameters = parameters,
                                              .parameter_count =
                                                QN_N_ELEMENTS (parameters),
                                              .resolve = resolve,
                                              .evaluate = qn_law_bilinear_evaluate };
