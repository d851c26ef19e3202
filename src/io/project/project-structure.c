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

gboolean
qn_read_courses (const QnJsonValue *place, QnWall *wall)
{
  QnJsonValue list, course = { 0 };
  if (!qn_member_array (place, "courses", QN_REQUIRED, &list))
    return FALSE;
  while (qn_json_value_next (&list, &course)) {
    if (!qn_json_value_array (&course))
      return FALSE;
    g_autoptr (GArray) lengths = g_array_new (FALSE, FALSE, sizeof (double));
    QnJsonValue element = { 0 };
    while (qn_json_value_next (&course, &element)) {
      double length = 0;
      if (!qn_json_value_number (&element, QN_RANGE_FINITE, &length))
        return FALSE;
      if (length == 0 || fabs (length) > QN_MAX_COURSE_LENGTH)
        return qn_json_value_fail (
          &element, _ (qn_problem_text (length == 0 ? QN_PROBLEM_COURSE_LENGTH_ZERO
                                                    : QN_PROBLEM_TOO_LARGE)));
      g_array_append_val (lengths, length);
    }
    if (!(qn_wall_add_course (wall, (const double *) lengths->data, lengths->len)
          || qn_json_value_no_memory (&course)))
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

/* ---- ties ---- */

static const QnMember end_members[] = {
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnTieEnd, block),
  QN_TWO ("at", REQUIRED, QnTieEnd, at),
  { 0 },
};

static const QnMember plate_members[] = {
  QN_NUMBER ("diameter", REQUIRED, POSITIVE, QnTiePlate, diameter),
  QN_NUMBER ("wall", OPTIONAL, NOT_NEGATIVE, QnTiePlate, wall),
  QN_NUMBER ("shear", OPTIONAL, NOT_NEGATIVE, QnTiePlate, shear),
  QN_NUMBER ("compression", OPTIONAL, NOT_NEGATIVE, QnTiePlate, compression),
  { 0 },
};

static const QnMember strip_members[] = {
  QN_NUMBER ("width", REQUIRED, POSITIVE, QnTieStrip, width),
  QN_NUMBER ("fracture_energy", OPTIONAL, NOT_NEGATIVE, QnTieStrip, fracture_energy),
  { 0 },
};

static const QnMember tie_members[] = {
  QN_KNOWN ("name"),
  QN_MEMBER_WITH ("ends", OBJECTS, REQUIRED, QnTie, ends, 2, .members = end_members,
                  .count = sizeof (QnTieEnd),
                  .refusal = N_ ("expected two values, one for each end")),
  QN_NUMBER ("area", REQUIRED, POSITIVE, QnTie, area),
  QN_NUMBER ("elasticity", REQUIRED, POSITIVE, QnTie, elasticity),
  QN_NUMBER ("yield", OPTIONAL, POSITIVE, QnTie, yield),
  QN_NUMBER ("prestress", OPTIONAL, NOT_NEGATIVE, QnTie, prestress),
  QN_NUMBER ("slack", OPTIONAL, NOT_NEGATIVE, QnTie, slack),
  QN_NUMBER ("anchor", OPTIONAL, POSITIVE, QnTie, anchor),
  QN_OBJECT ("plate", OPTIONAL, plate_members, QnTie, plate),
  QN_OBJECT ("strip", OPTIONAL, strip_members, QnTie, strip),
  { 0 },
};

const QnList qn_tie_list = { QN_LIST ("ties", QnTie, ties, tie_count),
                             .naming = QN_NAMING_NUMBERED, .members = tie_members,
                             .usual = &(const QnTie){ 0 } };

/* ---- beams ---- */

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
  QN_WEIGHT (OPTIONAL, QnSection),
  { 0 },
};

/* A rectangle, or area and inertia. */
static gboolean
read_section (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  (void) model;
  (void) entity;
  double number;
  gboolean rectangle = cJSON_HasObjectItem (place->json, "width")
                       || cJSON_HasObjectItem (place->json, "height");
  return qn_members_exclude (place, "shear_modulus", "poisson")
         && qn_members_exclude (place, "plastic_moment", "yield")
         && qn_members_exclude (place, "area", "height")
         && qn_members_exclude (place, "area", "width")
         && qn_members_exclude (place, "inertia", "height")
         && qn_members_exclude (place, "inertia", "width")
         && qn_member_number (place, rectangle ? "width" : "area", QN_REQUIRED,
                              QN_RANGE_POSITIVE, &number)
         && qn_member_number (place, rectangle ? "height" : "inertia", QN_REQUIRED,
                              QN_RANGE_POSITIVE, &number);
}

static const QnMember beam_node_members[] = {
  QN_KNOWN ("name"),
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnNode, block),
  QN_CHOICE ("side", OPTIONAL, qn_block_side_names, QnNode, side),
  QN_TWO ("at", OPTIONAL, QnNode, at),
  QN_SUPPORT (QnNode),
  { 0 },
};

/* Where it is: on a block, or at a place of its own. */
static gboolean
read_node (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  (void) model;
  QnNode *node = entity;
  const gboolean at = cJSON_HasObjectItem (place->json, "at");
  const QnJsonValue side = qn_json_value_member (place, "side");
  const gboolean rides = cJSON_HasObjectItem (place->json, "block");
  if (!rides && side.json != NULL)
    return qn_json_value_fail (&side, _ ("side needs a block"));
  if (rides)
    node->seat = at ? QN_SEAT_POINT : side.json != NULL ? QN_SEAT_SIDE : QN_SEAT_CENTROID;
  return (rides || qn_member_vec2 (place, "at", QN_REQUIRED, &node->at))
         && qn_members_exclude (place, "side", "at");
}

static const QnMember beam_members[] = {
  QN_KNOWN ("name"),
  QN_CHOICE ("kind", OPTIONAL, qn_beam_kind_names, QnBeam, kind),
  QN_LIST_OF ("nodes", NAMES, REQUIRED, QnBeam, nodes, QN_NAMED_NODE,
              N_ ("expected two values, one for each end")),
  QN_ENTITY ("section", REQUIRED, SECTION, QnBeam, section),
  QN_LIST_OF ("hinges", FLAGS, OPTIONAL, QnBeam, hinge, 2,
              N_ ("expected two values, one for each end")),
  QN_COUNT ("elements", OPTIONAL, QN_MAX_BEAM_ELEMENTS, QnBeam, element_count),
  { 0 },
};

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
  qn_members_write (json, section_members, model, section, &usual);
}

const QnList qn_section_list = { QN_LIST ("sections", QnSection, sections, section_count),
                                 .naming = QN_NAMING_REQUIRED, .members = section_members,
                                 .read = read_section, .append = append_section };

static void
append_node (GString *json, const QnModel *model, size_t index)
{
  const QnNode *node = &model->nodes[index];
  const gboolean placed = node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT;
  /* What follows from the block is as usual. */
  const QnNode usual = { .side =
                           node->seat == QN_SEAT_SIDE ? QN_BLOCK_SIDE_COUNT : node->side,
                         .at = placed ? qn_vec2 (NAN, NAN) : node->at };
  qn_members_write (json, beam_node_members, model, node, &usual);
}

static bool
is_of_a_beam (const QnModel *model, size_t index)
{
  return model->nodes[index].beam != QN_NONE;
}

const QnList qn_node_list = { QN_LIST ("nodes", QnNode, nodes, node_count),
                              .naming = QN_NAMING_REQUIRED,
                              .members = beam_node_members,
                              .read = read_node,
                              .append = append_node,
                              .is_left_out = is_of_a_beam };

const QnList qn_beam_list = { QN_LIST ("beams", QnBeam, beams, beam_count),
                              .naming = QN_NAMING_REQUIRED, .members = beam_members,
                              .usual = &(const QnBeam){ .element_count = 1 } };
