#include "doc/view/load-text.h"

#include "core/model/cycles.h"
#include "doc/edit/edit-stage.h"
#include "io/project/project-members.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n-lib.h>

/* The sum of forces over that of their sizes above which they have one direction. */
#define ONE_DIRECTION (1.0 - 1e-9)

static QnQuantity
quantity_of (QnDof dof)
{
  return dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH;
}

/* With its unit. */
static char *
in_full (QnUnits units, QnQuantity quantity, double value)
{
  return qn_units_format_full (units, quantity, value, 4);
}

static char *
dup_edge_text (const QnModel *model, const QnLoad *load, QnUnits units)
{
  static const char *const sides[QN_BLOCK_SIDE_COUNT] = {
    [QN_BLOCK_SIDE_LEFT] = N_ ("left side"),
    [QN_BLOCK_SIDE_RIGHT] = N_ ("right side"),
    [QN_BLOCK_SIDE_BOTTOM] = N_ ("bottom"),
    [QN_BLOCK_SIDE_TOP] = N_ ("top"),
  };
  const char *block = model->blocks[load->block].name;
  /* "2 to 5 kN/m", or one number where both are the same. */
  g_autofree char *from =
    qn_units_format (units, QN_QUANTITY_STIFFNESS, load->intensity[0], 4);
  g_autofree char *to = in_full (units, QN_QUANTITY_STIFFNESS, load->intensity[1]);
  g_autofree char *intensity = load->intensity[0] == load->intensity[1]
                                 ? g_steal_pointer (&to)
                                 : g_strdup_printf (_ ("%s to %s"), from, to);
  g_autofree char *where =
    load->has_side ? g_strdup (_ (sides[load->side]))
    : load->edge_count == 1
      ? g_strdup_printf (_ ("edge %d"), load->edge)
      : g_strdup_printf (_ ("%d edges from %d"), load->edge_count, load->edge);
  g_autofree char *direction =
    load->normal ? g_strdup (_ ("normal"))
                 : qn_units_format_pair (units, QN_QUANTITY_NUMBER, load->vector, 4);
  return g_strdup_printf (_ ("Edge load on %s, %s: %s (%s)"), block, where, intensity,
                          direction);
}

/* "; from x = 2 m; to x = 5 m", where the range has these ends. */
static void
append_span (GString *text, QnUnits units, char axis, const double span[2])
{
  for (int end = 0; end < 2; end++) {
    g_autofree char *at = in_full (units, QN_QUANTITY_LENGTH, span[end]);
    if (isfinite (span[end]))
      g_string_append_printf (text, end == 0 ? _ ("; from %c = %s") : _ ("; to %c = %s"),
                              axis, at);
  }
}

static char *
dup_surcharge_text (const QnLoad *load, QnUnits units)
{
  g_autofree char *pressure = in_full (units, QN_QUANTITY_PRESSURE, load->pressure);
  g_autofree char *weight = in_full (units, QN_QUANTITY_UNIT_WEIGHT, load->unit_weight);
  g_autofree char *level = in_full (units, QN_QUANTITY_LENGTH, load->level);
  GString *text = g_string_new (NULL);
  if (load->unit_weight > 0)
    g_string_append_printf (text, _ ("Fill of %s up to y = %s"), weight, level);
  if (load->unit_weight > 0 && load->pressure > 0)
    g_string_append (text, "; ");
  if (load->pressure > 0 || load->unit_weight == 0)
    g_string_append_printf (text, _ ("Surcharge %s"), pressure);
  append_span (text, units, 'x', load->span);
  return g_string_free (text, FALSE);
}

static char *
dup_backfill_text (const QnLoad *load, QnUnits units)
{
  g_autofree char *weight = in_full (units, QN_QUANTITY_UNIT_WEIGHT, load->unit_weight);
  g_autofree char *pressure = in_full (units, QN_QUANTITY_PRESSURE, load->pressure);
  g_autofree char *k =
    qn_units_format (units, QN_QUANTITY_NUMBER, qn_load_earth_coefficient (load), 4);
  GString *text = g_string_new (NULL);
  g_string_append_printf (text,
                          load->side == QN_BLOCK_SIDE_LEFT
                            ? _ ("Backfill on the left: %s, K = %s")
                            : _ ("Backfill on the right: %s, K = %s"),
                          weight, k);
  if (load->pressure > 0)
    g_string_append_printf (text, _ ("; surcharge %s"), pressure);
  append_span (text, units, 'y', load->span);
  return g_string_free (text, FALSE);
}

static char *
dup_fill_text (const QnLoad *load, QnUnits units)
{
  g_autofree char *weight = in_full (units, QN_QUANTITY_UNIT_WEIGHT, load->unit_weight);
  g_autofree char *from = in_full (units, QN_QUANTITY_LENGTH, load->surface[0].x);
  g_autofree char *to =
    in_full (units, QN_QUANTITY_LENGTH, load->surface[load->surface_count - 1].x);
  g_autofree char *angle = in_full (units, QN_QUANTITY_ANGLE, load->friction_angle);
  g_autofree char *part =
    qn_units_format (units, QN_QUANTITY_NUMBER, load->mobilisation, 3);
  GString *text = g_string_new (NULL);
  g_string_append_printf (text, _ ("Fill of %s from x = %s to %s"), weight, from, to);
  if (load->friction_angle > 0)
    g_string_append_printf (text, _ ("; friction angle %s, %s of Kp mobilised"), angle,
                            part);
  return g_string_free (text, FALSE);
}

static char *
dup_vehicle_text (const QnModel *model, const QnLoad *load, QnUnits units)
{
  g_autofree char *at = in_full (units, QN_QUANTITY_LENGTH, load->position);
  GString *text = g_string_new (NULL);
  g_string_append_printf (
    text,
    load->reversed ? _ ("%s to the left, front at x = %s, spread by %s")
                   : _ ("%s to the right, front at x = %s, spread by %s"),
    model->vehicles[load->vehicle].name, at, qn_dispersal_names[load->dispersal]);
  if (load->convoy > 1)
    g_string_append_printf (text, _ ("; convoy of %d"), (int) load->convoy);
  return g_string_free (text, FALSE);
}

char *
qn_load_dup_text (const QnModel *model, const QnLoad *load, QnUnits units)
{
  g_autofree char *force =
    qn_units_format_pair (units, QN_QUANTITY_FORCE, load->vector, 4);
  switch (load->kind) {
  case QN_LOAD_WEIGHT: {
    g_autofree char *direction =
      qn_units_format_pair (units, QN_QUANTITY_NUMBER, load->vector, 4);
    return g_strdup_printf (_ ("Own weight × (%s)"), direction);
  }
  case QN_LOAD_FORCE:
    return g_strdup_printf (_ ("Force on %s: %s"), model->blocks[load->block].name,
                            force);
  case QN_LOAD_NODE:
    return g_strdup_printf (_ ("Force on node %s: %s"), model->nodes[load->node].name,
                            force);
  case QN_LOAD_LINE: {
    g_autofree char *line =
      qn_units_format_pair (units, QN_QUANTITY_STIFFNESS, load->vector, 4);
    return g_strdup_printf (_ ("Along %s: %s"), model->beams[load->beam].name, line);
  }
  case QN_LOAD_SETTLEMENT: {
    g_autofree char *value = qn_units_format_full (
      qn_units_of_motion (units), quantity_of (load->dof), load->value, 4);
    return g_strdup_printf (_ ("Settlement of %s, %s: %s"),
                            model->blocks[load->block].name, qn_dof_names[load->dof],
                            value);
  }
  case QN_LOAD_EDGE:
    return dup_edge_text (model, load, units);
  case QN_LOAD_SURCHARGE:
    return dup_surcharge_text (load, units);
  case QN_LOAD_BACKFILL:
    return dup_backfill_text (load, units);
  case QN_LOAD_FILL:
    return dup_fill_text (load, units);
  case QN_LOAD_VEHICLE:
    return dup_vehicle_text (model, load, units);
  case QN_LOAD_KIND_COUNT:
    break;
  }
  return g_strdup ("");
}

static QnQuantity
end_quantity (const QnStage *stage)
{
  return qn_stage_get_end (stage) == QN_STAGE_END_DISPLACEMENT
           ? quantity_of (stage->control.dof)
           : QN_QUANTITY_NUMBER;
}

char *
qn_stage_dup_amplitudes (const QnModel *model, gsize index, QnUnits units, gsize *cycles)
{
  g_autofree double *amplitudes = g_new (double, qn_stage_span (model, index));
  const gsize count = qn_stage_amplitudes (model, index, amplitudes, cycles);
  return qn_units_format_list (qn_units_of_motion (units),
                               end_quantity (&model->stages[index]), amplitudes, count,
                               6);
}

double *
qn_stage_parse_amplitudes (const QnStage *stage, const char *text, QnUnits units,
                           gsize *count, GError **error)
{
  g_autofree double *amplitudes = g_new (double, QN_MAX_STAGES);
  return qn_units_parse_list (qn_units_of_motion (units), end_quantity (stage), text,
                              amplitudes, QN_MAX_STAGES, count, error)
           ? g_steal_pointer (&amplitudes)
           : NULL;
}

char *
qn_stage_dup_text (const QnModel *model, gsize index, QnUnits units)
{
  const QnStage *stage = &model->stages[index];
  g_autofree char *name = qn_stage_dup_name (model, (int32_t) index + 1);
  /* Names of the load sets that a stage drives, with commas. */
  GString *names = g_string_new (NULL);
  for (int32_t set = 0; set <= (int32_t) model->load_set_count; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    g_string_append_printf (names, "%s%s", names->len > 0 ? ", " : "",
                            set == 0 ? _ ("growing loads")
                                     : qn_model_load_set_name (model, set));
  }
  g_autofree char *sets = g_string_free (names, FALSE);
  g_autofree char *target = NULL;
  if (stage->leg > 1)
    return g_strdup ("");
  if (stage->leg == 1) {
    gsize cycles;
    target = qn_stage_dup_amplitudes (model, index, units, &cycles);
    return g_strdup_printf (ngettext ("%s: %s to and fro by %s, %d cycle each",
                                      "%s: %s to and fro by %s, %d cycles each", cycles),
                            stage->name != NULL ? stage->name : name, sets, target,
                            (int) cycles);
  }
  switch (qn_stage_get_end (stage)) {
  case QN_STAGE_END_MULTIPLIER:
    target = qn_units_format (units, QN_QUANTITY_NUMBER, stage->target, 5);
    return g_strdup_printf (_ ("%s: %s to %s"), name, sets, target);
  case QN_STAGE_END_DISPLACEMENT:
    target =
      qn_units_format_full (qn_units_of_motion (units), quantity_of (stage->control.dof),
                            stage->control.target, 4);
    return g_strdup_printf (_ ("%s: %s until %s is %s"), name, sets,
                            qn_dof_names[stage->control.dof], target);
  case QN_STAGE_END_COLLAPSE:
    break;
  }
  return qn_model_sets_have_force (model, stage->sets)
           ? g_strdup_printf (_ ("%s: %s to collapse"), name, sets)
           : g_strdup_printf (_ ("%s: %s to %s"), name, sets, "1");
}

/* Of all axles, N. */
static double
vehicle_weight (const QnModel *model, const QnLoad *load)
{
  const QnVehicle *vehicle = &model->vehicles[load->vehicle];
  double sum = 0.0;
  for (int32_t i = 0; i < vehicle->axle_count; i++)
    sum += vehicle->axles[i].load;
  return sum * MAX (load->convoy, 1);
}

char *
qn_live_loads_dup_amount (const QnModel *model, double multiplier, QnUnits units)
{
  QnVec2 sum = { 0.0, 0.0 };
  double total = 0.0;
  bool weights = false, forces = false;
  if (model->stage_count > 0)
    return NULL;
  for (gsize i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    double factor = qn_model_load_factor (model, load);
    if (load->set != 0)
      continue;
    QnVec2 force = qn_vec2_scale (factor, load->vector);
    if (load->kind == QN_LOAD_SETTLEMENT || load->moment != 0.0)
      return NULL;
    if (load->kind == QN_LOAD_VEHICLE)
      force.y = -factor * vehicle_weight (model, load);
    else if (load->kind != QN_LOAD_WEIGHT && load->kind != QN_LOAD_FORCE
             && load->kind != QN_LOAD_NODE)
      force = qn_model_load_resultant (model, model->dead_load_count + i);
    *(load->kind == QN_LOAD_WEIGHT ? &weights : &forces) = true;
    sum = qn_vec2_add (sum, force);
    total += qn_vec2_length (force);
  }
  double size = qn_vec2_length (sum);
  if (weights == forces || !(size > ONE_DIRECTION * total))
    return NULL;
  if (forces)
    return qn_units_format_full (units, QN_QUANTITY_FORCE, multiplier * size, 3);
  return sum.y == 0.0 ? g_strdup_printf (_ ("%.3g g"), multiplier * size) : NULL;
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
