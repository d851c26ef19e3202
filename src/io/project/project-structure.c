#include "io/project/project-members.h"
#include "io/project/project-parts.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* "b4" and the like. */
#define NAME_SIZE 24

static gboolean
read_entity (const QnJsonValue *place, const QnList *list, QnModel *model)
{
  char numbered[NAME_SIZE];
  const char *name = list->naming == QN_NAMING_NUMBERED ? numbered : NULL;
  const QnNeed need = list->naming == QN_NAMING_REQUIRED ? QN_REQUIRED : QN_OPTIONAL;
  g_snprintf (numbered, sizeof numbered, "%c%zu", list->path[0], place->index + 1);
  if (!qn_json_value_object (place)
      || (list->naming != QN_NAMING_NONE
          && !qn_member_string (place, "name", need, &name)))
    return FALSE;
  if (list->naming == QN_NAMING_REQUIRED && name[0] == '\0') {
    QnJsonValue member = qn_json_value_member (place, "name");
    return qn_json_value_fail (&member, _ (qn_problem_text (QN_PROBLEM_NAME_MISSING)));
  }
  gpointer entity = list->add != NULL ? list->add (place, model, name)
                                      : qn_model_add_item (model, list->items, name);
  if (entity == NULL)
    return qn_json_value_no_memory (place);
  return (list->members == NULL || qn_members_read (place, list->members, model, entity))
         && (list->read == NULL || list->read (place, model, entity));
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
    if (!read_entity (&element, list, model))
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

static gpointer
add_block (const QnJsonValue *place, QnModel *model, const char *name)
{
  g_autoptr (GArray) vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnVec2), 8);
  return read_vertices (place, vertices) ? qn_model_add_block (
           model, name, (const QnVec2 *) vertices->data, vertices->len)
                                         : NULL;
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
read_wall (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  (void) model;
  return qn_read_courses (place, entity);
}

static void
append_block (GString *json, const QnModel *model, size_t index)
{
  static const QnBlock usual = { 0 };
  const QnBlock *block = &model->blocks[index];
  qn_json_put_points (json, "vertices", qn_model_block_vertices (model, (QnId) index),
                      (gsize) block->vertex_count);
  qn_members_write (json, block_members, model, block, &usual);
}

static bool
follows_from_others (const QnModel *model, size_t index)
{
  return model->blocks[index].wall != QN_NONE || model->blocks[index].masonry != QN_NONE;
}

const QnList qn_block_list = { QN_LIST ("blocks", QnBlock, blocks, block_count),
                               .naming = QN_NAMING_NUMBERED,
                               .members = block_members,
                               .add = add_block,
                               .append = append_block,
                               .is_left_out = follows_from_others };

static void
append_wall (GString *json, const QnModel *model, size_t index)
{
  const QnWall *wall = &model->walls[index];
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

const QnList qn_wall_list = { QN_LIST ("walls", QnWall, walls, wall_count),
                              .naming = QN_NAMING_NUMBERED,
                              .members = wall_structure_members, .read = read_wall,
                              .append = append_wall };
