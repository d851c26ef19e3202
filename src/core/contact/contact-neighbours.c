/* All pairs of blocks that lie near each other, one after the other. */
#include "core/contact/contact-neighbours.h"

#include "core/base/memory.h"
#include "core/contact/contact-faces.h"
#include "core/contact/contact-loose.h"
#include "core/contact/contact-overlaps.h"

#include <stdlib.h>

/* Up to so many numbers are sorted by insertion: a brick has three neighbours that follow it. */
#define FEW_NEIGHBOURS 16

/* Which blocks of higher number lie near each block: those of block a are items[first[a]] up to
 * items[first[a + 1]], ascending. */
typedef struct {
  size_t *first;
  QnId *items;
} Neighbours;

static int
compare_ids (const void *a, const void *b)
{
  QnId left = *(const QnId *) a, right = *(const QnId *) b;
  return (left > right) - (left < right);
}

static void
sort_ids (QnId *items, size_t count)
{
  if (count > FEW_NEIGHBOURS) {
    qsort (items, count, sizeof *items, compare_ids);
    return;
  }
  for (size_t i = 1; i < count; i++) {
    QnId id = items[i];
    size_t place = i;
    for (; place > 0 && items[place - 1] > id; place--)
      items[place] = items[place - 1];
    items[place] = id;
  }
}

static void
neighbours_clear (Neighbours *neighbours)
{
  free (neighbours->first);
  free (neighbours->items);
}

/* Counting sort by the lower number of each pair. */
static bool
list_pairs (Neighbours *neighbours, size_t block_count, const QnBoxPairs *pairs)
{
  neighbours->first = qn_alloc (block_count + 2, sizeof *neighbours->first);
  neighbours->items = qn_alloc_unset (pairs->count, sizeof *neighbours->items);
  if (neighbours->first == NULL || neighbours->items == NULL)
    return false;

  /* Shifted by one, so that filling moves every start to its place. */
  size_t *end = neighbours->first + 1;
  for (size_t i = 0; i < pairs->count; i++) {
    const QnId *pair = pairs->items[i];
    end[(pair[0] < pair[1] ? pair[0] : pair[1]) + 1]++;
  }
  for (size_t a = 1; a <= block_count; a++)
    end[a] += end[a - 1];
  for (size_t i = 0; i < pairs->count; i++) {
    const QnId *pair = pairs->items[i];
    bool ordered = pair[0] < pair[1];
    neighbours->items[end[pair[!ordered]]++] = pair[ordered];
  }
  for (size_t a = 0; a < block_count; a++)
    sort_ids (neighbours->items + neighbours->first[a],
              neighbours->first[a + 1] - neighbours->first[a]);
  return true;
}

/* `neighbours` is cleared by the caller, whether it has been filled or not. */
static QnStatus
find_neighbours (const QnContactSearch *search, Neighbours *neighbours, QnDiag *diag)
{
  size_t blocks = search->model->block_count, most = QN_MOST_NEIGHBOURS (blocks);
  QnBoxPairs pairs = { 0 };
  bool done =
    qn_box_tree_pairs (&search->block_tree, 2 * search->lengths.gap_limit, most, &pairs);
  bool crowded = done && pairs.count == most;
  done = done && !crowded && list_pairs (neighbours, blocks, &pairs);
  qn_box_pairs_clear (&pairs);
  if (crowded)
    return qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_TOO_MANY_NEIGHBOURS,
                        QN_ENTITY_MODEL, QN_NONE, QN_NONE);
  return done ? QN_OK : qn_diag_no_memory (diag);
}

/* What a search has found besides the contacts, and room that it needs again and again. */
typedef struct {
  QnTouches touches;
  QnFindings overlaps;
  QnContactMatches matches;
  QnContactCuts cuts;
  size_t deep_overlaps;
} PairSearch;

static void
pair_search_clear (PairSearch *pairs)
{
  free (pairs->touches.items);
  qn_findings_clear (&pairs->overlaps);
  free (pairs->matches.items);
  free (pairs->cuts.items);
}

/* Room for as many faces as there are sides: in a structure without gaps every face begins at a
 * corner, and few corners begin two. More is made where that is not enough. */
static bool
reserve_faces (const QnContactSearch *search, QnContacts *contacts)
{
  size_t count = search->sides.count;
  contacts->faces = qn_alloc_unset (count, sizeof *contacts->faces);
  contacts->face_capacity = contacts->faces != NULL ? count : 0;
  return contacts->faces != NULL;
}

/* Gives back what was reserved for nothing. */
static bool
trim_faces (QnContacts *contacts)
{
  size_t count = contacts->face_count > 0 ? contacts->face_count : 1;
  QnContactFace *faces = realloc (contacts->faces, count * sizeof *faces);
  if (faces == NULL)
    return false;
  contacts->faces = faces;
  contacts->face_capacity = count;
  return true;
}

/* Appends the faces and gaps of two blocks, and notes their touches and overlaps. */
static bool
search_pair (const QnContactSearch *search, QnId a, QnId b, PairSearch *pairs,
             QnContacts *contacts)
{
  size_t earlier = pairs->overlaps.count;
  if (!qn_contact_match_pair (search, a, b, &pairs->matches, contacts, &pairs->touches)
      || !qn_contact_check_overlap (search, a, b, &pairs->cuts, &pairs->overlaps))
    return false;
  pairs->deep_overlaps +=
    pairs->overlaps.count > earlier
    && pairs->overlaps.items[earlier].problem == QN_PROBLEM_BLOCKS_OVERLAP;
  return true;
}

/* Names the first of them. */
static QnStatus
refuse_overlaps (const QnFinding *first, QnDiag *diag)
{
  qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_TOO_MANY_OVERLAPS, QN_ENTITY_BLOCK,
               first->block_a, QN_NONE);
  if (diag != NULL)
    diag->other = first->block_b;
  return QN_ERROR_INVALID;
}

static QnStatus
search_pairs (const QnContactSearch *search, const Neighbours *neighbours,
              PairSearch *pairs, QnContacts *contacts, QnDiag *diag)
{
  size_t blocks = search->model->block_count;
  bool done = reserve_faces (search, contacts);
  for (size_t a = 0; done && a < blocks; a++) {
    for (size_t k = neighbours->first[a]; done && k < neighbours->first[a + 1]; k++)
      done = search_pair (search, (QnId) a, neighbours->items[k], pairs, contacts);
    if (pairs->deep_overlaps > QN_MOST_OVERLAPS (blocks))
      return refuse_overlaps (&pairs->overlaps.items[0], diag);
  }
  done = done && trim_faces (contacts);
  for (size_t i = 0; done && i < pairs->overlaps.count; i++)
    done = qn_findings_add (&contacts->findings, pairs->overlaps.items[i]);
  return done ? QN_OK : qn_diag_no_memory (diag);
}

QnStatus
qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts, QnDiag *diag)
{
  Neighbours neighbours = { 0 };
  PairSearch pairs = { 0 };
  QnStatus status = find_neighbours (search, &neighbours, diag);
  if (status == QN_OK)
    status = search_pairs (search, &neighbours, &pairs, contacts, diag);
  neighbours_clear (&neighbours);
  if (status == QN_OK)
    status = qn_contact_search_points (search, contacts, &pairs.touches, diag);
  pair_search_clear (&pairs);
  return status;
}
