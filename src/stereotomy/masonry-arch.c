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

void
qn_arch_lay_ring (const QnArch *arch, QnVec2 at, const char *prefix, QnPieces *pieces)
{
  QnArchRing ring;
  qn_arch_ring_init (&ring, arch);
  int32_t rings = qn_arch_rings (arch);
  for (int32_t r = 0; r < rings; r++)
    for (int32_t i = 0; i < arch->voussoirs; i++) {
      QnRing voussoir = qn_arch_ring_voussoir (&ring, r, i);
      for (size_t k = 0; k < voussoir.count; k++)
        voussoir.points[k] = qn_vec2_add (at, voussoir.points[k]);
      QnPiece *piece =
        r == 0 ? qn_pieces_add (pieces, voussoir, "%s.v%d", prefix, i + 1)
               : qn_pieces_add (pieces, voussoir, "%s.r%d.v%d", prefix, r + 1, i + 1);
      piece->ring_number = rings > 1 ? r + 1 : 0;
    }
}

/* The block between the springing joint from `in` (intrados) to `out` and the level y. */
static QnPiece *
lay_springer (const QnMasonry *masonry, QnVec2 in, QnVec2 out, double y, const char *part,
              const char *side, QnPieces *pieces)
{
  const QnVec2 corners[] = { in, out, { out.x, y }, { in.x, y } };
  QnRing ring = qn_ring_of (corners, 4);
  qn_ring_orient (&ring);
  return qn_pieces_add (pieces, ring, "%s.%s.%s", masonry->name, part, side);
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
  for (int i = 0; i < 2; i++) {
    const char *side = i == 0 ? "left" : "right";
    QnVec2 in = qn_arch_ring_point (&ring, i, 0), out = qn_arch_ring_extrados (&ring, i);
    double y = -arch->springer;
    if (arch->springer > 0) {
      lay_springer (masonry, in, out, y, "springer", side, pieces);
      in.y = out.y = y;
    }
    if (masonry->foundation > 0)
      lay_springer (masonry, in, out, y - masonry->foundation, "base", side, pieces)
        ->fixed = true;
  }
  qn_arch_lay_ring (arch, qn_vec2 (0, 0), masonry->name, pieces);
  return QN_OK;
}
