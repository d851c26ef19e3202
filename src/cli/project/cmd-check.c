#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/edit/repair.h"
#include "doc/view/load-text.h"
#include "io/exchange/check-json.h"
#include "io/exchange/record.h"
#include "io/result/result-file.h"
#include "io/text/fault-text.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"

#include <glib/gi18n.h>
#include <math.h>

static char *check_result_path;
static gboolean check_json;

/* "name (ux, uy, rz)" for every supported block and node. */
static void
print_supports (const QnModel *model)
{
  const char *separator = " ";
  qn_print (_ ("supports:"));
  for (size_t i = 0; i < qn_model_body_count (model); i++) {
    const bool is_block = i < model->block_count;
    const QnNode *node = is_block ? NULL : &model->nodes[i - model->block_count];
    const bool *support = is_block ? model->blocks[i].support : node->support;
    const char *comma = " (";
    if (!qn_support_is_any (support))
      continue;
    qn_print ("%s%s", separator, is_block ? model->blocks[i].name : node->name);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      if (support[dof]) {
        qn_print ("%s%s", comma, qn_dof_names[dof]);
        comma = ", ";
      }
    qn_print (")");
    separator = ", ";
  }
  qn_print ("\n");
}

/* The dead loads, or those of one set. */
static void
print_load_list (const QnModel *model, const char *name, size_t from, size_t to,
                 int32_t set)
{
  gboolean any = FALSE;
  for (size_t i = from; i < to; i++) {
    if (qn_model_load (model, i)->set != set)
      continue;
    if (!any)
      qn_print (_ ("loads, %s:\n"), name);
    any = TRUE;
    /* "load backfill (traffic × 1.5): resultant (12000, 0) N" */
    const QnLoad *load = qn_model_load (model, i);
    const QnVec2 sum = qn_model_load_resultant (model, i);
    g_autofree char *text = qn_load_dup_text (model, load, QN_UNITS_SI);
    qn_print ("  %s", text);
    if (load->load_case > 0) {
      const QnLoadCase *of = &model->load_cases[load->load_case - 1];
      qn_print (_ (", case %s × %.6g"), of->name, of->factor);
    }
    if (load->kind != QN_LOAD_SETTLEMENT)
      qn_print (_ (", resultant (%.6g, %.6g) N"), sum.x, sum.y);
    if (load->kind == QN_LOAD_EDGE && load->normal
        && fmin (load->intensity[0], load->intensity[1]) < 0)
      qn_print (_ (", pulls the block outwards where it is negative"));
    qn_print ("\n");
  }
}

static void
print_loads (const QnModel *model)
{
  const size_t dead = model->dead_load_count, all = dead + model->live_load_count;
  print_load_list (model, "dead", 0, dead, 0);
  for (int32_t set = 0; set <= (int32_t) model->load_set_count; set++)
    print_load_list (model, qn_model_load_set_name (model, set), dead, all, set);
  /* What every case comes to, over all lists. */
  for (size_t k = 0; k < model->load_case_count; k++) {
    QnVec2 sum = { 0, 0 };
    for (size_t i = 0; i < qn_model_load_count (model); i++)
      if (qn_model_load (model, i)->load_case == (int32_t) k + 1)
        sum = qn_vec2_add (sum, qn_model_load_resultant (model, i));
    qn_print (_ ("load case %s: factor %.6g, resultant (%.6g, %.6g) N\n"),
              model->load_cases[k].name, model->load_cases[k].factor, sum.x, sum.y);
  }
}

/* What follows from the elasticity of a material. */
static void
print_elasticities (const QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++) {
    const QnLaw *law = &model->laws[i];
    if (law->elasticity > 0)
      qn_print (_ ("law %s: elasticity %.6g Pa, Poisson's ratio %.6g, blocks in a %s: "
                   "kn %.6g, ks %.6g Pa\n"),
                law->name, law->elasticity, law->poisson,
                qn_arrangement_names[law->arrangement], law->kn, law->ks);
    if (law->elasticity > 0 && law->poisson > 0
        && law->arrangement == QN_ARRANGEMENT_GRID)
      qn_print (
        _ ("  one direction does not strain the other: strains under equal stress in "
           "both are %.3g %% too large, stiffness between rigid sides %.3g %% too "
           "low\n"),
        100 * law->poisson / (1 - law->poisson), 100 * law->poisson * law->poisson);
  }
}

/* What moves the ground: a wrong unit, step or end shows in these numbers. */
static void
print_ground (const QnModel *model)
{
  for (size_t i = 0; i < model->ground_count; i++) {
    const QnGroundMotion *motion = &model->ground[i];
    g_autofree char *text = qn_ground_motion_dup_text (motion);
    qn_print (_ ("ground motion %zu: %s, factor %.6g along (%.6g, %.6g)\n"), i, text,
              motion->scale, motion->direction.x, motion->direction.y);
    if (motion->point_count == 0)
      continue;
    QnRecordFacts facts = qn_record_facts (
      &(QnRecord){ .points = motion->points, .count = motion->point_count });
    g_autofree char *every = facts.time_step > 0
                               ? g_strdup_printf (_ (" every %.4g s"), facts.time_step)
                               : g_strdup ("");
    qn_print (_ ("  %zu samples%s to %.4g s, unit %s; peak %.4g m/s2 (%.3g g), "
                 "%.4g m/s, %.4g m; drift at the end %.3g m/s, %.3g m\n"),
              motion->point_count, every, facts.duration,
              motion->record == NULL ? "m/s2" : motion->record_unit, facts.peak,
              facts.peak / QN_STANDARD_GRAVITY, facts.velocity, facts.displacement,
              facts.end_velocity, facts.end_displacement);
  }
}

static void
print_findings (const QnCheckReport *report)
{
  /* Blocks that stand apart by mortar: often all of a drawing, and no finding of contacts. */
  g_auto (QnGaps) gaps;
  qn_model_find_gaps (&report->project->model, 0, &gaps);
  g_autofree char *text = qn_gaps_dup_text (&gaps);
  if (text != NULL)
    qn_print (_ ("%s, open: the blocks beside them do not touch; import the drawing with "
                 "--close-joints\n"),
              text);
  const QnFindings *findings = &report->contacts->findings;
  const GPtrArray *warnings = report->project->warnings;
  if (findings->count + warnings->len == 0) {
    qn_print (_ ("warnings: none\n"));
    return;
  }
  qn_print (_ ("warnings: %zu\n"), findings->count + warnings->len);
  for (guint i = 0; i < warnings->len; i++)
    qn_print ("  %s\n", (char *) g_ptr_array_index (warnings, i));
  g_autoptr (GPtrArray) texts = qn_project_dup_finding_texts (report->project, findings);
  for (guint i = 0; i < texts->len; i++)
    qn_print ("  %s\n", (const char *) g_ptr_array_index (texts, i));
}

static void
print_faces (const QnModel *model, const QnContacts *contacts)
{
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    qn_print (
      _ ("face %zu: %s – %s, from (%.6g, %.6g) to (%.6g, %.6g), length %.6g m, pairs "
         "at"),
      i, model->blocks[face->a].name, model->blocks[face->b].name, face->start.x,
      face->start.y, face->end.x, face->end.y, face->length);
    for (int32_t k = 0; k < face->pair_count; k++)
      qn_print ("%s %.6g", k > 0 ? "," : "",
                contacts->pairs[face->first_pair + k].abscissa);
    qn_print (" m\n");
  }
}

/* "tie t: from b (0, 2) to ground (-3, 2), length 3 m, stiffness 2e+07 N/m, strength 3000 N (anchor)" */
static void
print_ties (const QnModel *model)
{
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    double strength = qn_tie_strength (tie);
    qn_print (_ ("tie %s: "), tie->name);
    for (int end = 0; end < 2; end++) {
      QnId block = tie->ends[end].block;
      qn_print (end == 0 ? _ ("from %s (%.6g, %.6g)") : _ (" to %s (%.6g, %.6g)"),
                block != QN_NONE ? model->blocks[block].name : _ ("ground"),
                tie->ends[end].at.x, tie->ends[end].at.y);
    }
    qn_print (_ (", length %.6g m, stiffness %.6g N/m"), qn_tie_length (tie),
              qn_tie_stiffness (tie));
    if (isfinite (strength))
      qn_print (qn_tie_weakest (tie) == QN_TIE_ANCHOR ? _ (", strength %.6g N (anchor)")
                                                      : _ (", strength %.6g N (steel)"),
                strength);
    if (isfinite (qn_tie_plate_punching (&tie->plate)))
      qn_print (_ (", plate punches at %.6g N"), qn_tie_plate_punching (&tie->plate));
    if (isfinite (qn_tie_plate_bearing (&tie->plate)))
      qn_print (_ (", plate bears %.6g N"), qn_tie_plate_bearing (&tie->plate));
    if (isfinite (qn_tie_debonding (tie)))
      qn_print (_ (", strip %.6g mm thick debonds at %.6g N"),
                1e3 * tie->area / tie->strip.width, qn_tie_debonding (tie));
    if (tie->prestress > 0)
      qn_print (_ (", prestress %.6g N"), tie->prestress);
    if (tie->slack > 0)
      qn_print (_ (", slack %.6g m"), tie->slack);
    qn_print ("\n");
  }
}

/* "beam b: from a (0, 0) to c (3, 0), hinged, length 3 m, section s, 4 elements" */
static void
print_beams (const QnModel *model)
{
  for (size_t i = 0; i < model->beam_count; i++) {
    const QnBeam *beam = &model->beams[i];
    qn_print (_ ("beam %s (%s): "), beam->name, qn_beam_kind_names[beam->kind]);
    for (int end = 0; end < 2; end++) {
      const QnNode *node = &model->nodes[beam->nodes[end]];
      qn_print (end == 0 ? _ ("from %s (%.6g, %.6g)") : _ (" to %s (%.6g, %.6g)"),
                node->name, node->at.x, node->at.y);
      if (node->block != QN_NONE)
        qn_print (_ (" on %s"), model->blocks[node->block].name);
      if (beam->hinge[end])
        qn_print (_ (", hinged"));
    }
    qn_print (ngettext (", length %.6g m, section %s, %d element\n",
                        ", length %.6g m, section %s, %d elements\n",
                        (unsigned long) beam->element_count),
              qn_model_beam_length (model, (QnId) i), model->sections[beam->section].name,
              beam->element_count);
  }
}

static void
print_result (const QnCheckReport *report)
{
  const QnResultFaults *faults = report->faults;
  const QnLastForces *last = &faults->last;
  const QnModel *model = &report->project->model;
  const char *verdict = faults->count == 0 ? _ ("passes") : _ ("fails");
  if (!isnan (last->multiplier)) {
    qn_print (_ ("result %s at load multiplier %.6g: %s\n"), report->result_name,
              last->multiplier, verdict);
    if (last->entity == QN_ENTITY_NODE)
      qn_print (_ ("  out of balance: %.2e of %.6g N, node %s\n"), last->out_of_balance,
                last->scale, model->nodes[last->index].name);
    else if (last->entity == QN_ENTITY_BEAM)
      qn_print (_ ("  out of balance: %.2e of %.6g N, beam %s\n"), last->out_of_balance,
                last->scale, model->beams[model->elements[last->index].beam].name);
    else
      qn_print (_ ("  out of balance: %.2e of %.6g N, block %s\n"), last->out_of_balance,
                last->scale,
                last->index == QN_NONE ? "–" : model->blocks[last->index].name);
    qn_print (_ ("  yield violation: %.2e of %.6g N"), last->yield_violation,
              last->contact_scale);
    if (last->pair != QN_NONE)
      qn_print (_ (", pair %d"), last->pair);
    qn_print ("\n");
  } else {
    qn_print (_ ("result %s: %s\n"), report->result_name, verdict);
  }
  for (int i = 0; i < faults->count; i++) {
    g_autofree char *text =
      qn_fault_dup_text (model, report->contacts, &faults->items[i]);
    qn_print (_ ("  not true: %s\n"), text);
  }
  if (faults->forces_unknown)
    qn_print (
      _ ("  not checked: forces of the steps before the last, which the result does "
         "not hold: solve --detail steps keeps them\n"));
  if (faults->in_time)
    qn_print (
      _ ("  not checked: the balance in motion, to which inertia and damping belong\n"));
  for (guint i = 0; i < report->unproved->len; i++)
    qn_print ("%s%s", i == 0 ? _ ("  not proved by the file: ") : ", ",
              (const char *) g_ptr_array_index (report->unproved, i));
  qn_print (report->unproved->len > 0 ? "\n" : "");
}

static void
print_report (const QnCheckReport *report)
{
  const QnModel *model = &report->project->model;
  double weight = 0, length = 0;
  for (size_t i = 0; i < model->block_count; i++)
    if (!model->blocks[i].support[QN_DOF_UY])
      weight += model->blocks[i].weight;
  for (size_t i = 0; i < report->contacts->face_count; i++)
    length += report->contacts->faces[i].length;

  if (model->title != NULL)
    qn_print ("%s\n", model->title);
  qn_print (_ ("blocks: %zu, free weight %.6g N\n"), model->block_count, weight);
  print_supports (model);
  qn_print (_ ("contact faces: %zu, total length %.6g m\n"), report->contacts->face_count,
            length);
  qn_print (_ ("contact pairs: %zu\n"), report->contacts->pair_count);
  if (model->beam_count > 0)
    qn_print (_ ("beams: %zu, elements %zu, nodes %zu\n"), model->beam_count,
              model->element_count, model->node_count);
  print_elasticities (model);
  print_loads (model);
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    print_ground (model);
  print_findings (report);
  if (report->faults != NULL)
    print_result (report);
  print_faces (model, report->contacts);
  print_beams (model);
  print_ties (model);
}

static void
tell (const QnCheckReport *report)
{
  gsize length;
  if (!check_json) {
    print_report (report);
    return;
  }
  g_autofree char *text = qn_check_report_dup_json (report, &length);
  qn_cli_must (qn_file_write ("-", text, length, QN_TROUBLE));
}

static void
check_model (const char *path)
{
  QnInput *input = qn_input_read (path);
  QnCheckReport report = { .project = &input->project, .contacts = &input->contacts };
  GError *unread = NULL;
  QnDiag diag = { 0 };
  gboolean complete =
    input->project.model.analysis.procedure != QN_PROCEDURE_DYNAMIC
    || qn_project_read_records (&input->project, NULL, qn_allow_outside, &unread);
  gboolean sound =
    qn_contacts_require_sound (&input->project.model, &input->contacts, &diag) == QN_OK;
  report.sound = complete && sound;
  tell (&report);
  qn_cli_trouble = unread;
  qn_cli_must (complete);
  if (!sound)
    qn_input_refuse (&input->project, &diag);
}

static void
check_result (const char *path)
{
  const char *name = check_result_path;
  QnResultFile file;
  gsize length;
  gboolean same_bytes;
  g_autofree char *text = qn_file_read (name, &length, QN_TROUBLE);
  qn_cli_must (text != NULL
               && qn_result_file_parse (text, length, name, &file, QN_TROUBLE));
  QnInput *input = qn_input_load_for_result (&file, path, name, &same_bytes);
  QnProject *project = &input->project;
  const QnContacts *contacts = &input->contacts;
  QnResultFaults faults;
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  QnCheckReport report = { .project = project,
                           .contacts = contacts,
                           .sound = TRUE,
                           .result_name = name,
                           .faults = &faults,
                           .unproved = unproved };
  qn_cli_must (file.result.history.width == 0
               || qn_project_read_records (project, NULL, qn_allow_outside, QN_TROUBLE));
  qn_cli_must (qn_result_file_find_faults (&input->file, name, project, contacts, &faults,
                                           QN_TROUBLE));
  qn_cli_must (faults.count > 0
               || qn_result_text_agrees (text, length, name, &input->file, project,
                                         contacts, unproved, QN_TROUBLE));
  tell (&report);
  if (faults.count > 0) {
    g_autofree char *first =
      qn_fault_dup_text (&project->model, contacts, &faults.items[0]);
    qn_cli_fail (QN_EXIT_INVALID, _ ("%s: not true: %s"), name, first);
  }
}

static const GOptionEntry check_entries[] = {
  { "json", 0, 0, G_OPTION_ARG_NONE, &check_json,
    N_ ("Print a form that programs can read"), NULL },
  { "result", 'r', 0, G_OPTION_ARG_FILENAME, &check_result_path,
    N_ ("Check everything in this result as well"), N_ ("RESULT.json") },
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_check (char **arguments)
{
  (check_result_path != NULL ? check_result : check_model) (arguments[0]);
}

const QnSubcommand qn_cmd_check = {
  .name = "check",
  .arguments = "MODEL",
  .summary =
    N_ ("List the contact faces and pairs of a project and what is wrong with it"),
  .help =
    N_ ("Gaps, overlaps and loose blocks are reported with their place. A result is "
        "checked without solving again: it must be of this very project; the forces of "
        "every step are those that its displacements cause, within the strength of the "
        "joints and in equilibrium; states, events, outcome, mechanism, reactions and "
        "bounds are those of the forces."),
  .options = check_entries,
  .run = run_check,
};
