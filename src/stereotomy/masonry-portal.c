/* Piers with lintels or arches between them. */
#include "stereotomy/arch-ring.h"
#include "stereotomy/masonry-parts.h"

#include <math.h>

/* A number of a bay or pier: its own, or the usual one. */
static double
own (const double *numbers, int32_t i, double usual)
{
  return i < QN_MOST_UNEQUAL && numbers[i] > 0 ? numbers[i] : usual;
}

static double
pier_width (const QnPortal *portal, int32_t pier)
{
  return own (portal->piers, pier, portal->pier_width);
}

static QnArch
arch_of (const QnPortal *portal, int32_t bay)
{
  QnArch arch = portal->arch;
  arch.span = own (portal->spans, bay, portal->span);
  arch.rise = own (portal->rises, bay, arch.rise);
  arch.ring = own (portal->rings, bay, arch.ring);
  return arch;
}

/* The rings of the bays to the left and to the right of a pier; at an end the one that is there, twice. */
static void
rings_at (const QnPortal *portal, int32_t pier, QnArchRing rings[2])
{
  for (int side = 0; side < 2; side++) {
    int32_t bay = pier - 1 + side;
    const QnArch arch = arch_of (portal, bay < 0              ? 0
                                         : bay < portal->bays ? bay
                                                              : portal->bays - 1);
    qn_arch_ring_init (&rings[side], &arch);
  }
}

static bool
check_bays (const QnPortal *portal, QnSubject of, QnDiag *diag)
{
  for (int32_t i = 0; i < portal->bays; i++) {
    const QnArch arch = arch_of (portal, i);
    if (!qn_require_length (of, "spans", arch.span, QN_RANGE_POSITIVE)
        || (portal->lintel_height == 0 && qn_arch_check (&arch, diag) != QN_OK))
      return false;
  }
  for (int32_t i = 0; i <= portal->bays; i++) {
    QnArchRing rings[2];
    const double width = pier_width (portal, i);
    if (!qn_require_length (of, "piers", width, QN_RANGE_POSITIVE))
      return false;
    if (portal->lintel_height > 0)
      continue;
    rings_at (portal, i, rings);
    if (!qn_require (of, rings[0].arch.ring + rings[1].arch.ring <= width * (1 + 1e-12),
                     QN_PROBLEM_PIER_TOO_NARROW, "pier", width))
      return false;
    for (int side = 0; side < 2 && portal->backing > 0; side++)
      if (!qn_require (of,
                       portal->backing > qn_arch_ring_extrados (&rings[side], 0).y
                         && portal->backing < qn_arch_ring_extrados (&rings[side], 0.5).y,
                       QN_PROBLEM_BACKING_TOO_HIGH, "backing", portal->backing))
        return false;
  }
  return true;
}

static QnStatus
check_portal (const QnPortal *portal, QnDiag *diag)
{
  const QnSubject of = qn_masonry_subject (diag);
  const QnArch *arch = &portal->arch;
  const double bays = portal->bays,
               pieces = (bays + 1) * (portal->courses + 2.0)
                        + bays * arch->voussoirs * qn_arch_rings (arch);
  return qn_required (
    qn_require_pieces (of, "bays", portal->bays, 1)
    && qn_require_pieces (of, "courses", portal->courses, 1)
    && qn_require_length (of, "span", portal->span, QN_RANGE_POSITIVE)
    && qn_require_length (of, "pier", portal->pier_width, QN_RANGE_POSITIVE)
    && qn_require_length (of, "pier", portal->pier_height, QN_RANGE_POSITIVE)
    && qn_require_length (of, "lintel", portal->lintel_height, QN_RANGE_NOT_NEGATIVE)
    && qn_require_length (of, "backing", portal->backing, QN_RANGE_NOT_NEGATIVE)
    && qn_require (of, pieces <= QN_MAX_PIECES, QN_PROBLEM_TOO_MANY_BLOCKS, "bays", bays)
    && check_bays (portal, of, diag));
}

static double
pier_left (const QnPortal *portal, int32_t pier)
{
  double x = pier * (portal->span + portal->pier_width);
  for (int32_t i = 0; i < pier && i < QN_MOST_UNEQUAL; i++)
    x += own (portal->spans, i, portal->span) - portal->span + pier_width (portal, i)
         - portal->pier_width;
  return x;
}

static void
lay_lintel (const QnMasonry *masonry, int32_t bay, QnPieces *pieces)
{
  const QnPortal *portal = &masonry->portal;
  double left = pier_left (portal, bay), right = pier_left (portal, bay + 1);
  double x0 = bay == 0 ? left : left + pier_width (portal, bay) / 2;
  double x1 = right + pier_width (portal, bay + 1) / (bay + 1 == portal->bays ? 1 : 2);
  qn_pieces_add (pieces,
                 qn_rectangle (x0, portal->pier_height, x1,
                               portal->pier_height + portal->lintel_height),
                 "%s.lintel%d", masonry->name, bay + 1);
}

/* Where joints at the springing lean, a block on the pier fills the wedge below them. */
static void
lay_skewback (const QnMasonry *masonry, const QnArchRing rings[2], int32_t pier,
              QnPieces *pieces)
{
  const QnPortal *portal = &masonry->portal;
  double x0 = pier_left (portal, pier), x1 = x0 + pier_width (portal, pier);
  double y = portal->pier_height;
  QnVec2 left = qn_arch_ring_extrados (&rings[0], 0);
  QnVec2 right = qn_arch_ring_extrados (&rings[1], 0);
  if (fmax (left.y, right.y) <= 1e-9 * portal->arch.ring)
    return;
  const QnVec2 corners[] = { { x0, y },
                             { x1, y },
                             { pier < portal->bays ? x1 + right.x : x1, y + right.y },
                             { pier > 0 ? x0 - left.x : x0, y + left.y } };
  QnRing block = qn_ring_of (corners, 4);
  qn_ring_simplify (&block, 1e-9 * portal->pier_width);
  qn_pieces_add (pieces, block, "%s.skewback%d", masonry->name, pier + 1);
}

/* Filling between the arches above a pier, up to a level. */
static void
lay_backing (const QnMasonry *masonry, const QnArchRing rings[2], int32_t pier,
             QnPieces *pieces)
{
  const QnPortal *portal = &masonry->portal;
  double x[] = { pier_left (portal, pier),
                 pier_left (portal, pier) + pier_width (portal, pier) };
  g_auto (QnRing) left = qn_arch_ring_line (&rings[0], true, portal->backing);
  g_auto (QnRing) right = qn_arch_ring_line (&rings[1], true, portal->backing);
  const size_t all = right.count + left.count;
  QnRing block = { g_new (QnVec2, all), 0 };
  /* Right of the pier from below, then left of it from above; an end is upright. */
  for (size_t k = 0; k < all; k++) {
    bool ahead = k < right.count;
    QnVec2 p = ahead ? right.points[k] : left.points[all - 1 - k];
    if (ahead ? pier == portal->bays : pier == 0)
      p.x = 0;
    block.points[block.count++] =
      qn_vec2 (ahead ? x[1] + p.x : x[0] - p.x, portal->pier_height + p.y);
  }
  qn_ring_simplify (&block, 1e-9 * portal->pier_width);
  qn_pieces_add (pieces, block, "%s.backing%d", masonry->name, pier + 1);
}

QnStatus
qn_masonry_lay_portal (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  /* The arches' span is the portal's. */
  QnMasonry laid = *masonry;
  QnPortal *portal = &laid.portal;
  portal->arch.span = portal->span;
  portal->arch.springer = 0;
  QnStatus status = check_portal (portal, diag);
  if (status != QN_OK)
    return status;
  for (int32_t i = 0; i <= portal->bays; i++) {
    double x0 = pier_left (portal, i), x1 = x0 + pier_width (portal, i);
    if (laid.foundation > 0)
      qn_pieces_add (pieces, qn_rectangle (x0, -laid.foundation, x1, 0), "%s.base%d",
                     laid.name, i + 1)
        ->fixed = true;
    for (int32_t k = 0; k < portal->courses; k++) {
      double y0 = portal->pier_height * k / portal->courses;
      double y1 = portal->pier_height * (k + 1) / portal->courses;
      qn_pieces_add (pieces, qn_rectangle (x0, y0, x1, y1), "%s.pier%d.%d", laid.name,
                     i + 1, k + 1);
    }
  }
  bool arches = portal->lintel_height == 0;
  for (int32_t i = 0; arches && i <= portal->bays; i++) {
    QnArchRing rings[2];
    rings_at (portal, i, rings);
    lay_skewback (&laid, rings, i, pieces);
    if (portal->backing > 0)
      lay_backing (&laid, rings, i, pieces);
  }
  for (int32_t i = 0; i < portal->bays; i++)
    if (arches) {
      g_autofree char *prefix = g_strdup_printf ("%s.arch%d", laid.name, i + 1);
      const QnArch arch = arch_of (portal, i);
      QnVec2 at = { pier_left (portal, i) + pier_width (portal, i), portal->pier_height };
      qn_arch_lay_ring (&arch, at, prefix, pieces);
    } else
      lay_lintel (&laid, i, pieces);
  return QN_OK;
}
