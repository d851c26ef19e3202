/* A wall that is listed course by course, read as a bonded wall with openings in it. */
#include "doc/edit/edit-masonry.h"
#include "doc/masonry/masonry-shape.h"

#include <math.h>

/* Lengths in units that differ by less are equal. */
#define SAME_LENGTH 1e-9

/* A block longer than this above an opening, resting on both sides, is its lintel. */
#define LINTEL_LENGTH 1.2

typedef struct Piece {
  double left, right; /* in units */
  gboolean gap;
} Piece;

/* Courses from the bottom, each a GArray of Piece. */
typedef GPtrArray Courses;

/* A rectangle of gaps above each other. */
typedef struct Hole {
  double left, right;
  guint bottom, top; /* courses bottom .. top - 1 */
  double bearing;    /* of a lintel in course `top`, in units; 0: none */
} Hole;

/* Appends, as one gap or block with the last where `joined` and both are of a kind. */
static void
append_piece (GArray *pieces, Piece piece, gboolean joined)
{
  Piece *last = pieces->len > 0 ? &g_array_index (pieces, Piece, pieces->len - 1) : NULL;
  if (joined && last != NULL && last->gap == piece.gap)
    last->right = piece.right;
  else
    g_array_append_val (pieces, piece);
}

static Courses *
read_courses (const QnWall *wall)
{
  Courses *courses = g_ptr_array_new_with_free_func ((GDestroyNotify) g_array_unref);
  for (int32_t course = 0, entry = 0; course < wall->course_count; course++) {
    GArray *pieces = g_array_new (FALSE, FALSE, sizeof (Piece));
    double x = 0.0;
    for (; entry < wall->course_ends[course]; entry++) {
      double end = x + fabs (wall->lengths[entry]);
      const gboolean gap = wall->lengths[entry] < 0.0;
      append_piece (pieces, (Piece){ x, end, gap }, gap);
      x = end;
    }
    g_ptr_array_add (courses, pieces);
  }
  return courses;
}

static const GArray *
course_at (const Courses *courses, guint index)
{
  return g_ptr_array_index (courses, index);
}

/* Whether a course is laid without a gap from `left` to `right`. */
static gboolean
is_solid (const GArray *pieces, double left, double right)
{
  double reached = 0.0; /* pieces follow each other from there */
  for (guint i = 0; i < pieces->len; i++) {
    const Piece *piece = &g_array_index (pieces, Piece, i);
    if (piece->gap && piece->right > left + SAME_LENGTH
        && piece->left < right - SAME_LENGTH)
      return FALSE;
    reached = piece->right;
  }
  return reached >= right - SAME_LENGTH;
}

/* The nearest course laid like `index` (every other one) that is whole over the range. */
static const GArray *
find_sister (const Courses *courses, guint index, double left, double right)
{
  for (guint away = 2; away < courses->len; away += 2) {
    if (index >= away && is_solid (course_at (courses, index - away), left, right))
      return course_at (courses, index - away);
    if (index + away < courses->len
        && is_solid (course_at (courses, index + away), left, right))
      return course_at (courses, index + away);
  }
  return NULL;
}

static gboolean
has_joint (const GArray *pieces, double at)
{
  for (guint i = 0; i < pieces->len; i++) {
    const Piece *piece = &g_array_index (pieces, Piece, i);
    if (fabs (piece->left - at) < SAME_LENGTH || fabs (piece->right - at) < SAME_LENGTH)
      return TRUE;
  }
  return FALSE;
}

/* The course with what lies between `left` and `right` laid like its sister. */
static GArray *
lay_like (const GArray *pieces, const GArray *sister, double left, double right)
{
  GArray *made = g_array_new (FALSE, FALSE, sizeof (Piece));
  gboolean filled = FALSE;
  for (guint i = 0; i < pieces->len; i++) {
    Piece piece = g_array_index (pieces, Piece, i);
    if (piece.left < left - SAME_LENGTH)
      append_piece (made, (Piece){ piece.left, MIN (piece.right, left), piece.gap },
                    FALSE);
    if (!filled && piece.right > left + SAME_LENGTH) {
      filled = TRUE;
      for (guint k = 0; k < sister->len; k++) {
        Piece like = g_array_index (sister, Piece, k);
        Piece part = { MAX (like.left, left), MIN (like.right, right), FALSE };
        if (part.right - part.left > SAME_LENGTH)
          append_piece (made, part, part.left == left && !has_joint (sister, left));
      }
    }
    if (piece.right > right + SAME_LENGTH)
      append_piece (made, (Piece){ MAX (piece.left, right), piece.right, piece.gap },
                    piece.left <= right + SAME_LENGTH && !has_joint (sister, right));
  }
  return made;
}

static gboolean
has_gap (const GArray *pieces, double left, double right)
{
  for (guint i = 0; i < pieces->len; i++) {
    const Piece *piece = &g_array_index (pieces, Piece, i);
    if (piece->gap && fabs (piece->left - left) < SAME_LENGTH
        && fabs (piece->right - right) < SAME_LENGTH)
      return TRUE;
  }
  return FALSE;
}

/* How far the block that spans the hole rests on either side, in units; 0 where there is none. */
static double
bearing_above (const Courses *courses, const Hole *hole)
{
  const GArray *pieces = hole->top < courses->len ? course_at (courses, hole->top) : NULL;
  for (guint i = 0; pieces != NULL && i < pieces->len; i++) {
    const Piece *piece = &g_array_index (pieces, Piece, i);
    double left = hole->left - piece->left, right = piece->right - hole->right;
    if (!piece->gap && piece->right - piece->left > LINTEL_LENGTH && left > SAME_LENGTH
        && fabs (left - right) < SAME_LENGTH)
      return left;
  }
  return 0.0;
}

static void
replace_course (Courses *courses, guint index, double left, double right)
{
  GArray *old = g_ptr_array_index (courses, index);
  const GArray *sister = find_sister (courses, index, left, right);
  courses->pdata[index] = lay_like (old, sister, left, right);
  g_array_unref (old);
}

/* Fills the hole if the bond defines its blocks. */
static gboolean
fill_hole (Courses *courses, Hole *hole)
{
  for (guint course = hole->bottom; course < hole->top; course++) {
    if (find_sister (courses, course, hole->left, hole->right) == NULL)
      return FALSE;
  }
  for (guint course = hole->bottom; course < hole->top; course++)
    replace_course (courses, course, hole->left, hole->right);
  hole->bearing = bearing_above (courses, hole);
  double left = hole->left - hole->bearing, right = hole->right + hole->bearing;
  if (hole->bearing > 0.0 && find_sister (courses, hole->top, left, right) != NULL)
    replace_course (courses, hole->top, left, right);
  else
    hole->bearing = 0.0;
  return TRUE;
}

/* Makes openings of the holes that can be filled; the others stay gaps of their courses. */
static void
take_openings (Courses *courses, QnMasonry *masonry, QnVec2 unit)
{
  for (guint course = 0; course < courses->len; course++) {
    for (guint i = 0; i < course_at (courses, course)->len; i++) {
      const Piece *piece = &g_array_index (course_at (courses, course), Piece, i);
      if (!piece->gap)
        continue;
      /* The hole that begins with a gap of a course. */
      Hole hole = { piece->left, piece->right, course, course + 1, 0.0 };
      while (hole.top < courses->len
             && has_gap (course_at (courses, hole.top), hole.left, hole.right))
        hole.top++;
      if (!fill_hole (courses, &hole))
        continue;
      QnOpening *opening = qn_masonry_add_opening (masonry);
      opening->at = qn_vec2 (hole.left * unit.x, hole.bottom * unit.y);
      opening->width = (hole.right - hole.left) * unit.x;
      opening->height = (hole.top - hole.bottom) * unit.y;
      if (hole.bearing > 0.0) {
        opening->span = QN_SPAN_LINTEL;
        opening->depth = unit.y;
        opening->bearing = hole.bearing * unit.x;
      }
      /* The course is another one now: from its beginning. */
      i = G_MAXUINT;
    }
  }
}

static gboolean
make_masonry (const QnWall *wall, QnMasonry *masonry)
{
  qn_masonry_init (masonry, QN_MASONRY_WALL, wall->name);
  masonry->origin = wall->origin;
  masonry->thickness = wall->thickness;
  masonry->unit_weight = wall->unit_weight;
  masonry->density = wall->density;
  masonry->law = wall->law;
  masonry->wall.leaves[0].bond = QN_BOND_CUSTOM;
  masonry->wall.leaves[0].unit = wall->unit;
  g_autoptr (GPtrArray) courses = read_courses (wall);
  take_openings (courses, masonry, wall->unit);
  for (guint i = 0; i < courses->len; i++) {
    const GArray *pieces = g_ptr_array_index (courses, i);
    g_autofree double *lengths = g_new (double, pieces->len + 1);
    for (guint k = 0; k < pieces->len; k++) {
      const Piece *piece = &g_array_index (pieces, Piece, k);
      lengths[k] = (piece->gap ? -1.0 : 1.0) * (piece->right - piece->left);
    }
    if (!qn_wall_add_course (&masonry->wall.courses, lengths, pieces->len))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_edit_convert_wall (QnProject *draft, QnId id, GError **error)
{
  QnWall *wall = &draft->model.walls[id];
  QnMasonry masonry;
  if (!make_masonry (wall, &masonry)) {
    qn_masonry_clear (&masonry);
    return qn_edit_no_memory (error);
  }
  qn_wall_remove_courses (wall);
  return qn_edit_add_masonry (draft, &masonry, error);
}

QnId
qn_model_wall_at (const QnModel *model, QnVec2 at)
{
  for (gsize i = model->wall_count; i > 0; i--) {
    const QnWall *wall = &model->walls[i - 1];
    double width = qn_wall_listed_length (wall) * wall->unit.x;
    double height = wall->course_count * wall->unit.y;
    QnVec2 p = qn_vec2_sub (at, wall->origin);
    if (p.x >= 0.0 && p.x <= width && p.y >= 0.0 && p.y <= height)
      return (QnId) (i - 1);
  }
  return QN_NONE;
}
