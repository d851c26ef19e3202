#include "solve.h"

#include <glib.h>
#include <math.h>
#include <string.h>

void
verify_contact_resultant (const Solved *solved, QnId block, double resultant[3])
{
  const QnContacts *contacts = &solved->contacts;
  QnVec2 centroid = solved->model.blocks[block].centroid;
  memset (resultant, 0, 3 * sizeof *resultant);
  for (size_t i = 0; i < contacts->pair_count; i++) {
    const QnContactPair *pair = &contacts->pairs[i];
    const QnContactFace *face = &contacts->faces[pair->face];
    const QnPairResult *force = &solved->result.pairs[i];
    if (face->a != block && face->b != block)
      continue;
    double sign = face->a == block ? 1 : -1;
    QnVec2 f =
      qn_vec2_add_scaled (qn_vec2_scale (sign * force->normal_force, face->normal),
                          sign * force->shear_force, face->tangent);
    resultant[0] += f.x;
    resultant[1] += f.y;
    resultant[2] += qn_vec2_cross (qn_vec2_sub (pair->point, centroid), f);
  }
}

/* Every free block in equilibrium with its loads, relative to the largest block weight. */
static void
check_equilibrium (const Solved *solved)
{
  const QnModel *model = &solved->model;
  const QnStep *last = &solved->result.steps[solved->result.step_count - 1];
  g_autofree double *dead = g_new0 (double, 3 * model->block_count);
  g_autofree double *live = g_new0 (double, 3 * model->block_count);
  double heaviest = 0, worst = 0;

  qn_model_set_forces (model, NULL, dead);
  qn_model_live_forces (model, live);
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    double arm = sqrt (block->area), contact[3];
    heaviest = fmax (heaviest, block->weight);
    verify_contact_resultant (solved, (QnId) i, contact);
    for (int dof = 0; dof < 3; dof++)
      if (!block->support[dof]) {
        double sum =
          contact[dof] + dead[3 * i + dof] + last->multiplier * live[3 * i + dof];
        worst = fmax (worst, fabs (sum) / (dof == QN_DOF_RZ ? arm : 1));
      }
  }
  g_assert_cmpfloat (worst, <=, 1e-6 * heaviest);
}

/* |t| <= c - mu n and n <= ft at every pair, for the weaker of its two laws, relative to the
 * largest contact force. Laws on the contact basis only. */
static void
check_strength (const Solved *solved)
{
  const QnContacts *contacts = &solved->contacts;
  double largest = 0, worst = 0;
  for (size_t i = 0; i < contacts->pair_count; i++) {
    const QnContactFace *face = &contacts->faces[contacts->pairs[i].face];
    const QnPairResult *force = &solved->result.pairs[i];
    const QnId laws[] = { face->law_a, face->law_b };
    largest = fmax (largest, hypot (force->normal_force, force->shear_force));
    for (int side = 0; side < 2; side++) {
      const QnLaw *law = &solved->model.laws[laws[side]];
      double slip =
        fabs (force->shear_force) + law->friction * force->normal_force - law->cohesion;
      worst = fmax (worst, fmax (slip, force->normal_force - law->tension));
    }
  }
  g_assert_cmpfloat (worst, <=, 1e-6 * largest);
}

void
verify_solve (Solved *solved, QnModel *model)
{
  QnDiag diag = { 0 };
  memset (solved, 0, sizeof *solved);
  solved->model = *model;
  memset (model, 0, sizeof *model);

  if (solved->model.characteristic_length == 0) {
    QnStatus status = qn_model_prepare (&solved->model, &diag);
    g_assert_cmpstr (qn_problem_text (diag.problem), ==,
                     qn_problem_text (QN_PROBLEM_NONE));
    g_assert_cmpint (status, ==, QN_OK);
  }
  g_assert_cmpint (qn_contacts_detect (&solved->model, &solved->contacts, &diag), ==,
                   QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (&solved->model, &solved->contacts, &diag),
                   ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&solved->model, &solved->contacts, NULL, NULL,
                                    &solved->result, &diag),
                   ==, QN_OK);
  if (solved->result.outcome != QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    check_equilibrium (solved);
    check_strength (solved);
  }
}

void
verify_clear (Solved *solved)
{
  qn_result_clear (&solved->result);
  qn_contacts_clear (&solved->contacts);
  qn_model_clear (&solved->model);
}

double
verify_collapse (QnModel *model)
{
  Solved solved;
  verify_solve (&solved, model);
  g_assert_cmpint (solved.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_true (solved.result.has_collapse_multiplier);
  double multiplier = solved.result.collapse_multiplier;
  verify_clear (&solved);
  return multiplier;
}
