#include "doc/edit/edit-stage.h"

#include "core/model/cycles.h"
#include "io/project/project-vehicle.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- sets and cases ---- */

gboolean
qn_edit_add_load_list (QnModel *model, gboolean cases, GError **error)
{
  const gsize count = cases ? model->load_case_count : model->load_set_count;
  g_autofree char *name = qn_edit_dup_new_name (
    model, cases ? offsetof (QnModel, load_cases) : offsetof (QnModel, load_sets),
    cases ? _ ("case") : _ ("set"), " ", count + 1);
  if (cases ? count >= QN_MAX_LOAD_CASES : count + 1 >= QN_MAX_LOAD_SETS)
    return qn_edit_refuse (error, cases
                                    ? _ ("The largest number of load cases is reached")
                                    : _ ("The largest number of load sets is reached"));
  return (cases ? qn_model_add_load_case : qn_model_add_load_set) (model, name) != QN_NONE
         || qn_edit_no_memory (error);
}

gboolean
qn_edit_rename_load_list (QnModel *model, gboolean cases, int32_t number,
                          const char *name, GError **error)
{
  if (*name == '\0'
      || (cases ? qn_model_find_load_case : qn_model_find_load_set) (model, name)
           != QN_NONE
      || (!cases && g_str_equal (name, "dead")))
    return qn_edit_refuse (error, cases ? _ ("A load case needs a name of its own")
                                        : _ ("A set of loads needs a name of its own"));
  return qn_edit_take_name (cases ? &model->load_cases[number - 1].name
                                  : &model->load_sets[number - 1],
                            name, error);
}

static uint32_t
without_bit (uint32_t bits, int32_t set)
{
  uint32_t low = (UINT32_C (1) << set) - 1;
  return (bits & low) | (bits >> 1 & ~low);
}

gboolean
qn_edit_delete_load_set (QnModel *model, int32_t set, GError **error)
{
  gsize kept = 0;
  for (gsize i = 0; i < model->live_load_count; i++) {
    QnLoad load = model->live_loads[i];
    if (load.set == set)
      continue;
    load.set -= load.set > set;
    model->live_loads[kept++] = load;
  }
  model->live_load_count = kept;
  kept = 0;
  for (gsize i = 0; i < model->stage_count; i++) {
    QnStage stage = model->stages[i];
    stage.sets = without_bit (stage.sets, set);
    if (stage.sets != 0)
      model->stages[kept++] = stage;
    else
      free (stage.name);
  }
  model->stage_count = kept;
  free (model->load_sets[set - 1]);
  qn_edit_drop (model->load_sets, &model->load_set_count, sizeof *model->load_sets,
                (gsize) set - 1);
  return TRUE;
}

gboolean
qn_edit_delete_load_case (QnModel *model, int32_t number, GError **error)
{
  for (int live = 0; live < 2; live++) {
    gsize count;
    QnLoad *loads = qn_model_loads (model, live, &count);
    for (gsize i = 0; i < count; i++) {
      if (loads[i].load_case == number)
        loads[i].load_case = 0;
      loads[i].load_case -= loads[i].load_case > number;
    }
  }
  free (model->load_cases[number - 1].name);
  qn_edit_drop (model->load_cases, &model->load_case_count, sizeof *model->load_cases,
                (gsize) number - 1);
  return TRUE;
}

/* ---- loads ---- */

QnBox
qn_edit_box_of (const QnModel *model, QnBlockSet set)
{
  g_autofree gboolean *flags = qn_block_set_to_flags (set, model);
  QnBox box = QN_BOX_EMPTY;
  for (gsize b = 0; b < model->block_count; b++)
    if (set.count > 0 ? flags[b] : !qn_support_is_full (model->blocks[b].support))
      qn_box_add_box (&box, qn_model_block_box (model, (QnId) b));
  return box;
}

/* Stone and soil as they are usual: 10 kN/m, 10 kPa, 18 kN/m3 with an angle of friction of 30 degrees; about the
 * blocks, in whole centimetres. */
gboolean
qn_edit_make_edge_load (QnModel *model, QnLoadKind kind, QnBlockSet set, QnLoad *load,
                        GError **error)
{
  *load = (QnLoad){ .kind = kind,
                    .block = QN_NONE,
                    .node = QN_NONE,
                    .beam = QN_NONE,
                    .edge_count = 1,
                    .part = { 0.0, 1.0 },
                    .intensity = { 1e4, 1e4 },
                    .normal = true,
                    .convoy = 1,
                    .stiffness = QN_USUAL_SOIL_STIFFNESS,
                    .has_side = true,
                    .side = QN_BLOCK_SIDE_TOP };
  if (kind == QN_LOAD_EDGE && set.count == 0)
    return qn_edit_refuse (error, _ ("Select the block whose edge is loaded"));
  QnBox box = qn_edit_box_of (model, set);
  if (qn_box_is_empty (box))
    return qn_edit_refuse (error, _ ("There is no block to be loaded"));
  box.min = qn_vec2 (floor (100.0 * box.min.x + 1e-6) / 100.0,
                     floor (100.0 * box.min.y + 1e-6) / 100.0);
  box.max = qn_vec2 (ceil (100.0 * box.max.x - 1e-6) / 100.0,
                     ceil (100.0 * box.max.y - 1e-6) / 100.0);
  switch ((int) kind) {
  case QN_LOAD_EDGE:
    load->block = set.ids[0];
    break;
  case QN_LOAD_SURCHARGE:
    load->pressure = 1e4;
    load->span[0] = box.min.x;
    load->span[1] = box.max.x;
    break;
  case QN_LOAD_FILL:
    load->unit_weight = 18e3;
    load->friction_angle = G_PI / 6.0;
    load->span[0] = box.min.y;
    load->span[1] = box.max.y;
    load->surface_count = 2;
    for (int end = 0; end < 2; end++)
      load->surface[end] = qn_vec2 (end == 0 ? box.min.x : box.max.x, box.max.y + 0.3);
    break;
  case QN_LOAD_VEHICLE:
    load->vehicle = qn_model_take_vehicle (model, "LM1 tandem");
    load->position = 0.5 * (box.min.x + box.max.x);
    if (load->vehicle == QN_NONE)
      return qn_edit_no_memory (error);
    break;
  default:
    load->side = QN_BLOCK_SIDE_LEFT;
    load->span[0] = box.min.y;
    load->span[1] = box.max.y;
    load->unit_weight = 18e3;
    load->earth = QN_EARTH_ACTIVE;
    load->friction_angle = G_PI / 6.0;
    break;
  }
  return TRUE;
}

QnId
qn_model_load_beside (const QnModel *model, gboolean live, QnId load, int by)
{
  gsize count;
  const QnLoad *loads = qn_model_loads (model, live, &count);
  QnId other = load + by;
  /* Settlements have a list of their own in the window. */
  while (other >= 0 && (gsize) other < count
         && (loads[other].set != loads[load].set
             || (loads[other].kind == QN_LOAD_SETTLEMENT)
                  != (loads[load].kind == QN_LOAD_SETTLEMENT)))
    other += by;
  return (gsize) other < count ? other : QN_NONE;
}

gboolean
qn_edit_move_load (QnModel *model, gboolean live, QnId load, int by, GError **error)
{
  const QnPickKind kind = QN_PICK_LOAD (live);
  if (!qn_edit_has_item (model, kind, load, error))
    return FALSE;
  const QnId other = qn_model_load_beside (model, live, load, by);
  if (!qn_edit_has_item (model, kind, other, error))
    return FALSE;
  QnLoad *loads = qn_model_loads (model, live, NULL), moved = loads[load];
  loads[load] = loads[other];
  loads[other] = moved;
  return TRUE;
}

/* ---- stages ---- */

QnStageEnd
qn_stage_get_end (const QnStage *stage)
{
  if (qn_control_is_given (&stage->control))
    return QN_STAGE_END_DISPLACEMENT;
  return stage->has_target ? QN_STAGE_END_MULTIPLIER : QN_STAGE_END_COLLAPSE;
}

/* Stages but the last must end somewhere: one that does not is driven by 1 from where its sets
 * were left. */
static void
close_ends (QnModel *model)
{
  double multiplier[QN_MAX_LOAD_SETS] = { 0 };
  for (gsize i = 0; i < model->stage_count; i++) {
    QnStage *stage = &model->stages[i];
    gboolean ends = qn_stage_get_end (stage) != QN_STAGE_END_COLLAPSE
                    || !qn_model_sets_have_force (model, stage->sets);
    double from = 0.0;
    for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
      if (stage->sets >> set & 1 && !isnan (multiplier[set]))
        from = multiplier[set];
    if (!ends && i + 1 < model->stage_count) {
      stage->has_target = true;
      stage->target = from + 1.0;
    }
    double reached = stage->has_target                       ? stage->target
                     : qn_control_is_given (&stage->control) ? NAN
                                                             : 1.0;
    for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
      if (stage->sets >> set & 1)
        multiplier[set] = reached;
  }
}

gboolean
qn_edit_add_stage (QnModel *model, GError **error)
{
  QnStage *stage = qn_model_add_stage (model, NULL);
  if (stage == NULL)
    return qn_edit_no_memory (error);
  stage->procedure = QN_PROCEDURE_LOAD;
  if (model->stage_count == 1) {
    /* The analysis as a whole becomes its first stage. */
    QnAnalysisSettings *a = &model->analysis;
    if (a->procedure == QN_PROCEDURE_LIMIT)
      a->procedure = QN_PROCEDURE_LOAD;
    stage->sets = 1;
    stage->procedure = a->procedure;
    if (a->procedure == QN_PROCEDURE_DISPLACEMENT)
      stage->control = a->control;
    stage->has_target =
      isfinite (a->max_multiplier) && !qn_control_is_given (&stage->control);
    stage->target = stage->has_target ? a->max_multiplier : 0.0;
    a->max_multiplier = INFINITY;
    return TRUE;
  }
  /* A further one drives a set that has loads and waits, or what the stage before drives. */
  uint32_t waiting = 0;
  for (gsize i = 0; i < model->live_load_count; i++)
    waiting |= UINT32_C (1) << model->live_loads[i].set;
  for (gsize i = 0; i + 1 < model->stage_count; i++)
    waiting &= ~model->stages[i].sets;
  stage->sets = waiting != 0 ? waiting & (~waiting + 1) /* the first of them */
                             : model->stages[model->stage_count - 2].sets;
  close_ends (model);
  /* Settlements that went to 1 come back. */
  const QnStage *before = stage - 1;
  if (!qn_model_sets_have_force (model, stage->sets) && before->sets == stage->sets) {
    double reached = before->has_target ? before->target : 1.0;
    stage->has_target = true;
    stage->target = reached != 0.0 ? 0.0 : 1.0;
  }
  return TRUE;
}

gboolean
qn_edit_delete_stage (QnModel *model, gsize index, GError **error)
{
  (void) error;
  for (gsize span = qn_stage_span (model, index); span > 0; span--) {
    free (model->stages[index].name);
    qn_edit_drop (model->stages, &model->stage_count, sizeof *model->stages, index);
  }
  return TRUE;
}

int
qn_edit_move_stage (QnModel *model, gsize index, int by, GError **error)
{
  gsize first = index;
  if (by < 0 && index > 0)
    while (model->stages[--first].leg > 1)
      ;
  const gsize ahead = qn_stage_span (model, first);
  if (first + ahead >= model->stage_count || (by < 0 && index == 0)) {
    qn_edit_refuse (error, _ ("There is no stage to swap with"));
    return -1;
  }
  const gsize behind = qn_stage_span (model, first + ahead);
  QnStage *stages = model->stages + first;
  g_autofree QnStage *moved = g_memdup2 (stages, ahead * sizeof *stages);
  memmove (stages, stages + ahead, behind * sizeof *stages);
  memcpy (stages + behind, moved, ahead * sizeof *stages);
  close_ends (model);
  return (int) (by < 0 ? first : first + behind);
}

gboolean
qn_edit_change_stage (QnModel *model, gsize index, const QnStage *settings,
                      const double *amplitudes, gsize count, gsize cycles, GError **error)
{
  char *name = model->stages[index].name;
  model->stages[index] = *settings;
  model->stages[index].name = name;
  for (gsize i = 0; i < count; i++)
    if (amplitudes[i] == 0.0)
      return qn_edit_refuse (error, _ ("An amplitude is not 0"));
  if (count * cycles * QN_CYCLE_LEGS > QN_MAX_STAGES)
    return qn_edit_refuse (error, _ ("So many cycles are too many stages"));
  return qn_model_set_cycles (model, index, amplitudes, count, cycles)
         || qn_edit_no_memory (error);
}

gboolean
qn_edit_rename_stage (QnModel *model, gsize index, const char *name, GError **error)
{
  for (gsize i = qn_stage_span (model, index); i-- > 0;)
    if (!qn_edit_take_text (&model->stages[index + i].name, name, error))
      return FALSE;
  return TRUE;
}
