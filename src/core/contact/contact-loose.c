/* Blocks that hang together badly: touching at a point, touching nothing, held by nothing. */
#include "core/contact/contact-loose.h"

#include "core/base/memory.h"
#include "core/base/polygon.h"
#include "core/base/union-find.h"

#include <stdlib.h>

/* Which faces each block has: those of block i are faces[first[i]] up to faces[first[i + 1]]. */
typedef struct {
  size_t *first;
  size_t *faces;
} FaceLists;

static bool
face_lists_init (FaceLists *lists, size_t block_count, const QnContacts *contacts)
{
  lists->first = qn_alloc (block_count + 2, sizeof *lists->first);
  lists->faces = qn_alloc (2 * contacts->face_count, sizeof *lists->faces);
  if (lists->first == NULL || lists->faces == NULL)
    return false;

  /* Counting sort, shifted by one so that filling moves every start to its place. */
  size_t *end = lists->first + 1;
  for (size_t i = 0; i < contacts->face_count; i++) {
    end[contacts->faces[i].a + 1]++;
    end[contacts->faces[i].b + 1]++;
  }
  for (size_t i = 1; i <= block_count; i++)
    end[i] += end[i - 1];
  for (size_t i = 0; i < contacts->face_count; i++) {
    lists->faces[end[contacts->faces[i].a]++] = i;
    lists->faces[end[contacts->faces[i].b]++] = i;
  }
  return true;
}

static void
face_lists_clear (FaceLists *lists)
{
  free (lists->first);
  free (lists->faces);
}

static bool
has_face_at (const FaceLists *lists, const QnContacts *contacts, QnId block, QnVec2 at,
             double tolerance)
{
  for (size_t i = lists->first[block]; i < lists->first[block + 1]; i++) {
    const QnContactFace *face = &contacts->faces[lists->faces[i]];
    if (qn_segment_distance (face->start, face->end, at) <= tolerance)
      return true;
  }
  return false;
}

static bool
is_overlap (const QnFinding *finding)
{
  return finding->problem == QN_PROBLEM_BLOCKS_OVERLAP
         || finding->problem == QN_PROBLEM_NEAR_MISS_OVERLAP;
}

/* Whether two blocks are known to overlap. Overlaps and touches are both sorted by blocks:
 * `*next` walks along the findings, of which those from `count` on are not looked at. */
static bool
overlap (const QnFindings *findings, size_t count, const QnTouch *touch, size_t *next)
{
  for (; *next < count; (*next)++) {
    const QnFinding *finding = &findings->items[*next];
    if (is_overlap (finding)
        && (finding->block_a > touch->a
            || (finding->block_a == touch->a && finding->block_b >= touch->b)))
      break;
  }
  return *next < count && findings->items[*next].block_a == touch->a
         && findings->items[*next].block_b == touch->b;
}

/* In a bond every joint ends at corners, where blocks that share no face meet too. That is
 * ordinary as long as both have a face there; a corner that bears on its own is not. */
static bool
report_points (const QnContactSearch *search, const FaceLists *lists,
               QnContacts *contacts, const QnTouches *touches)
{
  QnFindings *findings = &contacts->findings;
  double near = 4 * search->lengths.tolerance;
  size_t earlier = findings->count, next = 0;
  for (size_t i = 0; i < touches->count; i++) {
    const QnTouch *touch = &touches->items[i];
    if ((has_face_at (lists, contacts, touch->a, touch->at, near)
         && has_face_at (lists, contacts, touch->b, touch->at, near))
        || overlap (findings, earlier, touch, &next))
      continue;
    if (!qn_findings_add (findings, (QnFinding){ QN_PROBLEM_POINT_CONTACT, touch->a,
                                                 touch->b, touch->at, 0, QN_NONE }))
      return false;
  }
  return true;
}

/* What hangs on what. */
typedef struct {
  bool *touching; /* blocks that have a face, a point contact or an overlap, or a beam */
  QnId *parents;  /* of bodies: those with the same root hang together */
  bool *held;     /* bodies that hang together with one that has a support */
  size_t held_count;
} Cohesion;

static void
follow_faces (const QnContacts *contacts, Cohesion *cohesion)
{
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    cohesion->touching[face->a] = cohesion->touching[face->b] = true;
    qn_sets_join (cohesion->parents, face->a, face->b);
  }
  for (size_t i = 0; i < contacts->findings.count; i++) {
    const QnFinding *finding = &contacts->findings.items[i];
    if (finding->problem == QN_PROBLEM_POINT_CONTACT || is_overlap (finding))
      cohesion->touching[finding->block_a] = cohesion->touching[finding->block_b] = true;
  }
}

static void
follow_beams (const QnModel *model, Cohesion *cohesion)
{
  for (size_t i = 0; i < 2 * model->beam_count; i++) {
    QnId block = model->nodes[model->beams[i / 2].nodes[i % 2]].block;
    if (block != QN_NONE)
      cohesion->touching[block] = true;
  }
  for (size_t i = 0; i < model->element_count; i++)
    qn_sets_join (cohesion->parents,
                  (QnId) qn_model_node_body (model, model->elements[i].nodes[0]),
                  (QnId) qn_model_node_body (model, model->elements[i].nodes[1]));
}

static void
mark_held (const QnModel *model, size_t bodies, Cohesion *cohesion)
{
  bool *held = cohesion->held;
  for (size_t i = 0; i < bodies; i++) {
    const bool *support = i < model->block_count
                            ? model->blocks[i].support
                            : model->nodes[i - model->block_count].support;
    if (support[QN_DOF_UX] || support[QN_DOF_UY] || support[QN_DOF_RZ])
      held[qn_sets_root (cohesion->parents, (QnId) i)] = true;
  }
  for (size_t i = 0; i < bodies; i++) {
    held[i] = held[qn_sets_root (cohesion->parents, (QnId) i)];
    cohesion->held_count += held[i];
  }
}

/* `cohesion` is cleared by the caller, whether it has been filled or not; false when memory runs
 * out. */
static bool
find_cohesion (const QnModel *model, const QnContacts *contacts, Cohesion *cohesion)
{
  size_t bodies = qn_model_body_count (model);
  cohesion->touching = qn_alloc (model->block_count, sizeof *cohesion->touching);
  cohesion->held = qn_alloc (bodies, sizeof *cohesion->held);
  cohesion->parents = qn_alloc_unset (bodies, sizeof *cohesion->parents);
  if (cohesion->touching == NULL || cohesion->held == NULL || cohesion->parents == NULL)
    return false;

  qn_sets_init (cohesion->parents, bodies);
  follow_faces (contacts, cohesion);
  follow_beams (model, cohesion);
  mark_held (model, bodies, cohesion);
  return true;
}

static void
cohesion_clear (Cohesion *cohesion)
{
  free (cohesion->touching);
  free (cohesion->held);
  free (cohesion->parents);
}

static bool
report_blocks (const QnModel *model, QnFindings *findings, QnProblem problem,
               const bool *in_order)
{
  for (size_t i = 0; i < model->block_count; i++) {
    if (!in_order[i]
        && !qn_findings_add (findings,
                             (QnFinding){ problem, (QnId) i, QN_NONE,
                                          model->blocks[i].centroid, 0, QN_NONE }))
      return false;
  }
  return true;
}

static bool
report_beams (const QnModel *model, QnFindings *findings, const bool *held)
{
  for (size_t i = 0; i < model->beam_count; i++) {
    const QnId node = model->beams[i].nodes[0];
    if (!held[qn_model_node_body (model, node)]
        && !qn_findings_add (findings, (QnFinding){ .problem = QN_PROBLEM_BEAM_FLOATING,
                                                    .block_a = QN_NONE,
                                                    .block_b = QN_NONE,
                                                    .beam = (QnId) i,
                                                    .at = model->nodes[node].at }))
      return false;
  }
  return true;
}

static bool
report_support (const QnModel *model, QnFindings *findings, const bool *held,
                size_t held_count)
{
  /* One finding says more than one for every block of the model. */
  if (held_count == 0)
    return qn_findings_add (findings, (QnFinding){ .problem = QN_PROBLEM_NO_SUPPORT,
                                                   .block_a = QN_NONE,
                                                   .block_b = QN_NONE,
                                                   .at = model->block_count > 0
                                                           ? model->blocks[0].centroid
                                                           : model->nodes[0].at });
  return report_blocks (model, findings, QN_PROBLEM_BLOCK_FLOATING, held)
         && report_beams (model, findings, held);
}

QnStatus
qn_contact_search_points (const QnContactSearch *search, QnContacts *contacts,
                          const QnTouches *touches, QnDiag *diag)
{
  if (touches->count == 0)
    return QN_OK;

  FaceLists lists = { 0 };
  bool done = face_lists_init (&lists, search->model->block_count, contacts)
              && report_points (search, &lists, contacts, touches);
  face_lists_clear (&lists);
  return done ? QN_OK : qn_diag_no_memory (diag);
}

QnStatus
qn_contacts_report_loose (const QnModel *model, QnContacts *contacts, QnDiag *diag)
{
  Cohesion cohesion = { 0 };
  bool done =
    find_cohesion (model, contacts, &cohesion)
    && report_blocks (model, &contacts->findings, QN_PROBLEM_BLOCK_WITHOUT_CONTACT,
                      cohesion.touching)
    && report_support (model, &contacts->findings, cohesion.held, cohesion.held_count);
  cohesion_clear (&cohesion);
  return done ? QN_OK : qn_diag_no_memory (diag);
}
