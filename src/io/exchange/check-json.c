#include "io/exchange/check-json.h"

#include "io/exchange/record.h"
#include "io/project/project-members.h"
#include "io/text/fault-text.h"
#include "io/text/file-writer.h"

#include <math.h>

static void
write_beam_list (QnFileWriter *out, const QnModel *model)
{
  qn_file_writer_puts (out, "  \"beams\": [");
  for (size_t i = 0; i < model->beam_count; i++) {
    const QnBeam *beam = &model->beams[i];
    const QnSection *section = &model->sections[beam->section];
    double plastic = qn_section_plastic_moment (section);
    qn_file_writer_json (
      out,
      ",\n    { \"name\": %s, \"kind\": %s, \"nodes\": [%d, %d], "
      "\"section\": %s, \"elements\": %d, \"hinges\": [%i, %i], "
      "\"length\": %g, \"area\": %g, \"inertia\": %g",
      beam->name, qn_beam_kind_names[beam->kind], beam->nodes[0], beam->nodes[1],
      section->name, beam->element_count, beam->hinge[0], beam->hinge[1],
      qn_model_beam_length (model, (QnId) i), section->area, section->inertia);
    if (isfinite (plastic))
      qn_file_writer_json (out, ", \"plastic_moment\": %g", plastic);
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

static void
write_ties (QnFileWriter *out, const QnModel *model)
{
  qn_file_writer_puts (out, "  \"ties\": [");
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    qn_file_writer_json (out,
                         ",\n    { \"name\": %s, \"blocks\": [%d, %d], \"length\": %g, "
                         "\"stiffness\": %g",
                         tie->name, tie->ends[0].block, tie->ends[1].block,
                         qn_tie_length (tie), qn_tie_stiffness (tie));
    if (isfinite (qn_tie_strength (tie)))
      qn_file_writer_json (out, ", \"strength\": %g", qn_tie_strength (tie));
    if (isfinite (qn_tie_plate_punching (&tie->plate)))
      qn_file_writer_json (out, ", \"punching\": %g",
                           qn_tie_plate_punching (&tie->plate));
    if (isfinite (qn_tie_plate_bearing (&tie->plate)))
      qn_file_writer_json (out, ", \"bearing\": %g", qn_tie_plate_bearing (&tie->plate));
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

static void
write_faces (QnFileWriter *out, const QnContacts *contacts)
{
  qn_file_writer_puts (out, "  \"faces\": [");
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    qn_file_writer_json (out,
                         ",\n    { \"blocks\": [%d, %d], \"start\": [%g, %g], \"end\": "
                         "[%g, %g], \"normal\": [%g, %g], \"length\": %g,\n"
                         "      \"pairs\": [",
                         face->a, face->b, face->start.x, face->start.y, face->end.x,
                         face->end.y, face->normal.x, face->normal.y, face->length);
    for (int32_t k = 0; k < face->pair_count; k++) {
      const QnContactPair *pair = &contacts->pairs[face->first_pair + k];
      qn_file_writer_json (out, ", { \"point\": [%g, %g], \"tributary\": %g }",
                           pair->point.x, pair->point.y, pair->tributary);
    }
    qn_file_writer_puts (out, " ] }");
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

/* Where the analysis is one in time; the numbers of a signal are those of its points. */
static void
write_ground (QnFileWriter *out, const QnModel *model)
{
  static const char *const kinds[] = { [QN_SIGNAL_POINTS] = "points",
                                       [QN_SIGNAL_RECORD] = "record",
                                       [QN_SIGNAL_PULSE] = "pulse" };
  qn_file_writer_puts (out, "  \"ground\": [");
  for (size_t i = 0; i < model->ground_count; i++) {
    const QnGroundMotion *motion = &model->ground[i];
    qn_file_writer_json (out, ",\n    { \"kind\": %s", kinds[motion->kind]);
    if (motion->record != NULL)
      qn_file_writer_json (out, ", \"record\": %s", motion->record);
    if (motion->record_unit != NULL)
      qn_file_writer_json (out, ", \"unit\": %s", motion->record_unit);
    qn_file_writer_json (out, ", \"direction\": [%g, %g], \"scale\": %g",
                         motion->direction.x, motion->direction.y, motion->scale);
    if (motion->point_count > 0) {
      QnRecordFacts facts = qn_record_facts (
        &(QnRecord){ .points = motion->points, .count = motion->point_count });
      qn_file_writer_json (out,
                           ", \"samples\": %zu, \"time_step\": %g, \"duration\": %g,\n"
                           "      \"peak\": %g, \"velocity\": %g, \"displacement\": "
                           "%g, \"end_velocity\": %g, \"end_displacement\": %g",
                           motion->point_count, facts.time_step, facts.duration,
                           facts.peak, facts.velocity, facts.displacement,
                           facts.end_velocity, facts.end_displacement);
    }
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

/* "blocks-overlap" for QN_PROBLEM_BLOCKS_OVERLAP; the caller frees it. */
static char *
dup_problem_name (QnProblem problem)
{
#define PROBLEM_NAME(name, text) #name,
  static const char *const names[] = { QN_PROBLEMS (PROBLEM_NAME) };
#undef PROBLEM_NAME
  char *name = g_ascii_strdown (names[problem], -1);
  return g_strdelimit (name, "_", '-');
}

static void
write_findings (QnFileWriter *out, const QnCheckReport *report)
{
  const QnFindings *findings = &report->contacts->findings;
  g_autoptr (GPtrArray) texts = qn_project_dup_finding_texts (report->project, findings);
  qn_file_writer_puts (out, "  \"findings\": [");
  for (size_t i = 0; i < findings->count; i++) {
    const QnFinding *finding = &findings->items[i];
    g_autofree char *name = dup_problem_name (finding->problem);
    qn_file_writer_json (out, ",\n    { \"problem\": %s, \"blocks\": [", name);
    if (finding->block_a != QN_NONE)
      qn_file_writer_json (out, "%d", finding->block_a);
    if (finding->block_b != QN_NONE)
      qn_file_writer_json (out, ", %d", finding->block_b);
    qn_file_writer_json (out, "], \"at\": [%g, %g], \"value\": %g, \"text\": %s }",
                         finding->at.x, finding->at.y, finding->value,
                         (const char *) g_ptr_array_index (texts, (guint) i));
  }
  qn_file_writer_puts (out, "\n  ],\n  \"warnings\": [");

  const GPtrArray *warnings = report->project->warnings;
  for (guint i = 0; i < warnings->len; i++)
    qn_file_writer_json (out, ",\n    %s",
                         (const char *) g_ptr_array_index (warnings, i));
  qn_file_writer_puts (out, "\n  ]");
}

static void
write_result (QnFileWriter *out, const QnCheckReport *report)
{
  const QnResultFaults *faults = report->faults;
  const QnLastForces *last = &faults->last;
  qn_file_writer_json (out, ",\n  \"result\": { \"file\": %s, \"passes\": %i",
                       report->result_name, faults->count == 0);
  if (!isnan (last->multiplier))
    qn_file_writer_json (
      out,
      ", \"multiplier\": %g,\n    \"out_of_balance\": %g, \"unbalanced_block\": %d, "
      "\"unbalanced_node\": %d, \"unbalanced_element\": %d, \"force_scale\": %g,\n"
      "    \"yield_violation\": %g, \"violating_pair\": %d, \"contact_scale\": %g",
      last->multiplier, last->out_of_balance,
      last->entity == QN_ENTITY_BLOCK ? last->index : QN_NONE,
      last->entity == QN_ENTITY_NODE ? last->index : QN_NONE,
      last->entity == QN_ENTITY_BEAM ? last->index : QN_NONE, last->scale,
      last->yield_violation, last->pair, last->contact_scale);
  qn_file_writer_json (
    out, ",\n    \"balance_checked\": %i, \"forces_checked\": %i, \"faults\": [",
    !faults->in_time, !faults->forces_unknown);
  for (int i = 0; i < faults->count; i++) {
    const QnFault *fault = &faults->items[i];
    g_autofree char *text =
      qn_fault_dup_text (&report->project->model, report->contacts, fault);
    qn_file_writer_json (out, ",\n      { \"claim\": %s, \"step\": %d, \"text\": %s }",
                         qn_claim_name (fault->claim), fault->step, text);
  }
  qn_file_writer_puts (out, "],\n    \"not_proved\": [");
  for (guint i = 0; i < report->unproved->len; i++)
    qn_file_writer_json (out, i > 0 ? ", %s" : "%s",
                         (const char *) g_ptr_array_index (report->unproved, i));
  qn_file_writer_puts (out, "] }");
}

char *
qn_check_report_dup_json (const QnCheckReport *report, gsize *length)
{
  const QnModel *model = &report->project->model;
  QnFileWriter *out = qn_file_writer_new_in_memory ();

  qn_file_writer_json (out,
                       "{\n  \"format\": \"quoin-check\", \"version\": 1,\n"
                       "  \"model\": %s, \"sound\": %i,\n  \"blocks\": [",
                       report->project->name, report->sound);
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    qn_file_writer_json (out,
                         ",\n    { \"name\": %s, \"area\": %g, \"centroid\": [%g, %g], "
                         "\"weight\": %g, \"support\": [%i, %i, %i] }",
                         block->name, block->area, block->centroid.x, block->centroid.y,
                         block->weight, block->support[0], block->support[1],
                         block->support[2]);
  }
  qn_file_writer_puts (out, "\n  ],\n");
  qn_file_writer_puts (out, "  \"nodes\": [");
  for (size_t i = 0; i < model->node_count; i++) {
    const QnNode *node = &model->nodes[i];
    qn_file_writer_json (out, ",\n    { \"name\": %s, \"at\": [%g, %g]", node->name,
                         node->at.x, node->at.y);
    if (node->block != QN_NONE)
      qn_file_writer_json (out, ", \"block\": %d", node->block);
    qn_file_writer_json (out, ", \"support\": [%i, %i, %i] }", node->support[0],
                         node->support[1], node->support[2]);
  }
  qn_file_writer_puts (out, "\n  ],\n");
  write_beam_list (out, model);
  write_ties (out, model);
  qn_file_writer_puts (out, "  \"loads\": [");
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad *load = qn_model_load (model, i);
    const QnVec2 resultant = qn_model_load_resultant (model, i);
    qn_file_writer_json (
      out, ",\n    { \"kind\": %s, \"list\": %s", qn_load_kind_names[load->kind],
      i < model->dead_load_count ? "dead" : qn_model_load_set_name (model, load->set));
    if (load->load_case > 0)
      qn_file_writer_json (out, ", \"case\": %s",
                           model->load_cases[load->load_case - 1].name);
    qn_file_writer_json (out, ", \"factor\": %g, \"resultant\": [%g, %g] }",
                         qn_model_load_factor (model, load), resultant.x, resultant.y);
  }
  qn_file_writer_puts (out, "\n  ],\n");
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    write_ground (out, model);
  write_faces (out, report->contacts);
  write_findings (out, report);
  if (report->faults != NULL)
    write_result (out, report);
  qn_file_writer_puts (out, "\n}\n");
  return qn_file_writer_steal (out, length);
}
