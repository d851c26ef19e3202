#include "core/contact/contact-bars.h"
#include "core/result/result-contact.h"
#include "io/project/project-members.h"
#include "io/result/result-file.h"
#include "io/result/result-members.h"
#include "io/text/fault-text.h"
#include "io/text/file-writer.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"

/* "key": ["a", "b"], on a line of its own. The names are `offset` bytes within items of `stride` bytes. */
static void
write_names (QnFileWriter *writer, const char *key, const void *items, size_t count,
             size_t offset, size_t stride)
{
  qn_file_writer_json (writer, "  %s: [", key);
  for (size_t i = 0; i < count; i++)
    qn_file_writer_json (writer, i > 0 ? ", %s" : "%s",
                         *(char *const *) ((const char *) items + i * stride + offset));
  qn_file_writer_puts (writer, "],\n");
}

/* The members of the answer, from one to another, each on a line of its own. */
static void
write_lines (QnFileWriter *writer, const char *first, const char *last,
             const QnResult *result)
{
  const QnMember *m = qn_answer_members;
  while (strcmp (m->key, first) != 0)
    m++;
  for (bool more = true; more; m++) {
    const QnMember one[] = { *m, { 0 } };
    qn_result_members_write (writer, "  ", one, result, NULL, ",\n");
    more = strcmp (m->key, last) != 0;
  }
}

/* Proved collapses, the interval of collapse, validity of linear geometry. */
static void
write_answer (QnFileWriter *writer, const QnResult *result)
{
  QnProcedure found_by = QN_PROCEDURE_LOAD;
  double least, bound;
  const gboolean non_associative =
    result->limit.given && result->limit.flow == QN_FLOW_NON_ASSOCIATIVE;
  if (result->limit.given)
    write_lines (writer, "lower_bound", "multiplier_uncertainty", result);
  if (non_associative) {
    write_lines (writer, "associative_bound", "associative_bound", result);
    qn_file_writer_puts (writer, "  \"fixed_points\": [");
    for (int32_t i = 0; i < result->solution_count; i++)
      qn_file_writer_puts_number (writer, i > 0 ? ", " : "",
                                  result->solutions[i].multiplier);
    qn_file_writer_puts (writer, "],\n");
  }
  qn_file_writer_puts (writer, "  \"solutions\": [");
  for (int32_t i = 0; i < result->solution_count; i++)
    qn_result_members_write (writer, i > 0 ? ", { " : "{ ", qn_solution_members,
                             &result->solutions[i], NULL, " }");
  qn_result_collapse_interval (result, &least, &found_by, &bound);
  qn_file_writer_json (writer,
                       "],\n  \"collapse_interval\": [%f, %f],\n"
                       "  \"collapse_interval_ends\": [%s, %s],\n",
                       least, bound,
                       isfinite (least) ? qn_procedure_names[found_by] : NULL,
                       isfinite (bound) ? "associative-bound" : NULL);
  if (result->has_broken_bound)
    write_lines (writer, "broken_bond_bound", "broken_bond_bound", result);
  if (result->linearity == QN_LINEARITY_UNKNOWN)
    return;
  gboolean beyond = result->linearity == QN_LINEARITY_BEYOND;
  QnResult told = *result; /* whose arrays stay the result's */
  if (!beyond || result->history.width > 0)
    told.beyond_linear_multiplier = NAN;
  qn_file_writer_json (writer, "  \"beyond_linear\": %i,\n", beyond);
  write_lines (writer, "beyond_linear_multiplier", "beyond_linear_multiplier", &told);
}

static void
write_ids (QnFileWriter *writer, const char *text, const QnId *ids, size_t count)
{
  qn_file_writer_puts (writer, text);
  for (size_t i = 0; i < count; i++)
    qn_file_writer_printf (writer, "%s%d", i > 0 ? ", " : "[", ids[i]);
  qn_file_writer_puts (writer, count > 0 ? "]" : "[]");
}

/* Events of a path; other analyses have none. */
static void
write_events (QnFileWriter *writer, const QnResult *result)
{
  if (result->limit.given || result->history.width > 0)
    return;
  qn_file_writer_puts (writer, "  \"events\": [");
  for (size_t i = 0; i < result->event_count; i++) {
    const QnPathEvent *event = &result->events[i];
    const QnPathEvent usual = { 0 };
    qn_result_members_write (writer, i > 0 ? ",\n    { " : "\n    { ", qn_event_members,
                             event, &usual, "");
    write_ids (writer, ", \"blocks\": ", event->blocks, event->block_count);
    qn_file_writer_puts (writer, " }");
  }
  qn_file_writer_puts (writer, "],\n");
}

static void
write_head (QnFileWriter *writer, const QnProject *project, const QnResult *result)
{
  const char *path = project->path != NULL ? project->path : project->name;
  g_autofree char *model = g_path_get_basename (path != NULL ? path : "");
  g_autofree char *reason = qn_outcome_dup_reason (&project->model, result);
  qn_file_writer_json (writer,
                       "{\n  \"format\": \"quoin-result\", \"version\": 1,\n"
                       "  \"generator\": %s,\n  \"model\": %s,\n"
                       "  \"model_sha256\": %s,\n",
                       "quoin " QN_VERSION, model,
                       project->sha256 != NULL ? project->sha256 : "");
  if (project->overrides != NULL && project->overrides[0] != NULL)
    write_names (writer, "overrides", project->overrides,
                 g_strv_length (project->overrides), 0, sizeof (char *));
  write_lines (writer, "outcome", "first_limit_multiplier", result);
  write_events (writer, result);
  write_answer (writer, result);
  qn_file_writer_json (writer, "  \"reason\": %s,\n", reason);
}

/* Claims refused by the check of the analysis, and the unproved multiplier. */
static void
write_refused (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
               const QnResult *result)
{
  if (result->has_unproved_multiplier)
    write_lines (writer, "unproved_multiplier", "unproved_multiplier", result);
  if (result->refused_count == 0)
    return;
  QnRefusedMembers usual = { 0 };
  for (gsize k = 0; k < QN_FAULT_PLACES; k++)
    usual.places[k] = QN_NONE;
  qn_file_writer_puts (writer, "  \"refused\": [");
  for (int32_t i = 0; i < result->refused_count; i++) {
    const QnFault *fault = &result->refused[i];
    g_autofree char *text = qn_fault_dup_text (model, contacts, fault);
    QnRefusedMembers members = { .fault = *fault,
                                 .claim = (char *) qn_claim_name (fault->claim) };
    for (gsize k = 0; k < QN_FAULT_PLACES; k++)
      members.places[k] = fault->entity == qn_fault_entities[k] ? fault->index : QN_NONE;
    qn_result_members_write (writer, i > 0 ? ",\n    { " : "\n    { ", qn_refused_members,
                             &members, &usual, "");
    qn_file_writer_json (writer, ", \"text\": %s }", text);
  }
  qn_file_writer_puts (writer, "],\n");
}

/* Names of the stages and which one the analysis ended in. */
static void
write_stages (QnFileWriter *writer, const QnModel *model, const QnResult *result)
{
  if (model->stage_count == 0 || result->stage == 0)
    return;
  qn_file_writer_printf (writer, "  \"stage\": %d, \"stages\": [", result->stage - 1);
  for (size_t i = 0; i < model->stage_count; i++) {
    g_autofree char *name = qn_stage_dup_name (model, (int32_t) i + 1);
    qn_file_writer_json (writer, i > 0 ? ", %s" : "%s", name);
  }
  qn_file_writer_puts (writer, "],\n  \"stage_results\": [");
  for (int32_t i = 1; i <= result->stage && (size_t) i <= model->stage_count; i++) {
    QnStageFigures figures;
    if (!qn_result_stage_figures (model, result, i, i, &figures))
      figures =
        (QnStageFigures){ .multiplier = NAN, .lowest = NAN, .highest = NAN, .work = NAN };
    /* An analysis ends in the first stage that does not reach its end. */
    QnOutcome outcome = i < result->stage ? QN_OUTCOME_TARGET_REACHED : result->outcome;
    qn_file_writer_json (writer,
                         ",\n    { \"stage\": %d, \"outcome\": %s, \"multiplier\": %f, "
                         "\"lowest_multiplier\": %f, \"highest_multiplier\": %f, "
                         "\"work\": %f }",
                         i - 1, qn_outcome_names[outcome], figures.multiplier,
                         figures.lowest, figures.highest, figures.work);
  }
  gboolean any = FALSE;
  for (int32_t i = 1; i <= result->stage && (size_t) i <= model->stage_count; i++) {
    int32_t start = qn_result_cycle_start (model, result, i);
    QnStageFigures f;
    if (start == 0 || !qn_result_stage_figures (model, result, start, i, &f))
      continue;
    qn_file_writer_puts (writer, any ? "" : "],\n  \"cycles\": [");
    qn_file_writer_json (writer,
                         ",\n    { \"stage\": %d, \"cycle\": %d, "
                         "\"lowest_multiplier\": %f, \"highest_multiplier\": %f, "
                         "\"energy\": %f }",
                         start - 1, qn_stage_cycle (&model->stages[i - 1]), f.lowest,
                         f.highest, f.work);
    any = TRUE;
  }
  qn_file_writer_puts (writer, "],\n");
}

/* Names of the nodes; the elements in the order of their forces, by numbers of beam and nodes. */
static void
write_beams (QnFileWriter *writer, const QnModel *model)
{
  if (model->node_count == 0)
    return;
  write_names (writer, "nodes", model->nodes, model->node_count, offsetof (QnNode, name),
               sizeof *model->nodes);
  write_names (writer, "beams", model->beams, model->beam_count, offsetof (QnBeam, name),
               sizeof *model->beams);
  qn_file_writer_puts (writer, "  \"elements\": [");
  for (size_t i = 0; i < model->element_count; i++) {
    const QnBeamElement *element = &model->elements[i];
    qn_file_writer_printf (writer, "%s[%d, %d, %d]", i > 0 ? ", " : "", element->beam,
                           element->nodes[0], element->nodes[1]);
  }
  qn_file_writer_puts (writer, "],\n");
}

/* [[ux, uy, rz], …], a row per block. */
static void
write_rows (QnFileWriter *writer, const double *rows, size_t count)
{
  qn_file_writer_puts (writer, "[");
  for (size_t i = 0; i < count * QN_DOF_COUNT; i++) {
    qn_file_writer_puts (writer, i % QN_DOF_COUNT > 0 ? ", " : i > 0 ? "], [" : "[");
    qn_file_writer_number (writer, rows[i]);
  }
  qn_file_writer_puts (writer, count > 0 ? "]]" : "]");
}

static void
write_step_beams (QnFileWriter *writer, const QnResult *result, size_t step)
{
  if (result->node_count == 0)
    return;
  qn_file_writer_puts (writer, ", \"node_displacements\": ");
  write_rows (writer,
              qn_result_step_displacements (result, step)
                + result->block_count * QN_DOF_COUNT,
              result->node_count);
  if (result->beam_forces == NULL)
    return;
  qn_file_writer_puts (writer, ", \"beam_forces\": ");
  /* [[N, V, M, N, V, M], …], at the first and the second end of every element. */
  const QnBeamForces *forces = qn_result_step_beam_forces (result, step);
  qn_file_writer_puts (writer, "[");
  for (size_t i = 0; i < result->element_count; i++)
    for (int end = 0; end < 2; end++) {
      qn_file_writer_puts (writer, end > 0 ? ", " : i > 0 ? "], [" : "[");
      qn_file_writer_json (writer, "%g, %g, %g", forces[i].normal[end],
                           forces[i].shear[end], forces[i].moment[end]);
    }
  qn_file_writer_puts (writer, result->element_count > 0 ? "]]" : "]");
}

static void
write_steps (QnFileWriter *writer, const QnResult *result)
{
  size_t bodies = qn_result_body_count (result);
  qn_file_writer_puts (writer, "  \"steps\": [");
  for (size_t i = 0; i < result->step_count && !qn_file_writer_failed (writer); i++) {
    const QnStep *step = &result->steps[i], usual = { 0 };
    qn_result_members_write (writer, i > 0 ? ",\n    { " : "\n    { ", qn_step_members,
                             step, NULL, ", \"displacements\": ");
    write_rows (writer, qn_result_step_displacements (result, i), result->block_count);
    qn_result_members_write (writer, ", ", qn_step_rest, step, &usual, "");
    if (result->history.width > 0) {
      qn_result_members_write (writer, ", ", qn_step_time, step, NULL, "");
      if (result->velocities != NULL) {
        qn_file_writer_puts (writer, ", \"velocities\": ");
        write_rows (writer, result->velocities + i * bodies * QN_DOF_COUNT, bodies);
      }
    }
    write_step_beams (writer, result, i);
    /* Every tie in the order of the model; nothing where their forces are not known. */
    const QnTieResult *ties = qn_result_step_ties (result, i);
    for (size_t k = 0; ties != NULL && k < result->tie_count; k++)
      qn_result_members_write (writer, k == 0 ? ", \"ties\": [{ " : ", { ",
                               qn_tie_members, &ties[k], NULL, " }");
    qn_file_writer_puts (writer, ties != NULL && result->tie_count > 0 ? "]" : "");
    if (result->support_count > 0 && result->reactions != NULL) {
      qn_file_writer_puts (writer, ", \"reactions\": ");
      write_rows (writer, qn_result_step_reactions (result, i), result->support_count);
    }
    qn_result_forces_write (writer, result, i);
    qn_file_writer_puts (writer, " }");
  }
  qn_file_writer_puts (writer, "],\n");
}

static void
write_contact (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
               const QnResult *result, size_t index, QnResultDetail detail)
{
  const QnContactPair *pair = &contacts->pairs[index];
  const QnContactFace *face = &contacts->faces[pair->face];
  const QnPairResult *forces = &result->pairs[index];
  QnContactMembers members = {
    .contact = { .face = pair->face, .blocks = { face->a, face->b }, .bar = pair->bar },
    .pair = *forces,
    .area = pair->tributary * face->thickness
  };
  const QnContactMembers usual = { .contact.bar = QN_NONE };
  if (pair->bar != QN_NONE)
    members.stress =
      qn_bar_axial (pair, forces->normal_force, forces->shear_force) / members.area;
  qn_result_contact_place (model, contacts, index, qn_result_deformation (model, result),
                           &members.point, &members.normal);
  qn_result_members_write (writer, "{ ", qn_contact_members, &members, &usual, "");
  if (detail == QN_DETAIL_PAIRS && forces->has_springs) {
    /* The two springs between A, C and B; both carry the pair's force. */
    const double *elongations[2] = { forces->elongation_a, forces->elongation_b };
    qn_file_writer_json (writer, ", \"hinge\": [%g, %g], \"springs\": [", forces->hinge.x,
                         forces->hinge.y);
    for (int side = 0; side < 2; side++) {
      qn_file_writer_puts (writer, side == 0 ? "" : ", ");
      qn_file_writer_json (writer, "{ \"elongation\": [%g, %g], \"force\": [%g, %g] }",
                           elongations[side][0], elongations[side][1],
                           forces->normal_force, forces->shear_force);
    }
    qn_file_writer_puts (writer, "]");
  }
  qn_file_writer_puts (writer, " }");
}

/* Counts are the same in every run. Times and memory are not: they stand in a member of their own
 * too, and are left out where they have not been measured. */
static void
write_statistics (QnFileWriter *writer, const QnStatistics *statistics)
{
  const gboolean timed = statistics->seconds > 0;
  for (int all = timed ? 0 : 1; all < 2; all++) {
    QnMember members[16] = { { 0 } };
    gsize count = 0;
    for (const QnMember *m = qn_statistics_members; m->key != NULL; m++) {
      const gboolean varies = m->kind != QN_MEMBER_WHOLE;
      if (varies ? timed : all)
        members[count++] = *m;
    }
    qn_result_members_write (writer, all ? "  \"statistics\": { " : "  \"timings\": { ",
                             members, statistics, NULL, all ? " }\n}\n" : " },\n");
  }
}

/* The velocity field and the facts that follow from it. These are left out where memory runs out:
 * the field is the result. */
static void
write_mechanism (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
                 const QnResult *result)
{
  QnMechanism facts;
  qn_file_writer_puts (writer, "  \"mechanism\": ");
  if (result->mechanism == NULL) {
    qn_file_writer_puts (writer, "null,\n");
    return;
  }
  write_rows (writer, result->mechanism, result->block_count);
  qn_file_writer_puts (writer, ",\n");
  if (result->mechanism_uncertain)
    qn_file_writer_puts (writer, "  \"mechanism_uncertain\": true,\n");
  if (result->mechanism_by_work)
    qn_file_writer_puts (writer, "  \"mechanism_by_work\": true,\n");
  if (result->node_count > 0) {
    qn_file_writer_puts (writer, "  \"node_mechanism\": ");
    write_rows (writer, result->mechanism + result->block_count * QN_DOF_COUNT,
                result->node_count);
    qn_file_writer_puts (writer, ",\n");
  }
  if (qn_mechanism_of_result (&facts, model, contacts, result, NULL) != QN_OK)
    return;
  qn_file_writer_puts (writer, "  \"mechanism_facts\": ");
  qn_mechanism_write (writer, contacts, &facts);
  qn_file_writer_puts (writer, ",\n");
  qn_mechanism_clear (&facts);
}

static void
write_all (QnFileWriter *writer, const QnProject *project, const QnContacts *contacts,
           const QnResult *result, QnResultDetail detail)
{
  write_head (writer, project, result);
  write_refused (writer, &project->model, contacts, result);
  write_stages (writer, &project->model, result);
  if (result->unstable_count > 0) {
    write_ids (writer, "  \"unstable_blocks\": ", result->unstable_blocks,
               result->unstable_count);
    qn_file_writer_puts (writer, ",\n");
  }
  if (result->support_count > 0) {
    write_ids (writer, "  \"supports\": ", result->supports, result->support_count);
    qn_file_writer_puts (writer, ",\n");
  }
  const QnModel *model = &project->model;
  write_names (writer, "blocks", model->blocks, model->block_count,
               offsetof (QnBlock, name), sizeof *model->blocks);
  write_beams (writer, model);
  for (size_t i = 0, count = qn_model_tie_count (model); i < count; i++) {
    qn_file_writer_json (writer, i > 0 ? ", %s" : "  \"ties\": [%s",
                         qn_model_tie (model, i)->name);
    qn_file_writer_puts (writer, i + 1 == count ? "],\n" : "");
  }
  write_steps (writer, result);
  qn_file_writer_puts (writer, "  \"contacts\": [");
  size_t pairs =
    result->step_count > 0 && result->pairs != NULL ? contacts->pair_count : 0;
  for (size_t i = 0; i < pairs && !qn_file_writer_failed (writer); i++) {
    qn_file_writer_puts (writer, i > 0 ? ",\n    " : "\n    ");
    write_contact (writer, &project->model, contacts, result, i, detail);
  }
  qn_file_writer_puts (writer, "],\n");
  /* What the mechanism is where it is no collapse. */
  if (result->vibration.mode > 0)
    qn_result_members_write (writer, "  \"vibration\": { ", qn_vibration_members,
                             &result->vibration, NULL, " },\n");
  if (result->stability != QN_STABILITY_UNKNOWN)
    qn_file_writer_json (writer, "  \"stability\": %s,\n",
                         qn_stability_names[result->stability]);
  write_mechanism (writer, &project->model, contacts, result);
  if (result->history.width > 0)
    qn_result_history_write (writer, &project->model, result);
  else if (result->found_count > 0 || result->left_count > 0) {
    qn_file_writer_puts (writer, "  ");
    qn_result_found_write (writer, result);
    qn_file_writer_puts (writer, ",\n");
  }
  write_statistics (writer, &result->statistics);
}

gboolean
qn_result_file_write (const char *path, const QnProject *project,
                      const QnContacts *contacts, const QnResult *result,
                      QnResultDetail detail, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  write_all (writer, project, contacts, result, detail);
  return qn_file_writer_commit (writer, error);
}

char *
qn_result_dup_text (const QnProject *project, const QnContacts *contacts,
                    const QnResult *result, QnResultDetail detail, gsize *length)
{
  QnFileWriter *writer = qn_file_writer_new_in_memory ();
  write_all (writer, project, contacts, result, detail);
  return qn_file_writer_steal (writer, length);
}
