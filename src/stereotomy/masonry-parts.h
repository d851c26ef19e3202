/* The makers of the kinds of masonry; each fills `pieces` in the object's own frame and reports
 * bad parameters with the key concerned. Private to this layer. */
#pragma once

#include "core/base/numbers.h"
#include "core/base/require.h"
#include "stereotomy/masonry.h"
#include "stereotomy/pieces.h"

/* Most pieces of one object. */
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION /* a large wall teaches a fuzzer nothing */
#define QN_MAX_PIECES 1000
#else
#define QN_MAX_PIECES 200000
#endif

QnStatus qn_masonry_lay_wall (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag);
QnStatus qn_masonry_lay_arch (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag);
QnStatus qn_masonry_lay_column (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag);
QnStatus qn_masonry_lay_buttress (const QnMasonry *masonry, QnPieces *pieces,
                                  QnDiag *diag);
QnStatus qn_masonry_lay_portal (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag);
QnStatus qn_masonry_lay_rubble (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag);

/* What the openings of a wall cut away and put in. */
QnStatus qn_openings_cut (const QnMasonry *masonry, QnBox wall, QnPieces *pieces,
                          QnDiag *diag);

/* A number that breaks a rule: QN_ERROR_INVALID at `field`. The callers fill in the object's
 * index. */
QnStatus qn_masonry_problem (QnDiag *diag, QnProblem problem, const char *field,
                             double value);

/* Rules of an object (core/base/require.h): a length keeps its range and the limit of coordinates, a
 * count is from `least` to the most pieces. */
static inline QnSubject
qn_masonry_subject (QnDiag *diag)
{
  return (QnSubject){ QN_ENTITY_MASONRY, QN_NONE, diag };
}
bool qn_require_length (QnSubject of, const char *field, double value, QnRange range);
bool qn_require_pieces (QnSubject of, const char *field, int32_t value, int32_t least);

/* Pieces of straight-sided or curved rings of voussoirs named as masonry.h says, the left springing
 * at `at`; see arch-ring.h. */
QnStatus qn_arch_check (const QnArch *arch, QnDiag *diag);
void qn_arch_lay_ring (const QnArch *arch, QnVec2 at, const char *prefix,
                       QnPieces *pieces);

/* Joints that are not quite where the drawing has them: moves corners that pieces share as one, at random
 * (perturbation.c); size: 0 to QN_MAX_PERTURBATION. */
void qn_pieces_perturb (double size, uint32_t seed, QnPieces *pieces);

/* A number in [-1, 1) that depends on a seed and a place alone, whatever the size of the object. */
double qn_noise (uint32_t seed, uint32_t a, uint32_t b, uint32_t direction);
