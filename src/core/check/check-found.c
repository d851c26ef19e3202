/* Contacts that blocks found on their way: forces, and that none is missing. */
#include "core/base/memory.h"
#include "core/check/check-parts.h"
#include "core/result/result-contact.h"

#include <math.h>
#include <stdlib.h>

/* Whether all that the result says of found contacts refers to something. */
static bool
refers (const QnCheck *check)
{
  const QnResult *r = check->result;
  bool exist = qn_result_found_exist (r, check->model);

  for (size_t i = 0; exist && i < r->found_count; i++) {
    const QnFoundContact *c = &r->found[i].contact;
    exist = c->block != c->other && c->inset >= 0
            && qn_sides_find (&check->follow.sides, c->block, c->side) != NULL;
  }
  for (size_t i = 0; i < r->left_count; i++)
    exist = exist && (size_t) r->left[i].face < check->contacts->face_count;
  return exist;
}

bool
qn_check_found_init (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  const QnAnalysisSettings *settings = &check->model->analysis;
  bool states = r->found_count > 0 || r->left_count > 0 || r->found_force_count > 0;

  check->follows =
    settings->geometry == QN_GEOMETRY_NONLINEAR && !r->limit.given
    && (r->history.width > 0 ? settings->dynamic.follow : settings->follow);
  if (!check->follows) {
    if (states)
      qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_ANALYSIS, QN_NONE, NAN,
                     NAN);
    return true;
  }
  if (qn_contact_follow_init (&check->follow, check->model, check->contacts, diag)
      != QN_OK)
    return false;
  QnFoundContact *contacts = qn_alloc (r->found_count, sizeof *contacts);
  bool known = refers (check), ok = !check->pool.failed && contacts != NULL;
  if (!known)
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_ANALYSIS, QN_NONE, NAN,
                   NAN);
  for (size_t i = 0; ok && known && i < r->found_count; i++)
    contacts[i] = r->found[i].contact;
  if (ok && known)
    ok = qn_contacts_with_found (check->model, check->contacts, &check->follow.sides,
                                 contacts, r->found_count, &check->all, diag)
         == QN_OK;
  check->follows = known;
  free (contacts);
  return ok;
}

void
qn_check_found_clear (QnCheck *check)
{
  qn_contact_follow_clear (&check->follow);
  qn_contacts_clear (&check->all);
}

void
qn_check_found_take (QnCheck *check, size_t step)
{
  const QnResult *r = check->result;
  QnAssembly *as = &check->assembly;
  size_t drawn = check->contacts->pair_count;

  if (!check->follows)
    return;
  for (size_t i = 0; i < r->found_count; i++) {
    check->stated[drawn + i] = (QnPairResult){ .state = QN_PAIR_OPEN };
    check->begins[drawn + i] = as->inactive[drawn + i];
    as->inactive[drawn + i] = true;
  }
  check->found = qn_step_found (r, step, &check->found_count);
  for (size_t i = 0; i < check->found_count; i++) {
    const QnFoundForce *force = &check->found[i];
    size_t pair = drawn + (size_t) force->found;
    check->stated[pair] = (QnPairResult){ .normal_force = force->normal,
                                          .shear_force = force->shear,
                                          .state = force->state };
    if (!as->inactive[pair]) /* stated twice */
      qn_check_tell_model (check, QN_CLAIM_HISTORY, (QnId) step, force->normal, NAN);
    as->inactive[pair] = false;
  }
  for (size_t i = 0; i < r->left_count; i++) {
    const QnContactFace *face = &check->contacts->faces[r->left[i].face];
    /* The dead load comes before all that moves, also where that begins at the same time. */
    if (step == 0 || !(r->left[i].time <= r->steps[step].time))
      continue;
    check->follow.left[r->left[i].face] = true;
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      as->inactive[p] = true;
  }
}

/* Whether a corner lies within the block and between the ends of the side. */
static bool
is_within (const QnContactFollow *follow, const QnFoundContact *contact,
           const double *rows, double depth)
{
  QnCornerPlace at = qn_contact_follow_place (follow, contact, rows);
  double over = qn_contact_follow_band (follow, contact->block, contact->other);

  return at.apart < -depth && at.along > over && at.along < at.length - over;
}

/* Along a path contacts change once a step is accepted: those of a step are what its blocks came upon
 * until the step before. */
QnStatus
qn_check_found_missing (QnCheck *check, size_t step, QnDiag *diag)
{
  QnContactFollow *follow = &check->follow;
  bool in_time = check->result->history.width > 0;
  const double *rows = qn_result_step_displacements (check->result, step);
  const double *until =
    in_time || step == 0 ? rows : qn_result_step_displacements (check->result, step - 1);
  double depth = QN_CHECK_TOLERANCE * follow->smallest;
  bool changed;

  follow->count = 0; /* every step by itself */
  if (step == 0)
    qn_contact_follow_set_overlap (follow, check->assembly.elongations);
  QnStatus status = qn_contact_follow_search (
    follow, until, QN_FOLLOW_MARGIN * follow->smallest, &changed, diag);
  if (status != QN_OK)
    return status;
  for (size_t i = 0; i < check->found_count; i++) {
    const QnFound *found = &check->result->found[check->found[i].found];
    size_t at = qn_contact_follow_find (follow, &found->contact);
    if (at < follow->count) {
      follow->active[at] = true;
      follow->origins[at] = (QnId) i; /* where the step states it */
    }
  }
  qn_contact_follow_activate (follow, until);
  for (size_t i = 0; i < follow->count; i++) {
    const QnFoundContact *c = &follow->found[i];
    if (follow->active[i] && follow->origins[i] == QN_NONE
        && is_within (follow, c, until, depth) && is_within (follow, c, rows, depth))
      qn_check_tell (check, QN_CLAIM_FORCES, (QnId) step, QN_ENTITY_BLOCK, c->other, 0,
                     qn_contact_follow_place (follow, c, rows).apart);
  }
  return QN_OK;
}
