#include "io/project/block-lines.h"
#include "io/project/project-inner.h"
#include "io/project/project-masonry.h"
#include "io/project/project-names.h"
#include "io/project/project-write-parts.h"
#include "io/project/project.h"
#include "io/text/file-writer.h"
#include "io/text/json-text.h"

#include <cjson/cJSON.h>
#include <math.h>

static void
put_law (GString *json, const char *key, const QnModel *model, QnId law)
{
  if (law != QN_NONE)
    qn_json_put_string (json, key, model->laws[law].name);
}

/* Parameters that are left out by default are left out where they have no effect. */
static void
append_law (GString *json, const QnLaw *law)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  g_string_append_c (json, '{');
  qn_json_put_string (json, "name", law->name);
  qn_json_put_string (json, "kind", qn_name_of_law_kind ((int) law->kind));
  qn_json_put_string (json, "basis", qn_name_of_basis ((int) law->basis));
  qn_json_put_number (json, "kn", law->kn);
  qn_json_put_number (json, "ks", law->ks);
  if (law->shear_factor > 0)
    qn_json_put_number (json, "shear_factor", law->shear_factor);
  for (size_t i = 0; i < count; i++) {
    double value = qn_law_get (law, &parameters[i]);
    if (value != 0 || !parameters[i].positive)
      qn_json_put_number (json, parameters[i].key, value);
  }
  if (law->kind == QN_LAW_CURVE) {
    qn_json_begin_member (json, "points");
    for (int32_t i = 0; i < law->point_count; i++) {
      g_string_append (json, i > 0 ? ", " : "[");
      qn_json_append_vec2 (json, law->points[i]);
    }
    g_string_append_c (json, ']');
  }
  g_string_append (json, " }");
}

/* Weight the way it was given. */
static void
put_weight (GString *json, double unit_weight, double density)
{
  if (density >= 0)
    qn_json_put_number (json, "density", density);
  else
    qn_json_put_number (json, "unit_weight", unit_weight);
}

void
qn_json_put_support (GString *json, const bool support[QN_DOF_COUNT])
{
  if (!support[QN_DOF_UX] && !support[QN_DOF_UY] && !support[QN_DOF_RZ])
    return;
  qn_json_begin_member (json, "support");
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    g_string_append_printf (json, "%s%s", dof > 0 ? ", " : "[",
                            support[dof] ? "true" : "false");
  g_string_append_c (json, ']');
}

static void
append_block (GString *json, const QnModel *model, QnId id)
{
  const QnBlock *block = &model->blocks[id];
  const QnVec2 *vertices = qn_model_block_vertices (model, id);
  g_string_append_c (json, '{');
  qn_json_put_string (json, "name", block->name);
  qn_json_begin_member (json, "vertices");
  for (QnId i = 0; i < block->vertex_count; i++) {
    g_string_append (json, i > 0 ? ", " : "[");
    qn_json_append_vec2 (json, vertices[i]);
  }
  g_string_append (json, block->vertex_count > 0 ? "]" : "[]");
  qn_json_put_number (json, "thickness", block->thickness);
  put_weight (json, block->unit_weight, block->density);
  qn_json_put_support (json, block->support);
  put_law (json, "law", model, block->law);
  g_string_append (json, " }");
}

static void
append_wall (GString *json, const QnModel *model, const QnWall *wall)
{
  g_string_append_c (json, '{');
  qn_json_put_string (json, "name", wall->name);
  qn_json_put_vec2 (json, "origin", wall->origin);
  qn_json_put_vec2 (json, "unit", wall->unit);
  qn_json_put_number (json, "thickness", wall->thickness);
  put_weight (json, wall->unit_weight, wall->density);
  put_law (json, "law", model, wall->law);
  g_string_append (json, ",\n      \"courses\": [");
  int32_t entry = 0;
  for (int32_t course = 0; course < wall->course_count; course++) {
    g_string_append (json, course > 0 ? ",\n        [" : "\n        [");
    for (int32_t start = entry; entry < wall->course_ends[course]; entry++) {
      g_string_append (json, entry > start ? ", " : "");
      qn_json_append_number (json, wall->lengths[entry]);
    }
    g_string_append_c (json, ']');
  }
  g_string_append (json, " ] }");
}

static void
put_numbers (GString *json, const char *key, const double *numbers, int32_t count)
{
  qn_json_begin_member (json, key);
  for (int32_t i = 0; i < count; i++) {
    g_string_append (json, i > 0 ? ", " : "[");
    qn_json_append_number (json, numbers[i]);
  }
  g_string_append_c (json, ']');
}

static void
put_pair_rule (GString *json, const QnPairRule *rule)
{
  qn_json_begin_member (json, "pairs");
  g_string_append_c (json, '{');
  qn_json_put_string (json, "placement", qn_name_of_placement ((int) rule->placement));
  switch (rule->placement) {
  case QN_PLACEMENT_ENDS:
    qn_json_put_number (json, "offset", rule->offset);
    break;
  case QN_PLACEMENT_UNIFORM:
  case QN_PLACEMENT_GAUSS:
    qn_json_put_number (json, "count", rule->count);
    break;
  case QN_PLACEMENT_EXPLICIT:
    put_numbers (json, "positions", rule->positions, rule->count);
    put_numbers (json, "weights", rule->weights, rule->count);
    break;
  case QN_PLACEMENT_COUNT:
    g_assert_not_reached ();
  }
  g_string_append (json, " }");
}

static void
append_face (GString *json, const QnModel *model, const QnFaceOverride *face)
{
  g_string_append_c (json, '{');
  qn_json_begin_member (json, "blocks");
  g_string_append_c (json, '[');
  qn_json_append_string (json, model->blocks[face->block_a].name);
  g_string_append (json, ", ");
  qn_json_append_string (json, model->blocks[face->block_b].name);
  g_string_append_c (json, ']');
  put_law (json, "law", model, face->law);
  if (face->has_pairs)
    put_pair_rule (json, &face->pairs);
  g_string_append (json, " }");
}

static void
append_contact (GString *json, const QnModel *model, GHashTable *inner)
{
  g_string_append (json, "  \"contact\": {");
  put_law (json, "law", model, model->contact.law);
  qn_json_put_number (json, "tolerance", model->contact.tolerance);
  put_pair_rule (json, &model->contact.pairs);
  qn_json_append_inner (json, inner, "contact.pairs");
  if (model->override_count > 0) {
    g_string_append (json, ",\n    \"faces\": [\n      ");
    for (size_t i = 0; i < model->override_count; i++) {
      g_string_append (json, i > 0 ? ",\n      " : "");
      append_face (json, model, &model->overrides[i]);
      qn_json_append_note (json, inner, model->overrides[i].note);
    }
    g_string_append (json, " ]");
  }
  g_string_append (json, " }");
}

static void
append_bars (GString *json, const QnModel *model, GHashTable *inner)
{
  if (model->bar_count == 0)
    return;
  g_string_append (json, "  \"bars\": [");
  for (size_t i = 0; i < model->bar_count; i++) {
    const QnBar *bar = &model->bars[i];
    g_string_append (json, i > 0 ? ",\n    {" : "\n    {");
    put_law (json, "law", model, bar->law);
    qn_json_put_number (json, "area", bar->area);
    qn_json_put_vec2 (json, "start", bar->start);
    qn_json_put_vec2 (json, "end", bar->end);
    g_string_append (json, " }");
    qn_json_append_note (json, inner, bar->note);
  }
  g_string_append (json, " ],\n");
}

static gboolean
uses_density (const QnModel *model)
{
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].density >= 0)
      return TRUE;
  for (size_t i = 0; i < model->wall_count; i++)
    if (model->walls[i].density >= 0)
      return TRUE;
  for (size_t i = 0; i < model->section_count; i++)
    if (model->sections[i].density >= 0)
      return TRUE;
  return FALSE;
}

static void
append_head (GString *json, const QnModel *model)
{
  g_string_append (json, "{\n  \"format\": \"quoin\", \"version\": 1,\n");
  if (model->title != NULL) {
    g_string_append (json, "  \"title\": ");
    qn_json_append_string (json, model->title);
    g_string_append (json, ",\n");
  }
  if (uses_density (model)) {
    g_string_append (json, "  \"gravity\": ");
    qn_json_append_number (json, model->gravity);
    g_string_append (json, ",\n");
  }
}

static void
append_structure (GString *json, const QnModel *model, GHashTable *inner,
                  const QnBlockLines *like)
{
  g_string_append (json, "  \"laws\": [");
  for (size_t i = 0; i < model->law_count; i++) {
    g_string_append (json, i > 0 ? ",\n    " : "\n    ");
    append_law (json, &model->laws[i]);
    qn_json_append_note (json, inner, model->laws[i].note);
  }
  g_string_append (json, " ],\n  \"blocks\": [");
  gboolean first = TRUE;
  for (size_t i = 0; i < model->block_count && model->blocks[i].wall == QN_NONE; i++) {
    if (model->blocks[i].masonry != QN_NONE)
      continue;
    g_string_append (json, first ? "\n    " : ",\n    ");
    first = FALSE;
    if (like != NULL && qn_block_lines_append_same (json, like, model, (QnId) i))
      continue;
    append_block (json, model, (QnId) i);
    qn_json_append_note (json, inner, model->blocks[i].note);
  }
  g_string_append (json, " ],\n");
  if (model->wall_count == 0)
    return;

  g_string_append (json, "  \"walls\": [");
  for (size_t i = 0; i < model->wall_count; i++) {
    g_string_append (json, i > 0 ? ",\n    " : "\n    ");
    append_wall (json, model, &model->walls[i]);
    qn_json_append_note (json, inner, model->walls[i].note);
  }
  g_string_append (json, " ],\n");
}

static gboolean
has_any_masonry (const QnModel *model)
{
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      return TRUE;
  return FALSE;
}

/* The objects that were not detached. */
static void
append_masonry (GString *json, const QnProject *project, const cJSON *list)
{
  gboolean first = TRUE;
  QnId index = 0;
  g_string_append_c (json, '[');
  for (const cJSON *item = list->child; item != NULL; item = item->next, index++) {
    if (!qn_project_has_masonry (project, index))
      continue;
    g_string_append (json, first ? "\n    " : ",\n    ");
    qn_json_append_value (json, item, 4);
    first = FALSE;
  }
  g_string_append (json, " ]");
}

static char *
write_text (const QnProject *project, const QnBlockLines *like, gsize *length)
{
  const QnModel *model = &project->model;
  GString *json = g_string_sized_new (like != NULL ? like->length + 4096 : 4096);
  append_head (json, model);
  GHashTable *inner = qn_project_index_inner (project);
  append_structure (json, model, inner, like);
  qn_project_append_beams (json, model, inner);
  append_contact (json, model, inner);
  qn_json_append_inner (json, inner, "contact");
  g_string_append (json, ",\n");
  append_bars (json, model, inner);
  qn_project_append_loads (json, model, inner);
  qn_json_append_inner (json, inner, "loads");
  g_string_append (json, ",\n");
  qn_project_append_analysis (json, model, inner);
  qn_json_append_inner (json, inner, "analysis");
  g_clear_pointer (&inner, g_hash_table_unref);

  const cJSON *extra = project->extras != NULL ? project->extras->child : NULL;
  for (; extra != NULL; extra = extra->next) {
    gboolean masonry = g_strcmp0 (extra->string, QN_MASONRY_MEMBER) == 0;
    if ((masonry && !has_any_masonry (model))
        || g_strcmp0 (extra->string, QN_INNER_MEMBER) == 0)
      continue;
    g_string_append (json, ",\n  ");
    qn_json_append_string (json, extra->string);
    g_string_append (json, ": ");
    if (masonry)
      append_masonry (json, project, extra);
    else
      qn_json_append_value (json, extra, 2);
  }
  g_string_append (json, "\n}\n");
  if (length != NULL)
    *length = json->len;
  return g_string_free (json, FALSE);
}

char *
qn_project_to_text (const QnProject *project, gsize *length)
{
  return write_text (project, NULL, length);
}

char *
qn_project_to_text_like (const QnProject *project, const QnProject *like,
                         const char *like_text, gsize *length)
{
  QnBlockLines lines;
  gboolean found = !qn_project_has_inner_blocks (project)
                   && qn_block_lines_find (&lines, like, like_text);
  char *text = write_text (project, found ? &lines : NULL, length);
  if (found)
    qn_block_lines_clear (&lines);
  return text;
}

gboolean
qn_project_save (const QnProject *project, const char *path, GError **error)
{
  gsize length;
  char *text = qn_project_to_text (project, &length);
  gboolean saved = qn_file_write (path, text, length, error);
  g_free (text);
  return saved;
}
