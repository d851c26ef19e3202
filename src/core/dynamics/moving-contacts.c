#include "core/dynamics/moving-contacts.h"

#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

QnStatus
qn_moving_contacts_init (QnMovingContacts *moving, const QnAssembly *as, QnDiag *diag)
{
  const QnModel *model = as->model;

  *moving = (QnMovingContacts){ 0 };
  moving->displacements =
    qn_alloc (qn_model_body_count (model) * QN_DOF_COUNT, sizeof (double));
  moving->slips = qn_alloc (as->pair_count, sizeof (double));
  QnStatus status = moving->displacements != NULL && moving->slips != NULL
                      ? QN_OK
                      : qn_diag_no_memory (diag);
  if (status == QN_OK)
    status = qn_contact_follow_init (&moving->follow, model, as->contacts, diag);
  if (status == QN_OK)
    qn_contact_follow_set_overlap (&moving->follow, as->elongations);
  return status;
}

void
qn_moving_contacts_clear (QnMovingContacts *moving)
{
  qn_contact_follow_clear (&moving->follow);
  if (moving->moved) {
    qn_linsys_free (moving->linsys);
    qn_assembly_clear (&moving->assembly);
    qn_contacts_clear (&moving->contacts);
  }
  free (moving->displacements);
  free (moving->slips);
  free (moving->results);
  *moving = (QnMovingContacts){ 0 };
}

/* --- What new pairs remember ------------------------------------------------------------- */

/* Shear over normal force that two blocks have exchanged last, over all their pairs. */
static double
mobilised (const QnAssembly *as, const QnPairResponse *responses, QnId a, QnId b)
{
  double normal = 0, shear = 0;

  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    if ((face->a != a || face->b != b) && (face->a != b || face->b != a))
      continue;
    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++) {
      normal += responses[p].force[0];
      shear += responses[p].force[1];
    }
  }
  return normal < 0 ? shear / normal : 0;
}

/* A pair that wakes within the block goes on with the shear force that the blocks exchanged before. */
static QnPairMemory
fresh_memory (const QnPairSprings *springs, QnCornerPlace at, double foot, double ratio)
{
  QnPairElasticity elastic = qn_pair_elasticity (springs);
  double slip = at.along - foot, shear = ratio * elastic.k[0] * fmin (at.apart, 0);
  QnPairMemory memory = { 0 };

  memory.a.slip = slip - shear / elastic.k[1];
  memory.qa[1] = slip;
  return memory;
}

/* --- Going over -------------------------------------------------------------------------- */

/* Memory and sleep of all pairs of `as`; `places` of the found ones in the assembly before. */
static void
hand_over (QnMovingContacts *moving, const QnTimeStep *step, QnAssembly *as,
           const QnId *places, size_t before)
{
  const QnAssembly *old = step->assembly;
  const QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;

  memcpy (as->committed, old->committed, drawn * sizeof *as->committed);
  for (size_t i = 0; i < follow->count; i++)
    as->asleep[drawn + i] = true;
  for (size_t i = 0; i < before; i++)
    if (places[i] != QN_NONE) {
      as->committed[drawn + (size_t) places[i]] = old->committed[drawn + i];
      as->asleep[drawn + (size_t) places[i]] = old->asleep[drawn + i];
    }
  for (size_t p = 0; p < drawn; p++)
    as->asleep[p] = follow->left[follow->drawn->pairs[p].face];
}

/* Pairs that fall asleep or wake. */
static void
set_asleep (QnMovingContacts *moving, const QnAssembly *old, const QnPairResponse *last,
            QnAssembly *as)
{
  const QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;

  for (size_t i = 0; i < follow->count; i++) {
    const QnFoundContact *c = &follow->found[i];
    if (follow->awake[i] && as->asleep[drawn + i])
      as->committed[drawn + i] =
        fresh_memory (&as->springs[drawn + i],
                      qn_contact_follow_place (follow, c, moving->displacements), c->foot,
                      mobilised (old, last, c->block, c->other));
    as->asleep[drawn + i] = !follow->awake[i];
  }
}

/* A new assembly for a new list. */
static QnStatus
rebuild (QnMovingContacts *moving, QnTimeStep *step, const QnId *places, size_t before,
         QnDiag *diag)
{
  const QnContactFollow *follow = &moving->follow;
  const QnModel *model = follow->model;
  QnMovingContacts old = *moving;
  QnLinsys *linsys = NULL;
  QnContacts contacts;
  QnAssembly as;
  QnStatus status = qn_contacts_with_found (
    model, follow->drawn, &follow->sides, follow->found, follow->count, &contacts, diag);
  if (status != QN_OK)
    return status;

  /* The assembly keeps where its contacts are. */
  moving->contacts = contacts;
  status = qn_assembly_setup (&as, model, &moving->contacts, diag);
  if (status != QN_OK) {
    moving->contacts = old.contacts;
    qn_contacts_clear (&contacts);
    return status;
  }
  QnVec2 *points = qn_assembly_points (&as);
  if (points != NULL)
    linsys = qn_linsys_new (as.unknown_count, as.ap, as.ai, points);
  free (points);
  if (linsys == NULL)
    status = qn_diag_no_memory (diag);
  if (status == QN_OK) {
    /* Faces of the assembly before are asked for, where they were. */
    moving->contacts = old.contacts;
    hand_over (moving, step, &as, places, before);
    set_asleep (moving, step->assembly, step->start.responses, &as);
    moving->contacts = contacts;
    moving->assembly = as;
    status = qn_time_step_move (step, &moving->assembly, linsys, diag);
  }
  if (status != QN_OK) {
    moving->contacts = old.contacts;
    moving->assembly = old.assembly;
    qn_linsys_free (linsys);
    qn_assembly_clear (&as);
    qn_contacts_clear (&contacts);
    return status;
  }
  if (old.moved) {
    qn_linsys_free (old.linsys);
    qn_assembly_clear (&old.assembly);
    qn_contacts_clear (&old.contacts);
  }
  moving->linsys = linsys;
  moving->moved = true;
  moving->rebuilds++;
  return QN_OK;
}

/* --- After a step ------------------------------------------------------------------------ */

/* How fast a corner moves at most, m/s. */
static double
fastest (const QnMovingContacts *moving, const QnTimeStep *step)
{
  const QnAssembly *as = step->assembly;
  double speed = 0;

  for (size_t b = 0; b < as->model->block_count; b++) {
    double v[QN_DOF_COUNT] = { 0 };
    for (size_t i = 0; i < QN_DOF_COUNT; i++)
      if (as->unknown[QN_DOF_COUNT * b + i] != QN_NONE)
        v[i] = step->start.v[as->unknown[QN_DOF_COUNT * b + i]];
    speed = fmax (speed, hypot (v[0], v[1])
                           + moving->follow.reach[b] * fabs (v[QN_DOF_RZ]) / as->length);
  }
  return speed;
}

static double
margin_for (const QnMovingContacts *moving, const QnTimeStep *step, double longest)
{
  double smallest = INFINITY;

  for (size_t b = 0; b < moving->follow.model->block_count; b++)
    smallest = fmin (smallest, moving->follow.sizes[b]);
  smallest *= QN_FOLLOW_MARGIN;
  return fmax (fmax (smallest, 2 * QN_FOLLOW_OVERLAP * moving->follow.overlap),
               2 * longest * fastest (moving, step));
}

static bool
leave_joints (QnMovingContacts *moving, const QnTimeStep *step, double time,
              QnResult *result, bool *any)
{
  QnContactFollow *follow = &moving->follow;
  const QnContacts *drawn = follow->drawn;
  size_t before = result->left_count;

  for (size_t p = 0; p < drawn->pair_count; p++) {
    const QnPairMemory *memory = &step->start.responses[p].memory;
    moving->slips[p] = memory->a.slip + memory->b.slip;
  }
  *any = qn_contact_follow_leave (follow, moving->displacements, moving->slips);
  if (!*any)
    return true;
  for (size_t f = 0; f < drawn->face_count; f++) {
    size_t i = 0;
    while (i < before && result->left[i].face != (QnId) f)
      i++;
    if (follow->left[f] && i == before
        && !qn_result_add_left (result, (QnLeftFace){ (QnId) f, time }))
      return false;
  }
  return true;
}

QnStatus
qn_moving_contacts_update (QnMovingContacts *moving, QnTimeStep *step, double longest,
                           double time, QnEnergy *energy, QnResult *result, QnDiag *diag)
{
  QnContactFollow *follow = &moving->follow;
  size_t before = follow->count;
  double margin = margin_for (moving, step, longest);
  QnId *places = NULL;
  bool left, listed = false;
  QnStatus status = QN_OK;

  qn_assembly_expand (step->assembly, step->start.u, moving->displacements);
  if (!leave_joints (moving, step, time, result, &left))
    return qn_diag_no_memory (diag);
  if (left || qn_contact_follow_is_due (follow, moving->displacements, margin)) {
    places = qn_alloc (before, sizeof *places);
    status = places == NULL
               ? qn_diag_no_memory (diag)
               : qn_contact_follow_search (follow, moving->displacements, 2 * margin,
                                           places, &listed, diag);
  }
  bool woken = status == QN_OK && qn_contact_follow_wake (follow, moving->displacements);
  if (status == QN_OK && (listed || left)) {
    status = rebuild (moving, step, places, before, diag);
  } else if (status == QN_OK && woken) {
    set_asleep (moving, step->assembly, step->start.responses, step->assembly);
    qn_time_step_renew (step);
  }
  free (places);
  if (status == QN_OK && (listed || left || woken))
    qn_energy_renew (step, energy);
  return status;
}

bool
qn_moving_contacts_record (QnMovingContacts *moving, const QnTimeStep *step, double time,
                           int32_t step_index, QnResult *result)
{
  const QnAssembly *as = step->assembly;
  size_t drawn = moving->follow.drawn->pair_count;

  if (step_index >= 0) {
    if (!qn_array_reserve (&moving->results, &moving->result_capacity, as->pair_count,
                           sizeof *moving->results))
      return false;
    qn_assembly_pair_results (as, step->start.u, moving->results);
    memcpy (result->pairs, moving->results, drawn * sizeof *moving->results);
  }
  for (size_t p = drawn; p < as->pair_count; p++) {
    const double *force = step->start.responses[p].force;
    QnId place;
    if (force[0] == 0 && force[1] == 0)
      continue;
    if (!qn_result_add_found (result, (QnFound){ moving->follow.found[p - drawn], time },
                              &place))
      return false;
    if (step_index < 0)
      continue;
    QnFoundForce stated = { .step = step_index,
                            .found = place,
                            .normal = force[0],
                            .shear = force[1],
                            .state = moving->results[p].state };
    if (!qn_result_add_found_force (result, stated))
      return false;
  }
  return true;
}
