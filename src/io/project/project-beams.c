/* Sections, nodes and beams of a project file. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>

/* A member that has no meaning next to another one. */
static gboolean
exclude (const QnJsonValue *place, const char *key, const char *other)
{
  if (!cJSON_HasObjectItem (place->json, key)
      || !cJSON_HasObjectItem (place->json, other))
    return TRUE;
  QnJsonValue member = qn_json_value_member (place, key);
  return qn_json_value_failf (&member, _ ("%s and %s exclude each other"), key, other);
}

static gboolean
read_entity_name (const QnJsonValue *place, const char **name)
{
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "name", QN_REQUIRED, name))
    return FALSE;
  QnJsonValue member = qn_json_value_member (place, "name");
  return (*name)[0] != '\0'
         || qn_json_value_fail (&member, _ (qn_problem_text (QN_PROBLEM_NAME_MISSING)));
}

static const QnMember section_members[] = {
  QN_KNOWN ("name"),
  QN_NUMBER ("young", REQUIRED, POSITIVE, QnSection, young),
  QN_NUMBER ("shear_modulus", OPTIONAL, POSITIVE, QnSection, shear_modulus),
  QN_NUMBER ("poisson", OPTIONAL, FINITE, QnSection, poisson),
  QN_NUMBER ("width", OPTIONAL, POSITIVE, QnSection, width),
  QN_NUMBER ("height", OPTIONAL, POSITIVE, QnSection, height),
  QN_NUMBER ("area", OPTIONAL, POSITIVE, QnSection, area),
  QN_NUMBER ("inertia", OPTIONAL, POSITIVE, QnSection, inertia),
  QN_NUMBER ("shear_factor", WRITTEN, POSITIVE, QnSection, shear_factor),
  QN_NUMBER ("yield", OPTIONAL, POSITIVE, QnSection, yield),
  QN_NUMBER ("plastic_moment", OPTIONAL, POSITIVE, QnSection, plastic_moment),
  QN_KNOWN ("density"),
  QN_KNOWN ("unit_weight"),
  { 0 },
};

/* A rectangle, or area and inertia. */
static gboolean
read_section (const QnJsonValue *place, QnModel *model)
{
  const char *name;
  double number;
  if (!read_entity_name (place, &name)
      || !qn_members_check (place, section_members, NULL, NULL))
    return FALSE;
  QnSection *section = qn_model_add_section (model, name);
  if (section == NULL)
    return qn_json_value_no_memory (place);
  gboolean rectangle = cJSON_HasObjectItem (place->json, "width")
                       || cJSON_HasObjectItem (place->json, "height");
  gboolean heavy = cJSON_HasObjectItem (place->json, "unit_weight")
                   || cJSON_HasObjectItem (place->json, "density");
  return exclude (place, "shear_modulus", "poisson")
         && exclude (place, "plastic_moment", "yield")
         && exclude (place, "area", "height") && exclude (place, "area", "width")
         && exclude (place, "inertia", "height") && exclude (place, "inertia", "width")
         && qn_members_take (place, section_members, model, section)
         && qn_member_number (place, rectangle ? "width" : "area", QN_REQUIRED,
                              QN_RANGE_POSITIVE, &number)
         && qn_member_number (place, rectangle ? "height" : "inertia", QN_REQUIRED,
                              QN_RANGE_POSITIVE, &number)
         && (!heavy
             || qn_read_weight (place, model, &section->unit_weight, &section->density));
}

static gboolean
read_seat (const QnJsonValue *place, const QnModel *model, QnNode *node)
{
  gboolean at = cJSON_HasObjectItem (place->json, "at");
  gboolean side = cJSON_HasObjectItem (place->json, "side");
  if (!cJSON_HasObjectItem (place->json, "block")) {
    QnJsonValue member = qn_json_value_member (place, "side");
    return side ? qn_json_value_fail (&member, _ ("side needs a block"))
                : qn_member_vec2 (place, "at", QN_REQUIRED, &node->at);
  }
  node->seat = at ? QN_SEAT_POINT : side ? QN_SEAT_SIDE : QN_SEAT_CENTROID;
  return exclude (place, "side", "at")
         && qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK,
                          &node->block)
         && qn_member_vec2 (place, "at", QN_OPTIONAL, &node->at)
         && qn_member_choice (place, "side", QN_OPTIONAL, qn_block_side_names,
                              QN_BLOCK_SIDE_COUNT, &node->side);
}

static gboolean
read_node (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "name", "at", "block", "side", "support" };
  const char *name;
  if (!read_entity_name (place, &name)
      || !qn_json_value_check_keys (place, keys, G_N_ELEMENTS (keys)))
    return FALSE;
  QnNode *node = qn_model_add_node (model, name);
  if (node == NULL)
    return qn_json_value_no_memory (place);
  return read_seat (place, model, node) && qn_read_support (place, node->support);
}

/* ["a", "b"]: exactly two elements. */
static gboolean
read_two (const QnJsonValue *list)
{
  return qn_json_value_array (list)
         && (cJSON_GetArraySize (list->json) == 2
             || qn_json_value_fail (list, _ ("expected two values, one for each end")));
}

static gboolean
read_ends (const QnJsonValue *place, const QnModel *model, QnBeam *beam)
{
  QnJsonValue nodes = qn_json_value_member (place, "nodes"), hinges;
  if (!read_two (&nodes))
    return FALSE;
  for (int end = 0; end < 2; end++) {
    QnJsonValue name =
      qn_json_value_element (&nodes, (gsize) end, cJSON_GetArrayItem (nodes.json, end));
    if (!cJSON_IsString (name.json))
      return qn_json_value_fail (&name, _ ("expected the name of a node"));
    if (!qn_read_name_of (&name, model, QN_NAMED_NODE, &beam->nodes[end]))
      return FALSE;
  }
  hinges = qn_json_value_member (place, "hinges");
  if (hinges.json == NULL)
    return TRUE;
  if (!read_two (&hinges))
    return FALSE;
  for (int end = 0; end < 2; end++) {
    QnJsonValue flag =
      qn_json_value_element (&hinges, (gsize) end, cJSON_GetArrayItem (hinges.json, end));
    if (!cJSON_IsBool (flag.json))
      return qn_json_value_fail (&flag, _ ("expected true or false"));
    beam->hinge[end] = cJSON_IsTrue (flag.json);
  }
  return TRUE;
}

static gboolean
read_beam (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "name",   "nodes",    "section",
                                      "hinges", "elements", "kind" };
  const char *name;
  if (!read_entity_name (place, &name)
      || !qn_json_value_check_keys (place, keys, G_N_ELEMENTS (keys)))
    return FALSE;
  QnBeam *beam = qn_model_add_beam (model, name);
  if (beam == NULL)
    return qn_json_value_no_memory (place);
  return read_ends (place, model, beam)
         && qn_read_name (place, "section", QN_REQUIRED, model, QN_NAMED_SECTION,
                          &beam->section)
         && qn_member_choice (place, "kind", QN_OPTIONAL, qn_beam_kind_names,
                              QN_BEAM_KIND_COUNT, &beam->kind)
         && qn_member_count (place, "elements", QN_OPTIONAL, QN_MAX_BEAM_ELEMENTS,
                             &beam->element_count);
}

static void
append_section (GString *json, const QnModel *model, size_t index)
{
  const QnSection *section = &model->sections[index];
  const gboolean rectangle = section->height > 0;
  /* Numbers that follow from others are as usual. */
  const QnSection usual = { .poisson =
                              section->shear_modulus > 0 ? section->poisson : NAN,
                            .area = rectangle ? section->area : 0,
                            .inertia = rectangle ? section->inertia : 0 };
  qn_json_put_string (json, "name", section->name);
  qn_members_write (json, section_members, model, section, &usual);
  if (section->density >= 0)
    qn_json_put_number (json, "density", section->density);
  else if (section->unit_weight > 0)
    qn_json_put_number (json, "unit_weight", section->unit_weight);
}

const QnList qn_section_list = QN_LIST ("sections", read_section, append_section, NULL,
                                        QnSection, sections, section_count);

static void
append_node (GString *json, const QnModel *model, size_t index)
{
  const QnNode *node = &model->nodes[index];
  qn_json_put_string (json, "name", node->name);
  if (node->seat != QN_SEAT_FREE)
    qn_json_put_string (json, "block", model->blocks[node->block].name);
  if (node->seat == QN_SEAT_SIDE)
    qn_json_put_string (json, "side", qn_block_side_names[node->side]);
  if (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT)
    qn_json_put_vec2 (json, "at", node->at);
  qn_json_put_support (json, node->support);
}

static bool
is_of_a_beam (const QnModel *model, size_t index)
{
  return model->nodes[index].beam != QN_NONE;
}

const QnList qn_node_list =
  QN_LIST ("nodes", read_node, append_node, is_of_a_beam, QnNode, nodes, node_count);

static void
append_beam (GString *json, const QnModel *model, size_t index)
{
  const QnBeam *beam = &model->beams[index];
  qn_json_put_string (json, "name", beam->name);
  if (beam->kind != QN_BEAM_TIMOSHENKO)
    qn_json_put_string (json, "kind", qn_beam_kind_names[beam->kind]);
  qn_json_begin_member (json, "nodes");
  for (int end = 0; end < 2; end++) {
    g_string_append (json, end == 0 ? "[" : ", ");
    qn_json_append_string (json, model->nodes[beam->nodes[end]].name);
  }
  g_string_append_c (json, ']');
  qn_json_put_string (json, "section", model->sections[beam->section].name);
  if (beam->hinge[0] || beam->hinge[1]) {
    qn_json_begin_member (json, "hinges");
    g_string_append_printf (json, "[%s, %s]", beam->hinge[0] ? "true" : "false",
                            beam->hinge[1] ? "true" : "false");
  }
  qn_json_put_unusual (json, "elements", beam->element_count, 1);
}

const QnList qn_beam_list =
  QN_LIST ("beams", read_beam, append_beam, NULL, QnBeam, beams, beam_count);
