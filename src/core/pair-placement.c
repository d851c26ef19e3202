/* Laws and contact pairs of the faces, by the model's rules and its exceptions. */
#include "core/contact-search.h"
#include "core/memory.h"

#include <stdlib.h>

/* An exception, its blocks in the order in which faces name them. */
typedef struct {
  QnId a, b;
  size_t index; /* into QnModel.overrides */
  bool used;
} Exception;

/* Of two exceptions for the same blocks the later one comes last, and counts. */
static int
compare_exceptions (const void *left, const void *right)
{
  const Exception *l = left, *r = right;
  if (l->a != r->a)
    return l->a < r->a ? -1 : 1;
  if (l->b != r->b)
    return l->b < r->b ? -1 : 1;
  return (l->index > r->index) - (l->index < r->index);
}

static void
sort_exceptions (const QnModel *model, Exception *exceptions)
{
  for (size_t i = 0; i < model->override_count; i++) {
    const QnFaceOverride *override = &model->overrides[i];
    bool ordered = override->block_a < override->block_b;
    exceptions[i] =
      (Exception){ ordered ? override->block_a : override->block_b,
                   ordered ? override->block_b : override->block_a, i, false };
  }
  if (model->override_count > 1)
    qsort (exceptions, model->override_count, sizeof *exceptions, compare_exceptions);
}

/* The exception that counts for this face, marked as used, or NULL. `*next` walks along the
 * sorted exceptions as the sorted faces pass by. */
static const QnFaceOverride *
exception_of (const QnModel *model, Exception *exceptions, size_t *next,
              const QnContactFace *face)
{
  size_t count = model->override_count;
  while (*next < count
         && (exceptions[*next].a < face->a
             || (exceptions[*next].a == face->a && exceptions[*next].b < face->b)))
    (*next)++;

  const QnFaceOverride *found = NULL;
  for (size_t i = *next;
       i < count && exceptions[i].a == face->a && exceptions[i].b == face->b; i++) {
    exceptions[i].used = true;
    found = &model->overrides[exceptions[i].index];
  }
  return found;
}

static QnId
law_of_side (const QnModel *model, QnId block, const QnFaceOverride *exception)
{
  if (exception != NULL && exception->law != QN_NONE)
    return exception->law;
  QnId own = model->blocks[block].law;
  return own != QN_NONE ? own : model->contact.law;
}

static QnStatus
place_pairs (QnContacts *contacts, size_t index, const QnPairRule *rule, QnDiag *diag)
{
  QnContactFace *face = &contacts->faces[index];
  bool ends = rule->placement == QN_PLACEMENT_ENDS;
  if (ends && 2 * rule->offset >= face->length) {
    qn_diag_set_field (diag, QN_PROBLEM_PAIR_OFFSET_TOO_LARGE, QN_ENTITY_BLOCK, face->a,
                       NULL, face->length);
    if (diag != NULL) {
      diag->other = face->b;
      diag->at = qn_vec2_lerp (face->start, face->end, 0.5);
    }
    return QN_ERROR_INVALID;
  }

  size_t count = ends ? 2 : (size_t) rule->count;
  QnContactPair *pairs = contacts->pair_count + count > INT32_MAX
                           ? NULL
                           : qn_array_grow (contacts->pairs, &contacts->pair_capacity,
                                            contacts->pair_count + count, sizeof *pairs);
  if (pairs == NULL)
    return qn_diag_no_memory (diag);
  contacts->pairs = pairs;

  face->first_pair = (QnId) contacts->pair_count;
  face->pair_count = (int32_t) count;
  double tributary = face->length / (double) count;
  for (size_t i = 0; i < count; i++) {
    double abscissa = !ends    ? ((double) i + 0.5) * tributary
                      : i == 0 ? rule->offset
                               : face->length - rule->offset;
    pairs[contacts->pair_count++] = (QnContactPair){
      .face = (QnId) index,
      .point = qn_vec2_lerp (face->start, face->end, abscissa / face->length),
      .abscissa = abscissa,
      .tributary = tributary,
    };
  }
  return QN_OK;
}

static bool
report_unused (const QnModel *model, const Exception *exceptions, QnFindings *findings)
{
  for (size_t i = 0; i < model->override_count; i++) {
    const Exception *exception = &exceptions[i];
    if (exception->used)
      continue;
    QnVec2 at = qn_vec2_lerp (model->blocks[exception->a].centroid,
                              model->blocks[exception->b].centroid, 0.5);
    if (!qn_findings_add (findings, (QnFinding){ QN_PROBLEM_OVERRIDE_UNUSED, exception->a,
                                                 exception->b, at, 0 }))
      return false;
  }
  return true;
}

QnStatus
qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts, QnDiag *diag)
{
  Exception *exceptions = qn_alloc (model->override_count, sizeof *exceptions);
  if (exceptions == NULL)
    return qn_diag_no_memory (diag);
  sort_exceptions (model, exceptions);

  contacts->pair_count = 0;
  QnStatus status = QN_OK;
  size_t next = 0;
  for (size_t i = 0; i < contacts->face_count && status == QN_OK; i++) {
    QnContactFace *face = &contacts->faces[i];
    const QnFaceOverride *exception = exception_of (model, exceptions, &next, face);
    face->law_a = law_of_side (model, face->a, exception);
    face->law_b = law_of_side (model, face->b, exception);
    bool own_pairs = exception != NULL && exception->has_pairs;
    status = place_pairs (contacts, i,
                          own_pairs ? &exception->pairs : &model->contact.pairs, diag);
  }
  if (status == QN_OK && !report_unused (model, exceptions, &contacts->findings))
    status = qn_diag_no_memory (diag);
  free (exceptions);
  return status;
}
