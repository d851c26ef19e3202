#include "core/model/model-check.h"

#include "core/base/polygon.h"
#include "core/base/require.h"
#include "core/base/tolerance.h"
#include "core/model/bar.h"

/* A law by index; QN_NONE is left to the caller. */
static bool
check_law_reference (const QnModel *model, QnId law, QnSubject of)
{
  return law == QN_NONE
         || qn_require_index (of, "law", law, model->law_count, QN_PROBLEM_LAW_UNKNOWN);
}

static QnStatus
check_polygon (const QnModel *model, QnId index, QnSubject of)
{
  const QnBlock *block = &model->blocks[index];
  const QnVec2 *vertices = qn_model_block_vertices (model, index);
  QnPolygonFlaw flaw = qn_polygon_check (vertices, (size_t) block->vertex_count);
  if (flaw.problem == QN_PROBLEM_NONE)
    return QN_OK;
  if (flaw.problem == QN_PROBLEM_NO_MEMORY)
    return qn_diag_no_memory (of.diag);

  bool drawn = of.entity == QN_ENTITY_BLOCK;
  qn_require (of, false, flaw.problem, drawn ? "vertices" : "courses", 0);
  if (of.diag != NULL && drawn) {
    of.diag->sub = flaw.vertex;
    if (flaw.vertex != QN_NONE)
      of.diag->at = vertices[flaw.vertex];
    else if (block->vertex_count > 0)
      of.diag->at = vertices[0];
  }
  return QN_ERROR_INVALID;
}

QnStatus
qn_model_check_block (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnBlock *block = &model->blocks[index];
  const QnSubject of = qn_block_subject (model, index, diag);

  if (!qn_require_name (of, block->name, qn_model_find_block (model, block->name), index))
    return QN_ERROR_INVALID;
  QnStatus status = check_polygon (model, index, of);
  if (status != QN_OK)
    return status;
  return qn_required (
    qn_require_number (of, "thickness", block->thickness, QN_RANGE_POSITIVE)
    /* A negative density means that the unit weight counts. */
    && qn_require_number (of, "density", block->density, QN_RANGE_FINITE)
    && (block->density >= 0
        || qn_require_number (of, "unit_weight", block->unit_weight,
                              QN_RANGE_NOT_NEGATIVE))
    && check_law_reference (model, block->law, of)
    && check_law_reference (model, block->ring_law, of));
}

static bool
check_law (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_LAW, index, diag };
  const QnLaw *law = &model->laws[index];

  return qn_law_check (law, index, diag) == QN_OK
         && qn_require_name (of, law->name, qn_model_find_law (model, law->name), index);
}

static bool
check_explicit_pairs (const QnPairRule *rule, QnSubject of)
{
  double sum = 0;
  if (!qn_require (of, rule->count <= QN_MAX_EXPLICIT_PAIRS, QN_PROBLEM_TOO_LARGE,
                   "pairs.positions", rule->count))
    return false;
  for (int32_t i = 0; i < rule->count; i++) {
    double position = rule->positions[i], weight = rule->weights[i];
    double before = i > 0 ? rule->positions[i - 1] : -1;
    if (!qn_require (of, position >= 0 && position <= 1 && position > before,
                     QN_PROBLEM_PAIR_POSITION, "pairs.positions", position)
        || !qn_require (of, weight > 0, QN_PROBLEM_PAIR_WEIGHTS, "pairs.weights", weight))
      return false;
    sum += weight;
  }
  return qn_require (of, !(fabs (sum - 1) > QN_TOLERANCE_WEIGHTS),
                     QN_PROBLEM_PAIR_WEIGHTS, "pairs.weights", sum);
}

static bool
check_pairs (const QnPairRule *rule, QnSubject of)
{
  const int32_t count = rule->count;
  if (rule->placement == QN_PLACEMENT_LOBATTO
      && !qn_require (
        of,
        count == 0 || (count >= QN_LEAST_LOBATTO_PAIRS && count <= QN_MOST_LOBATTO_PAIRS),
        QN_PROBLEM_LOBATTO_COUNT, "pairs.count", count))
    return false;
  if (rule->placement <= QN_PLACEMENT_LOBATTO)
    return qn_require_number (of, "pairs.offset", rule->offset, QN_RANGE_NOT_NEGATIVE);
  return qn_require (of, count >= 1, QN_PROBLEM_PAIR_COUNT, "pairs.count", count)
         && qn_require (of, count <= QN_MAX_PAIRS_PER_FACE, QN_PROBLEM_TOO_LARGE,
                        "pairs.count", count)
         && (rule->placement != QN_PLACEMENT_EXPLICIT || check_explicit_pairs (rule, of));
}

static bool
check_mesh (const QnBar *bar, QnSubject of)
{
  return qn_require (of,
                     bar->start.x != bar->end.x && bar->start.y != bar->end.y
                       && bar->via_count == 0,
                     QN_PROBLEM_BAR_MESH, "end", 0)
         && qn_require (of, qn_bar_line_count (bar) <= QN_MAX_MESH_BARS,
                        QN_PROBLEM_BAR_TOO_MANY, "spacing",
                        fmin (bar->spacing.x, bar->spacing.y));
}

/* No two of its corners are one. */
static bool
check_line (const QnBar *bar, QnSubject of)
{
  bool holds = true;

  for (int32_t i = 0; i < bar->via_count && holds; i++)
    holds = qn_require_vector (of, "via", bar->via[i]);
  for (size_t i = 0; holds && i < qn_bar_line_count (bar); i++) {
    QnVec2 ends[2];
    qn_bar_line (bar, i, ends);
    holds = qn_require (of, ends[0].x != ends[1].x || ends[0].y != ends[1].y,
                        QN_PROBLEM_BAR_SHORT, i > 0 ? "via" : "end", 0);
  }
  return holds;
}

static bool
check_bar (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_BAR, index, diag };
  const QnBar *bar = &model->bars[index];

  return qn_require (of, bar->law != QN_NONE, QN_PROBLEM_LAW_UNKNOWN, "law", 0)
         && check_law_reference (model, bar->law, of)
         && qn_require (of, model->laws[bar->law].basis != QN_BASIS_CONTACT,
                        QN_PROBLEM_BAR_BASIS, "law", 0)
         && qn_require_number (of, "area", bar->area, QN_RANGE_POSITIVE)
         && qn_require_vector (of, "start", bar->start)
         && qn_require_vector (of, "end", bar->end)
         && qn_require_number (of, "spacing", bar->spacing.x, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "spacing", bar->spacing.y, QN_RANGE_NOT_NEGATIVE)
         && (qn_bar_is_mesh (bar) ? check_mesh (bar, of) : check_line (bar, of));
}

static bool
check_contact (const QnModel *model, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_CONTACT, QN_NONE, diag };
  const QnContactSettings *contact = &model->contact;
  bool covered = true; /* every block has a law */

  for (size_t i = 0; i < model->block_count; i++)
    covered &= model->blocks[i].law != QN_NONE;
  return qn_require_number (of, "tolerance", contact->tolerance, QN_RANGE_NOT_NEGATIVE)
         && qn_require (of, contact->tolerance <= QN_MAX_CONTACT_TOLERANCE,
                        QN_PROBLEM_TOO_LARGE, "tolerance", contact->tolerance)
         && check_pairs (&contact->pairs, of)
         && check_law_reference (model, contact->law, of)
         && qn_require (of, contact->law != QN_NONE || covered, QN_PROBLEM_LAW_MISSING,
                        "law", 0);
}

static bool
check_override (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_FACE_OVERRIDE, index, diag };
  const QnFaceOverride *override = &model->overrides[index];

  return qn_require_block (of, "blocks", override->block_a, model)
         && qn_require_block (of, "blocks", override->block_b, model)
         && qn_require (of, override->block_a != override->block_b, QN_PROBLEM_SAME_BLOCK,
                        "blocks", override->block_a)
         && check_law_reference (model, override->law, of)
         && (!override->has_pairs || check_pairs (&override->pairs, of));
}

QnStatus
qn_model_check_settings (const QnModel *model, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_MODEL, QN_NONE, diag };
  /* Masses are weights over gravity: none or one to divide by. */
  bool holds =
    qn_require_number (of, "gravity", model->gravity,
                       model->gravity > 0 ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE);

  for (size_t i = 0; i < model->law_count && holds; i++)
    holds = check_law (model, (QnId) i, diag);
  holds = holds && check_contact (model, diag);
  for (size_t i = 0; i < model->override_count && holds; i++)
    holds = check_override (model, (QnId) i, diag);
  for (size_t i = 0; i < model->bar_count && holds; i++)
    holds = check_bar (model, (QnId) i, diag);
  return qn_required (holds && qn_model_check_loads (model, diag)
                      && qn_model_check_analysis (model, diag));
}
