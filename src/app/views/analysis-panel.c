#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  TITLE,
  GRAVITY,
  PROCEDURE,
  EXPLANATION,
  STAGES,
  GEOMETRY,
  FOLLOW,
  SNAP,
  INCREMENTS,
  MAX_MULTIPLIER,
  MULTIPLIER_TOLERANCE,
  RESIDUAL_TOLERANCE,
  CONTROL_BLOCK,
  COMPONENT,
  TARGET,
  LOAD, /* constant and growing, horizontal and vertical */
  PLACEMENT = LOAD + 4,
  OFFSET,
  COUNT,
  POSITIONS,
  WEIGHTS,
  TOLERANCE,
  DYNAMIC_BOX,
  LOADS_BOX,
  STAGES_BOX,
  LAWS_BOX
};

static const QnFormField fields[] = {
  [TITLE] = { .id = "title", .step = N_ ("Change Title") },
  [GRAVITY] = { .id = "gravity", .step = N_ ("Change Gravity") },
  [PROCEDURE] = { .id = "procedure", .step = N_ ("Change Analysis") },
  [EXPLANATION] = { .id = "explanation" },
  [STAGES] = { .id = "stages" },
  [GEOMETRY] = { .id = "geometry", .step = N_ ("Change Analysis") },
  [FOLLOW] = { .id = "follow", .step = N_ ("Change Analysis") },
  [SNAP] = { .id = "snap", .step = N_ ("Change Analysis") },
  [INCREMENTS] = { .id = "increments", .step = N_ ("Change Analysis") },
  [MAX_MULTIPLIER] = { .id = "max_multiplier", .step = N_ ("Change Analysis") },
  [MULTIPLIER_TOLERANCE] = { .id = "multiplier_tolerance",
                             .step = N_ ("Change Analysis") },
  [RESIDUAL_TOLERANCE] = { .id = "residual_tolerance", .step = N_ ("Change Analysis") },
  [CONTROL_BLOCK] = { .id = "control_block", .step = N_ ("Change Analysis") },
  [COMPONENT] = { .id = "component", .step = N_ ("Change Analysis") },
  [TARGET] = { .id = "target", .step = N_ ("Change Analysis") },
  [LOAD] = { .id = "constant_x", .step = N_ ("Change Loads") },
  [LOAD + 1] = { .id = "constant_y", .step = N_ ("Change Loads") },
  [LOAD + 2] = { .id = "growing_x", .step = N_ ("Change Loads") },
  [LOAD + 3] = { .id = "growing_y", .step = N_ ("Change Loads") },
  [PLACEMENT] = { .id = "placement", .step = N_ ("Change Analysis") },
  [OFFSET] = { .id = "offset", .step = N_ ("Change Analysis") },
  [COUNT] = { .id = "count", .step = N_ ("Change Analysis") },
  [POSITIONS] = { .id = "positions", .step = N_ ("Change Analysis") },
  [WEIGHTS] = { .id = "weights", .step = N_ ("Change Analysis") },
  [TOLERANCE] = { .id = "tolerance", .step = N_ ("Change Analysis") },
  [DYNAMIC_BOX] = { .id = "dynamic_box" },
  [LOADS_BOX] = { .id = "loads_box" },
  [STAGES_BOX] = { .id = "stages_box" },
  [LAWS_BOX] = { .id = "laws_box" },
};

/* Rows of the choice of procedure. */
static const struct {
  const char *label, *explanation;
  QnProcedure procedure;
  QnFlow flow;
} procedures[] = {
  { N_ ("Load control (HybriDFEM)"),
    N_ ("The load grows step by step until there is no equilibrium any more."),
    QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE },
  { N_ ("Displacement control"),
    N_ ("A block is moved step by step to the target; the multiplier follows, also where "
        "it "
        "falls."),
    QN_PROCEDURE_DISPLACEMENT, QN_FLOW_ASSOCIATIVE },
  { N_ ("Work control"),
    N_ (
      "Every increment does the same work of the growing load; follows falling branches "
      "without choosing a block."),
    QN_PROCEDURE_WORK, QN_FLOW_ASSOCIATIVE },
  { N_ ("Arc length"),
    N_ ("Load and displacements advance together along the path, past limit points."),
    QN_PROCEDURE_ARC_LENGTH, QN_FLOW_ASSOCIATIVE },
  { N_ ("Limit analysis, associative"),
    N_ ("Rigid blocks, dilatancy = friction: the greatest multiplier that can be carried "
        "at "
        "all, without a path."),
    QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE },
  { N_ ("Limit analysis, non-associative"),
    N_ ("Rigid blocks with the dilatancy of the laws: multipliers at which forces and "
        "mechanism are consistent. There may be several."),
    QN_PROCEDURE_LIMIT, QN_FLOW_NON_ASSOCIATIVE },
  { N_ ("In time (earthquakes)"),
    N_ ("The ground moves under the constant loads, step by step in time; growing loads "
        "are not applied."),
    QN_PROCEDURE_DYNAMIC, QN_FLOW_ASSOCIATIVE },
};

/* ---- what the fields show ---- */

static QnVec2
weight_load (const QnLoad *loads, gsize count)
{
  for (gsize i = 0; i < count; i++) {
    if (loads[i].kind == QN_LOAD_WEIGHT && loads[i].set == 0)
      return loads[i].vector;
  }
  return qn_vec2 (0.0, 0.0);
}

static guint
procedure_row (const QnAnalysisSettings *analysis)
{
  for (guint i = 0; i < G_N_ELEMENTS (procedures); i++) {
    if (procedures[i].procedure == analysis->procedure
        && (analysis->procedure != QN_PROCEDURE_LIMIT
            || procedures[i].flow == analysis->flow))
      return i;
  }
  return 0;
}

static gboolean
show_contact (const QnModel *model, guint field, QnValue *value)
{
  const QnPairRule *rule = &model->contact.pairs;
  switch (field) {
  case PLACEMENT:
    value->number = rule->placement;
    return TRUE;
  case OFFSET:
    value->number = rule->offset;
    return rule->placement <= QN_PLACEMENT_LOBATTO;
  case COUNT:
    value->number = qn_pair_rule_shown_count (rule, model, model->contact.law);
    return rule->placement >= QN_PLACEMENT_LOBATTO
           && rule->placement != QN_PLACEMENT_EXPLICIT;
  case POSITIONS: /* without any those of the ends are there to start from */
    value->text = qn_pair_rule_dup_positions (rule);
    return rule->placement == QN_PLACEMENT_EXPLICIT;
  case WEIGHTS:
    value->text = qn_pair_rule_dup_weights (rule);
    return rule->placement == QN_PLACEMENT_EXPLICIT;
  default:
    return TRUE;
  }
}

static QnBound
bound_of (QnModel *model, guint field)
{
  QnAnalysisSettings *a = &model->analysis;
  const QnBound all[G_N_ELEMENTS (fields)] = {
    [GRAVITY] = QN_BOUND (&model->gravity),
    [GEOMETRY] = QN_BOUND (&a->geometry),
    [FOLLOW] = QN_BOUND (&a->follow),
    [SNAP] = QN_BOUND (&a->snap),
    [INCREMENTS] = QN_BOUND (&a->increments),
    [MAX_MULTIPLIER] = QN_BOUND (&a->max_multiplier),
    [MULTIPLIER_TOLERANCE] = QN_BOUND (&a->multiplier_tolerance),
    [RESIDUAL_TOLERANCE] = QN_BOUND (&a->residual_tolerance),
    [COMPONENT] = QN_BOUND (&a->control_dof),
    [TARGET] = QN_BOUND (&a->control_target),
    [TOLERANCE] = QN_BOUND (&model->contact.tolerance),
  };
  return all[field];
}

/* Gravity makes weights of densities; weights that are given as such stay. */
static gboolean
has_density (const QnModel *model)
{
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].density >= 0.0)
      return TRUE;
  for (gsize i = 0; i < model->wall_count; i++)
    if (model->walls[i].density >= 0.0)
      return TRUE;
  for (gsize i = 0; i < model->section_count; i++)
    if (model->sections[i].density >= 0.0)
      return TRUE;
  return FALSE;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const QnBoundForm *form = data;
  const QnModel *model = qn_canvas_get_model (form->canvas);
  QnAnalysisSettings a = model->analysis;
  gboolean timed = a.procedure == QN_PROCEDURE_DYNAMIC, staged = model->stage_count > 0;
  gboolean path = a.procedure != QN_PROCEDURE_LIMIT && !timed;
  gboolean controlled =
    a.procedure == QN_PROCEDURE_DISPLACEMENT || (path && a.control_block != QN_NONE);
  QnVec2 load;
  qn_value_show (value, bound_of ((QnModel *) model, field));
  switch (field) {
  case TITLE:
    value->text = g_strdup (model->title);
    return TRUE;
  case GRAVITY:
    return has_density (model);
  case PROCEDURE:
    for (guint i = 0; i < G_N_ELEMENTS (procedures); i++)
      qn_value_add_row (value, _ (procedures[i].label));
    value->number = procedure_row (&a);
    return !staged;
  case EXPLANATION:
    value->text = g_strdup (_ (procedures[procedure_row (&a)].explanation));
    return !staged;
  case STAGES:
    value->text = g_strdup (_ ("Loaded in stages: each has its own procedure, increments "
                               "and end; the rest holds for all of them."));
    return staged;
  case GEOMETRY:
    return path || timed;
  case FOLLOW:
    return path && a.geometry == QN_GEOMETRY_NONLINEAR;
  case SNAP:
  case INCREMENTS:
  case MULTIPLIER_TOLERANCE:
    return path;
  case MAX_MULTIPLIER:
    return path && !staged;
  case RESIDUAL_TOLERANCE:
    return path || timed;
  case CONTROL_BLOCK:
    qn_value_add_row (value, C_ ("block", "None"));
    for (gsize i = 0; i < model->block_count; i++)
      qn_value_add_row (value, model->blocks[i].name);
    value->number = a.control_block + 1;
    return path;
  case COMPONENT:
    return controlled;
  case TARGET:
    g_object_set (form->widgets[TARGET], "quantity",
                  a.control_dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH,
                  NULL);
    return controlled;
  case LOAD:
  case LOAD + 1:
    load = weight_load (model->dead_loads, model->dead_load_count);
    value->number = field == LOAD ? load.x : load.y;
    return TRUE;
  case LOAD + 2:
  case LOAD + 3:
    load = weight_load (model->live_loads, model->live_load_count);
    value->number = field == LOAD + 2 ? load.x : load.y;
    return TRUE;
  default:
    return show_contact (model, field, value);
  }
}

/* ---- changes ---- */

/* The highest free block, moved along the growing load by a hundredth of its height. */
static void
choose_control (QnModel *model)
{
  QnAnalysisSettings *a = &model->analysis;
  double lowest = INFINITY, highest = -INFINITY;
  for (gsize i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    lowest = MIN (lowest, block->centroid.y);
    if (!block->support[QN_DOF_UX] && block->centroid.y > highest) {
      highest = block->centroid.y;
      a->control_block = (QnId) i;
    }
  }
  double push = 0.0;
  for (gsize i = 0; i < model->live_load_count; i++)
    push += model->live_loads[i].vector.x;
  a->control_dof = QN_DOF_UX;
  a->control_target = qn_magnet_round_distance (
    0.01 * MAX (highest - lowest, model->characteristic_length));
  if (push < 0.0)
    a->control_target = -a->control_target;
}

static gboolean
take_contact (gpointer form, QnModel *model, guint field, const QnValue *value,
              GError **error)
{
  QnPairRule *rule = &model->contact.pairs;
  if (field == OFFSET)
    rule->offset = value->number;
  else if (field == COUNT)
    rule->count = MAX (qn_value_int (value), 1);
  else if (field == PLACEMENT && (QnPlacement) value->number != QN_PLACEMENT_EXPLICIT) {
    QnValue count = { .number = qn_bound_form_get_number (form, COUNT) };
    rule->placement = (QnPlacement) value->number;
    rule->count =
      rule->placement == QN_PLACEMENT_LOBATTO ? 0 : MAX (qn_value_int (&count), 1);
  } else {
    g_autofree char *positions = qn_bound_form_dup_text (form, POSITIONS);
    g_autofree char *weights = qn_bound_form_dup_text (form, WEIGHTS);
    return qn_pair_rule_parse (rule, positions, weights, error);
  }
  return TRUE;
}

static gboolean
take_load (gpointer form, QnModel *model, guint field, GError **error)
{
  gboolean live = field >= LOAD + 2;
  guint x = live ? LOAD + 2 : LOAD;
  return qn_edit_set_weight_load (
    model, live,
    qn_vec2 (qn_bound_form_get_number (form, x), qn_bound_form_get_number (form, x + 1)),
    error);
}

/* An empty title is none. */
static gboolean
take_title (QnModel *model, const char *text, GError **error)
{
  char *title = *text != '\0' ? strdup (text) : NULL;
  if (title == NULL && *text != '\0')
    return qn_edit_no_memory (error);
  free (model->title);
  model->title = title;
  return TRUE;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  QnModel *model = &draft->model;
  QnAnalysisSettings *a = &model->analysis;
  guint row = (guint) MAX (value->number, 0.0);
  if (field == TITLE)
    return take_title (model, value->text, error);
  qn_value_take (value, bound_of (model, field));
  if (field >= PLACEMENT && field != TOLERANCE)
    return take_contact (data, model, field, value, error);
  if (field >= LOAD && field < PLACEMENT)
    return take_load (data, model, field, error);
  switch (field) {
  case PROCEDURE:
    if (procedures[row].procedure == QN_PROCEDURE_DYNAMIC)
      return qn_edit_choose_dynamic (model, error);
    a->procedure = procedures[row].procedure;
    if (a->procedure == QN_PROCEDURE_LIMIT)
      a->flow = procedures[row].flow;
    break;
  case CONTROL_BLOCK:
    a->control_block = row == 0 || row > model->block_count ? QN_NONE : (QnId) row - 1;
    if (a->control_block != QN_NONE) /* in place of a node of beams */
      a->control_node = QN_NONE;
    break;
  default:
    break;
  }
  if (a->procedure == QN_PROCEDURE_DISPLACEMENT && a->control_block == QN_NONE
      && a->control_node == QN_NONE)
    choose_control (model);
  return TRUE;
}

GtkWidget *
qn_analysis_panel_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_SHOWN_FORM_KIND ("analysis-panel", QnBoundForm);
  QnBoundForm *form = qn_bound_form_new (&kind, canvas);
  gtk_box_append (GTK_BOX (form->widgets[DYNAMIC_BOX]), qn_dynamic_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[LOADS_BOX]), qn_load_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[LOADS_BOX]), qn_case_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[STAGES_BOX]), qn_stage_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[LAWS_BOX]), qn_law_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[LAWS_BOX]), qn_bar_form_new (canvas));
  gtk_box_append (GTK_BOX (form->widgets[LAWS_BOX]), qn_tie_form_new (canvas));
  return qn_bound_form_show (form);
}
