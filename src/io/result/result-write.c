#include "io/project/project-names.h"
#include "io/result/result-contact.h"
#include "io/result/result-file.h"
#include "io/result/result-forces.h"
#include "io/result/result-history.h"
#include "io/text/fault-text.h"
#include "io/text/file-writer.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"

/* What the file spells for an event, with its quotes. */
static const char *const event_texts[QN_EVENT_COUNT] = {
  [QN_EVENT_NONE] = "null",
  [QN_EVENT_SNAP] = "\"snap\"",
  [QN_EVENT_COLLAPSE] = "\"collapse\"",
};

static void
write_optional (QnFileWriter *writer, const char *key, bool given, double number)
{
  qn_file_writer_printf (writer, "  \"%s\": ", key);
  if (given)
    qn_file_writer_number (writer, number);
  else
    qn_file_writer_puts (writer, "null");
  qn_file_writer_puts (writer, ",\n");
}

static void
write_limit (QnFileWriter *writer, const QnResult *result)
{
  const QnLimitFigures *limit = &result->limit;
  if (!limit->given)
    return;
  write_optional (writer, "lower_bound", TRUE, limit->lower_bound);
  write_optional (writer, "upper_bound", TRUE, limit->upper_bound);
  qn_file_writer_printf (writer, "  \"flow\": \"%s\",\n", qn_flow_names[limit->flow]);
  if (limit->flow != QN_FLOW_NON_ASSOCIATIVE)
    return;
  write_optional (writer, "associative_bound", result->has_associative_bound,
                  result->associative_bound);
  qn_file_writer_puts (writer, "  \"fixed_points\": [");
  for (int32_t i = 0; i < result->solution_count; i++)
    qn_file_writer_puts_number (writer, i > 0 ? ", " : "",
                                result->solutions[i].multiplier);
  qn_file_writer_puts (writer, "],\n");
}

static void
write_known (QnFileWriter *writer, double number)
{
  if (isfinite (number))
    qn_file_writer_number (writer, number);
  else
    qn_file_writer_puts (writer, "null");
}

/* What is proved of collapse, the interval in which it lies, and whether linear geometry holds so far. */
static void
write_answer (QnFileWriter *writer, const QnResult *result)
{
  QnProcedure found_by = QN_PROCEDURE_LOAD;
  double least, bound;
  qn_file_writer_puts (writer, "  \"solutions\": [");
  for (int32_t i = 0; i < result->solution_count; i++) {
    const QnSolution *solution = &result->solutions[i];
    qn_file_writer_printf (writer, "%s{ \"multiplier\": ", i > 0 ? ", " : "");
    qn_file_writer_number (writer, solution->multiplier);
    qn_file_writer_printf (writer, ", \"found_by\": \"%s\", \"displacement\": ",
                           qn_procedure_names[solution->found_by]);
    write_known (writer, solution->displacement);
    qn_file_writer_puts (writer, " }");
  }
  qn_result_collapse_interval (result, &least, &found_by, &bound);
  qn_file_writer_puts (writer, "],\n  \"collapse_interval\": [");
  write_known (writer, least);
  qn_file_writer_puts (writer, ", ");
  write_known (writer, bound);
  qn_file_writer_printf (writer, "],\n  \"collapse_interval_ends\": [%s%s%s, %s],\n",
                         isfinite (least) ? "\"" : "",
                         isfinite (least) ? qn_procedure_names[found_by] : "null",
                         isfinite (least) ? "\"" : "",
                         isfinite (bound) ? "\"associative-bound\"" : "null");
  if (result->has_broken_bound)
    write_optional (writer, "broken_bond_bound", TRUE, result->broken_bound);
  if (result->linearity == QN_LINEARITY_UNKNOWN)
    return;
  gboolean beyond = result->linearity == QN_LINEARITY_BEYOND;
  qn_file_writer_printf (writer, "  \"beyond_linear\": %s,\n", beyond ? "true" : "false");
  write_optional (writer, "beyond_linear_multiplier",
                  beyond && result->history.width == 0, result->beyond_linear_multiplier);
}

static void
write_ids (QnFileWriter *writer, const char *text, const QnId *ids, size_t count)
{
  qn_file_writer_puts (writer, text);
  for (size_t i = 0; i < count; i++)
    qn_file_writer_printf (writer, "%s%d", i > 0 ? ", " : "[", ids[i]);
  qn_file_writer_puts (writer, count > 0 ? "]" : "[]");
}

/* What happened on a path; an analysis of another kind has no events. */
static void
write_events (QnFileWriter *writer, const QnResult *result)
{
  if (result->limit.given || result->history.width > 0)
    return;
  qn_file_writer_puts (writer, "  \"events\": [");
  for (size_t i = 0; i < result->event_count; i++) {
    const QnPathEvent *event = &result->events[i];
    qn_file_writer_puts (writer, i > 0 ? "," : "");
    qn_file_writer_puts_number (writer, "\n    { \"multiplier\": ", event->multiplier);
    qn_file_writer_printf (writer, ", \"kind\": \"%s\"",
                           qn_event_kind_names[event->kind]);
    if (event->stage > 0)
      qn_file_writer_printf (writer, ", \"stage\": %d", event->stage - 1);
    qn_file_writer_puts_number (
      writer, ", \"displacement_before\": ", event->displacement_before);
    qn_file_writer_puts_number (writer,
                                ", \"displacement_after\": ", event->displacement_after);
    qn_file_writer_puts_number (writer, ", \"energy\": ", event->energy);
    write_ids (writer, ", \"blocks\": ", event->blocks, event->block_count);
    qn_file_writer_puts (writer, " }");
  }
  qn_file_writer_puts (writer, "],\n");
}

static void
write_head (QnFileWriter *writer, const QnProject *project, const QnResult *result)
{
  const char *path = project->path != NULL ? project->path : project->name;
  char *model = g_path_get_basename (path != NULL ? path : "");
  qn_file_writer_puts_string (writer,
                              "{\n  \"format\": \"quoin-result\", \"version\": 1,\n"
                              "  \"generator\": \"quoin " QN_VERSION "\",\n  \"model\": ",
                              model);
  qn_file_writer_puts_string (
    writer, ",\n  \"model_sha256\": ", project->sha256 != NULL ? project->sha256 : "");
  qn_file_writer_puts (writer, ",\n");
  g_free (model);
  if (project->overrides != NULL && project->overrides[0] != NULL) {
    qn_file_writer_puts (writer, "  \"overrides\": [");
    for (gsize i = 0; project->overrides[i] != NULL; i++)
      qn_file_writer_puts_string (writer, i > 0 ? ", " : "", project->overrides[i]);
    qn_file_writer_puts (writer, "],\n");
  }

  qn_file_writer_printf (writer, "  \"outcome\": \"%s\",\n",
                         qn_outcome_names[result->outcome]);
  write_optional (writer, "collapse_multiplier", result->has_collapse_multiplier,
                  result->collapse_multiplier);
  write_optional (writer, "first_limit_multiplier", result->has_first_limit_multiplier,
                  result->first_limit_multiplier);
  write_events (writer, result);
  write_limit (writer, result);
  write_answer (writer, result);
  char *reason = qn_outcome_dup_reason (&project->model, result);
  qn_file_writer_puts_string (writer, "  \"reason\": ", reason);
  qn_file_writer_puts (writer, ",\n");
  g_free (reason);
}

/* What the check of the analysis has refused, and the multiplier that is not proved for it. */
static void
write_refused (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
               const QnResult *result)
{
  if (result->has_unproved_multiplier)
    write_optional (writer, "unproved_multiplier", TRUE, result->unproved_multiplier);
  if (result->refused_count == 0)
    return;
  qn_file_writer_puts (writer, "  \"refused\": [");
  for (int32_t i = 0; i < result->refused_count; i++) {
    const QnFault *fault = &result->refused[i];
    g_autofree char *text = qn_fault_dup_text (model, contacts, fault);
    qn_file_writer_printf (writer, "%s\n    { \"claim\": \"%s\", \"step\": %d",
                           i > 0 ? "," : "", qn_claim_name (fault->claim), fault->step);
    if (fault->index != QN_NONE)
      qn_file_writer_printf (writer, ", \"%s\": %d", qn_fault_place_name (fault->entity),
                             fault->index);
    qn_file_writer_puts (writer, ", \"stated\": ");
    write_known (writer, fault->stated);
    qn_file_writer_puts (writer, ", \"found\": ");
    write_known (writer, fault->found);
    qn_file_writer_puts_string (writer, ", \"text\": ", text);
    qn_file_writer_puts (writer, " }");
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
    char *name = qn_stage_dup_name (model, (int32_t) i + 1);
    qn_file_writer_puts_string (writer, i > 0 ? ", " : "", name);
    g_free (name);
  }
  qn_file_writer_puts (writer, "],\n  \"stage_results\": [");
  for (int32_t i = 1; i <= result->stage && (size_t) i <= model->stage_count; i++) {
    QnStageFigures figures = { 0 };
    gboolean known = qn_result_stage_figures (model, result, i, &figures);
    /* An analysis ends in the first stage that does not reach its end. */
    QnOutcome outcome = i < result->stage ? QN_OUTCOME_TARGET_REACHED : result->outcome;
    const struct {
      const char *key;
      double number;
    } numbers[] = { { "multiplier", figures.multiplier },
                    { "lowest_multiplier", figures.lowest },
                    { "highest_multiplier", figures.highest },
                    { "work", figures.work } };
    qn_file_writer_printf (writer, "%s\n    { \"stage\": %d, \"outcome\": \"%s\"",
                           i > 1 ? "," : "", i - 1, qn_outcome_names[outcome]);
    for (gsize k = 0; k < G_N_ELEMENTS (numbers); k++) {
      qn_file_writer_printf (writer, ", \"%s\": ", numbers[k].key);
      write_known (writer, known ? numbers[k].number : (double) NAN);
    }
    qn_file_writer_puts (writer, " }");
  }
  qn_file_writer_puts (writer, "],\n");
}

/* Names of the nodes; the elements in the order of their forces, by numbers of beam and nodes. */
static void
write_beams (QnFileWriter *writer, const QnModel *model)
{
  if (model->node_count == 0)
    return;
  qn_file_writer_puts (writer, "  \"nodes\": [");
  for (size_t i = 0; i < model->node_count; i++)
    qn_file_writer_puts_string (writer, i > 0 ? ", " : "", model->nodes[i].name);
  qn_file_writer_puts (writer, "],\n  \"beams\": [");
  for (size_t i = 0; i < model->beam_count; i++)
    qn_file_writer_puts_string (writer, i > 0 ? ", " : "", model->beams[i].name);
  qn_file_writer_puts (writer, "],\n  \"elements\": [");
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
      qn_file_writer_number (writer, forces[i].normal[end]);
      qn_file_writer_puts_number (writer, ", ", forces[i].shear[end]);
      qn_file_writer_puts_number (writer, ", ", forces[i].moment[end]);
    }
  qn_file_writer_puts (writer, result->element_count > 0 ? "]]" : "]");
}

/* Every tie in the order of the model; nothing where their forces are not known. */
static void
write_step_ties (QnFileWriter *writer, const QnResult *result, size_t step)
{
  const QnTieResult *ties = qn_result_step_ties (result, step);
  for (size_t i = 0; ties != NULL && i < result->tie_count; i++) {
    qn_file_writer_puts_number (
      writer, i == 0 ? ", \"ties\": [{ \"force\": " : "{ \"force\": ", ties[i].force);
    qn_file_writer_puts_number (writer, ", \"elongation\": ", ties[i].elongation);
    qn_file_writer_printf (writer, ", \"state\": \"%s\" }%s",
                           qn_tie_state_names[ties[i].state],
                           i + 1 < result->tie_count ? ", " : "]");
  }
}

static void
write_steps (QnFileWriter *writer, const QnResult *result)
{
  size_t bodies = qn_result_body_count (result);
  qn_file_writer_puts (writer, "  \"steps\": [");
  for (size_t i = 0; i < result->step_count && !qn_file_writer_failed (writer); i++) {
    const QnStep *step = &result->steps[i];
    qn_file_writer_puts (writer, i > 0 ? "," : "");
    qn_file_writer_puts_number (writer, "\n    { \"multiplier\": ", step->multiplier);
    qn_file_writer_puts (writer, ", \"displacements\": ");
    write_rows (writer, qn_result_step_displacements (result, i), result->block_count);
    qn_file_writer_printf (writer,
                           ", \"iterations\": %d, \"residual\": ", step->iterations);
    qn_file_writer_number (writer, step->residual);
    qn_file_writer_printf (writer, ", \"event\": %s", event_texts[step->event]);
    if (step->relaxed)
      qn_file_writer_puts (writer, ", \"relaxed\": true");
    if (step->stage > 0)
      qn_file_writer_printf (writer, ", \"stage\": %d", step->stage - 1);
    if (result->history.width > 0) {
      qn_file_writer_puts_number (writer, ", \"time\": ", step->time);
      if (result->velocities != NULL) {
        qn_file_writer_puts (writer, ", \"velocities\": ");
        write_rows (writer, result->velocities + i * bodies * QN_DOF_COUNT, bodies);
      }
    }
    write_step_beams (writer, result, i);
    write_step_ties (writer, result, i);
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
  QnVec2 point, normal;
  qn_result_contact_place (model, contacts, index, qn_result_deformation (model, result),
                           &point, &normal);
  qn_file_writer_printf (writer,
                         "{ \"face\": %d, \"blocks\": [%d, %d], \"point\": ", pair->face,
                         face->a, face->b);
  qn_file_writer_vec2 (writer, point);
  qn_file_writer_puts (writer, ", \"normal\": ");
  qn_file_writer_vec2 (writer, normal);
  qn_file_writer_puts_number (writer, ", \"area\": ", pair->tributary * face->thickness);
  if (pair->bar != QN_NONE)
    qn_file_writer_printf (writer, ", \"bar\": %d", pair->bar);
  qn_file_writer_printf (writer, ", \"state\": \"%s\", \"normal_force\": ",
                         qn_pair_state_names[forces->state]);
  qn_file_writer_number (writer, forces->normal_force);
  qn_file_writer_puts_number (writer, ", \"shear_force\": ", forces->shear_force);
  if (forces->damage > 0)
    qn_file_writer_puts_number (writer, ", \"damage\": ", forces->damage);
  if (detail == QN_DETAIL_PAIRS && forces->has_springs) {
    /* The two springs between A, C and B; both carry the pair's force. */
    const double *elongations[2] = { forces->elongation_a, forces->elongation_b };
    qn_file_writer_puts (writer, ", \"hinge\": ");
    qn_file_writer_vec2 (writer, forces->hinge);
    qn_file_writer_puts (writer, ", \"springs\": [");
    for (int side = 0; side < 2; side++) {
      qn_file_writer_puts (writer,
                           side == 0 ? "{ \"elongation\": " : ", { \"elongation\": ");
      qn_file_writer_vec2 (writer, qn_vec2 (elongations[side][0], elongations[side][1]));
      qn_file_writer_puts (writer, ", \"force\": ");
      qn_file_writer_vec2 (writer, qn_vec2 (forces->normal_force, forces->shear_force));
      qn_file_writer_puts (writer, " }");
    }
    qn_file_writer_puts (writer, "]");
  }
  qn_file_writer_puts (writer, " }");
}

static void
write_contacts (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
                const QnResult *result, QnResultDetail detail)
{
  qn_file_writer_puts (writer, "  \"contacts\": [");
  size_t count =
    result->step_count > 0 && result->pairs != NULL ? contacts->pair_count : 0;
  for (size_t i = 0; i < count && !qn_file_writer_failed (writer); i++) {
    qn_file_writer_puts (writer, i > 0 ? ",\n    " : "\n    ");
    write_contact (writer, model, contacts, result, i, detail);
  }
  qn_file_writer_puts (writer, "],\n");
}

/* Counts are the same in every run. Times and memory are not: they stand in a member of their own
 * too, and are left out where they have not been measured. */
static void
write_statistics (QnFileWriter *writer, const QnStatistics *statistics)
{
  const struct {
    const char *key;
    double number;
    gboolean varies;
  } figures[] = {
    { "seconds", statistics->seconds, TRUE },
    { "factor_seconds", statistics->factor_seconds, TRUE },
    { "assembly_seconds", statistics->assembly_seconds, TRUE },
    { "law_seconds", statistics->law_seconds, TRUE },
    { "iterations", statistics->iterations, FALSE },
    { "factorizations", statistics->factorizations, FALSE },
    { "peak_memory_bytes", (double) statistics->peak_memory_bytes, TRUE },
  };
  gboolean timed = statistics->seconds > 0;
  for (int all = timed ? 0 : 1; all < 2; all++) {
    const char *separator = "";
    qn_file_writer_puts (writer, all ? "  \"statistics\": {" : "  \"timings\": {");
    for (gsize i = 0; i < G_N_ELEMENTS (figures); i++) {
      if (figures[i].varies ? !timed : !all)
        continue;
      qn_file_writer_printf (writer, "%s \"%s\": ", separator, figures[i].key);
      qn_file_writer_number (writer, figures[i].number);
      separator = ",";
    }
    qn_file_writer_puts (writer, all ? " }\n}\n" : " },\n");
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

gboolean
qn_result_file_write (const char *path, const QnProject *project,
                      const QnContacts *contacts, const QnResult *result, GError **error)
{
  return qn_result_file_write_detailed (path, project, contacts, result, QN_DETAIL_FORCES,
                                        error);
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
  qn_file_writer_puts (writer, "  \"blocks\": [");
  for (size_t i = 0; i < project->model.block_count; i++)
    qn_file_writer_puts_string (writer, i > 0 ? ", " : "", project->model.blocks[i].name);
  qn_file_writer_puts (writer, "],\n");
  write_beams (writer, &project->model);
  for (size_t i = 0; i < project->model.tie_count; i++)
    qn_file_writer_puts_string (writer, i > 0 ? ", " : "  \"ties\": [",
                                project->model.ties[i].name);
  if (project->model.tie_count > 0)
    qn_file_writer_puts (writer, "],\n");
  write_steps (writer, result);
  write_contacts (writer, &project->model, contacts, result, detail);
  /* What the mechanism is where it is no collapse. */
  const QnVibration *vibration = &result->vibration;
  if (vibration->mode > 0) {
    qn_file_writer_printf (
      writer, "  \"vibration\": { \"dead_load\": %s, \"mode\": %d, \"omega\": ",
      vibration->dead_load ? "true" : "false", vibration->mode);
    qn_file_writer_number (writer, vibration->omega);
    qn_file_writer_printf (writer, ", \"sliding\": %s },\n",
                           vibration->sliding ? "true" : "false");
  }
  if (result->stability != QN_STABILITY_UNKNOWN)
    qn_file_writer_printf (writer, "  \"stability\": \"%s\",\n",
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
qn_result_file_write_detailed (const char *path, const QnProject *project,
                               const QnContacts *contacts, const QnResult *result,
                               QnResultDetail detail, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  write_all (writer, project, contacts, result, detail);
  return qn_file_writer_commit (writer, error);
}

char *
qn_result_dup_text (const QnProject *project, const QnContacts *contacts,
                    const QnResult *result, gsize *length)
{
  QnFileWriter *writer = qn_file_writer_new_in_memory ();
  write_all (writer, project, contacts, result, QN_DETAIL_FORCES);
  return qn_file_writer_steal (writer, length);
}
