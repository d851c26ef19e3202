#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "core/base/integer.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>
#include <math.h>

typedef struct Panel {
  QnCanvas *canvas;
  GtkDropDown *procedure, *geometry, *snap, *component, *placement, *control_block;
  QnQuantityEntry *increments, *max_multiplier, *multiplier_tolerance,
    *residual_tolerance;
  QnQuantityEntry *target, *target_angle; /* by what is controlled, one of them shown */
  GtkLabel *stages, *explanation;
  QnQuantityEntry *dead_x, *dead_y, *live_x, *live_y;
  QnQuantityEntry *offset, *count, *tolerance;
  GtkEntry *positions, *weights;
} Panel;

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
};

static void update (Panel *panel);

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
take_placement (const Panel *panel, QnPairRule *rule, GError **error)
{
  QnPlacement placement = (QnPlacement) gtk_drop_down_get_selected (panel->placement);
  rule->offset = qn_quantity_entry_get_value (panel->offset);
  if (placement != QN_PLACEMENT_EXPLICIT) {
    rule->count =
      (int32_t) qn_to_integer (qn_quantity_entry_get_value (panel->count), 1, G_MAXINT32);
    rule->placement = placement;
    return TRUE;
  }
  return qn_pair_rule_parse (
    rule, gtk_editable_get_text (GTK_EDITABLE (panel->positions)),
    gtk_editable_get_text (GTK_EDITABLE (panel->weights)), error);
}

/* Takes every field into the settings of the model. */
static gboolean
edit_settings (QnModel *model, gpointer data, GError **error)
{
  const Panel *panel = data;
  QnAnalysisSettings *a = &model->analysis;
  guint row = gtk_drop_down_get_selected (panel->procedure);
  a->procedure = procedures[row].procedure;
  if (a->procedure == QN_PROCEDURE_LIMIT)
    a->flow = procedures[row].flow;
  a->geometry = gtk_drop_down_get_selected (panel->geometry) == 1 ? QN_GEOMETRY_NONLINEAR
                                                                  : QN_GEOMETRY_LINEAR;
  a->snap = gtk_drop_down_get_selected (panel->snap) == 1 ? QN_SNAP_THROUGH_STOP
                                                          : QN_SNAP_THROUGH_JUMP;
  a->increments = (int32_t) qn_to_integer (
    qn_quantity_entry_get_value (panel->increments), 0, G_MAXINT32);
  a->max_multiplier = qn_quantity_entry_get_value (panel->max_multiplier);
  a->multiplier_tolerance = qn_quantity_entry_get_value (panel->multiplier_tolerance);
  a->residual_tolerance = qn_quantity_entry_get_value (panel->residual_tolerance);
  guint block = gtk_drop_down_get_selected (panel->control_block);
  a->control_block =
    block == 0 || block > model->block_count ? QN_NONE : (QnId) block - 1;
  if (a->control_block != QN_NONE) /* in place of a node of beams */
    a->control_node = QN_NONE;
  a->control_dof = (QnDof) gtk_drop_down_get_selected (panel->component);
  a->control_target = qn_quantity_entry_get_value (
    a->control_dof == QN_DOF_RZ ? panel->target_angle : panel->target);
  if (a->procedure == QN_PROCEDURE_DISPLACEMENT && a->control_block == QN_NONE
      && a->control_node == QN_NONE)
    choose_control (model);
  model->contact.tolerance = qn_quantity_entry_get_value (panel->tolerance);
  return take_placement (panel, &model->contact.pairs, error);
}

static void
apply_settings (Panel *panel)
{
  if (!qn_canvas_edit (panel->canvas, _ ("Change Analysis"), NULL, edit_settings, panel))
    update (panel);
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  (void) choice;
  (void) pspec;
  apply_settings (panel);
}

static void
on_quantity (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  apply_settings (panel);
}

static gboolean
edit_loads (QnModel *model, gpointer data, GError **error)
{
  const Panel *panel = data;
  QnVec2 dead = qn_vec2 (qn_quantity_entry_get_value (panel->dead_x),
                         qn_quantity_entry_get_value (panel->dead_y));
  QnVec2 live = qn_vec2 (qn_quantity_entry_get_value (panel->live_x),
                         qn_quantity_entry_get_value (panel->live_y));
  return qn_edit_set_weight_load (model, FALSE, dead, error)
         && qn_edit_set_weight_load (model, TRUE, live, error);
}

static void
on_load (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  if (!qn_canvas_edit (panel->canvas, _ ("Change Loads"), NULL, edit_loads, panel))
    update (panel);
}

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

static void
fill_blocks (Panel *panel, const QnModel *model)
{
  g_autofree const char **names = g_new0 (const char *, model->block_count + 2);
  names[0] = _ ("None");
  for (gsize i = 0; i < model->block_count; i++)
    names[i + 1] = model->blocks[i].name;
  qn_form_fill_choice (panel->control_block, names,
                       (guint) (model->analysis.control_block + 1), panel);
}

/* Without positions yet those of the ends stand there to start from. */
static void
show_positions (Panel *panel, const QnPairRule *rule)
{
  g_autofree char *positions = qn_pair_rule_dup_positions (rule);
  g_autofree char *weights = qn_pair_rule_dup_weights (rule);
  gtk_editable_set_text (GTK_EDITABLE (panel->positions), positions);
  gtk_editable_set_text (GTK_EDITABLE (panel->weights), weights);
}

static void
update_visibility (Panel *panel, const QnModel *model)
{
  QnProcedure procedure = model->analysis.procedure;
  gboolean path = procedure != QN_PROCEDURE_LIMIT;
  gboolean controlled = procedure == QN_PROCEDURE_DISPLACEMENT
                        || (path && model->analysis.control_block != QN_NONE);
  gboolean turned = model->analysis.control_dof == QN_DOF_RZ;
  QnPlacement placement = model->contact.pairs.placement;
  gboolean counted = placement == QN_PLACEMENT_UNIFORM || placement == QN_PLACEMENT_GAUSS;
  gboolean listed = placement == QN_PLACEMENT_EXPLICIT;
  const struct {
    gpointer field;
    gboolean visible;
  } rows[] = { { panel->geometry, path },
               { panel->snap, path },
               { panel->increments, path },
               { panel->max_multiplier, path && model->stage_count == 0 },
               { panel->procedure, model->stage_count == 0 },
               { panel->multiplier_tolerance, path },
               { panel->residual_tolerance, path },
               { panel->control_block, path },
               { panel->component, controlled },
               { panel->target, controlled && !turned },
               { panel->target_angle, controlled && turned },
               { panel->offset, placement == QN_PLACEMENT_ENDS },
               { panel->count, counted },
               { panel->positions, listed },
               { panel->weights, listed } };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++)
    qn_form_set_row_visible (rows[i].field, rows[i].visible);
}

/* Stages have procedures and ends of their own. */
static void
update_stages (Panel *panel, const QnModel *model)
{
  gtk_label_set_text (panel->stages,
                      _ ("Loaded in stages: each has its own procedure, increments and "
                         "end; the rest holds for all of them."));
  gtk_widget_set_visible (GTK_WIDGET (panel->stages), model->stage_count > 0);
  gtk_widget_set_visible (GTK_WIDGET (panel->explanation), model->stage_count == 0);
}

static void
update (Panel *panel)
{
  const QnModel *model = qn_canvas_get_model (panel->canvas);
  const QnAnalysisSettings *a = &model->analysis;
  qn_form_set_choice (panel->procedure, procedure_row (a), panel);
  qn_form_set_choice (panel->geometry, a->geometry == QN_GEOMETRY_NONLINEAR, panel);
  qn_form_set_choice (panel->snap, a->snap == QN_SNAP_THROUGH_STOP, panel);
  qn_form_set_choice (panel->component, (guint) a->control_dof, panel);
  qn_form_set_choice (panel->placement, (guint) model->contact.pairs.placement, panel);
  gtk_label_set_text (panel->explanation, _ (procedures[procedure_row (a)].explanation));
  update_stages (panel, model);
  fill_blocks (panel, model);
  qn_quantity_entry_set_value (panel->increments, a->increments);
  qn_quantity_entry_set_value (panel->max_multiplier, a->max_multiplier);
  qn_quantity_entry_set_value (panel->multiplier_tolerance, a->multiplier_tolerance);
  qn_quantity_entry_set_value (panel->residual_tolerance, a->residual_tolerance);
  gboolean turned = a->control_dof == QN_DOF_RZ;
  qn_quantity_entry_set_value (turned ? panel->target_angle : panel->target,
                               a->control_target);
  qn_quantity_entry_set_value (panel->offset, model->contact.pairs.offset);
  qn_quantity_entry_set_value (panel->count, MAX (1, model->contact.pairs.count));
  show_positions (panel, &model->contact.pairs);
  qn_quantity_entry_set_value (panel->tolerance, model->contact.tolerance);

  QnVec2 dead = weight_load (model->dead_loads, model->dead_load_count);
  QnVec2 live = weight_load (model->live_loads, model->live_load_count);
  qn_quantity_entry_set_value (panel->dead_x, dead.x);
  qn_quantity_entry_set_value (panel->dead_y, dead.y);
  qn_quantity_entry_set_value (panel->live_x, live.x);
  qn_quantity_entry_set_value (panel->live_y, live.y);
  update_visibility (panel, model);
}

/* ---- building ---- */

static void
build_procedure (Panel *panel, GtkWidget *form)
{
  const char *labels[G_N_ELEMENTS (procedures) + 1] = { NULL };
  for (gsize i = 0; i < G_N_ELEMENTS (procedures); i++)
    labels[i] = _ (procedures[i].label);
  const char *const geometries[] = { _ ("Linear"), _ ("Nonlinear"), NULL };
  const char *const snaps[] = { _ ("Jump beyond"), _ ("Stop"), NULL };
  const char *const components[] = { "ux", "uy", "rz", NULL };
  const char *const none[] = { NULL };
  GCallback choice = G_CALLBACK (on_choice), quantity = G_CALLBACK (on_quantity);

  qn_form_add_heading (form, _ ("Procedure"));
  panel->procedure = qn_form_add_choice (form, _ ("_Procedure"), labels, choice, panel);
  panel->explanation = qn_form_add_text (form);
  panel->stages = qn_form_add_text (form);
  gtk_widget_add_css_class (GTK_WIDGET (panel->explanation), "dim-label");
  panel->geometry = qn_form_add_choice (form, _ ("_Geometry"), geometries, choice, panel);
  panel->snap = qn_form_add_choice (form, _ ("_Limit points"), snaps, choice, panel);
  panel->increments = qn_form_add_quantity (form, _ ("_Increments"), QN_QUANTITY_NUMBER,
                                            1.0, 1e6, quantity, panel);
  panel->max_multiplier = qn_form_add_quantity (
    form, _ ("_Multiplier up to"), QN_QUANTITY_NUMBER, 0.0, INFINITY, quantity, panel);
  panel->multiplier_tolerance =
    qn_form_add_quantity (form, _ ("_Tolerance of the multiplier"), QN_QUANTITY_NUMBER,
                          1e-12, 0.1, quantity, panel);
  panel->residual_tolerance =
    qn_form_add_quantity (form, _ ("Tolerance of the _balance"), QN_QUANTITY_NUMBER,
                          1e-15, 0.1, quantity, panel);
  panel->control_block =
    qn_form_add_choice (form, _ ("_Block followed"), none, choice, panel);
  panel->component =
    qn_form_add_choice (form, _ ("C_omponent"), components, choice, panel);
  panel->target = qn_form_add_quantity (form, _ ("T_arget"), QN_QUANTITY_LENGTH, -1e6,
                                        1e6, quantity, panel);
  panel->target_angle = qn_form_add_quantity (form, _ ("T_arget"), QN_QUANTITY_ANGLE,
                                              -10.0, 10.0, quantity, panel);
}

static void
build_loads (Panel *panel, GtkWidget *form)
{
  GCallback load = G_CALLBACK (on_load);
  qn_form_add_heading (form, _ ("Loads, in Block Weights"));
  panel->dead_x = qn_form_add_quantity (form, _ ("Constant, horizontal"),
                                        QN_QUANTITY_NUMBER, -1e6, 1e6, load, panel);
  panel->dead_y = qn_form_add_quantity (form, _ ("Constant, vertical"),
                                        QN_QUANTITY_NUMBER, -1e6, 1e6, load, panel);
  panel->live_x = qn_form_add_quantity (form, _ ("Growing, horizontal"),
                                        QN_QUANTITY_NUMBER, -1e6, 1e6, load, panel);
  panel->live_y = qn_form_add_quantity (form, _ ("Growing, vertical"), QN_QUANTITY_NUMBER,
                                        -1e6, 1e6, load, panel);
}

static GtkEntry *
add_list (Panel *panel, GtkWidget *form, const char *label)
{
  GtkWidget *entry = gtk_entry_new ();
  gtk_editable_set_width_chars (GTK_EDITABLE (entry), 9);
  gtk_entry_set_placeholder_text (GTK_ENTRY (entry), _ ("0.1; 0.5; 0.9"));
  g_signal_connect_swapped (entry, "activate", G_CALLBACK (apply_settings), panel);
  qn_form_add_row (form, label, entry);
  return GTK_ENTRY (entry);
}

static void
build_contacts (Panel *panel, GtkWidget *form)
{
  const char *const placements[] = { _ ("At the ends"), _ ("Uniform"), _ ("Gauss points"),
                                     _ ("At given places"), NULL };
  GCallback quantity = G_CALLBACK (on_quantity);
  qn_form_add_heading (form, _ ("Contacts"));
  panel->placement = qn_form_add_choice (form, _ ("Contact pai_rs"), placements,
                                         G_CALLBACK (on_choice), panel);
  panel->offset = qn_form_add_quantity (form, _ ("O_ffset from corners"),
                                        QN_QUANTITY_LENGTH, 0.0, 1e3, quantity, panel);
  panel->count = qn_form_add_quantity (form, _ ("_Number per face"), QN_QUANTITY_NUMBER,
                                       1.0, QN_MAX_PAIRS_PER_FACE, quantity, panel);
  panel->positions = add_list (panel, form, _ ("Places (0 to 1)"));
  panel->weights = add_list (panel, form, _ ("Weights (empty: equal)"));
  panel->tolerance = qn_form_add_quantity (form, _ ("Relati_ve tolerance"),
                                           QN_QUANTITY_NUMBER, 0.0, 0.1, quantity, panel);
}

GtkWidget *
qn_analysis_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  panel->canvas = canvas;
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  GtkWidget *form = qn_form_new ();
  GtkWidget *contacts = qn_form_new ();
  build_procedure (panel, form);
  build_loads (panel, form);
  build_contacts (panel, contacts);
  gtk_box_append (GTK_BOX (box), form);
  gtk_box_append (GTK_BOX (box), qn_load_form_new (canvas));
  gtk_box_append (GTK_BOX (box), qn_stage_form_new (canvas));
  gtk_box_append (GTK_BOX (box), contacts);
  gtk_box_append (GTK_BOX (box), qn_law_form_new (canvas));
  qn_own (box, panel);
  qn_watch (box, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return box;
}
