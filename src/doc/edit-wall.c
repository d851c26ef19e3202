#include "doc/edit.h"

#include <glib/gi18n.h>
#include <stdlib.h>

/* Pieces shorter than this share of a block are rounding, not masonry. */
#define LEAST_LENGTH 1e-6

/* Widest wall and highest wall that the wall tool lays, in blocks. */
#define MOST_BLOCKS_PER_COURSE 10000
#define MOST_COURSES           10000

/* ---- courses as arrays of lengths ---- */

static GPtrArray *
read_courses (const QnWall *wall)
{
  GPtrArray *courses = g_ptr_array_new_with_free_func ((GDestroyNotify) g_array_unref);
  for (int32_t course = 0, first = 0; course < wall->course_count; course++) {
    int32_t end = wall->course_ends[course];
    GArray *lengths = g_array_new (FALSE, FALSE, sizeof (double));
    g_array_append_vals (lengths, wall->lengths + first, (guint) (end - first));
    g_ptr_array_add (courses, lengths);
    first = end;
  }
  return courses;
}

static gboolean
write_courses (QnWall *wall, const GPtrArray *courses, GError **error)
{
  free (wall->lengths);
  free (wall->course_ends);
  wall->lengths = NULL;
  wall->course_ends = NULL;
  wall->course_count = 0;
  for (guint i = 0; i < courses->len; i++) {
    const GArray *lengths = g_ptr_array_index (courses, i);
    if (!qn_wall_add_course (wall, (const double *) lengths->data, lengths->len))
      return qn_edit_no_memory (error);
  }
  return TRUE;
}

/* Appends, joining an opening to the one before it. */
static void
append_length (GArray *lengths, double length)
{
  if (fabs (length) < LEAST_LENGTH)
    return;
  if (length < 0.0 && lengths->len > 0) {
    double *last = &g_array_index (lengths, double, lengths->len - 1);
    if (*last < 0.0) {
      *last += length;
      return;
    }
  }
  g_array_append_val (lengths, length);
}

static double
course_width (const GArray *lengths)
{
  double width = 0.0;
  for (guint i = 0; i < lengths->len; i++)
    width += fabs (g_array_index (lengths, double, i));
  return width;
}

static double
wall_width (const QnWall *wall)
{
  g_autoptr (GPtrArray) courses = read_courses (wall);
  double width = 0.0;
  for (guint i = 0; i < courses->len; i++)
    width = MAX (width, course_width (g_ptr_array_index (courses, i)));
  return width;
}

/* A whole course of a bond, `width` in blocks. */
static GArray *
lay_course (QnWallBond bond, int course, double width)
{
  double shift = 0.0;
  if (bond == QN_WALL_BOND_RUNNING)
    shift = course % 2 == 0 ? 0.5 : 0.0;
  else if (bond == QN_WALL_BOND_THIRD)
    shift = course % 2 == 0 ? 2.0 / 3.0 : 1.0 / 3.0;

  GArray *lengths = g_array_new (FALSE, FALSE, sizeof (double));
  double x = 0.0, next = shift > 0.0 ? shift : 1.0;
  while (x < width - LEAST_LENGTH) {
    double end = MIN (next, width);
    append_length (lengths, end - x);
    x = end;
    next += 1.0;
  }
  return lengths;
}

/* ---- laying walls ---- */

static gboolean
lay_courses (const QnWallPlan *plan, GPtrArray **courses, double *width, GError **error)
{
  double halves = round (2.0 * plan->width / plan->unit.x);
  double rows = round (plan->height / plan->unit.y);
  if (!(halves >= 1.0) || !(rows >= 1.0)) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("The wall is smaller than half a block"));
    return FALSE;
  }
  if (halves > 2 * MOST_BLOCKS_PER_COURSE || rows > MOST_COURSES) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                         _ ("The wall has too many blocks"));
    return FALSE;
  }
  *width = 0.5 * halves;
  *courses = g_ptr_array_new_with_free_func ((GDestroyNotify) g_array_unref);
  for (int course = 0; course < (int) rows; course++)
    g_ptr_array_add (*courses, lay_course (plan->bond, course, *width));
  return TRUE;
}

static char *
dup_free_wall_name (const QnModel *model)
{
  for (gsize number = model->wall_count + 1;; number++) {
    g_autofree char *name = g_strdup_printf ("w%" G_GSIZE_FORMAT, number);
    gboolean taken = FALSE;
    for (gsize i = 0; i < model->wall_count; i++)
      taken = taken || g_strcmp0 (model->walls[i].name, name) == 0;
    /* Blocks of a wall that was detached keep its name in theirs. */
    g_autofree char *first_block = g_strdup_printf ("%s.1.1", name);
    if (!taken && qn_model_find_block (model, first_block) == QN_NONE)
      return g_steal_pointer (&name);
  }
}

static gboolean
add_base (QnModel *model, const QnWallPlan *plan, double width, GError **error)
{
  double right = plan->origin.x + width * plan->unit.x;
  double bottom = plan->origin.y - plan->unit.y;
  QnVec2 corners[] = { { plan->origin.x, bottom },
                       { right, bottom },
                       { right, plan->origin.y },
                       { plan->origin.x, plan->origin.y } };
  QnBlockStyle style = plan->style;
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    style.support[dof] = true;
  return qn_edit_add_block (model, corners, G_N_ELEMENTS (corners), style, error);
}

gboolean
qn_edit_add_wall (QnModel *model, const QnWallPlan *plan, GError **error)
{
  g_autoptr (GPtrArray) courses = NULL;
  double width = 0.0;
  if (!lay_courses (plan, &courses, &width, error))
    return FALSE;
  if (plan->base && !add_base (model, plan, width, error))
    return FALSE;

  g_autofree char *name = dup_free_wall_name (model);
  QnWall *wall = qn_model_add_wall (model, name);
  if (wall == NULL)
    return qn_edit_no_memory (error);
  wall->origin = plan->origin;
  wall->unit = plan->unit;
  wall->thickness = plan->style.thickness;
  wall->unit_weight = plan->style.unit_weight;
  wall->law = plan->style.law;
  return write_courses (wall, courses, error) && qn_edit_rebuild (model, NULL, error);
}

gboolean
qn_edit_relay_wall (QnModel *model, QnId id, const QnWallPlan *plan, GError **error)
{
  g_autoptr (GPtrArray) courses = NULL;
  double width = 0.0;
  if (!lay_courses (plan, &courses, &width, error))
    return FALSE;
  QnWall *wall = &model->walls[id];
  wall->origin = plan->origin;
  wall->unit = plan->unit;
  return write_courses (wall, courses, error) && qn_edit_rebuild (model, NULL, error);
}

QnId
qn_model_wall_at (const QnModel *model, QnVec2 at)
{
  for (gsize i = model->wall_count; i > 0; i--) {
    const QnWall *wall = &model->walls[i - 1];
    double width = wall_width (wall) * wall->unit.x;
    double height = wall->course_count * wall->unit.y;
    if (at.x >= wall->origin.x && at.x <= wall->origin.x + width && at.y >= wall->origin.y
        && at.y <= wall->origin.y + height)
      return (QnId) (i - 1);
  }
  return QN_NONE;
}

/* ---- openings ---- */

/* A rectangle of a wall: abscissae in blocks, courses from the bottom. */
typedef struct Patch {
  double left, right;
  int bottom, top; /* courses bottom .. top - 1 */
} Patch;

static gboolean
patch_from_corners (const QnWall *wall, QnVec2 a, QnVec2 b, Patch *patch)
{
  double width = wall_width (wall);
  double x0 = (MIN (a.x, b.x) - wall->origin.x) / wall->unit.x;
  double x1 = (MAX (a.x, b.x) - wall->origin.x) / wall->unit.x;
  double y0 = (MIN (a.y, b.y) - wall->origin.y) / wall->unit.y;
  double y1 = (MAX (a.y, b.y) - wall->origin.y) / wall->unit.y;
  patch->left = CLAMP (round (2.0 * x0) / 2.0, 0.0, width);
  patch->right = CLAMP (round (2.0 * x1) / 2.0, 0.0, width);
  patch->bottom = (int) CLAMP (round (y0), 0.0, (double) wall->course_count);
  patch->top = (int) CLAMP (round (y1), 0.0, (double) wall->course_count);
  return patch->right - patch->left > LEAST_LENGTH && patch->top > patch->bottom;
}

static void
patch_to_corners (const QnWall *wall, const Patch *patch, QnVec2 *lower_left,
                  QnVec2 *upper_right)
{
  *lower_left = qn_vec2 (wall->origin.x + patch->left * wall->unit.x,
                         wall->origin.y + patch->bottom * wall->unit.y);
  *upper_right = qn_vec2 (wall->origin.x + patch->right * wall->unit.x,
                          wall->origin.y + patch->top * wall->unit.y);
}

gboolean
qn_wall_snap_opening (const QnWall *wall, QnVec2 a, QnVec2 b, QnVec2 *lower_left,
                      QnVec2 *upper_right)
{
  Patch patch;
  if (!patch_from_corners (wall, a, b, &patch))
    return FALSE;
  patch_to_corners (wall, &patch, lower_left, upper_right);
  return TRUE;
}

/* Appends the part of a course between two abscissae as it is. */
static void
append_part (GArray *to, const GArray *course, double from, double until)
{
  double x = 0.0;
  for (guint i = 0; i < course->len; i++) {
    double length = g_array_index (course, double, i), end = x + fabs (length);
    double part = MIN (end, until) - MAX (x, from);
    if (part > LEAST_LENGTH)
      append_length (to, length < 0.0 ? -part : part);
    x = end;
  }
}

/* The course with everything between two abscissae replaced by one length. */
static GArray *
replace_part (const GArray *course, double left, double right, double length)
{
  GArray *made = g_array_new (FALSE, FALSE, sizeof (double));
  append_part (made, course, 0.0, left);
  append_length (made, length);
  append_part (made, course, right, course_width (course));
  return made;
}

static void
set_course (GPtrArray *courses, int index, GArray *course)
{
  g_array_unref (g_ptr_array_index (courses, index));
  g_ptr_array_index (courses, index) = course;
}

gboolean
qn_edit_cut_opening (QnModel *model, QnId id, QnVec2 a, QnVec2 b, gboolean lintel,
                     GError **error)
{
  QnWall *wall = &model->walls[id];
  Patch patch;
  if (!patch_from_corners (wall, a, b, &patch)) {
    g_set_error_literal (
      error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
      _ ("The opening is smaller than half a block or outside the wall"));
    return FALSE;
  }
  g_autoptr (GPtrArray) courses = read_courses (wall);
  for (int course = patch.bottom; course < patch.top; course++)
    set_course (courses, course,
                replace_part (g_ptr_array_index (courses, course), patch.left,
                              patch.right, patch.left - patch.right));
  if (lintel && patch.top < wall->course_count) {
    GArray *above = g_ptr_array_index (courses, patch.top);
    double left = MAX (patch.left - 0.5, 0.0);
    double right = MIN (patch.right + 0.5, course_width (above));
    set_course (courses, patch.top, replace_part (above, left, right, right - left));
  }
  return write_courses (wall, courses, error) && qn_edit_rebuild (model, NULL, error);
}

/* The opening of a course at an abscissa. */
static gboolean
gap_at (const GArray *course, double at, double *left, double *right)
{
  double x = 0.0;
  for (guint i = 0; i < course->len; i++) {
    double length = g_array_index (course, double, i), end = x + fabs (length);
    if (length < 0.0 && at >= x && at <= end) {
      *left = x;
      *right = end;
      return TRUE;
    }
    x = end;
  }
  return FALSE;
}

static gboolean
find_patch (const QnWall *wall, const GPtrArray *courses, QnVec2 at, Patch *patch)
{
  double x = (at.x - wall->origin.x) / wall->unit.x;
  double y = floor ((at.y - wall->origin.y) / wall->unit.y);
  if (!(y >= 0.0) || y >= wall->course_count)
    return FALSE;
  int course = (int) y;
  if (!gap_at (g_ptr_array_index (courses, course), x, &patch->left, &patch->right))
    return FALSE;

  patch->bottom = course;
  patch->top = course + 1;
  double left, right;
  while (patch->bottom > 0
         && gap_at (g_ptr_array_index (courses, patch->bottom - 1), x, &left, &right)
         && fabs (left - patch->left) + fabs (right - patch->right) < LEAST_LENGTH)
    patch->bottom--;
  while (patch->top < wall->course_count
         && gap_at (g_ptr_array_index (courses, patch->top), x, &left, &right)
         && fabs (left - patch->left) + fabs (right - patch->right) < LEAST_LENGTH)
    patch->top++;
  return TRUE;
}

gboolean
qn_wall_find_opening (const QnWall *wall, QnVec2 at, QnVec2 *lower_left,
                      QnVec2 *upper_right)
{
  g_autoptr (GPtrArray) courses = read_courses (wall);
  Patch patch;
  if (!find_patch (wall, courses, at, &patch))
    return FALSE;
  patch_to_corners (wall, &patch, lower_left, upper_right);
  return TRUE;
}

gboolean
qn_edit_fill_opening (QnModel *model, QnId id, QnVec2 at, GError **error)
{
  QnWall *wall = &model->walls[id];
  g_autoptr (GPtrArray) courses = read_courses (wall);
  Patch patch;
  if (!find_patch (wall, courses, at, &patch)) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("There is no opening here"));
    return FALSE;
  }
  double width = wall_width (wall);
  for (int course = patch.bottom; course < patch.top; course++) {
    GArray *old = g_ptr_array_index (courses, course);
    g_autoptr (GArray) full = lay_course (QN_WALL_BOND_RUNNING, course, width);
    GArray *made = g_array_new (FALSE, FALSE, sizeof (double));
    append_part (made, old, 0.0, patch.left);
    append_part (made, full, patch.left, patch.right);
    append_part (made, old, patch.right, course_width (old));
    set_course (courses, course, made);
  }
  return write_courses (wall, courses, error) && qn_edit_rebuild (model, NULL, error);
}
