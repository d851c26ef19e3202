/* Openings of a wall: the hole, what spans it, and the fabric cut to fit. */
#include "stereotomy/arch-ring.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"

/* Overlap or overhang below this part of an opening's size is rounding. */
#define OPENING_TOLERANCE 1e-9

/* Chords of an arched head that no voussoirs carry. */
#define BARE_HEAD_PARTS 12

/* How many parts of openings, units times parts, are cut with: so many, and so many more for every
 * unit. Walls need a few for each unit beside an opening. */
#define MOST_PARTS     20000
#define PARTS_PER_UNIT 10

/* What one opening takes from the fabric. */
typedef struct Cutter {
  QnRings parts; /* the hole first, then lintel, voussoirs, sill */
  QnBox bounds;
} Cutter;

static QnArch
head_arch (const QnOpening *opening)
{
  bool ring = opening->span == QN_SPAN_VOUSSOIRS;
  return (QnArch){ .span = opening->width,
                   .rise = opening->head == QN_HEAD_SEGMENTAL ? opening->rise
                                                              : opening->width / 2,
                   .ring = ring ? opening->depth : opening->width,
                   .shape = QN_ARCH_CIRCULAR,
                   .voussoirs = ring ? opening->voussoirs : BARE_HEAD_PARTS,
                   .sides = ring ? opening->sides : QN_SIDES_CURVED };
}

static QnStatus
check_head (const QnOpening *opening, QnDiag *diag)
{
  bool flat = opening->head == QN_HEAD_FLAT;
  bool fits =
    opening->span == QN_SPAN_NONE || (opening->span == QN_SPAN_VOUSSOIRS ? !flat : flat);
  if (!fits)
    return qn_masonry_problem (diag, QN_PROBLEM_OPENING_SPAN, "span", 0);
  if (flat)
    return QN_OK;
  double rise = head_arch (opening).rise;
  if (!(rise > 0) || rise > opening->width / 2 * (1 + 1e-12)
      || rise > opening->height * (1 + 1e-12) || rise < 1e-6 * opening->width)
    return qn_masonry_problem (diag, QN_PROBLEM_ARCH_SHAPE, "rise", rise);
  return QN_OK;
}

static QnStatus
check_opening (const QnOpening *opening, QnDiag *diag)
{
  const bool stones =
    opening->span == QN_SPAN_FLAT_ARCH || opening->span == QN_SPAN_VOUSSOIRS;
  const QnSubject of = qn_masonry_subject (diag);
  return qn_required (
    qn_require_length (of, "at", opening->at.x, QN_RANGE_FINITE)
    && qn_require_length (of, "at", opening->at.y, QN_RANGE_FINITE)
    && qn_require_length (of, "width", opening->width, QN_RANGE_POSITIVE)
    && qn_require_length (of, "height", opening->height, QN_RANGE_POSITIVE)
    && check_head (opening, diag) == QN_OK
    && (opening->span == QN_SPAN_NONE
        || qn_require_length (of, "depth", opening->depth, QN_RANGE_POSITIVE))
    && qn_require_length (of, "bearing", opening->bearing, QN_RANGE_NOT_NEGATIVE)
    && (!stones || qn_require_pieces (of, "voussoirs", opening->voussoirs, 1))
    && qn_require (of, opening->skew >= 0 && opening->skew < M_PI_2 - 0.01,
                   QN_PROBLEM_FLAT_ARCH_SKEW, "skew", opening->skew)
    && qn_require_length (of, "sill", opening->sill_height, QN_RANGE_NOT_NEGATIVE)
    && qn_require_length (of, "sill", opening->sill_bearing, QN_RANGE_NOT_NEGATIVE));
}

/* The hole: jambs, and the head as its voussoirs have it. */
static void
add_hole (const QnOpening *opening, QnRings *parts)
{
  double x0 = opening->at.x, x1 = x0 + opening->width, y0 = opening->at.y;
  if (opening->head == QN_HEAD_FLAT) {
    QnRing hole = qn_rectangle (x0, y0, x1, y0 + opening->height);
    qn_rings_take (parts, &hole);
    return;
  }

  QnArch arch = head_arch (opening);
  QnArchRing ring;
  qn_arch_ring_init (&ring, &arch);
  g_auto (QnRing) line = qn_arch_ring_line (&ring, false, INFINITY);
  QnRing hole = { g_new (QnVec2, line.count + 2), 0 };
  QnVec2 springing = { x0, y0 + opening->height - arch.rise };
  if (springing.y > y0) {
    hole.points[hole.count++] = qn_vec2 (x0, y0);
    hole.points[hole.count++] = qn_vec2 (x1, y0);
  }
  for (size_t i = line.count; i-- > 0;)
    hole.points[hole.count++] = qn_vec2_add (springing, line.points[i]);
  qn_rings_take (parts, &hole);
}

/* Voussoirs under a level extrados and over a level intrados, joints evenly spaced on both. */
static void
lay_flat_arch (const QnOpening *opening, const char *prefix, QnPieces *pieces)
{
  double y0 = opening->at.y + opening->height, y1 = y0 + opening->depth;
  double lean = opening->depth * tan (opening->skew), x = opening->at.x;
  double top = opening->width + 2 * lean;
  int32_t n = opening->voussoirs;
  for (int32_t i = 0; i < n; i++) {
    double s0 = (double) i / n, s1 = (double) (i + 1) / n;
    const QnVec2 corners[] = { { x + s0 * opening->width, y0 },
                               { x + s1 * opening->width, y0 },
                               { x - lean + s1 * top, y1 },
                               { x - lean + s0 * top, y1 } };
    qn_pieces_add (pieces, qn_ring_of (corners, 4), "%s.v%d", prefix, i + 1);
  }
}

static void
lay_span (const QnOpening *opening, const char *prefix, QnPieces *pieces)
{
  double x0 = opening->at.x, x1 = x0 + opening->width;
  double y = opening->at.y + opening->height;
  switch (opening->span) {
  case QN_SPAN_LINTEL:
    qn_pieces_add (
      pieces,
      qn_rectangle (x0 - opening->bearing, y, x1 + opening->bearing, y + opening->depth),
      "%s.lintel", prefix);
    break;
  case QN_SPAN_FLAT_ARCH:
    lay_flat_arch (opening, prefix, pieces);
    break;
  case QN_SPAN_VOUSSOIRS: {
    QnArch arch = head_arch (opening);
    qn_arch_lay_ring (&arch, qn_vec2 (x0, y - arch.rise), prefix, pieces);
    break;
  }
  case QN_SPAN_NONE:
  case QN_SPAN_COUNT:
    break;
  }
}

/* Fills `cutter` and adds lintel, voussoirs and sill to `pieces`. */
static void
make_cutter (const QnMasonry *masonry, size_t index, Cutter *cutter, QnPieces *pieces)
{
  const QnOpening *opening = &masonry->wall.openings[index];
  const char *name = opening->name != NULL ? opening->name : "";
  g_autofree char *prefix = name[0] != '\0'
                              ? g_strdup_printf ("%s.%s", masonry->name, name)
                              : g_strdup_printf ("%s.o%zu", masonry->name, index + 1);
  size_t first = pieces->count;
  add_hole (opening, &cutter->parts);
  lay_span (opening, prefix, pieces);
  if (opening->sill_height > 0)
    qn_pieces_add (pieces,
                   qn_rectangle (opening->at.x - opening->sill_bearing,
                                 opening->at.y - opening->sill_height,
                                 opening->at.x + opening->width + opening->sill_bearing,
                                 opening->at.y),
                   "%s.sill", prefix);
  for (size_t i = first; i < pieces->count; i++)
    qn_rings_add (&cutter->parts, pieces->items[i].ring.points,
                  pieces->items[i].ring.count);
  cutter->bounds = qn_rings_bounds (&cutter->parts);
}

/* Lintels, voussoirs and sills must lie within the wall; the hole may reach beyond it, not miss it. */
static QnStatus
check_inside (const Cutter *cutter, QnBox wall, QnDiag *diag)
{
  double margin = OPENING_TOLERANCE * qn_box_size (wall);
  if (!qn_box_meets_within (qn_ring_bounds (&cutter->parts.items[0]), wall, -margin))
    return qn_masonry_problem (diag, QN_PROBLEM_OPENING_MISSES, "openings", 0);
  for (size_t i = 1; i < cutter->parts.count; i++) {
    QnBox part = qn_ring_bounds (&cutter->parts.items[i]);
    if (part.min.x < wall.min.x - margin || part.max.x > wall.max.x + margin
        || part.min.y < wall.min.y - margin || part.max.y > wall.max.y + margin)
      return qn_masonry_problem (diag, QN_PROBLEM_OPENING_OUTSIDE, "openings", 0);
  }
  return QN_OK;
}

/* Nothing of an opening may lie within another one, but two holes may share an edge. */
static QnStatus
check_apart (const Cutter *a, const Cutter *b, QnDiag *diag)
{
  if (!qn_box_meets_within (a->bounds, b->bounds, 0))
    return QN_OK;
  double size = fmin (qn_box_size (a->bounds), qn_box_size (b->bounds));
  g_auto (QnRings) common = { 0 };
  QnStatus status = QN_OK;
  for (size_t i = 0; i < a->parts.count && status == QN_OK; i++)
    for (size_t k = 0; k < b->parts.count && status == QN_OK; k++)
      if (qn_box_meets_within (qn_ring_bounds (&a->parts.items[i]),
                               qn_ring_bounds (&b->parts.items[k]), 0))
        status =
          qn_polygon_intersection (&a->parts.items[i], &b->parts.items[k], &common, diag);
  const double area = qn_rings_area (&common);
  if (status == QN_OK && area > OPENING_TOLERANCE * size * size)
    status = qn_masonry_problem (diag, QN_PROBLEM_OPENINGS_OVERLAP, "openings", area);
  return status;
}

/* Moves `unit` into `pieces`, cut by those cutters that reach it; takes their parts from `left_parts`,
 * how many may still be cut with. */
static QnStatus
cut_unit (QnPiece *unit, const Cutter *cutters, size_t cutter_count, size_t *left_parts,
          QnPieces *pieces, QnDiag *diag)
{
  QnBox bounds = qn_ring_bounds (&unit->ring);
  g_auto (QnRings) near = { 0 }, parts = { 0 };
  QnStatus status = QN_OK;
  for (size_t i = 0; unit->fabric && i < cutter_count; i++) {
    if (!qn_box_meets_within (bounds, cutters[i].bounds, 0))
      continue;
    for (size_t k = 0; k < cutters[i].parts.count && status == QN_OK; k++) {
      const QnRing *part = &cutters[i].parts.items[k];
      if (qn_box_meets_within (bounds, qn_ring_bounds (part), 0))
        qn_rings_add (&near, part->points, part->count);
      if (near.count > *left_parts)
        status = qn_masonry_problem (diag, QN_PROBLEM_TOO_MANY_BLOCKS, "openings", 0);
    }
  }
  *left_parts -= status == QN_OK ? near.count : 0;
  double whole = qn_ring_area (&unit->ring), left = whole;
  if (status == QN_OK && near.count > 0) {
    status = qn_polygon_difference (&unit->ring, &near, &parts, diag);
    left = qn_rings_area (&parts);
  }
  if (status == QN_OK && left < whole * (1 - OPENING_TOLERANCE * 1e-3)) {
    /* Nothing is left of it, one part of the same name, or several that are lettered. */
    for (size_t i = 0; i < parts.count; i++) {
      const QnRing *rest = &parts.items[i];
      QnPiece *piece =
        parts.count == 1 ? qn_pieces_add (pieces, qn_ring_of (rest->points, rest->count),
                                          "%s", unit->name)
        : i < 26 ? qn_pieces_add (pieces, qn_ring_of (rest->points, rest->count), "%s%c",
                                  unit->name, 'a' + (int) i)
                 : qn_pieces_add (pieces, qn_ring_of (rest->points, rest->count),
                                  "%s-%zu", unit->name, i + 1);
      qn_piece_inherit (piece, unit);
      piece->cut = true;
    }
  } else if (status == QN_OK)
    qn_pieces_take (pieces, unit);
  return status;
}

QnStatus
qn_openings_cut (const QnMasonry *masonry, QnBox wall, QnPieces *pieces, QnDiag *diag)
{
  size_t count = masonry->wall.opening_count;
  if (count == 0)
    return QN_OK;
  g_autofree Cutter *cutters = g_new0 (Cutter, count);
  g_auto (QnPieces) spans = { 0 }, cut = { 0 };
  size_t left_parts = MOST_PARTS + PARTS_PER_UNIT * pieces->count;
  QnStatus status = QN_OK;
  for (size_t i = 0; i < count && status == QN_OK; i++) {
    status = check_opening (&masonry->wall.openings[i], diag);
    if (status == QN_OK)
      make_cutter (masonry, i, &cutters[i], &spans);
    if (status == QN_OK)
      status = check_inside (&cutters[i], wall, diag);
    for (size_t k = 0; k < i && status == QN_OK; k++)
      status = check_apart (&cutters[k], &cutters[i], diag);
    if (status != QN_OK && diag != NULL)
      diag->sub = (QnId) i;
  }
  for (size_t i = 0; i < pieces->count && status == QN_OK; i++)
    status = cut_unit (&pieces->items[i], cutters, count, &left_parts, &cut, diag);
  for (size_t i = 0; i < spans.count && status == QN_OK; i++)
    qn_pieces_take (&cut, &spans.items[i]);
  if (status == QN_OK) {
    QnPieces swap = *pieces;
    *pieces = cut;
    cut = swap;
  }
  for (size_t i = 0; i < count; i++)
    qn_rings_clear (&cutters[i].parts);
  return status;
}
