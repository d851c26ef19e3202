#include "core/model/cycles.h"

#include <stdlib.h>
#include <string.h>

size_t
qn_stage_span (const QnModel *model, size_t first)
{
  size_t end = first + 1;

  while (end < model->stage_count && model->stages[end].leg > 1)
    end++;
  return end - first;
}

size_t
qn_stage_amplitudes (const QnModel *model, size_t first, double *amplitudes,
                     size_t *cycles)
{
  const QnStage *stages = &model->stages[first];
  size_t count = 0, kept = 0;
  bool uniform = true;

  *cycles = 1;
  if (stages->leg == 0)
    return 0;
  for (size_t i = 0; i < qn_stage_span (model, first); i += QN_CYCLE_LEGS)
    amplitudes[count++] =
      stages[i].has_target ? stages[i].target : stages[i].control.target;
  while (*cycles < count && amplitudes[*cycles] == amplitudes[0])
    ++*cycles;
  for (size_t i = 0; i < count; i++)
    uniform = uniform && amplitudes[i] == amplitudes[i - i % *cycles];
  if (!uniform || count % *cycles > 0)
    *cycles = 1;
  for (size_t i = 0; i < count; i += *cycles)
    amplitudes[kept++] = amplitudes[i];
  return kept;
}

bool
qn_model_set_cycles (QnModel *model, size_t first, const double *amplitudes, size_t count,
                     size_t cycles)
{
  size_t span = qn_stage_span (model, first);
  size_t wanted = count > 0 ? QN_CYCLE_LEGS * count * cycles : 1;

  for (; span > wanted; span--) {
    QnStage *last = &model->stages[first + span - 1];
    free (last->name);
    memmove (last, last + 1, (--model->stage_count - (first + span - 1)) * sizeof *last);
  }
  for (; span < wanted; span++) {
    QnStage *added = qn_model_add_stage (model, model->stages[first].name);
    if (added == NULL)
      return false;
    const QnStage stage = *added;
    QnStage *place = &model->stages[first + span];
    memmove (place + 1, place, (size_t) (added - place) * sizeof *place);
    *place = stage;
  }
  QnStage stage = model->stages[first];
  if (count > 0)
    stage.has_target = !qn_control_is_given (&stage.control);
  for (size_t i = 0; i < wanted; i++) {
    stage.name = model->stages[first + i].name;
    stage.leg = count > 0 ? (int32_t) i + 1 : 0;
    if (count > 0) {
      double amplitude = amplitudes[i / (QN_CYCLE_LEGS * cycles)];
      *(stage.has_target ? &stage.target : &stage.control.target) =
        i % QN_CYCLE_LEGS == 0   ? amplitude
        : i % QN_CYCLE_LEGS == 1 ? -amplitude
                                 : 0;
    }
    model->stages[first + i] = stage;
  }
  return true;
}
