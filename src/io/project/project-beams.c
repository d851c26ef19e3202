/* Sections, nodes and beams of a project file. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"

#include <glib/gi18n-lib.h>

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
