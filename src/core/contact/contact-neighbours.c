/* All pairs of blocks that lie near each other, one after the other. */
#include "core/contact/contact-search.h"

#include <stdlib.h>

static QnStatus
find_neighbours (const QnContactSearch *search, QnBoxPairs *pairs, QnDiag *diag)
{
  size_t most = QN_MOST_NEIGHBOURS (search->model->block_count);

  search->room->failed |=
    !qn_box_tree_pairs (&search->block_tree, 2 * search->lengths.gap_limit, most, pairs);
  if (pairs->count == most)
    return qn_refuse (diag, QN_PROBLEM_TOO_MANY_NEIGHBOURS, QN_ENTITY_MODEL, QN_NONE);
  return QN_OK;
}

QnStatus
qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts, QnDiag *diag)
{
  size_t blocks = search->model->block_count;
  size_t deep_overlaps = 0;
  QnBoxPairs neighbours = { 0 };
  QnTouches touches = { 0 };
  QnFindings overlaps = { 0 };
  QnContactMatches matches = { 0 }; /* scratch of one pair of blocks, as the next */
  QnContactCuts cuts = { 0 };
  QnStatus status = find_neighbours (search, &neighbours, diag);

  for (size_t i = 0; status == QN_OK && !search->room->failed && i < neighbours.count
                     && deep_overlaps <= QN_MOST_OVERLAPS (blocks);
       i++) {
    QnId a = neighbours.items[i][0], b = neighbours.items[i][1];
    size_t earlier = overlaps.count;
    qn_contact_match_pair (search, a, b, &matches, contacts, &touches);
    qn_contact_check_overlap (search, a, b, &cuts, &overlaps);
    deep_overlaps += overlaps.count > earlier
                     && overlaps.items[earlier].problem == QN_PROBLEM_BLOCKS_OVERLAP;
  }
  qn_box_pairs_clear (&neighbours);
  free (matches.items);
  free (cuts.items);

  if (deep_overlaps > QN_MOST_OVERLAPS (blocks)) { /* the first is named */
    status = qn_refuse (diag, QN_PROBLEM_TOO_MANY_OVERLAPS, QN_ENTITY_BLOCK,
                        overlaps.items[0].block_a);
    if (diag != NULL)
      diag->other = overlaps.items[0].block_b;
  } else if (status == QN_OK) {
    for (size_t i = 0; i < overlaps.count; i++)
      qn_contacts_report (contacts, overlaps.items[i]);
    qn_contact_search_points (search, contacts, &touches);
  }
  free (touches.items);
  free (overlaps.items);
  return status;
}
