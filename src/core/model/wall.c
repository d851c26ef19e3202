#include "core/base/memory.h"
#include "core/base/require.h"
#include "core/model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool
qn_wall_add_course (QnWall *wall, const double *lengths, size_t count)
{
  size_t courses = (size_t) wall->course_count;
  size_t begin = courses > 0 ? (size_t) wall->course_ends[courses - 1] : 0;
  if (count > (size_t) INT32_MAX - begin || courses >= INT32_MAX)
    return false;

  if (!qn_array_reserve (&wall->lengths, &wall->length_capacity, begin + count,
                         sizeof *wall->lengths))
    return false;
  if (!qn_array_reserve (&wall->course_ends, &wall->course_capacity, courses + 1,
                         sizeof *wall->course_ends))
    return false;

  if (count > 0)
    memcpy (wall->lengths + begin, lengths, count * sizeof *wall->lengths);
  wall->course_ends[courses] = (int32_t) (begin + count);
  wall->course_count++;
  return true;
}

static bool
refuse_course (QnSubject of, QnProblem problem, QnId course, QnId position, double value)
{
  qn_require (of, false, problem, "courses", value);
  if (of.diag != NULL) {
    of.diag->sub = course;
    of.diag->other = position;
  }
  return false;
}

static bool
check_courses (const QnWall *wall, size_t *block_count, QnSubject of)
{
  if (wall->course_count == 0)
    return refuse_course (of, QN_PROBLEM_COURSE_EMPTY, QN_NONE, QN_NONE, 0);

  int32_t begin = 0;
  for (int32_t course = 0; course < wall->course_count; course++) {
    int32_t end = wall->course_ends[course];
    if (begin == end)
      return refuse_course (of, QN_PROBLEM_COURSE_EMPTY, course, QN_NONE, 0);
    for (int32_t i = begin; i < end; i++) {
      double length = wall->lengths[i];
      QnProblem problem =
        length == 0 ? QN_PROBLEM_COURSE_LENGTH_ZERO
                    : qn_number_problem (length, QN_RANGE_FINITE, QN_MAX_COURSE_LENGTH);
      if (problem != QN_PROBLEM_NONE)
        return refuse_course (of, problem, course, i - begin, length);
      if (length > 0)
        (*block_count)++;
    }
    begin = end;
  }
  return true;
}

static bool
check_wall (const QnWall *wall, size_t *block_count, QnSubject of)
{
  const double most = QN_MAX_COORDINATE;

  return qn_require_name (of, wall->name, QN_NONE, QN_NONE)
         && qn_require_size (of, "origin", wall->origin.x, QN_RANGE_FINITE, most)
         && qn_require_size (of, "origin", wall->origin.y, QN_RANGE_FINITE, most)
         && qn_require_size (of, "unit", wall->unit.x, QN_RANGE_POSITIVE, most)
         && qn_require_size (of, "unit", wall->unit.y, QN_RANGE_POSITIVE, most)
         && check_courses (wall, block_count, of)
         && qn_require (of, *block_count <= QN_MAX_BLOCKS, QN_PROBLEM_TOO_MANY_BLOCKS,
                        "courses", (double) *block_count);
}

/* Adds the blocks of one checked wall; false when memory runs out. */
static bool
expand_wall (QnModel *model, QnId index)
{
  const QnWall *wall = &model->walls[index];
  const size_t room = strlen (wall->name) + sizeof ".2147483647.2147483647";
  char *name = qn_alloc (room, 1);
  if (name == NULL)
    return false;

  bool done = true;
  int32_t i = 0;
  for (int32_t course = 0; course < wall->course_count && done; course++) {
    double y0 = wall->origin.y + wall->unit.y * course;
    double y1 = wall->origin.y + wall->unit.y * (course + 1);
    double end = 0;
    int32_t position = 0;
    for (; i < wall->course_ends[course] && done; i++) {
      double begin = end;
      end += fabs (wall->lengths[i]);
      if (wall->lengths[i] < 0)
        continue;
      double x0 = wall->origin.x + wall->unit.x * begin;
      double x1 = wall->origin.x + wall->unit.x * end;
      const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
      snprintf (name, room, "%s.%d.%d", wall->name, course + 1, ++position);
      QnBlock *block = qn_model_add_block (model, name, corners, 4);
      done = block != NULL;
      if (done) {
        block->wall = index;
        block->wall_entry = i;
        block->law = wall->law;
        block->thickness = wall->thickness;
        block->unit_weight = wall->unit_weight;
        block->density = wall->density;
      }
    }
  }
  free (name);
  return done;
}

QnStatus
qn_model_expand_walls (QnModel *model, QnDiag *diag)
{
  size_t block_count = model->block_count;
  for (size_t i = model->expanded_wall_count; i < model->wall_count; i++) {
    const QnSubject of = { QN_ENTITY_WALL, (QnId) i, diag };
    if (!check_wall (&model->walls[i], &block_count, of))
      return QN_ERROR_INVALID;
  }

  while (model->expanded_wall_count < model->wall_count) {
    if (!expand_wall (model, (QnId) model->expanded_wall_count))
      return qn_diag_no_memory (diag);
    model->expanded_wall_count++;
  }
  return QN_OK;
}
