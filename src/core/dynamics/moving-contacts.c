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
  free (moving->noted);
  free (moving->slips);
  free (moving->results);
  *moving = (QnMovingContacts){ 0 };
}

/* --- What new pairs remember ------------------------------------------------------------- */

/* What the pairs between two blocks did before contacts change. */
typedef struct {
  double normal, shear; /* N */
  double released;      /* J: stored by those that become inactive */
} Exchange;

static void
add_exchange (const QnTimeStep *step, size_t pair, bool becomes_inactive, Exchange *sum)
{
  const QnInstant *last = &step->start;

  if (step->assembly->inactive[pair])
    return;
  QnPairInstant at = {
    .q = { last->elongations[2 * pair], last->elongations[2 * pair + 1] },
    .response = &last->responses[pair],
  };
  sum->normal += at.response->force[0];
  sum->shear += at.response->force[1];
  sum->released +=
    becomes_inactive ? qn_pair_elastic_energy (&step->elasticity[pair], &at) : 0;
}

/* Between the blocks of the listed contacts from `first` to `end`; origins: places of the listed
 * contacts in the list of `step`, or QN_NONE (NULL: the same). */
static Exchange
exchange (const QnContactFollow *follow, const QnTimeStep *step, const QnId *origins,
          size_t first, size_t end)
{
  const QnContacts *drawn = follow->drawn;
  const QnFoundContact *c = &follow->found[first];
  Exchange sum = { 0 };
  size_t f, last;

  qn_contacts_between (drawn, c->block, c->other, &f, &last);
  for (; f < last; f++) {
    const QnContactFace *face = &drawn->faces[f];
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      add_exchange (step, (size_t) p, follow->left[f], &sum);
  }
  for (size_t i = first; i < end; i++) {
    QnId origin = origins != NULL ? origins[i] : (QnId) i;
    if (origin != QN_NONE)
      add_exchange (step, drawn->pair_count + (size_t) origin, !follow->active[i], &sum);
  }
  return sum;
}

/* Normal force of a pair without inset whose corner lies within the block, and the shear force that goes
 * with it. */
static void
undiminished (const QnPairElasticity *elastic, double apart, double ratio,
              double force[2])
{
  force[0] = elastic->k[0] * fmin (apart, 0);
  force[1] = ratio * force[0];
}

/* --- Transfer ---------------------------------------------------------------------------- */

/* Memory of all pairs, and which are inactive, of `as`. */
static void
transfer (QnMovingContacts *moving, const QnTimeStep *step, QnAssembly *as,
          const QnId *origins)
{
  const QnAssembly *old = step->assembly;
  const QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;

  memcpy (as->committed, old->committed, drawn * sizeof *as->committed);
  for (size_t p = 0; p < drawn; p++)
    as->inactive[p] = follow->left[follow->drawn->pairs[p].face];
  for (size_t i = 0; i < follow->count; i++) {
    as->inactive[drawn + i] = origins[i] == QN_NONE;
    if (origins[i] == QN_NONE)
      continue;
    as->committed[drawn + i] = old->committed[drawn + (size_t) origins[i]];
    as->inactive[drawn + i] = old->inactive[drawn + (size_t) origins[i]];
  }
}

static bool
becomes_active (const QnMovingContacts *moving, const QnAssembly *as, size_t i)
{
  return moving->follow.active[i] && as->inactive[moving->follow.drawn->pair_count + i];
}

/* Activates a pair: `share` of how deep its corner lies counts, with the shear force that goes with it. */
static void
activate (QnMovingContacts *moving, QnAssembly *as, size_t i, double ratio, double share)
{
  QnContactFollow *follow = &moving->follow;
  QnFoundContact *c = &follow->found[i];
  size_t pair = follow->drawn->pair_count + i;
  QnCornerPlace at = qn_contact_follow_place (follow, c, moving->displacements);
  QnPairElasticity elastic = qn_pair_elasticity (&as->springs[pair]);
  double force[2], slip = at.along - c->foot;

  undiminished (&elastic, at.apart, ratio, force);
  c->inset = (1 - share) * fmax (-at.apart, 0);
  as->committed[pair] = (QnPairMemory){ 0 };
  as->committed[pair].a.slip = slip - share * force[1] / elastic.k[1];
  as->committed[pair].qa[1] = slip;
}

/* Pairs between the same two blocks that become inactive or active, from `first` to `end`. */
static void
set_inactive (QnMovingContacts *moving, const QnTimeStep *step, QnAssembly *as,
              const QnId *origins, size_t first, size_t end)
{
  QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;
  Exchange before = exchange (follow, step, origins, first, end);
  double ratio = before.normal < 0 ? before.shear / before.normal : 0, stored = 0;

  for (size_t i = first; i < end; i++)
    if (becomes_active (moving, as, i)) {
      QnPairElasticity elastic = qn_pair_elasticity (&as->springs[drawn + i]);
      QnCornerPlace at =
        qn_contact_follow_place (follow, &follow->found[i], moving->displacements);
      double force[2];
      undiminished (&elastic, at.apart, ratio, force);
      stored +=
        0.5 * (force[0] * force[0] / elastic.k[0] + force[1] * force[1] / elastic.k[1]);
    }
  double share = stored > before.released ? sqrt (before.released / stored) : 1;
  for (size_t i = first; i < end; i++) {
    if (becomes_active (moving, as, i))
      activate (moving, as, i, ratio, share);
    as->inactive[drawn + i] = !follow->active[i];
  }
}

/* Takes up which pairs are inactive now, and where their contact begins. */
static void
take_changes (QnMovingContacts *moving, const QnTimeStep *step, QnContacts *contacts,
              QnAssembly *as, const QnId *origins)
{
  QnContactFollow *follow = &moving->follow;
  size_t drawn = follow->drawn->pair_count;

  for (size_t first = 0, end; first < follow->count; first = end) {
    end = qn_contact_follow_end (follow, first);
    set_inactive (moving, step, as, origins, first, end);
  }
  for (size_t i = 0; i < follow->count; i++)
    if (qn_contacts_set_inset (contacts, drawn + i, follow->found[i].inset))
      qn_assembly_place_pair (as, drawn + i);
}

/* A new assembly for a new list. */
static QnStatus
rebuild (QnMovingContacts *moving, QnTimeStep *step, const QnId *origins, QnDiag *diag)
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
    linsys =
      qn_linsys_new (as.unknown_count, as.ap, as.ai, points, model->analysis.workers);
  free (points);
  if (linsys == NULL)
    status = qn_diag_no_memory (diag);
  if (status == QN_OK) {
    transfer (moving, step, &as, origins);
    take_changes (moving, step, &moving->contacts, &as, origins);
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

  for (size_t p = 0; p < drawn->pair_count; p++) {
    const QnPairMemory *memory = &step->start.responses[p].memory;
    moving->slips[p] = memory->a.slip + memory->b.slip;
  }
  *any = qn_contact_follow_leave (follow, moving->displacements, moving->slips);
  if (!*any)
    return true;
  for (size_t f = 0; f < drawn->face_count; f++) {
    bool before = step->assembly->inactive[drawn->faces[f].first_pair];
    if (follow->left[f] && !before
        && !qn_result_add_left (result, (QnLeftFace){ (QnId) f, time }))
      return false;
  }
  return true;
}

/* Lists contacts anew. *origins: of those that are listed now the places in the list before, or
 * QN_NONE. */
static QnStatus
search (QnMovingContacts *moving, double margin, bool *changed, QnId **origins,
        QnDiag *diag)
{
  QnContactFollow *follow = &moving->follow;
  size_t before = follow->count;
  QnId *places = qn_alloc (before, sizeof *places), *noted = NULL;
  QnStatus status = places == NULL
                      ? qn_diag_no_memory (diag)
                      : qn_contact_follow_search (follow, moving->displacements, margin,
                                                  places, changed, diag);
  if (status == QN_OK) {
    *origins = qn_alloc (follow->count, sizeof **origins);
    noted = qn_alloc (follow->count, sizeof *noted);
    if (*origins == NULL || noted == NULL)
      status = qn_diag_no_memory (diag);
  }
  if (status == QN_OK) {
    for (size_t i = 0; i < follow->count; i++)
      (*origins)[i] = noted[i] = QN_NONE;
    for (size_t i = 0; i < before; i++)
      if (places[i] != QN_NONE) {
        (*origins)[places[i]] = (QnId) i;
        noted[places[i]] = moving->noted[i];
      }
    free (moving->noted);
    moving->noted = noted;
  } else {
    free (noted);
  }
  free (places);
  return status;
}

QnStatus
qn_moving_contacts_update (QnMovingContacts *moving, QnTimeStep *step, double longest,
                           double time, QnEnergy *energy, QnResult *result, QnDiag *diag)
{
  QnContactFollow *follow = &moving->follow;
  double margin = margin_for (moving, step, longest);
  QnId *origins = NULL;
  bool left, listed = false;
  QnStatus status = QN_OK;

  qn_assembly_expand (step->assembly, step->start.u, moving->displacements);
  if (!leave_joints (moving, step, time, result, &left))
    return qn_diag_no_memory (diag);
  if (left || qn_contact_follow_is_due (follow, moving->displacements, margin))
    status = search (moving, 2 * margin, &listed, &origins, diag);
  bool activated =
    status == QN_OK && qn_contact_follow_activate (follow, moving->displacements);
  if (status == QN_OK && (listed || left)) {
    status = rebuild (moving, step, origins, diag);
  } else if (status == QN_OK && activated) {
    take_changes (moving, step, &moving->contacts, step->assembly, NULL);
    qn_time_step_renew (step);
  }
  free (origins);
  if (status == QN_OK && (listed || left || activated))
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
    if (step_index < 0)
      continue;
    QnFoundForce stated = { .step = step_index,
                            .found = *noted,
                            .normal = force[0],
                            .shear = force[1],
                            .state = moving->results[p].state };
    if (!qn_result_add_found_force (result, stated))
      return false;
  }
  return true;
}
