#include "io/result/result-forces.h"

#include "core/base/memory.h"
#include "io/result/result-members.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

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
