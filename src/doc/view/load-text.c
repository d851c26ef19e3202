#include "doc/view/load-text.h"

#include "doc/edit/edit-stage.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n.h>

static const char *const components[QN_DOF_COUNT] = { "ux", "uy", "rz" };

static QnQuantity
quantity_of (QnDof dof)
{
  return dof == QN_DOF_RZ ? QN_QUANTITY_ANGLE : QN_QUANTITY_LENGTH;
}

static char *
dup_vector (QnUnits units, QnQuantity quantity, QnVec2 v)
{
  g_autofree char *x = qn_units_format (units, quantity, v.x, 4);
  g_autofree char *y = qn_units_format_full (units, quantity, v.y, 4);
  return g_strdup_printf ("%s; %s", x, y);
}

char *
qn_load_dup_text (const QnModel *model, const QnLoad *load, QnUnits units)
{
  g_autofree char *force = dup_vector (units, QN_QUANTITY_FORCE, load->vector);
  switch (load->kind) {
  case QN_LOAD_WEIGHT: {
    g_autofree char *direction = dup_vector (units, QN_QUANTITY_NUMBER, load->vector);
    return g_strdup_printf (_ ("Own weight × (%s)"), direction);
  }
  case QN_LOAD_FORCE:
    return g_strdup_printf (_ ("Force on %s: %s"), model->blocks[load->block].name,
                            force);
  case QN_LOAD_NODE:
    return g_strdup_printf (_ ("Force on node %s: %s"), model->nodes[load->node].name,
                            force);
  case QN_LOAD_LINE: {
    g_autofree char *line = dup_vector (units, QN_QUANTITY_STIFFNESS, load->vector);
    return g_strdup_printf (_ ("Along %s: %s"), model->beams[load->beam].name, line);
  }
  case QN_LOAD_SETTLEMENT: {
    g_autofree char *value =
      qn_units_format_full (units, quantity_of (load->dof), load->value, 4);
    return g_strdup_printf (_ ("Settlement of %s, %s: %s"),
                            model->blocks[load->block].name, components[load->dof],
                            value);
  }
  case QN_LOAD_KIND_COUNT:
    break;
  }
  return g_strdup ("");
}

/* Names of the load sets that a stage drives, with commas. */
static char *
dup_set_names (const QnModel *model, const QnStage *stage)
{
  GString *names = g_string_new (NULL);
  for (int32_t set = 0; set <= (int32_t) model->load_set_count; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    g_string_append_printf (names, "%s%s", names->len > 0 ? ", " : "",
                            set == 0 ? _ ("growing loads")
                                     : qn_model_load_set_name (model, set));
  }
  return g_string_free (names, FALSE);
}

char *
qn_stage_dup_text (const QnModel *model, gsize index, QnUnits units)
{
  const QnStage *stage = &model->stages[index];
  g_autofree char *name = qn_stage_dup_name (model, (int32_t) index + 1);
  g_autofree char *sets = dup_set_names (model, stage);
  g_autofree char *target = NULL;
  switch (qn_stage_get_end (stage)) {
  case QN_STAGE_END_MULTIPLIER:
    target = qn_units_format (units, QN_QUANTITY_NUMBER, stage->target, 5);
    return g_strdup_printf (_ ("%s: %s to %s"), name, sets, target);
  case QN_STAGE_END_DISPLACEMENT:
    target = qn_units_format_full (units, quantity_of (stage->control_dof),
                                   stage->control_target, 4);
    return g_strdup_printf (_ ("%s: %s until %s is %s"), name, sets,
                            components[stage->control_dof], target);
  case QN_STAGE_END_COLLAPSE:
  case QN_STAGE_END_COUNT:
    break;
  }
  return qn_model_sets_have_force (model, stage->sets)
           ? g_strdup_printf (_ ("%s: %s to collapse"), name, sets)
           : g_strdup_printf (_ ("%s: %s to %s"), name, sets, "1");
}

bool
qn_result_stage_steps (const QnResult *result, int32_t stage, size_t *first, size_t *last)
{
  bool found = false;
  for (size_t i = 0; i < result->step_count; i++) {
    if (result->steps[i].stage != stage)
      continue;
    if (!found)
      *first = i;
    *last = i;
    found = true;
  }
  return found;
}
