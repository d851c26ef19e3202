#include "core/base/decimal.h"
#include "support/generate-parts.h"

#include <string.h>

static const QnGenerateMaterial default_material = {
  .thickness = 1, .unit_weight = 20000, .stiffness = 1e7, .friction = 0.65
};

QnWallRecipe
qn_wall_recipe_default (void)
{
  return (QnWallRecipe){ .material = default_material,
                         .unit = { 0.4, 0.175 },
                         .length = 8,
                         .courses = 10,
                         .openings = 0,
                         .seed = 1 };
}

QnArchRecipe
qn_arch_recipe_default (void)
{
  return (QnArchRecipe){ .material = default_material,
                         .radius = 1,
                         .ring = 0.15,
                         .embrace = 3.14159265358979323846,
                         .count = 27,
                         .segments = 1 };
}

QnColumnRecipe
qn_column_recipe_default (void)
{
  return (QnColumnRecipe){
    .material = default_material, .count = 6, .height = 0.5, .width = 1, .top_width = 0.8
  };
}

QnStatus
qn_generate_check (double value, bool zero_allowed, const char *field, QnDiag *diag)
{
  QnProblem problem = !isfinite (value)             ? QN_PROBLEM_NOT_FINITE
                      : value > QN_MAX_COORDINATE   ? QN_PROBLEM_TOO_LARGE
                      : value < 0 && zero_allowed   ? QN_PROBLEM_NEGATIVE
                      : value <= 0 && !zero_allowed ? QN_PROBLEM_NOT_POSITIVE
                                                    : QN_PROBLEM_NONE;
  if (problem == QN_PROBLEM_NONE)
    return QN_OK;
  return qn_diag_set_field (diag, problem, QN_ENTITY_MODEL, QN_NONE, field, value);
}

QnStatus
qn_generate_check_blocks (double count, const char *field, QnDiag *diag)
{
  if (count <= QN_MAX_BLOCKS)
    return QN_OK;
  return qn_diag_set_field (diag, QN_PROBLEM_TOO_MANY_BLOCKS, QN_ENTITY_MODEL, QN_NONE,
                            field, count);
}

QnStatus
qn_generate_check_material (const QnGenerateMaterial *material, QnDiag *diag)
{
  QnStatus status = qn_generate_check (material->thickness, false, "thickness", diag);
  if (status == QN_OK)
    status = qn_generate_check (material->unit_weight, true, "unit_weight", diag);
  if (status == QN_OK)
    status = qn_generate_check (material->stiffness, false, "stiffness", diag);
  if (status == QN_OK)
    status = qn_generate_check (material->friction, true, "friction", diag);
  return status;
}

QnStatus
qn_generate_begin (QnModel *model, const QnGenerateMaterial *material, QnDiag *diag)
{
  QnLaw *law = qn_model_add_law (model, "joint");
  QnLoad *dead = qn_model_add_dead_load (model);
  QnLoad *live = qn_model_add_live_load (model);
  if (law == NULL || dead == NULL || live == NULL)
    return qn_diag_no_memory (diag);

  law->kind = QN_LAW_COULOMB;
  law->basis = QN_BASIS_CONTACT;
  law->kn = law->ks = material->stiffness;
  law->friction = material->friction;
  model->contact.law = (QnId) model->law_count - 1;
  dead->kind = live->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  live->vector = qn_vec2 (1, 0);
  return QN_OK;
}

QnStatus
qn_generate_add (QnModel *model, const QnGenerateMaterial *material, const char *prefix,
                 int32_t number, const QnVec2 *vertices, size_t count, QnDiag *diag)
{
  char name[16 + QN_DECIMAL_SIZE];
  size_t length = strlen (prefix);
  QN_ASSERT (length < 16);
  memcpy (name, prefix, length + 1);
  if (number >= 0)
    qn_write_decimal (name + length, number);

  QnBlock *block = qn_model_add_block (model, name, vertices, count);
  if (block == NULL)
    return qn_diag_no_memory (diag);
  block->thickness = material->thickness;
  block->unit_weight = material->unit_weight;
  return QN_OK;
}

QnStatus
qn_generate_add_fixed (QnModel *model, const QnGenerateMaterial *material,
                       const char *name, const QnVec2 *vertices, size_t count,
                       QnDiag *diag)
{
  QnStatus status = qn_generate_add (model, material, name, -1, vertices, count, diag);
  if (status != QN_OK)
    return status;
  QnBlock *block = &model->blocks[model->block_count - 1];
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    block->support[dof] = true;
  return QN_OK;
}
