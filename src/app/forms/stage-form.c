/* Stages of loading: their order, and what the selected one drives, how, and how far. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *list, *fields, *name, *sets, *take, *up, *down, *remove;
  GtkLabel *empty, *control;
  GtkDropDown *procedure, *end, *component;
  QnQuantityEntry *target, *length, *angle, *increments;
  int selected; /* stage, or -1 */
} Form;

static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                          QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };

/* ---- changes ---- */

typedef enum { ADD, REMOVE, MOVE, CHANGE, RENAME } What;

typedef struct Change {
  What what;
  QnStage settings;
  int by;
  const char *name;
  gsize stage;
} Change;

static gboolean
edit (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  switch (c->what) {
  case ADD:
    return qn_edit_add_stage (model, error);
  case REMOVE:
    return qn_edit_delete_stage (model, c->stage, error);
  case MOVE:
    return qn_edit_move_stage (model, c->stage, c->by, error);
  case CHANGE:
    return qn_edit_change_stage (model, c->stage, &c->settings, error);
  case RENAME:
    return qn_edit_rename_stage (model, c->stage, c->name, error);
  }
  g_return_val_if_reached (FALSE);
}

static void update (Form *form);
static void update_selected (Form *form);

static gboolean
apply (Form *form, const char *name, Change change)
{
  change.stage = (gsize) MAX (form->selected, 0);
  gboolean done = qn_canvas_edit (form->canvas, name, NULL, edit, &change);
  if (!done)
    update (form);
  return done;
}

static void
on_add (Form *form)
{
  if (apply (form, _ ("Add Stage"), (Change){ .what = ADD })) {
    form->selected = (int) qn_canvas_get_model (form->canvas)->stage_count - 1;
    update (form);
  }
}

static void
on_remove (Form *form)
{
  if (form->selected >= 0)
    apply (form, _ ("Remove Stage"), (Change){ .what = REMOVE });
}

static void
move (Form *form, int by)
{
  if (form->selected >= 0
      && apply (form, _ ("Move Stage"), (Change){ .what = MOVE, .by = by })) {
    form->selected += by;
    update (form);
  }
}

static void
on_up (Form *form)
{
  move (form, -1);
}

static void
on_down (Form *form)
{
  move (form, 1);
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  if (form->selected >= 0)
    apply (form, _ ("Rename Stage"), (Change){ .what = RENAME, .name = name });
}

static void
on_stage (GtkListBox *list, GtkListBoxRow *row, Form *form)
{
  (void) list;
  form->selected = row != NULL ? gtk_list_box_row_get_index (row) : -1;
  update_selected (form);
}

/* The selected block, or the second end of the selected beam where it stands free. */
static gboolean
take_control (Form *form, QnStage *stage)
{
  QnSelection *selection = qn_canvas_get_selection (form->canvas);
  guint blocks = 0, beams = 0;
  const QnId *ids = qn_selection_get_blocks (selection, &blocks);
  const QnId *beam = qn_selection_get_beams (selection, &beams);
  if (blocks > 0) {
    stage->control_block = ids[0];
    stage->control_node = QN_NONE;
    return TRUE;
  }
  if (beams > 0) {
    stage->control_node = qn_canvas_get_model (form->canvas)->beams[beam[0]].nodes[1];
    stage->control_block = QN_NONE;
    return TRUE;
  }
  qn_canvas_tell (form->canvas,
                  _ ("Select the block or the beam whose displacement ends the stage"));
  return FALSE;
}

/* Where nothing is said yet: the load doubles, or the block moves a little. */
static void
fill_in (const Form *form, QnStage *stage)
{
  if (stage->has_target && stage->target == 0.0 && form->selected == 0)
    stage->target = 1.0;
  if (qn_stage_get_end (stage) == QN_STAGE_END_DISPLACEMENT
      && stage->control_target == 0.0)
    stage->control_target = qn_magnet_round_distance (
      0.05 * qn_canvas_get_model (form->canvas)->characteristic_length);
}

static uint32_t
checked_sets (const Form *form)
{
  uint32_t sets = 0;
  int bit = 0;
  for (GtkWidget *check = gtk_widget_get_first_child (form->sets); check != NULL;
       check = gtk_widget_get_next_sibling (check), bit++)
    if (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)))
      sets |= UINT32_C (1) << bit;
  return sets;
}

/* Takes every field into the selected stage. */
static void
change_stage (Form *form, gboolean take)
{
  if (form->selected < 0)
    return;
  Change change = { .what = CHANGE,
                    .settings =
                      qn_canvas_get_model (form->canvas)->stages[form->selected] };
  QnStage *stage = &change.settings;
  QnStageEnd end = (QnStageEnd) gtk_drop_down_get_selected (form->end);
  stage->sets = checked_sets (form);
  stage->procedure = procedures[gtk_drop_down_get_selected (form->procedure)];
  if (stage->procedure == QN_PROCEDURE_DISPLACEMENT)
    end = QN_STAGE_END_DISPLACEMENT;
  stage->increments = (int32_t) qn_to_integer (
    qn_quantity_entry_get_value (form->increments), 0, G_MAXINT32);
  stage->has_target = end == QN_STAGE_END_MULTIPLIER;
  stage->target = stage->has_target ? qn_quantity_entry_get_value (form->target) : 0.0;
  gboolean controlled = stage->control_block != QN_NONE || stage->control_node != QN_NONE;
  if (end != QN_STAGE_END_DISPLACEMENT)
    stage->control_block = stage->control_node = QN_NONE;
  else if ((take || !controlled) && !take_control (form, stage)) {
    update (form);
    return;
  }
  if (end == QN_STAGE_END_DISPLACEMENT) {
    stage->control_dof = (QnDof) gtk_drop_down_get_selected (form->component);
    gboolean turn = stage->control_dof == QN_DOF_RZ;
    stage->control_target =
      qn_quantity_entry_get_value (turn ? form->angle : form->length);
  }
  fill_in (form, stage);
  apply (form, _ ("Change Stage"), change);
}

static void
on_field (gpointer widget, Form *form)
{
  (void) widget;
  change_stage (form, FALSE);
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  change_stage (form, FALSE);
}

static void
on_take (Form *form)
{
  change_stage (form, TRUE);
}

/* ---- what is shown ---- */

static void
fill_list (Form *form, const QnModel *model)
{
  g_autoptr (GStrvBuilder) lines = g_strv_builder_new ();
  for (gsize i = 0; i < model->stage_count; i++) {
    g_autofree char *text = qn_stage_dup_text (model, i, qn_settings_get_units ());
    g_strv_builder_add (lines, text);
  }
  g_auto (GStrv) strings = g_strv_builder_end (lines);
  qn_form_fill_list (form->list, (const char *const *) strings, form->selected, form);
  gtk_widget_set_visible (GTK_WIDGET (form->empty), model->stage_count == 0);
}

static GtkWidget *
nth_check (const Form *form, int32_t set)
{
  GtkWidget *check = gtk_widget_get_first_child (form->sets);
  for (int32_t i = 0; i < set && check != NULL; i++)
    check = gtk_widget_get_next_sibling (check);
  return check;
}

/* A check for every set. Those that are there stay: one of them may be telling of its change. */
static void
fill_sets (Form *form, const QnModel *model, const QnStage *stage)
{
  int32_t count = (int32_t) model->load_set_count + 1;
  GtkWidget *check;
  while ((check = nth_check (form, count)) != NULL)
    gtk_box_remove (GTK_BOX (form->sets), check);
  for (int32_t set = 0; set < count; set++) {
    check = nth_check (form, set);
    if (check == NULL) {
      check = gtk_check_button_new ();
      g_signal_connect (check, "toggled", G_CALLBACK (on_field), form);
      gtk_box_append (GTK_BOX (form->sets), check);
    }
    gtk_check_button_set_label (GTK_CHECK_BUTTON (check),
                                set == 0 ? _ ("Growing loads")
                                         : qn_model_load_set_name (model, set));
    qn_form_set_check (check, stage->sets >> set & 1, form);
  }
}

static void
show_control (Form *form, const QnModel *model, const QnStage *stage)
{
  gboolean controlled = qn_stage_get_end (stage) == QN_STAGE_END_DISPLACEMENT;
  gboolean turned = stage->control_dof == QN_DOF_RZ;
  g_autofree char *text =
    !controlled ? g_strdup ("")
    : stage->control_block != QN_NONE
      ? g_strdup_printf (_ ("Followed: block %s"),
                         model->blocks[stage->control_block].name)
      : g_strdup_printf (_ ("Followed: node %s"), model->nodes[stage->control_node].name);
  gtk_label_set_text (form->control, text);
  gtk_widget_set_visible (GTK_WIDGET (form->control), controlled);
  gtk_widget_set_visible (gtk_widget_get_parent (form->take), controlled);
  qn_form_set_row_visible (GTK_WIDGET (form->component), controlled);
  qn_form_set_row_visible (GTK_WIDGET (form->length), controlled && !turned);
  qn_form_set_row_visible (GTK_WIDGET (form->angle), controlled && turned);
  qn_form_set_choice (form->component, (guint) stage->control_dof, form);
  qn_quantity_entry_set_value (form->length, stage->control_target);
  qn_quantity_entry_set_value (form->angle, stage->control_target);
}

static void
show_stage (Form *form, const QnModel *model, const QnStage *stage)
{
  gtk_editable_set_text (GTK_EDITABLE (form->name),
                         stage->name != NULL ? stage->name : "");
  fill_sets (form, model, stage);
  guint row = 0;
  for (guint i = 0; i < G_N_ELEMENTS (procedures); i++)
    if (procedures[i] == stage->procedure)
      row = i;
  qn_form_set_choice (form->procedure, row, form);
  qn_form_set_choice (form->end, (guint) qn_stage_get_end (stage), form);
  qn_form_set_row_visible (GTK_WIDGET (form->target), stage->has_target);
  qn_quantity_entry_set_value (form->target, stage->target);
  qn_quantity_entry_set_value (form->increments, stage->increments);
  show_control (form, model, stage);
}

static void
update_selected (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  gboolean any = form->selected >= 0;
  gtk_widget_set_visible (form->fields, any);
  gtk_widget_set_sensitive (form->up, form->selected > 0);
  gtk_widget_set_sensitive (form->down,
                            any && form->selected + 1 < (int) model->stage_count);
  gtk_widget_set_sensitive (form->remove, any);
  if (any)
    show_stage (form, model, &model->stages[form->selected]);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  if (form->selected >= (int) model->stage_count)
    form->selected = (int) model->stage_count - 1;
  fill_list (form, model);
  update_selected (form);
}

/* ---- building ---- */

static void
build_fields (Form *form, GtkWidget *grid)
{
  const char *const methods[] = { _ ("Load control"), _ ("Displacement control"),
                                  _ ("Work control"), _ ("Arc length"), NULL };
  const char *const ends[] = { _ ("At collapse"), _ ("At a multiplier"),
                               _ ("At a displacement"), NULL };
  const char *const components[] = { "ux", "uy", "rz", NULL };
  GCallback field = G_CALLBACK (on_field), choice = G_CALLBACK (on_choice);
  form->name = qn_form_add_entry (grid, _ ("_Name"), 10, G_CALLBACK (on_name), form);
  form->sets = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  qn_form_add_row (grid, _ ("Drives"), form->sets);
  form->procedure = qn_form_add_choice (grid, _ ("_Procedure"), methods, choice, form);
  form->end = qn_form_add_choice (grid, _ ("E_nds"), ends, choice, form);
  form->target = qn_form_add_quantity (grid, _ ("_Multiplier"), QN_QUANTITY_NUMBER, -1e9,
                                       1e9, field, form);
  form->component = qn_form_add_choice (grid, _ ("C_omponent"), components, choice, form);
  form->length = qn_form_add_quantity (grid, _ ("T_arget"), QN_QUANTITY_LENGTH, -1e6, 1e6,
                                       field, form);
  form->angle = qn_form_add_quantity (grid, _ ("T_arget"), QN_QUANTITY_ANGLE, -10.0, 10.0,
                                      field, form);
  form->control = qn_form_add_text (grid);
  form->take = qn_form_add_button (
    qn_form_add_buttons (grid), _ ("_Follow What Is Selected"),
    _ ("The selected block, or the second end of the selected beam, ends the stage"),
    G_CALLBACK (on_take), form);
  form->increments = qn_form_add_quantity (grid, _ ("_Increments (0: as above)"),
                                           QN_QUANTITY_NUMBER, 0.0, 1e6, field, form);
}

static void
build_buttons (Form *form, GtkWidget *grid)
{
  GtkWidget *first = qn_form_add_buttons (grid), *second = qn_form_add_buttons (grid);
  qn_form_add_button (first, _ ("_Add Stage"), _ ("Add a stage behind the last"),
                      G_CALLBACK (on_add), form);
  form->remove =
    qn_form_add_button (first, _ ("Remo_ve Stage"), _ ("Remove the selected stage"),
                        G_CALLBACK (on_remove), form);
  form->up = qn_form_add_button (second, _ ("_Earlier"), _ ("Swap with the stage before"),
                                 G_CALLBACK (on_up), form);
  form->down = qn_form_add_button (second, _ ("_Later"), _ ("Swap with the next stage"),
                                   G_CALLBACK (on_down), form);
}

GtkWidget *
qn_stage_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  *form = (Form){ .canvas = canvas, .selected = -1 };
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  GtkWidget *grid = qn_form_new ();
  form->fields = qn_form_new ();
  form->empty = qn_form_add_text (grid);
  gtk_label_set_text (form->empty,
                      _ ("The live loads grow together. With stages, loads and "
                         "settlements are applied, held and taken away in turn."));
  gtk_widget_add_css_class (GTK_WIDGET (form->empty), "dim-label");
  form->list = qn_form_add_list (grid, _ ("Stages"), G_CALLBACK (on_stage), form);
  build_buttons (form, grid);
  build_fields (form, form->fields);
  gtk_box_append (GTK_BOX (box), grid);
  gtk_box_append (GTK_BOX (box), form->fields);
  GtkWidget *expander = gtk_expander_new_with_mnemonic (_ ("Loading in _Stages"));
  gtk_expander_set_child (GTK_EXPANDER (expander), box);
  gtk_widget_set_margin_start (expander, 12);
  gtk_widget_set_margin_end (expander, 12);
  qn_own (expander, form);
  qn_watch (expander, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update),
            form);
  update (form);
  return expander;
}
