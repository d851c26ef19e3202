/* The machine form of a check; data/check-format.md describes it key by key. */
#include "cli/project/check-report.h"
#include "io/exchange/record.h"
#include "io/project/project-names.h"
#include "io/text/fault-text.h"
#include "io/text/file-writer.h"

#include <math.h>

static void
write_point (QnFileWriter *out, const char *key, QnVec2 point)
{
  qn_file_writer_puts_number (out, key, point.x);
  qn_file_writer_puts_number (out, ", ", point.y);
  qn_file_writer_puts (out, "]");
}

static void
write_flag (QnFileWriter *out, const char *key, gboolean value)
{
  qn_file_writer_puts (out, key);
  qn_file_writer_puts (out, value ? "true" : "false");
}

static void
write_support (QnFileWriter *out, const bool support[QN_DOF_COUNT])
{
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    write_flag (out, dof > 0 ? ", " : ", \"support\": [", support[dof]);
  qn_file_writer_puts (out, "] }");
}

static void
write_nodes (QnFileWriter *out, const QnModel *model)
{
  qn_file_writer_puts (out, "  \"nodes\": [");
  for (size_t i = 0; i < model->node_count; i++) {
    const QnNode *node = &model->nodes[i];
    qn_file_writer_puts_string (
      out, i > 0 ? ",\n    { \"name\": " : "\n    { \"name\": ", node->name);
    write_point (out, ", \"at\": [", node->at);
    if (node->block != QN_NONE)
      qn_file_writer_printf (out, ", \"block\": %d", node->block);
    write_support (out, node->support);
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

static void
write_beams (QnFileWriter *out, const QnModel *model)
{
  qn_file_writer_puts (out, "  \"beams\": [");
  for (size_t i = 0; i < model->beam_count; i++) {
    const QnBeam *beam = &model->beams[i];
    const QnSection *section = &model->sections[beam->section];
    const QnVec2 *ends[2] = { &model->nodes[beam->nodes[0]].at,
                              &model->nodes[beam->nodes[1]].at };
    double plastic = qn_section_plastic_moment (section);
    qn_file_writer_puts_string (
      out, i > 0 ? ",\n    { \"name\": " : "\n    { \"name\": ", beam->name);
    qn_file_writer_printf (out, ", \"kind\": \"%s\", \"nodes\": [%d, %d], \"section\": ",
                           qn_beam_kind_names[beam->kind], beam->nodes[0],
                           beam->nodes[1]);
    qn_file_writer_json_string (out, section->name);
    qn_file_writer_printf (out, ", \"elements\": %d", beam->element_count);
    write_flag (out, ", \"hinges\": [", beam->hinge[0]);
    write_flag (out, ", ", beam->hinge[1]);
    qn_file_writer_puts_number (
      out, "], \"length\": ", qn_vec2_length (qn_vec2_sub (*ends[1], *ends[0])));
    qn_file_writer_puts_number (out, ", \"area\": ", section->area);
    qn_file_writer_puts_number (out, ", \"inertia\": ", section->inertia);
    if (isfinite (plastic))
      qn_file_writer_puts_number (out, ", \"plastic_moment\": ", plastic);
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
    qn_file_writer_puts_string (
      out, i > 0 ? ",\n    { \"name\": " : "\n    { \"name\": ", tie->name);
    qn_file_writer_printf (out, ", \"blocks\": [%d, %d]", tie->ends[0].block,
                           tie->ends[1].block);
    qn_file_writer_puts_number (out, ", \"length\": ", qn_tie_length (tie));
    qn_file_writer_puts_number (out, ", \"stiffness\": ", qn_tie_stiffness (tie));
    if (isfinite (qn_tie_strength (tie)))
      qn_file_writer_puts_number (out, ", \"strength\": ", qn_tie_strength (tie));
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
    qn_file_writer_printf (out, "%s\n    { \"blocks\": [%d, %d]", i > 0 ? "," : "",
                           face->a, face->b);
    write_point (out, ", \"start\": [", face->start);
    write_point (out, ", \"end\": [", face->end);
    write_point (out, ", \"normal\": [", face->normal);
    qn_file_writer_puts_number (out, ", \"length\": ", face->length);
    qn_file_writer_puts (out, ",\n      \"pairs\": [");
    for (int32_t k = 0; k < face->pair_count; k++) {
      const QnContactPair *pair = &contacts->pairs[face->first_pair + k];
      write_point (out, k > 0 ? ", { \"point\": [" : " { \"point\": [", pair->point);
      qn_file_writer_puts_number (out, ", \"tributary\": ", pair->tributary);
      qn_file_writer_puts (out, " }");
    }
    qn_file_writer_puts (out, " ] }");
  }
  qn_file_writer_puts (out, "\n  ],\n");
}

static void
write_loads (QnFileWriter *out, const QnModel *model)
{
  qn_file_writer_puts (out, "  \"loads\": [");
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad *load = qn_model_load (model, i);
    qn_file_writer_puts_string (out, i > 0 ? ",\n    { \"kind\": " : "\n    { \"kind\": ",
                                qn_load_kind_names[load->kind]);
    qn_file_writer_puts_string (
      out, ", \"list\": ",
      i < model->dead_load_count ? "dead" : qn_model_load_set_name (model, load->set));
    if (load->load_case > 0)
      qn_file_writer_puts_string (
        out, ", \"case\": ", model->load_cases[load->load_case - 1].name);
    qn_file_writer_puts_number (out,
                                ", \"factor\": ", qn_model_load_factor (model, load));
    write_point (out, ", \"resultant\": [", qn_model_load_resultant (model, i));
    qn_file_writer_puts (out, " }");
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
    qn_file_writer_printf (out, "%s\n    { \"kind\": \"%s\"", i > 0 ? "," : "",
                           kinds[motion->kind]);
    if (motion->record != NULL)
      qn_file_writer_puts_string (out, ", \"record\": ", motion->record);
    if (motion->record_unit != NULL)
      qn_file_writer_puts_string (out, ", \"unit\": ", motion->record_unit);
    write_point (out, ", \"direction\": [", motion->direction);
    qn_file_writer_puts_number (out, ", \"scale\": ", motion->scale);
    if (motion->point_count > 0) {
      QnRecordFacts facts = qn_record_facts (
        &(QnRecord){ .points = motion->points, .count = motion->point_count });
      qn_file_writer_printf (out, ", \"samples\": %zu", motion->point_count);
      qn_file_writer_puts_number (out, ", \"time_step\": ", facts.time_step);
      qn_file_writer_puts_number (out, ", \"duration\": ", facts.duration);
      qn_file_writer_puts_number (out, ",\n      \"peak\": ", facts.peak);
      qn_file_writer_puts_number (out, ", \"velocity\": ", facts.velocity);
      qn_file_writer_puts_number (out, ", \"displacement\": ", facts.displacement);
      qn_file_writer_puts_number (out, ", \"end_velocity\": ", facts.end_velocity);
      qn_file_writer_puts_number (out,
                                  ", \"end_displacement\": ", facts.end_displacement);
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
write_findings (QnFileWriter *out, const QnInput *input)
{
  const QnFindings *findings = &input->contacts.findings;
  g_autoptr (GPtrArray) texts = qn_project_dup_finding_texts (&input->project, findings);
  qn_file_writer_puts (out, "  \"findings\": [");
  for (size_t i = 0; i < findings->count; i++) {
    const QnFinding *finding = &findings->items[i];
    g_autofree char *name = dup_problem_name (finding->problem);
    qn_file_writer_printf (out, "%s\n    { \"problem\": \"%s\", \"blocks\": [",
                           i > 0 ? "," : "", name);
    if (finding->block_a != QN_NONE)
      qn_file_writer_printf (out, "%d", finding->block_a);
    if (finding->block_b != QN_NONE)
      qn_file_writer_printf (out, ", %d", finding->block_b);
    write_point (out, "], \"at\": [", finding->at);
    qn_file_writer_puts_number (out, ", \"value\": ", finding->value);
    qn_file_writer_puts_string (out,
                                ", \"text\": ", g_ptr_array_index (texts, (guint) i));
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "\n  ],\n  \"warnings\": [");

  const GPtrArray *warnings = input->project.warnings;
  for (guint i = 0; i < warnings->len; i++)
    qn_file_writer_puts_string (out, i > 0 ? ",\n    " : "\n    ",
                                g_ptr_array_index (warnings, i));
  qn_file_writer_puts (out, "\n  ]");
}

static void
write_result (QnFileWriter *out, const QnCheckReport *report)
{
  qn_file_writer_puts_string (out, ",\n  \"result\": { \"file\": ", report->result_name);
  write_flag (out, ", \"passes\": ", qn_check_report_passes (report));
  if (report->check != NULL) {
    qn_file_writer_puts_number (out, ", \"multiplier\": ", report->check->multiplier);
    qn_file_writer_puts_number (
      out, ",\n    \"out_of_balance\": ", report->check->out_of_balance);
    qn_file_writer_printf (out, ", \"unbalanced_block\": %d",
                           report->check->unbalanced_block);
    qn_file_writer_printf (out, ", \"unbalanced_node\": %d",
                           report->check->unbalanced_node);
    qn_file_writer_printf (out, ", \"unbalanced_element\": %d",
                           report->check->unbalanced_element);
    qn_file_writer_puts_number (out, ", \"force_scale\": ", report->check->force_scale);
    qn_file_writer_puts_number (
      out, ",\n    \"yield_violation\": ", report->check->yield_violation);
    qn_file_writer_printf (out, ", \"violating_pair\": %d",
                           report->check->violating_pair);
    qn_file_writer_puts_number (out,
                                ", \"contact_scale\": ", report->check->contact_scale);
  }
  const QnResultFaults *faults = report->faults;
  write_flag (out, ",\n    \"balance_checked\": ", !faults->in_time);
  write_flag (out, ", \"forces_checked\": ", !faults->forces_unknown);
  qn_file_writer_puts (out, ", \"faults\": [");
  for (int i = 0; i < faults->count; i++) {
    const QnFault *fault = &faults->items[i];
    g_autofree char *text =
      qn_fault_dup_text (&report->input->project.model, &report->input->contacts, fault);
    qn_file_writer_printf (out, "%s\n      { \"claim\": \"%s\", \"step\": %d, \"text\": ",
                           i > 0 ? "," : "", qn_claim_name (fault->claim), fault->step);
    qn_file_writer_json_string (out, text);
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "],\n    \"not_proved\": [");
  for (guint i = 0; i < report->unproved->len; i++)
    qn_file_writer_puts_string (out, i > 0 ? ", " : "",
                                g_ptr_array_index (report->unproved, i));
  qn_file_writer_puts (out, "] }");
}

gboolean
qn_check_report_write_json (const QnCheckReport *report, GError **error)
{
  const QnInput *input = report->input;
  QnFileWriter *out = qn_file_writer_open ("-", error);
  if (out == NULL)
    return FALSE;

  qn_file_writer_puts (
    out, "{\n  \"format\": \"quoin-check\", \"version\": 1,\n  \"model\": ");
  qn_file_writer_json_string (out, input->project.name);
  write_flag (out, ", \"sound\": ", report->sound);
  qn_file_writer_puts (out, ",\n");
  qn_file_writer_puts (out, "  \"blocks\": [");
  for (size_t i = 0; i < input->project.model.block_count; i++) {
    const QnBlock *block = &input->project.model.blocks[i];
    qn_file_writer_puts_string (
      out, i > 0 ? ",\n    { \"name\": " : "\n    { \"name\": ", block->name);
    qn_file_writer_puts_number (out, ", \"area\": ", block->area);
    write_point (out, ", \"centroid\": [", block->centroid);
    qn_file_writer_puts_number (out, ", \"weight\": ", block->weight);
    write_support (out, block->support);
  }
  qn_file_writer_puts (out, "\n  ],\n");
  write_nodes (out, &input->project.model);
  write_beams (out, &input->project.model);
  write_ties (out, &input->project.model);
  write_loads (out, &input->project.model);
  if (input->project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    write_ground (out, &input->project.model);
  write_faces (out, &input->contacts);
  write_findings (out, input);
  if (report->faults != NULL)
    write_result (out, report);
  qn_file_writer_puts (out, "\n}\n");
  return qn_file_writer_commit (out, error);
}
