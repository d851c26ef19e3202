/* All pairs of blocks that lie near each other, one after the other. */
#include "core/contact/contact-search.h"

#include "core/base/integer.h"

#include <stdlib.h>

/* Up to so many numbers are sorted by insertion: a brick has three neighbours that follow it. */
#define FEW_NEIGHBOURS 16

/* Which blocks of higher number lie near each block: those of block a are items[first[a]] up to
 * items[first[a + 1]], ascending. */
typedef struct {
  size_t *first;
  QnId *items;
} Neighbours;

static void
sort_ids (QnId *items, size_t count)
{
  if (count > FEW_NEIGHBOURS) {
    qsort (items, count, sizeof *items, qn_compare_ids);
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

/* Counting sort by the lower number of each pair. */
static void
list_pairs (Neighbours *neighbours, size_t block_count, const QnBoxPairs *pairs,
            QnPool *room)
{
  neighbours->first = qn_pool_alloc (room, block_count + 2, sizeof *neighbours->first);
  neighbours->items = qn_pool_alloc (room, pairs->count, sizeof *neighbours->items);
  if (room->failed)
    return;

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
}

static QnStatus
find_neighbours (const QnContactSearch *search, Neighbours *neighbours, QnDiag *diag)
{
  size_t blocks = search->model->block_count, most = QN_MOST_NEIGHBOURS (blocks);
  QnBoxPairs pairs = { 0 };
  search->room->failed |=
    !qn_box_tree_pairs (&search->block_tree, 2 * search->lengths.gap_limit, most, &pairs);
  bool crowded = pairs.count == most;
  if (!crowded)
    list_pairs (neighbours, blocks, &pairs, search->room);
  qn_box_pairs_clear (&pairs);
  return crowded ? qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_TOO_MANY_NEIGHBOURS,
                                QN_ENTITY_MODEL, QN_NONE, QN_NONE)
                 : QN_OK;
}

QnStatus
qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts, QnDiag *diag)
{
  size_t blocks = search->model->block_count, sides = search->sides.count;
  size_t deep_overlaps = 0;
  Neighbours neighbours = { 0 };
  QnTouches touches = { 0 };
  QnFindings overlaps = { 0 };
  QnContactMatches matches = { 0 }; /* scratch of one pair of blocks, as the next */
  QnContactCuts cuts = { 0 };
  QnStatus status = find_neighbours (search, &neighbours, diag);

  if (status != QN_OK || search->room->failed)
    return status;
  /* Room for as many faces as there are sides: in a structure without gaps every face begins at a
   * corner, and few corners begin two. More is made where that is not enough. */
  contacts->faces = qn_alloc_unset (sides, sizeof *contacts->faces);
  contacts->face_capacity = contacts->faces != NULL ? sides : 0;
  search->room->failed = contacts->faces == NULL;
  for (size_t a = 0; a < blocks && deep_overlaps <= QN_MOST_OVERLAPS (blocks); a++)
    for (size_t k = neighbours.first[a]; k < neighbours.first[a + 1]; k++) {
      QnId b = neighbours.items[k];
      size_t earlier = overlaps.count;
      qn_contact_match_pair (search, (QnId) a, b, &matches, contacts, &touches);
      qn_contact_check_overlap (search, (QnId) a, b, &cuts, &overlaps);
      deep_overlaps += overlaps.count > earlier
                       && overlaps.items[earlier].problem == QN_PROBLEM_BLOCKS_OVERLAP;
    }
  free (matches.items);
  free (cuts.items);

  if (deep_overlaps > QN_MOST_OVERLAPS (blocks)) { /* the first is named */
    status = qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_TOO_MANY_OVERLAPS,
                          QN_ENTITY_BLOCK, overlaps.items[0].block_a, QN_NONE);
    if (diag != NULL)
      diag->other = overlaps.items[0].block_b;
  } else {
    /* What was reserved for nothing is given back. */
    size_t kept = contacts->face_count > 0 ? contacts->face_count : 1;
    QnContactFace *faces = realloc (contacts->faces, kept * sizeof *faces);
    search->room->failed |= faces == NULL;
    if (faces != NULL) {
      contacts->faces = faces;
      contacts->face_capacity = kept;
    }
    for (size_t i = 0; i < overlaps.count; i++)
      qn_contacts_report (contacts, overlaps.items[i]);
    qn_contact_search_points (search, contacts, &touches);
  }
  free (touches.items);
  free (overlaps.items);
  return status;
}
