/* Blocks with point contacts alone, without contact, or without connection to a support. */
#include "core/contact/contact-search.h"

#include "core/base/polygon.h"
#include "core/base/union-find.h"

/* Which faces each block has: those of block i are faces[first[i]] up to faces[first[i + 1]]. */
typedef struct {
  size_t *first;
  size_t *faces;
} FaceLists;

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
void
qn_contact_search_points (const QnContactSearch *search, QnContacts *contacts,
                          const QnTouches *touches)
{
  const double near = 4 * search->lengths.tolerance;
  size_t earlier = contacts->findings.count, next = 0;
  FaceLists lists;

  size_t block_count = search->model->block_count;
  lists.first = qn_pool_alloc (&contacts->room, block_count + 2, sizeof *lists.first);
  lists.faces =
    qn_pool_alloc (&contacts->room, 2 * contacts->face_count, sizeof *lists.faces);
  if (!contacts->room.failed) {
    /* Counting sort, shifted by one so that filling moves every start to its place. */
    size_t *end = lists.first + 1;
    for (size_t i = 0; i < contacts->face_count; i++) {
      end[contacts->faces[i].a + 1]++;
      end[contacts->faces[i].b + 1]++;
    }
    for (size_t i = 1; i <= block_count; i++)
      end[i] += end[i - 1];
    for (size_t i = 0; i < contacts->face_count; i++) {
      lists.faces[end[contacts->faces[i].a]++] = i;
      lists.faces[end[contacts->faces[i].b]++] = i;
    }
  }
  for (size_t i = 0; i < touches->count && !contacts->room.failed; i++) {
    const QnTouch *touch = &touches->items[i];
    if (!(has_face_at (&lists, contacts, touch->a, touch->at, near)
          && has_face_at (&lists, contacts, touch->b, touch->at, near))
        && !overlap (&contacts->findings, earlier, touch, &next))
      qn_contacts_tell (contacts, QN_PROBLEM_POINT_CONTACT, touch->a, touch->b, QN_NONE,
                        touch->at, 0);
  }
}

static void
report_blocks (const QnModel *model, QnContacts *contacts, QnProblem problem,
               const bool *in_order)
{
  for (size_t i = 0; i < model->block_count; i++)
    if (!in_order[i])
      qn_contacts_tell (contacts, problem, (QnId) i, QN_NONE, QN_NONE,
                        model->blocks[i].centroid, 0);
}

/* Whether a point that moves with a block lies outside of it by more than joints may be wide. */
static bool
lies_off_block (const QnModel *model, QnId block, QnVec2 at)
{
  double tolerance = model->contact.tolerance * model->characteristic_length;
  return block != QN_NONE
         && qn_polygon_depth (qn_model_block_vertices (model, block),
                              (size_t) model->blocks[block].vertex_count, at)
              < -tolerance;
}

/* Ends of beams where there is nothing else: no block, support, other beam, load or control; and ends
 * that do not lie on the block that they move with. */
static void
report_free_ends (const QnModel *model, QnContacts *contacts)
{
  size_t ends = 2 * model->beam_count;
  int *uses = qn_pool_alloc (&contacts->room, model->node_count, sizeof *uses);

  if (uses == NULL)
    return;
  for (size_t i = 0; i < ends; i++)
    uses[model->beams[i / 2].nodes[i % 2]]++;
  for (size_t i = 0; i < qn_model_load_count (model); i++)
    if (qn_model_load (model, i)->kind == QN_LOAD_NODE)
      uses[qn_model_load (model, i)->node]++;
  if (model->analysis.control.node != QN_NONE)
    uses[model->analysis.control.node]++;
  for (size_t i = 0; i < ends; i++) {
    QnId id = model->beams[i / 2].nodes[i % 2];
    const QnNode *node = &model->nodes[id];
    bool alone =
      uses[id] == 1 && node->block == QN_NONE && !qn_support_is_any (node->support);
    if (alone || lies_off_block (model, node->block, node->at))
      qn_contacts_tell (contacts, QN_PROBLEM_BEAM_END_FREE, QN_NONE, QN_NONE,
                        (QnId) (i / 2), node->at, 0);
  }
}

/* Surcharges, backfills and axles that lie beside the structure, and forces beside their blocks. */
static void
report_loads (const QnModel *model, QnContacts *contacts)
{
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad *load = qn_model_load (model, i);
    bool any =
      load->pressure > 0 || load->unit_weight > 0 || load->kind == QN_LOAD_VEHICLE;
    size_t count;
    if (load->kind == QN_LOAD_BACKFILL)
      any = any && qn_load_earth_coefficient (load) > 0;
    bool off = load->kind == QN_LOAD_FORCE && load->has_at
               && lies_off_block (model, load->block, load->at);
    bool nothing = qn_load_is_on_edges (load->kind) && load->kind != QN_LOAD_EDGE && any
                   && qn_model_edge_forces_of (model, i, &count) == NULL;
    bool beside = load->kind == QN_LOAD_VEHICLE && load->beside > 0;
    if (off || nothing || beside)
      qn_contacts_tell (contacts,
                        off       ? QN_PROBLEM_LOAD_OFF_BLOCK
                        : nothing ? QN_PROBLEM_LOAD_MEETS_NOTHING
                                  : QN_PROBLEM_LOAD_BESIDE,
                        off ? load->block : QN_NONE, QN_NONE, (QnId) i, load->at, 0);
  }
}

/* Ends of ties that lie outside their blocks. */
static void
report_ties (const QnModel *model, QnContacts *contacts)
{
  for (size_t i = 0; i < 2 * model->tie_count; i++) {
    const QnTieEnd *end = &model->ties[i / 2].ends[i % 2];
    if (lies_off_block (model, end->block, end->at))
      qn_contacts_tell (contacts, QN_PROBLEM_TIE_OFF_BLOCK, end->block, QN_NONE,
                        (QnId) (i / 2), end->at, 0);
  }
}

void
qn_contacts_report_loose (const QnModel *model, QnContacts *contacts)
{
  size_t blocks = model->block_count, bodies = qn_model_body_count (model);
  size_t held_count = 0;
  const QnFindings *findings = &contacts->findings;
  /* Blocks that have a face, a point contact, an overlap, a beam or a tie; sets of bodies that hang together;
   * bodies in a set with a support. */
  bool *touching = qn_pool_alloc (&contacts->room, blocks, sizeof *touching);
  QnId *sets = qn_pool_alloc (&contacts->room, bodies, sizeof *sets);
  bool *held = qn_pool_alloc (&contacts->room, bodies, sizeof *held);

  if (contacts->room.failed)
    return;
  qn_sets_init (sets, bodies);
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    touching[face->a] = touching[face->b] = true;
    qn_sets_join (sets, face->a, face->b);
  }
  for (size_t i = 0; i < findings->count; i++) {
    const QnFinding *finding = &findings->items[i];
    if (finding->problem == QN_PROBLEM_POINT_CONTACT || is_overlap (finding))
      touching[finding->block_a] = touching[finding->block_b] = true;
  }
  for (size_t i = 0; i < 2 * model->beam_count; i++) {
    QnId block = model->nodes[model->beams[i / 2].nodes[i % 2]].block;
    if (block != QN_NONE)
      touching[block] = true;
  }
  for (size_t i = 0; i < model->element_count; i++) {
    const QnId *nodes = model->elements[i].nodes;
    qn_sets_join (sets, (QnId) qn_model_node_body (model, nodes[0]),
                  (QnId) qn_model_node_body (model, nodes[1]));
  }
  for (size_t i = 0; i < model->tie_count; i++) {
    QnId a = model->ties[i].ends[0].block, b = model->ties[i].ends[1].block;
    if (a != QN_NONE)
      touching[a] = true;
    if (b != QN_NONE)
      touching[b] = true;
    if (a != QN_NONE && b != QN_NONE)
      qn_sets_join (sets, a, b);
  }
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTieEnd *ends = model->ties[i].ends;
    if (ends[0].block == QN_NONE || ends[1].block == QN_NONE)
      held[qn_sets_root (sets, ends[0].block != QN_NONE ? ends[0].block
                                                        : ends[1].block)] = true;
  }
  for (size_t i = 0; i < bodies; i++) {
    const bool *support =
      i < blocks ? model->blocks[i].support : model->nodes[i - blocks].support;
    if (qn_support_is_any (support))
      held[qn_sets_root (sets, (QnId) i)] = true;
  }
  for (size_t i = 0; i < bodies; i++) {
    held[i] = held[qn_sets_root (sets, (QnId) i)];
    held_count += held[i];
  }

  report_blocks (model, contacts, QN_PROBLEM_BLOCK_WITHOUT_CONTACT, touching);
  if (held_count == 0) { /* one finding says more than one for every block */
    QnVec2 at = blocks > 0 ? model->blocks[0].centroid : model->nodes[0].at;
    qn_contacts_tell (contacts, QN_PROBLEM_NO_SUPPORT, QN_NONE, QN_NONE, 0, at, 0);
  } else {
    report_blocks (model, contacts, QN_PROBLEM_BLOCK_FLOATING, held);
    for (size_t i = 0; i < model->beam_count; i++) {
      const QnId node = model->beams[i].nodes[0];
      if (!held[qn_model_node_body (model, node)])
        qn_contacts_tell (contacts, QN_PROBLEM_BEAM_FLOATING, QN_NONE, QN_NONE, (QnId) i,
                          model->nodes[node].at, 0);
    }
  }
  report_free_ends (model, contacts);
  report_loads (model, contacts);
  report_ties (model, contacts);
}
