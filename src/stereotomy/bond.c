/* Laying the units of one leaf course by course. */
#include "stereotomy/masonry-parts.h"

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

QnStatus
qn_bond_lay_leaf (const QnMasonry *masonry, size_t leaf, double left, QnPieces *pieces,
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
