#include "io/result/result-check.h"

#include "core/base/memory.h"
#include "core/base/polygon.h"
#include "core/result/found-contacts.h"
#include "io/result/result-check-beams.h"
#include "io/result/result-contact.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>

/* Laws of the face overrides by their two blocks, so that a pair finds its own at once; of two
 * overrides for the same blocks the later counts. */
static GHashTable *
index_overrides (const QnModel *model)
{
  GHashTable *index = g_hash_table_new_full (g_int64_hash, g_int64_equal, g_free, NULL);
  for (size_t i = 0; i < model->override_count; i++) {
    const QnFaceOverride *override = &model->overrides[i];
    gint64 *key = g_new (gint64, 1);
    *key = (gint64) MIN (override->block_a, override->block_b) << 32
           | MAX (override->block_a, override->block_b);
    g_hash_table_insert (index, key, GINT_TO_POINTER (override->law + 1));
  }
  return index;
}

/* Law of the spring on the side of `block` in a pair between two blocks. */
static const QnLaw *
find_law (const QnModel *model, GHashTable *overrides, const QnResultContact *contact,
          QnId block)
{
  if (contact->bar != QN_NONE)
    return &model->laws[model->bars[contact->bar].law];
  gint64 key = (gint64) MIN (contact->block_a, contact->block_b) << 32
               | MAX (contact->block_a, contact->block_b);
  QnId law = GPOINTER_TO_INT (g_hash_table_lookup (overrides, &key)) - 1;
  if (law == QN_NONE)
    law = model->blocks[block].law;
  if (law == QN_NONE)
    law = model->contact.law;
  return &model->laws[law];
}

/* By how much a force exceeds what a law can carry, N; 0 or less where it does not. Strengths
 * per area are times the tributary area. */
static double
law_excess (const QnLaw *law, double area, const QnPairResult *pair)
{
  double factor = law->basis == QN_BASIS_CONTACT ? 1 : area;
  double normal = pair->normal_force, shear = pair->shear_force;
  switch (law->kind) {
  case QN_LAW_NO_TENSION:
    return normal;
  case QN_LAW_COULOMB:
  case QN_LAW_MOHR_COULOMB: {
    bool broken = pair->damage >= 1;
    double friction =
      broken && law->residual_friction > 0 ? law->residual_friction : law->friction;
    double cohesion = broken ? 0 : factor * law->cohesion;
    double tension = broken ? 0 : factor * law->tension;
    double slip =
      fabs (shear) + friction * normal - cohesion; /* |t| + mu n <= c, n <= ft */
    double opening = normal - MAX (tension, QN_BOND_ROUNDING * cohesion);
    if (law->kind == QN_LAW_COULOMB)
      return MAX (slip, opening);
    return MAX (MAX (slip, opening), -normal - factor * law->compression);
  }
  case QN_LAW_BILINEAR:
  case QN_LAW_CURVE:
  case QN_LAW_ELASTIC:
  case QN_LAW_KIND_COUNT:
    break;
  case QN_LAW_ELASTIC_PLASTIC:
    return fabs (normal) - factor * law->yield;
  case QN_LAW_STEEL:
    return fabs (normal) - factor * law->strength;
  case QN_LAW_CONCRETE:
    return MAX (normal - factor * law->tension, -normal - factor * law->strength);
  }
  return 0;
}

static double
distance_to_outline (const QnModel *model, QnId block, QnVec2 point)
{
  const QnVec2 *vertices = qn_model_block_vertices (model, block);
  QnId count = model->blocks[block].vertex_count;
  double distance = INFINITY;
  for (QnId i = 0; i < count; i++)
    distance =
      MIN (distance, qn_segment_distance (vertices[i], vertices[(i + 1) % count], point));
  return distance;
}

/* Adds the force of a pair, and its moment about the centroid, to the balance of one block. */
static void
add_force (const QnModel *model, QnId block, const double *deformation, QnVec2 force,
           QnVec2 point, double *balance)
{
  double *sum = balance + (size_t) block * QN_DOF_COUNT;
  QnVec2 centroid = model->blocks[block].centroid;
  if (deformation != NULL) {
    const double *u = deformation + (size_t) block * QN_DOF_COUNT;
    centroid = qn_vec2_add (centroid, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]));
  }
  sum[QN_DOF_UX] += force.x;
  sum[QN_DOF_UY] += force.y;
  sum[QN_DOF_RZ] += qn_vec2_cross (qn_vec2_sub (point, centroid), force); /* r x F */
}

static void
check_pairs (const QnResultFile *file, const QnModel *model, const double *deformation,
             double *balance, QnResultCheck *check)
{
  GHashTable *overrides = index_overrides (model);
  double worst = 0;
  for (size_t i = 0; i < file->result.pair_count; i++) {
    const QnResultContact *contact = &file->contacts[i];
    const QnPairResult *pair = &file->result.pairs[i];
    double normal = pair->normal_force, shear = pair->shear_force;
    QnVec2 force = qn_vec2_add_scaled (qn_vec2_scale (normal, contact->normal), shear,
                                       qn_vec2_perp (contact->normal));
    add_force (model, contact->block_a, deformation, force, contact->point, balance);
    add_force (model, contact->block_b, deformation, qn_vec2_scale (-1, force),
               contact->point, balance);
    check->contact_scale = MAX (check->contact_scale, qn_vec2_length (force));

    const QnId sides[2] = { contact->block_a, contact->block_b };
    for (int side = 0; side < 2; side++) {
      const QnLaw *law = find_law (model, overrides, contact, sides[side]);
      double excess = law_excess (law, contact->area, pair);
      if (excess > worst) {
        worst = excess;
        check->violating_pair = (QnId) i;
      }
      QnVec2 on_block =
        deformation == NULL
          ? contact->point
          : qn_block_unplace (model, sides[side], deformation, contact->point);
      double distance = distance_to_outline (model, sides[side], on_block);
      if (distance > check->point_distance) {
        check->point_distance = distance;
        check->distant_pair = (QnId) i;
      }
    }
  }
  check->yield_violation = check->contact_scale > 0 ? worst / check->contact_scale : 0;
  g_hash_table_unref (overrides);
}

/* Contacts that blocks found on their way, of which the result has been compared with the model. */
static void
check_found (const QnResult *result, const QnModel *model, const double *deformation,
             double *balance, QnResultCheck *check)
{
  size_t count;
  const QnFoundForce *forces = qn_step_found (result, result->step_count - 1, &count);
  for (size_t i = 0; i < count; i++) {
    const QnFoundContact *contact = &result->found[forces[i].found].contact;
    QnVec2 force = qn_found_force (model, contact, &forces[i], deformation);
    QnVec2 corner = qn_block_place (model, contact->other, deformation,
                                    qn_found_corner (model, contact));
    add_force (model, contact->block, deformation, force, corner, balance);
    add_force (model, contact->other, deformation, qn_vec2_scale (-1, force), corner,
               balance);
    check->contact_scale = MAX (check->contact_scale, qn_vec2_length (force));
  }
}

/* Sets the balance to the loads at the multiplier, and the force that counts as 1. */
static void
add_loads (const QnModel *model, const double *dead, const double *live, double *balance,
           QnResultCheck *check)
{
  double largest_load = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    bool free_to_move = !(block->support[QN_DOF_UX] && block->support[QN_DOF_UY]
                          && block->support[QN_DOF_RZ]);
    if (free_to_move)
      check->force_scale = MAX (check->force_scale, model->blocks[i].weight);
    for (size_t dof = 0; dof < QN_DOF_COUNT; dof++) {
      size_t k = i * QN_DOF_COUNT + dof;
      double load = dead[k] + live[k];
      balance[k] = load;
      if (free_to_move && dof != QN_DOF_RZ)
        largest_load = MAX (largest_load, fabs (load));
    }
  }
  for (size_t k = model->block_count * QN_DOF_COUNT;
       k < qn_model_body_count (model) * QN_DOF_COUNT; k++) {
    balance[k] = dead[k] + live[k];
    if (k % QN_DOF_COUNT != QN_DOF_RZ)
      largest_load = MAX (largest_load, fabs (balance[k]));
  }
  if (check->force_scale == 0)
    check->force_scale = largest_load;
}

/* Whether the multiplier was driven and not the motion: then the last equilibrium is the one at
 * collapse, while a path beyond its peak ends below. */
static gboolean
is_load_driven (const QnModel *model, const QnResult *result)
{
  QnProcedure procedure =
    result->stage > 0 && (size_t) result->stage <= model->stage_count
      ? model->stages[result->stage - 1].procedure
      : model->analysis.procedure;
  return procedure == QN_PROCEDURE_LOAD || procedure == QN_PROCEDURE_LIMIT;
}

/* How much of every load set acts at the last equilibrium. */
static void
find_factors (const QnModel *model, const QnResult *result, QnResultCheck *check,
              double *factors)
{
  const QnStep *last = &result->steps[result->step_count - 1];
  check->multiplier = last->multiplier;
  if (result->has_collapse_multiplier && is_load_driven (model, result))
    check->multiplier = result->collapse_multiplier;

  qn_result_load_factors (model, result, result->step_count - 1, factors);
  uint32_t driven = last->stage > 0 && (size_t) last->stage <= model->stage_count
                      ? model->stages[last->stage - 1].sets
                      : 1;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    if ((driven >> set & 1) != 0)
      factors[set] = check->multiplier;
}

static void
find_worst_node (const QnModel *model, const double *balance, double *worst,
                 QnResultCheck *check)
{
  for (size_t i = 0; i < model->node_count; i++)
    for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
      size_t body = model->block_count + i;
      double out = fabs (balance[body * QN_DOF_COUNT + (size_t) dof]);
      if (dof == QN_DOF_RZ)
        out /= model->characteristic_length;
      if (!qn_model_body_is_fixed (model, body, (QnDof) dof) && out > *worst) {
        *worst = out;
        check->unbalanced_node = (QnId) i;
        check->unbalanced_block = QN_NONE;
      }
    }
}

static void
find_worst_block (const QnModel *model, const double *balance, QnResultCheck *check)
{
  double worst = 0;
  /* Where supports settle or beams alone are loaded, joints and beams are the measure. */
  if (check->force_scale == 0)
    check->force_scale = MAX (check->contact_scale, check->beam_scale);
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    for (size_t dof = 0; dof < QN_DOF_COUNT; dof++) {
      double out = fabs (balance[i * QN_DOF_COUNT + dof]);
      if (dof == QN_DOF_RZ)
        out /= sqrt (block->area);
      if (!block->support[dof] && out > worst) {
        worst = out;
        check->unbalanced_block = (QnId) i;
      }
    }
  }
  find_worst_node (model, balance, &worst, check);
  /* Rounding is that of the largest force. */
  check->force_scale =
    MAX (check->force_scale, MAX (check->contact_scale, check->beam_scale));
  if (check->element_out_of_balance > worst) {
    worst = check->element_out_of_balance;
    check->unbalanced_block = check->unbalanced_node = QN_NONE;
  } else {
    check->unbalanced_element = QN_NONE;
  }
  check->out_of_balance = check->force_scale > 0 ? worst / check->force_scale : 0;
}

/* Whether what a law carries depends on the area that a pair stands for. */
static gboolean
needs_area (const QnLaw *law)
{
  if (law->basis == QN_BASIS_CONTACT || law->kind == QN_LAW_ELASTIC
      || law->kind == QN_LAW_NO_TENSION)
    return FALSE;
  return law->kind != QN_LAW_COULOMB || law->cohesion > 0 || law->tension > 0;
}

/* What makes the check meaningless. */
static const char *
find_obstacle (const QnResultFile *file, const QnModel *model)
{
  if (file->result.step_count == 0)
    return _ ("the result holds no equilibrium to check");
  if (file->result.history.width > 0)
    return _ (
      "an analysis in time ends in motion, not in an equilibrium: see the error of "
      "its energy balance");
  if (model->element_count > 0 && file->result.beam_forces == NULL)
    return _ ("the result holds no forces of the beams");
  if (model->tie_count > 0
      && (file->result.tie_count != model->tie_count
          || qn_result_step_ties (&file->result, file->result.step_count - 1) == NULL))
    return _ ("the result holds no forces of the ties");
  gboolean by_area = FALSE;
  for (size_t i = 0; i < model->law_count; i++)
    by_area = by_area || needs_area (&model->laws[i]);
  for (size_t i = 0; i < file->result.pair_count; i++) {
    const QnResultContact *contact = &file->contacts[i];
    if (by_area && contact->area < 0)
      return _ (
        "the contacts have no area, which the strengths of the laws are given by");
    if (contact->bar != QN_NONE && (size_t) contact->bar >= model->bar_count)
      return _ ("the contacts name a bar that the project does not have");
  }
  return NULL;
}

gboolean
qn_result_check (const QnResultFile *file, const QnProject *project, QnResultCheck *check,
                 GError **error)
{
  const QnModel *model = &project->model;
  const QnResult *result = &file->result;
  *check = (QnResultCheck){ .unbalanced_block = QN_NONE,
                            .unbalanced_node = QN_NONE,
                            .unbalanced_element = QN_NONE,
                            .violating_pair = QN_NONE,
                            .distant_pair = QN_NONE };
  if (!qn_result_file_match (file, project->name, project, NULL, NULL, error))
    return FALSE;
  const char *obstacle = find_obstacle (file, model);
  if (obstacle != NULL) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s: %s", project->name,
                 obstacle);
    return FALSE;
  }

  size_t size = qn_model_body_count (model) * QN_DOF_COUNT;
  double *vectors = qn_alloc (size, 3 * sizeof *vectors);
  if (vectors == NULL) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", project->name,
                 _ ("not enough memory"));
    return FALSE;
  }
  double *balance = vectors, *dead = vectors + size, *live = vectors + 2 * size;
  double factors[QN_MAX_LOAD_SETS];
  find_factors (model, result, check, factors);
  qn_model_dead_forces (model, dead);
  qn_model_set_forces (model, factors, live);
  const double *deformation = qn_result_deformation (model, result);
  if (deformation != NULL) {
    /* The arms of forces that act away from the centroid have turned with their blocks.
     * Loads of sets count with the factor of their set; the dead ones go elsewhere. */
    for (size_t i = 0; i < qn_model_acting_count (model); i++) {
      const QnLoad load = qn_model_acting_load (model, i);
      if (load.kind != QN_LOAD_FORCE && load.kind != QN_LOAD_NODE)
        continue;
      size_t rz = qn_model_load_body (model, &load) * QN_DOF_COUNT + QN_DOF_RZ;
      QnVec2 arm = qn_model_load_arm (model, &load);
      QnVec2 turned = qn_vec2_rotate (arm, cos (deformation[rz]), sin (deformation[rz]));
      double moment = qn_vec2_cross (qn_vec2_sub (turned, arm), load.vector);
      if (load.set == QN_NONE)
        dead[rz] += moment;
      else
        live[rz] += factors[load.set] * moment;
    }
  }
  add_loads (model, dead, live, balance, check);
  check_pairs (file, model, deformation, balance, check);
  if (deformation != NULL)
    check_found (result, model, deformation, balance, check);
  qn_result_check_add_beams (file, model, deformation, factors, balance, check);
  qn_result_check_add_ties (file, model, deformation, balance, check);
  find_worst_block (model, balance, check);
  if (check->tie_excess > 0)
    check->yield_violation =
      MAX (check->yield_violation, check->tie_excess / check->force_scale);
  free (vectors);
  return TRUE;
}
