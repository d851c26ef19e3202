/* Loads one by one: those that are constant, those that grow, and those of further sets. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"
#include <glib/gi18n.h>

/* Lines of a list; of more loads the rest is only counted. */
#define MOST_SHOWN 200

#define LARGEST 1e15 /* limit of fields */

/* Rows of the choice of list before the sets. */
enum { ROW_DEAD, ROW_LIVE, ROW_FIRST_SET };

typedef struct Form {
  QnCanvas *canvas;
  GtkDropDown *list, *component;
  GtkWidget *name, *loads, *remove_set, *remove;
  QnQuantityEntry *factor_x, *factor_y, *x, *y, *line_x, *line_y, *moment, *length,
    *angle;
  int32_t shown; /* list */
  int selected;  /* load of it, or -1 */
} Form;

static const QnLoad *
selected_load (const Form *form)
{
  return form->selected >= 0 ? qn_model_get_load (qn_canvas_get_model (form->canvas),
                                                  form->shown, (gsize) form->selected)
                             : NULL;
}

/* ---- changes ---- */

typedef enum {
  ADD_SET,
  REMOVE_SET,
  RENAME_SET,
  APPEND_LOAD,
  REPLACE_LOAD,
  REMOVE_LOAD
} What;

typedef struct Change {
  What what;
  QnLoad load;
  const char *name;
  int32_t list;
  gsize index;
} Change;

static gboolean
edit (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  switch (c->what) {
  case ADD_SET:
    return qn_edit_add_load_set (model, error);
  case REMOVE_SET:
    return qn_edit_delete_load_set (model, c->list, error);
  case RENAME_SET:
    return qn_edit_rename_load_set (model, c->list, c->name, error);
  case APPEND_LOAD:
    return qn_edit_append_load (model, c->list, c->load, error);
  case REPLACE_LOAD:
    return qn_edit_replace_load (model, c->list, c->index, c->load, error);
  case REMOVE_LOAD:
    return qn_edit_remove_load (model, c->list, c->index, error);
  }
  g_return_val_if_reached (FALSE);
}

static void update (Form *form);
static void show_fields (Form *form, const QnLoad *load);

static gboolean
apply (Form *form, const char *name, Change change)
{
  change.list = form->shown;
  change.index = (gsize) MAX (form->selected, 0);
  gboolean done = qn_canvas_edit (form->canvas, name, NULL, edit, &change);
  if (!done)
    update (form);
  return done;
}

static void
on_add_set (Form *form)
{
  if (apply (form, _ ("Add Set of Loads"), (Change){ .what = ADD_SET })) {
    form->shown = (int32_t) qn_canvas_get_model (form->canvas)->load_set_count;
    update (form);
  }
}

static void
on_remove_set (Form *form)
{
  if (form->shown > 0)
    apply (form, _ ("Remove Set of Loads"), (Change){ .what = REMOVE_SET });
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  if (form->shown > 0)
    apply (form, _ ("Rename Set of Loads"), (Change){ .what = RENAME_SET, .name = name });
}

static void
on_list (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  form->shown = (int32_t) gtk_drop_down_get_selected (choice) - ROW_LIVE;
  form->selected = -1;
  update (form);
}

static void
on_load (GtkListBox *list, GtkListBoxRow *row, Form *form)
{
  (void) list;
  form->selected = row != NULL ? gtk_list_box_row_get_index (row) : -1;
  show_fields (form, selected_load (form));
}

static void
on_remove (Form *form)
{
  if (selected_load (form) != NULL)
    apply (form, _ ("Remove Load"), (Change){ .what = REMOVE_LOAD });
}

/* Takes every field into the selected load. */
static void
on_field (gpointer widget, Form *form)
{
  (void) widget;
  const QnLoad *old = selected_load (form);
  if (old == NULL)
    return;
  Change change = { .what = REPLACE_LOAD, .load = *old };
  QnLoad *load = &change.load;
  gboolean weight = load->kind == QN_LOAD_WEIGHT, line = load->kind == QN_LOAD_LINE;
  QnQuantityEntry *x = weight ? form->factor_x : line ? form->line_x : form->x;
  QnQuantityEntry *y = weight ? form->factor_y : line ? form->line_y : form->y;
  if (load->kind == QN_LOAD_SETTLEMENT) {
    load->dof = (QnDof) gtk_drop_down_get_selected (form->component);
    gboolean turn = load->dof == QN_DOF_RZ;
    load->value = qn_quantity_entry_get_value (turn ? form->angle : form->length);
  } else
    load->vector =
      qn_vec2 (qn_quantity_entry_get_value (x), qn_quantity_entry_get_value (y));
  if (load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE)
    load->moment = qn_quantity_entry_get_value (form->moment);
  apply (form, _ ("Change Load"), change);
}

static void
on_component (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  on_field (choice, form);
}

/* ---- adding ---- */

static void
add (Form *form, QnLoad load)
{
  if (!apply (form, _ ("Add Load"), (Change){ .what = APPEND_LOAD, .load = load }))
    return;
  form->selected =
    (int) qn_model_count_loads (qn_canvas_get_model (form->canvas), form->shown) - 1;
  update (form);
}

static void
on_add_weight (Form *form)
{
  add (form, (QnLoad){ .kind = QN_LOAD_WEIGHT,
                       .vector = { form->shown == QN_DEAD_LOADS ? 0.0 : 1.0,
                                   form->shown == QN_DEAD_LOADS ? -1.0 : 0.0 },
                       .block = QN_NONE,
                       .node = QN_NONE,
                       .beam = QN_NONE });
}

/* On the first of the selected blocks, or the second end of the first of the beams. */
static void
on_add_force (Form *form)
{
  guint blocks = 0, beams = 0;
  QnSelection *selection = qn_canvas_get_selection (form->canvas);
  const QnId *ids = qn_selection_get_blocks (selection, &blocks);
  const QnId *beam = qn_selection_get_beams (selection, &beams);
  double size = qn_canvas_get_tool_settings (form->canvas)->force;
  QnLoad load = {
    .vector = { 0.0, -size }, .block = QN_NONE, .node = QN_NONE, .beam = QN_NONE
  };
  if (blocks > 0) {
    load.kind = QN_LOAD_FORCE;
    load.block = ids[0];
    add (form, load);
  } else if (beams > 0) {
    load.kind = QN_LOAD_NODE;
    load.node = qn_canvas_get_model (form->canvas)->beams[beam[0]].nodes[1];
    add (form, load);
  } else
    qn_canvas_tell (form->canvas,
                    _ ("Select the block or the beam that the force acts on"));
}

/* Down by a thousandth of the structure's width. */
static void
on_add_settlement (Form *form)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_canvas_get_selection (form->canvas), &count);
  const QnBlock *block =
    count > 0 ? &qn_canvas_get_model (form->canvas)->blocks[ids[0]] : NULL;
  int dof = QN_DOF_UY;
  while (block != NULL && dof < QN_DOF_UY + QN_DOF_COUNT
         && !block->support[dof % QN_DOF_COUNT])
    dof++;
  if (block == NULL || dof == QN_DOF_UY + QN_DOF_COUNT) {
    qn_canvas_tell (form->canvas, _ ("Select the fixed block that settles"));
    return;
  }
  double size = qn_magnet_round_distance (
    0.01 * qn_canvas_get_model (form->canvas)->characteristic_length);
  add (form, (QnLoad){ .kind = QN_LOAD_SETTLEMENT,
                       .block = ids[0],
                       .node = QN_NONE,
                       .beam = QN_NONE,
                       .dof = (QnDof) (dof % QN_DOF_COUNT),
                       .value = -size });
}

/* ---- what is shown ---- */

static void
fill_lists (Form *form, const QnModel *model)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  g_strv_builder_add (names, _ ("Constant"));
  g_strv_builder_add (names, _ ("Growing"));
  for (gsize i = 0; i < model->load_set_count; i++)
    g_strv_builder_add (names, model->load_sets[i]);
  g_auto (GStrv) strings = g_strv_builder_end (names);
  qn_form_fill_choice (form->list, (const char *const *) strings,
                       (guint) (form->shown + ROW_LIVE), form);
  gtk_editable_set_text (GTK_EDITABLE (form->name),
                         form->shown > 0 ? model->load_sets[form->shown - 1] : "");
  qn_form_set_row_visible (form->name, form->shown > 0);
  gtk_widget_set_sensitive (form->remove_set, form->shown > 0);
}

static void
fill_loads (Form *form, const QnModel *model)
{
  g_autoptr (GStrvBuilder) lines = g_strv_builder_new ();
  gsize count = qn_model_count_loads (model, form->shown);
  for (gsize i = 0; i < MIN (count, MOST_SHOWN); i++) {
    g_autofree char *line = qn_load_dup_text (
      model, qn_model_get_load (model, form->shown, i), qn_settings_get_units ());
    g_strv_builder_add (lines, line);
  }
  if (count > MOST_SHOWN) {
    g_autofree char *rest =
      g_strdup_printf (_ ("and %u more"), (guint) (count - MOST_SHOWN));
    g_strv_builder_add (lines, rest);
  }
  g_auto (GStrv) strings = g_strv_builder_end (lines);
  qn_form_fill_list (form->loads, (const char *const *) strings, form->selected, form);
}

static void
show_fields (Form *form, const QnLoad *load)
{
  QnLoadKind kind = load != NULL ? load->kind : QN_LOAD_KIND_COUNT;
  gboolean force = kind == QN_LOAD_FORCE || kind == QN_LOAD_NODE;
  gboolean settles = kind == QN_LOAD_SETTLEMENT;
  gboolean turns = settles && load->dof == QN_DOF_RZ;
  const struct {
    gpointer field;
    gboolean visible;
    double value;
  } fields[] = {
    { form->factor_x, kind == QN_LOAD_WEIGHT, load != NULL ? load->vector.x : 0.0 },
    { form->factor_y, kind == QN_LOAD_WEIGHT, load != NULL ? load->vector.y : 0.0 },
    { form->x, force, load != NULL ? load->vector.x : 0.0 },
    { form->y, force, load != NULL ? load->vector.y : 0.0 },
    { form->line_x, kind == QN_LOAD_LINE, load != NULL ? load->vector.x : 0.0 },
    { form->line_y, kind == QN_LOAD_LINE, load != NULL ? load->vector.y : 0.0 },
    { form->moment, force, load != NULL ? load->moment : 0.0 },
    { form->length, settles && !turns, load != NULL ? load->value : 0.0 },
    { form->angle, turns, load != NULL ? load->value : 0.0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (fields); i++) {
    qn_form_set_row_visible (fields[i].field, fields[i].visible);
    qn_quantity_entry_set_value (fields[i].field, fields[i].value);
  }
  qn_form_set_row_visible (GTK_WIDGET (form->component), settles);
  if (settles)
    qn_form_set_choice (form->component, (guint) load->dof, form);
  gtk_widget_set_sensitive (form->remove, load != NULL);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  if (form->shown > (int32_t) model->load_set_count)
    form->shown = 0;
  if (selected_load (form) == NULL)
    form->selected = -1;
  fill_lists (form, model);
  fill_loads (form, model);
  show_fields (form, selected_load (form));
}

/* ---- building ---- */

static void
build_fields (Form *form, GtkWidget *grid)
{
  const char *const components[] = { "ux", "uy", "rz", NULL };
  GCallback changed = G_CALLBACK (on_field);
  const struct {
    QnQuantityEntry **entry;
    const char *label;
    QnQuantity quantity;
  } fields[] = {
    { &form->factor_x, _ ("Horizontal"), QN_QUANTITY_NUMBER },
    { &form->factor_y, _ ("Vertical"), QN_QUANTITY_NUMBER },
    { &form->x, _ ("Horizontal"), QN_QUANTITY_FORCE },
    { &form->y, _ ("Vertical"), QN_QUANTITY_FORCE },
    { &form->line_x, _ ("Horizontal"), QN_QUANTITY_STIFFNESS },
    { &form->line_y, _ ("Vertical"), QN_QUANTITY_STIFFNESS },
    { &form->moment, _ ("Moment"), QN_QUANTITY_MOMENT },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (fields); i++)
    *fields[i].entry = qn_form_add_quantity (grid, fields[i].label, fields[i].quantity,
                                             -LARGEST, LARGEST, changed, form);
  form->component = qn_form_add_choice (grid, _ ("C_omponent"), components,
                                        G_CALLBACK (on_component), form);
  form->length = qn_form_add_quantity (grid, _ ("How far"), QN_QUANTITY_LENGTH, -LARGEST,
                                       LARGEST, changed, form);
  form->angle = qn_form_add_quantity (grid, _ ("How far"), QN_QUANTITY_ANGLE, -10.0, 10.0,
                                      changed, form);
}

static void
build_buttons (Form *form, GtkWidget *grid)
{
  GtkWidget *row = qn_form_add_buttons (grid);
  qn_form_add_button (row, _ ("+ _Weight"), _ ("Add a load in weights of the blocks"),
                      G_CALLBACK (on_add_weight), form);
  qn_form_add_button (row, _ ("+ _Force"),
                      _ ("Add a force on the selected block or end of a beam"),
                      G_CALLBACK (on_add_force), form);
  qn_form_add_button (row, _ ("+ S_ettlement"),
                      _ ("Add a settlement of the selected support"),
                      G_CALLBACK (on_add_settlement), form);
  form->remove =
    qn_form_add_button (qn_form_add_buttons (grid), _ ("_Remove Load"),
                        _ ("Remove the selected load"), G_CALLBACK (on_remove), form);
}

GtkWidget *
qn_load_form_new (QnCanvas *canvas)
{
  const char *const none[] = { NULL };
  Form *form = g_new0 (Form, 1);
  *form = (Form){ .canvas = canvas, .shown = QN_DEAD_LOADS, .selected = -1 };
  GtkWidget *grid = qn_form_new ();
  GtkWidget *expander = gtk_expander_new_with_mnemonic (_ ("Loads One by _One"));
  form->list = qn_form_add_choice (grid, _ ("_List"), none, G_CALLBACK (on_list), form);
  form->name = qn_form_add_entry (grid, _ ("_Name"), 10, G_CALLBACK (on_name), form);
  GtkWidget *sets = qn_form_add_buttons (grid);
  qn_form_add_button (
    sets, _ ("_Add Set"),
    _ ("Add a list of loads with a multiplier of their own, for stages"),
    G_CALLBACK (on_add_set), form);
  form->remove_set = qn_form_add_button (sets, _ ("Remo_ve Set"),
                                         _ ("Remove the set with all of its loads"),
                                         G_CALLBACK (on_remove_set), form);
  form->loads =
    qn_form_add_list (grid, _ ("Loads of the list"), G_CALLBACK (on_load), form);
  build_fields (form, grid);
  build_buttons (form, grid);
  gtk_expander_set_child (GTK_EXPANDER (expander), grid);
  gtk_widget_set_margin_start (expander, 12);
  gtk_widget_set_margin_end (expander, 12);
  qn_own (expander, form);
  qn_watch (expander, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update),
            form);
  update (form);
  return expander;
}
