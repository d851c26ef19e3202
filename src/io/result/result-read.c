#include "core/base/memory.h"
#include "io/result/result-members.h"
#include "io/text/fault-text.h"
#include "io/text/file-read.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const QnMember file_members[] = {
  QN_STRING ("generator", OPTIONAL, QnResultFile, generator),
  QN_STRING ("model", OPTIONAL, QnResultFile, model),
  QN_STRING ("model_sha256", OPTIONAL, QnResultFile, model_sha256),
  QN_STAGE ("stage", QnResultFile, result.stage),
  QN_CHOICE ("stability", OPTIONAL, qn_stability_names, QnResultFile, result.stability),
  QN_BOOL ("mechanism_uncertain", OPTIONAL, QnResultFile, result.mechanism_uncertain),
  QN_BOOL ("mechanism_by_work", OPTIONAL, QnResultFile, result.mechanism_by_work),
  { 0 },
};

/* Reads every element of a list, if it is there. */
typedef gboolean (*ReadFunc) (const QnJsonValue *item, QnResultFile *file);

static gboolean
read_each (const QnJsonValue *root, const char *key, QnNeed need, ReadFunc read,
           QnResultFile *file)
{
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (root, key, need, &list))
    return FALSE;
  while (qn_json_value_next (&list, &item))
    if (!read (&item, file))
      return FALSE;
  return TRUE;
}

static gsize
count_of (const QnJsonValue *root, const char *key)
{
  return (gsize) cJSON_GetArraySize (qn_json_value_member (root, key).json);
}

/* NULL-terminated strings; `count` is nullable. */
static gboolean
read_names (const QnJsonValue *root, const char *key, QnNeed need, char ***names,
            size_t *count)
{
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (root, key, need, &list) || list.json == NULL)
    return list.json == NULL && need == QN_OPTIONAL;
  *names = g_new0 (char *, count_of (root, key) + 1);
  while (qn_json_value_next (&list, &item)) {
    if (!cJSON_IsString (item.json))
      return qn_json_value_fail (&item, _ ("expected a string"));
    (*names)[item.index] = g_strdup (item.json->valuestring);
  }
  if (count != NULL)
    *count = count_of (root, key);
  return TRUE;
}

static gboolean
read_blocks (const QnJsonValue *owner, const char *key, QnNeed need, size_t block_count,
             QnId **ids, size_t *count)
{
  QnJsonValue list;
  return qn_member_array (owner, key, need, &list)
         && (list.json == NULL || qn_result_read_ids (&list, block_count, ids, count));
}

static gboolean
read_event (const QnJsonValue *item, QnResultFile *file)
{
  QnResult *result = &file->result;
  QnPathEvent read = { 0 };
  if (!qn_result_object (item, qn_event_members, &read))
    return FALSE;
  if (!QN_ARRAY_PUSH (result->events, result->event_count, result->event_capacity, read))
    return qn_json_value_no_memory (item);
  QnPathEvent *event = &result->events[result->event_count - 1];
  return read_blocks (item, "blocks", QN_REQUIRED, result->block_count, &event->blocks,
                      &event->block_count);
}

/* More than a result keeps is read and left out. */
static gboolean
read_solution (const QnJsonValue *item, QnResultFile *file)
{
  QnSolution solution = { .displacement = NAN };
  if (!qn_result_object (item, qn_solution_members, &solution))
    return FALSE;
  qn_result_add_solution (&file->result, solution);
  return TRUE;
}

static gboolean
read_refused (const QnJsonValue *item, QnResultFile *file)
{
  QnResult *result = &file->result;
  QnRefusedMembers read = {
    .fault = { .entity = QN_ENTITY_MODEL, .index = QN_NONE, .stated = NAN, .found = NAN }
  };
  for (gsize i = 0; i < QN_FAULT_PLACES; i++)
    read.places[i] = QN_NONE;
  gboolean done = qn_result_object (item, qn_refused_members, &read);
  read.fault.claim = qn_claim_from_name (read.claim);
  free (read.claim);
  if (done && read.fault.claim == QN_CLAIM_COUNT)
    return qn_json_value_fail (item, _ ("unknown kind of claim"));
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
read_contact (const QnJsonValue *item, QnResultFile *file)
{
  QnResult *result = &file->result;
  const QnJsonValue blocks = qn_json_value_member (item, "blocks"),
                    normal = qn_json_value_member (item, "normal");
  QnContactMembers read = { .contact.bar = QN_NONE };
  if (!qn_result_object (item, qn_contact_members, &read))
    return FALSE;
  const size_t a = (size_t) read.contact.blocks[0], b = (size_t) read.contact.blocks[1];
  if (a >= result->block_count || b >= result->block_count || a == b)
    return qn_json_value_fail (&blocks, _ ("there are no such two blocks"));
  if (!(fabs (qn_vec2_length (read.normal) - 1) <= 1e-6))
    return qn_json_value_fail (&normal, _ ("normal is not of length 1"));
  file->contacts[result->pair_count] = read.contact;
  result->pairs[result->pair_count++] = read.pair;
  return TRUE;
}

static gboolean
read_contacts (const QnJsonValue *root, QnResultFile *file)
{
  const size_t count = count_of (root, "contacts");
  file->contacts = qn_alloc (count, sizeof *file->contacts);
  file->result.pairs = qn_alloc (count, sizeof *file->result.pairs);
  if (file->contacts == NULL || file->result.pairs == NULL)
    return qn_json_value_no_memory (root);
  return read_each (root, "contacts", QN_REQUIRED, read_contact, file);
}

/* A list that all steps have, or none: `rows` rows of a step, behind those of the steps before. */
static gboolean
read_step_rows (const QnJsonValue *step, const char *key, size_t rows,
                const QnResult *result, double **numbers, size_t *capacity,
                const char *refusal)
{
  const size_t width = rows * QN_DOF_COUNT;
  const QnJsonValue list = qn_json_value_member (step, key);
  const gboolean given = list.json != NULL && rows > 0;
  if (step->index == 0 && given) {
    *capacity = result->step_count * width;
    *numbers = qn_result_room (step, *capacity, sizeof **numbers, refusal);
    if (*numbers == NULL)
      return FALSE;
  }
  if ((*numbers != NULL) != given)
    return qn_json_value_fail (step, refusal);
  return !given
         || qn_result_read_rows (&list, *numbers + step->index * width, rows, refusal);
}

/* N, V, M at the first and the second end of every element. */
static gboolean
read_beam_forces (const QnJsonValue *step, QnResult *result)
{
  const char *refusal = _ ("there are not as many beam forces as elements in every step");
  const size_t count = result->element_count;
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (step, "beam_forces", QN_OPTIONAL, &list))
    return FALSE;
  if (step->index == 0 && list.json != NULL) {
    result->beam_force_capacity = result->step_count * count;
    result->beam_forces = qn_result_room (step, result->beam_force_capacity,
                                          sizeof *result->beam_forces, refusal);
    if (result->beam_forces == NULL)
      return FALSE;
  }
  if ((result->beam_forces != NULL) != (list.json != NULL)
      || (list.json != NULL && (size_t) cJSON_GetArraySize (list.json) != count))
    return qn_json_value_fail (step, refusal);
  while (qn_json_value_next (&list, &item)) {
    double n[6];
    if (!qn_result_read_numbers (&item, n, 1, G_N_ELEMENTS (n), NULL))
      return FALSE;
    result->beam_forces[step->index * count + item.index] =
      (QnBeamForces){ { n[0], n[3] }, { n[1], n[4] }, { n[2], n[5] } };
  }
  return TRUE;
}

/* Not known of a step that leaves them out: NAN. */
static gboolean
read_ties (const QnJsonValue *step, QnResult *result)
{
  const size_t first = step->index * result->tie_count;
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (step, "ties", QN_OPTIONAL, &list))
    return FALSE;
  for (size_t i = 0; list.json == NULL && i < result->tie_count; i++)
    result->ties[first + i] =
      (QnTieResult){ .force = (double) NAN, .elongation = (double) NAN };
  if (list.json != NULL && count_of (step, "ties") != result->tie_count)
    return qn_json_value_fail (&list,
                               _ ("there are not as many ties in every step as names"));
  while (qn_json_value_next (&list, &item))
    if (!qn_result_object (&item, qn_tie_members, &result->ties[first + item.index]))
      return FALSE;
  return TRUE;
}

static gboolean
read_step (const QnJsonValue *step, QnResultFile *file)
{
  QnResult *result = &file->result;
  const size_t blocks = result->block_count, nodes = result->node_count,
               bodies = qn_result_body_count (result);
  double *rows = result->displacements + step->index * bodies * QN_DOF_COUNT;
  QnStep *read = &result->steps[step->index];
  QnJsonValue of_blocks, of_nodes;
  if (!qn_result_object (step, qn_step_members, read)
      || !qn_members_take (step, qn_step_rest, NULL, read)
      || !qn_members_take (step, qn_step_time, NULL, read)
      || !qn_member_array (step, "displacements", QN_REQUIRED, &of_blocks)
      || !qn_result_read_rows (&of_blocks, rows, blocks,
                               _ ("there are not as many displacements as blocks"))
      || !qn_member_array (step, "node_displacements", QN_OPTIONAL, &of_nodes))
    return FALSE;
  const char *nodes_refusal =
    _ ("there are not as many displacements as nodes in every step");
  if (of_nodes.json == NULL && nodes > 0)
    return qn_json_value_fail (step, nodes_refusal);
  return (of_nodes.json == NULL
          || qn_result_read_rows (&of_nodes, rows + blocks * QN_DOF_COUNT, nodes,
                                  nodes_refusal))
         && read_step_rows (
           step, "velocities", bodies, result, &result->velocities,
           &result->velocity_capacity,
           _ ("there are not as many velocities as bodies in every step"))
         && read_step_rows (
           step, "reactions", result->support_count, result, &result->reactions,
           &result->reaction_capacity,
           _ ("there are not as many reactions as supports in every step"))
         && read_beam_forces (step, result) && read_ties (step, result)
         && qn_result_forces_read (step, result);
}

static gboolean
read_steps (const QnJsonValue *root, QnResultFile *file)
{
  QnResult *result = &file->result;
  const QnJsonValue list = qn_json_value_member (root, "steps");
  const size_t count = count_of (root, "steps");
  result->displacement_capacity = count * qn_result_body_count (result) * QN_DOF_COUNT;
  result->displacements =
    qn_result_room (&list, result->displacement_capacity, sizeof *result->displacements,
                    _ ("there are not as many displacements as blocks"));
  result->steps = qn_alloc (count, sizeof *result->steps);
  result->tie_capacity = count * result->tie_count;
  if (result->tie_count > 0)
    result->ties =
      qn_result_room (&list, result->tie_capacity, sizeof *result->ties,
                      _ ("there are not as many ties in every step as names"));
  if (result->displacements == NULL || result->steps == NULL
      || (result->tie_count > 0 && result->ties == NULL))
    return qn_json_value_no_memory (&list);
  result->step_count = result->step_capacity = count;
  return read_each (root, "steps", QN_REQUIRED, read_step, file);
}

/* Velocities of blocks and nodes; null where there is none. */
static gboolean
read_mechanism (const QnJsonValue *root, QnResult *result)
{
  const size_t rows = qn_result_body_count (result);
  const QnJsonValue list = qn_json_value_member (root, "mechanism"),
                    of_nodes = qn_json_value_member (root, "node_mechanism");
  if (list.json == NULL || cJSON_IsNull (list.json))
    return TRUE;
  result->mechanism =
    qn_result_room (&list, rows * QN_DOF_COUNT, sizeof *result->mechanism,
                    _ ("there are not as many velocities as blocks"));
  return result->mechanism != NULL
         && qn_result_read_rows (&list, result->mechanism, result->block_count,
                                 _ ("there are not as many velocities as blocks"))
         && (result->node_count == 0
             || qn_result_read_rows (
               &of_nodes, result->mechanism + result->block_count * QN_DOF_COUNT,
               result->node_count, _ ("there are not as many velocities as nodes")));
}

/* The bound of a path stands in the interval alone. Its first end follows from the solutions. */
static gboolean
read_interval (const QnJsonValue *root, QnResult *result)
{
  QnJsonValue list;
  if (!qn_member_array (root, "collapse_interval", QN_OPTIONAL, &list)
      || list.json == NULL)
    return list.json == NULL;
  if (cJSON_GetArraySize (list.json) != 2)
    return qn_json_value_fail (&list, _ ("expected two numbers or null"));
  const cJSON *bound = list.json->child->next;
  if (!result->has_associative_bound && cJSON_IsNumber (bound)) {
    result->has_associative_bound = true;
    result->associative_bound = bound->valuedouble;
  }
  return TRUE;
}

static gboolean
read_optional (const QnJsonValue *root, const char *key, const QnMember *members,
               gpointer target)
{
  const QnJsonValue object = qn_json_value_member (root, key);
  return object.json == NULL || qn_result_object (&object, members, target);
}

static gboolean
read_document (const QnJsonValue *root, QnResultFile *file)
{
  QnResult *result = &file->result;
  bool beyond = false;
  if (!qn_read_format (root, "quoin-result",
                       _ ("this is not a result: expected \"quoin-result\""))
      || !qn_members_take (root, file_members, NULL, file)
      || !qn_members_take (root, qn_answer_members, NULL, result)
      || !qn_member_bool (root, "beyond_linear", QN_OPTIONAL, &beyond)
      || !read_optional (root, "vibration", qn_vibration_members, &result->vibration))
    return FALSE;
  result->element_count = count_of (root, "elements");
  result->tie_count = count_of (root, "ties");
  if (qn_json_value_member (root, "beyond_linear").json != NULL)
    result->linearity = beyond ? QN_LINEARITY_BEYOND : QN_LINEARITY_HOLDS;
  if (isnan (result->beyond_linear_multiplier))
    result->beyond_linear_multiplier = 0;
  result->events_unknown = qn_json_value_member (root, "events").json == NULL;
  /* Counted from 1, and 0 where none is told: what says 0 is compared with the first. */
  if (qn_json_value_member (root, "vibration").json != NULL)
    result->vibration.mode = MAX (result->vibration.mode, 1);
  return read_names (root, "overrides", QN_OPTIONAL, &file->overrides, NULL)
         && read_names (root, "blocks", QN_REQUIRED, &file->block_names,
                        &result->block_count)
         && read_names (root, "nodes", QN_OPTIONAL, &file->node_names,
                        &result->node_count)
         && read_blocks (root, "unstable_blocks", QN_OPTIONAL, result->block_count,
                         &result->unstable_blocks, &result->unstable_count)
         && read_blocks (root, "supports", QN_OPTIONAL, result->block_count,
                         &result->supports, &result->support_count)
         && read_each (root, "events", QN_OPTIONAL, read_event, file)
         && read_each (root, "solutions", QN_OPTIONAL, read_solution, file)
         && read_each (root, "refused", QN_OPTIONAL, read_refused, file)
         && read_contacts (root, file) && read_steps (root, file)
         && read_mechanism (root, result) && read_interval (root, result)
         && qn_result_history_read (root, result)
         && read_optional (root, "timings", qn_statistics_members, &result->statistics)
         && read_optional (root, "statistics", qn_statistics_members,
                           &result->statistics);
}

/* `text` is NUL-terminated. */
static gboolean
parse (const char *text, gsize length, const char *name, QnResultFile *file,
       GError **error)
{
  QnReader reader = { .name = name, .text = text, .length = length, .any_size = TRUE };
  cJSON *document = qn_json_parse (text, length, name, &reader.error);
  const QnJsonValue root = qn_json_value_root (&reader, document);
  *file = (QnResultFile){ 0 };
  gboolean done = document != NULL && read_document (&root, file);
  cJSON_Delete (document);
  if (!done) {
    qn_result_file_clear (file);
    g_propagate_error (error, reader.error);
  }
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
