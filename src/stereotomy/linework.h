/* Line work to polygons: a soup of segments, as drawings have it, becomes the faces it encloses. */
#pragma once

#include "stereotomy/weld.h"

typedef struct QnSegment {
  QnVec2 a, b; /* m */
} QnSegment;

typedef struct QnSegments {
  QnSegment *items;
  size_t count, capacity;
} QnSegments;

void qn_segments_add (QnSegments *segments, QnVec2 a, QnVec2 b);
void qn_segments_clear (QnSegments *segments);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnSegments, qn_segments_clear)

/* A tree of them, each grown by the margin, in memory of the pool. */
void qn_segments_tree (const QnSegments *segments, double margin, QnBoxTree *tree,
                       QnPool *pool);

/* Crossings of lines that are divided at, and pairs of lines whose boxes meet that are looked at: every
 * crossing is a corner of four faces, so that a soup of n lines may have n^2 of them. */
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION /* many teach a fuzzer nothing */
#define QN_MOST_CROSSINGS 2000
#else
#define QN_MOST_CROSSINGS 100000
#endif
#define QN_MOST_LINE_MEETINGS 20000000

/* Faces enclosed by the segments, appended to `faces` in a fixed order, counter-clockwise, without
 * collinear vertices. Ends within the tolerance of each other are welded (qn_weld_vertices());
 * an end that stops short of another segment by no more is prolonged to meet it; what
 * overruns or dangles is dropped. Segments may cross, overlap and repeat. A face around other
 * faces is left out and counted in `holes` (nullable). Refuses TOO_MANY_CROSSINGS. Changes the
 * segments. */
QnStatus qn_linework_polygonize (QnSegments *segments, double tolerance, QnRings *faces,
                                 size_t *holes, QnHealing *healing, QnDiag *diag);
