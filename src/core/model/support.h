/* Whether blocks and nodes are held. */
#pragma once

#include "core/model/model.h"

/* In all degrees of freedom. */
static inline bool
qn_support_is_full (const bool support[QN_DOF_COUNT])
{
  return support[QN_DOF_UX] && support[QN_DOF_UY] && support[QN_DOF_RZ];
}

/* In one of them at least. */
static inline bool
qn_support_is_any (const bool support[QN_DOF_COUNT])
{
  return support[QN_DOF_UX] || support[QN_DOF_UY] || support[QN_DOF_RZ];
}
