#include "io/project/project-inner.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

gboolean
qn_read_own_name (const QnJsonValue *place, const char *prefix,
                  char text[QN_NAME_TEXT_SIZE], const char **name)
{
  g_snprintf (text, QN_NAME_TEXT_SIZE, "%s%" G_GSIZE_FORMAT, prefix, place->index + 1);
  *name = text;
  return qn_member_string (place, "name", QN_OPTIONAL, name);
}

gboolean
qn_read_list (const QnJsonValue *owner, const QnList *list, QnNeed need, QnModel *model)
{
  const char *dot = strrchr (list->path, '.');
  QnJsonValue array, element = { 0 };
  if (!qn_member_array (owner, dot != NULL ? dot + 1 : list->path, need, &array))
    return FALSE;
  while (qn_json_value_next (&array, &element)) {
    const size_t index = G_STRUCT_MEMBER (size_t, model, list->count);
    if (!list->read (&element, model))
      return FALSE;
    *qn_list_note (model, list, index) = qn_read_note (&element);
  }
  return TRUE;
}

static const QnMember block_members[] = {
  QN_KNOWN ("name"),
  QN_KNOWN ("vertices"),
  QN_NUMBER ("thickness", REQUIRED, POSITIVE, QnBlock, thickness),
  QN_WEIGHT (REQUIRED, QnBlock),
  QN_SUPPORT (QnBlock),
  QN_BOOL ("rigid", OPTIONAL, QnBlock, rigid),
  QN_LAW (QnBlock),
  QN_COUNT ("ring", OPTIONAL, INT32_MAX, QnBlock, ring),
  QN_ENTITY ("ring_law", OPTIONAL, LAW, QnBlock, ring_law),
  { 0 },
};

static const QnMember wall_structure_members[] = {
  QN_KNOWN ("name"),
  QN_TWO ("origin", WRITTEN, QnWall, origin),
  QN_TWO ("unit", REQUIRED, QnWall, unit),
  QN_NUMBER ("thickness", REQUIRED, POSITIVE, QnWall, thickness),
  QN_WEIGHT (REQUIRED, QnWall),
  QN_LAW (QnWall),
  QN_KNOWN ("courses"),
  { 0 },
};

static gboolean
read_vertices (const QnJsonValue *place, GArray *vertices)
{
  QnJsonValue list, element = { 0 };
  if (!qn_member_array (place, "vertices", QN_REQUIRED, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    QnVec2 vertex;
    if (!qn_json_value_vec2 (&element, &vertex))
      return FALSE;
    g_array_append_val (vertices, vertex);
  }
  return TRUE;
}

static gboolean
read_block (const QnJsonValue *place, QnModel *model)
{
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  if (!qn_json_value_object (place) || !qn_read_own_name (place, "b", text, &name)
      || !qn_members_check (place, block_members, NULL, NULL))
    return FALSE;

  g_autoptr (GArray) vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnVec2), 8);
  if (!read_vertices (place, vertices))
    return FALSE;
  QnBlock *block =
    qn_model_add_block (model, name, (const QnVec2 *) vertices->data, vertices->len);
  return block != NULL ? qn_members_take (place, block_members, model, block)
                       : qn_json_value_no_memory (place);
}

static gboolean
read_course (const QnJsonValue *place, QnWall *wall)
{
  if (!qn_json_value_array (place))
    return FALSE;
  g_autoptr (GArray) lengths = g_array_new (FALSE, FALSE, sizeof (double));
  QnJsonValue element = { 0 };
  while (qn_json_value_next (place, &element)) {
    double length = 0;
    if (!qn_json_value_number (&element, QN_RANGE_FINITE, &length))
      return FALSE;
    if (length == 0 || fabs (length) > QN_MAX_COURSE_LENGTH)
      return qn_json_value_fail (
        &element, _ (qn_problem_text (length == 0 ? QN_PROBLEM_COURSE_LENGTH_ZERO
                                                  : QN_PROBLEM_TOO_LARGE)));
    g_array_append_val (lengths, length);
  }
  return qn_wall_add_course (wall, (const double *) lengths->data, lengths->len)
         || qn_json_value_no_memory (place);
}

gboolean
qn_read_courses (const QnJsonValue *place, QnWall *wall)
{
  QnJsonValue list, course = { 0 };
  if (!qn_member_array (place, "courses", QN_REQUIRED, &list))
    return FALSE;
  while (qn_json_value_next (&list, &course)) {
    if (!read_course (&course, wall))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_wall (const QnJsonValue *place, QnModel *model)
{
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  if (!qn_json_value_object (place) || !qn_read_own_name (place, "w", text, &name))
    return FALSE;
  QnWall *wall = qn_model_add_wall (model, name);
  if (wall == NULL)
    return qn_json_value_no_memory (place);
  return qn_members_read (place, wall_structure_members, model, wall)
         && qn_read_courses (place, wall);
}

static void
append_block (GString *json, const QnModel *model, size_t index)
{
  static const QnBlock usual = { 0 };
  const QnBlock *block = &model->blocks[index];
  qn_json_put_string (json, "name", block->name);
  qn_json_put_points (json, "vertices", qn_model_block_vertices (model, (QnId) index),
                      (gsize) block->vertex_count);
  qn_members_write (json, block_members, model, block, &usual);
}

static bool
follows_from_others (const QnModel *model, size_t index)
{
  return model->blocks[index].wall != QN_NONE || model->blocks[index].masonry != QN_NONE;
}

const QnList qn_block_list = QN_LIST ("blocks", read_block, append_block,
                                      follows_from_others, QnBlock, blocks, block_count);

static void
append_wall (GString *json, const QnModel *model, size_t index)
{
  const QnWall *wall = &model->walls[index];
  qn_json_put_string (json, "name", wall->name);
  qn_members_write (json, wall_structure_members, model, wall, NULL);
  g_string_append (json, ",\n      \"courses\": [");
  int32_t entry = 0;
  for (int32_t course = 0; course < wall->course_count; course++) {
    g_string_append (json, course > 0 ? ",\n        " : "\n        ");
    qn_json_append_numbers (json, wall->lengths + entry,
                            (gsize) (wall->course_ends[course] - entry));
    entry = wall->course_ends[course];
  }
  g_string_append (json, " ]");
}

const QnList qn_wall_list =
  QN_LIST ("walls", read_wall, append_wall, NULL, QnWall, walls, wall_count);
