#include "doc/masonry/masonry-plan.h"

#include "core/base/integer.h"
#include "doc/masonry/masonry-shape.h"
#include <math.h>

/* Rise of an arch where the pointer does not define it, in parts of the span. */
#define LEAST_RISE 0.02

static void
begin (QnMasonry *masonry, const QnMasonryStyle *style, QnMasonryKind kind)
{
  qn_masonry_init (masonry, kind, NULL);
  masonry->thickness = style->thickness;
  masonry->unit_weight = style->unit_weight;
  masonry->law = style->law;
  masonry->foundation = style->base ? style->unit.y : 0.0;
}

void
qn_plan_wall (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 from, QnVec2 to)
{
  begin (masonry, style, QN_MASONRY_WALL);
  QnLeaf *leaf = &masonry->wall.leaves[0];
  double half = 0.5 * style->unit.x;
  leaf->unit = style->unit;
  leaf->bond = style->bond;
  leaf->lap = style->lap;
  leaf->length = MAX (round (fabs (to.x - from.x) / half), 1.0) * half;
  masonry->wall.height =
    MAX (round (fabs (to.y - from.y) / style->unit.y), 1.0) * style->unit.y;
  masonry->origin.x = to.x < from.x ? from.x - leaf->length : from.x;
  masonry->origin.y = to.y < from.y ? from.y - masonry->wall.height : from.y;
}

gboolean
qn_plan_opening (const QnMasonry *wall, const QnMasonryStyle *style, QnVec2 from,
                 QnVec2 to, gboolean snap, QnOpening *opening)
{
  *opening = (QnOpening){ .voussoirs = 1 };
  if (!qn_masonry_set_opening_box (wall, opening, from, to, snap))
    return FALSE;
  const QnLeaf *leaf = &wall->wall.leaves[0];
  /* Nothing can span an opening that reaches the top of the wall. */
  double above =
    qn_masonry_wall_size (wall).y - opening->at.y - opening->height + 1e-9 * leaf->unit.y;
  QnSpan span = above < leaf->unit.y ? QN_SPAN_NONE : style->span;
  qn_opening_set_head (opening, style->head, span, leaf->unit.y);
  return TRUE;
}

double
qn_plan_arch_rise (QnVec2 left, QnVec2 right, QnVec2 at)
{
  QnVec2 chord = qn_vec2_sub (right, left);
  double span = qn_vec2_length (chord);
  return span > 0.0 ? qn_vec2_cross (chord, qn_vec2_sub (at, left)) / span : 0.0;
}

void
qn_plan_arch (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 left, QnVec2 right,
              double rise)
{
  begin (masonry, style, QN_MASONRY_ARCH);
  QnVec2 chord = qn_vec2_sub (right, left);
  QnArch *arch = &masonry->arch;
  arch->span = qn_vec2_length (chord);
  arch->rise = MAX (rise, LEAST_RISE * arch->span);
  arch->ring = style->ring;
  arch->voussoirs = style->voussoirs;
  arch->shape = style->shape;
  qn_arch_fit_shape (arch);
  masonry->origin = left;
  masonry->rotation = atan2 (chord.y, chord.x);
}

/* How many parts of about such a size. */
static int32_t
count_parts (double length, double part)
{
  return (int32_t) qn_to_integer (round (length / part), 1, QN_MAX_BLOCKS);
}

static int32_t
count_courses (const QnMasonryStyle *style, double height)
{
  return count_parts (height, style->unit.y);
}

void
qn_plan_in_box (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 from, QnVec2 to)
{
  const QnVec2 size = qn_vec2 (fabs (to.x - from.x), fabs (to.y - from.y));
  const double top = style->top_to_foot * size.x;
  begin (masonry, style, qn_masonry_kind_of (style->kind));
  masonry->origin = qn_vec2 (MIN (from.x, to.x), MIN (from.y, to.y));
  if (style->kind == QN_MASONRY_GRID)
    qn_masonry_set_grid (
      &masonry->wall, size,
      qn_vec2 (count_parts (size.x, style->unit.x), count_courses (style, size.y)));
  else if (style->kind == QN_MASONRY_VORONOI)
    qn_masonry_set_voronoi (&masonry->rubble, size, style->unit.x);
  else if (style->kind == QN_MASONRY_PORTAL) {
    masonry->portal.bays = 1;
    masonry->portal.pier_width = 0.2 * size.x;
    masonry->portal.span = 0.6 * size.x;
    masonry->portal.lintel_height = MIN (style->unit.y, 0.5 * size.y);
    masonry->portal.pier_height = size.y - masonry->portal.lintel_height;
    masonry->portal.courses = count_courses (style, masonry->portal.pier_height);
  } else if (style->kind == QN_MASONRY_BUTTRESS) {
    masonry->origin.x = from.x;
    masonry->buttress = (QnButtress){ .height = size.y,
                                      .bottom = size.x,
                                      .top = top,
                                      .courses = count_courses (style, size.y),
                                      .leans_right = to.x > from.x };
  } else if (style->kind == QN_MASONRY_RUBBLE)
    masonry->rubble = (QnRubble){ .width = size.x,
                                  .top = top,
                                  .height = size.y,
                                  .stone = style->unit.x,
                                  .irregularity = 0.7,
                                  .seed = 1 };
  else {
    masonry->origin.x = 0.5 * (from.x + to.x);
    masonry->column.height = size.y;
    masonry->column.bottom = size.x;
    masonry->column.top = top;
    masonry->column.drums = count_courses (style, size.y);
  }
}

double
qn_masonry_estimate_blocks (const QnMasonry *masonry)
{
  switch (masonry->kind) {
  case QN_MASONRY_WALL: {
    QnVec2 size = qn_masonry_wall_size (masonry);
    QnVec2 unit = masonry->wall.leaves[0].unit;
    return size.x / unit.x * size.y / unit.y;
  }
  case QN_MASONRY_ARCH:
    return masonry->arch.voussoirs * MAX (masonry->arch.rings, 1);
  case QN_MASONRY_COLUMN:
    return masonry->column.drums;
  case QN_MASONRY_BUTTRESS:
    return masonry->buttress.courses;
  case QN_MASONRY_PORTAL:
    return (masonry->portal.bays + 1) * masonry->portal.courses
           + masonry->portal.bays * masonry->portal.arch.voussoirs
               * MAX (masonry->portal.arch.rings, 1);
  case QN_MASONRY_RUBBLE:
    return masonry->rubble.width * masonry->rubble.height
           / (masonry->rubble.stone * masonry->rubble.stone);
  case QN_MASONRY_KIND_COUNT:
    break;
  }
  return 0.0;
}
