/* Stages of loading: their order, and what the selected one drives, how, and how far. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "core/model/cycles.h"
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"
#include <glib/gi18n.h>

#define CHANGE N_ ("Change Stage")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (STAGES, "stages", NULL)                                                         \
  FIELD (ADD, "add", N_ ("Add Stage"))                                                   \
  FIELD (REMOVE, "remove", N_ ("Remove Stage"))                                          \
  FIELD (EARLIER, "earlier", N_ ("Move Stage"))                                          \
  FIELD (LATER, "later", N_ ("Move Stage"))                                              \
  FIELD (BOX, "fields", NULL)                                                            \
  MEMBER (NAME, "name", N_ ("Rename Stage"), QnStage, name)                              \
  MEMBER (SETS, "sets", CHANGE, QnStage, sets)                                           \
  MEMBER (PROCEDURE, "procedure", CHANGE, QnStage, procedure)                            \
  FIELD (END, "end", CHANGE)                                                             \
  MEMBER (TARGET, "target", CHANGE, QnStage, target)                                     \
  MEMBER (COMPONENT, "component", CHANGE, QnStage, control.dof)                          \
  MEMBER (DISTANCE, "distance", CHANGE, QnStage, control.target)                         \
  FIELD (CONTROL, "control", NULL)                                                       \
  FIELD (FOLLOW, "follow", CHANGE)                                                       \
  FIELD (AMPLITUDES, "amplitudes", CHANGE)                                               \
  FIELD (CYCLES, "cycles", CHANGE)                                                       \
  MEMBER (INCREMENTS, "increments", CHANGE, QnStage, increments)
QN_FORM_FIELDS;

static char *
dup_row (const QnModel *model, gsize index)
{
  return qn_stage_dup_text (model, index, qn_settings_get_units ());
}

/* ---- what is shown ---- */

/* A cyclic protocol is one item of the list: the first of its stages. */
static gboolean
look (QnForm *form, const QnModel *model)
{
  while (form->selected >= 0 && model->stages[form->selected].leg > 1)
    form->selected--;
  return TRUE;
}

static gboolean
show_stage (const QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnStage *stage = &model->stages[form->selected];
  gboolean controlled = qn_stage_get_end (stage) == QN_STAGE_END_DISPLACEMENT;
  gsize cycles;
  switch (field) {
  case SETS:
    qn_value_add_row (value, _ ("Growing loads"));
    for (int32_t set = 1; set <= (int32_t) model->load_set_count; set++)
      qn_value_add_row (value, qn_model_load_set_name (model, set));
    return TRUE;
  case END:
    value->number = qn_stage_get_end (stage);
    return TRUE;
  case TARGET:
    return stage->has_target && stage->leg == 0;
  case DISTANCE:
    g_object_set (
      form->widgets[DISTANCE], "quantity",
      stage->control.dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH, NULL);
    return controlled && stage->leg == 0;
  case AMPLITUDES:
  case CYCLES:
    value->text = qn_stage_dup_amplitudes (model, (gsize) form->selected,
                                           qn_settings_get_units (), &cycles);
    value->number = (double) cycles;
    value->disabled = field == CYCLES && stage->leg == 0;
    return controlled || stage->has_target;
  case CONTROL:
    if (controlled)
      value->text = stage->control.block != QN_NONE
                      ? g_strdup_printf (_ ("Control block: %s"),
                                         model->blocks[stage->control.block].name)
                      : g_strdup_printf (_ ("Control node: %s"),
                                         model->nodes[stage->control.node].name);
    return controlled;
  case NAME:
  case PROCEDURE:
  case INCREMENTS:
    return TRUE;
  default:
    return controlled;
  }
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  switch (field) {
  case ADD:
    return TRUE;
  case REMOVE:
    value->disabled = form->selected < 0;
    return TRUE;
  case EARLIER:
    value->disabled = form->selected <= 0;
    return TRUE;
  case LATER:
    value->disabled =
      form->selected < 0
      || (gsize) form->selected + qn_stage_span (model, (gsize) form->selected)
           >= model->stage_count;
    return TRUE;
  case BOX:
    return form->selected >= 0;
  default:
    return form->selected >= 0 && show_stage (form, model, field, value);
  }
}

/* ---- changes ---- */

/* The protocol as it is, or what is entered of it. Where its ends are told otherwise it is one cycle of the
 * end that the stage has now. */
static gboolean
change_cycles (const QnForm *form, QnModel *model, guint field, const QnValue *value,
               const QnStage *stage, GError **error)
{
  const gsize first = (gsize) form->selected;
  const double end = stage->has_target ? stage->target : stage->control.target;
  g_autofree double *amplitudes = g_new (double, qn_stage_span (model, first));
  gsize cycles, count = qn_stage_amplitudes (model, first, amplitudes, &cycles);
  if (field == AMPLITUDES) {
    g_free (amplitudes);
    amplitudes = qn_stage_parse_amplitudes (stage, value->text, qn_settings_get_units (),
                                            &count, error);
    if (amplitudes == NULL)
      return FALSE;
  } else if (count > 0
             && qn_stage_get_end (stage) != qn_stage_get_end (&model->stages[first])) {
    count = qn_stage_get_end (stage) != QN_STAGE_END_COLLAPSE;
    amplitudes[0] = end;
  }
  if (field == CYCLES)
    cycles = (gsize) value->number;
  return qn_edit_change_stage (model, first, stage, amplitudes, count, cycles, error);
}

/* Where nothing is said yet the load doubles, or the block moves a little. */
static gboolean
change (const QnForm *form, QnModel *model, guint field, const QnValue *value,
        GError **error)
{
  QnStage stage = model->stages[form->selected];
  QnStageEnd end = qn_stage_get_end (&stage);
  gboolean controlled = qn_control_is_given (&stage.control);
  if (field == END)
    end = (QnStageEnd) value->number;
  if (stage.procedure == QN_PROCEDURE_DISPLACEMENT)
    end = QN_STAGE_END_DISPLACEMENT;
  stage.has_target = end == QN_STAGE_END_MULTIPLIER;
  if (!stage.has_target)
    stage.target = 0.0;
  else if (stage.target == 0.0 && (form->selected == 0 || stage.leg > 0))
    stage.target = 1.0;
  if (end != QN_STAGE_END_DISPLACEMENT)
    stage.control.block = stage.control.node = QN_NONE;
  else if (field == FOLLOW || !controlled) {
    /* The selected block, or the second end of the selected beam where it stands free. */
    const QnPartSet set = form->parts;
    if (set.blocks.count == 0 && set.beams.count == 0)
      return qn_edit_refuse (
        error, _ ("Select the block or the beam whose displacement ends the stage"));
    stage.control.block = set.blocks.count > 0 ? set.blocks.ids[0] : QN_NONE;
    stage.control.node =
      set.blocks.count > 0 ? QN_NONE : model->beams[set.beams.ids[0]].nodes[1];
  }
  if (end == QN_STAGE_END_DISPLACEMENT && stage.control.target == 0.0)
    stage.control.target = qn_magnet_round_distance (0.05 * model->characteristic_length);
  return change_cycles (form, model, field, value, &stage, error);
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  gsize stage = (gsize) MAX (form->selected, 0);
  switch (field) {
  case ADD:
    form->wanted = (int) model->stage_count;
    return qn_edit_add_stage (model, error);
  case REMOVE:
    return qn_edit_delete_stage (model, stage, error);
  case EARLIER:
  case LATER:
    form->wanted = qn_edit_move_stage (model, stage, field == EARLIER ? -1 : 1, error);
    return form->wanted >= 0;
  case NAME:
    return qn_edit_rename_stage (model, stage, value->text, error);
  default:
    return change (form, model, field, value, error);
  }
}

static const QnFormList list =
  QN_FORM_LIST (STAGES, EMPTY, stages, stage_count, dup_row, QN_PICK_NOTHING);

const QnFormKind qn_stage_form =
  QN_FORM_KIND ("stage-form", QnForm, .list = &list, .look = look);
