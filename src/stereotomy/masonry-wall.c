/* Walls: the units of every leaf course by course, what the openings leave of them (opening.c), the minimum piece
 * rule of masonry.h. */
#include "core/base/polygon.h"
#include "stereotomy/masonry-parts.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"

/* ---- the bond ---- */

/* Joints nearer than this part of a unit to an edge are on it. */
#define EDGE_TOLERANCE 1e-9

/* The units of one course: `lead` at a straight edge (mirrored at the right one), then `period`
 * over and over, beginning at `start` where there is no lead. */
typedef struct Pattern {
  double lead[2];
  int lead_count;
  double period[2];
  int period_count;
  double start; /* m, <= 0 */
} Pattern;

/* The course being laid. */
typedef struct Course {
  const QnMasonry *masonry;
  const QnLeaf *leaf;
  int32_t leaf_index, index, position;
  double left;   /* of the leaf, in the wall's frame */
  double y0, y1; /* the lower of the course's own top and the wall's */
  double full_height;
  QnPieces *pieces;
} Course;

/* A pattern with its closer behind the first header, or before everything; without one it is shifted. */
static Pattern
closed (Pattern pattern, QnCloser closer, double header, double queen,
        double three_quarter, double start)
{
  if (closer == QN_CLOSER_QUEEN) {
    pattern.lead_count = 2;
    pattern.lead[0] = header;
    pattern.lead[1] = queen;
  } else if (closer == QN_CLOSER_THREE_QUARTER) {
    pattern.lead_count = 1;
    pattern.lead[0] = three_quarter;
  } else {
    pattern.start = start;
  }
  return pattern;
}

/* Three-quarter bricks close the courses of stretchers, all else those of headers. */
static Pattern
english (double s, double h, bool odd, QnCloser closer)
{
  Pattern pattern = { .period = { odd ? h : s }, .period_count = 1 };
  return odd != (closer == QN_CLOSER_THREE_QUARTER)
           ? closed (pattern, closer, h, h / 2, 1.5 * h, -h / 2)
           : pattern;
}

static Pattern
flemish (double s, double h, bool odd, QnCloser closer)
{
  Pattern pattern = { .period = { s, h }, .period_count = 2 };
  return odd ? closed (pattern, closer, h, (s - h) / 2, (s + h) / 2, -(s + h) / 2)
             : pattern;
}

static Pattern
pattern_of (const QnLeaf *leaf, bool odd, QnCloser closer)
{
  double s = leaf->unit.x, h = leaf->header > 0 ? leaf->header : leaf->unit.x / 2;
  Pattern pattern = { .period = { s }, .period_count = 1 };
  switch (leaf->bond) {
  case QN_BOND_RUNNING:
    pattern.start = odd && leaf->lap > 0 ? (leaf->lap - 1) * s : 0;
    return pattern;
  case QN_BOND_HEADER:
    pattern.period[0] = h;
    pattern.start = odd ? -h / 2 : 0;
    return pattern;
  case QN_BOND_ENGLISH:
    return english (s, h, odd, closer);
  case QN_BOND_FLEMISH:
    return flemish (s, h, odd, closer);
  case QN_BOND_STACK:
  case QN_BOND_CUSTOM:
  case QN_BOND_COUNT:
    return pattern;
  }
  return pattern;
}

/* Lays the unit [x0, x1] (in the leaf's frame), cut to [least, most]; `whole` is its length uncut. */
static QnStatus
lay_unit (Course *course, double x0, double x1, double least, double most, QnDiag *diag)
{
  double whole = x1 - x0, tolerance = EDGE_TOLERANCE * course->leaf->unit.x;
  if (x0 < least + tolerance)
    x0 = least;
  if (x1 > most - tolerance)
    x1 = most;
  if (x1 - x0 <= tolerance)
    return QN_OK;

  const double left = course->left + x0, right = course->left + x1;
  const char *name = course->masonry->name;
  int32_t row = course->index + 1, position = ++course->position;
  QnPiece *piece =
    course->masonry->wall.leaf_count == 1
      ? qn_pieces_add (course->pieces, qn_rectangle (left, course->y0, right, course->y1),
                       "%s.%d.%d", name, row, position)
      : qn_pieces_add (course->pieces, qn_rectangle (left, course->y0, right, course->y1),
                       "%s.%c.%d.%d", name, 'a' + course->leaf_index, row, position);
  piece->fabric = true;
  piece->leaf = course->leaf_index;
  piece->course = course->index;
  piece->position = position;
  piece->whole_area = whole * course->full_height;
  piece->whole_width = fmin (whole, course->full_height);
  piece->cut = x1 - x0 < whole - tolerance
               || course->y1 - course->y0 < course->full_height * (1 - EDGE_TOLERANCE);
  if (course->pieces->count > QN_MAX_PIECES)
    return qn_masonry_problem (diag, QN_PROBLEM_TOO_MANY_BLOCKS, "unit", 0);
  return QN_OK;
}

/* Fills [from, to] with the pattern's period, beginning at `start`. */
static QnStatus
lay_period (Course *course, const Pattern *pattern, double start, double from, double to,
            QnDiag *diag)
{
  const QnMasonryWall *wall = &course->masonry->wall;
  bool first = course->leaf_index == 0;
  bool last = (size_t) course->leaf_index + 1 == wall->leaf_count;
  /* A toothed edge leaves the unit that crosses it whole. */
  double least = first && wall->left == QN_EDGE_TOOTHED ? -INFINITY : from;
  double most = last && wall->right == QN_EDGE_TOOTHED ? INFINITY : to;
  double period =
    pattern->period[0] + (pattern->period_count > 1 ? pattern->period[1] : 0);
  double tolerance = EDGE_TOLERANCE * course->leaf->unit.x;
  for (int32_t round = 0;; round++) {
    double x = start + round * period;
    for (int i = 0; i < pattern->period_count; i++) {
      if (x >= to - tolerance)
        return QN_OK;
      /* Neighbours must agree on their joint to the last bit. */
      double end = i + 1 < pattern->period_count ? x + pattern->period[i]
                                                 : start + (round + 1) * period;
      if (end > from + tolerance) {
        QnStatus status = lay_unit (course, x, end, least, most, diag);
        if (status != QN_OK)
          return status;
      }
      x = end;
    }
  }
}

static QnStatus
lay_course (Course *course, QnDiag *diag)
{
  const QnMasonryWall *wall = &course->masonry->wall;
  const QnLeaf *leaf = course->leaf;
  bool odd = course->index % 2 == 1;
  Pattern pattern = pattern_of (leaf, odd, leaf->closer);
  Pattern plain = pattern_of (leaf, odd, QN_CLOSER_NONE);
  double lead = 0;
  for (int i = 0; i < pattern.lead_count; i++)
    lead += pattern.lead[i];
  if (2 * lead > leaf->length)
    lead = 0;
  bool left = lead > 0 && !(course->leaf_index == 0 && wall->left == QN_EDGE_TOOTHED);
  bool right = lead > 0
               && !((size_t) course->leaf_index + 1 == wall->leaf_count
                    && wall->right == QN_EDGE_TOOTHED);

  QnStatus status = QN_OK;
  double x = 0;
  for (int i = 0; left && i < pattern.lead_count && status == QN_OK; i++) {
    status = lay_unit (course, x, x + pattern.lead[i], 0, leaf->length, diag);
    x += pattern.lead[i];
  }
  double end = right ? leaf->length - lead : leaf->length;
  if (status == QN_OK)
    status = lay_period (course, left ? &pattern : &plain,
                         left                     ? x
                         : pattern.lead_count > 0 ? plain.start
                                                  : pattern.start,
                         x, end, diag);
  for (int i = pattern.lead_count - 1; right && i >= 0 && status == QN_OK; i--) {
    status = lay_unit (course, end, end + pattern.lead[i], 0, leaf->length, diag);
    end += pattern.lead[i];
  }
  return status;
}

/* Courses listed one by one, lengths in units, negative ones left open and not counted. */
static QnStatus
lay_listed_course (Course *course, QnDiag *diag)
{
  const QnWall *listed = &course->masonry->wall.courses;
  int32_t i = course->index > 0 ? listed->course_ends[course->index - 1] : 0;
  double end = 0;
  QnStatus status = QN_OK;
  for (; i < listed->course_ends[course->index] && status == QN_OK; i++) {
    double begin = end, length = listed->lengths[i];
    QnProblem problem =
      length == 0 ? QN_PROBLEM_COURSE_LENGTH_ZERO
                  : qn_number_problem (length, QN_RANGE_FINITE, QN_MAX_COURSE_LENGTH);
    if (problem != QN_PROBLEM_NONE)
      return qn_masonry_problem (diag, problem, "courses", length);
    end += fabs (length);
    if (length > 0)
      status = lay_unit (course, course->leaf->unit.x * begin, course->leaf->unit.x * end,
                         -INFINITY, INFINITY, diag);
  }
  return status;
}

/* Bottom of a course above the ground: heights from the list, over and over, or all equal. */
static double
course_bottom (const QnMasonryWall *wall, const QnLeaf *leaf, int32_t index)
{
  size_t count = wall->course_height_count;
  if (count == 0)
    return leaf->unit.y * index;
  double all = 0, part = 0;
  for (size_t i = 0; i < count; i++) {
    all += wall->course_heights[i];
    if (i < (size_t) index % count)
      part += wall->course_heights[i];
  }
  return all * (double) ((size_t) index / count) + part;
}

/* The units of one leaf from x = `left`. */
static QnStatus
lay_leaf (const QnMasonry *masonry, size_t leaf, double left, QnPieces *pieces,
          QnDiag *diag)
{
  const QnMasonryWall *wall = &masonry->wall;
  Course course = { .masonry = masonry,
                    .leaf = &wall->leaves[leaf],
                    .leaf_index = (int32_t) leaf,
                    .left = left,
                    .pieces = pieces };
  bool listed = course.leaf->bond == QN_BOND_CUSTOM;
  QnStatus status = QN_OK;
  for (int32_t i = 0; status == QN_OK; i++) {
    double y0 = course_bottom (wall, course.leaf, i);
    double y1 = course_bottom (wall, course.leaf, i + 1);
    if (listed ? i >= wall->courses.course_count
               : y0 >= wall->height - EDGE_TOLERANCE * course.leaf->unit.y)
      break;
    course.index = i;
    course.position = 0;
    course.y0 = y0;
    course.y1 = listed || y1 <= wall->height * (1 + EDGE_TOLERANCE) ? y1 : wall->height;
    course.full_height = y1 - y0;
    status = listed ? lay_listed_course (&course, diag) : lay_course (&course, diag);
  }
  return status;
}

/* ---- the minimum piece rule ---- */

/* Edges nearer than this part of a unit's width lie on one line. */
#define JOINT_TOLERANCE 1e-9

static bool
is_sliver (const QnPiece *piece, double minimum)
{
  if (!piece->fabric || !piece->cut || piece->lone)
    return false;
  return qn_ring_area (&piece->ring) < minimum * piece->whole_area * (1 - JOINT_TOLERANCE)
         || qn_polygon_width (piece->ring.points, piece->ring.count)
              < minimum * piece->whole_width * (1 - JOINT_TOLERANCE);
}

typedef struct Neighbour {
  size_t index;
  bool same_course;
  double joint;
} Neighbour;

static int
compare_neighbours (const void *left, const void *right)
{
  const Neighbour *a = left, *b = right;
  if (a->same_course != b->same_course)
    return a->same_course ? -1 : 1;
  if (a->joint != b->joint)
    return a->joint > b->joint ? -1 : 1;
  return a->index < b->index ? -1 : 1;
}

/* Pieces of the same leaf that share a joint with `index`, best first: of Neighbour. */
static GArray *
find_neighbours (const QnPieces *pieces, size_t index)
{
  const QnPiece *sliver = &pieces->items[index];
  double tolerance = JOINT_TOLERANCE * sliver->whole_width;
  GArray *neighbours = g_array_new (FALSE, FALSE, sizeof (Neighbour));
  for (size_t i = 0; i < pieces->count; i++) {
    const QnPiece *other = &pieces->items[i];
    if (i == index || !other->fabric || other->leaf != sliver->leaf)
      continue;
    const Neighbour neighbour = { i, other->course == sliver->course,
                                  qn_joint_length (&sliver->ring, &other->ring,
                                                   tolerance) };
    if (neighbour.joint != 0)
      g_array_append_val (neighbours, neighbour);
  }
  g_array_sort (neighbours, compare_neighbours);
  return neighbours;
}

/* Merges the sliver with the first neighbour that gives a simple polygon; false where none does. */
static bool
merge_sliver (QnPieces *pieces, size_t index)
{
  g_autoptr (GArray) neighbours = find_neighbours (pieces, index);
  for (guint i = 0; i < neighbours->len; i++) {
    QnPiece *neighbour = &pieces->items[g_array_index (neighbours, Neighbour, i).index];
    QnRing pair[] = { neighbour->ring, pieces->items[index].ring }, joined;
    if (qn_polygons_union (&(QnRings){ .items = pair, .count = 2 }, &joined, NULL)
        != QN_OK)
      continue;
    qn_ring_clear (&neighbour->ring);
    neighbour->ring = joined;
    neighbour->cut = true;
    qn_pieces_remove (pieces, index);
    return true;
  }
  return false;
}

static void
merge_slivers (double minimum_piece, QnPieces *pieces)
{
  /* The smallest first: what is merged away can no longer tempt its neighbours. */
  while (minimum_piece > 0) {
    size_t smallest = SIZE_MAX;
    double area = INFINITY;
    for (size_t i = 0; i < pieces->count; i++) {
      if (!is_sliver (&pieces->items[i], minimum_piece))
        continue;
      double own = qn_ring_area (&pieces->items[i].ring);
      if (own < area) {
        area = own;
        smallest = i;
      }
    }
    if (smallest == SIZE_MAX)
      return;
    if (!merge_sliver (pieces, smallest))
      pieces->items[smallest].lone = true;
  }
}

/* ---- all of it ---- */

static QnStatus
check_leaf (const QnMasonryWall *wall, const QnLeaf *leaf, QnDiag *diag)
{
  bool listed = leaf->bond == QN_BOND_CUSTOM;
  const QnSubject of = qn_masonry_subject (diag);
  const char *unit = wall->grid ? "size" : "unit";
  bool holds =
    qn_require_length (of, unit, leaf->unit.x, QN_RANGE_POSITIVE)
    && qn_require_length (of, unit, leaf->unit.y, QN_RANGE_POSITIVE)
    && qn_require_length (of, "header", leaf->header, QN_RANGE_NOT_NEGATIVE)
    && (listed || qn_require_length (of, "length", leaf->length, QN_RANGE_POSITIVE))
    && qn_require (of, leaf->lap >= 0 && leaf->lap < 1, QN_PROBLEM_FRACTION, "lap",
                   leaf->lap)
    && qn_require (of, leaf->bond != QN_BOND_FLEMISH || leaf->header < leaf->unit.x,
                   QN_PROBLEM_HEADER_TOO_LONG, "header", leaf->header)
    && qn_require (of, !listed || wall->leaf_count == 1, QN_PROBLEM_LEAVES_LISTED,
                   "leaves", 0)
    && qn_require (of, !listed || wall->courses.course_count > 0, QN_PROBLEM_COURSE_EMPTY,
                   "courses", 0);
  if (!holds || listed)
    return qn_required (holds);
  double shortest =
    leaf->header > 0 ? fmin (leaf->header, leaf->unit.x) : leaf->unit.x / 2;
  double lowest = leaf->unit.y;
  for (size_t i = 0; i < wall->course_height_count; i++)
    lowest = i == 0 ? wall->course_heights[0] : fmin (lowest, wall->course_heights[i]);
  return qn_required (
    qn_require (of, leaf->length / shortest * (wall->height / lowest) <= QN_MAX_PIECES,
                QN_PROBLEM_TOO_MANY_BLOCKS, "unit", leaf->unit.x));
}

static QnStatus
check_wall (const QnMasonry *masonry, QnDiag *diag)
{
  const QnMasonryWall *wall = &masonry->wall;
  QN_ASSERT (wall->leaf_count > 0);
  const QnSubject of = qn_masonry_subject (diag);
  bool holds = wall->leaves[0].bond == QN_BOND_CUSTOM
               || qn_require_length (of, wall->grid ? "size" : "height", wall->height,
                                     QN_RANGE_POSITIVE);
  for (size_t i = 0; holds && i < wall->course_height_count; i++)
    holds = qn_require_length (of, "course_heights", wall->course_heights[i],
                               QN_RANGE_POSITIVE);
  holds = holds
          && qn_require (of, wall->minimum_piece >= 0 && wall->minimum_piece < 1,
                         QN_PROBLEM_FRACTION, "minimum_piece", wall->minimum_piece);
  QnStatus status = qn_required (holds);
  for (size_t i = 0; i < wall->leaf_count && status == QN_OK; i++) {
    status = check_leaf (wall, &wall->leaves[i], diag);
    if (status != QN_OK && diag != NULL && wall->leaf_count > 1)
      diag->other = (QnId) i;
  }
  return status;
}

/* Extent of the rectangle that the wall fills, teeth left out. */
static QnBox
wall_bounds (const QnMasonryWall *wall, const QnPieces *pieces)
{
  QnBox bounds = { { 0, 0 }, { 0, wall->height } };
  for (size_t i = 0; i < wall->leaf_count; i++)
    bounds.max.x += wall->leaves[i].length;
  if (wall->leaves[0].bond != QN_BOND_CUSTOM)
    return bounds;
  bounds.max = (QnVec2){ 0, 0 };
  for (size_t i = 0; i < pieces->count; i++) {
    QnBox piece = qn_ring_bounds (&pieces->items[i].ring);
    bounds.max.x = fmax (bounds.max.x, piece.max.x);
    bounds.max.y = fmax (bounds.max.y, piece.max.y);
  }
  return bounds;
}

/* One fixed block below the whole lowest course, teeth included. */
static void
lay_foundation (const QnMasonry *masonry, QnPieces *pieces)
{
  double left = INFINITY, right = -INFINITY;
  for (size_t i = 0; i < pieces->count; i++) {
    if (!pieces->items[i].fabric || pieces->items[i].course != 0)
      continue;
    QnBox bounds = qn_ring_bounds (&pieces->items[i].ring);
    left = fmin (left, bounds.min.x);
    right = fmax (right, bounds.max.x);
  }
  if (masonry->foundation == 0 || left >= right)
    return;
  qn_pieces_add (pieces, qn_rectangle (left, -masonry->foundation, right, 0), "%s.base",
                 masonry->name)
    ->fixed = true;
}

QnStatus
qn_masonry_lay_wall (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnMasonryWall *wall = &masonry->wall;
  QnStatus status = check_wall (masonry, diag);
  double left = 0;
  for (size_t i = 0; i < wall->leaf_count && status == QN_OK; i++) {
    status = lay_leaf (masonry, i, left, pieces, diag);
    left += wall->leaves[i].length;
  }
  lay_foundation (masonry, pieces);
  if (status == QN_OK)
    status = qn_openings_cut (masonry, wall_bounds (wall, pieces), pieces, diag);
  if (status == QN_OK)
    merge_slivers (wall->minimum_piece, pieces);
  return status;
}
