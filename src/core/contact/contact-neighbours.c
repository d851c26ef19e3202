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
static bool
find_neighbours (const QnContactSearch *search, Neighbours *neighbours)
{
  QnBoxPairs pairs = { 0 };
  bool done =
    qn_box_tree_pairs (&search->block_tree, 2 * search->lengths.gap_limit, &pairs)
    && list_pairs (neighbours, search->model->block_count, &pairs);
  qn_box_pairs_clear (&pairs);
  return done;
}

/* What a search has found besides the contacts, and room that it needs again and again. */
typedef struct {
  QnTouches touches;
  QnFindings overlaps;
  QnContactMatches matches;
  QnContactCuts cuts;
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

static bool
search_pairs (const QnContactSearch *search, const Neighbours *neighbours,
              PairSearch *pairs, QnContacts *contacts)
{
  if (!reserve_faces (search, contacts))
    return false;
  for (size_t i = 0; i < search->model->block_count; i++) {
    for (size_t k = neighbours->first[i]; k < neighbours->first[i + 1]; k++) {
      QnId a = (QnId) i, b = neighbours->items[k];
      if (!qn_contact_match_pair (search, a, b, &pairs->matches, contacts,
                                  &pairs->touches)
          || !qn_contact_check_overlap (search, a, b, &pairs->cuts, &pairs->overlaps))
        return false;
    }
  }
  if (!trim_faces (contacts))
    return false;
  for (size_t i = 0; i < pairs->overlaps.count; i++)
    if (!qn_findings_add (&contacts->findings, pairs->overlaps.items[i]))
      return false;
  return true;
}

QnStatus
qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts, QnDiag *diag)
{
  Neighbours neighbours = { 0 };
  PairSearch pairs = { 0 };
  bool done = find_neighbours (search, &neighbours)
              && search_pairs (search, &neighbours, &pairs, contacts);
  neighbours_clear (&neighbours);
  QnStatus status = done
                      ? qn_contact_search_points (search, contacts, &pairs.touches, diag)
                      : qn_diag_no_memory (diag);
  pair_search_clear (&pairs);
  return status;
}
