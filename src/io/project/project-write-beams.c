/* Sections, nodes and beams in the canonical layout. */
#include "io/project/project-inner.h"
#include "io/project/project-write-parts.h"
#include "io/text/json-text.h"

/* Numbers that follow from others are left out. */
static int32_t
append_section (GString *json, const QnModel *model, size_t index)
{
  const QnSection *section = &model->sections[index];
  qn_json_put_string (json, "name", section->name);
  qn_json_put_number (json, "young", section->young);
  if (section->shear_modulus > 0)
    qn_json_put_number (json, "shear_modulus", section->shear_modulus);
  else
    qn_json_put_number (json, "poisson", section->poisson);
  if (section->height > 0) {
    qn_json_put_number (json, "width", section->width);
    qn_json_put_number (json, "height", section->height);
  } else {
    qn_json_put_number (json, "area", section->area);
    qn_json_put_number (json, "inertia", section->inertia);
  }
  qn_json_put_number (json, "shear_factor", section->shear_factor);
  qn_json_put_unusual (json, "yield", section->yield, 0);
  qn_json_put_unusual (json, "plastic_moment", section->plastic_moment, 0);
  if (section->density >= 0)
    qn_json_put_number (json, "density", section->density);
  else if (section->unit_weight > 0)
    qn_json_put_number (json, "unit_weight", section->unit_weight);
  return section->note;
}

static int32_t
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
  return beam->note;
}

void
qn_project_append_beams (GString *json, const QnModel *model, GHashTable *inner)
{
  gboolean first = TRUE;

  qn_json_append_list (json, model, inner, "  \"sections\": [", 4, model->section_count,
                       append_section, "],\n");
  for (size_t i = 0; i < model->node_count; i++) {
    if (model->nodes[i].beam != QN_NONE)
      continue;
    g_string_append (json, first ? "  \"nodes\": [\n    " : ",\n    ");
    const QnNode *node = &model->nodes[i];
    g_string_append_c (json, '{');
    qn_json_put_string (json, "name", node->name);
    if (node->seat != QN_SEAT_FREE)
      qn_json_put_string (json, "block", model->blocks[node->block].name);
    if (node->seat == QN_SEAT_SIDE)
      qn_json_put_string (json, "side", qn_block_side_names[node->side]);
    if (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT)
      qn_json_put_vec2 (json, "at", node->at);
    qn_json_put_support (json, node->support);
    g_string_append (json, " }");
    qn_json_append_note (json, inner, model->nodes[i].note);
    first = FALSE;
  }
  g_string_append (json, first ? "" : " ],\n");
  qn_json_append_list (json, model, inner, "  \"beams\": [", 4, model->beam_count,
                       append_beam, "],\n");
}
