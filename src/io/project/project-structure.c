#include "core/model/support.h"
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
  while (qn_json_value_next (&array, &element))
    if (!list->read (&element, model))
      return FALSE;
  return TRUE;
}

gboolean
qn_read_weight (const QnJsonValue *place, const QnModel *model, double *unit_weight,
                double *density)
{
  const QnRange range = QN_RANGE_NOT_NEGATIVE;
  QnJsonValue by_density = qn_json_value_member (place, "density");
  if (by_density.json == NULL)
    return qn_member_number (place, "unit_weight", QN_REQUIRED, range, unit_weight);
  if (cJSON_HasObjectItem (place->json, "unit_weight"))
    return qn_json_value_fail (&by_density,
                               _ ("density and unit_weight exclude each other"));
  if (!qn_json_value_number (&by_density, range, density))
    return FALSE;
  *unit_weight = *density * model->gravity;
  return TRUE;
}

gboolean
qn_read_own_law (const QnJsonValue *place, const QnModel *model, QnId *law)
{
  QnJsonValue material = qn_json_value_member (place, "material");
  if (material.json == NULL)
    return qn_read_name (place, "law", QN_OPTIONAL, model, QN_NAMED_LAW, law);
  if (cJSON_HasObjectItem (place->json, "law"))
    return qn_json_value_fail (&material, _ ("law and material exclude each other"));
  return qn_read_name (place, "material", QN_REQUIRED, model, QN_NAMED_LAW, law);
}

gboolean
qn_read_support (const QnJsonValue *place, bool support[QN_DOF_COUNT])
{
  QnJsonValue list, flag = { 0 };
  if (!qn_member_array (place, "support", QN_OPTIONAL, &list))
    return FALSE;
  if (list.json != NULL && cJSON_GetArraySize (list.json) != QN_DOF_COUNT)
    return qn_json_value_fail (&list,
                               _ ("expected three values: ux, uy, rz fixed or not"));

  while (qn_json_value_next (&list, &flag)) {
    if (!cJSON_IsBool (flag.json))
      return qn_json_value_fail (&flag, _ ("expected true or false"));
    support[flag.index] = cJSON_IsTrue (flag.json);
  }
  return TRUE;
}

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
read_block_properties (const QnJsonValue *place, const QnModel *model, QnBlock *block)
{
  return qn_member_number (place, "thickness", QN_REQUIRED, QN_RANGE_POSITIVE,
                           &block->thickness)
         && qn_read_weight (place, model, &block->unit_weight, &block->density)
         && qn_read_support (place, block->support)
         && qn_member_bool (place, "rigid", QN_OPTIONAL, &block->rigid)
         && qn_read_own_law (place, model, &block->law)
         && qn_member_count (place, "ring", QN_OPTIONAL, INT32_MAX, &block->ring)
         && qn_read_name (place, "ring_law", QN_OPTIONAL, model, QN_NAMED_LAW,
                          &block->ring_law);
}

static gboolean
read_block (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "name",     "vertices", "thickness", "unit_weight",
                                      "density",  "support",  "rigid",     "law",
                                      "material", "ring",     "ring_law" };
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  if (!qn_json_value_object (place) || !qn_read_own_name (place, "b", text, &name)
      || !qn_json_value_check_keys (place, keys, G_N_ELEMENTS (keys)))
    return FALSE;

  GArray *vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnVec2), 8);
  gboolean done = read_vertices (place, vertices);
  if (done) {
    QnBlock *block =
      qn_model_add_block (model, name, (const QnVec2 *) vertices->data, vertices->len);
    done = block != NULL ? read_block_properties (place, model, block)
                         : qn_json_value_no_memory (place);
  }
  g_array_unref (vertices);
  return done;
}

static gboolean
read_course (const QnJsonValue *place, QnWall *wall)
{
  if (!qn_json_value_array (place))
    return FALSE;
  GArray *lengths = g_array_new (FALSE, FALSE, sizeof (double));
  QnJsonValue element = { 0 };
  gboolean done = TRUE;
  while (done && qn_json_value_next (place, &element)) {
    double length = 0;
    done = qn_json_value_number (&element, QN_RANGE_FINITE, &length);
    if (done && length == 0)
      done = qn_json_value_fail (&element,
                                 _ (qn_problem_text (QN_PROBLEM_COURSE_LENGTH_ZERO)));
    else if (done && fabs (length) > QN_MAX_COURSE_LENGTH)
      done = qn_json_value_fail (&element, _ (qn_problem_text (QN_PROBLEM_TOO_LARGE)));
    g_array_append_val (lengths, length);
  }
  if (done && !qn_wall_add_course (wall, (const double *) lengths->data, lengths->len))
    done = qn_json_value_no_memory (place);
  g_array_unref (lengths);
  return done;
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
  static const char *const keys[] = { "name",      "origin",      "unit",
                                      "thickness", "unit_weight", "density",
                                      "courses",   "law",         "material" };
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  if (!qn_json_value_object (place) || !qn_read_own_name (place, "w", text, &name)
      || !qn_json_value_check_keys (place, keys, G_N_ELEMENTS (keys)))
    return FALSE;

  QnWall *wall = qn_model_add_wall (model, name);
  if (wall == NULL)
    return qn_json_value_no_memory (place);
  return qn_member_vec2 (place, "origin", QN_OPTIONAL, &wall->origin)
         && qn_member_vec2 (place, "unit", QN_REQUIRED, &wall->unit)
         && qn_member_number (place, "thickness", QN_REQUIRED, QN_RANGE_POSITIVE,
                              &wall->thickness)
         && qn_read_weight (place, model, &wall->unit_weight, &wall->density)
         && qn_read_own_law (place, model, &wall->law) && qn_read_courses (place, wall);
}

void
qn_json_put_support (GString *json, const bool support[QN_DOF_COUNT])
{
  if (!qn_support_is_any (support))
    return;
  qn_json_begin_member (json, "support");
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    g_string_append_printf (json, "%s%s", dof > 0 ? ", " : "[",
                            support[dof] ? "true" : "false");
  g_string_append_c (json, ']');
}

static void
append_block (GString *json, const QnModel *model, size_t index)
{
  const QnBlock *block = &model->blocks[index];
  qn_json_put_string (json, "name", block->name);
  qn_json_put_points (json, "vertices", qn_model_block_vertices (model, (QnId) index),
                      (gsize) block->vertex_count);
  qn_json_put_number (json, "thickness", block->thickness);
  qn_json_put_weight (json, block->unit_weight, block->density);
  qn_json_put_support (json, block->support);
  if (block->rigid) {
    qn_json_begin_member (json, "rigid");
    g_string_append (json, "true");
  }
  qn_json_put_law (json, model, block->law);
  qn_json_put_unusual (json, "ring", block->ring, 0);
  if (block->ring_law != QN_NONE)
    qn_json_put_string (json, "ring_law", model->laws[block->ring_law].name);
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
  qn_json_put_vec2 (json, "origin", wall->origin);
  qn_json_put_vec2 (json, "unit", wall->unit);
  qn_json_put_number (json, "thickness", wall->thickness);
  qn_json_put_weight (json, wall->unit_weight, wall->density);
  qn_json_put_law (json, model, wall->law);
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
