/* Loads, settlements of supports, and reactions. */
#include "core/assembly/assembly-parts.h"

#include "core/base/memory.h"

#include <string.h>

/* loads = as->forces on the unknowns. */
static void
scatter_forces (const QnAssembly *as, double *loads)
{
  for (size_t i = 0; i < qn_model_body_count (as->model) * QN_DOF_COUNT; i++)
    if (as->unknown[i] != QN_NONE)
      loads[as->unknown[i]] =
        i % QN_DOF_COUNT == QN_DOF_RZ ? as->forces[i] / as->length : as->forces[i];
}

/* Puts settlements of all sets, each times its own factor, in the places of the supports that settle;
 * those of the dead loads where there are no factors. */
static void
add_settlements (const QnAssembly *as, const double *factors, double *out)
{
  for (size_t i = 0; i < qn_model_acting_count (as->model); i++) {
    const QnLoad load = qn_model_acting_load (as->model, i);
    if (load.kind != QN_LOAD_SETTLEMENT || (load.set == QN_NONE) != (factors == NULL))
      continue;
    double value = load.dof == QN_DOF_RZ ? load.value * as->length : load.value;
    int32_t unknown = as->unknown[QN_DOF_COUNT * load.block + (int) load.dof];
    out[unknown] += (factors ? factors[load.set] : 1) * as->stiffness * value;
  }
}

/* loads = every set times its factor. */
static void
sum_sets (const QnAssembly *as, const double *factors, const QnVec2 *beam_loads,
          double *loads)
{
  qn_model_set_forces (as->model, factors, as->forces);
  scatter_forces (as, loads);
  qn_beam_assembly_add_loads (as, beam_loads, loads);
  for (size_t s = 0; s < as->settling_count; s++)
    loads[as->settling[s].unknown] = 0;
  add_settlements (as, factors, loads);
}

void
qn_assembly_set_loads (QnAssembly *as, const double *held, const double *driven)
{
  size_t n = (size_t) as->unknown_count;

  memcpy (as->held, held, sizeof as->held);
  memcpy (as->driven, driven, sizeof as->driven);
  qn_beam_assembly_set_loads (as, held, driven);
  sum_sets (as, driven, as->beams.loads[1], as->live_at_rest);
  sum_sets (as, held, as->beams.loads[0], as->dead_at_rest);
  qn_model_set_forces (as->model, NULL, as->forces);
  scatter_forces (as, as->dead);
  for (size_t s = 0; s < as->settling_count; s++)
    as->dead[as->settling[s].unknown] = 0;
  add_settlements (as, NULL, as->dead);
  for (size_t i = 0; i < n; i++)
    as->dead_at_rest[i] += as->dead[i];
  memcpy (as->dead, as->dead_at_rest, n * sizeof *as->dead);
  memcpy (as->live, as->live_at_rest, n * sizeof *as->live);

  for (size_t i = 0; i < as->eccentric_count; i++) {
    QnEccentricLoad *load = &as->eccentric[i];
    load->dead = load->set == QN_NONE ? 1 : held[load->set];
    load->live = load->set == QN_NONE ? 0 : driven[load->set];
  }
}

static double
largest_force (const QnAssembly *as, const double *loads)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->forces[i] = as->settles[i] ? 0 : loads[i];
  return qn_assembly_largest (as, as->forces, NULL);
}

/* Scale of out-of-balance forces, N: the dead loads; without any, the loads of all sets; without any, mean
 * stiffness x 1/1000 of the first settlement. */
static void
choose_force_scale (QnAssembly *as)
{
  double all[QN_MAX_LOAD_SETS];
  const double none[QN_MAX_LOAD_SETS] = { 0 };

  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    all[set] = 1;
  qn_assembly_set_loads (as, none, all);
  as->force_scale = largest_force (as, as->dead);
  if (as->force_scale == 0)
    as->force_scale = largest_force (as, as->live);
  for (size_t s = 0; s < as->settling_count && as->force_scale == 0; s++) {
    int32_t i = as->settling[s].unknown;
    as->force_scale = 1e-3 * fmax (fabs (as->dead[i]), fabs (as->live[i]));
  }
}

static bool
is_eccentric (const QnModel *model, const QnLoad *load)
{
  QnVec2 arm = qn_model_load_arm (model, load);

  return (load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE)
         && (arm.x != 0 || arm.y != 0);
}

void
qn_assembly_gather_loads (QnAssembly *as)
{
  const QnModel *model = as->model;
  const double held[QN_MAX_LOAD_SETS] = { 0 }, driven[QN_MAX_LOAD_SETS] = { 1 };

  as->eccentric =
    qn_pool_alloc (&as->pool, qn_model_acting_count (model), sizeof *as->eccentric);
  if (as->eccentric == NULL)
    return;
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (!is_eccentric (model, &load))
      continue;
    int32_t unknown =
      as->unknown[QN_DOF_COUNT * qn_model_load_body (model, &load) + QN_DOF_RZ];
    if (unknown != QN_NONE && !as->settles[unknown])
      as->eccentric[as->eccentric_count++] = (QnEccentricLoad){
        .unknown = unknown,
        .set = load.set,
        .arm = qn_model_load_arm (model, &load),
        .force = load.vector,
      };
  }
  choose_force_scale (as);
  qn_assembly_set_loads (as, held, driven);
}

void
qn_assembly_turn_loads (QnAssembly *as, const double *u)
{
  size_t bytes = (size_t) as->unknown_count * sizeof *as->dead;

  memcpy (as->dead, as->dead_at_rest, bytes);
  memcpy (as->live, as->live_at_rest, bytes);
  for (size_t i = 0; i < as->eccentric_count; i++) {
    QnEccentricLoad *load = &as->eccentric[i];
    double rz = u[load->unknown] / as->length;
    load->turned = qn_vec2_rotate (load->arm, cos (rz), sin (rz));
    QnVec2 moved = qn_vec2_sub (load->turned, load->arm);
    double moment = qn_vec2_cross (moved, load->force) / as->length;
    as->dead[load->unknown] += load->dead * moment;
    as->live[load->unknown] += load->live * moment;
  }
  qn_beam_assembly_turn_loads (as);
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    as->dead[i] = as->dead_at_rest[i];
    as->live[i] = as->live_at_rest[i];
  }
}

/* A force at the arm r of a block that turns loses -d(r x F)/drz = r . F of its moment. */
void
qn_assembly_add_load_stiffness (QnAssembly *as, double multiplier)
{
  for (size_t i = 0; i < as->eccentric_count; i++) {
    const QnEccentricLoad *load = &as->eccentric[i];
    double factor = (load->dead + multiplier * load->live) / (as->length * as->length);
    as->ax[as->diagonal[load->unknown]] +=
      factor * qn_vec2_dot (load->turned, load->force);
  }
  qn_beam_assembly_add_load_stiffness (as, multiplier);
}

/* --- Reactions -------------------------------------------------------------------------- */

static bool
is_supported (const QnModel *model, size_t body, size_t dof)
{
  return body < model->block_count ? model->blocks[body].support[dof]
                                   : model->nodes[body - model->block_count].support[dof];
}

/* reaction = P - dead - lambda live */
void
qn_assembly_reactions (QnAssembly *as, double multiplier, double *reactions)
{
  const QnModel *model = as->model;
  size_t count = qn_model_body_count (model) * QN_DOF_COUNT;
  double factors[QN_MAX_LOAD_SETS];

  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    factors[set] = as->held[set] + multiplier * as->driven[set];
  memset (reactions, 0, count * sizeof *reactions);
  /* Adds what the pairs of all faces exert on the fixed degrees of freedom of their
   * blocks, as P of the residual. */
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[p].face];
    const double *force = as->responses[p].force;
    double *a = reactions + QN_DOF_COUNT * face->a,
           *b = reactions + QN_DOF_COUNT * face->b;
    double part[QN_PAIR_FACTORS];
    for (int i = 0; i < QN_PAIR_FACTORS; i++) /* P = G' f */
      part[i] = as->gradients[p].factors[0][i] * force[0]
                + as->gradients[p].factors[1][i] * force[1];
    for (int i = 0; i < 2; i++) {
      a[i] -= part[1 + i];
      b[i] += part[1 + i];
    }
    a[QN_DOF_RZ] += part[0] * as->length;
    b[QN_DOF_RZ] += part[3] * as->length;
  }
  qn_beam_assembly_add_body_forces (as, multiplier, reactions);
  qn_model_set_forces (model, NULL, as->forces);
  for (size_t i = 0; i < count; i++)
    reactions[i] -= as->forces[i];
  qn_model_set_forces (model, factors, as->forces);
  for (size_t i = 0; i < count; i++)
    reactions[i] -= as->forces[i];
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    /* Subtracts loads, their arms turned with supports that turn. */
    if (as->nonlinear && is_eccentric (as->model, &load)) {
      size_t rotation = QN_DOF_COUNT * qn_model_load_body (as->model, &load) + QN_DOF_RZ;
      int32_t unknown = as->unknown[rotation];
      for (size_t s = 0; s < as->settling_count; s++) {
        if (as->settling[s].unknown != unknown)
          continue;
        double rz = as->settling[s].u / as->length;
        QnVec2 arm = qn_model_load_arm (as->model, &load);
        QnVec2 moved = qn_vec2_sub (qn_vec2_rotate (arm, cos (rz), sin (rz)), arm);
        reactions[rotation] -= (load.set == QN_NONE ? 1 : factors[load.set])
                               * qn_vec2_cross (moved, load.vector);
      }
    }
  }
  for (size_t i = 0; i < count; i++)
    if (!is_supported (model, i / QN_DOF_COUNT, i % QN_DOF_COUNT))
      reactions[i] = 0;
}
