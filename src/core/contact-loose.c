/* Blocks that hang together badly: touching at a point, touching nothing, held by nothing. */
#include "core/contact-search.h"
#include "core/memory.h"
#include "core/polygon.h"

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

/* In a bond every joint ends at corners, where blocks that share no face meet too. That is
 * ordinary as long as both have a face there; a corner that bears on its own is not. */
static bool
report_points (const QnContactSearch *search, const FaceLists *lists,
               QnContacts *contacts, const QnTouches *touches)
{
  double near = 4 * search->tolerance;
  for (size_t i = 0; i < touches->count; i++) {
    const QnTouch *touch = &touches->items[i];
    if (has_face_at (lists, contacts, touch->a, touch->at, near)
        && has_face_at (lists, contacts, touch->b, touch->at, near))
      continue;
    if (!qn_findings_add (
          &contacts->findings,
          (QnFinding){ QN_PROBLEM_POINT_CONTACT, touch->a, touch->b, touch->at, 0 }))
      return false;
  }
  return true;
}

static bool
is_supported (const QnBlock *block)
{
  return block->support[QN_DOF_UX] || block->support[QN_DOF_UY]
         || block->support[QN_DOF_RZ];
}

/* Marks every block that is connected through faces to a block with a support. `queue` has room
 * for all blocks. Returns how many are marked. */
static size_t
mark_held (const QnModel *model, const QnContacts *contacts, const FaceLists *lists,
           bool *held, QnId *queue)
{
  size_t count = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    held[i] = is_supported (&model->blocks[i]);
    if (held[i])
      queue[count++] = (QnId) i;
  }

  for (size_t next = 0; next < count; next++) {
    QnId block = queue[next];
    for (size_t i = lists->first[block]; i < lists->first[block + 1]; i++) {
      const QnContactFace *face = &contacts->faces[lists->faces[i]];
      QnId neighbour = face->a == block ? face->b : face->a;
      if (!held[neighbour]) {
        held[neighbour] = true;
        queue[count++] = neighbour;
      }
    }
  }
  return count;
}

static bool
report_blocks (const QnModel *model, const FaceLists *lists, QnContacts *contacts,
               const bool *held, size_t held_count)
{
  QnFindings *findings = &contacts->findings;
  for (size_t i = 0; i < model->block_count; i++) {
    if (lists->first[i] == lists->first[i + 1]
        && !qn_findings_add (findings,
                             (QnFinding){ QN_PROBLEM_BLOCK_WITHOUT_CONTACT, (QnId) i,
                                          QN_NONE, model->blocks[i].centroid, 0 }))
      return false;
  }

  /* One finding says more than one for every block of the model. */
  if (held_count == 0)
    return qn_findings_add (findings,
                            (QnFinding){ QN_PROBLEM_NO_SUPPORT, QN_NONE, QN_NONE,
                                         model->blocks[0].centroid, 0 });
  for (size_t i = 0; i < model->block_count; i++) {
    if (!held[i]
        && !qn_findings_add (findings,
                             (QnFinding){ QN_PROBLEM_BLOCK_FLOATING, (QnId) i, QN_NONE,
                                          model->blocks[i].centroid, 0 }))
      return false;
  }
  return true;
}

QnStatus
qn_contact_search_loose (const QnContactSearch *search, QnContacts *contacts,
                         const QnTouches *touches, QnDiag *diag)
{
  const QnModel *model = search->model;
  FaceLists lists = { 0 };
  bool *held = qn_alloc (model->block_count, sizeof *held);
  QnId *queue = qn_alloc (model->block_count, sizeof *queue);
  bool done = held != NULL && queue != NULL
              && face_lists_init (&lists, model->block_count, contacts)
              && report_points (search, &lists, contacts, touches);
  if (done) {
    size_t held_count = mark_held (model, contacts, &lists, held, queue);
    done = report_blocks (model, &lists, contacts, held, held_count);
  }

  face_lists_clear (&lists);
  free (held);
  free (queue);
  return done ? QN_OK : qn_diag_no_memory (diag);
}
