#include "stereotomy/masonry.h"
#include "core/base/memory.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"

#include <stdlib.h>

#define DEFAULT_MINIMUM_PIECE 0.2

void
qn_masonry_init (QnMasonry *masonry, QnMasonryKind kind, const char *name)
{
  *masonry = (QnMasonry){ .kind = kind,
                          .name = g_strdup (name),
                          .thickness = 1,
                          .density = -1,
                          .law = QN_NONE,
                          .ring_law = QN_NONE,
                          .perturbation_seed = 1,
                          .wall.minimum_piece = DEFAULT_MINIMUM_PIECE };
  qn_masonry_add_leaf (masonry);
}

void
qn_masonry_clear (QnMasonry *masonry)
{
  free (masonry->name);
  QnMasonryWall *wall = &masonry->wall;
  free (wall->leaves);
  free (wall->course_heights);
  free (wall->courses.name);
  free (wall->courses.lengths);
  free (wall->courses.course_ends);
  for (size_t i = 0; i < wall->opening_count; i++)
    free (wall->openings[i].name);
  free (wall->openings);
  *masonry = (QnMasonry){ 0 };
}

void
qn_masonry_set_grid (QnMasonryWall *wall, QnVec2 size, QnVec2 cells)
{
  QnLeaf *leaf = &wall->leaves[0];

  wall->grid = true;
  wall->height = size.y;
  leaf->bond = QN_BOND_STACK;
  leaf->length = size.x;
  leaf->unit = qn_vec2 (size.x / cells.x, size.y / cells.y);
}

void
qn_masonry_set_voronoi (QnRubble *rubble, QnVec2 size, double cell)
{
  *rubble = (QnRubble){ .width = size.x,
                        .top = size.x,
                        .height = size.y,
                        .stone = cell,
                        .irregularity = 1,
                        .relaxed = true,
                        .seed = 1 };
}

QnOpening *
qn_masonry_add_opening (QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  qn_require_memory (QN_ARRAY_PUSH (wall->openings, wall->opening_count,
                                    wall->opening_capacity,
                                    (QnOpening){ .voussoirs = 1 }));
  return &wall->openings[wall->opening_count - 1];
}

QnLeaf *
qn_masonry_add_leaf (QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  qn_require_memory (QN_ARRAY_PUSH (wall->leaves, wall->leaf_count, wall->leaf_capacity,
                                    (QnLeaf){ .lap = 0.5 }));
  return &wall->leaves[wall->leaf_count - 1];
}

void
qn_masonries_take (QnMasonries *list, QnMasonry *masonry)
{
  qn_require_memory (QN_ARRAY_PUSH (list->items, list->count, list->capacity, *masonry));
  *masonry = (QnMasonry){ 0 };
}

void
qn_masonries_clear (QnMasonries *list)
{
  for (size_t i = 0; i < list->count; i++)
    qn_masonry_clear (&list->items[i]);
  free (list->items);
  *list = (QnMasonries){ 0 };
}

QnStatus
qn_masonry_problem (QnDiag *diag, QnProblem problem, const char *field, double value)
{
  return qn_diag_set_field (diag, problem, QN_ENTITY_MASONRY, QN_NONE, field, value);
}

bool
qn_require_length (QnSubject of, const char *field, double value, QnRange range)
{
  return qn_require_size (of, field, value, range, QN_MAX_COORDINATE);
}

bool
qn_require_pieces (QnSubject of, const char *field, int32_t value, int32_t least)
{
  return qn_require (of, value >= least, QN_PROBLEM_NOT_POSITIVE, field, value)
         && qn_require (of, value <= QN_MAX_PIECES, QN_PROBLEM_TOO_MANY_BLOCKS, field,
                        value);
}

static QnStatus
check_common (const QnMasonry *m, QnDiag *diag)
{
  const QnSubject of = qn_masonry_subject (diag);
  return qn_required (
    qn_require_name (of, m->name, QN_NONE, QN_NONE)
    && qn_require_length (of, "origin", m->origin.x, QN_RANGE_FINITE)
    && qn_require_length (of, "origin", m->origin.y, QN_RANGE_FINITE)
    && qn_require_length (of, "rotation", m->rotation, QN_RANGE_FINITE)
    && qn_require_length (of, "thickness", m->thickness, QN_RANGE_POSITIVE)
    && qn_require_length (of, "foundation", m->foundation, QN_RANGE_NOT_NEGATIVE)
    && qn_require (of, m->perturbation >= 0 && m->perturbation <= QN_MAX_PERTURBATION,
                   QN_PROBLEM_PERTURBATION, "perturbation", m->perturbation));
}

static QnStatus (*const lay[QN_MASONRY_KIND_COUNT]) (const QnMasonry *masonry,
                                                     QnPieces *pieces, QnDiag *diag) = {
  [QN_MASONRY_WALL] = qn_masonry_lay_wall,
  [QN_MASONRY_ARCH] = qn_masonry_lay_arch,
  [QN_MASONRY_COLUMN] = qn_masonry_lay_column,
  [QN_MASONRY_BUTTRESS] = qn_masonry_lay_buttress,
  [QN_MASONRY_PORTAL] = qn_masonry_lay_portal,
  [QN_MASONRY_RUBBLE] = qn_masonry_lay_rubble,
};

/* Turns and moves the pieces to their place and adds them to the model. */
static QnStatus
add_blocks (const QnMasonry *masonry, const QnPieces *pieces, QnModel *model,
            QnDiag *diag)
{
  double cosine = cos (masonry->rotation), sine = sin (masonry->rotation);
  for (size_t i = 0; i < pieces->count; i++) {
    const QnPiece *piece = &pieces->items[i];
    for (size_t k = 0; k < piece->ring.count; k++) {
      QnVec2 p = piece->ring.points[k];
      if (masonry->rotation != 0)
        p = qn_vec2_rotate (p, cosine, sine);
      piece->ring.points[k] = qn_vec2_add (masonry->origin, p);
    }
    QnStatus status = qn_ring_check (&piece->ring, (QnId) i, diag);
    if (status != QN_OK)
      return status;
    QnBlock *block =
      qn_model_add_block (model, piece->name, piece->ring.points, piece->ring.count);
    if (block == NULL)
      return qn_diag_no_memory (diag);
    block->thickness = masonry->thickness;
    block->unit_weight = masonry->unit_weight;
    block->density = masonry->density;
    block->law = masonry->law;
    block->ring = piece->ring_number;
    block->ring_law = piece->ring_number > 0 ? masonry->ring_law : QN_NONE;
    block->rigid = piece->fixed;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = piece->fixed;
  }
  return QN_OK;
}

QnStatus
qn_masonry_expand (const QnMasonry *masonry, QnId index, QnModel *model, QnDiag *diag)
{
  g_auto (QnPieces) pieces = { 0 };
  QnStatus status = check_common (masonry, diag);
  if (status == QN_OK)
    status = lay[masonry->kind](masonry, &pieces, diag);
  if (status == QN_OK && masonry->perturbation > 0)
    qn_pieces_perturb (masonry->perturbation, masonry->perturbation_seed, &pieces);
  if (status == QN_OK && model->block_count + pieces.count > QN_MAX_BLOCKS)
    status = qn_masonry_problem (diag, QN_PROBLEM_TOO_MANY_BLOCKS, NULL, 0);
  if (status == QN_OK && pieces.count == 0)
    status = qn_masonry_problem (diag, QN_PROBLEM_GEOMETRY_EMPTY, NULL, 0);
  if (status == QN_OK)
    status = add_blocks (masonry, &pieces, model, diag);
  /* An error in a polygon is an error of the object. */
  if (status != QN_OK && diag != NULL && status != QN_ERROR_NO_MEMORY) {
    diag->entity = QN_ENTITY_MASONRY;
    diag->index = index;
  }
  return status;
}

/* clang-format off */
const char *const qn_masonry_kind_names[QN_MASONRY_NAME_COUNT] = { "wall", "arch", "column", "buttress", "portal", "rubble", "grid", "voronoi" };
const char *const qn_bond_names[QN_BOND_COUNT] = { "running", "stack", "header", "english", "flemish", "custom" };
const char *const qn_closer_names[QN_CLOSER_COUNT] = { "none", "queen", "three-quarter" };
const char *const qn_edge_names[QN_EDGE_COUNT] = { "straight", "toothed" };
const char *const qn_head_names[QN_HEAD_COUNT] = { "flat", "segmental", "semicircular" };
const char *const qn_span_names[QN_SPAN_COUNT] = { "none", "lintel", "flat-arch", "voussoirs" };
const char *const qn_sides_names[QN_SIDES_COUNT] = { "curved", "straight" };
const char *const qn_arch_shape_names[QN_ARCH_SHAPE_COUNT] = { "circular", "pointed", "elliptic", "parabolic", "three-centred" };
/* clang-format on */
