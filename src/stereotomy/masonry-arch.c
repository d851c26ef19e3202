#include "stereotomy/arch-ring.h"
#include "stereotomy/masonry-parts.h"

QnStatus
qn_arch_check (const QnArch *arch, QnDiag *diag)
{
  const QnSubject of = qn_masonry_subject (diag);
  double half = arch->span / 2;
  bool fits = arch->shape == QN_ARCH_CIRCULAR  ? arch->rise <= half * (1 + 1e-12)
              : arch->shape == QN_ARCH_POINTED ? arch->rise > half * (1 + 1e-12)
              : arch->shape == QN_ARCH_THREE_CENTRED
                ? arch->rise < half && qn_arch_haunch (arch) > 0
                : true;
  /* Flatter or steeper than this, the curve is a straight line in double precision. */
  fits = fits && arch->rise >= 1e-6 * arch->span && arch->rise <= 1e6 * arch->span
         && arch->ring <= 1e6 * arch->span;
  return qn_required (
    qn_require_length (of, "span", arch->span, QN_RANGE_POSITIVE)
    && qn_require_length (of, "rise", arch->rise, QN_RANGE_POSITIVE)
    && qn_require_length (of, "ring", arch->ring, QN_RANGE_POSITIVE)
    && qn_require_pieces (of, "voussoirs", arch->voussoirs, 2)
    && qn_require_pieces (of, "rings", qn_arch_rings (arch), 1)
    && qn_require (of, arch->shape != QN_ARCH_POINTED || qn_arch_rings (arch) == 1,
                   QN_PROBLEM_POINTED_RINGS, "rings", arch->rings)
    && qn_require (of, (double) arch->voussoirs * qn_arch_rings (arch) <= QN_MAX_PIECES,
                   QN_PROBLEM_TOO_MANY_BLOCKS, "rings", arch->rings)
    && qn_require_length (of, "haunch", arch->haunch, QN_RANGE_NOT_NEGATIVE)
    && qn_require (of, arch->shape != QN_ARCH_THREE_CENTRED || arch->haunch < arch->rise,
                   QN_PROBLEM_ARCH_SHAPE, "haunch", arch->haunch)
    && qn_require_length (of, "springer", arch->springer, QN_RANGE_NOT_NEGATIVE)
    && qn_require (of, fits, QN_PROBLEM_ARCH_SHAPE, "rise", arch->rise));
}

QnStatus
qn_arch_lay_ring (const QnArch *arch, QnVec2 at, const char *prefix, QnPieces *pieces,
                  QnDiag *diag)
{
  QnArchRing ring;
  qn_arch_ring_init (&ring, arch);
  int32_t rings = qn_arch_rings (arch);
  for (int32_t r = 0; r < rings; r++)
    for (int32_t i = 0; i < arch->voussoirs; i++) {
      QnRing voussoir;
      if (!qn_arch_ring_voussoir (&ring, r, i, &voussoir))
        return qn_diag_no_memory (diag);
      for (size_t k = 0; k < voussoir.count; k++)
        voussoir.points[k] = qn_vec2_add (at, voussoir.points[k]);
      QnPiece *piece = r == 0 ? qn_pieces_add (pieces, voussoir.points, voussoir.count,
                                               "%s.v%d", prefix, i + 1)
                              : qn_pieces_add (pieces, voussoir.points, voussoir.count,
                                               "%s.r%d.v%d", prefix, r + 1, i + 1);
      qn_ring_clear (&voussoir);
      if (piece == NULL)
        return qn_diag_no_memory (diag);
      piece->ring_number = rings > 1 ? r + 1 : 0;
    }
  return QN_OK;
}

/* The block between the springing joint from `in` (intrados) to `out` and the level y. */
static QnStatus
lay_springer (const QnMasonry *masonry, QnVec2 in, QnVec2 out, double y, const char *part,
              const char *side, bool fixed, QnPieces *pieces, QnDiag *diag)
{
  QnRing ring;
  const QnVec2 corners[] = { in, out, { out.x, y }, { in.x, y } };
  if (!qn_ring_init (&ring, corners, 4))
    return qn_diag_no_memory (diag);
  qn_ring_orient (&ring);
  QnPiece *piece = qn_pieces_add (pieces, ring.points, ring.count, "%s.%s.%s",
                                  masonry->name, part, side);
  qn_ring_clear (&ring);
  if (piece == NULL)
    return qn_diag_no_memory (diag);
  piece->fixed = fixed;
  return QN_OK;
}

QnStatus
qn_masonry_lay_arch (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnArch *arch = &masonry->arch;
  QnStatus status = qn_arch_check (arch, diag);
  if (status != QN_OK)
    return status;
  QnArchRing ring;
  qn_arch_ring_init (&ring, arch);
  for (int i = 0; i < 2 && status == QN_OK; i++) {
    const char *side = i == 0 ? "left" : "right";
    QnVec2 in = qn_arch_ring_intrados (&ring, i), out = qn_arch_ring_extrados (&ring, i);
    double y = -arch->springer;
    if (arch->springer > 0)
      status = lay_springer (masonry, in, out, y, "springer", side, false, pieces, diag);
    if (arch->springer > 0) {
      in.y = y;
      out.y = y;
    }
    if (status == QN_OK && masonry->foundation > 0)
      status = lay_springer (masonry, in, out, y - masonry->foundation, "base", side,
                             true, pieces, diag);
  }
  if (status == QN_OK)
    status = qn_arch_lay_ring (arch, qn_vec2 (0, 0), masonry->name, pieces, diag);
  return status;
}
