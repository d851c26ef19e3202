#include "core/base/memory.h"
#include "io/result/result-members.h"
#include "io/text/fault-text.h"
#include "io/text/file-read.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define FORMAT "quoin-result"

/* A file that is being read: what the tables of members fill, and where the rest is. */
typedef struct Document {
  QnResult result;
  char *generator, *model, *model_sha256;
  int32_t version;
  bool has_linearity, is_beyond_linear;
  gsize overrides, events, solutions, interval, unstable, supports, refused, blocks,
    nodes, elements, ties, steps, contacts, vibration, mechanism, node_mechanism, history,
    found, left, timings, statistics;
} Document;

static const QnMember document_members[] = {
  QN_WHOLE ("version", REQUIRED, 0, Document, version),
  QN_STRING ("generator", OPTIONAL, Document, generator),
  QN_STRING ("model", OPTIONAL, Document, model),
  QN_STRING ("model_sha256", OPTIONAL, Document, model_sha256),
  QN_STAGE ("stage", Document, result.stage),
  QN_CHOICE ("stability", OPTIONAL, qn_stability_names, Document, result.stability),
  QN_BOOL ("mechanism_uncertain", OPTIONAL, Document, result.mechanism_uncertain),
  QN_BOOL ("mechanism_by_work", OPTIONAL, Document, result.mechanism_by_work),
  QN_PLACE ("overrides", OPTIONAL, Document, overrides),
  QN_PLACE ("events", OPTIONAL, Document, events),
  QN_PLACE ("solutions", OPTIONAL, Document, solutions),
  QN_PLACE ("collapse_interval", OPTIONAL, Document, interval),
  QN_GIVEN ("beyond_linear", BOOL, 0, Document, is_beyond_linear, has_linearity),
  QN_PLACE ("unstable_blocks", OPTIONAL, Document, unstable),
  QN_PLACE ("supports", OPTIONAL, Document, supports),
  QN_PLACE ("refused", OPTIONAL, Document, refused),
  QN_PLACE ("blocks", REQUIRED, Document, blocks),
  QN_PLACE ("nodes", OPTIONAL, Document, nodes),
  QN_PLACE ("elements", OPTIONAL, Document, elements),
  QN_PLACE ("ties", OPTIONAL, Document, ties),
  QN_PLACE ("steps", REQUIRED, Document, steps),
  QN_PLACE ("contacts", REQUIRED, Document, contacts),
  QN_PLACE ("vibration", OPTIONAL, Document, vibration),
  QN_PLACE ("mechanism", OPTIONAL, Document, mechanism),
  QN_PLACE ("node_mechanism", OPTIONAL, Document, node_mechanism),
  QN_PLACE ("history", OPTIONAL, Document, history),
  QN_PLACE ("found", OPTIONAL, Document, found),
  QN_PLACE ("left", OPTIONAL, Document, left),
  QN_PLACE ("timings", OPTIONAL, Document, timings),
  QN_PLACE ("statistics", OPTIONAL, Document, statistics),
  { 0 },
};

/* Calls for every element of a list, if it is there. */
typedef gboolean (*ReadFunc) (QnJson *json, gsize at, QnResultFile *file);

static gboolean
read_each (QnJson *json, gsize list, ReadFunc read, QnResultFile *file)
{
  if (list > 0 && !qn_result_read_array (json, list))
    return FALSE;
  for (gsize i = list + 1; list > 0 && i < json->tokens[list].next;
       i = json->tokens[i].next)
    if (!read (json, i, file))
      return FALSE;
  return TRUE;
}

/* NULL-terminated strings; `count` is nullable. */
static gboolean
read_names (QnJson *json, gsize at, char ***names, size_t *count)
{
  if (at == 0)
    return TRUE;
  if (!qn_result_read_array (json, at))
    return FALSE;
  gsize length = 0;
  *names = g_new0 (char *, qn_json_count (json, at) + 1);
  for (gsize i = at + 1; i < json->tokens[at].next; i = json->tokens[i].next) {
    if (json->tokens[i].type != QN_JSON_STRING)
      return qn_json_fail (json, i, _ ("expected a string"));
    (*names)[length++] = qn_json_dup_string (json, i);
  }
  if (count != NULL)
    *count = length;
  return TRUE;
}

static gboolean
read_event (QnJson *json, gsize at, QnResultFile *file)
{
  static const QnMember *const tables[] = { qn_event_members, NULL };
  QnResult *result = &file->result;
  QnEventMembers read = { 0 };
  if (!qn_result_members_read (json, at, tables, &read))
    return FALSE;
  if (!QN_ARRAY_PUSH (result->events, result->event_count, result->event_capacity,
                      read.event))
    return qn_json_no_memory (json);
  QnPathEvent *event = &result->events[result->event_count - 1];
  return qn_result_read_ids (json, read.blocks, result->block_count, &event->blocks,
                             &event->block_count);
}

/* More than a result keeps is read and left out. */
static gboolean
read_solution (QnJson *json, gsize at, QnResultFile *file)
{
  static const QnMember *const tables[] = { qn_solution_members, NULL };
  QnSolution solution = { .displacement = NAN };
  if (!qn_result_members_read (json, at, tables, &solution))
    return FALSE;
  qn_result_add_solution (&file->result, solution);
  return TRUE;
}

static gboolean
read_refused (QnJson *json, gsize at, QnResultFile *file)
{
  static const QnMember *const tables[] = { qn_refused_members, NULL };
  QnResult *result = &file->result;
  QnRefusedMembers read = {
    .fault = { .entity = QN_ENTITY_MODEL, .index = QN_NONE, .stated = NAN, .found = NAN }
  };
  for (gsize i = 0; i < QN_FAULT_PLACES; i++)
    read.places[i] = QN_NONE;
  gboolean done = qn_result_members_read (json, at, tables, &read);
  read.fault.claim = qn_claim_from_name (read.claim);
  g_free (read.claim);
  if (done && read.fault.claim == QN_CLAIM_COUNT)
    return qn_json_fail (json, at, _ ("unknown kind of claim"));
  for (gsize i = 0; i < QN_FAULT_PLACES; i++)
    if (read.places[i] != QN_NONE) {
      read.fault.entity = qn_fault_entities[i];
      read.fault.index = read.places[i];
    }
  if (done && result->refused_count < QN_CLAIM_COUNT)
    result->refused[result->refused_count++] = read.fault;
  return done;
}

static gboolean
read_contact (QnJson *json, gsize at, QnResultFile *file)
{
  static const QnMember *const tables[] = { qn_contact_members, NULL };
  QnResult *result = &file->result;
  QnContactMembers read = { .contact.bar = QN_NONE };
  if (!qn_result_members_read (json, at, tables, &read))
    return FALSE;
  const size_t a = (size_t) read.contact.blocks[0], b = (size_t) read.contact.blocks[1];
  if (a >= result->block_count || b >= result->block_count || a == b)
    return qn_json_fail (json, qn_json_member (json, at, "blocks"),
                         _ ("there are no such two blocks"));
  if (!(fabs (qn_vec2_length (read.normal) - 1) <= 1e-6))
    return qn_json_fail (json, qn_json_member (json, at, "normal"),
                         _ ("normal is not of length 1"));
  file->contacts[result->pair_count] = read.contact;
  result->pairs[result->pair_count++] = read.pair;
  return TRUE;
}

static gboolean
read_contacts (QnJson *json, gsize at, QnResultFile *file)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  const size_t count = qn_json_count (json, at);
  file->contacts = qn_alloc (count, sizeof *file->contacts);
  file->result.pairs = qn_alloc (count, sizeof *file->result.pairs);
  if (file->contacts == NULL || file->result.pairs == NULL)
    return qn_json_no_memory (json);
  return read_each (json, at, read_contact, file);
}

/* Rows of a list that all steps have, or none: `rows` rows of a step, behind those of the steps before. */
static gboolean
read_step_rows (QnJson *json, gsize at, gsize list, size_t step, size_t rows,
                const QnResult *result, double **numbers, size_t *capacity,
                const char *refusal)
{
  const size_t width = rows * QN_DOF_COUNT;
  if (step == 0 && list > 0 && rows > 0) {
    *capacity = result->step_count * width;
    *numbers = qn_result_room (json, at, *capacity, sizeof **numbers, refusal);
    if (*numbers == NULL)
      return FALSE;
  }
  if ((*numbers != NULL) != (list > 0 && rows > 0))
    return qn_json_fail (json, at, refusal);
  return *numbers == NULL
         || qn_result_read_rows (json, list, *numbers + step * width, rows, refusal);
}

/* N, V, M at the first and the second end of every element. */
static gboolean
read_beam_forces (QnJson *json, gsize at, gsize list, size_t step, QnResult *result)
{
  const char *refusal = _ ("there are not as many beam forces as elements in every step");
  const size_t count = result->element_count;
  if (step == 0 && list > 0) {
    result->beam_force_capacity = result->step_count * count;
    result->beam_forces = qn_result_room (json, at, result->beam_force_capacity,
                                          sizeof *result->beam_forces, refusal);
    if (result->beam_forces == NULL)
      return FALSE;
  }
  if ((result->beam_forces != NULL) != (list > 0)
      || (list > 0 && qn_json_count (json, list) != count))
    return qn_json_fail (json, at, refusal);
  for (size_t i = 0; list > 0 && i < count; i++) {
    double n[6];
    at = i == 0 ? list + 1 : json->tokens[at].next;
    if (!qn_result_read_numbers (json, at, n, 1, G_N_ELEMENTS (n), NULL))
      return FALSE;
    result->beam_forces[step * count + i] =
      (QnBeamForces){ { n[0], n[3] }, { n[1], n[4] }, { n[2], n[5] } };
  }
  return TRUE;
}

/* Not known of a step that leaves them out: NAN. */
static gboolean
read_ties (QnJson *json, gsize list, size_t step, QnResult *result)
{
  static const QnMember *const tables[] = { qn_tie_members, NULL };
  QnTieResult *ties =
    result->tie_count > 0 ? result->ties + step * result->tie_count : NULL;
  size_t count = 0;
  for (size_t i = 0; list == 0 && i < result->tie_count; i++)
    ties[i] = (QnTieResult){ .force = (double) NAN, .elongation = (double) NAN };
  if (list == 0)
    return TRUE;
  if (!qn_result_read_array (json, list))
    return FALSE;
  if (qn_json_count (json, list) != result->tie_count)
    return qn_json_fail (json, list,
                         _ ("there are not as many ties in every step as names"));
  for (gsize i = list + 1; i < json->tokens[list].next; i = json->tokens[i].next)
    if (!qn_result_members_read (json, i, tables, &ties[count++]))
      return FALSE;
  return TRUE;
}

static gboolean
read_step (QnJson *json, gsize at, size_t step, QnResult *result)
{
  static const QnMember *const tables[] = { qn_step_members, qn_step_rest, qn_step_time,
                                            qn_step_lists, NULL };
  const size_t blocks = result->block_count, nodes = result->node_count;
  double *rows =
    result->displacements + step * qn_result_body_count (result) * QN_DOF_COUNT;
  QnStepMembers read = { 0 };
  if (!qn_result_members_read (json, at, tables, &read))
    return FALSE;
  result->steps[step] = read.step;
  if (!qn_result_read_rows (json, read.displacements, rows, blocks,
                            _ ("there are not as many displacements as blocks")))
    return FALSE;
  const char *nodes_refusal =
    _ ("there are not as many displacements as nodes in every step");
  if (read.node_displacements == 0 && nodes > 0)
    return qn_json_fail (json, at, nodes_refusal);
  return (read.node_displacements == 0
          || qn_result_read_rows (json, read.node_displacements,
                                  rows + blocks * QN_DOF_COUNT, nodes, nodes_refusal))
         && read_step_rows (
           json, at, read.velocities, step, qn_result_body_count (result), result,
           &result->velocities, &result->velocity_capacity,
           _ ("there are not as many velocities as bodies in every step"))
         && read_step_rows (
           json, at, read.reactions, step, result->support_count, result,
           &result->reactions, &result->reaction_capacity,
           _ ("there are not as many reactions as supports in every step"))
         && read_beam_forces (json, at, read.beam_forces, step, result)
         && read_ties (json, read.ties, step, result)
         && qn_result_forces_read (json, at, read.forces, read.states, read.damage,
                                   result, step);
}

static gboolean
read_steps (QnJson *json, gsize at, QnResult *result)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  const size_t count = qn_json_count (json, at);
  result->displacement_capacity = count * qn_result_body_count (result) * QN_DOF_COUNT;
  result->displacements = qn_result_room (
    json, count > 0 ? at + 1 : at, result->displacement_capacity,
    sizeof *result->displacements, _ ("there are not as many displacements as blocks"));
  result->steps = qn_alloc (count, sizeof *result->steps);
  result->tie_capacity = count * result->tie_count;
  if (result->tie_count > 0)
    result->ties =
      qn_result_room (json, at, result->tie_capacity, sizeof *result->ties,
                      _ ("there are not as many ties in every step as names"));
  if (result->displacements == NULL || result->steps == NULL
      || (result->tie_count > 0 && result->ties == NULL))
    return qn_json_no_memory (json);
  result->step_count = result->step_capacity = count;
  for (size_t i = 0; i < count; i++) {
    at = i == 0 ? at + 1 : json->tokens[at].next;
    if (!read_step (json, at, i, result))
      return FALSE;
  }
  return TRUE;
}

/* Velocities of blocks and nodes; null where there is none. */
static gboolean
read_mechanism (QnJson *json, gsize at, gsize of_nodes, QnResult *result)
{
  const size_t rows = qn_result_body_count (result);
  if (at == 0 || json->tokens[at].type == QN_JSON_NULL)
    return TRUE;
  result->mechanism =
    qn_result_room (json, at, rows * QN_DOF_COUNT, sizeof *result->mechanism,
                    _ ("there are not as many velocities as blocks"));
  if (result->mechanism == NULL
      || !qn_result_read_rows (json, at, result->mechanism, result->block_count,
                               _ ("there are not as many velocities as blocks")))
    return FALSE;
  if (result->node_count == 0)
    return TRUE;
  if (of_nodes == 0)
    return qn_json_fail_missing (json, 0, "node_mechanism");
  return qn_result_read_rows (
    json, of_nodes, result->mechanism + result->block_count * QN_DOF_COUNT,
    result->node_count, _ ("there are not as many velocities as nodes"));
}

/* The bound of a path stands in the interval alone. Its first end follows from the solutions. */
static gboolean
read_interval (QnJson *json, gsize at, QnResult *result)
{
  const gsize second = at + 2;
  if (at == 0)
    return TRUE;
  if (!qn_result_read_array (json, at))
    return FALSE;
  if (qn_json_count (json, at) != 2 || json->tokens[at].next != at + 3)
    return qn_json_fail (json, at, _ ("expected two numbers or null"));
  if (!result->has_associative_bound && json->tokens[second].type == QN_JSON_NUMBER) {
    result->has_associative_bound = true;
    result->associative_bound = qn_json_number (json, second);
  }
  return TRUE;
}

/* Parts whose meaning depends on how many blocks, nodes, steps or pairs there are. */
static gboolean
read_parts (QnJson *json, const Document *places, QnResultFile *file)
{
  static const QnMember *const vibration[] = { qn_vibration_members, NULL };
  static const QnMember *const statistics[] = { qn_statistics_members, NULL };
  QnResult *result = &file->result;
  if (places->elements > 0)
    result->element_count = qn_json_count (json, places->elements);
  if (places->ties > 0)
    result->tie_count = qn_json_count (json, places->ties);
  if (places->has_linearity)
    result->linearity =
      places->is_beyond_linear ? QN_LINEARITY_BEYOND : QN_LINEARITY_HOLDS;
  if (isnan (result->beyond_linear_multiplier))
    result->beyond_linear_multiplier = 0;
  result->events_unknown = places->events == 0;
  if (places->vibration > 0) {
    if (!qn_result_members_read (json, places->vibration, vibration, &result->vibration))
      return FALSE;
    /* Counted from 1, and 0 where none is told: what says 0 is compared with the first. */
    result->vibration.mode = MAX (result->vibration.mode, 1);
  }
  return read_names (json, places->overrides, &file->overrides, NULL)
         && read_names (json, places->blocks, &file->block_names, &result->block_count)
         && read_names (json, places->nodes, &file->node_names, &result->node_count)
         && (places->unstable == 0
             || qn_result_read_ids (json, places->unstable, result->block_count,
                                    &result->unstable_blocks, &result->unstable_count))
         && (places->supports == 0
             || qn_result_read_ids (json, places->supports, result->block_count,
                                    &result->supports, &result->support_count))
         && read_each (json, places->events, read_event, file)
         && read_each (json, places->solutions, read_solution, file)
         && read_each (json, places->refused, read_refused, file)
         && read_contacts (json, places->contacts, file)
         && read_steps (json, places->steps, result)
         && read_mechanism (json, places->mechanism, places->node_mechanism, result)
         && read_interval (json, places->interval, result)
         && qn_result_history_read (json, places->history, places->found, places->left,
                                    result)
         && (places->timings == 0
             || qn_result_members_read (json, places->timings, statistics,
                                        &result->statistics))
         && (places->statistics == 0
             || qn_result_members_read (json, places->statistics, statistics,
                                        &result->statistics));
}

static gboolean
read_document (QnJson *json, QnResultFile *file)
{
  static const QnMember *const tables[] = { document_members, qn_answer_members, NULL };
  Document read = { 0 };
  /* What is not a result is told so before its members are. */
  gsize format = qn_json_member (json, 0, "format");
  if (format > 0
      && (json->tokens[format].type != QN_JSON_STRING
          || !qn_json_string_is (json, format, FORMAT)))
    return qn_json_fail (json, format,
                         _ ("this is not a result: expected \"quoin-result\""));
  gboolean done = qn_result_members_read (json, 0, tables, &read);
  file->generator = read.generator;
  file->model = read.model;
  file->model_sha256 = read.model_sha256;
  file->result = read.result;
  if (done && format == 0)
    return qn_json_fail_missing (json, 0, "format");
  if (done && read.version != QN_FORMAT_VERSION)
    return qn_json_failf (json, qn_json_member (json, 0, "version"),
                          _ ("this program reads version %d of the format only"),
                          QN_FORMAT_VERSION);
  return done && read_parts (json, &read, file);
}

/* `text` is NUL-terminated. */
static gboolean
parse (const char *text, gsize length, const char *name, QnResultFile *file,
       GError **error)
{
  QnJson json;
  *file = (QnResultFile){ 0 };
  gboolean done = qn_json_scan (&json, text, length, name) && read_document (&json, file);
  if (!done) {
    qn_result_file_clear (file);
    g_propagate_error (error, g_steal_pointer (&json.error));
  }
  qn_json_clear (&json);
  return done;
}

gboolean
qn_result_file_read (const char *path, QnResultFile *file, GError **error)
{
  *file = (QnResultFile){ 0 };
  gsize length;
  g_autofree char *text = qn_file_read (path, &length, error);
  return text != NULL && parse (text, length, path, file, error);
}

gboolean
qn_result_file_parse (const char *text, gsize length, const char *name,
                      QnResultFile *file, GError **error)
{
  g_autofree char *copy = g_malloc (length + 1);
  if (length > 0)
    memcpy (copy, text, length);
  copy[length] = '\0';
  return parse (copy, length, name, file, error);
}
