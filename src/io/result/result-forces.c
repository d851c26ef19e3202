#include "io/result/result-forces.h"

#include "core/base/memory.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
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

gboolean
qn_result_force_read (QnJsonStream *stream, gpointer target)
{
  QnStepForces *all = target;
  if (!qn_array_reserve (&all->forces, &all->force_capacity, all->force_count + 1,
                         sizeof *all->forces))
    return qn_json_stream_no_memory (stream);
  return qn_json_stream_number (stream, &all->forces[all->force_count++]);
}

gboolean
qn_result_states_read (QnJsonStream *stream, gpointer target)
{
  QnStepForces *all = target;
  g_autofree char *text = NULL;
  if (!qn_json_stream_string (stream, &text))
    return FALSE;
  size_t length = strlen (text);
  if (!qn_array_reserve (&all->states, &all->state_capacity, all->state_count + length,
                         sizeof *all->states))
    return qn_json_stream_no_memory (stream);
  for (size_t i = 0; i < length; i++) {
    const char *letter = strchr (letters, text[i]);
    if (letter == NULL)
      return qn_json_stream_fail (stream, _ ("states are letters k, s and o"));
    all->states[all->state_count++] = (uint8_t) (letter - letters);
  }
  return TRUE;
}

gboolean
qn_result_damage_read (QnJsonStream *stream, gpointer target)
{
  QnStepForces *all = target;
  if (!qn_array_reserve (&all->damage, &all->damage_capacity, all->damage_count + 1,
                         sizeof *all->damage))
    return qn_json_stream_no_memory (stream);
  all->damage[all->damage_count].step = all->step;
  return qn_json_stream_number (stream, &all->damage[all->damage_count++].number);
}

/* False where it is not damage of pairs. */
static gboolean
take_damage (const QnStepForces *all, QnResult *result)
{
  if (all->damage_count == 0)
    return TRUE;
  size_t wanted = result->step_count * result->pair_count;
  result->step_damage = qn_alloc (wanted, sizeof *result->step_damage);
  if (result->step_damage == NULL || all->damage_count % 2 != 0)
    return FALSE;
  result->step_damage_capacity = wanted;
  for (size_t i = 0; i < all->damage_count; i += 2) {
    double pair = all->damage[i].number, value = all->damage[i + 1].number;
    if (!(pair >= 0 && pair < (double) result->pair_count && pair == floor (pair)
          && value >= 0 && value <= 1))
      return FALSE;
    result->step_damage[all->damage[i].step * result->pair_count + (size_t) pair] = value;
  }
  return TRUE;
}

gboolean
qn_result_forces_take (QnStepForces *all, QnResult *result)
{
  if (all->force_count == 0 && all->state_count == 0)
    return TRUE;
  size_t wanted = result->step_count * result->pair_count;
  if (all->force_count != 2 * wanted || all->state_count != wanted)
    return FALSE;
  result->step_forces = g_steal_pointer (&all->forces);
  result->step_states = g_steal_pointer (&all->states);
  result->step_force_capacity = all->force_capacity;
  result->step_state_capacity = all->state_capacity;
  return take_damage (all, result);
}

void
qn_result_forces_clear (QnStepForces *all)
{
  free (all->forces);
  free (all->states);
  free (all->damage);
  *all = (QnStepForces){ 0 };
}
