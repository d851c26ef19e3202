/* Piers with lintels or arches between them. */
#include "core/base/memory.h"
#include "stereotomy/arch-ring.h"
#include "stereotomy/masonry-parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool
check_backing (const QnPortal *portal, QnSubject of)
{
  QnArchRing ring;
  qn_arch_ring_init (&ring, &portal->arch);
  return qn_require_length (of, "backing", portal->backing, QN_RANGE_NOT_NEGATIVE)
         && qn_require (of,
                        portal->backing == 0
                          || (portal->backing > qn_arch_ring_extrados (&ring, 0).y
                              && portal->backing < qn_arch_ring_extrados (&ring, 0.5).y),
                        QN_PROBLEM_BACKING_TOO_HIGH, "backing", portal->backing);
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
    && qn_require (of, pieces <= QN_MAX_PIECES, QN_PROBLEM_TOO_MANY_BLOCKS, "bays", bays)
    && (portal->lintel_height > 0
        || (qn_arch_check (arch, diag) == QN_OK
            && qn_require (of, 2 * arch->ring <= portal->pier_width * (1 + 1e-12),
                           QN_PROBLEM_PIER_TOO_NARROW, "pier", portal->pier_width)
            && check_backing (portal, of))));
}

static double
pier_left (const QnPortal *portal, int32_t pier)
{
  return pier * (portal->span + portal->pier_width);
}

static QnStatus
lay_pier (const QnMasonry *masonry, int32_t pier, QnPieces *pieces, QnDiag *diag)
{
  const QnPortal *portal = &masonry->portal;
  double x0 = pier_left (portal, pier), x1 = x0 + portal->pier_width;
  QnVec2 corners[4];
  if (masonry->foundation > 0) {
    qn_rectangle (x0, -masonry->foundation, x1, 0, corners);
    QnPiece *base =
      qn_pieces_add (pieces, corners, 4, "%s.base%d", masonry->name, pier + 1);
    if (base == NULL)
      return qn_diag_no_memory (diag);
    base->fixed = true;
  }
  for (int32_t i = 0; i < portal->courses; i++) {
    double y0 = portal->pier_height * i / portal->courses;
    double y1 = portal->pier_height * (i + 1) / portal->courses;
    qn_rectangle (x0, y0, x1, y1, corners);
    if (qn_pieces_add (pieces, corners, 4, "%s.pier%d.%d", masonry->name, pier + 1, i + 1)
        == NULL)
      return qn_diag_no_memory (diag);
  }
  return QN_OK;
}

static QnStatus
lay_lintel (const QnMasonry *masonry, int32_t bay, QnPieces *pieces, QnDiag *diag)
{
  const QnPortal *portal = &masonry->portal;
  double left = pier_left (portal, bay), right = pier_left (portal, bay + 1);
  double x0 = bay == 0 ? left : left + portal->pier_width / 2;
  double x1 =
    bay + 1 == portal->bays ? right + portal->pier_width : right + portal->pier_width / 2;
  QnVec2 corners[4];
  qn_rectangle (x0, portal->pier_height, x1, portal->pier_height + portal->lintel_height,
                corners);
  return qn_pieces_add (pieces, corners, 4, "%s.lintel%d", masonry->name, bay + 1) != NULL
           ? QN_OK
           : qn_diag_no_memory (diag);
}

/* Where joints at the springing lean, a block on the pier fills the wedge below them. */
static QnStatus
lay_skewback (const QnMasonry *masonry, const QnArchRing *ring, int32_t pier,
              QnPieces *pieces, QnDiag *diag)
{
  const QnPortal *portal = &masonry->portal;
  double x0 = pier_left (portal, pier), x1 = x0 + portal->pier_width;
  double y = portal->pier_height;
  QnVec2 lean = qn_arch_ring_extrados (ring, 0);
  if (lean.y <= 1e-9 * portal->arch.ring)
    return QN_OK;
  double top = y + lean.y;
  const QnVec2 corners[] = { { x0, y },
                             { x1, y },
                             { pier < portal->bays ? x1 + lean.x : x1, top },
                             { pier > 0 ? x0 - lean.x : x0, top } };
  QnRing block;
  if (!qn_ring_init (&block, corners, 4))
    return qn_diag_no_memory (diag);
  qn_ring_simplify (&block, 1e-9 * portal->pier_width);
  QnPiece *piece = qn_pieces_add (pieces, block.points, block.count, "%s.skewback%d",
                                  masonry->name, pier + 1);
  qn_ring_clear (&block);
  return piece != NULL ? QN_OK : qn_diag_no_memory (diag);
}

/* What fills the space between the arches above a pier, up to a level. */
static QnStatus
lay_backing (const QnMasonry *masonry, const QnArchRing *ring, int32_t pier,
             QnPieces *pieces, QnDiag *diag)
{
  const QnPortal *portal = &masonry->portal;
  double x[] = { pier_left (portal, pier),
                 pier_left (portal, pier) + portal->pier_width };
  QnRing line, block;
  if (!qn_arch_ring_haunch (ring, portal->backing, &line))
    return qn_diag_no_memory (diag);
  size_t count = line.count;
  block.points = qn_alloc (2 * count + 2, sizeof *block.points);
  block.count = 0;
  /* Right of the pier from below, then left of it from above; an end is upright. */
  for (size_t k = 0; k < 2 * count && block.points != NULL; k++) {
    bool right = k < count;
    QnVec2 p = line.points[right ? k : 2 * count - 1 - k];
    if (right ? pier == portal->bays : pier == 0)
      p.x = 0;
    block.points[block.count++] =
      qn_vec2 (right ? x[1] + p.x : x[0] - p.x, portal->pier_height + p.y);
  }
  qn_ring_clear (&line);
  if (block.points == NULL)
    return qn_diag_no_memory (diag);
  qn_ring_simplify (&block, 1e-9 * portal->pier_width);
  QnPiece *piece = qn_pieces_add (pieces, block.points, block.count, "%s.backing%d",
                                  masonry->name, pier + 1);
  qn_ring_clear (&block);
  return piece != NULL ? QN_OK : qn_diag_no_memory (diag);
}

static QnStatus
lay_arch (const QnMasonry *masonry, int32_t bay, QnPieces *pieces, QnDiag *diag)
{
  const QnPortal *portal = &masonry->portal;
  size_t size = strlen (masonry->name) + 24;
  char *prefix = qn_alloc (size, 1);
  if (prefix == NULL)
    return qn_diag_no_memory (diag);
  snprintf (prefix, size, "%s.arch%d", masonry->name, bay + 1);
  QnVec2 at = { pier_left (portal, bay) + portal->pier_width, portal->pier_height };
  QnStatus status = qn_arch_lay_ring (&portal->arch, at, prefix, pieces, diag);
  free (prefix);
  return status;
}

QnStatus
qn_masonry_lay_portal (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  /* The arches' span is the portal's. */
  QnMasonry own = *masonry;
  QnPortal *portal = &own.portal;
  portal->arch.span = portal->span;
  portal->arch.springer = 0;
  QnStatus status = check_portal (portal, diag);
  for (int32_t i = 0; i <= portal->bays && status == QN_OK; i++)
    status = lay_pier (&own, i, pieces, diag);
  if (status != QN_OK)
    return status;

  bool arches = portal->lintel_height == 0;
  QnArchRing ring;
  if (arches)
    qn_arch_ring_init (&ring, &portal->arch);
  for (int32_t i = 0; arches && i <= portal->bays && status == QN_OK; i++) {
    status = lay_skewback (&own, &ring, i, pieces, diag);
    if (status == QN_OK && portal->backing > 0)
      status = lay_backing (&own, &ring, i, pieces, diag);
  }
  for (int32_t i = 0; i < portal->bays && status == QN_OK; i++)
    status =
      arches ? lay_arch (&own, i, pieces, diag) : lay_lintel (&own, i, pieces, diag);
  return status;
}
