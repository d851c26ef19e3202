#include "core/law/law-ops.h"

const char *const qn_law_kind_names[QN_LAW_KIND_COUNT] = {
  [QN_LAW_ELASTIC] = "elastic",   [QN_LAW_NO_TENSION] = "no-tension",
  [QN_LAW_COULOMB] = "coulomb",   [QN_LAW_MOHR_COULOMB] = "mohr-coulomb",
  [QN_LAW_BILINEAR] = "bilinear", [QN_LAW_ELASTIC_PLASTIC] = "elastic-plastic",
  [QN_LAW_CONCRETE] = "concrete", [QN_LAW_STEEL] = "steel",
  [QN_LAW_CURVE] = "curve",
};

const QnLawOps *
qn_law_ops (QnLawKind kind)
{
  static const QnLawOps *const laws[QN_LAW_KIND_COUNT] = {
    [QN_LAW_ELASTIC] = &qn_law_ops_elastic,
    [QN_LAW_NO_TENSION] = &qn_law_ops_no_tension,
    [QN_LAW_COULOMB] = &qn_law_ops_coulomb,
    [QN_LAW_MOHR_COULOMB] = &qn_law_ops_mohr_coulomb,
    [QN_LAW_BILINEAR] = &qn_law_ops_bilinear,
    [QN_LAW_ELASTIC_PLASTIC] = &qn_law_ops_elastic_plastic,
    [QN_LAW_CONCRETE] = &qn_law_ops_concrete,
    [QN_LAW_STEEL] = &qn_law_ops_steel,
    [QN_LAW_CURVE] = &qn_law_ops_curve,
  };
  return laws[kind];
}
