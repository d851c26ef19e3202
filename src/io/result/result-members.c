#include "io/result/result-members.h"

#include "core/base/integer.h"
#include "core/base/memory.h"
#include "io/project/project-members.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Most members of one object. */
#define MOST_MEMBERS 64

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
  QN_NUMBER ("multiplier", REQUIRED, FINITE, QnEventMembers, event.multiplier),
  QN_CHOICE ("kind", REQUIRED, qn_event_kind_names, QnEventMembers, event.kind),
  QN_STAGE ("stage", QnEventMembers, event.stage),
  QN_NUMBER ("displacement_before", REQUIRED, FINITE, QnEventMembers,
             event.displacement_before),
  QN_NUMBER ("displacement_after", REQUIRED, FINITE, QnEventMembers,
             event.displacement_after),
  QN_NUMBER ("energy", REQUIRED, FINITE, QnEventMembers, event.energy),
  QN_PLACE ("blocks", REQUIRED, QnEventMembers, blocks),
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
  QN_NUMBER ("multiplier", REQUIRED, FINITE, QnStepMembers, step.multiplier),
  { 0 },
};

const QnMember qn_step_rest[] = {
  QN_WHOLE ("iterations", WRITTEN, 0, QnStepMembers, step.iterations),
  QN_NUMBER ("residual", WRITTEN, FINITE, QnStepMembers, step.residual),
  QN_CHOICE ("event", WRITTEN, step_event_names, QnStepMembers, step.event),
  QN_BOOL ("relaxed", OPTIONAL, QnStepMembers, step.relaxed),
  QN_STAGE ("stage", QnStepMembers, step.stage),
  { 0 },
};

const QnMember qn_step_time[] = {
  QN_NUMBER ("time", WRITTEN, FINITE, QnStepMembers, step.time),
  { 0 },
};

const QnMember qn_step_lists[] = {
  QN_PLACE ("displacements", REQUIRED, QnStepMembers, displacements),
  QN_PLACE ("node_displacements", OPTIONAL, QnStepMembers, node_displacements),
  QN_PLACE ("velocities", OPTIONAL, QnStepMembers, velocities),
  QN_PLACE ("reactions", OPTIONAL, QnStepMembers, reactions),
  QN_PLACE ("beam_forces", OPTIONAL, QnStepMembers, beam_forces),
  QN_PLACE ("ties", OPTIONAL, QnStepMembers, ties),
  QN_PLACE ("forces", OPTIONAL, QnStepMembers, forces),
  QN_PLACE ("states", OPTIONAL, QnStepMembers, states),
  QN_PLACE ("damage", OPTIONAL, QnStepMembers, damage),
  { 0 },
};

/* ---- reading ---- */

static gboolean
read_number (QnJson *json, gsize at, double *number)
{
  if (json->tokens[at].type != QN_JSON_NUMBER)
    return qn_json_fail (json, at, _ ("expected a number"));
  *number = qn_json_number (json, at);
  return isfinite (*number) || qn_json_fail (json, at, _ ("number is not finite"));
}

static gboolean
read_whole (QnJson *json, gsize at, double least, double most, gint64 *whole)
{
  double number = 0;
  if (!read_number (json, at, &number))
    return FALSE;
  *whole = qn_to_integer (number, (gint64) least, (gint64) most);
  return (number >= least && number <= most && number == floor (number))
         || qn_json_fail (json, at, _ ("expected a whole number that is not negative"));
}

static gboolean
read_id (QnJson *json, gsize at, double least, int32_t *id)
{
  gint64 whole;
  if (!read_whole (json, at, least, INT32_MAX, &whole))
    return FALSE;
  *id = (int32_t) whole;
  return TRUE;
}

gboolean
qn_result_read_id (QnJson *json, gsize at, int32_t *id)
{
  return read_id (json, at, 0, id);
}

static gboolean
read_choice (QnJson *json, gsize at, const QnMember *m, int *choice)
{
  g_autoptr (GString) message = g_string_new (NULL);
  gboolean string = json->tokens[at].type == QN_JSON_STRING;
  for (int i = 0; i < m->detail; i++)
    if (m->names[i] == NULL ? json->tokens[at].type == QN_JSON_NULL
                            : string && qn_json_string_is (json, at, m->names[i])) {
      *choice = i;
      return TRUE;
    }
  if (!string)
    return qn_json_fail (json, at, _ ("expected a string"));
  g_autofree char *given = qn_json_dup_string (json, at);
  qn_json_append_string (message, given);
  /* Translators: followed by a list of words. */
  g_string_append (message, _ (" is not one of "));
  for (int i = 0; i < m->detail; i++)
    g_string_append_printf (message, "%s%s", i > 0 ? ", " : "",
                            m->names[i] != NULL ? m->names[i] : "null");
  return qn_json_fail (json, at, message->str);
}

static gboolean
read_member (QnJson *json, gsize at, const QnMember *m, char *target)
{
  gpointer to = target + m->offset;
  const QnJsonType type = json->tokens[at].type;
  double two[2];
  QnId *ids = to;
  gboolean null = m->kind == QN_MEMBER_MAYBE && type == QN_JSON_NULL;
  if (m->given > 0)
    *(bool *) (target + m->given) = !null;
  switch ((int) m->kind) { /* the others are of projects */
  case QN_MEMBER_PLACE:
    *(gsize *) to = at;
    return TRUE;
  case QN_MEMBER_MAYBE:
    if (null && m->given == 0)
      *(double *) to = NAN;
    return null || read_number (json, at, to);
  case QN_MEMBER_NUMBER:
    return read_number (json, at, to);
  case QN_MEMBER_WHOLE:
    return read_id (json, at, m->detail, to);
  case QN_MEMBER_BYTES:
    return read_whole (json, at, 0, 0x1p53, to);
  case QN_MEMBER_BOOL:
    *(bool *) to = type == QN_JSON_TRUE;
    return type == QN_JSON_TRUE || type == QN_JSON_FALSE
           || qn_json_fail (json, at, _ ("expected true or false"));
  case QN_MEMBER_CHOICE:
    return read_choice (json, at, m, to);
  case QN_MEMBER_STRING:
    if (type != QN_JSON_STRING)
      return qn_json_fail (json, at, _ ("expected a string"));
    *(char **) to = qn_json_dup_string (json, at);
    return TRUE;
  case QN_MEMBER_TWO:
    if (!qn_result_read_numbers (json, at, two, 1, 2, NULL))
      return FALSE;
    *(QnVec2 *) to = qn_vec2 (two[0], two[1]);
    return TRUE;
  case QN_MEMBER_PAIR:
    return qn_result_read_numbers (json, at, two, 1, 2, NULL)
           && read_id (json, at + 1, 0, &ids[0]) && read_id (json, at + 2, 0, &ids[1]);
  case QN_MEMBER_STAGE:
    if (!read_id (json, at, 0, ids))
      return FALSE;
    if (*ids >= QN_MAX_STAGES)
      return qn_json_fail (json, at, _ ("there is no such stage"));
    ++*ids;
    return TRUE;
  }
  g_return_val_if_reached (FALSE);
}

gboolean
qn_result_members_read (QnJson *json, gsize at, const QnMember *const *tables,
                        gpointer target)
{
  const QnMember *members[MOST_MEMBERS];
  guint count = 0;
  guint64 seen = 0;
  for (; *tables != NULL; tables++)
    for (const QnMember *m = *tables; m->key != NULL; m++)
      members[count++] = m;
  g_assert (count <= MOST_MEMBERS);
  if (json->tokens[at].type != QN_JSON_OBJECT)
    return qn_json_fail (json, at, _ ("expected an object"));
  for (gsize key = at + 1; key < json->tokens[at].next; key = json->tokens[key].next) {
    guint i = 0;
    while (i < count && !qn_json_string_is (json, key, members[i]->key))
      i++;
    if (i == count)
      continue;
    if ((seen >> i & 1) != 0)
      return qn_json_fail (json, key, _ ("key is given twice"));
    seen |= G_GUINT64_CONSTANT (1) << i;
    if (!read_member (json, key + 1, members[i], target))
      return FALSE;
  }
  for (guint i = 0; i < count; i++)
    if (members[i]->use == QN_USE_REQUIRED && (seen >> i & 1) == 0)
      return qn_json_fail_missing (json, at, members[i]->key);
  return TRUE;
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
        || (m->kind == QN_MEMBER_TWO && !isfinite (numbers[0] + numbers[1])))
      qn_file_writer_number (writer, NAN); /* so that the file is not written */
  }
}

gboolean
qn_result_read_array (QnJson *json, gsize at)
{
  return json->tokens[at].type == QN_JSON_ARRAY
         || qn_json_fail (json, at, _ ("expected an array"));
}

gboolean
qn_result_read_numbers (QnJson *json, gsize at, double *numbers, size_t stride,
                        size_t count, const char *refusal)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  size_t read = 0;
  gsize item = at + 1;
  for (; item < json->tokens[at].next && read < count; item = json->tokens[item].next)
    if (!read_number (json, item, &numbers[stride * read++]))
      return FALSE;
  if (read == count && item == json->tokens[at].next)
    return TRUE;
  if (refusal != NULL)
    return qn_json_fail (json, at, refusal);
  return qn_json_failf (json, at, _ ("expected %d numbers"), (int) count);
}

gboolean
qn_result_read_rows (QnJson *json, gsize at, double *rows, size_t count,
                     const char *refusal)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  size_t read = 0;
  gsize row = at + 1;
  for (; row < json->tokens[at].next && read < count; row = json->tokens[row].next)
    if (!qn_result_read_numbers (json, row, &rows[QN_DOF_COUNT * read++], 1, QN_DOF_COUNT,
                                 NULL))
      return FALSE;
  return (read == count && row == json->tokens[at].next)
         || qn_json_fail (json, at, refusal);
}

gboolean
qn_result_read_ids (QnJson *json, gsize at, size_t block_count, QnId **ids, size_t *count)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  *ids = qn_alloc (qn_json_count (json, at), sizeof **ids);
  if (*ids == NULL)
    return qn_json_no_memory (json);
  *count = 0;
  for (gsize i = at + 1; i < json->tokens[at].next; i = json->tokens[i].next) {
    if (!qn_result_read_id (json, i, &(*ids)[*count]))
      return FALSE;
    if ((size_t) (*ids)[(*count)++] >= block_count)
      return qn_json_fail (json, i, _ ("there is no such block"));
  }
  return TRUE;
}

void *
qn_result_room (QnJson *json, gsize at, size_t count, size_t size, const char *refusal)
{
  void *room = NULL;
  if (count > json->count)
    qn_json_fail (json, at, refusal);
  else if ((room = qn_alloc (count, size)) == NULL)
    qn_json_no_memory (json);
  return room;
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
read_damage (QnJson *json, gsize at, QnResult *result, size_t step)
{
  const size_t count = result->pair_count, numbers = qn_json_count (json, at);
  if (result->step_damage == NULL)
    result->step_damage =
      qn_alloc (result->step_count * count, sizeof *result->step_damage);
  g_autofree double *read = g_new (double, numbers + 1);
  if (result->step_damage == NULL)
    return qn_json_no_memory (json);
  result->step_damage_capacity = result->step_count * count;
  if (!qn_result_read_numbers (json, at, read, 1, numbers, NULL))
    return FALSE;
  gboolean fits = numbers % 2 == 0;
  for (size_t i = 0; fits && i < numbers; i += 2) {
    fits = read[i] >= 0 && read[i] < (double) count && read[i] == floor (read[i])
           && read[i + 1] >= 0 && read[i + 1] <= 1;
    if (fits)
      result->step_damage[step * count + (size_t) read[i]] = read[i + 1];
  }
  return fits || qn_json_fail (json, at, _ ("there are not as many forces as contacts"));
}

gboolean
qn_result_forces_read (QnJson *json, gsize at, gsize forces, gsize states, gsize damage,
                       QnResult *result, size_t step)
{
  const char *refusal = _ ("there are not as many forces as contacts");
  const size_t count = result->pair_count, all = result->step_count * count;
  const gboolean given = forces > 0 && states > 0;
  if (step == 0 && given) {
    result->step_forces =
      qn_result_room (json, at, 2 * all, sizeof *result->step_forces, refusal);
    result->step_states = qn_alloc (all, sizeof *result->step_states);
    if (result->step_forces == NULL || result->step_states == NULL)
      return qn_json_no_memory (json);
    result->step_force_capacity = 2 * all;
    result->step_state_capacity = all;
  }
  if ((result->step_forces != NULL) != given || (forces > 0) != (states > 0))
    return qn_json_fail (json, at, refusal);
  if (!given)
    return TRUE;
  if (json->tokens[states].type != QN_JSON_STRING)
    return qn_json_fail (json, states, _ ("expected a string"));
  g_autofree char *text = qn_json_dup_string (json, states);
  if (strlen (text) != count)
    return qn_json_fail (json, states, refusal);
  for (size_t i = 0; i < count; i++) {
    const char *letter = strchr (letters, text[i]);
    if (letter == NULL)
      return qn_json_fail (json, states, _ ("states are letters k, s and o"));
    result->step_states[count * step + i] = (uint8_t) (letter - letters);
  }
  return qn_result_read_numbers (json, forces, result->step_forces + 2 * count * step, 1,
                                 2 * count, refusal)
         && (damage == 0 || read_damage (json, damage, result, step));
}
