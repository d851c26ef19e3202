#include "core/dynamics/moving-contacts.h"

#include "core/base/memory.h"
#include "core/dynamics/pair-motion.h"

#include <stdlib.h>
#include <string.h>

QnStatus
qn_moving_contacts_init (QnMovingContacts *moving, const QnAssembly *as, QnDiag *diag)
{
  const QnModel *model = as->model;

  *moving = (QnMovingContacts){ 0 };
  moving->displacements =
    qn_alloc (qn_model_body_count (model) * QN_DOF_COUNT, sizeof (double));
  QnStatus status = moving->displacements != NULL ? QN_OK : qn_diag_no_memory (diag);
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
  qn_contacts_clear (&moving->lists[0]);
  qn_contacts_clear (&moving->lists[1]);
  free (moving->displacements);
  free (moving->noted);
  *moving = (QnMovingContacts){ 0 };
}

/* --- Memory of new pairs ----------------------------------------------------------------- */

/* State of the pairs between two blocks before contacts change. */
typedef struct {
  double normal, shear; /* N */
  double released;      /* J: stored by those that become inactive */
} Exchange;

static void
add_exchange (const QnAssembly *as, size_t pair, bool becomes_inactive, Exchange *sum)
{
  if (as->inactive[pair])
    return;
  QnPairElasticity elastic = qn_pair_elasticity (&as->springs[pair]);
  const double *force = as->responses[pair].force;
  sum->normal += force[0];
  sum->shear += force[1];
  sum->released += becomes_inactive ? qn_pair_elastic_energy (&elastic, force) : 0;
}

/* Where the corner of a listed contact lies, and the force of its pair were there no inset, with the shear force that
 * goes with it. */
static QnCornerPlace
undiminished (const QnMovingContacts *moving, const QnAssembly *as, size_t i,
              double ratio, QnPairElasticity *elastic, double force[2])
{
  const QnContactFollow *follow = &moving->follow;
  QnCornerPlace at =
    qn_contact_follow_place (follow, &follow->found[i], moving->displacements);

  *elastic = qn_pair_elasticity (&as->springs[follow->drawn->pair_count + i]);
  force[0] = elastic->k[0] * fmin (at.apart, 0);
  force[1] = ratio * force[0];
  return at;
}

/* --- Transfer ---------------------------------------------------------------------------- */

/* A pair without force. */
static void
carry_nothing (QnAssembly *as, size_t pair)
{
  as->responses[pair] =
    (QnPairResponse){ .memory = as->committed[pair], .state = QN_PAIR_OPEN };
}

/* Activates a pair: `share` of how deep its corner lies counts, with the shear force that goes with it. */
static void
activate (QnMovingContacts *moving, QnAssembly *as, size_t i, double ratio, double share)
{
  QnFoundContact *c = &moving->follow.found[i];
  QnPairMemory *memory = &as->committed[moving->follow.drawn->pair_count + i];
  QnPairElasticity elastic;
  double force[2];
  QnCornerPlace at = undiminished (moving, as, i, ratio, &elastic, force);
  double slip = at.along - c->foot;

  c->inset = (1 - share) * fmax (-at.apart, 0);
  *memory = (QnPairMemory){ .qa = { 0, slip } };
  memory->a.slip = slip - share * force[1] / elastic.k[1];
}

/* Pairs between the same two blocks that become inactive or active, from `first` to `end`. */
static void
set_inactive (QnMovingContacts *moving, QnAssembly *as, size_t first, size_t end)
{
  const bool *active = moving->follow.active;
  bool *inactive = as->inactive + moving->follow.drawn->pair_count;
  /* Between the blocks of the listed contacts from `first` to `end`. */
  const QnContacts *drawn = moving->follow.drawn;
  const QnFoundContact *c = &moving->follow.found[first];
  Exchange before = { 0 };
  size_t f, last;
  qn_contacts_between (drawn, c->block, c->other, &f, &last);
  for (; f < last; f++) {
    const QnContactFace *face = &drawn->faces[f];
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      add_exchange (as, (size_t) p, moving->follow.left[f], &before);
  }
  for (size_t i = first; i < end; i++)
    add_exchange (as, drawn->pair_count + i, !moving->follow.active[i], &before);
  double ratio = before.normal < 0 ? before.shear / before.normal : 0, stored = 0;

  for (size_t i = first; i < end; i++)
    if (active[i] && inactive[i]) {
      QnPairElasticity elastic;
      double force[2];
      undiminished (moving, as, i, ratio, &elastic, force);
      stored += qn_pair_elastic_energy (&elastic, force);
    }
  double share = stored > before.released ? sqrt (before.released / stored) : 1;
  for (size_t i = first; i < end; i++) {
    if (inactive[i] != active[i])
      continue;
    if (active[i])
      activate (moving, as, i, ratio, share);
    inactive[i] = !active[i];
    carry_nothing (as, moving->follow.drawn->pair_count + i);
  }
}

/* Takes up which pairs are inactive now, and where their contact begins. */
static void
take_changes (QnMovingContacts *moving, QnContacts *contacts, QnAssembly *as)
{
  QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;

  for (size_t first = 0, end; first < follow->count; first = end) {
    end = qn_contact_follow_end (follow, first);
    set_inactive (moving, as, first, end);
  }
  for (size_t p = 0; p < drawn; p++)
    if (follow->left[follow->drawn->pairs[p].face]) {
      as->inactive[p] = true;
      carry_nothing (as, p);
    }
  for (size_t i = 0; i < follow->count; i++)
    if (qn_contacts_set_inset (contacts, drawn + i, follow->found[i].inset))
      qn_assembly_place_pair (as, drawn + i);
}

/* A new assembly for a new list. */
static QnStatus
rebuild (QnMovingContacts *moving, QnEquilibrium *eq, QnDiag *diag)
{
  const QnContactFollow *follow = &moving->follow;
  QnContacts *before = moving->contacts;
  QnContacts *contacts = &moving->lists[before == moving->lists ? 1 : 0];
  QnAssembly next = { 0 };
  QnStatus status = qn_contacts_with_found (follow->model, follow->drawn, &follow->sides,
                                            follow->found, follow->count, contacts, diag);

  if (status == QN_OK)
    status = qn_assembly_setup (&next, follow->model, contacts, diag);
  if (status == QN_OK) {
    /* Loads, memory and forces of all pairs, and which are inactive, as they were before. */
    const QnAssembly *old = &eq->assembly;
    size_t drawn = follow->drawn->pair_count;
    qn_assembly_set_loads (&next, old->held, old->driven);
    next.commits = old->commits;
    memcpy (next.committed, old->committed, drawn * sizeof *next.committed);
    memcpy (next.responses, old->responses, drawn * sizeof *next.responses);
    memcpy (next.inactive, old->inactive, drawn * sizeof *next.inactive);
    for (size_t i = 0; i < follow->count; i++) {
      next.inactive[drawn + i] = true;
      carry_nothing (&next, drawn + i);
      if (follow->origins[i] == QN_NONE)
        continue;
      size_t origin = drawn + (size_t) follow->origins[i];
      next.committed[drawn + i] = old->committed[origin];
      next.responses[drawn + i] = old->responses[origin];
      next.inactive[drawn + i] = old->inactive[origin];
    }
    take_changes (moving, contacts, &next);
    status = qn_equilibrium_exchange (eq, &next, diag);
  }
  if (status != QN_OK)
    return status;
  if (before != NULL)
    qn_contacts_clear (before);
  moving->contacts = contacts;
  return QN_OK;
}

/* --- After a step ------------------------------------------------------------------------ */

static bool
leave_joints (QnMovingContacts *moving, const QnAssembly *old, double time,
              QnResult *result, bool *any)
{
  QnContactFollow *follow = &moving->follow;
  const QnContacts *drawn = follow->drawn;

  *any = qn_contact_follow_leave (follow, moving->displacements, old->responses);
  if (!*any)
    return true;
  for (size_t f = 0; f < drawn->face_count; f++) {
    bool before = old->inactive[drawn->faces[f].first_pair];
    if (follow->left[f] && !before
        && !qn_result_add_left (result, (QnLeftFace){ (QnId) f, time }))
      return false;
  }
  return true;
}

/* Lists contacts anew. */
static QnStatus
search (QnMovingContacts *moving, double margin, bool *changed, QnDiag *diag)
{
  QnContactFollow *follow = &moving->follow;
  QnStatus status =
    qn_contact_follow_search (follow, moving->displacements, margin, changed, diag);
  if (status != QN_OK)
    return status;
  QnId *noted = qn_alloc (follow->count, sizeof *noted);
  if (noted == NULL)
    return qn_diag_no_memory (diag);
  for (size_t i = 0; i < follow->count; i++)
    noted[i] =
      follow->origins[i] != QN_NONE ? moving->noted[follow->origins[i]] : QN_NONE;
  free (moving->noted);
  moving->noted = noted;
  return QN_OK;
}

QnStatus
qn_moving_contacts_update (QnMovingContacts *moving, QnEquilibrium *eq, double margin,
                           double time, QnResult *result, bool *changed, QnDiag *diag)
{
  QnContactFollow *follow = &moving->follow;
  bool left, listed = false;
  QnStatus status = QN_OK;

  margin = fmax (margin, fmax (QN_FOLLOW_MARGIN * follow->smallest,
                               2 * QN_FOLLOW_OVERLAP * follow->overlap));
  qn_assembly_expand (&eq->assembly, eq->u, moving->displacements);
  if (!leave_joints (moving, &eq->assembly, time, result, &left))
    return qn_diag_no_memory (diag);
  if (left || qn_contact_follow_is_due (follow, moving->displacements, margin))
    status = search (moving, 2 * margin, &listed, diag);
  bool activated =
    status == QN_OK && qn_contact_follow_activate (follow, moving->displacements);
  *changed = listed || left || activated;
  if (status == QN_OK && (listed || left))
    status = rebuild (moving, eq, diag);
  else if (activated)
    take_changes (moving, moving->contacts, &eq->assembly);
  return status;
}

bool
qn_moving_contacts_record (QnMovingContacts *moving, const QnAssembly *as, double time,
                           const QnPairResult *pairs, QnResult *result)
{
  size_t drawn = moving->follow.drawn->pair_count;

  for (size_t p = drawn; p < as->pair_count; p++) {
    const double *force = as->responses[p].force;
    QnId *noted = &moving->noted[p - drawn];
    QnFound found = { moving->follow.found[p - drawn], time };
    bool acts = force[0] != 0 || force[1] != 0 || found.contact.inset > 0;
    if (as->inactive[p] || !acts)
      continue;
    if (*noted == QN_NONE || result->found[*noted].contact.inset != found.contact.inset) {
      if (!qn_result_add_found (result, found))
        return false;
      *noted = (QnId) result->found_count - 1;
    }
    if (pairs == NULL)
      continue;
    QnFoundForce stated = { .step = (int32_t) result->step_count - 1,
                            .found = *noted,
                            .normal = force[0],
                            .shear = force[1],
                            .state = pairs[p].state };
    if (!qn_result_add_found_force (result, stated))
      return false;
  }
  return true;
}

bool
qn_record_step (QnEquilibrium *eq, QnMovingContacts *moving, double multiplier,
                QnStep step, QnResult *result)
{
  QnAssembly *as = &eq->assembly;
  const QnModel *model = as->model;
  QnPool pool = { 0 };
  double *rows =
    qn_pool_alloc (&pool, qn_model_body_count (model) * QN_DOF_COUNT, sizeof *rows);
  QnBeamForces *forces = qn_pool_alloc (&pool, model->element_count, sizeof *forces);
  QnTieResult *ties = qn_pool_alloc (&pool, qn_model_tie_count (model), sizeof *ties);
  QnPairResult *pairs = qn_pool_alloc (&pool, as->pair_count, sizeof *pairs);
  bool ok = !pool.failed;

  if (ok) {
    qn_assembly_expand (as, eq->u, rows);
    ok = qn_result_add_step (result, step, rows);
    qn_beam_assembly_forces (as, multiplier, forces);
    ok = ok && (model->element_count == 0 || qn_result_add_beam_forces (result, forces));
    qn_beam_assembly_ties (as, ties);
    ok = ok && qn_result_add_ties (result, ties);
    qn_assembly_reactions (as, multiplier, rows);
    ok = ok && qn_result_add_reactions (result, rows);
    qn_assembly_pair_results (as, eq->u, pairs);
    memcpy (result->pairs, pairs, result->pair_count * sizeof *pairs);
    ok = ok
         && (moving == NULL
             || qn_moving_contacts_record (moving, as, step.time, pairs, result));
    ok = ok && qn_result_add_forces (result, model->analysis.all_forces);
  }
  qn_pool_clear (&pool);
  return ok;
}
