#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>
#include <math.h>

#define CHANGE N_ ("Change Analysis")

#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (TITLE, "title", N_ ("Change Title"), QnModel, title)                           \
  MEMBER (GRAVITY, "gravity", N_ ("Change Gravity"), QnModel, gravity)                   \
  FIELD (PROCEDURE, "procedure", CHANGE)                                                 \
  FIELD (EXPLANATION, "explanation", NULL)                                               \
  FIELD (STAGES, "staged", NULL)                                                         \
  MEMBER (GEOMETRY, "geometry", CHANGE, QnModel, analysis.geometry)                      \
  MEMBER (FOLLOW, "follow", CHANGE, QnModel, analysis.follow)                            \
  MEMBER (SNAP, "snap", CHANGE, QnModel, analysis.snap)                                  \
  MEMBER (INCREMENTS, "increments", CHANGE, QnModel, analysis.increments)                \
  MEMBER (MAX_MULTIPLIER, "max_multiplier", CHANGE, QnModel, analysis.max_multiplier)    \
  MEMBER (MULTIPLIER_TOLERANCE, "multiplier_tolerance", CHANGE, QnModel,                 \
          analysis.multiplier_tolerance)                                                 \
  MEMBER (RESIDUAL_TOLERANCE, "residual_tolerance", CHANGE, QnModel,                     \
          analysis.residual_tolerance)                                                   \
  FIELD (CONTROL_BLOCK, "control_block", CHANGE)                                         \
  MEMBER (COMPONENT, "component", CHANGE, QnModel, analysis.control.dof)                 \
  MEMBER (TARGET, "target", CHANGE, QnModel, analysis.control.target)                    \
  FIELD (LOAD, "constant_x",                                                             \
         N_ ("Change Loads")) /* constant and growing, horizontal and vertical */        \
  FIELD (CONSTANT_Y, "constant_y", N_ ("Change Loads"))                                  \
  FIELD (GROWING_X, "growing_x", N_ ("Change Loads"))                                    \
  FIELD (GROWING_Y, "growing_y", N_ ("Change Loads"))                                    \
  FIELD (PLACEMENT, "placement", CHANGE)                                                 \
  MEMBER (OFFSET, "offset", CHANGE, QnModel, contact.pairs.offset)                       \
  FIELD (COUNT, "count", CHANGE)                                                         \
  FIELD (POSITIONS, "positions", CHANGE)                                                 \
  FIELD (WEIGHTS, "weights", CHANGE)                                                     \
  MEMBER (TOLERANCE, "tolerance", CHANGE, QnModel, contact.tolerance)                    \
  FIELD (METHOD_TEXT, "method_text", NULL) /* beside the names of the cards */           \
  FIELD (MATERIALS_TEXT, "materials_text", NULL)                                         \
  FIELD (LOADS_TEXT, "loads_text", NULL)                                                 \
  FIELD (SUPPORTS_TEXT, "supports_text", NULL)                                           \
  FIELD (TIES_TEXT, "ties_text", NULL)                                                   \
  FIELD (GROUND_TEXT, "ground_text", NULL)                                               \
  FIELD (MATERIALS_HINT, "materials_hint", NULL) /* what the method ignores of them */   \
  FIELD (LOADS_HINT, "loads_hint", NULL)                                                 \
  FIELD (SUPPORTS_HINT, "supports_hint", NULL)                                           \
  FIELD (TIES_HINT, "ties_hint", NULL)                                                   \
  FIELD (GROUND_HINT, "ground_hint", NULL)                                               \
  FIELD (METHOD, "method", NULL) /* cards */                                             \
  FIELD (MATERIALS, "materials", NULL)                                                   \
  FIELD (LOADS, "loads_card", NULL)                                                      \
  FIELD (SUPPORTS, "supports_card", NULL)                                                \
  FIELD (TIES, "ties_card", NULL)                                                        \
  FIELD (GROUND, "ground", NULL)
QN_FORM_FIELDS;

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

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return model;
}

/* What the method ignores of what a card is about; NULL: nothing. */
static const char *
ignored_text (const QnModel *model, guint field)
{
  const QnAnalysisSettings *a = &model->analysis;
  const gboolean limit = a->procedure == QN_PROCEDURE_LIMIT;
  const gboolean timed = a->procedure == QN_PROCEDURE_DYNAMIC;
  switch (field) {
  case MATERIALS_HINT:
    return !limit ? NULL
           : a->flow == QN_FLOW_ASSOCIATIVE
             ? _ ("Limit analysis knows rigid blocks, strengths that last and joints "
                  "that dilate by their friction: what is grey plays no part.")
             : _ ("Limit analysis knows rigid blocks and strengths that last: what is "
                  "grey plays no part.");
  case LOADS_HINT:
    return timed ? _ ("In time the constant loads act alone: growing ones are not "
                      "applied.")
                 : NULL;
  case SUPPORTS_HINT:
    return limit   ? _ ("Limit analysis covers growing loads, not growing settlements.")
           : timed ? _ ("In time growing settlements are not applied.")
           : a->procedure == QN_PROCEDURE_WORK
             ? _ ("Work control needs growing loads: settlements do no work.")
             : NULL;
  case TIES_HINT:
    return limit ? _ ("Limit analysis knows what a tie can carry: what is grey plays no "
                      "part.")
                 : NULL;
  default:
    return timed ? NULL
                 : _ ("The method follows no time: choose In time (earthquakes) under "
                      "Method, and the ground moves as is entered here.");
  }
}

/* What a card holds. */
static char *
dup_card_text (const QnModel *model, guint field)
{
  gsize loads[2];
  guint fixed = 0, settle = 0;
  switch (field) {
  case METHOD_TEXT:
    return model->stage_count > 0
             ? g_strdup (_ ("in stages"))
             : g_strdup (_ (procedures[procedure_row (&model->analysis)].label));
  case MATERIALS_TEXT:
    return model->law_count == 1 ? g_strdup (model->laws[0].name)
                                 : g_strdup_printf (ngettext ("%zu law", "%zu laws",
                                                              (gulong) model->law_count),
                                                    model->law_count);
  case LOADS_TEXT:
    qn_model_loads (model, 0, &loads[0]);
    qn_model_loads (model, 1, &loads[1]);
    return g_strdup_printf (_ ("%zu constant, %zu growing"), loads[0], loads[1]);
  case SUPPORTS_TEXT:
    for (gsize i = 0; i < model->block_count; i++)
      fixed += qn_support_is_any (model->blocks[i].support);
    for (gsize i = 0; i < model->node_count; i++)
      fixed += qn_support_is_any (model->nodes[i].support);
    for (gsize i = 0; i < qn_model_load_count (model); i++)
      settle += qn_model_load (model, i)->kind == QN_LOAD_SETTLEMENT;
    return g_strdup_printf (
      ngettext ("%u fixed, %u settlement", "%u fixed, %u settlements", settle), fixed,
      settle);
  case TIES_TEXT:
    return model->tie_count + model->bar_count > 0
             ? g_strdup_printf ("%zu", model->tie_count + model->bar_count)
             : g_strdup (_ ("none"));
  default:
    return model->analysis.procedure != QN_PROCEDURE_DYNAMIC
             ? g_strdup (_ ("not used by the method"))
             : g_strdup_printf ("%zu", model->ground_count);
  }
}

/* What the method ignores is grey; why stands under its name. */
static char *
dup_explanation (const QnAnalysisSettings *a)
{
  const char *own = _ (procedures[procedure_row (a)].explanation);
  const char *ignored =
    a->procedure == QN_PROCEDURE_LIMIT
      ? _ ("It follows no path: what is grey plays no part.")
    : a->procedure == QN_PROCEDURE_DYNAMIC
      ? _ ("It follows time, not the load: what is grey plays no part.")
      : NULL;
  return ignored != NULL ? g_strdup_printf ("%s %s", own, ignored) : g_strdup (own);
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  QnAnalysisSettings a = model->analysis;
  gboolean timed = a.procedure == QN_PROCEDURE_DYNAMIC, staged = model->stage_count > 0;
  gboolean path = a.procedure != QN_PROCEDURE_LIMIT && !timed;
  gboolean controlled =
    a.procedure == QN_PROCEDURE_DISPLACEMENT || (path && a.control.block != QN_NONE);
  QnVec2 load;
  switch (field) {
  case TITLE:
    return TRUE;
  case GRAVITY:
    return qn_model_has_density (model);
  case PROCEDURE:
    for (guint i = 0; i < G_N_ELEMENTS (procedures); i++)
      qn_value_add_row (value, _ (procedures[i].label));
    value->number = procedure_row (&a);
    return !staged;
  case EXPLANATION:
    value->text = dup_explanation (&a);
    return !staged;
  case STAGES:
    value->text = g_strdup (_ ("Loaded in stages: each has its own procedure, increments "
                               "and end; the rest holds for all of them."));
    return staged;
  case GEOMETRY:
  case RESIDUAL_TOLERANCE:
    value->disabled = !path && !timed;
    return TRUE;
  case FOLLOW:
    value->disabled = !path || a.geometry != QN_GEOMETRY_NONLINEAR;
    return TRUE;
  case SNAP:
  case INCREMENTS:
  case MULTIPLIER_TOLERANCE:
    value->disabled = !path;
    return TRUE;
  case MAX_MULTIPLIER:
    value->disabled = !path || staged;
    return TRUE;
  case CONTROL_BLOCK:
    qn_value_add_row (value, C_ ("block", "None"));
    for (gsize i = 0; i < model->block_count; i++)
      qn_value_add_row (value, model->blocks[i].name);
    value->number = a.control.block + 1;
    value->disabled = !path;
    return TRUE;
  case COMPONENT:
    return controlled;
  case TARGET:
    g_object_set (form->widgets[TARGET], "quantity",
                  a.control.dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH,
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
    if (field < METHOD_TEXT)
      return qn_value_set_pairs (value, model, &model->contact.pairs, model->contact.law,
                                 (QnPairField) (field - PLACEMENT));
    if (field >= METHOD)
      return TRUE;
    value->text = field < MATERIALS_HINT ? dup_card_text (model, field)
                                         : g_strdup (ignored_text (model, field));
    return value->text != NULL;
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
      a->control.block = (QnId) i;
    }
  }
  double push = 0.0;
  for (gsize i = 0; i < model->live_load_count; i++)
    push += model->live_loads[i].vector.x;
  a->control.dof = QN_DOF_UX;
  a->control.target = qn_magnet_round_distance (
    0.01 * MAX (highest - lowest, model->characteristic_length));
  if (push < 0.0)
    a->control.target = -a->control.target;
}

static gboolean
take_contact (gpointer form, QnModel *model, guint field, const QnValue *value,
              GError **error)
{
  QnPairRule *rule = &model->contact.pairs;
  if (field == COUNT)
    rule->count = MAX (qn_value_int (value), 1);
  else if (field == PLACEMENT && (QnPlacement) value->number != QN_PLACEMENT_EXPLICIT) {
    QnValue count = { .number = qn_form_get_number (form, COUNT) };
    rule->placement = (QnPlacement) value->number;
    rule->count =
      rule->placement == QN_PLACEMENT_LOBATTO ? 0 : MAX (qn_value_int (&count), 1);
  } else {
    g_autofree char *positions = qn_form_dup_text (form, POSITIONS);
    g_autofree char *weights = qn_form_dup_text (form, WEIGHTS);
    return qn_pair_rule_parse (rule, positions, weights, error);
  }
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnAnalysisSettings *a = &model->analysis;
  guint row = (guint) MAX (value->number, 0.0);
  if (field == TITLE)
    return qn_edit_take_text (&model->title, value->text, error);
  if (field >= PLACEMENT && field != OFFSET && field != TOLERANCE)
    return take_contact (data, model, field, value, error);
  if (field >= LOAD && field < PLACEMENT) {
    const gboolean live = field >= LOAD + 2;
    const guint x = live ? LOAD + 2 : LOAD;
    const QnVec2 load =
      qn_vec2 (qn_form_get_number (data, x), qn_form_get_number (data, x + 1));
    return qn_edit_set_weight_load (model, live, load, error);
  }
  switch (field) {
  case PROCEDURE:
    if (procedures[row].procedure == QN_PROCEDURE_DYNAMIC)
      return qn_edit_choose_dynamic (model, error);
    a->procedure = procedures[row].procedure;
    if (a->procedure == QN_PROCEDURE_LIMIT)
      a->flow = procedures[row].flow;
    break;
  case CONTROL_BLOCK:
    a->control.block = row == 0 || row > model->block_count ? QN_NONE : (QnId) row - 1;
    if (a->control.block != QN_NONE) /* in place of a node of beams */
      a->control.node = QN_NONE;
    break;
  }
  if (a->procedure == QN_PROCEDURE_DISPLACEMENT && !qn_control_is_given (&a->control))
    choose_control (model);
  return TRUE;
}

GtkWidget *
qn_analysis_panel_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("analysis-panel", QnForm, .subject = subject);
  static const struct {
    const QnFormKind *part;
    guint card;
    gboolean first; /* before what the card has by itself */
  } parts[] = {
    { &qn_stage_form, METHOD, FALSE },    { &qn_law_form, MATERIALS, TRUE },
    { &qn_load_form, LOADS, TRUE },       { &qn_case_form, LOADS, FALSE },
    { &qn_support_form, SUPPORTS, TRUE }, { &qn_settlement_form, SUPPORTS, FALSE },
    { &qn_bar_form, TIES, FALSE },        { &qn_tie_form, TIES, FALSE },
    { &qn_dynamic_form, GROUND, TRUE },
  };
  QnForm *form = qn_form_new (&kind, canvas);
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++) {
    QnForm *part = qn_form_new (parts[i].part, canvas);
    part->card = GTK_EXPANDER (form->widgets[parts[i].card]);
    GtkBox *box = GTK_BOX (gtk_expander_get_child (part->card));
    (parts[i].first ? gtk_box_prepend : gtk_box_append) (box, qn_form_show (part));
  }
  for (guint hint = MATERIALS_HINT; hint <= GROUND_HINT; hint++)
    gtk_box_reorder_child_after (GTK_BOX (gtk_widget_get_parent (form->widgets[hint])),
                                 form->widgets[hint], NULL);
  return qn_form_show (form);
}
