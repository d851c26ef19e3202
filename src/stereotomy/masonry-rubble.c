/* Rubble: a seeded Voronoi tessellation, its short edges closed, within a trapezium. */
#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "stereotomy/geos.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

/* Edges shorter than this part of a stone are closed: no mason leaves them, and contact
 * detection would have to tell them from points. */
#define SHORT_EDGE 0.12

/* How often that length is halved where closing spoils a stone. */
#define CLOSING_ROUNDS 8

/* How often sites are moved to the centroids of their cells. */
#define RELAXING_ROUNDS 10

/* Courses are lower than stones are long, as they lie. */
#define FLATNESS 0.75

/* A number in [-1, 1) for each stone and direction, whatever the size of the wall. */
static double
noise (const QnRubble *rubble, int32_t row, int32_t column, uint32_t direction)
{
  return qn_noise (rubble->seed, (uint32_t) row, (uint32_t) column, direction);
}

static QnStatus
check_rubble (const QnRubble *rubble, QnDiag *diag)
{
  const QnSubject of = qn_masonry_subject (diag);
  /* There is one stone in a row and one row at least, however flat or narrow. */
  const double pieces = fmax (1, fmax (rubble->width, rubble->top) / rubble->stone)
                        * fmax (1, rubble->height / (FLATNESS * rubble->stone));
  const bool cells = rubble->relaxed;
  const char *stone = cells ? "cell" : "stone", *width = cells ? "size" : "width";
  return qn_required (
    qn_require_length (of, width, rubble->width, QN_RANGE_POSITIVE)
    && qn_require_length (of, width, rubble->top, QN_RANGE_POSITIVE)
    && qn_require_length (of, cells ? "size" : "height", rubble->height,
                          QN_RANGE_POSITIVE)
    && qn_require_length (of, stone, rubble->stone, QN_RANGE_POSITIVE)
    && qn_require (of, rubble->irregularity >= 0 && rubble->irregularity <= 1,
                   QN_PROBLEM_FRACTION, "irregularity", rubble->irregularity)
    && qn_require (of, pieces <= QN_MAX_PIECES, QN_PROBLEM_TOO_MANY_BLOCKS, stone,
                   rubble->stone));
}

static double
half_width (const QnRubble *rubble, double y)
{
  return (rubble->width + (rubble->top - rubble->width) * y / rubble->height) / 2;
}

/* The number of rows, and of stones in the row whose middle is at y. */
static int32_t
row_count (const QnRubble *rubble)
{
  double height = rubble->stone * (rubble->relaxed ? 1 : FLATNESS);
  return (int32_t) qn_to_integer (round (rubble->height / height), 1, QN_MAX_BLOCKS);
}

static int32_t
column_count (const QnRubble *rubble, double y)
{
  return (int32_t) qn_to_integer (round (2 * half_width (rubble, y) / rubble->stone), 1,
                                  QN_MAX_BLOCKS);
}

/* Site of a stone: rows of equal height, stones of equal length, every other row shifted, all
 * moved by the noise. */
static QnVec2
site_at (const QnRubble *rubble, int32_t row, int32_t column)
{
  double height = rubble->height / row_count (rubble), y = (row + 0.5) * height;
  int32_t columns = column_count (rubble, y);
  double half = half_width (rubble, y), length = 2 * half / columns;
  double shift = columns > 1 ? (row % 2 == 0 ? 0.25 : -0.25) : 0;
  double stray = rubble->relaxed ? 1 : 0.35 * rubble->irregularity;
  double x = rubble->width / 2 - half + (column + 0.5 + shift / 2) * length
             + stray * length * noise (rubble, row, column, 0);
  y += stray * height * noise (rubble, row, column, 1);
  if (rubble->relaxed) { /* those that have strayed beyond the outline */
    x = fmin (fmax (x, 0.1 * length), rubble->width - 0.1 * length);
    y = fmin (fmax (y, 0.1 * height), rubble->height - 0.1 * height);
  }
  return qn_vec2 (x, y);
}

/* The sites of all stones, row by row. */
static QnVec2 *
lay_sites (const QnRubble *rubble, size_t *count)
{
  int32_t rows = row_count (rubble);
  size_t total = 0, i = 0;
  for (int32_t row = 0; row < rows; row++)
    total += (size_t) column_count (rubble, (row + 0.5) * rubble->height / rows);
  QnVec2 *sites = g_new (QnVec2, total);
  for (int32_t row = 0; row < rows; row++) {
    int32_t columns = column_count (rubble, (row + 0.5) * rubble->height / rows);
    for (int32_t column = 0; column < columns; column++)
      sites[i++] = site_at (rubble, row, column);
  }
  *count = total;
  return sites;
}

/* All cells, in no particular order, clipped to nothing yet. */
static QnStatus
divide (const QnVec2 *sites, size_t count, const QnRing *outline, QnRings *cells,
        QnDiag *diag)
{
  if (count == 1) {
    qn_rings_add (cells, outline->points, outline->count);
    return QN_OK;
  }
  g_autoptr (GEOSGeometry) line = qn_geos_line (sites, count);
  g_autoptr (GEOSGeometry) frame = qn_geos_polygon (outline->points, outline->count);
  g_autoptr (GEOSGeometry) diagram = GEOSVoronoiDiagram_r (qn_geos (), line, frame, 0, 0);
  if (diagram == NULL)
    return qn_geos_failed (diag);
  qn_geos_read_polygons (diagram, cells, NULL);
  return QN_OK;
}

/* Index of the cell around a site, or QN_NONE. */
static QnId
cell_of (const QnRings *cells, const QnBoxTree *tree, QnVec2 site)
{
  QnBoxQuery query = qn_box_tree_query (tree, (QnBox){ site, site });
  for (QnId i; (i = qn_box_query_next (&query)) != QN_NONE;) {
    const QnRing *cell = &cells->items[i];
    if (qn_polygon_depth (cell->points, cell->count, site) >= 0)
      return i;
  }
  return QN_NONE;
}

/* The cell of every site within the outline, in the order of the sites; without points where there
 * is none. */
static QnStatus
tessellate (const QnVec2 *sites, size_t count, const QnRing *outline, QnRing *stones,
            QnDiag *diag)
{
  g_auto (QnRings) cells = { 0 };
  g_auto (QnPool) room = { 0 };
  QnBoxTree tree;
  QnStatus status = divide (sites, count, outline, &cells, diag);
  qn_rings_tree (&cells, 0, &tree, &room);
  for (size_t i = 0; i < count && status == QN_OK; i++) {
    QnId cell = cell_of (&cells, &tree, sites[i]);
    g_auto (QnRings) parts = { 0 };
    if (cell != QN_NONE)
      status = qn_polygon_intersection (&cells.items[cell], outline, &parts, diag);
    if (status == QN_OK && parts.count > 0) {
      stones[i] = parts.items[0];
      parts.items[0] = (QnRing){ 0 };
    }
  }
  return status;
}

static void
clear_stones (QnRing *stones, size_t count)
{
  for (size_t i = 0; i < count; i++)
    qn_ring_clear (&stones[i]);
}

/* Moves every site to the centroid of its cell (S. Lloyd, Least squares quantization in PCM, IEEE
 * Transactions on Information Theory 28 (1982) 129-137). */
static QnStatus
relax (QnVec2 *sites, size_t count, const QnRing *outline, QnRing *stones, QnDiag *diag)
{
  QnStatus status = QN_OK;
  for (int round = 0; round < RELAXING_ROUNDS && status == QN_OK; round++) {
    clear_stones (stones, count);
    status = tessellate (sites, count, outline, stones, diag);
    for (size_t i = 0; i < count && status == QN_OK; i++)
      if (stones[i].count > 0)
        sites[i] = qn_ring_centroid (&stones[i]);
  }
  clear_stones (stones, count);
  return status;
}

/* Names the stones by row and column. */
static void
name_stones (const QnMasonry *masonry, const QnRing *stones, QnPieces *pieces)
{
  const QnRubble *rubble = &masonry->rubble;
  int32_t rows = row_count (rubble);
  for (int32_t row = 0; row < rows; row++) {
    int32_t columns = column_count (rubble, (row + 0.5) * rubble->height / rows);
    for (int32_t column = 0; column < columns; column++, stones++)
      if (stones->count > 0)
        qn_pieces_add (pieces, qn_ring_of (stones->points, stones->count), "%s.%d.%d",
                       masonry->name, row + 1, column + 1);
  }
}

static QnStatus
lay_stones (const QnMasonry *masonry, const QnRing *outline, QnPieces *pieces,
            QnDiag *diag)
{
  size_t count;
  g_autofree QnVec2 *sites = lay_sites (&masonry->rubble, &count);
  g_autofree QnRing *stones = g_new0 (QnRing, count);
  QnStatus status = QN_OK;
  if (masonry->rubble.relaxed)
    status = relax (sites, count, outline, stones, diag);
  if (status == QN_OK)
    status = tessellate (sites, count, outline, stones, diag);
  if (status == QN_OK)
    name_stones (masonry, stones, pieces);
  clear_stones (stones, count);
  return status;
}

/* Closes short edges; where that would spoil a stone, closes only shorter ones. */
static void
close_short_edges (QnPieces *pieces, double length, const QnRing *outline)
{
  bool sound = false;
  for (int round = 0; round < CLOSING_ROUNDS && !sound; round++, length /= 2) {
    g_auto (QnRings) rings = { 0 };
    for (size_t i = 0; i < pieces->count; i++)
      qn_rings_add (&rings, pieces->items[i].ring.points, pieces->items[i].ring.count);
    qn_weld_vertices (&rings, 0, length, outline, NULL);
    sound = true;
    for (size_t i = 0; i < rings.count && sound; i++)
      sound = qn_ring_check (&rings.items[i], 0, NULL) == QN_OK;
    for (size_t i = 0; i < rings.count && sound; i++) {
      QnRing swap = pieces->items[i].ring;
      pieces->items[i].ring = rings.items[i];
      rings.items[i] = swap;
    }
  }
}

QnStatus
qn_masonry_lay_rubble (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnRubble *rubble = &masonry->rubble;
  QnStatus status = check_rubble (rubble, diag);
  if (status != QN_OK)
    return status;
  double middle = rubble->width / 2, top = rubble->top / 2;
  QnVec2 corners[] = { { 0, 0 },
                       { rubble->width, 0 },
                       { middle + top, rubble->height },
                       { middle - top, rubble->height } };
  const QnRing outline = { corners, 4 };
  status = lay_stones (masonry, &outline, pieces, diag);
  if (status == QN_OK)
    close_short_edges (pieces, SHORT_EDGE * rubble->stone, &outline);
  if (status == QN_OK && masonry->foundation > 0)
    qn_pieces_add (pieces, qn_rectangle (0, -masonry->foundation, rubble->width, 0),
                   "%s.base", masonry->name)
      ->fixed = true;
  return status;
}
