#include "io/result/result-members.h"

#include "core/base/memory.h"
#include "io/project/project-members.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static const char *const step_event_names[QN_EVENT_COUNT] = {
  [QN_EVENT_NONE] = NULL,
  [QN_EVENT_SNAP] = "snap",
  [QN_EVENT_COLLAPSE] = "collapse",
};

const QnMember qn_answer_members[] = {
  QN_CHOICE ("outcome", REQUIRED, qn_outcome_names, QnResult, outcome),
  QN_GIVEN ("collapse_multiplier", MAYBE, 0, QnResult, collapse_multiplier,
            has_collapse_multiplier),
  QN_GIVEN ("first_limit_multiplier", MAYBE, 0, QnResult, first_limit_multiplier,
            has_first_limit_multiplier),
  QN_GIVEN ("lower_bound", NUMBER, 0, QnResult, limit.lower_bound, limit.given),
  QN_NUMBER ("upper_bound", WRITTEN, FINITE, QnResult, limit.upper_bound),
  QN_CHOICE ("flow", WRITTEN, qn_flow_names, QnResult, limit.flow),
  QN_NUMBER ("multiplier_uncertainty", OPTIONAL, FINITE, QnResult, limit.uncertainty),
  QN_GIVEN ("associative_bound", MAYBE, 0, QnResult, associative_bound,
            has_associative_bound),
  QN_GIVEN ("broken_bond_bound", NUMBER, 0, QnResult, broken_bound, has_broken_bound),
  QN_MAYBE ("beyond_linear_multiplier", WRITTEN, QnResult, beyond_linear_multiplier),
  QN_GIVEN ("unproved_multiplier", NUMBER, 0, QnResult, unproved_multiplier,
            has_unproved_multiplier),
  { 0 },
};

const QnMember qn_solution_members[] = {
  QN_NUMBER ("multiplier", REQUIRED, FINITE, QnSolution, multiplier),
  QN_CHOICE ("found_by", REQUIRED, qn_procedure_names, QnSolution, found_by),
  QN_MAYBE ("displacement", WRITTEN, QnSolution, displacement),
  { 0 },
};

const QnMember qn_vibration_members[] = {
  QN_BOOL ("dead_load", REQUIRED, QnVibration, dead_load),
  QN_WHOLE ("mode", REQUIRED, 0, QnVibration, mode),
  QN_NUMBER ("omega", REQUIRED, FINITE, QnVibration, omega),
  QN_BOOL ("sliding", WRITTEN, QnVibration, sliding),
  { 0 },
};

const QnMember qn_statistics_members[] = {
  QN_NUMBER ("seconds", WRITTEN, FINITE, QnStatistics, seconds),
  QN_NUMBER ("factor_seconds", WRITTEN, FINITE, QnStatistics, factor_seconds),
  QN_NUMBER ("assembly_seconds", WRITTEN, FINITE, QnStatistics, assembly_seconds),
  QN_NUMBER ("law_seconds", WRITTEN, FINITE, QnStatistics, law_seconds),
  QN_WHOLE ("iterations", WRITTEN, 0, QnStatistics, iterations),
  QN_WHOLE ("factorizations", WRITTEN, 0, QnStatistics, factorizations),
  QN_MEMBER ("peak_memory_bytes", BYTES, WRITTEN, QnStatistics, peak_memory_bytes, 0,
             NULL),
  { 0 },
};

const QnMember qn_tie_members[] = {
  QN_NUMBER ("force", REQUIRED, FINITE, QnTieResult, force),
  QN_NUMBER ("elongation", REQUIRED, FINITE, QnTieResult, elongation),
  QN_CHOICE ("state", REQUIRED, qn_tie_state_names, QnTieResult, state),
  { 0 },
};

const QnMember qn_event_members[] = {
  QN_NUMBER ("multiplier", REQUIRED, FINITE, QnPathEvent, multiplier),
  QN_CHOICE ("kind", REQUIRED, qn_event_kind_names, QnPathEvent, kind),
  QN_STAGE ("stage", QnPathEvent, stage),
  QN_NUMBER ("displacement_before", REQUIRED, FINITE, QnPathEvent, displacement_before),
  QN_NUMBER ("displacement_after", REQUIRED, FINITE, QnPathEvent, displacement_after),
  QN_NUMBER ("energy", REQUIRED, FINITE, QnPathEvent, energy),
  { 0 },
};

const QnEntity qn_fault_entities[QN_FAULT_PLACES] = {
  QN_ENTITY_CONTACT, QN_ENTITY_BLOCK, QN_ENTITY_NODE,
  QN_ENTITY_BEAM,    QN_ENTITY_TIE,   QN_ENTITY_ANALYSIS
};

const QnMember qn_refused_members[] = {
  QN_STRING ("claim", REQUIRED, QnRefusedMembers, claim),
  QN_WHOLE ("step", REQUIRED, QN_NONE, QnRefusedMembers, fault.step),
  QN_WHOLE ("pair", OPTIONAL, 0, QnRefusedMembers, places[0]),
  QN_WHOLE ("block", OPTIONAL, 0, QnRefusedMembers, places[1]),
  QN_WHOLE ("node", OPTIONAL, 0, QnRefusedMembers, places[2]),
  QN_WHOLE ("beam", OPTIONAL, 0, QnRefusedMembers, places[3]),
  QN_WHOLE ("tie", OPTIONAL, 0, QnRefusedMembers, places[4]),
  QN_WHOLE ("event", OPTIONAL, 0, QnRefusedMembers, places[5]),
  QN_MAYBE ("stated", WRITTEN, QnRefusedMembers, fault.stated),
  QN_MAYBE ("found", WRITTEN, QnRefusedMembers, fault.found),
  { 0 },
};

const QnMember qn_contact_members[] = {
  QN_WHOLE ("face", REQUIRED, 0, QnContactMembers, contact.face),
  QN_PAIR ("blocks", REQUIRED, QnContactMembers, contact.blocks),
  QN_TWO ("point", REQUIRED, QnContactMembers, point),
  QN_TWO ("normal", REQUIRED, QnContactMembers, normal),
  QN_NUMBER ("area", WRITTEN, FINITE, QnContactMembers, area),
  QN_WHOLE ("bar", OPTIONAL, 0, QnContactMembers, contact.bar),
  QN_NUMBER ("stress", OPTIONAL, FINITE, QnContactMembers, stress),
  QN_CHOICE ("state", REQUIRED, qn_pair_state_names, QnContactMembers, pair.state),
  QN_NUMBER ("normal_force", REQUIRED, FINITE, QnContactMembers, pair.normal_force),
  QN_NUMBER ("shear_force", REQUIRED, FINITE, QnContactMembers, pair.shear_force),
  QN_NUMBER ("damage", OPTIONAL, FINITE, QnContactMembers, pair.damage),
  { 0 },
};

const QnMember qn_step_members[] = {
  QN_NUMBER ("multiplier", REQUIRED, FINITE, QnStep, multiplier),
  { 0 },
};

const QnMember qn_step_rest[] = {
  QN_WHOLE ("iterations", WRITTEN, 0, QnStep, iterations),
  QN_NUMBER ("residual", WRITTEN, FINITE, QnStep, residual),
  QN_CHOICE ("event", WRITTEN, step_event_names, QnStep, event),
  QN_BOOL ("relaxed", OPTIONAL, QnStep, relaxed),
  QN_STAGE ("stage", QnStep, stage),
  { 0 },
};

const QnMember qn_step_time[] = {
  QN_NUMBER ("time", WRITTEN, FINITE, QnStep, time),
  { 0 },
};

/* ---- reading ---- */

gboolean
qn_result_read_numbers (const QnJsonValue *list, double *numbers, size_t stride,
                        size_t count, const char *refusal)
{
  if (!qn_json_value_array (list))
    return FALSE;
  if ((size_t) cJSON_GetArraySize (list->json) != count)
    return refusal != NULL
             ? qn_json_value_fail (list, refusal)
             : qn_json_value_failf (list, _ ("expected %d numbers"), (int) count);
  return qn_json_value_numbers (list, QN_RANGE_FINITE, stride, numbers);
}

gboolean
qn_result_read_rows (const QnJsonValue *list, double *rows, size_t count,
                     const char *refusal)
{
  QnJsonValue row = { 0 };
  if (!qn_json_value_array (list))
    return FALSE;
  if ((size_t) cJSON_GetArraySize (list->json) != count)
    return qn_json_value_fail (list, refusal);
  while (qn_json_value_next (list, &row))
    if (!qn_result_read_numbers (&row, &rows[QN_DOF_COUNT * row.index], 1, QN_DOF_COUNT,
                                 NULL))
      return FALSE;
  return TRUE;
}

gboolean
qn_result_read_ids (const QnJsonValue *list, size_t block_count, QnId **ids,
                    size_t *count)
{
  QnJsonValue item = { 0 };
  *count = (size_t) cJSON_GetArraySize (list->json);
  *ids = qn_alloc (*count, sizeof **ids);
  if (*ids == NULL)
    return qn_json_value_no_memory (list);
  while (qn_json_value_next (list, &item)) {
    QnId *id = &(*ids)[item.index];
    if (!qn_read_index (&item, 0, id))
      return FALSE;
    if ((size_t) *id >= block_count)
      return qn_json_value_fail (&item, _ ("there is no such block"));
  }
  return TRUE;
}

void *
qn_result_room (const QnJsonValue *place, size_t count, size_t size, const char *refusal)
{
  void *room = NULL;
  if (count > place->reader->length)
    qn_json_value_fail (place, refusal);
  else if ((room = qn_alloc (count, size)) == NULL)
    qn_json_value_no_memory (place);
  return room;
}

void
qn_result_members_write (QnFileWriter *writer, const char *before,
                         const QnMember *members, gconstpointer source,
                         gconstpointer usual, const char *after)
{
  GString *buffer = qn_file_writer_buffer (writer);
  g_string_append (buffer, before);
  qn_members_write (buffer, members, NULL, source, usual);
  g_string_append (buffer, after);
  for (const QnMember *m = members; m->key != NULL; m++) {
    const double *numbers = (const double *) ((const char *) source + m->offset);
    if ((m->kind == QN_MEMBER_NUMBER && !isfinite (numbers[0]))
        || (m->kind == QN_MEMBER_NUMBERS && !isfinite (numbers[0] + numbers[1])))
      qn_file_writer_number (writer, NAN); /* so that the file is not written */
  }
}

/* Digits of a force: more than any picture or table shows, half of what a double holds. The
 * last step's forces, of which equilibrium is checked, are written in full. */
#define FORCE_FORMAT "%.8g"

/* Stick, slip, open, yield. */
static const char letters[QN_PAIR_STATE_COUNT + 1] = "ksoy";

void
qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step)
{
  if (result->step_forces == NULL)
    return;
  size_t count = result->pair_count;
  const double *forces = result->step_forces + 2 * count * step;
  const uint8_t *states = result->step_states + count * step;
  char text[2] = { 0 };
  qn_file_writer_puts (writer, ", \"forces\": [");
  for (size_t i = 0; i < 2 * count; i++) {
    qn_file_writer_puts (writer, i > 0 ? "," : "");
    qn_file_writer_rounded (writer, forces[i] + 0.0, FORCE_FORMAT);
  }
  qn_file_writer_puts (writer, "], \"states\": \"");
  for (size_t i = 0; i < count; i++) {
    text[0] = letters[states[i]];
    qn_file_writer_puts (writer, text);
  }
  qn_file_writer_puts (writer, "\"");
  if (result->step_damage == NULL)
    return;
  const double *damage = result->step_damage + count * step;
  bool any = false;
  for (size_t i = 0; i < count; i++) {
    if (damage[i] == 0)
      continue;
    qn_file_writer_printf (writer, any ? ", %zu, " : ", \"damage\": [%zu, ", i);
    qn_file_writer_number (writer, damage[i]);
    any = true;
  }
  qn_file_writer_puts (writer, any ? "]" : "");
}

/* Numbers of pairs and the damage of their bonds, in turns. */
static gboolean
read_damage (const QnJsonValue *list, QnResult *result, size_t step)
{
  const size_t count = result->pair_count,
               numbers = (size_t) cJSON_GetArraySize (list->json);
  if (result->step_damage == NULL)
    result->step_damage =
      qn_alloc (result->step_count * count, sizeof *result->step_damage);
  g_autofree double *read = g_new (double, numbers + 1);
  if (result->step_damage == NULL)
    return qn_json_value_no_memory (list);
  result->step_damage_capacity = result->step_count * count;
  if (!qn_result_read_numbers (list, read, 1, numbers, NULL))
    return FALSE;
  gboolean fits = numbers % 2 == 0;
  for (size_t i = 0; fits && i < numbers; i += 2) {
    fits = read[i] >= 0 && read[i] < (double) count && read[i] == floor (read[i])
           && read[i + 1] >= 0 && read[i + 1] <= 1;
    if (fits)
      result->step_damage[step * count + (size_t) read[i]] = read[i + 1];
  }
  return fits
         || qn_json_value_fail (list, _ ("there are not as many forces as contacts"));
}

gboolean
qn_result_forces_read (const QnJsonValue *place, QnResult *result)
{
  const char *refusal = _ ("there are not as many forces as contacts"), *text = NULL;
  const size_t step = place->index, count = result->pair_count,
               all = result->step_count * count;
  const QnJsonValue forces = qn_json_value_member (place, "forces"),
                    states = qn_json_value_member (place, "states");
  QnJsonValue damage;
  const gboolean given = forces.json != NULL && states.json != NULL;
  if (step == 0 && given) {
    result->step_forces =
      qn_result_room (place, 2 * all, sizeof *result->step_forces, refusal);
    result->step_states = qn_alloc (all, sizeof *result->step_states);
    if (result->step_forces == NULL || result->step_states == NULL)
      return qn_json_value_no_memory (place);
    result->step_force_capacity = 2 * all;
    result->step_state_capacity = all;
  }
  if ((result->step_forces != NULL) != given
      || (forces.json != NULL) != (states.json != NULL))
    return qn_json_value_fail (place, refusal);
  if (!given)
    return TRUE;
  if (!qn_member_string (place, "states", QN_REQUIRED, &text))
    return FALSE;
  if (strlen (text) != count)
    return qn_json_value_fail (&states, refusal);
  for (size_t i = 0; i < count; i++) {
    const char *letter = strchr (letters, text[i]);
    if (letter == NULL)
      return qn_json_value_fail (&states, _ ("states are letters k, s and o"));
    result->step_states[count * step + i] = (uint8_t) (letter - letters);
  }
  return qn_result_read_numbers (&forces, result->step_forces + 2 * count * step, 1,
                                 2 * count, refusal)
         && qn_member_array (place, "damage", QN_OPTIONAL, &damage)
         && (damage.json == NULL || read_damage (&damage, result, step));
}
