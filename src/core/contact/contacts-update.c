/* Contacts after a small change. Everything that two blocks have to do with each other depends on
 * what lies near both of them. So the pairs of blocks near a change are searched in a part of
 * the model that holds their neighbours as well, and all other pairs are taken over. */
#include "core/base/memory.h"
#include "core/contact/contact-neighbours.h"

#include <stdlib.h>
#include <string.h>

/* Where more than one block in so many has changed, detecting anew is as quick. */
#define MOST_CHANGES 4

typedef struct {
  const QnModel *old_model, *model;
  QnContactLengths lengths;
  QnId
    *new_of_old; /* number in the new model of a block that has not changed, or QN_NONE */
  bool *changed; /* new blocks that are not as they were */
  bool *near;    /* new blocks near a change: pairs of these are searched */
  QnModel part;  /* these and their neighbours; blocks and vertices alone */
  QnId *whole_of_part;
} Update;

static void
update_clear (Update *update)
{
  free (update->new_of_old);
  free (update->changed);
  free (update->near);
  free (update->part.blocks);
  free (update->part.vertices);
  free (update->whole_of_part);
}

static QnBox
block_box (const QnModel *model, size_t block)
{
  return qn_box_of_points (qn_model_block_vertices (model, (QnId) block),
                           (size_t) model->blocks[block].vertex_count);
}

static bool
same_block (const Update *update, QnId old, QnId new)
{
  const QnBlock *was = &update->old_model->blocks[old], *is = &update->model->blocks[new];
  return was->vertex_count == is->vertex_count && was->thickness == is->thickness
         && memcmp (qn_model_block_vertices (update->old_model, old),
                    qn_model_block_vertices (update->model, new),
                    (size_t) is->vertex_count * sizeof (QnVec2))
              == 0;
}

/* Fills new_of_old and changed; *changes counts changed blocks and those gone. False where the
 * blocks that have not changed stand in another order. */
static bool
compare_blocks (Update *update, size_t *changes)
{
  size_t old_count = update->old_model->block_count, kept = 0;
  QnId last = QN_NONE;
  for (size_t i = 0; i < old_count; i++)
    update->new_of_old[i] = QN_NONE;
  for (size_t i = 0; i < update->model->block_count; i++) {
    QnId old = qn_model_find_block (update->old_model, update->model->blocks[i].name);
    update->changed[i] = old == QN_NONE || !same_block (update, old, (QnId) i);
    if (update->changed[i])
      continue;
    if (old <= last)
      return false;
    last = old;
    update->new_of_old[old] = (QnId) i;
    kept++;
  }
  *changes = update->model->block_count - kept + old_count - kept;
  return true;
}

/* Boxes of what has changed, as it was and as it is. */
static void
collect_changes (const Update *update, QnBox *boxes)
{
  size_t count = 0;
  for (size_t i = 0; i < update->old_model->block_count; i++) {
    if (update->new_of_old[i] == QN_NONE)
      boxes[count++] = block_box (update->old_model, i);
  }
  for (size_t i = 0; i < update->model->block_count; i++) {
    if (update->changed[i])
      boxes[count++] = block_box (update->model, i);
  }
}

/* Marks the blocks near any of the boxes and counts them; false when memory runs out. */
static bool
mark_near (const Update *update, const QnBox *boxes, size_t box_count, bool *near,
           size_t *near_count)
{
  QnBoxTree tree;
  if (!qn_box_tree_init (&tree, boxes, box_count))
    return false;

  *near_count = 0;
  for (size_t i = 0; i < update->model->block_count; i++) {
    /* A gap, what fills it, and the tolerances about both: less than four gap limits. */
    QnBox box = qn_box_grow (block_box (update->model, i), 4 * update->lengths.gap_limit);
    QnBoxQuery query = qn_box_tree_query (&tree, box);
    near[i] = qn_box_query_next (&query) != QN_NONE;
    *near_count += near[i];
  }
  qn_box_tree_clear (&tree);
  return true;
}

/* The part of the model that consists of the marked blocks. */
static bool
build_part (Update *update, const bool *marked, size_t count)
{
  QnModel *part = &update->part;
  size_t vertex_count = 0;
  for (size_t i = 0; i < update->model->block_count; i++) {
    if (marked[i])
      vertex_count += (size_t) update->model->blocks[i].vertex_count;
  }
  part->blocks = qn_alloc (count, sizeof *part->blocks);
  part->vertices = qn_alloc (vertex_count, sizeof *part->vertices);
  update->whole_of_part = qn_alloc (count, sizeof *update->whole_of_part);
  if (part->blocks == NULL || part->vertices == NULL || update->whole_of_part == NULL)
    return false;

  for (size_t i = 0; i < update->model->block_count; i++) {
    if (!marked[i])
      continue;
    QnBlock *block = &part->blocks[part->block_count];
    *block = update->model->blocks[i];
    memcpy (part->vertices + part->vertex_count,
            qn_model_block_vertices (update->model, (QnId) i),
            (size_t) block->vertex_count * sizeof *part->vertices);
    block->first_vertex = (QnId) part->vertex_count;
    part->vertex_count += (size_t) block->vertex_count;
    update->whole_of_part[part->block_count++] = (QnId) i;
  }
  return true;
}

/* Cuts out the neighbourhood of the changes. */
static bool
select_part (Update *update, size_t changes)
{
  size_t block_count = update->model->block_count, near_count = 0, count = 0;
  QnBox *boxes = qn_alloc (changes, sizeof *boxes);
  bool done = boxes != NULL;
  if (done) {
    collect_changes (update, boxes);
    done = mark_near (update, boxes, changes, update->near, &near_count);
  }
  free (boxes);

  /* Now the neighbours of these, which have a say in gaps and corners. */
  boxes = done ? qn_alloc (near_count, sizeof *boxes) : NULL;
  bool *marked = qn_alloc (block_count, sizeof *marked);
  done = boxes != NULL && marked != NULL;
  for (size_t i = 0; done && i < block_count; i++) {
    if (update->near[i])
      boxes[count++] = block_box (update->model, i);
  }
  done = done && mark_near (update, boxes, near_count, marked, &count)
         && build_part (update, marked, count);
  free (boxes);
  free (marked);
  return done;
}

/* Numbers of two blocks in the new model, if what is known of the pair can be used. */
static bool
translate (const Update *update, bool from_part, QnId *a, QnId *b)
{
  const QnId *map = from_part ? update->whole_of_part : update->new_of_old;
  *a = map[*a];
  *b = map[*b];
  if (*a == QN_NONE || *b == QN_NONE)
    return false;
  return from_part == (update->near[*a] && update->near[*b]);
}

static bool
precedes (QnId a, QnId b, QnId other_a, QnId other_b)
{
  return a < other_a || (a == other_a && b <= other_b);
}

/* The next usable face from *index on, translated, or false at the end of the list. */
static bool
next_face (const Update *update, bool from_part, const QnContacts *from, size_t *index,
           QnContactFace *face)
{
  for (; *index < from->face_count; (*index)++) {
    *face = from->faces[*index];
    if (translate (update, from_part, &face->a, &face->b))
      return true;
  }
  return false;
}

static bool
merge_faces (const Update *update, const QnContacts *old, const QnContacts *found,
             QnContacts *contacts)
{
  size_t i = 0, j = 0;
  QnContactFace kept, fresh;
  contacts->faces = qn_alloc (old->face_count + found->face_count, sizeof kept);
  if (contacts->faces == NULL)
    return false;
  contacts->face_capacity = old->face_count + found->face_count;

  bool has_kept = next_face (update, false, old, &i, &kept);
  bool has_fresh = next_face (update, true, found, &j, &fresh);
  while (has_kept || has_fresh) {
    bool take_kept =
      has_kept && (!has_fresh || precedes (kept.a, kept.b, fresh.a, fresh.b));
    contacts->faces[contacts->face_count++] = take_kept ? kept : fresh;
    if (take_kept)
      i++, has_kept = next_face (update, false, old, &i, &kept);
    else
      j++, has_fresh = next_face (update, true, found, &j, &fresh);
  }
  return true;
}

/* Kinds of findings in the order in which a search reports them. */
typedef enum { GAPS, OVERLAPS, POINTS, KIND_COUNT } Kind;

static bool
is_kind (QnProblem problem, Kind kind)
{
  switch (kind) {
  case GAPS:
    return problem == QN_PROBLEM_NEAR_MISS_GAP;
  case OVERLAPS:
    return problem == QN_PROBLEM_BLOCKS_OVERLAP
           || problem == QN_PROBLEM_NEAR_MISS_OVERLAP;
  case POINTS:
    return problem == QN_PROBLEM_POINT_CONTACT;
  case KIND_COUNT:
    break;
  }
  return false;
}

static bool
next_finding (const Update *update, bool from_part, const QnFindings *from, Kind kind,
              size_t *index, QnFinding *finding)
{
  for (; *index < from->count; (*index)++) {
    *finding = from->items[*index];
    if (is_kind (finding->problem, kind)
        && translate (update, from_part, &finding->block_a, &finding->block_b))
      return true;
  }
  return false;
}

/* Findings of one kind, which both lists hold in order. */
static bool
merge_findings (const Update *update, Kind kind, const QnFindings *old,
                const QnFindings *found, QnFindings *findings)
{
  size_t i = 0, j = 0;
  QnFinding kept, fresh;
  bool done = true;
  bool has_kept = next_finding (update, false, old, kind, &i, &kept);
  bool has_fresh = next_finding (update, true, found, kind, &j, &fresh);
  while (done && (has_kept || has_fresh)) {
    bool take_kept =
      has_kept
      && (!has_fresh
          || precedes (kept.block_a, kept.block_b, fresh.block_a, fresh.block_b));
    done = qn_findings_add (findings, take_kept ? kept : fresh);
    if (take_kept)
      i++, has_kept = next_finding (update, false, old, kind, &i, &kept);
    else
      j++, has_fresh = next_finding (update, true, found, kind, &j, &fresh);
  }
  return done;
}

static QnStatus
search_part (const Update *update, QnContacts *found, QnDiag *diag)
{
  QnContactSearch search;
  *found = (QnContacts){ 0 };
  QnStatus status =
    qn_contact_search_init (&search, &update->part, update->lengths, diag);
  if (status != QN_OK)
    return status;
  status = qn_contact_search_all (&search, found, diag);
  qn_contact_search_clear (&search);
  return status;
}

/* Searches the neighbourhood of the changes and merges it with what is known. */
static QnStatus
update_pairs (Update *update, size_t changes, const QnContacts *old, QnContacts *contacts,
              QnDiag *diag)
{
  QnContacts found = { 0 };
  if (!select_part (update, changes))
    return qn_diag_no_memory (diag);
  QnStatus status = search_part (update, &found, diag);
  bool done = status == QN_OK && merge_faces (update, old, &found, contacts);
  for (Kind kind = GAPS; kind < KIND_COUNT && done; kind++)
    done =
      merge_findings (update, kind, &old->findings, &found.findings, &contacts->findings);
  qn_contacts_clear (&found);
  return done || status != QN_OK ? status : qn_diag_no_memory (diag);
}

static bool
same_lengths (QnContactLengths a, QnContactLengths b)
{
  return a.tolerance == b.tolerance && a.gap_limit == b.gap_limit
         && a.overlap_limit == b.overlap_limit;
}

QnStatus
qn_contacts_update (const QnModel *old_model, const QnContacts *old, const QnModel *model,
                    QnContacts *contacts, QnDiag *diag)
{
  *contacts = (QnContacts){ 0 };
  if (old_model->block_count == 0 || model->block_count == 0)
    return qn_contacts_detect (model, contacts, diag);

  Update update = { .old_model = old_model, .model = model };
  size_t changes = 0;
  update.lengths = qn_contact_lengths (model);
  update.new_of_old = qn_alloc (old_model->block_count, sizeof *update.new_of_old);
  update.changed = qn_alloc (model->block_count, sizeof *update.changed);
  update.near = qn_alloc (model->block_count, sizeof *update.near);
  if (update.new_of_old == NULL || update.changed == NULL || update.near == NULL) {
    update_clear (&update);
    return qn_diag_no_memory (diag);
  }

  bool worthwhile = same_lengths (update.lengths, qn_contact_lengths (old_model))
                    && compare_blocks (&update, &changes)
                    && changes <= model->block_count / MOST_CHANGES;
  QnStatus status = QN_OK;
  if (worthwhile)
    status = update_pairs (&update, changes, old, contacts, diag);
  update_clear (&update);
  if (status != QN_OK) {
    qn_contacts_clear (contacts);
    return status;
  }
  return worthwhile ? qn_contacts_complete (model, contacts, diag)
                    : qn_contacts_detect (model, contacts, diag);
}
