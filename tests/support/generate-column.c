#include "support/generate-parts.h"

static QnStatus
check_column (const QnColumnRecipe *recipe, QnDiag *diag)
{
  QnStatus status = qn_generate_check_material (&recipe->material, diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->count, false, "count", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->height, false, "height", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->width, false, "width", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->top_width, false, "top_width", diag);
  if (status == QN_OK)
    status = qn_generate_check_blocks (recipe->count + 1.0, "count", diag);
  return status;
}

/* Half the width at a joint, joint 0 being the foot. */
static double
half_width (const QnColumnRecipe *recipe, int32_t joint)
{
  double share = (double) joint / recipe->count;
  return (recipe->width + share * (recipe->top_width - recipe->width)) / 2;
}

QnStatus
qn_generate_column (QnModel *model, const QnColumnRecipe *recipe, QnDiag *diag)
{
  QnStatus status = check_column (recipe, diag);
  if (status == QN_OK)
    status = qn_generate_begin (model, &recipe->material, diag);
  if (status != QN_OK)
    return status;

  double w = recipe->width, h = recipe->height;
  const QnVec2 base[] = { { -w, -h / 2 }, { w, -h / 2 }, { w, 0 }, { -w, 0 } };
  status = qn_generate_add_fixed (model, &recipe->material, "base", base, 4, diag);
  for (int32_t i = 0; i < recipe->count && status == QN_OK; i++) {
    double below = half_width (recipe, i), above = half_width (recipe, i + 1);
    double y0 = h * i, y1 = h * (i + 1);
    const QnVec2 drum[] = {
      { -below, y0 }, { below, y0 }, { above, y1 }, { -above, y1 }
    };
    status = qn_generate_add (model, &recipe->material, "d", i + 1, drum, 4, diag);
  }
  return status;
}
