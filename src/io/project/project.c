#include "io/project/project.h"

#include "core/contact/plausible.h"
#include "io/json/json-path.h"
#include "io/json/json-value.h"
#include "io/project/project-masonry.h"
#include "io/project/project-parts.h"
#include "io/project/typical-joint.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

void
qn_project_init (QnProject *project)
{
  *project = (QnProject){ .warnings = g_ptr_array_new_with_free_func (g_free) };
  qn_model_init (&project->model);
}

static gboolean
begin (QnModel *model, const char *name)
{
  QnLaw *law = qn_model_add_law (model, name);
  QnLoad *dead = qn_model_add_dead_load (model), *live = qn_model_add_live_load (model);
  if (law == NULL || dead == NULL || live == NULL
      || !qn_law_make_joint (law, QN_JOINT_DRY_STONE))
    return FALSE;
  model->contact.law = 0;
  dead->vector = qn_vec2 (0, -1);
  live->vector = qn_vec2 (1, 0);
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  return TRUE;
}

gboolean
qn_project_begin (QnProject *project, const char *law, GError **error)
{
  qn_project_init (project);
  if (begin (&project->model, law) && qn_project_prepare (project, error))
    return TRUE;
  if (error != NULL && *error == NULL)
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY,
                         _ ("not enough memory"));
  qn_project_clear (project);
  return FALSE;
}

void
qn_project_clear (QnProject *project)
{
  qn_model_clear (&project->model);
  g_free (project->name);
  g_free (project->path);
  g_free (project->sha256);
  g_strfreev (project->overrides);
  g_clear_pointer (&project->warnings, g_ptr_array_unref);
  cJSON_Delete (project->extras);
  g_free (project->text);
  *project = (QnProject){ 0 };
}

/* Its values are in no text that messages could point to. */
static void
forget_places (cJSON *value)
{
  value->valueint = 0;
  for (cJSON *item = value->child; item != NULL; item = item->next)
    forget_places (item);
}

gboolean
qn_project_copy (const QnProject *project, QnProject *copy, GError **error)
{
  *copy = (QnProject){ 0 };
  if (qn_model_copy (&project->model, &copy->model, NULL) != QN_OK)
    return qn_io_fail (error, QN_IO_ERROR_NO_MEMORY, "%s", _ ("not enough memory"));
  copy->extras = cJSON_Duplicate (project->extras, 1);
  if (copy->extras != NULL)
    forget_places (copy->extras);
  copy->name = g_strdup (project->name);
  copy->path = g_strdup (project->path);
  copy->warnings = g_ptr_array_ref (project->warnings);
  return TRUE;
}

gboolean
qn_project_prepare (QnProject *project, GError **error)
{
  QnDiag diag;
  qn_project_drop_detached (project);
  if (qn_model_prepare (&project->model, &diag) == QN_OK)
    return TRUE;
  qn_project_set_error (project, &diag, error);
  return FALSE;
}

/* Key path of a block that a wall was expanded into: its entry among the courses. */
static void
append_wall_block (GString *path, const QnModel *model, const QnBlock *block)
{
  const QnWall *wall = &model->walls[block->wall];
  int32_t course = 0, above = wall->course_count;
  while (course < above) {
    int32_t middle = course + (above - course) / 2;
    if (wall->course_ends[middle] <= block->wall_entry)
      course = middle + 1;
    else
      above = middle;
  }
  int32_t start = course > 0 ? wall->course_ends[course - 1] : 0;
  g_string_append_printf (path, "walls[%d].courses[%d][%d]", block->wall, course,
                          block->wall_entry - start);
}

char *
qn_project_dup_key_path (const QnProject *project, QnEntity entity, QnId index)
{
  static const char *const containers[] = {
    [QN_ENTITY_MODEL] = "",
    [QN_ENTITY_LAW] = "laws",
    [QN_ENTITY_BLOCK] = "blocks",
    [QN_ENTITY_WALL] = "walls",
    [QN_ENTITY_CONTACT] = "contact",
    [QN_ENTITY_FACE_OVERRIDE] = "contact.faces",
    [QN_ENTITY_BAR] = "bars",
    [QN_ENTITY_TIE] = "ties",
    [QN_ENTITY_VEHICLE] = "vehicles",
    [QN_ENTITY_NODE] = "nodes",
    [QN_ENTITY_SECTION] = "sections",
    [QN_ENTITY_BEAM] = "beams",
    [QN_ENTITY_DEAD_LOAD] = "loads.dead",
    [QN_ENTITY_LIVE_LOAD] = "loads.live",
    [QN_ENTITY_LOAD_CASE] = "loads.cases",
    [QN_ENTITY_ANALYSIS] = "analysis",
    [QN_ENTITY_STAGE] = "analysis.stages",
    [QN_ENTITY_GROUND_MOTION] = "analysis.dynamic.ground",
    [QN_ENTITY_INITIAL_MOTION] = "analysis.dynamic.initial",
    [QN_ENTITY_TRACK] = "analysis.dynamic.track",
    [QN_ENTITY_MASONRY] = "masonry",
  };
  const QnModel *model = &project->model;
  GString *path = g_string_new (NULL);
  if (entity == QN_ENTITY_BLOCK && index >= 0 && (size_t) index < model->block_count
      && model->blocks[index].masonry != QN_NONE) {
    entity = QN_ENTITY_MASONRY;
    index = model->blocks[index].masonry;
  }
  if (entity == QN_ENTITY_BLOCK && index >= 0 && (size_t) index < model->block_count
      && model->blocks[index].wall != QN_NONE) {
    append_wall_block (path, model, &model->blocks[index]);
  } else if (entity == QN_ENTITY_LIVE_LOAD && index >= 0
             && (size_t) index < model->live_load_count) {
    /* Key path of a load that is not dead: its entry in the list of its set. */
    int32_t set = model->live_loads[index].set;
    gsize place = 0;
    for (QnId i = 0; i < index; i++)
      place += model->live_loads[i].set == set;
    g_string_append (path, set == 0 ? "loads" : "loads.sets");
    qn_json_path_append (path, qn_model_load_set_name (model, set), 0);
    qn_json_path_append (path, NULL, place);
  } else if (entity == QN_ENTITY_LOAD_CASE && index >= 0
             && (size_t) index < model->load_case_count) {
    g_string_append (path, containers[entity]);
    qn_json_path_append (path, model->load_cases[index].name, 0);
  } else {
    g_string_append (path, containers[entity]);
    gboolean is_list = entity != QN_ENTITY_MODEL && entity != QN_ENTITY_CONTACT
                       && entity != QN_ENTITY_ANALYSIS;
    if (entity == QN_ENTITY_STAGE && index >= 0)
      index = (QnId) qn_project_stage_entry (model, (gsize) index);
    if (is_list && index != QN_NONE)
      g_string_append_printf (path, "[%d]", index);
  }
  return g_string_free (path, FALSE);
}

/* Path of the key that a diagnostic is about. */
static char *
dup_problem_path (const QnProject *project, const QnDiag *diag)
{
  g_autofree char *entity = qn_project_dup_key_path (project, diag->entity, diag->index);
  GString *path = g_string_new (entity);
  if (diag->entity == QN_ENTITY_MASONRY && diag->sub != QN_NONE) {
    g_string_append_printf (path, ".openings[%d]", diag->sub);
    if (g_strcmp0 (diag->field, "openings") == 0)
      return g_string_free (path, FALSE);
  } else if (diag->entity == QN_ENTITY_MASONRY && diag->other != QN_NONE) {
    g_string_append_printf (path, ".leaves[%d]", diag->other);
  }
  if (diag->field == NULL)
    return g_string_free (path, FALSE);

  g_string_append_printf (path, "%s%s", path->len > 0 ? "." : "", diag->field);
  gboolean in_course = strcmp (diag->field, "courses") == 0;
  /* Other problems of a polygon are those of all vertices together. */
  gboolean at_vertex = strcmp (diag->field, "vertices") == 0
                       && (diag->problem == QN_PROBLEM_DUPLICATE_VERTEX
                           || diag->problem == QN_PROBLEM_NOT_FINITE
                           || diag->problem == QN_PROBLEM_TOO_LARGE);
  gboolean at_point = strcmp (diag->field, "points") == 0;
  if ((in_course || at_vertex || at_point) && diag->sub != QN_NONE)
    g_string_append_printf (path, "[%d]", diag->sub);
  if (in_course && diag->sub != QN_NONE && diag->other != QN_NONE)
    g_string_append_printf (path, "[%d]", diag->other);
  return g_string_free (path, FALSE);
}

/* (block "a") or (blocks "a" and "b") */
static void
append_block_names (GString *message, const QnModel *model, QnId a, QnId b)
{
  if (a < 0 || (size_t) a >= model->block_count)
    return;
  gboolean two = b >= 0 && (size_t) b < model->block_count;
  g_string_append (message, two ? _ (" (blocks ") : _ (" (block "));
  qn_json_append_string (message, model->blocks[a].name);
  if (two) {
    g_string_append (message, _ (" and "));
    qn_json_append_string (message, model->blocks[b].name);
  }
  g_string_append_c (message, ')');
}

QnReader
qn_project_reader (const QnProject *project)
{
  return (QnReader){ .name = project->name != NULL ? project->name : _ ("project"),
                     .text = project->text,
                     .length = project->text_length,
                     .overrides = (const char *const *) project->overrides };
}

void
qn_project_set_error (const QnProject *project, const QnDiag *diag, GError **error)
{
  QnReader reader = qn_project_reader (project);
  if (diag->status == QN_ERROR_NO_MEMORY) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", reader.name,
                 _ ("not enough memory"));
    return;
  }
  g_autoptr (GString) message = g_string_new (_ (qn_problem_text (diag->problem)));
  if (diag->entity == QN_ENTITY_BLOCK)
    append_block_names (message, &project->model, diag->index, diag->other);
  g_autofree char *path = dup_problem_path (project, diag);
  qn_project_set_key_error (project, path, message->str, error);
}

void
qn_project_set_key_error (const QnProject *project, const char *path, const char *message,
                          GError **error)
{
  QnReader reader = qn_project_reader (project);
  g_autofree char *line = qn_reader_dup_line (&reader, path, NULL, message);
  g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, line);
}

char *
qn_project_dup_finding_value (const QnFinding *finding, const char *unit, double factor)
{
  const unsigned long joints = (unsigned long) finding->subject;
  if (finding->problem == QN_PROBLEM_PAIRS_BENDING)
    return g_strdup_printf (
      ngettext ("%.3g times the true one at %lu joint, which makes buckling and large "
                "displacements wrong; use the default pairs",
                "%.3g times the true one at %lu joints, which makes buckling and large "
                "displacements wrong; use the default pairs",
                joints),
      finding->value, joints);
  if (finding->problem == QN_PROBLEM_PAIRS_CRUSHING)
    return g_strdup_printf (
      ngettext ("up to %.3g times the moment of the stress block at %lu joint, which is "
                "unsafe; use a law by area with the default pairs, or with 20 even ones",
                "up to %.3g times the moment of the stress block at %lu joints, which is "
                "unsafe; use a law by area with the default pairs, or with 20 even ones",
                joints),
      finding->value, joints);
  if (finding->problem == QN_PROBLEM_BLOCK_SLIVER && joints > 1)
    return g_strdup_printf (_ ("the first of %lu side by side"), joints);
  return finding->value != 0 ? g_strdup_printf ("%.3g %s", factor * finding->value, unit)
                             : NULL;
}

char *
qn_range_dup_text (const QnFinding *finding)
{
  const QnUsualRange *range = finding->range;
  g_autoptr (GString) text = g_string_new (NULL);
  if (range->least > 0)
    g_string_printf (text, _ ("%.4g %s, where %.4g to %.4g is usual"), finding->value,
                     range->unit, range->least, range->greatest);
  else
    g_string_printf (text, _ ("%.4g %s, where up to %.4g is usual"), finding->value,
                     range->unit, range->greatest);
  g_string_replace (text, " ,", ",", 0); /* of a bare number */
  g_string_append_printf (text, ": %s", _ (qn_problem_text (finding->problem)));
  return g_strdup (text->str);
}

/* Text of a finding without its place. */
static char *
dup_finding_message (const QnProject *project, const QnFinding *finding)
{
  if (finding->range != NULL)
    return qn_range_dup_text (finding);
  GString *message = g_string_new (_ (qn_problem_text (finding->problem)));
  append_block_names (message, &project->model, finding->block_a, finding->block_b);
  if (finding->block_b != QN_NONE)
    g_string_append_printf (message, _ (" at (%.6g, %.6g) m"), finding->at.x,
                            finding->at.y);
  g_autofree char *value = qn_project_dup_finding_value (finding, "m", 1);
  if (value != NULL)
    g_string_append_printf (message, ": %s", value);
  return g_string_free (message, FALSE);
}

static char *
dup_finding_path (const QnProject *project, const QnFinding *finding)
{
  const QnId dead = (QnId) project->model.dead_load_count;
  if (finding->range != NULL) {
    /* The key of a number that is in doubt; blocks of walls and of masonry stand for
     * their object. */
    const QnUsualRange *range = finding->range;
    g_autofree char *path =
      qn_project_dup_key_path (project, range->entity, finding->subject);
    if (g_str_has_prefix (path, "walls["))
      path[strcspn (path, ".")] = '\0';
    return g_strdup_printf ("%s%s%s", path, *path != '\0' ? "." : "", range->key);
  }
  switch ((int) finding->problem) {
  case QN_PROBLEM_DOUBT_NO_DEAD_LOAD:
    return g_strdup ("loads.dead");
  case QN_PROBLEM_BEAM_FLOATING:
  case QN_PROBLEM_BEAM_END_FREE:
    return qn_project_dup_key_path (project, QN_ENTITY_BEAM, finding->subject);
  case QN_PROBLEM_TIE_OFF_BLOCK:
    return qn_project_dup_key_path (project, QN_ENTITY_TIE, finding->subject);
  case QN_PROBLEM_LOAD_MEETS_NOTHING:
  case QN_PROBLEM_LOAD_OFF_BLOCK:
  case QN_PROBLEM_LOAD_BESIDE:
    return finding->subject < dead
             ? qn_project_dup_key_path (project, QN_ENTITY_DEAD_LOAD, finding->subject)
             : qn_project_dup_key_path (project, QN_ENTITY_LIVE_LOAD,
                                        finding->subject - dead);
  case QN_PROBLEM_LAW_CHAIN:
  case QN_PROBLEM_LAW_GRID:
    return g_strdup_printf ("laws[%d].arrangement", (int) finding->subject);
  case QN_PROBLEM_LAW_SHEAR:
    return g_strdup_printf ("laws[%d].kind", (int) finding->subject);
  case QN_PROBLEM_PAIRS_BENDING:
  case QN_PROBLEM_PAIRS_CRUSHING:
    return g_strdup ("contact.pairs");
  default:
    return qn_project_dup_key_path (project, QN_ENTITY_BLOCK, finding->block_a);
  }
}

GPtrArray *
qn_project_dup_finding_texts (const QnProject *project, const QnFindings *findings)
{
  GPtrArray *lines = g_ptr_array_new_with_free_func (g_free);
  QnReader reader = qn_project_reader (project);
  if (findings->count == 0)
    return lines;
  g_autoptr (GPtrArray) paths = g_ptr_array_new_with_free_func (g_free);
  for (size_t i = 0; i < findings->count; i++)
    g_ptr_array_add (paths, dup_finding_path (project, &findings->items[i]));
  g_autofree QnJsonPlace *places =
    reader.text != NULL ? qn_json_locate_all (reader.text, reader.length, paths) : NULL;
  for (size_t i = 0; i < findings->count; i++) {
    g_autofree char *message = dup_finding_message (project, &findings->items[i]);
    g_ptr_array_add (lines,
                     qn_reader_dup_line (&reader, paths->pdata[i],
                                         places != NULL ? &places[i] : NULL, message));
  }
  return lines;
}

void
qn_project_put_extra (QnProject *project, const char *member, cJSON *value)
{
  if (project->extras == NULL)
    project->extras = cJSON_CreateObject ();
  if (value != NULL)
    forget_places (value);
  if (value == NULL)
    cJSON_DeleteItemFromObjectCaseSensitive (project->extras, member);
  else if (!cJSON_ReplaceItemInObjectCaseSensitive (project->extras, member, value))
    cJSON_AddItemToObject (project->extras, member, value);
}

gboolean
qn_project_set_extra (QnProject *project, const char *member, const char *json,
                      GError **error)
{
  cJSON *value = json != NULL ? qn_json_parse (json, strlen (json), member, error) : NULL;
  if (json != NULL && value == NULL)
    return FALSE;
  qn_project_put_extra (project, member, value);
  return TRUE;
}

char *
qn_project_dup_extra (const QnProject *project, const char *member)
{
  const cJSON *value = cJSON_GetObjectItemCaseSensitive (project->extras, member);
  if (value == NULL)
    return NULL;
  GString *json = g_string_new (NULL);
  qn_json_append_value (json, value, 0);
  return g_string_free (json, FALSE);
}
