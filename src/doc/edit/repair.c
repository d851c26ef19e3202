#include "doc/edit/repair.h"

#include "core/base/polygon.h"
#include "core/contact/plausible.h"
#include "doc/edit/edit-shape.h"
#include "doc/edit/edit.h"
#include "io/text/text-format.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Repairs in one go at most; each can bring another finding to light. */
#define MOST_REPAIRS 500

/* Overlap above this part of the smaller block: it lies in the other. */
#define SAME_BLOCK 0.999

/* Snapping reaches this much farther than the gap: corners lie aslant. */
#define SNAP_REACH 1.5

/* Gaps are closed up to so many times the width of one. */
#define CLOSE_REACH 1.25

/* ---- which block gives way ---- */

static int
firmness (const QnBlock *block)
{
  int fixed = qn_support_is_any (block->support);
  return 2 * fixed + (block->wall != QN_NONE || block->masonry != QN_NONE);
}

static void
choose (const QnModel *model, const QnFinding *finding, QnId *mover, QnId *keeper)
{
  *mover = finding->block_a;
  *keeper = finding->block_b;
  if (*keeper == QN_NONE || finding->problem == QN_PROBLEM_BLOCK_SLIVER)
    return;
  const QnBlock *a = &model->blocks[*mover], *b = &model->blocks[*keeper];
  gboolean swap =
    firmness (a) != firmness (b) ? firmness (a) > firmness (b) : a->area > b->area;
  if (swap) {
    *mover = finding->block_b;
    *keeper = finding->block_a;
  }
}

/* ---- choices ---- */

static guint
overlap_choices (const QnModel *model, const QnFinding *finding, QnRepair *choices)
{
  QnId mover, keeper;
  guint count = 0;
  choose (model, finding, &mover, &keeper);
  g_auto (QnRing) p = qn_block_to_ring (model, mover),
                  q = qn_block_to_ring (model, keeper);
  g_auto (QnRings) common = { 0 };
  qn_polygon_intersection (&p, &q, &common, NULL);
  if (qn_rings_area (&common) >= SAME_BLOCK * model->blocks[mover].area) {
    choices[count++] = QN_REPAIR_DELETE;
  } else {
    choices[count++] = QN_REPAIR_TRIM;
    choices[count++] = QN_REPAIR_MOVE;
  }
  choices[count++] = QN_REPAIR_MERGE;
  return count;
}

/* A near miss is closed up to a width that allows for sides that are not parallel. */
static double
gap_width (const QnFinding *finding)
{
  return CLOSE_REACH * finding->value;
}

/* Whether the sides of the two blocks bound a gap: corners in front of sides do not. */
static gboolean
can_grow (const QnModel *model, const QnFinding *finding)
{
  g_auto (QnGaps) gaps;
  gboolean found = FALSE;
  qn_model_find_gaps (model, gap_width (finding), &gaps);
  for (gsize i = 0; i < gaps.count && !found; i++)
    found = ((QnId) gaps.items[i].rings[0] == finding->block_a
             && (QnId) gaps.items[i].rings[1] == finding->block_b)
            || ((QnId) gaps.items[i].rings[1] == finding->block_a
                && (QnId) gaps.items[i].rings[0] == finding->block_b);
  return found;
}

guint
qn_repair_get_choices (const QnModel *model, const QnFinding *finding, gboolean gaps,
                       QnRepair choices[QN_REPAIR_COUNT])
{
  guint count = 0;
  gboolean two = finding->block_a != QN_NONE && finding->block_b != QN_NONE;
  if ((finding->problem == QN_PROBLEM_NEAR_MISS_GAP
       || finding->problem == QN_PROBLEM_NEAR_MISS_OVERLAP)
      && two) {
    if (finding->problem == QN_PROBLEM_NEAR_MISS_GAP && can_grow (model, finding))
      choices[count++] = QN_REPAIR_CLOSE;
    choices[count++] = QN_REPAIR_SNAP;
    choices[count++] = QN_REPAIR_MOVE;
    choices[count++] = QN_REPAIR_MERGE;
  } else if (finding->problem == QN_PROBLEM_BLOCKS_OVERLAP && two) {
    count = overlap_choices (model, finding, choices);
  } else if ((finding->problem == QN_PROBLEM_BLOCK_WITHOUT_CONTACT
              || finding->problem == QN_PROBLEM_BLOCK_FLOATING)
             && finding->block_a != QN_NONE) {
    choices[count++] = gaps ? QN_REPAIR_CLOSE : QN_REPAIR_SUPPORT;
    choices[count++] = QN_REPAIR_DELETE;
  } else if (finding->problem == QN_PROBLEM_BLOCK_SLIVER) {
    if (two)
      choices[count++] = QN_REPAIR_MERGE;
    choices[count++] = QN_REPAIR_DELETE;
  } else if (finding->problem == QN_PROBLEM_OVERRIDE_UNUSED && two) {
    choices[count++] = QN_REPAIR_FORGET;
  }
  return count;
}

const QnRepairWords qn_repair_words[QN_REPAIR_COUNT] = {
  [QN_REPAIR_CLOSE] = { N_ ("Close"), N_ ("Close Gaps"),
                        N_ ("Extends all blocks beside gaps like this one to the "
                            "middle") },
  [QN_REPAIR_SNAP] = { N_ ("Snap"), N_ ("Snap Corners"),
                       N_ ("Moves corners of %s onto %s") },
  [QN_REPAIR_MOVE] = { N_ ("Move"), N_ ("Move to Contact"),
                       N_ ("Moves %s as a whole until it touches %s") },
  [QN_REPAIR_TRIM] = { N_ ("Trim"), N_ ("Trim Block"),
                       N_ ("Removes from %s its overlap with %s") },
  [QN_REPAIR_MERGE] = { N_ ("Merge"), N_ ("Merge Blocks"),
                        N_ ("Makes one block of %s and %s") },
  [QN_REPAIR_SUPPORT] = { N_ ("Fix"), N_ ("Fix Block"), N_ ("Fixes %s to the ground") },
  [QN_REPAIR_DELETE] = { N_ ("Delete"), N_ ("Delete"), N_ ("Removes %s") },
  [QN_REPAIR_FORGET] = { N_ ("Remove"), N_ ("Remove Exception"),
                         N_ ("Removes the exception for %s and %s") },
};

char *
qn_repair_explain (const QnModel *model, const QnFinding *finding, QnRepair repair)
{
  QnId mover, keeper;
  if (finding->problem == QN_PROBLEM_BLOCK_SLIVER && finding->subject > 1)
    return g_strdup_printf (repair == QN_REPAIR_MERGE ? _ (
                              "Makes each of these %d blocks a part of its neighbour")
                                                      : _ ("Removes these %d blocks"),
                            (int) finding->subject);
  choose (model, finding, &mover, &keeper);
  const char *first = model->blocks[mover].name;
  const char *second = keeper != QN_NONE ? model->blocks[keeper].name : "";
  g_auto (GStrv) parts = g_strsplit (_ (qn_repair_words[repair].sentence), "%s", -1);
  GString *text = g_string_new (parts[0]);
  for (guint i = 1; parts[i] != NULL; i++)
    g_string_append_printf (text, "%s%s", i == 1 ? first : second, parts[i]);
  return g_string_free (text, FALSE);
}

/* ---- repairs ---- */

/* Outward normal of the side of a block that is nearest to a place. */
static QnVec2
normal_at (const QnModel *model, QnId block, QnVec2 at)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  gsize count = (gsize) model->blocks[block].vertex_count;
  QnVec2 normal = { 0.0, 1.0 };
  double nearest = INFINITY;
  for (gsize i = 0; i < count; i++) {
    QnVec2 along = qn_vec2_sub (v[(i + 1) % count], v[i]);
    double length = qn_vec2_length (along);
    double distance = qn_segment_distance (v[i], v[(i + 1) % count], at);
    if (length > 0.0 && distance < nearest) {
      nearest = distance;
      normal = qn_vec2 (along.y / length, -along.x / length);
    }
  }
  return normal;
}

static gboolean
move_to_contact (QnModel *model, const QnFinding *finding, GError **error)
{
  QnId mover, keeper;
  choose (model, finding, &mover, &keeper);
  double sign = finding->problem == QN_PROBLEM_NEAR_MISS_GAP ? -1.0 : 1.0;
  QnVec2 by =
    qn_vec2_scale (sign * finding->value, normal_at (model, keeper, finding->at));
  return qn_edit_transform_blocks (model, (QnBlockSet){ &mover, 1 },
                                   qn_transform_translation (by.x, by.y), error);
}

/* Gives the block that gives way another shape, freed from its wall first: without what lies in its
 * neighbour, or with its corners and edges on those of the neighbour. */
static gboolean
reshape (QnModel *model, const QnFinding *finding, gboolean trims, GError **error)
{
  QnId mover, keeper;
  choose (model, finding, &mover, &keeper);
  qn_edit_take_apart (model, (QnBlockSet){ &mover, 1 });
  g_auto (QnRing) subject = qn_block_to_ring (model, mover),
                  neighbour = qn_block_to_ring (model, keeper);
  g_auto (QnRings) pair = { 0 }, left = { 0 };
  QnDiag diag = { 0 };
  if (!trims) {
    qn_rings_take (&pair, &neighbour);
    qn_rings_take (&pair, &subject);
    qn_snap_neighbours (&pair, SNAP_REACH * finding->value, NULL);
    qn_rings_take (&left, &pair.items[1]);
  } else if (qn_polygon_difference (
               &subject, &(QnRings){ .items = &neighbour, .count = 1 }, &left, &diag)
             != QN_OK)
    return qn_edit_refuse_diag (error, model, &diag);
  if (left.count == 0)
    return qn_edit_refuse (error, _ ("Nothing would be left of %s"),
                           model->blocks[mover].name);
  return qn_edit_replace_blocks (model, &mover, 1, &left, error);
}

static gboolean
forget (QnModel *model, const QnFinding *finding)
{
  gsize kept = 0;
  for (gsize i = 0; i < model->override_count; i++) {
    if (!qn_override_concerns (&model->overrides[i], finding->block_a, finding->block_b))
      model->overrides[kept++] = model->overrides[i];
  }
  model->override_count = kept;
  return TRUE;
}

/* What a gap parts must touch before it can be one. */
static gboolean
merge (QnModel *model, const QnFinding *finding, GError **error)
{
  QnId ids[2];
  choose (model, finding, &ids[1], &ids[0]);
  return (finding->problem != QN_PROBLEM_NEAR_MISS_GAP
          || reshape (model, finding, FALSE, error))
         && qn_edit_join_blocks (model, (QnBlockSet){ ids, 2 }, error);
}

/* Slivers side by side as one: each becomes a part of its neighbour, or goes. */
static gboolean
repair_slivers (QnModel *model, QnId first, gboolean merges, GError **error)
{
  QnContacts contacts;
  QnDiag diag = { 0 };
  QnId *row, *beside;
  g_autoptr (GArray) ids = g_array_new (FALSE, FALSE, sizeof (QnId));
  g_autoptr (GArray) pairs = g_array_new (FALSE, FALSE, 2 * sizeof (QnId));
  if (qn_contacts_detect (model, &contacts, &diag) != QN_OK)
    return qn_edit_refuse_diag (error, model, &diag);
  gboolean any = qn_contacts_find_slivers (model, &contacts, &row, &beside);
  for (QnId i = 0; any && i < (QnId) model->block_count; i++)
    if (row[i] == first) {
      g_array_append_val (ids, i);
      const QnId pair[] = { beside[i], i };
      if (beside[i] != QN_NONE)
        g_array_append_val (pairs, pair);
    }
  qn_contacts_clear (&contacts);
  if (!merges)
    return qn_edit_delete_blocks (model, (QnBlockSet){ (QnId *) ids->data, ids->len },
                                  error);
  /* What has become a part of another already is gone. */
  for (guint i = 0; i < pairs->len; i++) {
    const QnId *pair = (const QnId *) pairs->data + 2 * i;
    if (model->blocks[pair[0]].vertex_count > 0 && model->blocks[pair[1]].vertex_count > 0
        && !qn_edit_join_blocks (model, (QnBlockSet){ pair, 2 }, error))
      return FALSE;
  }
  return TRUE;
}

/* Near misses up to the width of this one; around a block that stands alone joints of mortar of usual
 * width. */
static gboolean
close_gaps (QnModel *model, const QnFinding *finding, GError **error)
{
  double width = gap_width (finding);
  if (finding->problem != QN_PROBLEM_NEAR_MISS_GAP) {
    g_auto (QnGaps) gaps;
    qn_model_find_gaps (model, 0.0, &gaps);
    width = 0.0;
    for (gsize i = 0; i < gaps.count; i++)
      width = fmax (width, CLOSE_REACH * gaps.items[i].width);
  }
  return qn_edit_close_gaps (model, width, error);
}

gboolean
qn_edit_repair (QnModel *model, const QnFinding *finding, QnRepair repair, GError **error)
{
  QnId mover, keeper;
  choose (model, finding, &mover, &keeper);
  static const bool fixed[QN_DOF_COUNT] = { true, true, true };
  if (finding->problem == QN_PROBLEM_BLOCK_SLIVER)
    return repair_slivers (model, mover, repair == QN_REPAIR_MERGE, error);
  switch (repair) {
  case QN_REPAIR_CLOSE:
    return close_gaps (model, finding, error);
  case QN_REPAIR_SNAP:
    return reshape (model, finding, FALSE, error);
  case QN_REPAIR_MOVE:
    return move_to_contact (model, finding, error);
  case QN_REPAIR_TRIM:
    return reshape (model, finding, TRUE, error);
  case QN_REPAIR_MERGE:
    return merge (model, finding, error);
  case QN_REPAIR_SUPPORT:
    return qn_edit_set_support (model, (QnBlockSet){ &mover, 1 }, QN_DOF_UX, QN_DOF_COUNT,
                                fixed, error);
  case QN_REPAIR_DELETE:
    return qn_edit_delete_blocks (model, (QnBlockSet){ &mover, 1 }, error);
  case QN_REPAIR_FORGET:
    return forget (model, finding);
  case QN_REPAIR_COUNT:
    break;
  }
  return FALSE;
}

/* ---- all at once ---- */

static gboolean
is_harmless (QnRepair repair)
{
  return repair == QN_REPAIR_CLOSE || repair == QN_REPAIR_SNAP || repair == QN_REPAIR_TRIM
         || repair == QN_REPAIR_FORGET;
}

static gboolean
has_gaps (const QnModel *model)
{
  g_auto (QnGaps) gaps;
  qn_model_find_gaps (model, 0.0, &gaps);
  return gaps.count > 0;
}

/* Repairs the first finding that can be; FALSE where there is none. */
static gboolean
repair_one (QnModel *model)
{
  QnContacts contacts = { 0 };
  QnDiag diag = { 0 };
  if (qn_model_prepare (model, &diag) != QN_OK
      || qn_contacts_detect (model, &contacts, &diag) != QN_OK)
    return FALSE;
  gboolean done = FALSE, gaps = has_gaps (model);
  for (gsize i = 0; i < contacts.findings.count && !done; i++) {
    QnRepair choices[QN_REPAIR_COUNT];
    const QnFinding *finding = &contacts.findings.items[i];
    if (qn_repair_get_choices (model, finding, gaps, choices) == 0
        || !is_harmless (choices[0]))
      continue;
    QnModel trial;
    if (qn_model_copy (model, &trial, &diag) != QN_OK)
      break;
    done = qn_edit_repair (&trial, finding, choices[0], NULL)
           && qn_edit_rebuild (&trial, NULL, NULL);
    if (done) {
      QnModel old = *model;
      *model = trial;
      trial = old;
    }
    qn_model_clear (&trial);
  }
  qn_contacts_clear (&contacts);
  return done;
}

gboolean
qn_edit_repair_all (QnModel *model, guint *count, GError **error)
{
  for (*count = 0; *count < MOST_REPAIRS && repair_one (model);)
    (*count)++;
  if (*count > 0)
    return TRUE;
  return qn_edit_refuse (error,
                         _ ("There is nothing here that can be repaired automatically"));
}

/* Gaps below so many tolerances of contacts are none. */
#define LEAST_GAP 2.0

static double
least_gap (const QnModel *model)
{
  return LEAST_GAP * model->contact.tolerance * model->characteristic_length;
}

static QnRings
to_rings (const QnModel *model)
{
  QnRings rings = { 0 };
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    qn_rings_add (&rings, qn_model_block_vertices (model, i),
                  (gsize) model->blocks[i].vertex_count);
  return rings;
}

void
qn_model_find_gaps (const QnModel *model, double width, QnGaps *gaps)
{
  g_auto (QnRings) rings = to_rings (model);
  qn_gaps_find (&rings, least_gap (model),
                width > 0.0 ? width : qn_gaps_usual_width (&rings), gaps);
}

double
qn_model_usual_gap (const QnModel *model)
{
  g_auto (QnRings) rings = to_rings (model);
  return qn_gaps_usual_width (&rings);
}

char *
qn_gaps_dup_text (const QnGaps *gaps)
{
  double least, mean, most;
  if (gaps->count == 0)
    return NULL;
  qn_gaps_widths (gaps, &least, &mean, &most);
  g_autofree char *widths = qn_widths_dup_text (least, mean, most);
  return g_strdup_printf (ngettext ("%zu joint of mortar, %s wide",
                                    "%zu joints of mortar, %s wide",
                                    (gulong) gaps->count),
                          gaps->count, widths);
}

static gboolean
same_ring (const QnModel *model, QnId block, const QnRing *ring)
{
  return (gsize) model->blocks[block].vertex_count == ring->count
         && memcmp (qn_model_block_vertices (model, block), ring->points,
                    ring->count * sizeof *ring->points)
              == 0;
}

gboolean
qn_edit_close_gaps (QnModel *model, double width, GError **error)
{
  g_auto (QnRings) rings = to_rings (model);
  qn_gaps_close (&rings, least_gap (model), width);
  g_autoptr (GArray) changed = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (!same_ring (model, i, &rings.items[i]))
      g_array_append_val (changed, i);
  const QnBlockSet set = { (const QnId *) changed->data, changed->len };
  gboolean done = set.count > 0;
  if (!done)
    qn_edit_refuse (error, _ ("There are no gaps up to %.3g mm between blocks"),
                    1e3 * width);
  qn_edit_take_apart (model, set);
  for (guint i = 0; i < set.count && done; i++) {
    const QnBlock *block = &model->blocks[set.ids[i]];
    const QnRings one = { .items = &rings.items[set.ids[i]], .count = 1 };
    if ((gsize) block->vertex_count == one.items->count)
      memcpy (model->vertices + block->first_vertex, one.items->points,
              one.items->count * sizeof *one.items->points);
    else
      done = qn_edit_replace_blocks (model, &set.ids[i], 1, &one, error);
  }
  return done;
}
